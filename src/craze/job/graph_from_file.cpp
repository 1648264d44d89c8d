#include "craze/job/graph_from_file.h"

#include <algorithm>

#include "craze/error.h"
#include "craze/io/lines/read_lines.h"
#include "craze/products/statistics/null_models/null_models.h"
#include "craze/read_mesh.h"

namespace craze {

CrackGraphInput graph_from_file(const std::filesystem::path& path,
                                std::vector<std::string>& warnings) {
  const std::string name = path.string();
  if (name.starts_with("null:")) return null_graph(name.substr(5));
  if (const auto lines = read_lines_file(path)) return graph_from_lines(*lines);
  const MeshFile file = read_mesh_file(path);
  warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
  CrackGraphInput graph = graph_from_cut_mesh(file.mesh);
  if (std::all_of(graph.edges.begin(), graph.edges.end(),
                  [](const GraphInputEdge& e) { return e.border; })) {
    throw Error(ErrorKind::request, "no cracks to measure", name,
                "the mesh has no open edges inside its surface; of a mesh whose cracks were opened "
                "into gaps, give the lines instead");
  }
  return graph;
}

}  // namespace craze
