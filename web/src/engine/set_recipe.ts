// A recipe into a job of the engine.
import type { CrazeModule } from "./craze_module";
import type { Memory } from "./memory";
import type { RecipeRequest } from "./messages";

/** Throws CrazeError where it is none. */
export function setRecipe(
  craze: CrazeModule,
  memory: Memory,
  job: number,
  { base, set }: RecipeRequest,
): void {
  if ("preset" in base) {
    memory.withText(base.preset, (preset) =>
      memory.check((e) => craze._craze_job_set_preset(job, preset, e)),
    );
  } else {
    memory.withText(base.text, (text) =>
      memory.withText(base.name, (name) =>
        memory.check((e) => craze._craze_job_set_recipe(job, text, name, e)),
      ),
    );
  }
  for (const [key, value] of set) {
    memory.withText(key, (k) =>
      memory.withText(value, (v) => memory.check((e) => craze._craze_job_set(job, k, v, e))),
    );
  }
}
