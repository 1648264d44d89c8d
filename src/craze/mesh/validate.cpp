#include "craze/mesh/validate.h"

#include <cstddef>

namespace craze {

namespace {

constexpr std::size_t most_lines = 100;

class Checker {
 public:
  explicit Checker(const TriangleMesh& mesh) : mesh_(mesh) {}

  std::vector<std::string> run() {
    check_faces();
    if (!problems_.empty()) return problems_;  // the rest would read out of range
    check_opposites();
    check_roots();
    if (!problems_.empty()) return problems_;  // the fans might not end
    check_fans();
    return problems_;
  }

 private:
  void report(const char* what, std::int32_t index, const char* why) {
    if (problems_.size() < most_lines) {
      problems_.push_back(std::string(what) + " " + std::to_string(index) + ": " + why);
    }
  }

  void check_faces() {
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      const Triangle& t = mesh_.triangle(f);
      for (std::int32_t v : t) {
        if (v < 0 || v >= mesh_.vertex_count()) report("face", f, "a corner is not a vertex");
      }
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) report("face", f, "a corner is repeated");
    }
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (!mesh_.position(v).allFinite()) report("vertex", v, "its position is not finite");
      const std::int32_t first = mesh_.first_halfedge(v);
      if (first < -1 || first >= 3 * mesh_.face_count()) {
        report("vertex", v, "its first halfedge does not exist");
      } else if (first >= 0 && mesh_.from(first) != v) {
        report("vertex", v, "its first halfedge leaves another vertex");
      }
    }
  }

  void check_opposites() {
    for (std::int32_t h = 0; h < 3 * mesh_.face_count(); ++h) {
      const std::int32_t o = mesh_.opposite(h);
      if (o < 0) continue;
      if (o >= 3 * mesh_.face_count() || o == h || mesh_.opposite(o) != h) {
        report("halfedge", h, "its opposite does not name it back");
      } else if (mesh_.from(o) != mesh_.to(h) || mesh_.to(o) != mesh_.from(h)) {
        report("halfedge", h, "its opposite joins other vertices");
      }
    }
  }

  void check_roots() {
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      const std::int32_t root = mesh_.root(v);
      if (root < 0 || root > v || mesh_.root(root) != root) {
        report("vertex", v, "its root is not a root");
      } else if (mesh_.position(root) != mesh_.position(v)) {
        report("vertex", v, "it has left its root");
      }
    }
  }

  void check_fans() {
    std::vector<std::int32_t> corners(mesh_.vertex_count(), 0);
    std::vector<std::int32_t> open(mesh_.vertex_count(), 0);
    for (std::int32_t h = 0; h < 3 * mesh_.face_count(); ++h) {
      ++corners[mesh_.from(h)];
      if (mesh_.is_open(h)) ++open[mesh_.from(h)];
    }
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      const std::int32_t first = mesh_.first_halfedge(v);
      if (first < 0) {
        if (corners[v] > 0) report("vertex", v, "it has faces but no first halfedge");
        continue;
      }
      std::int32_t reached = 0;
      for (std::int32_t h = first; h >= 0 && reached <= corners[v];) {
        ++reached;
        h = mesh_.rotate(h);
        if (h == first) break;
      }
      if (reached != corners[v]) report("vertex", v, "its fan does not reach all its corners");
      if (open[v] > 1) report("vertex", v, "it has more than one fan");
      if (open[v] == 1 && !mesh_.is_open(first)) {
        report("vertex", v, "its fan does not start at the open edge");
      }
    }
  }

  const TriangleMesh& mesh_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> validate(const TriangleMesh& mesh) {
  return Checker(mesh).run();
}

}  // namespace craze
