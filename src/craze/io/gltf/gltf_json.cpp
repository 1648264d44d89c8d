#include "craze/io/gltf/gltf_json.h"

#include <algorithm>
#include <cmath>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

constexpr int max_depth = 64;

/// The deepest nesting of brackets outside strings.
int nesting(std::string_view text) {
  int depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        in_string = false;
      }
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
  if (nesting(text) > max_depth) {
    fail_input(name, fmt::format("its JSON is nested more than {} deep", max_depth));
  }
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(e.byte, text.size()));
    fail_input(at_line(name, 1 + std::count(text.begin(), end, '\n')), "its JSON is broken here");
  } catch (const Json::exception&) {
    fail_input(name, "its JSON holds a number out of range");
  }
}

void GltfJson::fail(const std::string& why) const {
  fail_input(name_, why);
}

const Json& GltfJson::array(const Json& object, const char* key) const {
  static const Json none = Json::array();
  const auto found = object.find(key);
  if (found == object.end()) return none;
  if (!found->is_array()) fail(fmt::format("'{}' is not an array", key));
  return *found;
}

const Json& GltfJson::item(const Json& root, const char* list, std::size_t i) const {
  const Json& items = array(root, list);
  if (i >= items.size()) {
    fail(fmt::format("it asks for item {} of the {} in '{}'", i, items.size(), list));
  }
  if (!items[i].is_object()) {
    fail(fmt::format("'{}' item {} is not an object", list, i));
  }
  return items[i];
}

std::size_t GltfJson::as_index(const Json& value, const char* what) const {
  constexpr double exact = 9007199254740992.0;  // 2⁵³
  const double number = value.is_number() ? value.get<double>() : -1;
  if (!(number >= 0 && number <= exact && number == std::floor(number))) {
    fail(fmt::format("'{}' is not a whole number of 0 or more", what));
  }
  return static_cast<std::size_t>(number);
}

std::optional<std::size_t> GltfJson::index(const Json& object, const char* key) const {
  const auto found = object.find(key);
  if (found == object.end()) return std::nullopt;
  return as_index(*found, key);
}

std::size_t GltfJson::index_or(const Json& object, const char* key, std::size_t fallback) const {
  return index(object, key).value_or(fallback);
}

const Json* GltfJson::extension(const Json& object, const char* key) const {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(key);
  return found != extensions->end() && found->is_object() ? &*found : nullptr;
}

std::string GltfJson::text(const Json& object, const char* key) const {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool GltfJson::numbers(const Json& object, const char* key, double* values, std::size_t n) const {
  const Json& list = array(object, key);
  if (list.empty()) return false;
  if (list.size() != n) fail(fmt::format("'{}' has not {} numbers", key, n));
  for (std::size_t i = 0; i < n; ++i) {
    if (!list[i].is_number() || !std::isfinite(list[i].get<double>())) {
      fail(fmt::format("'{}' holds something that is not a number", key));
    }
    values[i] = list[i].get<double>();
  }
  return true;
}

}  // namespace craze
