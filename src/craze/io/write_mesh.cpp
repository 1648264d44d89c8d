#include "craze/write_mesh.h"
#include "craze/mesh/morph_animation.h"

#include <algorithm>
#include <map>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/extension.h"
#include "craze/io/files/look_pictures.h"
#include "craze/io/gltf/gltf.h"
#include "craze/io/gltf/materials/material_extent.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/io/mesh_formats.h"
#include "craze/io/obj/looks_library.h"
#include "craze/io/obj/obj_scene.h"
#include "craze/io/ply/ply_scene.h"
#include "craze/io/source_scene.h"

namespace craze {

namespace {

/// ".ply, .obj, .stl or .glb": the formats that can be written and meet the condition.
template <class Condition>
std::string list_formats(const char* joined_by, Condition condition) {
  std::string list, last;
  for (const MeshFormat& format : mesh_formats()) {
    if (!format.write || !condition(format)) continue;
    if (!last.empty()) list += (list.empty() ? "" : ", ") + last;
    last = fmt::format(".{}", format.name);
  }
  return list.empty() ? last : list + joined_by + last;
}

/// `where`: the file or the format, for messages.
const MeshFormat& writable_format(std::string_view name, const std::string& where) {
  const MeshFormat* format = find_mesh_format(name);
  if (format && format->write) return *format;
  throw Error(ErrorKind::usage, "cannot write mesh", where,
              "the extension must be " + list_formats(" or ", [](const auto&) { return true; }));
}

void check_options(const MeshFormat* format, const std::string& where, bool objects,
                   bool animation) {
  if (objects && !(format && format->holds_objects)) {
    throw Error(ErrorKind::usage, "cannot write fragments as objects", where,
                fmt::format("only {} hold several objects{}",
                            list_formats(" and ", [](const auto& f) { return f.holds_objects; }),
                            format && format->name == "ply"
                                ? "; in .ply each face has its number as fragment"
                                : ""));
  }
  if (animation && !(format && format->holds_animation)) {
    throw Error(
        ErrorKind::usage, "cannot write the growth into the mesh", where,
        fmt::format("only {} can move; give --frames for one file per moment",
                    list_formats(" and ", [](const auto& f) { return f.holds_animation; })));
  }
}

/// Kinds of a scene's contents that the format keeps of that scene.
std::vector<std::string> kept_kinds(const MeshFormat& format, const SourceScene& scene,
                                    bool has_own_objects) {
  std::vector<std::string> kept;
  // Other formats' materials have no place in a PLY, and their pictures none without them.
  if (format.name == "ply" && dynamic_cast<const PlyScene*>(&scene))
    kept = {"comments", "obj_info lines", "pictures of materials", "textures that were not read"};
  if (format.name == "usda") {
    kept = {"materials",
            "textures",
            "images",
            "material libraries",
            "pictures of materials",
            "textures that were not read"};
  }
  if (format.name == "obj" || format.name == "glb") {
    kept = {"materials", "textures", "images", "material libraries", "pictures of materials"};
    if (!has_own_objects) kept.emplace_back("objects and groups");
    if (!has_own_objects && format.name == "obj") {
      kept.emplace_back("nodes");
      kept.emplace_back("name of the node");
    }
    if (format.name == "obj") {
      kept.emplace_back("of the materials");
      kept.emplace_back("textures that were not read");
    }
  }
  return kept;
}

/// Where there is one node with one mesh, its place is the surface's: only names can be lost.
void name_the_only_ones(std::vector<SceneContent>& contents) {
  std::map<std::string, SceneContent*> of;
  for (SceneContent& content : contents) of[content.kind] = &content;
  const auto nodes = of.find("nodes"), meshes = of.find("meshes");
  if (nodes == of.end() || meshes == of.end()) return;
  SceneContent &node = *nodes->second, &mesh = *meshes->second;
  if (node.names.size() > 1 || mesh.names.size() > 1) return;
  if (mesh.names == node.names) mesh.names.clear();
  node.kind = "name of the node";
  mesh.kind = "name of the mesh";
  for (SceneContent* content : {&node, &mesh}) {
    content->tells_names = true;
    std::erase(content->names, std::string());
  }
  std::erase_if(contents, [](const SceneContent& content) { return content.names.empty(); });
}

void warn_of_lost(const MeshFormat& format, const SurfaceMesh& mesh,
                  const MeshFileOptions& options) {
  if (!options.scene || !options.warn) return;
  if (format.name == "glb" && keeps_scene(options)) return;
  std::string target = fmt::format(".{}", format.name);
  if (!options.objects.empty()) target += " with fragments as objects";
  std::vector<SceneContent> contents = options.scene->contents();
  name_the_only_ones(contents);
  std::vector<std::string> kept = kept_kinds(format, *options.scene, !options.objects.empty());
  if (format.name == "glb" && keeps_nodes(mesh, options)) {
    target += " of another surface than the input's";
    for (const char* kind :
         {"nodes", "meshes", "name of the node", "name of the mesh", "animations", "cameras",
          "lights", "copyright", "extensions", "extras"}) {
      kept.emplace_back(kind);
    }
  }
  std::string lost = describe_lost(contents, kept, target);
  const auto* document = dynamic_cast<const GltfDocument*>(options.scene.get());
  const bool is_obj = format.name == "obj";
  if (document && (is_obj || format.name == "usda") &&
      says_more(document->root(), is_obj ? MaterialExtent::color : MaterialExtent::surface)) {
    if (lost.empty())
      lost = "not kept of the input, since " + target + " has no place for it: ";
    else
      lost += ", ";
    lost += "what materials have besides ";
    lost += is_obj ? "a base colour and its texture at the first UVs"
                   : "colour, metalness, roughness, normals, occlusion, emission and "
                     "opacity with their textures at the first UVs";
  }
  if (!lost.empty()) options.warn(lost);
}

/// `where`: the file or the format, for messages.
const MeshFormat& checked_format(const SurfaceMesh& mesh, std::string_view name,
                                 const std::string& where, const MeshFileOptions& options) {
  const bool objects = !options.objects.empty(), animation = options.animation != nullptr;
  check_options(find_mesh_format(name), where, objects, animation);
  const MeshFormat& format = writable_format(name, where);
  warn_of_lost(format, mesh, options);
  return format;
}

}  // namespace

void check_mesh_file(const std::filesystem::path& path, bool objects, bool animation) {
  check_options(find_mesh_format(lower_extension(path)), path.string(), objects, animation);
}

std::string format_mesh(const SurfaceMesh& mesh, std::string_view format,
                        const MeshFileOptions& options, const Context& context) {
  std::string bytes;
  ByteSink sink([&](std::string_view part) { bytes += part; });
  checked_format(mesh, format, std::string(format), options).write(mesh, options, sink, context);
  sink.flush();
  context.report({"write", 1});
  return bytes;
}

void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh,
                const MeshFileOptions& options, const Context& context) {
  const std::string extension = lower_extension(path);
  const auto* obj = dynamic_cast<const ObjScene*>(options.scene.get());
  MeshFileOptions own = options;
  ObjLibrary library;
  if (obj && extension == ".obj" && options.material_library.empty()) {
    library = library_beside(path, *obj, mesh);
    own.material_library = library.names;
  }
  if (const auto* ply = dynamic_cast<const PlyScene*>(options.scene.get())) {
    own.scene = ply->seen_from(path);
  }
  LookPictures pictures(path);
  std::vector<MaterialLook> looks;
  if (!obj && extension == ".obj" && options.looks && options.material_library.empty()) {
    const LooksLibrary of_looks = looks_library(path, mesh, *options.looks, pictures);
    own.material_library = of_looks.file.filename().string();
    library.file = of_looks.file;
    library.text = of_looks.text;
  }
  if (extension == ".usda" && options.looks) {
    looks = looks_with_files(*options.looks, pictures);
    own.looks = &looks;
  }
  const MeshFormat& format = checked_format(mesh, extension, path.string(), own);
  AtomicFile file(path, "cannot write mesh", context);
  ByteSink sink([&](std::string_view part) { file.put(part); });
  format.write(mesh, own, sink, context);
  sink.flush();
  pictures.write(context);
  if (!library.file.empty()) {
    write_file(library.file, library.text, "cannot write the materials", context);
  }
  file.finish();
  context.report({"write", 1});
}

}  // namespace craze
