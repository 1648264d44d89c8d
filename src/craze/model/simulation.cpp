#include "craze/model/simulation.h"

#include <algorithm>
#include <chrono>
#include <numbers>
#include <string>

#include "craze/base/error.h"
#include "craze/base/parallel.h"
#include "craze/model/basis_matrix.h"
#include "craze/model/screening.h"

namespace craze {

namespace {

class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// A node is moved by a force above this part of the toughness: far below what any pattern sees, far
// above rounding.
constexpr double rest_force = 1e-7;
// Nothing more can happen once every force is below this part of the toughness.
constexpr double equilibrium_force = 1e-3;
// A node that could not open on a plane is tried again when the plane has turned this much.
constexpr double arrest_cosine = 0.98;

EulerRelaxationOptions relaxation_options(const SimulationParameters& p) {
  return {p.evolution.time_step, adhesion(p.layer), rest_force * p.material.toughness};
}

void check_size(std::size_t size, std::size_t expected, const char* name) {
  if (size != 0 && size != expected) {
    throw Error(ErrorKind::request, "wrong number of values", name,
                std::to_string(size) + " given, " + std::to_string(expected) + " needed");
  }
}

}  // namespace

const char* to_string(StopReason reason) {
  switch (reason) {
    case StopReason::equilibrium:
      return "equilibrium";
    case StopReason::max_load:
      return "max_load";
    case StopReason::max_cracks:
      return "max_cracks";
    case StopReason::cancelled:
      return "cancelled";
  }
  return "";
}

Simulation::Simulation(TriangleMesh mesh, SimulationFields fields,
                       const SimulationParameters& parameters, const Context& context)
    : parameters_(parameters),
      fields_(std::move(fields)),
      mesh_(std::move(mesh)),
      field_(mesh_, craze::singular_value_cap(mesh_)),
      blocks_(mesh_),
      relaxation_(mesh_, relaxation_options(parameters)) {
  const auto faces = static_cast<std::size_t>(mesh_.face_count());
  check_size(fields_.stress.size(), faces, "stress");
  check_size(fields_.growth.size(), faces, "growth");
  check_size(fields_.toughness_scale.size(), faces, "toughness scale");
  check_size(fields_.separation_scale.size(), faces, "separation scale");
  check_size(fields_.fixed.size(), static_cast<std::size_t>(mesh_.vertex_count()), "fixed");

  // 1. Initialize the stress field according to heuristics and optionally evolve it.
  double area = 0;
  for (std::int32_t f = 0; f < mesh_.face_count() && !fields_.stress.empty(); ++f) {
    field_.add_stress(mesh_, f, fields_.stress[f]);
    const Sym3 sigma = field_.stress(mesh_, f);
    initial_tension_ += 0.5 * (sigma.xx + sigma.yy + sigma.zz) * mesh_.area(f);
    area += mesh_.area(f);
  }
  if (area > 0) initial_tension_ /= area;
  field_.update_forces(mesh_);
  relaxation_.fixed = fields_.fixed;

  // 2. Compute the failure criteria for each node and store them in a priority queue.
  changed_nodes_.assign(mesh_.vertex_count(), 1);
  update_failure_criteria(context);
}

StopReason Simulation::run(const Context& context) {
  // 3. While failure can occur and we want to continue:
  while (can_continue(context)) {
    // 3a. Crack the mesh at the node associated with the top of the priority queue.
    const EvolutionParameters& evolution = parameters_.evolution;
    std::int64_t cracks = evolution.cracks_per_step;
    if (evolution.max_cracks > 0) cracks = std::min(cracks, evolution.max_cracks - events_);
    while (cracks > 0 && crack_top()) --cracks;
    // 3b. Evolve the stress field.
    evolve(context);
    // 3c. Update the mesh information and priority queue.
    update_failure_criteria(context);
    context.report({"crack", -1, events_, mesh_.face_count(), load_});
  }
  // 4. For display: post/ and render/.
  return stop_;
}

bool Simulation::can_continue(const Context& context) {
  const EvolutionParameters& evolution = parameters_.evolution;
  const auto stop = [&](StopReason reason) {
    stop_ = reason;
    return false;
  };
  if (context.is_cancelled()) return stop(StopReason::cancelled);
  if (evolution.max_cracks > 0 && events_ >= evolution.max_cracks) {
    return stop(StopReason::max_cracks);
  }
  if (load_ >= evolution.max_load && evolution.shrinkage > 0) return stop(StopReason::max_load);
  if (!queue_.empty()) return true;
  if (evolution.shrinkage > 0 || !fields_.growth.empty()) return true;
  const bool at_rest = time_ > 0 && relaxation_.largest_force() <=
                                        equilibrium_force * parameters_.material.toughness;
  if (at_rest) return stop(StopReason::equilibrium);
  return true;
}

bool Simulation::crack_top() {
  const Stopwatch watch(times_.crack);
  const double tau = parameters_.material.toughness;
  const CrackRules rules{parameters_.crack.snap_angle * std::numbers::pi / 180,
                         parameters_.crack.back_angle * std::numbers::pi / 180};
  while (!queue_.empty()) {
    const std::int32_t v = queue_.top();
    const Eigenpair failure = failing_[v];
    const double threshold = tau * scale_at(fields_.toughness_scale, v);
    open_crack(mesh_, field_, v, failure.vector, rules, static_cast<std::int32_t>(segments()),
               outcome_);
    queue_.remove(v);
    residuals_.erase(v);
    if (outcome_.empty()) {
      arrested_[v] = failure.vector;
      continue;
    }
    for (const CrackSegment& s : outcome_.segments) {
      segments_.push_back({s, time_, static_cast<std::int32_t>(events_)});
    }
    ++events_;

    // New vertices on a held border, and copies of held vertices, are held.
    if (!relaxation_.fixed.empty()) {
      const auto old = static_cast<std::int32_t>(relaxation_.fixed.size());
      relaxation_.fixed.resize(mesh_.vertex_count(), 0);
      for (std::int32_t n = old; n < mesh_.vertex_count(); ++n) {
        const std::int32_t root = mesh_.root(n);
        if (root != n) {
          relaxation_.fixed[n] = relaxation_.fixed[root];
        } else if (const std::int32_t h = mesh_.first_halfedge(n);
                   mesh_.is_open(h) && mesh_.crack_of(h) < 0) {
          relaxation_.fixed[n] = relaxation_.fixed[mesh_.to(h)];
        }
      }
    }

    // [IO06 Eq. 8] The residual v* = v⁺ − τ drives the new tips on.
    for (const std::int32_t tip : outcome_.tips) {
      Sym3 residual;
      add_outer(residual, parameters_.material.alpha * (failure.value - threshold),
                failure.vector);
      residuals_[tip] = residual;
    }
    changed_nodes_.resize(mesh_.vertex_count(), 1);
    for (const std::int32_t n : outcome_.changed_nodes) {
      changed_nodes_[n] = 1;
      arrested_.erase(n);
    }
    blocks_.update(mesh_, outcome_.changed_faces);
    return true;
  }
  return false;
}

void Simulation::evolve(const Context& context) {
  const Stopwatch watch(times_.relax);
  const EvolutionParameters& evolution = parameters_.evolution;
  // 3b.i. Perform relaxation.
  relaxation_.run(field_, mesh_, blocks_, evolution.relaxation_steps, context.threads);
  time_ += evolution.time_step * static_cast<double>(evolution.relaxation_steps);
  // 3b.ii. Optional: add shrinkage tension and/or curvature biasing.
  if (evolution.shrinkage > 0 || !fields_.growth.empty()) add_growth();
}

void Simulation::add_growth() {
  for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
    Sym3 growth;
    if (!fields_.growth.empty()) growth = fields_.growth[mesh_.source_face(f)];
    growth.xx += parameters_.evolution.shrinkage;
    growth.yy += parameters_.evolution.shrinkage;
    growth.zz += parameters_.evolution.shrinkage;
    field_.add_stress(mesh_, f, growth);
  }
  field_.update_forces(mesh_);
  added_tension_ += parameters_.evolution.shrinkage;
  load_ = initial_tension_ > 0 ? 1 + added_tension_ / initial_tension_ : added_tension_;
  changed_nodes_.assign(mesh_.vertex_count(), 1);
}

void Simulation::update_failure_criteria(const Context& context) {
  const Stopwatch watch(times_.separation);
  const std::int32_t nodes = mesh_.vertex_count();
  changed_nodes_.resize(nodes, 1);
  failing_.resize(nodes);
  const std::vector<char>& blocks = relaxation_.changed_blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (!blocks[b]) continue;
    const std::int32_t begin = static_cast<std::int32_t>(b) * ElementBlocks::nodes_per_block;
    const std::int32_t end = std::min(nodes, begin + ElementBlocks::nodes_per_block);
    std::fill(changed_nodes_.begin() + begin, changed_nodes_.begin() + end, 1);
  }
  relaxation_.clear_changed();

  parallel_for(context.threads, static_cast<std::size_t>(nodes), 512,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t v = begin; v < end; ++v) {
                   if (changed_nodes_[v]) evaluate(static_cast<std::int32_t>(v));
                 }
               });
  for (std::int32_t v = 0; v < nodes; ++v) {
    if (!changed_nodes_[v]) continue;
    changed_nodes_[v] = 0;
    queue_.set(v, failing_[v].value);
    // A tip that does not fail has stopped: its residual is spent.
    if (failing_[v].value == 0) residuals_.erase(v);
  }
}

void Simulation::evaluate(std::int32_t v) {
  failing_[v] = {};
  const double tau = parameters_.material.toughness * scale_at(fields_.toughness_scale, v);
  const double scale = scale_at(fields_.separation_scale, v);
  const auto residual = residuals_.find(v);
  const SeparationTensor separation = separation_tensor(mesh_, field_, v);
  if (residual == residuals_.end() && scale * separation.bound <= tau) return;
  Sym3 tensor = scale * separation.tensor;
  if (residual != residuals_.end()) tensor += residual->second;
  const Eigenpair pair = largest_eigenpair(tensor);
  if (!(pair.value > tau)) return;
  const auto arrested = arrested_.find(v);
  if (arrested != arrested_.end() &&
      std::abs(arrested->second.dot(pair.vector)) > arrest_cosine) {
    return;
  }
  failing_[v] = pair;
}

double Simulation::scale_at(const std::vector<double>& per_face, std::int32_t v) const {
  if (per_face.empty()) return 1;
  double sum = 0, count = 0;
  mesh_.for_each_outgoing(v, [&](std::int32_t h) {
    sum += per_face[mesh_.source_face(h / 3)];
    ++count;
  });
  return count > 0 ? sum / count : 1;
}

Sym3 Simulation::separation(std::int32_t v) const {
  return scale_at(fields_.separation_scale, v) * separation_tensor(mesh_, field_, v).tensor;
}

std::vector<double> Simulation::crack_times() const {
  std::vector<double> times;
  times.reserve(segments_.size());
  for (const Segment& s : segments_) times.push_back(s.time);
  return times;
}

}  // namespace craze
