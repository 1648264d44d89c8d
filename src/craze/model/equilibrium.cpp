#include "craze/model/equilibrium.h"

#include <algorithm>

#include "craze/base/parallel.h"
#include "craze/model/element_response.h"

namespace craze {

namespace {

/// y += K x over the elements, held corners included (their rows are ignored by the caller).
CRAZE_WIDE void add_stiffness(const Element* elements, const std::array<std::int32_t, 3>* corners,
                              std::size_t count, const Vec4d* x, Vec4d* y) {
  for (std::size_t f = 0; f < count; ++f) {
    const auto& corner = corners[f];
    const Vec4d::Lanes x0 = x[corner[0]].v;
    const ElementResponse response =
        element_response(elements[f], x[corner[1]].v - x0, x[corner[2]].v - x0);
    y[corner[0]].v -= response.f1 + response.f2;
    y[corner[1]].v += response.f1;
    y[corner[2]].v += response.f2;
  }
}

double dot(const Vec4d& a, const Vec4d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

Vec3 Equilibrium::residual(const StressField& field, std::int32_t v) const {
  if (is_fixed(v)) return Vec3::Zero();
  const Vec3 r = field.force(v) - options_.adhesion * field.node_areas()[v] * field.displacement(v);
  return r - field.normals()[v].dot(r) * field.normals()[v];
}

void Equilibrium::restore(StressField& field, const TriangleMesh& mesh,
                          const std::vector<std::int32_t>& seeds, int threads,
                          std::vector<std::int32_t>& moved) {
  node_mark_.resize(mesh.vertex_count(), -1);
  face_mark_.resize(mesh.face_count(), 0);
  drift_.resize(mesh.vertex_count(), 0);
  const double allowed = options_.tolerance * options_.tolerance;
  std::vector<std::int32_t> open = seeds;
  for (double radius = options_.radius; !open.empty(); radius *= 1.5) {
    cluster_seeds(mesh, open, 2 * (radius + options_.longest_edge));
    parallel_for(threads, patch_count_, 1, [&](std::size_t i, std::size_t) {
      grow(mesh, patches_[i], radius);
      solve(field, patches_[i]);
      apply(field, mesh, patches_[i]);
    });
    // Whatever a patch pushed out over its rim is a change there: go on from it.
    open.clear();
    for (std::size_t i = 0; i < patch_count_; ++i) {
      Patch& patch = patches_[i];
      iterations_ += patch.iterations;
      element_updates_ += patch.iterations * static_cast<std::int64_t>(patch.elements.size());
      const auto held = static_cast<std::int32_t>(patch.nodes.size());
      for (std::size_t f = 0; f < patch.faces.size(); ++f) {
        face_mark_[patch.faces[f]] = 0;
        for (int c = 0; c < 3; ++c) {
          const std::int32_t v = mesh.triangle(patch.faces[f])[c];
          if (drift_[v] > options_.noticeable) {
            drift_[v] = 0;
            moved.push_back(v);
          }
          if (patch.corners[f][c] == held && residual(field, v).squaredNorm() > allowed) {
            open.push_back(v);
          }
        }
      }
      for (const std::int32_t v : patch.nodes) node_mark_[v] = -1;
    }
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
  }
}

void Equilibrium::cluster_seeds(const TriangleMesh& mesh, const std::vector<std::int32_t>& seeds,
                                double reach) {
  // Seeds within reach of each other belong together: patches must not share an element. Where
  // there are many, telling them apart costs more than it saves.
  constexpr std::size_t many = 1000;
  patch_count_ = 0;
  std::vector<char> taken(seeds.size(), 0);
  std::vector<std::size_t> cluster;
  for (std::size_t first = 0; first < seeds.size(); ++first) {
    if (taken[first]) continue;
    if (patches_.size() == patch_count_) patches_.emplace_back();
    Patch& patch = patches_[patch_count_++];
    patch.seeds.clear();
    if (seeds.size() > many) {
      patch.seeds = seeds;
      return;
    }
    cluster.assign(1, first);
    taken[first] = 1;
    for (std::size_t i = 0; i < cluster.size(); ++i) {
      const Vec3& p = mesh.position(seeds[cluster[i]]);
      patch.seeds.push_back(seeds[cluster[i]]);
      for (std::size_t j = first + 1; j < seeds.size(); ++j) {
        if (taken[j] || (mesh.position(seeds[j]) - p).squaredNorm() > reach * reach) continue;
        taken[j] = 1;
        cluster.push_back(j);
      }
    }
  }
}

void Equilibrium::grow(const TriangleMesh& mesh, Patch& patch, double radius) {
  patch.nodes.clear();
  patch.origin.clear();
  patch.faces.clear();
  patch.corners.clear();
  const auto join = [&](std::int32_t v, std::int32_t seed) {
    node_mark_[v] = static_cast<std::int32_t>(patch.nodes.size());
    patch.nodes.push_back(v);
    patch.origin.push_back(seed);
  };
  for (const std::int32_t v : patch.seeds) {
    if (node_mark_[v] < 0 && !is_fixed(v)) join(v, v);
  }
  for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
    const std::int32_t seed = patch.origin[i];
    const Vec3& center = mesh.position(seed);
    mesh.for_each_outgoing(patch.nodes[i], [&](std::int32_t h) {
      const std::int32_t f = h / 3;
      if (face_mark_[f] != 0) return;
      face_mark_[f] = 1;
      patch.faces.push_back(f);
      for (const std::int32_t n : mesh.triangle(f)) {
        if (node_mark_[n] >= 0 || is_fixed(n)) continue;
        if ((mesh.position(n) - center).squaredNorm() <= radius * radius) join(n, seed);
      }
    });
  }
  const auto held = static_cast<std::int32_t>(patch.nodes.size());
  for (const std::int32_t f : patch.faces) {
    std::array<std::int32_t, 3> corner;
    for (int c = 0; c < 3; ++c) {
      const std::int32_t n = mesh.triangle(f)[c];
      corner[c] = node_mark_[n] >= 0 ? node_mark_[n] : held;
    }
    patch.corners.push_back(corner);
  }
}

void Equilibrium::solve(const StressField& field, Patch& patch) const {
  const std::size_t n = patch.nodes.size();
  patch.elements.clear();
  for (const std::int32_t f : patch.faces) patch.elements.push_back(field.elements()[f]);
  patch.x.assign(n + 1, Vec4d{});
  patch.r.assign(n + 1, Vec4d{});
  patch.p.assign(n + 1, Vec4d{});
  patch.q.assign(n + 1, Vec4d{});
  patch.mass.resize(n);
  patch.normals.resize(n);
  patch.inverse_diagonal.assign(n + 1, 0.0);

  // Jacobi: a third of the trace of each node's 3×3 block, ½ (|B|² P + B Bᵀ) per element corner
  // with B_a = Σ N_ab e_b and P the projection on its plane.
  for (std::size_t f = 0; f < patch.elements.size(); ++f) {
    const Element& e = patch.elements[f];
    const Vec3 b1 = e.e1[3] * e.edge1() + e.e2[3] * e.edge2();
    const Vec3 b2 = e.e2[3] * e.edge1() + e.t[3] * e.edge2();
    const auto& corner = patch.corners[f];
    patch.inverse_diagonal[corner[0]] += 0.5 * (b1 + b2).squaredNorm();
    patch.inverse_diagonal[corner[1]] += 0.5 * b1.squaredNorm();
    patch.inverse_diagonal[corner[2]] += 0.5 * b2.squaredNorm();
  }
  double rz = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int32_t v = patch.nodes[i];
    const Vec3& normal = field.normals()[v];
    patch.normals[i].v = Vec4d::Lanes{normal.x(), normal.y(), normal.z(), 0};
    patch.mass[i] = options_.adhesion * field.node_areas()[v];
    patch.inverse_diagonal[i] = 1 / (patch.inverse_diagonal[i] + patch.mass[i]);
    const Vec3 r = residual(field, v);
    patch.r[i].v = Vec4d::Lanes{r.x(), r.y(), r.z(), 0};
    patch.p[i].v = patch.inverse_diagonal[i] * patch.r[i].v;
    rz += dot(patch.r[i], patch.p[i]);
  }

  // Conjugate gradients until every node's force is well below the tolerance.
  const double allowed = 0.25 * options_.tolerance * options_.tolerance;
  for (patch.iterations = 0; patch.iterations < 10'000; ++patch.iterations) {
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, dot(patch.r[i], patch.r[i]));
    if (!(largest > allowed)) break;
    for (std::size_t i = 0; i < n; ++i) patch.q[i].v = patch.mass[i] * patch.p[i].v;
    add_stiffness(patch.elements.data(), patch.corners.data(), patch.elements.size(),
                  patch.p.data(), patch.q.data());
    double pq = 0;
    for (std::size_t i = 0; i < n; ++i) {
      patch.q[i].v -= dot(patch.q[i], patch.normals[i]) * patch.normals[i].v;
      pq += dot(patch.p[i], patch.q[i]);
    }
    if (!(pq > 0)) break;
    const double step = rz / pq;
    double rz_next = 0;
    for (std::size_t i = 0; i < n; ++i) {
      patch.x[i].v += step * patch.p[i].v;
      patch.r[i].v -= step * patch.q[i].v;
      rz_next += patch.inverse_diagonal[i] * dot(patch.r[i], patch.r[i]);
    }
    const double beta = rz_next / rz;
    rz = rz_next;
    for (std::size_t i = 0; i < n; ++i) {
      patch.p[i].v = patch.inverse_diagonal[i] * patch.r[i].v + beta * patch.p[i].v;
    }
  }
}

void Equilibrium::apply(StressField& field, const TriangleMesh& mesh, const Patch& patch) {
  for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
    Vec4d& u = field.displacements()[patch.nodes[i]];
    u.v += patch.x[i].v;
    u[3] = 0;
  }
  for (std::size_t f = 0; f < patch.faces.size(); ++f) {
    const auto& corner = patch.corners[f];
    const Vec4d &x0 = patch.x[corner[0]], &x1 = patch.x[corner[1]], &x2 = patch.x[corner[2]];
    field.displace(patch.faces[f], mesh.triangle(patch.faces[f]), x0, x1, x2, drift_);
  }
}

}  // namespace craze
