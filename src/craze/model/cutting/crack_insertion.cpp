#include "craze/model/cutting/crack_insertion.h"

#include <algorithm>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/model/cutting/vertex_slide.h"

namespace craze {

namespace {

void sort_unique(std::vector<std::int32_t>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

double angle_between(const Vec3& a, const Vec3& b) {
  return elementary::atan2(a.cross(b).norm(), a.dot(b));
}

// Where a near vertex cannot slide, a crack closer to its edge than this follows the edge, radians.
constexpr double least_split_angle = 5 * std::numbers::pi / 180;

/// A way for the crack to leave the node.
struct Ray {
  enum Way {
    across,     // a face, splitting the edge opposite to the node
    along,      // an edge
    to_vertex,  // across a face, to a vertex of it that is to slide there
  };
  std::int32_t halfedge;  // outgoing; of the face crossed, or the edge followed
  Way way;
  double angle;        // around the star from its first halfedge, radians
  double off_edge;     // angle to the nearer edge of the face crossed, radians
  bool near_halfedge;  // which is that of `halfedge`, not the other one
};

/// Where along the edge opposite to the node in h's face the plane passes; negative if it does not.
double crossing(const TriangleMesh& mesh, std::int32_t h, const Vec3& normal) {
  const std::int32_t v = mesh.from(h);
  const double db = normal.dot(mesh.way(v, mesh.to(h)));
  const double dc = normal.dot(mesh.way(v, mesh.from(TriangleMesh::prev(h))));
  if ((db >= 0) == (dc >= 0)) return -1;
  return db / (db - dc);
}

class Insertion {
 public:
  Insertion(CrackedSheet& sheet, const CrackRules& rules, CrackOutcome& outcome)
      : sheet_(sheet), mesh_(sheet.mesh()), rules_(rules), outcome_(outcome) {}

  std::vector<Ray> admissible_rays(std::int32_t v, const Vec3& normal) const;
  void insert(const Ray& ray, const Vec3& normal, std::int32_t label);

 private:
  bool too_close_to_open_edge(std::int32_t v, const Vec3& direction) const;
  std::int32_t split(std::int32_t h, double t);
  bool slide(std::int32_t h, double t);
  void cut(std::int32_t h, std::int32_t label);
  void note_star(std::int32_t v) { outcome_.changed_nodes.push_back(v); }

  CrackedSheet& sheet_;
  const TriangleMesh& mesh_;
  const CrackRules& rules_;
  CrackOutcome& outcome_;
};

bool Insertion::too_close_to_open_edge(std::int32_t v, const Vec3& direction) const {
  if (!mesh_.is_open_vertex(v)) return false;
  const std::int32_t first = mesh_.first_halfedge(v);
  std::int32_t last = first;
  for (std::int32_t h = first; h >= 0; h = mesh_.rotate(h)) last = h;
  const Vec3 a = mesh_.way(v, mesh_.to(first));
  const Vec3 b = mesh_.way(v, mesh_.from(TriangleMesh::prev(last)));
  return std::min(angle_between(direction, a), angle_between(direction, b)) < rules_.back_angle;
}

std::vector<Ray> Insertion::admissible_rays(std::int32_t v, const Vec3& normal) const {
  std::vector<Ray> rays;
  double around = 0;  // angle of the current face's first edge
  mesh_.for_each_outgoing(v, [&](std::int32_t h) {
    const std::int32_t across = TriangleMesh::prev(h);  // enters v: the face's other edge at v
    const Vec3 b = mesh_.way(v, mesh_.to(h));
    const Vec3 c = mesh_.way(v, mesh_.from(across));
    const double face_angle = angle_between(b, c);
    const double t = crossing(mesh_, h, normal);
    if (t >= 0) {
      const Vec3 direction = (1 - t) * b + t * c;
      const double to_b = angle_between(direction, b), to_c = angle_between(direction, c);
      const bool near_b = to_b <= to_c;
      Ray ray{h, Ray::across, around + to_b, std::min(to_b, to_c), near_b};
      const bool open = near_b ? mesh_.is_open(h) : mesh_.is_open(across);
      // An end so close to a corner that the split would have no area follows the edge as well.
      const bool at_corner = t < 1e-9 || t > 1 - 1e-9;
      bool drop = too_close_to_open_edge(v, direction);
      if (ray.off_edge < rules_.snap_angle || at_corner) {
        if (open) {
          drop = drop || at_corner;
        } else if (rules_.near_vertex == NearVertex::slide && !at_corner &&
                   !mesh_.is_open_vertex(near_b ? mesh_.to(h) : mesh_.from(across))) {
          ray.way = Ray::to_vertex;
        } else {
          ray.way = Ray::along;
          ray.halfedge = near_b ? h : mesh_.opposite(across);
          ray.angle = near_b ? around : around + face_angle;
        }
      }
      const auto same = [&](const Ray& r) {
        return r.way == Ray::along && ray.way == Ray::along && r.halfedge == ray.halfedge;
      };
      if (!drop && std::none_of(rays.begin(), rays.end(), same)) rays.push_back(ray);
    }
    around += face_angle;
  });
  if (rays.size() <= 2) return rays;

  const bool closed = !mesh_.is_open_vertex(v);
  std::size_t best_a = 0, best_b = 1;
  double best = -1;
  for (std::size_t a = 0; a < rays.size(); ++a) {
    for (std::size_t b = a + 1; b < rays.size(); ++b) {
      const double between = std::abs(rays[b].angle - rays[a].angle);
      const double separation = closed ? std::min(between, around - between) : between;
      if (separation > best) {
        best = separation;
        best_a = a;
        best_b = b;
      }
    }
  }
  return {rays[best_a], rays[best_b]};
}

std::int32_t Insertion::split(std::int32_t h, double t) {
  const TriangleMesh::Split split = sheet_.split(h, t);
  for (int side = 0; side < 2; ++side) {
    if (split.face[side] < 0) continue;
    outcome_.changed_faces.push_back(split.face[side]);
    for (const std::int32_t f : {split.face[side], split.new_face[side]}) {
      for (const std::int32_t v : mesh_.triangle(f)) note_star(v);
    }
  }
  return split.vertex;
}

bool Insertion::slide(std::int32_t h, double t) {
  if (!slide_vertex(sheet_, h, t)) return false;
  mesh_.for_each_outgoing(mesh_.from(h), [&](std::int32_t spoke) {
    for (const std::int32_t v : mesh_.triangle(TriangleMesh::face_of(spoke))) note_star(v);
  });
  return true;
}

void Insertion::cut(std::int32_t h, std::int32_t label) {
  const std::int32_t o = mesh_.opposite(h), from = mesh_.from(h), to = mesh_.to(h);
  outcome_.segments.push_back({mesh_.root(from), mesh_.root(to), mesh_.source_face(h / 3)});
  const bool becomes_tip = !mesh_.is_open_vertex(to);
  const TriangleMesh::Cut cut = sheet_.cut(h, label);
  if (becomes_tip) outcome_.tips.push_back(to);
  const auto note = [&](std::int32_t v, std::int32_t copy, std::int32_t fan_start) {
    note_star(v);
    if (copy < 0) return;
    note_star(copy);
    for (std::int32_t g = fan_start; g >= 0; g = mesh_.rotate(g)) {
      outcome_.changed_faces.push_back(g / 3);
    }
  };
  note(from, cut.copy_of_from, h);
  note(to, cut.copy_of_to, o);
}

void Insertion::insert(const Ray& ray, const Vec3& normal, std::int32_t label) {
  std::int32_t h = ray.halfedge;
  if (ray.way != Ray::along) {
    // An earlier segment of this event may have halved the face: look again.
    const double t = crossing(mesh_, h, normal);
    if (!(t > 0 && t < 1)) return;
    const std::int32_t opposite = TriangleMesh::next(h);
    const bool reached =
        ray.way == Ray::to_vertex && (slide(ray.near_halfedge ? opposite : mesh_.opposite(opposite),
                                            ray.near_halfedge ? t : 1 - t) ||
                                      ray.off_edge < least_split_angle);
    if (reached) {
      if (!ray.near_halfedge) h = mesh_.opposite(TriangleMesh::prev(h));
    } else {
      split(opposite, t);
      // The face now ends at the new vertex, so its far edge at v is the segment.
      h = mesh_.opposite(TriangleMesh::prev(h));
    }
  }
  if (h >= 0 && !mesh_.is_open(h)) cut(h, label);
}

}  // namespace

void CrackOutcome::clear() {
  segments.clear();
  tips.clear();
  changed_faces.clear();
  changed_nodes.clear();
}

void CrackOutcome::append(const CrackOutcome& later, std::int32_t at_tip) {
  tips.erase(std::remove(tips.begin(), tips.end(), at_tip), tips.end());
  segments.insert(segments.end(), later.segments.begin(), later.segments.end());
  tips.insert(tips.end(), later.tips.begin(), later.tips.end());
  changed_faces.insert(changed_faces.end(), later.changed_faces.begin(), later.changed_faces.end());
  changed_nodes.insert(changed_nodes.end(), later.changed_nodes.begin(), later.changed_nodes.end());
  sort_unique(changed_nodes);
}

void open_crack(CrackedSheet& sheet, std::int32_t v, const Vec3& normal, const CrackRules& rules,
                std::int32_t first_label, CrackOutcome& outcome) {
  outcome.clear();
  Insertion insertion(sheet, rules, outcome);
  for (const Ray& ray : insertion.admissible_rays(v, normal)) {
    insertion.insert(ray, normal, first_label + static_cast<std::int32_t>(outcome.segments.size()));
  }
  sort_unique(outcome.changed_nodes);
}

}  // namespace craze
