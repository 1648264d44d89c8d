#include "craze/products/opening/aged_displacement.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>

#include "craze/products/opening/curl.h"
#include "craze/products/opening/surface_extension.h"

namespace craze {

namespace {

/// Reach of a factor into the pieces, over the natural length of curl: a third of the mean distance
/// between cracks.
constexpr double far_reach = 3;

/// The vertices on one site, and which cracks they lie on.
struct WearSite {
  std::vector<std::int32_t> vertices;
  std::map<std::int32_t, std::vector<std::size_t>> cracks;  ///< by label: indices into vertices

  std::size_t place_of(std::int32_t v) {
    const auto at = std::find(vertices.begin(), vertices.end(), v);
    if (at != vertices.end()) return static_cast<std::size_t>(at - vertices.begin());
    vertices.push_back(v);
    return vertices.size() - 1;
  }
};

std::vector<WearSite> sites_with_cracks(const TriangleMesh& mesh, const CrackSites& sites) {
  std::vector<WearSite> result(sites.vertex.size());
  for (const std::int32_t h : sites.sides) {
    for (const std::int32_t v : {mesh.from(h), mesh.to(h)}) {
      WearSite& site = result[sites.site_of[v]];
      site.cracks[mesh.crack_of(h)].push_back(site.place_of(v));
    }
  }
  return result;
}

/// Moves the vertices of one site, and gives the factor of them together.
class SiteMover {
 public:
  SiteMover(const WearSite& site, const std::vector<Vec3>& displacement)
      : group_(site.vertices.size()) {
    std::iota(group_.begin(), group_.end(), 0);
    for (const std::int32_t v : site.vertices) {
      mean_.push_back(displacement[v]);
      apart_.push_back(Vec3::Zero());
      count_.push_back(1);
    }
  }

  /// The two sides of a crack part by its factor, and are one from then on.
  void join(std::size_t i, std::size_t j, double factor) {
    const std::size_t a = group_[i], b = group_[j];
    if (a == b) return;
    const double all = count_[a] + count_[b];
    const Vec3 mean = (count_[a] * mean_[a] + count_[b] * mean_[b]) / all;
    const Vec3 of_a = factor * (mean_[a] - mean), of_b = factor * (mean_[b] - mean);
    for (std::size_t k = 0; k < group_.size(); ++k) {
      if (group_[k] == a) apart_[k] += of_a;
      if (group_[k] == b) {
        apart_[k] += of_b;
        group_[k] = a;
      }
    }
    mean_[a] = mean;
    count_[a] = all;
  }

  Vec3 moved(std::size_t k, double factor) const { return factor * mean_[group_[k]] + apart_[k]; }

 private:
  std::vector<std::size_t> group_;  // of each vertex
  std::vector<Vec3> mean_;          // of each group
  std::vector<double> count_;
  std::vector<Vec3> apart_;  // of each vertex, from the mean of its group
};

}  // namespace

std::vector<Vec3> aged_displacement(const TriangleMesh& mesh, const CrackSites& sites,
                                    const std::vector<Vec3>& displacement,
                                    const std::vector<double>& crack_times,
                                    const WidthByAge& width) {
  std::vector<Vec3> aged = displacement;
  std::vector<std::uint8_t> known(aged.size(), 0);
  std::vector<double> less(aged.size(), 0);  // 1 − factor
  for (const WearSite& site : sites_with_cracks(mesh, sites)) {
    std::vector<std::array<double, 2>> by_factor;  // of the cracks here, and their labels
    for (const auto& crack : site.cracks) {
      by_factor.push_back(
          {width.factor(crack_times[crack.first]), static_cast<double>(crack.first)});
    }
    std::sort(by_factor.begin(), by_factor.end());
    double together = by_factor.back()[0];
    if (by_factor.size() == 2) {  // a crack that goes on
      together = (by_factor[0][0] + by_factor[1][0]) / 2;
      by_factor[0][0] = by_factor[1][0] = together;
    }
    SiteMover mover(site, displacement);
    for (const auto& [factor, label] : by_factor) {
      const std::vector<std::size_t>& on = site.cracks.at(static_cast<std::int32_t>(label));
      for (const std::size_t k : on) mover.join(on.front(), k, factor);
    }
    for (std::size_t k = 0; k < site.vertices.size(); ++k) {
      const std::int32_t v = site.vertices[k];
      aged[v] = mover.moved(k, together);
      known[v] = 1;
      less[v] = 1 - together;
    }
  }
  const std::vector<double> inside =
      extend_over_surface(mesh, known, less, far_reach * natural_curl_length(mesh, sites));
  for (std::size_t v = 0; v < aged.size(); ++v) {
    if (!known[v]) aged[v] = (1 - inside[v]) * displacement[v];
  }
  return aged;
}

}  // namespace craze
