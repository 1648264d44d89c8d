// A stroke on the vertices of a surface. Sums, products and roots alone, rounded to single
// precision, so that the same stroke gives the same bits everywhere.
import type { Stroke } from "../project/project";
import type { Canvas } from "./canvas";

export const steps = 65535;

/** What a stroke paints with at a vertex: `values`, `columns` of them per vertex, go towards
 * `target` by a weight. */
export interface Ink {
  values: Float32Array;
  columns: number;
}

/** The vertices that a stroke changed and what they had before, row by row; null: all of them. */
export interface Delta {
  ink: Ink;
  vertices: Uint32Array | null;
  before: Float32Array;
}

/** Masks of the file, by name, one number per vertex. */
export type Masks = ReadonlyMap<string, Float32Array>;

/** Where a brush came down, in the units of the surface. */
interface Dab {
  at: readonly [number, number, number];
  normal: readonly [number, number, number];
  target: readonly number[]; // one per column
}

/** Paints: full in the middle of a dab, soft to its edge. Dabs before `first` are painted already.
 * A mask of the file that is not there leaves all as it is. */
export function applyStroke(
  canvas: Canvas,
  stroke: Stroke,
  ink: Ink,
  masks: Masks,
  first = 0,
): Delta {
  if (stroke.kind !== "brush") {
    const before = ink.values.slice();
    applyEverywhere(stroke, ink, masks);
    return { ink, vertices: null, before };
  }
  const changed = new Map<number, Float32Array>();
  const keep = (v: number) => {
    if (!changed.has(v)) changed.set(v, ink.values.slice(ink.columns * v, ink.columns * (v + 1)));
  };
  for (const dab of dabsOf(canvas, stroke, ink, first)) applyDab(canvas, stroke, dab, ink, keep);
  const before = new Float32Array(ink.columns * changed.size);
  [...changed.values()].forEach((row, i) => before.set(row, ink.columns * i));
  return { ink, vertices: Uint32Array.from(changed.keys()), before };
}

export function takeBack({ ink, vertices, before }: Delta): void {
  const { values, columns } = ink;
  if (!vertices) return values.set(before);
  vertices.forEach((vertex, i) =>
    values.set(before.subarray(columns * i, columns * (i + 1)), columns * vertex),
  );
}

function applyEverywhere(stroke: Stroke, { values }: Ink, masks: Masks): void {
  if (stroke.kind === "file") {
    const mask = masks.get(stroke.from!);
    if (mask) values.set(mask);
    return;
  }
  const amount = stroke.strength / 100;
  const target = stroke.erase ? 0 : 1;
  for (let v = 0; v < values.length; ++v) {
    const old = values[v]!;
    values[v] = stroke.kind === "invert" ? 1 - old : old + amount * (target - old);
  }
}

function dabsOf({ low, size }: Canvas, stroke: Stroke, ink: Ink, first: number): Dab[] {
  const dabs: Dab[] = [];
  let last: Dab["at"] | null = null;
  for (let i = 0; i < stroke.dabs.length; i += 6) {
    const n = stroke.dabs.slice(i, i + 6);
    const place = (k: number) => low[k]! + (n[k]! / steps) * size[k]!;
    const at = [place(0), place(1), place(2)] as const;
    const normal = [n[3]!, n[4]!, n[5]!] as const;
    const target = stroke.erase ? Array(ink.columns).fill(0) : targetOf(ink, last, at);
    last = at;
    if (!target || i < 6 * first) continue;
    dabs.push({ at, normal, target });
    if (!stroke.mirror) continue;
    const mirrored = [low[0] + size[0] - (at[0] - low[0]), at[1], at[2]] as const;
    dabs.push({
      at: mirrored,
      normal: [-normal[0], normal[1], normal[2]],
      // xy and zx change their sign.
      target: target.map((x, k) => (k === 3 || k === 5 ? -x : x)),
    });
  }
  return dabs;
}

/** 1; or the tensor t tᵀ of the way from the last dab to this one, null where there is none. */
function targetOf(ink: Ink, last: Dab["at"] | null, at: Dab["at"]): number[] | null {
  if (ink.columns === 1) return [1];
  if (!last) return null;
  const [x, y, z] = [at[0] - last[0], at[1] - last[1], at[2] - last[2]];
  const square = x * x + y * y + z * z;
  if (square === 0) return null;
  return [x * x, y * y, z * z, x * y, y * z, z * x].map((product) => product / square);
}

function applyDab(
  { positions, normals, diagonal }: Canvas,
  stroke: Stroke,
  { at, normal, target }: Dab,
  { values, columns }: Ink,
  keep: (v: number) => void,
): void {
  const radius = (stroke.radius / steps) * diagonal;
  const square = radius * radius;
  const amount = stroke.strength / 100;
  for (let v = 0; v < positions.length / 3; ++v) {
    const dx = positions[3 * v]! - at[0];
    const dy = positions[3 * v + 1]! - at[1];
    const dz = positions[3 * v + 2]! - at[2];
    const distance = dx * dx + dy * dy + dz * dz;
    if (distance >= square) continue;
    const facing =
      normals[3 * v]! * normal[0] + normals[3 * v + 1]! * normal[1] + normals[3 * v + 2]! * normal[2];
    if (facing <= 0) continue; // the other side of a thin wall
    const soft = 1 - distance / square;
    const weight = amount * soft * soft;
    keep(v);
    for (let k = columns * v; k < columns * (v + 1); ++k) {
      values[k] = values[k]! + weight * (target[k - columns * v]! - values[k]!);
    }
  }
}
