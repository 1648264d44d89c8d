// Meshes of the interface: arrays in, arrays out.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "callback_context.h"
#include "craze/mesh/convex_hull.h"
#include "craze/mesh/mass_properties.h"
#include "craze/mesh/mesh_parts.h"
#include "craze/output/write_surface.h"
#include "craze/products.h"
#include "craze/read_mesh.h"
#include "craze/shapes.h"
#include "craze/write_mesh.h"
#include "guard.h"
#include "handles.h"

using namespace craze;
using namespace craze::c;

namespace {

constexpr std::string_view vertex_prefix = "vertex:", face_prefix = "face:";

bool starts_with(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

std::vector<std::string> array_names(const SurfaceMesh& mesh) {
  std::vector<std::string> names{"vertices", "faces"};
  if (!mesh.corner_uvs.empty()) names.emplace_back("uv");
  if (!mesh.corner_normals.empty()) names.emplace_back("normals");
  if (!mesh.vertex_colors.empty()) names.emplace_back("colors");
  if (!mesh.face_materials.empty()) names.emplace_back("materials");
  if (!mesh.source_faces.empty()) names.emplace_back("source_faces");
  for (const Attribute& a : mesh.vertex_attributes) names.push_back("vertex:" + a.name);
  for (const Attribute& a : mesh.face_attributes) names.push_back("face:" + a.name);
  return names;
}

template <class Row>
void view_rows(craze_array& view, const std::vector<Row>& rows, int columns, craze_type type) {
  view = {rows.data(), static_cast<int64_t>(rows.size()), columns, type};
}

void view_attribute(craze_array& view, const std::vector<Attribute>& attributes,
                    const std::string& name) {
  const Attribute* a = find_attribute(attributes, name);
  if (!a) throw Error(ErrorKind::usage, "no such array", name, "the mesh has no such attribute");
  view = {a->values.data(), static_cast<int64_t>(a->values.size()) / a->components, a->components,
          CRAZE_FLOAT64};
}

void view_array(craze_array& view, const SurfaceMesh& mesh, std::string_view name) {
  if (name == "vertices") return view_rows(view, mesh.positions, 3, CRAZE_FLOAT64);
  if (name == "faces") return view_rows(view, mesh.triangles, 3, CRAZE_INT32);
  const auto is_there = [&](const char* wanted, const auto& rows) {
    return name == wanted && !rows.empty();
  };
  if (is_there("uv", mesh.corner_uvs)) return view_rows(view, mesh.corner_uvs, 2, CRAZE_FLOAT64);
  if (is_there("normals", mesh.corner_normals)) {
    return view_rows(view, mesh.corner_normals, 3, CRAZE_FLOAT64);
  }
  if (is_there("colors", mesh.vertex_colors)) {
    return view_rows(view, mesh.vertex_colors, 4, CRAZE_FLOAT32);
  }
  if (is_there("materials", mesh.face_materials)) {
    return view_rows(view, mesh.face_materials, 1, CRAZE_INT32);
  }
  if (is_there("source_faces", mesh.source_faces)) {
    return view_rows(view, mesh.source_faces, 1, CRAZE_INT32);
  }
  if (starts_with(name, vertex_prefix)) {
    return view_attribute(view, mesh.vertex_attributes,
                          std::string(name.substr(vertex_prefix.size())));
  }
  if (starts_with(name, face_prefix)) {
    return view_attribute(view, mesh.face_attributes, std::string(name.substr(face_prefix.size())));
  }
  throw Error(ErrorKind::usage, "no such array", std::string(name),
              "craze_mesh_array_name() lists those that there are");
}

void check_rows(std::string_view name, int64_t rows, std::size_t wanted, int32_t columns,
                int32_t wanted_columns) {
  if (rows != static_cast<int64_t>(wanted)) {
    throw Error(ErrorKind::usage, "wrong number of rows", std::string(name),
                std::to_string(rows) + " given, " + std::to_string(wanted) + " needed");
  }
  if (columns < 1 || (wanted_columns > 0 && columns != wanted_columns)) {
    const std::string needed = wanted_columns > 0 ? std::to_string(wanted_columns) : "at least 1";
    throw Error(ErrorKind::usage, "wrong number of columns", std::string(name),
                std::to_string(columns) + " given, " + needed + " needed");
  }
}

void set_attribute(std::vector<Attribute>& attributes, std::string name, const double* values,
                   int64_t rows, int32_t columns) {
  Attribute attribute{std::move(name), columns, {values, values + rows * columns}};
  for (Attribute& old : attributes) {
    if (old.name == attribute.name) {
      old = std::move(attribute);
      return;
    }
  }
  attributes.push_back(std::move(attribute));
}

void check_vertex(std::size_t face, int32_t vertex, int64_t count) {
  if (vertex >= 0 && vertex < count) return;
  throw Error(
      ErrorKind::input, "wrong face", std::to_string(face),
      "it has vertex " + std::to_string(vertex) + ", there are 0 to " + std::to_string(count - 1));
}

template <class Row>
void set_rows(std::vector<Row>& into, const double* values, int64_t rows, int columns) {
  into.resize(static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < into.size(); ++i) {
    for (int k = 0; k < columns; ++k) {
      into[i][static_cast<std::size_t>(k)] =
          static_cast<std::decay_t<decltype(into[i][0])>>(values[i * columns + k]);
    }
  }
}

std::vector<int32_t> whole_numbers(std::string_view name, const double* values, int64_t rows) {
  std::vector<int32_t> numbers;
  for (int64_t i = 0; i < rows; ++i) {
    constexpr double most = std::numeric_limits<int32_t>::max();
    if (!(values[i] >= 0 && values[i] <= most && values[i] == std::floor(values[i]))) {
      throw Error(ErrorKind::usage, "wrong number", std::string(name), "must be whole, from 0");
    }
    numbers.push_back(static_cast<int32_t>(values[i]));
  }
  return numbers;
}

void set_array(SurfaceMesh& mesh, std::string_view name, const double* values, int64_t rows,
               int32_t columns) {
  const std::size_t n = mesh.positions.size(), m = mesh.triangles.size();
  if (name == "uv") {
    check_rows(name, rows, 3 * m, columns, 2);
    set_rows(mesh.corner_uvs, values, rows, 2);
  } else if (name == "normals") {
    check_rows(name, rows, 3 * m, columns, 3);
    set_rows(mesh.corner_normals, values, rows, 3);
  } else if (name == "source_faces") {
    check_rows(name, rows, m, columns, 1);
    mesh.source_faces = whole_numbers(name, values, rows);
  } else if (name == "vertex:color") {
    check_rows(name, rows, n, columns, columns == 3 ? 3 : 4);
    mesh.vertex_colors.assign(n, Color{0, 0, 0, 1});
    set_rows(mesh.vertex_colors, values, rows, columns);
  } else if (starts_with(name, vertex_prefix) && name.size() > vertex_prefix.size()) {
    check_rows(name, rows, n, columns, 0);
    set_attribute(mesh.vertex_attributes, std::string(name.substr(vertex_prefix.size())), values,
                  rows, columns);
  } else if (starts_with(name, face_prefix) && name.size() > face_prefix.size()) {
    check_rows(name, rows, m, columns, 0);
    set_attribute(mesh.face_attributes, std::string(name.substr(face_prefix.size())), values, rows,
                  columns);
  } else {
    throw Error(ErrorKind::usage, "no such array", std::string(name),
                "uv, normals, source_faces, vertex:NAME and face:NAME can be set");
  }
}

bool has_array(const SurfaceMesh& mesh, std::string_view name) {
  const std::vector<std::string> names = array_names(mesh);
  return std::find(names.begin(), names.end(), name == "vertex:color" ? "colors" : name) !=
         names.end();
}

bool holds_all_of(const std::vector<Attribute>& attributes, const std::vector<Attribute>& others) {
  return std::all_of(others.begin(), others.end(), [&](const Attribute& other) {
    const Attribute* own = find_attribute(attributes, other.name);
    return own && own->components == other.components && own->values == other.values;
  });
}

/// Whether it is the other mesh, but for its places and for more attributes.
bool holds_all_of(const SurfaceMesh& mesh, const SurfaceMesh& other) {
  return mesh.positions.size() == other.positions.size() && mesh.triangles == other.triangles &&
         mesh.corner_uvs == other.corner_uvs && mesh.corner_normals == other.corner_normals &&
         mesh.vertex_colors == other.vertex_colors && mesh.face_materials == other.face_materials &&
         (mesh.material_names == other.material_names || mesh.face_materials.empty()) &&
         holds_all_of(mesh.vertex_attributes, other.vertex_attributes) &&
         holds_all_of(mesh.face_attributes, other.face_attributes);
}

/// With all that it was made of.
void write(const craze_mesh& mesh, const char* path, const SurfaceFileOptions& options,
           const Context& context) {
  if (mesh.opening) {
    const SourceFile arrays;
    write_surface(path, *mesh.mesh, mesh.opening->surface(), mesh.opening->result(),
                  mesh.source ? *mesh.source : arrays, options, context);
  } else if (mesh.source) {
    write_surface(path, *mesh.mesh, *mesh.source, options, context);
  } else {
    write_mesh(path, *mesh.mesh, {}, context);
  }
}

void require_fragments(const SurfaceMesh& mesh) {
  if (find_attribute(mesh.face_attributes, "fragment")) return;
  throw Error(ErrorKind::request, "no fragments", "face:fragment",
              "the mesh has no such attribute: it is not a cracked one");
}

}  // namespace

craze_mesh::craze_mesh(SurfaceMesh given) : own_(std::make_shared<SurfaceMesh>(std::move(given))) {
  mesh = own_;
  list_arrays();
}

craze_mesh::craze_mesh(std::shared_ptr<const SurfaceMesh> shared) : mesh(std::move(shared)) {
  list_arrays();
}

void craze_mesh::list_arrays() {
  names = array_names(*mesh);
}

craze_mesh* craze_mesh_new(const double* vertices, int64_t n, const int32_t* faces, int64_t m,
                           craze_error* error) {
  return guarded(error, [&] {
    constexpr int64_t most = std::numeric_limits<int32_t>::max() / 3;
    if (n < 0 || m < 0 || n > most || m > most) {
      wrong_argument("wrong size", "craze_mesh_new", "0 to 715827882 vertices and faces fit");
    }
    if (n > 0) require(vertices, "vertices");
    if (m > 0) require(faces, "faces");
    SurfaceMesh mesh;
    mesh.positions.resize(static_cast<std::size_t>(n));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      mesh.positions[v] = Vec3(vertices[3 * v], vertices[3 * v + 1], vertices[3 * v + 2]);
    }
    mesh.triangles.resize(static_cast<std::size_t>(m));
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      mesh.triangles[f] = {faces[3 * f], faces[3 * f + 1], faces[3 * f + 2]};
      for (const int32_t v : mesh.triangles[f]) check_vertex(f, v, n);
    }
    return new craze_mesh(std::move(mesh));
  });
}

craze_mesh* craze_mesh_read(const char* path, craze_progress progress, void* user,
                            craze_error* error) {
  return guarded(error, [&] {
    require(path, "path");
    MeshFile file = read_mesh_file(path, CallbackContext(progress, user).get());
    auto mesh = std::make_unique<craze_mesh>(std::move(file.mesh));
    mesh->warnings = std::move(file.warnings);
    mesh->source = std::make_shared<const SourceFile>(
        SourceFile{path, std::move(file.looks), std::move(file.scene)});
    return mesh.release();
  });
}

const char* craze_mesh_warning(const craze_mesh* mesh, int64_t i) {
  return mesh ? text_at(mesh->warnings, i) : nullptr;
}

craze_mesh* craze_mesh_shape(const char* specification, craze_error* error) {
  return guarded(error, [&] {
    require(specification, "specification");
    auto mesh = std::make_unique<craze_mesh>(make_shape(specification));
    mesh->source = std::make_shared<const SourceFile>(
        SourceFile{"shape:" + std::string(specification), {}, nullptr});
    return mesh.release();
  });
}

void craze_mesh_free(craze_mesh* mesh) {
  delete mesh;
}

craze_status craze_mesh_set(craze_mesh* mesh, const char* name, const double* values, int64_t rows,
                            int32_t columns, craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(name, "name");
    if (rows > 0) require(values, "values");
    const bool replaces = has_array(*mesh->mesh, name);
    mesh->change([&](SurfaceMesh& changed) { set_array(changed, name, values, rows, columns); });
    if (replaces) mesh->forget_origin();
  });
}

craze_status craze_mesh_set_materials(craze_mesh* mesh, const int32_t* materials,
                                      const char* const* names, int64_t count, craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    if (count > 0) require(names, "names");
    if (count > 0 && !mesh->mesh->triangles.empty()) require(materials, "materials");
    std::vector<std::string> given;
    for (int64_t i = 0; i < count; ++i) {
      require(names[i], "names");
      given.emplace_back(names[i]);
    }
    std::vector<int32_t> of_faces;
    if (count > 0) of_faces.assign(materials, materials + mesh->mesh->triangles.size());
    for (const int32_t material : of_faces) {
      if (material < -1 || material >= count) {
        wrong_argument("wrong material", std::to_string(material).c_str(),
                       "must be -1 or count the names from 0");
      }
    }
    mesh->change([&](SurfaceMesh& changed) {
      changed.material_names = std::move(given);
      changed.face_materials = std::move(of_faces);
    });
    mesh->forget_origin();
  });
}

craze_status craze_mesh_array(const craze_mesh* mesh, const char* name, craze_array* array,
                              craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(name, "name");
    require(array, "array");
    view_array(*array, *mesh->mesh, name);
  });
}

const char* craze_mesh_array_name(const craze_mesh* mesh, int64_t i) {
  return mesh ? text_at(mesh->names, i) : nullptr;
}

const char* craze_mesh_material_name(const craze_mesh* mesh, int64_t i) {
  return mesh ? text_at(mesh->mesh->material_names, i) : nullptr;
}

craze_status craze_mesh_write(const craze_mesh* mesh, const char* path, craze_progress progress,
                              void* user, craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(path, "path");
    write(*mesh, path, {}, CallbackContext(progress, user).get());
  });
}

craze_status craze_mesh_write_telling(const craze_mesh* mesh, const char* path, craze_told told,
                                      craze_progress progress, void* user, craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(path, "path");
    SurfaceFileOptions options;
    if (told) options.warn = [&](const std::string& sentence) { told(user, sentence.c_str()); };
    write(*mesh, path, options, CallbackContext(progress, user).get());
  });
}

int craze_mesh_keep_origin(craze_mesh* mesh, const craze_mesh* from) {
  if (!mesh || !from || !(from->source || from->opening)) return 0;
  const bool holds = holds_all_of(*mesh->mesh, *from->mesh);
  guard(nullptr, [&] {
    if (!holds) return;
    mesh->change([&](SurfaceMesh& changed) {
      changed.object_names = from->mesh->object_names;
      changed.face_objects = from->mesh->face_objects;
      changed.metres_per_unit = from->mesh->metres_per_unit;
    });
    mesh->source = from->source;
    mesh->opening = from->opening;
  });
  return holds ? 1 : 0;
}

int64_t craze_mesh_fragment_count(const craze_mesh* mesh, craze_error* error) {
  int64_t count = -1;
  guard(error, [&] {
    require(mesh, "mesh");
    require_fragments(*mesh->mesh);
    count = static_cast<int64_t>(mesh_parts(*mesh->mesh, "fragment").size());
  });
  return count;
}

craze_status craze_mesh_fragments(const craze_mesh* mesh, craze_mesh** pieces, int64_t count,
                                  craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    if (count > 0) require(pieces, "pieces");
    require_fragments(*mesh->mesh);
    std::vector<SurfaceMesh> found = fragments(*mesh->mesh);
    if (count != static_cast<int64_t>(found.size())) {
      wrong_argument("wrong number of fragments", "craze_mesh_fragments",
                     "craze_mesh_fragment_count() says how many there are");
    }
    std::vector<std::unique_ptr<craze_mesh>> made;
    for (SurfaceMesh& piece : found) made.push_back(std::make_unique<craze_mesh>(std::move(piece)));
    for (std::size_t i = 0; i < made.size(); ++i) pieces[i] = made[i].release();
  });
}

craze_status craze_mesh_mass(const craze_mesh* mesh, double* volume, double* centre,
                             double* inertia, craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(volume, "volume");
    const MassProperties mass = mass_properties(mesh->mesh->positions, mesh->mesh->triangles);
    *volume = mass.volume;
    for (int i = 0; i < 3; ++i) {
      if (centre) centre[i] = mass.centre[i];
      for (int j = 0; inertia && j < 3; ++j) inertia[3 * i + j] = mass.inertia(i, j);
    }
  });
}

craze_mesh* craze_mesh_convex_hull(const craze_mesh* mesh, craze_error* error) {
  return guarded(error, [&] {
    require(mesh, "mesh");
    ConvexHull hull = convex_hull(mesh->mesh->positions);
    SurfaceMesh made;
    made.positions = std::move(hull.positions);
    made.triangles = std::move(hull.triangles);
    made.metres_per_unit = mesh->mesh->metres_per_unit;
    return new craze_mesh(std::move(made));
  });
}
