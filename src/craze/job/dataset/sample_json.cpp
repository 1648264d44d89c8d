#include "craze/job/dataset/sample_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "craze/base/parse_double.h"
#include "craze/base/text/format.h"
#include "craze/base/version.h"
#include "craze/engine/cracked_surface.h"
#include "craze/io/bytes/sha256.h"
#include "craze/recipe/recipe_json.h"

namespace craze {

namespace {

using Json = nlohmann::ordered_json;

/// To a ten-thousandth: pixels.
double pixels(double x) {
  return std::floor(x * 1e4 + 0.5) / 1e4;
}

/// To nine digits: model units.
double digits(double x) {
  const std::string text = fmt::format("{:.9g}", x);
  double rounded = x;
  parse_double(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

Json point(const Vec3& p) {
  return {digits(p.x()), digits(p.y()), digits(p.z())};
}

Json camera_json(const Projection& projection) {
  const render::Camera& c = projection.camera();
  const Vec3 eye = projection.eye(), down = -c.up;
  Json rows = Json::array();
  for (const Vec3& axis : {c.right, down, c.forward}) {
    rows.push_back({axis.x(), axis.y(), axis.z(), -axis.dot(eye)});
  }
  const int w = projection.width(), h = projection.height();
  return {{"width", w},    {"height", h},   {"fx", w / (2 * c.tan_x)}, {"fy", h / (2 * c.tan_y)},
          {"cx", w / 2.0}, {"cy", h / 2.0}, {"world_to_camera", rows}};
}

Json crack_json(const Scene& scene, std::size_t c, const SeenLine& line) {
  const CrackNetwork& network = scene.result.state().network;
  const WholeCrack& crack = scene.cracks[c];
  Json points = Json::array(), seen = Json::array(), widths = Json::array(),
       lengths = Json::array(), visible = Json::array();
  for (std::size_t i = 0; i < crack.nodes.size(); ++i) {
    points.push_back(point(network.nodes[crack.nodes[i]].position));
    seen.push_back({pixels(line.pixels[i].x()), pixels(line.pixels[i].y())});
    widths.push_back(pixels(line.width[i]));
    lengths.push_back(digits(scene.widths[c][i]));
    visible.push_back(static_cast<int>(line.visible[i]));
  }
  Json parent;
  if (crack.parent >= 0) parent = scene.cracks[crack.parent].order;
  return {{"id", crack.order},    {"parent", parent}, {"time", crack.time},
          {"event", crack.event}, {"pixels", seen},   {"width_pixels", widths},
          {"points", points},     {"width", lengths}, {"visible", visible}};
}

Json junctions_json(const Scene& scene, const std::vector<SeenLine>& lines) {
  if (scene.cracks.empty()) return Json::array();
  const CrackNetwork& network = scene.result.state().network;
  std::vector<std::vector<std::int32_t>> cracks(network.nodes.size());
  std::vector<int> visible(network.nodes.size(), 0);
  for (std::size_t c = 0; c < scene.cracks.size(); ++c) {
    const WholeCrack& crack = scene.cracks[c];
    for (std::size_t i = 0; i < crack.nodes.size(); ++i) {
      const std::int32_t n = crack.nodes[i];
      if (cracks[n].empty() || cracks[n].back() != crack.order) cracks[n].push_back(crack.order);
      visible[n] = lines[c].visible[i];
    }
  }
  const std::vector<std::string_view> kinds = junction_kinds(network);
  const Projection& projection = scene.projection;
  Json junctions = Json::array();
  for (std::size_t n = 0; n < kinds.size(); ++n) {
    const Vec3& p = network.nodes[n].position;
    if (kinds[n].empty() || !(projection.depth(p) > 0)) continue;
    const Vec2 pixel = projection.pixel(p);
    if (!projection.in_frame(pixel)) continue;
    junctions.push_back({{"kind", kinds[n]},
                         {"pixel", {pixels(pixel.x()), pixels(pixel.y())}},
                         {"point", point(p)},
                         {"cracks", cracks[n]},
                         {"visible", visible[n]}});
  }
  return junctions;
}

}  // namespace

double DepthRange::code(double depth) const {
  if (depth <= 0) return 0;
  return farthest > nearest ? 1 + 65534 * (depth - nearest) / (farthest - nearest) : 1;
}

DepthRange depth_range(const std::vector<float>& depths) {
  DepthRange range;
  for (const double d : depths) {
    if (d <= 0) continue;
    range.nearest = range.farthest == 0 ? d : std::min(range.nearest, d);
    range.farthest = std::max(range.farthest, d);
  }
  return range;
}

std::string sample_json(const SampleFacts& facts) {
  const Scene& scene = facts.scene;
  Json values;
  const std::vector<std::string> extents = facts.plan.plan.extents();
  for (const auto& [key, value] : facts.values) {
    if (std::find(extents.begin(), extents.end(), key) != extents.end()) continue;
    if (const auto* number = std::get_if<double>(&value)) {
      values[key] = *number;
    } else {
      values[key] = std::get<std::string>(value);
    }
  }
  Json cracks = Json::array();
  for (std::size_t c = 0; c < scene.cracks.size(); ++c) {
    if (facts.lines[c].in_frame) cracks.push_back(crack_json(scene, c, facts.lines[c]));
  }
  Json hashes;
  for (const SampleFile& file : facts.sample.files) hashes[file.kind] = sha256(file.bytes);
  const SampleSums& sums = facts.sample.sums;
  const Json json{
      {"id", facts.sample.id},
      {"index", facts.index},
      {"attempt", facts.attempt},
      {"version", version()},
      {"plan_sha256", facts.plan.sha256},
      {"clean", facts.clean},
      {"object", word_of(facts.values, "object.mesh")},
      {"seed", scene.recipe.simulation.seed},
      {"crack_pixels", sums.crack_pixels},
      {"crack_share", static_cast<double>(sums.crack_pixels) / static_cast<double>(sums.pixels)},
      {"label",
       {{"tolerance_pixels", number_of(facts.values, "label.tolerance")},
        {"width_per_pixel", sample_scale::width},
        {"distance_per_pixel", sample_scale::distance},
        {"farthest_pixels", sample_scale::farthest},
        {"depth_nearest", digits(facts.depths.nearest)},
        {"depth_farthest", digits(facts.depths.farthest)},
        {"points_farthest", digits(Scene::pixels_beside * scene.pixel)}}},
      {"camera", camera_json(scene.projection)},
      {"cracks", cracks},
      {"junctions", junctions_json(scene, facts.lines)},
      {"values", values},
      {"recipe", recipe_to_json(scene.recipe)},
      {"sha256", hashes}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace craze
