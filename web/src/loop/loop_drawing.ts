// A state of the paper's loop as a drawing: mesh, cracks, forces, ellipses of ς, residuals.
import type { LoopState } from "../engine/messages";
import { svg } from "../ui/svg";

const ellipse = 0.02; // length of an axis where ς is τ; the plate is 1 wide
const arrow = 0.6; // length of a force, over its size

export interface Shown {
  forces: boolean;
  separation: boolean;
  /** The pieces of this crack stand out, and the node where it began; null: none. */
  crack: number | null;
}

/** `pieces` has the cracks that are drawn, which may be more than the state has. */
export function loopDrawing(state: LoopState, pieces: LoopState, shown: Shown): SVGSVGElement {
  const picture = svg("svg", {
    viewBox: "-0.58 -0.58 1.16 1.16",
    class: "loop",
    role: "img",
    "aria-label": "The plate, seen from above",
  });
  const turned = svg("g", { transform: "scale(1 -1)" });
  turned.append(meshOf(state));
  if (shown.separation) turned.append(ellipsesOf(state));
  if (shown.forces) turned.append(forcesOf(state));
  turned.append(cracksOf(pieces, shown.crack));
  picture.append(turned);
  return picture;
}

function meshOf({ fields: { positions: p, triangles } }: LoopState): SVGPathElement {
  let path = "";
  for (let f = 0; f < triangles.length; f += 3) {
    const corners = [0, 1, 2].map((i) => {
      const v = 3 * triangles[f + i]!;
      return `${p[v]!.toFixed(4)} ${p[v + 1]!.toFixed(4)}`;
    });
    path += `M${corners.join("L")}Z`;
  }
  return svg("path", { d: path, class: "mesh" });
}

function forcesOf({ fields: { positions: p, forces } }: LoopState): SVGPathElement {
  let path = "";
  for (let v = 0; v < p.length; v += 3) {
    const [x, y] = [p[v]!, p[v + 1]!];
    const [dx, dy] = [arrow * forces[v]!, arrow * forces[v + 1]!];
    if (Math.hypot(dx, dy) < 0.004) continue;
    const [tx, ty] = [x + dx, y + dy];
    path += `M${x} ${y}L${tx} ${ty}`;
    // The head: a third as long, at 30 degrees.
    for (const side of [-1, 1]) {
      const hx = -0.26 * dx + side * 0.15 * dy;
      const hy = -0.26 * dy - side * 0.15 * dx;
      path += `M${tx} ${ty}L${tx + hx} ${ty + hy}`;
    }
  }
  return svg("path", { d: path, class: "force" });
}

function ellipsesOf({ fields, toughness }: LoopState): SVGGElement {
  const { positions: p, separation, separationDirection: n, residual } = fields;
  const group = svg("g");
  for (let v = 0; v < residual.length; ++v) {
    const [largest, other] = [separation[2 * v]!, Math.max(separation[2 * v + 1]!, 0)];
    const fails = largest + residual[v]! >= toughness;
    const angle = (180 / Math.PI) * Math.atan2(n[3 * v + 1]!, n[3 * v]!);
    const at = `translate(${p[3 * v]} ${p[3 * v + 1]}) rotate(${angle.toFixed(2)})`;
    group.append(
      svg("ellipse", {
        transform: at,
        rx: ellipse * (largest / toughness),
        ry: ellipse * (other / toughness),
        class: fails ? "separation fails" : "separation",
      }),
    );
    if (residual[v]! > 0) {
      const r = ellipse * (residual[v]! / toughness);
      group.append(svg("circle", { cx: p[3 * v]!, cy: p[3 * v + 1]!, r, class: "residual" }));
    }
  }
  return group;
}

function cracksOf({ lines, events }: LoopState, newest: number | null): SVGGElement {
  const group = svg("g");
  events.forEach((event, i) => {
    if (newest !== null && event > newest) return;
    const [x1, y1, , x2, y2] = lines.subarray(6 * i, 6 * i + 6) as unknown as number[];
    const name = event === newest ? "crack newest" : "crack";
    group.append(svg("line", { x1: x1!, y1: y1!, x2: x2!, y2: y2!, class: name }));
  });
  return group;
}
