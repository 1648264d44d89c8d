// The recipe of a project as keys that differ from its preset: for the engine and for the command.
import { layers, paintedLayers } from "../paint/layers";
import type { Project } from "./project";

/** Keys and values, as --set takes them, without [post]. */
export function changedKeys(project: Project): [string, string][] {
  const set: [string, string][] = [];
  if (project.spacing !== null) set.push(["layer.spacing", String(project.spacing)]);
  if (project.load !== null) set.push(["evolution.max_load", String(project.load)]);
  for (const name of paintedLayers(project)) {
    set.push([layers[name].key, JSON.stringify(layers[name].attribute)]);
  }
  project.impacts.forEach((point, i) => {
    set.push([`impact.${i}.point`, `[${point.join(",")}]`]);
    set.push([`impact.${i}.relative_radius`, "0.05"]);
  });
  set.push(["seed", String(project.seed)]);
  return set;
}

function postKeys({ gap, wall, curl }: Project): [string, string][] {
  const all: [string, number][] = [
    ["post.gap", gap],
    ["post.wall", wall],
    ["post.curl", curl],
  ];
  return all.filter(([, value]) => value !== 0).map(([key, value]) => [key, String(value)]);
}

/** For a shell: as it is where nothing in it means something there. */
function quoted(text: string): string {
  return /^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

/** The input that the command reads: what was painted is in a file that the page exports. */
export function commandInput(project: Project): string {
  if (paintedLayers(project).length > 0) return "painted.ply";
  const { source } = project;
  return source.kind === "shape" ? `shape:${source.specification}` : source.name;
}

/** The command that writes the same bytes as the page. */
export function commandLine(project: Project, output: string): string {
  const words = ["craze", "crack", commandInput(project), "-o", output, "--preset", project.preset];
  for (const [key, value] of [...changedKeys(project), ...postKeys(project)]) {
    words.push("--set", `${key}=${value}`);
  }
  return words.map(quoted).join(" ");
}
