// The paint of all layers on the vertices of one surface, kept in step with a list of strokes.
import { layerNames, type LayerName, type Stroke } from "../project/project";
import { applyStroke, takeBack, type Delta, type Ink } from "./brush";
import type { Canvas } from "./canvas";

const longestMemory = 64 * 1024 * 1024; // bytes of deltas

export class Painting {
  private strokes: readonly Stroke[] = [];
  private deltas: (Delta[] | null)[] = []; // of each stroke; null: no longer remembered
  private remembered = 0; // bytes
  private readonly paint: Record<LayerName, Ink>;
  private readonly directed: Ink; // stress that has a direction

  constructor(private readonly canvas: Canvas) {
    const blank = (columns: number): Ink => {
      return { values: new Float32Array((columns * canvas.positions.length) / 3), columns };
    };
    this.paint = Object.fromEntries(layerNames.map((name) => [name, blank(1)])) as typeof this.paint;
    this.directed = blank(6);
  }

  /** One per vertex, 0 … 1. */
  values(layer: LayerName): Float32Array {
    return this.paint[layer].values;
  }

  /** The same as it is looked at: of stress, with and without a direction. */
  seen(layer: LayerName): Float32Array {
    if (layer !== "stress") return this.values(layer);
    const t = this.tension;
    return this.values(layer).map((p, v) => p + t[6 * v]! + t[6 * v + 1]! + t[6 * v + 2]!);
  }

  /** Six per vertex, xx yy zz xy yz zx: tension along strokes, its trace 0 … 1. */
  get tension(): Float32Array {
    return this.directed.values;
  }

  /** Paints what the list has more and takes back what it has no longer. */
  follow(strokes: readonly Stroke[]): void {
    let common = 0;
    while (common < strokes.length && strokes[common] === this.strokes[common]) ++common;
    if (this.deltas.slice(common).includes(null)) {
      for (const ink of [...Object.values(this.paint), this.directed]) ink.values.fill(0);
      this.deltas = [];
      this.remembered = 0;
      common = 0;
    }
    for (const deltas of this.deltas.splice(common).reverse()) {
      deltas!.forEach(takeBack);
      this.remembered -= sizeOf(deltas!);
    }
    for (const stroke of strokes.slice(common)) this.add(stroke);
    this.strokes = strokes;
  }

  private inksOf({ kind, layer, along, erase }: Stroke): Ink[] {
    if (layer !== "stress" || kind === "invert") return [this.paint[layer]];
    if (erase) return [this.paint.stress, this.directed];
    return [along && kind === "brush" ? this.directed : this.paint.stress];
  }

  private add(stroke: Stroke): void {
    const deltas = this.inksOf(stroke).map((ink) => applyStroke(this.canvas, stroke, ink));
    this.deltas.push(deltas);
    this.remembered += sizeOf(deltas);
    for (let i = 0; this.remembered > longestMemory && i < this.deltas.length; ++i) {
      const old = this.deltas[i];
      if (!old) continue;
      this.remembered -= sizeOf(old);
      this.deltas[i] = null;
    }
  }
}

const sizeOf = (deltas: Delta[]) =>
  deltas.reduce((sum, { vertices, before }) => sum + vertices.byteLength + before.byteLength, 0);
