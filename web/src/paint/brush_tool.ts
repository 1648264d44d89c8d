// The brush, or the hammer, on the surface: what the pointer and the keyboard do with it.
import type { LayerName, Stroke } from "../project/project";
import type { Viewer } from "../scene/viewer";
import { steps } from "./brush";
import type { Canvas } from "./canvas";
import { dabOf, Picking, type Hit, type Place } from "./picking";

export type Tool = LayerName | "impact";

export interface BrushSettings {
  size: number; // radius over the diagonal
  strength: number; // 0 … 1
  along: boolean;
  erase: boolean;
  mirror: boolean;
}

export interface BrushEvents {
  settings(): BrushSettings;
  preview(stroke: Stroke): void;
  finish(stroke: Stroke): void;
  drop(): void; // the stroke that was previewed is none
  impact(point: [number, number, number]): void;
}

const impactSize = 0.05; // radius of a blow over the diagonal

export class BrushTool {
  private chosen: Tool | null = null;
  private surface: { canvas: Canvas; picking: Picking } | null = null;
  private stroke: Stroke | null = null;

  constructor(
    private readonly viewer: Viewer,
    private readonly events: BrushEvents,
  ) {}

  get tool(): Tool | null {
    return this.chosen;
  }

  /** Another one ends a stroke. */
  set tool(tool: Tool | null) {
    this.end();
    this.chosen = tool;
  }

  get isDown(): boolean {
    return this.stroke !== null;
  }

  setSurface(canvas: Canvas, triangles: Uint32Array): void {
    this.stroke = null;
    this.surface = { canvas, picking: new Picking(canvas.positions, triangles) };
  }

  /** The surface at a place of the view; null where there is none. */
  at(place: Place): Hit | null {
    return this.surface?.picking.at(place, this.viewer.camera) ?? null;
  }

  /** How large the brush is in pixels of the page, where it hits. */
  radiusAt({ point }: Hit): number {
    const size = this.chosen === "impact" ? impactSize : this.events.settings().size;
    return size * this.surface!.canvas.diagonal * this.viewer.pixelsPerLength(point);
  }

  /** A blow, or the beginning of a stroke; `pressure`: 0 … 1. */
  begin(hit: Hit, pressure: number): void {
    if (!this.chosen || !this.surface) return;
    if (this.chosen === "impact") {
      const [x, y, z] = hit.point.toArray().map((value) => Number(value.toPrecision(5)));
      return this.events.impact([x!, y!, z!]);
    }
    const { size, strength, along, erase, mirror } = this.events.settings();
    this.stroke = {
      kind: "brush",
      layer: this.chosen,
      along: along && this.chosen === "stress",
      radius: Math.round(size * steps),
      strength: Math.max(1, Math.round(100 * strength * pressure)),
      erase,
      mirror,
      dabs: dabOf(hit, this.surface.canvas),
    };
    this.events.preview(this.stroke);
  }

  /** The brush goes on to a place, if it is down. */
  moveTo(hit: Hit): void {
    if (!this.stroke || !this.surface) return;
    const dab = dabOf(hit, this.surface.canvas);
    if (this.fromLast(dab) < this.stroke.radius / 3) return;
    this.stroke = { ...this.stroke, dabs: [...this.stroke.dabs, ...dab] };
    this.events.preview(this.stroke);
  }

  end(): void {
    const { stroke } = this;
    this.stroke = null;
    if (stroke) this.events.finish(stroke);
  }

  /** Ends it as if it had not been. */
  drop(): void {
    if (!this.stroke) return;
    this.stroke = null;
    this.events.drop();
  }

  /** In 1/65535 of the diagonal. */
  private fromLast(dab: number[]): number {
    const { size, diagonal } = this.surface!.canvas;
    const last = this.stroke!.dabs.slice(-6);
    return Math.hypot(...size.map((s, k) => ((dab[k]! - last[k]!) * s) / diagonal));
  }
}
