#include <map>

#include "craze/io/gltf/scene/crack_primitives.h"

namespace craze {

namespace {

constexpr int lines_mode = 1;

bool is_of_lines(const std::string& name) {
  return name == "POSITION" || name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
}

/// Whatever moves the targets of a node moves those of its lines.
void animate_as(std::size_t node, std::size_t lines, Json& root) {
  if (!root.contains("animations")) return;
  for (Json& animation : root["animations"]) {
    Json copies = Json::array();
    for (const Json& channel : animation["channels"]) {
      const Json& target = channel["target"];
      if (!target.contains("node") || target["node"] != Json(node)) continue;
      if (target.value("path", "") != "weights") continue;
      copies.push_back(channel);
      copies.back()["target"]["node"] = lines;
    }
    for (Json& copy : copies) animation["channels"].push_back(std::move(copy));
  }
}

std::size_t target_count(const Json& primitive) {
  return primitive.contains("targets") ? primitive["targets"].size() : 0;
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
  std::map<std::pair<std::int32_t, std::array<std::uint32_t, 3>>, std::uint32_t> numbers;
  std::vector<CutVertices::Vertex> points;
  std::vector<std::uint32_t> indices;
  for (const std::int32_t h : crack_edges) {
    for (const int i : {h % 3, (h + 1) % 3}) {
      const std::int32_t v = cut.mesh().triangles[h / 3][static_cast<std::size_t>(i)];
      const VertexBlend blend = cut.blend(place.part, h / 3, i);
      const auto [found, is_new] =
          numbers.try_emplace({v, blend.from}, static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back({blend, v});
      indices.push_back(found->second);
    }
  }
  PrimitiveVertices vertices(primitive, place, accessors, is_of_lines);
  const std::size_t old = vertices.count();
  vertices.append(cut, points);
  vertices.drop(old);
  vertices.complete_targets();
  for (std::size_t k = 0; k < points.size(); ++k) vertices.shift(k, style.lifts[points[k].of]);
  Json made{{"mode", lines_mode},
            {"attributes", vertices.write_attributes(output)},
            {"indices", output.add_indices(indices, vertices.count(), 0)},
            {"material", style.material}};
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
