// The pictures of a kept document's materials, read, and put back changed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "craze/base/surface_pictures.h"
#include "craze/context.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Whether each of a material's pictures stays as it is: base colour, normal, occlusion, roughness.
using KeptPictures = std::array<bool, 4>;

/// One material's pictures, decoded.
struct MaterialPictures {
  SurfacePictures pictures;
  Color base_factor{1, 1, 1, 1};
  KeptPictures kept{};  ///< those that cannot be changed; empty in `pictures`
};

/// Of a material of the document; −1: of what has none. A picture that cannot be read stays as it
/// is, which `warn` is told in one sentence.
MaterialPictures material_pictures(const GltfDocument& document, std::int32_t material,
                                   const std::function<void(const std::string&)>& warn);

/// Pictures that take the place of a material's own.
struct NewPictures {
  std::int32_t material = -1;  ///< of the document; −1: of the primitives that have none
  SurfacePictures pictures;    ///< 8 bits; roughness holds occlusion in red; factors are 1
  KeptPictures kept{};         ///< what none of them takes the place of
  std::size_t uv_set = 0;      ///< TEXCOORD_n that they lie in
  bool has_tangents = false;   ///< the document's tangents are those of that set
};

/// The document with these pictures, the rest as it is: every primitive keeps its accessors byte
/// for byte, without tangents of other UVs than those that normals lie in. Pictures that nothing
/// else uses give their place to the new ones. Throws Error(request) for more than 4 GB, and
/// Cancelled.
std::string format_with_pictures(const GltfDocument& document,
                                 const std::vector<NewPictures>& materials, const Context& context);

}  // namespace craze
