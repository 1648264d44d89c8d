// The statistics of a pattern as a table: value, error, and both on a line beside what is published.
import type { Measured, Statistics } from "../engine/messages";
import { element } from "../ui/elements";
import { svg } from "../ui/svg";
import { published, rows, type Row } from "./bands";

const width = 64; // of a plot, in pixels
const height = 16;

export function statisticsTable(statistics: Statistics, preset: string): HTMLTableElement {
  const bands = published[preset] ?? {};
  const head = element("tr", {}, ...["", "measured", "published"].map((text) => th(text, "col")));
  const table = element("table", { class: "statistics" }, element("thead", {}, head));
  const body = element("tbody");
  for (const row of rows) {
    const [group, name] = row.key.split(".") as [string, string];
    const measured = statistics[group]?.[name];
    if (!measured || measured.value === null) continue;
    const band = bands[row.key] ?? null;
    body.append(
      element(
        "tr",
        {},
        th(row.name, "row"),
        element("td", {}, valueOf(measured)),
        element("td", {}, band ? textOf(band) : "–"),
        element("td", {}, plot(row, measured, band)),
      ),
    );
  }
  table.append(body);
  return table;
}

const th = (text: string, scope: string) =>
  text ? element("th", { scope }, text) : element("td");

const number = (x: number) => String(Number(x.toPrecision(3)));

function valueOf({ value, error }: Measured): string {
  if (error === null || error === 0) return number(value!);
  const digits = Math.min(Math.max(-Math.floor(Math.log10(error)), 0), 6);
  return `${value!.toFixed(digits)} ± ${Number(error.toPrecision(1))}`; // no finer than it is known
}

const textOf = ([low, high]: readonly [number, number]) =>
  low === high ? number(low) : `${number(low)}–${number(high)}`;

/** The band as a bar, the value as a dot with its error. */
function plot(row: Row, { value, error }: Measured, band: readonly [number, number] | null) {
  const x = (v: number) =>
    4 + ((Math.min(Math.max(v, row.low), row.high) - row.low) / (row.high - row.low)) * (width - 8);
  const picture = svg("svg", { width, height, "aria-hidden": "true" });
  picture.append(svg("line", { x1: 4, x2: width - 4, y1: 8, y2: 8, class: "axis" }));
  if (band) {
    const wide = Math.max(x(band[1]) - x(band[0]), 3);
    const left = (x(band[0]) + x(band[1]) - wide) / 2;
    picture.append(svg("rect", { x: left, y: 2, width: wide, height: 12, class: "band" }));
  }
  const [from, to] = [value! - (error ?? 0), value! + (error ?? 0)];
  picture.append(
    svg("line", { x1: x(from), x2: x(to), y1: 8, y2: 8, class: "error-bar" }),
    svg("circle", { cx: x(value!), cy: 8, r: 3, class: "value" }),
  );
  return picture;
}
