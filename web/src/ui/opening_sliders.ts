// The sliders of what changes a finished run, which cracks nothing again.
import { openingKeys, openingNames, openingOf, type OpeningName } from "../project/openings";
import type { Project } from "../project/project";
import { parameter } from "../project/tables";
import { Slider } from "./slider";

interface Row {
  name: string;
  high: number; // in the unit of the key; of lengths, over the diagonal of the input
  length?: true;
}

const table: Record<OpeningName, Row> = {
  gap: { name: "Gap", high: 0.2 },
  gapWidth: { name: "Mean opening", high: 0.01, length: true },
  wall: { name: "Wall", high: 0.06, length: true },
  curl: { name: "Curl", high: 6 },
  lateWidth: { name: "Late width", high: 1 },
  thickness: { name: "Thickness", high: 0.1, length: true },
  roughness: { name: "Roughness", high: 0.15 },
};

export class OpeningSliders {
  private readonly sliders: Record<OpeningName, Slider>;

  constructor(change: (change: Partial<Project>) => void) {
    const slider = (key: OpeningName) =>
      new Slider({
        name: table[key].name,
        low: 0,
        high: table[key].high,
        help: parameter(`post.${openingKeys[key]}`).help,
        // The last one moved of the two holds.
        set: (value) => change({ [key]: value, ...(key === "gap" ? { gapWidth: null } : {}) }),
      });
    const made = openingNames.map((key) => [key, slider(key)]);
    this.sliders = Object.fromEntries(made) as typeof this.sliders;
  }

  get rows(): HTMLElement[] {
    return openingNames.map((key) => this.sliders[key].row);
  }

  /** `diagonal`: of the input, which lengths go by. */
  show(project: Project, diagonal: number): void {
    for (const key of openingNames) {
      const { high, length } = table[key];
      this.sliders[key].range(0, high * (length ? diagonal : 1));
      this.sliders[key].show(openingOf(project, key));
    }
    this.sliders.wall.disabled = openingOf(project, "thickness") !== 0; // they go all the way
  }
}
