#include "craze/output/split_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace craze {

namespace {

/// Values nearer than this, relative, are one: those of an edge are interpolated on both its sides.
constexpr double same_value = 1e-6;

/// All numbers of a vertex that may differ, as columns.
struct Columns {
  std::vector<double> of_input;    // by vertex of the input
  std::vector<double> of_surface;  // by vertex of the surface
  std::size_t count = 0;

  void add(const std::vector<std::pair<std::vector<double>, std::vector<double>>>& columns,
           std::size_t inputs, std::size_t vertices) {
    count = columns.size();
    for (std::size_t v = 0; v < inputs; ++v) {
      for (const auto& column : columns) of_input.push_back(column.first[v]);
    }
    for (std::size_t v = 0; v < vertices; ++v) {
      for (const auto& column : columns) of_surface.push_back(column.second[v]);
    }
  }
};

std::vector<double> column(const Attribute& a, int k) {
  std::vector<double> values;
  for (auto i = static_cast<std::size_t>(k); i < a.values.size(); i += std::size_t(a.components)) {
    values.push_back(a.values[i]);
  }
  return values;
}

std::vector<double> column(const std::vector<Color>& colors, std::size_t k) {
  std::vector<double> values;
  for (const Color& c : colors) values.push_back(c[k]);
  return values;
}

bool is_same(const double* a, const double* b, std::size_t count) {
  return std::equal(a, a + count, b, [](double x, double y) {
    return std::abs(x - y) <= same_value * std::max({1.0, std::abs(x), std::abs(y)});
  });
}

/// The attributes that are to be taken from the input.
std::vector<const Attribute*> unchanged(const SurfaceMesh& surface, const SurfaceMesh& made,
                                        const SurfaceMesh& input) {
  std::vector<const Attribute*> all;
  for (const Attribute& a : input.vertex_attributes) {
    const Attribute* now = find_attribute(surface.vertex_attributes, a.name);
    const Attribute* then = find_attribute(made.vertex_attributes, a.name);
    const bool is_kept = now && then && now->components == a.components &&
                         then->components == a.components && now->values == then->values;
    if (is_kept) all.push_back(&a);
  }
  return all;
}

}  // namespace

SplitSurface with_values_of_input(const SurfaceMesh& surface, const SurfaceMesh& made,
                                  const SurfaceMesh& input, const SurfaceOrigin& origin) {
  const std::vector<const Attribute*> attributes = unchanged(surface, made, input);
  const bool has_colors =
      !input.vertex_colors.empty() && surface.vertex_colors == made.vertex_colors;
  std::vector<std::pair<std::vector<double>, std::vector<double>>> columns;
  for (std::size_t k = 0; has_colors && k < 4; ++k) {
    columns.emplace_back(column(input.vertex_colors, k), column(surface.vertex_colors, k));
  }
  for (const Attribute* a : attributes) {
    const Attribute& now = *find_attribute(surface.vertex_attributes, a->name);
    for (int k = 0; k < a->components; ++k) columns.emplace_back(column(*a, k), column(now, k));
  }
  SplitSurface split{surface, {}};
  const std::size_t vertices = surface.positions.size();
  for (std::size_t v = 0; v < vertices; ++v) split.sources.push_back(static_cast<int>(v));
  if (columns.empty()) return split;
  Columns numbers;
  numbers.add(columns, columns[0].first.size(), vertices);
  const std::size_t n = numbers.count;

  std::vector<double>& values = numbers.of_surface;  // of the split surface in the end
  std::vector<char> is_set(vertices, 0);
  std::vector<std::int32_t> next(vertices, -1);  // the next copy of the same vertex
  std::vector<double> own(n);
  for (std::size_t c = 0; c < 3 * surface.triangles.size(); ++c) {
    if (origin.face[c / 3] < 0) continue;
    const Triangle& t = input.triangles[static_cast<std::size_t>(origin.face[c / 3])];
    for (std::size_t k = 0; k < n; ++k) {
      own[k] = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double w = origin.weights[c][static_cast<int>(i)];
        if (w != 0) own[k] += w * numbers.of_input[n * static_cast<std::size_t>(t[i]) + k];
      }
    }
    std::int32_t& corner = split.mesh.triangles[c / 3][c % 3];
    auto v = static_cast<std::size_t>(corner);
    if (!is_set[v]) {
      // Its first corner: what the vertex has stays, to the last bit, where that is the same.
      is_set[v] = 1;
      if (!is_same(&own[0], &values[n * v], n)) {
        std::copy(own.begin(), own.end(), values.begin() + static_cast<std::ptrdiff_t>(n * v));
      }
      continue;
    }
    while (!is_same(&own[0], &values[n * v], n) && next[v] >= 0) {
      v = static_cast<std::size_t>(next[v]);
    }
    if (!is_same(&own[0], &values[n * v], n)) {
      next[v] = static_cast<std::int32_t>(split.sources.size());
      v = split.sources.size();
      split.sources.push_back(corner);
      next.push_back(-1);
      values.insert(values.end(), own.begin(), own.end());
    }
    corner = static_cast<std::int32_t>(v);
  }

  SurfaceMesh& mesh = split.mesh;
  for (std::size_t v = vertices; v < split.sources.size(); ++v) {
    mesh.positions.push_back(Vec3(mesh.positions[static_cast<std::size_t>(split.sources[v])]));
  }
  std::size_t first = 0;
  if (!mesh.vertex_colors.empty()) {
    for (std::size_t v = 0; v < split.sources.size(); ++v) {
      if (v >= vertices) {
        mesh.vertex_colors.push_back(
            Color(mesh.vertex_colors[static_cast<std::size_t>(split.sources[v])]));
      }
      for (std::size_t k = 0; has_colors && k < 4; ++k) {
        mesh.vertex_colors[v][k] = static_cast<float>(values[n * v + k]);
      }
    }
    if (has_colors) first = 4;
  }
  for (Attribute& a : mesh.vertex_attributes) a = pick(a, split.sources);
  for (const Attribute* a : attributes) {
    const auto made_of = std::find_if(mesh.vertex_attributes.begin(), mesh.vertex_attributes.end(),
                                      [&](const Attribute& b) { return b.name == a->name; });
    const auto width = static_cast<std::size_t>(a->components);
    for (std::size_t v = 0; v < split.sources.size(); ++v) {
      for (std::size_t k = 0; k < width; ++k) {
        made_of->values[width * v + k] = values[n * v + first + k];
      }
    }
    first += width;
  }
  return split;
}

MorphAnimation of_split(const MorphAnimation& animation, const SplitSurface& split) {
  std::vector<std::vector<std::int32_t>> copies;
  for (std::size_t v = 0; v < split.sources.size(); ++v) {
    const auto source = static_cast<std::size_t>(split.sources[v]);
    if (source >= copies.size()) copies.resize(source + 1);
    copies[source].push_back(static_cast<std::int32_t>(v));
  }
  MorphAnimation result;
  result.seconds = animation.seconds;
  for (const MorphStage& stage : animation.stages) {
    std::vector<std::pair<std::int32_t, std::size_t>> moved;
    for (std::size_t i = 0; i < stage.vertices.size(); ++i) {
      for (const std::int32_t v : copies[static_cast<std::size_t>(stage.vertices[i])]) {
        moved.emplace_back(v, i);
      }
    }
    std::sort(moved.begin(), moved.end());
    MorphStage& made = result.stages.emplace_back();
    for (const auto& [vertex, i] : moved) {
      made.vertices.push_back(vertex);
      made.shifts.push_back(stage.shifts[i]);
    }
  }
  return result;
}

}  // namespace craze
