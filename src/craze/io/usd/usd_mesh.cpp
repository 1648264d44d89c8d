// Format: Pixar, "UsdGeom: USD Geometry Schema", Mesh and Primvars.
#include "craze/io/usd/usd_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/polygons/single_precision.h"
#include "craze/io/polygons/unify_corners.h"

namespace craze {

namespace {

using Float3 = std::array<float, 3>;

float to_float(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -most, most));
}

/// Attributes of our own that are numbers of things.
bool counts_things(const Attribute& a) {
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  return a.components == 1 && (a.name == "fragment" || a.name == "source_face") &&
         std::all_of(a.values.begin(), a.values.end(),
                     [](double x) { return std::abs(x) <= most && x == std::floor(x); });
}

/// Whole numbers that a float would round.
bool needs_double(const std::vector<double>& values) {
  constexpr double exact = 16777216;  // 2²⁴
  return std::any_of(values.begin(), values.end(),
                     [](double x) { return std::abs(x) > exact && x == std::floor(x); });
}

class MeshWriter {
 public:
  MeshWriter(const SurfaceMesh& mesh, ByteSink& sink, const Context& context)
      : mesh_(mesh),
        context_(context),
        meter_(context, "write", 0),
        sink_(sink),
        text_(sink.pending()) {
    // What these mean is the format's own.
    for (const char* name : {"st", "normals", "displayColor", "displayOpacity"}) {
      primvars_.take(name);
    }
  }

  void write(const std::string& name, const Vec3& origin, const std::vector<MorphStage>& stages,
             const UsdClip& clip, UsdMaterials& materials) {
    text_ += fmt::format(
        "    def Mesh \"{}\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n"
        "    {{\n",
        name);
    line("uniform bool doubleSided = 1");
    line("uniform token orientation = \"rightHanded\"");
    line("uniform token subdivisionScheme = \"none\"");
    array("int[] faceVertexCounts", mesh_.triangles.size(),
          [](std::string& out, std::size_t) { out += '3'; });
    write_indices("int[] faceVertexIndices", mesh_.triangles);
    write_points(origin, stages, clip);
    write_corner_values();
    write_colors();
    for (const Attribute& a : mesh_.vertex_attributes) write_attribute(a, "vertex");
    for (const Attribute& a : mesh_.face_attributes) write_attribute(a, "uniform");
    write_materials(materials);
    if (!origin.isZero(0)) {
      std::string place = "double3 xformOp:translate = ";
      append_usd_tuple(place, origin.data(), 3);
      line(place);
      line("uniform token[] xformOpOrder = [\"xformOp:translate\"]");
    }
    text_ += "    }\n";
  }

 private:
  void line(const std::string& words) { text_ += "        " + words + "\n"; }

  template <class Append>
  void array(const std::string& what, std::size_t count, Append append, const char* metadata = "") {
    text_ += "        " + what + " = ";
    append_usd_array(text_, count, [&](std::string& out, std::size_t i) {
      meter_.at(++done_);
      append(out, i);
      sink_.pass_on();
    });
    text_ += metadata;
    text_ += '\n';
  }

  void write_indices(const std::string& what, const std::vector<Triangle>& triangles) {
    array(what, 3 * triangles.size(), [&](std::string& out, std::size_t c) {
      append_usd_number(out, triangles[c / 3][c % 3]);
    });
  }

  static std::vector<Float3> floats(const std::vector<Vec3>& positions, const Vec3& origin) {
    std::vector<Float3> points;
    points.reserve(positions.size());
    for (const Vec3& p : positions) points.push_back(to_floats(p - origin, "USDA"));
    return points;
  }

  void append_points(const std::vector<Float3>& points) {
    append_usd_array(text_, points.size(), [&](std::string& out, std::size_t i) {
      meter_.at(++done_);
      append_usd_tuple(out, points[i].data(), 3);
      sink_.pass_on();
    });
  }

  void write_points(const Vec3& origin, const std::vector<MorphStage>& stages,
                    const UsdClip& clip) {
    const std::vector<Float3> last = floats(mesh_.positions, origin);
    Float3 low{}, high{};
    if (!last.empty()) low = high = last[0];
    const auto extend = [&](const std::vector<Float3>& points) {
      for (const Float3& p : points) {
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], p[k]);
          high[k] = std::max(high[k], p[k]);
        }
      }
    };
    extend(last);
    text_ += "        point3f[] points = ";
    append_points(last);
    text_ += '\n';
    if (!stages.empty()) {
      std::vector<Vec3> positions = mesh_.positions;
      for (const MorphStage& stage : stages) shift(positions, stage, -1);
      text_ += "        point3f[] points.timeSamples = {\n";
      for (std::size_t k = 0; k <= stages.size(); ++k) {
        context_.check();
        if (k == stages.size()) positions = mesh_.positions;  // without what rounding has left
        const std::vector<Float3> points = floats(positions, origin);
        extend(points);
        fmt::format_to(std::back_inserter(text_),
                       "            {}: ", clip.begin + static_cast<double>(k) * clip.per_stage);
        append_points(points);
        text_ += ",\n";
        if (k < stages.size()) shift(positions, stages[k], 1);
      }
      text_ += "        }\n";
    }
    array("float3[] extent", 2, [&](std::string& out, std::size_t i) {
      append_usd_tuple(out, i == 0 ? low.data() : high.data(), 3);
    });
  }

  static void shift(std::vector<Vec3>& positions, const MorphStage& stage, double sign) {
    for (std::size_t i = 0; i < stage.vertices.size(); ++i) {
      positions[stage.vertices[i]] += sign * stage.shifts[i];
    }
  }

  void write_corner_values() {
    constexpr const char* per_corner = " (interpolation = \"faceVarying\")";
    if (!mesh_.corner_uvs.empty()) {
      const UnifiedCorners unified = unify_corners(mesh_, {.uvs = true, .normals = false});
      array(
          "texCoord2f[] primvars:st", unified.uvs.size(),
          [&](std::string& out, std::size_t i) {
            const float uv[2] = {to_float(unified.uvs[i].x()), to_float(unified.uvs[i].y())};
            append_usd_tuple(out, uv, 2);
          },
          per_corner);
      write_indices("int[] primvars:st:indices", unified.triangles);
    }
    if (mesh_.corner_normals.empty()) return;
    const UnifiedCorners unified = unify_corners(mesh_, {.uvs = false, .normals = true});
    array(
        "normal3f[] primvars:normals", unified.normals.size(),
        [&](std::string& out, std::size_t i) {
          const Float3 n = to_floats(unified.normals[i], "USDA");
          append_usd_tuple(out, n.data(), 3);
        },
        per_corner);
    write_indices("int[] primvars:normals:indices", unified.triangles);
  }

  void write_colors() {
    if (mesh_.vertex_colors.empty()) return;
    constexpr const char* per_vertex = " (interpolation = \"vertex\")";
    array(
        "color3f[] primvars:displayColor", mesh_.vertex_colors.size(),
        [&](std::string& out, std::size_t v) {
          append_usd_tuple(out, mesh_.vertex_colors[v].data(), 3);
        },
        per_vertex);
    const bool opaque = std::all_of(mesh_.vertex_colors.begin(), mesh_.vertex_colors.end(),
                                    [](const Color& c) { return c[3] == 1; });
    if (opaque) return;
    array(
        "float[] primvars:displayOpacity", mesh_.vertex_colors.size(),
        [&](std::string& out, std::size_t v) { append_usd_number(out, mesh_.vertex_colors[v][3]); },
        per_vertex);
  }

  /// As numbers, or vectors of up to four; more components stay numbers with an elementSize. Types
  /// go by the name, so that files of one kind are alike, and to double where a float would round.
  void write_attribute(const Attribute& a, const char* interpolation) {
    const int n = a.components <= 4 ? a.components : 1;
    const bool whole = counts_things(a), wide = !whole && needs_double(a.values);
    const std::string number = whole ? "int" : wide ? "double" : "float";
    const std::string type = n == 1 ? number : fmt::format("{}{}", number, n);
    std::string metadata = fmt::format(" (interpolation = \"{}\"", interpolation);
    if (a.components > 4) metadata += fmt::format("; elementSize = {}", a.components);
    metadata += ')';
    array(
        fmt::format("{}[] primvars:{}", type, primvars_.take(a.name)),
        a.values.size() / static_cast<std::size_t>(n),
        [&](std::string& out, std::size_t i) {
          const double* values = &a.values[static_cast<std::size_t>(n) * i];
          if (whole) return append_usd_number(out, static_cast<std::int32_t>(*values));
          if (wide) return append_usd_tuple(out, values, n);
          std::array<float, 4> numbers{};
          std::transform(values, values + n, numbers.begin(), to_float);
          append_usd_tuple(out, numbers.data(), n);
        },
        metadata.c_str());
  }

  void write_materials(UsdMaterials& materials) {
    std::map<std::int32_t, std::vector<std::int32_t>> faces;
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      faces[mesh_.face_materials.empty() ? -1 : mesh_.face_materials[f]].push_back(
          static_cast<std::int32_t>(f));
    }
    if (faces.size() == 1) {
      line(fmt::format("rel material:binding = <{}>", materials.path(faces.begin()->first)));
      return;
    }
    line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
    UsdNames names;
    for (const auto& [material, of] : faces) {
      const std::string& path = materials.path(material);
      text_ += fmt::format(
          "        def GeomSubset \"{}\" (\n            prepend apiSchemas = "
          "[\"MaterialBindingAPI\"]\n        )\n        {{\n            uniform token elementType "
          "= \"face\"\n            uniform token familyName = \"materialBind\"\n            int[] "
          "indices = ",
          names.take(path.substr(path.rfind('/') + 1)));
      append_usd_array(text_, of.size(), [this, &faces = of](std::string& out, std::size_t i) {
        append_usd_number(out, faces[i]);
        sink_.pass_on();
      });
      text_ += fmt::format("\n            rel material:binding = <{}>\n        }}\n", path);
    }
  }

  const SurfaceMesh& mesh_;
  const Context& context_;
  ProgressMeter meter_;
  std::size_t done_ = 0;
  UsdNames primvars_;
  ByteSink& sink_;
  std::string& text_;  // what the sink has yet to pass on
};

}  // namespace

void usd_mesh(const std::string& name, const SurfaceMesh& mesh, const Vec3& origin,
              const std::vector<MorphStage>& stages, const UsdClip& clip, UsdMaterials& materials,
              ByteSink& sink, const Context& context) {
  MeshWriter(mesh, sink, context).write(name, origin, stages, clip, materials);
}

}  // namespace craze
