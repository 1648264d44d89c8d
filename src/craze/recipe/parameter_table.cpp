#include "craze/recipe/parameter_table.h"

#include <algorithm>

#include "craze/recipe/parameter_section.h"

namespace craze {

namespace {

constexpr ParameterRange any{};
constexpr ParameterRange not_negative{0};
constexpr ParameterRange positive{0, any.high, true};
constexpr ParameterRange share{0, 1};
constexpr ParameterRange positive_share{0, 1, true};
constexpr ParameterRange inside_share{0.01, 0.99};
constexpr ParameterRange angle{0, 90};
constexpr ParameterRange count{0, 9007199254740992.0};  // 2^53: whole in a double, and in JSON
constexpr ParameterRange from_one{1, count.high};
// Of things each of which is a run of its own.
constexpr ParameterRange runs{0, 1000}, runs_from_one{1, 1000};

std::vector<Parameter> make_table() {
  std::vector<Parameter> t;

  Section(
      t, "", [](auto& r, std::size_t) -> auto& { return r.simulation; })
      .add("engine", &SimulationParameters::engine, any,
           {.help = "how the stress relaxes: the paper's Euler steps, or straight to equilibrium",
            .source = "[IO06 §4.1]",
            .choices = {"euler", "quasistatic"}})
      .add("seed", &SimulationParameters::seed, count,
           {.help = "names the random numbers of a run; the same seed gives the same bytes"});

  Section(
      t, "mesh.", [](auto& r, std::size_t) -> auto& { return r.mesh; })
      .add("edge", &MeshParameters::edge, positive,
           {.help = "edge length of the simulation mesh; \"keep\": the input's triangles",
            .symbol = "h",
            .unit = "length",
            .choices = {"auto", "keep"}})
      .add("output", &MeshParameters::output, any,
           {.help = "what the cracks are cut into: \"asset\": the input's own triangles, which are "
                    "split only where a crack passes; \"simulation\": the mesh they grew on",
            .choices = {"asset", "simulation"}})
      .add("unit", &MeshParameters::unit, any,
           {.help = "unit of the input, where its file says none (glTF is in metres): what lengths "
                    "such as 4mm are measured in",
            .choices = {"none", "um", "mm", "cm", "m", "km", "in", "ft"}});

  Section(
      t, "stress.", [](auto& r, std::size_t) -> auto& { return r.simulation.stress; })
      .add("uniform", &StressParameters::uniform, any,
           {.help = "tension equal in all directions",
            .symbol = "σ₀",
            .unit = "stress",
            .source = "[IO06 §3.2]"})
      .add("tensor", &StressParameters::tensor, any,
           {.help = "xx yy zz xy yz zx in world axes, projected into each triangle",
            .symbol = "σ₀",
            .unit = "stress",
            .source = "[IO06 §3.2]"})
      .add("noise", &StressParameters::noise, not_negative,
           {.help = "random part of the stress, relative standard deviation",
            .source = "[IO06 §3.2]"})
      .add("noise_length", &StressParameters::noise_length, not_negative,
           {.help = "over which length the noise is alike; 0: each triangle by itself",
            .unit = "length"})
      .add("relative_noise_length", &StressParameters::relative_noise_length, not_negative,
           {.help = "noise_length as a multiple of the screening length, where noise_length is 0"})
      .add("curvature", &StressParameters::curvature, any,
           {.help = "times the curvature tensor is added",
            .unit = "stress·length",
            .source = "[IO06 §3.2]"})
      .add("curvature_radius", &StressParameters::curvature_radius, not_negative,
           {.help = "neighbourhood the curvature is measured over; 0: twice the mean edge",
            .unit = "length",
            .source = "[CSM03]"})
      .add("attribute", &StressParameters::attribute, any,
           {.help = "name of a vertex or face attribute of the input to add: 1 value, or 6 in the "
                    "order of stress.tensor",
            .unit = "stress",
            .source = "[IO06 §3.2]"})
      .add("texture", &StressParameters::texture, any,
           {.help = "file of a grey picture in UV space that the stress is multiplied with"});

  Section(
      t, "impact.", [](auto& r, std::size_t index) -> auto& { return r.simulation.impacts[index]; })
      .add("point", &Impact::point, any,
           {.help = "where the surface is hit: at the place nearest to it, no farther away than a "
                    "tenth of the object's diagonal",
            .unit = "position",
            .source = "[IO06 §4.1, Fig. 3]"})
      .add("direction", &Impact::direction, any,
           {.help = "instead of point: what hits comes from outside in this direction toward the "
                    "middle of the object's box, [0, 0, -1] from above; zero: point"})
      .add("uv", &Impact::uv, any, {.help = "instead of point: the place with this UV; []: point"})
      .add("radius", &Impact::radius, positive,
           {.help = "within it the amplitudes hold in full", .unit = "length"})
      .add("relative_radius", &Impact::relative_radius, not_negative,
           {.help = "instead of radius: as part of the object's diagonal; 0: radius"})
      .add("radial", &Impact::radial, any,
           {.help = "tension along the rays: opens rings", .unit = "stress"})
      .add("hoop", &Impact::hoop, any,
           {.help = "tension around the point: opens rays", .unit = "stress"})
      .add("falloff", &Impact::falloff, not_negative,
           {.help = "exponent of the decay beyond the radius"})
      .add("radial_falloff", &Impact::radial_falloff, not_negative,
           {.help = "exponent for the radial part alone; 0: falloff"})
      .add("hoop_falloff", &Impact::hoop_falloff, not_negative,
           {.help = "exponent for the hoop part alone; 0: falloff"});

  Section(
      t, "material.", [](auto& r, std::size_t) -> auto& { return r.simulation.material; })
      .add("toughness", &MaterialParameters::toughness, positive,
           {.help = "a node fails where the separation tensor's eigenvalue exceeds it",
            .symbol = "τ",
            .unit = "force",
            .source = "[IO06 §3.4]"})
      .add("strength", &MaterialParameters::strength, positive,
           {.help = "stress at which an intact place fails (criterion \"strength\")",
            .symbol = "σ_c",
            .unit = "stress"})
      .add("criterion", &MaterialParameters::criterion, any,
           {.help = "\"force\": the paper's; \"strength\": independent of the mesh",
            .source = "[IO06 §3.4]",
            .choices = {"force", "strength"}})
      .add("alpha", &MaterialParameters::alpha, share,
           {.help = "share of the excess carried to the new tips: low is jagged, high is straight",
            .symbol = "α",
            .source = "[IO06 Eq. 8]"})
      .add("relative_toughness", &MaterialParameters::relative_toughness, not_negative,
           {.help =
                "toughness as a multiple of strength · √ℓ (criterion \"strength\"); 0: toughness "
                "as given"})
      .add("process_zone", &MaterialParameters::process_zone, not_negative,
           {.help = "no intact place fails this close to a crack tip (criterion \"strength\"); 0: "
                    "half the screening length",
            .unit = "length"})
      .add("scatter", &MaterialParameters::scatter, share,
           {.help = "random part of the strength, relative standard deviation"})
      .add("scatter_length", &MaterialParameters::scatter_length, not_negative,
           {.help = "over which length the scatter is alike; 0: stress.noise_length",
            .unit = "length"})
      .add("relative_scatter_length", &MaterialParameters::relative_scatter_length, not_negative,
           {.help =
                "scatter_length as a multiple of the screening length, where scatter_length is 0"})
      .add("lookahead", &MaterialParameters::lookahead, not_negative,
           {.help = "length ahead of a crack tip over whose mean stress it turns, so that it meets "
                    "other cracks squarely, and never backward; 0, or less than an edge: it "
                    "turns by the forces at the tip alone",
            .unit = "length"})
      .add("relative_lookahead", &MaterialParameters::relative_lookahead, not_negative,
           {.help = "lookahead as a multiple of the screening length, where lookahead is 0"})
      .add("curvature_scale", &MaterialParameters::curvature_scale, any,
           {.help = "what of the curvature multiplies the separation tensor",
            .source = "[IO06 §4.1, Figs. 4, 10]",
            .choices = {"none", "gaussian", "mean", "frobenius", "sum-of-squares"}})
      .add("bias", &MaterialParameters::bias, share,
           {.help = "preference for cracks along the principal directions of curvature",
            .source = "[IO06 Fig. 2]"})
      .add("attribute", &MaterialParameters::attribute, any,
           {.help = "name of a scalar attribute of the input that multiplies toughness and "
                    "strength; 0: no crack, ever"})
      .add("texture", &MaterialParameters::texture, any,
           {.help = "file of a grey picture in UV space that multiplies them too"});

  Section(
      t, "layer.", [](auto& r, std::size_t) -> auto& { return r.simulation.layer; })
      .add("spacing", &LayerParameters::spacing, not_negative,
           {.help = "distance between cracks to aim for; sets the adhesion", .unit = "length"})
      .add("relative_spacing", &LayerParameters::relative_spacing, not_negative,
           {.help = "spacing as part of the object's diagonal, where neither spacing nor "
                    "screening_length is given"})
      .add("screening_length", &LayerParameters::screening_length, not_negative,
           {.help = "over which a crack unloads its surroundings; 0: no adhesion, as in the paper",
            .symbol = "ℓ",
            .unit = "length"})
      .add("rounds", &LayerParameters::rounds, runs,
           {.help = "times at most that all is cracked anew with the screening length put right by "
                    "the spacing that came out, until it is within 5 % of what was asked for"})
      .add("attribute", &LayerParameters::attribute, any,
           {.help = "name of a scalar attribute of the input that multiplies the spacing; 0: no "
                    "crack, ever"})
      .add("texture", &LayerParameters::texture, any,
           {.help = "file of a grey picture in UV space that multiplies it too"});

  Section(
      t, "where.", [](auto& r, std::size_t) -> auto& { return r.simulation.where; })
      .add("materials", &WhereParameters::materials, any,
           {.help = "names of the materials that crack, * and ? standing for any letters; []: all"})
      .add("nodes", &WhereParameters::nodes, any,
           {.help = "names of the objects that crack, likewise: nodes of glTF, o and g of OBJ"})
      .add("attribute", &WhereParameters::attribute, any,
           {.help = "name of a scalar attribute of the input, 0 … 1: at 0 no crack, ever, at 1 as "
                    "without it, between ever fewer"})
      .add("texture", &WhereParameters::texture, any,
           {.help = "file of a grey picture in UV space that multiplies it"})
      .add("invert", &WhereParameters::invert, any,
           {.help = "the rest of the surface cracks instead: 1 minus the product of all four"});

  Section(
      t, "evolution.", [](auto& r, std::size_t) -> auto& { return r.simulation.evolution; })
      .add("shrinkage", &EvolutionParameters::shrinkage, not_negative,
           {.help = "tension added everywhere per step (euler)",
            .symbol = "c",
            .unit = "stress",
            .source = "[IO06 §4.1]"})
      .add("curvature_growth", &EvolutionParameters::curvature_growth, any,
           {.help = "times the curvature tensor is added per step (euler), or per unit of the load "
                    "factor (quasistatic)",
            .unit = "stress·length",
            .source = "[IO06 §4.1]"})
      .add("time_step", &EvolutionParameters::time_step, positive,
           {.help = "rate of one relaxation step", .symbol = "Δt", .source = "[IO06 Eq. 3]"})
      .add("relaxation_steps", &EvolutionParameters::relaxation_steps, count,
           {.help = "relaxation steps between two crack events (euler)",
            .symbol = "R",
            .source = "[IO06 Eq. 9]"})
      .add("cracks_per_step", &EvolutionParameters::cracks_per_step, from_one,
           {.help = "nodes cracked between two relaxations; 1 is the paper's",
            .source = "[IO06 §3.1]"})
      .add("max_load", &EvolutionParameters::max_load, not_negative,
           {.help = "load factor to stop at (quasistatic)", .symbol = "s"})
      .add(
          "load_step", &EvolutionParameters::load_step, not_negative,
          {.help = "nodes that fail within this part of the load, too far apart to interact, crack "
                   "in one step; 0: the next one only (quasistatic)"})
      .add(
          "residual", &EvolutionParameters::residual, positive,
          {.help = "largest force left on a node when the next crack is looked for, over the force "
                   "at which nodes fail (quasistatic)"})
      .add("max_cracks", &EvolutionParameters::max_cracks, count,
           {.help = "crack events to stop after; 0: no limit"})
      .add("cycles", &EvolutionParameters::cycles, runs_from_one,
           {.help = "times the layer cracks; in between it heals, and the last cycle is the result",
            .source = "Goehring et al. 2010"})
      .add("healing", &EvolutionParameters::healing, positive_share,
           {.help =
                "strength across a healed crack, over that of the layer around it; 1: nothing is "
                "remembered"})
      .add("scar_width", &EvolutionParameters::scar_width, positive,
           {.help = "half width of the weak strip that a healed crack leaves, over the screening "
                    "length"})
      .add("drift", &EvolutionParameters::drift, not_negative,
           {.help = "how far the junctions of healed cracks move from cycle to cycle, toward three "
                    "angles of 120 degrees, over the screening length; 0: they stay",
            .source = "Goehring et al. 2010"})
      .add("onset_attribute", &EvolutionParameters::onset_attribute, any,
           {.help = "name of a scalar attribute of the input: the load factor at which a place "
                    "starts to be loaded, 0 or more (quasistatic)"})
      .add("onset_texture", &EvolutionParameters::onset_texture, any,
           {.help = "file of a grey picture in UV space, added to it: black starts at once, white "
                    "at max_load, and so never"})
      .add(
          "onset_speed", &EvolutionParameters::onset_speed, not_negative,
          {.help = "how far a front runs over the object while the load factor grows by 1; what it "
                   "has passed starts to be loaded; 0: no front",
           .unit = "length"})
      .add("onset_point", &EvolutionParameters::onset_point, any,
           {.help = "where the front comes from: it meets the place nearest to it at load 0",
            .unit = "position"})
      .add("onset_direction", &EvolutionParameters::onset_direction, any,
           {.help = "instead of onset_point: which way a plane front runs, from the first place it "
                    "meets; zero: from the point"})
      .add("place_load", &EvolutionParameters::place_load, not_negative,
           {.help = "load that a place takes from its onset on, at most, as what has dried shrinks "
                    "no more; 0: all up to max_load (quasistatic)"});

  Section(
      t, "boundary.", [](auto& r, std::size_t) -> auto& { return r.simulation.boundary; })
      .add("default", &BoundaryParameters::kind, any,
           {.help = "whether the open border may move",
            .source = "[IO06 §4.1]",
            .choices = {"free", "fixed"}})
      .add("fixed_attribute", &BoundaryParameters::fixed_attribute, any,
           {.help = "name of a vertex attribute of the input: vertices above 0.5 are fixed"});

  Section(
      t, "crack.", [](auto& r, std::size_t) -> auto& { return r.simulation.crack; })
      .add("snap_angle", &CrackParameters::snap_angle, angle,
           {.help = "a crack closer than this to a mesh edge follows the edge",
            .symbol = "θ₁",
            .unit = "degrees",
            .source = "[IO06 Fig. 5]"})
      .add("back_angle", &CrackParameters::back_angle, angle,
           {.help = "a crack closer than this to an older crack at its node is dropped",
            .symbol = "θ₂",
            .unit = "degrees",
            .source = "[IO06 Fig. 5]"})
      .add("near_vertex", &CrackParameters::near_vertex, any,
           {.help = "within snap_angle of an edge: \"snap\" bends the crack to the edge, \"slide\" "
                    "moves the edge's end onto the crack, so that cracks do not see the mesh",
            .choices = {"snap", "slide"}})
      .add("stride", &CrackParameters::stride, not_negative,
           {.help = "how far a crack runs straight on before equilibrium is sought again, as a "
                    "multiple of the screening length; 0: one edge (quasistatic)"});

  Section(
      t, "post.", [](auto& r, std::size_t) -> auto& { return r.post; })
      .add("gap", &PostParameters::gap, not_negative,
           {.help = "how far cracks open: scales the displacement",
            .symbol = "γ",
            .source = "[IO06 Eq. 9]",
            .instead_of = "post.gap_width"})
      .add(
          "gap_width", &PostParameters::gap_width, not_negative,
          {.help = "instead of gap: how wide cracks open on average over their length, tapering to "
                   "their tips",
           .unit = "length",
           .instead_of = "post.gap"})
      .add("wall", &PostParameters::wall, not_negative,
           {.help = "depth of the side walls of open cracks; 0: none",
            .unit = "length",
            .source = "[IO06 §5]"})
      .add("late_width", &PostParameters::late_width, share,
           {.help =
                "width of the last crack to open, over that with 1; the first keeps its own, the "
                "others lie between by the time they have been open; so do stains of maps and "
                "textures. 1: age makes no difference. gap_width stays the mean"})
      .add("curl", &PostParameters::curl, any,
           {.help = "lift of the crack edges, as a share of their displacement; below 0: down",
            .source = "[IO06 §5, Fig. 9]"})
      .add("thickness", &PostParameters::thickness, not_negative,
           {.help = "each fragment is a closed solid: outer surface, walls all round and an inner "
                    "surface so far inwards, less where there is no room; 0: none. Walls go all "
                    "the way, whatever wall is",
            .unit = "length"})
      .add(
          "wedge", &PostParameters::wedge, share,
          {.help = "with thickness: how much less open cracks are at the inner surface than at the "
                   "outer one, as a share: 0: walls straight down, 1: pieces meet there"})
      .add("core", &PostParameters::core, any,
           {.help = "with thickness: what is left inside a closed surface is one more solid, which "
                    "stays when the pieces fall"})
      .add("collider", &PostParameters::collider, any,
           {.help = "with thickness, in GLB: the convex hull of each piece, for physics: "
                    "\"extras\": numbers in its node's extras; \"unreal\", \"godot\": a node of "
                    "its own, named as that engine's importer wants it",
            .choices = {"none", "extras", "unreal", "godot"}})
      .add("roughness", &PostParameters::roughness, not_negative,
           {.help = "how rough the cracks' own lines are, in the surface: rms difference over the "
                    "usual length of a crack between two junctions; 0: smooth",
            .unit = "length",
            .instead_of = "post.relative_roughness"})
      .add("relative_roughness", &PostParameters::relative_roughness, not_negative,
           {.help = "roughness as a part of that usual length, where roughness is 0",
            .instead_of = "post.roughness"})
      .add("roughness_exponent", &PostParameters::roughness_exponent, inside_share,
           {.help = "how roughness goes down with scale, as its power: near 1 soft bends, near 0 "
                    "fine teeth; broken materials have 0.75 to 0.8",
            .symbol = "H",
            .source = "Bouchaud 1997"})
      .add("roughness_step", &PostParameters::roughness_step, not_negative,
           {.help = "distance between the points of a rough line, at most; 0: 1/16 of the usual "
                    "length of a crack, more where that makes over 262144 points",
            .unit = "length"})
      .add("face_roughness", &PostParameters::face_roughness, {0, 10},
           {.help = "how rough broken faces are in depth, over the roughness of the cracks' lines: "
                    "walls of gaps and of solid pieces then have rows of points in depth. 1: alike "
                    "in all directions, 0: flat"})
      .add("chipping", &PostParameters::chipping, share,
           {.help = "share of the rims of open cracks that is chipped: shell-shaped bites out of "
                    "the surface, more of them at junctions and along old cracks; 0: none"})
      .add("chip_size", &PostParameters::chip_size, not_negative,
           {.help =
                "half the length of the largest chips along a rim, the smallest have a quarter "
                "of it; 0: 1/8 of the mean distance between cracks. Never more than 1/3 of that, "
                "nor than six widths of the crack",
            .unit = "length"})
      .add("lines", &PostParameters::lines, any,
           {.help = "cracks that are shut, gap 0, in GLB: \"auto\": dark lines a hair above the "
                    "surface, so that every viewer shows them; \"none\": the surface alone",
            .choices = {"auto", "none"}});

  Section(
      t, "picture.", [](auto& r, std::size_t) -> auto& { return r.picture; })
      .add("material", &PictureParameters::material, any,
           {.help = "look of the surface in pictures: clay, mud, glaze, plaster, glass or paint"})
      .add("up", &PictureParameters::up, any,
           {.help = "axis that points up in pictures; auto: z for flat plates and built-in shapes, "
                    "else y",
            .choices = {"auto", "x", "y", "z"}});
  return t;
}

}  // namespace

const std::vector<Parameter>& parameter_table() {
  static const std::vector<Parameter> table = make_table();
  return table;
}

std::string Parameter::section() const {
  const auto dot = key.find('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::string Parameter::name() const {
  const auto dot = key.find('.');
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

ParameterValue Parameter::default_value() const {
  Recipe recipe;
  if (repeated()) recipe.simulation.impacts.emplace_back();
  return get(recipe, 0);
}

const Parameter* find_parameter(std::string_view key) {
  const auto& table = parameter_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Parameter& p) { return p.key == key; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace craze
