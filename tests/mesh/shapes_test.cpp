#include "craze/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "craze/error.h"
#include "craze/mesh/mesh_summary.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/validate.h"

namespace craze {
namespace {

constexpr double pi = std::numbers::pi;

MeshSummary summary_of(const SurfaceMesh& s) {
  const TriangleMesh mesh(s.positions, s.triangles);
  EXPECT_TRUE(validate(mesh).empty());
  return summarize(mesh);
}

MeshSummary summary_of(const std::string& shape) {
  return summary_of(make_shape(shape));
}

std::string message_of(const std::string& shape) {
  try {
    make_shape(shape);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::usage);
    return e.what();
  }
  ADD_FAILURE() << shape << " was accepted";
  return "";
}

TEST(Shapes, APlateHasExactlyTwoNSquaredTrianglesAndUnitArea) {
  for (const int n : {1, 2, 7, 99}) {
    for (const std::string jitter : {"0", "0.3", "0.45"}) {
      const MeshSummary s =
          summary_of("plate?n=" + std::to_string(n) + "&jitter=" + jitter + "&seed=5");
      EXPECT_EQ(s.faces, 2 * n * n);
      EXPECT_NEAR(s.area, 1, 1e-12);
      EXPECT_EQ(s.boundary_loops, 1);
      EXPECT_EQ(s.euler_characteristic, 1);
    }
  }
}

TEST(Shapes, AJitteredPlateFacesUpEverywhereAndKeepsItsBorder) {
  for (const std::string seed : {"1", "2", "3", "4"}) {
    const SurfaceMesh s = make_shape("plate?n=40&size=2&jitter=0.45&seed=" + seed);
    for (const Triangle& t : s.triangles) {
      const Vec3 n =
          (s.positions[t[1]] - s.positions[t[0]]).cross(s.positions[t[2]] - s.positions[t[0]]);
      EXPECT_GT(n.z(), 0);
    }
    const SurfaceMesh regular = make_shape("plate?n=40&size=2");
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      for (int axis = 0; axis < 2; ++axis) {
        if (std::abs(regular.positions[v][axis]) == 1) {
          EXPECT_EQ(s.positions[v][axis], regular.positions[v][axis]);
        }
      }
    }
    EXPECT_NE(s.positions, regular.positions);
  }
}

TEST(Shapes, TheSeedDecidesTheJitter) {
  EXPECT_EQ(make_shape("plate?jitter=0.3&seed=4").positions,
            make_shape("plate?jitter=0.3&seed=4").positions);
  EXPECT_NE(make_shape("plate?jitter=0.3&seed=4").positions,
            make_shape("plate?jitter=0.3&seed=5").positions);
}

TEST(Shapes, TheRegularGridPrefersNoDiagonal) {
  const SurfaceMesh s = make_shape("plate?n=10");
  Vec2 sum = Vec2::Zero();  // double-angle sum of the edges: 0 without a preferred direction
  for (const Triangle& t : s.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 e = s.positions[t[(i + 1) % 3]] - s.positions[t[i]];
      sum += Vec2(e.x() * e.x() - e.y() * e.y(), 2 * e.x() * e.y());
    }
  }
  EXPECT_NEAR(sum.norm(), 0, 1e-12);
}

TEST(Shapes, RoundShapesHaveTheAreaAndVolumeOfTheSmoothOnes) {
  const double r = 0.8, h = 1.7;
  MeshSummary s = summary_of("sphere?n=24&radius=0.8");
  EXPECT_EQ(s.faces, 20 * 24 * 24);
  EXPECT_NEAR(s.area / (4 * pi * r * r), 1, 3e-3);
  EXPECT_NEAR(s.volume / (4 * pi * r * r * r / 3), 1, 3e-3);

  s = summary_of("cylinder?n=120&radius=0.8&height=1.7");
  EXPECT_NEAR(s.area / (2 * pi * r * h + 2 * pi * r * r), 1, 3e-3);
  EXPECT_NEAR(s.volume / (pi * r * r * h), 1, 3e-3);

  s = summary_of("cylinder?n=120&radius=0.8&height=1.7&open=1");
  EXPECT_NEAR(s.area / (2 * pi * r * h), 1, 3e-3);
  EXPECT_EQ(s.boundary_loops, 2);

  s = summary_of("torus?n=150&major=1.7&minor=0.8");
  EXPECT_NEAR(s.area / (4 * pi * pi * r * h), 1, 3e-3);
  EXPECT_NEAR(s.volume / (2 * pi * pi * r * r * h), 1, 5e-3);

  s = summary_of("disc?n=200&radius=0.8");
  EXPECT_NEAR(s.area / (pi * r * r), 1, 3e-3);

  // Pappus: two half spheres and a half tube of radius wall/2.
  s = summary_of("bowl?n=200&radius=0.8&wall=0.1");
  EXPECT_NEAR(s.area / (2 * pi * (r * r + 0.49) + 2 * pi * pi * 0.05 * 0.75), 1, 3e-3);

  s = summary_of("cube?n=5&size=2");
  EXPECT_NEAR(s.area, 24, 1e-12);
  EXPECT_NEAR(s.volume, 8, 1e-12);

  s = summary_of("strip?n=4&length=3&width=0.5");
  EXPECT_NEAR(s.area, 1.5, 1e-12);
}

TEST(Shapes, SolidsAreClosedOutwardAndOfTheRightGenus) {
  for (const std::string name : {"sphere", "cylinder", "cube", "bowl", "cup", "torus"}) {
    const MeshSummary s = summary_of(name);
    EXPECT_TRUE(s.closed()) << name;
    EXPECT_EQ(s.components, 1) << name;
    EXPECT_EQ(s.genus, name == "torus" ? 1 : 0) << name;
    EXPECT_GT(s.volume, 0) << name;
  }
}

TEST(Shapes, ACubeOfOneCellHasTwelveTrianglesOnEightCorners) {
  const MeshSummary s = summary_of("cube?n=1");
  EXPECT_EQ(s.faces, 12);
  EXPECT_EQ(s.vertices, 8);
}

TEST(Shapes, RoundShapesHaveTrianglesOfAboutOneSizeAndNoSlivers) {
  for (const std::string name :
       {"disc", "sphere", "cylinder", "torus", "bowl?n=200", "cup", "cup?n=300&wall=0.05"}) {
    const MeshSummary s = summary_of(name);
    EXPECT_LT(s.worst_aspect, 4.0) << name;
    EXPECT_LT(s.edge_max / s.edge_mean, 2.2) << name;
    EXPECT_GT(s.edge_min / s.edge_mean, 0.35) << name;
  }
}

TEST(Shapes, EdgeSetsTheEdgeLength) {
  for (const std::string name : {"disc", "cylinder", "torus", "bowl", "cup"}) {
    EXPECT_NEAR(summary_of(name + "?edge=0.02").edge_mean, 0.02, 0.002) << name;
  }
}

TEST(Shapes, UvsFillTheUnitSquareWithoutOverlapOrFlips) {
  for (const ShapeInfo& info : shape_table()) {
    const SurfaceMesh s = make_shape(info.name);
    ASSERT_EQ(s.corner_uvs.size(), 3 * s.triangles.size()) << info.name;
    double area = 0;
    for (std::size_t f = 0; f < s.triangles.size(); ++f) {
      const Vec2 &a = s.corner_uvs[3 * f], &b = s.corner_uvs[3 * f + 1],
                 &c = s.corner_uvs[3 * f + 2];
      const double twice = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
      EXPECT_GT(twice, 0) << info.name << " face " << f;
      area += twice / 2;
      for (const Vec2& uv : {a, b, c}) {
        EXPECT_GE(uv.minCoeff(), 0) << info.name;
        EXPECT_LE(uv.maxCoeff(), 1) << info.name;
      }
    }
    EXPECT_LE(area, 1 + 1e-12) << info.name;
    EXPECT_GT(area, 0.7) << info.name;
  }
}

TEST(Shapes, AreStoppedAtAnyMoment) {
  for (const ShapeInfo& info : shape_table()) {
    int questions = 0;
    Context counting;
    counting.cancelled = [&] { return ++questions < 0; };
    make_shape(info.name, counting);
    EXPECT_GE(questions, 5) << info.name;
    for (const int last : {1, questions / 2, questions}) {
      int asked = 0;
      Context context;
      context.cancelled = [&] { return ++asked >= last; };
      EXPECT_THROW(make_shape(info.name, context), Cancelled) << info.name;
    }
  }
}

TEST(Shapes, CornerNormalsAgreeWithTheFaces) {
  for (const ShapeInfo& info : shape_table()) {
    const SurfaceMesh s = make_shape(info.name);
    for (std::size_t c = 0; c < s.corner_normals.size(); ++c) {
      const Triangle& t = s.triangles[c / 3];
      const Vec3 n = (s.positions[t[1]] - s.positions[t[0]])
                         .cross(s.positions[t[2]] - s.positions[t[0]])
                         .normalized();
      EXPECT_NEAR(s.corner_normals[c].norm(), 1, 1e-9) << info.name;
      EXPECT_GT(s.corner_normals[c].dot(n), 0.6) << info.name << " face " << c / 3;
    }
  }
}

TEST(Shapes, TheCupHasAWallOfTheAskedThicknessAndAHollow) {
  const SurfaceMesh s = make_shape("cup?n=200&radius=0.4&height=0.8&wall=0.04");
  double lowest_inside = 1;  // of the vertices near the axis that face up
  for (const Vec3& p : s.positions) {
    if (std::hypot(p.x(), p.y()) < 1e-9 && p.z() > 0.07 * 0.8 + 1e-6) lowest_inside = p.z();
  }
  EXPECT_NEAR(lowest_inside, 0.07 * 0.8 + 0.04, 1e-9);
  const MeshSummary m = summary_of(s);
  EXPECT_LT(m.volume, 0.35 * pi * 0.4 * 0.4 * 0.8);
}

TEST(Shapes, MistakesAreNamedWithTheNearestKnownWord) {
  EXPECT_NE(message_of("plat?n=3").find("did you mean 'plate'"), std::string::npos);
  EXPECT_NE(message_of("plate?jiter=0.1").find("did you mean 'jitter'"), std::string::npos);
  EXPECT_NE(message_of("plate?jitter=0.5").find("from 0 to 0.45"), std::string::npos);
  EXPECT_NE(message_of("plate?n=2.5").find("whole number"), std::string::npos);
  EXPECT_NE(message_of("plate?n=").find("'n'"), std::string::npos);
  EXPECT_NE(message_of("plate?n=3x").find("'3x'"), std::string::npos);
  EXPECT_NE(message_of("plate?n=nan").find("'nan'"), std::string::npos);
  EXPECT_NE(message_of("torus?minor=2").find("minor"), std::string::npos);
  EXPECT_NE(message_of("").find("Known"), std::string::npos);
  EXPECT_NE(message_of("plate?n=3&n=4").find("'n' is given twice"), std::string::npos);
}

TEST(Shapes, HelpListsEveryShapeAndParameter) {
  const std::string help = shape_help();
  for (const ShapeInfo& s : shape_table()) {
    EXPECT_NE(help.find(s.name), std::string::npos);
    for (const ShapeParameter& p : s.parameters) {
      EXPECT_NE(help.find("    " + std::string(p.name) + " = "), std::string::npos);
      EXPECT_LE(p.low, p.standard);
      EXPECT_GE(p.high, p.standard);
    }
  }
}

}  // namespace
}  // namespace craze
