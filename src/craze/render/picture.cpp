#include "craze/render/picture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "craze/base/reporting_loop.h"
#include "craze/error.h"
#include "craze/mesh/smooth_normals.h"
#include "craze/render/film.h"
#include "craze/render/light/studio.h"
#include "craze/render/rays/tracer.h"

namespace craze::render {

namespace {

constexpr int groups_per_chunk = 256;  // of sixteen samples

struct Bounds {
  Vec3 centre;
  double diagonal;
};

Bounds bounds(const std::vector<Vec3>& points) {
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {(low + high) / 2, (high - low).norm()};
}

Subject subject(const SurfaceMesh& mesh, const PictureOptions& options) {
  return options.subject.points.empty() ? subject_of(mesh) : options.subject;
}

double diagonal(const SurfaceMesh& mesh, const PictureOptions& options) {
  const Subject of = subject(mesh, options);
  return of.points.empty() ? 0 : bounds(of.points).diagonal;
}

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::request, "cannot draw a picture", where, why);
}

bool is_finite(const std::optional<double>& number) {
  return !number || std::isfinite(*number);
}

bool is_finite(const std::optional<Vec3>& point) {
  return !point || point->allFinite();
}

void check(const View& view) {
  if (!(view.zoom > 0) || !(view.field_of_view > 0) || !(view.field_of_view < 180)) {
    refuse("view", "the zoom must be above 0, the field of view between 0 and 180 degrees");
  }
  if (!is_finite(view.azimuth) || !is_finite(view.elevation) || !is_finite(view.target) ||
      !is_finite(view.focus) || !std::isfinite(view.zoom) || !std::isfinite(view.margin)) {
    refuse("view", "angles, points and the zoom must be finite");
  }
  if (!(view.aperture >= 0 && view.aperture <= 1)) {
    refuse("view", "the aperture must be in [0, 1]");
  }
}

/// `camera` in render units.
void check(const Camera& camera) {
  // In single precision rays from farther away miss what they should meet.
  constexpr double farthest = 1e4;
  if (!(camera.eye.norm() < farthest)) refuse("view", "the camera is too far from the object");
}

void check_light(const PictureOptions& options) {
  if (!is_finite(options.light.azimuth) || !is_finite(options.light.elevation) ||
      !std::isfinite(options.environment.turn)) {
    refuse("light", "angles must be finite");
  }
  if (!(options.exposure > 0) || !std::isfinite(options.exposure)) {
    refuse("light", "the exposure must be above 0, and finite");
  }
}

void check(const SurfaceMesh& mesh, const CrackLines* lines, const PictureOptions& options) {
  const auto size_is_good = [](int n) { return n >= 1 && n <= PictureOptions::largest_size; };
  if (!size_is_good(options.width) || !size_is_good(options.height)) {
    refuse(std::to_string(options.width) + " x " + std::to_string(options.height),
           "the size must be 1 to 16384 pixels");
  }
  if (options.samples < 1 || options.samples > 4096) {
    refuse("samples " + std::to_string(options.samples), "must be 1 to 4096");
  }
  check(options.view);
  check_light(options);
  if (!(options.line_width >= 0) || !std::isfinite(options.line_width)) {
    refuse("lines", "their width must be at least 0, and finite");
  }
  if (mesh.triangles.empty()) refuse("mesh", "it has no triangles");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh.positions[v].allFinite()) {
      refuse("vertex " + std::to_string(v), "its position is not finite");
    }
  }
  if (lines && lines->cracks.first.size() > mesh.triangles.size() + 1) {
    refuse("crack lines", "they belong to a mesh with more faces");
  }
  if (lines && lines->places.size() > mesh.positions.size()) {
    refuse("crack lines", "they belong to a mesh with more vertices");
  }
}

std::vector<std::uint8_t> find_walls(const SurfaceMesh& mesh) {
  std::vector<std::uint8_t> is_wall(mesh.triangles.size(), 0);
  for (std::size_t f = 0; f < mesh.face_materials.size(); ++f) {
    const std::int32_t m = mesh.face_materials[f];
    is_wall[f] = m >= 0 && mesh.material_names[m] == "crack_wall" ? 1 : 0;
  }
  return is_wall;
}

std::vector<std::int32_t> find_pieces(const SurfaceMesh& mesh) {
  const Attribute* fragment = find_attribute(mesh.face_attributes, "fragment");
  if (!fragment || fragment->components != 1) return {};
  std::vector<std::int32_t> pieces;
  for (const double id : fragment->values) {
    pieces.push_back(std::abs(id) < 2e9 ? static_cast<std::int32_t>(id) : 0);
  }
  return pieces;
}

/// The mesh's own colours; faces of materials beyond them, such as walls, have none.
void add_looks(const SurfaceMesh& mesh, const PictureOptions& options, TracedModel& model) {
  model.looks = options.looks;
  const auto count = static_cast<std::int32_t>(model.looks.size());
  for (const std::int32_t m : mesh.face_materials) model.look.push_back(m < count ? m : -1);
  const auto traced = [&](const std::vector<Vec2>& uvs) {
    std::vector<Eigen::Vector2f> rounded;
    if (uvs.size() != 3 * mesh.triangles.size()) return rounded;
    for (const Vec2& uv : uvs) rounded.push_back(uv.cast<float>());
    return rounded;
  };
  model.uvs = traced(mesh.corner_uvs);
  for (const std::vector<Vec2>& uvs : options.further_uvs) model.further_uvs.push_back(traced(uvs));
  for (Look& look : model.looks) {
    for (PlacedTexture* texture : {&look.picture, &look.transmission_picture, &look.normals}) {
      if (*texture && model.uvs_of(*texture).empty()) texture->texture = nullptr;
    }
  }
}

/// A subject in render units, and its camera.
struct Framed {
  Subject subject;
  PictureCamera taken;
};

Framed framed_picture(const SurfaceMesh& mesh, const PictureOptions& options) {
  Subject of = subject(mesh, options);
  const Bounds box = bounds(of.points);
  const double scale = box.diagonal > 0 ? 1 / box.diagonal : 1;
  for (Vec3& p : of.points) p = scale * (p - box.centre);
  View view = options.view;
  if (view.target) view.target = scale * (*view.target - box.centre);
  Camera camera = frame(of, view, static_cast<double>(options.width) / options.height);
  camera.aperture = view.aperture;
  if (view.focus) {
    // What lies behind the camera, or in it, cannot be sharp.
    const Vec3 focus = scale * (*view.focus - box.centre);
    camera.focus = std::max(1e-3, (focus - camera.eye).dot(camera.forward));
  }
  return {std::move(of), {camera, box.centre, scale}};
}

}  // namespace

/// The mesh's own normals where it has them.
std::vector<Vec3f> shading_normals(const SurfaceMesh& mesh, double crease) {
  const bool has_own = mesh.corner_normals.size() == 3 * mesh.triangles.size();
  std::vector<Vec3f> normals;
  normals.reserve(3 * mesh.triangles.size());
  for (const Vec3& n : has_own ? mesh.corner_normals : smooth_normals(mesh, crease)) {
    normals.push_back(n.cast<float>());
  }
  return normals;
}

PictureCamera picture_camera(const SurfaceMesh& mesh, const PictureOptions& options) {
  return framed_picture(mesh, options).taken;
}

double line_width(const SurfaceMesh& mesh, const PictureOptions& options) {
  return options.line_width > 0 ? options.line_width : 0.0021 * diagonal(mesh, options);
}

double line_reach(const SurfaceMesh& mesh, const PictureOptions& options) {
  return std::max(LinePainter::reach * line_width(mesh, options),
                  1.5 * options.material.fissure * diagonal(mesh, options));
}

Image render_picture(const SurfaceMesh& mesh, const CrackLines* lines,
                     const PictureOptions& options, const Context& context) {
  check(mesh, lines, options);
  context.report({.phase = "picture", .fraction = 0});
  const Framed framed = framed_picture(mesh, options);
  const auto& [camera, centre, scale] = framed.taken;
  check(camera);

  TracedModel model;
  model.positions.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) model.positions.push_back(scale * (p - centre));
  model.places = model.positions;
  for (std::size_t v = 0; lines && v < lines->places.size(); ++v) {
    model.places[v] = scale * (lines->places[v] - centre);
  }
  model.triangles = mesh.triangles;
  model.normals = shading_normals(mesh, options.crease);
  model.marks = scaled(options.marks, centre, scale);
  model.is_wall = find_walls(mesh);
  model.pieces = find_pieces(mesh);
  if (!options.looks.empty()) add_looks(mesh, options, model);
  const LinePainter painter(lines ? *lines : CrackLines{}, centre, scale,
                            scale * line_width(mesh, options) / 2);
  model.lines = lines ? &painter : nullptr;

  const Studio studio(camera, options.backdrop.value_or(options.material.backdrop), options.light,
                      options.environment);
  const int groups = (options.samples + RayScene::lanes - 1) / RayScene::lanes;
  context.check();
  const Tracer tracer(model, options.material, camera, studio,
                      options.ground ? framed.subject.points : std::vector<Vec3>{}, groups,
                      options.seed);

  Film film(options.width, options.height, context);
  const auto width = static_cast<std::size_t>(options.width);
  // A pixel of many samples is a chunk of its own, so that no chunk takes long.
  const auto grain = static_cast<std::size_t>(std::max(1, groups_per_chunk / groups));
  reporting_loop(context, "picture", width * static_cast<std::size_t>(options.height), grain,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
                     film.at(x, y) = tracer.trace(x, y, options.width, options.height);
                   }
                 });
  const double distance = -camera.eye.dot(camera.forward);
  film.smooth_light(context, static_cast<float>(distance * 2 * camera.tan_y / options.height));
  return film.develop(options.exposure, context);
}

}  // namespace craze::render
