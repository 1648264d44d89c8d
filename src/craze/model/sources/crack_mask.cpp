#include "craze/model/sources/crack_mask.h"

#include <algorithm>
#include <array>
#include <string>

#include "craze/base/name_pattern.h"
#include "craze/error.h"
#include "craze/model/sources/input_fields.h"
#include "craze/model/sources/mask_values.h"

namespace craze {

namespace {

constexpr double rounding = 1e-6;

/// #F, 1 where the face's name fits one of the patterns; all where there are no patterns.
std::vector<char> named_faces(std::size_t faces, const std::vector<std::int32_t>& index,
                              const std::vector<std::string>& names,
                              const std::vector<std::string>& patterns) {
  if (patterns.empty()) return std::vector<char>(faces, 1);
  std::vector<char> fits(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    fits[i] = std::any_of(patterns.begin(), patterns.end(),
                          [&](const std::string& p) { return fits_pattern(names[i], p); });
  }
  std::vector<char> named(faces, 0);
  for (std::size_t f = 0; f < index.size(); ++f) {
    const auto name = static_cast<std::size_t>(index[f]);  // −1, none, is beyond all names
    named[f] = name < fits.size() && fits[name];
  }
  return named;
}

GreyImage inverted(GreyImage image) {
  for (float& pixel : image.pixels) pixel = 1 - pixel;
  return image;
}

/// The least and the largest of what a factor may be at a place.
struct Span {
  double low = 1, high = 1;
};

/// The attribute times the picture, at a corner or the middle of a face.
class Painting {
 public:
  static constexpr int middle = 3;  // after the corners 0, 1 and 2

  Painting(const SurfaceMesh& surface, const TriangleMesh& mesh, const WhereParameters& where,
           const GreyImage& picture)
      : surface_(surface) {
    const InputFields fields = input_fields(surface);
    if (!where.attribute.empty()) {
      const char* key = "where.attribute";
      face_ = mask_shares(scalar_per_face(mesh, fields, where.attribute, key), "face");
      vertex_ = mask_shares(scalar_per_vertex(mesh, fields, where.attribute, key), "vertex");
    }
    if (where.texture.empty()) return;
    picture_ = picture;
    negative_ = inverted(picture);
    if (picture.empty() || surface.corner_uvs.empty()) {
      throw Error(ErrorKind::request, "cannot use painted values", "where.texture",
                  picture.empty() ? "the picture was not read"
                                  : "the input has no texture coordinates (UVs), so a picture has "
                                    "no place on it");
    }
  }

  Span at(std::size_t f, int place) const {
    Span span;
    if (!face_.empty()) {
      span.low = span.high = place == middle
                                 ? face_[f]
                                 : vertex_[surface_.triangles[f][static_cast<std::size_t>(place)]];
    }
    if (picture_.empty()) return span;
    const Vec2* uv = &surface_.corner_uvs[3 * f];
    const Vec2 here = place == middle ? Vec2((uv[0] + uv[1] + uv[2]) / 3) : uv[place];
    const double grey = std::clamp(picture_.sample(here), 0.0, 1.0);
    span.low *= picture_.touches_black(here) ? 0 : grey;
    span.high *= negative_.touches_black(here) ? 1 : grey;
    return span;
  }

 private:
  const SurfaceMesh& surface_;
  GreyImage picture_, negative_;       // empty: none
  std::vector<double> face_, vertex_;  // of the attribute; empty: none
};

/// Of the faces that are 0 to their neighbours across a corner.
void spread_zeros(std::vector<double>& mask, const std::vector<Triangle>& triangles,
                  std::size_t vertices, const std::vector<char>& by_material) {
  std::vector<char> touched(vertices, 0);
  for (std::size_t f = 0; f < mask.size(); ++f) {
    if (mask[f] > 0 || by_material[f]) continue;
    for (const std::int32_t v : triangles[f]) touched[v] = 1;
  }
  for (std::size_t f = 0; f < mask.size(); ++f) {
    const Triangle& t = triangles[f];
    if (touched[t[0]] || touched[t[1]] || touched[t[2]]) mask[f] = 0;
  }
}

}  // namespace

std::vector<double> crack_mask(const SurfaceMesh& surface, const TriangleMesh& mesh,
                               const WhereParameters& where, const GreyImage& picture,
                               bool remeshed) {
  if (!where.is_given()) return {};
  const std::size_t faces = surface.triangles.size();
  const std::vector<char> material =
      named_faces(faces, surface.face_materials, surface.material_names, where.materials);
  const std::vector<char> object =
      named_faces(faces, surface.face_objects, surface.object_names, where.nodes);
  const Painting painting(surface, mesh, where, picture);
  std::vector<double> mask(faces);
  std::vector<char> by_material(faces, 0);
  for (std::size_t f = 0; f < faces; ++f) {
    const double selected = material[f] && object[f] ? 1 : 0;
    double least = 1;
    for (int place = 0; place <= Painting::middle; ++place) {
      const Span span = painting.at(f, place);
      const double low = where.invert ? 1 - selected * span.high : selected * span.low;
      least = std::min(least, low);
      mask[f] = low;  // at the middle in the end
    }
    if (least < rounding) mask[f] = 0;
    by_material[f] = !where.materials.empty() && material[f] == static_cast<char>(where.invert);
  }
  if (remeshed) spread_zeros(mask, surface.triangles, surface.positions.size(), by_material);
  return mask;
}

}  // namespace craze
