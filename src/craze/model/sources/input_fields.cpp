#include "craze/model/sources/input_fields.h"

#include <algorithm>
#include <cmath>

#include "craze/error.h"

namespace craze {

namespace {

constexpr const char* tensor_suffixes[6] = {"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"};

[[noreturn]] void fail(const std::string& key, const std::string& why) {
  throw Error(ErrorKind::request, "cannot use painted values", key, why);
}

std::string names_of(const std::vector<Attribute>& attributes) {
  std::string names;
  for (const Attribute& a : attributes) names += (names.empty() ? "" : ", ") + a.name;
  return names.empty() ? "none" : names;
}

struct Found {
  const Attribute* attribute;
  bool per_vertex;
};

Found look_up(const TriangleMesh& mesh, const InputFields& fields, const std::string& name,
              const std::string& key) {
  Found found{find_attribute(fields.vertex_attributes, name), true};
  if (!found.attribute) found = {find_attribute(fields.face_attributes, name), false};
  if (!found.attribute) {
    fail(key, "the input has no attribute \"" + name + "\"; per vertex it has " +
                  names_of(fields.vertex_attributes) + ", per face " +
                  names_of(fields.face_attributes));
  }
  const Attribute& a = *found.attribute;
  const std::int32_t elements = found.per_vertex ? mesh.vertex_count() : mesh.face_count();
  if (a.values.size() != static_cast<std::size_t>(elements) * a.components) {
    fail(key, "attribute \"" + name + "\" has " + std::to_string(a.values.size()) +
                  " numbers for " + std::to_string(elements) + " elements of " +
                  std::to_string(a.components));
  }
  const auto bad =
      std::find_if(a.values.begin(), a.values.end(), [](double x) { return !std::isfinite(x); });
  if (bad != a.values.end()) {
    fail(key, "attribute \"" + name + "\" is not finite at " +
                  (found.per_vertex ? "vertex " : "face ") +
                  std::to_string((bad - a.values.begin()) / a.components));
  }
  return found;
}

Found look_up_scalar(const TriangleMesh& mesh, const InputFields& fields, const std::string& name,
                     const std::string& key) {
  const Found found = look_up(mesh, fields, name, key);
  if (found.attribute->components != 1) {
    fail(key, "attribute \"" + name + "\" has " + std::to_string(found.attribute->components) +
                  " components where 1 is needed");
  }
  return found;
}

/// Component k at face f.
double at_face(const TriangleMesh& mesh, const Found& found, std::int32_t f, int k) {
  const Attribute& a = *found.attribute;
  const auto value = [&](std::int32_t element) {
    return a.values[static_cast<std::size_t>(element) * a.components + k];
  };
  if (!found.per_vertex) return value(f);
  const Triangle& t = mesh.triangle(f);
  return (value(t[0]) + value(t[1]) + value(t[2])) / 3;
}

bool has_attribute(const InputFields& fields, const std::string& name) {
  return find_attribute(fields.vertex_attributes, name) ||
         find_attribute(fields.face_attributes, name);
}

void require_uvs(const TriangleMesh& mesh, const InputFields& fields, const GreyImage& image,
                 const std::string& key) {
  if (image.empty()) fail(key, "the picture was not read");
  if (fields.corner_uvs.empty()) {
    fail(key, "the input has no texture coordinates (UVs), so a picture has no place on it");
  }
  if (fields.corner_uvs.size() != 3 * static_cast<std::size_t>(mesh.face_count())) {
    fail(key, "the texture coordinates are not three per triangle");
  }
}

}  // namespace

InputFields input_fields(const SurfaceMesh& mesh) {
  InputFields fields;
  fields.vertex_attributes = mesh.vertex_attributes;
  fields.face_attributes = mesh.face_attributes;
  fields.corner_uvs = mesh.corner_uvs;
  if (mesh.vertex_colors.empty()) return fields;
  const auto add = [&](const char* name, auto&& value) {
    if (has_attribute(fields, name)) return;
    Attribute a{name, 1, {}};
    for (const Color& c : mesh.vertex_colors) a.values.push_back(value(c));
    fields.vertex_attributes.push_back(std::move(a));
  };
  add("color", [](const Color& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; });
  add("color_r", [](const Color& c) { return c[0]; });
  add("color_g", [](const Color& c) { return c[1]; });
  add("color_b", [](const Color& c) { return c[2]; });
  add("color_a", [](const Color& c) { return c[3]; });
  return fields;
}

std::vector<double> scalar_per_face(const TriangleMesh& mesh, const InputFields& fields,
                                    const std::string& name, const std::string& key) {
  const Found found = look_up_scalar(mesh, fields, name, key);
  std::vector<double> values(mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) values[f] = at_face(mesh, found, f, 0);
  return values;
}

std::vector<double> scalar_per_vertex(const TriangleMesh& mesh, const InputFields& fields,
                                      const std::string& name, const std::string& key) {
  const Found found = look_up_scalar(mesh, fields, name, key);
  if (found.per_vertex) return found.attribute->values;
  std::vector<double> values(mesh.vertex_count(), 0.0);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    double sum = 0, area = 0;
    mesh.for_each_outgoing(v, [&](std::int32_t h) {
      const std::int32_t f = TriangleMesh::face_of(h);
      const double a = mesh.area(f);
      sum += a * found.attribute->values[f];
      area += a;
    });
    if (area > 0) values[v] = sum / area;
  }
  return values;
}

std::vector<Sym3> tensor_per_face(const TriangleMesh& mesh, const InputFields& fields,
                                  const std::string& name, const std::string& key) {
  std::vector<Sym3> values(mesh.face_count());
  const bool six_scalars = !has_attribute(fields, name) && has_attribute(fields, name + "_xx");
  if (six_scalars) {
    double Sym3::*const parts[6] = {&Sym3::xx, &Sym3::yy, &Sym3::zz,
                                    &Sym3::xy, &Sym3::yz, &Sym3::zx};
    for (int k = 0; k < 6; ++k) {
      const Found part = look_up_scalar(mesh, fields, name + tensor_suffixes[k], key);
      for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
        values[f].*parts[k] = at_face(mesh, part, f, 0);
      }
    }
    return values;
  }
  const Found found = look_up(mesh, fields, name, key);
  const int n = found.attribute->components;
  if (n != 1 && n != 6) {
    fail(key, "attribute \"" + name + "\" has " + std::to_string(n) +
                  " components; a stress has 1, or 6: xx yy zz xy yz zx");
  }
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto at = [&](int k) { return at_face(mesh, found, f, k); };
    const double c = at(0);
    values[f] = n == 1 ? Sym3{c, c, c, 0, 0, 0} : Sym3{c, at(1), at(2), at(3), at(4), at(5)};
  }
  return values;
}

std::vector<double> texture_per_face(const TriangleMesh& mesh, const InputFields& fields,
                                     const GreyImage& image, const std::string& key) {
  require_uvs(mesh, fields, image, key);
  std::vector<double> values(mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Vec2* uv = &fields.corner_uvs[3 * static_cast<std::size_t>(f)];
    values[f] = image.sample((uv[0] + uv[1] + uv[2]) / 3);
  }
  return values;
}

std::vector<std::uint8_t> black_faces(const TriangleMesh& mesh, const InputFields& fields,
                                      const GreyImage& image, const std::string& key) {
  require_uvs(mesh, fields, image, key);
  std::vector<std::uint8_t> black(mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Vec2* uv = &fields.corner_uvs[3 * static_cast<std::size_t>(f)];
    const Vec2 places[] = {uv[0], uv[1], uv[2], (uv[0] + uv[1] + uv[2]) / 3};
    for (const Vec2& place : places) black[f] |= image.touches_black(place) ? 1 : 0;
  }
  return black;
}

std::vector<double> texture_per_vertex(const TriangleMesh& mesh, const InputFields& fields,
                                       const GreyImage& image, const std::string& key) {
  require_uvs(mesh, fields, image, key);
  std::vector<double> values(mesh.vertex_count(), 0.0);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    double sum = 0;
    int corners = 0;
    mesh.for_each_outgoing(v, [&](std::int32_t h) {
      sum += image.sample(fields.corner_uvs[h]);
      ++corners;
    });
    if (corners > 0) values[v] = sum / corners;
  }
  return values;
}

}  // namespace craze
