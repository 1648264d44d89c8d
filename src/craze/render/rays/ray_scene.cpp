#include "craze/render/rays/ray_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <new>

namespace craze::render {

struct RayScene::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  const float* vertices = nullptr;         // three numbers each; the scene's own
  const std::uint32_t* corners = nullptr;  // three a face
  ~Handles() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

namespace {

using Mask = std::array<int, RayScene::lanes>;

template <class Packet>
void load(const RayScene::Rays& rays, Packet& packet, Mask& valid) {
  const Ray none{Vec3f::Zero(), Vec3f::UnitZ()};
  for (int i = 0; i < RayScene::lanes; ++i) {
    // Without AVX-512 Embree reads lanes that are not active, too, and Debian's stops where they
    // hold no ray.
    const Ray& ray = rays[i].active ? rays[i] : none;
    valid[i] = ray.active ? -1 : 0;
    packet.org_x[i] = ray.origin.x();
    packet.org_y[i] = ray.origin.y();
    packet.org_z[i] = ray.origin.z();
    packet.dir_x[i] = ray.direction.x();
    packet.dir_y[i] = ray.direction.y();
    packet.dir_z[i] = ray.direction.z();
    packet.tnear[i] = ray.near;
    packet.tfar[i] = std::numeric_limits<float>::infinity();
    packet.time[i] = 0;
    packet.mask[i] = ~0u;
    packet.id[i] = i;
    packet.flags[i] = 0;
  }
}

}  // namespace

RayScene::RayScene(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles)
    : handles_(std::make_unique<Handles>()) {
  // By the widest instruction set there is. So rays along an edge may meet another face on another
  // machine.
  handles_->device = rtcNewDevice(nullptr);
  if (!handles_->device) throw std::bad_alloc();
  handles_->scene = rtcNewScene(handles_->device);
  rtcSetSceneFlags(handles_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), positions.size()));
  auto* corners = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), triangles.size()));
  if (!vertices || !corners) {
    rtcReleaseGeometry(geometry);
    throw std::bad_alloc();
  }
  handles_->vertices = vertices;
  handles_->corners = corners;
  for (const Vec3& p : positions) {
    for (int k = 0; k < 3; ++k) *vertices++ = static_cast<float>(p[k]);
  }
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) *corners++ = static_cast<std::uint32_t>(t[k]);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(handles_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(handles_->scene);
}

RayScene::~RayScene() = default;

// Embree finds the face. Where the ray meets it, it works out from approximate reciprocals, which
// are each maker's own: that is done here.
Hit RayScene::hit_on(const Ray& ray, std::int32_t face) const {
  const auto corner = [&](int k) -> Vec3 {
    const float* p = handles_->vertices + 3 * handles_->corners[3 * face + k];
    return {p[0], p[1], p[2]};
  };
  const Vec3 a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
  const Vec3 direction = ray.direction.cast<double>();
  const Vec3 from_a = ray.origin.cast<double>() - a;
  const Vec3 across = direction.cross(ac), around = from_a.cross(ab);
  const double volume = ab.dot(across);
  double u = 1. / 3, v = u;
  if (volume != 0) {  // not seen edge-on
    u = std::clamp(from_a.dot(across) / volume, 0.0, 1.0);
    v = std::clamp(direction.dot(around) / volume, 0.0, 1 - u);
  }
  const double distance = (u * ab + v * ac - from_a).dot(direction) / direction.squaredNorm();
  return {face, static_cast<float>(distance), static_cast<float>(u), static_cast<float>(v)};
}

void RayScene::intersect(const Rays& rays, Hits& hits) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit16 packet;
  alignas(64) Mask valid;
  load(rays, packet.ray, valid);
  for (unsigned& id : packet.hit.geomID) id = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect16(valid.data(), handles_->scene, &context, &packet);
  for (int i = 0; i < lanes; ++i) {
    const bool hit = rays[i].active && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    hits[i] = hit ? hit_on(rays[i], static_cast<std::int32_t>(packet.hit.primID[i])) : Hit{};
  }
}

Hit RayScene::intersect(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit r;
  r.ray.org_x = ray.origin.x();
  r.ray.org_y = ray.origin.y();
  r.ray.org_z = ray.origin.z();
  r.ray.dir_x = ray.direction.x();
  r.ray.dir_y = ray.direction.y();
  r.ray.dir_z = ray.direction.z();
  r.ray.tnear = ray.near;
  r.ray.tfar = std::numeric_limits<float>::infinity();
  r.ray.time = 0;
  r.ray.mask = ~0u;
  r.ray.id = 0;
  r.ray.flags = 0;
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(handles_->scene, &context, &r);
  if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return hit_on(ray, static_cast<std::int32_t>(r.hit.primID));
}

void RayScene::occluded(const Rays& rays, Flags& hit) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay16 packet;
  alignas(64) Mask valid;
  load(rays, packet, valid);
  rtcOccluded16(valid.data(), handles_->scene, &context, &packet);
  // Embree marks a hit by an infinite negative far distance.
  for (int i = 0; i < lanes; ++i) hit[i] = rays[i].active && packet.tfar[i] < 0;
}

}  // namespace craze::render
