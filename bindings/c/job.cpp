// A run of the interface: what is cracked, how, and the run itself.
#include <nlohmann/json.hpp>

#include "callback_context.h"
#include "craze/output/named_nodes.h"
#include "craze/presets.h"
#include "craze/recipe/recipe_json.h"
#include "craze/recipe/set_key.h"
#include "given_picture.h"
#include "guard.h"
#include "handles.h"
#include "opened_pieces.h"

using namespace craze;
using namespace craze::c;

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
    job->textures[name] = grey_picture(pixels, type, width, height, channels, name);
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
    const Recipe recipe =
        with_named_nodes(job->recipe, *job->mesh, job->source ? job->source->scene.get() : nullptr);
    job->result = crack({job->mesh, job->textures, "mesh"}, recipe, options, context.get());
    job->post.reset();
    job->rougher.reset();
    pieces.tell();
    job->cracked_source = job->source;
  });
}
