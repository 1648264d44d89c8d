#include "craze/job/maps/scene_uvs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "craze/base/text/format.h"
#include "craze/engine/asset/cut_surface.h"
#include "craze/engine/cracked_surface.h"
#include "craze/error.h"
#include "craze/io/gltf/scene/uvs/uv_sets.h"
#include "craze/maps.h"
#include "craze/mesh/atlas/uv_atlas.h"
#include "craze/products/maps/map_cracks.h"
#include "craze/products/maps/uv_layout.h"

namespace craze {

namespace {

/// The materials on both sides of every crack, and around its ends.
std::set<std::int32_t> cracked_materials(const Result& result) {
  const CrackedSurface& state = result.state();
  const TriangleMesh& cut = state.mesh();
  std::vector<char> is_cracked(static_cast<std::size_t>(cut.vertex_count()), 0);
  for (const MapCrack& crack : map_cracks(state.network, cut)) {
    for (const std::int32_t root : crack.roots) {
      if (root >= 0) is_cracked[root] = 1;
    }
  }
  const std::vector<std::int32_t>& materials = state.surface->face_materials;
  std::set<std::int32_t> cracked;
  for (std::int32_t f = 0; f < cut.face_count(); ++f) {
    const Triangle& t = cut.triangle(f);
    if (std::none_of(t.begin(), t.end(), [&](auto v) { return is_cracked[cut.root(v)] != 0; })) {
      continue;
    }
    const std::int32_t face = state.asset ? state.asset->cut.face_source[f] : cut.source_face(f);
    cracked.insert(materials.empty() ? -1 : materials[face]);
  }
  return cracked;
}

double twice_area(const std::vector<Vec2>& uvs, std::size_t f) {
  const Vec2 a = uvs[3 * f + 1] - uvs[3 * f], b = uvs[3 * f + 2] - uvs[3 * f];
  return std::abs(a.x() * b.y() - a.y() * b.x());
}

/// Chooses a set for each material.
class Chooser {
 public:
  Chooser(const GltfDocument& document, const SurfaceMesh& surface, const SurfaceOrigin& origin,
          const Context& context)
      : surface_(surface), context_(context) {
    for (std::size_t n = 0; n < uv_set_count(document); ++n) {
      const UvSet set = uv_set(document, n);
      sets_.push_back(uvs_on_surface(set.corners, origin));
      std::vector<char>& has = has_.emplace_back();
      for (const std::int32_t t : origin.face) has.push_back(set.has[t]);
    }
  }

  const std::vector<std::vector<Vec2>>& sets() const { return sets_; }

  enum class Fault { none, missing, flat, overlap };

  /// What keeps a material's maps out of a set.
  Fault fault(std::int32_t material, std::size_t set, bool tiles) const {
    double area = 0, lost = 0;
    for (std::size_t f = 0; f < surface_.triangles.size(); ++f) {
      if (!is_of(material, f)) continue;
      if (!has_[set][f]) return Fault::missing;
      const Triangle& t = surface_.triangles[f];
      const Vec3& p = surface_.positions[t[0]];
      const double own = (surface_.positions[t[1]] - p).cross(surface_.positions[t[2]] - p).norm();
      area += own;
      if (!(twice_area(sets_[set], f) > 0)) lost += own;
    }
    if (lost > unseen_overlap * area) return Fault::flat;
    MapSurface whole;
    whole.surface.face_materials = surface_.face_materials;
    whole.surface.material_names = surface_.material_names;
    whole.pieces = faces_as_pieces(sets_[set]);
    context_.check();
    const auto sheets = sheets_of_material(whole, material, tiles && has_tiles(whole));
    return overlap_of(whole, sheets) > unseen_overlap ? Fault::overlap : Fault::none;
  }

 private:
  bool is_of(std::int32_t material, std::size_t f) const {
    return surface_.face_materials.empty() || surface_.face_materials[f] == material;
  }

  const SurfaceMesh& surface_;
  const Context& context_;
  std::vector<std::vector<Vec2>> sets_;  // 3 #F of the surface
  std::vector<std::vector<char>> has_;   // #F
};

/// Atlases of the document's own triangles, one per material, as single precision stores them.
std::vector<Vec2> atlases(const GltfDocument& document, const std::set<std::int32_t>& materials,
                          const SurfaceOrigin& origin, const Context& context) {
  SurfaceMesh mesh;
  mesh.positions = document.positions();
  mesh.triangles = document.triangles();
  const std::size_t count = mesh.triangles.size();
  std::vector<std::int32_t> material(count, -1);
  for (const GltfPart& part : document.parts()) {
    std::fill(material.begin() + part.first_face, material.begin() + part.end_face,
              material_of(document, part));
  }
  std::vector<char> is_shown(count, 0);  // not doubled, and not without area
  for (const std::int32_t f : origin.face) is_shown[f] = 1;
  std::vector<Vec2> corners(3 * count, Vec2::Zero());
  for (const std::int32_t m : materials) {
    std::vector<char> wanted(count, 0);
    for (std::size_t f = 0; f < count; ++f) wanted[f] = is_shown[f] != 0 && material[f] == m;
    const std::vector<Vec2> uvs = uv_atlas(mesh, wanted, context);
    for (std::size_t c = 0; c < uvs.size(); ++c) {
      if (!wanted[c / 3]) continue;
      const auto u = static_cast<float>(uvs[c].x()), v = static_cast<float>(1 - uvs[c].y());
      corners[c] = {u, 1 - static_cast<double>(v)};
    }
  }
  // Triangles that were left out because they lie on others show what those show.
  using Key = std::pair<std::int32_t, std::array<std::array<double, 3>, 3>>;
  std::map<Key, std::vector<std::pair<std::array<double, 3>, Vec2>>> shown;
  const auto corners_of = [&](std::size_t f) {
    std::array<std::array<double, 3>, 3> places{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.positions[mesh.triangles[f][i]];
      places[i] = {p.x(), p.y(), p.z()};
    }
    return places;
  };
  const auto key_of = [&](std::size_t f) {
    auto places = corners_of(f);
    std::sort(places.begin(), places.end());
    return Key{material[f], places};
  };
  std::set<Key> wanted;
  for (std::size_t f = 0; f < count; ++f) {
    if (!is_shown[f] && materials.count(material[f]) > 0) wanted.insert(key_of(f));
  }
  if (wanted.empty()) return corners;
  for (std::size_t f = 0; f < count; ++f) {
    if (!is_shown[f] || materials.count(material[f]) == 0 || wanted.count(key_of(f)) == 0) continue;
    auto& places = shown[key_of(f)];
    for (std::size_t i = 0; i < 3; ++i) places.emplace_back(corners_of(f)[i], corners[3 * f + i]);
  }
  for (std::size_t f = 0; f < count; ++f) {
    if (is_shown[f] || materials.count(material[f]) == 0) continue;
    const auto twin = shown.find(key_of(f));
    if (twin == shown.end()) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const auto& [place, uv] : twin->second) {
        if (place == corners_of(f)[i]) corners[3 * f + i] = uv;
      }
    }
  }
  return corners;
}

const char* text(Chooser::Fault fault) {
  if (fault == Chooser::Fault::flat) return "have no area";
  return fault == Chooser::Fault::overlap ? "overlap" : "are missing";
}

/// "the UVs of 'brick' overlap, those of 'floor' are missing".
std::string describe(const std::map<std::int32_t, Chooser::Fault>& faults,
                     const std::vector<std::string>& names) {
  constexpr std::size_t most_named = 4;
  std::string list;
  std::size_t named = 0;
  for (const auto& [material, fault] : faults) {
    if (named++ == most_named) {
      list += fmt::format(", and of {} more", faults.size() - most_named);
      break;
    }
    const std::string of = material < 0 ? "what has no material" : "'" + names[material] + "'";
    list += fmt::format("{}of {} {}", list.empty() ? "the UVs " : ", those ", of, text(fault));
  }
  return list;
}

}  // namespace

bool SceneUvs::is_first_alone() const {
  return made.empty() &&
         std::all_of(set.begin(), set.end(), [](const auto& one) { return one.second == 0; });
}

void check_first_uvs(const GltfDocument& document) {
  const UvSet first = uv_set(document, 0);
  if (std::all_of(first.has.begin(), first.has.end(), [](char has) { return has != 0; })) return;
  throw Error(
      ErrorKind::request, "cannot bake maps", "uv",
      "the scene has parts with no UVs, which can be made with mesh.output = \"asset\" alone");
}

SceneUvs scene_uvs(const Result& result, const std::shared_ptr<const GltfDocument>& document,
                   bool for_files, const Context& context) {
  const CrackedSurface& state = result.state();
  SceneUvs uvs;
  uvs.document = document;
  uvs.surface = *state.surface;
  const std::set<std::int32_t> used = used_materials(uvs.surface),
                               cracked = cracked_materials(result);
  for (const std::int32_t m : used) {
    uvs.set[m] = 0;
    if (!for_files && cracked.count(m) == 0) uvs.uncracked.insert(m);
  }
  if (!state.surface_origin || state.surface_origin->face.empty()) {
    check_uvs(uvs.surface);
    uvs.is_remeshed = true;
    return uvs;
  }
  const SurfaceOrigin origin = state.surface_origin->whole();
  const Chooser chooser(*document, uvs.surface, origin, context);
  uvs.own = chooser.sets();
  std::map<std::int32_t, Chooser::Fault> faults;
  for (const std::int32_t m : used) {
    if (uvs.uncracked.count(m) > 0) continue;
    auto first = Chooser::Fault::missing;
    std::size_t n = 0;
    for (; n < uvs.own.size(); ++n) {
      const Chooser::Fault fault = chooser.fault(m, n, for_files);
      if (fault == Chooser::Fault::none) break;
      if (n == 0) first = fault;
    }
    uvs.set[m] = n;
    if (n == uvs.own.size()) faults.emplace(m, first);
  }
  std::vector<Vec2> made;
  if (!faults.empty()) {
    FurtherUvs further;
    for (const auto& [m, fault] : faults) uvs.made.insert(m);
    further.materials = uvs.made;
    further.number = uv_set_count(*document, uvs.made);
    for (const std::int32_t m : uvs.made) uvs.set[m] = further.number;
    further.corners = atlases(*document, further.materials, origin, context);
    made = uvs_on_surface(further.corners, origin);
    uvs.document = with_further_uvs(*document, further);
    uvs.warning = fmt::format("{} (maps): others were made, TEXCOORD_{}",
                              describe(faults, uvs.surface.material_names), further.number);
  }
  if (uvs.surface.corner_uvs.empty()) {
    uvs.surface.corner_uvs.assign(3 * uvs.surface.triangles.size(), Vec2::Zero());
  }
  for (std::size_t c = 0; c < uvs.surface.corner_uvs.size(); ++c) {
    const std::int32_t m =
        uvs.surface.face_materials.empty() ? -1 : uvs.surface.face_materials[c / 3];
    const std::size_t n = uvs.set[m];
    if (uvs.made.count(m) > 0) {
      uvs.surface.corner_uvs[c] = made[c];
    } else if (n > 0) {
      uvs.surface.corner_uvs[c] = uvs.own[n][c];
    }
  }
  return uvs;
}

}  // namespace craze
