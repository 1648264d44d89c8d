#include "craze/model/initial_state.h"

#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "craze/base/parallel.h"
#include "craze/error.h"
#include "craze/model/failure/failure_criterion.h"
#include "craze/model/relaxation/onset_loading.h"
#include "craze/model/relaxation/relaxation.h"

namespace craze {

namespace {

// Numbers beyond these, in any unit, overflow where they are squared and multiplied.
constexpr double least_number = 1e-60, greatest_number = 1e60;
void check_number(double value, const char* name) {
  if (value == 0 || (std::abs(value) >= least_number && std::abs(value) <= greatest_number)) return;
  std::ostringstream why;
  why << value << " is out of the range that can be computed with, " << least_number << " to "
      << greatest_number;
  throw Error(ErrorKind::request, "cannot simulate", name, why.str());
}

void check_size(std::size_t size, std::size_t expected, const char* name) {
  if (size != 0 && size != expected) {
    throw Error(ErrorKind::request, "wrong number of values", name,
                std::to_string(size) + " given, " + std::to_string(expected) + " needed");
  }
}

void check_stress(const Sym3& sigma) {
  const double size = sigma.matrix().cwiseAbs().maxCoeff();
  if (!(size <= greatest_number)) check_number(size, "stress");
}

void check_sizes(const SimulationFields& fields, const TriangleMesh& mesh) {
  const auto faces = static_cast<std::size_t>(mesh.face_count());
  const auto vertices = static_cast<std::size_t>(mesh.vertex_count());
  check_size(fields.stress.size(), faces, "stress");
  check_size(fields.onset.size(), faces, "onset");
  check_size(fields.growth.size(), faces, "growth");
  check_size(fields.toughness_scale.size(), faces, "toughness scale");
  check_size(fields.separation_scale.size(), faces, "separation scale");
  check_size(fields.adhesion_scale.size(), faces, "adhesion scale");
  check_size(fields.preferred.size(), faces, "preferred directions");
  check_size(fields.fixed.size(), vertices, "fixed");
  check_size(fields.pinned.size(), vertices, "pinned");
}

/// Area mean of √(½ Σ g²), force/length.
double mean_size(const TriangleMesh& mesh, const std::vector<Sym3>& stress) {
  double sum = 0, area = 0;
  for (std::size_t f = 0; f < stress.size(); ++f) {
    const double a = mesh.area(static_cast<std::int32_t>(f));
    sum += a * std::sqrt(0.5) * stress[f].matrix().norm();
    area += a;
  }
  return area > 0 ? sum / area : 0;
}

/// Area mean of tr σ / 2, force/length.
double mean_tension(const CrackedSheet& sheet) {
  double tension = 0, area = 0;
  for (std::int32_t f = 0; f < sheet.mesh().face_count(); ++f) {
    const Sym3 sigma = sheet.field().stress(sheet.mesh(), f);
    tension += 0.5 * (sigma.xx + sigma.yy + sigma.zz) * sheet.mesh().area(f);
    area += sheet.mesh().area(f);
  }
  return area > 0 ? tension / area : 0;
}

}  // namespace

SimulationParameters checked(const SimulationParameters& p) {
  const auto positive = [](double value, const char* name) {
    if (value > 0) return check_number(value, name);
    throw Error(ErrorKind::request, "cannot simulate", name,
                "it must be more than 0: what resists nothing is cracked everywhere");
  };
  if (p.material.criterion == Criterion::strength)
    positive(p.material.strength, "material.strength");
  positive(p.material.toughness, "material.toughness");
  check_number(p.layer.screening_length, "layer.screening_length");
  check_number(p.evolution.shrinkage, "evolution.shrinkage");
  return p;
}

CrackedSheet stressed_sheet(TriangleMesh mesh, const SimulationFields& fields, Engine engine,
                            const Context& context) {
  check_sizes(fields, mesh);
  context.check();
  StressField field(mesh, engine_singular_value_cap(mesh, engine), context.threads);
  context.check();
  for (std::size_t v = 0; v < fields.fixed.size(); ++v) {
    if (!fields.fixed[v]) continue;
    field.hold(static_cast<std::int32_t>(v));
    mesh.pin(static_cast<std::int32_t>(v));
  }
  for (std::size_t v = 0; v < fields.pinned.size(); ++v) {
    if (fields.pinned[v]) mesh.pin(static_cast<std::int32_t>(v));
  }
  const bool apart = is_staggered(fields.onset);
  constexpr std::size_t grain = 1024;
  parallel_for(context.threads, fields.stress.size(), grain,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t f = begin; f < end; ++f) {
                   check_stress(fields.stress[f]);
                   if (apart) continue;
                   field.add_stress(mesh, static_cast<std::int32_t>(f), fields.stress[f]);
                 }
               });
  if (!fields.adhesion_scale.empty()) field.set_adhesion(mesh, fields.adhesion_scale);
  field.update_forces(mesh, context.threads);
  return {std::move(mesh), std::move(field)};
}

InitialLoad initial_load(const CrackedSheet& sheet, SimulationFields& fields,
                         const MaterialParameters& material) {
  InitialLoad load;
  load.tension = mean_tension(sheet);
  load.growth = std::move(fields.growth);
  load.growth_tension = mean_size(sheet.mesh(), load.growth);
  load.onset = std::move(fields.onset);
  if (!is_staggered(load.onset)) return load;
  load.stress = std::move(fields.stress);
  load.stress.resize(load.onset.size());
  const double tension = mean_size(sheet.mesh(), load.stress);
  if (tension > 0) load.failure_load = typical_failure_tension(sheet.mesh(), material) / tension;
  return load;
}

}  // namespace craze
