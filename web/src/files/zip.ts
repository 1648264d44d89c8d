// Files in one: a ZIP that stores them as they are, dated with the first day that ZIP knows.
import { crc32 } from "./crc32";

interface NamedBytes {
  name: string;
  bytes: Uint8Array;
}

const version = 20; // 2.0
const utf8 = 1 << 11;
const firstDay = (1 << 5) | 1; // 1980-01-01

/** The files must be less than 4 GB together. */
export function zip(files: NamedBytes[]): Uint8Array {
  const parts: Uint8Array[] = [];
  const directory: Uint8Array[] = [];
  let at = 0;
  const add = (part: Uint8Array) => {
    parts.push(part);
    at += part.length;
  };
  for (const { name, bytes } of files) {
    const text = new TextEncoder().encode(name);
    // What both records of a file say of it.
    const common = [
      ...[version, utf8, 0, 0, firstDay].map((value) => [value, 2] as const),
      ...[crc32(bytes), bytes.length, bytes.length].map((value) => [value, 4] as const),
      [text.length, 2] as const,
    ];
    const offset = at;
    directory.push(
      fields([[0x02014b50, 4], [version, 2], ...common, [0, 2], [0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]]),
      text,
    );
    add(fields([[0x04034b50, 4], ...common, [0, 2]]));
    add(text);
    add(bytes);
  }
  const begin = at;
  directory.forEach(add);
  const count = files.length;
  add(fields([[0x06054b50, 4], [0, 2], [0, 2], [count, 2], [count, 2], [at - begin, 4], [begin, 4], [0, 2]]));
  const whole = new Uint8Array(at);
  let end = 0;
  for (const part of parts) {
    whole.set(part, end);
    end += part.length;
  }
  return whole;
}

/** Whole numbers of 2 or 4 bytes each, the least byte first. */
function fields(values: (readonly [value: number, bytes: number])[]): Uint8Array {
  const bytes: number[] = [];
  for (const [value, size] of values) {
    for (let k = 0; k < size; ++k) bytes.push((value >>> (8 * k)) & 255);
  }
  return Uint8Array.from(bytes);
}
