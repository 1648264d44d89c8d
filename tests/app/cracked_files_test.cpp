// A cracked file read again: its cracks are those of the run, and its seams are none.
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "craze/io/image/read_image.h"
#include "craze/read_mesh.h"

namespace craze {
namespace {

class CrackedFiles : public CommandTest {
 protected:
  /// Cracks `input` into file after file and expects the numbers of the run's report in each.
  void expect_numbers_of_the_run(const std::string& input, const Arguments& formats,
                                 const Arguments& more) {
    for (const std::string& format : formats) {
      Arguments arguments{"crack", input,      "-o",          "cut." + format, "--preset",
                          "mud",   "--report", "report.json", "--quiet"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      ASSERT_EQ(run(arguments).code, 0);
      const auto report = nlohmann::json::parse(read_text(file("report.json")))["statistics"];
      const CommandResult result = run({"stats", "cut." + format, "--json"});
      ASSERT_EQ(result.code, 0) << result.err;
      const auto read = nlohmann::json::parse(result.out);
      EXPECT_GT(report["counts"]["junctions"], 5) << input;
      EXPECT_EQ(report["counts"], read["counts"]) << input << " " << format;
      const double length = report["crack_length"];
      EXPECT_NEAR(read["crack_length"], length, (format == "glb" ? 1e-6 : 1e-12) * length);
    }
  }

  /// Two plates of quads in one file, "left" and "right", apart.
  void write_two_plates(const std::string& name, int n) {
    std::ofstream obj(file(name));
    for (int plate = 0; plate < 2; ++plate) {
      obj << "o " << (plate == 0 ? "left" : "right") << "\n";
      for (int y = 0; y <= n; ++y) {
        for (int x = 0; x <= n; ++x) {
          obj << "v " << 1.5 * plate + x / double(n) << " " << y / double(n) << " 0\n";
        }
      }
      const int first = 1 + plate * (n + 1) * (n + 1);
      for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
          const int a = first + y * (n + 1) + x;
          obj << "f " << a << " " << a + 1 << " " << a + n + 2 << " " << a + n + 1 << "\n";
        }
      }
    }
  }
};

TEST_F(CrackedFiles, StatisticsAreThoseOfTheRunThoughTexturesHaveSeams) {
  const Arguments coarse{"--set", "layer.relative_spacing=0.2"};
  expect_numbers_of_the_run("shape:cube?n=4", {"ply", "glb", "obj"}, coarse);
  expect_numbers_of_the_run("shape:torus?n=14", {"ply", "glb"}, coarse);
}

TEST_F(CrackedFiles, StatisticsAreThoseOfTheRunWhereOneSideOfACrackIsSplit) {
  expect_numbers_of_the_run("shape:plate?n=60&jitter=0.3", {"ply", "obj"},
                            {"--set", "layer.relative_spacing=0.1", "--set", "mesh.edge=\"keep\""});
}

TEST_F(CrackedFiles, PiecesAsObjectsAreParted) {
  expect_numbers_of_the_run("shape:cube?n=4", {"obj", "glb"},
                            {"--fragments", "--set", "layer.relative_spacing=0.2"});
}

TEST_F(CrackedFiles, MasksOfACubeAreThoseOfTheRun) {
  ASSERT_EQ(
      run({"crack", "shape:cube?n=4", "--preset", "mud", "--set", "layer.relative_spacing=0.15",
           "-o", "cut.ply", "--maps", "one", "--map", "mask", "--map-size", "128", "--quiet"})
          .code,
      0);
  const CommandResult result =
      run({"bake", "cut.ply", "-o", "two", "--map", "mask", "--map-size", "128", "--quiet"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Image one = read_image_file(file("one") / "mask.png"),
              two = read_image_file(file("two") / "mask.png");
  int cracked = 0, differ = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      cracked += one.value(x, y, 0) > 0.1;
      differ += std::abs(one.value(x, y, 0) - two.value(x, y, 0)) > 0.01;
    }
  }
  EXPECT_GT(cracked, 1000);
  EXPECT_LT(differ, cracked / 100);  // where faces are cut, distances are unfolded over other edges
}

TEST_F(CrackedFiles, APartOfAGlbThatNoCrackTouchesHasNone) {
  write_two_plates("two.obj", 8);
  ASSERT_EQ(run({"crack", "two.obj", "-o", "two.glb", "--max-cracks", "0", "--quiet"}).code, 0);
  expect_numbers_of_the_run(
      "two.glb", {"glb"},
      {"--set", "where.nodes=[\"right\"]", "--set", "layer.relative_spacing=0.07"});
  const SurfaceMesh mesh = read_mesh_file(file("cut.glb")).mesh;
  const Attribute* distance = find_attribute(mesh.vertex_attributes, "crack_distance");
  const Attribute* time = find_attribute(mesh.vertex_attributes, "crack_time");
  const Attribute* growth = find_attribute(mesh.vertex_attributes, "crack_growth");
  ASSERT_TRUE(distance && time && growth);
  int left = 0;
  double latest = -1;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    latest = std::max(latest, time->values[v]);
    if (mesh.positions[v].x() > 1.2) continue;
    ++left;
    EXPECT_NEAR(distance->values[v], std::sqrt(2.5 * 2.5 + 1), 1e-6) << "as in a PLY: the diagonal";
    EXPECT_EQ(time->values[v], -1);
    EXPECT_EQ(growth->values[v], -1);
  }
  EXPECT_EQ(left, 81);
  EXPECT_GT(latest, 0) << "the other has cracked";
}

/// How many faces have one colour and one label at all their corners.
int flat_faces(const SurfaceMesh& mesh) {
  const Attribute* label = find_attribute(mesh.vertex_attributes, "label");
  int flat = 0;
  for (const Triangle& t : mesh.triangles) {
    bool same = true;
    for (const std::int32_t v : t) {
      same = same && mesh.vertex_colors[v] == mesh.vertex_colors[t[0]];
      same = same && (!label || label->values[v] == label->values[t[0]]);
    }
    flat += same;
  }
  return flat;
}

TEST_F(CrackedFiles, FlatColoursAndLabelsStayFlat) {
  constexpr int n = 3;
  std::ofstream ply(file("flat.ply"));
  ply << "ply\nformat ascii 1.0\nelement vertex " << 6 * n * n
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
         "property uchar green\nproperty uchar blue\nproperty float label\nelement face "
      << 2 * n * n << "\nproperty list uchar int vertex_indices\nend_header\n";
  const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  for (int q = 0; q < n * n; ++q) {
    for (int c = 0; c < 6; ++c) {
      const int triangle = 2 * q + c / 3;
      ply << q % n + corners[c][0] << " " << q / n + corners[c][1] << " 0 "
          << (triangle % 2 ? "255 0 0 " : "0 255 0 ") << triangle << "\n";
    }
  }
  for (int f = 0; f < 2 * n * n; ++f)
    ply << "3 " << 3 * f << " " << 3 * f + 1 << " " << 3 * f + 2 << "\n";
  ply.close();
  for (const char* format : {"ply", "glb", "obj"}) {
    for (const Arguments& more :
         {Arguments{"--max-cracks", "0"}, Arguments{"--set", "layer.relative_spacing=0.1"},
          Arguments{"--set", "layer.relative_spacing=0.1", "--set", "post.gap=0.05", "--set",
                    "post.wall=0.05"}}) {
      const std::string cut = std::string("cut.") + format;
      Arguments arguments{"crack", "flat.ply", "-o", cut, "--preset", "mud", "--quiet"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      ASSERT_EQ(run(arguments).code, 0);
      const SurfaceMesh mesh = read_mesh_file(file(cut)).mesh;
      ASSERT_FALSE(mesh.vertex_colors.empty());
      EXPECT_EQ(find_attribute(mesh.vertex_attributes, "label") != nullptr, cut != "cut.obj");
      EXPECT_GE(mesh.triangles.size(), 2u * n * n);
      EXPECT_EQ(flat_faces(mesh), static_cast<int>(mesh.triangles.size())) << cut << more.back();
    }
  }
  // In OBJ a border of colours and a crack along it look the same.
  expect_numbers_of_the_run("flat.ply", {"ply", "glb"}, {"--set", "layer.relative_spacing=0.1"});
  const CommandResult result =
      run({"crack", "flat.ply", "-o", "cut.ply", "--preset", "mud", "--quiet", "--set",
           "layer.relative_spacing=0.2", "--set", "mesh.output=\"simulation\""});
  EXPECT_NE(result.err.find("vertices that lie at one place"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace craze
