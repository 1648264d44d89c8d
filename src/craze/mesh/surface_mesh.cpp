#include "craze/surface_mesh.h"

namespace craze {

const Attribute* find_attribute(const std::vector<Attribute>& attributes, const std::string& name) {
  for (const Attribute& a : attributes) {
    if (a.name == name) return &a;
  }
  return nullptr;
}

Attribute pick(const Attribute& source, const std::vector<std::int32_t>& from) {
  Attribute result{source.name, source.components, {}};
  result.values.reserve(from.size() * static_cast<std::size_t>(source.components));
  for (const std::int32_t i : from) {
    const auto begin = source.values.begin() + static_cast<std::ptrdiff_t>(i) * source.components;
    result.values.insert(result.values.end(), begin, begin + source.components);
  }
  return result;
}

}  // namespace craze
