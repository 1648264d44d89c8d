// The recipe of a project as keys that differ from its preset: for the engine and for the command.
import type { RecipeRequest } from "../engine/messages";
import { layers, ownMask, paintedLayers } from "../paint/layers";
import { noOpenings, postKeys } from "./openings";
import type { OwnRecipe, Project } from "./project";

/** For the engine; without [post], which opens what is cracked. */
export function recipeRequest(project: Project): RecipeRequest {
  const { recipe, preset } = project;
  const base = recipe ? { text: JSON.stringify(recipe), name: ownRecipe } : { preset };
  return { base, set: changedKeys(project) };
}

/** The same with [post]. */
export function wholeRecipe(project: Project): RecipeRequest {
  const { base, set } = recipeRequest(project);
  return { base, set: [...set, ...postKeys(project)] };
}

const ownRecipe = "recipe.toml"; // as it is exported

/** Keys and values, as --set takes them, without [post]. */
function changedKeys(project: Project): [string, string][] {
  const set: [string, string][] = [];
  if (project.spacing !== null) set.push(["layer.spacing", String(project.spacing)]);
  if (project.load !== null) set.push(["evolution.max_load", String(project.load)]);
  for (const name of paintedLayers(project)) {
    set.push([layers[name].key, JSON.stringify(layers[name].attribute)]);
  }
  const mask = ownMask(project);
  if (mask !== null) set.push([layers.mask.key, JSON.stringify(mask)]);
  project.impacts.forEach((point, i) => {
    set.push([`impact.${i}.point`, `[${point.join(",")}]`]);
    set.push([`impact.${i}.relative_radius`, "0.05"]);
  });
  set.push(["seed", String(project.seed)]);
  return set;
}

/** What changes with another preset. */
export function ofPreset(preset: string): Partial<Project> {
  return { preset, recipe: null, spacing: null, load: null };
}

/** What changes with a recipe of a person's own: its seed and opening, and no impact but its own. */
export function ofOwnRecipe(recipe: OwnRecipe): Partial<Project> {
  return { recipe, seed: recipe.seed, spacing: null, load: null, impacts: [], ...noOpenings };
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

/** The command that writes the same bytes as the page. A recipe of a person's own it reads from
 * the file that the page exports, in which every change is. */
export function commandLine(project: Project, output: string): string {
  const words = ["craze", "crack", commandInput(project), "-o", output];
  if (project.recipe) return [...words, "--recipe", ownRecipe].map(quoted).join(" ");
  words.push("--preset", project.preset);
  for (const [key, value] of [...changedKeys(project), ...postKeys(project)]) {
    words.push("--set", `${key}=${value}`);
  }
  return words.map(quoted).join(" ");
}
