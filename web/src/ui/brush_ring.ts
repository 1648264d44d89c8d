// Where the brush is, over the picture: moving it draws nothing anew.
import type { Place } from "../paint/picking";
import { element } from "./elements";

const offSurface = 6; // pixels: radius where there is nothing to paint on

export class BrushRing {
  readonly root = element("div", { class: "ring", "aria-hidden": "true", hidden: "" });

  /** `radius` in pixels, null off the surface. */
  show({ x, y }: Place, radius: number | null, down: boolean): void {
    const { style, classList } = this.root;
    this.root.hidden = false;
    style.left = `${100 * x}%`;
    style.top = `${100 * y}%`;
    style.width = style.height = `${2 * (radius ?? offSurface)}px`;
    classList.toggle("off", radius === null);
    classList.toggle("down", down);
  }

  hide(): void {
    this.root.hidden = true;
  }
}
