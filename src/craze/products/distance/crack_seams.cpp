#include "craze/products/distance/crack_seams.h"

#include <algorithm>
#include <cmath>

#include "craze/base/segment_distance.h"
#include "craze/mesh/run_attributes.h"

namespace craze {

namespace {

/// Files round to single precision, and normals to less.
constexpr double same_uv = 1e-6, same_color = 1e-3, same_normal = 1e-3, same_value = 1e-6;
/// Relative: what a distance may be off.
constexpr double same_distance = 1e-5;

const Attribute* with_components(const SurfaceMesh& surface, const char* name, int components) {
  const Attribute* found = find_attribute(surface.vertex_attributes, name);
  return found && found->components == components ? found : nullptr;
}

/// Whether some vertex has corners of different UVs or normals, which then need no copies of it.
bool keeps_corners_apart(const SurfaceMesh& s) {
  std::vector<std::int32_t> first(s.positions.size(), -1);
  for (std::size_t c = 0; c < 3 * s.triangles.size(); ++c) {
    std::int32_t& known = first[s.triangles[c / 3][c % 3]];
    if (known < 0) known = static_cast<std::int32_t>(c);
    if (!s.corner_uvs.empty() && s.corner_uvs[c] != s.corner_uvs[known]) return true;
    if (!s.corner_normals.empty() && s.corner_normals[c] != s.corner_normals[known]) return true;
  }
  return false;
}

/// Whether most triangles are parted from all that they touch.
bool repeats_every_vertex(const TriangleMesh& mesh, const std::vector<SeamPiece>& pieces) {
  std::vector<std::uint8_t> parted(3 * static_cast<std::size_t>(mesh.face_count()), 0);
  for (const SeamPiece& piece : pieces) parted[piece.side] = parted[piece.other] = 1;
  std::int64_t alone = 0;
  for (std::size_t h = 0; h < parted.size(); h += 3) {
    alone += parted[h] && parted[h + 1] && parted[h + 2];
  }
  return 2 * alone > mesh.face_count();
}

/// Whether the object is a run's fragment: "fragment_7", below a node "cup/fragment_7".
bool is_fragment(const std::string& name) {
  const std::string own = name.substr(name.rfind('/') + 1);
  return own.starts_with("fragment_") && own.size() > 9 &&
         own.find_first_not_of("0123456789", 9) == std::string::npos;
}

class Seams {
 public:
  Seams(const SurfaceMesh& surface, const TriangleMesh& mesh)
      : surface_(surface),
        mesh_(mesh),
        distance_(with_components(surface, "crack_distance", 1)),
        displacement_(distance_ ? with_components(surface, "displacement", 3) : nullptr),
        keeps_corners_(!distance_ && keeps_corners_apart(surface)) {}

  std::vector<KnownSeam> known() const {
    const std::vector<SeamPiece> pieces =
        seam_pieces(mesh_, [&](std::int32_t h, std::int32_t g) { return go_together(h, g); });
    const bool tells_nothing = !distance_ && repeats_every_vertex(mesh_, pieces);
    std::vector<KnownSeam> seams;
    for (const SeamPiece& piece : pieces) {
      seams.push_back({piece, tells_nothing ? SeamKind::joined : kind(piece)});
    }
    return seams;
  }

 private:
  static std::int32_t next(std::int32_t h) { return TriangleMesh::next(h); }

  bool go_together(std::int32_t h, std::int32_t g) const {
    return displacement_ && is_moved(h, g) ? !moves_apart(h, g) : looks_same(h, g);
  }

  SeamKind kind(const SeamPiece& piece) const {
    const std::int32_t h = piece.side, g = piece.other;
    const bool off = distance_ && (is_off(h) || is_off(g));
    if (!piece.whole) return off ? SeamKind::border : SeamKind::crack;
    if (!distance_) {
      const bool same = keeps_corners_ ? has_same_vertices(h, g) : looks_same(h, g);
      return same ? SeamKind::crack : SeamKind::joined;
    }
    if (displacement_ && is_moved(h, g)) {
      if (!moves_apart(h, g)) return SeamKind::joined;
      return off ? SeamKind::border : SeamKind::crack;
    }
    const bool parts = !off && (looks_same(h, g) || is_nearest(h) || is_nearest(g));
    return parts ? SeamKind::crack : SeamKind::joined;
  }

  /// Whether an end is away from all cracks.
  bool is_off(std::int32_t h) const {
    return distance_at(mesh_.from(h)) || distance_at(mesh_.to(h));
  }
  bool distance_at(std::int32_t v) const { return !(distance_->values[v] <= 0); }

  /// Whether the edge, and no other, is the crack nearest to the corner opposite.
  bool is_nearest(std::int32_t h) const {
    const std::int32_t v = mesh_.from(TriangleMesh::prev(h));
    const Vec3 &apex = mesh_.position(v), &a = mesh_.position(mesh_.from(h)),
               &b = mesh_.position(mesh_.to(h));
    const double foot = nearest_on_segment(apex, a, b), own = point_segment_distance(apex, a, b);
    return foot > 0 && foot < 1 && std::abs(distance_->values[v] - own) <= same_distance * own;
  }

  Vec3 displacement(std::int32_t v) const {
    const double* u = &displacement_->values[3 * static_cast<std::size_t>(v)];
    return {u[0], u[1], u[2]};
  }
  bool is_moved(std::int32_t h, std::int32_t g) const {
    for (const std::int32_t side : {h, g}) {
      if (displacement(mesh_.from(side)) != Vec3::Zero()) return true;
      if (displacement(mesh_.to(side)) != Vec3::Zero()) return true;
    }
    return false;
  }
  bool moves_apart(std::int32_t h, std::int32_t g) const {
    return displacement(mesh_.from(h)) != displacement(mesh_.to(g)) ||
           displacement(mesh_.to(h)) != displacement(mesh_.from(g));
  }

  /// Whether nothing but a cut parts the two sides of an edge.
  bool looks_same(std::int32_t h, std::int32_t g) const {
    const std::vector<std::int32_t>& materials = surface_.face_materials;
    if (!materials.empty() && materials[h / 3] != materials[g / 3]) return false;
    return has_same_vertices(h, g) && is_same_corner(h, next(g)) && is_same_corner(next(h), g);
  }
  /// The same of what belongs to vertices rather than to corners.
  bool has_same_vertices(std::int32_t h, std::int32_t g) const {
    if (!is_same_object(h / 3, g / 3)) return false;
    return is_same_vertex(mesh_.from(h), mesh_.to(g)) && is_same_vertex(mesh_.to(h), mesh_.from(g));
  }
  bool is_same_object(std::int32_t f, std::int32_t g) const {
    const std::vector<std::int32_t>& objects = surface_.face_objects;
    if (objects.empty() || objects[f] == objects[g]) return true;
    const auto is_piece = [&](std::int32_t object) {
      return object >= 0 && is_fragment(surface_.object_names[object]);
    };
    return is_piece(objects[f]) && is_piece(objects[g]);
  }
  bool is_same_corner(std::int32_t c, std::int32_t d) const {
    const std::vector<Vec2>& uvs = surface_.corner_uvs;
    const std::vector<Vec3>& normals = surface_.corner_normals;
    if (!uvs.empty() && !((uvs[c] - uvs[d]).norm() <= same_uv)) return false;
    return normals.empty() || (normals[c] - normals[d]).norm() <= same_normal;
  }
  bool is_same_vertex(std::int32_t v, std::int32_t w) const {
    if (!surface_.vertex_colors.empty()) {
      const Color &a = surface_.vertex_colors[v], &b = surface_.vertex_colors[w];
      if (!std::equal(a.begin(), a.end(), b.begin(),
                      [](float x, float y) { return std::abs(x - y) <= same_color; })) {
        return false;
      }
    }
    for (const Attribute& a : surface_.vertex_attributes) {
      if (is_run_attribute(a.name)) continue;  // they differ at the sides of a crack
      for (int k = 0; k < a.components; ++k) {
        const double x = a.values[static_cast<std::size_t>(v) * a.components + k],
                     y = a.values[static_cast<std::size_t>(w) * a.components + k];
        const double scale = std::max({1.0, std::abs(x), std::abs(y)});
        if (!(std::abs(x - y) <= same_value * scale)) return false;
      }
    }
    return true;
  }
  const SurfaceMesh& surface_;
  const TriangleMesh& mesh_;
  const Attribute* distance_;
  const Attribute* displacement_;
  bool keeps_corners_;
};

}  // namespace

std::vector<KnownSeam> known_seams(const SurfaceMesh& surface, const TriangleMesh& mesh) {
  return Seams(surface, mesh).known();
}

std::vector<std::int32_t> crack_seams(const SurfaceMesh& surface, const TriangleMesh& mesh) {
  std::vector<std::int32_t> sides;
  for (const KnownSeam& seam : known_seams(surface, mesh)) {
    if (seam.kind == SeamKind::crack) {
      sides.insert(sides.end(), {seam.piece.side, seam.piece.other});
    }
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

}  // namespace craze
