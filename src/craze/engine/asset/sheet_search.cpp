#include "craze/engine/asset/sheet_search.h"

#include "craze/mesh/closest_point.h"

namespace craze {

namespace {

constexpr std::size_t most_faces = 512;

}  // namespace

SheetSearch::Place SheetSearch::nearest_in(const Vec3& p, std::int32_t face) const {
  const Triangle& t = asset_.triangles[face];
  const Vec3 a = period_.nearest(asset_.positions[t[0]], p),
             b = period_.nearest(asset_.positions[t[1]], p),
             c = period_.nearest(asset_.positions[t[2]], p);
  const Vec3 w = nearest_weights(p, a, b, c);
  if (!w.allFinite()) return {{face, Vec3(1, 0, 0)}, (a - p).norm()};  // a face without area
  return {{face, w}, (w[0] * a + w[1] * b + w[2] * c - p).norm()};
}

template <class Visit>
void SheetSearch::for_each_neighbour(std::int32_t face, Visit&& visit) const {
  for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h) {
    if (topology_.edge(h) < 0) continue;
    for (const std::int32_t o : topology_.sides(topology_.edge(h))) {
      if (o != h) visit(o / 3);
    }
  }
}

bool SheetSearch::step_down(const Vec3& p, Place& place) const {
  Place best = place;
  const auto look = [&](std::int32_t f) {
    const Place other = nearest_in(p, f);
    if (other.distance < best.distance) best = other;
  };
  for_each_neighbour(place.at.face, look);
  for (int i = 0; i < 3; ++i) {
    if (place.at.weights[i] != 1) continue;
    for (const std::int32_t h : topology_.leaving(topology_.from(3 * place.at.face + i))) {
      look(h / 3);
    }
  }
  const bool moved = best.distance < place.distance;
  place = best;
  return moved;
}

SurfacePoint SheetSearch::find(const Vec3& p, std::int32_t start) {
  Place best = nearest_in(p, start);
  while (best.distance > 0 && step_down(p, best)) {
  }
  if (best.distance == 0) return best.at;
  ++search_;
  queue_.assign(1, best.at.face);
  seen_[best.at.face] = search_;
  for (std::size_t k = 0; k < queue_.size() && queue_.size() < most_faces; ++k) {
    for_each_neighbour(queue_[k], [&](std::int32_t f) {
      if (seen_[f] == search_) return;
      seen_[f] = search_;
      const Place other = nearest_in(p, f);
      if (other.distance > best.distance) return;
      queue_.push_back(f);
      if (other.distance < best.distance) best = other;
    });
  }
  return best.at;
}

}  // namespace craze
