// A run of the interface: what is cracked, how, and the run itself.
#include <nlohmann/json.hpp>

#include "callback_context.h"
#include "craze/base/image.h"
#include "craze/presets.h"
#include "craze/recipe/recipe_json.h"
#include "craze/recipe/set_key.h"
#include "guard.h"
#include "handles.h"
#include "opened_pieces.h"

using namespace craze;
using namespace craze::c;

namespace {

template <class T>
std::vector<T> copy_pixels(const void* pixels, int64_t count) {
  const T* first = static_cast<const T*>(pixels);
  return {first, first + count};
}

decltype(Image::values) pixel_values(const void* pixels, craze_type type, int64_t count,
                                     const char* name) {
  switch (type) {
    case CRAZE_UINT8:
      return copy_pixels<std::uint8_t>(pixels, count);
    case CRAZE_UINT16:
      return copy_pixels<std::uint16_t>(pixels, count);
    case CRAZE_FLOAT32: {
      std::vector<float> values = copy_pixels<float>(pixels, count);
      for (const float x : values) {
        if (!(x >= 0 && x <= 1)) {
          throw Error(ErrorKind::usage, "wrong pixel", name, "must be in [0, 1]");
        }
      }
      return values;
    }
    default:
      throw Error(ErrorKind::usage, "wrong type of pixels", name,
                  "must be CRAZE_UINT8, CRAZE_UINT16 or CRAZE_FLOAT32");
  }
}

}  // namespace

craze_job* craze_job_new(void) {
  return guarded(nullptr, [] { return new craze_job; });
}

void craze_job_free(craze_job* job) {
  delete job;
}

craze_status craze_job_set_mesh(craze_job* job, const craze_mesh* mesh, craze_error* error) {
  return guard(error, [&] {
    require(job, "job");
    require(mesh, "mesh");
    job->mesh = mesh->mesh;
    job->source = mesh->opening ? nullptr : mesh->source;
  });
}

craze_status craze_job_set_texture(craze_job* job, const char* name, const void* pixels,
                                   craze_type type, int64_t width, int64_t height, int32_t channels,
                                   craze_error* error) {
  return guard(error, [&] {
    require(job, "job");
    require(name, "name");
    require(pixels, "pixels");
    constexpr int64_t longest = 16384;
    if (width < 1 || height < 1 || width > longest || height > longest) {
      throw Error(ErrorKind::usage, "wrong size of a picture", name,
                  "its sides must be 1 to 16384 pixels");
    }
    if (channels < 1 || channels > 4) {
      throw Error(ErrorKind::usage, "wrong number of channels", name, "must be 1 to 4");
    }
    Image image;
    image.width = static_cast<std::int32_t>(width);
    image.height = static_cast<std::int32_t>(height);
    image.channels = channels;
    image.values = pixel_values(pixels, type, width * height * channels, name);
    job->textures[name] = to_grey(image);
  });
}

craze_status craze_job_set_preset(craze_job* job, const char* preset, craze_error* error) {
  return guard(error, [&] {
    require(job, "job");
    require(preset, "preset");
    job->recipe = read_preset(preset);
  });
}

craze_status craze_job_set_recipe(craze_job* job, const char* text, const char* name,
                                  craze_error* error) {
  return guard(error, [&] {
    require(job, "job");
    require(text, "text");
    job->recipe = read_recipe(text, name ? name : "recipe");
  });
}

craze_status craze_job_set(craze_job* job, const char* key, const char* value, craze_error* error) {
  return guard(error, [&] {
    require(job, "job");
    require(key, "key");
    require(value, "value");
    set_key(job->recipe, key, value, std::string(key) + " = " + value);
  });
}

char* craze_job_recipe(const craze_job* job, craze_error* error) {
  return guarded(error, [&] {
    require(job, "job");
    return copy_text(recipe_to_json(job->recipe).dump());
  });
}

char* craze_job_recipe_toml(const craze_job* job, craze_error* error) {
  return guarded(error, [&] {
    require(job, "job");
    return copy_text(write_recipe(job->recipe));
  });
}

craze_status craze_job_set_threads(craze_job* job, int threads, craze_error* error) {
  return guard(error, [&] {
    require(job, "job");
    if (threads < 0 || threads > Threads::max_count) {
      wrong_argument("wrong number of threads", "threads", "0 (one per core) to 1024");
    }
    job->threads = threads;
  });
}

craze_status craze_job_set_max_cracks(craze_job* job, int64_t max_cracks, craze_error* error) {
  return guard(error, [&] {
    require(job, "job");
    job->options.max_cracks.reset();
    if (max_cracks >= 0) job->options.max_cracks = max_cracks;
  });
}

void craze_job_set_progress(craze_job* job, craze_progress progress, void* user) {
  if (!job) return;
  job->progress = progress;
  job->user = user;
}

void craze_job_set_opened(craze_job* job, craze_opened opened, void* user) {
  if (!job) return;
  job->opened = opened;
  job->opened_user = user;
}

craze_status craze_job_run(craze_job* job, craze_error* error) {
  return guard(error, [&] {
    require(job, "job");
    if (!job->mesh) wrong_argument("nothing to crack", "craze_job_run", "set a mesh first");
    CrackOptions options = job->options;
    options.on_cancel = OnCancel::discard;
    OpenedPieces pieces(job->opened, job->opened_user);
    if (job->opened) options.on_opened = [&](const OpenedPiece& piece) { pieces.add(piece); };
    const CallbackContext context(*job);
    job->result = crack({job->mesh, job->textures, "mesh"}, job->recipe, options, context.get());
    job->rougher.reset();
    pieces.tell();
    job->cracked_source = job->source;
  });
}
