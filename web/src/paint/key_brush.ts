// The brush by keys: arrows move it over the view, Space puts it down and takes it up.
import type { Viewer } from "../scene/viewer";
import type { BrushRing } from "../ui/brush_ring";
import type { BrushTool } from "./brush_tool";
import type { Place } from "./picking";

const step = 24; // pixels of the page
const fineStep = 4;
const between = 4; // pixels, of a stroke that is drawn

const ways: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export interface KeyBrushEvents {
  say(sentence: string): void; // what the brush does, for those who do not see it
  resize(factor: number): number; // returns the brush's new size, over the diagonal
}

export class KeyBrush {
  private place: Place = { x: 0.5, y: 0.5 };
  private readonly canvas: HTMLCanvasElement;

  constructor(
    viewer: Viewer,
    private readonly brush: BrushTool,
    private readonly ring: BrushRing,
    private readonly events: KeyBrushEvents,
  ) {
    this.canvas = viewer.canvas;
    this.canvas.addEventListener("keydown", (event) => this.key(event), { capture: true });
    this.canvas.addEventListener("focus", () => this.focused());
    this.canvas.addEventListener("blur", () => {
      this.brush.end();
      this.ring.hide();
      this.events.say("");
    });
  }

  /** Another tool is in the hand. */
  toolChanged(): void {
    this.ring.hide();
    this.events.say("");
  }

  private focused(): void {
    if (!this.brush.tool || !this.canvas.matches(":focus-visible")) return;
    this.show();
    this.events.say(`${this.where()} Arrow keys move it, Space ${this.does()}.`);
  }

  private key(event: KeyboardEvent): void {
    if (!this.brush.tool || event.ctrlKey || event.metaKey || event.altKey) return;
    const way = ways[event.key];
    if (way) this.go(way, event.shiftKey ? fineStep : step);
    else if (event.key === " " || event.key === "Enter") this.press(event.repeat);
    else if (event.key === "Escape" && this.brush.isDown) this.drop();
    else if (event.key === "[" || event.key === ",") this.resize(1 / 1.25);
    else if (event.key === "]" || event.key === ".") this.resize(1.25);
    else return;
    event.preventDefault();
    event.stopImmediatePropagation(); // the camera stays
  }

  private go([right, down]: readonly [number, number], pixels: number): void {
    const { clientWidth, clientHeight } = this.canvas;
    const before = this.place;
    const inside = (x: number) => Math.min(Math.max(x, 0), 1);
    const x = inside(before.x + (right * pixels) / clientWidth);
    const y = inside(before.y + (down * pixels) / clientHeight);
    const parts = this.brush.isDown ? Math.ceil(pixels / between) : 1;
    for (let i = 1; i <= parts; ++i) {
      const t = i / parts;
      this.place = { x: before.x + t * (x - before.x), y: before.y + t * (y - before.y) };
      const hit = this.brush.at(this.place);
      if (hit) this.brush.moveTo(hit);
    }
    this.show();
    this.events.say(this.where());
  }

  private press(repeated: boolean): void {
    if (repeated) return; // a key that is held does it once
    if (this.brush.isDown) {
      this.brush.end();
      this.show();
      return this.events.say("Brush up. The stroke is painted.");
    }
    const hit = this.brush.at(this.place);
    if (!hit) return this.events.say(this.where());
    this.brush.begin(hit, 1);
    this.show();
    if (this.brush.isDown) this.events.say(this.where());
    else this.events.say("A blow fell here.");
  }

  private drop(): void {
    this.brush.drop();
    this.show();
    this.events.say("Brush up. The stroke is taken back.");
  }

  private resize(factor: number): void {
    const size = this.events.resize(factor);
    this.show();
    this.events.say(`Brush size ${size}.`);
  }

  private show(): void {
    const hit = this.brush.at(this.place);
    this.ring.show(this.place, hit && this.brush.radiusAt(hit), this.brush.isDown);
  }

  private does(): string {
    return this.brush.tool === "impact" ? "strikes" : "puts it down";
  }

  private where(): string {
    const percent = (x: number) => `${Math.round(100 * x)} %`;
    const place = `${percent(this.place.x)} from the left, ${percent(this.place.y)} from the top`;
    const thing = this.brush.tool === "impact" ? "Hammer" : "Brush";
    const state = this.brush.isDown ? `${thing} down` : thing;
    const off = this.brush.at(this.place) ? "" : ", off the surface";
    return `${state}: ${place}${off}.`;
  }
}
