// The engine's own tables, taken from it when the page is built.
import type { OwnRecipe } from "./project";
import parameters from "../engine/generated/parameters.json";
import presets from "../engine/generated/presets.json";

interface Parameter {
  key: string;
  help: string;
  default: unknown;
  instead_of: string;
  minimum?: number;
}

export interface Preset {
  description: string;
  recipe: OwnRecipe;
}

/** Throws Error for a key that the engine has not. */
export function parameter(key: string): Parameter {
  const found = (parameters as Parameter[]).find((row) => row.key === key);
  if (!found) throw new Error(`no parameter ${key}`);
  return found;
}

export const presetTable = presets as unknown as Record<string, Preset>;
