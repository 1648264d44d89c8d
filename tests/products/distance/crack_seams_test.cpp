#include "craze/products/distance/crack_seams.h"

#include <gtest/gtest.h>

#include "craze/products/distance/seams.h"

namespace craze {
namespace {

/// A plate cut through in two places: at x = 1/3 and x = 2/3 the vertices are doubled.
struct TwiceParted {
  SurfaceMesh surface;
  static constexpr int side = 9;  // quads

  TwiceParted() {
    const int columns = side + 3;
    for (int y = 0; y <= side; ++y) {
      for (int x = 0; x < columns; ++x) {
        const int at = x - (x > side / 3 ? 1 : 0) - (x > 2 * side / 3 + 1 ? 1 : 0);
        surface.positions.emplace_back(at / double{side}, y / double{side}, 0);
      }
    }
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x + 1 < columns; ++x) {
        const int a = y * columns + x, b = a + 1, c = a + columns, d = c + 1;
        if (surface.positions[a] == surface.positions[b]) continue;
        surface.triangles.push_back({a, b, d});
        surface.triangles.push_back({a, d, c});
      }
    }
  }
  double middle(std::size_t f) const {
    double x = 0;
    for (const std::int32_t v : surface.triangles[f]) x += surface.positions[v].x() / 3;
    return x;
  }
  TriangleMesh mesh() const { return {surface.positions, surface.triangles}; }
  /// How many sides are taken for cracks near that x.
  int sides_near(double x) const {
    const TriangleMesh topology = mesh();
    int count = 0;
    for (const std::int32_t h : crack_seams(surface, topology)) {
      count += std::abs(topology.position(topology.from(h)).x() - x) < 0.01;
    }
    return count;
  }
};

TEST(CrackSeams, WhereTheSidesLookTheSameThereIsACrack) {
  const TwiceParted plate;
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 2 * TwiceParted::side);
}

TEST(CrackSeams, WhereUvsDifferThereIsNone) {
  TwiceParted plate;
  for (std::size_t f = 0; f < plate.surface.triangles.size(); ++f) {
    for (const std::int32_t v : plate.surface.triangles[f]) {
      const Vec3& p = plate.surface.positions[v];
      plate.surface.corner_uvs.emplace_back(p.x() + (plate.middle(f) > 2 / 3.0 ? 1 : 0), p.y());
    }
  }
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0);
}

TEST(CrackSeams, WhereNormalsOrMaterialsDifferThereIsNone) {
  TwiceParted plate;
  for (std::size_t f = 0; f < plate.surface.triangles.size(); ++f) {
    const Vec3 normal = plate.middle(f) > 2 / 3.0 ? Vec3(0, 0.6, 0.8) : Vec3(0, 0, 1);
    plate.surface.corner_normals.insert(plate.surface.corner_normals.end(), 3, normal);
  }
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0);

  TwiceParted painted;
  painted.surface.material_names = {"left", "right"};
  for (std::size_t f = 0; f < painted.surface.triangles.size(); ++f) {
    painted.surface.face_materials.push_back(painted.middle(f) > 1 / 3.0 ? 1 : 0);
  }
  EXPECT_EQ(painted.sides_near(1 / 3.0), 0);
  EXPECT_EQ(painted.sides_near(2 / 3.0), 2 * TwiceParted::side);
}

TEST(CrackSeams, AFileThatRepeatsEveryVertexHasNone) {
  const TwiceParted plate;
  SurfaceMesh soup;
  for (const Triangle& t : plate.surface.triangles) {
    const auto first = static_cast<std::int32_t>(soup.positions.size());
    for (const std::int32_t v : t) soup.positions.push_back(plate.surface.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const TriangleMesh topology(soup.positions, soup.triangles);
  EXPECT_FALSE(seam_sides(topology).empty());
  EXPECT_TRUE(crack_seams(soup, topology).empty());
}

TEST(CrackSeams, TheDistanceToTheCracksDecidesWhereItIsGiven) {
  TwiceParted plate;
  Attribute distance{"crack_distance", 1, {}};
  for (const Vec3& p : plate.surface.positions) {
    distance.values.push_back(std::abs(p.x() - TwiceParted::side / 3 / double{TwiceParted::side}));
  }
  plate.surface.vertex_attributes = {distance};
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0);
}

/// A slanted plate whose left half is one texture and its right half another, which cracks along
/// y = 1/3: vertices in the middle and along the crack are doubled, as in a file that holds one UV
/// a vertex.
struct TexturedAndCracked {
  SurfaceMesh surface;
  static constexpr int side = 6;  // quads
  static constexpr double crack = 1 / 3.0;

  TexturedAndCracked() {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const int a = vertex(x, y, x, y), b = vertex(x + 1, y, x, y),
                  c = vertex(x + 1, y + 1, x, y), d = vertex(x, y + 1, x, y);
        surface.triangles.insert(surface.triangles.end(), {{a, b, c}, {a, c, d}});
      }
    }
    for (const Triangle& t : surface.triangles) {
      for (const std::int32_t v : t) surface.corner_uvs.push_back(uvs_[v]);
    }
  }

  /// What a run adds: the lower part moves down. Zero where it is not known.
  void add_displacement(bool known) {
    Attribute a{"displacement", 3, {}};
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const double down = !known ? 0 : below_[v] ? -0.1 : 0.1;
      a.values.insert(a.values.end(), {0, down, 0});
    }
    surface.vertex_attributes.push_back(a);
  }
  void add_distance() {
    Attribute a{"crack_distance", 1, {}};
    for (const Vec3& p : surface.positions) a.values.push_back(std::abs(p.y() - crack));
    surface.vertex_attributes.push_back(a);
  }
  /// How many sides are cracks along y = 1/3, and elsewhere.
  std::array<int, 2> cracks() const {
    const TriangleMesh topology(surface.positions, surface.triangles);
    std::array<int, 2> count{};
    for (const std::int32_t h : crack_seams(surface, topology)) {
      const double a = topology.position(topology.from(h)).y(),
                   b = topology.position(topology.to(h)).y();
      ++count[a == crack && b == crack ? 0 : 1];
    }
    return count;
  }

 private:
  int vertex(int x, int y, int of_x, int of_y) {
    const bool right = 2 * of_x >= side, below = 3 * of_y < side;
    const Vec2 uv((x + (right ? side : 0)) / double{side}, y / double{side});
    const Vec3 p((x - 0.5 * y) / double{side}, 3 * y == side ? crack : y / double{side}, 0);
    for (std::size_t v = 0; v < uvs_.size(); ++v) {
      if (surface.positions[v] == p && uvs_[v] == uv && below_[v] == below) {
        return static_cast<int>(v);
      }
    }
    surface.positions.push_back(p);
    uvs_.push_back(uv);
    below_.push_back(below);
    return static_cast<int>(uvs_.size()) - 1;
  }
  std::vector<Vec2> uvs_;
  std::vector<char> below_;
};

TEST(CrackSeams, ASeamBetweenTwoCracksIsNoneThoughBothItsEndsLieOnThem) {
  TexturedAndCracked plate;
  plate.add_distance();
  // Another crack a row higher, so that a piece of the seam runs from crack to crack.
  for (std::size_t v = 0; v < plate.surface.positions.size(); ++v) {
    double& d = plate.surface.vertex_attributes[0].values[v];
    d = std::min(d, std::abs(plate.surface.positions[v].y() - 0.5));
  }
  for (const bool known : {true, false}) {
    plate.add_displacement(known);
    EXPECT_EQ(plate.cracks(), (std::array{2 * TexturedAndCracked::side, 0})) << known;
    plate.surface.vertex_attributes.pop_back();
  }
}

TEST(CrackSeams, ACrackAlongASeamIsOne) {
  TexturedAndCracked plate;
  for (std::size_t f = 0; f < plate.surface.triangles.size(); ++f) {  // a seam along the crack
    double y = 0;
    for (const std::int32_t v : plate.surface.triangles[f]) y += plate.surface.positions[v].y() / 3;
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
      plate.surface.corner_uvs[c].y() += y < TexturedAndCracked::crack ? 0 : 3;
    }
  }
  EXPECT_EQ(plate.cracks(), (std::array{0, 0})) << "nothing tells it from a seam";
  plate.add_distance();
  EXPECT_EQ(plate.cracks(), (std::array{2 * TexturedAndCracked::side, 0}));
  plate.add_displacement(true);
  EXPECT_EQ(plate.cracks(), (std::array{2 * TexturedAndCracked::side, 0}));
}

TEST(CrackSeams, WhereFilesKeepUvsApartFromVerticesASplitVertexIsACut) {
  TwiceParted plate;  // one vertex in the middle of a part has two UVs
  for (std::size_t f = 0; f < plate.surface.triangles.size(); ++f) {
    for (const std::int32_t v : plate.surface.triangles[f]) {
      const Vec3& p = plate.surface.positions[v];
      plate.surface.corner_uvs.emplace_back(p.x() + (plate.middle(f) > 0.5 ? 1 : 0), p.y());
      plate.surface.corner_normals.push_back(plate.middle(f) > 2 / 3.0 ? Vec3(0, 0.6, 0.8)
                                                                       : Vec3(0, 0, 1));
    }
  }
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 2 * TwiceParted::side);
  plate.surface.object_names = {"left", "right"};
  for (std::size_t f = 0; f < plate.surface.triangles.size(); ++f) {
    plate.surface.face_objects.push_back(plate.middle(f) > 2 / 3.0 ? 1 : 0);
  }
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0) << "two objects that touch";
  plate.surface.object_names = {"fragment_0", "cup/fragment_12"};
  EXPECT_EQ(plate.sides_near(2 / 3.0), 2 * TwiceParted::side) << "two pieces";
}

TEST(CrackSeams, WhereColoursOrAttributesDifferThereIsNone) {
  TwiceParted plate;
  Attribute label{"label", 1, {}};
  for (std::size_t v = 0; v < plate.surface.positions.size(); ++v) {
    const bool right = v % (TwiceParted::side + 3) > 2 * TwiceParted::side / 3 + 1;
    label.values.push_back(right ? 1 : 0);
    plate.surface.vertex_colors.push_back({1, right ? 1.0f : 0.0f, 0, 1});
  }
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0);
  plate.surface.vertex_colors.clear();
  plate.surface.vertex_attributes = {label};
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0);
}

}  // namespace
}  // namespace craze
