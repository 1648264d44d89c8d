#include "craze/output/write_surface.h"

#include <numeric>

#include "craze/engine/cracked_surface.h"
#include "craze/io/files/extension.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/io/mesh_formats.h"
#include "craze/output/lost_data.h"
#include "craze/output/split_values.h"
#include "craze/products/opening/crack_edges.h"
#include "craze/products/opening/opened_origin.h"
#include "craze/products/opening/shading_normals.h"
#include "craze/recipe/own_lengths.h"
#include "craze/surface_origin.h"
#include "craze/write_mesh.h"

namespace craze {

namespace {

UpAxis up_axis(UpAxis wanted, const SourceFile& source) {
  return wanted == UpAxis::automatic && is_shape(source.name) ? UpAxis::z : wanted;
}

/// What both have; `looks` holds those that the options refer to.
MeshFileOptions options_of(const std::string& path, const SourceFile& source,
                           const SurfaceFileOptions& options, std::vector<MaterialLook>& looks) {
  looks = looks_from(source.looks, source.name, path);
  MeshFileOptions file;
  if (!looks.empty()) file.looks = &looks;
  file.objects = options.objects;
  file.animation = options.animation;
  file.scene = source.scene;
  file.warn = options.warn;
  return file;
}

void tell_lost(const std::string& path, const SurfaceMesh& surface, const SourceFile& source,
               const SurfaceFileOptions& options) {
  if (!options.warn) return;
  std::string_view format = "";
  const std::string extension = lower_extension(path);
  if (!extension.empty()) format = std::string_view(extension).substr(1);
  const std::string lost = describe_lost_data(surface, format, source.scene.get());
  if (!lost.empty()) options.warn(lost);
  const std::string rounded = describe_rounded_data(surface, format);
  if (!rounded.empty()) options.warn(rounded);
}

/// Whether only the origin of its faces ties the mesh to what else the file had.
bool keeps_scene_of(const std::string& path, const SourceFile& source) {
  return lower_extension(path) == ".glb" &&
         dynamic_cast<const GltfDocument*>(source.scene.get()) != nullptr;
}

/// Every face is where it was.
SurfaceOrigin unmoved(const SurfaceMesh& mesh) {
  SurfaceOrigin origin;
  origin.face.resize(mesh.triangles.size());
  std::iota(origin.face.begin(), origin.face.end(), 0);
  for (std::size_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
    origin.weights.push_back(Vec3::Unit(static_cast<int>(c % 3)));
  }
  origin.wall_begin = static_cast<std::int32_t>(mesh.triangles.size());
  return origin;
}

}  // namespace

void write_surface(const std::string& path, const SurfaceMesh& mesh, const OpenedSurface& shown,
                   const Result& result, const SourceFile& source,
                   const SurfaceFileOptions& options, const Context& context) {
  tell_lost(path, *result.state().surface, source, options);
  const std::string replaced = describe_replaced_data(*result.state().surface);
  if (options.warn && !replaced.empty()) options.warn(replaced);
  const Recipe& recipe = result.report().recipe;
  std::vector<MaterialLook> looks;
  MeshFileOptions file = options_of(path, source, options, looks);
  file.up = up_axis(recipe.picture.up, source);
  file.metres_per_unit = metres_per_unit(mesh, recipe);
  const std::string extension = lower_extension(path);
  const std::string scaled = describe_unit(file.metres_per_unit, extension.substr(1));
  if (options.warn && !scaled.empty()) options.warn(scaled);
  // A scene that is kept has its own vertices.
  const bool keeps = keeps_scene_of(path, source);
  const SurfaceMesh* lost = result.state().lost_values.get();
  if (keeps || extension == ".stl") lost = nullptr;
  SurfaceOrigin origin;
  if (keeps || lost) origin = opened_origin(result, shown);
  if (!origin.face.empty()) file.origin = &origin;
  file.bent = shown.curled;
  const MeshFormat* format = find_mesh_format(extension);
  if (shown.opened.solid && find_attribute(mesh.face_attributes, "fragment")) {
    if (format && format->holds_objects) {
      file.objects = "fragment";
      file.solids = recipe.post.collider;
    } else if (options.warn && extension == ".stl") {
      options.warn("pieces have no names in .stl: each is a closed shell of one list of triangles");
    }
  }
  if (shown.shut && file.objects.empty() && recipe.post.lines != ShutCracks::none) {
    file.crack_edges = crack_edges(result, shown);
  }
  SplitSurface split;
  const SurfaceMesh* written = &mesh;
  MorphAnimation animation;
  if (lost && origin.face.size() == mesh.triangles.size()) {
    SurfaceMesh held = *lost;
    if (extension == ".obj") held.vertex_attributes.clear();  // which it has no place for
    split = with_values_of_input(mesh, shown.mesh, held, origin);
    written = &split.mesh;
    if (file.animation) {
      animation = of_split(*file.animation, split);
      file.animation = &animation;
    }
  } else if (lost && options.warn && origin.face.empty()) {
    options.warn(
        "colours or attributes differ between vertices that lie at one place: the first one's are "
        "kept, as mesh.output = \"asset\" would keep all");
  }
  if (extension != ".glb" || !mesh.corner_normals.empty()) {
    write_mesh(path, *written, file, context);
    return;
  }
  // Viewers shade a GLB without normals flat.
  file.normals = [&] { return shading_normals(shown, result, options.crease); };
  write_mesh(path, *written, file, context);
}

void write_surface(const std::string& path, const SurfaceMesh& mesh, const SourceFile& source,
                   const SurfaceFileOptions& options, const Context& context) {
  tell_lost(path, mesh, source, options);
  std::vector<MaterialLook> looks;
  MeshFileOptions file = options_of(path, source, options, looks);
  file.up = up_axis(UpAxis::automatic, source);
  SurfaceOrigin origin;
  if (keeps_scene_of(path, source)) {
    origin = unmoved(mesh);
    file.origin = &origin;
  }
  write_mesh(path, mesh, file, context);
}

}  // namespace craze
