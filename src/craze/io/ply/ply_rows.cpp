#include "craze/io/ply/ply_rows.h"

#include <algorithm>
#include <cmath>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

/// Whether there is no surface without the property.
bool is_needed(const std::string& property) {
  for (const char* needed : {"x", "y", "z", "vertex_indices", "vertex_index", "material_index"}) {
    if (property == needed) return true;
  }
  return false;
}

}  // namespace

PlyRows::PlyRows(const PlyElement& element, std::vector<PlyColumn> columns, const std::string& name)
    : element_(element),
      columns_(std::move(columns)),
      taken_(columns_.size()),
      mended_(columns_.size(), 0),
      name_(name) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    for (std::size_t k = 0; k < columns_[i].values.size(); ++k) {
      double& value = columns_[i].values[k];
      if (std::isfinite(value)) continue;
      if (is_needed(element.properties[i].name)) fail_value(i, k);
      value = 0;
      ++mended_[i];
    }
  }
}

void PlyRows::warn_of_mended(const MeshSource& source) const {
  std::string list;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (mended_[i] == 0) continue;
    list += fmt::format("{}{} of '{}'", list.empty() ? "" : ", ", mended_[i],
                        printable(element_.properties[i].name));
  }
  if (list.empty()) return;
  source.warn(fmt::format("values of '{}' that are not finite numbers are 0: {}",
                          printable(element_.name), list));
}

void PlyRows::fail_value(std::size_t column, std::size_t k) const {
  const auto& ends = columns_[column].ends;
  const auto row = ends.empty() ? static_cast<std::ptrdiff_t>(k)
                                : std::upper_bound(ends.begin(), ends.end(), k) - ends.begin();
  fail_input(name_, fmt::format("{} {}: {} is not a finite number", printable(element_.name), row,
                                printable(element_.properties[column].name)));
}

std::ptrdiff_t PlyRows::find(const std::string& property, bool list) const {
  for (std::size_t i = 0; i < element_.properties.size(); ++i) {
    const PlyProperty& p = element_.properties[i];
    if (p.name == property && p.is_list == list) return static_cast<std::ptrdiff_t>(i);
  }
  return -1;
}

bool PlyRows::has_all(const std::vector<std::string>& properties) const {
  return std::all_of(properties.begin(), properties.end(), [&](const auto& n) { return has(n); });
}

PlyType PlyRows::type(const std::string& property) const {
  return element_.properties[find(property)].type;
}

const std::vector<double>& PlyRows::take(const std::string& property) {
  taken_[find(property)] = true;
  return columns_[find(property)].values;
}

const PlyColumn& PlyRows::take_list(const std::string& property) {
  taken_[find(property, true)] = true;
  return columns_[find(property, true)];
}

std::vector<std::string> PlyRows::lists_left() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const PlyProperty& p = element_.properties[i];
    if (p.is_list && !taken_[i] && !columns_[i].values.empty()) names.push_back(p.name);
  }
  return names;
}

std::size_t PlyRows::components_from(std::size_t first, const std::string& stem) const {
  std::size_t n = 1;
  while (first + n < columns_.size() && is_spare(first + n) &&
         element_.properties[first + n].name == fmt::format("{}_{}", stem, n)) {
    ++n;
  }
  return n;
}

std::vector<Attribute> PlyRows::attributes() const {
  std::vector<Attribute> result;
  std::size_t n = 1;
  for (std::size_t i = 0; i < columns_.size(); i += n) {
    n = 1;
    if (!is_spare(i)) continue;
    std::string name = element_.properties[i].name;
    if (name.size() > 2 && name.ends_with("_0")) {
      const std::string stem = name.substr(0, name.size() - 2);
      n = components_from(i, stem);
      if (n > 1) name = stem;
    }
    Attribute& a = result.emplace_back(Attribute{name, static_cast<int>(n), {}});
    a.values.resize(n * count());
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t row = 0; row < count(); ++row) {
        a.values[n * row + k] = columns_[i + k].values[row];
      }
    }
  }
  return result;
}

}  // namespace craze
