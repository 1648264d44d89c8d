#include <map>

#include "craze/io/gltf/gltf_primitive.h"
#include "craze/io/gltf/scene/crack_primitives.h"
#include "craze/io/gltf/scene/weight_channels.h"

namespace craze {

namespace {

constexpr int triangles_mode = 4;
/// Half the width of a band over the lift of a line: about half a pixel where the object fills a
/// picture.
constexpr double half_width = 3;

struct LinePoints {
  int mode = lines_mode;
  std::vector<CutVertices::Vertex> points;
  std::vector<Vec3> shifts;  ///< of points, in the scene
  std::vector<std::uint32_t> indices;
};

/// The i-th corner of the triangle of a halfedge, as a vertex of its part.
CutVertices::Vertex corner_of(const PrimitiveSource& source, std::int32_t halfedge, int i) {
  const Triangle& t = source.cut.mesh().triangles[halfedge / 3];
  return {source.cut.blend(source.place.part, halfedge / 3, i), t[static_cast<std::size_t>(i)]};
}

LinePoints edges(const PrimitiveSource& source, const std::vector<std::int32_t>& halfedges,
                 const std::vector<Vec3>& lifts) {
  LinePoints line;
  std::map<std::pair<std::int32_t, std::array<std::uint32_t, 3>>, std::uint32_t> numbers;
  for (const std::int32_t h : halfedges) {
    for (const int i : {h % 3, (h + 1) % 3}) {
      const CutVertices::Vertex corner = corner_of(source, h, i);
      const auto [found, is_new] = numbers.try_emplace(
          {corner.of, corner.blend.from}, static_cast<std::uint32_t>(line.points.size()));
      line.indices.push_back(found->second);
      if (!is_new) continue;
      line.points.push_back(corner);
      line.shifts.push_back(lifts[corner.of]);
    }
  }
  return line;
}

/// Two triangles an edge: three.js and others move lines by no joints.
LinePoints bands(const PrimitiveSource& source, const std::vector<std::int32_t>& halfedges,
                 const std::vector<Vec3>& lifts) {
  LinePoints line;
  line.mode = triangles_mode;
  const std::vector<Vec3>& positions = source.cut.mesh().positions;
  for (const std::int32_t h : halfedges) {
    const auto first = static_cast<std::uint32_t>(line.points.size());
    const CutVertices::Vertex a = corner_of(source, h, h % 3),
                              b = corner_of(source, h, (h + 1) % 3);
    const Vec3 along = (positions[b.of] - positions[a.of]).stableNormalized();
    for (const CutVertices::Vertex& end : {a, b}) {
      const Vec3 aside = half_width * lifts[end.of].cross(along);
      line.points.insert(line.points.end(), {end, end});
      line.shifts.insert(line.shifts.end(), {lifts[end.of] - aside, lifts[end.of] + aside});
    }
    for (const std::uint32_t i : {0, 2, 1, 1, 2, 3}) line.indices.push_back(first + i);
  }
  return line;
}

bool is_of_lines(const std::string& name) {
  return name == "POSITION" || name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
}

/// Whatever moves the targets of a node moves those of its lines.
void animate_as(std::size_t node, std::size_t lines, Json& root) {
  if (!root.contains("animations")) return;
  for (Json& animation : root["animations"]) {
    Json copies = Json::array();
    for (const Json& channel : animation["channels"]) {
      const auto moved = moved_weights(channel);
      if (!moved || moved->node != node) continue;
      copies.push_back(channel);
      move_weights_of(lines, copies.back());
    }
    for (Json& copy : copies) animation["channels"].push_back(std::move(copy));
  }
}

/// The weights of the first targets, which the part has of its own.
void copy_weights(const Json& from, std::size_t targets, Json& to) {
  if (targets == 0 || !from.contains("weights")) return;
  to["weights"] = Json::array();
  for (const Json& weight : from["weights"]) {
    if (to["weights"].size() < targets) to["weights"].push_back(weight);
  }
}

}  // namespace

Json line_primitive(const PrimitiveSource& source, const std::vector<std::int32_t>& crack_edges,
                    const LineStyle& style, SceneOutput& output) {
  const auto& [cut, primitive, place, accessors] = source;
  const LinePoints line = place.part.skin ? bands(source, crack_edges, style.lifts)
                                          : edges(source, crack_edges, style.lifts);
  PrimitiveVertices vertices(primitive, place, accessors, is_of_lines);
  const std::size_t old = vertices.count();
  vertices.append(cut, line.points);
  vertices.drop(old);
  vertices.complete_targets();
  for (std::size_t k = 0; k < line.points.size(); ++k) vertices.shift(k, line.shifts[k]);
  Json made{{"mode", line.mode},
            {"attributes", vertices.write_attributes(output)},
            {"indices", output.add_indices(line.indices, vertices.count(), 0)},
            {"material", style.material}};
  if (line.mode == triangles_mode) made["extras"][crack_lines_mark] = true;
  if (Json targets = vertices.write_targets(output); !targets.empty()) {
    made["targets"] = std::move(targets);
  }
  return made;
}

void add_line_node(const Showing& showing, Json primitives, SceneOutput& output) {
  Json& root = output.root;
  const Json& mesh = root["meshes"][showing.mesh];
  const Json& node = root["nodes"][showing.node];
  const std::size_t targets = target_count(primitives[0]);
  Json lines{{"name", "crack_lines"}, {"primitives", std::move(primitives)}};
  Json shown{{"name", "crack_lines"}, {"mesh", root["meshes"].size()}};
  if (node.contains("skin")) shown["skin"] = node["skin"];
  copy_weights(mesh, targets, lines);
  copy_weights(node, targets, shown);
  const std::size_t number = root["nodes"].size();
  root["meshes"].push_back(std::move(lines));
  root["nodes"].push_back(std::move(shown));
  // Joints place a skinned mesh wherever its node is; it belongs at the top.
  const std::size_t scene = root.value("scene", std::size_t{0});
  const bool is_at_top = root["nodes"][number].contains("skin") && root.contains("scenes");
  Json& parent = is_at_top ? root["scenes"][scene] : root["nodes"][showing.node];
  const char* children = is_at_top ? "nodes" : "children";
  if (!parent.contains(children)) parent[children] = Json::array();
  parent[children].push_back(number);
  animate_as(showing.node, number, root);
}

}  // namespace craze
