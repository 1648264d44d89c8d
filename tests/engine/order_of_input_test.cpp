// In which order a mesh lists its vertices and faces is nobody's business but the output's.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "craze/engine/cracked_surface.h"
#include "engine/mud_run.h"
#include "mesh/shuffled.h"

namespace craze {
namespace {

Result mud_on(const SurfaceMesh& mesh, const std::vector<std::string>& settings) {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.relative_spacing = 0.12;
  return crack({std::make_shared<SurfaceMesh>(mesh), {}, "mesh"}, recipe_with(settings, recipe), {},
               {});
}

/// Each piece of crack: where it ends and when it opened. Without numbers.
std::set<std::array<double, 7>> pieces(const CrackNetwork& network) {
  std::set<std::array<double, 7>> found;
  for (const CrackEdge& e : network.edges) {
    const Vec3 &a = network.nodes[e.a].position, &b = network.nodes[e.b].position;
    found.insert({a[0], a[1], a[2], b[0], b[1], b[2], e.time});
  }
  return found;
}

TEST(OrderOfInput, ChangesNoCrack) {
  struct Case {
    const char* shape;
    std::vector<std::string> settings;
  };
  const std::vector<std::string> keep = {"mesh.edge=\"keep\"", "post.relative_roughness=0"};
  const std::vector<std::string> rough = {"mesh.edge=\"keep\""};
  for (const Case& c : {Case{"plate?n=30&jitter=0.3", keep}, Case{"sphere?n=12", keep},
                        Case{"torus?n=40", rough}, Case{"sphere?n=5", {}}}) {
    const SurfaceMesh mesh = make_shape(c.shape);
    const Result plain = mud_on(mesh, c.settings);
    const Result shuffled = mud_on(test::shuffled(mesh, 3), c.settings);
    ASSERT_GT(plain.report().cracks.events, 20) << c.shape;
    EXPECT_EQ(shuffled.report().cracks.events, plain.report().cracks.events) << c.shape;
    const CrackNetwork a = crack_network(*plain.state().simulation);
    const CrackNetwork b = crack_network(*shuffled.state().simulation);
    EXPECT_EQ(pieces(a), pieces(b)) << c.shape;
  }
}

TEST(OrderOfInput, IsThatOfWhatIsKnownOfEachNodeAndFace) {
  const SurfaceMesh mesh = make_shape("sphere?n=12");
  const std::vector<std::string> settings = {"mesh.edge=\"keep\"", "material.scatter=0.2",
                                             "material.curvature_scale=\"mean\"",
                                             "evolution.max_cracks=40"};
  const Result plain = mud_on(mesh, settings);
  const Result other = mud_on(test::shuffled(mesh, 3), settings);
  const Simulation &a = *plain.state().simulation, &b = *other.state().simulation;
  const auto vertices = test::any_order(mesh.positions.size(), 3);
  const auto faces = test::any_order(mesh.triangles.size(), 4);
  std::set<double> traces;
  for (std::int32_t v = 0; v < static_cast<std::int32_t>(vertices.size()); ++v) {
    const Mat3 s = b.separation(v).matrix();
    ASSERT_EQ(s, a.separation(vertices[v]).matrix());
    ASSERT_EQ(b.residual(v).matrix(), a.residual(vertices[v]).matrix());
    ASSERT_EQ(b.displacement(v), a.displacement(vertices[v]));
    traces.insert(s.trace());
  }
  EXPECT_GT(traces.size(), vertices.size() / 2);
  ASSERT_EQ(b.toughness_scale().size(), faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    ASSERT_EQ(b.toughness_scale()[f], a.toughness_scale()[static_cast<std::size_t>(faces[f])]);
  }
}

TEST(OrderOfInput, IsThatOfTheOutput) {
  SurfaceMesh mesh = test::shuffled(make_shape("sphere?n=12"), 7);
  mesh.source_faces.clear();
  for (const char* edge : {"mesh.edge=\"keep\"", "mesh.edge=\"auto\""}) {
    const Result result = mud_on(mesh, {edge, "crack.near_vertex=\"snap\""});
    const CrackedSurface& state = result.state();
    EXPECT_EQ(state.surface->positions, mesh.positions) << edge;
    EXPECT_EQ(state.surface->triangles, mesh.triangles) << edge;
    const TriangleMesh& cut = state.mesh();
    ASSERT_GT(cut.face_count(), static_cast<std::int32_t>(mesh.triangles.size()));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      ASSERT_EQ(cut.position(static_cast<std::int32_t>(v)), mesh.positions[v]) << edge << " " << v;
    }
  }
}

}  // namespace
}  // namespace craze
