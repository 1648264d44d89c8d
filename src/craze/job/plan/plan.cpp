#include "craze/job/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/job/plan/plan_text.h"
#include "craze/job/plan/read_distribution.h"
#include "craze/presets.h"
#include "craze/recipe/nearest_name.h"
#include "craze/recipe/parameter_table.h"
#include "craze/recipe/set_key.h"
#include "craze/recipe/toml_text.h"

namespace craze {

namespace {

const std::string recipe_prefix = "recipe.";
const std::string preset_key = "recipe.preset";

[[noreturn]] void fail(const std::string& what, const std::string& where, const std::string& why) {
  throw Error(ErrorKind::usage, what, where, why);
}

/// Purposes of random numbers have the key's name.
std::uint64_t stream_of(const std::string& key) {
  std::uint64_t h = 0;
  for (const char c : key) h = hash_bits(h ^ static_cast<unsigned char>(c));
  return h;
}

void check_plan_value(const PlanKey& key, const PlanValue& value, const std::string& where) {
  const std::string wrong = "wrong value for " + key.key + ": " + plan_text(value);
  if (key.type == PlanKeyType::word) {
    const auto* word = std::get_if<std::string>(&value);
    if (!word) fail(wrong, where, "must be text");
    if (key.choices.empty()) return;
    if (std::find(key.choices.begin(), key.choices.end(), *word) != key.choices.end()) return;
    std::string choices;
    for (const std::string& c : key.choices) choices += (choices.empty() ? "" : ", ") + c;
    fail(wrong, where, "choose one of " + choices);
  }
  const auto* number = std::get_if<double>(&value);
  if (!number) fail(wrong, where, "must be a number");
  if (!(*number >= key.low && *number <= key.high)) {
    fail(wrong, where, fmt::format("must be in [{}, {}]", key.low, key.high));
  }
}

void check_preset(const std::string& name, const std::string& where) {
  try {
    find_preset(name);
  } catch (const Error& e) {
    fail("wrong value for " + preset_key, where, e.what());
  }
}

/// The numbers of integer keys are rounded, so that they may be drawn.
std::string recipe_text(const Parameter* p, const PlanValue& value) {
  const auto* number = std::get_if<double>(&value);
  if (number && p && p->type == ParameterType::integer && std::abs(*number) < 9e15) {
    return fmt::format("{}", static_cast<std::int64_t>(std::llround(*number)));
  }
  return plan_text(value);
}

void set_recipe_key(Recipe& recipe, const std::string& key, const PlanValue& value,
                    const std::string& where) {
  set_key(recipe, key, recipe_text(find_parameter(key), value), where);
}

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() ? b : a + "." + b;
}

/// The entries of a text, whatever their keys.
class EntryReader {
 public:
  EntryReader(const std::string& name, const PlanSchema& schema) : name_(name), schema_(schema) {}

  std::vector<PlanEntry> read(const toml::table& root) {
    for (const auto& [toml_key, node] : root) {
      const std::string key(toml_key.str());
      const auto* table = node.as_table();
      if (key == "recipe") {
        if (!table) fail("wrong type for recipe", locate(node), "must be a section");
        read_recipe_keys(*table);
      } else if (table && !is_key(key)) {
        for (const auto& [inner, value] : *table) {
          add(joined(key, std::string(inner.str())), value);
        }
        if (table->empty()) fail_unknown(key, node);
      } else {
        add(key, node);
      }
    }
    return std::move(entries_);
  }

 private:
  std::string locate(const toml::node& node) const {
    const auto at = node.source().begin;
    return at ? fmt::format("{}:{}:{}", name_, at.line, at.column) : name_;
  }

  bool is_key(const std::string& key) const {
    return std::any_of(schema_.keys.begin(), schema_.keys.end(),
                       [&](const PlanKey& k) { return k.key == key; });
  }

  [[noreturn]] void fail_unknown(const std::string& key, const toml::node& node) const {
    std::vector<std::string> keys;
    for (const PlanKey& k : schema_.keys) keys.push_back(k.key);
    for (const Parameter& p : parameter_table()) keys.push_back(recipe_prefix + p.key);
    const std::string nearest = nearest_name(key, keys);
    fail("unknown key " + key, locate(node),
         nearest.empty() ? "keys of recipes stand in [recipe]" : "did you mean " + nearest + "?");
  }

  void add(const std::string& key, const toml::node& node) {
    if (!is_key(key)) fail_unknown(key, node);
    push(key, node);
  }

  void push(const std::string& key, const toml::node& node) {
    const auto here = [this](const toml::node& n) { return locate(n); };
    entries_.push_back({key, read_distribution(node, key, schema_.has_axes, here), locate(node)});
  }

  /// In [recipe] a table is a section unless its name is a key.
  void read_recipe_keys(const toml::table& table) {
    for (const auto& [toml_key, node] : table) {
      const std::string key(toml_key.str());
      if (key == "preset" || key == "impact" || find_parameter(key) || !node.is_table()) {
        add_recipe_key(key, node);
        continue;
      }
      for (const auto& [inner, value] : *node.as_table()) {
        add_recipe_key(joined(key, std::string(inner.str())), value);
      }
    }
  }

  void add_recipe_key(const std::string& key, const toml::node& node) {
    if (key.rfind("impact", 0) == 0) {
      fail("no impacts in a plan", locate(node), "give a preset that has them");
    }
    if (key != "preset" && !find_parameter(key)) fail_unknown(recipe_prefix + key, node);
    push(recipe_prefix + key, node);
  }

  const std::string& name_;
  const PlanSchema& schema_;
  std::vector<PlanEntry> entries_;
};

/// The entries' indices, each link behind what it goes with.
class LinkOrder {
 public:
  LinkOrder(const std::vector<PlanEntry>& entries, const std::map<std::string, std::size_t>& by_key)
      : entries_(entries), by_key_(by_key), state_(entries.size(), 0) {
    for (std::size_t i = 0; i < entries.size(); ++i) visit(i);
  }
  std::vector<std::size_t> order;

 private:
  void visit(std::size_t first) {
    // A chain of links is followed without recursion: a plan may have thousands.
    std::vector<std::size_t> chain;
    for (std::size_t i = first; state_[i] != 2;) {
      const PlanEntry& e = entries_[i];
      if (state_[i] == 1)
        fail("links go round in a circle", e.where, "one must be given by itself");
      state_[i] = 1;
      chain.push_back(i);
      const auto* link = std::get_if<Linked>(&e.distribution);
      if (!link) break;
      const auto found = by_key_.find(link->key);
      if (found == by_key_.end()) {
        fail("no key " + link->key + " to go with", e.where, "the plan does not give it");
      }
      i = found->second;
    }
    for (; !chain.empty(); chain.pop_back()) {
      state_[chain.back()] = 2;
      order.push_back(chain.back());
    }
  }

  const std::vector<PlanEntry>& entries_;
  const std::map<std::string, std::size_t>& by_key_;
  std::vector<char> state_;
};

}  // namespace

Plan::Plan(std::string_view text, const std::string& name, const PlanSchema& schema)
    : text_(text), name_(name), schema_(schema) {
  const toml::table root = parse_toml(text, name, "plan");
  std::vector<PlanEntry> given = EntryReader(name, schema_).read(root);
  for (const PlanKey& key : schema_.keys) {
    const auto found = std::find_if(given.begin(), given.end(),
                                    [&](const PlanEntry& e) { return e.key == key.key; });
    PlanEntry e = found == given.end() ? PlanEntry{key.key, Constant{key.standard}, name} : *found;
    if (key.fixed && !std::holds_alternative<Constant>(e.distribution)) {
      fail("one value alone for " + key.key, e.where, "it is the plan's, not a run's");
    }
    for (const PlanValue& value : extremes(e.distribution)) {
      check_plan_value(key, value, e.where);
      const auto* x = std::get_if<double>(&value);
      if (key.fixed && key.type == PlanKeyType::integer && *x != std::floor(*x)) {
        fail("wrong value for " + key.key + ": " + plan_text(value), e.where,
             "must be a whole number");
      }
    }
    entries_.push_back(std::move(e));
  }
  for (PlanEntry& e : given) {
    if (e.key.rfind(recipe_prefix, 0) != 0) continue;
    Recipe scratch;
    for (const PlanValue& value : extremes(e.distribution)) {
      if (e.key == preset_key) {
        check_preset(plan_text(value), e.where);
      } else {
        set_recipe_key(scratch, e.key.substr(recipe_prefix.size()), value, e.where);
      }
    }
    entries_.push_back(std::move(e));
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) by_key_[entries_[i].key] = i;
  order_ = LinkOrder(entries_, by_key_).order;
  check_links();
}

void Plan::check_links() const {
  std::map<std::string, std::vector<PlanValue>> possible;  // the least and the largest, or all
  for (const std::size_t i : order_) {
    const PlanEntry& e = entries_[i];
    const auto* link = std::get_if<Linked>(&e.distribution);
    std::vector<PlanValue>& values = possible[e.key];
    if (!link) {
      values = extremes(e.distribution);
      continue;
    }
    Random none(0, 0);  // links draw nothing
    Recipe scratch;
    for (const PlanValue& other : possible.at(link->key)) {
      const PlanValue value = craze::draw(e.distribution, none, &other, e.where);
      if (i < schema_.keys.size()) {
        check_plan_value(schema_.keys[i], value, e.where);
      } else if (e.key == preset_key) {
        check_preset(plan_text(value), e.where);
      } else {
        set_recipe_key(scratch, e.key.substr(recipe_prefix.size()), value, e.where);
      }
      values.push_back(value);
    }
  }
}

std::vector<std::string> Plan::extents() const {
  std::vector<std::string> keys;
  for (const PlanKey& key : schema_.keys) {
    const bool linked = std::any_of(entries_.begin(), entries_.end(), [&](const PlanEntry& e) {
      const auto* link = std::get_if<Linked>(&e.distribution);
      return link && link->key == key.key;
    });
    if (key.extent && !linked) keys.push_back(key.key);
  }
  return keys;
}

std::string Plan::identity() const {
  return without_keys(text_, name_, extents());
}

const PlanEntry& Plan::entry(const std::string& key) const {
  return entries_[by_key_.at(key)];
}

double Plan::number(const std::string& key) const {
  return std::get<double>(std::get<Constant>(entry(key).distribution).value);
}

std::string Plan::word(const std::string& key) const {
  return std::get<std::string>(std::get<Constant>(entry(key).distribution).value);
}

PlanValues Plan::draw(std::uint64_t index, std::uint64_t attempt, const PlanValues& axes) const {
  const auto seed = static_cast<std::uint64_t>(number("seed"));
  const std::uint64_t name = hash_bits(hash_bits(hash_bits(seed) ^ index) ^ attempt);
  PlanValues values;
  for (const std::size_t i : order_) {
    const PlanEntry& e = entries_[i];
    Random random(name, stream_of(e.key));
    const auto* link = std::get_if<Linked>(&e.distribution);
    PlanValue value =
        craze::draw(e.distribution, random, link ? &values.at(link->key) : nullptr, e.where);
    if (const auto axis = axes.find(e.key); axis != axes.end()) value = axis->second;
    if (i < schema_.keys.size()) {
      const PlanKey& key = schema_.keys[i];
      check_plan_value(key, value, e.where);
      auto* x = std::get_if<double>(&value);
      if (x && key.type == PlanKeyType::integer) *x = std::floor(*x + 0.5);
    }
    values.emplace(e.key, std::move(value));
  }
  return values;
}

double number_of(const PlanValues& values, const std::string& key) {
  return std::get<double>(values.at(key));
}

std::string word_of(const PlanValues& values, const std::string& key) {
  return std::get<std::string>(values.at(key));
}

Recipe recipe_of(const Plan& plan, const PlanValues& values, std::uint64_t seed) {
  const auto preset = values.find(preset_key);
  Recipe recipe = preset == values.end() ? Recipe{} : read_preset(plan_text(preset->second));
  recipe.simulation.seed = seed;
  for (const PlanEntry& e : plan.entries()) {
    if (e.key == preset_key || e.key.rfind(recipe_prefix, 0) != 0) continue;
    set_recipe_key(recipe, e.key.substr(recipe_prefix.size()), values.at(e.key), e.where);
  }
  return recipe;
}

std::string plan_reference(const PlanSchema& schema) {
  std::string page = "| key | range | where not given | meaning |\n|---|---|---|---|\n";
  for (const PlanKey& key : schema.keys) {
    std::string range = "text";
    if (!key.choices.empty()) {
      range.clear();
      for (const std::string& c : key.choices) range += (range.empty() ? "" : ", ") + c;
    } else if (key.type != PlanKeyType::word) {
      range = fmt::format("{} … {}", key.low, key.high);
    }
    const std::string standard = plan_text(key.standard);
    page += fmt::format("| `{}` | {} | {} | {}{} |\n", key.key, range,
                        standard.empty() ? "" : "`" + standard + "`", key.help,
                        key.fixed ? " (not drawn)" : "");
  }
  return page;
}

}  // namespace craze
