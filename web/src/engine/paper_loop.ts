// The loop of section 3.1 of the paper on a plate that is small enough to follow it by eye: its own
// engine, and one crack more each time.
import type { CrazeModule } from "./craze_module";
import { fieldsOf } from "./fields";
import type { Memory } from "./memory";
import type { LoopState } from "./messages";

const plate = "plate?n=10&jitter=0.3";
const toughness = 0.06;

const recipe = (seed: number) => `
engine = "euler"
seed = ${seed}
[mesh]
edge = "keep"
output = "simulation"
[stress]
noise = 0.1
[material]
toughness = ${toughness}
[evolution]
relaxation_steps = 10
`;

/** The state after so many cracks, each relaxed. It is run from the beginning: that takes 20 ms. */
export function loopState(
  craze: CrazeModule,
  memory: Memory,
  cracks: number,
  seed: number,
): LoopState {
  const mesh = memory.withText(plate, (at) => memory.made((e) => craze._craze_mesh_shape(at, e)));
  const job = craze._craze_job_new();
  try {
    memory.check((e) => craze._craze_job_set_threads(job, 1, e));
    memory.check((e) => craze._craze_job_set_mesh(job, mesh, e));
    memory.withText(recipe(seed), (at) =>
      memory.check((e) => craze._craze_job_set_recipe(job, at, 0, e)),
    );
    memory.check((e) => craze._craze_job_set_max_cracks(job, BigInt(cracks), e));
    memory.check((e) => craze._craze_job_run(job, e));
    const { stop_reason } = JSON.parse(memory.taken((e) => craze._craze_job_summary(job, e)));
    return {
      fields: fieldsOf(craze, memory, job),
      ...linesOf(craze, memory, job),
      toughness,
      ended: stop_reason !== "max_cracks",
    };
  } finally {
    craze._craze_job_free(job);
    craze._craze_mesh_free(mesh);
  }
}

function linesOf(craze: CrazeModule, memory: Memory, job: number) {
  const lines = memory.made((e) => craze._craze_job_lines(job, e));
  try {
    const points = memory.linesArray(lines, "points").values;
    const edges = memory.linesArray(lines, "edges").values;
    const events = Int32Array.from(memory.linesArray(lines, "edge:event").values);
    const places = new Float32Array(3 * edges.length);
    for (let i = 0; i < places.length; ++i) {
      places[i] = points[3 * edges[Math.floor(i / 3)]! + (i % 3)]!;
    }
    return { lines: places, events };
  } finally {
    craze._craze_lines_free(lines);
  }
}
