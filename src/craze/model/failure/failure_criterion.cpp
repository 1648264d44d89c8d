#include "craze/model/failure/failure_criterion.h"

#include <algorithm>
#include <limits>

#include "craze/base/cell_grid.h"

namespace craze {

namespace {

// Tips are few: in large cubes most of them are found in one.
CellGrid tip_grid(double process_zone) {
  return CellGrid(4 * process_zone);
}

// node_width() of a regular star is about the height of its triangles.
constexpr double width_per_edge = 0.87;

double edge_sum(const TriangleMesh& mesh) {
  double edges = 0;
  for (const Triangle& t : mesh.triangles()) {
    for (int i = 0; i < 3; ++i) edges += mesh.way(t[(i + 1) % 3], t[i]).norm();
  }
  return edges;
}

}  // namespace

bool is_crack_tip(const TriangleMesh& mesh, std::int32_t v) {
  const std::int32_t first = mesh.first_halfedge(v);
  if (first < 0 || mesh.crack_of(first) < 0) return false;
  std::int32_t last = first;
  for (std::int32_t h = first; h >= 0; h = mesh.rotate(h)) last = h;
  return mesh.crack_of(TriangleMesh::prev(last)) == mesh.crack_of(first);
}

double node_width(const TriangleMesh& mesh, std::int32_t v, const Vec3& normal) {
  const std::int32_t begin = mesh.first_halfedge(v);
  if (begin < 0) return 0;
  // A ∇λ_v = F × (b − a) / (2 |F|), with a and b the spokes of the face and F = a × b. By dot
  // products, most of which the next face can use: n̂·(F × (b − a)) is this numerator.
  Vec3 a = mesh.way(v, mesh.to(begin));
  double aa = a.squaredNorm(), na = normal.dot(a), width = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const Vec3 b = mesh.way(v, mesh.from(TriangleMesh::prev(h)));
    const double bb = b.squaredNorm(), nb = normal.dot(b), ab = a.dot(b);
    const double numerator = nb * (ab - aa) - na * (bb - ab), squared = aa * bb - ab * ab;
    // No more than |b − a|, also where rounding leaves nothing of F.
    if (squared > 0) {
      const double across = std::max(0.0, aa + bb - 2 * ab);
      width += 0.5 * std::sqrt(std::min(numerator * numerator / squared, across));
    }
    a = b;
    aa = bb;
    na = nb;
  });
  return 0.5 * width;
}

double typical_failure_force(const TriangleMesh& mesh, const MaterialParameters& material) {
  if (material.criterion == Criterion::force) return material.toughness;
  return material.strength * width_per_edge * edge_sum(mesh) / (3 * std::max(1, mesh.face_count()));
}

double typical_failure_tension(const TriangleMesh& mesh, const MaterialParameters& material) {
  if (material.criterion == Criterion::strength) return material.strength;
  const double width = width_per_edge * edge_sum(mesh) / (3 * std::max(1, mesh.face_count()));
  return width > 0 ? material.toughness / width : material.toughness;
}

FailureCriterion::FailureCriterion(const MaterialParameters& material, double process_zone)
    : material_(material), process_zone_(process_zone) {}

double mean_tension_ahead(const TriangleMesh& mesh, const StressField& field, std::int32_t v,
                          const Vec3& normal, double length) {
  const Vec3 start = mesh.position(v);
  const auto height = [&](std::int32_t n) { return normal.dot(mesh.way(v, n)); };
  double tension = 0, total = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t spoke) {
    std::int32_t edge = TriangleMesh::next(spoke);
    Vec3 from = start;
    double walked = 0;
    // Around a closed surface the plane comes back: it meets no face twice before.
    for (std::int32_t faces = mesh.face_count(); walked < length && faces > 0; --faces) {
      // The plane leaves the face of `edge` through it, if it meets it.
      const double a = height(mesh.from(edge)), b = height(mesh.to(edge));
      if ((a >= 0) == (b >= 0)) return;
      const double t = a / (a - b);
      const Vec3 to = (1 - t) * mesh.position_near(mesh.from(edge), start) +
                      t * mesh.position_near(mesh.to(edge), start);
      const double step = std::min((to - from).norm(), length - walked);
      tension += step * normal.dot(field.stress(mesh, edge / 3) * normal);
      total += step;
      walked += (to - from).norm();
      from = to;
      const std::int32_t beyond = mesh.opposite(edge);
      if (beyond < 0) return;
      const double apex = height(mesh.from(TriangleMesh::prev(beyond)));
      // beyond runs from the far end of `edge`, at height b, to the near one, at height a.
      edge = (apex >= 0) == (b >= 0) ? TriangleMesh::next(beyond) : TriangleMesh::prev(beyond);
    }
  });
  return total > 0 ? tension / total : 0;
}

double FailureCriterion::least_threshold(const TriangleMesh& mesh, std::int32_t v,
                                         const Vec3& normal, double scale) const {
  if (material_.criterion == Criterion::force) return material_.toughness * scale;
  const double width = node_width(mesh, v, normal);
  const double strength = material_.strength * scale * width;
  if (!is_crack_tip(mesh, v)) return strength;
  const double toughness = material_.toughness * scale * std::sqrt(width);
  const auto origin = origin_.find(v);
  const bool young =
      origin != origin_.end() &&
      (mesh.position_near(v, origin->second) - origin->second).norm() < process_zone_;
  return young ? std::min(strength, toughness) : toughness;
}

double FailureCriterion::threshold(const TriangleMesh& mesh, const StressField& field,
                                   std::int32_t v, const Eigenpair& failure, double scale,
                                   double least, std::int32_t& shield) const {
  shield = -1;
  if (material_.criterion == Criterion::force || is_crack_tip(mesh, v)) return least;
  shield = tip_near(mesh, v);
  if (shield >= 0) return std::numeric_limits<double>::infinity();
  if (!mesh.is_open_vertex(v) || !(process_zone_ > 0)) return least;
  const double ahead = mean_tension_ahead(mesh, field, v, failure.vector, process_zone_);
  if (!(ahead > 0)) return std::numeric_limits<double>::infinity();
  return std::max(least, failure.value * material_.strength * scale / ahead);
}

void FailureCriterion::tip_advanced(const TriangleMesh& mesh, std::int32_t from, std::int32_t to) {
  if (material_.criterion == Criterion::force) return;
  const auto origin = origin_.find(from);
  const Vec3 start = origin != origin_.end() ? origin->second : mesh.position(from);
  origin_[to] = start;
}

bool FailureCriterion::node_changed(const TriangleMesh& mesh, std::int32_t v) {
  if (material_.criterion == Criterion::force || !(process_zone_ > 0)) return false;
  if (static_cast<std::size_t>(mesh.vertex_count()) > listed_.size()) {
    listed_.resize(mesh.vertex_count(), 0);
  }
  const bool tip = is_crack_tip(mesh, v);
  if (tip == (listed_[v] != 0)) return false;
  listed_[v] = tip ? 1 : 0;
  std::vector<std::int32_t>& cell =
      tips_[tip_grid(process_zone_).key(mesh.period().wrapped(mesh.position(v)))];
  if (tip) {
    cell.push_back(v);
  } else {
    cell.erase(std::find(cell.begin(), cell.end(), v));
  }
  return !tip;
}

std::int32_t FailureCriterion::tip_near(const TriangleMesh& mesh, std::int32_t v) const {
  if (!(process_zone_ > 0)) return -1;
  const Vec3& p = mesh.position(v);
  std::int32_t found = -1;
  const CellGrid grid = tip_grid(process_zone_);
  mesh.period().for_each_image(p, process_zone_, [&](const Vec3& image) {
    grid.for_each_near(image, process_zone_, [&](std::uint64_t key) {
      const auto cell = tips_.find(key);
      if (found >= 0 || cell == tips_.end()) return;
      for (const std::int32_t tip : cell->second) {
        if (mesh.way(v, tip).squaredNorm() < process_zone_ * process_zone_) {
          found = tip;
          return;
        }
      }
    });
  });
  return found;
}

}  // namespace craze
