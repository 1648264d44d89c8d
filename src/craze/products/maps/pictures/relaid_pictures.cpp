#include "craze/products/maps/pictures/relaid_pictures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "craze/base/parallel.h"
#include "craze/base/srgb.h"
#include "craze/products/maps/groove_sampler.h"
#include "craze/products/maps/map_faces.h"
#include "craze/products/maps/pictures/sample_picture.h"
#include "craze/products/maps/rows_at_once.h"
#include "craze/products/maps/texel_owners.h"

namespace craze {

namespace {

constexpr int most_samples = 8;  // of a texel, along each side

/// What the numbers of a picture are.
enum class Numbers { color, vector, plain };

/// Half as large, each pixel the mean of those that it covers.
Image halved(const Image& image, Numbers numbers) {
  Image half{std::max(image.width / 2, 1), std::max(image.height / 2, 1), image.channels, {}};
  std::vector<float> values;
  for (std::int32_t y = 0; y < half.height; ++y) {
    const std::int32_t top = y * image.height / half.height,
                       bottom = (y + 1) * image.height / half.height;
    for (std::int32_t x = 0; x < half.width; ++x) {
      const std::int32_t left = x * image.width / half.width,
                         right = (x + 1) * image.width / half.width;
      for (int c = 0; c < image.channels; ++c) {
        const bool is_light =
            numbers == Numbers::color && (image.channels % 2 == 1 || c + 1 < image.channels);
        double sum = 0;
        for (std::int32_t j = top; j < bottom; ++j) {
          for (std::int32_t i = left; i < right; ++i) {
            const double value = image.value(i, j, c);
            sum += is_light ? srgb_to_linear(static_cast<float>(value)) : value;
          }
        }
        const auto mean = static_cast<float>(sum / ((bottom - top) * (right - left)));
        values.push_back(is_light ? linear_to_srgb(mean) : mean);
      }
    }
  }
  half.values = std::move(values);
  return half;
}

/// A picture and smaller ones of it.
class Levels {
 public:
  Levels(const SurfacePicture& own, Numbers numbers, double pixels) : numbers_(numbers) {
    smaller_.reserve(level_of(pixels));
    samplers_.emplace_back(own);
    const Image* last = &own.image;
    for (std::size_t i = 0; i < level_of(pixels) && (last->width > 1 || last->height > 1); ++i) {
      smaller_.push_back({halved(*last, numbers), own.place, own.wraps, own.uv_set});
      samplers_.emplace_back(smaller_.back());
      last = &smaller_.back().image;
    }
  }

  /// The mean over a parallelogram around uv with sides a and b, in UVs, on which so many pixels
  /// come.
  Color mean(const Vec2& uv, const Vec2& a, const Vec2& b, double pixels_a, double pixels_b) const {
    const std::size_t level = std::min(level_of(std::min(pixels_a, pixels_b)), smaller_.size());
    const PictureSampler& sampler = samplers_[level];
    const double scale = 1.0 / static_cast<double>(std::uint32_t{1} << level);
    const int n = samples(pixels_a * scale), m = samples(pixels_b * scale);
    if (n * m == 1) return sampler.color(uv);
    std::array<double, 4> sum{};
    for (int j = 0; j < m; ++j) {
      for (int i = 0; i < n; ++i) {
        const Color one = sampler.color(uv + ((i + 0.5) / n - 0.5) * a + ((j + 0.5) / m - 0.5) * b);
        for (std::size_t c = 0; c < 4; ++c) {
          sum[c] += numbers_ == Numbers::color && c < 3 ? srgb_to_linear(one[c]) : one[c];
        }
      }
    }
    Color mean{};
    for (std::size_t c = 0; c < 4; ++c) {
      const auto value = static_cast<float>(sum[c] / (n * m));
      mean[c] = numbers_ == Numbers::color && c < 3 ? linear_to_srgb(value) : value;
    }
    return mean;
  }

 private:
  static std::size_t level_of(double pixels) {
    constexpr double most = 1 << 20;
    std::size_t level = 0;
    for (double p = std::min(pixels, most); p >= 2; p /= 2) ++level;
    return level;
  }
  static int samples(double pixels) {
    return static_cast<int>(std::clamp(std::ceil(pixels - 1e-9), 1.0, double{most_samples}));
  }

  Numbers numbers_;
  std::vector<SurfacePicture> smaller_;   // each half as large as the last
  std::vector<PictureSampler> samplers_;  // of the picture and of those
};

/// How a picture's UVs change from texel to texel over a face.
struct Footprint {
  Vec2 right, down;                   ///< in the mesh's UVs, per texel
  double pixels_x = 0, pixels_y = 0;  ///< of the picture
};

class Relayer {
 public:
  Relayer(const MapSurface& maps, const MapSheet& sheet, int size, const Context& context)
      : maps_(maps),
        sheet_(sheet),
        size_(size),
        context_(context),
        faces_(maps.surface),
        owners_(maps.pieces, sheet.pieces, size) {}

  double pixels_per_texel() const { return most_pixels_; }

  SurfacePicture relaid(const SurfacePicture& own, const std::vector<Vec2>& uvs, Numbers numbers,
                        double normal_scale) {
    const std::vector<Footprint> footprints = footprints_of(own, uvs);
    double most = 0;
    for (const PlacedPiece& placed : sheet_.pieces) {
      const Footprint& f = footprints[maps_.pieces[placed.piece].face];
      most = std::max(most, std::min(f.pixels_x, f.pixels_y));
    }
    const Levels levels(own, numbers, most);
    std::optional<MapFaces> own_faces;
    if (numbers == Numbers::vector) {
      own_surface_ = maps_.surface;
      own_surface_.corner_uvs = uvs;
      own_faces.emplace(own_surface_);
    }
    const int channels = own.image.channels;
    SurfacePicture made;
    made.image = {size_, size_, numbers == Numbers::vector ? 3 : channels, {}};
    std::vector<std::uint16_t> values(static_cast<std::size_t>(size_) * size_ *
                                      made.image.channels);
    parallel_for(context_.threads, static_cast<std::size_t>(size_), rows_at_once,
                 [&](std::size_t begin, std::size_t end) {
                   std::vector<TexelOwners::Owner> owners;
                   for (std::size_t y = begin; y < end; ++y) {
                     owners_.row(static_cast<int>(y), owners);
                     std::uint16_t* out = &values[y * static_cast<std::size_t>(size_) *
                                                  static_cast<std::size_t>(made.image.channels)];
                     for (int x = 0; x < size_; ++x, out += made.image.channels) {
                       fill(static_cast<int>(y), x, owners[x], levels, footprints, uvs,
                            own_faces ? &*own_faces : nullptr, normal_scale, made.image.channels,
                            out);
                     }
                   }
                 });
    made.image.values = std::move(values);
    context_.check();
    return made;
  }

 private:
  std::vector<Footprint> footprints_of(const SurfacePicture& own, const std::vector<Vec2>& uvs) {
    std::vector<Footprint> footprints(maps_.surface.triangles.size());
    const Mat2 place = own.place.leftCols<2>();
    double pixels = 0, area = 0;
    for (const PlacedPiece& placed : sheet_.pieces) {
      const std::int32_t face = maps_.pieces[placed.piece].face;
      const auto c = 3 * static_cast<std::size_t>(face);
      // Weights of corners 1 and 2 per unit of the new u and v.
      const Mat2 weights = faces_[face].weights * faces_[face].by_uv;
      Mat2 sides;
      sides << uvs[c + 1] - uvs[c], uvs[c + 2] - uvs[c];
      const Mat2 by_uv = sides * weights;
      Footprint& f = footprints[face];
      f.right = by_uv.col(0) / size_;
      f.down = -by_uv.col(1) / size_;
      const auto in_pixels = [&](const Vec2& d) {
        const Vec2 p = place * d;
        return Vec2(p.x() * own.image.width, p.y() * own.image.height).norm();
      };
      f.pixels_x = in_pixels(f.right);
      f.pixels_y = in_pixels(f.down);
      const double own_area =
          std::abs(faces_[face].plane.corners[1].x() * faces_[face].plane.corners[2].y() -
                   faces_[face].plane.corners[1].y() * faces_[face].plane.corners[2].x());
      pixels += own_area * std::sqrt(f.pixels_x * f.pixels_y);
      area += own_area;
    }
    if (area > 0) most_pixels_ = std::max(most_pixels_, pixels / area);
    return footprints;
  }

  void fill(int y, int x, const TexelOwners::Owner& owner, const Levels& levels,
            const std::vector<Footprint>& footprints, const std::vector<Vec2>& uvs,
            const MapFaces* own_faces, double normal_scale, int channels,
            std::uint16_t* out) const {
    Color color{1, 1, 1, 1};
    if (own_faces) color = {0.5f, 0.5f, 1, 1};
    if (owner.placed >= 0) {
      const PlacedPiece& placed = sheet_.pieces[owner.placed];
      const std::int32_t face = maps_.pieces[placed.piece].face;
      // As the maps are continued beside the surface.
      Vec2 away(x - owner.x, y - owner.y);
      const double distance = std::sqrt(away.squaredNorm());
      if (distance > texels_followed) away *= texels_followed / distance;
      const Vec2 at = Vec2(owner.x + 0.5, owner.y + 0.5) + away;
      const Vec2 uv(at.x() / size_ + placed.offset.x(), 1 - at.y() / size_ + placed.offset.y());
      const Vec3 weights = faces_.weights(face, faces_.at(face, uv));
      const auto c = 3 * static_cast<std::size_t>(face);
      const Vec2 own_uv = weights[0] * uvs[c] + weights[1] * uvs[c + 1] + weights[2] * uvs[c + 2];
      const Footprint& f = footprints[face];
      color = levels.mean(own_uv, f.right, f.down, f.pixels_x, f.pixels_y);
      if (own_faces) turn(face, weights, *own_faces, normal_scale, color);
    }
    const auto put = [&](int k, float value) {
      out[k] = static_cast<std::uint16_t>(
          std::floor(std::clamp(static_cast<double>(value), 0.0, 1.0) * 65535 + 0.5));
    };
    for (int k = 0; k < channels; ++k) put(k, color[static_cast<std::size_t>(k)]);
    if (channels == 2) put(1, color[3]);
  }

  /// A stored normal from the frame of its own UVs to that of the new ones.
  void turn(std::int32_t face, const Vec3& weights, const MapFaces& own_faces, double scale,
            Color& color) const {
    const auto basis = [](const MapFrame& frame) {
      Mat3 b;
      b << frame.tangent, frame.bitangent, frame.normal;
      return b;
    };
    const Vec3 own(scale * (2 * color[0] - 1), scale * (2 * color[1] - 1), 2 * color[2] - 1);
    const Vec3 seen = basis(faces_.frame(face, weights)).inverse() *
                      (basis(own_faces.frame(face, weights)) * own);
    const Vec3 n = seen.allFinite() ? Vec3(seen.stableNormalized()) : Vec3::UnitZ();
    for (int k = 0; k < 3; ++k) {
      color[static_cast<std::size_t>(k)] = static_cast<float>(0.5 + 0.5 * n[k]);
    }
  }

  const MapSurface& maps_;
  const MapSheet& sheet_;
  int size_;
  const Context& context_;
  MapFaces faces_;
  SurfaceMesh own_surface_;  // with the UVs that normals come from
  TexelOwners owners_;
  double most_pixels_ = 0;
};

}  // namespace

RelaidPictures relaid_pictures(const SurfacePictures& own, const OwnUvs& uvs,
                               const MapSurface& maps, const MapSheet& sheet, int size,
                               const Context& context) {
  RelaidPictures result;
  result.pictures = own;
  SurfacePictures& made = result.pictures;
  Relayer relayer(maps, sheet, size, context);
  const auto move = [&](SurfacePicture& picture, const std::vector<Vec2>* from, Numbers numbers) {
    if (!from || picture.image.empty()) return false;
    picture = relayer.relaid(picture, *from, numbers, own.normal_scale);
    return true;
  };
  move(made.base_color, uvs[0], Numbers::color);
  if (move(made.normal, uvs[1], Numbers::vector)) made.normal_scale = 1;
  move(made.occlusion, uvs[2], Numbers::plain);
  move(made.roughness, uvs[3], Numbers::plain);
  result.pixels_per_texel = relayer.pixels_per_texel();
  return result;
}

}  // namespace craze
