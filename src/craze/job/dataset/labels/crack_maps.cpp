#include "craze/job/dataset/labels/crack_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "craze/base/parallel.h"
#include "craze/engine/cracked_surface.h"

namespace craze {

namespace {

constexpr int cells = 8, corners = cells + 1;
constexpr int lattice = corners * corners;

/// Part of a triangle's area where a linear function is below 0, from its values at the corners.
double part_below(double a, double b, double c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  if (a >= 0) return 0;
  if (c <= 0) return 1;
  if (b >= 0) return a / (a - b) * (a / (a - c));
  return 1 - c / (c - a) * (c / (c - b));
}

class PixelCracks {
 public:
  PixelCracks(const Scene& scene, const render::RayScene& rays, const LabelNoise& noise)
      : scene_(scene), rays_(rays), noise_(noise), strips_(scene, noise) {
    is_noisy_ = noise.grow != 0 ||
                std::find(noise.dropped.begin(), noise.dropped.end(), 1) != noise.dropped.end();
  }

  void measure(int x, int y, CrackMaps& maps) const {
    const std::size_t i = static_cast<std::size_t>(y) * scene_.projection.width() + x;
    std::array<double, lattice> outside, labelled;
    trace(x, y, outside, labelled);
    maps.coverage[i] = static_cast<float>(area(outside));
    maps.label[i] = is_noisy_ ? static_cast<float>(area(labelled)) : maps.coverage[i];
    if (maps.coverage[i] <= 0) return;
    const render::Hit hit = rays_.intersect(scene_.projection.ray(x + 0.5, y + 0.5));
    NearestStrip nearest;
    Vec3 normal;
    if (hit.face >= 0) nearest = strips_.nearest(hit.face, strips_.point_of(hit), false);
    if (nearest.line < 0) {
      // The middle sees something else: the part of the pixel that is deepest in a crack tells.
      nearest = deepest(x, y, normal);
    } else {
      normal = strips_.normal_of(hit.face);
    }
    if (nearest.line < 0) return;
    maps.crack[i] = strips_.crack(nearest);
    maps.width[i] = static_cast<float>(strips_.seen_width(nearest, normal));
  }

 private:
  template <class Visit>
  void each_corner(int x, int y, const Visit& visit) const {
    for (int first = 0; first < lattice; first += render::RayScene::lanes) {
      render::RayScene::Rays rays;
      render::RayScene::Hits hits;
      const int count = std::min(render::RayScene::lanes, lattice - first);
      for (int k = 0; k < count; ++k) {
        const int i = (first + k) % corners, j = (first + k) / corners;
        rays[k] = scene_.projection.ray(x + static_cast<double>(i) / cells,
                                        y + static_cast<double>(j) / cells);
      }
      rays_.intersect(rays, hits);
      for (int k = 0; k < count; ++k) visit(first + k, hits[k]);
    }
  }

  void trace(int x, int y, std::array<double, lattice>& outside,
             std::array<double, lattice>& labelled) const {
    each_corner(x, y, [&](int k, const render::Hit& hit) {
      outside[k] = labelled[k] = far();
      if (hit.face < 0) return;
      const Vec3 p = strips_.point_of(hit);
      outside[k] = std::min(far(), strips_.nearest(hit.face, p, false).outside);
      labelled[k] = outside[k];
      if (!is_noisy_) return;
      const double pixel = scene_.projection.pixel_size(hit.distance / scene_.projection.scale());
      labelled[k] =
          std::min(far(), strips_.nearest(hit.face, p, true).outside) - noise_.grow * pixel;
    });
  }

  /// What stands for the distance where there is no crack.
  double far() const { return 100 * scene_.options.line_width; }

  static double area(const std::array<double, lattice>& g) {
    double sum = 0;
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        const double a = g[j * corners + i], b = g[j * corners + i + 1],
                     c = g[(j + 1) * corners + i], d = g[(j + 1) * corners + i + 1];
        sum += part_below(a, b, d) + part_below(a, c, d);
      }
    }
    return sum / (2 * cells * cells);
  }

  NearestStrip deepest(int x, int y, Vec3& normal) const {
    NearestStrip best;
    each_corner(x, y, [&](int, const render::Hit& hit) {
      if (hit.face < 0) return;
      const NearestStrip here = strips_.nearest(hit.face, strips_.point_of(hit), false);
      if (here.outside >= best.outside) return;
      best = here;
      normal = strips_.normal_of(hit.face);
    });
    return best;
  }

  const Scene& scene_;
  const render::RayScene& rays_;
  const LabelNoise& noise_;
  CrackStrips strips_;
  bool is_noisy_ = false;
};

/// The pixels that a crack or a grown mask may touch: those near the picture of an edge.
std::vector<std::uint8_t> near_cracks(const Scene& scene, double grow) {
  const Projection& projection = scene.projection;
  const int width = projection.width(), height = projection.height();
  std::vector<std::uint8_t> near(static_cast<std::size_t>(width) * height, 0);
  const CrackNetwork& network = scene.result.state().network;
  for (std::size_t c = 0; c < scene.cracks.size(); ++c) {
    const WholeCrack& crack = scene.cracks[c];
    for (std::size_t i = 0; i + 1 < crack.nodes.size(); ++i) {
      const Vec3& a = network.nodes[crack.nodes[i]].position;
      const Vec3& b = network.nodes[crack.nodes[i + 1]].position;
      const double least = std::min(projection.depth(a), projection.depth(b));
      if (!(least > 0)) continue;
      const double wide = std::max(scene.widths[c][i], scene.widths[c][i + 1]);
      const double reach = wide / 2 / projection.pixel_size(least) + std::max(0.0, grow) + 2;
      const Vec2 p = projection.pixel(a), q = projection.pixel(b);
      if (!p.allFinite() || !q.allFinite()) continue;
      const Vec2 low = p.cwiseMin(q), high = p.cwiseMax(q);
      const auto first = [](double v, int size) {
        return static_cast<int>(std::clamp(std::floor(v), 0.0, static_cast<double>(size)));
      };
      const int x1 = first(high.x() + reach + 1, width), y1 = first(high.y() + reach + 1, height);
      for (int y = first(low.y() - reach, height); y < y1; ++y) {
        for (int x = first(low.x() - reach, width); x < x1; ++x) {
          near[static_cast<std::size_t>(y) * width + x] = 1;
        }
      }
    }
  }
  return near;
}

}  // namespace

CrackMaps crack_maps(const Scene& scene, const render::RayScene& rays, const LabelNoise& noise,
                     const Context& context) {
  const int width = scene.projection.width(), height = scene.projection.height();
  const std::size_t size = static_cast<std::size_t>(width) * height;
  CrackMaps maps{std::vector<float>(size, 0), std::vector<float>(size, 0),
                 std::vector<float>(size, 0), std::vector<std::int32_t>(size, -1)};
  if (scene.cracks.empty()) return maps;
  const std::vector<std::uint8_t> near = near_cracks(scene, noise.grow);
  const PixelCracks pixels(scene, rays, noise);
  parallel_for(context.threads, static_cast<std::size_t>(height), 4,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t y = begin; y < end; ++y) {
                   for (int x = 0; x < width; ++x) {
                     if (!near[y * width + x]) continue;
                     pixels.measure(x, static_cast<int>(y), maps);
                   }
                 }
               });
  return maps;
}

}  // namespace craze
