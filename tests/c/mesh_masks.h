/* Masks of a mesh: attributes, colours and a texture in its file. */
#ifndef CRAZE_TESTS_C_MESH_MASKS_H
#define CRAZE_TESTS_C_MESH_MASKS_H

void what_may_be_a_mask(const char* folder);

#endif
