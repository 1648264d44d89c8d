// What the page and its workers say to each other.

/** What is cracked: a built-in shape, as `cup?n=96`, or a file's bytes with its name. */
export type Input =
  | { kind: "shape"; specification: string }
  | { kind: "file"; name: string; bytes: Uint8Array };

/** Values painted on the input's vertices, row by row, under the name that the recipe gives them. */
export interface PaintedAttribute {
  name: string;
  values: Float32Array;
  columns: number; // how many values a vertex has
}

/** What a recipe begins with, and the keys that differ from it, as --set takes them, in order. */
export interface RecipeRequest {
  base: { preset: string } | { text: string; name: string }; // a text: TOML or JSON
  set: [key: string, value: string][];
}

export interface CrackRequest {
  input: Input;
  painted: PaintedAttribute[];
  recipe: RecipeRequest;
}

/** How a finished run is opened: TOML or JSON of a recipe that has keys of [post] alone. */
export type Post = string;

/** The surface that was given, for looking at and painting on. */
export interface InputMesh {
  positions: Float32Array; // three per vertex
  triangles: Uint32Array; // three per triangle
  normals: Float32Array; // three per corner, unit
  masks: string[]; // what of it may be a mask
  warnings: string[];
}

/** What is drawn of an opened surface; all is per corner, three corners a triangle. */
export interface Picture {
  positions: Float32Array;
  normals: Float32Array;
  fragments: Int32Array; // one per triangle
  walls: Uint8Array; // one per triangle: 1 where it is a crack's wall
  lines: Float32Array; // six per piece of a crack: from, to
  lineGrowth: Float32Array; // two per piece: when the growth comes by, 0 … 1
  warnings: string[];
}

/** The places of a Picture's corners and lines at a time of its growth. */
export interface Moment {
  positions: Float32Array;
  lines: Float32Array;
}

export interface Summary {
  cracks: number;
  fragments: number;
  length: number;
  triangles: number;
  seconds: number;
  warnings: string[];
}

export interface Progress {
  phase: string;
  fraction: number | null;
  cracks: number;
  load: number;
}

/** Pieces of crack as they open, six numbers each: from, to. `first` is the number of the first of
 * them; with 0 the pattern begins anew. */
export interface OpenedPieces {
  first: number;
  pieces: Float32Array;
}

/** The state that a run ended in, on the mesh that its cracks grew on. */
export interface Fields {
  positions: Float32Array; // three per vertex
  triangles: Int32Array; // three per triangle
  normals: Float32Array; // three per corner, unit
  stress: Float32Array; // two per triangle: the principal stresses, the larger first
  stressDirection: Float32Array; // three per triangle, of the larger one, unit
  separation: Float32Array; // two per vertex: values of ς, the larger first, force
  separationDirection: Float32Array; // three per vertex, of the larger one, unit
  forces: Float32Array; // three per vertex
  residual: Float32Array; // one per vertex: what Eq. 8 leaves at a tip, force
}

/** One value of the statistics with its standard error; null where it cannot be measured. */
export interface Measured {
  value: number | null;
  error: number | null;
}
export type Statistics = Record<string, Record<string, Measured>>;

/** The paper's loop on a small plate after so many cracks. */
export interface LoopState {
  fields: Fields;
  lines: Float32Array; // six per piece of a crack: from, to
  events: Int32Array; // one per piece: the number of its crack
  toughness: number; // force at which a node fails
  ended: boolean; // nothing more can fail
}

/** A whole recipe. */
export interface RecipeTexts {
  toml: string;
  json: string;
}

export interface OutputFile {
  name: string;
  bytes: Uint8Array;
}

export interface Requests {
  start: { request: { code: WebAssembly.Module; life: string }; reply: null };
  look: { request: { input: Input }; reply: InputMesh };
  mask: { request: { input: Input; name: string }; reply: { values: Float32Array } };
  crack: { request: CrackRequest; reply: Summary };
  open: { request: Post; reply: Picture };
  moment: { request: { time: number }; reply: Moment };
  write: { request: { name: string; post: Post }; reply: OutputFile[] };
  fields: { request: null; reply: Fields };
  statistics: { request: Post; reply: Statistics };
  writeLines: { request: { name: string; post: Post }; reply: OutputFile[] };
  loop: { request: { cracks: number; seed: number }; reply: LoopState };
  maps: { request: { size: number; post: Post }; reply: OutputFile[] };
  recipe: { request: RecipeRequest; reply: RecipeTexts };
  paintedInput: { request: CrackRequest & { name: string }; reply: OutputFile[] };
}

export type Kind = keyof Requests;

export type ToWorker = { [K in Kind]: { id: number; kind: K; request: Requests[K]["request"] } }[Kind];

export type FromWorker =
  | { id: number; reply: Requests[Kind]["reply"] }
  | { id: number; error: { status: number; message: string } }
  | { progress: Progress }
  | { opened: OpenedPieces };
