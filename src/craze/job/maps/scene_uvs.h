// Which UVs of a kept scene its maps lie in.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/products/maps/map_surface.h"
#include "craze/products/maps/pictures/relaid_pictures.h"

namespace craze {

/// Each material's maps lie in the first of its UV sets that all of its faces have and where no
/// two places share a texel; in a further one, made for it, where there is none.
struct SceneUvs {
  std::shared_ptr<const GltfDocument> document;  ///< with the sets that were made
  SurfaceMesh surface;                           ///< what the cracks were cut into, in those UVs
  std::map<std::int32_t, std::size_t> set;       ///< by material (−1: none): TEXCOORD_n
  std::set<std::int32_t> made;                   ///< materials whose set was made
  std::set<std::int32_t> uncracked;  ///< materials that no crack touches, which stay as they are
  /// 3 #F of `surface`, by number: the UV sets that the file had.
  std::vector<std::vector<Vec2>> own;
  bool is_remeshed = false;  ///< the surface has the first set alone
  std::string warning;       ///< of sets that were made; empty: none were

  /// Whether all lie in the first set, as the file has it.
  bool is_first_alone() const;
};

/// Throws Error(request) where a part of the surface has no first set, which is all that a remeshed
/// one has.
void check_first_uvs(const GltfDocument& document);

/// `document` came with the input of `result`. for_files: of every material, cracked or not, and
/// UDIM tiles may lie side by side. Where the surface was remeshed its one set is all there is.
/// Throws Error(request) where that has no UVs, and Cancelled.
SceneUvs scene_uvs(const Result& result, const std::shared_ptr<const GltfDocument>& document,
                   bool for_files, const Context& context);

}  // namespace craze
