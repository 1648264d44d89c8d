// Carrying things from face to face, nearest first.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <queue>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// What a face has taken.
struct FaceCover {
  double covered = std::numeric_limits<double>::infinity();  ///< farther from it is no point
  std::int32_t last = -1;  ///< of what it has accepted, a list that the spread keeps
};

/// Carries what Rules say outwards over the faces of a mesh, never across an open edge. Each thing
/// is accepted by a face once at most, and the nearest first. Rules has, of things of the type
/// Rules::Carried:
///   number(thing): what tells it from the others;
///   matters(face, distance, covered, thing): whether a face takes one that is at least so far from
///     all its points, where no point of it is farther than `covered` from one that it has taken;
///     false for any larger distance as well, and for any smaller `covered`;
///   is_hidden(halfedge, thing): whether what the face of the halfedge has taken makes it useless
///     beyond that edge; true ever after;
///   distance_to_edge(halfedge, thing), across(halfedge, thing): in the face of the halfedge, and
///     as it is seen from the face beyond;
///   accept(face, thing): what to do with it; returns from what no point of the face is farther.
template <class Rules>
class FaceSpread {
 public:
  using Carried = typename Rules::Carried;

  /// All must outlive this. `covers`, #F: only those of faces that things reach are touched.
  FaceSpread(const TriangleMesh& mesh, Rules& rules, std::vector<FaceCover>& covers)
      : mesh_(mesh), rules_(rules), covers_(covers) {}

  void start(std::int32_t face, const Carried& thing) { send(0, face, {thing, -1}); }

  /// Until nothing is on its way any more, or so many have arrived, from which `left` is taken.
  /// Returns whether nothing is. Then no face that accepted something may be reached again.
  bool run(std::int64_t& left) {
    for (; !queue_.empty(); --left) {
      if (left == 0) return false;
      const Arrival arrival = queue_.top();
      queue_.pop();
      const Traveller traveller = pool_[arrival.slot];
      free_.push_back(arrival.slot);
      if (takes(arrival.face, arrival.distance, traveller.thing) && !is_late(traveller))
        accept(arrival, traveller);
    }
    accepted_.clear();
    return true;
  }

 private:
  struct Traveller {
    Carried thing;       ///< as seen from the face
    std::int32_t entry;  ///< halfedge of the face it came in by; −1 at its own
  };
  struct Arrival {
    double distance;  ///< at least this far from any point of the face
    std::int32_t face;
    std::int32_t slot;    ///< what arrives, in the pool
    std::int64_t number;  ///< of arrivals, in the order in which they were sent
  };
  struct Later {
    bool operator()(const Arrival& p, const Arrival& q) const {
      return std::tie(p.distance, p.face, p.number) > std::tie(q.distance, q.face, q.number);
    }
  };
  struct Accepted {
    std::int32_t number;  ///< of the thing
    std::int32_t before;  ///< what the face accepted before it; −1: nothing
  };

  bool takes(std::int32_t face, double distance, const Carried& thing) const {
    const FaceCover& cover = covers_[face];
    if (!rules_.matters(face, distance, cover.covered, thing)) return false;
    const std::int32_t number = rules_.number(thing);
    for (std::int32_t i = cover.last; i >= 0; i = accepted_[i].before) {
      if (accepted_[i].number == number) return false;
    }
    return true;
  }

  /// Whether what came in before has made it useless.
  bool is_late(const Traveller& traveller) const {
    return traveller.entry >= 0 && rules_.is_hidden(traveller.entry, traveller.thing);
  }

  void send(double distance, std::int32_t face, const Traveller& traveller) {
    auto slot = static_cast<std::int32_t>(pool_.size());
    if (free_.empty()) {
      pool_.push_back(traveller);
    } else {
      slot = free_.back();
      free_.pop_back();
      pool_[slot] = traveller;
    }
    queue_.push({distance, face, slot, sent_++});
  }

  void accept(const Arrival& arrival, const Traveller& traveller) {
    const std::int32_t f = arrival.face;
    FaceCover& cover = covers_[f];
    accepted_.push_back({rules_.number(traveller.thing), cover.last});
    cover.last = static_cast<std::int32_t>(accepted_.size()) - 1;
    cover.covered = std::min(cover.covered, rules_.accept(f, traveller.thing));
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      if (h != traveller.entry && !mesh_.is_open(h)) pass_on(arrival.distance, traveller.thing, h);
    }
  }

  void pass_on(double least, const Carried& thing, std::int32_t h) {
    const std::int32_t o = mesh_.opposite(h), g = TriangleMesh::face_of(o);
    if (!takes(g, least, thing) || rules_.is_hidden(h, thing)) return;
    const double distance = std::max(least, rules_.distance_to_edge(h, thing));
    if (!rules_.matters(g, distance, covers_[g].covered, thing)) return;
    send(distance, g, {rules_.across(h, thing), o});
  }

  const TriangleMesh& mesh_;
  Rules& rules_;
  std::vector<Traveller> pool_;     // of what is on its way
  std::vector<std::int32_t> free_;  // slots of the pool
  std::int64_t sent_ = 0;
  std::vector<Accepted> accepted_;
  std::vector<FaceCover>& covers_;
  std::priority_queue<Arrival, std::vector<Arrival>, Later> queue_;
};

/// What faces accepted, in the order in which they did.
template <class Thing>
struct AcceptedByFaces {
  std::vector<std::int32_t> faces;
  std::vector<Thing> things;

  void add(std::int32_t face, const Thing& thing) {
    faces.push_back(face);
    things.push_back(thing);
  }
};

/// Sorts by face into `sorted`; those of one face, which all are in one list, stay in order.
/// `first`: #F + 1 offsets.
template <class Thing>
void sort_by_face(std::span<const AcceptedByFaces<Thing>> lists, std::int32_t face_count,
                  std::vector<std::int32_t>& first, std::vector<Thing>& sorted) {
  first.assign(static_cast<std::size_t>(face_count) + 1, 0);
  for (const AcceptedByFaces<Thing>& list : lists) {
    for (const std::int32_t f : list.faces) ++first[f + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::int32_t> next(first.begin(), first.end() - 1);
  sorted.resize(first.back());
  for (const AcceptedByFaces<Thing>& list : lists) {
    for (std::size_t i = 0; i < list.things.size(); ++i)
      sorted[next[list.faces[i]]++] = list.things[i];
  }
}

}  // namespace craze
