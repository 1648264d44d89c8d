#include "craze/model/patch_solver.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace craze {

namespace {

// In mark.
constexpr std::int32_t fixed_node = -2;

using Lanes = Vec4f::Lanes;

Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}

void store(float* to, const Lanes& lanes) {
  std::memcpy(to, &lanes, sizeof(lanes));
}

/// (x0, x0, x1, x1)
Lanes spread(const float* x) {
  double both;
  std::memcpy(&both, x, sizeof(both));
  using Doubles = double __attribute__((vector_size(16)));
  const Doubles pair = {both, 0};
  Lanes lanes;
  std::memcpy(&lanes, &pair, sizeof(lanes));
  return __builtin_shufflevector(lanes, lanes, 0, 0, 1, 1);
}

float sum(const Lanes& lanes) {
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

/// |r|² of the two nodes, twice each.
Lanes squared(const Lanes& r) {
  const Lanes squares = r * r;
  return squares + __builtin_shufflevector(squares, squares, 1, 0, 3, 2);
}

Lanes larger(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}

float largest(const Lanes& lanes) {
  return std::max(lanes[0], lanes[2]);
}

}  // namespace

void PatchSolver::join(const Task& task, std::int32_t v) {
  task.mark[v] = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back(v);
  const std::int32_t owner = task.seed_patch[v];
  if (owner >= 0 && owner != task.patch) {
    r_.insert(r_.end(), 2, 0.0F);
    return;
  }
  const PlaneBasis basis(task.layer.field.normals()[v]);
  const Vec3 pull = task.layer.pull(v) / scale_;
  r_.push_back(static_cast<float>(basis.a.dot(pull)));
  r_.push_back(static_cast<float>(basis.b.dot(pull)));
}

void PatchSolver::load_rows(const Task& task) {
  std::vector<std::int32_t>& mark = task.mark;
  // The padding of the last time is no node.
  r_.resize(2 * nodes_.size());
  const auto end = static_cast<std::int32_t>(nodes_.size());
  for (std::int32_t i = loaded_; i < end; ++i) {
    const TangentStiffness::Row row = task.layer.stiffness.row(nodes_[i]);
    for (std::int32_t k = 0; k < row.count; ++k) {
      const std::int32_t n = row.columns[k];
      if (mark[n] == -1) {
        if (task.layer.is_fixed(n)) {
          mark[n] = fixed_node;
          held_.push_back(n);
        } else {
          join(task, n);
        }
      }
      if (mark[n] < 0) continue;
      columns_.push_back(mark[n]);
      blocks_.push_back(row.blocks[k]);
    }
    row_begin_.push_back(static_cast<std::int32_t>(columns_.size()));
  }
  loaded_ = end;
  const std::size_t padded = 2 * (nodes_.size() + nodes_.size() % 2);
  for (std::vector<float>* values :
       {&x_, &r_, &z_, &p_, &q_, &inverse_diagonal_, &inverse_off_diagonal_}) {
    values->resize(padded, 0.0F);
  }
}

void PatchSolver::activate() {
  for (std::int32_t i = active_; i < loaded_; ++i) {
    const Vec4f& k = blocks_[row_begin_[i]];
    const float determinant = k[0] * k[3] - k[1] * k[2];
    if (!(determinant > 0)) continue;  // nothing holds it
    inverse_diagonal_[2 * i] = k[3] / determinant;
    inverse_diagonal_[2 * i + 1] = k[0] / determinant;
    inverse_off_diagonal_[2 * i] = inverse_off_diagonal_[2 * i + 1] = -k[1] / determinant;
  }
  active_ = loaded_;
}

float PatchSolver::multiply() {
  Lanes pq = {0, 0, 0, 0};
  for (std::int32_t i = 0; i < loaded_; ++i) {
    Lanes row = {0, 0, 0, 0};
    for (std::int32_t k = row_begin_[i]; k < row_begin_[i + 1]; ++k) {
      row += blocks_[k].v * spread(&p_[2 * columns_[k]]);
    }
    const Lanes y = row + __builtin_shufflevector(row, row, 2, 3, 0, 1);
    std::memcpy(&q_[2 * i], &y, 2 * sizeof(float));
    const float own[2] = {p_[2 * i], p_[2 * i + 1]};
    pq += Lanes{own[0], own[1], 0, 0} * y;
  }
  return sum(pq);
}

void PatchSolver::clear() {
  for (std::vector<float>* values :
       {&x_, &r_, &z_, &p_, &q_, &inverse_diagonal_, &inverse_off_diagonal_}) {
    values->clear();
  }
  nodes_.clear();
  held_.clear();
  columns_.clear();
  blocks_.clear();
  row_begin_.assign(1, 0);
  active_ = loaded_ = 0;
  iterations_ = node_updates_ = 0;
}

void PatchSolver::solve(const LayerState& layer, const std::vector<std::int32_t>& seeds,
                        std::int32_t patch, const std::vector<std::int32_t>& seed_patch,
                        std::vector<std::int32_t>& mark) {
  // Residuals are counted in tolerances, or in millionths of the largest where that is more: their
  // squares must fit. Solved is what is below half a tolerance, and single precision cannot tell
  // more than this part of the largest.
  constexpr float precision = 1e-10F;
  constexpr double least_scale = 1e-6;
  constexpr std::int64_t most_iterations = 10'000;
  scale_ = layer.tolerance;
  for (const std::int32_t v : seeds) scale_ = std::max(scale_, least_scale * layer.pull(v).norm());
  const double half_tolerance = 0.5 * layer.tolerance / scale_;
  const auto solved = static_cast<float>(half_tolerance * half_tolerance);
  clear();
  const Task task{layer, patch, seed_patch, mark};
  for (const std::int32_t v : seeds) {
    if (mark[v] == -1 && !layer.is_fixed(v)) join(task, v);
  }
  load_rows(task);
  float zr = 0, most = 0, allowed = solved;
  const auto take_in_ring = [&](float& zr_sum, float& zq_sum) {
    const std::int32_t first = active_;
    activate();
    for (std::int32_t i = 2 * first; i < 2 * active_; ++i) {
      z_[i] = inverse_diagonal_[i] * r_[i] + inverse_off_diagonal_[i] * r_[i ^ 1];
      zr_sum += z_[i] * r_[i];
      zq_sum += z_[i] * q_[i];
    }
    load_rows(task);
  };
  const auto largest_in = [&](std::int32_t first, std::int32_t last) {
    float found = 0;
    for (std::int32_t i = first; i < last; ++i) {
      found = std::max(found, r_[2 * i] * r_[2 * i] + r_[2 * i + 1] * r_[2 * i + 1]);
    }
    return found;
  };
  float ignored = 0;
  take_in_ring(zr, ignored);
  most = largest_in(0, loaded_);
  allowed = std::max(allowed, precision * most);
  std::copy(z_.begin(), z_.begin() + 2 * active_, p_.begin());

  while (most > allowed && iterations_ < most_iterations) {
    const float pq = multiply();
    if (!(pq > 0)) break;
    const float step = zr / pq;
    ++iterations_;
    node_updates_ += loaded_;
    Lanes zr_sum = {0, 0, 0, 0}, zq_sum = zr_sum, largest_sum = zr_sum;
    const auto update_two = [&](std::int32_t i, const Lanes& counted) {
      const Lanes q = load(&q_[i]);
      const Lanes r = load(&r_[i]) - step * q;
      const Lanes swapped = __builtin_shufflevector(r, r, 1, 0, 3, 2);
      const Lanes z = load(&inverse_diagonal_[i]) * r + load(&inverse_off_diagonal_[i]) * swapped;
      store(&x_[i], load(&x_[i]) + step * load(&p_[i]));
      store(&r_[i], r);
      store(&z_[i], z);
      zr_sum += z * r;
      zq_sum += z * q;
      largest_sum = larger(largest_sum, counted * squared(r));
    };
    const std::int32_t even = 2 * (loaded_ - loaded_ % 2);
    for (std::int32_t i = 0; i < even; i += 4) update_two(i, Lanes{1, 1, 1, 1});
    if (even < 2 * loaded_) update_two(even, Lanes{1, 1, 0, 0});
    float zr_next = sum(zr_sum), zq = sum(zq_sum);
    most = largest(largest_sum);
    allowed = std::max(allowed, precision * most);
    if (active_ < loaded_ && largest_in(active_, loaded_) > allowed) take_in_ring(zr_next, zq);
    // Polak and Ribière's β: the directions stay conjugate as rings come in.
    const float beta = std::max(0.0F, -step * zq / zr);
    zr = zr_next;
    for (std::int32_t i = 0; i < 2 * active_; i += 4) {
      store(&p_[i], load(&z_[i]) + beta * load(&p_[i]));
    }
  }
  converged_ = !(most > solved);
  for (const std::int32_t v : nodes_) mark[v] = -1;
  for (const std::int32_t v : held_) mark[v] = -1;
}

Vec3 PatchSolver::displacement(const LayerState& layer, std::int32_t i) const {
  const PlaneBasis basis(layer.field.normals()[nodes_[i]]);
  const auto k = 2 * static_cast<std::size_t>(i);
  return scale_ * (static_cast<double>(x_[k]) * basis.a + static_cast<double>(x_[k + 1]) * basis.b);
}

}  // namespace craze
