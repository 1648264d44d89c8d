#include "craze/products/faces/rough_faces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "craze/base/elementary.h"
#include "craze/base/parallel.h"
#include "craze/base/text/format.h"
#include "craze/mesh/self_intersection.h"
#include "craze/products/faces/face_field.h"
#include "craze/products/faces/wall_columns.h"
#include "craze/products/faces/wall_rows.h"

namespace craze {

namespace {

using Pairs = SelfIntersections::Pairs;

constexpr double steps_of_usual = 16;  // as on lines
/// A point moves aside by less than so much of its way to the end of its line.
constexpr double room_share = 0.4;
constexpr double reach_of_end = 0.5;  // in depths: beside the end of a line faces are less rough
constexpr double turn_share = 0.5;    // of the depth: a line's way is that over as much each way
constexpr std::size_t points_at_once = 512;
constexpr int rounds = 16;
constexpr double step_back = 0.6;
constexpr double nothing = 0.05;   // shares below are none at all
constexpr double told_from = 0.1;  // of all columns
constexpr double needle = 1e-12;   // of a longest side squared

class FaceRoughener {
 public:
  FaceRoughener(const TriangleMesh& mesh, const CrackSites& sites, const FaceOptions& options,
                OpenedMesh& opened, const Context& context)
      : mesh_(mesh), sites_(sites), options_(options), opened_(opened), context_(context) {
    begin_ = mesh.face_count();
    end_ = opened.solid ? opened.solid->inner_begin
                        : static_cast<std::int32_t>(opened.mesh.triangles.size());
    for (const std::int32_t v : opened.vertex_of) column_.push_back(column_of(v));
  }

  std::vector<std::string> run() {
    find_depths();
    if (!(depth_ > 0)) return {};
    const int rows = choose_rows();
    rows_ = wall_rows(opened_, begin_, end_, column_, mesh_.vertex_count(), rows);
    move_aside(depth_ / rows);
    put_together();
    hold_back();
    for (WallPoint& p : rows_.points) p.aside *= share(p);
    finish();
    return warnings();
  }

 private:
  std::int32_t column_of(std::int32_t v) const {
    const std::int32_t site = sites_.site_of[v];
    return site >= 0 ? site : static_cast<std::int32_t>(sites_.vertex.size()) + v;
  }
  std::size_t column_count() const { return sites_.vertex.size() + mesh_.positions().size(); }
  /// Without chips, which take away some of a face.
  Vec3 whole_top(std::int32_t v) const {
    return opened_.chipped.empty() ? opened_.mesh.positions[v]
                                   : Vec3(opened_.mesh.positions[v] - opened_.chipped[v]);
  }

  /// Where the faces lie while the cracks are shut, and how deep they go on average.
  void find_depths() {
    down_.assign(column_count(), Vec3::Zero());
    std::vector<std::uint8_t> is_known(column_count(), 0);
    const std::int32_t bottoms_end = opened_.solid
                                         ? opened_.solid->core_vertex
                                         : static_cast<std::int32_t>(opened_.mesh.positions.size());
    double sum = 0, count = 0;
    for (std::int32_t b = mesh_.vertex_count(); b < bottoms_end; ++b) {
      const std::int32_t v = opened_.vertex_of[b], column = column_[b];
      if (is_known[column] || (sites_.site_of[v] < 0 && !mesh_.is_open_vertex(v))) continue;
      is_known[column] = 1;
      const Vec3 top = opened_.solid ? whole_top(v) : mesh_.position(v);
      down_[column] = opened_.mesh.positions[b] - top;
      if (column >= static_cast<std::int32_t>(sites_.vertex.size())) continue;
      sum += down_[column].norm();
      ++count;
    }
    depth_ = count > 0 ? sum / count : 0;
  }

  int choose_rows() {
    const double usual = options_.usual;
    const double steepest = usual * elementary::pow(std::min(options_.amplitude / usual, 1.0),
                                                    1 / (1 - options_.exponent));
    const double step = options_.step > 0 ? options_.step : usual / steps_of_usual;
    const auto rows_at = [&](double apart) { return std::max(std::ceil(depth_ / apart), 2.0); };
    wanted_rows_ = rows_at(step);
    const double gentle = rows_at(std::max(step, steepest));
    const double most =
        std::max(std::min<double>(most_wall_rows, most_wall_triangles / 2 / (end_ - begin_)), 2.0);
    is_steep_ = gentle < std::min(wanted_rows_, most);
    is_coarse_ = most < gentle;
    row_count_ = static_cast<int>(std::min(gentle, most));
    return row_count_;
  }

  Vec3 shut_top(std::int32_t v) const {
    const Vec3& at = mesh_.position(v);
    return opened_.chipped.empty() ? at : Vec3(at + opened_.chipped[v]);
  }
  const Vec3& site_at(std::int32_t site) const { return mesh_.position(sites_.vertex[site]); }

  /// How much of the roughness there is so near to the end of a line.
  double near_end(double to_end) const {
    const double share = std::min(to_end / (reach_of_end * depth_), 1.0);
    return elementary::pow(share, options_.exponent);
  }

  void move_aside(double step) {
    const FaceField field(
        {options_.amplitude, options_.usual, options_.exponent, depth_, step, options_.seed});
    const std::vector<WallColumn> columns = wall_columns(mesh_, sites_, turn_share * depth_);
    std::vector<WallPoint>& points = rows_.points;
    parallel_for(context_.threads, points.size(), points_at_once,
                 [&](std::size_t begin, std::size_t end) {
                   FaceField::Memory memory, at_edges;
                   for (std::size_t i = begin; i < end; ++i) {
                     move_aside(field, columns, points[i], memory, at_edges);
                   }
                 });
    context_.check();
  }

  void move_aside(const FaceField& field, const std::vector<WallColumn>& columns, WallPoint& p,
                  FaceField::Memory& memory, FaceField::Memory& at_edges) const {
    const std::int32_t a = column_[p.top], b = column_[p.bottom];
    const auto sites = static_cast<std::int32_t>(sites_.vertex.size());
    if (a >= sites || b >= sites) return;  // at the border
    const double t = p.share;
    const Vec3 way = (1 - t) * columns[a].along + t * columns[b].along;
    const Vec3 down = (1 - t) * down_[a] + t * down_[b];
    const Vec3 aside = down.cross(way).stableNormalized();
    const double to_end = (1 - t) * columns[a].to_end + t * columns[b].to_end;
    if (!(to_end > 0) || aside.isZero(0)) return;
    const Vec3 chip = shut_top(p.top) - mesh_.position(p.top);
    const Vec3 top = site_at(a) + chip, bottom = site_at(b) + down_[b];
    const Vec3 at = (1 - t) * top + t * bottom;
    double height =
        field.at(at, memory) - (1 - t) * field.at(top, at_edges) - t * field.at(bottom, at_edges);
    height += field.arc(at, memory) * elementary::sin(std::numbers::pi * t);
    height *= near_end(to_end);
    const double over = height / (room_share * to_end);
    p.aside = height / std::sqrt(1 + over * over) * aside;
  }

  /// Of the whole opened mesh, with its walls in rows.
  void put_together() {
    const auto& old = opened_.mesh.triangles;
    triangles_.assign(old.begin(), old.begin() + begin_);
    triangles_.insert(triangles_.end(), rows_.triangles.begin(), rows_.triangles.end());
    triangles_.insert(triangles_.end(), old.begin() + end_, old.end());
    share_.assign(sites_.vertex.size(), 1);
  }

  /// The share of its way that a point goes.
  double share(const WallPoint& p) const {
    const std::int32_t a = column_[p.top], b = column_[p.bottom];
    const auto sites = static_cast<std::int32_t>(sites_.vertex.size());
    if (a >= sites || b >= sites) return 0;
    return (1 - p.share) * share_[a] + p.share * share_[b];
  }
  std::vector<Vec3> positions(bool flat) const {
    std::vector<Vec3> positions = opened_.mesh.positions;
    for (const WallPoint& p : rows_.points) {
      const Vec3 at = p.between(positions);
      positions.push_back(flat ? at : Vec3(at + share(p) * p.aside));
    }
    return positions;
  }

  void hold_back() {
    SelfIntersections crossings(triangles_, 4 * triangles_.size());
    Pairs before;
    bool knows_before = false;
    for (int round = 0; round < rounds; ++round) {
      context_.report({"roughen", static_cast<double>(round) / rounds});
      context_.check();
      const std::vector<Vec3> now = positions(false);
      std::vector<std::uint8_t> less(share_.size(), 0);
      bool is_sound = true;
      const auto mark = [&](std::int32_t triangle) {
        if (mark_columns(triangle, less)) is_sound = false;
      };
      for (std::size_t t = 0; t < rows_.triangles.size(); ++t) {
        if (is_turned(t, now)) mark(begin_ + static_cast<std::int32_t>(t));
      }
      const Pairs& pairs = crossings.at(now, context_);
      if (!pairs.empty() && !knows_before) {
        before = self_intersections(positions(true), triangles_, 4 * triangles_.size(), context_);
        knows_before = true;
      }
      Pairs fresh;
      std::set_difference(pairs.begin(), pairs.end(), before.begin(), before.end(),
                          std::back_inserter(fresh));
      for (const auto& [f, g] : fresh) {
        mark(f);
        mark(g);
      }
      if (is_sound) break;
      const double left = round + 4 < rounds ? step_back : 0;
      for (std::size_t c = 0; c < share_.size(); ++c) {
        if (!less[c]) continue;
        share_[c] *= left;
        if (share_[c] < nothing) share_[c] = 0;
      }
    }
    context_.report({"roughen", 1});
  }

  /// The columns of its points that are moved; false: there are none.
  bool mark_columns(std::int32_t triangle, std::vector<std::uint8_t>& marks) const {
    bool any = false;
    const auto first = static_cast<std::int32_t>(opened_.mesh.positions.size());
    for (const std::int32_t v : triangles_[triangle]) {
      if (v < first) continue;
      const WallPoint& p = rows_.points[v - first];
      if (p.aside.isZero(0) || share(p) == 0) continue;
      marks[column_[p.top]] = marks[column_[p.bottom]] = 1;
      any = true;
    }
    return any;
  }

  Vec3 normal(const Triangle& t, const std::vector<Vec3>& at) const {
    return (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]);
  }
  /// Whether a triangle of a row looks the other way than the wall does.
  bool is_turned(std::size_t t, const std::vector<Vec3>& at) const {
    const Triangle& wall = opened_.mesh.triangles[rows_.parent[t]];
    const Vec3 flat = normal(wall, at);
    const double side = std::max((at[wall[1]] - at[wall[0]]).squaredNorm(),
                                 (at[wall[2]] - at[wall[0]]).squaredNorm());
    return flat.norm() > needle * side && normal(rows_.triangles[t], at).dot(flat) < 0;
  }

  /// `opened` with rows instead of its walls.
  void finish() {
    const auto more = static_cast<std::int32_t>(rows_.triangles.size()) - (end_ - begin_);
    std::vector<std::int32_t> beside(opened_.beside.begin(), opened_.beside.begin() + begin_);
    for (const std::int32_t f : rows_.parent) beside.push_back(opened_.beside[f]);
    beside.insert(beside.end(), opened_.beside.begin() + end_, opened_.beside.end());
    opened_.beside = std::move(beside);
    opened_.face_of.resize(triangles_.size(), -1);
    opened_.mesh.face_materials.resize(triangles_.size(), 0);
    opened_.mesh.triangles = std::move(triangles_);
    for (const WallPoint& p : rows_.points) {
      opened_.mesh.positions.push_back(p.between(opened_.mesh.positions) + p.aside);
    }
    opened_.vertex_of.insert(opened_.vertex_of.end(), rows_.vertex.begin(), rows_.vertex.end());
    opened_.wall_points = std::move(rows_.points);
    if (!opened_.solid) return;
    opened_.solid->inner_begin += more;
    opened_.solid->core_begin += more;
  }

  std::vector<std::string> warnings() const {
    std::vector<std::string> warnings;
    const auto held = std::count_if(share_.begin(), share_.end(), [](double s) { return s < 0.5; });
    if (static_cast<double>(held) > told_from * static_cast<double>(share_.size())) {
      warnings.push_back(fmt::format(
          "broken faces are less rough than asked for (post.face_roughness) at {} of {} places: "
          "other faces, or bends of their own, are too near",
          held, share_.size()));
    }
    if (is_coarse_ || is_steep_) {
      warnings.push_back(fmt::format(
          "rough faces have {} rows, not the {:.0f} of their step (post.roughness_step): {}",
          row_count_, wanted_rows_,
          is_coarse_ ? fmt::format("walls have at most {} rows and {:.0f} triangles",
                                   most_wall_rows, most_wall_triangles)
                     : "faces so rough would be steeper than 45 degrees (post.face_roughness)"));
    }
    return warnings;
  }

  const TriangleMesh& mesh_;
  const CrackSites& sites_;
  const FaceOptions& options_;
  OpenedMesh& opened_;
  const Context& context_;
  std::int32_t begin_, end_;          // of the walls' faces
  std::vector<std::int32_t> column_;  // of each vertex of the opened mesh: its site, or beyond
  std::vector<Vec3> down_;            // of each column: from the shut top to the shut bottom
  double depth_ = 0;
  double wanted_rows_ = 0;  // by their step
  int row_count_ = 0;
  bool is_coarse_ = false, is_steep_ = false;
  WallRows rows_;
  std::vector<Triangle> triangles_;
  std::vector<double> share_;  // of each site: of the way aside
};

}  // namespace

std::vector<std::string> make_faces_rough(const TriangleMesh& mesh, const CrackSites& sites,
                                          const FaceOptions& options, OpenedMesh& opened,
                                          const Context& context) {
  return FaceRoughener(mesh, sites, options, opened, context).run();
}

}  // namespace craze
