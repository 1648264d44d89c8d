// A stroke on the vertices of a surface. Sums and products alone, rounded to single precision, so
// that the same stroke gives the same bits everywhere.
import type { Stroke } from "../project/project";

export interface Canvas {
  positions: Float32Array; // three per vertex
  normals: Float32Array; // three per vertex, of any length
  low: [number, number, number];
  size: [number, number, number]; // of the box
  diagonal: number;
}

export const steps = 65535;

/** The vertices that a stroke changed and what they had before. */
export interface Delta {
  vertices: Uint32Array;
  before: Float32Array;
}

export function canvasOf(positions: Float32Array, triangles: Uint32Array): Canvas {
  const low: Canvas["low"] = [Infinity, Infinity, Infinity];
  const high: Canvas["low"] = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3]!, x);
    high[i % 3] = Math.max(high[i % 3]!, x);
  });
  const size: Canvas["size"] = [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
  const diagonal = Math.sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]);
  return { positions, normals: vertexNormals(positions, triangles), low, size, diagonal };
}

function vertexNormals(p: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(p.length);
  for (let f = 0; f < triangles.length; f += 3) {
    const [a, b, c] = [3 * triangles[f]!, 3 * triangles[f + 1]!, 3 * triangles[f + 2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const at of [a, b, c]) for (let k = 0; k < 3; ++k) normals[at + k]! += normal[k]!;
  }
  return normals;
}

/** Paints on `values`, one per vertex, 0 … 1: full in the middle of a dab, soft to its edge. */
export function applyStroke(canvas: Canvas, stroke: Stroke, values: Float32Array): Delta {
  const changed = new Map<number, number>();
  for (let i = 0; i < stroke.dabs.length; i += 6) {
    const dab = stroke.dabs.slice(i, i + 6);
    applyDab(canvas, stroke, dab, values, changed);
    if (stroke.mirror) {
      const mirrored = [steps - dab[0]!, dab[1]!, dab[2]!, -dab[3]!, dab[4]!, dab[5]!];
      applyDab(canvas, stroke, mirrored, values, changed);
    }
  }
  return {
    vertices: Uint32Array.from(changed.keys()),
    before: Float32Array.from(changed.values()),
  };
}

export function takeBack(delta: Delta, values: Float32Array): void {
  delta.vertices.forEach((vertex, i) => (values[vertex] = delta.before[i]!));
}

function applyDab(
  canvas: Canvas,
  stroke: Stroke,
  dab: number[],
  values: Float32Array,
  changed: Map<number, number>,
): void {
  const { positions, normals, low, size, diagonal } = canvas;
  const x = low[0] + (dab[0]! / steps) * size[0];
  const y = low[1] + (dab[1]! / steps) * size[1];
  const z = low[2] + (dab[2]! / steps) * size[2];
  const radius = (stroke.radius / steps) * diagonal;
  const square = radius * radius;
  const amount = stroke.strength / 100;
  for (let v = 0; v < values.length; ++v) {
    const [dx, dy, dz] = [positions[3 * v]! - x, positions[3 * v + 1]! - y, positions[3 * v + 2]! - z];
    const distance = dx * dx + dy * dy + dz * dz;
    if (distance >= square) continue;
    const facing =
      normals[3 * v]! * dab[3]! + normals[3 * v + 1]! * dab[4]! + normals[3 * v + 2]! * dab[5]!;
    if (facing <= 0) continue; // the other side of a thin wall
    const soft = 1 - distance / square;
    const weight = amount * soft * soft;
    const old = values[v]!;
    if (!changed.has(v)) changed.set(v, old);
    values[v] = stroke.erase ? old - weight * old : old + weight * (1 - old);
  }
}
