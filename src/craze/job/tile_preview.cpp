#include "craze/job/tile_preview.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/base/image.h"
#include "craze/base/srgb.h"
#include "craze/render/picture.h"

namespace craze {

namespace {

constexpr int tiles_on_plane = 2, tiles_around = 4, tiles_up = 2;
constexpr int preview_size = 800;

/// Vertex (i, j) of a grid with a triangle pair for each texel.
SurfaceMesh grid_of(int across, int up, int texels, const auto& place) {
  SurfaceMesh mesh;
  for (int j = 0; j <= up; ++j) {
    for (int i = 0; i <= across; ++i) mesh.positions.push_back(place(i, j));
  }
  const auto vertex = [&](int i, int j) { return j * (across + 1) + i; };
  const auto uv = [&](int i, int j) {
    return Vec2(static_cast<double>(i) / texels, static_cast<double>(j) / texels);
  };
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < across; ++i) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      for (const Vec2& corner :
           {uv(i, j), uv(i + 1, j), uv(i + 1, j + 1), uv(i, j), uv(i + 1, j + 1), uv(i, j + 1)}) {
        mesh.corner_uvs.push_back(corner);
      }
    }
  }
  return mesh;
}

/// The height half a texel to the left of and below the middle of texel (i, j), both repeating;
/// j counts from below.
double height_at(const Map& height, int i, int j) {
  const int n = height.header.size;
  const auto texel = [&](int x, int y) -> double {
    const int column = (x + n) % n, row = n - 1 - (y + n) % n;
    return height.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(n) +
                         static_cast<std::size_t>(column)];
  };
  return (texel(i - 1, j - 1) + texel(i, j - 1) + texel(i - 1, j) + texel(i, j)) / 4;
}

}  // namespace

SurfaceMesh tiled_plane(const Map& height, double side) {
  const int n = height.header.size, across = tiles_on_plane * n;
  return grid_of(across, across, n, [&](int i, int j) {
    return Vec3(side * i / n, side * j / n, height_at(height, i % n, j % n));
  });
}

SurfaceMesh tiled_sphere(const Map& height, double side) {
  const int n = height.header.size, around = tiles_around * n, up = tiles_up * n;
  const double radius = tiles_around * side / (2 * std::numbers::pi);
  return grid_of(around, up, n, [&](int i, int j) {
    const double longitude = 2 * std::numbers::pi * i / around;
    const double latitude = std::numbers::pi * (static_cast<double>(j) / up - 0.5);
    const double r = radius + height_at(height, i % n, j % n);
    const double ring = r * elementary::cos(latitude);
    return Vec3(ring * elementary::cos(longitude), ring * elementary::sin(longitude),
                r * elementary::sin(latitude));
  });
}

render::Image tile_picture(const SurfaceMesh& mesh, const Map& base_color,
                           const render::Material& material, const Context& context) {
  std::vector<std::uint8_t> pixels;
  for (const float x : base_color.values) {
    const double stored = linear_to_srgb(std::clamp(x, 0.0f, 1.0f));
    pixels.push_back(static_cast<std::uint8_t>(std::floor(255 * stored + 0.5)));
  }
  const int n = base_color.header.size;
  const Image image{n, n, 3, std::move(pixels)};
  render::PictureOptions options;
  options.width = options.height = preview_size;
  options.material = material;
  options.material.mottle = options.material.pieces = 0;  // they are in the base colour
  options.material.glass = false;
  options.view.up = UpAxis::z;
  render::Look look;
  look.picture.texture = std::make_shared<const render::ColorTexture>(image);
  options.looks = {look};
  return render_picture(mesh, nullptr, options, context);
}

}  // namespace craze
