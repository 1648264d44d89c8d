#include <fmt/compile.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/obj/mtl.h"
#include "craze/io/obj/obj.h"
#include "craze/io/obj/obj_scene.h"
#include "craze/io/polygons/unify_corners.h"
#include "craze/mesh/mesh_parts.h"

namespace craze {

namespace {

/// From here on, an alpha is 1 but for rounding.
constexpr float opaque = 1 - 1.0f / 512;

/// An object of the mesh as OBJ says it; "" where it does not.
struct ObjectNames {
  std::string o, g;
};

ObjectNames names_of(const SurfaceMesh& mesh, std::int32_t object, const ObjScene* scene) {
  if (object < 0) return {};
  const auto number = static_cast<std::size_t>(object);
  if (!scene || number >= scene->objects.size())
    return {one_line_name(mesh.object_names[number]), ""};
  return {scene->objects[number].first, scene->objects[number].second};
}

/// The faces with those of one object together, and the groups of one `o`, in the order in which
/// they first come; those without `o` first, since nothing ends one.
std::vector<std::size_t> by_object(const SurfaceMesh& mesh, const ObjScene* scene) {
  std::map<std::string, std::size_t> first_of_o{{"", 0}};
  std::map<std::int32_t, std::pair<std::size_t, std::size_t>> rank;  // by object
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto [known, is_new] = rank.try_emplace(mesh.face_objects[f]);
    if (is_new) {
      const ObjectNames names = names_of(mesh, known->first, scene);
      const std::size_t of_o = first_of_o.try_emplace(names.o, first_of_o.size()).first->second;
      // In a scene what has no group comes before what has one.
      known->second = {of_o, scene && names.g.empty() ? 0 : rank.size()};
    }
    faces[known->second].push_back(f);
  }
  std::vector<std::size_t> order;
  for (const auto& [place, of] : faces) order.insert(order.end(), of.begin(), of.end());
  return order;
}

}  // namespace

void write_obj(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
               const Context& context) {
  const bool has_uvs = !mesh.corner_uvs.empty(), has_normals = !mesh.corner_normals.empty();
  ProgressMeter meter(context, "write", mesh.positions.size() + mesh.triangles.size());
  const UnifiedCorners uvs = unify_corners(mesh, {.uvs = true, .normals = false});
  const UnifiedCorners normals = unify_corners(mesh, {.uvs = false, .normals = true});

  std::string& text = sink.pending();
  text += "# craze\n";
  const auto out = std::back_inserter(text);
  if (!options.material_library.empty()) text += "mtllib " + options.material_library + "\n";
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    meter.at(v);
    const Vec3& p = mesh.positions[v];
    fmt::format_to(out, FMT_COMPILE("v {} {} {}"), p.x(), p.y(), p.z());
    if (!mesh.vertex_colors.empty()) {
      Color c = mesh.vertex_colors[v];
      for (float& channel : c) channel = std::clamp(channel, 0.0f, 1.0f);
      fmt::format_to(out, FMT_COMPILE(" {} {} {}"), c[0], c[1], c[2]);
      // Other readers give up at a seventh number: only where it says something.
      if (c[3] < opaque) fmt::format_to(out, FMT_COMPILE(" {}"), c[3]);
    }
    text += '\n';
    sink.pass_on();
  }
  for (const Vec2& t : uvs.uvs) {
    fmt::format_to(out, FMT_COMPILE("vt {} {}\n"), t.x(), t.y());
    sink.pass_on();
  }
  for (const Vec3& n : normals.normals) {
    fmt::format_to(out, FMT_COMPILE("vn {} {} {}\n"), n.x(), n.y(), n.z());
    sink.pass_on();
  }

  const auto* scene = dynamic_cast<const ObjScene*>(options.scene.get());
  const bool has_objects = options.objects.empty() && !mesh.face_objects.empty();
  std::int32_t material = -1, object = -1;
  ObjectNames last;
  const std::vector<std::string> materials = mtl_names(mesh);
  std::size_t faces = 0;
  const auto add_face = [&](std::size_t f) {
    meter.at(mesh.positions.size() + faces++);
    if (has_objects && mesh.face_objects[f] != object) {
      object = mesh.face_objects[f];
      const ObjectNames names = names_of(mesh, object, scene);
      if (!names.o.empty() && (!scene || names.o != last.o)) text += "o " + names.o + "\n";
      if (!names.g.empty()) text += "g " + names.g + "\n";
      last = names;
    }
    if (!mesh.face_materials.empty() && mesh.face_materials[f] != material) {
      material = mesh.face_materials[f];
      fmt::format_to(out, "usemtl {}\n", material < 0 ? "(null)" : materials[material]);
    }
    text += 'f';
    for (int i = 0; i < 3; ++i) {
      const std::int32_t v = mesh.triangles[f][i] + 1;
      const std::int32_t t = uvs.triangles[f][i] + 1, n = normals.triangles[f][i] + 1;
      if (has_uvs && has_normals) {
        fmt::format_to(out, FMT_COMPILE(" {}/{}/{}"), v, t, n);
      } else if (has_uvs) {
        fmt::format_to(out, FMT_COMPILE(" {}/{}"), v, t);
      } else if (has_normals) {
        fmt::format_to(out, FMT_COMPILE(" {}//{}"), v, n);
      } else {
        fmt::format_to(out, FMT_COMPILE(" {}"), v);
      }
    }
    text += '\n';
    sink.pass_on();
  };
  if (has_objects) {
    for (const std::size_t f : by_object(mesh, scene)) add_face(f);
    return;
  }
  if (options.objects.empty()) {
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) add_face(f);
    return;
  }
  for (const MeshPart& part : mesh_parts(mesh, options.objects)) {
    text += "o " + part.name + "\n";
    for (const std::int32_t f : part.faces) add_face(f);
  }
}

}  // namespace craze
