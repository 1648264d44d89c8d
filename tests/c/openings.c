#include "openings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "expect.h"

static void pieces_are_solids(craze_job* job) {
  double volume = 0, centre[3], inertia[9];
  craze_mesh *mesh, *hull;
  craze_opening* opening =
      craze_job_open_post(job, "[post]\ngap = 0\nthickness = 0.01\ncore = true", NULL);
  EXPECT(opening != NULL);
  mesh = craze_opening_mesh(opening, NULL);
  EXPECT(craze_mesh_mass(mesh, &volume, centre, inertia, NULL) == CRAZE_OK);
  EXPECT(volume > 0 && inertia[0] > 0 && inertia[1] == inertia[3]);
  EXPECT(craze_mesh_mass(mesh, &volume, NULL, NULL, NULL) == CRAZE_OK);
  hull = craze_mesh_convex_hull(mesh, NULL);
  EXPECT(hull != NULL);
  EXPECT_ERROR(craze_mesh_mass(mesh, NULL, NULL, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_mass(NULL, &volume, NULL, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_convex_hull(NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_open_post(job, "[post]\nthickness = -1", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_open_post(job, "[post]\nthickness = inf", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_open_post(NULL, "[post]\nthickness = 1", e), CRAZE_USAGE);
  craze_mesh_free(hull);
  craze_mesh_free(mesh);
  craze_opening_free(opening);
}

static void cracks_are_made_rough_without_a_run(craze_job* job) {
  craze_opening* own = craze_job_open_post(job, "", NULL);
  craze_opening* rough = craze_job_open_post(job, "[post]\nroughness = 0.01\nwall = 0", NULL);
  EXPECT(own != NULL && rough != NULL);
  EXPECT(craze_opening_vertex_count(rough) > craze_opening_vertex_count(own));
  EXPECT_ERROR(craze_job_open_post(job, "[post]\ngap = -1", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_open_post(job, "[layer]\nspacing = 0.3", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_open_post(job, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_open_post(NULL, "", e), CRAZE_USAGE);
  craze_opening_free(own);
  craze_opening_free(rough);
}

static int64_t line_points(const craze_job* job) {
  craze_array points;
  craze_lines* lines = craze_job_lines(job, NULL);
  EXPECT(craze_lines_array(lines, "points", &points, NULL) == CRAZE_OK);
  craze_lines_free(lines);
  return points.rows;
}

static void a_finished_job_gets_another_post(craze_job* job) {
  craze_job* rough = craze_job_with_post(job, "[post]\nroughness = 0.01", NULL);
  EXPECT(rough != NULL);
  EXPECT(line_points(rough) > line_points(job));
  craze_opening* own = craze_job_open_post(rough, "", NULL);
  craze_opening* same = craze_job_open_post(job, "[post]\nroughness = 0.01", NULL);
  EXPECT(craze_opening_vertex_count(own) == craze_opening_vertex_count(same));
  craze_opening_free(own);
  craze_opening_free(same);
  EXPECT_ERROR(craze_job_with_post(job, "[layer]\nspacing = 0.3", e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_with_post(job, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_with_post(NULL, "", e), CRAZE_USAGE);
  craze_job_free(rough);
}

void cracks_open_and_grow(craze_job* job) {
  craze_array vertices;
  double* positions;
  int64_t count;
  craze_mesh* mesh;
  craze_opening* opening = craze_job_open(job, 0.1, 0.02, 0.1, NULL);
  EXPECT(opening != NULL);
  mesh = craze_opening_mesh(opening, NULL);
  count = craze_opening_vertex_count(opening);
  EXPECT(craze_mesh_array(mesh, "vertices", &vertices, NULL) == CRAZE_OK);
  EXPECT(vertices.rows == count && count > 0);
  positions = malloc((size_t)count * 3 * sizeof *positions);
  EXPECT(positions != NULL);
  EXPECT(craze_opening_positions_at(opening, 1, positions, NULL) == CRAZE_OK);
  EXPECT(memcmp(positions, vertices.data, (size_t)count * 3 * sizeof *positions) == 0);
  EXPECT_ERROR(craze_opening_positions_at(opening, 2, positions, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_opening_positions_at(opening, NAN, positions, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_opening_positions_at(opening, 0, NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_opening_positions_at(NULL, 0, positions, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_opening_mesh(NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_job_open(job, NAN, 0, 0, e), CRAZE_REQUEST);
  pieces_are_solids(job);
  cracks_are_made_rough_without_a_run(job);
  a_finished_job_gets_another_post(job);
  EXPECT(craze_opening_vertex_count(NULL) == 0);
  EXPECT(craze_opening_warning(opening, 1 << 20) == NULL);
  EXPECT(craze_opening_warning(NULL, 0) == NULL);
  craze_opening_free(opening);
  craze_opening_free(NULL);
  /* The mesh outlives what it was made of, and is the caller's to change. */
  EXPECT(craze_mesh_set(mesh, "vertex:height", positions, count, 1, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_array(mesh, "vertices", &vertices, NULL) == CRAZE_OK);
  EXPECT(vertices.rows == count);
  craze_mesh_free(mesh);
  free(positions);
}
