#include "craze/products/maps/uv_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "craze/base/text/format.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/products/maps/texel_owners.h"

namespace craze {

namespace {

constexpr int looked_at = 1024;    // texels a side in which overlap is looked for
constexpr double rounding = 1e-5;  // of UVs at the border of a tile, tiles
constexpr int tiles_across = 10;   // of a row of UDIM tiles
constexpr int tiles_up = 900;      // whose numbers have four digits
constexpr double most_cells = 64;  // that a piece touches, each way, less one
/// How often UVs may cover a picture before it is of no use to look where.
constexpr double most_layers = 64;

struct Box {
  Vec2 low, high;
};

Box box_of(const MapPiece& piece) {
  return {piece.uvs[0].cwiseMin(piece.uvs[1]).cwiseMin(piece.uvs[2]),
          piece.uvs[0].cwiseMax(piece.uvs[1]).cwiseMax(piece.uvs[2])};
}

/// The cell that a piece lies in; of the middle where it lies in several.
Vec2 cell_of(const Box& box) {
  const Vec2 middle = (box.low + box.high) / 2;
  return {std::floor(middle.x()), std::floor(middle.y())};
}

bool is_inside(const Box& box, const Vec2& cell) {
  return ((box.low - cell).array() >= -rounding).all() &&
         ((box.high - cell).array() <= 1 + rounding).all();
}

/// The cells of the grid that a piece touches, as far as that is sane.
struct Cells {
  Vec2 low;
  int columns, rows;
};

Cells cells_of(const MapPiece& piece) {
  const Box box = box_of(piece);
  const auto count = [](double low, double high) {
    return 1 + static_cast<int>(std::clamp(std::ceil(high - rounding) - 1 - low, 0.0, most_cells));
  };
  const Vec2 low(std::floor(box.low.x() + rounding), std::floor(box.low.y() + rounding));
  return {low, count(low.x(), box.high.x()), count(low.y(), box.high.y())};
}

double uv_area(const MapPiece& piece) {
  const Vec2 a = piece.uvs[1] - piece.uvs[0], b = piece.uvs[2] - piece.uvs[0];
  return std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
}

/// In every cell that it touches, or in the first alone.
void place_repeated(const MapPiece& piece, std::int32_t index, bool everywhere,
                    std::vector<PlacedPiece>& placed) {
  const Cells cells = cells_of(piece);
  for (int j = 0; j < (everywhere ? cells.rows : 1); ++j) {
    for (int i = 0; i < (everywhere ? cells.columns : 1); ++i) {
      placed.push_back({index, cells.low + Vec2(i, j)});
    }
  }
}

using Materials = std::vector<std::int32_t>;

/// The sheets of the pieces that have one of `materials`; empty: of all.
std::vector<MapSheet> sheets_of(const MapSurface& maps, bool tiles, std::int32_t material,
                                bool by_material) {
  std::map<int, MapSheet> sheets;
  const Materials& of_face = maps.surface.face_materials;
  const auto is_in = [&](const MapPiece& piece) {
    return !by_material || of_face.empty() || of_face[piece.face] == material;
  };
  double layers = 0;
  for (const MapPiece& piece : maps.pieces) layers += is_in(piece) ? uv_area(piece) : 0;
  for (std::size_t i = 0; i < maps.pieces.size(); ++i) {
    const MapPiece& piece = maps.pieces[i];
    if (!is_in(piece)) continue;
    const auto index = static_cast<std::int32_t>(i);
    if (!tiles) {
      place_repeated(piece, index, layers <= most_layers, sheets[0].pieces);
      continue;
    }
    const Vec2 cell = cell_of(box_of(piece));
    const int udim = 1001 + static_cast<int>(cell.x()) + tiles_across * static_cast<int>(cell.y());
    sheets[udim].pieces.push_back({index, cell});
  }
  std::vector<MapSheet> result;
  for (auto& [udim, sheet] : sheets) {
    sheet.udim = udim;
    if (by_material) {
      sheet.material = material;
      sheet.texture_set = material < 0 ? "none" : maps.surface.material_names[material];
    }
    result.push_back(std::move(sheet));
  }
  return result;
}

/// Names that files can have, each another.
void make_names_distinct(std::vector<MapSheet>& sheets) {
  std::map<std::string, std::string> given;
  std::set<std::string> taken;
  for (MapSheet& sheet : sheets) {
    if (const auto old = given.find(sheet.texture_set); old != given.end()) {
      sheet.texture_set = old->second;
      continue;
    }
    std::string name;
    for (const char c : sheet.texture_set) {
      const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                         (c >= 'A' && c <= 'Z') || c == '-' || c == '_' || (c & 0x80) != 0;
      name += plain ? c : '_';
    }
    std::string distinct = name;
    for (int n = 2; !taken.insert(distinct).second; ++n) distinct = fmt::format("{}_{}", name, n);
    given.emplace(sheet.texture_set, distinct);
    sheet.texture_set = distinct;
  }
}

}  // namespace

std::set<std::int32_t> used_materials(const SurfaceMesh& surface) {
  if (surface.face_materials.empty()) return {-1};
  return {surface.face_materials.begin(), surface.face_materials.end()};
}

bool has_tiles(const MapSurface& maps) {
  bool beyond_first = false;
  for (const MapPiece& piece : maps.pieces) {
    const Box box = box_of(piece);
    const Vec2 cell = cell_of(box);
    if (!is_inside(box, cell) || cell.x() < 0 || cell.x() >= tiles_across || cell.y() < 0 ||
        cell.y() >= tiles_up) {
      return false;
    }
    beyond_first |= !cell.isZero();
  }
  return beyond_first;
}

std::vector<MapSheet> sheets_of_material(const MapSurface& maps, std::int32_t material,
                                         bool tiles) {
  return sheets_of(maps, tiles, material, true);
}

double overlap_of(const MapSurface& maps, const std::vector<MapSheet>& sheets) {
  std::int64_t covered = 0, twice = 0;
  for (const MapSheet& sheet : sheets) {
    double layers = 0;
    std::int32_t last = -1;
    for (const PlacedPiece& placed : sheet.pieces) {
      if (placed.piece != last) layers += uv_area(maps.pieces[placed.piece]);
      last = placed.piece;
    }
    if (!(layers <= most_layers)) return 1;
    const TexelOwners owners(maps.pieces, sheet.pieces, looked_at);
    covered += owners.covered();
    twice += owners.overlapping();
  }
  return covered > 0 ? static_cast<double>(twice) / static_cast<double>(covered) : 0;
}

UvLayout uv_layout(const MapSurface& maps, bool by_material, const Context& context) {
  UvLayout layout;
  const bool tiles = !by_material && has_tiles(maps);
  const Materials& materials = maps.surface.face_materials;
  std::set<std::int32_t> used(materials.begin(), materials.end());
  for (const std::int32_t out : maps.left_out) used.erase(out);
  const auto apart = [&] {
    std::vector<MapSheet> sheets;
    for (const std::int32_t material : used) {
      context.check();
      for (MapSheet& sheet : sheets_of(maps, tiles, material, true)) {
        sheets.push_back(std::move(sheet));
      }
    }
    return sheets;
  };
  const bool must_part = (by_material || maps.apart) && !materials.empty();
  layout.sheets = must_part ? apart() : sheets_of(maps, tiles, -1, false);
  double overlapping = overlap_of(maps, layout.sheets);
  context.check();
  if (!must_part && overlapping > unseen_overlap && used.size() > 1) {
    std::vector<MapSheet> sheets = apart();
    const double less = overlap_of(maps, sheets);
    if (less < overlapping / 2) {
      layout.sheets = std::move(sheets);
      overlapping = less;
    }
  }
  if (layout.sheets.size() > 1) make_names_distinct(layout.sheets);
  if (overlapping > unseen_overlap) {
    layout.warnings.push_back(fmt::format(
        "the UVs overlap (maps): {:.3g} % of the covered texels belong to several places of the "
        "surface and show the first one; unwrap it without overlap",
        100 * overlapping));
  }
  return layout;
}

std::vector<std::uint8_t> faces_at_uv_border(const SurfaceMesh& surface) {
  const TriangleMesh mesh(surface.positions, surface.triangles);
  const auto continues = [&](std::int32_t h) {
    const std::int32_t o = mesh.opposite(h);
    return o >= 0 && surface.corner_uvs[h] == surface.corner_uvs[TriangleMesh::next(o)] &&
           surface.corner_uvs[TriangleMesh::next(h)] == surface.corner_uvs[o];
  };
  std::vector<std::uint8_t> is_border(surface.positions.size(), 0);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (!continues(h)) is_border[mesh.from(h)] = is_border[mesh.to(h)] = 1;
  }
  std::vector<std::uint8_t> at_border;
  for (const Triangle& t : surface.triangles) {
    at_border.push_back(is_border[t[0]] | is_border[t[1]] | is_border[t[2]]);
  }
  return at_border;
}

}  // namespace craze
