// The brush in the hand: what holds it, pointer or keys, and where it is shown and told.
import { BrushTool, type BrushEvents } from "./paint/brush_tool";
import { KeyBrush } from "./paint/key_brush";
import { brushByPointer } from "./paint/pointer_brush";
import type { Tool } from "./paint/brush_tool";
import type { Canvas } from "./paint/canvas";
import type { Viewer } from "./scene/viewer";
import { BrushRing } from "./ui/brush_ring";
import { element } from "./ui/elements";
import type { Slider } from "./ui/slider";

export class Brushing {
  private readonly brush: BrushTool;
  private readonly keys: KeyBrush;
  private readonly ring = new BrushRing();
  private readonly says = element("p", { class: "brush-says", "aria-live": "polite" });

  /** `view` holds the canvas. */
  constructor(view: HTMLElement, viewer: Viewer, size: Slider, events: BrushEvents) {
    view.append(this.ring.root, this.says);
    this.brush = new BrushTool(viewer, events);
    brushByPointer(viewer, this.brush, this.ring);
    this.keys = new KeyBrush(viewer, this.brush, this.ring, {
      say: (sentence) => (this.says.textContent = sentence),
      resize: (factor) => size.scale(factor),
    });
  }

  hold(tool: Tool | null): void {
    this.brush.tool = tool;
    this.keys.toolChanged();
  }

  setSurface(canvas: Canvas, triangles: Uint32Array): void {
    this.brush.setSurface(canvas, triangles);
  }
}
