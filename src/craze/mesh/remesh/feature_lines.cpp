#include "craze/mesh/remesh/feature_lines.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "craze/base/elementary.h"

namespace craze {

namespace {

Vec3 unit_normal(const TriangleMesh& mesh, std::int32_t f) {
  const Triangle& t = mesh.triangle(f);
  return mesh.way(t[0], t[1]).cross(mesh.way(t[0], t[2])).normalized();
}

// Which ends of each edge have two different UVs, one per side.
class UvSeams {
 public:
  UvSeams(const SurfaceMesh& s, const TriangleMesh& mesh) : mesh_(mesh) {
    if (s.corner_uvs.empty()) return;
    torn_.resize(3 * mesh.face_count(), 0);
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      const std::int32_t o = mesh.opposite(h);
      if (o < 0) continue;
      // Readers may round the two sides differently; a millionth of the texture shows nowhere.
      const Vec2 step = s.corner_uvs[h] - s.corner_uvs[TriangleMesh::next(o)];
      torn_[h] = !(step.norm() < 1e-6);
    }
  }

  bool is_seam(std::int32_t h, std::int32_t o) const {
    if (torn_.empty()) return false;
    if (torn_[h] && torn_[o]) return true;
    if (torn_[h]) return !is_pole(mesh_.from(h));
    return torn_[o] && !is_pole(mesh_.from(o));
  }

 private:
  // The axis of a lathe has no longitude, so every face there has a UV of its own and every edge is
  // torn at this end; its far end is whole, but for a seam or two that end here.
  bool is_pole(std::int32_t v) const {
    int edges = 0, through = 0;
    bool all = true;
    mesh_.for_each_outgoing(v, [&](std::int32_t h) {
      const std::int32_t o = mesh_.opposite(h);
      ++edges;
      all = all && o >= 0 && torn_[h];
      through += o >= 0 && torn_[o];
    });
    return all && edges >= 4 && through <= 2;
  }

  const TriangleMesh& mesh_;
  std::vector<char> torn_;  // 3 #F: the end of halfedge h at from(h)
};

}  // namespace

std::vector<char> feature_lines(const SurfaceMesh& surface, const TriangleMesh& mesh,
                                double angle) {
  const double cosine = elementary::cos(angle * std::numbers::pi / 180);
  std::vector<Vec3> normals;
  normals.reserve(mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) normals.push_back(unit_normal(mesh, f));
  const UvSeams uvs(surface, mesh);
  const auto& materials = surface.face_materials;
  std::vector<char> marks(3 * mesh.face_count(), no_feature);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const std::int32_t o = mesh.opposite(h);
    if (o >= 0 &&
        (uvs.is_seam(h, o) || (!materials.empty() && materials[h / 3] != materials[o / 3]))) {
      marks[h] = seam;
    } else if (o < 0 || normals[h / 3].dot(normals[o / 3]) < cosine) {
      marks[h] = crease;
    }
  }
  return marks;
}

std::vector<char> without_short_creases(const TriangleMesh& mesh, std::vector<char> marks,
                                        const std::vector<double>& wanted) {
  // Vertices joined by marked edges form a web, named by its lowest vertex.
  std::vector<std::int32_t> web(mesh.vertex_count());
  std::iota(web.begin(), web.end(), 0);
  const auto find = [&](std::int32_t v) {
    while (web[v] != v) v = web[v] = web[web[v]];
    return v;
  };
  const std::int32_t halfedges = 3 * mesh.face_count();
  for (std::int32_t h = 0; h < halfedges; ++h) {
    if (marks[h] == no_feature) continue;
    const std::int32_t a = find(mesh.from(h)), b = find(mesh.to(h));
    web[std::max(a, b)] = std::min(a, b);
  }
  const double needed = 4;
  std::vector<double> edges(web.size(), 0);  // the length of a web in wanted edge lengths
  for (std::int32_t h = 0; h < halfedges; ++h) {
    const std::int32_t a = mesh.from(h), b = mesh.to(h);
    if (marks[h] == no_feature || mesh.opposite(h) > h) continue;
    const bool stays = marks[h] == seam || mesh.is_open(h);
    edges[find(a)] += stays ? needed : mesh.way(a, b).norm() / (0.5 * (wanted[a] + wanted[b]));
  }
  for (std::int32_t h = 0; h < halfedges; ++h) {
    if (marks[h] == crease && edges[find(mesh.from(h))] < needed) marks[h] = no_feature;
  }
  return marks;
}

}  // namespace craze
