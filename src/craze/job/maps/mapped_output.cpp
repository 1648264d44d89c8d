#include "craze/job/maps/mapped_output.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "craze/engine/cracked_surface.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/gltf/scene/scene_pictures.h"
#include "craze/io/source_scene.h"
#include "craze/job/maps/made_uvs.h"
#include "craze/maps.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/corner_frames.h"
#include "craze/products/maps/map_surface.h"
#include "craze/products/maps/uv_layout.h"
#include "craze/write_mesh.h"

namespace craze {

namespace {

using Document = std::shared_ptr<const GltfDocument>;
using Warn = std::function<void(const std::string&)>;

bool is_document(const SourceScene* scene) {
  return dynamic_cast<const GltfDocument*>(scene) != nullptr;
}

/// What is written, before it has cracks.
struct MappedScene {
  Document document;
  std::map<std::int32_t, std::int32_t> materials;  ///< of the surface to the document's
};

std::set<std::int32_t> used_materials(const SurfaceMesh& mesh) {
  if (mesh.face_materials.empty()) return {-1};
  return {mesh.face_materials.begin(), mesh.face_materials.end()};
}

/// The document itself, or that of the GLB that holds `surface` and what it can of `scene`.
MappedScene mapped_scene(const SurfaceMesh& surface,
                         const std::shared_ptr<const SourceScene>& scene, const Warn& warn,
                         const Context& context) {
  MappedScene result;
  result.document = std::dynamic_pointer_cast<const GltfDocument>(scene);
  const bool is_kept = result.document != nullptr;
  if (!is_kept) {
    MeshFileOptions options;
    options.scene = scene;
    options.warn = warn;
    const MeshFile file = read_mesh(format_mesh(surface, "glb", options, context), "scene.glb");
    result.document = std::dynamic_pointer_cast<const GltfDocument>(file.scene);
  }
  if (!result.document) {
    throw Error(ErrorKind::request, "cannot write the mapped mesh", "scene",
                "its scene cannot be kept");
  }
  // GLB has one primitive per material, in their order.
  std::int32_t next = 0;
  for (const std::int32_t material : used_materials(surface)) {
    result.materials[material] = is_kept ? material : next++;
  }
  return result;
}

/// Whether the scene brings pictures, which lie in the UVs that there are.
bool has_pictures(const SourceScene* scene) {
  if (!scene) return false;
  for (const SceneContent& content : scene->contents()) {
    if (content.kind == "pictures of base colours" || content.kind == "images") return true;
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
  if (is_document(scene)) {
    if (surface.corner_normals.empty()) surface.corner_normals = flat_normals(surface);
    return surface;
  }
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
class MaterialMaps : public MapSink {
 public:
  MaterialMaps(const MappedScene& scene, const CrackStain& stain, const Warn& warn,
               const Context& context)
      : stain_(stain), context_(context) {
    for (const auto& [own, documents] : scene.materials) {
      own_.emplace(own, material_pictures(*scene.document, documents, warn));
    }
    materials_ = &scene.materials;
  }

  int largest_picture() const {
    int side = 0;
    for (const auto& [material, own] : own_) side = std::max(side, largest_side(own.pictures));
    return side;
  }

  void begin(const std::vector<MapHeader>& headers) override {
    material_ = headers[0].material;
    const MaterialPictures& own = own_.at(material_);
    pictures_ = std::make_unique<CrackPictures>(own.pictures, own.base_factor, stain_, context_);
    pictures_->begin(headers);
  }
  void rows(int first, int count, const std::vector<const float*>& maps) override {
    pictures_->rows(first, count, maps);
  }
  void end() override {
    made_.push_back({materials_->at(material_), pictures_->take(), own_.at(material_).kept});
    pictures_.reset();
  }

  const std::vector<NewPictures>& made() const { return made_; }

 private:
  const CrackStain& stain_;
  const Context& context_;
  const std::map<std::int32_t, std::int32_t>* materials_;
  std::map<std::int32_t, MaterialPictures> own_;  // by the input's material
  std::int32_t material_ = -1;                    // of the maps that come
  std::unique_ptr<CrackPictures> pictures_;
  std::vector<NewPictures> made_;
};

}  // namespace

void check_mappable(const SurfaceMesh& input, const SourceScene* scene) {
  if (is_document(scene)) check_uvs(input);
}

MeshCounts write_mapped(const Result& result, const std::shared_ptr<const SourceScene>& scene,
                        const MappedOutput& output, const Warn& warn, const Context& context) {
  const SurfaceMesh surface = surface_to_map(result, scene.get(), warn, context);
  const MappedScene mapped = mapped_scene(surface, scene, warn, context);
  CrackStain stain = output.stain;
  stain.late = output.post.late_width;
  MaterialMaps maps(mapped, stain, warn, context);
  MapOptions options;
  options.size = std::clamp(maps.largest_picture(), output.size, MapOptions::largest_size);
  options.maps = CrackPictures::maps();
  options.by_material = true;
  options.post = output.post;
  for (const std::string& warning :
       bake_surface(map_surface(result, surface, options.post, context), options, maps, context)) {
    warn(warning);
  }
  write_file(output.path, format_with_pictures(*mapped.document, maps.made(), context),
             "cannot write mesh", context);
  return count_mesh(surface);
}

}  // namespace craze
