// JavaScript's values in the engine's memory and back. Views of that memory are copied at once: it
// may move whenever the engine runs.
import type { CrazeModule } from "./craze_module";

const errorSize = 4 + 1024; // craze_error
const arraySize = 24; // craze_array

/** What the engine said in one line: WHAT (WHERE): WHY. */
export class CrazeError extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
    this.name = "CrazeError";
  }
}

/** Numbers in rows, one after the other. */
export interface Rows {
  values: Float64Array | Float32Array | Int32Array | Uint8Array;
  rows: number;
  columns: number;
}

export class Memory {
  private readonly error: number;
  private readonly array: number;

  constructor(private readonly craze: CrazeModule) {
    this.error = craze._malloc(errorSize);
    this.array = craze._malloc(arraySize);
  }

  /** The text at a pointer; "" for NULL. */
  text(pointer: number): string {
    if (pointer === 0) return "";
    const bytes = this.craze.HEAPU8;
    return new TextDecoder().decode(bytes.slice(pointer, bytes.indexOf(0, pointer)));
  }

  /** Runs body with the text's place, which it may use until it returns. */
  withText<T>(text: string, body: (pointer: number) => T): T {
    const bytes = new TextEncoder().encode(text);
    const pointer = this.allocate(bytes.length + 1);
    try {
      this.craze.HEAPU8.set(bytes, pointer);
      this.craze.HEAPU8[pointer + bytes.length] = 0;
      return body(pointer);
    } finally {
      this.craze._free(pointer);
    }
  }

  /** The same with room for numbers, which hold `values` where they are given. */
  withNumbers<T>(count: number, values: ArrayLike<number> | null, body: (at: number) => T): T {
    const pointer = this.allocate(8 * count);
    try {
      if (values) this.craze.HEAPF64.set(values, pointer / 8);
      return body(pointer);
    } finally {
      this.craze._free(pointer);
    }
  }

  /** The same with bytes. */
  withBytes<T>(bytes: Uint8Array | Uint8ClampedArray, body: (at: number) => T): T {
    const pointer = this.allocate(bytes.length);
    try {
      this.craze.HEAPU8.set(bytes, pointer);
      return body(pointer);
    } finally {
      this.craze._free(pointer);
    }
  }

  numbers(pointer: number, count: number): Float64Array {
    return this.craze.HEAPF64.slice(pointer / 8, pointer / 8 + count);
  }

  /** Calls a function that returns a status; throws CrazeError unless all went well. */
  check(call: (error: number) => number): void {
    if (call(this.error) !== 0) throw this.failure();
  }

  /** Calls a function that returns a handle or a text; throws CrazeError where there is none. */
  made(call: (error: number) => number): number {
    const pointer = call(this.error);
    if (pointer === 0) throw this.failure();
    return pointer;
  }

  /** A copy of a mesh's array; throws CrazeError where there is no such one. */
  meshArray(mesh: number, name: string): Rows {
    return this.rowsOf(name, (...found) => this.craze._craze_mesh_array(mesh, ...found));
  }

  /** The same of crack lines. */
  linesArray(lines: number, name: string): Rows {
    return this.rowsOf(name, (...found) => this.craze._craze_lines_array(lines, ...found));
  }

  /** The same of the i-th of baked maps. */
  mapsArray(maps: number, index: bigint): Rows {
    this.check((error) => this.craze._craze_maps_array(maps, index, this.array, error));
    return this.foundRows("maps");
  }

  /** The text that a function returns, which is freed. */
  taken(call: (error: number) => number): string {
    const pointer = this.made(call);
    const text = this.text(pointer);
    this.craze._craze_text_free(pointer);
    return text;
  }

  /** The file of a material's texture; empty where there is none. */
  texture(mesh: number, material: bigint): Uint8Array {
    this.check((error) => this.craze._craze_mesh_texture(mesh, material, this.array, error));
    return this.foundRows("texture").values as Uint8Array;
  }

  private rowsOf(name: string, find: (name: number, array: number, error: number) => number): Rows {
    this.withText(name, (at) => this.check((error) => find(at, this.array, error)));
    return this.foundRows(name);
  }

  private foundRows(name: string): Rows {
    const view = new DataView(this.craze.HEAPU8.buffer, this.array, arraySize);
    const data = view.getUint32(0, true);
    const rows = Number(view.getBigInt64(8, true));
    const columns = view.getInt32(16, true);
    const type = [Float64Array, Float32Array, Int32Array, Uint8Array][view.getInt32(20, true)];
    if (!type) throw new CrazeError(7, `unknown type of array (${name})`);
    const values = new type(this.craze.HEAPU8.buffer as ArrayBuffer, data, rows * columns).slice();
    return { values, rows, columns };
  }

  /** Sentences up to the first NULL. */
  list(at: (index: bigint) => number): string[] {
    const found: string[] = [];
    for (let i = 0n; ; ++i) {
      const pointer = at(i);
      if (pointer === 0) return found;
      found.push(this.text(pointer));
    }
  }

  private allocate(bytes: number): number {
    const pointer = this.craze._malloc(Math.max(bytes, 1));
    if (pointer === 0) throw new CrazeError(6, "not enough memory");
    return pointer;
  }

  private failure(): CrazeError {
    const view = new DataView(this.craze.HEAPU8.buffer);
    return new CrazeError(view.getInt32(this.error, true), this.text(this.error + 4));
  }
}
