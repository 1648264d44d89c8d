// The controls of what is seen. None of them changes the project.
import { button, checkbox, combobox, element } from "./elements";
import { heatGradient } from "../scene/heat_colors";
import { Slider, rounded } from "./slider";

export const views = ["Surface", "Fragments", "Age of cracks", "Stress", "Separation ς"] as const;
export type View = (typeof views)[number];

export interface SeeActions {
  view(view: View): void;
  wireframe(shown: boolean): void;
  directions(shown: boolean): void;
  lineColor(color: number, chosen: boolean): void; // or looked at, while one is chosen
  compare(): void;
  stopComparing(): void;
  divide(at: number): void;
  loop(): void;
}

export class SeePanel {
  readonly root: HTMLElement;
  readonly view;
  private readonly directions;
  private readonly legend = element("p", { class: "legend", hidden: "" });
  private readonly color = element("input", { type: "color" });
  private readonly divide: Slider;
  private readonly compare: HTMLButtonElement;
  private readonly stop: HTMLButtonElement;

  constructor(actions: SeeActions) {
    const choices = views.map((value) => ({ value, label: value }));
    this.view = combobox("Show", choices, (view) => actions.view(view as View));
    this.directions = checkbox("Principal directions", actions.directions);
    this.directions.input.checked = true;
    for (const kind of ["input", "change"] as const) {
      const value = () => Number.parseInt(this.color.value.slice(1), 16);
      this.color.addEventListener(kind, () => actions.lineColor(value(), kind === "change"));
    }
    this.divide = new Slider({
      name: "Divide",
      low: 0,
      high: 1,
      help: "where the kept result ends and the present one begins",
      preview: actions.divide,
      set: actions.divide,
    });
    this.divide.show(0.5);
    this.compare = button("Compare", actions.compare, {
      title: "Keep this result at the left, and see what comes next at the right",
    });
    this.stop = button("Stop comparing", actions.stopComparing);
    this.root = element(
      "section",
      {},
      element("h2", {}, "See"),
      this.view.row,
      this.legend,
      this.directions.row,
      checkbox("Wireframe", actions.wireframe).row,
      element("label", { class: "row" }, element("span", {}, "Line colour"), this.color),
      this.divide.row,
      element(
        "div",
        { class: "buttons" },
        this.compare,
        this.stop,
        button("How it cracks", actions.loop),
      ),
    );
    this.showComparing(false);
    this.showScale(null);
  }

  /** What the colours of a heat map mean, up to `end`; null: there is none. */
  showScale(scale: { end: number; unit: string } | null): void {
    this.legend.hidden = this.directions.row.hidden = scale === null;
    if (!scale) return;
    const bar = element("span", { class: "scale", "aria-hidden": "true" });
    bar.style.background = heatGradient;
    this.legend.replaceChildren("0", bar, `${rounded(scale.end)} ${scale.unit}`);
  }

  showLineColor(color: number): void {
    this.color.value = `#${color.toString(16).padStart(6, "0")}`;
  }

  showComparing(comparing: boolean): void {
    this.divide.row.hidden = this.stop.hidden = !comparing;
    if (!comparing) this.divide.show(0.5);
  }
}
