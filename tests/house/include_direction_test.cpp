// The rooms of the library and what each may know: arrows point down only.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "source_tree.h"

namespace craze::house {
namespace {

/// What the sources of a room may include besides their own room.
const std::map<std::string, std::set<std::string>> may_use = {
    {"base", {}},
    {"mesh", {"base"}},
    {"model", {"base", "mesh"}},
    {"recipe", {"base", "mesh", "model"}},
    {"engine", {"base", "mesh", "model", "recipe"}},
    {"material", {"base"}},
    {"products", {"base", "mesh", "model", "recipe", "engine", "material"}},
    {"io", {"base", "mesh"}},
    {"output", {"base", "mesh", "model", "recipe", "engine", "products", "io"}},
    {"render", {"base", "mesh", "model", "products", "material", "io"}},
    {"job",
     {"base", "mesh", "model", "recipe", "engine", "products", "material", "io", "output",
      "render"}},
};

/// The room that each public header, include/craze/NAME.h, is the door of.
const std::map<std::string, std::string> door_of = {
    {"context", "base"},       {"error", "base"},          {"grey_image", "base"},
    {"length", "base"},        {"tensor", "base"},         {"threads", "base"},
    {"line_set", "mesh"},      {"repair", "mesh"},         {"shapes", "mesh"},
    {"surface_mesh", "mesh"},  {"up_axis", "mesh"},        {"collider", "mesh"},
    {"parameters", "model"},   {"presets", "recipe"},      {"recipe", "recipe"},
    {"engine", "engine"},      {"report", "engine"},       {"products", "products"},
    {"maps", "products"},      {"surface_origin", "mesh"}, {"material_look", "io"},
    {"read_mesh", "io"},       {"write_mesh", "io"},       {"craze", "bindings"},
    {"opened_piece", "model"}, {"texture_wrap", "base"},
};

/// "mesh" of "craze/mesh/weld.h" and of "craze/surface_mesh.h"; empty for headers of others.
std::string room_of(const std::string& include) {
  if (include.rfind("craze/", 0) != 0) return "";
  const std::string rest = include.substr(6);
  const auto slash = rest.find('/');
  if (slash != std::string::npos) return rest.substr(0, slash);
  const auto door = door_of.find(rest.substr(0, rest.find('.')));
  return door == door_of.end() ? "a header that no room has" : door->second;
}

/// "mesh" of the source src/craze/mesh/…/weld.cpp.
std::string room_of_source(const std::filesystem::path& source) {
  return room_of(std::filesystem::relative(source, source_dir / "src"));
}

TEST(Includes, PointOnlyDownward) {
  for (const auto& source : sources_below("src/craze")) {
    const std::string room = room_of_source(source);
    ASSERT_TRUE(may_use.count(room)) << source << ": a folder without a place in the house";
    for (const std::string& include : includes_of(source)) {
      const std::string used = room_of(include);
      if (used.empty() || used == room) continue;
      EXPECT_TRUE(may_use.at(room).count(used)) << source << " includes " << include;
    }
  }
}

TEST(TheHouse, HasNoCircle) {
  for (const auto& [room, used] : may_use) {
    for (const std::string& below : used) {
      EXPECT_FALSE(may_use.at(below).count(room)) << room << " and " << below;
      for (const std::string& deeper : may_use.at(below)) {
        EXPECT_FALSE(deeper == room) << room << " uses " << below << ", which uses " << deeper;
      }
    }
  }
}

// A folder that holds more is one whose ideas have no names of their own yet.
TEST(TheHouse, HasNoFolderOfFortyFiles) {
  std::map<std::filesystem::path, int> count;
  for (const auto& source : sources_below("src")) ++count[source.parent_path()];
  for (const auto& [folder, files] : count) EXPECT_LT(files, 40) << folder;
}

// The one header of ours that brings fmt, for sources alone.
const std::filesystem::path formatting = source_dir / "src/craze/base/text/format.h";

TEST(Includes, OfHeadersNeedOnlyTheStandardLibraryEigenJsonAndToml) {
  for (const auto& header : sources_below("src/craze")) {
    if (header.extension() != ".h") continue;
    for (const std::string& include : includes_of(header)) {
      const bool standard = include.find_first_of("/.") == std::string::npos;
      const bool known = include.rfind("craze/", 0) == 0 || include.rfind("Eigen/", 0) == 0 ||
                         include.rfind("nlohmann/", 0) == 0 || include.rfind("toml++/", 0) == 0 ||
                         include.rfind("sanitizer/", 0) == 0;  // comes with the compiler
      const bool door = header == formatting && include == "fmt/format.h";
      EXPECT_TRUE(standard || known || door) << header << " includes " << include;
      EXPECT_NE(source_dir / "src" / include, formatting) << header << " brings fmt";
    }
  }
}

TEST(Includes, OfFmtsFormattingGoThroughOneHeader) {
  for (const char* folder : {"src", "apps", "bindings", "tests", "benchmarks", "fuzz"}) {
    for (const auto& source : sources_below(folder)) {
      if (source == formatting) continue;
      for (const std::string& include : includes_of(source)) {
        EXPECT_NE(include, "fmt/format.h") << source << " compiles it anew";
      }
    }
  }
}

// Whoever installs craze needs nothing else to compile against it.
TEST(Includes, OfPublicHeadersNeedOnlyTheStandardLibraryEigenAndEachOther) {
  for (const auto& header : sources_below("include/craze")) {
    const std::string room = room_of("craze/" + header.filename().string());
    for (const std::string& include : includes_of(header)) {
      const bool standard = include.find('/') == std::string::npos;
      const bool eigen = include.rfind("Eigen/", 0) == 0;
      const bool own = std::filesystem::exists(source_dir / "include" / include);
      EXPECT_TRUE(standard || eigen || own) << header << " includes " << include;
      if (!own) continue;
      const std::string used = room_of(include);
      EXPECT_TRUE(used == room || may_use.at(room).count(used)) << header << ": " << include;
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
  for (const std::string folder : {"base", "mesh", "model", "recipe", "engine", "products"}) {
    for (const auto& source : sources_below("src/craze/" + folder)) {
      for (const std::string& include : includes_of(source)) {
        EXPECT_FALSE(missing.count(include)) << source << " includes " << include;
      }
    }
  }
}

}  // namespace
}  // namespace craze::house
