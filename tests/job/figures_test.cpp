#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "craze/error.h"
#include "craze/job/figure_run.h"
#include "craze/job/figure_table.h"
#include "craze/job/snapping_diagram.h"
#include "craze/shapes.h"
#include "temporary_folder.h"

namespace craze {
namespace {

TEST(Figures, AllTwelveOfThePaperAreThere) {
  std::set<int> numbers;
  std::set<std::string_view> names;
  for (const Figure& figure : figure_table()) {
    numbers.insert(figure.number);
    names.insert(figure.name);
    EXPECT_EQ(&find_figure(std::string(figure.name)), &figure);
    EXPECT_EQ(&find_figure(std::to_string(figure.number)), &figure);
  }
  EXPECT_EQ(numbers, (std::set<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(names.size(), numbers.size());
}

TEST(Figures, AMisspeltNameIsMet) {
  try {
    find_figure("dargon");
    FAIL();
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "unknown figure (dargon): did you mean dragon?");
    EXPECT_EQ(e.kind(), ErrorKind::usage);
  }
}

TEST(Figures, EveryRecipeIsReadableAndUsedAndEveryFigureHasItsOwn) {
  std::set<std::string_view> used;
  for (const Figure& figure : figure_table()) {
    EXPECT_EQ(figure.recipes.empty(), figure.kind == FigureKind::diagram) << figure.name;
    used.insert(figure.recipes.begin(), figure.recipes.end());
  }
  std::set<std::string_view> there;
  for (const Preset& recipe : figure_recipes()) {
    there.insert(recipe.name);
    EXPECT_NO_THROW(read_recipe(recipe.text, std::string(recipe.name))) << recipe.name;
    EXPECT_GT(recipe.description().size(), 10u) << recipe.name;
  }
  EXPECT_EQ(used, there);
}

TEST(Figures, ShapesHaveThePapersTrianglesWithinTwoPercent) {
  for (const Figure& figure : figure_table()) {
    if (figure.paper_triangles == 0) continue;
    const std::string shape(figure.shape.substr(figure.shape.find(':') + 1));
    const auto triangles = static_cast<double>(make_shape(shape).triangles.size());
    EXPECT_NEAR(triangles / figure.paper_triangles, 1, 0.02) << figure.name << " " << triangles;
  }
}

TEST(Figures, TheRecipesHoldWhatThePaperStates) {
  const auto recipe = [](std::string_view name) {
    return read_recipe(find_figure_recipe(name).text, std::string(name)).simulation;
  };
  EXPECT_EQ(recipe("mud_straight").material.alpha, 0.85);
  EXPECT_EQ(recipe("mud_jagged").material.alpha, 0.5);
  EXPECT_EQ(recipe("mud_curled").material.alpha, 0.5);
  EXPECT_EQ(recipe("bunny_curvature").material.curvature_scale, CurvatureScale::frobenius);
  EXPECT_EQ(recipe("bunny_uniform").material.curvature_scale, CurvatureScale::none);
  EXPECT_EQ(recipe("horse").material.curvature_scale, CurvatureScale::sum_of_squares);
  EXPECT_GT(recipe("statue").material.bias, 0);
}

class FigureFolder : public testing::Test {
 protected:
  FigureFolder() {
    request_.folder = (folder_ / "new").string();
    request_.size = 64;
    request_.settings = {"evolution.max_cracks=2"};
  }
  void expect_files(const FigureResult& result) const {
    for (const FigurePart& part : result.parts) {
      for (const std::string& picture : part.pictures) {
        EXPECT_TRUE(std::filesystem::exists(folder_ / "new" / picture)) << picture;
      }
    }
  }

  TemporaryFolder folder_;
  FigureRequest request_;
};

TEST_F(FigureFolder, AFigureLeavesItsPicturesAndReportAndSaysHowItWasMade) {
  const FigureResult glass = make_figure(find_figure("glass"), request_, {});
  ASSERT_EQ(glass.parts.size(), 1u);
  expect_files(glass);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "new" / "glass.json"));
  EXPECT_FALSE(glass.stands_in);
  EXPECT_EQ(glass.parts[0].triangles, 4802);
  const std::string page = figure_page({glass});
  EXPECT_NE(page.find("craze crack 'shape:plate?n=49&jitter=0.3' --recipe "
                      "recipes/figures/glass.toml --set 'evolution.max_cracks=2'"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("| 4802 | 4804 |"), std::string::npos) << page;
  EXPECT_NE(page.find("| 20 seconds |"), std::string::npos) << page;
}

TEST_F(FigureFolder, TheUsersMeshIsTakenAndAShapeStandsInWhereItIsMissing) {
  request_.meshes = folder_.path().string();
  std::ofstream(folder_ / "horse_30k.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  request_.settings = {"evolution.max_cracks=1", "layer.relative_spacing=0"};
  const FigureResult mine = make_figure(find_figure("horse"), request_, {});
  EXPECT_FALSE(mine.stands_in);
  EXPECT_EQ(mine.parts[0].triangles, 1);
  EXPECT_NE(mine.parts[0].command.find("MESHES/horse_30k.obj"), std::string::npos);
  std::filesystem::remove(folder_ / "horse_30k.obj");
  const FigureResult shape = make_figure(find_figure("horse"), request_, {});
  EXPECT_TRUE(shape.stands_in);
  EXPECT_NE(figure_page({shape}).find("stands in for horse_30k.obj"), std::string::npos);
}

TEST_F(FigureFolder, FramesAreOnePerStep) {
  const FigureResult drying = make_figure(find_figure("drying"), request_, {});
  ASSERT_EQ(drying.parts.size(), 1u);
  EXPECT_GT(drying.parts[0].pictures.size(), 3u);
  expect_files(drying);
}

TEST_F(FigureFolder, TheDiagramNeedsNoRun) {
  const FigureResult snapping = make_figure(find_figure("5"), request_, {});
  expect_files(snapping);
  EXPECT_EQ(snapping.parts[0].triangles, 0);
}

/// The data of the paths of one class in a panel's states, in drawing order.
std::vector<std::string> paths(const std::string& svg, const std::string& kind) {
  std::vector<std::string> found;
  const std::string start = "<path class=\"" + kind + "\" d=\"";
  for (auto at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    const auto begin = at + start.size();
    found.push_back(svg.substr(begin, svg.find('"', begin) - begin));
  }
  return found;
}

std::ptrdiff_t pieces(const std::string& path) {
  return std::count(path.begin(), path.end(), 'M');
}

TEST(SnappingDiagram, DrawsTheMeshesBeforeAndAfterEachRule) {
  const std::string svg = snapping_diagram();
  const auto edges = paths(svg, "edge");
  const auto cracks = paths(svg, "crack");
  ASSERT_EQ(edges.size(), 6u);
  ASSERT_EQ(cracks.size(), 4u) << "three after, and the older crack before";
  // Two sides per cut edge. Through triangles: both ways. Snapped: both ways, one along an edge.
  EXPECT_EQ(pieces(cracks[0]), 4);
  EXPECT_EQ(pieces(cracks[1]), 4);
  // The older crack, then one segment more: the one back along it is dropped.
  EXPECT_EQ(pieces(cracks[2]), 4);
  EXPECT_EQ(pieces(cracks[3]), 6);
  // A crack through a triangle leaves two uncut edges more, one along an edge takes that away.
  EXPECT_EQ(pieces(edges[1]) - pieces(edges[0]), 2 + 2);
  EXPECT_EQ(pieces(edges[3]) - pieces(edges[2]), 2 - 1);
  EXPECT_EQ(pieces(edges[5]) - pieces(edges[4]), 2);
}

}  // namespace
}  // namespace craze
