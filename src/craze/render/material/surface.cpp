#include "craze/render/material/surface.h"

#include <algorithm>

#include "craze/base/random.h"
#include "craze/render/material/noise.h"
#include "craze/render/material/pattern.h"

namespace craze::render {

const Look* TracedModel::look_of(std::int32_t face) const {
  if (is_wall[face]) return nullptr;
  const std::int32_t index = looks.empty() ? -1 : look.empty() ? 0 : look[face];
  return index < 0 ? nullptr : &looks[index];
}

const std::vector<Eigen::Vector2f>& TracedModel::uvs_of(const PlacedTexture& texture) const {
  static const std::vector<Eigen::Vector2f> none;
  if (texture.uv_set == 0) return uvs;
  return texture.uv_set <= further_uvs.size() ? further_uvs[texture.uv_set - 1] : none;
}

namespace {

/// Where there are such UVs.
Eigen::Vector2f uv_at(const TracedModel& model, const PlacedTexture& texture, const Hit& hit) {
  if (!texture) return Eigen::Vector2f::Zero();
  const Eigen::Vector2f* uv = &model.uvs_of(texture)[static_cast<std::size_t>(3) * hit.face];
  return (1 - hit.u - hit.v) * uv[0] + hit.u * uv[1] + hit.v * uv[2];
}

/// The smooth normal bent by the look's normal picture, along the face's directions of u and v.
/// `ab`, `ac`: edges of the face; `normal` on the side that its corners turn counterclockwise.
Vec3f mapped_normal(const TracedModel& model, const Hit& hit, const Vec3f& ab, const Vec3f& ac,
                    const Vec3f& normal) {
  const Look* look = model.look_of(hit.face);
  if (!look || !look->normals) return normal;
  const Eigen::Vector2f* uv = &model.uvs_of(look->normals)[static_cast<std::size_t>(3) * hit.face];
  const Eigen::Vector2f b = uv[1] - uv[0], c = uv[2] - uv[0];
  const float area = b.x() * c.y() - b.y() * c.x();
  const Vec3f along_u = (c.y() * ab - b.y() * ac) * (area < 0 ? -1.0f : 1.0f);
  const Vec3f tangent = (along_u - along_u.dot(normal) * normal).stableNormalized();
  if (area == 0 || tangent.isZero()) return normal;
  const Vec3f bitangent = (area < 0 ? -1.0f : 1.0f) * normal.cross(tangent);
  const Vec3f n = look->tangent_normal(uv_at(model, look->normals, hit));
  return (n.x() * tangent + n.y() * bitangent + n.z() * normal).normalized();
}

}  // namespace

LookSample body_at(const TracedModel& model, const Material& material, const Hit& hit) {
  if (model.is_wall[hit.face]) return {material.wall};
  const Look* look = model.look_of(hit.face);
  if (!look) return {material.color};
  return look->at(uv_at(model, look->picture, hit), uv_at(model, look->transmission_picture, hit));
}

float fresnel(float cosine) {
  // Schlick's approximation for a refractive index of 1.5.
  const float m = 1 - std::clamp(cosine, 0.0f, 1.0f), m2 = m * m;
  return 0.04f + 0.96f * m2 * m2 * m;
}

LineSample line_at(const TracedModel& model, const Hit& hit, const Vec3f& place, float footprint) {
  if (!model.lines || model.is_wall[hit.face]) return {};
  return model.lines->at(hit.face, place, footprint);
}

Surface surface_at(const TracedModel& model, const Material& material, const Ray& ray,
                   const Hit& hit, float footprint) {
  const Triangle& t = model.triangles[hit.face];
  const float w0 = 1 - hit.u - hit.v;
  const Vec3f a = model.positions[t[0]].cast<float>(), b = model.positions[t[1]].cast<float>(),
              c = model.positions[t[2]].cast<float>();
  const Vec3f* n = &model.normals[static_cast<std::size_t>(3) * hit.face];

  Surface s;
  s.view = ray.direction.normalized();
  s.position = w0 * a + hit.u * b + hit.v * c;
  s.geometric = (b - a).cross(c - a).stableNormalized();
  s.normal = (w0 * n[0] + hit.u * n[1] + hit.v * n[2]).stableNormalized();
  if (s.normal.dot(s.geometric) < 0) s.normal = -s.normal;
  s.normal = mapped_normal(model, hit, b - a, c - a, s.normal);
  if (s.geometric.dot(s.view) > 0) s.geometric = -s.geometric;
  if (s.normal.dot(s.geometric) < 0) s.normal = -s.normal;
  if (s.normal.isZero()) s.normal = s.geometric;
  const auto place = [&](int i) { return model.places[t[i]].cast<float>(); };
  s.place = w0 * place(0) + hit.u * place(1) + hit.v * place(2);
  // [Hanika 2021, "Hacking the shadow terminator"] Up to the planes through the corners across
  // their normals.
  s.raised = s.position;
  const float weights[3] = {w0, hit.u, hit.v};
  const Vec3f* corners[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    const Vec3f up = n[i].dot(s.geometric) < 0 ? Vec3f(-n[i]) : n[i];
    s.raised -= weights[i] * std::min(0.0f, up.dot(s.position - *corners[i])) * up;
  }

  const bool wall = model.is_wall[hit.face] != 0;
  const LookSample body = body_at(model, material, hit);
  s.cover = body.cover;
  s.clear = body.clear();
  s.albedo = body.cover * (1 - body.transmission) * body.color;
  s.coat = wall ? 0 : body.cover * std::max(material.coat, body.transmission);
  const MarkSample mark =
      wall || model.marks.empty() ? MarkSample{} : marks_at(model.marks, s.place, footprint);
  if (!wall) {
    // Colours of marks are premultiplied by their cover.
    s.albedo = (1 - mark.cover) * s.albedo + mark.color;
    s.clear *= 1 - mark.cover;
    s.cover += mark.cover * (1 - s.cover);
    s.normal = (s.normal + mark.tilt).normalized();
    const LineSample line = line_at(model, hit, s.place, footprint);
    float core = line.core * material.line_strength;
    if (material.patchiness > 0 && core > 0) {
      const float pale = fractal_noise(70 * (s.place + material.pattern.shift), 3).value;
      core *= 1 - material.patchiness * smoothstep(-0.4f, 0.5f, pale);
    }
    s.albedo *= 1 - line.stain * material.stain;
    s.clear *= 1 - line.stain * material.stain;
    s.albedo += core * (material.line - s.albedo);
    s.clear *= 1 - core;
    s.cover += core * (1 - s.cover);
    s.coat *= 1 - 0.7f * core;
    const float lean = model.lines && model.lines->shows_gaps() ? material.worn : material.groove;
    s.normal = (s.normal + lean * line.tilt).normalized();
  }
  // A smooth normal may turn away from the eye at the silhouette.
  const float away = s.normal.dot(s.view);
  if (away > -0.01f) s.normal = (s.normal - (away + 0.01f) * s.view).normalized();
  s.coat *= fresnel(-s.normal.dot(s.view));
  s.albedo *= (1 - s.coat) * mark.light;
  s.clear *= 1 - s.coat;
  s.lit = s.cover > 0;
  return s;
}

Grain grain_at(const Material& material, const Vec3f& of_body, std::int32_t piece, bool wall,
               float footprint) {
  Grain grain;
  const Vec3f place = of_body + material.pattern.shift;
  const Random random(static_cast<std::uint64_t>(piece));
  if (material.pieces > 0 && !wall) {
    grain.tint += 0.16f * material.pieces * static_cast<float>(random.uniform_at(0) - 0.5);
    for (int k = 0; k < 3; ++k) {
      grain.tilt[k] = 0.1f * material.pieces * static_cast<float>(random.uniform_at(k + 1) - 0.5);
    }
  }
  if (material.mottle > 0) grain.tint += material.mottle * fractal_noise(14 * place).value;
  if (material.aggregate > 0) {
    const Cell stone = nearest_cell(place / material.aggregate_size);
    const Random of_stone(stone.id);
    // The binder between stones is darker.
    const float gap = 1 - smoothstep(0, 0.12f, stone.second - stone.first);
    grain.tint += material.aggregate *
                  (0.5f * static_cast<float>(of_stone.uniform_at(0) - 0.5) - 0.35f * gap);
  }
  if (material.grit > 0) {
    const float spot =
        value_noise(330 * place).value * (0.6f + 0.4f * value_noise(60 * place).value);
    grain.tint += 0.22f * material.grit * spot;
    grain.tilt -= 0.16f * material.grit * fractal_noise(130 * place, 2).gradient;
  }
  if (material.bump > 0) {
    const float frequency = wall ? 60 : 34, strength = (wall ? 2 : 1) * material.bump;
    grain.tilt -= strength * fractal_noise(frequency * place).gradient;
  }
  if (!wall) {
    const PatternSample pattern = pattern_at(material.pattern, of_body, footprint);
    grain.tint *= pattern.tint;
    grain.tilt += pattern.tilt;
  }
  return grain;
}

}  // namespace craze::render
