#include "craze/recipe/json_table.h"

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "craze/error.h"

namespace craze {

namespace {

using Json = nlohmann::json;

constexpr int deepest = 16;

/// A text, and what it should be.
struct Named {
  const std::string &name, &what;
};

[[noreturn]] void fail(const Named& text, const std::string& why) {
  throw Error(ErrorKind::usage, "not a JSON " + text.what, text.name, why);
}

class Converter {
 public:
  explicit Converter(const Named& text) : text_(text) {}

  toml::table table(const Json& object, int depth) const {
    check_depth(depth);
    toml::table result;
    for (const auto& [key, value] : object.items()) {
      with_value(key, value, depth, [&, k = key](auto&& x) {
        result.insert_or_assign(k, std::forward<decltype(x)>(x));
      });
    }
    return result;
  }

 private:
  toml::array array(const Json& list, const std::string& key, int depth) const {
    check_depth(depth);
    toml::array result;
    for (const Json& value : list) {
      with_value(key, value, depth,
                 [&](auto&& x) { result.push_back(std::forward<decltype(x)>(x)); });
    }
    return result;
  }

  template <class Put>
  void with_value(const std::string& key, const Json& value, int depth, Put&& put) const {
    switch (value.type()) {
      case Json::value_t::object:
        return put(table(value, depth + 1));
      case Json::value_t::array:
        return put(array(value, key, depth + 1));
      case Json::value_t::string:
        return put(value.get<std::string>());
      case Json::value_t::boolean:
        return put(value.get<bool>());
      case Json::value_t::number_integer:
        return put(value.get<std::int64_t>());
      case Json::value_t::number_unsigned:
        if (value.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<std::int64_t>::max()}) {
          return put(value.get<double>());
        }
        return put(value.get<std::int64_t>());
      case Json::value_t::number_float:
        return put(value.get<double>());
      default:
        fail(text_, key + " has no value");
    }
  }

  void check_depth(int depth) const {
    if (depth > deepest) fail(text_, "nested too deep");
  }

  const Named& text_;
};

/// Refuses what is nested too deep before anything is built of it.
bool is_flat_enough(int depth, Json::parse_event_t, Json&) {
  return depth <= deepest;
}

}  // namespace

bool is_json(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

toml::table read_json_table(std::string_view text, const std::string& name,
                            const std::string& what) {
  const Named named{name, what};
  try {
    const Json json = Json::parse(text, is_flat_enough);
    if (!json.is_object()) fail(named, "nested too deep");
    return Converter(named).table(json, 0);
  } catch (const Json::parse_error& e) {
    fail(named, "what is at byte " + std::to_string(e.byte) + " is not JSON");
  }
}

}  // namespace craze
