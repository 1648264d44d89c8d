// The paint of all layers on the vertices of one surface, kept in step with a list of strokes.
import { layerNames, type LayerName, type Stroke } from "../project/project";
import { applyStroke, takeBack, type Canvas, type Delta } from "./brush";

const longestMemory = 64 * 1024 * 1024; // bytes of deltas

export class Painting {
  private strokes: readonly Stroke[] = [];
  private deltas: (Delta | null)[] = []; // null: no longer remembered
  private remembered = 0; // bytes
  private readonly paint: Record<LayerName, Float32Array>;

  constructor(private readonly canvas: Canvas) {
    const blank = () => new Float32Array(canvas.positions.length / 3);
    this.paint = Object.fromEntries(layerNames.map((name) => [name, blank()])) as typeof this.paint;
  }

  /** One per vertex, 0 … 1. */
  values(layer: LayerName): Float32Array {
    return this.paint[layer];
  }

  /** Paints what the list has more and takes back what it has no longer. */
  follow(strokes: readonly Stroke[]): void {
    let common = 0;
    while (common < strokes.length && strokes[common] === this.strokes[common]) ++common;
    if (this.deltas.slice(common).includes(null)) {
      for (const name of layerNames) this.paint[name].fill(0);
      this.deltas = [];
      this.remembered = 0;
      common = 0;
    }
    for (let i = this.deltas.length - 1; i >= common; --i) {
      const delta = this.deltas[i]!;
      takeBack(delta, this.paint[this.strokes[i]!.layer]);
      this.remembered -= sizeOf(delta);
    }
    this.deltas.length = common;
    for (const stroke of strokes.slice(common)) this.add(stroke);
    this.strokes = strokes;
  }

  private add(stroke: Stroke): void {
    const delta = applyStroke(this.canvas, stroke, this.paint[stroke.layer]);
    this.deltas.push(delta);
    this.remembered += sizeOf(delta);
    for (let i = 0; this.remembered > longestMemory && i < this.deltas.length; ++i) {
      const old = this.deltas[i];
      if (!old) continue;
      this.remembered -= sizeOf(old);
      this.deltas[i] = null;
    }
  }
}

const sizeOf = (delta: Delta) => delta.vertices.byteLength + delta.before.byteLength;
