// Options of the verbs that bake maps.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "craze/job/maps/write_maps.h"
#include "craze/products/maps/pictures/crack_pictures.h"
#include "option_needs.h"

namespace craze::app {

/// --map, --map-size, --map-format, --map-green.
void add_map_options(CLI::App& verb, MapsRequest& maps, const char* group);

/// The same of tiles, which have a material's maps as well; --size names the texels too.
void add_texture_map_options(CLI::App& verb, MapsRequest& maps, const char* group);

/// --map-green says something of maps that have directions alone. `maps` must outlive the need.
OptionNeed green_need(const MapsRequest& maps);

/// --stain.
void add_stain_option(CLI::App& verb, CrackStain& stain, const char* group);

}  // namespace craze::app
