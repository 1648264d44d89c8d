#include "craze/products/maps/map_faces.h"

#include <algorithm>

namespace craze {

namespace {

/// Zero where m has no inverse that doubles can hold.
Mat2 inverse_or_zero(const Mat2& m) {
  const double d = m.determinant();
  if (d == 0) return Mat2::Zero();
  const Mat2 inverse = m.inverse();
  return inverse.allFinite() ? inverse : Mat2::Zero();
}

}  // namespace

MapFaces::MapFaces(const SurfaceMesh& surface)
    : normals_(corner_normals(surface)), tangents_(corner_tangents(surface, normals_)) {
  faces_.reserve(surface.triangles.size());
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    MapFace face;
    face.plane = face_plane(surface, static_cast<std::int32_t>(f));
    face.uv = surface.corner_uvs[3 * f];
    Mat2 lengths, uvs;
    lengths << face.plane.corners[1], face.plane.corners[2];
    uvs << surface.corner_uvs[3 * f + 1] - face.uv, surface.corner_uvs[3 * f + 2] - face.uv;
    face.by_uv = lengths * inverse_or_zero(uvs);
    if (!face.by_uv.allFinite()) face.by_uv.setZero();
    face.weights = inverse_or_zero(lengths);
    faces_.push_back(face);
  }
}

MapFrame MapFaces::frame(std::int32_t f, const Vec3& weights) const {
  const std::size_t c = 3 * static_cast<std::size_t>(f);
  const auto mix = [&](const std::vector<Vec3>& corners) -> Vec3 {
    return weights[0] * corners[c] + weights[1] * corners[c + 1] + weights[2] * corners[c + 2];
  };
  MapFrame frame;
  frame.tangent = mix(tangents_.tangent);
  frame.normal = mix(normals_);
  frame.bitangent = tangents_.handed[f] * frame.normal.cross(frame.tangent);
  return frame;
}

double MapFaces::texel(std::int32_t f, int size) const {
  const Mat2& m = faces_[f].by_uv;
  return std::max(m.col(0).norm(), m.col(1).norm()) / size;
}

}  // namespace craze
