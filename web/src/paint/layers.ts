// What each paint does to the recipe: the one table.
import { layerNames, type LayerName, type Project } from "../project/project";
import type { Painting } from "./painting";

export interface Layer {
  attribute: string; // the input's, made of the paint
  key: string; // of the recipe, that names it
  /** The attribute where the paint is p, 0 … 1. */
  value(p: number): number;
}

// Added tension where the paint is full, in units of the presets' own.
const fullStress = 2;

export const layers: Record<LayerName, Layer> = {
  stress: {
    attribute: "paint_stress",
    key: "stress.attribute",
    value: (p) => fullStress * p,
  },
  // Weaker where painted: factor of strength and toughness.
  strength: { attribute: "paint_strength", key: "material.attribute", value: (p) => 1 - 0.75 * p },
  // Denser where painted: factor of the spacing.
  spacing: { attribute: "paint_spacing", key: "layer.attribute", value: (p) => 1 - 0.75 * p },
  // Cracks where painted, and nowhere else.
  mask: { attribute: "paint_mask", key: "where.attribute", value: (p) => p },
};

/** The attribute of the file that the mask is, where nothing else was painted, on it or elsewhere:
 * then the file itself is what the command reads. */
export function ownMask({ strokes }: Project): string | null {
  const last = strokes.at(-1);
  if (last?.kind !== "file" || !strokes.every(({ layer }) => layer === "mask")) return null;
  return isTexture(last.from!) ? null : last.from!;
}

/** Whether a mask of the file is in a texture of it, not at its vertices. */
export const isTexture = (name: string) => /^texture(:[rgba])?$/.test(name);

export function paintedLayers(project: Project): LayerName[] {
  if (ownMask(project) !== null) return [];
  return layerNames.filter((name) => project.strokes.some((stroke) => stroke.layer === name));
}

const isDirected = (project: Project) =>
  project.strokes.some((stroke) => stroke.layer === "stress" && stroke.along);

/** The attributes of the input that the strokes of a project make. A stress without direction is
 * one number, c I; with one it is a tensor, xx yy zz xy yz zx. */
export function paintedAttributes(project: Project, painting: Painting) {
  return paintedLayers(project).map((name) => {
    const { attribute, value } = layers[name];
    const paint = painting.values(name);
    if (name !== "stress" || !isDirected(project)) {
      return { name: attribute, values: Float32Array.from(paint, value), columns: 1 };
    }
    const values = Float32Array.from(painting.tension, value);
    paint.forEach((p, v) => {
      for (let k = 0; k < 3; ++k) values[6 * v + k]! += value(p);
    });
    return { name: attribute, values, columns: 6 };
  });
}
