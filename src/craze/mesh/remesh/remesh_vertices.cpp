#include "craze/mesh/remesh/remesh_vertices.h"

#include <algorithm>

#include "craze/base/reporting_loop.h"

namespace craze {

namespace {

constexpr std::size_t moves_at_once = 512;
// Of a step along the surface: how far from it a walk may end that has not lost its way.
constexpr double trusted_walk = 0.5;

struct Move {
  bool wanted = false;
  Vec3 to;
  std::int32_t face = -1;
  double length = 0;
};

Move find_move(const RemeshSurface& s, std::int32_t v, double shaken) {
  Move move;
  if (!s.mesh.is_vertex(v) || s.mesh.count_marked(v) > 0) return move;
  const Vec3 p = s.mesh.position(v);
  Vec3 normal = Vec3::Zero(), center = Vec3::Zero();
  double weight = 0;
  s.mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const Vec3 cross = s.face_cross(h / 3);
    const std::int32_t b = s.mesh.to(h), c = s.mesh.apex(h);
    const double l = (s.wanted[v] + s.wanted[b] + s.wanted[c]) / 3, w = cross.norm() / (l * l);
    normal += cross;
    center += w / 3 * (p + s.mesh.position_near(b, p) + s.mesh.position_near(c, p));
    weight += w;
  });
  if (!(normal.norm() > 0)) return move;
  normal.normalize();
  Vec3 step = center / weight - p;
  for (int axis = 0; axis < 3 && shaken > 0; ++axis) {
    step[axis] += shaken * s.wanted[v] * (2 * s.shaking.uniform_at(3ull * v + axis) - 1);
  }
  step -= step.dot(normal) * normal;
  if (s.mesh.period().is_given()) {  // the plane goes on for ever
    return {true, p + step, s.near[v], s.length[v]};
  }
  const ClosestPoint::Hit hit =
      s.walk.find(p + step, {normal, -1, s.near[v]}, trusted_walk * step.norm());
  if (hit.face < 0) return move;
  move.wanted = true;
  move.to = hit.point;
  move.face = hit.face;
  for (int i = 0; i < 3; ++i) {
    move.length += hit.weights[i] * s.lengths[s.input.triangles[hit.face][i]];
  }
  return move;
}

// least: the cosine of the largest turn of a face.
bool keeps_star(const RemeshSurface& s, std::int32_t v, const Vec3& to, double least) {
  bool keeps = true;
  s.mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const Vec3 b = s.mesh.position_near(s.mesh.to(h), to);
    const Vec3 c = s.mesh.position_near(s.mesh.apex(h), to);
    const Vec3 before = s.face_cross(h / 3), after = cross_of(to, b, c);
    keeps = keeps && after.dot(before) > least * after.norm() * before.norm() &&
            after.norm() >= std::min(0.2 * (b - c).squaredNorm(), before.norm());
  });
  return keeps;
}

}  // namespace

void smooth(RemeshSurface& s, double shaken) {
  std::vector<Move> moves(s.mesh.vertex_count());
  const Context& stage = s.progress.stage();
  reporting_loop(stage, "remesh", moves.size(), moves_at_once,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t v = begin; v < end; ++v) {
                     moves[v] = find_move(s, static_cast<std::int32_t>(v), shaken);
                   }
                 });
  for (std::int32_t v = 0; v < s.mesh.vertex_count(); ++v) {
    const Move& m = moves[v];
    s.step();
    if (!m.wanted) continue;
    // A part of the way where all of it would fold the star.
    const Vec3 from = s.mesh.position(v);
    for (const double part : {1.0, 0.5, 0.25}) {
      const Vec3 to = from + part * (m.to - from);
      if (!keeps_star(s, v, to, 0.5)) continue;
      s.mesh.move(v, to);
      s.near[v] = m.face;
      s.wanted[v] *= m.length / s.length[v];
      s.length[v] = m.length;
      break;
    }
  }
  s.look_everywhere_again();
}

std::vector<std::int32_t> pull_vertices(RemeshSurface& s) {
  std::vector<Move> moves(s.mesh.vertex_count());
  const double enough = 1e-3 * s.max_distance;
  const Context& stage = s.progress.stage();
  reporting_loop(
      stage, "remesh", moves.size(), moves_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto v = static_cast<std::int32_t>(i);
          if (!s.mesh.is_vertex(v) || s.mesh.count_marked(v) > 0) continue;
          const auto hit =
              s.walk.find(s.mesh.position(v), {Vec3::Zero(), -1, s.near[v], enough}, enough);
          moves[v].to = hit.point;
          moves[v].face = hit.face;
          moves[v].wanted = hit.distance > enough;
        }
      });
  std::vector<std::int32_t> moved;
  for (std::int32_t v = 0; v < static_cast<std::int32_t>(moves.size()); ++v) {
    s.step();
    if (moves[v].face >= 0) s.near[v] = moves[v].face;
    if (!moves[v].wanted || !keeps_star(s, v, moves[v].to, 0.1)) continue;
    s.mesh.move(v, moves[v].to);
    s.look_around_again(v);
    moved.push_back(v);
  }
  return moved;
}

}  // namespace craze
