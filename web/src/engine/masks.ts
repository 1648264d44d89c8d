// What of a file may be a mask: numbers and colours of its vertices, textures of its materials.
import type { CrazeModule } from "./craze_module";
import type { Memory } from "./memory";
import { decodePicture, type Pixels } from "./decode_picture";

const texture = "texture"; // of the base colour, as grey; texture:r and so on for one channel
const channels = ["r", "g", "b", "a"];
const bytes = 3; // CRAZE_UINT8

/** Names for maskValues. */
export function maskNames(craze: CrazeModule, memory: Memory, mesh: number): string[] {
  const textured = materials(craze, memory, mesh).some((i) => memory.texture(mesh, i).length > 0);
  const ofTextures = [texture, ...channels.map((channel) => `${texture}:${channel}`)];
  return [...new Set([...attributes(craze, memory, mesh), ...(textured ? ofTextures : [])])];
}

const attributes = (craze: CrazeModule, memory: Memory, mesh: number): string[] =>
  JSON.parse(memory.taken((e) => craze._craze_mesh_masks(mesh, e)));

/** One number per vertex, 0 … 1. Throws CrazeError where the mesh has no such thing, and Error for a
 * texture that is no picture. */
export async function maskValues(
  craze: CrazeModule,
  memory: Memory,
  mesh: number,
  name: string,
): Promise<Float32Array> {
  const vertices = memory.meshArray(mesh, "vertices").rows;
  const [of, channel] = name.split(":");
  const isChannel = channel === undefined || channels.includes(channel);
  if (of !== texture || !isChannel || attributes(craze, memory, mesh).includes(name)) {
    return memory.withNumbers(vertices, null, (at) => {
      memory.withText(name, (text) => memory.check((e) => craze._craze_mesh_mask(mesh, text, at, e)));
      return Float32Array.from(memory.numbers(at, vertices));
    });
  }
  const pictures: [bigint, Pixels][] = [];
  for (const material of materials(craze, memory, mesh)) {
    const file = memory.texture(mesh, material);
    if (file.length > 0) pictures.push([material, await decodePicture(file)]);
  }
  if (pictures.length === 0) throw new Error("The file has no textures.");
  const values = new Float64Array(vertices); // what has no texture is 0
  return memory.withNumbers(vertices, values, (at) => {
    for (const [material, picture] of pictures) {
      const { rgba, width, height } = picture;
      const k = channels.indexOf(channel ?? "");
      const pixels = k < 0 ? rgba : rgba.filter((_, i) => i % 4 === k);
      memory.withBytes(pixels, (place) =>
        memory.check((e) =>
          craze._craze_mesh_mask_picture(
            mesh, material, place, bytes, BigInt(width), BigInt(height), k < 0 ? 4 : 1, at, e,
          ),
        ),
      );
    }
    return Float32Array.from(memory.numbers(at, vertices));
  });
}

function materials(craze: CrazeModule, memory: Memory, mesh: number): bigint[] {
  return memory.list((i) => craze._craze_mesh_material_name(mesh, i)).map((_, i) => BigInt(i));
}
