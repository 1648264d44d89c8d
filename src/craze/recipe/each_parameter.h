// Every parameter of a recipe in turn.
#pragma once

#include "craze/recipe/parameter_table.h"

namespace craze {

/// Calls visit(parameter, index, is_first) for every parameter a recipe holds, in the order of the
/// table, impact by impact; is_first at the first key of a section, or of an impact.
template <class Visit>
void for_each_parameter(const Recipe& recipe, Visit&& visit) {
  const auto& table = parameter_table();
  for (auto p = table.begin(); p != table.end();) {
    auto end = p;
    while (end != table.end() && end->section() == p->section()) ++end;
    const std::size_t copies = p->repeated() ? recipe.simulation.impacts.size() : 1;
    for (std::size_t index = 0; index < copies; ++index) {
      for (auto q = p; q != end; ++q) visit(*q, index, q == p);
    }
    p = end;
  }
}

}  // namespace craze
