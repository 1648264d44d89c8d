// The layers of the library: base < mesh < io < model < bake, render, stats, post, engine <
// scenario. A folder inside a layer belongs to it.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "source_tree.h"

namespace craze::house {
namespace {

const std::map<std::string, int> rank = {{"base", 0},   {"mesh", 1},    {"io", 2},    {"model", 3},
                                         {"bake", 4},   {"render", 4},  {"stats", 4}, {"post", 4},
                                         {"engine", 4}, {"scenario", 5}};

/// "mesh" of "craze/mesh/weld.h"; empty for headers of others.
std::string layer_of(const std::string& include) {
  if (include.rfind("craze/", 0) != 0) return "";
  return include.substr(6, include.find('/', 6) - 6);
}

/// "mesh" of the file src/craze/mesh/weld.h.
std::string layer_of(const std::filesystem::path& source) {
  return *std::filesystem::relative(source, source_dir / "src/craze").begin();
}

TEST(Includes, PointOnlyDownward) {
  for (const auto& source : sources_below("src/craze")) {
    const std::string layer = layer_of(source);
    ASSERT_TRUE(rank.count(layer)) << source << ": a folder without a place among the layers";
    for (const std::string& include : includes_of(source)) {
      const std::string used = layer_of(include);
      if (used.empty()) continue;
      ASSERT_TRUE(rank.count(used)) << source << " includes " << include;
      EXPECT_LE(rank.at(used), rank.at(layer)) << source << " includes " << include;
    }
  }
}

TEST(Includes, OfLayersSideBySideFormNoCircle) {
  std::map<std::string, std::set<std::string>> uses;
  for (const auto& source : sources_below("src/craze")) {
    const std::string layer = layer_of(source);
    for (const std::string& include : includes_of(source)) {
      const std::string used = layer_of(include);
      if (!used.empty() && used != layer) uses[layer].insert(used);
    }
  }
  for (std::size_t pass = 0; pass < rank.size(); ++pass) {  // what is used by what is used
    for (auto& [layer, used] : uses) {
      const std::set<std::string> direct = used;
      for (const std::string& other : direct) used.insert(uses[other].begin(), uses[other].end());
    }
  }
  EXPECT_EQ(uses["scenario"].size(), rank.size() - 2);  // all but itself and engine
  for (const auto& [layer, used] : uses) EXPECT_FALSE(used.count(layer)) << layer;
}

TEST(Includes, OfHeadersNeedOnlyTheStandardLibraryEigenAndJson) {
  for (const auto& header : sources_below("src/craze")) {
    if (header.extension() != ".h") continue;
    for (const std::string& include : includes_of(header)) {
      const bool standard = include.find_first_of("/.") == std::string::npos;
      const bool known = include.rfind("craze/", 0) == 0 || include.rfind("Eigen/", 0) == 0 ||
                         include.rfind("nlohmann/", 0) == 0 ||
                         include.rfind("sanitizer/", 0) == 0;  // comes with the compiler
      EXPECT_TRUE(standard || known) << header << " includes " << include;
    }
  }
}

// Then every such header is compiled first in its file, with nothing before it to lean on.
TEST(Includes, OfASourceBeginWithItsOwnHeader) {
  for (const auto& source : sources_below("src/craze")) {
    auto header = source;
    header.replace_extension(".h");
    if (source.extension() != ".cpp" || !std::filesystem::exists(header)) continue;
    const std::string own = std::filesystem::relative(header, source_dir / "src");
    const auto includes = includes_of(source);
    ASSERT_FALSE(includes.empty()) << source;
    EXPECT_EQ(includes.front(), own) << source;
  }
}

// What WebAssembly's older standard library lacks stays out of what is compiled to it.
TEST(TheCore, UsesNoHeaderMissingFromLibcxx13) {
  const std::set<std::string> missing = {"bit",        "format",    "ranges", "source_location",
                                         "stop_token", "syncstream"};
  for (const std::string folder : {"base", "mesh", "model"}) {
    for (const auto& source : sources_below("src/craze/" + folder)) {
      for (const std::string& include : includes_of(source)) {
        EXPECT_FALSE(missing.count(include)) << source << " includes " << include;
      }
    }
  }
}

}  // namespace
}  // namespace craze::house
