#include <string>

#include "craze/error.h"
#include "craze/maps.h"
#include "craze/recipe/nearest_name.h"

namespace craze {

const std::vector<MapInfo>& map_table() {
  static const std::vector<MapInfo> table{
      {MapKind::mask, "mask", 1, MapValues::share, "share of the texel that lies in an open crack"},
      {MapKind::height, "height", 1, MapValues::length,
       "of the surface with its grooves over the surface without"},
      {MapKind::normal, "normal", 3, MapValues::vector,
       "of the grooves, in tangent space (MikkTSpace)"},
      {MapKind::occlusion, "occlusion", 1, MapValues::share,
       "light of an even sky that reaches into the grooves; 1: all"},
      {MapKind::curvature, "curvature", 1, MapValues::inverse_length,
       "mean curvature of surface and grooves; convex above 0"},
      {MapKind::distance, "distance", 1, MapValues::length,
       "along the surface to the nearest crack"},
      {MapKind::width, "width", 1, MapValues::length, "of the nearest crack's opening, there"},
      {MapKind::direction, "direction", 3, MapValues::vector,
       "in which the nearest crack grew, red and green in tangent space; blue: 1, or 0 without "
       "one"},
      {MapKind::time, "time", 1, MapValues::load, "at which the nearest crack opened"},
      {MapKind::crack, "crack", 1, MapValues::id, "number of the nearest crack event"},
      {MapKind::fragment, "fragment", 1, MapValues::id, "number of the piece"},
      {MapKind::position, "position", 3, MapValues::length, "on the surface"},
  };
  return table;
}

const std::vector<MapInfo>& material_map_table() {
  static const std::vector<MapInfo> table{
      {MapKind::base_color, "base_color", 3, MapValues::color,
       "of the material without light or shade"},
      {MapKind::roughness, "roughness", 1, MapValues::share, "of the material; 0: a mirror"},
  };
  return table;
}

const MapInfo& map_info(MapKind kind) {
  const auto i = static_cast<std::size_t>(kind), n = map_table().size();
  return i < n ? map_table()[i] : material_map_table()[i - n];
}

MapKind find_map(const std::string& name, bool of_tile) {
  std::vector<std::string> names;
  std::string list;
  std::vector<MapInfo> all = map_table();
  if (of_tile) {
    all.insert(all.end(), material_map_table().begin(), material_map_table().end());
  }
  for (const MapInfo& info : all) {
    if (info.name == name) return info.kind;
    names.emplace_back(info.name);
    list += (list.empty() ? "" : ", ") + names.back();
  }
  const std::string nearest = nearest_name(name, names);
  throw Error(ErrorKind::usage, "unknown map", name,
              nearest.empty() ? "there are " + list : "did you mean " + nearest + "?");
}

std::string map_name(const MapHeader& header) {
  std::string name = header.texture_set.empty() ? "" : header.texture_set + "_";
  name += map_info(header.kind).name;
  return header.udim > 0 ? name + "." + std::to_string(header.udim) : name;
}

}  // namespace craze
