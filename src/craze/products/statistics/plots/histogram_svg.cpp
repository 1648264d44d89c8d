#include <algorithm>
#include <cmath>

#include "craze/base/text/format.h"
#include "craze/products/statistics/plots/plots.h"

namespace craze {

std::string histogram_svg(const std::vector<double>& values, const Histogram& layout) {
  constexpr double width = 480, height = 320;
  constexpr double left = 56, right = 16, top = 40, bottom = 48;
  std::vector<double> share(layout.bins, 0.0);
  const double bin = (layout.high - layout.low) / layout.bins;
  for (const double v : values) {
    // A value on the edge between two bins, up to rounding, belongs to the upper one.
    const double k = std::floor((v - layout.low) / bin + 1e-9);
    if (k >= 0 && k < layout.bins) share[static_cast<std::size_t>(k)] += 1.0 / values.size();
  }
  double peak = *std::max_element(share.begin(), share.end());
  if (peak == 0) peak = 1;
  // Horizontal lines at a round share, four to eight of them.
  double step = 1;
  while (step > peak) step /= 10;
  while (peak / step < 4) step /= 2;
  const double ceiling = step * std::ceil(peak / step);
  const auto x = [&](double v) {
    return left + (v - layout.low) / (layout.high - layout.low) * (width - left - right);
  };
  const auto y = [&](double s) { return height - bottom - s / ceiling * (height - top - bottom); };

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#333\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<text x=\"{2}\" y=\"24\" font-size=\"15\">{3}</text>\n"
      "<text x=\"{4}\" y=\"24\" text-anchor=\"end\" fill=\"#777\">n = {5}</text>\n",
      width, height, left, layout.title, width - right, values.size());
  for (double s = 0; s < ceiling + step / 2; s += step) {
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:.3g} %</text>\n",
        left, width - right, y(s), left - 6, y(s) + 4, 100 * s);
  }
  for (int k = 0; k < layout.bins; ++k) {
    if (share[k] == 0) continue;
    const double a = x(layout.low + k * bin), b = x(layout.low + (k + 1) * bin);
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#4878a8\"/>\n",
        a + 0.5, y(share[k]), b - a - 1, y(0) - y(share[k]));
  }
  for (const double m : layout.marks) {
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#c0392b\" "
        "stroke-dasharray=\"4 3\"/>\n",
        x(m), top, height - bottom);
  }
  const auto ticks = static_cast<int>((layout.high - layout.first_tick) / layout.tick + 1e-9);
  for (int k = 0; k <= ticks; ++k) {
    const double v = layout.first_tick + k * layout.tick;
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:.6g}</text>\n", x(v),
                       height - bottom + 16, v);
  }
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n</svg>\n",
                     (left + width - right) / 2, height - 10, layout.axis);
  return svg;
}

std::string angles_svg(const Statistics& s) {
  return histogram_svg(
      s.samples.angles,
      {"Angles at junctions of three", "angle, degrees", 0, 240, 48, 0, 30, {90, 120, 180}});
}

std::string areas_svg(const Statistics& s) {
  return histogram_svg(s.samples.areas,
                       {"Cell areas", "area over mean area", 0, 4, 40, 0, 0.5, {1}});
}

std::string sides_svg(const Statistics& s) {
  return histogram_svg(s.samples.sides, {"Sides per cell", "sides", 1.5, 12.5, 11, 2, 1, {}});
}

}  // namespace craze
