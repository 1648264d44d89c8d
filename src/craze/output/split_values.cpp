#include "craze/output/split_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace craze {

namespace {

/// Values nearer than this, relative, are one: those of an edge are interpolated on both its sides.
constexpr double same_value = 1e-6;

/// The colours and attributes of a mesh that may differ, as one row of numbers a vertex.
struct Rows {
  const std::vector<Color>* colors = nullptr;
  std::vector<const Attribute*> attributes;

  std::size_t width() const {
    std::size_t numbers = colors ? 4 : 0;
    for (const Attribute* a : attributes) numbers += static_cast<std::size_t>(a->components);
    return numbers;
  }
  std::size_t count() const {
    if (colors) return colors->size();
    if (attributes.empty()) return 0;
    return attributes[0]->values.size() / static_cast<std::size_t>(attributes[0]->components);
  }
  std::vector<double> numbers() const {
    std::vector<double> all;
    all.reserve(width() * count());
    for (std::size_t v = 0; v < count(); ++v) {
      if (colors) all.insert(all.end(), (*colors)[v].begin(), (*colors)[v].end());
      for (const Attribute* a : attributes) {
        const auto first = a->values.begin() + static_cast<std::ptrdiff_t>(v) * a->components;
        all.insert(all.end(), first, first + a->components);
      }
    }
    return all;
  }
};

bool is_same(const double* a, const double* b, std::size_t count) {
  return std::equal(a, a + count, b, [](double x, double y) {
    return std::abs(x - y) <= same_value * std::max({1.0, std::abs(x), std::abs(y)});
  });
}

class Splitter {
 public:
  Splitter(const SurfaceMesh& surface, const SurfaceMesh& made, const SurfaceMesh& input,
           const SurfaceOrigin& origin)
      : input_(input), origin_(origin), split_{surface, {}}, vertices_(surface.positions.size()) {
    choose(surface, made);
    width_ = of_surface_.width();
    numbers_ = of_input_.numbers();
    values_ = of_surface_.numbers();
    split_.sources.resize(vertices_);
    std::iota(split_.sources.begin(), split_.sources.end(), 0);
    is_set_.assign(vertices_, 0);
    next_.assign(vertices_, -1);
  }

  SplitSurface split() {
    if (width_ == 0) return std::move(split_);
    for (std::size_t c = 0; c < 3 * split_.mesh.triangles.size(); ++c) {
      if (origin_.face[c / 3] >= 0) split_corner(c);
    }
    write_back();
    return std::move(split_);
  }

 private:
  /// What the input has and the surface still has as it was made.
  void choose(const SurfaceMesh& surface, const SurfaceMesh& made) {
    if (!input_.vertex_colors.empty() && surface.vertex_colors == made.vertex_colors) {
      of_input_.colors = &input_.vertex_colors;
      of_surface_.colors = &surface.vertex_colors;
    }
    for (const Attribute& a : input_.vertex_attributes) {
      const Attribute* now = find_attribute(surface.vertex_attributes, a.name);
      const Attribute* then = find_attribute(made.vertex_attributes, a.name);
      const bool is_kept = now && then && now->components == a.components &&
                           then->components == a.components && now->values == then->values;
      if (!is_kept) continue;
      of_input_.attributes.push_back(&a);
      of_surface_.attributes.push_back(now);
    }
  }

  /// The numbers that the input has where the corner is.
  std::vector<double> at_corner(std::size_t c) const {
    std::vector<double> own(width_, 0);
    const Triangle& t = input_.triangles[static_cast<std::size_t>(origin_.face[c / 3])];
    for (std::size_t i = 0; i < 3; ++i) {
      const double weight = origin_.weights[c][static_cast<int>(i)];
      if (weight == 0) continue;
      const double* row = &numbers_[width_ * static_cast<std::size_t>(t[i])];
      for (std::size_t k = 0; k < width_; ++k) own[k] += weight * row[k];
    }
    return own;
  }

  bool has(std::size_t v, const std::vector<double>& own) const {
    return is_same(own.data(), &values_[width_ * v], width_);
  }

  /// Gives the corner that copy of its vertex which has its numbers, made where there is none.
  void split_corner(std::size_t c) {
    const std::vector<double> own = at_corner(c);
    std::int32_t& corner = split_.mesh.triangles[c / 3][c % 3];
    auto v = static_cast<std::size_t>(corner);
    if (!is_set_[v]) {
      // Its first corner: what the vertex has stays, to the last bit, where that is the same.
      is_set_[v] = 1;
      if (!has(v, own)) {
        std::copy(own.begin(), own.end(),
                  values_.begin() + static_cast<std::ptrdiff_t>(width_ * v));
      }
      return;
    }
    while (!has(v, own) && next_[v] >= 0) v = static_cast<std::size_t>(next_[v]);
    if (!has(v, own)) {
      next_[v] = static_cast<std::int32_t>(split_.sources.size());
      v = split_.sources.size();
      split_.sources.push_back(corner);
      next_.push_back(-1);
      values_.insert(values_.end(), own.begin(), own.end());
    }
    corner = static_cast<std::int32_t>(v);
  }

  void write_back() {
    SurfaceMesh& mesh = split_.mesh;
    for (std::size_t v = vertices_; v < split_.sources.size(); ++v) {
      const auto source = static_cast<std::size_t>(split_.sources[v]);
      mesh.positions.push_back(Vec3(mesh.positions[source]));
      if (!mesh.vertex_colors.empty()) {
        mesh.vertex_colors.push_back(Color(mesh.vertex_colors[source]));
      }
    }
    for (Attribute& a : mesh.vertex_attributes) a = pick(a, split_.sources);
    const double* value = values_.data();
    std::vector<Attribute*> attributes;
    for (const Attribute* a : of_input_.attributes) {
      attributes.push_back(&*std::find_if(mesh.vertex_attributes.begin(),
                                          mesh.vertex_attributes.end(),
                                          [&](const Attribute& b) { return b.name == a->name; }));
    }
    for (std::size_t v = 0; v < split_.sources.size(); ++v) {
      for (std::size_t k = 0; of_input_.colors && k < 4; ++k) {
        mesh.vertex_colors[v][k] = static_cast<float>(*value++);
      }
      for (Attribute* a : attributes) {
        const auto width = static_cast<std::size_t>(a->components);
        for (std::size_t k = 0; k < width; ++k) a->values[width * v + k] = *value++;
      }
    }
  }

  const SurfaceMesh& input_;
  const SurfaceOrigin& origin_;
  SplitSurface split_;
  std::size_t vertices_, width_ = 0;
  Rows of_input_, of_surface_;
  std::vector<double> numbers_;       // of the input, a row a vertex
  std::vector<double> values_;        // of the split surface
  std::vector<std::uint8_t> is_set_;  // of vertices that a corner has come by
  std::vector<std::int32_t> next_;    // the next copy of the same vertex; -1: none
};

}  // namespace

SplitSurface with_values_of_input(const SurfaceMesh& surface, const SurfaceMesh& made,
                                  const SurfaceMesh& input, const SurfaceOrigin& origin) {
  return Splitter(surface, made, input, origin).split();
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
