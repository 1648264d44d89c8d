// What a run is asked to do: the recipe's sections as plain structs. Names, ranges, units and texts
// are in recipe/parameter_table.cpp, the one place that describes them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "craze/length.h"
#include "craze/tensor.h"

namespace craze {

enum class Engine { euler, quasistatic };
enum class Criterion { force, strength };
enum class CurvatureScale { none, gaussian, mean, frobenius, sum_of_squares };
/// What becomes of a crack within θ₁ of an edge that ends at an intact vertex.
enum class NearVertex {
  snap,   ///< the crack bends to the edge: the paper
  slide,  ///< the vertex moves onto the crack (vertex_slide.h), so that cracks do not see the mesh
};
enum class BoundaryKind { free, fixed };

/// [stress]: the initial field σ₀, the sum of what is given.
struct StressParameters {
  double uniform = 1;                ///< isotropic tension
  std::array<double, 6> tensor{};    ///< sxx syy szz sxy syz szx, world axes
  double noise = 0.05;               ///< relative standard deviation
  Length noise_length = 0;           ///< correlation length; 0: per triangle
  double relative_noise_length = 0;  ///< noise_length as a multiple of ℓ, where that is 0
  double curvature = 0;              ///< times the curvature tensor
  Length curvature_radius = 0;       ///< 0: twice the mean edge
  std::string attribute;             ///< of the input, added
  std::string texture;               ///< grey image in UV space, multiplied in
};

/// [[impact]]: a stress pattern around a point of the surface.
struct Impact {
  Vec3 point = Vec3::Zero();      ///< the nearest place of the surface is hit
  Vec3 direction = Vec3::Zero();  ///< of what comes from outside toward the middle; zero: the point
  std::vector<double> uv;         ///< two: the place with that UV; none: point or direction
  Length radius = 1;
  double relative_radius = 0;  ///< the radius as part of the object's diagonal; 0: radius
  double radial = 0;           ///< amplitude of the tension along the rays: opens rings
  double hoop = 1;             ///< amplitude of the tension around the point: opens rays
  double falloff = 2;          ///< exponent of the decay beyond the radius
  double radial_falloff = 0;   ///< of the radial part alone; 0: falloff
  double hoop_falloff = 0;     ///< of the hoop part alone; 0: falloff
};

/// [material]
struct MaterialParameters {
  double toughness = 1;  ///< τ
  double strength = 1;
  Criterion criterion = Criterion::force;
  double alpha = 0.5;             ///< α of Eq. 8
  double relative_toughness = 0;  ///< toughness over strength · √ℓ; 0: toughness as given
  Length process_zone = 0;        ///< length around a tip in which no other node fails; 0: ℓ / 2
  double scatter = 0;             ///< relative scatter of the strength
  Length scatter_length = 0;      ///< its correlation length; 0: the stress's noise_length
  double relative_scatter_length = 0;  ///< scatter_length as a multiple of ℓ, where that is 0
  Length lookahead = 0;           ///< length ahead of a tip by whose stress it turns; 0: its own ς
  double relative_lookahead = 0;  ///< lookahead as a multiple of ℓ, where that is 0
  CurvatureScale curvature_scale = CurvatureScale::none;
  double bias = 0;        ///< preference for principal directions (Fig. 2)
  std::string attribute;  ///< of the input, multiplies toughness and strength; 0: no crack, ever
  std::string texture;    ///< grey image in UV space, multiplied in too
};

/// [layer]
struct LayerParameters {
  Length spacing = 0;           ///< asked-for spacing of the cracks
  double relative_spacing = 0;  ///< the spacing as part of the object's diagonal
  Length screening_length = 0;  ///< ℓ; 0: no adhesion
  std::int64_t rounds = 0;      ///< times ℓ is put right by the spacing that came out
  std::string attribute;        ///< of the input, multiplies the spacing; 0: no crack, ever
  std::string texture;          ///< grey image in UV space, multiplied in too
};

/// [evolution]
struct EvolutionParameters {
  double shrinkage = 0;               ///< c: c I is added to every σ per step
  double curvature_growth = 0;        ///< times the curvature tensor, added per step
  double time_step = 0.1;             ///< Δt
  std::int64_t relaxation_steps = 1;  ///< R
  std::int64_t cracks_per_step = 1;
  double max_load = 4;
  double load_step = 0.02;          ///< relative; failures this close count as simultaneous
  double residual = 0.05;           ///< force left on a node over the force at which it fails
  std::int64_t max_cracks = 0;      ///< 0: no limit
  std::int64_t cycles = 1;          ///< times the layer cracks; it heals in between
  double healing = 0.3;             ///< strength across a healed crack over that around it
  double scar_width = 0.3;          ///< of a healed crack's weakness, standard deviation over ℓ
  double drift = 0;                 ///< of junctions from cycle to cycle, over ℓ; 0: none
  std::string onset_attribute;      ///< of the input: the load at which a place starts to be loaded
  std::string onset_texture;        ///< grey image in UV space: black at once, white at max_load
  Length onset_speed = 0;           ///< of a front behind which places start, per load; 0: none
  Vec3 onset_point = Vec3::Zero();  ///< what the front comes from
  Vec3 onset_direction = Vec3::Zero();  ///< of a plane front, instead; zero: the point
  double place_load = 0;                ///< most load of a place by itself; 0: no limit of its own

  /// The most that a place is loaded, whenever it starts.
  double most_load() const {
    return place_load > 0 && place_load < max_load ? place_load : max_load;
  }
};

/// [boundary]
struct BoundaryParameters {
  BoundaryKind kind = BoundaryKind::free;  ///< key boundary.default
  std::string fixed_attribute;
};

/// [crack]
struct CrackParameters {
  double snap_angle = 25;  ///< θ₁, degrees
  double back_angle = 15;  ///< θ₂, degrees
  NearVertex near_vertex = NearVertex::snap;
  double stride = 0;  ///< how far a failing node's crack runs at once, screening lengths
};

/// [where]: what of the surface cracks. Everything given must hold.
struct WhereParameters {
  std::vector<std::string> materials;  ///< names, or patterns with * and ?; none: any
  std::vector<std::string> nodes;      ///< of objects, likewise
  std::string attribute;               ///< of the input, 0 … 1: never … freely
  std::string texture;                 ///< grey image in UV space, multiplied in
  bool invert = false;                 ///< the rest of the surface instead

  bool is_given() const {
    return invert || !materials.empty() || !nodes.empty() || !attribute.empty() || !texture.empty();
  }
};

/// Everything the simulation needs to know besides the mesh.
struct SimulationParameters {
  Engine engine = Engine::quasistatic;
  std::uint64_t seed = 1;
  StressParameters stress;
  std::vector<Impact> impacts;
  MaterialParameters material;
  LayerParameters layer;
  WhereParameters where;
  EvolutionParameters evolution;
  BoundaryParameters boundary;
  CrackParameters crack;
};

}  // namespace craze
