// The state of a run, out of the engine's memory.
import type { CrazeModule } from "./craze_module";
import type { Memory } from "./memory";
import type { Fields } from "./messages";
import { shading } from "./shading";

/** Attributes of one number each, row by row. */
function together(memory: Memory, mesh: number, element: string, names: string[]): Float32Array {
  const columns = names.map((name) => memory.meshArray(mesh, `${element}:${name}`).values);
  const rows = new Float32Array(names.length * columns[0]!.length);
  columns.forEach((values, k) => {
    for (let i = 0; i < values.length; ++i) rows[names.length * i + k] = values[i]!;
  });
  return rows;
}

/** Throws CrazeError where the job has no result. */
export function fieldsOf(craze: CrazeModule, memory: Memory, job: number): Fields {
  const mesh = memory.made((e) => craze._craze_job_fields(job, e));
  try {
    const triangles = memory.meshArray(mesh, "faces").values as Int32Array;
    return {
      positions: Float32Array.from(memory.meshArray(mesh, "vertices").values),
      triangles,
      normals: shading(craze, memory, mesh, triangles.length),
      stress: together(memory, mesh, "face", ["s1", "s2"]),
      stressDirection: together(memory, mesh, "face", ["dx", "dy", "dz"]),
      separation: together(memory, mesh, "vertex", ["v", "v2"]),
      separationDirection: together(memory, mesh, "vertex", ["nx", "ny", "nz"]),
      forces: together(memory, mesh, "vertex", ["fx", "fy", "fz"]),
      residual: together(memory, mesh, "vertex", ["r"]),
    };
  } finally {
    craze._craze_mesh_free(mesh);
  }
}
