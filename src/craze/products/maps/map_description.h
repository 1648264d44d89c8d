// What stands in maps.json beside maps (docs/maps.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "craze/maps.h"
#include "craze/products/maps/tile_textures.h"

namespace craze {

enum class MapFormat {
  png,  ///< integers of 16 bits
  exr,  ///< floats of 32 bits
};

/// "mask.png".
std::string map_file_name(const MapHeader& header, MapFormat format);

/// What is said of one file.
nlohmann::ordered_json map_json(const MapHeader& header, MapFormat format);

/// The whole text, with the members of `more` before the list `maps` of what map_json() says.
std::string maps_text(MapFormat format, const nlohmann::ordered_json& more,
                      const nlohmann::ordered_json& maps);

/// The member `tile` of a tile's, in an object.
nlohmann::ordered_json tile_json(const TileTextures& made, const TileSize& size);

}  // namespace craze
