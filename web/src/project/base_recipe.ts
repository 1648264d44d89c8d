// What a project's own keys are on top of.
import type { OwnRecipe, Project } from "./project";
import { presetTable } from "./tables";

export function baseRecipe(project: Project): OwnRecipe {
  return project.recipe ?? presetTable[project.preset]!.recipe;
}
