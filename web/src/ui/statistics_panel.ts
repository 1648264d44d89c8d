// The statistics of the last result, measured when they are asked for.
import type { Statistics } from "../engine/messages";
import { statisticsTable } from "../statistics/statistics_table";
import { button, element } from "./elements";

export class StatisticsPanel {
  readonly root: HTMLElement;
  private readonly result = element("div");

  constructor(measure: () => void) {
    this.root = element(
      "section",
      {},
      element("h2", {}, "Statistics"),
      element("div", { class: "buttons" }, button("Measure", measure)),
      this.result,
    );
  }

  show(statistics: Statistics, preset: string): void {
    this.result.replaceChildren(statisticsTable(statistics, preset));
  }

  clear(): void {
    this.result.replaceChildren();
  }
}
