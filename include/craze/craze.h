/* craze: surface crack patterns on triangle meshes, for any language that can call C (C99).
 *
 *   craze_error error;
 *   craze_mesh *plate = craze_mesh_shape("plate?n=60&jitter=0.3", &error);
 *   craze_job *job = craze_job_new();
 *   craze_job_set_mesh(job, plate, &error);
 *   craze_job_set_preset(job, "mud", &error);
 *   if (craze_job_run(job, &error) == CRAZE_OK) {
 *     craze_mesh *cracked = craze_job_cut_mesh(job, &error);
 *     craze_mesh_write(cracked, "mud.ply", NULL, NULL, &error);
 *     craze_mesh_free(cracked);
 *   }
 *   craze_job_free(job);
 *   craze_mesh_free(plate);
 *
 * Handles are opaque and owned by the caller: each *_new, *_shape, *_read and product is freed by
 * its *_free, which takes NULL. A product keeps what it needs; it may outlive the job.
 * Functions that can fail take a craze_error, which may be NULL, and return a status, or NULL
 * instead of a handle. No exception crosses, nothing is printed, nothing is global: different
 * handles may be used by different threads at a time, one handle by one thread at a time.
 * Texts are UTF-8. Lengths are in the unit of the mesh. */
#ifndef CRAZE_CRAZE_H
#define CRAZE_CRAZE_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define CRAZE_API
#else
#define CRAZE_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The interface that this header describes. It grows by new functions; a change of the old ones
 * changes the number. */
#define CRAZE_INTERFACE 1

typedef enum craze_status {
  CRAZE_OK = 0,
  CRAZE_INPUT = 1,     /* a mesh or file that cannot be read or is not what it says */
  CRAZE_USAGE = 2,     /* a wrong key, value, name or argument */
  CRAZE_REQUEST = 3,   /* something impossible was asked of a good input */
  CRAZE_OUTPUT = 4,    /* a file that cannot be written */
  CRAZE_CANCELLED = 5, /* a callback asked to stop */
  CRAZE_MEMORY = 6,    /* not enough of it */
  CRAZE_INTERNAL = 7   /* a fault of craze itself */
} craze_status;

/* What went wrong, in one line: WHAT (WHERE): WHY. */
typedef struct craze_error {
  craze_status status;
  char message[1024];
} craze_error;

typedef enum craze_type {
  CRAZE_FLOAT64 = 0,
  CRAZE_FLOAT32 = 1,
  CRAZE_INT32 = 2,
  CRAZE_UINT8 = 3, /* of pictures alone, as the next */
  CRAZE_UINT16 = 4
} craze_type;

/* Numbers in rows, one after the other, owned by the handle they were got from: valid until it is
 * freed. */
typedef struct craze_array {
  const void* data;
  int64_t rows;
  int32_t columns;
  craze_type type;
} craze_array;

/* Called from the thread that called the function that takes it, about twenty times a second and at
 * the start and the end of each phase. `fraction` goes to 1 in each, or is below 0 where no end is
 * known. Anything but 0 stops: the call returns CRAZE_CANCELLED and changes nothing. It must not
 * use the handle that is at work. NULL where nobody asks. */
typedef int (*craze_progress)(void* user, const char* phase, double fraction, int64_t cracks,
                              double load);

typedef struct craze_mesh craze_mesh;
typedef struct craze_lines craze_lines;
typedef struct craze_job craze_job;
typedef struct craze_opening craze_opening;
typedef struct craze_maps craze_maps;

/* "0.2.0". */
CRAZE_API const char* craze_version(void);
/* CRAZE_INTERFACE of the library that is loaded. */
CRAZE_API int craze_interface(void);
/* Frees a text that a function below returned. */
CRAZE_API void craze_text_free(char* text);

/* JSON: {"glaze": {"description": ..., "recipe": {...}}, ...}. Free with craze_text_free. */
CRAZE_API char* craze_presets(craze_error* error);
/* JSON: a list of every key of a recipe with its type, default, range, choices, unit and help. Free
 * with craze_text_free. */
CRAZE_API char* craze_parameters(craze_error* error);

/* ---- Meshes ------------------------------------------------------------------------------ */

/* Copies `vertices` (n rows of x y z) and `faces` (m rows of three vertex indices from 0,
 * counter-clockwise seen from outside). CRAZE_INPUT where a face has a vertex that is not there. */
CRAZE_API craze_mesh* craze_mesh_new(const double* vertices, int64_t n, const int32_t* faces,
                                     int64_t m, craze_error* error);
/* Reads .obj .ply .stl .off .gltf .glb. */
CRAZE_API craze_mesh* craze_mesh_read(const char* path, craze_progress progress, void* user,
                                      craze_error* error);
/* What the file had that was left out, one sentence at a time; NULL beyond the last. */
CRAZE_API const char* craze_mesh_warning(const craze_mesh* mesh, int64_t i);
/* A built-in shape: "plate?n=60&jitter=0.3", "cup", "sphere?n=40", ... */
CRAZE_API craze_mesh* craze_mesh_shape(const char* specification, craze_error* error);
CRAZE_API void craze_mesh_free(craze_mesh* mesh);

/* Sets what is known per element; `rows` must fit. Names:
 *   "uv"           3 m rows of 2: corner i of face f at 3 f + i
 *   "normals"      3 m rows of 3, unit, likewise
 *   "source_faces" m rows of 1: what the cut mesh gives as "face:source_face"; the faces themselves
 *                  where it is not set
 *   "vertex:NAME"  n rows of any number of columns; "vertex:color" takes 4, linear RGBA in 0 ... 1,
 *                  or 3
 *   "face:NAME"    m rows of any number of columns */
CRAZE_API craze_status craze_mesh_set(craze_mesh* mesh, const char* name, const double* values,
                                      int64_t rows, int32_t columns, craze_error* error);

/* Sets the material of each face: m indices of the `count` names, -1: none. 0 names: no materials.
 */
CRAZE_API craze_status craze_mesh_set_materials(craze_mesh* mesh, const int32_t* materials,
                                                const char* const* names, int64_t count,
                                                craze_error* error);

/* Normals to look at it by, as GLB is written with: its own where it has some, else smooth ones but
 * for edges sharper than `crease` degrees (75 is usual); neither cracks nor gaps of a run leave a
 * mark. Writes 3 m rows of x y z, unit: corner i of face f at 3 f + i. */
CRAZE_API craze_status craze_mesh_shading(const craze_mesh* mesh, double crease, double* normals,
                                          craze_error* error);

/* A view of what is known: "vertices" (n, 3) float64, "faces" (m, 3) int32, "source_faces" (m, 1)
 * int32, "materials" (m, 1) int32, "colors" (n, 4) float32, and the names that craze_mesh_set
 * takes. CRAZE_USAGE where the mesh has no such thing. */
CRAZE_API craze_status craze_mesh_array(const craze_mesh* mesh, const char* name,
                                        craze_array* array, craze_error* error);
/* The name of the i-th array, NULL beyond the last; valid until the mesh is freed or set. */
CRAZE_API const char* craze_mesh_array_name(const craze_mesh* mesh, int64_t i);
/* The name of the i-th material ("materials" counts them from 0; -1: none), NULL beyond the
 * last. */
CRAZE_API const char* craze_mesh_material_name(const craze_mesh* mesh, int64_t i);

/* What may serve as a mask, to be looked at and painted over; [where] of a recipe (docs/where.md)
 * is what cracks by it.
 * JSON: the names of the scalars per vertex that are 0 ... 1, vertex colours as "color",
 * "color_r" ...: what where.attribute takes. Free with craze_text_free. */
CRAZE_API char* craze_mesh_masks(const craze_mesh* mesh, craze_error* error);
/* Writes the values of one of them, n rows of one. CRAZE_REQUEST for any other name. */
CRAZE_API craze_status craze_mesh_mask(const craze_mesh* mesh, const char* name, double* values,
                                       craze_error* error);
/* The texture of the i-th material's base colour, where it is in the file that the mesh was read
 * from: the bytes of a PNG or JPEG, rows of one CRAZE_UINT8; no rows: there is none. CRAZE_USAGE
 * where there is no such material. */
CRAZE_API craze_status craze_mesh_texture(const craze_mesh* mesh, int64_t material,
                                          craze_array* file, craze_error* error);
/* Writes, at the vertices of the i-th material's faces, the mean of a picture, as of
 * craze_job_set_texture, where that texture lies on them; the other ones of the n `values` stay.
 * CRAZE_REQUEST where the mesh has no UVs. */
CRAZE_API craze_status craze_mesh_mask_picture(const craze_mesh* mesh, int64_t material,
                                               const void* pixels, craze_type type, int64_t width,
                                               int64_t height, int32_t channels, double* values,
                                               craze_error* error);

/* Writes .ply .obj .stl .glb .usda: the whole file or none. A mesh that was read, and what a run
 * makes of it, is written with all that its file held besides (nodes, materials, textures ...), as
 * the command does it, where the format has a place for that; until an array that it had is set
 * anew. */
CRAZE_API craze_status craze_mesh_write(const craze_mesh* mesh, const char* path,
                                        craze_progress progress, void* user, craze_error* error);
/* The same, telling what the format has no place for, one sentence at a time, in the thread that
 * called. */
typedef void (*craze_told)(void* user, const char* sentence);
CRAZE_API craze_status craze_mesh_write_telling(const craze_mesh* mesh, const char* path,
                                                craze_told told, craze_progress progress,
                                                void* user, craze_error* error);
/* Gives `mesh` what the file of `from` held besides its arrays, if it has all that `from` has:
 * the same faces, UVs, normals, colours, materials and attributes; vertices may have moved, and
 * there may be more attributes. 1: done; 0: nothing changed. */
CRAZE_API int craze_mesh_keep_origin(craze_mesh* mesh, const craze_mesh* from);
/* The parts of a cracked mesh by its face attribute "fragment": how many there are (-1 where it has
 * none), and as many handles, to be freed one by one. */
CRAZE_API int64_t craze_mesh_fragment_count(const craze_mesh* mesh, craze_error* error);
CRAZE_API craze_status craze_mesh_fragments(const craze_mesh* mesh, craze_mesh** pieces,
                                            int64_t count, craze_error* error);

/* Of a closed mesh, density 1: its volume, and where they are not NULL its centre of mass (3) and
 * its inertia tensor about that (9, row by row). */
CRAZE_API craze_status craze_mesh_mass(const craze_mesh* mesh, double* volume, double* centre,
                                       double* inertia, craze_error* error);
/* The convex hull of its vertices, of at most 64 of them: a collider. It has no faces where all lie
 * in a plane. Free with craze_mesh_free. */
CRAZE_API craze_mesh* craze_mesh_convex_hull(const craze_mesh* mesh, craze_error* error);

/* ---- A run ------------------------------------------------------------------------------- */

CRAZE_API craze_job* craze_job_new(void);
CRAZE_API void craze_job_free(craze_job* job);

/* What is cracked. The mesh is shared, not copied, until it is set or freed. */
CRAZE_API craze_status craze_job_set_mesh(craze_job* job, const craze_mesh* mesh,
                                          craze_error* error);
/* A picture that the recipe names (stress.texture ...): height rows from the top of width pixels of
 * 1 ... 4 channels (grey, grey and alpha, RGB, RGBA) of CRAZE_UINT8, CRAZE_UINT16 or CRAZE_FLOAT32
 * in 0 ... 1. What counts is 0.2126 R + 0.7152 G + 0.0722 B as given (no gamma), without alpha.
 * Copied. */
CRAZE_API craze_status craze_job_set_texture(craze_job* job, const char* name, const void* pixels,
                                             craze_type type, int64_t width, int64_t height,
                                             int32_t channels, craze_error* error);

/* The recipe: that of a preset; TOML or JSON text, on top of the defaults, `name` being what errors
 * call it; one key ("layer.spacing") and its value as TOML or JSON ("0.2", "\"mud\"", "[0, 0, 1]"),
 * on top of what is set. The last one stands. */
CRAZE_API craze_status craze_job_set_preset(craze_job* job, const char* preset, craze_error* error);
CRAZE_API craze_status craze_job_set_recipe(craze_job* job, const char* text, const char* name,
                                            craze_error* error);
CRAZE_API craze_status craze_job_set(craze_job* job, const char* key, const char* value,
                                     craze_error* error);
/* JSON of the whole recipe as it is set. Free with craze_text_free. */
CRAZE_API char* craze_job_recipe(const craze_job* job, craze_error* error);
/* The same as TOML, which craze crack --recipe reads. Free with craze_text_free. */
CRAZE_API char* craze_job_recipe_toml(const craze_job* job, craze_error* error);

/* 0, the default: one per core. The result does not depend on it. */
CRAZE_API craze_status craze_job_set_threads(craze_job* job, int threads, craze_error* error);
/* Stop after so many crack events; 0: before the first; below 0, the default: no such limit. */
CRAZE_API craze_status craze_job_set_max_cracks(craze_job* job, int64_t max_cracks,
                                                craze_error* error);

/* Asked by craze_job_run and by what makes products of the job. */
CRAZE_API void craze_job_set_progress(craze_job* job, craze_progress progress, void* user);

/* Called by craze_job_run from its thread with the pieces of crack that have opened since the last
 * time, about twenty times a second while some do and when it is done: `count` rows of x y z x y z,
 * both ends on the mesh that the simulation runs on. `first` is the number of the first of them;
 * with 0 the pattern begins anew (evolution.cycles, layer.rounds). It must not use the handle. */
typedef void (*craze_opened)(void* user, int64_t first, const double* pieces, int64_t count);
CRAZE_API void craze_job_set_opened(craze_job* job, craze_opened opened, void* user);

/* Cracks the mesh. May be called again, with another recipe or mesh; products made before stay. */
CRAZE_API craze_status craze_job_run(craze_job* job, craze_error* error);

/* ---- What comes out ---------------------------------------------------------------------- */

/* The cut mesh, shut. "vertex:crack_distance", "vertex:crack_time", "vertex:crack_growth",
 * "vertex:displacement", "face:fragment", "face:source_face" are as in docs/outputs.md. */
CRAZE_API craze_mesh* craze_job_cut_mesh(const craze_job* job, craze_error* error);

/* The mesh that the cracks grew on, cut, with the state that was reached, of the last cycle and
 * round: face:s1 s2 dx dy dz, the principal stresses, force per length, and the direction of the
 * first; vertex:fx fy fz, forces; vertex:v nx ny nz v2, the separation tensor's largest value, its
 * direction and the other value; vertex:r, the residual at tips; vertex:ux uy uz, displacements;
 * and what else craze crack --fields writes. */
CRAZE_API craze_mesh* craze_job_fields(const craze_job* job, craze_error* error);

/* The cracks as a graph: "points" (p, 3) float64, "edges" (e, 2) int32, "uv" (2 e, 2), and
 * "point:NAME" (junction, normal) and "edge:NAME" (time, width, event). */
CRAZE_API craze_lines* craze_job_lines(const craze_job* job, craze_error* error);
CRAZE_API craze_status craze_lines_array(const craze_lines* lines, const char* name,
                                         craze_array* array, craze_error* error);
/* Writes .ply .obj .json .svg, the whole file or none. CRAZE_REQUEST where a format cannot hold
 * them: an SVG wants a plane or UVs. */
CRAZE_API craze_status craze_lines_write(const craze_lines* lines, const char* path,
                                         craze_error* error);
CRAZE_API void craze_lines_free(craze_lines* lines);

/* JSON; free with craze_text_free. The report is that of the command; the statistics are part of
 * it, and the summary is the report without them, which takes no time. */
CRAZE_API char* craze_job_report(const craze_job* job, craze_error* error);
CRAZE_API char* craze_job_summary(const craze_job* job, craze_error* error);
CRAZE_API char* craze_job_statistics(const craze_job* job, craze_error* error);
/* Statistics of lines of any origin: `points` (p rows of 3), `edges` (e rows of 2). `time`, one
 * per edge, may be NULL. `simplify`: lines are drawn by as few of their points as stay within this
 * length of them; 0: as they are. */
CRAZE_API char* craze_statistics(const double* points, int64_t p, const int32_t* edges, int64_t e,
                                 const double* time, double simplify, craze_error* error);

/* The cut mesh with its cracks open: `gap` times the displacement, walls of depth `wall` (length),
 * edges lifted by `curl`. Nothing is cracked again. */
CRAZE_API craze_opening* craze_job_open(const craze_job* job, double gap, double wall, double curl,
                                        craze_error* error);
/* The cut mesh opened as the recipe of the run says, and with the keys of its [post] in `text`,
 * TOML or JSON as of craze_job_set_recipe: {"post": {"gap": 0.1, "roughness": 0.01}}. With a
 * thickness each fragment is a closed solid, one of the parts of craze_mesh_fragments(). Nothing is
 * cracked again. The lines of the roughness last asked for are kept with the job. */
CRAZE_API craze_opening* craze_job_open_post(craze_job* job, const char* text, craze_error* error);
/* A finished job, as this one would be had its recipe had those keys: for its lines, maps,
 * statistics and report. Free with craze_job_free. */
CRAZE_API craze_job* craze_job_with_post(craze_job* job, const char* text, craze_error* error);
CRAZE_API void craze_opening_free(craze_opening* opening);
/* The opened mesh. Free with craze_mesh_free. */
CRAZE_API craze_mesh* craze_opening_mesh(const craze_opening* opening, craze_error* error);
/* What could not be done as asked, one sentence at a time; NULL beyond the last. */
CRAZE_API const char* craze_opening_warning(const craze_opening* opening, int64_t i);
/* How many vertices its mesh has. */
CRAZE_API int64_t craze_opening_vertex_count(const craze_opening* opening);
/* Its vertices at a time of its growth, 0 (no crack) ... 1 (all): writes as many rows of x y z. */
CRAZE_API craze_status craze_opening_positions_at(craze_opening* opening, double time,
                                                  double* positions, craze_error* error);

/* Maps of the cracks for the mesh's own UVs (docs/maps.md), `size` texels a side. `names`: those
 * wanted, with commas between them; NULL: all. `green_up`: 0 where the green of normals falls with
 * v (DirectX), else 1. `gap`, `wall`: width of the grooves over the opening, and their depth,
 * length; the rest of [post] is the recipe's. CRAZE_REQUEST where the mesh has no UVs. */
CRAZE_API craze_maps* craze_job_bake(const craze_job* job, int32_t size, const char* names,
                                     int32_t green_up, double gap, double wall, craze_error* error);
CRAZE_API void craze_maps_free(craze_maps* maps);
/* "mask"; "SET_mask" where there are several texture sets, "mask.1001" where there are tiles. NULL
 * beyond the last. */
CRAZE_API const char* craze_maps_name(const craze_maps* maps, int64_t i);
/* The i-th map: size * size rows, from the left and the top, of 1 or 3 columns, float32. */
CRAZE_API craze_status craze_maps_array(const craze_maps* maps, int64_t i, craze_array* array,
                                        craze_error* error);
/* What 0 and the largest number stand for where the i-th map is stored as whole numbers, for each
 * of its columns: the ranges of craze crack --maps. */
CRAZE_API craze_status craze_maps_range(const craze_maps* maps, int64_t i, double low[3],
                                        double high[3], craze_error* error);
/* What the command writes as maps.json beside these maps as .exr, a text that lives as long as they
 * do; NULL without maps. */
CRAZE_API const char* craze_maps_description(const craze_maps* maps);
/* A tileable set of textures (docs/textures.md): cracks a flat torus by the job's recipe and bakes
 * its maps, "base_color" and "roughness" among them. The job needs no mesh, and a run that it has
 * stays. `period`: the side, "2" in the tile's own unit or a length such as "40cm". `names`: NULL:
 * base_color, normal, height, occlusion, roughness, mask, fragment. CRAZE_REQUEST where the recipe
 * asks for what a tile has not. */
CRAZE_API craze_maps* craze_job_texture(const craze_job* job, const char* period, int32_t size,
                                        const char* names, int32_t green_up, craze_error* error);
/* What could not be done as asked, one sentence at a time; NULL beyond the last. */
CRAZE_API const char* craze_maps_warning(const craze_maps* maps, int64_t i);

#ifdef __cplusplus
}
#endif

#endif
