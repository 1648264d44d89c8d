// Format: Pixar, "OpenUSD: Universal Scene Description", the crate-free text form.

#include <cmath>

#include "craze/base/text/format.h"
#include "craze/io/polygons/float_grid.h"
#include "craze/io/polygons/polygon_soup.h"
#include "craze/io/usd/usd.h"
#include "craze/io/usd/usd_mesh.h"
#include "craze/mesh/mesh_parts.h"

namespace craze {

namespace {

constexpr double codes_per_second = 24;
/// Seconds that the clip waits before and after, as in GLB.
constexpr double wait_before = 0.25, wait_after = 1;

class UsdWriter {
 public:
  UsdWriter(const SurfaceMesh& mesh, const MeshFileOptions& options, const Context& context)
      : mesh_(mesh), options_(options), context_(context), materials_(mesh, options) {}

  void write(ByteSink& sink) {
    names_.take("Materials");
    sink.pending() += header() + "def Xform \"craze\"\n{\n";
    const std::vector<MorphStage> none;
    if (options_.objects.empty()) {
      usd_mesh(names_.take("surface"), mesh_, far_origin(mesh_),
               options_.animation ? options_.animation->stages : none, clip(), materials_, sink,
               context_);
    } else {
      write_parts(sink);
    }
    sink.pending() += materials_.text() + "}\n";
  }

 private:
  UsdClip clip() const {
    if (!options_.animation) return {};
    const auto stages = static_cast<double>(options_.animation->stages.size());
    return {wait_before * codes_per_second,
            options_.animation->seconds * codes_per_second / std::max(stages, 1.0)};
  }

  std::string header() const {
    const UpAxis up = options_.up;
    double unit = mesh_.metres_per_unit > 0 ? mesh_.metres_per_unit : options_.metres_per_unit;
    if (!(unit > 0)) unit = 1;
    std::string text = fmt::format(
        "#usda 1.0\n(\n    defaultPrim = \"craze\"\n    doc = \"craze\"\n    metersPerUnit = {}\n"
        "    upAxis = \"{}\"\n",
        unit, up == UpAxis::z ? 'Z' : 'Y');
    if (options_.animation) {
      const double seconds = wait_before + options_.animation->seconds + wait_after;
      text +=
          fmt::format("    startTimeCode = 0\n    endTimeCode = {}\n    timeCodesPerSecond = {}\n",
                      std::ceil(seconds * codes_per_second), codes_per_second);
    }
    return text + ")\n\n";
  }

  /// Each about its own middle. What meets still meets: places and points lie on one grid.
  void write_parts(ByteSink& sink) {
    const Vec3 far = far_origin(mesh_);
    SurfaceMesh near = mesh_;
    for (Vec3& p : near.positions) p -= far;
    const double grid = float_grid(near);
    for (const MeshPart& part : mesh_parts(near, options_.objects)) {
      ExtractedPart own = extract_part(near, part.faces);
      const Vec3 origin = on_grid(centroid(own.mesh), grid) + far;
      for (Vec3& p : own.mesh.positions) p = on_grid(p, grid) + far;
      const std::vector<MorphStage> stages = options_.animation
                                                 ? stages_of(*options_.animation, own.vertices)
                                                 : std::vector<MorphStage>{};
      usd_mesh(names_.take(part.name), own.mesh, origin, stages, clip(), materials_, sink,
               context_);
    }
  }

  const SurfaceMesh& mesh_;
  const MeshFileOptions& options_;
  const Context& context_;
  UsdMaterials materials_;
  UsdNames names_;
};

/// Opacity reads one texture.
void warn_of_two_opacities(const SurfaceMesh& mesh, const MeshFileOptions& options) {
  if (!options.looks || !options.warn) return;
  std::string list;
  for (std::size_t m = 0; m < options.looks->size(); ++m) {
    const MaterialLook& look = (*options.looks)[m];
    if (look.alpha == MaterialLook::Alpha::ignored || look.base_picture.file.empty() ||
        !(look.transmission > 0) || look.transmission_picture.file.empty()) {
      continue;
    }
    const std::string name = m < mesh.material_names.size() ? mesh.material_names[m] : "";
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  if (list.empty()) return;
  options.warn(
      fmt::format("opacity has one texture in USDA: of {} the colour's alpha stays, and the "
                  "texture of what is transmitted is left out",
                  list));
}

void warn_of_textures(const MeshFileOptions& options) {
  if (!options.looks || !options.warn) return;
  bool is_left_out = false;
  for (const MaterialLook& look : *options.looks) {
    for_each_picture(look, [&](const LookPicture& picture) {
      is_left_out = is_left_out || (picture.bytes && picture.file.empty());
    });
  }
  if (!is_left_out) return;
  options.warn("textures inside the input are not in the USDA: it can only name files");
}

}  // namespace

void write_usda(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
                const Context& context) {
  warn_of_textures(options);
  warn_of_two_opacities(mesh, options);
  if (mesh.corner_normals.empty()) {
    UsdWriter(mesh, options, context).write(sink);
    return;
  }
  SurfaceMesh unit = mesh;
  normalize_corner_normals(unit);
  UsdWriter(unit, options, context).write(sink);
}

}  // namespace craze
