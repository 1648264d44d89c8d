// Masks that the file brings: its colours, numbers and textures, to begin a paint with.
import { button, combobox, element } from "./elements";

const colors: Record<string, string> = { r: "red", g: "green", b: "blue", a: "alpha" };

/** What a person reads for the engine's name. */
function labelOf(name: string): string {
  const [, thing, channel] = /^(color|texture)(?:[_:]([rgba]))?$/.exec(name) ?? [];
  if (!thing) return name;
  const what = thing === "color" ? "Vertex colour" : "Texture";
  return `${what}, ${channel ? colors[channel] : "grey"}`;
}

export class MaskRow {
  readonly root: HTMLElement;
  private readonly select: HTMLSelectElement;
  private readonly take: HTMLButtonElement;
  private paints = false;

  constructor(take: (name: string) => void) {
    const { row, select } = combobox("Of the file", [], () => {});
    this.select = select;
    this.take = button("Take", () => take(this.select.value), {
      title: "The paint becomes what the file's colours, numbers or textures are; paint on it then",
    });
    row.append(this.take);
    this.root = row;
  }

  /** `masks`: by their names in the engine. */
  set(masks: readonly string[]): void {
    this.select.replaceChildren(
      ...masks.map((name) => element("option", { value: name }, labelOf(name))),
    );
    if (masks.length === 0) this.select.append(element("option", {}, "none"));
    this.select.disabled = masks.length === 0;
    this.enable(this.paints);
  }

  /** Whether there is a paint that it can become. */
  enable(paints: boolean): void {
    this.paints = paints;
    this.take.disabled = !paints || this.select.disabled;
  }
}
