#include "craze/render/picture.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "craze/error.h"
#include "products/distance/surfaces.h"

namespace craze::render {
namespace {

SurfaceMesh surface(const TriangleMesh& mesh) {
  SurfaceMesh s;
  s.positions = mesh.positions();
  s.triangles = mesh.triangles();
  return s;
}

PictureOptions small(const std::string& material) {
  PictureOptions options;
  options.width = 96;
  options.height = 72;
  options.material = find_material(material);
  return options;
}

double brightness(const Image& image, int x, int y) {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * image.width + x);
  return (image.rgb[i] + image.rgb[i + 1] + image.rgb[i + 2]) / 3.0;
}

/// The plate from straight above, a crack along y = 0.5 from border to border.
struct CrackedPlate {
  TriangleMesh mesh = test::plate(10, 0);
  PictureOptions options = small("plaster");

  CrackedPlate() {
    options.view.elevation = 90;
    options.width = options.height = 101;
    options.line_width = 0.04;
    const auto on_line = [&](std::int32_t v) {
      return std::abs(mesh.position(v).y() - 0.5) < 1e-9;
    };
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      if (!mesh.is_open(h) && on_line(mesh.from(h)) && on_line(mesh.to(h))) mesh.cut(h, 0);
    }
  }
  CrackLines lines() const {
    return crack_lines(mesh, crack_sides(mesh), line_reach(surface(mesh), options), {});
  }
};

TEST(Picture, IsTheSameOnAnyNumberOfThreads) {
  TriangleMesh mesh = test::torus(24);
  test::cut_at_random(mesh, 80, 0, 3);
  const SurfaceMesh s = surface(mesh);
  for (const Material& material : materials()) {
    const PictureOptions options = small(material.name);
    const CrackLines lines = crack_lines(mesh, crack_sides(mesh), line_reach(s, options), {});
    Context one, many;
    one.threads = 1;
    many.threads = 3;
    EXPECT_EQ(render_picture(s, &lines, options, one).rgb,
              render_picture(s, &lines, options, many).rgb)
        << material.name;
  }
}

TEST(Picture, DrawsACrackAsADarkLineWhereItLies) {
  const CrackedPlate plate;
  const CrackLines lines = plate.lines();
  const Image with = render_picture(surface(plate.mesh), &lines, plate.options, {});
  const Image without = render_picture(surface(plate.mesh), nullptr, plate.options, {});
  EXPECT_LT(brightness(with, 50, 50), 0.6 * brightness(without, 50, 50));
  EXPECT_NEAR(brightness(with, 50, 30), brightness(without, 50, 30), 3);
}

TEST(Picture, ALineAsFineAsAnImagePointKeepsItsInk) {
  CrackedPlate plate;
  const auto ink = [&](double width) {
    plate.options.line_width = width;
    plate.options.material.stain = plate.options.material.groove = 0;
    const CrackLines lines = plate.lines();
    const Image with = render_picture(surface(plate.mesh), &lines, plate.options, {});
    const Image without = render_picture(surface(plate.mesh), nullptr, plate.options, {});
    double sum = 0;
    for (int x = 30; x < 70; ++x) {
      for (int y = 20; y < 80; ++y) sum += brightness(without, x, y) - brightness(with, x, y);
    }
    return sum;
  };
  EXPECT_NEAR(ink(0.004) / ink(0.008), 0.5, 0.12);
}

TEST(Picture, LineWidthMayVaryAlongACrack) {
  const CrackedPlate plate;
  std::vector<std::array<float, 2>> width;
  const std::vector<std::int32_t> sides = crack_sides(plate.mesh);
  const auto at = [&](std::int32_t v) { return plate.mesh.position(v).x() < 0.5 ? 0.0f : 1.0f; };
  for (const std::int32_t h : sides)
    width.push_back({at(plate.mesh.from(h)), at(plate.mesh.to(h))});
  CrackLines lines = plate.lines();
  set_widths(lines, sides, width);
  const Image image = render_picture(surface(plate.mesh), &lines, plate.options, {});
  EXPECT_GT(brightness(image, 30, 50), 1.5 * brightness(image, 70, 50));
}

TEST(Picture, AnOpenCrackLeavesNoSeamInTheShading) {
  const TriangleMesh whole = test::torus(30);
  TriangleMesh cracked = whole;
  test::cut_at_random(cracked, 300, 0, 8);
  const PictureOptions options = small("clay");
  EXPECT_EQ(render_picture(surface(whole), nullptr, options, {}).rgb,
            render_picture(surface(cracked), nullptr, options, {}).rgb);
}

TEST(Picture, FramesTheObjectInsideTheMargin) {
  PictureOptions options = small("plaster");
  options.ground = false;
  options.backdrop = Rgb::Zero();
  const Image image = render_picture(surface(test::torus(40)), nullptr, options, {});
  int left = image.width, right = -1, top = image.height, bottom = -1;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (brightness(image, x, y) < 1) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  EXPECT_NEAR(left, 0.08 * image.width, 2);
  EXPECT_NEAR(right, 0.92 * image.width, 2);
  EXPECT_NEAR(image.height - 1 - bottom, top, 2);
}

TEST(Picture, DoesNotDependOnTheUnitOrPlaceOfTheModel) {
  const SurfaceMesh here = surface(test::torus(20));
  SurfaceMesh far = here;
  for (Vec3& p : far.positions) p = 1024 * p + Vec3(1 << 20, -(1 << 18), 1 << 19);
  const Image a = render_picture(here, nullptr, small("clay"), {});
  const Image b = render_picture(far, nullptr, small("clay"), {});
  int different = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) different += std::abs(a.rgb[i] - b.rgb[i]) > 2;
  EXPECT_LT(different, static_cast<int>(a.rgb.size() / 200));
}

/// Mean difference of two pictures over the points that both show as lit object.
double difference(const Image& a, const Image& b) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (brightness(a, x, y) < 2 || brightness(b, x, y) < 2) continue;
      sum += std::abs(brightness(a, x, y) - brightness(b, x, y));
      ++count;
    }
  }
  return sum / count;
}

TEST(Picture, TheEdgeOfTheLightIsSmoothOnACoarseSurface) {
  PictureOptions options = small("plaster");
  options.material.mottle = options.material.bump = 0;
  options.ground = false;
  options.light = {90, 0};
  options.view.elevation = options.view.azimuth = 0;
  options.width = options.height = 160;
  // A ball, from triangles as large as a sixth of it; the light comes from the right.
  const auto ball = [](int n) {
    return surface(test::grid(2 * n, n, true, false, [](double u, double v) {
      const double a = 2 * std::numbers::pi * u, b = std::numbers::pi * (0.02 + 0.96 * v);
      return Vec3(std::sin(b) * std::cos(a), -std::cos(b), -std::sin(b) * std::sin(a));
    }));
  };
  const Image coarse = render_picture(ball(9), nullptr, options, {});
  const Image fine = render_picture(ball(60), nullptr, options, {});
  // Without care, triangles that the light just misses stay dark as a whole: 7 darker.
  double darker = 0;
  for (int y = 30; y < 130; ++y) {
    for (int x = 50; x < 110; ++x) {
      darker = std::max(darker, brightness(fine, x, y) - brightness(coarse, x, y));
    }
  }
  EXPECT_LT(darker, 3);
}

TEST(Picture, ZoomShowsTheTargetInTheMiddleAndLarger) {
  CrackedPlate plate;
  const CrackLines lines = plate.lines();
  plate.options.view.target = Vec3(0.5, 0.4, 0);
  plate.options.view.zoom = 4;
  const Image image = render_picture(surface(plate.mesh), &lines, plate.options, {});
  // The crack is 0.1 above the middle: the plate, 84 points high before, is four times as large.
  const int row = 50 - static_cast<int>(0.1 * 4 * 0.84 * 101);
  EXPECT_LT(brightness(image, 50, row), 0.6 * brightness(image, 50, 50));
}

TEST(Picture, WhatIsOutOfFocusIsBlurred) {
  CrackedPlate plate;
  const CrackLines lines = plate.lines();
  // Of the crack beside the plate's own brightness.
  const auto contrast = [&](double aperture, const std::optional<Vec3>& focus) {
    plate.options.view.aperture = aperture;
    plate.options.view.focus = focus;
    const Image image = render_picture(surface(plate.mesh), &lines, plate.options, {});
    return brightness(image, 50, 50) / brightness(image, 50, 30);
  };
  const double sharp = contrast(0, {});
  EXPECT_NEAR(contrast(0.1, {}), sharp, 0.05) << "in the middle";
  EXPECT_NEAR(contrast(0.1, Vec3(0.2, 0.3, 0)), sharp, 0.05) << "on the plate";
  EXPECT_GT(contrast(0.1, Vec3(0.5, 0.5, 1)), sharp + 0.2) << "above it";
  EXPECT_GT(contrast(0.1, Vec3(0.5, 0.5, -100)), sharp + 0.1) << "far behind it";
}

TEST(Picture, WhatIsNotFiniteIsRefused) {
  const SurfaceMesh plate = surface(test::plate(2, 0));
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  int number = 0;
  const auto expect_refused = [&](auto change) {
    PictureOptions options = small("plaster");
    change(options);
    EXPECT_THROW(render_picture(plate, nullptr, options, {}), Error) << number;
    ++number;
  };
  for (const double wrong : {nan, inf, -inf}) {
    expect_refused([&](PictureOptions& o) { o.view.azimuth = wrong; });
    expect_refused([&](PictureOptions& o) { o.view.elevation = wrong; });
    expect_refused([&](PictureOptions& o) { o.view.zoom = wrong; });
    expect_refused([&](PictureOptions& o) { o.view.margin = wrong; });
    expect_refused([&](PictureOptions& o) { o.view.field_of_view = wrong; });
    expect_refused([&](PictureOptions& o) { o.view.aperture = wrong; });
    expect_refused([&](PictureOptions& o) { o.view.target = Vec3(0, wrong, 0); });
    expect_refused([&](PictureOptions& o) { o.view.focus = Vec3(0, wrong, 0); });
    expect_refused([&](PictureOptions& o) { o.light.azimuth = wrong; });
    expect_refused([&](PictureOptions& o) { o.light.elevation = wrong; });
    expect_refused([&](PictureOptions& o) { o.environment.turn = wrong; });
    expect_refused([&](PictureOptions& o) { o.exposure = static_cast<float>(wrong); });
    expect_refused([&](PictureOptions& o) { o.line_width = wrong; });
  }
  expect_refused([](PictureOptions& o) { o.view.target = Vec3(1e308, 0, 0); });
  expect_refused([](PictureOptions& o) { o.view.aperture = -0.1; });
}

TEST(Picture, TheLampStandsWhereItIsAskedTo) {
  PictureOptions options = small("plaster");
  options.view.elevation = 0;
  options.view.azimuth = 0;
  const SurfaceMesh torus = surface(test::torus(40));
  const auto sides = [&](double azimuth) {
    options.light = {azimuth, 10};
    const Image image = render_picture(torus, nullptr, options, {});
    return std::pair{brightness(image, 14, 36), brightness(image, 81, 36)};
  };
  const auto [left, dark_right] = sides(-80);
  const auto [dark_left, right] = sides(80);
  EXPECT_GT(left, 1.3 * dark_right);
  EXPECT_GT(right, 1.3 * dark_left);
}

TEST(Picture, LinesAreCrispOnTwoHundredTriangles) {
  // A diagonal crack over a plate of 200 triangles, against the same over 20,000.
  const auto picture = [](int n) {
    TriangleMesh mesh = test::plate(n, 0);
    const auto on_line = [&](std::int32_t v) {
      return std::abs(mesh.position(v).y() - mesh.position(v).x()) < 1e-9;
    };
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      if (!mesh.is_open(h) && on_line(mesh.from(h)) && on_line(mesh.to(h))) mesh.cut(h, 0);
    }
    PictureOptions options = small("plaster");
    options.view.elevation = 90;
    options.width = options.height = 201;
    options.line_width = 0.02;
    const CrackLines lines =
        crack_lines(mesh, crack_sides(mesh), line_reach(surface(mesh), options), {});
    return render_picture(surface(mesh), &lines, options, {});
  };
  const Image coarse = picture(10), fine = picture(100);
  int different = 0;
  for (std::size_t i = 0; i < coarse.rgb.size(); ++i) {
    different += std::abs(coarse.rgb[i] - fine.rgb[i]) > 3 ? 1 : 0;
  }
  EXPECT_LT(different, static_cast<int>(coarse.rgb.size() / 500));
  EXPECT_LT(brightness(coarse, 100, 100), 0.6 * brightness(coarse, 100, 60)) << "there is a line";
}

TEST(Picture, PicturesOfOneSubjectAreTakenFromOnePlace) {
  PictureOptions options = small("clay");
  options.view.elevation = 90;
  options.ground = false;
  const SurfaceMesh whole = surface(test::torus(30));
  SurfaceMesh top = whole;
  top.triangles.resize(whole.triangles.size() / 2);  // the upper half of the ring
  for (Vec3& p : top.positions) p.y() = std::max(p.y(), 0.0);
  const Image alone = render_picture(top, nullptr, options, {});
  options.subject = subject_of(whole);
  const Image of_whole = render_picture(whole, nullptr, options, {});
  const Image of_top = render_picture(top, nullptr, options, {});
  EXPECT_LT(difference(of_whole, of_top), 0.5);
  EXPECT_GT(difference(of_whole, alone), 0.5);
}

TEST(Picture, WornEdgesOfGapsAreDrawnOnTheMovedSurface) {
  CrackedPlate plate;
  plate.options.material = find_material("mud");
  SurfaceMesh moved = surface(plate.mesh);
  for (Vec3& p : moved.positions) p.y() += p.y() > 0.5 ? 0.03 : -0.03;
  CrackLines lines = plate.lines();
  const Image sharp = render_picture(moved, nullptr, plate.options, {});
  lines.open = true;
  lines.places = plate.mesh.positions();
  const Image worn = render_picture(moved, &lines, plate.options, {});
  EXPECT_NE(sharp.rgb, worn.rgb);
  // Nothing is drawn away from the edges.
  EXPECT_NEAR(brightness(sharp, 50, 15), brightness(worn, 50, 15), 12);
}

TEST(Picture, RefusesWhatCannotBeDrawn) {
  const SurfaceMesh torus = surface(test::torus(8));
  EXPECT_THROW(render_picture({}, nullptr, small("clay"), {}), Error);
  PictureOptions huge = small("clay");
  huge.width = 1 << 20;
  EXPECT_THROW(render_picture(torus, nullptr, huge, {}), Error);
  SurfaceMesh broken = torus;
  broken.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(render_picture(broken, nullptr, small("clay"), {}), Error);
  CrackLines foreign;
  foreign.cracks.first.assign(torus.triangles.size() + 2, 0);
  EXPECT_THROW(render_picture(torus, &foreign, small("clay"), {}), Error);
  EXPECT_THROW(find_material("marble"), Error);
}

}  // namespace
}  // namespace craze::render
