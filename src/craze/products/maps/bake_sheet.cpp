#include "craze/products/maps/bake_sheet.h"

#include <algorithm>
#include <cmath>

#include "craze/base/parallel.h"
#include "craze/products/maps/rows_at_once.h"
#include "craze/products/maps/texel_owners.h"

namespace craze {

namespace {

constexpr int band_rows = 128;
static_assert(band_rows % 16 == 0);

struct Texel {
  std::int32_t face = -1;  ///< −1: the picture is empty
  std::int32_t piece = -1;
  Vec2 p = Vec2::Zero();  ///< in the plane of the face
};

using Heights = std::array<std::array<double, 3>, 3>;  ///< [row][column] around a texel, y down

/// Some rows of all maps, with one more above and below for differences.
class Band {
 public:
  Band(const BakeScene& scene, const MapSheet& sheet, const std::vector<MapHeader>& headers)
      : scene_(scene),
        sheet_(sheet),
        headers_(headers),
        size_(scene.options.size),
        repeats_(scene.maps.is_tile()),
        owners_(scene.maps.pieces, sheet.pieces, size_),
        texels_(static_cast<std::size_t>(size_) * (band_rows + 2)),
        grooves_(texels_.size()) {
    for (const MapHeader& header : headers) {
      by_heights_ |= header.kind == MapKind::normal || header.kind == MapKind::curvature;
      values_.emplace_back(static_cast<std::size_t>(size_) * band_rows *
                           map_info(header.kind).channels);
    }
  }

  void bake(int first, int count, const Context& context) {
    first_ = first;
    parallel_for(context.threads, static_cast<std::size_t>(count) + 2, rows_at_once,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t r = begin; r < end; ++r) find_texels(static_cast<int>(r));
                 });
    parallel_for(context.threads, static_cast<std::size_t>(count), rows_at_once,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t r = begin; r < end; ++r) fill_row(static_cast<int>(r));
                 });
  }

  std::vector<const float*> rows() const {
    std::vector<const float*> rows;
    for (const std::vector<float>& values : values_) rows.push_back(values.data());
    return rows;
  }

 private:
  std::size_t index(int row, int x) const { return static_cast<std::size_t>(row) * size_ + x; }
  Mat2 texel_sides(std::int32_t face) const {
    const Mat2& m = scene_.faces[face].by_uv;
    Mat2 sides;
    sides << m.col(0) / size_, -m.col(1) / size_;
    return sides;
  }

  /// At p in the plane of the texel's face.
  GrooveMean groove_at(const Texel& texel, const Vec2& p, const Mat2& sides) const {
    return scene_.grooves.mean(texel.face, p, sides, scene_.lift.at(texel.piece, p),
                               scene_.maps.pieces[texel.piece].fragment);
  }

  /// Row r of the band with its margin: row first + r − 1 of the picture.
  void find_texels(int r) {
    int y = first_ + r - 1;
    if (repeats_) y = (y + size_) % size_;
    if (y < 0 || y >= size_) return;
    std::vector<TexelOwners::Owner> owners;
    owners_.row(y, owners);
    for (int x = 0; x < size_; ++x) {
      const TexelOwners::Owner& owner = owners[x];
      Texel& texel = texels_[index(r, x)];
      texel = {};
      if (owner.placed < 0) continue;
      const PlacedPiece& placed = sheet_.pieces[owner.placed];
      texel.piece = placed.piece;
      texel.face = scene_.maps.pieces[placed.piece].face;
      Vec2 away(x - owner.x, y - owner.y);
      const double distance = std::sqrt(away.squaredNorm());
      if (distance > texels_followed) away *= texels_followed / distance;
      const Vec2 at = Vec2(owner.x + 0.5, owner.y + 0.5) + away;
      const Vec2 uv(at.x() / size_ + placed.offset.x(), 1 - at.y() / size_ + placed.offset.y());
      texel.p = scene_.faces.at(texel.face, uv);
      grooves_[index(r, x)] = groove_at(texel, texel.p, texel_sides(texel.face));
    }
  }

  /// The height of a neighbour, or of what lies there in the plane of the texel's own face where
  /// that texel shows another place.
  double height_beside(const Texel& texel, int r, int x, int dx, int dy, const Mat2& sides) const {
    const int y = first_ + r + dy - 1;
    const int beside = repeats_ ? (x + dx + size_) % size_ : x + dx;
    if (repeats_ || (beside >= 0 && beside < size_ && y >= 0 && y < size_)) {
      const std::size_t i = index(r + dy, beside);
      if (scene_.islands[texels_[i].face] == scene_.islands[texel.face]) return grooves_[i].height;
    }
    return groove_at(texel, texel.p + sides * Vec2(dx, dy), sides).height;
  }

  Heights heights_around(const Texel& texel, int r, int x, const Mat2& sides) const {
    Heights heights;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        heights[dy + 1][dx + 1] = dx == 0 && dy == 0 ? grooves_[index(r, x)].height
                                                     : height_beside(texel, r, x, dx, dy, sides);
      }
    }
    return heights;
  }

  void put_vector(const Vec3& v, float* out) const {
    const double green = scene_.options.green_up ? v.y() : -v.y();
    out[0] = static_cast<float>(0.5 + 0.5 * v.x());
    out[1] = static_cast<float>(0.5 + 0.5 * green);
    out[2] = static_cast<float>(0.5 + 0.5 * v.z());
  }

  /// The normal whose tilt against the surface's own is the gradient of the height, in the frame in
  /// which a shader reads it.
  Vec3 normal(const Texel& texel, const MapFrame& frame, const Heights& h,
              const Mat2& sides) const {
    const Vec2 by_texel((h[1][2] - h[1][0]) / 2, (h[2][1] - h[0][1]) / 2);
    if (by_texel.isZero()) return Vec3::UnitZ();
    const Vec2 slope = sides.transpose().inverse() * by_texel;
    const FacePlane& plane = scene_.faces[texel.face].plane;
    const Vec3 n = frame.normal.stableNormalized();
    const Vec3 gradient = slope.x() * plane.x + slope.y() * plane.y;
    const Vec3 tilted = n - (gradient - gradient.dot(n) * n);
    Mat3 basis;
    basis << frame.tangent, frame.bitangent, frame.normal;
    const Vec3 seen = basis.inverse() * tilted;
    return seen.allFinite() ? Vec3(seen.stableNormalized()) : Vec3::UnitZ();
  }

  double curvature(const Texel& texel, const Vec3& weights, const Heights& h,
                   const Mat2& sides) const {
    Mat2 bend;
    bend(0, 0) = h[1][2] - 2 * h[1][1] + h[1][0];
    bend(1, 1) = h[2][1] - 2 * h[1][1] + h[0][1];
    bend(0, 1) = bend(1, 0) = (h[2][2] - h[2][0] - h[0][2] + h[0][0]) / 4;
    double mean = 0;
    if (!bend.isZero()) {
      const Mat2 inverse = sides.inverse();
      mean = -0.5 * (inverse.transpose() * bend * inverse).trace();
      if (!std::isfinite(mean)) mean = 0;
    }
    const Triangle& t = scene_.maps.surface.triangles[texel.face];
    for (int i = 0; i < 3; ++i) mean += weights[i] * scene_.base_curvature[t[i]];
    return mean;
  }

  Vec3 direction(const Texel& texel, const MapFrame& frame, const NearestCrack& nearest) const {
    if (nearest.crack < 0) return {0, 0, -1};
    const FacePlane& plane = scene_.faces[texel.face].plane;
    const Vec3 grew = nearest.direction.x() * plane.x + nearest.direction.y() * plane.y;
    Vec3 seen(grew.dot(frame.tangent.stableNormalized()),
              grew.dot(frame.bitangent.stableNormalized()), 0);
    seen = seen.stableNormalized();
    seen.z() = 1;
    return seen;
  }

  void fill_row(int row) {
    const int r = row + 1;
    for (int x = 0; x < size_; ++x) {
      const Texel& texel = texels_[index(r, x)];
      if (texel.face < 0) continue;
      const GrooveMean& groove = grooves_[index(r, x)];
      const NearestCrack nearest = scene_.grooves.nearest(texel.face, texel.p);
      const Mat2 sides = texel_sides(texel.face);
      const Vec3 weights = scene_.faces.weights(texel.face, texel.p);
      const MapFrame frame = scene_.faces.frame(texel.face, weights);
      const Heights heights = by_heights_ ? heights_around(texel, r, x, sides) : Heights{};
      for (std::size_t m = 0; m < headers_.size(); ++m) {
        const MapHeader& header = headers_[m];
        float* const out = values_[m].data() + index(row, x) * map_info(header.kind).channels;
        const auto put = [out](double value) { *out = static_cast<float>(value); };
        switch (header.kind) {
          case MapKind::mask:
            put(groove.mask);
            break;
          case MapKind::height:
            put(groove.height);
            break;
          case MapKind::normal:
            put_vector(normal(texel, frame, heights, sides), out);
            break;
          case MapKind::occlusion:
            put(groove.light);
            break;
          case MapKind::curvature:
            put(curvature(texel, weights, heights, sides));
            break;
          case MapKind::distance:
            put(std::min(nearest.distance, header.high[0]));
            break;
          case MapKind::width:
            put(scene_.grooves.width(texel.face, nearest));
            break;
          case MapKind::direction:
            put_vector(direction(texel, frame, nearest), out);
            break;
          case MapKind::time:
            put(nearest.crack < 0 ? header.low[0] : scene_.maps.cracks[nearest.crack].time);
            break;
          case MapKind::crack:
            put(nearest.crack < 0 ? 0 : 1 + scene_.maps.cracks[nearest.crack].number);
            break;
          case MapKind::fragment:
            put(1 + scene_.maps.pieces[texel.piece].fragment);
            break;
          case MapKind::position: {
            const Vec3 p = scene_.faces.position(texel.face, texel.p);
            for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(p[i]);
            break;
          }
          case MapKind::base_color:
          case MapKind::roughness:
            break;  // of material_maps.h
        }
      }
    }
  }

  const BakeScene& scene_;
  const MapSheet& sheet_;
  const std::vector<MapHeader>& headers_;
  int size_, first_ = 0;
  bool by_heights_ = false;  // whether a map needs differences
  bool repeats_;             // whether the picture continues on itself
  TexelOwners owners_;
  std::vector<Texel> texels_;        // of the band and its margin
  std::vector<GrooveMean> grooves_;  // likewise
  std::vector<std::vector<float>> values_;
};

}  // namespace

void bake_sheet(const BakeScene& scene, const MapSheet& sheet,
                const std::vector<MapHeader>& headers, MapSink& sink, const Context& context) {
  Band band(scene, sheet, headers);
  sink.begin(headers);
  const int size = scene.options.size;
  for (int first = 0; first < size; first += band_rows) {
    context.check();
    context.report({"maps", static_cast<double>(first) / size});
    const int count = std::min(band_rows, size - first);
    band.bake(first, count, context);
    sink.rows(first, count, band.rows());
  }
  sink.end();
  context.report({"maps", 1});
}

}  // namespace craze
