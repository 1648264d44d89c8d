// with_post: a finished run with another [post].
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/simulation_surface.h"
#include "craze/error.h"
#include "craze/products.h"
#include "mud_run.h"

namespace craze {
namespace {

using test::mud_run;
using test::plate;

/// All that a result and its opening hold, as text.
std::string all_of(const Result& result) {
  Report report = result.report();
  report.time = {};
  std::string all = statistics_json(result);
  for (const std::string& warning : report.warnings) all += warning;
  all += write_recipe(report.recipe);
  const auto add = [&all](const auto& values) {
    all.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
  };
  const LineSet lines = crack_lines(result);
  add(lines.points);
  add(lines.edges);
  const Opening opening(result, report.recipe.post, {});
  const SurfaceMesh& mesh = opening.mesh();
  add(mesh.positions);
  add(mesh.triangles);
  for (const Attribute& a : mesh.vertex_attributes) add(a.values);
  add(mesh.corner_uvs);
  add(opening.origin().face);
  add(opening.origin().weights);
  for (const auto x : {report.output.vertices, report.output.triangles, report.cracks.fragments,
                       report.carried.split_triangles, report.carried.added_triangles,
                       report.carried.lost_pieces}) {
    all += std::to_string(x) + ",";
  }
  return all + std::to_string(report.cracks.length);
}

TEST(WithPost, IsWhatARunWithItIsToTheByte) {
  // On its own triangles, on a finer mesh, on a scan, and on the mesh of the simulation.
  const std::vector<std::vector<std::string>> runs = {
      {plate, "mesh.edge=keep"},
      {"cup?n=40", "layer.spacing=0.4"},
      {"cup?n=90", "layer.spacing=0.9", "evolution.max_cracks=12"},
      {"cup?n=24", "layer.spacing=0.4", "mesh.output=simulation"}};
  const std::vector<std::vector<std::string>> posts = {
      {"post.roughness=1%", "post.gap_width=0.3%"},
      {"post.relative_roughness=0.06", "post.roughness_exponent=0.6", "post.gap=0.05"},
      {"post.wall=0.01", "post.gap_width=0.005", "post.late_width=0.4"}};
  for (const std::vector<std::string>& run : runs) {
    const auto run_with = [&](const std::vector<std::string>& post) {
      std::vector<std::string> settings(run.begin() + 1, run.end());
      settings.insert(settings.end(), post.begin(), post.end());
      return mud_run(run[0], settings);
    };
    std::vector<Result> fresh;
    std::vector<std::string> bytes;
    for (const std::vector<std::string>& post : posts) {
      fresh.push_back(run_with(post));
      bytes.push_back(all_of(fresh.back()));
    }
    EXPECT_NE(bytes[0], bytes[1]);
    Recipe smooth = read_preset("mud");
    smooth.post.relative_roughness = 0;  // as mud_run() has it
    const bool is_scan = run[0] == "cup?n=90";
    EXPECT_EQ(smooth_asset(*fresh[0].state().surface, fresh[0].report().recipe).empty(), !is_scan);
    for (std::size_t from = 0; from < posts.size(); ++from) {
      for (std::size_t to = 0; to < posts.size(); ++to) {
        PostParameters post = recipe_with(posts[to], smooth).post;
        const Result changed = with_post(fresh[from], post, {});
        EXPECT_EQ(all_of(changed) == bytes[to], true) << run[0] << " " << from << " → " << to;
        EXPECT_EQ(changed.state().simulation, fresh[from].state().simulation);
        EXPECT_EQ(changed.state().surface, fresh[from].state().surface);
        EXPECT_EQ(&changed.state() == &fresh[from].state(), from == to);
        EXPECT_EQ(&with_post(fresh[from], post, {}, &changed).state(), &changed.state());
      }
    }
  }
}

TEST(WithPost, RefusesWhatARunRefuses) {
  const Result result = mud_run(plate, {"evolution.max_cracks=3"});
  PostParameters post;
  post.gap = 0.1;
  post.gap_width = 0.1;
  EXPECT_THROW(with_post(result, post, {}), Error);
  post = recipe_with({"post.roughness=2mm"}).post;
  EXPECT_THROW(with_post(result, post, {}), Error);  // the unit is not known
}

}  // namespace
}  // namespace craze
