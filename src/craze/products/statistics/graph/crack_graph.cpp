#include "craze/products/statistics/graph/crack_graph.h"

#include <algorithm>
#include <queue>

#include "craze/base/elementary.h"
#include "craze/products/statistics/graph/plane_frame.h"

namespace craze {
namespace {

struct Link {
  std::int32_t edge, other;
  double angle;
};

/// Links of each input point, counter-clockwise in its tangent plane.
std::vector<std::vector<Link>> ordered_links(const CrackGraphInput& input) {
  std::vector<std::vector<Link>> links(input.points.size());
  for (std::size_t e = 0; e < input.edges.size(); ++e) {
    const GraphInputEdge& edge = input.edges[e];
    links[edge.a].push_back({static_cast<std::int32_t>(e), edge.b, 0});
    links[edge.b].push_back({static_cast<std::int32_t>(e), edge.a, 0});
  }
  for (std::size_t p = 0; p < links.size(); ++p) {
    if (links[p].size() < 3) continue;
    const Mat32 frame = plane_frame(input.normals[p]);
    for (Link& l : links[p]) {
      const Vec2 d = frame.transpose() * (input.points[l.other] - input.points[p]);
      l.angle = elementary::atan2(d.y(), d.x());
    }
    std::stable_sort(links[p].begin(), links[p].end(),
                     [](const Link& l, const Link& m) { return l.angle < m.angle; });
  }
  return links;
}

CrackGraph::Segment segment_of(const GraphInputEdge& edge, bool forward) {
  return {edge.time, edge.event, forward ? edge.left_piece : edge.right_piece,
          forward ? edge.right_piece : edge.left_piece};
}

void reverse(CrackGraph::Edge& edge) {
  std::reverse(edge.points.begin(), edge.points.end());
  std::reverse(edge.normals.begin(), edge.normals.end());
  std::reverse(edge.segments.begin(), edge.segments.end());
  for (CrackGraph::Segment& s : edge.segments) std::swap(s.left_piece, s.right_piece);
}

/// Crack edges by length, shortest first, ties by index.
using Shortest = std::priority_queue<std::pair<double, std::int32_t>,
                                     std::vector<std::pair<double, std::int32_t>>, std::greater<>>;

}  // namespace

CrackGraph::CrackGraph(const CrackGraphInput& input) {
  const auto links = ordered_links(input);
  const auto is_inner = [&](std::int32_t p) {
    return links[p].size() == 2 &&
           input.edges[links[p][0].edge].border == input.edges[links[p][1].edge].border;
  };
  std::vector<std::int32_t> node_of(input.points.size(), -1);
  const auto node_at = [&](std::int32_t p) {
    if (node_of[p] < 0) {
      node_of[p] = static_cast<std::int32_t>(nodes_.size());
      nodes_.push_back({input.points[p], input.normals[p], false, {}});
    }
    return node_of[p];
  };
  std::vector<Dart> dart_of(2 * input.edges.size(), -1);  // of an input edge leaving a, or b
  const auto walk = [&](std::int32_t start, const Link& first) {
    if (dart_of[2 * first.edge] >= 0 || dart_of[2 * first.edge + 1] >= 0) return;
    Edge edge;
    edge.border = input.edges[first.edge].border;
    edge.points.push_back(input.points[start]);
    edge.normals.push_back(input.normals[start]);
    const auto id = static_cast<std::int32_t>(edges_.size());
    std::int32_t at = start;
    Link link = first;
    for (bool inner = true; inner;) {
      const bool forward = input.edges[link.edge].a == at;
      dart_of[2 * link.edge + (forward ? 0 : 1)] = 2 * id;
      dart_of[2 * link.edge + (forward ? 1 : 0)] = 2 * id + 1;
      at = link.other;
      edge.length += (input.points[at] - edge.points.back()).norm();
      edge.points.push_back(input.points[at]);
      edge.normals.push_back(input.normals[at]);
      edge.segments.push_back(segment_of(input.edges[link.edge], forward));
      inner = at != start && is_inner(at);
      if (inner) link = links[at][links[at][0].edge == link.edge ? 1 : 0];
    }
    origin_.push_back(node_at(start));
    origin_.push_back(node_at(at));
    edges_.push_back(std::move(edge));
  };
  for (std::size_t p = 0; p < links.size(); ++p) {
    if (is_inner(static_cast<std::int32_t>(p))) continue;
    for (const Link& l : links[p]) walk(static_cast<std::int32_t>(p), l);
  }
  for (std::size_t p = 0; p < links.size(); ++p) {  // closed loops without a junction
    if (!links[p].empty()) walk(static_cast<std::int32_t>(p), links[p][0]);
  }
  for (std::size_t p = 0; p < links.size(); ++p) {
    if (node_of[p] < 0) continue;
    Node& node = nodes_[node_of[p]];
    for (const Link& l : links[p]) {
      const bool forward = input.edges[l.edge].a == static_cast<std::int32_t>(p);
      node.darts.push_back(dart_of[2 * l.edge + (forward ? 0 : 1)]);
      node.border |= input.edges[l.edge].border;
    }
  }
}

CrackGraph::Edge CrackGraph::directed(Dart d) const {
  Edge edge = edges_[d / 2];
  if (d & 1) reverse(edge);
  return edge;
}

void CrackGraph::detach(Dart d) {
  std::vector<Dart>& darts = nodes_[origin_[d]].darts;
  darts.erase(std::find(darts.begin(), darts.end(), d));
}

void CrackGraph::remove_edge(std::int32_t e) {
  detach(2 * e);
  detach(2 * e + 1);
  edges_[e] = {};
}

void CrackGraph::join_at(std::int32_t node) {
  if (degree(node) != 2) return;
  const Dart a = nodes_[node].darts[0], b = nodes_[node].darts[1];
  if (a / 2 == b / 2 || edges_[a / 2].border != edges_[b / 2].border) return;
  // The new line keeps a's index and runs from a's far end over the node to b's far end.
  const std::int32_t e = a / 2;
  Edge line = directed(twin(a));
  const Edge rest = directed(b);
  line.points.insert(line.points.end(), rest.points.begin() + 1, rest.points.end());
  line.normals.insert(line.normals.end(), rest.normals.begin() + 1, rest.normals.end());
  line.segments.insert(line.segments.end(), rest.segments.begin(), rest.segments.end());
  line.length += rest.length;
  const std::int32_t first = target(a), last = target(b);
  const auto rename = [&](std::int32_t n, Dart from, Dart to) {
    *std::find(nodes_[n].darts.begin(), nodes_[n].darts.end(), from) = to;
  };
  rename(first, twin(a), 2 * e);
  rename(last, twin(b), 2 * e + 1);
  edges_[b / 2] = {};
  edges_[e] = std::move(line);
  origin_[2 * e] = first;
  origin_[2 * e + 1] = last;
  nodes_[node].darts.clear();
}

void CrackGraph::prune_spurs(double length) {
  const auto is_spur = [&](std::int32_t e) {
    return is_alive(e) && !edges_[e].border && edges_[e].length < length &&
           (is_tip(origin(2 * e)) || is_tip(target(2 * e)));
  };
  Shortest queue;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto id = static_cast<std::int32_t>(e);
    if (is_spur(id)) queue.emplace(edges_[e].length, id);
  }
  while (!queue.empty()) {
    const auto [l, e] = queue.top();
    queue.pop();
    if (!is_spur(e) || edges_[e].length != l) continue;
    const std::int32_t ends[2] = {origin(2 * e), target(2 * e)};
    remove_edge(e);
    for (const std::int32_t node : ends) {
      join_at(node);
      // What is left there may be a dead end now.
      for (const std::int32_t n : {node, ends[0], ends[1]}) {
        for (const Dart d : nodes_[n].darts) {
          if (is_spur(d / 2)) queue.emplace(edges_[d / 2].length, d / 2);
        }
      }
    }
  }
}

void CrackGraph::contract_edges(double length) {
  Shortest queue;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (is_alive(static_cast<int>(e)) && !edges_[e].border && edges_[e].length < length) {
      queue.emplace(edges_[e].length, e);
    }
  }
  while (!queue.empty()) {
    const std::int32_t e = queue.top().second;
    queue.pop();
    if (!is_alive(e) || edges_[e].length >= length) continue;
    const std::int32_t keep = origin(2 * e), drop = target(2 * e);
    if (keep == drop) {
      remove_edge(e);
      join_at(keep);
      continue;
    }
    Node& a = nodes_[keep];
    Node& b = nodes_[drop];
    if (a.border && b.border) continue;
    if (a.darts.size() == 1 || b.darts.size() == 1) continue;  // a dead end: for prune_spurs
    // The point that takes the place of both ends.
    const Edge& edge = edges_[e];
    Vec3 position = (a.position + b.position) / 2;
    Vec3 normal = a.normal + b.normal;
    if (a.border || b.border) position = a.border ? a.position : b.position;
    normal = normal.norm() > 0 ? Vec3(normal.normalized()) : edge.normals[0];
    // Around the new node: a's darts after the edge, then b's after it.
    const auto after = [](const std::vector<Dart>& darts, Dart d) {
      std::vector<Dart> rest;
      const std::size_t at = std::find(darts.begin(), darts.end(), d) - darts.begin();
      for (std::size_t i = 1; i < darts.size(); ++i) rest.push_back(darts[(at + i) % darts.size()]);
      return rest;
    };
    std::vector<Dart> darts = after(a.darts, 2 * e);
    const std::vector<Dart> rest = after(b.darts, 2 * e + 1);
    darts.insert(darts.end(), rest.begin(), rest.end());
    edges_[e] = {};
    for (const Dart d : darts) {
      origin_[d] = keep;
      Edge& other = edges_[d / 2];
      const double step = ((d & 1 ? other.points.back() : other.points.front()) - position).norm();
      if (step == 0) continue;
      other.length += step;
      if (d & 1) {
        other.points.push_back(position);
        other.normals.push_back(normal);
        other.segments.push_back(other.segments.back());
      } else {
        other.points.insert(other.points.begin(), position);
        other.normals.insert(other.normals.begin(), normal);
        other.segments.insert(other.segments.begin(), other.segments.front());
      }
    }
    a = {position, normal, a.border || b.border, std::move(darts)};
    b.darts.clear();
    join_at(keep);
  }
}

void CrackGraph::remove_dead_ends() {
  std::vector<std::int32_t> face_of(2 * edges_.size(), -1);
  const auto faces = trace_faces();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const Dart d : faces[f]) face_of[d] = static_cast<std::int32_t>(f);
  }
  std::vector<std::int32_t> touched;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto id = static_cast<std::int32_t>(e);
    if (!is_alive(id) || edges_[e].border || face_of[2 * e] != face_of[2 * e + 1]) continue;
    touched.push_back(origin(2 * id));
    touched.push_back(target(2 * id));
    remove_edge(id);
  }
  for (const std::int32_t node : touched) join_at(node);
}

std::vector<std::vector<Dart>> CrackGraph::trace_faces() const {
  // With the face on the left, the next dart is the one clockwise of the way back.
  std::vector<Dart> next(2 * edges_.size(), -1);
  for (const Node& node : nodes_) {
    const std::size_t n = node.darts.size();
    for (std::size_t i = 0; i < n; ++i) next[twin(node.darts[i])] = node.darts[(i + n - 1) % n];
  }
  std::vector<std::vector<Dart>> faces;
  std::vector<char> seen(next.size(), 0);
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (seen[start] || next[start] < 0) continue;
    std::vector<Dart>& face = faces.emplace_back();
    for (auto d = static_cast<Dart>(start); !seen[d]; d = next[d]) {
      seen[d] = 1;
      face.push_back(d);
    }
  }
  return faces;
}

}  // namespace craze
