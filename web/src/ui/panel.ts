// The controls and what each of them changes.
import { baseRecipe } from "../project/base_recipe";
import type { Project } from "../project/project";
import { ofPreset } from "../project/recipe";
import { parameter, presetTable } from "../project/tables";
import { button, checkbox, combobox, element, radioGroup, type Choice } from "./elements";
import { MaskRow } from "./mask_row";
import { OpeningSliders } from "./opening_sliders";
import { pictureOf } from "./preset_pictures";
import { Slider } from "./slider";

export const paints = ["None", "Stress", "Strength", "Spacing", "Mask", "Impact"] as const;
export type Paint = (typeof paints)[number];

export interface Actions {
  open(): void;
  crack(): void;
  cancel(): void;
  undo(): void;
  redo(): void;
  exportFile(format: string): void;
  copyCommand(): void;
  copyLink(): void;
  newSeed(): void;
  saveProject(): void;
  play(): void;
  change(change: Partial<Project>): void;
  growth(time: number): void;
  paint(paint: Paint): void;
  fill(): void;
  invert(): void;
  takeMask(name: string): void;
  keys(): void;
}

const shapes: Choice[] = [
  { value: "cup?n=96", label: "Cup" },
  { value: "bowl", label: "Bowl" },
  { value: "plate?n=60&jitter=0.3", label: "Plate" },
  { value: "sphere", label: "Sphere" },
  { value: "torus", label: "Torus" },
  { value: "bumps", label: "Bumps" },
];

const formats: Choice[] = [
  { value: "ply", label: "PLY" },
  { value: "obj", label: "OBJ" },
  { value: "glb", label: "GLB" },
  { value: "stl", label: "STL" },
  { value: "usda", label: "USDA" },
  { value: "svg", label: "Lines (SVG)" },
  { value: "maps.zip", label: "Maps (ZIP of PNG)" },
  { value: "toml", label: "Recipe (TOML)" },
  { value: "png", label: "Picture (PNG)" },
  { value: "webm", label: "Film (WebM)" },
  { value: "painted.ply", label: "Painted input (PLY)" },
];

export class Panel {
  readonly root = element("div", { class: "panel" });
  private readonly presets;
  private readonly paintGroup;
  private readonly shape;
  readonly spacing;
  readonly load;
  private readonly opening;
  readonly growth;
  readonly brushSize;
  readonly brushStrength;
  readonly along = checkbox("Along the stroke", () => {});
  readonly erase = checkbox("Erase", () => {});
  readonly mirror = checkbox("Mirror in x", () => {});
  readonly masks: MaskRow;
  private readonly cancelButton;
  private readonly fillButton;
  private readonly invertButton;
  private readonly undoButton;
  private readonly redoButton;
  private readonly status = element("p", { role: "status", "aria-label": "Progress" });
  private readonly bar = element("progress", { "aria-hidden": "true", max: "1", value: "0" });
  private readonly error = element("p", { role: "alert", class: "error" });

  /** `more`: sections that have panels of their own. */
  constructor(actions: Actions, more: { see: HTMLElement; statistics: HTMLElement }) {
    const slider = (name: string, key: keyof Project & string, of: string, high: number) =>
      new Slider({
        name,
        low: parameter(of).minimum ?? 0,
        high,
        help: parameter(of).help,
        set: (value) => actions.change({ [key]: value }),
      });
    const choices = Object.entries(presetTable).map(([value, { description }]) => ({
      value,
      label: value,
      help: description,
      picture: pictureOf(value),
    }));
    this.presets = radioGroup("Preset", choices, (preset) =>
      actions.change(ofPreset(preset)),
    );
    this.shape = combobox("Shape", shapes, (specification) =>
      actions.change({ source: { kind: "shape", specification }, strokes: [], impacts: [] }),
    );
    this.spacing = slider("Spacing", "spacing", "layer.spacing", 1);
    this.load = slider("Load", "load", "evolution.max_load", 8);
    this.opening = new OpeningSliders((change) => actions.change(change));
    this.growth = new Slider({
      name: "Growth",
      low: 0,
      high: 1,
      help: "how far the cracks have grown",
      preview: actions.growth,
      set: actions.growth,
    });
    const tool = (name: string, low: number, high: number, value: number) => {
      const made = new Slider({ name, low, high, set: () => {} });
      made.show(value);
      return made;
    };
    this.brushSize = tool("Brush size", 0.01, 0.5, 0.12);
    this.brushStrength = tool("Brush strength", 0.01, 1, 0.5);
    this.paintGroup = radioGroup(
      "Paint",
      paints.map((value) => ({ value, label: value })),
      (paint) => {
        this.showBrush(paint as Paint);
        actions.paint(paint as Paint);
      },
    );
    this.masks = new MaskRow(actions.takeMask);
    this.along.row.title = "Stress pulls in the direction in which the brush goes";
    this.fillButton = button("Fill", actions.fill);
    this.invertButton = button("Invert", actions.invert);
    this.cancelButton = button("Cancel", actions.cancel);
    this.undoButton = button("Undo", actions.undo, { "aria-keyshortcuts": "Control+Z" });
    this.redoButton = button("Redo", actions.redo, { "aria-keyshortcuts": "Control+Shift+Z" });
    const format = combobox("Export format", formats, () => {});
    const row = (...children: Node[]) => element("div", { class: "buttons" }, ...children);
    const group = (title: string, ...children: Node[]) =>
      element("section", {}, element("h2", {}, title), ...children);
    this.root.append(
      row(
        button("Open", actions.open),
        this.undoButton,
        this.redoButton,
        button("Keys", actions.keys, { "aria-keyshortcuts": "?" }),
      ),
      this.shape.row,
      this.presets.group,
      row(
        button("Crack", actions.crack, { class: "main" }),
        this.cancelButton,
        button("New seed", actions.newSeed),
      ),
      this.status,
      this.bar,
      this.error,
      group("Cracks", this.spacing.row, this.load.row),
      group("Opening", ...this.opening.rows),
      group("Growth", this.growth.row, row(button("Play", actions.play))),
      this.paintGroup.group,
      group(
        "Brush",
        this.brushSize.row,
        this.brushStrength.row,
        this.along.row,
        this.erase.row,
        this.mirror.row,
        row(this.fillButton, this.invertButton),
        this.masks.root,
      ),
      more.see,
      more.statistics,
      group(
        "Keep",
        format.row,
        row(
          button("Export", () => actions.exportFile(format.select.value)),
          button("Save project", actions.saveProject),
          button("Copy command", actions.copyCommand),
          button("Copy link", actions.copyLink),
        ),
      ),
    );
    this.paintGroup.show("None");
    this.showBrush("None");
  }

  private showBrush(paint: Paint): void {
    this.along.input.disabled = paint !== "Stress";
    const paints = paint !== "None" && paint !== "Impact";
    this.fillButton.disabled = this.invertButton.disabled = !paints;
    this.masks.enable(paints);
  }

  /** `diagonal`: of the input, which lengths go by; `spacing`: what holds where none is set. */
  show(project: Project, diagonal: number, canUndo: boolean, canRedo: boolean): void {
    const recipe = baseRecipe(project);
    this.presets.show(project.recipe ? "" : project.preset);
    if (project.source.kind === "shape") this.shape.select.value = project.source.specification;
    else this.shape.select.selectedIndex = -1;
    this.spacing.range(0.015 * diagonal, 0.3 * diagonal);
    const { spacing, relative_spacing: part } = recipe.layer;
    this.spacing.show(project.spacing ?? (spacing || (part || 0.06) * diagonal));
    this.load.range(0, 8);
    this.load.show(project.load ?? recipe.evolution.max_load);
    this.opening.show(project, diagonal);
    this.undoButton.disabled = !canUndo;
    this.redoButton.disabled = !canRedo;
  }

  /** One sentence; `fraction` is null where no end is known, and without it nothing is at work. */
  tell(sentence: string, fraction?: number | null): void {
    this.status.textContent = sentence;
    this.cancelButton.disabled = fraction === undefined;
    this.bar.classList.toggle("idle", fraction === undefined);
    if (fraction == null) this.bar.removeAttribute("value");
    else this.bar.value = fraction;
  }

  complain(sentence: string): void {
    this.error.textContent = sentence;
  }
}
