// Meshes of the interface: arrays in, arrays out.
#include <cmath>
#include <limits>
#include <utility>

#include "craze/mesh/mesh_parts.h"
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
  if (name == "uv") return view_rows(view, mesh.corner_uvs, 2, CRAZE_FLOAT64);
  if (name == "normals") return view_rows(view, mesh.corner_normals, 3, CRAZE_FLOAT64);
  if (name == "colors") return view_rows(view, mesh.vertex_colors, 4, CRAZE_FLOAT32);
  if (name == "materials") return view_rows(view, mesh.face_materials, 1, CRAZE_INT32);
  if (name == "source_faces") return view_rows(view, mesh.source_faces, 1, CRAZE_INT32);
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
    throw Error(ErrorKind::usage, "wrong number of columns", std::string(name),
                std::to_string(columns) + " given, " + std::to_string(wanted_columns) + " needed");
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

void set_array(SurfaceMesh& mesh, std::string_view name, const double* values, int64_t rows,
               int32_t columns) {
  const std::size_t n = mesh.positions.size(), m = mesh.triangles.size();
  if (name == "uv") {
    check_rows(name, rows, 3 * m, columns, 2);
    set_rows(mesh.corner_uvs, values, rows, 2);
  } else if (name == "normals") {
    check_rows(name, rows, 3 * m, columns, 3);
    set_rows(mesh.corner_normals, values, rows, 3);
  } else if (name == "vertex:color") {
    check_rows(name, rows, n, columns, 4);
    set_rows(mesh.vertex_colors, values, rows, 4);
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
                "uv, normals, vertex:NAME and face:NAME can be set");
  }
}

}  // namespace

craze_mesh::craze_mesh(SurfaceMesh given)
    : mesh(std::make_shared<SurfaceMesh>(std::move(given))), names(array_names(*mesh)) {}

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
    }
    return new craze_mesh(std::move(mesh));
  });
}

craze_mesh* craze_mesh_read(const char* path, craze_error* error) {
  return guarded(error, [&] {
    require(path, "path");
    return new craze_mesh(read_mesh_file(path).mesh);
  });
}

craze_mesh* craze_mesh_shape(const char* specification, craze_error* error) {
  return guarded(error, [&] {
    require(specification, "specification");
    return new craze_mesh(make_shape(specification));
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
    // Those that share the mesh keep it as it was.
    auto changed =
        mesh->mesh.use_count() > 1 ? std::make_shared<SurfaceMesh>(*mesh->mesh) : mesh->mesh;
    set_array(*changed, name, values, rows, columns);
    mesh->mesh = std::move(changed);
    mesh->names = array_names(*mesh->mesh);
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
  if (!mesh || i < 0 || i >= static_cast<int64_t>(mesh->names.size())) return nullptr;
  return mesh->names[static_cast<std::size_t>(i)].c_str();
}

const char* craze_mesh_material_name(const craze_mesh* mesh, int64_t i) {
  if (!mesh || i < 0 || i >= static_cast<int64_t>(mesh->mesh->material_names.size())) {
    return nullptr;
  }
  return mesh->mesh->material_names[static_cast<std::size_t>(i)].c_str();
}

craze_status craze_mesh_write(const craze_mesh* mesh, const char* path, craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(path, "path");
    write_mesh(path, *mesh->mesh);
  });
}

int64_t craze_mesh_fragment_count(const craze_mesh* mesh, craze_error* error) {
  int64_t count = -1;
  guard(error, [&] {
    require(mesh, "mesh");
    count = static_cast<int64_t>(mesh_parts(*mesh->mesh, "fragment").size());
  });
  return count;
}

craze_status craze_mesh_fragments(const craze_mesh* mesh, craze_mesh** pieces, int64_t count,
                                  craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    if (count > 0) require(pieces, "pieces");
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
