#include "craze/job/dataset/labels/surface_maps.h"

#include <algorithm>
#include <cmath>

#include "craze/engine/cracked_surface.h"

namespace craze {

SurfaceMaps surface_maps(const Scene& scene, const render::RayScene& rays) {
  const Projection& projection = scene.projection;
  const int width = projection.width(), height = projection.height();
  const std::size_t size = static_cast<std::size_t>(width) * height;
  const auto& fragments = scene.mesh.face_attributes.front().values;
  const std::vector<render::Vec3f> normals =
      render::shading_normals(scene.mesh, scene.options.crease);
  SurfaceMaps maps{std::vector<float>(size, 0),
                   std::vector<Eigen::Vector3f>(size, Eigen::Vector3f::Zero()),
                   std::vector<std::int32_t>(size, -1)};
  const render::Camera& camera = projection.camera();
  for (std::size_t first = 0; first < size; first += render::RayScene::lanes) {
    const std::size_t count = std::min<std::size_t>(render::RayScene::lanes, size - first);
    render::RayScene::Rays packet;
    render::RayScene::Hits hits;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = first + k;
      packet[k] = projection.ray(static_cast<double>(i % width) + 0.5,
                                 static_cast<double>(i / width) + 0.5);
    }
    rays.intersect(packet, hits);
    for (std::size_t k = 0; k < count; ++k) {
      const render::Hit& hit = hits[k];
      if (hit.face < 0) continue;
      const std::size_t i = first + k;
      maps.depth[i] = static_cast<float>(static_cast<double>(hit.distance) / projection.scale());
      maps.fragment[i] = static_cast<std::int32_t>(fragments[hit.face]);
      const render::Vec3f* n = &normals[static_cast<std::size_t>(3) * hit.face];
      Vec3 normal = ((1 - hit.u - hit.v) * n[0] + hit.u * n[1] + hit.v * n[2])
                        .cast<double>()
                        .stableNormalized();
      const Vec3 view = packet[k].direction.cast<double>();
      if (normal.dot(view) > 0) normal = -normal;  // an open sheet seen from behind
      maps.normal[i] = Eigen::Vector3f(static_cast<float>(normal.dot(camera.right)),
                                       static_cast<float>(normal.dot(camera.up)),
                                       static_cast<float>(-normal.dot(camera.forward)));
    }
  }
  return maps;
}

bool is_seen(const Projection& projection, const render::RayScene& rays, const Vec3& point) {
  if (!(projection.depth(point) > 0)) return false;
  const Vec2 pixel = projection.pixel(point);
  if (!projection.in_frame(pixel)) return false;
  const render::Hit hit = rays.intersect(projection.ray(pixel.x(), pixel.y()));
  // The point is on the mesh: what is nearer by more than rounding hides it.
  constexpr double rounding = 1e-4;
  const double depth = projection.depth(point) * projection.scale();
  return hit.face < 0 || static_cast<double>(hit.distance) > (1 - rounding) * depth;
}

std::vector<SeenLine> seen_lines(const Scene& scene, const render::RayScene& rays) {
  const Projection& projection = scene.projection;
  const CrackNetwork& network = scene.result.state().network;
  std::vector<SeenLine> lines;
  for (std::size_t c = 0; c < scene.cracks.size(); ++c) {
    const WholeCrack& crack = scene.cracks[c];
    SeenLine line;
    for (std::size_t i = 0; i < crack.nodes.size(); ++i) {
      const CrackNode& node = network.nodes[crack.nodes[i]];
      const Vec3& before = network.nodes[crack.nodes[i == 0 ? 0 : i - 1]].position;
      const Vec3& after =
          network.nodes[crack.nodes[std::min(i + 1, crack.nodes.size() - 1)]].position;
      const Vec3 way = after - before;
      const Vec3 along = (way - way.dot(node.normal) * node.normal).stableNormalized();
      const Vec3 across = node.normal.cross(along);
      const Vec2 pixel = projection.pixel(node.position);
      line.pixels.push_back(pixel);
      line.width.push_back(projection.seen_width(node.position, along, across, scene.widths[c][i]));
      line.visible.push_back(is_seen(projection, rays, node.position));
      line.in_frame |= projection.depth(node.position) > 0 && projection.in_frame(pixel);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<float> distance_map(const std::vector<SeenLine>& lines, int width, int height,
                                double limit) {
  std::vector<float> squared(static_cast<std::size_t>(width) * height,
                             static_cast<float>(limit * limit));
  const auto bound = [](double v, int size) {
    return static_cast<int>(std::clamp(std::floor(v), 0.0, static_cast<double>(size)));
  };
  for (const SeenLine& line : lines) {
    for (std::size_t i = 0; i + 1 < line.pixels.size(); ++i) {
      if (!line.visible[i] || !line.visible[i + 1]) continue;
      const Vec2 a = line.pixels[i], along = line.pixels[i + 1] - a;
      const double length = along.squaredNorm();
      const Vec2 low = a.cwiseMin(line.pixels[i + 1]), high = a.cwiseMax(line.pixels[i + 1]);
      const int x1 = bound(high.x() + limit + 1, width), y1 = bound(high.y() + limit + 1, height);
      for (int y = bound(low.y() - limit, height); y < y1; ++y) {
        for (int x = bound(low.x() - limit, width); x < x1; ++x) {
          const Vec2 off = Vec2(x + 0.5, y + 0.5) - a;
          const double t = length > 0 ? std::clamp(off.dot(along) / length, 0.0, 1.0) : 0;
          float& best = squared[static_cast<std::size_t>(y) * width + x];
          best = std::min(best, static_cast<float>((off - t * along).squaredNorm()));
        }
      }
    }
  }
  for (float& d : squared) d = std::sqrt(d);
  return squared;
}

}  // namespace craze
