#include "craze/mesh/remesh/remesh_surface.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "craze/error.h"
#include "craze/mesh/remesh/edge_length_field.h"
#include "craze/mesh/remesh/feature_lines.h"

namespace craze {

namespace {

// Lengths between the two thresholds come out a little shorter than wanted: measured on flat and
// round shapes, their mean is 1/1.055 of it.
constexpr double centre_of_band = 1.055;
constexpr double length_variation = 0.15;  // of the length wanted, seeded
constexpr double most_faces = 50e6;

}  // namespace

RemeshSurface::RemeshSurface(const SurfaceMesh& input_mesh, const TriangleMesh& topology,
                             const RemeshOptions& remesh_options, RemeshProgress& remesh_progress)
    : input(input_mesh),
      options(remesh_options),
      progress(remesh_progress),
      variation(options.seed, 1),
      place(options.seed, 2),
      shaking(options.seed, 3),
      max_distance(options.max_distance > 0 ? options.max_distance : 0.1 * options.target_edge),
      lengths(edge_length_field(topology, options.target_edge, options.coarsen)),
      marks(without_short_creases(topology, feature_lines(input, topology, options.feature_angle),
                                  lengths)),
      patch(patches(topology.face_count(), marks, seam,
                    [&](std::int32_t h) { return topology.opposite(h); })),
      tree(input.positions, input.triangles, patch),
      walk(topology, tree),
      mesh(topology, marks) {
  look_everywhere_again();
  refuse_too_many(topology);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    add_vertex(lengths[v], mesh.is_vertex(v) ? topology.first_halfedge(v) / 3 : -1);
  }
}

void RemeshSurface::refuse_too_many(const TriangleMesh& topology) const {
  double faces = 0;
  for (std::int32_t f = 0; f < topology.face_count(); ++f) {
    double there = 0;
    for (std::int32_t v : topology.triangle(f)) there += lengths[v] / 3;
    faces += topology.area(f) / (std::sqrt(3.0) / 4 * there * there);
  }
  if (faces <= most_faces) return;
  throw Error(ErrorKind::request, "simulation mesh too fine",
              "target edge " + std::to_string(options.target_edge),
              "it would have about " + std::to_string(std::llround(faces / 1e6)) +
                  " million triangles; ask for a longer edge");
}

void RemeshSurface::add_vertex(double length_there, std::int32_t near_face) {
  const double u = variation.uniform_at(wanted.size());
  length.push_back(length_there);
  wanted.push_back(centre_of_band * length_there * (1 + length_variation * (2 * u - 1)));
  near.push_back(near_face);
  line_error.push_back(0);
}

double RemeshSurface::edge_length(std::int32_t h) const {
  return mesh.period().shortest(mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
}

Vec3 RemeshSurface::face_cross(std::int32_t f) const {
  const Triangle& t = mesh.triangle(f);
  const Vec3& a = mesh.position(t[0]);
  return cross_of(a, mesh.position_near(t[1], a), mesh.position_near(t[2], a));
}

std::int32_t RemeshSurface::split(std::int32_t h, const Vec3& at) {
  const std::int32_t a = mesh.from(h), b = mesh.to(h);
  const std::int32_t x = mesh.split(h, at);
  add_vertex(0.5 * (length[a] + length[b]), near[a]);
  line_error.back() = std::max(line_error[a], line_error[b]);
  for (std::vector<char>* flags : {&may_flip, &may_be_long, &may_be_short}) {
    flags->resize(mesh.halfedge_slots(), 1);
  }
  look_around_again(x);
  return x;
}

void RemeshSurface::look_around_again(std::int32_t v) {
  mesh.for_each_outgoing(v, [&](std::int32_t h) { look_at_again(h / 3); });
}

void RemeshSurface::look_at_again(std::int32_t f) {
  for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
    may_flip[h] = may_be_long[h] = may_be_short[h] = 1;
    const std::int32_t o = mesh.opposite(h);
    if (o >= 0) may_flip[o] = may_be_long[o] = may_be_short[o] = 1;
  }
}

void RemeshSurface::look_everywhere_again() {
  for (std::vector<char>* flags : {&may_flip, &may_be_long, &may_be_short}) {
    flags->assign(mesh.halfedge_slots(), 1);
  }
}

}  // namespace craze
