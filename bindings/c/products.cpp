// What comes out of a run of the interface.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "callback_context.h"
#include "craze/io/lines/write_lines.h"
#include "craze/products/field_mesh.h"
#include "craze/products/report_json.h"
#include "guard.h"
#include "handles.h"

using namespace craze;
using namespace craze::c;

namespace {

const Result& result_of(const craze_job* job) {
  require(job, "job");
  if (!job->result) wrong_argument("nothing to show", "job", "craze_job_run() comes first");
  return *job->result;
}

constexpr std::string_view point_prefix = "point:", edge_prefix = "edge:";

void view_line_attribute(craze_array& view, const std::vector<Attribute>& attributes,
                         const std::string& name) {
  const Attribute* a = find_attribute(attributes, name);
  if (!a) throw Error(ErrorKind::usage, "no such array", name, "the lines have no such attribute");
  view = {a->values.data(), static_cast<int64_t>(a->values.size()) / a->components, a->components,
          CRAZE_FLOAT64};
}

void view_lines(craze_array& view, const LineSet& lines, std::string_view name) {
  const auto rows = [](const auto& values) { return static_cast<int64_t>(values.size()); };
  if (name == "points") {
    view = {lines.points.data(), rows(lines.points), 3, CRAZE_FLOAT64};
  } else if (name == "edges") {
    view = {lines.edges.data(), rows(lines.edges), 2, CRAZE_INT32};
  } else if (name == "uv") {
    view = {lines.uvs.data(), rows(lines.uvs), 2, CRAZE_FLOAT64};
  } else if (name.substr(0, point_prefix.size()) == point_prefix) {
    view_line_attribute(view, lines.point_attributes,
                        std::string(name.substr(point_prefix.size())));
  } else if (name.substr(0, edge_prefix.size()) == edge_prefix) {
    view_line_attribute(view, lines.edge_attributes, std::string(name.substr(edge_prefix.size())));
  } else {
    throw Error(ErrorKind::usage, "no such array", std::string(name),
                "points, edges, uv, point:NAME and edge:NAME are there");
  }
}

LineSet line_set(const double* points, int64_t p, const int32_t* edges, int64_t e,
                 const double* time) {
  constexpr int64_t most = std::numeric_limits<int32_t>::max();
  if (p < 0 || e < 0 || p > most || e > most) {
    wrong_argument("wrong size", "craze_statistics", "0 to 2147483647 points and edges fit");
  }
  if (p > 0) require(points, "points");
  if (e > 0) require(edges, "edges");
  LineSet lines;
  for (int64_t i = 0; i < p; ++i) {
    lines.points.emplace_back(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
    if (!lines.points.back().allFinite()) {
      wrong_argument("wrong point", std::to_string(i).c_str(), "it is not finite");
    }
  }
  for (int64_t i = 0; i < e; ++i) {
    const int32_t a = edges[2 * i], b = edges[2 * i + 1];
    if (a < 0 || b < 0 || a >= p || b >= p) {
      wrong_argument("wrong edge", std::to_string(i).c_str(), "its points are not there");
    }
    lines.edges.push_back({a, b});
  }
  if (time) {
    lines.edge_attributes.push_back({"time", 1, {time, time + e}});
    if (!std::all_of(time, time + e, [](double t) { return std::isfinite(t); })) {
      wrong_argument("wrong time", "time", "must be finite");
    }
  }
  return lines;
}

craze_opening* new_opening(const craze_job* job, const Result& result, const PostParameters& post) {
  const CallbackContext context(*job);
  auto opening = std::make_shared<const Opening>(result, post, context.get());
  std::vector<std::string> warnings = opening->warnings();
  return new craze_opening{job->cracked_source, std::move(opening), {}, std::move(warnings)};
}

/// The run's own [post], but for what says how its cracks are open.
PostParameters unopened_post(const Result& result) {
  PostParameters post = result.report().recipe.post;
  post.gap = 0;
  post.gap_width = post.wall = post.thickness = 0;
  post.curl = 0;
  return post;
}

/// [post] as a text changes that of a job's result.
PostParameters changed_post(const craze_job& job, const char* text) {
  Recipe asked;
  asked.post = job.post ? *job.post : asked_post(*job.result);
  Recipe changed = read_recipe(text, "post", asked);
  const PostParameters post = changed.post;
  changed.post = asked.post;
  if (!(changed == asked)) {
    throw Error(ErrorKind::usage, "wrong key", "post", "only those of [post] change an opening");
  }
  return post;
}

/// The run of a job with another [post]; lines made anew for it are kept with the job.
Result made_with(craze_job& job, const Result& result, const PostParameters& post) {
  Result made =
      with_post(result, post, CallbackContext(job).get(), job.rougher ? &*job.rougher : nullptr);
  if (&made.state() != &result.state()) job.rougher = made;
  return made;
}

craze_mesh* new_mesh(const craze_opening& shown) {
  std::shared_ptr<const SurfaceMesh> mesh(shown.opening, &shown.opening->mesh());
  auto handle = std::make_unique<craze_mesh>(std::move(mesh));
  handle->source = shown.source;
  handle->opening = shown.opening;
  return handle.release();
}

}  // namespace

craze_mesh* craze_job_cut_mesh(const craze_job* job, craze_error* error) {
  return guarded(error, [&] {
    const CallbackContext context(*job);
    const craze_opening shut{
        job->cracked_source,
        std::make_shared<const Opening>(result_of(job), PostParameters{}, context.get()),
        {},
        {}};
    return new_mesh(shut);
  });
}

craze_mesh* craze_job_fields(const craze_job* job, craze_error* error) {
  return guarded(error, [&] {
    const Result& result = result_of(job);
    return new craze_mesh(field_mesh(result, CallbackContext(*job).get()));
  });
}

craze_lines* craze_job_lines(const craze_job* job, craze_error* error) {
  return guarded(error, [&] {
    const Result& result = result_of(job);
    return new craze_lines{crack_lines(result, CallbackContext(*job).get())};
  });
}

craze_status craze_lines_array(const craze_lines* lines, const char* name, craze_array* array,
                               craze_error* error) {
  return guard(error, [&] {
    require(lines, "lines");
    require(name, "name");
    require(array, "array");
    view_lines(*array, lines->lines, name);
  });
}

craze_status craze_lines_write(const craze_lines* lines, const char* path, craze_error* error) {
  return guard(error, [&] {
    require(lines, "lines");
    require(path, "path");
    write_lines(path, lines->lines, {}, {});
  });
}

void craze_lines_free(craze_lines* lines) {
  delete lines;
}

char* craze_job_report(const craze_job* job, craze_error* error) {
  return guarded(error, [&] {
    const Result& result = result_of(job);
    return copy_text(report_json(result, CallbackContext(*job).get()));
  });
}

char* craze_job_summary(const craze_job* job, craze_error* error) {
  return guarded(error, [&] { return copy_text(report_text(result_of(job).report(), nullptr)); });
}

char* craze_job_statistics(const craze_job* job, craze_error* error) {
  return guarded(error, [&] {
    const Result& result = result_of(job);
    return copy_text(statistics_json(result, CallbackContext(*job).get()));
  });
}

char* craze_statistics(const double* points, int64_t p, const int32_t* edges, int64_t e,
                       const double* time, double simplify, craze_error* error) {
  return guarded(error, [&] {
    if (!(simplify >= 0)) wrong_argument("wrong length", "simplify", "must be 0 or more");
    return copy_text(statistics_json(line_set(points, p, edges, e, time), simplify));
  });
}

craze_opening* craze_job_open(const craze_job* job, double gap, double wall, double curl,
                              craze_error* error) {
  return guarded(error, [&] {
    const Result& result = result_of(job);
    PostParameters post = unopened_post(result);
    post.gap = gap;
    post.wall = wall;
    post.curl = curl;
    return new_opening(job, result, post);
  });
}

craze_opening* craze_job_open_post(craze_job* job, const char* text, craze_error* error) {
  return guarded(error, [&] {
    const Result& result = result_of(job);
    require(text, "text");
    const Result made = made_with(*job, result, changed_post(*job, text));
    craze_opening* opening = new_opening(job, made, made.report().recipe.post);
    const std::vector<std::string>& known = result.report().warnings;
    for (const std::string& warning : made.report().warnings) {
      if (std::find(known.begin(), known.end(), warning) == known.end()) {
        opening->warnings.push_back(warning);
      }
    }
    return opening;
  });
}

craze_job* craze_job_with_post(craze_job* job, const char* text, craze_error* error) {
  return guarded(error, [&] {
    const Result& result = result_of(job);
    require(text, "text");
    const PostParameters post = changed_post(*job, text);
    Result made = made_with(*job, result, post);
    auto changed = std::make_unique<craze_job>(*job);
    changed->recipe.post = post;
    changed->post = post;
    changed->result = std::move(made);
    return changed.release();
  });
}

void craze_opening_free(craze_opening* opening) {
  delete opening;
}

craze_mesh* craze_opening_mesh(const craze_opening* opening, craze_error* error) {
  return guarded(error, [&] {
    require(opening, "opening");
    return new_mesh(*opening);
  });
}

const char* craze_opening_warning(const craze_opening* opening, int64_t i) {
  return opening ? text_at(opening->warnings, i) : nullptr;
}

int64_t craze_opening_vertex_count(const craze_opening* opening) {
  return opening ? static_cast<int64_t>(opening->opening->mesh().positions.size()) : 0;
}

craze_status craze_opening_positions_at(craze_opening* opening, double time, double* positions,
                                        craze_error* error) {
  return guard(error, [&] {
    require(opening, "opening");
    require(positions, "positions");
    if (!(time >= 0 && time <= 1)) wrong_argument("wrong time", "time", "must be in [0, 1]");
    if (!opening->clip) opening->clip.emplace(*opening->opening);
    for (const Vec3& p : opening->clip->positions_at(time)) {
      *positions++ = p.x();
      *positions++ = p.y();
      *positions++ = p.z();
    }
  });
}
