// PNG of 16 bits a channel, as the command writes maps: linear, each row filtered by what is left.
import { crc32 } from "./crc32";

export interface MapPixels {
  values: ArrayLike<number>; // rows from the top, pixels from the left, channels together
  size: number; // pixels a side
  channels: 1 | 3;
  low: readonly number[]; // per channel: what 0 stands for
  high: readonly number[]; // and 65535
}

const signature = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const filterLeft = 1;
const linearGamma = [0, 1, 0x86, 0xa0]; // 100000

export async function png16(map: MapPixels): Promise<Uint8Array> {
  const { size, channels } = map;
  const header = new Uint8Array(13);
  new DataView(header.buffer).setUint32(0, size);
  new DataView(header.buffer).setUint32(4, size);
  header.set([16, channels === 3 ? 2 : 0], 8);
  const zlib = new Blob([filtered(map) as BlobPart])
    .stream()
    .pipeThrough(new CompressionStream("deflate"));
  const parts = [
    Uint8Array.from(signature),
    chunk("IHDR", header),
    chunk("gAMA", Uint8Array.from(linearGamma)),
    chunk("IDAT", new Uint8Array(await new Response(zlib).arrayBuffer())),
    chunk("IEND", new Uint8Array(0)),
  ];
  return new Uint8Array(await new Blob(parts as BlobPart[]).arrayBuffer());
}

function filtered({ values, size, channels, low, high }: MapPixels): Uint8Array {
  const row = size * channels;
  const bytes = new Uint8Array(size * (1 + 2 * row));
  let at = 0;
  for (let y = 0; y < size; ++y) {
    bytes[at++] = filterLeft;
    const left = [0, 0, 0];
    for (let i = 0; i < row; ++i) {
      const k = i % channels;
      const share = (values[y * row + i]! - low[k]!) / (high[k]! - low[k]!);
      const number = Math.floor(Math.min(Math.max(share, 0), 1) * 65535 + 0.5);
      bytes[at++] = (number >> 8) - (left[k]! >> 8);
      bytes[at++] = (number & 255) - (left[k]! & 255);
      left[k] = number;
    }
  }
  return bytes;
}

function chunk(type: string, data: Uint8Array): Uint8Array {
  const bytes = new Uint8Array(12 + data.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(new TextEncoder().encode(type), 4);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, crc32(bytes.subarray(4, 8 + data.length)));
  return bytes;
}
