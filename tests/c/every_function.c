/* A C99 program that calls every function of craze.h, the way it should be and the way it should
 * not. It frees all it gets: a memory checker finds nothing to say. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "craze/craze.h"
#include "expect.h"
#include "mesh_masks.h"
#include "openings.h"

int failures = 0;

static const double square[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
static const int32_t halves[6] = {0, 1, 2, 0, 2, 3};

static int count_calls(void* user, const char* phase, double fraction, int64_t cracks,
                       double load) {
  ++*(int*)user;
  EXPECT(phase != NULL && strlen(phase) > 0);
  EXPECT(fraction <= 1);
  EXPECT(cracks >= 0);
  EXPECT(load >= 0);
  return 0;
}

static void count_sentences(void* user, const char* sentence) {
  ++*(int*)user;
  EXPECT(strlen(sentence) > 0);
}

static int stop_at_once(void* user, const char* phase, double fraction, int64_t cracks,
                        double load) {
  (void)user, (void)phase, (void)fraction, (void)cracks, (void)load;
  return 1;
}

typedef struct pieces_heard {
  int64_t calls, next;
  double length;
} pieces_heard;

/* Pieces come in their order, without gaps, and lie on the plate. */
static void hear_pieces(void* user, int64_t first, const double* pieces, int64_t count) {
  pieces_heard* heard = user;
  int64_t i;
  ++heard->calls;
  EXPECT(first == heard->next);
  EXPECT(count > 0);
  heard->next = first + count;
  for (i = 0; i < 6 * count; ++i) EXPECT(fabs(pieces[i]) <= 0.5);
  for (i = 0; i < count; ++i) {
    const double* p = pieces + 6 * i;
    heard->length += hypot(p[3] - p[0], p[4] - p[1]);
  }
}

static void a_text(char* text, const char* holds) {
  EXPECT(text != NULL);
  if (text) EXPECT(strstr(text, holds) != NULL);
  craze_text_free(text);
}

static void the_catalogue_is_there(void) {
  EXPECT(craze_interface() == CRAZE_INTERFACE);
  EXPECT(strchr(craze_version(), '.') != NULL);
  a_text(craze_presets(NULL), "\"glaze\"");
  a_text(craze_parameters(NULL), "layer.spacing");
  craze_text_free(NULL);
}

static void a_mesh_keeps_what_it_is_given(const char* folder) {
  const double uv[12] = {0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1},
               up[18] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const double color[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, weight[4] = {0, 1, 2, 3};
  const double polygons[2] = {0, 0}, half[2] = {0.5, 0};
  const int32_t materials[2] = {-1, 1}, wrong[3] = {0, 1, 4}, beyond[2] = {0, 2};
  const char* const names[2] = {"clay", "glass"};
  char path[512];
  craze_error error;
  craze_array array;
  int64_t i;
  int told = 0;
  craze_mesh* mesh = craze_mesh_new(square, 4, halves, 2, &error);
  EXPECT(mesh != NULL && error.status == CRAZE_OK && error.message[0] == '\0');
  EXPECT_ERROR(craze_mesh_array(mesh, "uv", &array, e), CRAZE_USAGE); /* it has none yet */
  EXPECT(craze_mesh_set(mesh, "uv", uv, 6, 2, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "normals", up, 6, 3, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "vertex:color", color, 4, 3, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "vertex:weight", weight, 4, 1, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "vertex:weight", weight, 4, 1, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "face:sort", half, 2, 1, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "source_faces", polygons, 2, 1, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set_materials(mesh, materials, names, 2, NULL) == CRAZE_OK);

  EXPECT(craze_mesh_array(mesh, "vertices", &array, NULL) == CRAZE_OK);
  EXPECT(array.rows == 4 && array.columns == 3 && array.type == CRAZE_FLOAT64);
  EXPECT(memcmp(array.data, square, sizeof square) == 0);
  EXPECT(craze_mesh_array(mesh, "faces", &array, NULL) == CRAZE_OK);
  EXPECT(array.rows == 2 && array.columns == 3 && array.type == CRAZE_INT32);
  EXPECT(memcmp(array.data, halves, sizeof halves) == 0);
  EXPECT(craze_mesh_array(mesh, "colors", &array, NULL) == CRAZE_OK);
  EXPECT(array.rows == 4 && array.columns == 4 && array.type == CRAZE_FLOAT32);
  EXPECT(((const float*)array.data)[3] == 1);
  EXPECT(craze_mesh_array(mesh, "materials", &array, NULL) == CRAZE_OK);
  EXPECT(memcmp(array.data, materials, sizeof materials) == 0);
  for (i = 0; craze_mesh_array_name(mesh, i); ++i) {
    EXPECT(craze_mesh_array(mesh, craze_mesh_array_name(mesh, i), &array, NULL) == CRAZE_OK);
    EXPECT(array.rows > 0 && array.data != NULL);
  }
  EXPECT(i == 9);
  EXPECT(strcmp(craze_mesh_material_name(mesh, 1), "glass") == 0);
  EXPECT(craze_mesh_material_name(mesh, 2) == NULL);
  EXPECT(craze_mesh_array_name(mesh, -1) == NULL);
  EXPECT(craze_mesh_warning(mesh, 0) == NULL);

  EXPECT_ERROR(craze_mesh_new(square, 4, wrong, 1, e), CRAZE_INPUT);
  EXPECT_ERROR(craze_mesh_new(NULL, 4, halves, 2, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_new(square, 4, NULL, 2, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_new(square, -1, halves, 2, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_new(square, 4, halves, INT64_MAX, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(mesh, "uv", uv, 4, 2, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(mesh, "uv", uv, 6, 3, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(mesh, "vertex:", weight, 4, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(mesh, "vertex:weight", weight, 4, 0, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(mesh, "vertex:weight", NULL, 4, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(mesh, "volume", weight, 4, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(mesh, NULL, weight, 4, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(NULL, "uv", uv, 6, 2, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set(mesh, "source_faces", half, 2, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set_materials(mesh, beyond, names, 2, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set_materials(mesh, NULL, names, 2, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_set_materials(mesh, materials, NULL, 2, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_array(mesh, "vertex:none", &array, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_array(mesh, "none", &array, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_array(mesh, "faces", NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_fragment_count(mesh, e), CRAZE_REQUEST);
  EXPECT(craze_mesh_fragment_count(mesh, NULL) == -1);
  EXPECT_ERROR(craze_mesh_fragments(mesh, NULL, 0, e), CRAZE_REQUEST);

  snprintf(path, sizeof path, "%s/square.ply", folder);
  i = 0;
  EXPECT(craze_mesh_write(mesh, path, NULL, NULL, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_write_telling(mesh, path, count_sentences, NULL, &told, NULL) == CRAZE_OK);
  EXPECT(told == 0);
  EXPECT(craze_mesh_keep_origin(mesh, mesh) == 0); /* arrays have none */
  EXPECT(craze_mesh_keep_origin(mesh, NULL) == 0);
  EXPECT_ERROR(craze_mesh_write(mesh, path, stop_at_once, NULL, e), CRAZE_CANCELLED);
  EXPECT_ERROR(craze_mesh_write(mesh, "nowhere/at/all.ply", NULL, NULL, e), CRAZE_OUTPUT);
  EXPECT_ERROR(craze_mesh_write(mesh, "square.doc", NULL, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_write(mesh, NULL, NULL, NULL, e), CRAZE_USAGE);
  craze_mesh_free(mesh);
  mesh = craze_mesh_read(path, NULL, NULL, &error);
  EXPECT(mesh != NULL);
  EXPECT(craze_mesh_array(mesh, "vertex:weight", &array, NULL) == CRAZE_OK);
  EXPECT(memcmp(array.data, weight, sizeof weight) == 0);
  EXPECT(craze_mesh_keep_origin(mesh, mesh) == 1);
  craze_mesh_free(mesh);
  remove(path);
  EXPECT_ERROR(craze_mesh_read(path, NULL, NULL, e), CRAZE_INPUT);
  EXPECT_ERROR(craze_mesh_read(NULL, NULL, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_shape("plait", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_shape(NULL, e), CRAZE_USAGE);
  craze_mesh_free(NULL);
}

static void a_job_is_told_what_is_wrong(craze_job* job) {
  const float grey[2] = {0, 1}, bright[1] = {255};
  EXPECT_ERROR(craze_job_run(job, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_run(NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_cut_mesh(job, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_lines(job, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_report(job, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_summary(job, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_statistics(job, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_open(job, 1, 0, 0, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_recipe(NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_recipe_toml(NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_mesh(job, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_preset(job, "mudd", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_preset(job, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_recipe(job, "[layer", "mine", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_recipe(job, NULL, "mine", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set(job, "layer.spacing", "-1", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set(job, "layer.spacin", "1", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set(job, NULL, "1", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set(job, "seed", NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_threads(job, -1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_max_cracks(NULL, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_texture(job, "t", grey, CRAZE_FLOAT32, 0, 1, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_texture(job, "t", grey, CRAZE_FLOAT32, 2, 1, 5, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_texture(job, "t", grey, CRAZE_INT32, 2, 1, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_texture(job, "t", bright, CRAZE_FLOAT32, 1, 1, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_set_texture(job, "t", NULL, CRAZE_FLOAT32, 2, 1, 1, e), CRAZE_USAGE);
  EXPECT(craze_job_set_texture(job, "t", grey, CRAZE_FLOAT32, 2, 1, 1, NULL) == CRAZE_OK);
  craze_job_set_progress(NULL, NULL, NULL);
  craze_job_free(NULL);
}

static void the_lines_say_where_the_cracks_are(craze_job* job) {
  craze_array points, edges, time;
  craze_lines* lines = craze_job_lines(job, NULL);
  EXPECT(craze_lines_array(lines, "points", &points, NULL) == CRAZE_OK);
  EXPECT(craze_lines_array(lines, "edges", &edges, NULL) == CRAZE_OK);
  EXPECT(craze_lines_array(lines, "edge:time", &time, NULL) == CRAZE_OK);
  EXPECT(edges.rows > 0 && edges.rows == time.rows && points.columns == 3);
  EXPECT_ERROR(craze_lines_array(lines, "edge:none", &time, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_lines_array(lines, "none", &time, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_lines_array(NULL, "points", &time, e), CRAZE_USAGE);
  a_text(craze_statistics(points.data, points.rows, edges.data, edges.rows, time.data, 0, NULL),
         "junctions");
  EXPECT_ERROR(craze_statistics(points.data, 0, edges.data, edges.rows, NULL, 0, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_statistics(NULL, 1, edges.data, 0, NULL, 0, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_statistics(points.data, points.rows, edges.data, edges.rows, NULL, -1, e),
               CRAZE_USAGE);
  EXPECT_ERROR(craze_lines_write(lines, "/nowhere/lines.svg", e), CRAZE_OUTPUT);
  EXPECT_ERROR(craze_lines_write(lines, NULL, e), CRAZE_USAGE);
  craze_lines_free(lines);
  craze_lines_free(NULL);
}

static void maps_are_baked(craze_job* job) {
  craze_array map;
  craze_maps* maps = craze_job_bake(job, 32, "mask,normal", 1, 0, 0, NULL);
  EXPECT(maps != NULL);
  EXPECT(strcmp(craze_maps_name(maps, 0), "mask") == 0);
  EXPECT(strcmp(craze_maps_name(maps, 1), "normal") == 0);
  EXPECT(craze_maps_name(maps, 2) == NULL);
  EXPECT(craze_maps_name(NULL, 0) == NULL);
  EXPECT(craze_maps_array(maps, 1, &map, NULL) == CRAZE_OK);
  EXPECT(map.rows == 32 * 32 && map.columns == 3 && map.type == CRAZE_FLOAT32);
  EXPECT(strstr(craze_maps_description(maps), "\"file\": \"normal.exr\"") != NULL);
  EXPECT(craze_maps_description(NULL) == NULL);
  EXPECT(craze_maps_warning(maps, 0) == NULL);
  EXPECT(craze_maps_warning(NULL, 0) == NULL);
  EXPECT_ERROR(craze_maps_array(maps, 2, &map, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_maps_array(maps, 0, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_maps_array(NULL, 0, &map, e), CRAZE_USAGE);
  double low[3];
  double high[3];
  EXPECT(craze_maps_range(maps, 1, low, high, NULL) == CRAZE_OK);
  EXPECT(low[2] == 0 && high[2] == 1);
  EXPECT_ERROR(craze_maps_range(maps, 2, low, high, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_maps_range(maps, 0, NULL, high, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_maps_range(maps, 0, low, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_maps_range(NULL, 0, low, high, e), CRAZE_USAGE);
  craze_maps_free(maps);
  craze_maps_free(NULL);
  EXPECT_ERROR(craze_job_bake(job, 32, "mask,", 1, 0, 0, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_bake(job, 0, NULL, 1, 0, 0, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_bake(job, 32, NULL, 1, NAN, 0, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_bake(NULL, 32, NULL, 1, 0, 0, e), CRAZE_USAGE);
}

static void a_tile_is_baked(void) {
  int calls = 0;
  craze_array map;
  craze_maps* maps;
  craze_job* job = craze_job_new();
  EXPECT(craze_job_set_preset(job, "mud", NULL) == CRAZE_OK);
  craze_job_set_progress(job, count_calls, &calls);
  maps = craze_job_texture(job, "40cm", 16, "base_color,mask", 1, NULL);
  EXPECT(maps != NULL && calls > 0);
  EXPECT(strcmp(craze_maps_name(maps, 0), "base_color") == 0);
  EXPECT(strcmp(craze_maps_name(maps, 1), "mask") == 0);
  EXPECT(craze_maps_array(maps, 0, &map, NULL) == CRAZE_OK);
  EXPECT(map.rows == 16 * 16 && map.columns == 3);
  EXPECT(strstr(craze_maps_description(maps), "\"side\": 0.4,") != NULL);
  craze_maps_free(maps);
  EXPECT_ERROR(craze_job_texture(job, "0", 16, NULL, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_texture(job, "3%", 16, NULL, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_texture(job, NULL, 16, NULL, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_texture(job, "1", 0, NULL, 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_texture(job, "1", 16, "position", 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_texture(job, "1", 16, "stones", 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_texture(NULL, "1", 16, NULL, 1, e), CRAZE_USAGE);
  EXPECT(craze_job_set(job, "layer.spacing", "0.5", NULL) == CRAZE_OK);
  EXPECT_ERROR(craze_job_texture(job, "1", 16, NULL, 1, e), CRAZE_REQUEST);
  craze_job_set_progress(job, stop_at_once, NULL);
  EXPECT(craze_job_set(job, "layer.spacing", "0", NULL) == CRAZE_OK);
  EXPECT_ERROR(craze_job_texture(job, "1", 16, NULL, 1, e), CRAZE_CANCELLED);
  craze_job_free(job);
}

static void fragments_are_meshes(const craze_mesh* cut) {
  craze_error error;
  int64_t count = craze_mesh_fragment_count(cut, &error), i;
  craze_mesh** pieces = calloc((size_t)count, sizeof *pieces);
  EXPECT(count >= 1 && pieces != NULL);
  EXPECT_ERROR(craze_mesh_fragments(cut, pieces, count + 1, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_fragments(cut, NULL, count, e), CRAZE_USAGE);
  EXPECT(craze_mesh_fragments(cut, pieces, count, NULL) == CRAZE_OK);
  for (i = 0; i < count; ++i) craze_mesh_free(pieces[i]);
  free(pieces);
}

static void fields_are_those_of_the_state(craze_job* job) {
  craze_array s1, s2, sxx, syy, v, r, faces;
  int64_t f;
  craze_mesh* fields = craze_job_fields(job, NULL);
  EXPECT(craze_mesh_array(fields, "faces", &faces, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_array(fields, "face:s1", &s1, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_array(fields, "face:s2", &s2, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_array(fields, "face:s_xx", &sxx, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_array(fields, "face:s_yy", &syy, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_array(fields, "vertex:v", &v, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_array(fields, "vertex:r", &r, NULL) == CRAZE_OK);
  EXPECT(s1.rows == faces.rows && v.rows == r.rows);
  for (f = 0; f < s1.rows; ++f) {
    const double a = ((const double*)s1.data)[f], b = ((const double*)s2.data)[f];
    const double trace = ((const double*)sxx.data)[f] + ((const double*)syy.data)[f];
    EXPECT(a >= b);
    EXPECT(fabs(a + b - trace) <= 1e-9 * (1 + fabs(trace)));
  }
  craze_mesh_free(fields);
}

static void a_mesh_is_shaded(const craze_mesh* cut) {
  craze_array faces;
  double* normals;
  int64_t i;
  craze_error error;
  EXPECT(craze_mesh_array(cut, "faces", &faces, NULL) == CRAZE_OK);
  normals = malloc((size_t)(9 * faces.rows) * sizeof *normals);
  EXPECT_ERROR(craze_mesh_shading(cut, -1, normals, e), CRAZE_USAGE);
  EXPECT(craze_mesh_shading(cut, 75, normals, &error) == CRAZE_OK);
  for (i = 0; i < 3 * faces.rows; ++i) EXPECT(fabs(fabs(normals[3 * i + 2]) - 1) < 1e-9);
  free(normals);
}

static void a_run_gives_what_it_should(void) {
  craze_error error;
  craze_array before, after;
  int calls = 0;
  pieces_heard heard = {0, 0, 0};
  craze_mesh* cut;
  craze_mesh* plate = craze_mesh_shape("plate?n=6&jitter=0.3", &error);
  craze_job* job = craze_job_new();
  a_job_is_told_what_is_wrong(job);
  EXPECT(craze_job_set_mesh(job, plate, NULL) == CRAZE_OK);
  /* The job keeps the mesh that it was given. */
  EXPECT(craze_mesh_array(plate, "vertices", &before, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(plate, "vertex:x", before.data, before.rows, 1, NULL) == CRAZE_OK);
  craze_mesh_free(plate);
  EXPECT(craze_job_set_recipe(job, "seed = 3\n", NULL, NULL) == CRAZE_OK);
  EXPECT(craze_job_set_preset(job, "mud", NULL) == CRAZE_OK);
  EXPECT(craze_job_set(job, "seed", "7", NULL) == CRAZE_OK);
  EXPECT(craze_job_set(job, "mesh.edge", "\"keep\"", NULL) == CRAZE_OK);
  EXPECT(craze_job_set(job, "post.relative_roughness", "0", NULL) == CRAZE_OK);
  a_text(craze_job_recipe(job, NULL), "\"seed\":7");
  a_text(craze_job_recipe_toml(job, NULL), "seed = 7");
  EXPECT(craze_job_set_threads(job, 1, NULL) == CRAZE_OK);
  EXPECT(craze_job_set_max_cracks(job, 4, NULL) == CRAZE_OK);
  craze_job_set_progress(job, stop_at_once, NULL);
  EXPECT_ERROR(craze_job_run(job, e), CRAZE_CANCELLED);
  EXPECT_ERROR(craze_job_report(job, e), CRAZE_USAGE);
  craze_job_set_progress(job, count_calls, &calls);
  craze_job_set_opened(NULL, NULL, NULL);
  craze_job_set_opened(job, hear_pieces, &heard);
  EXPECT(craze_job_run(job, NULL) == CRAZE_OK);
  EXPECT(calls > 0);
  craze_job_set_opened(job, NULL, NULL);
  EXPECT(heard.calls > 0 && heard.next >= 4 && heard.length > 0);
  fields_are_those_of_the_state(job);
  a_text(craze_job_report(job, NULL), "\"statistics\"");
  a_text(craze_job_summary(job, NULL), "\"stop_reason\"");
  a_text(craze_job_statistics(job, NULL), "{");
  the_lines_say_where_the_cracks_are(job);
  maps_are_baked(job);
  cracks_open_and_grow(job);
  cut = craze_job_cut_mesh(job, NULL);
  a_mesh_is_shaded(cut);
  EXPECT(craze_mesh_array(cut, "vertex:crack_time", &before, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_array(cut, "face:fragment", &after, NULL) == CRAZE_OK);
  craze_job_set_progress(job, stop_at_once, NULL);
  EXPECT_ERROR(craze_job_run(job, e), CRAZE_CANCELLED);
  EXPECT_ERROR(craze_job_cut_mesh(job, e), CRAZE_CANCELLED);
  EXPECT_ERROR(craze_job_lines(job, e), CRAZE_CANCELLED);
  EXPECT_ERROR(craze_job_report(job, e), CRAZE_CANCELLED);
  EXPECT_ERROR(craze_job_statistics(job, e), CRAZE_CANCELLED);
  craze_job_set_progress(job, NULL, NULL);
  a_text(craze_job_summary(job, NULL), "\"stop_reason\""); /* that of the run before */
  craze_job_free(job);
  fragments_are_meshes(cut);
  craze_mesh_free(cut);
}

int main(int count, char** arguments) {
  the_catalogue_is_there();
  a_mesh_keeps_what_it_is_given(count > 1 ? arguments[1] : ".");
  a_tile_is_baked();
  a_run_gives_what_it_should();
  what_may_be_a_mask(count > 1 ? arguments[1] : ".");
  if (failures == 0) puts("every function of craze.h does what it says");
  return failures == 0 ? 0 : 1;
}
