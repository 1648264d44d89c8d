#include "craze/job/plan/distribution.h"

#include <algorithm>
#include <numeric>

#include "craze/base/elementary.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/recipe/length_text.h"

namespace craze {

namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

double draw_normal(const Normal& d, Random& random) {
  constexpr int tries = 64;
  double x = d.mean;
  for (int i = 0; i < tries; ++i) {
    x = d.mean + d.deviation * random.normal();
    if (x >= d.low && x <= d.high) return x;
  }
  return std::clamp(x, d.low, d.high);
}

const PlanValue& draw_choice(const Choice& d, Random& random) {
  if (d.weights.empty()) return d.values[random.below(d.values.size())];
  double left = random.uniform() * std::accumulate(d.weights.begin(), d.weights.end(), 0.0);
  std::size_t last = 0;
  for (std::size_t i = 0; i < d.values.size(); ++i) {
    if (d.weights[i] <= 0) continue;
    last = i;
    if (left < d.weights[i]) break;
    left -= d.weights[i];
  }
  return d.values[last];
}

PlanValue follow(const Linked& d, const PlanValue& other, const std::string& where) {
  if (!d.map.empty()) {
    const auto found = d.map.find(plan_text(other));
    if (found != d.map.end()) return found->second;
    throw Error(ErrorKind::usage, "no value for " + d.key + " = " + plan_text(other), where,
                "the map has none");
  }
  if (d.factor == 1 && d.offset.number() == 0) return other;
  if (const std::optional<Length> length = plan_length(other)) {
    const LengthUnit unit = length->number() == 0 ? d.offset.unit() : length->unit();
    if (const auto offset = in_unit(d.offset, unit)) {
      return plan_value({*offset + d.factor * length->number(), unit});
    }
    throw Error(ErrorKind::usage, "cannot calculate with " + d.key, where,
                "the units of " + plan_text(other) + " and the offset do not convert");
  }
  throw Error(ErrorKind::usage, "cannot calculate with " + d.key, where,
              plan_text(other) + " is not a number; give a map");
}

template <class Law>
std::vector<PlanValue> ends(const Law& law) {
  return {plan_value({law.low, law.unit}), plan_value({law.high, law.unit})};
}

}  // namespace

std::string plan_text(const PlanValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return fmt::format("{}", std::get<double>(value));
}

std::optional<Length> plan_length(const PlanValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return parse_length(*text);
  return Length(std::get<double>(value));
}

PlanValue plan_value(const Length& length) {
  if (length.unit() == LengthUnit::own) return length.number();
  return format_length(length);
}

std::optional<double> in_unit(const Length& length, LengthUnit unit) {
  if (length.unit() == unit || length.number() == 0) return length.number();
  const double from = metres(length.unit()), to = metres(unit);
  if (from == 0 || to == 0) return {};
  return length.number() * from / to;
}

PlanValue draw(const Distribution& distribution, Random& random, const PlanValue* other,
               const std::string& where) {
  return std::visit(
      Overloaded{[](const Constant& d) { return d.value; },
                 [&](const Uniform& d) {
                   return plan_value({random.uniform(d.low, d.high), d.unit});
                 },
                 [&](const LogUniform& d) {
                   const double u = random.uniform();
                   const double log =
                       elementary::log(d.low) * (1 - u) + elementary::log(d.high) * u;
                   return plan_value({std::clamp(elementary::exp(log), d.low, d.high), d.unit});
                 },
                 [&](const Normal& d) {
                   return plan_value({draw_normal(d, random), d.unit});
                 },
                 [&](const Choice& d) { return draw_choice(d, random); },
                 [&](const Linked& d) { return follow(d, *other, where); },
                 [](const Axis& d) { return d.values.front(); }},
      distribution);
}

std::vector<PlanValue> extremes(const Distribution& distribution) {
  using Values = std::vector<PlanValue>;
  return std::visit(
      Overloaded{[](const Constant& d) { return Values{d.value}; },
                 [](const Uniform& d) { return ends(d); },
                 [](const LogUniform& d) { return ends(d); },
                 [](const Normal& d) { return ends(d); }, [](const Choice& d) { return d.values; },
                 [](const Linked& d) {
                   Values values;
                   for (const auto& [word, value] : d.map) values.push_back(value);
                   return values;
                 },
                 [](const Axis& d) { return d.values; }},
      distribution);
}

}  // namespace craze
