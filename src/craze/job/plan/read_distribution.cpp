#include "craze/job/plan/read_distribution.h"

#include <cmath>
#include <optional>
#include <set>
#include <sstream>

#include "craze/base/elementary.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/recipe/length_text.h"
#include "craze/recipe/nearest_name.h"

namespace craze {

namespace {

constexpr double longest_axis = 100000;

class Reader {
 public:
  Reader(const std::string& key, const std::function<std::string(const toml::node&)>& locate)
      : key_(key), locate_(locate) {}

  Distribution read(const toml::node& node, bool axes) const {
    const auto* table = node.as_table();
    if (!table) return Constant{value(node)};
    const std::string kind = kind_of(*table, axes);
    if (kind == "uniform") {
      const auto [ends, unit] = range(*table, "uniform");
      return Uniform{ends[0], ends[1], unit};
    }
    if (kind == "log_uniform") {
      const auto [ends, unit] = range(*table, "log_uniform");
      if (!(ends[0] > 0)) fail(*table, "log_uniform needs numbers above 0");
      return LogUniform{ends[0], ends[1], unit};
    }
    if (kind == "normal") return normal(*table);
    if (kind == "choice") return choice(*table);
    if (kind == "linked") return linked(*table);
    return axis(*table, kind);
  }

 private:
  [[noreturn]] void fail(const toml::node& node, const std::string& why) const {
    throw Error(ErrorKind::usage, "not a distribution for " + key_, locate_(node), why);
  }

  std::string kind_of(const toml::table& table, bool axes) const {
    std::vector<std::string> kinds{"uniform", "log_uniform", "normal", "choice", "linked"};
    if (axes) kinds.insert(kinds.end(), {"values", "linear", "log"});
    std::string kind;
    for (const std::string& one : kinds) {
      if (!table.contains(one)) continue;
      if (!kind.empty()) fail(table, "both " + kind + " and " + one);
      kind = one;
    }
    const std::map<std::string, std::set<std::string>> extras{
        {"normal", {"within"}}, {"choice", {"weights"}}, {"linked", {"factor", "offset", "map"}}};
    const auto extra = extras.find(kind);
    for (const auto& [name, node] : table) {
      const std::string word(name.str());
      if (word == kind || (extra != extras.end() && extra->second.count(word))) continue;
      const std::string nearest = nearest_name(word, kinds);
      fail(node,
           "unknown word " + word + (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    }
    if (kind.empty())
      fail(table,
           "empty; give a value, or one of uniform, log_uniform, normal, "
           "choice, linked");
    return kind;
  }

  double number(const toml::node& node) const {
    const auto x = node.value<double>();
    if (!node.is_number() || !x || !std::isfinite(*x)) fail(node, "must be a finite number");
    return *x;
  }

  /// A number, or a length with its unit.
  Length length(const toml::node& node) const {
    const auto* text = node.as_string();
    if (!text) return number(node);
    const auto length = parse_length(text->get());
    if (!length || !std::isfinite(length->number())) {
      fail(node, "must be a finite number, or a length such as \"4mm\"");
    }
    return *length;
  }

  const toml::array& brackets(const toml::table& table, const char* word, std::size_t count) const {
    const toml::node& node = *table.get(word);
    const auto* array = node.as_array();
    if (!array || array->size() != count) {
      fail(node, fmt::format("{} needs {} numbers in brackets", word, count));
    }
    return *array;
  }

  std::vector<double> numbers(const toml::table& table, const char* word, std::size_t count) const {
    std::vector<double> result;
    for (const toml::node& element : brackets(table, word, count)) {
      result.push_back(number(element));
    }
    return result;
  }

  /// Numbers in one unit: that of the first that has one.
  struct Lengths {
    std::vector<double> numbers;
    LengthUnit unit = LengthUnit::own;
  };
  Lengths in_one_unit(const std::vector<Length>& lengths, const toml::node& node) const {
    Lengths result;
    for (const Length& length : lengths) {
      if (result.unit == LengthUnit::own) result.unit = length.unit();
    }
    for (const Length& length : lengths) {
      const auto number = in_unit(length, result.unit);
      if (!number) fail(node, "its units do not convert: give all of them one, or none");
      result.numbers.push_back(*number);
    }
    return result;
  }
  Lengths lengths(const toml::table& table, const char* word, std::size_t count) const {
    std::vector<Length> given;
    for (const toml::node& element : brackets(table, word, count)) given.push_back(length(element));
    return in_one_unit(given, *table.get(word));
  }

  Lengths range(const toml::table& table, const char* word) const {
    Lengths ends = lengths(table, word, 2);
    if (!(ends.numbers[0] <= ends.numbers[1])) {
      fail(table, std::string(word) + " needs the smaller number first");
    }
    return ends;
  }

  Normal normal(const toml::table& table) const {
    const auto [law, unit] = lengths(table, "normal", 2);
    if (!(law[1] >= 0)) fail(table, "the standard deviation is below 0");
    // Without ends of its own a normal law has those of four deviations: ranges can be checked.
    if (!table.contains("within")) {
      return {law[0], law[1], law[0] - 4 * law[1], law[0] + 4 * law[1], unit};
    }
    const auto [ends, of_ends] = range(table, "within");
    const Lengths all = in_one_unit(
        {{law[0], unit}, {law[1], unit}, {ends[0], of_ends}, {ends[1], of_ends}}, table);
    return {all.numbers[0], all.numbers[1], all.numbers[2], all.numbers[3], all.unit};
  }

  std::vector<PlanValue> values(const toml::node& node) const {
    const auto* array = node.as_array();
    if (!array || array->empty()) fail(node, "needs values in brackets");
    std::vector<PlanValue> result;
    for (const toml::node& element : *array) result.push_back(value(element));
    return result;
  }

  Choice choice(const toml::table& table) const {
    Choice d{values(*table.get("choice")), {}};
    if (!table.contains("weights")) return d;
    d.weights = numbers(table, "weights", d.values.size());
    double sum = 0;
    for (const double w : d.weights) {
      if (w < 0) fail(table, "a weight is below 0");
      sum += w;
    }
    if (!(sum > 0) || !std::isfinite(sum)) fail(table, "the weights sum to nothing");
    return d;
  }

  Linked linked(const toml::table& table) const {
    Linked d;
    const auto key = table["linked"].value<std::string>();
    if (!table["linked"].is_string()) fail(table, "linked needs the name of a key");
    d.key = *key;
    if (const auto* node = table.get("factor")) d.factor = number(*node);
    if (const auto* node = table.get("offset")) d.offset = length(*node);
    if (const auto* node = table.get("map")) {
      const auto* map = node->as_table();
      if (!map || map->empty()) fail(*node, "map needs a table of values");
      for (const auto& [word, mapped] : *map) d.map.emplace(word.str(), value(mapped));
    }
    return d;
  }

  Axis axis(const toml::table& table, const std::string& kind) const {
    if (kind == "values") return {values(*table.get("values"))};
    const toml::array& given = brackets(table, kind.c_str(), 3);
    const auto [law, unit] = in_one_unit({length(given[0]), length(given[1])}, table);
    const double n = number(given[2]);
    if (n != std::floor(n) || n < 1 || n > longest_axis) {
      fail(table,
           fmt::format("the third number of {} counts the values, 1 to {}", kind, longest_axis));
    }
    const bool log = kind == "log";
    if (log && !(law[0] > 0 && law[1] > 0)) fail(table, "log needs numbers above 0");
    Axis d;
    for (double i = 0; i < n; ++i) {
      const double u = n == 1 ? 0 : i / (n - 1);
      const double x =
          log ? elementary::exp((1 - u) * elementary::log(law[0]) + u * elementary::log(law[1]))
              : (1 - u) * law[0] + u * law[1];
      d.values.push_back(plan_value({u == 0 ? law[0] : u == 1 ? law[1] : x, unit}));
    }
    return d;
  }

  PlanValue value(const toml::node& node) const {
    if (node.is_number()) return number(node);
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* truth = node.as_boolean()) return std::string(truth->get() ? "true" : "false");
    const auto* array = node.as_array();
    if (!array) fail(node, "must be a value");
    for (const toml::node& element : *array) {
      if (!element.is_number() && !element.is_string()) fail(element, "must be a number or a word");
    }
    std::ostringstream text;
    text << *array;
    return text.str();
  }

  const std::string& key_;
  const std::function<std::string(const toml::node&)>& locate_;
};

}  // namespace

Distribution read_distribution(const toml::node& node, const std::string& key, bool axes,
                               const std::function<std::string(const toml::node&)>& locate) {
  return Reader(key, locate).read(node, axes);
}

}  // namespace craze
