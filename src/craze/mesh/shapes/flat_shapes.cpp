#include "craze/mesh/shapes/flat_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "craze/base/random.h"

namespace craze {

namespace {

double signed_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).z();
}

// cot of the angle at p in the triangle (p, a, b): negative for obtuse ones.
double cotangent(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (a - p).dot(b - p) / (a - p).cross(b - p).norm();
}

// The grid of a rectangle while its vertices are being moved.
struct Grid {
  const RectangleOptions& options;
  std::vector<Vec3> offsets;  // in cells, at jitter 1

  std::int32_t vertex(int i, int j) const { return j * (options.cells_x + 1) + i; }
  Vec3 position(int i, int j) const {
    const Vec3& o = offsets[vertex(i, j)];
    return {((i + o.x()) / options.cells_x - 0.5) * options.size_x,
            ((j + o.y()) / options.cells_y - 0.5) * options.size_y, 0};
  }
  /// The two triangles of a cell, as corner numbers into (0,0) (1,0) (1,1) (0,1).
  std::array<std::array<int, 3>, 2> split(int i, int j) const {
    const Vec3 p[4] = {position(i, j), position(i + 1, j), position(i + 1, j + 1),
                       position(i, j + 1)};
    const auto smallest = [&](int k) {
      return std::min(signed_area(p[k], p[(k + 1) % 4], p[(k + 2) % 4]),
                      signed_area(p[k], p[(k + 2) % 4], p[(k + 3) % 4]));
    };
    int start = (i + j) % 2;
    if (smallest(0) <= 0 || smallest(1) <= 0) {
      start = smallest(0) >= smallest(1) ? 0 : 1;
    } else {
      // The diagonal 0–2 is Delaunay where the angles at 1 and 3 sum to less than a straight one.
      const double gain = cotangent(p[1], p[0], p[2]) + cotangent(p[3], p[2], p[0]) -
                          cotangent(p[0], p[1], p[3]) - cotangent(p[2], p[3], p[1]);
      if (std::abs(gain) > 1e-9) start = gain > 0 ? 0 : 1;
    }
    return {{{start, (start + 1) % 4, (start + 2) % 4}, {start, (start + 2) % 4, (start + 3) % 4}}};
  }
};

constexpr int corner_x[4] = {0, 1, 1, 0}, corner_y[4] = {0, 0, 1, 1};

// Halves the offsets around triangles smaller than a twentieth of a regular one until none is left.
void calm(Grid& grid, const Context& context) {
  const RectangleOptions& o = grid.options;
  const double regular = 0.5 * o.size_x / o.cells_x * o.size_y / o.cells_y;
  for (bool changed = true; changed;) {
    changed = false;
    for (int j = 0; j < o.cells_y; ++j) {
      context.check();
      for (int i = 0; i < o.cells_x; ++i) {
        for (const auto& t : grid.split(i, j)) {
          const auto at = [&](int k) {
            return grid.position(i + corner_x[t[k]], j + corner_y[t[k]]);
          };
          if (signed_area(at(0), at(1), at(2)) >= 0.05 * regular) continue;
          for (int k : t) grid.offsets[grid.vertex(i + corner_x[k], j + corner_y[k])] *= 0.5;
          changed = true;
        }
      }
    }
  }
}

}  // namespace

SurfaceMesh make_rectangle(const RectangleOptions& options, const Context& context) {
  const int nx = options.cells_x, ny = options.cells_y;
  Grid grid{options, std::vector<Vec3>((nx + 1) * (ny + 1), Vec3::Zero())};
  if (options.jitter > 0) {
    Random random(options.seed);
    for (int j = 0; j <= ny; ++j) {
      context.check();
      for (int i = 0; i <= nx; ++i) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        const bool slides_x = i > 0 && i<nx, slides_y = j> 0 && j < ny;
        grid.offsets[grid.vertex(i, j)] =
            options.jitter * Vec3(slides_x ? x : 0, slides_y ? y : 0, 0);
      }
    }
    calm(grid, context);
  }
  SurfaceMesh mesh;
  for (int j = 0; j <= ny; ++j) {
    context.check();
    for (int i = 0; i <= nx; ++i) mesh.positions.push_back(grid.position(i, j));
  }
  for (int j = 0; j < ny; ++j) {
    context.check();
    for (int i = 0; i < nx; ++i) {
      for (const auto& t : grid.split(i, j)) {
        Triangle triangle;
        for (int k = 0; k < 3; ++k) {
          triangle[k] = grid.vertex(i + corner_x[t[k]], j + corner_y[t[k]]);
          const Vec3& p = mesh.positions[triangle[k]];
          mesh.corner_uvs.emplace_back(p.x() / options.size_x + 0.5, p.y() / options.size_y + 0.5);
        }
        mesh.triangles.push_back(triangle);
      }
    }
  }
  return mesh;
}

SurfaceMesh make_cube(int cells, double size, const Context& context) {
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, std::int32_t> vertices;
  const double margin = 0.02;  // of a UV tile: keeps texture filters from mixing neighbouring sides
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2, outward = side % 2;
    // (u, v, axis) is right-handed for the outward side; u and v change places on the other one.
    const int u = (axis + (outward ? 1 : 2)) % 3, v = (axis + (outward ? 2 : 1)) % 3;
    const auto add_corner = [&](int i, int j) {
      std::array<int, 3> at{};
      at[axis] = outward ? cells : 0;
      at[u] = i;
      at[v] = j;
      const auto [found, added] =
          vertices.try_emplace(at, static_cast<std::int32_t>(mesh.positions.size()));
      if (added) {
        mesh.positions.push_back(size * (Vec3(at[0], at[1], at[2]) / cells - Vec3::Constant(0.5)));
      }
      const double s = margin + (1 - 2 * margin) * i / cells;
      const double t = margin + (1 - 2 * margin) * j / cells;
      mesh.corner_uvs.emplace_back((axis + s) / 3, (outward + t) / 2);
      return found->second;
    };
    for (int j = 0; j < cells; ++j) {
      context.check();
      for (int i = 0; i < cells; ++i) {
        const int start = (i + j) % 2;
        for (int half = 0; half < 2; ++half) {
          Triangle t;
          for (int k = 0; k < 3; ++k) {
            const int c = (start + (k == 0 ? 0 : k + half)) % 4;
            t[k] = add_corner(i + corner_x[c], j + corner_y[c]);
          }
          mesh.triangles.push_back(t);
        }
      }
    }
  }
  return mesh;
}

}  // namespace craze
