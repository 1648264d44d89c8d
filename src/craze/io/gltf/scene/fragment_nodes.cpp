#include "craze/io/gltf/scene/fragment_nodes.h"

#include <algorithm>
#include <map>

#include "craze/base/text/format.h"
#include "craze/io/gltf/scene/weight_channels.h"
#include "craze/io/gltf/solids/scene_solid.h"
#include "craze/io/gltf/solids/solid_node.h"
#include "craze/io/polygons/float_grid.h"

namespace craze {

namespace {

/// A part's share of one fragment.
struct Piece {
  LoosePrimitive primitive;
  std::optional<std::size_t> material;
};

std::map<double, std::vector<Piece>> pieces_by_fragment(const std::vector<LoosePart>& parts) {
  std::map<double, std::vector<Piece>> pieces;
  for (const LoosePart& part : parts) {
    std::map<double, std::vector<std::size_t>> triangles;
    for (std::size_t t = 0; t < part.fragment.size(); ++t) triangles[part.fragment[t]].push_back(t);
    for (const auto& [value, own] : triangles) {
      pieces[value].push_back({part.whole.picked(own), part.material});
    }
  }
  return pieces;
}

double largest_coordinate(const std::vector<LoosePart>& parts) {
  double most = 0;
  for (const LoosePart& part : parts) {
    for (std::size_t v = 0; v < part.whole.vertices().count(); ++v) {
      most = std::max(most, part.whole.vertices().position(v).cwiseAbs().maxCoeff());
    }
  }
  return most;
}

/// Positions and triangles of all of them.
SurfaceMesh mesh_of(const std::vector<Piece>& pieces) {
  SurfaceMesh mesh;
  for (const Piece& piece : pieces) {
    const auto first = static_cast<std::int32_t>(mesh.positions.size());
    const PrimitiveVertices& vertices = piece.primitive.vertices();
    for (std::size_t v = 0; v < vertices.count(); ++v) {
      mesh.positions.push_back(vertices.position(v));
    }
    const auto& indices = piece.primitive.indices();
    for (std::size_t c = 0; c < indices.size(); c += 3) {
      const auto vertex = [&](std::size_t i) {
        return first + static_cast<std::int32_t>(indices[c + i]);
      };
      mesh.triangles.push_back({vertex(0), vertex(1), vertex(2)});
    }
  }
  return mesh;
}

/// Gives the pieces' places from their middle, which is returned; on a grid on which neighbours
/// still meet to the last bit.
Vec3 recentre(std::vector<Piece>& pieces, bool is_solid, double grid) {
  const SurfaceMesh mesh = mesh_of(pieces);
  const Vec3 origin = on_grid(is_solid ? solid_mass(mesh).centre : centroid(mesh), grid);
  for (Piece& piece : pieces) {
    PrimitiveVertices& vertices = piece.primitive.vertices();
    for (std::size_t v = 0; v < vertices.count(); ++v) {
      vertices.set_position(v, on_grid(vertices.position(v), grid) - origin);
    }
  }
  return origin;
}

/// The showing's mesh without what is taken apart.
Json left_of_mesh(const Showing& showing, const std::vector<std::size_t>& taken, const Json& root) {
  Json mesh = root["meshes"][showing.mesh];
  Json left = Json::array();
  for (std::size_t p = 0; p < mesh["primitives"].size(); ++p) {
    const bool is_taken = std::find(taken.begin(), taken.end(), p) != taken.end();
    if (!is_taken) left.push_back(mesh["primitives"][p]);
  }
  mesh["primitives"] = std::move(left);
  return mesh;
}

/// What moves the weights of a node moves those of these; of itself no more, unless it `stays`.
void hand_on_weights(std::size_t node, const std::vector<std::size_t>& to, bool stays, Json& root) {
  if (!root.contains("animations")) return;
  for (Json& animation : root["animations"]) {
    Json channels = Json::array();
    for (Json& channel : animation["channels"]) {
      const auto moved = moved_weights(channel);
      const bool is_its = moved && moved->node == node;
      if (!is_its || stays) channels.push_back(channel);
      if (!is_its) continue;
      for (const std::size_t heir : to) {
        channels.push_back(channel);
        move_weights_of(heir, channels.back());
      }
    }
    animation["channels"] = std::move(channels);
  }
}

class FragmentNodes {
 public:
  FragmentNodes(const Showing& showing, bool is_skinned, std::optional<Collider> solids,
                SceneGrowth* growth, SceneOutput& output)
      : showing_(showing),
        is_skinned_(is_skinned),
        solids_(solids),
        growth_(growth),
        output_(output) {
    mesh_ = output.root["meshes"][showing.mesh];
  }

  void add(const std::string& name, std::vector<Piece>& pieces, double grid) {
    const Json& shown = output_.root["nodes"][showing_.node];
    Json node{{"name", name}};
    for (const char* key : {"skin", "weights"}) {
      if (shown.contains(key)) node[key] = shown[key];
    }
    if (!is_skinned_ && !shown.contains("skin")) {
      const Vec3 origin = recentre(pieces, solids_.has_value(), grid);
      node["translation"] = {origin.x(), origin.y(), origin.z()};
    }
    const std::size_t mesh = next_mesh();
    node["mesh"] = mesh;
    nodes_.push_back(output_.root["nodes"].size());
    output_.root["nodes"].push_back(std::move(node));
    if (growth_) growth_->begin({nodes_.back(), mesh, {}}, output_);
    Json primitives = Json::array();
    for (Piece& piece : pieces) {
      if (growth_) piece.primitive.add_targets(*growth_);
      primitives.push_back(piece.primitive.write(output_));
      if (piece.material) primitives.back()["material"] = *piece.material;
    }
    output_.root["meshes"][mesh]["primitives"] = std::move(primitives);
    if (growth_) growth_->end(output_);
    if (solids_) add_solid(mesh_of(pieces), *solids_, nodes_.back(), output_);
  }

  /// Puts the nodes in their place.
  void finish(Json left) {
    Json& root = output_.root;
    const bool stays = !left["primitives"].empty();
    Json& node = root["nodes"][showing_.node];
    if (stays) {
      node["mesh"] = root["meshes"].size();
      root["meshes"].push_back(std::move(left));
    } else {
      for (const char* key : {"mesh", "skin", "weights"}) node.erase(key);
    }
    const bool is_at_top = is_skinned_ && root.contains("scenes");
    Json& parent = is_at_top ? root["scenes"][root.value("scene", std::size_t{0})] : node;
    Json& children = parent[is_at_top ? "nodes" : "children"];
    for (const std::size_t own : nodes_) children.push_back(own);
    hand_on_weights(showing_.node, nodes_, stays, root);
  }

 private:
  /// The showing's own first, then copies of it.
  std::size_t next_mesh() {
    if (nodes_.empty()) return showing_.mesh;
    output_.root["meshes"].push_back(mesh_);
    return output_.root["meshes"].size() - 1;
  }

  const Showing& showing_;
  bool is_skinned_;
  std::optional<Collider> solids_;
  SceneGrowth* growth_;
  SceneOutput& output_;
  Json mesh_;  // as it was
  std::vector<std::size_t> nodes_;
};

}  // namespace

void add_fragment_nodes(const Showing& showing, const std::vector<LoosePart>& parts,
                        const std::vector<std::size_t>& taken, const std::string& name,
                        bool is_skinned, std::optional<Collider> solids, SceneGrowth* growth,
                        SceneOutput& output) {
  Json left = left_of_mesh(showing, taken, output.root);
  const double grid = float_grid(largest_coordinate(parts));
  FragmentNodes nodes(showing, is_skinned, solids, growth, output);
  std::map<double, std::vector<Piece>> all = pieces_by_fragment(parts);
  for (auto& [value, pieces] : all) {
    nodes.add(fmt::format("{}_{:g}", name, value), pieces, grid);
  }
  nodes.finish(std::move(left));
}

}  // namespace craze
