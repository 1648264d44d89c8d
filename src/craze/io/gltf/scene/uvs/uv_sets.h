// The UV sets of a kept document, read and added to.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <vector>

#include "craze/io/gltf/scene/gltf_document.h"

namespace craze {

/// Sets from this number on are not looked for.
inline constexpr std::size_t most_uv_sets = 64;

/// One UV set of the surface that was read.
struct UvSet {
  std::vector<Vec2> corners;  ///< 3 #F of the document, v upwards; zero where there are none
  std::vector<char> has;      ///< #F
};

/// TEXCOORD_`number`, with the default weights of morph targets. Throws Error(input).
UvSet uv_set(const GltfDocument& document, std::size_t number);

/// The number below which all sets of the surface's primitives are.
std::size_t uv_set_count(const GltfDocument& document);
/// Those of the primitives with these materials (−1: none) alone.
std::size_t uv_set_count(const GltfDocument& document, const std::set<std::int32_t>& materials);

/// The number of a part's material; −1: none.
std::int32_t material_of(const GltfDocument& document, const GltfPart& part);

/// A set for all faces of some materials.
struct FurtherUvs {
  std::set<std::int32_t> materials;  ///< −1: of the primitives that have none
  std::size_t number = 0;            ///< uv_set_count() of these or more
  std::vector<Vec2> corners;         ///< 3 #F of the document, v upwards, in single precision
};

/// The document with these as TEXCOORD_`number`, and as the sets below it that a primitive lacks.
/// Triangles and their order stay; vertices keep their numbers, with copies behind them where the
/// new set parts them; what several nodes show becomes single. Tangents are those of the new set,
/// and morph targets leave them. What has these materials and is not part of the surface gets
/// copies of them. Throws Error(input).
std::shared_ptr<const GltfDocument> with_further_uvs(const GltfDocument& document,
                                                     const FurtherUvs& uvs);

}  // namespace craze
