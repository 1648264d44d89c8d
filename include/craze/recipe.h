// A recipe: every setting of a run except its files. TOML on disk, JSON between programs, dotted
// keys on the command line.
#pragma once

#include <string>
#include <string_view>

#include "craze/collider.h"
#include "craze/parameters.h"
#include "craze/up_axis.h"

namespace craze {

/// mesh.edge: how fine the simulation mesh is.
struct EdgeLength {
  enum class Kind {
    automatic,  ///< from the screening length or spacing, else from the input
    keep,       ///< the input's triangles as they are
    given,      ///< `length`
  };
  Kind kind = Kind::automatic;
  Length length = 0;  ///< target edge length; 0 unless given
};

/// mesh.output: which triangles carry the cracks in the end.
enum class OutputMesh {
  asset,       ///< the input's own, split only where a crack passes
  simulation,  ///< those that the cracks grew on
};

/// [mesh]
struct MeshParameters {
  EdgeLength edge;
  LengthUnit unit = LengthUnit::own;  ///< the mesh's, where its file says none; own: not known
  OutputMesh output = OutputMesh::asset;
};

/// post.lines: how a GLB shows cracks that are shut.
enum class ShutCracks {
  automatic,  ///< as dark lines
  none,       ///< not at all
};

/// [post]: §5 of the paper, done to the finished mesh.
struct PostParameters {
  double gap = 0;         ///< γ of Eq. 9
  Length gap_width = 0;   ///< mean opening, instead of gap; a run turns it into that
  Length wall = 0;        ///< depth of the side walls
  double late_width = 1;  ///< of the last crack to open, over that which it has with 1
  double curl = 0;        ///< lift at a crack, as a share of the displacement there
  Length thickness = 0;   ///< each fragment is a closed solid; instead of wall
  double wedge = 0;   ///< of solids: how much less open cracks are at the inner surface, a share
  bool core = false;  ///< what is left inside a closed surface is a solid as well
  Collider collider = Collider::extras;  ///< of solids
  Length roughness = 0;             ///< of the cracks' lines, rms over the usual length of a crack
  double relative_roughness = 0;    ///< that over the usual length, where roughness is 0
  double roughness_exponent = 0.8;  ///< Hurst exponent of that
  Length roughness_step = 0;        ///< between points of a rough line; 0: automatic
  double face_roughness = 0;        ///< of broken faces in depth, over that of lines
  double chipping = 0;              ///< share of the rims of open cracks that is chipped
  Length chip_size = 0;  ///< half the length of the largest chips along a rim; 0: automatic
  ShutCracks lines = ShutCracks::automatic;
};

/// [picture]: how the result is shown.
struct PictureParameters {
  std::string material = "clay";  ///< a name of the renderer's materials
  UpAxis up = UpAxis::automatic;
};

struct Recipe {
  SimulationParameters simulation;
  MeshParameters mesh;
  PostParameters post;
  PictureParameters picture;
};

/// Equal in every parameter of the table.
bool operator==(const Recipe& a, const Recipe& b);

/// Sets what a TOML or JSON text gives and leaves the rest of `base` as it is; impacts given
/// replace those of the base, and of gap and gap_width, or roughness and relative_roughness, one
/// that is given alone replaces the other. `name` is the file named in errors. Unknown keys, wrong
/// types, values out of range, text larger than 1 MiB or nested deeper than any recipe needs throw
/// Error(usage) with the place.
Recipe read_recipe(std::string_view text, const std::string& name, const Recipe& base = {});

/// Reads a recipe from a file; Error(input) where it cannot be read.
Recipe read_recipe_file(const std::string& path, const Recipe& base = {});

/// Applies one "key=value" of the command line. The value is written as in TOML, except that words
/// need no quotes. impact.N.key changes the N-th impact, counted from 0, or appends one where N is
/// their number. Throws Error(usage).
void apply_set(Recipe& recipe, const std::string& assignment);

/// TOML with every parameter, which reads back equal.
std::string write_recipe(const Recipe& recipe);

}  // namespace craze
