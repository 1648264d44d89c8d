// A slider with its name and its value. Dragging previews, letting go sets: one step to undo.
import { element } from "./elements";

export interface SliderOptions {
  name: string;
  low: number;
  high: number;
  help?: string;
  preview?: (value: number) => void;
  set: (value: number) => void;
}

const parts = 200; // steps of a slider

/** Three digits: what is shown is what is used. */
export const rounded = (value: number) => Number(value.toPrecision(3));

export class Slider {
  readonly row: HTMLLabelElement;
  private readonly input = element("input", { type: "range", min: "0", max: String(parts) });
  private readonly output = element("output");
  private low: number;
  private high: number;

  constructor(options: SliderOptions) {
    this.low = options.low;
    this.high = options.high;
    this.input.setAttribute("aria-label", options.name);
    if (options.help) this.input.title = options.help;
    const name = element("span", {}, options.name);
    this.row = element("label", { class: "row slider" }, name, this.input, this.output);
    this.input.addEventListener("input", () => {
      this.tell(this.value);
      options.preview?.(this.value);
    });
    this.input.addEventListener("change", () => options.set(this.value));
  }

  get value(): number {
    return rounded(this.low + (this.input.valueAsNumber / parts) * (this.high - this.low));
  }

  range(low: number, high: number): void {
    [this.low, this.high] = [low, high];
  }

  /** Shows a value; one beyond the range widens it. */
  show(value: number): void {
    this.low = Math.min(this.low, value);
    this.high = Math.max(this.high, value);
    const part = this.high > this.low ? (value - this.low) / (this.high - this.low) : 0;
    this.input.value = String(Math.round(part * parts));
    this.tell(value);
  }

  private tell(value: number): void {
    this.output.textContent = String(rounded(value));
    this.input.setAttribute("aria-valuetext", String(rounded(value)));
  }
}
