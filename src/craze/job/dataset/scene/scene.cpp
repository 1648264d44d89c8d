#include "craze/job/dataset/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

#include "craze/base/elementary.h"
#include "craze/engine/cracked_surface.h"
#include "craze/error.h"
#include "craze/job/dataset/marks/distractors.h"
#include "craze/job/dataset/scene/mesh_folder.h"
#include "craze/job/dataset/scene/surface_look.h"
#include "craze/job/load_surface.h"
#include "craze/job/load_textures.h"
#include "craze/output/source_file.h"
#include "craze/products/cut_surface.h"
#include "craze/products/opening/opened_surface.h"
#include "craze/products/opening/shading_normals.h"
#include "craze/render/light/studio.h"
#include "craze/render/subject.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

/// The mesh that a name stands for: of a folder one of its meshes.
std::string pick_object(const std::string& name, const std::string& folder, Random& random) {
  if (is_shape(name)) return name;
  const fs::path path = fs::path(folder) / name;
  std::error_code failed;
  if (!fs::is_directory(path, failed)) return path.string();
  const std::vector<std::string> files = meshes_in(path);
  return files[random.below(files.size())];
}

/// What of [post] has a part in the lines of cracks, which are drawn as strips, not as gaps.
PostParameters lines_alone(const PostParameters& post) {
  PostParameters kept;
  kept.roughness = post.roughness;
  kept.relative_roughness = post.relative_roughness;
  kept.roughness_exponent = post.roughness_exponent;
  kept.roughness_step = post.roughness_step;
  return kept;
}

render::PictureOptions picture_options(const PlanValues& values, const DatasetShape& shape,
                                       const render::Subject& subject, bool stands_on_z,
                                       std::uint64_t name) {
  const std::map<std::string, UpAxis> axes{
      {"auto", UpAxis::automatic}, {"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}};
  render::PictureOptions options;
  options.width = shape.width;
  options.height = shape.height;
  options.samples = static_cast<int>(number_of(values, "light.samples"));
  options.subject = subject;
  options.view.up = axes.at(word_of(values, "camera.up"));
  if (stands_on_z && options.view.up == UpAxis::automatic) options.view.up = UpAxis::z;
  options.view.elevation = number_of(values, "camera.elevation");
  options.view.azimuth = number_of(values, "camera.azimuth");
  options.view.zoom = number_of(values, "camera.zoom");
  options.view.field_of_view = number_of(values, "camera.field_of_view");
  options.light = {number_of(values, "light.azimuth"), number_of(values, "light.elevation")};
  options.ground = word_of(values, "camera.ground") == "yes";
  options.exposure =
      static_cast<float>(elementary::exp(elementary::log(2) * number_of(values, "image.exposure")));
  options.material = surface_material(values, name);
  options.seed = name;

  Vec3 low = subject.points.front(), high = low;
  for (const Vec3& p : subject.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Random random(name, 0x63656e74);
  Vec3 off;
  for (int k = 0; k < 3; ++k) off[k] = random.uniform_at(k) - 0.5;
  options.view.target =
      (low + high) / 2 + number_of(values, "camera.off_centre") * (high - low).norm() * off;
  return options;
}

/// Where a node is in a whole crack.
struct Station {
  std::int32_t crack, index;
};

/// The stretch of a crack between the ends of a side of the cut mesh.
struct Stretch {
  std::int32_t crack = -1, from = 0, to = 0;
};

Stretch shortest_stretch(const std::vector<Station>& a, const std::vector<Station>& b) {
  Stretch best;
  for (const Station& p : a) {
    for (const Station& q : b) {
      if (p.crack != q.crack || p.index == q.index) continue;
      if (best.crack < 0 || std::abs(p.index - q.index) < std::abs(best.from - best.to)) {
        best = {p.crack, p.index, q.index};
      }
    }
  }
  return best;
}

/// A side of the cut mesh may hold several edges of the network, whose nodes on it were made from
/// across the crack. Its width is linear from end to end, and theirs is made that.
void straighten(const CrackNetwork& network, const WholeCrack& crack, const Stretch& s,
                std::vector<double>& width) {
  const auto [first, last] = std::minmax(s.from, s.to);
  const auto place = [&](std::int32_t i) { return network.nodes[crack.nodes[i]].position; };
  const double length = (place(last) - place(first)).norm();
  for (std::int32_t i = first + 1; i < last && length > 0; ++i) {
    const double t = std::clamp((place(i) - place(first)).norm() / length, 0.0, 1.0);
    width[i] = (1 - t) * width[first] + t * width[last];
  }
}

/// Fills in what is drawn of the cracks: lines, their widths, whose they are.
void draw_cracks(Scene& scene, double reach, const Context& context) {
  const CrackedSurface& state = scene.result.state();
  const TriangleMesh& mesh = state.mesh();
  const CrackNetwork& network = state.network;
  std::vector<std::int32_t> node_of(mesh.vertex_count(), -1);
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    node_of[network.nodes[n].vertex] = static_cast<std::int32_t>(n);
  }
  std::vector<std::vector<Station>> stations(network.nodes.size());
  for (std::size_t c = 0; c < scene.cracks.size(); ++c) {
    for (std::size_t i = 0; i < scene.cracks[c].nodes.size(); ++i) {
      stations[scene.cracks[c].nodes[i]].push_back(
          {static_cast<std::int32_t>(c), static_cast<std::int32_t>(i)});
    }
  }
  const std::vector<std::int32_t> sides = crack_sides(mesh);
  std::vector<Stretch> stretches;
  for (const std::int32_t side : sides) {
    const std::int32_t a = node_of[mesh.root(mesh.from(side))];
    const std::int32_t b = node_of[mesh.root(mesh.to(side))];
    stretches.push_back(a < 0 || b < 0 ? Stretch{} : shortest_stretch(stations[a], stations[b]));
    const Stretch& s = stretches.back();
    if (s.crack >= 0) straighten(network, scene.cracks[s.crack], s, scene.widths[s.crack]);
  }
  std::vector<std::array<float, 2>> width;
  const double unit = scene.options.line_width;
  for (const Stretch& s : stretches) {
    if (s.crack < 0) {
      width.push_back({0, 0});
      continue;
    }
    const std::vector<double>& w = scene.widths[s.crack];
    width.push_back({static_cast<float>(w[s.from] / unit), static_cast<float>(w[s.to] / unit)});
  }
  scene.lines = render::crack_lines(mesh, sides, reach, context);
  render::set_widths(scene.lines, sides, width);
  for (const NearbyCrack& line : scene.lines.cracks.segments) {
    const auto side = std::lower_bound(sides.begin(), sides.end(), line.halfedge) - sides.begin();
    scene.crack_of_line.push_back(stretches[side].crack);
  }
}

/// The depth of what is in the middle of the picture.
double middle_depth(const render::RayScene& rays, const Projection& projection) {
  const render::Hit hit =
      rays.intersect(projection.ray(projection.width() / 2.0, projection.height() / 2.0));
  if (hit.face >= 0) return static_cast<double>(hit.distance) / projection.scale();
  return -projection.camera().eye.dot(projection.camera().forward) / projection.scale();
}

}  // namespace

Scene make_scene(const Plan& plan, const PlanValues& values, const DatasetShape& shape,
                 const std::string& folder, std::uint64_t name, bool clean,
                 const Context& context) {
  Random random(name, 0x6f626a);
  const std::string object = pick_object(word_of(values, "object.mesh"), folder, random);
  Recipe recipe = recipe_of(plan, values, name >> 11);  // seeds have 53 bits
  recipe.post = lines_alone(recipe.post);
  Input input;
  input.name = object;
  input.surface = std::make_shared<const SurfaceMesh>(load_surface(object, context).mesh);
  input.textures = load_textures(recipe, texture_folder(folder, recipe), context);
  CrackOptions how{{}, OnCancel::discard};
  if (clean) how.max_cracks = 0;
  const Result result = crack(std::move(input), recipe, how, context);
  const CrackedSurface& state = result.state();

  const OpenedSurface shown =
      opened_surface(result, plain_cut_surface(result, context.threads), {}, recipe.post, context);
  SurfaceMesh mesh = shown.mesh;
  Attribute fragment{"fragment", 1, {}};
  for (const std::int32_t f : state.fragments.face) fragment.values.push_back(f);
  mesh.face_attributes = {std::move(fragment)};
  const render::Subject subject = render::subject_of(mesh);
  render::PictureOptions options = picture_options(values, shape, subject, is_shape(object), name);
  mesh.corner_normals = shading_normals(shown, result, options.crease);
  const Projection projection(render::picture_camera(mesh, options), shape.width, shape.height);

  Scene scene{
      object, result.report().recipe, result, std::move(mesh), options, projection, 0, {}, {}, {},
      {}};
  std::vector<Vec3> places;
  for (const Vec3& p : scene.mesh.positions) places.push_back(projection.to_render(p));
  const render::RayScene rays(places, scene.mesh.triangles);
  const render::Studio studio(projection.camera(), options.material.backdrop, options.light);
  scene.options.marks = strewn_marks(values, scene.mesh, rays, projection, options.material.color,
                                     studio.lamp_direction().cast<double>(), name);
  scene.pixel = projection.pixel_size(middle_depth(rays, projection));
  scene.options.line_width = scene.pixel * number_of(values, "lines.width");
  if (clean || state.network.edges.empty()) return scene;

  scene.cracks = whole_cracks(state.network);
  scene.widths = crack_widths(state.network, scene.cracks,
                              {scene.options.line_width, number_of(values, "lines.even"),
                               number_of(values, "lines.unevenness"),
                               scene.pixel * number_of(values, "lines.taper"), name});
  double widest = 0;
  for (const auto& of_crack : scene.widths) {
    widest = std::max(widest, *std::max_element(of_crack.begin(), of_crack.end()));
  }
  draw_cracks(scene, render::LinePainter::reach * widest + Scene::pixels_beside * scene.pixel,
              context);
  return scene;
}

}  // namespace craze
