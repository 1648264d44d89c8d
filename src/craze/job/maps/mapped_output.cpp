#include "craze/job/maps/mapped_output.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "craze/base/text/format.h"
#include "craze/engine/cracked_surface.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/gltf/scene/scene_pictures.h"
#include "craze/io/source_scene.h"
#include "craze/job/maps/made_uvs.h"
#include "craze/maps.h"
#include "craze/mesh/corner_frames.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/map_surface.h"
#include "craze/products/maps/pictures/relaid_pictures.h"
#include "craze/products/maps/uv_layout.h"
#include "craze/write_mesh.h"

namespace craze {

namespace {

using Document = std::shared_ptr<const GltfDocument>;
using Warn = std::function<void(const std::string&)>;

/// What is written, before it has cracks.
struct MappedScene {
  Document document;
  std::map<std::int32_t, std::int32_t> materials;  ///< of the surface to the document's
};

/// The document itself, where the scene is one.
MappedScene mapped_scene(const SceneUvs& uvs) {
  MappedScene result{uvs.document, {}};
  for (const auto& [material, set] : uvs.set) {
    if (uvs.uncracked.count(material) == 0) result.materials[material] = material;
  }
  return result;
}

/// That of the GLB that holds `surface` and what it can of `scene`.
MappedScene mapped_scene(const SurfaceMesh& surface,
                         const std::shared_ptr<const SourceScene>& scene, const Warn& warn,
                         const Context& context) {
  MappedScene result;
  MeshFileOptions options;
  options.scene = scene;
  options.warn = warn;
  const MeshFile file = read_mesh(format_mesh(surface, "glb", options, context), "scene.glb");
  result.document = std::dynamic_pointer_cast<const GltfDocument>(file.scene);
  if (!result.document) {
    throw Error(ErrorKind::request, "cannot write the mapped mesh", "scene",
                "its scene cannot be kept");
  }
  // GLB has one primitive per material, in their order.
  std::int32_t next = 0;
  for (const std::int32_t material : used_materials(surface)) result.materials[material] = next++;
  return result;
}

/// Whether the scene brings pictures, which lie in the UVs that there are.
bool has_pictures(const SourceScene* scene) {
  if (!scene) return false;
  for (const SceneContent& content : scene->contents()) {
    if (content.kind == "pictures of materials" || content.kind == "images") return true;
  }
  return false;
}

/// By glTF a primitive without normals is flat. Section 3.7.2.1.
std::vector<Vec3> flat_normals(const SurfaceMesh& surface) {
  std::vector<Vec3> normals;
  for (const Triangle& t : surface.triangles) {
    const Vec3& p = surface.positions[t[0]];
    const Vec3 across = (surface.positions[t[1]] - p).cross(surface.positions[t[2]] - p);
    normals.insert(normals.end(), 3, across.stableNormalized());
  }
  return normals;
}

/// The surface that the cracks were cut into, with UVs that maps can be baked in.
SurfaceMesh surface_to_map(const Result& result, const SourceScene* scene, const Warn& warn,
                           const Context& context) {
  SurfaceMesh surface = *result.state().surface;
  surface.corner_normals = corner_normals(surface);
  const char* reason = surface.corner_uvs.empty() ? "has no UVs" : nullptr;
  if (!reason && !has_pictures(scene) &&
      !uv_layout(map_surface(result, {}, context), true, context).warnings.empty()) {
    reason = "has UVs that overlap";
  }
  if (!reason) return surface;
  warn(make_uvs(surface, reason, context));
  return surface;
}

int largest_side(const SurfacePictures& pictures) {
  int side = 0;
  for (const SurfacePicture* p :
       {&pictures.base_color, &pictures.normal, &pictures.occlusion, &pictures.roughness}) {
    side = std::max({side, p->image.width, p->image.height});
  }
  return side;
}

/// Hands the maps of each material to its pictures.
class MaterialMapSink : public MapSink {
 public:
  /// uvs: of a kept scene; null: all pictures lie in the UVs of the maps. All must outlive this.
  MaterialMapSink(const MappedScene& scene, const SceneUvs* uvs, const CrackStain& stain,
                  const Warn& warn, const Context& context)
      : materials_(scene.materials), uvs_(uvs), stain_(stain), warn_(warn), context_(context) {
    for (const auto& [own, documents] : scene.materials) {
      MaterialPictures& pictures =
          own_.emplace(own, material_pictures(*scene.document, documents, warn)).first->second;
      if (uvs && uvs->is_remeshed) keep_further_sets(pictures);
    }
  }

  int largest_picture() const {
    int side = 0;
    for (const auto& [material, own] : own_) side = std::max(side, largest_side(own.pictures));
    return side;
  }

  void begin(const std::vector<MapHeader>& headers) override {
    material_ = headers[0].material;
    MaterialPictures& own = own_.at(material_);
    if (uvs_) relay(own, headers[0].size);
    pictures_ = std::make_unique<CrackPictures>(own.pictures, own.base_factor, stain_, context_);
    pictures_->begin(headers);
  }
  void rows(int first, int count, const std::vector<const float*>& maps) override {
    pictures_->rows(first, count, maps);
  }
  void end() override {
    MaterialPictures& own = own_.at(material_);
    const std::size_t set = uvs_ ? uvs_->set.at(material_) : 0;
    made_.push_back({materials_.at(material_), pictures_->take(), own.kept, set,
                     uvs_ && uvs_->made.count(material_) > 0});
    pictures_.reset();
    own.pictures = {};
  }

  const std::vector<NewPictures>& made() const { return made_; }

 private:
  /// They stay as they are, with a warning: a remeshed surface does not tell where they lay.
  void keep_further_sets(MaterialPictures& own) const {
    SurfacePictures& p = own.pictures;
    const std::array<SurfacePicture*, 4> slots{&p.base_color, &p.normal, &p.occlusion,
                                               &p.roughness};
    bool any = false;
    for (std::size_t s = 0; s < slots.size(); ++s) {
      if (slots[s]->image.empty() || slots[s]->uv_set == 0) continue;
      *slots[s] = {};
      own.kept[s] = any = true;
    }
    if (any) warn_("pictures in further UV sets stay without cracks on a remeshed surface (maps)");
  }

  /// Pictures of other UV sets than that of the maps, into it.
  void relay(MaterialPictures& own, int size) {
    const std::size_t set = uvs_->set.at(material_);
    const bool is_made = uvs_->made.count(material_) > 0;
    SurfacePictures& pictures = own.pictures;
    OwnUvs from{};
    const std::array<const SurfacePicture*, 4> slots{&pictures.base_color, &pictures.normal,
                                                     &pictures.occlusion, &pictures.roughness};
    bool any = false;
    for (std::size_t s = 0; s < slots.size(); ++s) {
      if (slots[s]->image.empty() || (slots[s]->uv_set == set && !is_made)) continue;
      // A set that no part of the surface has is (0, 0) everywhere.
      from[s] = slots[s]->uv_set < uvs_->own.size() ? &uvs_->own[slots[s]->uv_set] : &no_uvs();
      any = true;
    }
    if (!any) return;
    MapSurface whole;
    whole.surface = uvs_->surface;
    whole.pieces = faces_as_pieces(whole.surface.corner_uvs);
    const MapSheet sheet = sheets_of_material(whole, material_, false).at(0);
    RelaidPictures relaid = relaid_pictures(pictures, from, whole, sheet, size, context_);
    pictures = std::move(relaid.pictures);
    constexpr double noticed = 1.5;
    if (relaid.pixels_per_texel < noticed || size >= MapOptions::largest_size) return;
    const std::vector<std::string>& names = whole.surface.material_names;
    warn_(
        fmt::format("the pictures of {} repeat, and are {:.2g} times coarser where they show its "
                    "cracks (maps); --map-size keeps more",
                    material_ < 0 ? "what has no material" : "'" + names[material_] + "'",
                    relaid.pixels_per_texel));
  }

  const std::vector<Vec2>& no_uvs() {
    if (no_uvs_.empty()) no_uvs_.assign(3 * uvs_->surface.triangles.size(), Vec2::Zero());
    return no_uvs_;
  }

  const std::map<std::int32_t, std::int32_t>& materials_;
  const SceneUvs* uvs_;
  const CrackStain& stain_;
  const Warn& warn_;
  const Context& context_;
  std::map<std::int32_t, MaterialPictures> own_;  // by the input's material
  std::vector<Vec2> no_uvs_;
  std::int32_t material_ = -1;  // of the maps that come
  std::unique_ptr<CrackPictures> pictures_;
  std::vector<NewPictures> made_;
};

/// The scene's surface, as glTF shades it.
SurfaceMesh surface_of_scene(const SceneUvs& uvs) {
  SurfaceMesh surface = uvs.surface;
  if (surface.corner_normals.empty()) surface.corner_normals = flat_normals(surface);
  return surface;
}

}  // namespace

MeshCounts write_mapped(const Result& result, const SceneUvs* uvs,
                        const std::shared_ptr<const SourceScene>& scene, const MappedOutput& output,
                        const Warn& warn, const Context& context) {
  const SurfaceMesh surface =
      uvs ? surface_of_scene(*uvs) : surface_to_map(result, scene.get(), warn, context);
  const MappedScene mapped = uvs ? mapped_scene(*uvs) : mapped_scene(surface, scene, warn, context);
  CrackStain stain = output.stain;
  stain.late = output.post.late_width;
  MaterialMapSink maps(mapped, uvs, stain, warn, context);
  MapOptions options;
  options.size = std::clamp(maps.largest_picture(), output.size, MapOptions::largest_size);
  options.maps = CrackPictures::maps();
  options.by_material = true;
  options.post = output.post;
  MapSurface baked = map_surface(result, surface, options.post, context);
  if (uvs) baked.left_out = uvs->uncracked;
  if (mapped.materials.empty()) {
    warn("there are no cracks: the materials stay as they are (maps)");
  } else {
    for (const std::string& warning : bake_surface(baked, options, maps, context)) warn(warning);
  }
  write_file(output.path, format_with_pictures(*mapped.document, maps.made(), context),
             "cannot write mesh", context);
  context.report({"write", 1});
  return count_mesh(surface);
}

}  // namespace craze
