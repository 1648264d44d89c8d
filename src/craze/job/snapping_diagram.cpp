#include "craze/job/snapping_diagram.h"

#include <numbers>
#include <vector>

#include "craze/base/elementary.h"
#include "craze/base/text/format.h"
#include "craze/model/cutting/crack_insertion.h"

namespace craze {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double snap_angle = 25, back_angle = 15;  // the paper's examples, degrees
constexpr double scale = 52, panel_width = 260, panel_height = 226;

/// A node at the origin with neighbours every 60°, but one at 160° instead of 180°, and a ring of
/// triangles around its star. Vertex 0 is the node, 1 … 6 its neighbours from 0° on.
TriangleMesh star() {
  std::vector<Vec3> points{Vec3::Zero()};
  for (int i = 0; i < 6; ++i) {
    const double angle = (i == 3 ? 160 : 60 * i) * degree;
    points.emplace_back(elementary::cos(angle), elementary::sin(angle), 0);
  }
  for (int i = 0; i < 12; ++i) {
    const double angle = 30 * i * degree, radius = i % 2 ? 1.75 : 1.95;
    points.emplace_back(radius * elementary::cos(angle), radius * elementary::sin(angle), 0);
  }
  std::vector<Triangle> triangles;
  for (std::int32_t i = 0; i < 6; ++i) {
    const std::int32_t a = 1 + i, b = 1 + (i + 1) % 6;
    const std::int32_t p = 7 + 2 * i, q = p + 1, r = 7 + (2 * i + 2) % 12;
    triangles.push_back({0, a, b});
    triangles.push_back({a, p, q});
    triangles.push_back({a, q, b});
    triangles.push_back({b, q, r});
  }
  return {std::move(points), std::move(triangles)};
}

/// A place where a node fails.
struct Panel {
  CrackedSheet sheet{star(), StressField(star(), 100)};
  std::int32_t labels = 0;

  /// Opens the plane that runs at `angle`, degrees, through v.
  void fail(std::int32_t v, double angle) {
    const Vec3 normal(-elementary::sin(angle * degree), elementary::cos(angle * degree), 0);
    CrackOutcome outcome;
    open_crack(sheet, v, normal, {snap_angle * degree, back_angle * degree}, labels, outcome);
    labels += static_cast<std::int32_t>(outcome.segments.size());
  }
};

class Drawing {
 public:
  void mesh(const Panel& panel, double left, double top) {
    left_ = left + panel_width / 2;
    top_ = top + panel_height / 2;
    const TriangleMesh& m = panel.sheet.mesh();
    std::vector<Vec2> at;
    at.reserve(m.vertex_count());
    for (std::int32_t v = 0; v < m.vertex_count(); ++v) at.push_back(shown(m, v));
    std::string edges, cracks;
    for (std::int32_t h = 0; h < 3 * m.face_count(); ++h) {
      if (m.opposite(h) > h) continue;  // its other side is drawn
      (m.crack_of(h) < 0 ? edges : cracks) += segment(at[m.from(h)], at[m.to(h)]);
    }
    path("edge", edges);
    if (!cracks.empty()) path("crack", cracks);
  }

  void plane(double angle) {
    const Vec2 d(elementary::cos(angle * degree), elementary::sin(angle * degree));
    path("plane", segment(-1.7 * d, 1.7 * d));
  }

  /// The angle between the plane and an edge, from `low` to `high` degrees, with its name.
  void angle(double low, double high, const char* name) {
    constexpr double radius = 1.3;
    const Vec2 a =
        canvas(radius * Vec2(elementary::cos(low * degree), elementary::sin(low * degree)));
    const Vec2 b =
        canvas(radius * Vec2(elementary::cos(high * degree), elementary::sin(high * degree)));
    path("angle", fmt::format("M{:.2f} {:.2f}A{:.2f} {:.2f} 0 0 0 {:.2f} {:.2f}", a.x(), a.y(),
                              radius * scale, radius * scale, b.x(), b.y()));
    const double middle = (low + high) / 2 * degree;
    label(canvas(1.5 * Vec2(elementary::cos(middle), elementary::sin(middle))) + Vec2(0, 4), "name",
          name);
  }

  void node() {
    const Vec2 c = canvas(Vec2::Zero());
    body_ +=
        fmt::format("<circle class=\"node\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\"/>\n", c.x(), c.y());
  }

  void text(double x, double y, const char* words) { label({x, y}, "text", words); }

  std::string svg(double width, double height) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
        "height=\"{1:g}\">\n<style>\n"
        "path {{ fill: none; stroke-linecap: round; stroke-linejoin: round; }}\n"
        ".edge {{ stroke: #8a8f98; stroke-width: 1; }}\n"
        ".crack {{ stroke: #14161a; stroke-width: 3.5; }}\n"
        ".plane {{ stroke: #c0392b; stroke-width: 1.8; stroke-dasharray: 2 5; }}\n"
        ".angle {{ stroke: #c0392b; stroke-width: 1.2; }}\n"
        ".node {{ fill: #c0392b; }}\n"
        "text {{ font: 13px sans-serif; fill: #14161a; text-anchor: middle; }}\n"
        ".name {{ font: italic 13px serif; fill: #c0392b; }}\n"
        "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}</svg>\n",
        width, height, body_);
  }

 private:
  Vec2 canvas(const Vec2& p) const { return {left_ + scale * p.x(), top_ - scale * p.y()}; }

  /// Where a vertex is drawn: one on a crack moves a little into its own faces.
  static Vec2 shown(const TriangleMesh& m, std::int32_t v) {
    constexpr double apart = 0.1;
    Vec3 inward = Vec3::Zero();
    bool cut = false;
    double angles = 0;
    m.for_each_outgoing(v, [&](std::int32_t h) {
      const Vec3 b = m.position(m.to(h)) - m.position(v);
      const Vec3 c = m.position(m.from(TriangleMesh::prev(h))) - m.position(v);
      const double angle = elementary::atan2(b.cross(c).norm(), b.dot(c));
      inward += angle * (b.normalized() + c.normalized());
      angles += angle;
      cut = cut || m.crack_of(h) >= 0 || m.crack_of(TriangleMesh::prev(h)) >= 0;
    });
    const bool tip = angles > 359 * degree;
    const double shift = cut && !tip ? apart : 0;
    return (m.position(v) + shift * inward.normalized()).head<2>();
  }

  std::string segment(const Vec2& a, const Vec2& b) const {
    const Vec2 p = canvas(a), q = canvas(b);
    return fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", p.x(), p.y(), q.x(), q.y());
  }

  void path(const char* kind, const std::string& data) {
    body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, data);
  }

  void label(const Vec2& at, const char* kind, const char* words) {
    body_ += fmt::format("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", kind, at.x(),
                         at.y(), words);
  }

  std::string body_;
  double left_ = 0, top_ = 0;
};

}  // namespace

std::string snapping_diagram() {
  constexpr double through = 30, near_edge = 13, near_crack = 12;
  constexpr double header = 34;
  Drawing drawing;
  const auto column = [&](int i, Panel& panel, double angle, const char* words, const char* name) {
    const double left = i * panel_width;
    drawing.text(left + panel_width / 2, 22, words);
    drawing.mesh(panel, left, header);
    drawing.plane(angle);
    if (name) drawing.angle(0, angle, name);
    drawing.node();
    panel.fail(0, angle);
    drawing.mesh(panel, left, header + panel_height);
  };
  Panel split, snapped, dropped;
  dropped.fail(1, 0);  // an older crack, whose tip the node is
  column(0, split, through, "the triangles are split", nullptr);
  column(1, snapped, near_edge, "\u03b8\u2081 &lt; 25\u00b0: follows the edge", "\u03b8\u2081");
  column(2, dropped, near_crack, "\u03b8\u2082 &lt; 15\u00b0: no crack back", "\u03b8\u2082");
  return drawing.svg(3 * panel_width, header + 2 * panel_height);
}

}  // namespace craze
