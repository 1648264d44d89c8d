#include "craze/material/material.h"

#include "craze/error.h"

namespace craze::render {

const std::vector<Material>& materials() {
  static const std::vector<Material> table{
      {.name = "clay",
       .color = from_srgb(201, 176, 152),
       .wall = from_srgb(138, 104, 80),
       .mottle = 0.06f,
       .bump = 0.05f,
       .gloss = 0.05f,
       .line = from_srgb(44, 30, 24),
       .line_strength = 0.95f,
       .stain = 0.15f,
       .groove = 0.6f,
       .worn = 0.6f},
      {.name = "mud",
       .color = from_srgb(154, 137, 117),
       .wall = from_srgb(84, 67, 53),
       .mottle = 0.2f,
       .bump = 0.24f,
       .grit = 1,
       .pieces = 1,
       .line = from_srgb(40, 31, 24),
       .line_strength = 0.97f,
       .stain = 0.3f,
       .groove = 0.7f,
       .worn = 1.2f},
      {.name = "glaze",
       .color = from_srgb(190, 205, 190),
       .wall = from_srgb(122, 96, 74),
       .mottle = 0.05f,
       .coat = 1,
       .line = from_srgb(46, 38, 30),
       .line_strength = 0.88f,
       .stain = 0.28f,
       .worn = 0.4f},
      {.name = "plaster",
       .color = from_srgb(216, 211, 202),
       .wall = from_srgb(168, 160, 148),
       .mottle = 0.05f,
       .bump = 0.04f,
       .line = from_srgb(70, 64, 58),
       .line_strength = 0.9f,
       .stain = 0.12f,
       .groove = 0.6f,
       .worn = 0.5f},
      {.name = "glass",
       .color = from_srgb(226, 240, 236),
       .wall = from_srgb(240, 248, 246),
       .coat = 1,
       .glass = true,
       .fissure = 0.03f,
       .line = from_srgb(250, 253, 253),
       .line_strength = 0.55f,
       .backdrop = from_srgb(84, 92, 104)},
      {.name = "paint",
       .color = from_srgb(92, 140, 142),
       .wall = from_srgb(150, 122, 94),
       .mottle = 0.08f,
       .bump = 0.03f,
       .coat = 0.45f,
       .line = from_srgb(52, 40, 32),
       .line_strength = 0.95f,
       .stain = 0.2f,
       .groove = 0.4f,
       .worn = 0.3f},
  };
  return table;
}

const Material& find_material(const std::string& name) {
  std::string names;
  for (const Material& m : materials()) {
    if (m.name == name) return m;
    names += (names.empty() ? "" : ", ") + m.name;
  }
  throw Error(ErrorKind::usage, "unknown material", name, "choose one of " + names);
}

}  // namespace craze::render
