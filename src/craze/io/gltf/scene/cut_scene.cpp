#include "craze/io/gltf/scene/cut_scene.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <numeric>

#include "craze/mesh/run_attributes.h"

namespace craze {

CutScene::CutScene(const GltfDocument& document, const SurfaceMesh& mesh,
                   const SurfaceOrigin& origin, const std::vector<std::int32_t>& crack_edges,
                   bool is_apart)
    : document_(document), mesh_(mesh), origin_(origin), parts_(document.parts().size()) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : document.positions()) box.extend(p);
  unnoticed_ = box.isEmpty() ? 0
                             : box.diagonal().norm() *
                                   static_cast<double>(std::numeric_limits<float>::epsilon()) / 2;
  std::vector<std::int32_t> by_source(mesh.triangles.size());
  std::iota(by_source.begin(), by_source.end(), 0);
  std::stable_sort(by_source.begin(), by_source.end(),
                   [&](std::int32_t a, std::int32_t b) { return origin.face[a] < origin.face[b]; });
  for (const std::int32_t f : by_source) {
    PartFaces& part = parts_[document.part_of(origin.face[f])];
    (f < origin.wall_begin ? part.faces : part.walls).push_back(f);
  }
  for (const std::int32_t h : crack_edges) {
    parts_[document.part_of(origin.face[h / 3])].crack_edges.push_back(h);
  }
  const bool whole = is_apart || has_new_attributes();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    parts_[p].is_changed =
        (whole && !parts_[p].faces.empty()) || is_changed(document.parts()[p], parts_[p]);
  }
}

bool CutScene::has_new_attributes() const {
  const std::vector<std::string>& known = document_.attributes();
  return std::any_of(mesh_.vertex_attributes.begin(), mesh_.vertex_attributes.end(),
                     [&](const Attribute& a) {
                       return !is_run_attribute(a.name) &&
                              std::find(known.begin(), known.end(), a.name) == known.end();
                     });
}

std::array<std::uint32_t, 3> CutScene::read_triangle(const GltfPart& part,
                                                     std::int32_t face) const {
  std::array<std::uint32_t, 3> vertices{};
  for (std::size_t i = 0; i < 3; ++i) {
    vertices[i] = static_cast<std::uint32_t>(document_.triangles()[face][i] - part.first_vertex);
  }
  return vertices;
}

std::array<std::uint32_t, 3> CutScene::triangle(const GltfPart& part, std::int32_t face) const {
  const auto [a, b, c] = read_triangle(part, face);
  return part.mirrored ? std::array{a, c, b} : std::array{a, b, c};
}

VertexBlend CutScene::blend(const GltfPart& part, std::int32_t face, int i) const {
  const std::size_t corner = 3 * static_cast<std::size_t>(face) + static_cast<std::size_t>(i);
  return make_blend(read_triangle(part, origin_.face[face]), origin_.weights[corner]);
}

VertexBlend CutScene::itself(std::uint32_t vertex) {
  VertexBlend blend;
  blend.from[0] = vertex;
  blend.weights[0] = 1;
  return blend;
}

std::array<int, 3> CutScene::order(const GltfPart& part, std::int32_t face) const {
  Mat3 corners;
  for (int i = 0; i < 3; ++i)
    corners.col(i) = origin_.weights[3 * static_cast<std::size_t>(face) + i];
  const bool is_turned = corners.determinant() < 0;  // by the repair of its orientation
  return is_turned == part.mirrored ? std::array{0, 1, 2} : std::array{0, 2, 1};
}

Vec3 CutScene::shift(const GltfPart& part, const VertexBlend& blend, std::int32_t vertex) const {
  Vec3 from = Vec3::Zero();
  for (int i = 0; i < blend.size(); ++i) {
    from += blend.weights[i] *
            document_.positions()[static_cast<std::size_t>(part.first_vertex) + blend.from[i]];
  }
  const Vec3 shift = mesh_.positions[vertex] - from;
  return shift.norm() > unnoticed_ ? shift : Vec3(0, 0, 0);
}

/// Unchanged: each face is a triangle of the document, nothing moved, and no vertex is asked for by
/// two of the cut mesh.
bool CutScene::is_changed(const GltfPart& part, const PartFaces& own) const {
  if (!own.walls.empty()) return true;
  std::vector<std::pair<std::uint32_t, std::int32_t>> vertices;
  for (std::size_t k = 0; k < own.faces.size(); ++k) {
    const std::int32_t f = own.faces[k];
    if (k > 0 && source(f) == source(own.faces[k - 1])) return true;
    for (int i = 0; i < 3; ++i) {
      const VertexBlend at = blend(part, f, i);
      const std::int32_t v = mesh_.triangles[f][static_cast<std::size_t>(i)];
      if (!at.is_copy() || !shift(part, at, v).isZero(0)) return true;
      vertices.emplace_back(at.from[0], v);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end(), [](const auto& a, const auto& b) {
           return a.first == b.first;
         }) != vertices.end();
}

}  // namespace craze
