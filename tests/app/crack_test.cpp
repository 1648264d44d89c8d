#include <chrono>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "app/command.h"
#include "craze/read_mesh.h"
#include "craze/surface_mesh.h"

namespace craze {
namespace {

// A small plate that cracks within a fraction of a second.
const Arguments small_run{
    "crack", "shape:plate?n=16&jitter=0.3", "--set", "material.toughness=0.06",
    "--set", "material.alpha=0.8",          "--set", "evolution.shrinkage=0.05",
    "--set", "evolution.relaxation_steps=4"};

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

class Crack : public CommandTest {
 protected:
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "run")) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }
};

TEST_F(Crack, WritesWhatIsAskedForAndNothingElse) {
  const CommandResult result = run(with(
      small_run, {"-o", "a.glb", "--lines", "l.svg", "--report", "r.json", "--fields", "f.ply"}));
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_EQ(files(), (std::set<std::string>{"a.glb", "f.ply", "l.svg", "r.json"}));
}

TEST_F(Crack, TheReportHasTheKeysOfTheContract) {
  const CommandResult result = run(with(small_run, {"--report", "-"}));
  ASSERT_EQ(result.code, 0) << result.err;
  const auto report = nlohmann::json::parse(result.out);
  for (const char* key : {"version", "seed", "threads", "engine", "load", "stop_reason",
                          "statistics", "recipe", "repair"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  for (const char* mesh : {"input", "simulation", "output"}) {
    EXPECT_GE(report[mesh]["vertices"], 17 * 17);
    EXPECT_GE(report[mesh]["triangles"], 2 * 16 * 16);
  }
  for (const char* key : {"total", "load", "prepare", "relax", "separation", "crack", "write"}) {
    EXPECT_GE(report["time"][key], 0.0) << key;
  }
  EXPECT_GT(report["cracks"]["events"], 0);
  EXPECT_GE(report["cracks"]["segments"], report["cracks"]["events"]);
  EXPECT_GT(report["cracks"]["length"], 0.0);
  EXPECT_GE(report["cracks"]["fragments"], 1);
  EXPECT_EQ(report["recipe"]["material"]["alpha"], 0.8);
}

TEST_F(Crack, TheSameBytesOnAnyNumberOfThreads) {
  ASSERT_EQ(run(with(small_run, {"-o", "a.ply", "--threads", "1"})).code, 0);
  ASSERT_EQ(run(with(small_run, {"-o", "b.ply", "--threads", "3"})).code, 0);
  EXPECT_EQ(read_text(file("a.ply")), read_text(file("b.ply")));
  ASSERT_EQ(run(with(small_run, {"-o", "c.ply", "--seed", "2"})).code, 0);
  EXPECT_NE(read_text(file("a.ply")), read_text(file("c.ply"))) << "the seed does nothing";
}

TEST_F(Crack, TheMeshCarriesCrackAndInputAttributes) {
  ASSERT_EQ(run(with(small_run, {"-o", "a.ply"})).code, 0);
  const SurfaceMesh mesh = read_mesh_file(file("a.ply")).mesh;
  EXPECT_FALSE(mesh.corner_uvs.empty());
  const Attribute* distance = find_attribute(mesh.vertex_attributes, "crack_distance");
  const Attribute* time = find_attribute(mesh.vertex_attributes, "crack_time");
  const Attribute* displacement = find_attribute(mesh.vertex_attributes, "displacement");
  const Attribute* fragment = find_attribute(mesh.face_attributes, "fragment");
  const Attribute* source = find_attribute(mesh.face_attributes, "source_face");
  const Attribute* growth = find_attribute(mesh.vertex_attributes, "crack_growth");
  ASSERT_TRUE(distance && time && growth && displacement && fragment && source);
  EXPECT_EQ(displacement->components, 3);
  int on_cracks = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_GE(distance->values[v], 0);
    if (distance->values[v] == 0) {
      ++on_cracks;
      EXPECT_GE(time->values[v], 0);
      EXPECT_GE(growth->values[v], 0);
      EXPECT_LE(growth->values[v], 1);
    }
  }
  EXPECT_GT(on_cracks, 0);
  for (const double f : source->values) EXPECT_LT(f, 2 * 16 * 16);
}

TEST_F(Crack, BeforeTheFirstCrackTheFieldsAreThoseOfTheRecipe) {
  ASSERT_EQ(run({"crack", "shape:plate?n=8", "--fields", "f.ply", "--max-cracks", "0", "--set",
                 "stress.noise=0", "--set", "stress.uniform=2"})
                .code,
            0);
  const SurfaceMesh mesh = read_mesh_file(file("f.ply")).mesh;
  EXPECT_EQ(mesh.triangles.size(), 2u * 8 * 8);
  const auto value = [&](const std::vector<Attribute>& attributes, const char* name,
                         std::size_t i) {
    const Attribute* a = find_attribute(attributes, name);
    return a ? a->values[i] : NAN;
  };
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    EXPECT_NEAR(value(mesh.face_attributes, "s_xx", f), 2, 1e-12);
    EXPECT_NEAR(value(mesh.face_attributes, "s_yy", f), 2, 1e-12);
    EXPECT_NEAR(value(mesh.face_attributes, "s_zz", f), 0, 1e-12);
    EXPECT_NEAR(value(mesh.face_attributes, "s_xy", f), 0, 1e-12);
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    const bool inside = std::max(std::abs(p.x()), std::abs(p.y())) < 0.49;
    const double force =
        std::hypot(value(mesh.vertex_attributes, "fx", v), value(mesh.vertex_attributes, "fy", v));
    if (inside) {
      EXPECT_NEAR(force, 0, 1e-12) << "uniform tension is in equilibrium";
    }
    EXPECT_EQ(value(mesh.vertex_attributes, "ux", v), 0);
    EXPECT_NEAR(value(mesh.vertex_attributes, "k1", v), 0, 1e-9);
  }
}

TEST_F(Crack, TheFieldsAreThoseAtTheLoadOfTheReport) {
  const CommandResult result = run({"crack",        "shape:plate?n=40&jitter=0.3",
                                    "--fields",     "f.ply",
                                    "-o",           "a.ply",
                                    "--report",     "-",
                                    "--max-cracks", "1",
                                    "--set",        "stress.noise=0",
                                    "--set",        "stress.uniform=2",
                                    "--set",        "mesh.edge=keep",
                                    "--set",        "layer.screening_length=0.04",
                                    "--set",        "material.criterion=strength",
                                    "--set",        "material.strength=3"});
  ASSERT_EQ(result.code, 0) << result.err;
  const double load = nlohmann::json::parse(result.out)["load"];
  EXPECT_GT(load, 1.3);
  const SurfaceMesh fields = read_mesh_file(file("f.ply")).mesh,
                    mesh = read_mesh_file(file("a.ply")).mesh;
  const Attribute* distance = find_attribute(mesh.vertex_attributes, "crack_distance");
  const Attribute* stress = find_attribute(fields.face_attributes, "s_xx");
  ASSERT_TRUE(distance && stress);
  int far = 0;
  for (std::size_t f = 0; f < fields.triangles.size(); ++f) {
    double border = 1, crack = 1;
    for (const std::int32_t v : fields.triangles[f]) {
      const Vec3& p = fields.positions[v];
      border = std::min(border, 0.5 - std::max(std::abs(p.x()), std::abs(p.y())));
      crack = std::min(crack, distance->values[v]);
    }
    if (std::min(border, crack) < 0.25) continue;
    EXPECT_NEAR(stress->values[f] / (2 * load), 1, 0.01) << "far from all that unloads it";
    ++far;
  }
  EXPECT_GT(far, 20);
  // And the gap's displacement is that of the fields.
  const Attribute* displacement = find_attribute(mesh.vertex_attributes, "displacement");
  const Attribute* ux = find_attribute(fields.vertex_attributes, "ux");
  ASSERT_TRUE(displacement && ux);
  for (std::size_t v = 0; v < ux->values.size(); ++v) {
    ASSERT_EQ(displacement->values[3 * v], ux->values[v]);
  }
}

TEST_F(Crack, CtrlCWritesWhatThereIsAndExitsWith130) {
  // Never cracks and never ends.
  const pid_t process =
      start({"crack", "shape:plate?n=20", "-o", "a.ply", "--report", "r.json", "--set",
             "material.toughness=1e6", "--set", "evolution.shrinkage=1e-8"});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  kill(process, SIGINT);
  const CommandResult result = finish(process);
  EXPECT_EQ(result.code, 130);
  EXPECT_EQ(files(), (std::set<std::string>{"a.ply", "r.json"}));
  EXPECT_EQ(nlohmann::json::parse(read_text(file("r.json")))["stop_reason"], "cancelled");
  EXPECT_EQ(read_mesh_file(file("a.ply")).mesh.triangles.size(), 2u * 20 * 20);
}

TEST_F(Crack, GapsAndWallsCloseTheSurfaceAgain) {
  ASSERT_EQ(run(with(small_run, {"-o", "shut.ply", "--set", "post.gap=0"})).code, 0);
  ASSERT_EQ(
      run(with(small_run, {"-o", "open.ply", "--set", "post.gap=0.2", "--set", "post.wall=0.1"}))
          .code,
      0);
  const SurfaceMesh shut = read_mesh_file(file("shut.ply")).mesh,
                    open = read_mesh_file(file("open.ply")).mesh;
  EXPECT_GT(open.triangles.size(), shut.triangles.size());
  EXPECT_EQ(open.material_names, std::vector<std::string>{"crack_wall"});
  EXPECT_EQ(open.corner_uvs.size(), 3 * open.triangles.size());
  const Attribute* source = find_attribute(open.face_attributes, "source_face");
  ASSERT_TRUE(source);
  for (std::size_t f = 0; f < open.triangles.size(); ++f) {
    EXPECT_EQ(open.face_materials[f] == 0, source->values[f] < 0);
  }
}

}  // namespace
}  // namespace craze
