#include "craze/job/maps/map_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "craze/base/parallel.h"
#include "craze/base/version.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/output_folder.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

constexpr double largest_integer = 65535;

const char* extension(MapFormat format) {
  return format == MapFormat::png ? "png" : "exr";
}

std::string file_name(const MapHeader& header, MapFormat format) {
  return map_name(header) + "." + extension(format);
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

nlohmann::ordered_json describe(const MapHeader& header, MapFormat format) {
  const MapInfo& info = map_info(header.kind);
  nlohmann::ordered_json json;
  json["file"] = file_name(header, format);
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

}  // namespace

void MapFiles::begin(const std::vector<MapHeader>& headers) {
  make_output_folder("maps", request_.folder);
  headers_ = headers;
  for (const MapHeader& header : headers) files_.push_back(new_file(header));
}

void MapFiles::rows(int first, int count, const std::vector<const float*>& maps) {
  const int block = files_.front()->block_rows();
  const std::size_t blocks = static_cast<std::size_t>((count + block - 1) / block);
  std::vector<RowImage::Block> packed(blocks * maps.size());
  parallel_for(context_.threads, packed.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t m = i / blocks;
      const int row = static_cast<int>(i % blocks) * block;
      const std::size_t width =
          static_cast<std::size_t>(headers_[m].size) * map_info(headers_[m].kind).channels;
      packed[i] = files_[m]->pack(first + row, std::min(block, count - row),
                                  maps[m] + static_cast<std::size_t>(row) * width);
    }
  });
  for (std::size_t i = 0; i < packed.size(); ++i) {
    files_[i / blocks]->write(first + static_cast<int>(i % blocks) * block, packed[i]);
  }
}

void MapFiles::end() {
  for (std::size_t m = 0; m < files_.size(); ++m) {
    files_[m]->finish();
    described_.push_back(describe(headers_[m], request_.format));
    const auto set = uv_sets_.find(headers_[m].material);
    if (set != uv_sets_.end()) described_.back()["uv_set"] = set->second;
  }
  files_.clear();
}

void MapFiles::write_description(const nlohmann::ordered_json& more) const {
  nlohmann::ordered_json json;
  json["craze"] = version();
  json["format"] = extension(request_.format);
  json["bits"] = request_.format == MapFormat::png ? 16 : 32;
  // How a number is got from what is stored.
  json["stored"] = request_.format == MapFormat::png
                       ? "range[0] + stored / 65535 * (range[1] - range[0]); ids as they are"
                       : "as it is";
  json["rows"] = "from v = 1 down";
  json["tangents"] = "MikkTSpace";
  json.update(more);
  json["maps"] = described_;
  write_file(fs::path(request_.folder) / "maps.json", json.dump(2) + "\n", "cannot write maps",
             context_);
}

std::unique_ptr<RowImage> MapFiles::new_file(const MapHeader& header) const {
  const MapInfo& info = map_info(header.kind);
  RowImageFormat format{header.size, header.size, info.channels, header.low, header.high};
  format.is_color = info.values == MapValues::color;
  if (info.values == MapValues::id) {
    if (request_.format == MapFormat::png && header.high[0] > largest_integer) {
      throw Error(ErrorKind::request, "cannot write map", file_name(header, request_.format),
                  fmt::format("16 bits do not number {}; use --map-format exr", header.high[0]));
    }
    format.high.fill(largest_integer);
  }
  const fs::path path = fs::path(request_.folder) / file_name(header, request_.format);
  return request_.format == MapFormat::png ? new_png16(path, format, context_)
                                           : new_exr(path, format, context_);
}

}  // namespace craze
