// Maps: what is known of the cracks as pictures in the surface's own UVs.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/recipe.h"
#include "craze/surface_mesh.h"

namespace craze {

enum class MapKind {
  mask,
  height,
  normal,
  occlusion,
  curvature,
  distance,
  width,
  direction,
  time,
  crack,
  fragment,
  position,
  base_color,  ///< of tiles alone, as is the next (material_map_table)
  roughness,
};

/// What the numbers of a map are.
enum class MapValues {
  share,           ///< 0 … 1
  vector,          ///< ½ + ½ x of each component of a unit vector
  length,          ///< model units
  inverse_length,  ///< 1 / model units
  load,            ///< load factor, or simulated time
  id,              ///< whole numbers from 1; 0: none. Never mixed
  color,           ///< linear, 0 … 1
};

struct MapInfo {
  MapKind kind;
  std::string_view name;
  int channels;  ///< 1 or 3
  MapValues values;
  std::string_view text;
};

/// Every map of a surface, in the order of MapKind: the one table that help, checks and files read.
const std::vector<MapInfo>& map_table();
/// What a tile has as well, in the order that goes on from there.
const std::vector<MapInfo>& material_map_table();
const MapInfo& map_info(MapKind kind);
/// Throws Error(usage) for a name that is none. of_tile: material_map_table() counts too.
MapKind find_map(const std::string& name, bool of_tile = false);

struct MapOptions {
  static constexpr int largest_size = 8192;

  int size = 1024;            ///< texels along each side, 1 … largest_size
  std::vector<MapKind> maps;  ///< each once at most; empty: all of them
  bool green_up =
      true;  ///< green of normal and direction grows with v (glTF, OpenGL); else it falls
  /// A set for each material even where their UVs lie apart, and no tiles, as glTF has it.
  bool by_material = false;
  /// How wide and deep the grooves are, how rims curl and where they are chipped.
  PostParameters post;
};

/// One map of one texture set, or of one UDIM tile of it.
struct MapHeader {
  MapKind kind;
  std::string texture_set;     ///< a material's name; empty where there is one set alone
  std::int32_t material = -1;  ///< whose set it is, of the surface's; −1: of several, or of none
  int udim = 0;                ///< 1001 + u + 10 v; 0: there are no tiles
  std::int32_t size = 0;
  bool green_up = true;
  /// What 0 and 1 stand for where a file holds integers, per channel; ids are as they are.
  std::array<double, 3> low{0, 0, 0}, high{1, 1, 1};
};

/// What tells a map from the others of a surface: "mask", "SET_mask", "mask.1001", "SET_mask.1001".
std::string map_name(const MapHeader& header);

/// Rows from the top (v = 1 first), pixels from the left, channels together.
struct Map {
  MapHeader header;
  std::vector<float> values;  ///< size × size × channels
};

/// Where maps go as they come to be, so that no more than some rows of them are in memory. All are
/// called from the caller's thread.
class MapSink {
 public:
  virtual ~MapSink() = default;
  /// The maps that rows() is about until end(): those of one set or tile.
  virtual void begin(const std::vector<MapHeader>& maps) = 0;
  /// `count` rows from `first` on, one array per map of begin(). Every row comes once, in order;
  /// `count` is a multiple of 16 but for the last rows of a map.
  virtual void rows(int first, int count, const std::vector<const float*>& maps) = 0;
  virtual void end() = 0;
};

/// Bakes the maps of a run. Each texel is computed from the curves of the cracks themselves, so
/// they are as sharp as the size allows whatever the triangles; texels outside the surface take
/// what would follow across the seam. Reports "maps". Returns what could not be done as asked, a
/// sentence each. Throws Error(request) for a surface without UVs, Error(usage) for wrong options,
/// and Cancelled. The same on any number of threads. Memory: 6 bytes per texel and 128 rows of each
/// map.
std::vector<std::string> bake_maps(const Result& result, const MapOptions& options, MapSink& sink,
                                   const Context& context);

/// The same of a cracked mesh that comes from a file: cracks are open edges that lie on each other.
/// What it has of the vertex attributes crack_time and displacement and the face attribute fragment
/// is used. Throws Error(request) where it has no cracks.
std::vector<std::string> bake_maps(const SurfaceMesh& cracked, const MapOptions& options,
                                   MapSink& sink, const Context& context);

/// Throws Error(request) for a surface without UVs.
void check_uvs(const SurfaceMesh& surface);

/// All of a run's maps in memory; `warnings` receives what bake_maps() returns.
std::vector<Map> baked_maps(const Result& result, const MapOptions& options,
                            std::vector<std::string>& warnings, const Context& context);

}  // namespace craze
