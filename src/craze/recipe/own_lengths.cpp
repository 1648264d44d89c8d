#include "craze/recipe/own_lengths.h"

#include <cmath>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/recipe/each_parameter.h"
#include "craze/recipe/length_text.h"

namespace craze {

namespace {

/// Calls visit(parameter, index, key, length) for every length that is not a bare number.
template <class Visit>
void for_each_foreign_length(const Recipe& recipe, Visit&& visit) {
  for_each_parameter(recipe, [&](const Parameter& p, std::size_t index, bool) {
    if (!p.is_length()) return;
    const ParameterValue value = p.get(recipe, index);
    const auto* text = std::get_if<std::string>(&value);
    const auto length = text ? parse_length(*text) : std::nullopt;
    if (!length) return;  // a number, or a word
    const std::string key =
        p.repeated() ? fmt::format("{}.{}.{}", p.section(), index, p.name()) : p.key;
    visit(p, index, key, *length);
  });
}

bool is_of_world(const Length& length) {
  return length.unit() != LengthUnit::own && length.unit() != LengthUnit::percent;
}

[[noreturn]] void fail_unknown_unit(const Length& length, const std::string& name,
                                    const char* instead) {
  throw Error(
      ErrorKind::request, "the mesh's unit is not known", name,
      fmt::format("{} cannot be measured on it; give {}a bare number in the mesh's unit, or "
                  "a percentage of its diagonal",
                  format_length(length), instead));
}

double own_number(const Length& length, const Yardstick& yardstick) {
  if (length.unit() == LengthUnit::percent) return length.number() / 100 * yardstick.diagonal;
  return length.number() * (metres(length.unit()) / yardstick.metres_per_unit);
}

}  // namespace

double metres_per_unit(const SurfaceMesh& mesh, const Recipe& recipe) {
  return mesh.metres_per_unit > 0 ? mesh.metres_per_unit : metres(recipe.mesh.unit);
}

void check_units(const Recipe& recipe, double metres_per_unit) {
  if (metres_per_unit > 0) return;
  for_each_foreign_length(
      recipe, [](const Parameter&, std::size_t, const std::string& key, const Length& length) {
        if (is_of_world(length)) fail_unknown_unit(length, key, "mesh.unit, such as mm, or ");
      });
}

double own_length(const Length& length, const Yardstick& yardstick, const std::string& name) {
  if (length.unit() == LengthUnit::own) return length.number();
  if (is_of_world(length) && yardstick.metres_per_unit == 0) fail_unknown_unit(length, name, "");
  return own_number(length, yardstick);
}

Recipe with_own_lengths(Recipe recipe, const Yardstick& yardstick) {
  check_units(recipe, yardstick.metres_per_unit);
  Recipe own = recipe;
  for_each_foreign_length(recipe, [&](const Parameter& p, std::size_t index, const std::string& key,
                                      const Length& length) {
    const double number = own_number(length, yardstick);
    if (!std::isfinite(number) || !p.range.contains(number)) {
      throw Error(ErrorKind::request, "length out of range", key,
                  fmt::format("{} is {} in the mesh's unit, and must be {}", format_length(length),
                              number, range_in_words(p.range, ParameterType::real)));
    }
    p.set(own, index, number);
  });
  return own;
}

}  // namespace craze
