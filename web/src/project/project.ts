// What the page holds: all of it, and nothing that can be made of it again. Immutable; a change is
// a new one that shares the rest.
import { noOpenings, openingNames, type Openings, type Value } from "./openings";

export type Source = { kind: "shape"; specification: string } | { kind: "file"; name: string };

export const layerNames = ["stress", "strength", "spacing", "mask"] as const;
export type LayerName = (typeof layerNames)[number];

/** A stroke of the brush. Its numbers are whole, so that they come back from an address as they
 * were: places in 1/65535 of the box of the input, radius in the same of its diagonal, strength in
 * 1/100; normals are of length 127. */
export interface Stroke {
  kind: "brush" | "fill" | "invert" | "file"; // all but the first are of the whole surface
  from?: string; // of "file": which of the file's masks the layer becomes
  layer: LayerName;
  along: boolean; // stress alone: tension along the way that the brush goes, none across it
  radius: number;
  strength: number;
  erase: boolean;
  mirror: boolean; // in x too, about the middle of the box
  dabs: number[]; // x y z and the normal's x y z, six a dab
}

/** What the page itself reads of a whole recipe, which has all keys of the table. */
export interface OwnRecipe {
  seed: number;
  layer: { spacing: Value; relative_spacing: number };
  evolution: { max_load: number };
  picture: { material: string };
  post: Record<string, Value>;
}

export interface Project extends Openings {
  source: Source;
  preset: string;
  recipe: OwnRecipe | null; // a person's own, whole, in the place of the preset's
  seed: number;
  spacing: number | null; // layer.spacing in the mesh's unit; null: the recipe's
  load: number | null; // evolution.max_load; null: the recipe's
  lineColor: number; // of cracks, red · 65536 + green · 256 + blue
  strokes: readonly Stroke[];
  impacts: readonly (readonly [number, number, number])[];
}

export const firstProject: Project = {
  source: { kind: "shape", specification: "cup?n=96" },
  preset: "glaze",
  recipe: null,
  seed: 1,
  spacing: 0.14,
  load: null,
  ...noOpenings,
  lineColor: 0x1b130e,
  strokes: [],
  impacts: [],
};

/** Whether the second cracks otherwise than the first; how cracks are opened does not count. */
export function cracksOtherwise(a: Project, b: Project): boolean {
  return (
    a.source !== b.source ||
    a.preset !== b.preset ||
    a.recipe !== b.recipe ||
    a.seed !== b.seed ||
    a.spacing !== b.spacing ||
    a.load !== b.load ||
    a.strokes !== b.strokes ||
    a.impacts !== b.impacts
  );
}

export function opensOtherwise(a: Project, b: Project): boolean {
  return openingNames.some((name) => a[name] !== b[name]);
}
