#include "craze/products/maps/map_description.h"

#include "craze/base/version.h"

namespace craze {

namespace {

const char* extension(MapFormat format) {
  return format == MapFormat::png ? "png" : "exr";
}

const char* unit(MapValues values) {
  switch (values) {
    case MapValues::length:
      return "model unit";
    case MapValues::inverse_length:
      return "1 / model unit";
    case MapValues::load:
      return "load";
    case MapValues::share:
    case MapValues::vector:
    case MapValues::id:
    case MapValues::color:
      break;
  }
  return "1";
}

const char* name_of(MapValues values) {
  switch (values) {
    case MapValues::share:
      return "share";
    case MapValues::vector:
      return "vector";
    case MapValues::length:
    case MapValues::inverse_length:
    case MapValues::load:
      return "number";
    case MapValues::id:
      return "id";
    case MapValues::color:
      return "color";
  }
  return "";
}

}  // namespace

std::string map_file_name(const MapHeader& header, MapFormat format) {
  return map_name(header) + "." + extension(format);
}

nlohmann::ordered_json map_json(const MapHeader& header, MapFormat format) {
  const MapInfo& info = map_info(header.kind);
  nlohmann::ordered_json json;
  json["file"] = map_file_name(header, format);
  json["map"] = info.name;
  json["texture_set"] = header.texture_set;
  json["udim"] = header.udim > 0 ? nlohmann::ordered_json(header.udim) : nullptr;
  json["size"] = {header.size, header.size};
  json["channels"] = info.channels;
  json["color_space"] =
      info.values == MapValues::color && format == MapFormat::png ? "sRGB" : "linear";
  json["values"] = name_of(info.values);
  json["unit"] = unit(info.values);
  if (header.kind == MapKind::position) {
    json["range"] = {header.low, header.high};
  } else {
    json["range"] = {header.low[0], header.high[0]};
  }
  if (info.values == MapValues::vector) json["green"] = header.green_up ? "up" : "down";
  json["text"] = info.text;
  return json;
}

std::string maps_text(MapFormat format, const nlohmann::ordered_json& more,
                      const nlohmann::ordered_json& maps) {
  nlohmann::ordered_json json;
  json["craze"] = version();
  json["format"] = extension(format);
  json["bits"] = format == MapFormat::png ? 16 : 32;
  // How a number is got from what is stored.
  json["stored"] = format == MapFormat::png
                       ? "range[0] + stored / 65535 * (range[1] - range[0]); ids as they are"
                       : "as it is";
  json["rows"] = "from v = 1 down";
  json["tangents"] = "MikkTSpace";
  json.update(more);
  json["maps"] = maps;
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;  // what is no UTF-8
  return json.dump(2, ' ', false, replace) + "\n";
}

nlohmann::ordered_json tile_json(const TileTextures& made, const TileSize& size) {
  nlohmann::ordered_json tile;
  tile["side"] = size.side;
  tile["metres_per_unit"] =
      size.metres_per_unit > 0 ? nlohmann::ordered_json(size.metres_per_unit) : nullptr;
  tile["seed"] = made.tile().recipe.simulation.seed;
  tile["material"] = made.tile().recipe.picture.material;
  tile["gap"] = made.grooves().gap;
  tile["wall"] = static_cast<double>(made.grooves().wall);
  tile["pieces"] = made.tile().report.cracks.fragments;
  tile["crack_length"] = made.tile().report.cracks.length;
  nlohmann::ordered_json json;
  json["tile"] = tile;
  return json;
}

}  // namespace craze
