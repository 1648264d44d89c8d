#include "craze/scenario/growth_output.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "craze/io/write_mesh.h"
#include "craze/render/png.h"
#include "craze/render/video.h"

namespace craze {

GrowthScene::GrowthScene(const RunRequest& request, const Simulation& simulation,
                         const SurfaceMesh& surface, const ShownSurface& shown,
                         const CrackSites& sites, const CrackSchedule& schedule)
    : request_(request),
      simulation_(simulation),
      surface_(surface),
      shown_(shown),
      sites_(sites),
      schedule_(schedule),
      motion_(simulation.mesh(), sites, schedule, shown.opened) {}

MorphAnimation GrowthScene::animation() const {
  MorphAnimation animation;
  animation.seconds = request_.clip_seconds;
  std::vector<Vec3> before = motion_.positions(0);
  const int stages = request_.animation_stages;
  for (int k = 1; k <= stages; ++k) {
    std::vector<Vec3> now = motion_.positions(static_cast<double>(k) / stages);
    MorphStage& stage = animation.stages.emplace_back();
    for (std::size_t v = 0; v < now.size(); ++v) {
      if (now[v] == before[v]) continue;
      stage.vertices.push_back(static_cast<std::int32_t>(v));
      stage.shifts.push_back(now[v] - before[v]);
    }
    before = std::move(now);
  }
  return animation;
}

std::vector<std::array<float, 2>> GrowthScene::side_openness(double time) const {
  std::vector<std::array<float, 2>> open;
  for (const auto& [from, to] : schedule_.sides) {
    open.push_back({static_cast<float>(CrackSchedule::openness(from, time)),
                    static_cast<float>(CrackSchedule::openness(to, time))});
  }
  return open;
}

SurfaceMesh GrowthScene::mesh_at(double time) const {
  SurfaceMesh mesh = shown_.mesh;
  mesh.positions = motion_.positions(time);
  Attribute openness{"openness", 1, {}};
  for (const std::int32_t v : shown_.opened.vertex_of) {
    const std::int32_t site = sites_.site_of[v];
    openness.values.push_back(site < 0 ? 0 : CrackSchedule::openness(schedule_.sites[site], time));
  }
  mesh.vertex_attributes.push_back(std::move(openness));
  return mesh;
}

/// Takes the pictures, one moment after the other, from one place.
class GrowthScene::Photographer {
 public:
  Photographer(const GrowthScene& scene, const render::PictureOptions& options)
      : scene_(scene), options_(options), mesh_(scene.shown_.mesh) {
    options_.subject = mesh_.positions;
    mesh_.face_attributes.clear();  // fragments look alike before they are ones
    mesh_.corner_normals = picture_normals(scene.shown_, scene.surface_, scene.simulation_,
                                           scene.request_.recipe.post, options_.crease);
    lines_ =
        picture_lines(scene.shown_, scene.simulation_.mesh(), render::line_reach(mesh_, options_));
  }

  render::Image picture(double time, const Context& context) {
    render::set_widths(lines_, scene_.sites_.sides, scene_.side_openness(time));
    mesh_.positions = scene_.motion_.positions(time);
    return render::render_picture(mesh_, &lines_, options_, context);
  }

 private:
  const GrowthScene& scene_;
  render::PictureOptions options_;
  SurfaceMesh mesh_;
  render::CrackLines lines_;
};

void GrowthScene::write_frames(const render::PictureOptions& options,
                               const Context& context) const {
  namespace fs = std::filesystem;
  const bool pictures = request_.frame_format == "png" || !request_.video.empty();
  std::optional<Photographer> photographer;
  if (pictures) photographer.emplace(*this, options);
  std::optional<render::Video> video;
  if (!request_.video.empty()) {
    video.emplace(request_.video, options.width, options.height,
                  request_.frame_count / request_.clip_seconds);
  }
  if (!request_.frames.empty()) fs::create_directories(request_.frames);
  for (int i = 0; i < request_.frame_count; ++i) {
    const double time = request_.frame_count > 1 ? i / (request_.frame_count - 1.0) : 1;
    context.report({"frames", time, simulation_.events(), simulation_.mesh().face_count(),
                    simulation_.load()});
    const fs::path path =
        fs::path(request_.frames) / fmt::format("frame_{:04}.{}", i, request_.frame_format);
    render::Image image;
    if (pictures) image = photographer->picture(time, context);
    if (video) video->add(image);
    if (request_.frames.empty()) continue;
    if (request_.frame_format == "png") {
      render::write_png(path.string(), image);
    } else {
      write_mesh(path, mesh_at(time));
    }
  }
  if (video) video->finish();
}

}  // namespace craze
