// The paint of all layers on the vertices of one surface, kept in step with a list of strokes.
import { layerNames, type LayerName, type Stroke } from "../project/project";
import { applyStroke, takeBack, type Delta, type Ink } from "./brush";
import type { Canvas } from "./canvas";

const longestMemory = 64 * 1024 * 1024; // bytes of deltas

export class Painting {
  private strokes: readonly Stroke[] = [];
  private deltas: (Delta[] | null)[] = []; // of each stroke; null: no longer remembered
  private remembered = 0; // bytes
  private readonly masks = new Map<string, Float32Array>(); // of the file
  private readonly paint: Record<LayerName, Ink>;
  private readonly directed: Ink; // stress that has a direction

  constructor(private readonly canvas: Canvas) {
    const blank = (columns: number): Ink => {
      return { values: new Float32Array((columns * canvas.positions.length) / 3), columns };
    };
    this.paint = Object.fromEntries(layerNames.map((name) => [name, blank(1)])) as typeof this.paint;
    this.directed = blank(6);
  }

  /** Bytes that are remembered to take strokes back. */
  get memory(): number {
    return this.remembered;
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

  /** Makes a mask of the file known, one number per vertex. */
  provide(name: string, mask: Float32Array): void {
    this.masks.set(name, mask);
  }

  /** The masks that the strokes are of and that are not known. */
  missing(strokes: readonly Stroke[]): string[] {
    const names = strokes.filter(({ kind }) => kind === "file").map(({ from }) => from!);
    return [...new Set(names)].filter((name) => !this.masks.has(name));
  }

  /** Paints what the list has more and takes back what it has no longer. */
  follow(strokes: readonly Stroke[]): void {
    let common = 0;
    while (common < strokes.length && strokes[common] === this.strokes[common]) ++common;
    if (this.grow(strokes, common)) return;
    if (this.deltas.slice(common).includes(null)) {
      for (const ink of [...Object.values(this.paint), this.directed]) ink.values.fill(0);
      this.deltas = [];
      this.remembered = 0;
      common = 0;
    }
    for (const deltas of this.deltas.splice(common).reverse()) {
      deltas!.reverse().forEach(takeBack);
      this.remembered -= sizeOf(deltas!);
    }
    for (const stroke of strokes.slice(common)) this.add(stroke);
    this.strokes = strokes;
  }

  /** A stroke that goes on: what it has more is painted, and nothing again. */
  private grow(strokes: readonly Stroke[], common: number): boolean {
    const [before, now, deltas] = [this.strokes[common], strokes[common], this.deltas[common]];
    if (!before || !now || !deltas || !goesOn(before, now)) return false;
    if (this.strokes.length !== common + 1 || strokes.length !== common + 1) return false;
    const more = this.painted(now, before.dabs.length / 6);
    deltas.push(...more);
    this.remembered += sizeOf(more);
    this.strokes = strokes;
    return true;
  }

  private inksOf({ kind, layer, along, erase }: Stroke): Ink[] {
    if (layer !== "stress" || kind === "invert" || kind === "file") return [this.paint[layer]];
    if (erase) return [this.paint.stress, this.directed];
    return [along && kind === "brush" ? this.directed : this.paint.stress];
  }

  private painted(stroke: Stroke, first: number): Delta[] {
    const { canvas, masks } = this;
    return this.inksOf(stroke).map((ink) => applyStroke(canvas, stroke, ink, masks, first));
  }

  private add(stroke: Stroke): void {
    const deltas = this.painted(stroke, 0);
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

/** Whether the second is the first with more dabs. */
function goesOn({ dabs: first, ...before }: Stroke, { dabs, ...now }: Stroke): boolean {
  const same = JSON.stringify(before) === JSON.stringify(now);
  return same && dabs.length >= first.length && first.every((number, i) => number === dabs[i]);
}

const sizeOf = (deltas: Delta[]) =>
  deltas.reduce((sum, { vertices, before }) => sum + (vertices?.byteLength ?? 0) + before.byteLength, 0);
