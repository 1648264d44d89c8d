#include "craze/repair.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/mesh_summary.h"
#include "craze/mesh/remesh/surface_source.h"
#include "craze/mesh/repair/duplicate_faces.h"
#include "craze/mesh/repair/pair_edges.h"
#include "craze/mesh/repair/traced_repair.h"
#include "craze/mesh/repair/weld.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

namespace {

constexpr double largest_coordinate = 1e50;  // products of four stay finite

[[noreturn]] void fail(const std::string& what, std::size_t index, const std::string& why) {
  throw Error(ErrorKind::input, "mesh cannot be used", what + " " + std::to_string(index), why);
}

void check_size(std::size_t size, std::size_t expected, const std::string& name) {
  if (size == expected) return;
  throw Error(ErrorKind::input, "mesh cannot be used", name,
              std::to_string(size) + " values instead of " + std::to_string(expected));
}

void check_input(const SurfaceMesh& s) {
  const std::size_t vertices = s.positions.size(), faces = s.triangles.size();
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!(s.positions[v].cwiseAbs().maxCoeff() <= largest_coordinate) ||
        !s.positions[v].allFinite()) {
      fail("vertex", v, "its position is not a finite number below 1e50");
    }
  }
  for (std::size_t f = 0; f < faces; ++f) {
    for (std::int32_t v : s.triangles[f]) {
      if (v < 0 || static_cast<std::size_t>(v) >= vertices) {
        fail("face", f, "corner " + std::to_string(v) + " is not a vertex");
      }
    }
  }
  const auto check_given = [](std::size_t size, std::size_t expected, const std::string& name) {
    if (size > 0) check_size(size, expected, name);
  };
  check_given(s.corner_uvs.size(), 3 * faces, "UVs");
  check_given(s.corner_normals.size(), 3 * faces, "normals");
  check_given(s.vertex_colors.size(), vertices, "colours");
  check_given(s.face_materials.size(), faces, "materials");
  check_given(s.face_objects.size(), faces, "objects");
  check_given(s.source_faces.size(), faces, "source faces");
  for (const Attribute& a : s.vertex_attributes) {
    check_size(a.values.size(), a.components * vertices, a.name);
  }
  for (const Attribute& a : s.face_attributes) {
    check_size(a.values.size(), a.components * faces, a.name);
  }
}

// The surface while it is being put in order: faces with neighbours, and what each came from.
class Workpiece {
 public:
  Workpiece(const SurfaceMesh& input, RepairReport& report, const Context& context)
      : input_(input), report_(report), context_(context) {}

  TracedSurface run(double tolerance) {
    begin_stage();
    merge_vertices(tolerance);
    begin_stage();
    drop_faces(std::max(tolerance, 0.0));
    begin_stage();
    orient();
    begin_stage();
    separate_fans();
    begin_stage();
    separate_edges();
    begin_stage();
    TracedSurface traced{transfer(input_, std::move(triangles_), source_), origin()};
    begin_stage();
    return traced;
  }

 private:
  void begin_stage() {
    constexpr double stages = 6;
    context_.check();
    context_.report({"repair", stage_++ / stages, 0, std::ssize(input_.triangles)});
  }

  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  std::int32_t from(std::int32_t h) const { return triangles_[h / 3][h % 3]; }
  std::int32_t to(std::int32_t h) const { return from(next(h)); }

  void merge_vertices(double tolerance) {
    triangles_ = input_.triangles;
    if (tolerance < 0) return;
    const std::vector<std::int32_t> first = weld(input_.positions, tolerance);
    for (std::size_t v = 0; v < first.size(); ++v) {
      if (first[v] != static_cast<std::int32_t>(v)) ++report_.merged_vertices;
    }
    for (Triangle& t : triangles_) {
      for (std::int32_t& v : t) v = first[v];
    }
  }

  bool is_degenerate(const Triangle& t, double tolerance) const {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
    const Vec3 &a = input_.positions[t[0]], &b = input_.positions[t[1]],
               &c = input_.positions[t[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return !((b - a).cross(c - a).norm() > tolerance * longest);
  }

  void drop_faces(double tolerance) {
    std::vector<std::int32_t> sound;
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      if (!is_degenerate(triangles_[f], tolerance)) sound.push_back(static_cast<std::int32_t>(f));
    }
    report_.degenerate_faces = static_cast<std::int32_t>(triangles_.size() - sound.size());
    source_.faces = distinct_faces(triangles_, sound);
    report_.duplicate_faces = static_cast<std::int32_t>(sound.size() - source_.faces.size());
    std::vector<Triangle> kept;
    for (std::int32_t f : source_.faces) kept.push_back(triangles_[f]);
    triangles_ = std::move(kept);
  }

  void orient() {
    EdgePairs pairs = pair_edges(input_.positions, triangles_);
    report_.flipped_faces = pairs.flips;
    report_.nonmanifold_edges = pairs.crowded_edges;
    report_.cut_edges = pairs.cut_edges;
    opposite_ = std::move(pairs.opposite);
    source_.flipped = std::move(pairs.flipped);
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const std::int32_t c = 3 * source_.faces[f];
      const bool flipped = source_.flipped[f];
      if (flipped) std::swap(triangles_[f][1], triangles_[f][2]);
      source_.corners.push_back({c, c});
      source_.corners.push_back(flipped ? std::array{c + 2, c + 2} : std::array{c + 1, c + 1});
      source_.corners.push_back(flipped ? std::array{c + 1, c + 1} : std::array{c + 2, c + 2});
    }
  }

  // Corners at one vertex that are joined by paired edges form a fan; each fan gets its own vertex.
  void separate_fans() {
    std::vector<std::int32_t> fan(opposite_.size());  // union-find: the lowest corner of a fan
    std::iota(fan.begin(), fan.end(), 0);
    const auto find = [&](std::int32_t c) {
      while (fan[c] != c) c = fan[c] = fan[fan[c]];
      return c;
    };
    const auto unite = [&](std::int32_t a, std::int32_t b) {
      a = find(a);
      b = find(b);
      fan[std::max(a, b)] = std::min(a, b);
    };
    const auto halfedges = static_cast<std::int32_t>(opposite_.size());
    for (std::int32_t h = 0; h < halfedges; ++h) {
      if (opposite_[h] < h) continue;
      unite(h, next(opposite_[h]));
      unite(next(h), opposite_[h]);
    }
    // The first fan of a vertex keeps its place in the order; the others come after all of them.
    std::vector<std::int32_t> first_fan(input_.positions.size(), -1), others;
    for (std::int32_t c = 0; c < halfedges; ++c) {
      if (find(c) != c) continue;
      if (first_fan[from(c)] < 0) {
        first_fan[from(c)] = c;
      } else {
        others.push_back(c);
      }
    }
    std::vector<std::int32_t> vertex(halfedges, -1);  // of the lowest corner of each fan
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(first_fan.size()); ++v) {
      if (first_fan[v] < 0) continue;
      vertex[first_fan[v]] = static_cast<std::int32_t>(source_.vertices.size());
      source_.vertices.push_back({v, v});
    }
    report_.unused_vertices = static_cast<std::int32_t>(first_fan.size() - source_.vertices.size() -
                                                        report_.merged_vertices);
    report_.split_vertices = static_cast<std::int32_t>(others.size());
    for (std::int32_t c : others) {
      vertex[c] = static_cast<std::int32_t>(source_.vertices.size());
      source_.vertices.push_back({from(c), from(c)});
    }
    for (std::int32_t c = 0; c < halfedges; ++c) triangles_[c / 3][c % 3] = vertex[find(c)];
  }

  // Two edges with the same two ends would be taken for one: all but the first get a vertex in
  // their middle. A face is split at most once per round.
  void separate_edges() {
    for (bool again = true; again;) {
      again = false;
      std::vector<std::int32_t> edges;
      for (std::int32_t h = 0; h < static_cast<std::int32_t>(opposite_.size()); ++h) {
        if (opposite_[h] < h) edges.push_back(h);
      }
      const auto key = [&](std::int32_t h) {
        return std::make_tuple(std::min(from(h), to(h)), std::max(from(h), to(h)), h);
      };
      std::sort(edges.begin(), edges.end(),
                [&](std::int32_t g, std::int32_t h) { return key(g) < key(h); });
      std::vector<std::int32_t> same;
      for (std::size_t i = 1; i < edges.size(); ++i) {
        const std::int32_t g = edges[i - 1], h = edges[i];
        if (std::minmax(from(g), to(g)) == std::minmax(from(h), to(h))) same.push_back(h);
      }
      std::vector<char> touched(triangles_.size(), 0);
      const auto is_touched = [&](std::int32_t g) {  // new faces are
        const auto f = static_cast<std::size_t>(g / 3);
        return f >= touched.size() || touched[f] != 0;
      };
      for (std::int32_t h : same) {
        const std::int32_t o = opposite_[h];
        if (is_touched(h) || (o >= 0 && is_touched(o))) {
          again = true;
          continue;
        }
        touched[h / 3] = 1;
        if (o >= 0) touched[o / 3] = 1;
        split(h);
      }
    }
  }

  void split(std::int32_t h) {
    const std::int32_t o = opposite_[h];
    const auto x = static_cast<std::int32_t>(source_.vertices.size());
    source_.vertices.push_back({source_.vertices[from(h)][0], source_.vertices[to(h)][0]});
    ++report_.inserted_vertices;
    // As in TriangleMesh::split_edge: g = (p → q) becomes p → x, the new face is (x, q, apex).
    const auto halve = [&](std::int32_t g) {
      const std::int32_t f = g / 3, side = next(g), last = next(side);
      const auto half = static_cast<std::int32_t>(triangles_.size());
      triangles_.push_back({x, to(g), from(last)});
      const std::array<std::int32_t, 2> middle{source_.corners[g][0], source_.corners[side][0]};
      const auto at_q = source_.corners[side], at_apex = source_.corners[last];
      source_.corners.insert(source_.corners.end(), {middle, at_q, at_apex});
      source_.corners[side] = middle;
      source_.faces.push_back(std::int32_t{source_.faces[f]});
      source_.flipped.push_back(char{source_.flipped[f]});
      triangles_[f][side % 3] = x;
      const std::int32_t outer = opposite_[side];
      opposite_.insert(opposite_.end(), {-1, outer, side});
      if (outer >= 0) opposite_[outer] = 3 * half + 1;
      opposite_[side] = 3 * half + 2;
      return 3 * half;
    };
    const std::int32_t to_end = halve(h);
    if (o < 0) return;
    const std::int32_t to_start = halve(o);
    opposite_[h] = to_start;
    opposite_[to_start] = h;
    opposite_[o] = to_end;
    opposite_[to_end] = o;
  }

  RepairOrigin origin() const {
    RepairOrigin origin;
    origin.face = source_.faces;
    origin.corners.reserve(source_.corners.size());
    for (const auto& [a, b] : source_.corners) {
      origin.corners.push_back(
          {static_cast<std::uint8_t>(a % 3), static_cast<std::uint8_t>(b % 3)});
    }
    return origin;
  }

  const SurfaceMesh& input_;
  RepairReport& report_;
  const Context& context_;
  int stage_ = 0;  // that begins next
  std::vector<Triangle> triangles_;
  std::vector<std::int32_t> opposite_;  // 3 #F, −1: open
  SurfaceSource source_;
};

}  // namespace

SurfaceOrigin RepairOrigin::whole() const {
  SurfaceOrigin origin;
  origin.face = face;
  origin.weights.reserve(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c) origin.weights.push_back(weights(c));
  origin.wall_begin = static_cast<std::int32_t>(face.size());
  return origin;
}

std::string RepairReport::text() const {
  std::string text;
  const auto add = [&](std::int32_t count, const char* verb, const char* one, const char* many) {
    if (count == 0) return;
    if (!text.empty()) text += ", ";
    text.append(verb).append(" ").append(std::to_string(count)).append(" ");
    text.append(count == 1 ? one : many);
  };
  add(merged_vertices, "merged", "vertex", "vertices");
  add(unused_vertices, "dropped", "unused vertex", "unused vertices");
  add(degenerate_faces, "dropped", "degenerate face", "degenerate faces");
  add(duplicate_faces, "dropped", "duplicate face", "duplicate faces");
  add(flipped_faces, "flipped", "face", "faces");
  add(nonmanifold_edges, "untangled", "edge of several faces", "edges of several faces");
  add(cut_edges, "opened", "edge", "edges");
  add(split_vertices, "split off", "vertex", "vertices");
  add(inserted_vertices, "inserted", "vertex", "vertices");
  return text;
}

TracedSurface traced_repair(const SurfaceMesh& input, const RepairOptions& options,
                            RepairReport& report, const Context& context) {
  check_input(input);
  report = {};
  TracedSurface made =
      Workpiece(input, report, context).run(options.tolerance * bounding_diagonal(input.positions));
  const MeshSummary s = summarize(TriangleMesh(made.surface.positions, made.surface.triangles));
  report.components = s.components;
  report.boundary_loops = s.boundary_loops;
  return made;
}

SurfaceMesh repair(const SurfaceMesh& input, const RepairOptions& options, RepairReport& report,
                   const Context& context) {
  return traced_repair(input, options, report, context).surface;
}

}  // namespace craze
