// The recipe of a project as keys that differ from its preset: for the engine and for the command.
import { layers, paintedLayers } from "../paint/layers";
import type { Project } from "./project";
import { presetTable } from "./tables";

const opening = ["gap", "wall", "curl"] as const;

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

function postKeys(project: Project): [string, string][] {
  const own = presetTable[project.preset]!.recipe.post;
  return opening
    .filter((name) => project[name] !== own[name])
    .map((name) => [`post.${name}`, String(project[name])]);
}

/** What changes with another preset: an opening that was the preset's own is the next one's. */
export function ofPreset(project: Project, preset: string): Partial<Project> {
  const old = presetTable[project.preset]!.recipe.post;
  const change: Partial<Project> = { preset, spacing: null, load: null };
  for (const name of opening) {
    if (project[name] === old[name]) change[name] = presetTable[preset]!.recipe.post[name];
  }
  return change;
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
