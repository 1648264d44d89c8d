// What changes a finished run without cracking again: keys of [post], by their names in a project.
import { baseRecipe } from "./base_recipe";
import type { Project } from "./project";
import { parameter } from "./tables";

export const openingKeys = {
  gap: "gap",
  gapWidth: "gap_width",
  wall: "wall",
  curl: "curl",
  lateWidth: "late_width",
  thickness: "thickness",
  roughness: "relative_roughness",
} as const;

export type OpeningName = keyof typeof openingKeys;
export const openingNames = Object.keys(openingKeys) as OpeningName[];

/** What a project sets; null: as the recipe has it. */
export type Openings = Record<OpeningName, number | null>;

export const noOpenings = Object.fromEntries(openingNames.map((name) => [name, null])) as Openings;

/** A number, or a length with its unit. */
export type Value = number | string;

/** What holds in a project; a gap yields to a mean opening. */
export function openingOf(project: Project, name: OpeningName): Value {
  if (name === "gap" && openingOf(project, "gapWidth") !== 0) return 0;
  return project[name] ?? recipeValue(project, openingKeys[name]);
}

/** Whether places move in the growth, or cracks only appear. */
export function isOpened(project: Project): boolean {
  return (["gap", "gapWidth", "curl"] as const).some((name) => openingOf(project, name) !== 0);
}

/** Names of [post] and what holds for them. */
function postValues(project: Project): [string, Value][] {
  const values = openingNames.map((name): [string, Value] => [
    openingKeys[name],
    openingOf(project, name),
  ]);
  // It goes before the relative one.
  const roughness = project.roughness === null ? recipeValue(project, "roughness") : 0;
  return [...values, ["roughness", roughness]];
}

/** The same as --set takes them, but for those that the recipe has so. */
export function postKeys(project: Project): [string, string][] {
  return postValues(project)
    .filter(([name, value]) => value !== recipeValue(project, name))
    .map(([name, value]) => [`post.${name}`, String(value)]);
}

/** For the engine to open a finished run by, as a recipe of [post] alone. */
export function postText(project: Project): string {
  return JSON.stringify({ post: Object.fromEntries(postValues(project)) });
}

function recipeValue(project: Project, name: string): Value {
  return baseRecipe(project).post[name] ?? (parameter(`post.${name}`).default as Value);
}
