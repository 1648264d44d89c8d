#include "craze/model/stress_field.h"

#include <cmath>
#include <cstddef>

#include "craze/base/parallel.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/basis_matrix.h"
#include "craze/model/element_response.h"

namespace craze {

namespace {

constexpr std::size_t grain = 1024;
// Bytes of memory that the system gives only where it is written to: room there costs nothing, and
// to copy all of it, for more or less of it, as much again.
constexpr std::size_t large = std::size_t{1} << 25;

/// T of the world tensor sigma: T_ab = A b_a·σ b_b, with b_a = Σ_c H_ac e_c the dual of e_a and
/// A H = √A N.
void add_components(Element& e, double root_area, const Sym3& sigma) {
  const Vec3 b1 = root_area * (e.e1[3] * e.edge1() + e.e2[3] * e.edge2());
  const Vec3 b2 = root_area * (e.e2[3] * e.edge1() + e.t[3] * e.edge2());
  // b1 and b2 above carry a factor A, so one A is taken out again.
  const double inverse = root_area > 0 ? 1 / (root_area * root_area) : 0;
  const Vec3 s1 = sigma * b1, s2 = sigma * b2;
  e.t[0] += inverse * b1.dot(s1);
  e.t[1] += inverse * b2.dot(s2);
  e.t[2] += inverse * b1.dot(s2);
}

/// Σ T_ab e_a e_bᵀ / A, the mixed term through (e₁ + e₂)(e₁ + e₂)ᵀ.
Sym3 stress_of(const Element& e, double area) {
  Sym3 sigma;
  if (!(area > 0)) return sigma;
  add_outer(sigma, (e.t[0] - e.t[2]) / area, e.edge1());
  add_outer(sigma, (e.t[1] - e.t[2]) / area, e.edge2());
  add_outer(sigma, e.t[2] / area, e.edge1() + e.edge2());
  return sigma;
}

/// What displacements of the corners make of an element's stress.
ElementResponse response_to(const Element& e, const std::vector<Vec4d>& u, const Triangle& t) {
  return element_response(e, u[t[1]].v - u[t[0]].v, u[t[2]].v - u[t[0]].v);
}

CRAZE_WIDE void displace_elements(Element* elements, const Triangle* triangles,
                                  const std::int32_t* faces, std::size_t count,
                                  const std::int32_t* slot, const Vec4d* shifts, Vec4d* forces,
                                  double* drift) {
  // Faces come in the order of the nodes, which on a scanned mesh is none: they are asked for
  // early.
  constexpr std::size_t ahead = 8;
  const Vec4d::Lanes none = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    if (i + ahead < count) {
      const char* next = reinterpret_cast<const char*>(&elements[faces[i + ahead]]);
      __builtin_prefetch(next);
      __builtin_prefetch(next + sizeof(Element) - 1);
      __builtin_prefetch(&triangles[faces[i + ahead]]);
    }
    const Triangle& corners = triangles[faces[i]];
    const std::int32_t s0 = slot[corners[0]], s1 = slot[corners[1]], s2 = slot[corners[2]];
    if (s0 < 0 && s1 < 0 && s2 < 0) continue;
    const Vec4d::Lanes u0 = s0 < 0 ? none : shifts[s0].v, u1 = s1 < 0 ? none : shifts[s1].v,
                       u2 = s2 < 0 ? none : shifts[s2].v;
    Element& element = elements[faces[i]];
    const ElementResponse response = element_response(element, u1 - u0, u2 - u0);
    response.add_stress_to(element);
    const Vec4d::Lanes changes[3] = {response.f1 + response.f2, -response.f1, -response.f2};
    const double most = response.force_bound();
    for (int c = 0; c < 3; ++c) {
      forces[corners[c]].v += changes[c];
      forces[corners[c]][3] = 0;
      drift[corners[c]] += most;
    }
  }
}

}  // namespace

StressField::StressField(const TriangleMesh& mesh, double cap, const Threads& threads)
    : cap_(cap),
      elements_(mesh.face_count()),
      forces_(mesh.vertex_count()),
      displacements_(mesh.vertex_count()),
      normals_(mesh.vertex_count(), Vec3::Zero()),
      node_areas_(mesh.vertex_count(), 0.0) {
  if (elements_.size() * sizeof(Element) > large) elements_.reserve(elements_.size() / 2 * 3);
  parallel_for(threads, elements_.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      elements_[f] = make_element(mesh, static_cast<std::int32_t>(f));
    }
  });
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const double third = mesh.area(f) / 3;
    const Triangle& t = mesh.triangle(f);
    const Vec3 normal = mesh.way(t[0], t[1]).cross(mesh.way(t[0], t[2]));
    for (const std::int32_t v : t) {
      node_areas_[v] += third;
      normals_[v] += normal;
    }
  }
  for (Vec3& n : normals_) n.normalize();
}

Element StressField::make_element(const TriangleMesh& mesh, std::int32_t f) const {
  const Vec3 p0 = mesh.corner(f, 0), p1 = mesh.corner(f, 1), p2 = mesh.corner(f, 2);
  const double area = mesh.area(f);
  Element e;
  if (!(area > 0)) return e;  // no area: bears no stress and exerts no force
  const Mat2 beta = cap_singular_values(basis_matrix(p0, p1, p2), cap_);
  const Mat32 edges = tangent_frame(p0, p1, p2) * beta.inverse();
  const Mat2 n = std::sqrt(area) * beta * beta.transpose();
  e.e1.v = Vec4d::Lanes{edges(0, 0), edges(1, 0), edges(2, 0), n(0, 0)};
  e.e2.v = Vec4d::Lanes{edges(0, 1), edges(1, 1), edges(2, 1), n(0, 1)};
  e.t.v = Vec4d::Lanes{0, 0, 0, n(1, 1)};
  return e;
}

Sym3 StressField::stress(const TriangleMesh& mesh, std::int32_t f) const {
  return stress_of(elements_[f], mesh.area(f));
}

void StressField::add_stress(const TriangleMesh& mesh, std::int32_t f, const Sym3& sigma) {
  add_components(elements_[f], std::sqrt(mesh.area(f)), sigma);
}

void StressField::update_force(const TriangleMesh& mesh, std::int32_t v) {
  Vec3 force = Vec3::Zero();
  mesh.for_each_outgoing(v,
                         [&](std::int32_t h) { force += element_force(elements_[h / 3], h % 3); });
  forces_[v].v = Vec4d::Lanes{force.x(), force.y(), force.z(), 0};
}

void StressField::update_forces(const TriangleMesh& mesh, const Threads& threads) {
  parallel_for(threads, forces_.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) update_force(mesh, static_cast<std::int32_t>(v));
  });
}

void StressField::displace(const TriangleMesh& mesh, const std::vector<std::int32_t>& faces,
                           const std::vector<std::int32_t>& slot, const std::vector<Vec4d>& shifts,
                           std::vector<double>& drift) {
  displace_elements(elements_.data(), mesh.triangles().data(), faces.data(), faces.size(),
                    slot.data(), shifts.data(), forces_.data(), drift.data());
}

void StressField::update_node_area(const TriangleMesh& mesh, std::int32_t v) {
  double area = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    area += mesh.area(h / 3) * (adhesion_.empty() ? 1 : adhesion_[mesh.source_face(h / 3)]);
  });
  node_areas_[v] = area / 3;
}

void StressField::set_adhesion(const TriangleMesh& mesh, std::vector<double> factors) {
  adhesion_ = std::move(factors);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) update_node_area(mesh, v);
}

void StressField::hold(std::int32_t v) {
  held_.resize(forces_.size(), 0);
  held_[v] = 1;
}

void StressField::follow(const TriangleMesh& mesh, const TriangleMesh::Split& split,
                         std::int32_t from, std::int32_t to, double t) {
  Vec4d u;
  u.v = (1 - t) * displacements_[from].v + t * displacements_[to].v;
  displacements_.push_back(u);
  normals_.emplace_back(((1 - t) * normals_[from] + t * normals_[to]).normalized());
  forces_.emplace_back();
  node_areas_.push_back(0);
  if (!held_.empty()) {
    const std::int32_t h = mesh.first_halfedge(split.vertex);
    const bool on_border = mesh.is_open(h) && mesh.crack_of(h) < 0;
    held_.push_back(on_border ? held_[mesh.to(h)] : 0);
  }
  elements_.resize(mesh.face_count());
  for (int side = 0; side < 2; ++side) {
    if (split.face[side] < 0) continue;
    // The old element still holds the whole parent: σ is its A σ over the area of both halves.
    const std::int32_t f = split.face[side], half = split.new_face[side];
    const Sym3 sigma = stress_of(elements_[f], mesh.area(f) + mesh.area(half));
    for (const std::int32_t child : {f, half}) {
      elements_[child] = make_element(mesh, child);
      add_stress(mesh, child, sigma);
    }
  }
  for (int side = 0; side < 2; ++side) {
    if (split.face[side] < 0) continue;
    for (const std::int32_t child : {split.face[side], split.new_face[side]}) {
      for (const std::int32_t v : mesh.triangle(child)) {
        update_force(mesh, v);
        update_node_area(mesh, v);
      }
    }
  }
}

std::vector<Sym3> StressField::unstrained_stress(const TriangleMesh& mesh, std::int32_t v) const {
  std::vector<Sym3> stress;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const std::int32_t f = TriangleMesh::face_of(h);
    Element e = elements_[f];
    const ElementResponse strained = response_to(e, displacements_, mesh.triangle(f));
    e.t[0] -= strained.t11;
    e.t[1] -= strained.t22;
    e.t[2] -= strained.t12;
    stress.push_back(stress_of(e, mesh.area(f)));
  });
  return stress;
}

void StressField::follow_slide(const TriangleMesh& mesh, std::int32_t v, std::int32_t toward,
                               double t, const std::vector<Sym3>& unstrained) {
  displacements_[v].v = (1 - t) * displacements_[v].v + t * displacements_[toward].v;
  normals_[v] = ((1 - t) * normals_[v] + t * normals_[toward]).normalized();
  std::size_t i = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const std::int32_t f = TriangleMesh::face_of(h);
    elements_[f] = make_element(mesh, f);
    add_stress(mesh, f, unstrained[i++]);
    response_to(elements_[f], displacements_, mesh.triangle(f)).add_stress_to(elements_[f]);
  });
  const auto update = [&](std::int32_t n) {
    update_force(mesh, n);
    update_node_area(mesh, n);
  };
  update(v);
  mesh.for_each_outgoing(v, [&](std::int32_t h) { update(mesh.to(h)); });
}

void StressField::follow(const TriangleMesh& mesh, std::int32_t vertex, std::int32_t copy) {
  if (copy < 0) return;
  displacements_.push_back(Vec4d(displacements_[vertex]));
  normals_.push_back(Vec3(normals_[vertex]));
  forces_.emplace_back();
  node_areas_.push_back(0);
  if (!held_.empty()) held_.push_back(char(held_[vertex]));
  for (const std::int32_t v : {vertex, copy}) {
    update_force(mesh, v);
    update_node_area(mesh, v);
  }
}

void StressField::renumber(const Numbering& numbering) {
  reorder(adhesion_, numbering.faces);
  reorder(elements_, numbering.faces);
  for (auto* vectors : {&forces_, &displacements_}) reorder(*vectors, numbering.vertices);
  reorder(normals_, numbering.vertices);
  reorder(node_areas_, numbering.vertices);
  reorder(held_, numbering.vertices);
}

void StressField::shrink_to_fit() {
  if (elements_.size() * sizeof(Element) <= large) elements_.shrink_to_fit();
  for (auto* vectors : {&forces_, &displacements_}) vectors->shrink_to_fit();
  normals_.shrink_to_fit();
  node_areas_.shrink_to_fit();
  held_.shrink_to_fit();
}

}  // namespace craze
