#include "craze/job/dataset/shards/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "craze/error.h"
#include "craze/io/files/tar.h"
#include "craze/io/image/read_image.h"
#include "craze/job/dataset/shards/shard_files.h"

namespace craze {

namespace {

using Bytes = std::array<std::uint8_t, 3>;
using Files = std::map<std::string, std::string>;  // of a sample, by kind

constexpr int border = 4;

class Sheet {
 public:
  Sheet(const SheetOptions& options, std::size_t samples, double aspect)
      : options_(options), height_(static_cast<int>(std::lround(options.size * aspect))) {
    const auto count = static_cast<int>(samples);
    const int columns = std::min(options.columns, count), rows = (count + columns - 1) / columns;
    image_.width = columns * (2 * options.size + border) + border;
    image_.height = rows * (height_ + border) + border;
    image_.rgb.assign(static_cast<std::size_t>(3) * image_.width * image_.height, 255);
  }

  void add(const Files& files) {
    const Image picture = read_image(files.at("image.png"), "an image");
    const Image mask = read_image(files.at("mask.png"), "a mask");
    const int x0 = border + next_ % options_.columns * (2 * options_.size + border);
    const int y0 = border + next_ / options_.columns * (height_ + border);
    ++next_;
    const double step = static_cast<double>(picture.width) / options_.size;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < options_.size; ++x) {
        std::array<double, 3> sum{};
        double covered = 0, count = 0;
        const auto end = [&](int i, int size) {
          return std::min(
              size, std::max(static_cast<int>((i + 1) * step), static_cast<int>(i * step) + 1));
        };
        for (int v = static_cast<int>(y * step); v < end(y, picture.height); ++v) {
          for (int u = static_cast<int>(x * step); u < end(x, picture.width); ++u) {
            for (int c = 0; c < 3; ++c) sum[c] += 255 * picture.value(u, v, c);
            covered += mask.value(u, v, 0);
            ++count;
          }
        }
        Bytes plain, labelled;
        const double red = std::min(1.0, 1.5 * covered / count);
        constexpr std::array<double, 3> mark{255, 30, 30};
        for (int c = 0; c < 3; ++c) {
          plain[c] = static_cast<std::uint8_t>(sum[c] / count);
          labelled[c] = static_cast<std::uint8_t>((1 - red) * sum[c] / count + red * mark[c]);
        }
        put(x0 + x, y0 + y, plain);
        put(x0 + options_.size + x, y0 + y, labelled);
      }
    }
    add_junctions(nlohmann::json::parse(files.at("json")), x0 + options_.size, y0, step);
  }

  render::Image take() { return std::move(image_); }

 private:
  void put(int x, int y, const Bytes& color) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    std::copy(color.begin(), color.end(),
              image_.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image_.width + x));
  }

  void add_junctions(const nlohmann::json& json, int x0, int y0, double step) {
    const std::map<std::string, Bytes> colors{
        {"end", {60, 120, 255}}, {"t", {40, 230, 60}}, {"y", {255, 230, 40}}};
    for (const auto& junction : json.at("junctions")) {
      const std::string kind = junction.at("kind");
      if (kind == "border" || junction.at("visible") == 0) continue;
      const auto color = colors.find(kind);
      const Bytes shown = color == colors.end() ? Bytes{255, 255, 255} : color->second;
      const int x = x0 + static_cast<int>(junction.at("pixel")[0].get<double>() / step);
      const int y = y0 + static_cast<int>(junction.at("pixel")[1].get<double>() / step);
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) put(x + dx, y + dy, shown);
      }
    }
  }

  SheetOptions options_;
  int height_, next_ = 0;
  render::Image image_;
};

/// The shards that are there, with how many samples each has.
std::vector<std::pair<ShardPaths, std::uint64_t>> whole_shards(
    const DatasetPlan& plan, const std::filesystem::path& folder) {
  std::vector<std::pair<ShardPaths, std::uint64_t>> shards;
  for (std::uint64_t s = 0; s < plan.shape.shards(); ++s) {
    const auto mark = read_mark(plan.shape, folder, s);
    if (mark) shards.emplace_back(shard_paths(folder, s), mark->samples);
  }
  return shards;
}

void add_sample(Sheet& sheet, const Files& files, const std::filesystem::path& archive) {
  try {
    sheet.add(files);
  } catch (const std::exception&) {  // of pictures, of JSON, or that one is missing
    throw Error(ErrorKind::input, "cannot show a sample", archive.string(),
                "it is damaged; craze dataset verify says where");
  }
}

}  // namespace

render::Image contact_sheet(const std::filesystem::path& folder, const SheetOptions& options,
                            const Context& context) {
  const DatasetPlan plan(plan_of_folder(folder, "dataset"));
  const auto shards = whole_shards(plan, folder);
  std::uint64_t there = 0;
  for (const auto& [paths, count] : shards) there += count;
  if (there == 0) {
    throw Error(ErrorKind::input, "nothing to look at", folder.string(), "no shard is whole yet");
  }
  const auto shown = std::min<std::uint64_t>(there, static_cast<std::uint64_t>(options.samples));
  Sheet sheet(options, shown, static_cast<double>(plan.shape.height) / plan.shape.width);
  std::uint64_t at = 0, done = 0;  // of all that are there
  for (const auto& [paths, count] : shards) {
    if (done == shown || done * there / shown >= at + count) {
      at += count;
      continue;
    }
    TarReader tar(paths.tar);
    Files files;
    std::string name, bytes;
    while (tar.next(name, bytes)) {
      const std::string kind = name.substr(name.find('.') + 1);
      files[kind] = bytes;
      if (kind != "json") continue;
      context.check();
      if (done < shown && at == done * there / shown) {
        add_sample(sheet, files, paths.tar);
        ++done;
      }
      files.clear();
      ++at;
    }
  }
  return sheet.take();
}

}  // namespace craze
