// The engine's own tables, taken from it when the page is built.
import parameters from "../engine/generated/parameters.json";
import presets from "../engine/generated/presets.json";

interface Parameter {
  key: string;
  help: string;
  minimum?: number;
}

interface PresetRecipe {
  layer: { spacing: number | string; relative_spacing: number };
  evolution: { max_load: number };
  picture: { material: string };
  post: { gap: number; wall: number; curl: number };
}

export interface Preset {
  description: string;
  recipe: PresetRecipe;
}

/** Throws Error for a key that the engine has not. */
export function parameter(key: string): Parameter {
  const found = (parameters as Parameter[]).find((row) => row.key === key);
  if (!found) throw new Error(`no parameter ${key}`);
  return found;
}

export const presetTable = presets as unknown as Record<string, Preset>;
