#include "mesh_masks.h"

#include <math.h>
#include <stdlib.h>

#include "craze/craze.h"
#include "expect.h"

/* A square of two triangles with UVs and a material, whose texture is in the file: what stands for
 * a PNG there is of no matter to whoever only hands it on. */
static const char* const gltf =
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
    "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,"
    "\"TEXCOORD_0\":1},\"indices\":2,\"material\":0}]}],\"materials\":[{\"name\":\"skin\","
    "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],\"textures\":[{\"source\":"
    "0}],\"images\":[{\"uri\":\"data:image/png;base64,iVBORw0KGgo=\"}],\"buffers\":[{"
    "\"byteLength\":92,\"uri\":\"data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAA"
    "AAAAAAAAAAAAAIA/AAAAAAAAgD8AAIA/AAAAAAAAgD8AAAEAAgAAAAIAAwA=\"}],"
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,"
    "\"byteLength\":32},{\"buffer\":0,\"byteOffset\":80,\"byteLength\":12}],\"accessors\":[{"
    "\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"min\":[0,0,0],"
    "\"max\":[1,1,0]},{\"bufferView\":1,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},{"
    "\"bufferView\":2,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}]}";

static void values_of_attributes_and_colors(void) {
  craze_error error;
  const double ramp[4] = {0, 0.25, 0.5, 1}, beyond[4] = {0, 1, 2, 3};
  const double red[12] = {1, 0, 0, 0.5, 0, 0, 0, 0, 0, 0.25, 0, 0};
  const double square[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const int32_t halves[6] = {0, 1, 2, 0, 2, 3};
  double values[4] = {9, 9, 9, 9};
  craze_array file;
  char* names;
  craze_mesh* mesh = craze_mesh_new(square, 4, halves, 2, &error);
  EXPECT(craze_mesh_set(mesh, "vertex:ramp", ramp, 4, 1, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "vertex:height", beyond, 4, 1, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "vertex:pair", red, 4, 2, NULL) == CRAZE_OK);
  EXPECT(craze_mesh_set(mesh, "vertex:color", red, 4, 3, NULL) == CRAZE_OK);
  names = craze_mesh_masks(mesh, NULL);
  EXPECT(names && strcmp(names,
                         "[\"ramp\",\"color\",\"color_r\",\"color_g\",\"color_b\","
                         "\"color_a\"]") == 0);
  craze_text_free(names);
  EXPECT(craze_mesh_mask(mesh, "color_r", values, NULL) == CRAZE_OK);
  EXPECT(values[0] == 1 && values[1] == 0.5 && values[2] == 0 && values[3] == 0.25);
  EXPECT(craze_mesh_mask(mesh, "ramp", values, NULL) == CRAZE_OK);
  EXPECT(memcmp(values, ramp, sizeof values) == 0);
  EXPECT_ERROR(craze_mesh_mask(mesh, "height", values, e), CRAZE_REQUEST);
  EXPECT_ERROR(craze_mesh_mask(mesh, "pair", values, e), CRAZE_REQUEST);
  EXPECT_ERROR(craze_mesh_mask(mesh, "nothing", values, e), CRAZE_REQUEST);
  EXPECT_ERROR(craze_mesh_mask(mesh, NULL, values, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_masks(NULL, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_texture(mesh, 0, &file, e), CRAZE_USAGE);
  craze_mesh_free(mesh);
}

void what_may_be_a_mask(const char* folder) {
  craze_error error;
  const float halves[2] = {0, 1}; /* black at the left, white at the right */
  const float wrong[2] = {0, 2};
  double values[4] = {9, 9, 9, 9};
  craze_array file;
  craze_mesh* mesh;
  FILE* written;
  char path[4096];
  values_of_attributes_and_colors();
  snprintf(path, sizeof path, "%s/textured.gltf", folder);
  written = fopen(path, "wb");
  EXPECT(written && fputs(gltf, written) >= 0);
  if (written) fclose(written);
  mesh = craze_mesh_read(path, NULL, NULL, &error);
  EXPECT(mesh != NULL);
  if (!mesh) return;
  EXPECT(craze_mesh_texture(mesh, 0, &file, NULL) == CRAZE_OK);
  EXPECT(file.type == CRAZE_UINT8 && file.columns == 1 && file.rows == 8);
  EXPECT(file.rows == 8 && memcmp(file.data, "\x89PNG\r\n\x1a\n", 8) == 0);
  EXPECT_ERROR(craze_mesh_texture(mesh, 1, &file, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_texture(mesh, -1, &file, e), CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_texture(mesh, 0, NULL, e), CRAZE_USAGE);
  /* u is 0 at vertices 0 and 3: halfway between the last pixel and the first. */
  EXPECT(craze_mesh_mask_picture(mesh, 0, halves, CRAZE_FLOAT32, 2, 1, 1, values, NULL) ==
         CRAZE_OK);
  EXPECT(fabs(values[0] - 0.5) < 1e-9 && fabs(values[3] - 0.5) < 1e-9);
  EXPECT(fabs(values[1] - 0.5) < 1e-9 && fabs(values[2] - 0.5) < 1e-9);
  EXPECT_ERROR(craze_mesh_mask_picture(mesh, 0, wrong, CRAZE_FLOAT32, 2, 1, 1, values, e),
               CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_mask_picture(mesh, 0, NULL, CRAZE_FLOAT32, 2, 1, 1, values, e),
               CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_mask_picture(mesh, 0, halves, CRAZE_FLOAT32, 2, 1, 5, values, e),
               CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_mask_picture(mesh, 0, halves, CRAZE_FLOAT32, 0, 1, 1, values, e),
               CRAZE_USAGE);
  EXPECT_ERROR(craze_mesh_mask_picture(mesh, 3, halves, CRAZE_FLOAT32, 2, 1, 1, values, e),
               CRAZE_USAGE);
  craze_mesh_free(mesh);
}
