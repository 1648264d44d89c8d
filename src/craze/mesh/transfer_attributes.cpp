#include "craze/mesh/transfer_attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "craze/base/parallel.h"
#include "craze/mesh/uv_islands.h"

namespace craze {

namespace {

constexpr double snap = 1e-9;
constexpr std::size_t grain = 4096;  // vertices or corners in a part of a loop

/// The sum of weight × value(corner) over the corners that count; a corner alone is an exact copy.
template <class Value>
auto interpolate(const TrianglePoint& at, Value&& value) {
  auto sum = value(at.corners[0]);
  if (at.weights[0] == 1) return sum;
  sum *= at.weights[0];
  for (int i = 1; i < 3; ++i) {
    if (at.weights[i] != 0) sum += at.weights[i] * value(at.corners[i]);
  }
  return sum;
}

TrianglePoint at_corner(std::int32_t c) {
  return {{c, (c + 1) % 3, (c + 2) % 3}, {1, 0, 0}};
}

/// The nearest point of the edge between two corners, the lower vertex first.
TrianglePoint on_edge(const SurfaceMesh& surface, std::int32_t f, const Vec3& p, std::int32_t a,
                      std::int32_t b) {
  const Triangle& t = surface.triangles[f];
  if (t[a] > t[b]) std::swap(a, b);
  const Vec3& origin = surface.positions[t[a]];
  const Vec3 edge = surface.positions[t[b]] - origin;
  const double squared = edge.squaredNorm();
  const double s = squared > 0 ? std::clamp((p - origin).dot(edge) / squared, 0.0, 1.0) : 0;
  if (s < snap) return at_corner(a);
  if (s > 1 - snap) return at_corner(b);
  return {{a, b, 3 - a - b}, {1 - s, s, 0}};
}

/// Calls body(i) for i in [0, n), in any order.
template <class Body>
void transfer_each(const Threads& threads, std::size_t n, const Body& body) {
  const auto part = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(static_cast<std::int32_t>(i));
  };
  parallel_for(threads, n, grain, part);
}

/// Of vertex v: faces[first[v]], …, faces[first[v + 1] − 1], ascending.
struct FacesAroundVertices {
  std::vector<std::int32_t> first, faces;

  explicit FacesAroundVertices(const SurfaceMesh& surface)
      : first(surface.positions.size() + 1, 0), faces(3 * surface.triangles.size()) {
    for (const Triangle& t : surface.triangles) {
      for (const std::int32_t v : t) ++first[v + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
      for (const std::int32_t v : surface.triangles[f])
        faces[next[v]++] = static_cast<std::int32_t>(f);
    }
  }
};

/// Finds the corners of the cut mesh in the triangles of `surface`.
class CornerSources {
 public:
  CornerSources(const SurfaceMesh& surface, const TriangleMesh& cut, const Threads& threads)
      : surface_(surface), cut_(cut) {
    std::vector<std::int32_t> slid;
    for (std::int32_t v = 0; v < cut.vertex_count(); ++v) {
      if (cut.anchor(v) >= 0) slid.push_back(v);
    }
    if (slid.empty()) return;
    const FacesAroundVertices around(surface);
    home_.assign(cut.vertex_count(), -1);
    transfer_each(threads, slid.size(), [&](std::int32_t i) {
      const std::int32_t v = slid[i];
      home_[v] = nearest_face(around, surface.triangles[cut.anchor(v)], cut.position(v));
    });
  }

  /// The triangle in which a corner takes its attributes: its face's source, but for a vertex that
  /// has slid the nearest one of those around its anchor.
  std::int32_t triangle(std::int32_t h) const {
    const std::int32_t found = home_.empty() ? -1 : home_[cut_.from(h)];
    return found >= 0 ? found : cut_.source_face(TriangleMesh::face_of(h));
  }
  TrianglePoint point(std::int32_t h) const { return point_in(triangle(h), h); }
  /// The point of a triangle of `surface` that is nearest to the corner.
  TrianglePoint point_in(std::int32_t f, std::int32_t h) const {
    return locate_in_triangle(surface_, f, cut_.position(cut_.from(h)));
  }
  bool any_has_slid() const { return !home_.empty(); }

 private:
  std::int32_t nearest_face(const FacesAroundVertices& around, const Triangle& anchor,
                            const Vec3& p) const {
    double least = std::numeric_limits<double>::infinity();
    std::int32_t nearest = -1;
    for (const std::int32_t corner : anchor) {
      for (std::int32_t i = around.first[corner]; i < around.first[corner + 1]; ++i) {
        const std::int32_t f = around.faces[i];
        const TrianglePoint at = locate_in_triangle(surface_, f, p);
        const Vec3 found = interpolate(
            at, [&](int c) -> Vec3 { return surface_.positions[surface_.triangles[f][c]]; });
        const double distance = (found - p).squaredNorm();
        // Of faces that are as near, the first: copies of the vertex must agree.
        if (distance > least || (distance == least && f >= nearest)) continue;
        least = distance;
        nearest = f;
      }
    }
    return nearest;
  }

  const SurfaceMesh& surface_;
  const TriangleMesh& cut_;
  std::vector<std::int32_t> home_;  // #V of the cut mesh; empty: none has slid
};

/// Each face stays in the island of its source: where a vertex has slid across a seam that was not
/// one when the surface was cut, its corners are left on the borders of their islands.
std::vector<Vec2> transfer_uvs(const SurfaceMesh& surface, const TriangleMesh& cut,
                               const CornerSources& sources, const Threads& threads) {
  std::vector<std::int32_t> islands;
  if (sources.any_has_slid()) islands = uv_islands(surface);
  std::vector<Vec2> uvs(3 * static_cast<std::size_t>(cut.face_count()));
  transfer_each(threads, uvs.size(), [&](std::int32_t k) {
    std::int32_t from = sources.triangle(k);
    const std::int32_t own = cut.source_face(TriangleMesh::face_of(k));
    if (!islands.empty() && islands[from] != islands[own]) from = own;
    const std::size_t first = 3 * static_cast<std::size_t>(from);
    uvs[k] = interpolate(sources.point_in(from, k),
                         [&](int c) -> Vec2 { return surface.corner_uvs[first + c]; });
  });
  return uvs;
}

std::vector<Vec3> transfer_normals(const SurfaceMesh& surface, const CornerSources& sources,
                                   std::int32_t corners, const Threads& threads) {
  std::vector<Vec3> normals(corners);
  transfer_each(threads, normals.size(), [&](std::int32_t k) {
    const std::size_t first = 3 * static_cast<std::size_t>(sources.triangle(k));
    const TrianglePoint point = sources.point(k);
    const auto value = [&](int c) -> Vec3 { return surface.corner_normals[first + c]; };
    normals[k] = interpolate(point, value);
    if (point.weights[0] == 1) return;
    // Opposite normals at a fold cancel: take the nearest corner's.
    const double length = normals[k].norm();
    if (length > snap) {
      normals[k] /= length;
    } else {
      const auto& w = point.weights;
      normals[k] = value(point.corners[std::max_element(w.begin(), w.end()) - w.begin()]);
    }
  });
  return normals;
}

Attribute transfer_face_attribute(const Attribute& source, const TriangleMesh& cut) {
  Attribute result{source.name, source.components, {}};
  result.values.reserve(static_cast<std::size_t>(cut.face_count()) * source.components);
  for (std::int32_t f = 0; f < cut.face_count(); ++f) {
    const auto begin =
        source.values.begin() + static_cast<std::ptrdiff_t>(cut.source_face(f)) * source.components;
    result.values.insert(result.values.end(), begin, begin + source.components);
  }
  return result;
}

}  // namespace

TrianglePoint locate_in_triangle(const SurfaceMesh& surface, std::int32_t f, const Vec3& p) {
  const Triangle& t = surface.triangles[f];
  const Vec3 &a = surface.positions[t[0]], &b = surface.positions[t[1]],
             &c = surface.positions[t[2]];
  for (std::int32_t i = 0; i < 3; ++i) {
    if (p == surface.positions[t[i]]) return at_corner(i);
  }
  const Vec3 normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  const double edges[3] = {(c - b).squaredNorm(), (a - c).squaredNorm(), (b - a).squaredNorm()};
  const auto longest = static_cast<std::int32_t>(std::max_element(edges, edges + 3) - edges);
  // A triangle without area is as good as its longest edge.
  if (!(squared > snap * snap * edges[longest] * edges[longest])) {
    return on_edge(surface, f, p, (longest + 1) % 3, (longest + 2) % 3);
  }
  const double w[3] = {normal.dot((c - b).cross(p - b)) / squared,
                       normal.dot((a - c).cross(p - c)) / squared,
                       normal.dot((b - a).cross(p - a)) / squared};
  const auto least = static_cast<std::int32_t>(std::min_element(w, w + 3) - w);
  if (w[least] < snap) return on_edge(surface, f, p, (least + 1) % 3, (least + 2) % 3);
  return {{0, 1, 2}, {w[0], w[1], 1 - w[0] - w[1]}};
}

SurfaceMesh transfer_attributes(const SurfaceMesh& surface, const TriangleMesh& cut,
                                const Threads& threads) {
  SurfaceMesh result;
  result.positions = cut.positions();
  result.metres_per_unit = surface.metres_per_unit;
  result.triangles = cut.triangles();
  const CornerSources sources(surface, cut, threads);
  const std::int32_t corners = 3 * cut.face_count();
  if (!surface.corner_uvs.empty()) result.corner_uvs = transfer_uvs(surface, cut, sources, threads);
  if (!surface.corner_normals.empty()) {
    result.corner_normals = transfer_normals(surface, sources, corners, threads);
  }

  // Calls take(v, source vertices, weights) for each vertex of the cut mesh, in any order.
  const auto for_each_vertex = [&](auto&& take) {
    transfer_each(threads, cut.positions().size(), [&](std::int32_t v) {
      const std::int32_t h = cut.first_halfedge(v);
      if (h < 0) {
        take(v, Triangle{cut.root(v), cut.root(v), cut.root(v)}, at_corner(0));
      } else {
        take(v, surface.triangles[sources.triangle(h)], sources.point(h));
      }
    });
  };
  if (!surface.vertex_colors.empty()) {
    result.vertex_colors.resize(cut.vertex_count());
    for_each_vertex([&](std::int32_t v, const Triangle& t, const TrianglePoint& at) {
      for (std::size_t channel = 0; channel < 4; ++channel) {
        result.vertex_colors[v][channel] = static_cast<float>(
            interpolate(at, [&](int c) -> double { return surface.vertex_colors[t[c]][channel]; }));
      }
    });
  }
  for (const Attribute& source : surface.vertex_attributes) {
    Attribute a{source.name, source.components, {}};
    a.values.resize(static_cast<std::size_t>(cut.vertex_count()) * a.components);
    for_each_vertex([&](std::int32_t v, const Triangle& t, const TrianglePoint& at) {
      for (int i = 0; i < a.components; ++i) {
        a.values[static_cast<std::size_t>(v) * a.components + i] =
            interpolate(at, [&](int c) -> double {
              return source.values[static_cast<std::size_t>(t[c]) * a.components + i];
            });
      }
    });
    result.vertex_attributes.push_back(std::move(a));
  }

  for (const Attribute& source : surface.face_attributes) {
    result.face_attributes.push_back(transfer_face_attribute(source, cut));
  }
  result.material_names = surface.material_names;
  const bool has_materials = !surface.face_materials.empty();
  result.object_names = surface.object_names;
  const bool has_objects = !surface.face_objects.empty();
  const bool has_sources = !surface.source_faces.empty();
  result.source_faces.reserve(cut.face_count());
  if (has_materials) result.face_materials.reserve(cut.face_count());
  for (std::int32_t f = 0; f < cut.face_count(); ++f) {
    const std::int32_t source = cut.source_face(f);
    if (has_materials) result.face_materials.push_back(surface.face_materials[source]);
    if (has_objects) result.face_objects.push_back(surface.face_objects[source]);
    result.source_faces.push_back(has_sources ? surface.source_faces[source] : source);
  }
  return result;
}

}  // namespace craze
