#include "craze/mesh/remesh/remesh_approach.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "craze/base/reporting_loop.h"
#include "craze/mesh/remesh/feature_lines.h"
#include "craze/mesh/remesh/remesh_edges.h"
#include "craze/mesh/remesh/remesh_vertices.h"

namespace craze {

namespace {

constexpr std::size_t grain = 512;
// Of the length wanted, where the middle of an edge is no point of the input.
constexpr double shortest_to_halve = 0.4;

// True if the four faces that a vertex at p makes of the two beside h stand as these do.
bool suits_split(const RemeshSurface& s, std::int32_t h, const Vec3& p) {
  for (const std::int32_t g : {h, s.mesh.opposite(h)}) {
    const Vec3 &a = s.mesh.position(s.mesh.from(g)), &b = s.mesh.position(s.mesh.to(g));
    const Vec3& c = s.mesh.position(s.mesh.apex(g));
    const Vec3 whole = cross_of(a, b, c);
    for (const Vec3& part : {cross_of(a, p, c), cross_of(p, b, c)}) {
      if (!(part.dot(whole) > 0.1 * part.norm() * whole.norm()) ||
          part.norm() < 0.05 * whole.norm()) {
        return false;
      }
    }
  }
  return true;
}

Vec3 middle_of(const RemeshSurface& s, std::int32_t h) {
  return 0.5 * (s.mesh.position(s.mesh.from(h)) + s.mesh.position(s.mesh.to(h)));
}

ClosestPoint::Filter near_filter(const RemeshSurface& s, std::int32_t h) {
  return {Vec3::Zero(), -1, s.near[s.mesh.from(h)]};
}

bool is_near(const RemeshSurface& s, std::int32_t f) {
  const auto within = [&](const Vec3& p, std::int32_t h) {
    ClosestPoint::Filter filter = near_filter(s, h);
    filter.enough = s.max_distance;
    return s.walk.find(p, filter, s.max_distance).distance <= s.max_distance;
  };
  const Triangle& t = s.mesh.triangle(f);
  const Vec3 sum = s.mesh.position(t[0]) + s.mesh.position(t[1]) + s.mesh.position(t[2]);
  if (!within(sum / 3, 3 * f)) return false;
  for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
    if (s.mesh.is_edge(h) && s.mesh.mark(h) == no_feature && !within(middle_of(s, h), h))
      return false;
  }
  return true;
}

// −1 if all sides lie on kept lines.
std::int32_t longest_free_side(const RemeshSurface& s, std::int32_t f) {
  std::int32_t longest = -1;
  double length = 0;
  for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
    if (s.mesh.mark(h) != no_feature || s.edge_length(h) <= length) continue;
    length = s.edge_length(h);
    longest = h;
  }
  return longest;
}

}  // namespace

void approach_input(RemeshSurface& s) {
  const int rounds = 10;
  std::vector<Triangle> sound;  // the corners of a slot's face when it was last found near enough
  for (int round = 0; round < rounds; ++round) {
    sound.resize(s.mesh.face_slots(), {-1, -1, -1});
    std::vector<std::int32_t> to_split(sound.size(), -1);
    const Context& stage = s.progress.stage();
    reporting_loop(stage, "remesh", sound.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t slot = begin; slot < end; ++slot) {
        const auto f = static_cast<std::int32_t>(slot);
        if (sound[f] == s.mesh.triangle(f)) continue;
        if (is_near(s, f)) {
          sound[f] = s.mesh.triangle(f);
        } else {
          to_split[f] = longest_free_side(s, f);
        }
      }
    });
    bool again = false;
    std::vector<char> touched(sound.size(), 0);  // its sides are no longer those looked at
    for (const std::int32_t h : to_split) {
      s.step();
      if (h < 0) continue;
      again = true;
      const std::int32_t o = s.mesh.opposite(h);  // a free edge has two sides
      const bool beside_new = 3 * touched.size() <= static_cast<std::size_t>(o);
      if (beside_new || touched[h / 3] || touched[o / 3]) continue;
      touched[h / 3] = touched[o / 3] = 1;
      const Vec3 nearest = s.tree.find(middle_of(s, h), near_filter(s, h)).point;
      if (suits_split(s, h, nearest)) {
        s.split(h, nearest);
      } else if (s.edge_length(h) >
                 shortest_to_halve * s.wanted_length(s.mesh.from(h), s.mesh.to(h))) {
        s.split(h, middle_of(s, h));
      } else {
        sound[h / 3] = s.mesh.triangle(h / 3);  // a fold that more vertices would not open
      }
    }
    if (!again) return;
    flip_edges(s);
    for (const std::int32_t v : pull_vertices(s)) {
      s.mesh.for_each_outgoing(v, [&](std::int32_t h) {
        if (static_cast<std::size_t>(h / 3) < sound.size()) sound[h / 3] = {-1, -1, -1};
      });
    }
  }
}

}  // namespace craze
