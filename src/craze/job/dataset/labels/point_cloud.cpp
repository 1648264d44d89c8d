#include "craze/job/dataset/labels/point_cloud.h"

#include <algorithm>
#include <cmath>

#include "craze/base/random.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/ply/ply_properties.h"
#include "craze/render/picture.h"

namespace craze {

namespace {

/// Places of [0, 1)², any first of which are spread evenly.
class EvenPlaces {
 public:
  explicit EvenPlaces(std::uint64_t seed) {
    const Random random(seed, 0x706f696e);
    shift_ = {random.uniform_at(0), random.uniform_at(1)};
  }
  Vec2 at(std::uint64_t i) const {
    constexpr double plastic = 1.32471795724474602596;  // the real root of x³ = x + 1
    const auto n = static_cast<double>(i + 1);
    const Vec2 place = shift_ + n * Vec2(1 / plastic, 1 / (plastic * plastic));
    return place.array() - place.array().floor();
  }

 private:
  Vec2 shift_;
};

class PointMaker {
 public:
  PointMaker(const Scene& scene, const LabelNoise& noise, const render::Image& picture,
             double least_width)
      : scene_(scene),
        noise_(noise),
        picture_(picture),
        least_width_(least_width),
        strips_(scene, noise),
        normals_(render::shading_normals(scene.mesh, scene.options.crease)),
        fragments_(scene.mesh.face_attributes.front().values) {}

  LabelledPoint make(const render::Ray& ray, const render::Hit& hit, const Vec2& pixel) const {
    LabelledPoint point;
    point.position = strips_.point_of(hit);
    point.normal = normal(hit);
    if (point.normal.dot(ray.direction.cast<double>()) > 0) point.normal = -point.normal;
    const auto x = static_cast<std::size_t>(pixel.x()), y = static_cast<std::size_t>(pixel.y());
    const std::size_t i = 3 * (y * static_cast<std::size_t>(picture_.width) + x);
    for (std::size_t k = 0; k < 3; ++k) point.color[k] = picture_.rgb[i + k];
    const NearestStrip at = strips_.nearest(hit.face, point.position, false);
    point.crack = at.outside <= 0 ? strips_.crack(at) : -1;
    point.width = point.crack < 0 ? 0 : strips_.width(at);
    point.labelled = is_labelled(hit, point.position);
    point.fragment = static_cast<std::int32_t>(fragments_[hit.face]);
    point.distance =
        strips_.distance(hit.face, point.position, Scene::pixels_beside * scene_.pixel);
    return point;
  }

 private:
  Vec3 normal(const render::Hit& hit) const {
    const render::Vec3f* n = &normals_[static_cast<std::size_t>(3) * hit.face];
    return ((1 - hit.u - hit.v) * n[0] + hit.u * n[1] + hit.v * n[2])
        .cast<double>()
        .stableNormalized();
  }

  bool is_labelled(const render::Hit& hit, const Vec3& position) const {
    const NearestStrip kept = strips_.nearest(hit.face, position, true);
    if (kept.line < 0) return false;
    const double pixel = scene_.projection.pixel_size(scene_.projection.depth(position));
    if (kept.outside > noise_.grow * pixel) return false;
    return least_width_ <= 0 ||
           strips_.seen_width(kept, strips_.normal_of(hit.face)) >= least_width_;
  }

  const Scene& scene_;
  const LabelNoise& noise_;
  const render::Image& picture_;
  double least_width_;
  CrackStrips strips_;
  std::vector<render::Vec3f> normals_;
  const std::vector<double>& fragments_;
};

void append_float(std::string& bytes, double x) {
  append(bytes, static_cast<float>(x));
}

}  // namespace

std::vector<LabelledPoint> point_cloud(const Scene& scene, const render::RayScene& rays,
                                       const LabelNoise& noise, const render::Image& picture,
                                       const CloudOptions& options) {
  const PointMaker maker(scene, noise, picture, options.least_width);
  const EvenPlaces places(options.seed);
  const Vec2 size(scene.projection.width(), scene.projection.height());
  std::vector<LabelledPoint> points;
  for (std::uint64_t first = 0; first < options.count; first += render::RayScene::lanes) {
    const auto lanes = static_cast<std::uint64_t>(render::RayScene::lanes);
    const std::uint64_t count = std::min(lanes, options.count - first);
    render::RayScene::Rays packet;
    render::RayScene::Hits hits;
    for (std::uint64_t k = 0; k < count; ++k) {
      const Vec2 pixel = places.at(first + k).cwiseProduct(size);
      packet[k] = scene.projection.ray(pixel.x(), pixel.y());
    }
    rays.intersect(packet, hits);
    for (std::uint64_t k = 0; k < count; ++k) {
      if (hits[k].face < 0) continue;
      points.push_back(maker.make(packet[k], hits[k], places.at(first + k).cwiseProduct(size)));
    }
  }
  return points;
}

std::string format_cloud(const Scene& scene, const std::vector<LabelledPoint>& points) {
  PlyProperties columns;
  for (int k = 0; k < 3; ++k) {
    columns.add_double(std::string(1, "xyz"[k]),
                       [&points, k](std::size_t i) { return points[i].position[k]; });
  }
  const auto add_float = [&columns](const std::string& name,
                                    std::function<double(std::size_t)> value) {
    columns.add(name, "float", [value = std::move(value)](std::string& bytes, std::size_t i) {
      append_float(bytes, value(i));
    });
  };
  for (int k = 0; k < 3; ++k) {
    add_float(std::string("n") + "xyz"[k],
              [&points, k](std::size_t i) { return points[i].normal[k]; });
  }
  const char* colors[] = {"red", "green", "blue"};
  for (std::size_t k = 0; k < 3; ++k) {
    columns.add(colors[k], "uchar", [&points, k](std::string& bytes, std::size_t i) {
      append(bytes, points[i].color[k]);
    });
  }
  columns.add("mask", "uchar", [&points](std::string& bytes, std::size_t i) {
    append(bytes, static_cast<std::uint8_t>(points[i].labelled ? 1 : 0));
  });
  columns.add("crack", "int", [&points, &scene](std::string& bytes, std::size_t i) {
    const std::int32_t crack = points[i].crack;
    append(bytes, crack < 0 ? std::int32_t{0} : scene.cracks[crack].order);
  });
  columns.add("fragment", "int", [&points](std::string& bytes, std::size_t i) {
    append(bytes, points[i].fragment + 1);
  });
  add_float("width", [&points](std::size_t i) { return points[i].width; });
  add_float("distance", [&points](std::size_t i) { return points[i].distance; });
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment craze\nelement vertex {}\n{}end_header\n",
      points.size(), columns.header());
  for (std::size_t i = 0; i < points.size(); ++i) columns.append_row(bytes, i);
  return bytes;
}

}  // namespace craze
