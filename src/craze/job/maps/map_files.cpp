#include "craze/job/maps/map_files.h"

#include <algorithm>
#include <filesystem>

#include "craze/base/parallel.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/job/output_folder.h"
#include "craze/products/maps/map_description.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

constexpr double largest_integer = 65535;

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
    described_.push_back(map_json(headers_[m], request_.format));
    const auto set = uv_sets_.find(headers_[m].material);
    if (set != uv_sets_.end()) described_.back()["uv_set"] = set->second;
  }
  files_.clear();
}

void MapFiles::write_description(const nlohmann::ordered_json& more) const {
  write_file(fs::path(request_.folder) / "maps.json", maps_text(request_.format, more, described_),
             "cannot write maps", context_);
}

std::unique_ptr<RowImage> MapFiles::new_file(const MapHeader& header) const {
  const MapInfo& info = map_info(header.kind);
  RowImageFormat format{header.size, header.size, info.channels, header.low, header.high};
  format.is_color = info.values == MapValues::color;
  if (info.values == MapValues::id) {
    if (request_.format == MapFormat::png && header.high[0] > largest_integer) {
      throw Error(ErrorKind::request, "cannot write map", map_file_name(header, request_.format),
                  fmt::format("16 bits do not number {}; use --map-format exr", header.high[0]));
    }
    format.high.fill(largest_integer);
  }
  const fs::path path = fs::path(request_.folder) / map_file_name(header, request_.format);
  return request_.format == MapFormat::png ? new_png16(path, format, context_)
                                           : new_exr(path, format, context_);
}

}  // namespace craze
