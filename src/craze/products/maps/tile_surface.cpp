#include "craze/products/maps/tile_surface.h"

#include <array>
#include <cmath>
#include <map>

#include "craze/mesh/bounding_diagonal.h"
#include "craze/products/maps/map_cracks.h"

namespace craze {

namespace {

constexpr double steps = 0x1p40;  // of the UVs, in a tile

/// Places of the plane, in tiles.
class TileGrid {
 public:
  explicit TileGrid(double side) : side_(side) {}

  Vec2 uv(const Vec3& p) const { return {step(p.x()), step(p.y())}; }
  /// The image of uv that is nearest to `to`.
  static Vec2 nearest(const Vec2& uv, const Vec2& to) {
    return {uv.x() - std::round(uv.x() - to.x()), uv.y() - std::round(uv.y() - to.y())};
  }
  Vec3 place(const Vec2& uv) const { return {side_ * uv.x(), side_ * uv.y(), 0}; }

 private:
  /// In [0, 1).
  double step(double x) const {
    const double whole = std::floor(x / side_ * steps + 0.5) / steps;
    return whole - std::floor(whole);
  }

  double side_;
};

/// The faces laid out, each around its first corner, which lies in the tile; vertices of the
/// border come once for each image that faces need.
void lay_out(const SurfaceMesh& mesh, const TileGrid& squares, MapSurface& maps) {
  using Image = std::array<double, 3>;  // vertex and place
  std::map<Image, std::int32_t> laid;
  SurfaceMesh& open = maps.surface;
  maps.joined = mesh.triangles;
  for (const Triangle& t : mesh.triangles) {
    const Vec2 first = squares.uv(mesh.positions[t[0]]);
    Triangle face;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 uv = TileGrid::nearest(squares.uv(mesh.positions[t[i]]), first);
      const auto next = static_cast<std::int32_t>(open.positions.size());
      const auto [at, is_new] = laid.insert({{static_cast<double>(t[i]), uv.x(), uv.y()}, next});
      if (is_new) open.positions.push_back(squares.place(uv));
      face[i] = at->second;
      open.corner_uvs.push_back(uv);
      open.corner_normals.push_back(Vec3::UnitZ());
    }
    open.triangles.push_back(face);
  }
}

}  // namespace

MapSurface tile_surface(const CrackedTile& tile) {
  const TriangleMesh& cut = tile.mesh();
  const TileGrid squares(cut.period().length);
  MapSurface maps;
  maps.diagonal = bounding_diagonal({}, cut.period());
  lay_out(tile.surface, squares, maps);
  for (std::int32_t f = 0; f < cut.face_count(); ++f) {
    const std::int32_t face = tile.source_face(f);
    MapPiece piece{face, tile.fragments.face[static_cast<std::size_t>(f)], {}};
    const Vec2& first = maps.surface.corner_uvs[3 * static_cast<std::size_t>(face)];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t v = cut.triangle(f)[i];
      piece.uvs[i] = TileGrid::nearest(squares.uv(cut.position(v)), first);
    }
    maps.pieces.push_back(piece);
  }
  maps.cut = {tile.rough ? std::shared_ptr<const void>(tile.rough) : tile.simulation, &cut};
  maps.seed = tile.recipe.simulation.seed;
  maps.cracks = map_cracks(tile.network, cut);
  for (MapCrack& crack : maps.cracks) {
    const Vec2& first = maps.surface.corner_uvs[3 * static_cast<std::size_t>(crack.face)];
    const Vec2 a = TileGrid::nearest(squares.uv(crack.a), first);
    crack.b = squares.place(TileGrid::nearest(squares.uv(crack.b), a));
    crack.a = squares.place(a);
  }
  return maps;
}

}  // namespace craze
