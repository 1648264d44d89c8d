// What nodes at the top of the queue will be found to do, worked out for all of them at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/failure/failure.h"

namespace craze {

/// A node's failure, exact, and, where it fails, its plane: as they were before the cracks of a
/// step, and as they still are far from each.
struct ForeseenFailure {
  std::int32_t node = -1;
  Failure failure;
  std::optional<CrackPlane> plane;
  bool holds = true;  ///< no crack has opened near it since
};

class ForeseenFailures {
 public:
  /// Begins anew with these nodes, about which nothing is known as yet.
  void begin(std::vector<std::int32_t> nodes);
  void clear() { failures_.clear(); }

  /// One for each node, ascending.
  std::vector<ForeseenFailure>& all() { return failures_; }
  /// What still holds of v; null where nothing does.
  const ForeseenFailure* find(std::int32_t v) const;
  /// A crack has opened at v and changed these nodes: what lies within `influence` (length) of any
  /// of them, or could, holds no longer. O(failures + changed).
  void opened(const TriangleMesh& mesh, std::int32_t v, const std::vector<std::int32_t>& changed,
              double influence);

 private:
  std::vector<ForeseenFailure> failures_;
};

}  // namespace craze
