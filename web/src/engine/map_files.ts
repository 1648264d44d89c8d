// Maps of a run as files: the pixels of craze crack --maps, and what they stand for beside them.
import { png16 } from "../files/png16";
import type { CrazeModule } from "./craze_module";
import type { Memory } from "./memory";
import type { OutputFile } from "./messages";

/** `size`: texels a side; grooves are as wide and deep as the job's recipe says. Throws CrazeError,
 * as for a mesh without UVs. */
export async function mapFiles(
  craze: CrazeModule,
  memory: Memory,
  job: number,
  size: number,
): Promise<OutputFile[]> {
  const summary = JSON.parse(memory.taken((e) => craze._craze_job_summary(job, e)));
  const { gap, wall } = summary.recipe.post;
  const maps = memory.made((e) => craze._craze_job_bake(job, size, 0, 1, gap, wall, e));
  try {
    const files: OutputFile[] = [];
    const described: object[] = [];
    const names = memory.list((i) => craze._craze_maps_name(maps, i));
    for (const [i, name] of names.entries()) {
      const at = BigInt(i);
      const { values, columns } = memory.mapsArray(maps, at);
      const channels = columns as 1 | 3;
      const [low, high] = memory.withNumbers(6, null, (range) => {
        memory.check((e) => craze._craze_maps_range(maps, at, range, range + 24, e));
        const numbers = [...memory.numbers(range, 6)];
        return [numbers.slice(0, channels), numbers.slice(3, 3 + channels)] as const;
      });
      const file = `${name}.png`;
      files.push({ name: file, bytes: await png16({ values, size, channels, low, high }) });
      described.push({ file, size: [size, size], channels, low, high });
    }
    const text = JSON.stringify({ maps: described }, null, 2);
    return [...files, { name: "maps.json", bytes: new TextEncoder().encode(text) }];
  } finally {
    craze._craze_maps_free(maps);
  }
}
