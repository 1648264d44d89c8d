#include "craze/job/dataset/dataset_plan.h"

#include "craze/material/material.h"

namespace craze {

namespace {

using Keys = std::vector<PlanKey>;

PlanKey whole(std::string key, double standard, double low, double high, std::string help) {
  return {std::move(key), PlanKeyType::integer, standard, low, high, {}, false, std::move(help)};
}

PlanKey number(std::string key, double standard, double low, double high, std::string help) {
  return {std::move(key), PlanKeyType::number, standard, low, high, {}, false, std::move(help)};
}

PlanKey word(std::string key, std::string standard, std::vector<std::string> choices,
             std::string help) {
  PlanKey k;
  k.key = std::move(key);
  k.type = PlanKeyType::word;
  k.standard = std::move(standard);
  k.choices = std::move(choices);
  k.help = std::move(help);
  return k;
}

PlanKey fixed(PlanKey key) {
  key.fixed = true;
  return key;
}

PlanKey extent(PlanKey key) {
  key.extent = true;
  return fixed(std::move(key));
}

Keys set_keys() {
  return {
      extent(whole("samples", 100, 1, 1e9, "how many")),
      fixed(whole("seed", 1, 0, 9007199254740000.0, "another one gives another set")),
      fixed(whole("shard_samples", 64, 1, 100000, "samples of a shard, a tar file")),
      fixed(whole("width", 512, 16, 8192, "of the pictures, pixels")),
      fixed(whole("height", 512, 16, 8192, "likewise")),
      fixed(number("clean", 0.1, 0, 1, "share of samples without a crack")),
      fixed(whole("attempts", 8, 1, 1000, "draws of a sample until a crack is seen in it")),
      fixed(word("folders", "no", {"no", "yes"},
                 "images/ and masks/ beside the shards, for loaders that want files")),
      fixed(whole("points", 0, 0, 1e7,
                  "of a cloud of points with labels, PLY, a sample; 0: no cloud")),
  };
}

Keys object_keys() {
  return {
      word("object.mesh", "shape:plate?n=80&jitter=0.3", {},
           "a mesh file or a folder of them, seen from the plan's folder, or "
           "shape:NAME?key=value&…"),
  };
}

Keys surface_keys() {
  std::vector<std::string> names;
  for (const render::Material& m : render::materials()) {
    if (!m.glass) names.push_back(m.name);
  }
  const double own = -1;
  return {
      word("surface.material", "plaster", names, "how the surface looks; the keys below change it"),
      number("surface.brightness", 1, 0.05, 4, "factor of the colour"),
      number("surface.warmth", 0, -1, 1, "from blue to red"),
      number("surface.mottle", own, -1, 1, "clouds in the colour; below 0: the material's"),
      number("surface.bump", own, -1, 1, "unevenness; below 0: the material's"),
      number("surface.grit", own, -1, 2, "grains; below 0: the material's"),
      number("surface.aggregate", 0, 0, 2, "stones of different tints"),
      number("surface.aggregate_size", 0.011, 0.001, 0.5,
             "of a stone, as part of the object's diagonal"),
      number("surface.hue", 0, -360, 360, "degrees: 0 red, 120 green, 240 blue"),
      number("surface.saturation", own, -1, 1,
             "how much of that hue the colour has, as bright as before; below 0: the material's"),
      number("surface.specks", 0, 0, 1, "specks of different colours, as granite has"),
      number("surface.speck_size", 0.002, 0.0005, 0.5, "of a speck, as part of the diagonal"),
      number("surface.veins", 0, 0, 1, "dark veins that wander, as of marble or wood"),
      number("surface.vein_size", 0.03, 0.002, 1, "from one to the next, as part of the diagonal"),
      number("surface.vein_width", 0.2, 0.01, 1, "of a vein, as part of that"),
      number("surface.bricks", 0, -1, 1,
             "how much darker, or lighter below 0, mortar between bricks is"),
      number("surface.brick_size", 0.05, 0.002, 1, "height of a course, as part of the diagonal"),
      number("surface.mortar", 0.1, 0.01, 0.5, "of a joint, as part of that"),
      number("surface.flaking", 0, 0, 1, "share, about, where the coat has come off in patches"),
      number("surface.flake_size", 0.03, 0.002, 1, "of a patch, as part of the diagonal"),
      number("surface.below", 0.6, 0.05, 4, "factor of the colour where the coat is gone"),
      number("surface.coat", own, -1, 1, "a clear coat that mirrors; below 0: the material's"),
      number("surface.gloss", own, -1, 1, "a broad sheen; below 0: the material's"),
  };
}

Keys crack_keys() {
  const double own = -1;
  return {
      number("lines.width", 3, 0.2, 60,
             "mean width of the cracks, pixels in the middle of the picture"),
      number("lines.unevenness", 0.2, 0, 1, "how much the width varies along a crack"),
      number("lines.even", 0.5, 0, 1,
             "0: each crack as wide as it opened; 1: all alike, but for their tips"),
      number("lines.taper", 25, 0, 1000, "length over which a tip closes, pixels"),
      number("lines.darkness", own, -1, 1,
             "how much of its colour a crack shows; below 0: the material's"),
      number("lines.patchiness", 0, 0, 1, "how much that varies along a crack"),
      number("lines.brightness", 1, 0, 4, "factor of the cracks' colour"),
      number("lines.stain", own, -1, 1, "a darker band beside; below 0: the material's"),
      number("lines.groove", own, -1, 1, "how engraved they look; below 0: the material's"),
  };
}

Keys camera_keys() {
  return {
      number("camera.elevation", 90, 5, 90, "degrees above the horizon; 90: from above"),
      number("camera.azimuth", 0, -360, 360, "degrees"),
      number("camera.zoom", 1.6, 0.2, 100, "1: the whole object is seen"),
      number("camera.field_of_view", 30, 2, 100, "vertical, degrees"),
      number("camera.off_centre", 0.1, 0, 0.5,
             "how far the middle may lie from the object's, as part of its diagonal"),
      word("camera.up", "auto", {"auto", "x", "y", "z"}, "which way is up"),
      word("camera.ground", "no", {"no", "yes"}, "a floor that catches the shadow"),
      number("light.azimuth", -50, -360, 360, "of the lamp, degrees to the right of the camera"),
      number("light.elevation", 40, 3, 90, "degrees above the horizon"),
      whole("light.samples", 16, 16, 1024, "rays a pixel"),
      number("image.exposure", 0, -4, 4, "stops"),
      number("image.blur", 0.5, 0, 20, "standard deviation, pixels"),
      number("image.motion", 0, 0, 40, "length of the camera's shake, pixels"),
      number("image.motion_angle", 0, -360, 360, "its direction, degrees"),
      number("image.noise", 2, 0, 60, "of the sensor, standard deviation of 255"),
      number("image.quality", 100, 1, 100, "JPEG's; 100: never packed"),
  };
}

Keys mark_keys() {
  return {
      whole("distractors.shadow", 0, 0, 4, "shadows with an edge"),
      whole("distractors.stain", 0, 0, 40, "stains"),
      whole("distractors.joint", 0, 0, 10, "straight joints, wide and engraved"),
      whole("distractors.scratch", 0, 0, 60, "scratches, fine and light"),
      whole("distractors.seam", 0, 0, 10, "seams: straight, thin and dark"),
      whole("distractors.hair", 0, 0, 20, "hairs and threads, with their shadows"),
      whole("distractors.twig", 0, 0, 10, "twigs with branches"),
      whole("distractors.grass", 0, 0, 10, "tufts of grass"),
      whole("distractors.rod", 0, 0, 10, "rods and cables, straight, with their shadows"),
      whole("distractors.pebble", 0, 0, 40, "pebbles"),
      whole("distractors.tyre", 0, 0, 10, "tyre marks: broad, dark and faint"),
      whole("distractors.painted_line", 0, 0, 4, "painted lines: broad, white or yellow"),
      whole("distractors.lettering", 0, 0, 4, "rows of painted signs"),
  };
}

Keys label_keys() {
  return {
      number("label.min_width", 0, 0, 20,
             "cracks narrower than this where they are are left out of the mask, pixels"),
      number("label.min_pixels", 20, 1, 1e6, "of a mask, to count as a crack that is seen"),
      number("label.tolerance", 2, 0, 20,
             "that a judge should allow, pixels; goes with the labels"),
      number("label.grow", 0, -5, 10,
             "label noise: the mask is so much wider on each side than the crack, pixels"),
      number("label.dropout", 0, 0, 1, "label noise: share of cracks that are not in the mask"),
  };
}

}  // namespace

const PlanSchema& dataset_schema() {
  static const PlanSchema schema = [] {
    PlanSchema s{"dataset", {}, false};
    for (const Keys& keys : {set_keys(), object_keys(), surface_keys(), crack_keys(), camera_keys(),
                             mark_keys(), label_keys()}) {
      s.keys.insert(s.keys.end(), keys.begin(), keys.end());
    }
    return s;
  }();
  return schema;
}

DatasetShape dataset_shape(const Plan& plan) {
  const auto count = [&](const char* key) { return static_cast<std::uint64_t>(plan.number(key)); };
  return {count("samples"),
          count("shard_samples"),
          static_cast<int>(plan.number("width")),
          static_cast<int>(plan.number("height")),
          plan.number("clean"),
          static_cast<int>(plan.number("attempts")),
          plan.word("folders") == "yes",
          count("points")};
}

}  // namespace craze
