// What each paint does to the recipe: the one table.
import type { LayerName } from "../project/project";

export interface Layer {
  attribute: string; // the input's, made of the paint
  key: string; // of the recipe, that names it
  /** The attribute where the paint is p, 0 … 1. */
  value(p: number): number;
}

export const layers: Record<LayerName, Layer> = {
  // Added tension, in units of the presets' own.
  stress: { attribute: "paint_stress", key: "stress.attribute", value: (p) => 2 * p },
  // Weaker where painted: factor of strength and toughness.
  strength: { attribute: "paint_strength", key: "material.attribute", value: (p) => 1 - 0.75 * p },
  // Denser where painted: factor of the spacing.
  spacing: { attribute: "paint_spacing", key: "layer.attribute", value: (p) => 1 - 0.75 * p },
  // Cracks where painted, and nowhere else.
  mask: { attribute: "paint_mask", key: "where.attribute", value: (p) => p },
};
