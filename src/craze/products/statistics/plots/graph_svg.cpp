#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "craze/base/text/format.h"
#include "craze/products/statistics/graph/plane_frame.h"
#include "craze/products/statistics/measures/pattern.h"
#include "craze/products/statistics/plots/plots.h"

namespace craze {

namespace {

constexpr double picture = 800, margin = 16, legend = 36;

/// Dark violet to ochre in equal steps of lightness (after matplotlib's viridis), u in [0, 1].
std::string time_color(double u) {
  constexpr std::array<std::array<double, 3>, 5> stops{
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 190, 98}, {222, 200, 30}}};
  const double at = std::clamp(u, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t i = std::min<std::size_t>(stops.size() - 2, static_cast<std::size_t>(at));
  int c[3];
  for (int k = 0; k < 3; ++k) {
    c[k] = static_cast<int>(std::lround(stops[i][k] + (at - i) * (stops[i + 1][k] - stops[i][k])));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

struct Kind {
  const char* label;
  const char* color;
};
constexpr Kind kinds[] = {
    {"T", "#c0392b"}, {"Y", "#2471a3"}, {"mixed", "#d68910"}, {"X", "#7d3c98"}, {"end", "#1e8449"}};

/// Index into kinds, or −1 for a node that is no junction.
int kind_of(const std::vector<double>& sectors, double tolerance) {
  if (sectors.size() == 1) return 4;
  if (sectors.size() > 3) return 3;
  if (sectors.size() < 3) return -1;
  switch (junction_shape(sectors, tolerance)) {
    case JunctionShape::t:
      return 0;
    case JunctionShape::y:
      return 1;
    case JunctionShape::mixed:
      return 2;
  }
  return -1;
}

/// From the surface to the picture.
class Projection {
 public:
  Projection(const CrackGraphInput& input, const Vec3& view) {
    const bool flat = find_window(input).has_value();
    toward_ = flat ? input.normals[0] : Vec3(-view.normalized());
    // Up in the picture is z on a curved object seen from the side, y on a plate seen from above.
    const bool from_above = std::abs(toward_.z()) > 0.9;
    const Vec3 up = from_above ? Vec3::UnitY() : Vec3::UnitZ();
    frame_.col(1) = (up - toward_ * toward_.dot(up)).normalized();
    frame_.col(0) = frame_.col(1).cross(toward_);
    low_ = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low_;
    for (const Vec3& p : input.points) {
      low_ = low_.cwiseMin(frame_.transpose() * p);
      high = high.cwiseMax(frame_.transpose() * p);
    }
    const Vec2 size = high - low_;
    scale_ = size.maxCoeff() > 0 ? (picture - 2 * margin) / size.maxCoeff() : 1;
    width = size.x() * scale_ + 2 * margin;
    height = size.y() * scale_ + 2 * margin + legend;
  }

  Vec2 operator()(const Vec3& p) const {
    const Vec2 q = scale_ * (frame_.transpose() * p - low_);
    return {margin + q.x(), height - legend - margin - q.y()};
  }
  bool faces_us(const Vec3& normal) const { return normal.dot(toward_) > 0; }
  double scale() const { return scale_; }

  double width = 0, height = 0;

 private:
  Vec3 toward_;
  Mat32 frame_;
  Vec2 low_;
  double scale_ = 1;
};

/// A rank in [0, 1] for each edge of the input; the same for all where no time is known.
std::vector<double> time_ranks(const CrackGraphInput& input) {
  using Moment = std::pair<double, std::int32_t>;
  const auto moment = [](const GraphInputEdge& e) {
    return Moment{std::isnan(e.time) ? 0 : e.time, e.event};
  };
  std::vector<Moment> moments;
  for (const GraphInputEdge& e : input.edges) {
    if (!e.border) moments.push_back(moment(e));
  }
  std::sort(moments.begin(), moments.end());
  moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
  std::vector<double> ranks;
  for (const GraphInputEdge& e : input.edges) {
    const auto at = std::lower_bound(moments.begin(), moments.end(), moment(e)) - moments.begin();
    ranks.push_back(moments.size() > 1 ? static_cast<double>(at) / (moments.size() - 1.0) : 0);
  }
  return ranks;
}

std::string line(const Vec2& a, const Vec2& b, const std::string& color, double width) {
  return fmt::format(
      "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" "
      "stroke-width=\"{}\"/>\n",
      a.x(), a.y(), b.x(), b.y(), color, width);
}

std::string dot(const Vec2& p, double radius, const char* color) {
  return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"/>\n", p.x(),
                     p.y(), radius, color);
}

std::string time_legend(double y) {
  std::string svg = fmt::format("<text x=\"{}\" y=\"{}\">first</text>\n", margin, y + 4);
  for (int k = 0; k < 40; ++k) {
    svg += line({margin + 36 + 4 * k, y}, {margin + 40 + 4 * k, y}, time_color(k / 39.0), 10);
  }
  return svg + fmt::format("<text x=\"{}\" y=\"{}\">last</text>\n", margin + 204, y + 4);
}

std::string junctions(const CrackGraphInput& input, const Projection& project,
                      const StatisticsOptions& options) {
  const Pattern pattern(input, options);
  const CrackGraph graph = pattern.simplified(options.simplify);
  const auto sectors = all_sector_angles(graph, pattern.fit());
  const double radius = std::clamp(0.07 * pattern.unit * project.scale(), 1.0, 5.0);
  std::string svg;
  std::array<int, 5> count{};
  for (std::size_t n = 0; n < sectors.size(); ++n) {
    const CrackGraph::Node& node = graph.nodes()[n];
    const int kind = kind_of(sectors[n], options.tolerance * std::numbers::pi / 180);
    if (kind < 0 || node.border || !project.faces_us(node.normal)) continue;
    ++count[kind];
    svg += dot(project(node.position), radius, kinds[kind].color);
  }
  for (int k = 0; k < 5; ++k) {
    const double x = margin + 6 + 110 * k, y = project.height - legend / 2;
    svg += dot({x, y}, 5, kinds[k].color);
    svg += fmt::format("<text x=\"{}\" y=\"{}\">{} ({})</text>\n", x + 10, y + 4, kinds[k].label,
                       count[k]);
  }
  return svg;
}

}  // namespace

std::string graph_svg(const CrackGraphInput& input, GraphColor color,
                      const StatisticsOptions& options, const Vec3& view) {
  const Projection project(input, view);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"13\" "
      "fill=\"#333\">\n<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n"
      "<g stroke-linecap=\"round\">\n",
      project.width, project.height);
  const std::vector<double> ranks = time_ranks(input);
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    const GraphInputEdge& e = input.edges[i];
    if (!project.faces_us(input.normals[e.a]) || !project.faces_us(input.normals[e.b])) continue;
    const Vec2 a = project(input.points[e.a]), b = project(input.points[e.b]);
    if (e.border) {
      svg += line(a, b, "#bbb", 1);
    } else if (color == GraphColor::time) {
      svg += line(a, b, time_color(ranks[i]), 1.8);
    } else {
      svg += line(a, b, "#888", 1.2);
    }
  }
  svg += "</g>\n";
  svg += color == GraphColor::time ? time_legend(project.height - legend / 2)
                                   : junctions(input, project, options);
  return svg + "</svg>\n";
}

}  // namespace craze
