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

  /** Makes the value so many times as large, within the range; returns it. */
  scale(factor: number): number {
    this.show(Math.min(Math.max(this.value * factor, this.low), this.high));
    return this.value;
  }

  range(low: number, high: number): void {
    [this.low, this.high] = [low, high];
  }

  set disabled(disabled: boolean) {
    this.input.disabled = disabled;
  }

  /** Shows a value; one beyond the range widens it. A text, which is no number here, is told. */
  show(value: number | string): void {
    if (typeof value === "string") {
      this.input.value = "0";
      return this.tell(value);
    }
    this.low = Math.min(this.low, value);
    this.high = Math.max(this.high, value);
    const part = this.high > this.low ? (value - this.low) / (this.high - this.low) : 0;
    this.input.value = String(Math.round(part * parts));
    this.tell(value);
  }

  private tell(value: number | string): void {
    const text = typeof value === "string" ? value : String(rounded(value));
    this.output.textContent = text;
    this.input.setAttribute("aria-valuetext", text);
  }
}
