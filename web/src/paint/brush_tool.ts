// The pointer on the canvas as a brush, or as a hammer. The camera turns where it misses.
import type { LayerName, Stroke } from "../project/project";
import type { Viewer } from "../scene/viewer";
import { steps } from "./brush";
import type { Canvas } from "./canvas";
import { dabOf, Picking } from "./picking";

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
  impact(point: [number, number, number]): void;
}

export class BrushTool {
  tool: LayerName | "impact" | null = null;
  private surface: { canvas: Canvas; picking: Picking } | null = null;
  private stroke: Stroke | null = null;

  constructor(
    private readonly viewer: Viewer,
    private readonly events: BrushEvents,
  ) {
    const { canvas } = viewer;
    canvas.addEventListener("pointerdown", (event) => this.down(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.move(event), { capture: true });
    for (const end of ["pointerup", "pointercancel"] as const) {
      canvas.addEventListener(end, () => this.up(), { capture: true });
    }
  }

  setSurface(canvas: Canvas, triangles: Uint32Array): void {
    this.surface = { canvas, picking: new Picking(canvas.positions, triangles) };
  }

  private down(event: PointerEvent): void {
    if (!this.tool || !this.surface || event.button !== 0) return;
    const hit = this.surface.picking.at(event, this.viewer.camera);
    if (!hit) return;
    this.viewer.controls.enabled = false;
    if (this.tool === "impact") {
      const [x, y, z] = hit.point.toArray().map((value) => Number(value.toPrecision(5)));
      this.events.impact([x!, y!, z!]);
      this.viewer.controls.enabled = true;
      return;
    }
    const { size, strength, along, erase, mirror } = this.events.settings();
    // A pen presses; a mouse and a finger say 0.5 or 0.
    const pressure = event.pointerType === "pen" ? event.pressure : 1;
    this.stroke = {
      kind: "brush",
      layer: this.tool,
      along: along && this.tool === "stress",
      radius: Math.round(size * steps),
      strength: Math.max(1, Math.round(100 * strength * pressure)),
      erase,
      mirror,
      dabs: dabOf(hit, this.surface.canvas),
    };
    this.viewer.canvas.setPointerCapture(event.pointerId);
    this.events.preview(this.stroke);
  }

  private move(event: PointerEvent): void {
    if (!this.stroke || !this.surface) return;
    const hit = this.surface.picking.at(event, this.viewer.camera);
    if (!hit) return;
    const dab = dabOf(hit, this.surface.canvas);
    if (this.fromLast(dab) < this.stroke.radius / 3) return;
    this.stroke = { ...this.stroke, dabs: [...this.stroke.dabs, ...dab] };
    this.events.preview(this.stroke);
  }

  private up(): void {
    this.viewer.controls.enabled = true;
    const { stroke } = this;
    this.stroke = null;
    if (stroke) this.events.finish(stroke);
  }

  /** In 1/65535 of the diagonal. */
  private fromLast(dab: number[]): number {
    const { size, diagonal } = this.surface!.canvas;
    const last = this.stroke!.dabs.slice(-6);
    return Math.hypot(...size.map((s, k) => ((dab[k]! - last[k]!) * s) / diagonal));
  }
}
