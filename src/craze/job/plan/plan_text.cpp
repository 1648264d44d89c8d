#include "craze/job/plan/plan_text.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "craze/base/text/format.h"
#include "craze/recipe/json_table.h"
#include "craze/recipe/toml_text.h"

namespace craze {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Where the first line begins.
std::size_t begin_of(const std::string& text) {
  return text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

/// Of a place that the TOML library names, bytes from the start. Its columns count characters.
std::size_t offset_of(const std::string& text, const toml::source_position& place) {
  std::size_t at = place.line == 1 ? begin_of(text) : 0;
  for (toml::source_index line = 1; line < place.line; ++line) at = text.find('\n', at) + 1;
  const auto continues = [&] { return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80; };
  for (toml::source_index column = 1; column < place.column && at < text.size(); ++column) {
    do ++at;
    while (at < text.size() && continues());
  }
  return at;
}

/// The line that a byte is in, with its end.
std::pair<std::size_t, std::size_t> line_around(const std::string& text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t end = text.find('\n', at);
  return {before == std::string::npos ? begin_of(text) : before + 1,
          end == std::string::npos ? text.size() : end + 1};
}

/// A JSON text after a change of its top level; one that is no object stays as it is.
std::string changed_json(const std::string& text, const std::function<void(Json&)>& change) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return text;
  change(json);
  return json.dump(2);
}

}  // namespace

std::string with_number(const std::string& text, const std::string& name, const std::string& key,
                        std::uint64_t value) {
  if (is_json(text)) return changed_json(text, [&](Json& json) { json[key] = value; });
  const toml::table root = parse_toml(text, name, "plan");
  const toml::node* given = root.get(key);
  std::string changed = text;
  if (!given) {
    changed.insert(begin_of(text), fmt::format("{} = {}\n", key, value));
  } else if (given->is_value()) {
    const toml::source_region at = given->source();
    const std::size_t from = offset_of(text, at.begin), to = offset_of(text, at.end);
    changed.replace(from, to - from, fmt::format("{}", value));
  }
  return changed;
}

std::string without_keys(const std::string& text, const std::string& name,
                         const std::vector<std::string>& keys) {
  if (is_json(text)) {
    return changed_json(text, [&](Json& json) {
      for (const std::string& key : keys) json.erase(key);
    });
  }
  const toml::table root = parse_toml(text, name, "plan");
  std::vector<std::pair<std::size_t, std::size_t>> lines;
  for (const std::string& key : keys) {
    const toml::node* given = root.get(key);
    if (!given || !given->is_value()) continue;
    lines.push_back(line_around(text, offset_of(text, given->source().begin)));
  }
  std::sort(lines.rbegin(), lines.rend());  // the last first, so that places stay
  std::string changed = text;
  for (const auto& line : lines) changed.erase(line.first, line.second - line.first);
  return changed;
}

}  // namespace craze
