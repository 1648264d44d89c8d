#include "craze/render/subject.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace craze::render {

namespace {

using Box = Eigen::AlignedBox3d;

constexpr double stray_area = 0.01;     // of the whole, all strays together
constexpr double stray_distance = 0.1;  // of the diagonal of what is no stray

/// Vertices joined by triangles and by equal places: a forest.
class Parts {
 public:
  explicit Parts(const SurfaceMesh& mesh) : parent_(mesh.positions.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const Triangle& t : mesh.triangles) {
      join(t[0], t[1]);
      join(t[0], t[2]);
    }
    std::vector<std::int32_t> order(parent_);
    std::iota(order.begin(), order.end(), 0);
    const auto& p = mesh.positions;
    const auto before = [](const Vec3& a, const Vec3& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::sort(order.begin(), order.end(),
              [&](std::int32_t a, std::int32_t b) { return before(p[a], p[b]); });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (p[order[i]] == p[order[i - 1]]) join(order[i], order[i - 1]);
    }
  }
  std::int32_t root(std::int32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

 private:
  void join(std::int32_t a, std::int32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::int32_t> parent_;
};

Vec3 area_vector(const SurfaceMesh& mesh, const Triangle& t) {
  const Vec3& p = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p) / 2;
}

struct Part {
  std::int32_t root;
  double area;
  Box box;
};

/// #V: whether a vertex is of a stray part.
std::vector<char> strays(const std::vector<Part>& by_area, double area, std::size_t vertices) {
  std::vector<char> is_stray(vertices, 0);  // by root
  std::size_t small = 0;
  for (double sum = 0; small < by_area.size(); ++small) {
    sum += by_area[small].area;
    if (!(sum <= stray_area * area)) break;
  }
  Box core;
  for (std::size_t i = small; i < by_area.size(); ++i) core.extend(by_area[i].box);
  if (core.isEmpty()) return is_stray;
  const double far = stray_distance * core.diagonal().norm();
  for (std::size_t i = 0; i < small; ++i) {
    if (core.exteriorDistance(by_area[i].box) > far) is_stray[by_area[i].root] = 1;
  }
  return is_stray;
}

}  // namespace

Subject subject_of(const SurfaceMesh& mesh) {
  Parts parts(mesh);
  std::vector<double> area(mesh.positions.size(), 0);  // by root
  std::vector<Box> box(mesh.positions.size());
  double whole = 0;
  Subject subject;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 vector = area_vector(mesh, t);
    const std::int32_t root = parts.root(t[0]);
    area[root] += vector.norm();
    whole += vector.norm();
    subject.facing += vector;
    for (const std::int32_t v : t) box[root].extend(mesh.positions[v]);
  }
  if (whole > 0) subject.facing /= whole;
  std::vector<Part> by_area;
  for (std::size_t v = 0; v < box.size(); ++v) {
    if (!box[v].isEmpty()) by_area.push_back({static_cast<std::int32_t>(v), area[v], box[v]});
  }
  std::stable_sort(by_area.begin(), by_area.end(),
                   [](const Part& a, const Part& b) { return a.area < b.area; });
  const std::vector<char> is_stray = strays(by_area, whole, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const std::int32_t root = parts.root(static_cast<std::int32_t>(v));
    if (!box[root].isEmpty() && !is_stray[root]) subject.points.push_back(mesh.positions[v]);
  }
  return subject;
}

}  // namespace craze::render
