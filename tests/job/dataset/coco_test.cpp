#include "craze/job/dataset/shards/coco.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "craze/base/random.h"
#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "temporary_folder.h"

namespace craze {
namespace {

/// The other way round, as the format's description has it: five bits a letter from the low end,
/// the sixth for more, the sign in the last one's fifth.
std::vector<std::uint8_t> unpacked(const std::string& text, int width, int height) {
  std::vector<long> runs;
  for (std::size_t i = 0; i < text.size();) {
    long x = 0;
    int k = 0, c = 0;
    do {
      c = text[i++] - 48;
      x |= static_cast<long>(c & 31) << (5 * k++);
    } while (c & 32);
    if (c & 16) x |= -1L << (5 * k);
    if (runs.size() > 2) x += runs[runs.size() - 2];
    runs.push_back(x);
  }
  std::vector<std::uint8_t> down;  // the columns
  for (std::size_t r = 0; r < runs.size(); ++r) down.insert(down.end(), runs[r], r % 2);
  std::vector<std::uint8_t> mask(down.size());
  for (int x = 0; x < width; ++x) {
    for (int y = 0; y < height; ++y) mask[y * width + x] = down[x * height + y];
  }
  return mask;
}

TEST(Coco, RunsUnpackToTheMask) {
  Random random(3);
  for (const double share : {0.0, 0.02, 0.5, 1.0}) {
    std::vector<std::uint8_t> mask(60 * 45);
    for (auto& m : mask) m = random.uniform() < share ? 1 : 0;
    EXPECT_EQ(unpacked(coco_runs(mask, 60, 45), 60, 45), mask) << share;
  }
}

Sample sample(std::uint64_t index, int cracks) {
  Sample s;
  s.id = sample_id(index);
  for (int c = 1; c <= cracks; ++c) {
    SampleInstance instance{c, std::vector<std::uint8_t>(12, 0)};
    instance.mask[c] = instance.mask[c + 4] = 1;
    s.instances.push_back(instance);
  }
  return s;
}

TEST(Coco, PartsJoinToWhatOnePartWouldBe) {
  const TemporaryFolder folder;
  CocoPart all, copied;
  std::vector<CocoFile> parts;
  const int cracks[] = {0, 2, 0, 1, 0};
  for (std::uint64_t i = 0; i < 5; ++i) {
    CocoPart part;
    part.add(sample(i, cracks[i]), i, 4, 3);
    all.add(sample(i, cracks[i]), i, 4, 3);
    copied.add(part.text(), "part");
    parts.push_back({folder / std::to_string(i), sha256(part.text())});
    std::ofstream(parts.back().path) << part.text();
  }
  std::string joined;
  const auto put = [&](std::string_view piece) { joined += piece; };
  join_coco(parts, {}, put);
  EXPECT_EQ(joined, all.text());
  EXPECT_EQ(copied.text(), all.text());
  const auto json = nlohmann::json::parse(joined);
  EXPECT_EQ(json["images"].size(), 5u);
  ASSERT_EQ(json["annotations"].size(), 3u);
  EXPECT_EQ(json["annotations"][0]["bbox"], (nlohmann::json{1, 0, 1, 2}));
  EXPECT_EQ(json["annotations"][2]["image_id"], 3);
  parts[1].sha256 = parts[0].sha256;
  EXPECT_THROW(join_coco(parts, {}, put), Error) << "of other bytes";
}

}  // namespace
}  // namespace craze
