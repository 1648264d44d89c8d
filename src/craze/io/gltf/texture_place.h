// Where a texture lies on its UVs.
#pragma once

#include <Eigen/Core>

#include "craze/io/gltf/gltf_json.h"
#include "craze/texture_wrap.h"

namespace craze {

/// 2 × 3: from (u, v, 1), v upwards, to the texture's, as a KHR_texture_transform says. Throws
/// Error(input).
Eigen::Matrix<double, 2, 3> texture_place(const Json& transform, const GltfJson& json);

/// How a texture's sampler has its picture go on; `texture` is one of the document's list.
TextureWraps texture_wraps(const Json& root, const Json& texture);

}  // namespace craze
