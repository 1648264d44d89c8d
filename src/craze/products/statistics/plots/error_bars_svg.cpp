#include <algorithm>
#include <cmath>

#include "craze/base/elementary.h"
#include "craze/base/text/format.h"
#include "craze/products/statistics/plots/plots.h"

namespace craze {

namespace {

constexpr double width = 480, height = 320;
constexpr double left = 64, right = 24, top = 40, bottom = 52;
constexpr std::size_t most_labels = 8;

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return safe;
}

/// Values along a side of the picture, with round steps.
class RoundSteps {
 public:
  RoundSteps(double low, double high, double from, double to) : from_(from), to_(to) {
    if (!(high > low)) {
      const double room = low == 0 ? 1 : std::abs(low) / 10;
      low -= room;
      high += room;
    }
    step_ = 1;
    while (step_ > high - low) step_ /= 10;
    while (step_ * 10 < high - low) step_ *= 10;
    while ((high - low) / step_ < 3) step_ /= 2;
    low_ = step_ * std::floor(low / step_);
    high_ = step_ * std::ceil(high / step_);
  }
  double at(double v) const { return from_ + (v - low_) / (high_ - low_) * (to_ - from_); }
  std::vector<double> ticks() const {
    std::vector<double> all;
    for (double k = 0; low_ + k * step_ < high_ + step_ / 2; ++k) all.push_back(low_ + k * step_);
    return all;
  }

 private:
  double from_, to_, low_, high_, step_;
};

RoundSteps vertical(const std::vector<PlotPoint>& points) {
  double low = points.empty() ? 0 : points.front().mean, high = low;
  for (const PlotPoint& p : points) {
    low = std::min(low, p.mean - p.error);
    high = std::max(high, p.mean + p.error);
  }
  return {low, high, height - bottom, top};
}

/// Where each point stands, from the left.
std::vector<double> places(const std::vector<PlotPoint>& points, bool logarithmic) {
  std::vector<double> x;
  x.reserve(points.size());
  for (const PlotPoint& p : points) x.push_back(logarithmic ? elementary::log(p.x) : p.x);
  if (x.empty()) return x;
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double first = *low, way = *high - *low;
  constexpr double inside = 16;
  for (double& v : x) {
    const double share = way > 0 ? (v - first) / way : 0.5;
    v = left + inside + share * (width - left - right - 2 * inside);
  }
  return x;
}

}  // namespace

std::string error_bars_svg(const std::vector<PlotPoint>& points, const ErrorBars& layout) {
  const RoundSteps y = vertical(points);
  const std::vector<double> x = places(points, layout.logarithmic);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#333\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<text x=\"{2}\" y=\"24\" font-size=\"15\">{3}</text>\n",
      width, height, left, escaped(layout.title));
  for (const double v : y.ticks()) {
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:.4g}</text>\n",
        left, width - right, y.at(v), left - 6, y.at(v) + 4, v);
  }
  std::string way, marks;
  const std::size_t every = points.size() / most_labels + 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlotPoint& p = points[i];
    way += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", x[i], y.at(p.mean));
    marks += fmt::format(
        "<g stroke=\"#1f4e79\" fill=\"#1f4e79\">"
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>"
        "<circle cx=\"{0:.1f}\" cy=\"{3:.1f}\" r=\"3\"/>"
        "<title>{4}: {5:.6g} ± {6:.2g} ({7} runs)</title></g>\n",
        x[i], y.at(p.mean - p.error), y.at(p.mean + p.error), y.at(p.mean), escaped(p.label),
        p.mean, p.error, p.runs);
    if (i % every != 0) continue;
    marks += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x[i],
                         height - bottom + 18, escaped(p.label));
  }
  if (layout.joined) {
    svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"#9db8d2\"/>\n", way);
  }
  svg += marks;
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n</svg>\n",
                     (left + width - right) / 2, height - 12, escaped(layout.axis));
  return svg;
}

}  // namespace craze
