#include "craze/mesh/remesh/remesh_transfer.h"

#include <algorithm>

#include "craze/base/reporting_loop.h"
#include "craze/mesh/remesh/feature_lines.h"

namespace craze {

namespace {

constexpr std::size_t slots_at_once = 1024;

// A place on the source: a face and barycentric coordinates in it.
struct Place {
  std::int32_t face;
  Vec3 weights;
};

class Transfer {
 public:
  Transfer(const RemeshSurface& remeshed, const Context& context)
      : source_(remeshed), mesh_(remeshed.mesh), context_(context) {
    made_.triangles = mesh_.compact(kept_);
    for (std::int32_t v : kept_) made_.positions.push_back(mesh_.position(v));
    for (std::int32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (mesh_.is_face(f)) slots_.push_back(f);
    }
  }

  SurfaceMesh run() {
    find_normals();
    find_faces();
    find_patches();
    context_.check();
    find_corners();
    context_.check();
    fill();
    return std::move(made_);
  }

 private:
  const Vec3& corner(std::size_t f, int i) const { return made_.positions[made_.triangles[f][i]]; }
  Vec3 middle(std::size_t f) const { return (corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3; }

  void find_normals() {
    for (std::size_t f = 0; f < slots_.size(); ++f) {
      normals_.emplace_back(
          (corner(f, 1) - corner(f, 0)).cross(corner(f, 2) - corner(f, 0)).normalized());
    }
  }

  ClosestPoint::Hit find(const Vec3& p, const Vec3& normal, std::int32_t patch,
                         std::int32_t hint) const {
    ClosestPoint::Hit hit = source_.walk.find(p, {normal, patch, hint}, source_.max_distance);
    if (hit.face < 0) hit = source_.tree.find(p, {Vec3::Zero(), patch, -1});
    return hit;
  }

  void find_faces() {
    face_.resize(slots_.size());
    reporting_loop(context_, "remesh", slots_.size(), slots_at_once,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t f = begin; f < end; ++f) {
                       const std::int32_t near = source_.near[mesh_.triangle(slots_[f])[0]];
                       face_[f] = find(middle(f), normals_[f], -1, near).face;
                     }
                   });
  }

  // Seams part the new mesh as they part the source: each part takes the patch that most of its
  // faces found, and those that strayed over a seam look again within it.
  void find_patches() {
    std::vector<std::int32_t> compact(mesh_.face_slots(), -1);
    for (std::size_t f = 0; f < slots_.size(); ++f)
      compact[slots_[f]] = static_cast<std::int32_t>(f);
    std::vector<char> marks(3 * slots_.size());
    for (std::size_t h = 0; h < marks.size(); ++h) {
      marks[h] = mesh_.mark(static_cast<std::int32_t>(3 * slots_[h / 3] + h % 3));
    }
    const std::vector<std::int32_t> part =
        patches(static_cast<std::int32_t>(slots_.size()), marks, seam, [&](std::int32_t h) {
          const std::int32_t o = mesh_.opposite(3 * slots_[h / 3] + h % 3);
          return o < 0 ? -1 : 3 * compact[o / 3] + o % 3;
        });
    struct Vote {
      std::int32_t part, patch;
    };
    std::vector<Vote> votes;
    for (std::size_t f = 0; f < part.size(); ++f)
      votes.push_back({part[f], source_.patch[face_[f]]});
    std::sort(votes.begin(), votes.end(), [](const Vote& a, const Vote& b) {
      return a.part < b.part || (a.part == b.part && a.patch < b.patch);
    });
    std::vector<std::int32_t> winner(part.size(), -1), most(part.size(), 0);
    for (std::size_t i = 0, j; i < votes.size(); i = j) {
      j = i;
      while (j < votes.size() && votes[j].part == votes[i].part &&
             votes[j].patch == votes[i].patch) {
        ++j;
      }
      const std::int32_t p = votes[i].part;
      if (static_cast<std::int32_t>(j - i) > most[p]) {
        most[p] = static_cast<std::int32_t>(j - i);
        winner[p] = votes[i].patch;
      }
    }
    patch_.resize(part.size());
    for (std::size_t f = 0; f < part.size(); ++f) {
      patch_[f] = winner[part[f]];
      if (source_.patch[face_[f]] != patch_[f]) {
        face_[f] = find(middle(f), normals_[f], patch_[f], -1).face;
      }
    }
  }

  // The place of a corner as its face sees it: the source face is looked for a little inside the
  // face, which decides the side of a seam or fold; the coordinates are those of the corner itself.
  Place corner_place(std::size_t f, int i) const {
    const Vec3 p = corner(f, i), inside = p + 1e-4 * (middle(f) - p);
    const std::int32_t face = find(inside, normals_[f], patch_[f], face_[f]).face;
    const Triangle& t = source_.input.triangles[face];
    const auto& q = source_.input.positions;
    return {face, nearest_weights(p, q[t[0]], q[t[1]], q[t[2]])};
  }

  void find_corners() {
    corners_.resize(3 * slots_.size());
    // On a line each face asks for itself; elsewhere the first face at a vertex asks for all.
    std::vector<std::int32_t> first(made_.positions.size(), -1);
    std::vector<char> on_line(made_.positions.size(), 0);
    for (std::size_t v = 0; v < kept_.size(); ++v) on_line[v] = mesh_.count_marked(kept_[v]) > 0;
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      std::int32_t& asks = first[made_.triangles[c / 3][c % 3]];
      if (asks < 0) asks = static_cast<std::int32_t>(c);
    }
    const auto asks_itself = [&](std::size_t c) {
      const std::int32_t v = made_.triangles[c / 3][c % 3];
      return on_line[v] || first[v] == static_cast<std::int32_t>(c);
    };
    reporting_loop(context_, "remesh", slots_.size(), slots_at_once,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t f = begin; f < end; ++f) {
                       for (int i = 0; i < 3; ++i) {
                         if (asks_itself(3 * f + i)) corners_[3 * f + i] = corner_place(f, i);
                       }
                     }
                   });
    vertices_.resize(kept_.size());
    for (std::size_t v = 0; v < kept_.size(); ++v) vertices_[v] = corners_[first[v]];
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      if (!asks_itself(c)) corners_[c] = vertices_[made_.triangles[c / 3][c % 3]];
    }
  }

  void fill() {
    const SurfaceMesh& s = source_.input;
    for (const Place& at : corners_) {
      const std::int32_t c = 3 * at.face;
      const Vec3& w = at.weights;
      if (!s.corner_uvs.empty()) {
        made_.corner_uvs.emplace_back(w[0] * s.corner_uvs[c] + w[1] * s.corner_uvs[c + 1] +
                                      w[2] * s.corner_uvs[c + 2]);
      }
      if (!s.corner_normals.empty()) {
        const Vec3 n = w[0] * s.corner_normals[c] + w[1] * s.corner_normals[c + 1] +
                       w[2] * s.corner_normals[c + 2];
        made_.corner_normals.push_back(n.norm() > 0 ? Vec3(n.normalized())
                                                    : source_.tree.normal(at.face));
      }
    }
    for (const Place& at : vertices_) {
      if (s.vertex_colors.empty()) break;
      Color& color = made_.vertex_colors.emplace_back(Color{});
      for (int i = 0; i < 3; ++i) {
        const Color& c = s.vertex_colors[s.triangles[at.face][i]];
        for (std::size_t k = 0; k < c.size(); ++k)
          color[k] += static_cast<float>(at.weights[i]) * c[k];
      }
    }
    for (const Attribute& a : s.vertex_attributes) {
      Attribute& b = made_.vertex_attributes.emplace_back(Attribute{a.name, a.components, {}});
      for (const Place& at : vertices_) {
        const Triangle& t = s.triangles[at.face];
        for (int k = 0; k < a.components; ++k) {
          double value = 0;
          for (int i = 0; i < 3; ++i) value += at.weights[i] * a.values[t[i] * a.components + k];
          b.values.push_back(value);
        }
      }
    }
    for (const Attribute& a : s.face_attributes) {
      Attribute& b = made_.face_attributes.emplace_back(Attribute{a.name, a.components, {}});
      for (std::int32_t f : face_) {
        for (int k = 0; k < a.components; ++k) b.values.push_back(a.values[f * a.components + k]);
      }
    }
    made_.metres_per_unit = s.metres_per_unit;
    made_.material_names = s.material_names;
    made_.object_names = s.object_names;
    for (std::int32_t f : face_) {
      if (!s.face_materials.empty()) made_.face_materials.push_back(s.face_materials[f]);
      if (!s.face_objects.empty()) made_.face_objects.push_back(s.face_objects[f]);
      made_.source_faces.push_back(s.source_faces.empty() ? f : s.source_faces[f]);
    }
  }

  const RemeshSurface& source_;
  const EditMesh& mesh_;
  const Context& context_;
  SurfaceMesh made_;
  std::vector<std::int32_t> kept_;   // #V: the vertex in mesh_
  std::vector<std::int32_t> slots_;  // #F: the face in mesh_
  std::vector<Vec3> normals_;        // #F
  std::vector<std::int32_t> face_;   // #F: the source face nearest to the middle
  std::vector<std::int32_t> patch_;  // #F
  std::vector<Place> corners_;       // 3 #F
  std::vector<Place> vertices_;      // #V
};

}  // namespace

SurfaceMesh transfer_attributes(const RemeshSurface& remeshed, const Context& context) {
  return Transfer(remeshed, context).run();
}

}  // namespace craze
