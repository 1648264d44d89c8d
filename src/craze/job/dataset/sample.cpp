#include "craze/job/dataset/sample.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/image/format_png.h"
#include "craze/job/dataset/labels/crack_maps.h"
#include "craze/job/dataset/labels/point_cloud.h"
#include "craze/job/dataset/labels/surface_maps.h"
#include "craze/job/dataset/sample_json.h"
#include "craze/job/dataset/scene/camera_faults.h"

namespace craze {

namespace {

std::uint16_t whole(double x, double top) {
  return static_cast<std::uint16_t>(std::clamp(std::floor(x + 0.5), 0.0, top));
}

/// A grey picture of one number a pixel.
template <class Values, class Number>
std::string grey_png(const Scene& scene, int bits, const Values& values, const Number& number) {
  PngPicture png{scene.projection.width(), scene.projection.height(), 1, bits, {}};
  png.values.reserve(values.size());
  const double top = bits == 8 ? 255 : 65535;
  for (const auto& v : values) png.values.push_back(whole(number(v), top));
  return format_png(png);
}

std::string normal_png(const Scene& scene, const std::vector<Eigen::Vector3f>& normals) {
  PngPicture png{scene.projection.width(), scene.projection.height(), 3, 8, {}};
  for (const Eigen::Vector3f& n : normals) {
    for (int k = 0; k < 3; ++k) {
      png.values.push_back(n.isZero() ? std::uint16_t{0} : whole(128 + 127.0 * n[k], 255));
    }
  }
  return format_png(png);
}

std::string image_png(const render::Image& image) {
  return format_png({image.width, image.height, 3, 8, {image.rgb.begin(), image.rgb.end()}});
}

/// Everything that is measured of a scene.
struct Labels {
  CrackMaps cracks;
  SurfaceMaps surface;
  std::vector<SeenLine> lines;
  std::vector<std::uint8_t> mask;  ///< 0 or 1
};

LabelNoise label_noise(const Scene& scene, const PlanValues& values, std::uint64_t name) {
  LabelNoise noise{number_of(values, "label.grow"), {}};
  const Random random(name, 0x64726f70);
  for (std::size_t c = 0; c < scene.cracks.size(); ++c) {
    noise.dropped.push_back(random.uniform_at(c) < number_of(values, "label.dropout") ? 1 : 0);
  }
  return noise;
}

/// The scene's surface in render units.
render::RayScene rays_of(const Scene& scene) {
  std::vector<Vec3> places;
  for (const Vec3& p : scene.mesh.positions) places.push_back(scene.projection.to_render(p));
  return {places, scene.mesh.triangles};
}

Labels make_labels(const Scene& scene, const PlanValues& values, std::uint64_t name,
                   const Context& context) {
  const render::RayScene rays = rays_of(scene);
  const LabelNoise noise = label_noise(scene, values, name);
  Labels labels{crack_maps(scene, rays, noise, context),
                surface_maps(scene, rays),
                seen_lines(scene, rays),
                {}};
  const double least = number_of(values, "label.min_width");
  for (std::size_t i = 0; i < labels.cracks.label.size(); ++i) {
    const bool wide = least <= 0 || labels.cracks.width[i] >= least;
    labels.mask.push_back(labels.cracks.label[i] >= 0.5f && wide ? 1 : 0);
  }
  return labels;
}

SampleSums sums_of(const Labels& labels, bool clean) {
  SampleSums sums;
  sums.samples = 1;
  sums.clean = clean ? 1 : 0;
  sums.pixels = labels.mask.size();
  sums.crack_pixels =
      static_cast<std::uint64_t>(std::count(labels.mask.begin(), labels.mask.end(), 1));
  for (const SeenLine& line : labels.lines) {
    for (std::size_t i = 0; i + 1 < line.pixels.size(); ++i) {
      if (!line.visible[i] || !line.visible[i + 1]) continue;
      const double width = (line.width[i] + line.width[i + 1]) / 2;
      const int bin = std::min(static_cast<int>(width / SampleSums::bin), SampleSums::bins - 1);
      sums.length_by_width[bin] += (line.pixels[i + 1] - line.pixels[i]).norm();
    }
  }
  return sums;
}

std::vector<SampleInstance> instances_of(const Scene& scene, const Labels& labels) {
  std::map<std::int32_t, std::vector<std::uint8_t>> masks;
  for (std::size_t i = 0; i < labels.mask.size(); ++i) {
    if (!labels.mask[i] || labels.cracks.crack[i] < 0) continue;
    auto& mask = masks[scene.cracks[labels.cracks.crack[i]].order];
    mask.resize(labels.mask.size(), 0);
    mask[i] = 1;
  }
  std::vector<SampleInstance> instances;
  for (auto& [order, mask] : masks) instances.push_back({order, std::move(mask)});
  return instances;
}

Sample finished(const DatasetPlan& plan, std::uint64_t index, int attempt, std::uint64_t name,
                const PlanValues& values, const Scene& scene, const Labels& labels, bool clean,
                const Context& context) {
  Sample sample;
  sample.id = sample_id(index);
  sample.sums = sums_of(labels, clean);
  sample.instances = instances_of(scene, labels);
  const render::Image picture = render::render_picture(
      scene.mesh, scene.cracks.empty() ? nullptr : &scene.lines, scene.options, context);
  const auto add = [&](const char* kind, std::string bytes) {
    sample.files.push_back({kind, std::move(bytes)});
  };
  const DepthRange depths = depth_range(labels.surface.depth);
  const auto id_of = [&](std::int32_t crack) { return crack < 0 ? 0 : scene.cracks[crack].order; };
  const render::Image taken = with_camera_faults(picture, values, name);
  add("image.png", image_png(taken));
  add("mask.png", grey_png(scene, 8, labels.mask, [](int m) { return 255 * m; }));
  add("coverage.png", grey_png(scene, 8, labels.cracks.coverage, [](double c) { return 255 * c; }));
  add("width.png",
      grey_png(scene, 16, labels.cracks.width, [](double w) { return w * sample_scale::width; }));
  add("distance.png", grey_png(scene, 16,
                               distance_map(labels.lines, scene.projection.width(),
                                            scene.projection.height(), sample_scale::farthest),
                               [](double d) { return d * sample_scale::distance; }));
  add("depth.png",
      grey_png(scene, 16, labels.surface.depth, [&](double d) { return depths.code(d); }));
  add("normal.png", normal_png(scene, labels.surface.normal));
  add("crack.png", grey_png(scene, 16, labels.cracks.crack, id_of));
  add("fragment.png", grey_png(scene, 16, labels.surface.fragment, [](int f) { return f + 1; }));
  if (plan.shape.points > 0) {
    add("points.ply",
        format_cloud(scene,
                     point_cloud(scene, rays_of(scene), label_noise(scene, values, name), taken,
                                 {plan.shape.points, number_of(values, "label.min_width"), name})));
  }
  add("json",
      sample_json({plan, index, attempt, clean, values, scene, labels.lines, depths, sample}));
  return sample;
}

}  // namespace

SampleSums& SampleSums::operator+=(const SampleSums& other) {
  samples += other.samples;
  clean += other.clean;
  pixels += other.pixels;
  crack_pixels += other.crack_pixels;
  for (int i = 0; i < bins; ++i) length_by_width[i] += other.length_by_width[i];
  return *this;
}

double SampleSums::median_width() const {
  double sum = 0, below = 0;
  for (const double l : length_by_width) sum += l;
  for (int i = 0; i < bins && sum > 0; ++i) {
    if (below + length_by_width[i] >= sum / 2) {
      return bin * (i + (sum / 2 - below) / length_by_width[i]);
    }
    below += length_by_width[i];
  }
  return 0;
}

DatasetPlan::DatasetPlan(const PlanSource& from)
    : source(from),
      plan(from.text, from.name, dataset_schema()),
      shape(dataset_shape(plan)),
      sha256(craze::sha256(plan.identity())) {
  constexpr std::uint64_t most_shards = 1000000;  // their names have six digits
  if (shape.shards() > most_shards) {
    throw Error(ErrorKind::usage, "too many shards", from.name,
                fmt::format("at most {}; give more shard_samples", most_shards));
  }
  for (const PlanEntry& entry : plan.entries()) {
    if (entry.key.rfind("recipe.post.", 0) != 0) continue;
    if (entry.key.find("roughness") != std::string::npos) continue;
    throw Error(ErrorKind::usage, "no " + entry.key + " in a dataset", entry.where,
                "cracks are strips of the surface, as wide as lines.width says");
  }
}

std::string sample_id(std::uint64_t index) {
  return fmt::format("{:09}", index);
}

Sample make_sample(const DatasetPlan& plan, std::uint64_t index, const Context& context) {
  const auto seed = static_cast<std::uint64_t>(plan.plan.number("seed"));
  const bool clean = Random(hash_bits(seed) ^ index, 0x636c6561).uniform_at(0) < plan.shape.clean;
  for (int attempt = 0; attempt < plan.shape.attempts; ++attempt) {
    const auto tried = static_cast<std::uint64_t>(attempt);
    const std::uint64_t name = hash_bits(hash_bits(hash_bits(seed) ^ index) ^ tried);
    const PlanValues values = plan.plan.draw(index, tried);
    try {
      const Scene scene = make_scene(plan.plan, values, plan.shape, plan.source.folder.string(),
                                     name, clean, context);
      const Labels labels = make_labels(scene, values, name, context);
      const auto seen = std::count(labels.mask.begin(), labels.mask.end(), 1);
      if (!clean && static_cast<double>(seen) < number_of(values, "label.min_pixels")) continue;
      return finished(plan, index, attempt, name, values, scene, labels, clean, context);
    } catch (const Error& e) {
      throw Error(e.kind(), "cannot make a sample", sample_id(index), e.what());
    }
  }
  throw Error(ErrorKind::request, "the plan yields no crack that is seen",
              "sample " + sample_id(index),
              fmt::format("none in {} draws; let more crack (recipe.evolution.max_load, "
                          "recipe.layer), draw them wider (lines.width) or look nearer "
                          "(camera.zoom)",
                          plan.shape.attempts));
}

}  // namespace craze
