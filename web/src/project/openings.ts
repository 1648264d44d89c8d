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

const insteadOf: Partial<Record<OpeningName, OpeningName>> = { gap: "gapWidth", gapWidth: "gap" };

/** What holds in a project: one way to say how far cracks open replaces the recipe's other one, and
 * of two a mean opening holds. */
export function openingOf(project: Project, name: OpeningName): Value {
  const other = insteadOf[name];
  if (other && yields(project, name, other)) return 0;
  return project[name] ?? recipeValue(project, openingKeys[name]);
}

function yields(project: Project, name: OpeningName, other: OpeningName): boolean {
  if (project[other] === null) return false;
  return project[name] === null || (name === "gap" && project[other] !== 0);
}

/** Whether places move in the growth, or cracks only appear. */
export function isOpened(project: Project): boolean {
  return (["gap", "gapWidth", "curl"] as const).some((name) => openingOf(project, name) !== 0);
}

/** What the project sets of [post], by its names there. */
function ownValues(project: Project): [string, number][] {
  return openingNames
    .filter((name) => project[name] !== null && openingOf(project, name) === project[name])
    .map((name) => [openingKeys[name], project[name]!]);
}

/** The same as --set takes them, which take nothing back by themselves. */
export function postKeys(project: Project): [string, string][] {
  const own = ownValues(project);
  const taken = own
    .map(([name]) => parameter(`post.${name}`).instead_of.replace("post.", ""))
    .filter((other) => other && !own.some(([name]) => name === other))
    .filter((other) => recipeValue(project, other) !== 0)
    .map((other): [string, number] => [other, 0]);
  return [...own, ...taken].map(([name, value]) => [`post.${name}`, String(value)]);
}

/** For the engine to open a finished run by, as a recipe of [post] alone. */
export function postText(project: Project): string {
  return JSON.stringify({ post: Object.fromEntries(ownValues(project)) });
}

function recipeValue(project: Project, name: string): Value {
  return baseRecipe(project).post[name] ?? (parameter(`post.${name}`).default as Value);
}
