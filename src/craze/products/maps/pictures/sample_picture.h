// Pictures at points of the UVs.
#pragma once

#include "craze/base/surface_pictures.h"
#include "craze/surface_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// Reads a picture between its pixels, and beyond 0 … 1 as its wraps say.
class PictureSampler {
 public:
  /// `picture` must outlive this; empty: white everywhere.
  explicit PictureSampler(const SurfacePicture& picture)
      : image_(picture.image), place_(picture.place), wraps_(picture.wraps) {}

  /// Red, green, blue and alpha as stored, 0 … 1, bilinearly, at UVs of the mesh; at the
  /// middle of a pixel its own numbers. A grey picture has three alike; alpha is 1 where there is
  /// none.
  Color color(const Vec2& mesh_uv) const;

 private:
  const Image& image_;
  const Eigen::Matrix<double, 2, 3>& place_;
  TextureWraps wraps_;
};

}  // namespace craze
