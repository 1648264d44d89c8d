#include "craze/products/growth/growth_motion.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "craze/products/opening/surface_extension.h"

namespace craze {

namespace {

/// A crack that ends or passes at a site, between two of the vertices there.
struct Parting {
  std::int32_t site;
  std::int32_t a, b;
  double time;
};

/// By site and time.
std::vector<Parting> partings(const TriangleMesh& mesh, const CrackSites& sites,
                              const CrackSchedule& schedule) {
  // The vertex at the end of each side, by the last two sites that the side runs over.
  std::map<std::array<std::int32_t, 2>, std::int32_t> end_of;
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t v = mesh.to(sites.sides[i]);
    end_of[{sites.before_to(mesh, i), sites.site_of[v]}] = v;
  }
  std::vector<Parting> result;
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t v = mesh.from(sites.sides[i]);
    const auto across = end_of.find({sites.after_from(mesh, i), sites.site_of[v]});
    if (across == end_of.end()) continue;
    result.push_back({sites.site_of[v], v, across->second, schedule.sides[i][0]});
  }
  std::sort(result.begin(), result.end(), [](const Parting& x, const Parting& y) {
    return std::tie(x.site, x.time, x.a) < std::tie(y.site, y.time, y.a);
  });
  return result;
}

/// The vertices of a site in groups that are not parted yet.
class Together {
 public:
  explicit Together(const std::vector<std::int32_t>& vertices)
      : vertices_(vertices), group_(vertices.size()) {
    std::iota(group_.begin(), group_.end(), 0);
  }

  void join(std::int32_t v, std::int32_t w) {
    const std::size_t a = group_[index(v)], b = group_[index(w)];
    for (std::size_t& g : group_) g = g == std::max(a, b) ? std::min(a, b) : g;
  }

  /// The vertices that are together with the i-th.
  std::vector<std::int32_t> group_of(std::size_t i) const {
    std::vector<std::int32_t> members;
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
      if (group_[k] == group_[i]) members.push_back(vertices_[k]);
    }
    return members;
  }

 private:
  std::size_t index(std::int32_t v) const {
    return static_cast<std::size_t>(std::lower_bound(vertices_.begin(), vertices_.end(), v) -
                                    vertices_.begin());
  }

  const std::vector<std::int32_t>& vertices_;  // ascending
  std::vector<std::size_t> group_;
};

/// A side of a crack as one of its ends sees it.
struct Neighbour {
  std::int32_t vertex;
  double time;  ///< when the crack is at the end that sees it
};

std::vector<std::vector<Neighbour>> neighbours(const TriangleMesh& mesh, const CrackSites& sites,
                                               const CrackSchedule& schedule) {
  std::vector<std::vector<Neighbour>> along(mesh.vertex_count());
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t a = mesh.from(sites.sides[i]), b = mesh.to(sites.sides[i]);
    along[a].push_back({b, schedule.sides[i][0]});
    along[b].push_back({a, schedule.sides[i][1]});
  }
  return along;
}

/// #V: when vertices away from cracks go.
std::vector<double> arrivals(const TriangleMesh& mesh, const CrackSites& sites,
                             const CrackSchedule& schedule) {
  std::vector<std::uint8_t> on_crack(mesh.vertex_count(), 0);
  std::vector<double> arrival(mesh.vertex_count(), 0);
  double size = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    size = std::max(size, (mesh.position(v) - mesh.position(0)).norm());
    if (sites.site_of[v] < 0) continue;
    on_crack[v] = 1;
    arrival[v] = schedule.sites[sites.site_of[v]];
  }
  arrival = extend_over_surface(mesh, on_crack, arrival, size, 1e-4);
  for (double& t : arrival) t = std::clamp(t, 0.0, 1 - CrackSchedule::opening_time);
  return arrival;
}

/// Where vertices that are still one go: as far as their neighbours along the cracks that are there
/// already, so that the edge of a piece is straight where it will be parted.
Vec3 goal_of(const std::vector<std::int32_t>& group,
             const std::vector<std::vector<Neighbour>>& along, double time,
             const std::vector<Vec3>& whole) {
  Vec3 of_group = Vec3::Zero(), of_neighbours = Vec3::Zero();
  int count = 0;
  for (const std::int32_t v : group) {
    of_group += whole[v] / static_cast<double>(group.size());
    for (const Neighbour& n : along[v]) {
      if (n.time > time) continue;
      of_neighbours += whole[n.vertex];
      ++count;
    }
  }
  return count > 0 ? Vec3(of_neighbours / count) : of_group;
}

}  // namespace

GrowthMotion::GrowthMotion(const TriangleMesh& mesh, const CrackSites& sites,
                           const CrackSchedule& schedule, const OpenedMesh& opened)
    : shut_(opened.mesh.positions.empty() ? mesh.positions() : opened.mesh.positions),
      wall_points_(opened.wall_points),
      drag_(mesh, sites) {
  std::copy(mesh.positions().begin(), mesh.positions().end(), shut_.begin());
  add_bottoms(mesh, sites, opened);
  if (opened.mesh.positions.empty()) return;
  std::vector<Vec3> whole(mesh.positions().size());
  bool moves = false;
  for (std::size_t v = 0; v < whole.size(); ++v) {
    whole[v] = opened.mesh.positions[v] - shut_[v];
    moves = moves || !whole[v].isZero(0);
  }
  if (!moves) return;
  arrival_ = arrivals(mesh, sites, schedule);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (sites.site_of[v] < 0 && !whole[v].isZero(0)) shifts_.push_back({v, arrival_[v], whole[v]});
  }
  part_at_sites(mesh, sites, schedule, whole);
}

void GrowthMotion::add_bottoms(const TriangleMesh& mesh, const CrackSites& sites,
                               const OpenedMesh& opened) {
  goes_down_ = !opened.solid;
  if (opened.solid) {
    for (std::int32_t b = mesh.vertex_count(); b < opened.solid->core_vertex; ++b) {
      const std::int32_t top = opened.vertex_of[b];
      inner_.push_back({b, top, opened.mesh.positions[b] - opened.mesh.positions[top]});
    }
    return;
  }
  std::vector<std::uint8_t> at_border(sites.vertex.size(), 0);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) != TriangleMesh::border) continue;
    for (const std::int32_t v : {mesh.from(h), mesh.to(h)}) {
      if (sites.site_of[v] >= 0) at_border[sites.site_of[v]] = 1;
    }
  }
  const auto end = static_cast<std::int32_t>(shut_.size() - wall_points_.size());
  for (std::int32_t b = mesh.vertex_count(); b < end; ++b) {
    const std::int32_t top = opened.vertex_of[b], site = sites.site_of[top];
    if (site < 0 || at_border[site]) continue;
    bottoms_.push_back({b, top, opened.mesh.positions[b] - mesh.position(top)});
  }
}

void GrowthMotion::part_at_sites(const TriangleMesh& mesh, const CrackSites& sites,
                                 const CrackSchedule& schedule, const std::vector<Vec3>& whole) {
  std::vector<std::vector<std::int32_t>> vertices_at(sites.vertex.size());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (sites.site_of[v] >= 0) vertices_at[sites.site_of[v]].push_back(v);
  }
  const std::vector<Parting> all = partings(mesh, sites, schedule);
  const auto along = neighbours(mesh, sites, schedule);
  std::size_t begin = 0;
  for (std::size_t s = 0; s < vertices_at.size(); ++s) {
    const auto& vertices = vertices_at[s];
    std::size_t end = begin;
    while (end < all.size() && all[end].site == static_cast<std::int32_t>(s)) ++end;
    std::vector<Vec3> gone(vertices.size(), Vec3::Zero());
    const auto go = [&](const Together& together, double time) {
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::vector<std::int32_t> group = together.group_of(i);
        const Vec3 goal =
            group.size() == 1 ? whole[vertices[i]] : goal_of(group, along, time, whole);
        if (!(goal - gone[i]).isZero(0)) shifts_.push_back({vertices[i], time, goal - gone[i]});
        gone[i] = goal;
      }
    };
    // At each crack's time, the vertices that only later ones part are still together. A crack that
    // passes on the far side only parts none.
    const auto go_at = [&](double time, std::size_t parted) {
      Together together(vertices);
      for (std::size_t i = parted; i < end; ++i) together.join(all[i].a, all[i].b);
      go(together, time);
    };
    if (begin == end || all[begin].time > schedule.sites[s]) go_at(schedule.sites[s], begin);
    for (std::size_t i = begin; i < end; ++i) {
      if (i + 1 == end || all[i + 1].time != all[i].time) go_at(all[i].time, i + 1);
    }
    begin = end;
  }
}

std::vector<Vec3> GrowthMotion::positions(double time) const {
  std::vector<Vec3> positions = shut_;
  if (shifts_.empty()) return positions;
  std::vector<Vec3> move(arrival_.size(), Vec3::Zero());
  for (const Shift& shift : shifts_) {
    move[shift.vertex] += CrackSchedule::openness(shift.arrival, time) * shift.by;
  }
  std::vector<double> slack(arrival_.size());
  for (std::size_t v = 0; v < slack.size(); ++v) {
    slack[v] = 1 - CrackSchedule::openness(arrival_[v], time);
  }
  drag_.along(slack, move);
  for (std::size_t v = 0; v < move.size(); ++v) positions[v] += move[v];
  for (const Bottom& inner : inner_) positions[inner.vertex] = positions[inner.top] + inner.down;
  for (const Bottom& bottom : bottoms_) {
    const double open = 1 - slack[bottom.top];
    positions[bottom.vertex] =
        shut_[bottom.top] + open * bottom.down + (1 - open) * move[bottom.top];
  }
  std::size_t v = shut_.size() - wall_points_.size();
  for (const WallPoint& p : wall_points_) {
    const double open = goes_down_ ? 1 - slack[p.top] : 1;
    positions[v++] = p.between(positions) + open * p.aside;
  }
  return positions;
}

}  // namespace craze
