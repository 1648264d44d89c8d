// The pointer on the canvas as a brush. The camera turns where it misses the surface.
import type { Viewer } from "../scene/viewer";
import type { BrushRing } from "../ui/brush_ring";
import type { BrushTool } from "./brush_tool";
import type { Place } from "./picking";

/** Where a pointer is on what it points at. */
function placeOf(event: PointerEvent): Place {
  const box = (event.target as HTMLElement).getBoundingClientRect();
  return {
    x: (event.clientX - box.left) / box.width,
    y: (event.clientY - box.top) / box.height,
  };
}

export function brushByPointer(viewer: Viewer, brush: BrushTool, ring: BrushRing): void {
  const { canvas } = viewer;
  let drawing: number | null = null; // the pointer that does
  const down = (event: PointerEvent) => {
    if (!brush.tool || event.button !== 0 || drawing !== null) return;
    const hit = brush.at(placeOf(event));
    if (!hit) return;
    viewer.controls.enabled = false;
    // A pen presses; a mouse and a finger say 0.5 or 0.
    brush.begin(hit, event.pointerType === "pen" ? event.pressure : 1);
    if (!brush.isDown) return void (viewer.controls.enabled = true);
    drawing = event.pointerId;
    canvas.setPointerCapture(drawing);
  };
  const move = (event: PointerEvent) => {
    if (!brush.tool || (drawing !== null && event.pointerId !== drawing)) return;
    const place = placeOf(event);
    const hit = brush.at(place);
    if (event.pointerType !== "touch") ring.show(place, hit && brush.radiusAt(hit), brush.isDown);
    if (hit && drawing !== null) brush.moveTo(hit);
  };
  const up = (event: PointerEvent) => {
    if (event.pointerId !== drawing) return;
    drawing = null;
    viewer.controls.enabled = true;
    brush.end();
  };
  canvas.addEventListener("pointerdown", down, { capture: true });
  canvas.addEventListener("pointermove", move, { capture: true });
  for (const end of ["pointerup", "pointercancel"] as const) {
    canvas.addEventListener(end, up, { capture: true });
  }
  canvas.addEventListener("pointerleave", () => ring.hide());
}
