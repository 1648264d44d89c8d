// A plan: which values many runs take, drawn or by grid. TOML on disk.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "craze/job/plan/distribution.h"
#include "craze/recipe.h"

namespace craze {

enum class PlanKeyType { number, integer, word };

/// A key that a kind of plan knows besides those of recipes.
struct PlanKey {
  std::string key;  ///< dotted
  PlanKeyType type = PlanKeyType::number;
  PlanValue standard;  ///< where the plan does not give it
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {};  ///< of words; empty: any
  bool fixed = false;                     ///< of the plan as a whole: one value, never drawn
  std::string help = {};                  ///< one line
  bool extent = false;                    ///< how far the plan goes: changes none of its runs
};

/// What a kind of plan may hold: its own keys, and in [recipe] those of recipes, without the place
/// of an impact's number any of them.
struct PlanSchema {
  std::string kind;  ///< "dataset", "sweep"
  std::vector<PlanKey> keys;
  bool has_axes = false;
};

struct PlanEntry {
  std::string key;  ///< dotted; recipe keys begin with "recipe."
  Distribution distribution;
  std::string where;  ///< FILE:LINE:COLUMN
};

/// All values of one run.
using PlanValues = std::map<std::string, PlanValue>;

/// Every key of the schema, then the recipe's in the order of the text. Values are within their
/// keys' ranges, whatever is drawn.
class Plan {
 public:
  /// Throws Error(usage) in one line with the place: no TOML, an unknown key, a distribution that
  /// is none, a value out of range, a link to nothing, round in a circle, or to
  /// values of which it can make none.
  Plan(std::string_view text, const std::string& name, const PlanSchema& schema);

  /// The text it was read from.
  const std::string& text() const { return text_; }
  const std::vector<PlanEntry>& entries() const { return entries_; }

  /// The keys that say how far the plan goes, but for those that others are linked to.
  std::vector<std::string> extents() const;
  /// The text without the lines of extents(): the same of plans whose runs are the same.
  std::string identity() const;

  /// Of fixed keys.
  double number(const std::string& key) const;
  std::string word(const std::string& key) const;

  /// The values of run `index`, a function of the plan, its key "seed", the index and the attempt
  /// alone. Each key draws by itself: another key more changes none of them. Axes give what `axes`
  /// says, else their first value. Throws Error(usage) where a linked value is out of range.
  PlanValues draw(std::uint64_t index, std::uint64_t attempt = 0,
                  const PlanValues& axes = {}) const;

 private:
  const PlanEntry& entry(const std::string& key) const;
  /// Every link, at the ends of what it goes with.
  void check_links() const;

  std::string text_, name_;
  PlanSchema schema_;
  std::vector<PlanEntry> entries_;
  std::map<std::string, std::size_t> by_key_;
  std::vector<std::size_t> order_;  // entries, a link behind what it goes with
};

double number_of(const PlanValues& values, const std::string& key);
std::string word_of(const PlanValues& values, const std::string& key);

/// The recipe of a run: recipe.preset, then the recipe's keys; the seed is `seed` where the plan
/// gives none. Throws Error(usage).
Recipe recipe_of(const Plan& plan, const PlanValues& values, std::uint64_t seed);

/// The keys as Markdown: key, range, standard value, meaning.
std::string plan_reference(const PlanSchema& schema);

}  // namespace craze
