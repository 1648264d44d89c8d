// The normals that a mesh of the engine is looked at by.
import type { CrazeModule } from "./craze_module";
import type { Memory } from "./memory";

const crease = 75; // degrees, as pictures and GLB of the command have it

/** Three numbers per corner, unit. */
export function shading(
  craze: CrazeModule,
  memory: Memory,
  mesh: number,
  corners: number,
): Float32Array {
  return memory.withNumbers(3 * corners, null, (at) => {
    memory.check((e) => craze._craze_mesh_shading(mesh, crease, at, e));
    return Float32Array.from(memory.numbers(at, 3 * corners));
  });
}
