#include "craze/job/dataset/shards/coco.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/files/read_file.h"

namespace craze {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view head =
    "{\"info\":{\"description\":\"cracks\"},\n"
    "\"categories\":[{\"id\":1,\"name\":\"crack\"}],\n\"images\":[\n";
constexpr std::string_view between = "],\n\"annotations\":[\n";
constexpr std::string_view tail = "]}\n";
constexpr std::uint64_t most_cracks = 100000;  ///< of a sample, in annotations' ids

std::string lines(const std::vector<std::string>& objects) {
  std::string text;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    text += objects[i] + (i + 1 < objects.size() ? ",\n" : "\n");
  }
  return text;
}

[[noreturn]] void fail_damaged(const std::filesystem::path& part) {
  throw Error(ErrorKind::input, "cannot join a shard's boxes", part.string(),
              "they are damaged; remove that file and make the set again");
}

/// The lines of a part's images, or of its annotations.
std::string_view section(const std::string& text, bool annotations,
                         const std::filesystem::path& part) {
  const std::size_t middle = text.find(between);
  if (text.compare(0, head.size(), head) != 0 || middle == std::string::npos ||
      text.size() < middle + between.size() + tail.size()) {
    fail_damaged(part);
  }
  const std::string_view all(text);
  return annotations ? all.substr(middle + between.size(),
                                  text.size() - tail.size() - middle - between.size())
                     : all.substr(head.size(), middle - head.size());
}

}  // namespace

std::string coco_runs(const std::vector<std::uint8_t>& mask, int width, int height) {
  std::vector<std::int64_t> runs;
  std::uint8_t value = 0;
  std::int64_t run = 0;
  for (int x = 0; x < width; ++x) {
    for (int y = 0; y < height; ++y) {
      const std::uint8_t here = mask[static_cast<std::size_t>(y) * width + x];
      if (here != value) {
        runs.push_back(run);
        run = 0;
        value = here;
      }
      ++run;
    }
  }
  runs.push_back(run);
  // Five bits a letter, the sixth says that more follow; from the third run on differences.
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::int64_t x = i > 2 ? runs[i] - runs[i - 2] : runs[i];
    for (bool more = true; more;) {
      std::int64_t c = x & 31;
      x >>= 5;
      more = (c & 16) != 0 ? x != -1 : x != 0;
      if (more) c |= 32;
      text += static_cast<char>(c + 48);
    }
  }
  return text;
}

void CocoPart::add(const Sample& sample, std::uint64_t index, int width, int height) {
  images_.push_back(Json{
      {"id", index}, {"file_name", sample.id + ".image.png"}, {"width", width}, {"height", height}}
                        .dump());
  for (const SampleInstance& instance : sample.instances) {
    int x0 = width, y0 = height, x1 = 0, y1 = 0, area = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (!instance.mask[static_cast<std::size_t>(y) * width + x]) continue;
        x0 = std::min(x0, x);
        y0 = std::min(y0, y);
        x1 = std::max(x1, x + 1);
        y1 = std::max(y1, y + 1);
        ++area;
      }
    }
    annotations_.push_back(
        Json{{"id", index * most_cracks + static_cast<std::uint64_t>(instance.order)},
             {"image_id", index},
             {"category_id", 1},
             {"iscrowd", 0},
             {"area", area},
             {"bbox", {x0, y0, x1 - x0, y1 - y0}},
             {"segmentation",
              {{"size", {height, width}}, {"counts", coco_runs(instance.mask, width, height)}}}}
            .dump());
  }
}

void CocoPart::add(const std::string& text, const std::filesystem::path& name) {
  for (const bool annotations : {false, true}) {
    auto& objects = annotations ? annotations_ : images_;
    std::string_view rest = section(text, annotations, name);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      std::string_view line = rest.substr(0, end);
      if (line.ends_with(',')) line.remove_suffix(1);
      objects.emplace_back(line);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
}

std::string CocoPart::text() const {
  return std::string(head) + lines(images_) + std::string(between) + lines(annotations_) +
         std::string(tail);
}

void join_coco(const std::vector<CocoFile>& parts, const Context& context,
               const std::function<void(std::string_view)>& put) {
  put(head);
  for (const bool annotations : {false, true}) {
    if (annotations) put(between);
    bool first = true;
    for (const CocoFile& part : parts) {
      context.check();
      const std::string text = read_file(part.path, "cannot read a shard's boxes", context);
      if (sha256(text) != part.sha256) fail_damaged(part.path);
      std::string_view lines_of_part = section(text, annotations, part.path);
      if (lines_of_part.empty()) continue;
      if (!first) put(",\n");
      first = false;
      lines_of_part.remove_suffix(1);  // its last line's end
      put(lines_of_part);
    }
    if (!first) put("\n");
  }
  put(tail);
}

}  // namespace craze
