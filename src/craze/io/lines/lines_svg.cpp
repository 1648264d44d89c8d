#include <fmt/compile.h>
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <iterator>

#include "craze/error.h"
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

/// A path element's data: one subpath per chain, y downwards.
template <class Point>
void append_chain(std::string& path, std::size_t count, const Box& box, Point point) {
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 p = point(i);
    fmt::format_to(std::back_inserter(path), FMT_COMPILE("{}{} {}"), i == 0 ? "M" : "L", p.x(),
                   box.low.y() + box.high.y() - p.y());
  }
}

}  // namespace

std::string format_lines_svg(const LineSet& lines) {
  const bool has_uvs = !lines.uvs.empty();
  const std::vector<Vec2> flat = has_uvs ? lines.uvs : project(lines.points);
  Box box = bounds(flat);
  if (has_uvs) {  // the whole texture, and what lies outside it
    box.low = box.low.cwiseMin(Vec2(0, 0));
    box.high = box.high.cwiseMax(Vec2(1, 1));
  }
  std::string path;
  if (has_uvs) {
    for (std::size_t e = 0; e < lines.edges.size(); ++e) {
      append_chain(path, 2, box, [&](std::size_t i) { return flat[2 * e + i]; });
    }
  } else {
    for (const auto& chain : join_edges(lines)) {
      append_chain(path, chain.size(), box, [&](std::size_t i) { return flat[chain[i]]; });
    }
  }
  const Vec2 size = box.high - box.low;
  const double stroke = std::max(size.maxCoeff(), 1e-300) / 500;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\">\n"
      "<path fill=\"none\" stroke=\"black\" stroke-width=\"{}\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\" d=\"{}\"/>\n</svg>\n",
      box.low.x() - stroke, box.low.y() - stroke, size.x() + 2 * stroke, size.y() + 2 * stroke,
      stroke, path);
}

}  // namespace craze
