/* Cracks a cup through the installed header: 0 when there are cracks. */
#include <craze/craze.h>
#include <stdio.h>

int main(void) {
  craze_error error;
  craze_mesh* cup = craze_mesh_shape("cup?n=24", &error);
  craze_job* job = craze_job_new();
  craze_mesh* cracked = NULL;
  if (craze_job_set_mesh(job, cup, &error) == CRAZE_OK &&
      craze_job_set_preset(job, "glaze", &error) == CRAZE_OK &&
      craze_job_set_max_cracks(job, 5, &error) == CRAZE_OK &&
      craze_job_run(job, &error) == CRAZE_OK) {
    cracked = craze_job_cut_mesh(job, &error);
  }
  if (!cracked || craze_mesh_fragment_count(cracked, &error) < 1 ||
      craze_mesh_write(cracked, "cup.ply", NULL, NULL, &error) != CRAZE_OK) {
    fprintf(stderr, "consumer: %s\n", error.message);
    return 1;
  }
  craze_mesh_free(cracked);
  craze_job_free(job);
  craze_mesh_free(cup);
  return 0;
}
