#include <fmt/compile.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/lines/uv_lines.h"
#include "craze/io/lines/write_lines.h"

namespace craze {

namespace {

/// How far from their plane lines may lie, relative to their size.
constexpr double flatness = 1e-6;

struct Box {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};

Box bounds(const std::vector<Vec2>& points) {
  if (points.empty()) return {};
  Box box{points[0], points[0]};
  for (const Vec2& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

/// Flips the axis so that its largest component is positive: the same plane, the same picture.
Vec3 upright(const Vec3& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vec3(-axis) : axis;
}

/// The points in the axes of their plane: x along the world axis that lies flattest in it.
std::vector<Vec2> project(const std::vector<Vec3>& points) {
  if (points.empty()) return {};
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Mat3 spread = Mat3::Zero();
  double size = 0;
  for (const Vec3& p : points) {
    spread += (p - mean) * (p - mean).transpose();
    size = std::max(size, (p - mean).norm());
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
  const Vec3 normal = upright(solver.eigenvectors().col(0));  // of the least spread
  Eigen::Index flattest = 0;
  normal.cwiseAbs().minCoeff(&flattest);
  // Between equal candidates x is preferred, so that a drawing in the x y plane keeps its axes.
  const Vec3 x = (Vec3::Unit(flattest) - normal[flattest] * normal).normalized();
  const Vec3 y = normal.cross(x);
  std::vector<Vec2> flat;
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    if (std::abs(d.dot(normal)) > flatness * 2 * size) {
      throw Error(ErrorKind::request, "cannot write lines", "SVG",
                  "the lines are not in one plane; SVG needs a flat surface or UVs");
    }
    flat.emplace_back(p.dot(x), p.dot(y));
  }
  return flat;
}

/// Subpaths of one island, or of all lines.
using Path = std::pair<std::int32_t, std::string>;

/// A subpath per chain, y downwards, gathered by the island of its first point; in their order.
std::vector<Path> paths(const LineSet& lines, const std::vector<Vec2>& flat,
                        const std::vector<std::int32_t>& island, const Box& box) {
  std::map<std::int32_t, std::string> by_island;
  for (const auto& chain : join_edges(lines)) {
    std::string& path = by_island[island.empty() ? 0 : island[chain[0]]];
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Vec2& p = flat[chain[i]];
      fmt::format_to(std::back_inserter(path), FMT_COMPILE("{}{} {}"), i == 0 ? "M" : "L", p.x(),
                     box.low.y() + box.high.y() - p.y());
    }
  }
  return {by_island.begin(), by_island.end()};
}

std::string drawing(const std::vector<Path>& paths, const Box& box, bool in_texture) {
  constexpr double longest_side = 1024;  // pixels
  Vec2 size = box.high - box.low;
  if (!(size.maxCoeff() > 0)) size = Vec2(1, 1);
  const double stroke = size.maxCoeff() / 500;
  size += Vec2(2 * stroke, 2 * stroke);
  const Vec2 pixels = longest_side / size.maxCoeff() * size;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} "
      "{}\">\n<g fill=\"none\" stroke=\"black\" stroke-width=\"{}\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">\n",
      pixels.x(), pixels.y(), box.low.x() - stroke, box.low.y() - stroke, size.x(), size.y(),
      stroke);
  for (const auto& [island, path] : paths) {
    const std::string id = in_texture ? fmt::format(" id=\"island_{}\"", island) : "";
    svg += fmt::format("<path{} d=\"{}\"/>\n", id, path);
  }
  return svg + "</g>\n</svg>\n";
}

std::string plane_drawing(const LineSet& lines) {
  const std::vector<Vec2> flat = project(lines.points);
  const Box box = bounds(flat);
  return drawing(paths(lines, flat, {}, box), box, false);
}

}  // namespace

std::string format_lines_svg(const LineSet& lines, const LinesWarning& warn) {
  if (lines.uvs.empty()) return plane_drawing(lines);
  const UvLines drawn = uv_lines(lines);
  if (drawn.lines.edges.empty() && drawn.left_out > 0) return plane_drawing(lines);
  if (drawn.left_out > 0 && warn) {
    warn(
        fmt::format("{} of {} pieces of crack are not in the SVG: the parts they lie on have no "
                    "UVs; .ply, .obj and .json hold them",
                    drawn.left_out, lines.edges.size()));
  }
  std::vector<Vec2> flat;
  for (const Vec3& p : drawn.lines.points) flat.emplace_back(p.x(), p.y());
  Box box = bounds(flat);  // the whole texture, and what lies outside it
  box.low = box.low.cwiseMin(Vec2(0, 0));
  box.high = box.high.cwiseMax(Vec2(1, 1));
  return drawing(paths(drawn.lines, flat, drawn.island, box), box, true);
}

}  // namespace craze
