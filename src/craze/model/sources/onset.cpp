#include "craze/model/sources/onset.h"

#include <algorithm>
#include <limits>
#include <string>

#include "craze/error.h"
#include "craze/model/relaxation/relaxation.h"

namespace craze {

namespace {

[[noreturn]] void fail(const char* key, const std::string& why) {
  throw Error(ErrorKind::request, "cannot load places one after the other", key, why);
}

bool has_origin(const EvolutionParameters& e) {
  return !e.onset_point.isZero(0) || !e.onset_direction.isZero(0);
}

/// The key that asks for an onset; none where there is none.
const char* asking_key(const EvolutionParameters& e) {
  if (!e.onset_attribute.empty()) return "evolution.onset_attribute";
  if (!e.onset_texture.empty()) return "evolution.onset_texture";
  if (e.onset_speed > 0) return "evolution.onset_speed";
  if (!e.onset_point.isZero(0)) return "evolution.onset_point";
  return has_origin(e) ? "evolution.onset_direction" : nullptr;
}

void check_not_negative(const std::vector<double>& onset, const char* element) {
  const auto bad = std::find_if(onset.begin(), onset.end(), [](double o) { return !(o >= 0); });
  if (bad == onset.end()) return;
  fail("evolution.onset_attribute", "it is " + std::to_string(*bad) + " at " + element + " " +
                                        std::to_string(bad - onset.begin()) +
                                        "; loading starts at 0");
}

void add_front(std::vector<double>& onset, const TriangleMesh& mesh, const EvolutionParameters& e) {
  if (mesh.period().is_given()) {
    fail("evolution.onset_speed", "a front has a first place, and a tile has none");
  }
  const Vec3 direction = e.onset_direction.stableNormalized();
  std::vector<double> distance(onset.size());
  double nearest = std::numeric_limits<double>::infinity();
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Vec3 middle = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
    distance[f] =
        direction.isZero(0) ? (middle - e.onset_point).stableNorm() : direction.dot(middle);
    nearest = std::min(nearest, distance[f]);
  }
  for (std::size_t f = 0; f < onset.size(); ++f)
    onset[f] += (distance[f] - nearest) / e.onset_speed;
}

}  // namespace

std::vector<double> onset_per_face(const TriangleMesh& mesh, const SimulationParameters& parameters,
                                   const InputFields& fields) {
  const EvolutionParameters& e = parameters.evolution;
  const char* key = asking_key(e);
  if (!key) return {};
  if (running_engine(parameters) == Engine::euler) {
    fail(key, "it needs engine = \"quasistatic\" and a layer that adheres: give layer.spacing");
  }
  std::vector<double> onset(static_cast<std::size_t>(mesh.face_count()), 0.0);
  if (!e.onset_attribute.empty()) {
    const char* attribute_key = "evolution.onset_attribute";
    check_not_negative(scalar_per_vertex(mesh, fields, e.onset_attribute, attribute_key), "vertex");
    onset = scalar_per_face(mesh, fields, e.onset_attribute, attribute_key);
    check_not_negative(onset, "face");
  }
  if (!e.onset_texture.empty()) {
    const auto grey =
        texture_per_face(mesh, fields, fields.onset_texture, "evolution.onset_texture");
    for (std::size_t f = 0; f < onset.size(); ++f) onset[f] += e.max_load * grey[f];
  }
  if (e.onset_speed > 0) {
    add_front(onset, mesh, e);
  } else if (has_origin(e)) {
    fail(key, "a front needs a speed: give evolution.onset_speed");
  }
  return onset;
}

}  // namespace craze
