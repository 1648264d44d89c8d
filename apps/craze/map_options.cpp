#include "map_options.h"

#include <algorithm>

#include "color_option.h"
#include "craze/base/srgb.h"

namespace craze::app {

namespace {

/// "mask, height, …".
std::string map_names(const std::vector<MapInfo>& table) {
  std::string names;
  for (const MapInfo& info : table) {
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  }
  return names;
}

void add_options(CLI::App& verb, MapsRequest& maps, const char* group, bool of_tile,
                 const std::string& which, const char* size) {
  verb.add_option_function<std::vector<std::string>>(
          "--map",
          [&maps, of_tile](const std::vector<std::string>& names) {
            for (const std::string& name : names) {
              maps.options.maps.push_back(find_map(name, of_tile));
            }
          },
          "Which ones, as often as you like; " + which)
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group(group);
  verb.add_option(size, maps.options.size, "Texels along each side")
      ->type_name("N")
      ->check(CLI::Range(1, MapOptions::largest_size))
      ->capture_default_str()
      ->group(group);
  verb.add_option_function<std::string>(
          "--map-format",
          [&maps](const std::string& format) {
            maps.format = format == "exr" ? MapFormat::exr : MapFormat::png;
          },
          "png: 16 bits; exr: 32-bit floats, numbers as they are")
      ->check(CLI::IsMember({"png", "exr"}).description(""))
      ->type_name("EXT")
      ->default_str("png")
      ->group(group);
  verb.add_option_function<std::string>(
          "--map-green",
          [&maps](const std::string& green) { maps.options.green_up = green == "up"; },
          "Normals: up for glTF, OpenGL, Blender, Unity; down for DirectX, Unreal")
      ->check(CLI::IsMember({"up", "down"}).description(""))
      ->type_name("WAY")
      ->default_str("up")
      ->group(group);
}

}  // namespace

void add_map_options(CLI::App& verb, MapsRequest& maps, const char* group) {
  add_options(verb, maps, group, false, "all where none is named: " + map_names(map_table()),
              "--map-size");
}

void add_texture_map_options(CLI::App& verb, MapsRequest& maps, const char* group) {
  add_options(verb, maps, group, true,
              map_names(material_map_table()) +
                  ", or of those of craze bake; base_color, normal, height, occlusion, roughness, "
                  "mask and fragment where none is named",
              "--size,--map-size");
}

OptionNeed green_need(const MapsRequest& maps) {
  return {{"--map-green"}, "--map normal or --map direction", [&maps] {
            const std::vector<MapKind>& kinds = maps.options.maps;
            return kinds.empty() || std::any_of(kinds.begin(), kinds.end(), [](MapKind kind) {
                     return map_info(kind).values == MapValues::vector;
                   });
          }};
}

void add_stain_option(CLI::App& verb, CrackStain& stain, const char* group) {
  verb.add_option_function<std::string>(
          "--stain",
          [&stain](const std::string& text) {
            Color color{0, 0, 0, 1};
            const std::array<int, 3> stored = color_of("--stain", text);
            for (std::size_t k = 0; k < 3; ++k) {
              color[k] = srgb_to_linear(static_cast<float>(stored[k]) / 255);
            }
            stain.color = color;
          },
          "--as maps: colour of the cracks, RRGGBB; the surface's own, darkened")
      ->type_name("RRGGBB")
      ->group(group);
}

}  // namespace craze::app
