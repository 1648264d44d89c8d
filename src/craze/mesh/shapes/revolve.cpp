#include "craze/mesh/shapes/revolve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"

namespace craze {

namespace {

using std::numbers::pi;
constexpr int curve_points = 400;  // per stretch: a chord then misses a half circle by 8e-6 radii

// One ring of vertices: `count` of them from `first` on, at angles phase + 2π k / count.
struct Ring {
  double radius, z, v;
  Vec2 normal_before, normal_after;  // of the stretches that end and begin here, in (radius, z)
  std::int32_t first = 0;
  int count = 1;
  double phase = 0;

  double angle(int k) const { return phase + 2 * pi * k / count; }
  std::int32_t vertex(int k) const { return first + k % count; }
};

double length(const ProfileStretch& s) {
  double sum = 0;
  for (std::size_t i = 1; i < s.size(); ++i) sum += (s[i] - s[i - 1]).norm();
  return sum;
}

// The point and the outward normal at arc length `at`.
void locate(const ProfileStretch& s, double at, Vec2& point, Vec2& normal) {
  for (std::size_t i = 1; i < s.size(); ++i) {
    const Vec2 step = s[i] - s[i - 1];
    const double l = step.norm();
    if (at <= l || i + 1 == s.size()) {
      point = s[i - 1] + std::min(at / l, 1.0) * step;
      normal = Vec2(step.y(), -step.x()) / l;
      return;
    }
    at -= l;
  }
}

std::vector<Ring> sample(const std::vector<ProfileStretch>& profile, double edge, bool loop) {
  std::vector<Ring> rings;
  double total = 0, before = 0;
  for (const ProfileStretch& s : profile) total += length(s);
  for (const ProfileStretch& s : profile) {
    const double l = length(s), row = edge * std::sqrt(3.0) / 2;
    int steps = std::max(1, static_cast<int>(std::lround(l / row)));
    if (loop && profile.size() == 1) steps = std::max(4, steps + steps % 2);
    for (int i = 0; i <= steps; ++i) {
      Vec2 point = Vec2::Zero(), normal = Vec2::Zero();
      locate(s, l * i / steps, point, normal);
      if (i == 0 && !rings.empty()) {
        rings.back().normal_after = normal;
        continue;
      }
      rings.push_back({point.x(), point.y(), (before + l * i / steps) / total, normal, normal});
    }
    before += l;
  }
  return rings;
}

// Gives the rings their vertices. Neighbouring rings are turned by half a step against each other.
void place_vertices(std::vector<Ring>& rings, double edge, bool loop, SurfaceMesh& mesh,
                    const Context& context) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    context.check();
    Ring& ring = rings[i];
    if (loop && i + 1 == rings.size()) {
      ring.first = rings[0].first;
      ring.count = rings[0].count;
      ring.phase = rings[0].phase;
      break;
    }
    const bool on_axis = ring.radius < 1e-9 * edge;
    ring.first = static_cast<std::int32_t>(mesh.positions.size());
    ring.count = on_axis ? 1 : std::max<int>(5, std::lround(2 * pi * ring.radius / edge));
    ring.phase = i % 2 && !on_axis ? pi / ring.count : 0;
    for (int k = 0; k < ring.count; ++k) {
      const double a = ring.angle(k);
      mesh.positions.push_back(on_axis ? Vec3(0, 0, ring.z)
                                       : Vec3(ring.radius * elementary::cos(a),
                                              ring.radius * elementary::sin(a), ring.z));
    }
  }
}

// A corner of the strip between two rings: vertex k of one of them.
struct StripCorner {
  const Ring* ring;
  int k;
  bool lower;  // on the ring that the profile reaches first
};

void add_triangle(SurfaceMesh& mesh, const std::array<StripCorner, 3>& corners, double u_scale) {
  Triangle t;
  for (int c = 0; c < 3; ++c) {
    const StripCorner& x = corners[c];
    t[c] = x.ring->vertex(x.k);
    double angle = x.ring->angle(x.k);
    if (x.ring->count == 1) {  // the axis has no angle of its own: take the middle of the others
      const StripCorner &y = corners[(c + 1) % 3], &z = corners[(c + 2) % 3];
      angle = 0.5 * (y.ring->angle(y.k) + z.ring->angle(z.k));
    }
    const Vec2& n = x.lower ? x.ring->normal_after : x.ring->normal_before;
    mesh.corner_uvs.emplace_back(angle * u_scale, x.ring->v);
    mesh.corner_normals.push_back(x.ring->count == 1 ? Vec3(0, 0, n.y() < 0 ? -1 : 1)
                                                     : Vec3(n.x() * elementary::cos(angle),
                                                            n.x() * elementary::sin(angle), n.y()));
  }
  mesh.triangles.push_back(t);
}

// Fills the strip between two rings, always taking the step whose diagonal turns less.
void stitch(SurfaceMesh& mesh, const Ring& low, const Ring& high, double u_scale) {
  const int low_steps = low.count == 1 ? 0 : low.count;
  const int high_steps = high.count == 1 ? 0 : high.count;
  for (int i = 0, j = 0; i < low_steps || j < high_steps;) {
    const bool step_low =
        j == high_steps || (i < low_steps && std::abs(low.angle(i + 1) - high.angle(j)) <=
                                                 std::abs(high.angle(j + 1) - low.angle(i)));
    if (step_low) {
      add_triangle(mesh, {{{&low, i, true}, {&low, i + 1, true}, {&high, j, false}}}, u_scale);
      ++i;
    } else {
      add_triangle(mesh, {{{&low, i, true}, {&high, j + 1, false}, {&high, j, false}}}, u_scale);
      ++j;
    }
  }
}

}  // namespace

ProfileStretch arc(const Vec2& center, double radius, double from_angle, double to_angle) {
  ProfileStretch s;
  for (int i = 0; i <= curve_points; ++i) {
    const double a = from_angle + (to_angle - from_angle) * i / curve_points;
    s.emplace_back(center + radius * Vec2(elementary::cos(a), elementary::sin(a)));
  }
  return s;
}

ProfileStretch bezier(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  ProfileStretch s;
  for (int i = 0; i <= curve_points; ++i) {
    const double t = static_cast<double>(i) / curve_points, r = 1 - t;
    s.emplace_back(r * r * r * a + 3 * r * r * t * b + 3 * r * t * t * c + t * t * t * d);
  }
  return s;
}

SurfaceMesh revolve(const std::vector<ProfileStretch>& profile, double edge, const Context& context,
                    bool loop) {
  SurfaceMesh mesh;
  std::vector<Ring> rings = sample(profile, edge, loop);
  place_vertices(rings, edge, loop, mesh, context);
  double turn = 2 * pi;  // the seam is a zigzag of mesh edges: u runs a little past one turn
  for (const Ring& r : rings) turn = std::max(turn, 2 * pi + r.phase);
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    context.check();
    stitch(mesh, rings[i], rings[i + 1], 1 / turn);
  }
  return mesh;
}

}  // namespace craze
