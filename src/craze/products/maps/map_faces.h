// How a surface's faces lie in its UVs.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/corner_frames.h"
#include "craze/products/maps/seen_cracks.h"

namespace craze {

struct MapFace {
  FacePlane plane;
  Vec2 uv;       ///< of corner 0
  Mat2 by_uv;    ///< lengths in the plane per unit of u and v: its columns
  Mat2 weights;  ///< weights of corners 1 and 2 per length in the plane
};

/// Normal and tangents of a map at a point; none is unit inside a face, as shaders have it.
struct MapFrame {
  Vec3 tangent, bitangent, normal;
};

class MapFaces {
 public:
  /// `surface` must outlive this.
  explicit MapFaces(const SurfaceMesh& surface);

  const MapFace& operator[](std::int32_t f) const { return faces_[f]; }
  /// Where a point with these UVs lies in the plane of face f.
  Vec2 at(std::int32_t f, const Vec2& uv) const { return faces_[f].by_uv * (uv - faces_[f].uv); }
  /// Of the corners at a point of the plane; they sum to 1.
  Vec3 weights(std::int32_t f, const Vec2& p) const {
    const Vec2 w = faces_[f].weights * p;
    return {1 - w.x() - w.y(), w.x(), w.y()};
  }
  Vec3 position(std::int32_t f, const Vec2& p) const {
    const FacePlane& plane = faces_[f].plane;
    return plane.origin + p.x() * plane.x + p.y() * plane.y;
  }
  MapFrame frame(std::int32_t f, const Vec3& weights) const;
  /// The longest side of a texel, length.
  double texel(std::int32_t f, int size) const;

 private:
  std::vector<MapFace> faces_;
  std::vector<Vec3> normals_;
  CornerTangents tangents_;
};

}  // namespace craze
