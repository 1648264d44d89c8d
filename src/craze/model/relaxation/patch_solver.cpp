#include "craze/model/relaxation/patch_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace craze {

namespace {

// In mark.
constexpr std::int32_t fixed_node = -2;

// Nodes are asked for this many before they are read.
constexpr std::int32_t rows_ahead = 8;

using Lanes = Vec8f::Lanes;

// Wide values go by reference: how they are returned depends on the machine.
inline void load(Lanes& lanes, const float* from) {
  std::memcpy(&lanes, from, sizeof(lanes));
}

inline void store(float* to, const Lanes& lanes) {
  std::memcpy(to, &lanes, sizeof(lanes));
}

/// (x0, x1, x0, x1, y0, y1, y0, y1)
inline void spread(Lanes& lanes, const float* x, const float* y) {
  double first, second;
  std::memcpy(&first, x, sizeof(double));
  std::memcpy(&second, y, sizeof(double));
  const Vec4d::Lanes pairs = {first, first, second, second};
  std::memcpy(&lanes, &pairs, sizeof(lanes));
}

inline float sum(const Lanes& v) {
  return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
}

inline float largest(const Lanes& v) {
  return std::max(std::max(v[0], v[2]), std::max(v[4], v[6]));
}

/// The two numbers of a node, and two zeros.
inline void load_pair(Vec4f::Lanes& four, const float* from) {
  double both;
  std::memcpy(&both, from, sizeof(both));
  using Doubles = double __attribute__((vector_size(16)));
  const Doubles lanes = {both, 0};
  std::memcpy(&four, &lanes, sizeof(four));
}

/// Nodes [0, count) of y = K p, whose rows are given; returns p·y.
CRAZE_WIDE float multiply(const std::int32_t* row_begin, const std::int32_t* columns,
                          const Vec4f* blocks, std::int32_t count, const float* p, float* y) {
  Vec4f::Lanes py = {0, 0, 0, 0};
  for (std::int32_t i = 0; i < count; ++i) {
    Lanes row = {0, 0, 0, 0, 0, 0, 0, 0}, block, x;
    Vec4f::Lanes pi;
    for (std::int32_t k = row_begin[i]; k < row_begin[i + 1]; k += 2) {
      load(block, reinterpret_cast<const float*>(blocks + k));
      spread(x, p + 2 * std::ptrdiff_t{columns[k]}, p + 2 * std::ptrdiff_t{columns[k + 1]});
      row += block * x;
    }
    // A block's first row lies before its second.
    row += __builtin_shufflevector(row, row, 1, 0, 3, 2, 5, 4, 7, 6);
    const Vec4f::Lanes sums = __builtin_shufflevector(row, row, 0, 1, 2, 3) +
                              __builtin_shufflevector(row, row, 4, 5, 6, 7);
    const Vec4f::Lanes yi = __builtin_shufflevector(sums, sums, 0, 2, 0, 2);
    y[2 * i] = yi[0];
    y[2 * i + 1] = yi[1];
    load_pair(pi, p + 2 * i);
    py += pi * yi;
  }
  return py[0] + py[1];
}

/// What a step of an iteration leaves.
struct StepResult {
  float zr, zq;   ///< z·r and z·q
  float largest;  ///< |r|² of the node where it is largest
};

/// The arrays of an iteration, two numbers a node.
struct Vectors {
  float *x, *r, *z;
  const float *p, *q, *inverse_diagonal, *inverse_off_diagonal;
};

/// x += step p, r −= step q and z = the inverse of the diagonal blocks times r, for nodes
/// [0, count); arrays have room up to a multiple of four nodes, and no more is changed there.
CRAZE_WIDE StepResult take_step(const Vectors& v, std::int32_t count, float step) {
  Lanes zr = {0, 0, 0, 0, 0, 0, 0, 0}, zq = zr, most = zr;
  for (std::int32_t i = 0; i < 2 * count; i += 8) {
    Lanes x, r, p, q, diagonal, off_diagonal;
    load(x, v.x + i);
    load(r, v.r + i);
    load(p, v.p + i);
    load(q, v.q + i);
    load(diagonal, v.inverse_diagonal + i);
    load(off_diagonal, v.inverse_off_diagonal + i);
    x += step * p;
    r -= step * q;
    const Lanes swapped = __builtin_shufflevector(r, r, 1, 0, 3, 2, 5, 4, 7, 6);
    const Lanes z = diagonal * r + off_diagonal * swapped;
    store(v.x + i, x);
    store(v.r + i, r);
    store(v.z + i, z);
    zr += z * r;
    zq += z * q;
    Lanes squares = r * r;
    squares += __builtin_shufflevector(squares, squares, 1, 0, 3, 2, 5, 4, 7, 6);
    // Nodes from `count` on are not looked at.
    const std::int32_t left = 2 * count - i;
    if (left < 8) {
      for (int lane = 0; lane < 8; ++lane) squares[lane] = lane < left ? squares[lane] : 0;
    }
    most = squares > most ? squares : most;
  }
  return {sum(zr), sum(zq), largest(most)};
}

/// p = z + beta p.
CRAZE_WIDE void turn(float* p, const float* z, float beta, std::int32_t count) {
  for (std::int32_t i = 0; i < 2 * count; i += 8) {
    Lanes old, now;
    load(old, p + i);
    load(now, z + i);
    now += beta * old;
    store(p + i, now);
  }
}

}  // namespace

void PatchSolver::join(const Task& task, std::int32_t v) {
  task.mark[v] = static_cast<std::int32_t>(answer_.nodes.size());
  answer_.nodes.push_back(v);
  task.layer.stiffness.prefetch_extent(v);
}

void PatchSolver::read_residuals(const Task& task) {
  // The padding of the last time is no node.
  auto i = static_cast<std::size_t>(residuals_);
  r_.resize(2 * i);
  for (; i < answer_.nodes.size(); ++i) {
    const std::int32_t v = answer_.nodes[i], owner = task.seed_patch[v];
    if (i + rows_ahead < answer_.nodes.size()) task.layer.prefetch(answer_.nodes[i + rows_ahead]);
    if (owner != task.patch && (owner >= 0 || !task.takes_all)) {
      r_.insert(r_.end(), 2, 0.0F);
      continue;
    }
    const PlaneBasis basis(task.layer.field.normals()[v]);
    const Vec3 pull = task.layer.pull(v) / answer_.scale;
    r_.push_back(static_cast<float>(basis.a.dot(pull)));
    r_.push_back(static_cast<float>(basis.b.dot(pull)));
  }
  residuals_ = static_cast<std::int32_t>(answer_.nodes.size());
}

// Patches grow ring by ring, so that doubling would leave half of the largest memory empty.
void PatchSolver::make_room(std::size_t rows) {
  constexpr std::size_t per_row = 8;  // six neighbours and the node, filled up to an even number
  const std::size_t needed = columns_.size() + per_row * rows;
  if (needed <= columns_.capacity()) return;
  const std::size_t room = std::max(needed, columns_.capacity() / 4 * 5);
  columns_.reserve(room);
  blocks_.reserve(room);
}

void PatchSolver::load_rows(const Task& task) {
  std::vector<std::int32_t>& mark = task.mark;
  const auto end = static_cast<std::int32_t>(answer_.nodes.size());
  make_room(static_cast<std::size_t>(end - loaded_));
  for (std::int32_t i = loaded_; i < end; ++i) {
    if (i + rows_ahead < end) task.layer.stiffness.prefetch(answer_.nodes[i + rows_ahead]);
    const TangentStiffness::Row row = task.layer.stiffness.row(answer_.nodes[i]);
    for (std::int32_t k = 0; k < row.count; ++k) {
      const std::int32_t n = row.columns[k];
      if (mark[n] == -1) {
        if (task.layer.field.is_held(n)) {
          mark[n] = fixed_node;
          answer_.held.push_back(n);
        } else {
          join(task, n);
        }
      }
      if (mark[n] < 0) continue;
      columns_.push_back(mark[n]);
      blocks_.push_back(row.blocks[k]);
    }
    if (columns_.size() % 2 != 0) {
      columns_.push_back(i);
      blocks_.emplace_back();
    }
    row_begin_.push_back(static_cast<std::int32_t>(columns_.size()));
  }
  loaded_ = end;
  read_residuals(task);
  const std::size_t padded = 2 * ((answer_.nodes.size() + 3) / 4 * 4);
  for (std::vector<float>* values :
       {&answer_.x, &r_, &z_, &p_, &q_, &inverse_diagonal_, &inverse_off_diagonal_}) {
    values->resize(padded, 0.0F);
  }
}

void PatchSolver::activate() {
  for (std::int32_t i = answer_.active; i < loaded_; ++i) {
    const Vec4f& k = blocks_[row_begin_[i]];
    const float determinant = k[0] * k[3] - k[1] * k[2];
    if (!(determinant > 0)) continue;  // nothing holds it
    inverse_diagonal_[2 * i] = k[3] / determinant;
    inverse_diagonal_[2 * i + 1] = k[0] / determinant;
    inverse_off_diagonal_[2 * i] = inverse_off_diagonal_[2 * i + 1] = -k[2] / determinant;
  }
  answer_.active = loaded_;
}

void PatchSolver::clear() {
  for (std::vector<float>* values :
       {&answer_.x, &r_, &z_, &p_, &q_, &inverse_diagonal_, &inverse_off_diagonal_}) {
    values->clear();
  }
  answer_.nodes.clear();
  answer_.held.clear();
  columns_.clear();
  blocks_.clear();
  row_begin_.assign(1, 0);
  answer_.active = loaded_ = residuals_ = 0;
  answer_.iterations = answer_.node_updates = 0;
}

void PatchSolver::solve(const LayerState& layer, const std::vector<std::int32_t>& seeds,
                        std::int32_t patch, bool takes_all,
                        const std::vector<std::int32_t>& seed_patch,
                        std::vector<std::int32_t>& mark, const StopQuestion& stop) {
  // Residuals are counted in tolerances, or in millionths of the largest where that is more: their
  // squares must fit. Solved is what is below half a tolerance, and single precision cannot tell
  // more than this part of the largest.
  constexpr float precision = 1e-10F;
  constexpr double least_scale = 1e-6;
  constexpr std::int64_t most_iterations = 10'000;
  constexpr std::int64_t between_questions = 8;
  answer_.scale = layer.tolerance;
  for (const std::int32_t v : seeds)
    answer_.scale = std::max(answer_.scale, least_scale * layer.pull(v).norm());
  const double half_tolerance = 0.5 * layer.tolerance / answer_.scale;
  const auto solved = static_cast<float>(half_tolerance * half_tolerance);
  clear();
  const Task task{layer, patch, takes_all, seed_patch, mark};
  for (const std::int32_t v : seeds) {
    if (mark[v] == -1 && !layer.field.is_held(v)) join(task, v);
  }
  load_rows(task);
  float zr = 0, most = 0, allowed = solved;
  const auto take_in_ring = [&](float& zr_sum, float& zq_sum) {
    const std::int32_t first = answer_.active;
    activate();
    for (std::int32_t i = 2 * first; i < 2 * answer_.active; ++i) {
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
  std::copy(z_.begin(), z_.begin() + 2 * answer_.active, p_.begin());

  while (most > allowed && answer_.iterations < most_iterations) {
    if (stop && answer_.iterations % between_questions == 0 && stop()) break;
    const float pq =
        multiply(row_begin_.data(), columns_.data(), blocks_.data(), loaded_, p_.data(), q_.data());
    if (!(pq > 0)) break;
    const float step = zr / pq;
    ++answer_.iterations;
    answer_.node_updates += loaded_;
    StepResult left = take_step({answer_.x.data(), r_.data(), z_.data(), p_.data(), q_.data(),
                                 inverse_diagonal_.data(), inverse_off_diagonal_.data()},
                                loaded_, step);
    most = left.largest;
    allowed = std::max(allowed, precision * most);
    if (answer_.active < loaded_ && largest_in(answer_.active, loaded_) > allowed)
      take_in_ring(left.zr, left.zq);
    // Polak and Ribière's β: the directions stay conjugate as rings come in.
    const float beta = std::max(0.0F, -step * left.zq / zr);
    zr = left.zr;
    turn(p_.data(), z_.data(), beta, answer_.active);
  }
  for (const std::int32_t v : answer_.nodes) mark[v] = -1;
  for (const std::int32_t v : answer_.held) mark[v] = -1;
}

Vec3 PatchAnswer::displacement(const LayerState& layer, std::int32_t i) const {
  const PlaneBasis basis(layer.field.normals()[nodes[i]]);
  const auto k = 2 * static_cast<std::size_t>(i);
  return scale * (static_cast<double>(x[k]) * basis.a + static_cast<double>(x[k + 1]) * basis.b);
}

}  // namespace craze
