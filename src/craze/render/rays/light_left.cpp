#include "craze/render/rays/light_left.h"

#include "craze/render/rays/rays.h"

namespace craze::render {

LightLeft::LightLeft(const TracedModel& model, const Material& material, const RayScene& scene)
    : model_(model), material_(material), scene_(scene) {
  if (material.glass) return;
  std::vector<Triangle> solids, clears;
  for (std::size_t f = 0; f < model.triangles.size(); ++f) {
    const auto face = static_cast<std::int32_t>(f);
    const Look* look = model.look_of(face);
    const bool is_clear = look && look->is_see_through();
    (is_clear ? clears : solids).push_back(model.triangles[f]);
    if (is_clear) clear_faces_.push_back(face);
  }
  if (clears.empty()) return;
  clears_ = std::make_unique<const RayScene>(model.positions, clears);
  if (!solids.empty()) solids_ = std::make_unique<const RayScene>(model.positions, solids);
}

float LightLeft::through(Ray ray) const {
  float left = 1;
  for (int layer = 0; layer < most_layers && left > least_seen; ++layer) {
    Hit hit = clears_->intersect(ray);
    if (hit.face < 0) break;
    hit.face = clear_faces_[hit.face];
    left *= luminance(body_at(model_, material_, hit).clear());
    ray.near = behind(hit, ray);
  }
  return left;
}

void LightLeft::along(const RayScene::Rays& rays, Lanes& left) const {
  RayScene::Flags hidden{};
  if (!clears_) {
    scene_.occluded(rays, hidden);
  } else if (solids_) {
    solids_->occluded(rays, hidden);
  }
  for (int i = 0; i < RayScene::lanes; ++i) {
    left[i] = hidden[i] ? 0 : clears_ && rays[i].active ? through(rays[i]) : 1;
  }
}

}  // namespace craze::render
