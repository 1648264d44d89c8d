// The points where curves touch an asset's vertices, edges and faces, each once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/base/period.h"
#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/face_grid.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A point of the asset: face and barycentric coordinates, ≥ 0, sum 1.
struct SurfacePoint {
  std::int32_t face = -1;  ///< −1: nowhere
  Vec3 weights = Vec3::Zero();
};

enum class SiteKind : std::uint8_t { place, edge, face };

struct Site {
  SiteKind kind;
  std::int32_t where;      ///< the place (vertex), edge or face that holds it, and nothing smaller
  std::int32_t at = 0;     ///< edge: grid units from the lower of its two places
  GridPoint in_face = {};  ///< face
};

/// A site on an edge: its distance from the lower place in grid units, and its number.
struct EdgeSite {
  std::int32_t at, site;
};

/// Sites are numbered as they come. What comes nearer to a vertex, an edge or a site of the same
/// edge than the tolerances is put there: by a share of the edge or face, and by a length, though a
/// length never reaches further than a sixteenth of the edge or face, so that paths across fine
/// faces stay as they are. The asset must outlive this.
class SiteTable {
 public:
  /// snap: length. period: of the asset.
  SiteTable(const SurfaceMesh& asset, const AssetTopology& topology, double snap,
            const Period& period = {});

  std::int32_t at_place(std::int32_t place);
  /// The point of halfedge h at share s of it, 0 … 1.
  std::int32_t on_halfedge(std::int32_t h, double s);
  std::int32_t at(const SurfacePoint& point);
  /// A new site inside a face, wherever others are.
  std::int32_t add(std::int32_t face, const GridPoint& at);
  /// A new site halfway between two of a face, on the edge that holds both if one does. on_edge()
  /// does not list it.
  std::int32_t add_between(std::int32_t face, std::int32_t a, std::int32_t b);

  std::int32_t count() const { return static_cast<std::int32_t>(sites_.size()); }
  const Site& operator[](std::int32_t site) const { return sites_[site]; }
  Vec3 position(std::int32_t site) const { return position(site, asset_.positions); }
  const Period& period() const { return period_; }
  /// With the asset's places elsewhere, #V.
  Vec3 position(std::int32_t site, const std::vector<Vec3>& places) const;
  /// Those inside an edge, from its lower place up.
  const std::vector<EdgeSite>& on_edge(std::int32_t edge) const {
    return of_edge_[edge] < 0 ? none_ : edge_sites_[of_edge_[edge]];
  }
  /// Where a site lies in a face that touches it. Exact.
  GridPoint in_face(std::int32_t site, std::int32_t face) const;
  bool touches(std::int32_t site, std::int32_t face) const;
  /// Calls visit(face) for the faces that touch a site until it returns false.
  template <class Visit>
  void for_each_face(std::int32_t site, Visit&& visit) const {
    const Site& s = sites_[site];
    if (s.kind == SiteKind::face) {
      visit(s.where);
      return;
    }
    const HalfedgeRange around =
        s.kind == SiteKind::edge ? topology_.sides(s.where) : topology_.leaving(s.where);
    for (const std::int32_t h : around) {
      if (!visit(h / 3)) return;
    }
  }
  /// A face that touches both, the lowest; −1 if none does.
  std::int32_t common_face(std::int32_t a, std::int32_t b) const;

 private:
  double edge_share(double length) const;

  const SurfaceMesh& asset_;
  const AssetTopology& topology_;
  double snap_;
  Period period_;
  double rounding_ = 0;  // what positions are rounded to, length
  std::vector<Site> sites_;
  std::vector<std::int32_t> of_place_;  // #V: its site or −1
  std::vector<std::int32_t> of_edge_;   // #E: its list or −1
  std::vector<std::vector<EdgeSite>> edge_sites_;
  std::vector<EdgeSite> none_;
};

}  // namespace craze
