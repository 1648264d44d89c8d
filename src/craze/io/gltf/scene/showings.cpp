#include "craze/io/gltf/scene/showings.h"

#include <algorithm>
#include <map>
#include <set>

#include "craze/io/gltf/scene/gpu_copies.h"

namespace craze {

namespace {

/// A node, and which of its copies where it has many.
using Place = std::pair<std::size_t, std::optional<std::size_t>>;

std::map<Place, std::vector<std::size_t>> parts_by_place(const GltfDocument& document) {
  std::map<Place, std::vector<std::size_t>> places;
  for (std::size_t p = 0; p < document.parts().size(); ++p) {
    const GltfPart& part = document.parts()[p];
    places[{part.node, part.copy}].push_back(p);
  }
  return places;
}

/// The meshes that some node goes on showing as they are.
std::set<std::size_t> kept_meshes(const Json& nodes, const std::set<std::size_t>& changed_nodes) {
  std::set<std::size_t> kept;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto mesh = nodes[n].find("mesh");
    if (mesh != nodes[n].end() && !changed_nodes.count(n)) kept.insert(mesh->get<std::size_t>());
  }
  return kept;
}

}  // namespace

std::vector<Showing> separate_showings(const CutScene& cut, GltfAccessors& accessors,
                                       SceneOutput& output) {
  const GltfDocument& document = cut.document();
  std::map<Place, std::vector<std::size_t>> changed;
  std::set<std::size_t> changed_nodes;
  std::map<std::size_t, std::vector<std::size_t>> copies;  // that change, by node
  for (auto& [place, parts] : parts_by_place(document)) {
    const bool any = std::any_of(parts.begin(), parts.end(),
                                 [&](std::size_t p) { return cut.parts()[p].is_changed; });
    if (!any) continue;
    if (place.second) {
      copies[place.first].push_back(*place.second);
    } else {
      changed_nodes.insert(place.first);
    }
    changed.emplace(place, std::move(parts));
  }
  std::map<Place, std::size_t> node_of;
  for (const auto& [node, taken] : copies) {
    const SeparatedCopies separated =
        separate_copies(document.root(), node, taken, accessors, output);
    for (std::size_t i = 0; i < taken.size(); ++i) {
      node_of[{node, taken[i]}] = separated.nodes[i];
    }
    if (!separated.any_left) changed_nodes.insert(node);
  }

  std::set<std::size_t> taken = kept_meshes(document.root()["nodes"], changed_nodes);
  std::vector<Showing> showings;
  for (auto& [place, parts] : changed) {
    Showing showing{place.second ? node_of[place] : place.first, document.parts()[parts[0]].mesh,
                    std::move(parts)};
    if (!taken.insert(showing.mesh).second) {
      Json copy = document.root()["meshes"][showing.mesh];
      showing.mesh = output.root["meshes"].size();
      output.root["meshes"].push_back(std::move(copy));
    }
    output.root["nodes"][showing.node]["mesh"] = showing.mesh;
    showings.push_back(std::move(showing));
  }
  return showings;
}

}  // namespace craze
