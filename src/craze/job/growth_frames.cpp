#include "craze/job/growth_frames.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/job/crack_picture.h"
#include "craze/job/output_place.h"
#include "craze/products/opening/shading_normals.h"
#include "craze/render/png.h"
#include "craze/render/video.h"
#include "craze/write_mesh.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

SurfaceMesh mesh_at(const GrowthScene& scene, double time) {
  SurfaceMesh mesh = scene.shown.mesh;
  mesh.positions = scene.growth.positions_at(time);
  mesh.vertex_attributes.push_back({"openness", 1, scene.growth.openness_at(time)});
  return mesh;
}

/// Takes the pictures, one moment after the other, from one place.
class Photographer {
 public:
  Photographer(const GrowthScene& scene, const render::PictureOptions& options,
               const Context& context)
      : scene_(scene), options_(options), mesh_(scene.shown.mesh) {
    options_.subject = render::subject_of(mesh_);
    mesh_.face_attributes.clear();  // fragments look alike before they are ones
    // What bends is shaded as it stands at each moment.
    mesh_.corner_normals.clear();
    if (!scene.shown.curled) {
      mesh_.corner_normals = shading_normals(scene.shown, scene.result, options_.crease);
    }
    lines_ = picture_lines(scene.shown, scene.result, render::line_reach(mesh_, options_), context);
  }

  render::Image picture(double time, const Context& context) {
    render::set_widths(lines_, scene_.shown.times.sites.sides,
                       scene_.growth.side_openness_at(time));
    mesh_.positions = scene_.growth.positions_at(time);
    return render::render_picture(mesh_, &lines_, options_, context);
  }

 private:
  const GrowthScene& scene_;
  render::PictureOptions options_;
  SurfaceMesh mesh_;
  render::CrackLines lines_;
};

void make_folder(const std::string& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw Error(ErrorKind::output, "cannot write the frames", folder, failure.message());
  }
}

}  // namespace

void write_frames(const RunRequest& request, const GrowthScene& scene,
                  const render::PictureOptions& options, const Context& context) {
  const bool pictures = request.frame_format == "png" || !request.video.empty();
  std::optional<Photographer> photographer;
  if (pictures) photographer.emplace(scene, options, context);
  std::optional<render::Video> video;
  if (!request.video.empty()) {
    video.emplace(followed(request.video).string(), options.width, options.height,
                  request.frame_count / request.clip_seconds);
  }
  if (!request.frames.empty()) make_folder(request.frames);
  for (int i = 0; i < request.frame_count; ++i) {
    context.check();
    const double time = request.frame_count > 1 ? i / (request.frame_count - 1.0) : 1;
    const double frames = request.frame_count;
    const Context frame = phase_part(context, "frames", i / frames, (i + 1) / frames);
    frame.report({});
    const fs::path path =
        fs::path(request.frames) / fmt::format("frame_{:04}.{}", i, request.frame_format);
    render::Image image;
    if (pictures) image = photographer->picture(time, frame);
    if (video) video->add(image, frame);
    if (request.frames.empty()) continue;
    if (request.frame_format == "png") {
      render::write_png(path.string(), image, frame);
    } else {
      write_mesh(path, mesh_at(scene, time), {}, frame);
    }
  }
  context.report({"frames", 1});
  if (video) video->finish(context);
}

}  // namespace craze
