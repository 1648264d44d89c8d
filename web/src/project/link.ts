// A project as text, checked when it comes back: for addresses, packed, and for files.
import { openingKeys, openingNames, type Openings, type Value } from "./openings";
import { firstProject, layerNames, type OwnRecipe, type Project, type Stroke } from "./project";

type Json = Record<string, unknown>;

// Keys of [post] that the engine has where a recipe, as of an older page, has none.
const isValue = (x: unknown): x is Value | undefined =>
  x === undefined || isNumber(x) || typeof x === "string";
const isNumber = (x: unknown): x is number => typeof x === "number" && Number.isFinite(x);
const isList = (x: unknown, length?: number): x is number[] =>
  Array.isArray(x) && x.every(isNumber) && (length === undefined || x.length === length);

function wrong(what: string): never {
  throw new Error(`this is no project of craze (${what})`);
}

function numberOr<T>(x: unknown, other: T, what: string, low: number): number | T {
  if (x === undefined || x === null) return other;
  return isNumber(x) && x >= low ? x : wrong(what);
}

function strokeOf(value: unknown): Stroke {
  const stroke = value as Stroke;
  if (!layerNames.includes(stroke?.layer)) wrong("layer of a stroke");
  if (!isNumber(stroke.radius) || !isNumber(stroke.strength)) wrong("numbers of a stroke");
  if (!isList(stroke.dabs) || stroke.dabs.length % 6 !== 0) wrong("dabs of a stroke");
  const kind = (["fill", "invert", "file"] as const).find((name) => name === stroke.kind) ?? "brush";
  if (kind === "file" && typeof stroke.from !== "string") wrong("file of a stroke");
  const [along, erase, mirror] = [stroke.along, stroke.erase, stroke.mirror].map((x) => x === true);
  return { ...stroke, kind, along: along!, erase: erase!, mirror: mirror! };
}

/** The whole recipe in parsed JSON, null where there is none; throws Error where it lacks what the
 * page reads. */
export function ownRecipeOf(json: unknown): OwnRecipe | null {
  if (json === undefined || json === null) return null;
  const recipe = json as OwnRecipe;
  const { seed, layer, evolution, picture, post } = recipe;
  if (typeof post !== "object" || post === null) wrong("recipe");
  const numbers = [seed, layer?.relative_spacing, evolution?.max_load];
  if (!numbers.every(isNumber) || typeof picture?.material !== "string") wrong("recipe");
  if (!isValue(layer.spacing)) wrong("recipe");
  for (const key of [...Object.values(openingKeys), "roughness"]) {
    if (!isValue(post[key])) wrong(`post.${key} of the recipe`);
  }
  return recipe;
}

function openingsOf(value: Json): Openings {
  const read = (name: string) =>
    numberOr(value[name], null, name, name === "curl" ? -Infinity : 0);
  return Object.fromEntries(openingNames.map((name) => [name, read(name)])) as Openings;
}

/** The project in parsed JSON; throws Error where it is none. */
export function projectOf(json: unknown): Project {
  if (typeof json !== "object" || json === null) wrong("not an object");
  const value = json as Json;
  const source = (value["source"] ?? firstProject.source) as Json;
  const named = source["kind"] === "shape" ? source["specification"] : source["name"];
  if (typeof named !== "string" || !["shape", "file"].includes(String(source["kind"]))) {
    wrong("source");
  }
  const preset = value["preset"] ?? firstProject.preset;
  if (typeof preset !== "string") wrong("preset");
  const strokes = value["strokes"] ?? [];
  const impacts = value["impacts"] ?? [];
  if (!Array.isArray(strokes)) wrong("strokes");
  if (!Array.isArray(impacts) || !impacts.every((point) => isList(point, 3))) wrong("impacts");
  return {
    source: source as unknown as Project["source"],
    preset,
    recipe: ownRecipeOf(value["recipe"]),
    seed: numberOr(value["seed"], firstProject.seed, "seed", 0),
    spacing: numberOr(value["spacing"], null, "spacing", 0),
    load: numberOr(value["load"], null, "load", 0),
    ...openingsOf(value),
    lineColor: numberOr(value["lineColor"], firstProject.lineColor, "lineColor", 0) & 0xffffff,
    strokes: strokes.map(strokeOf),
    impacts: impacts as unknown as Project["impacts"],
  };
}

async function through(bytes: Uint8Array, stream: ReadableWritablePair): Promise<Uint8Array> {
  const piped = new Blob([bytes as BlobPart]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}

/** What stands behind the # of a shared address. */
export async function toHash(project: Project): Promise<string> {
  const text = new TextEncoder().encode(JSON.stringify(project));
  const packed = await through(text, new CompressionStream("deflate-raw"));
  let binary = "";
  for (const byte of packed) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** Throws Error where the text is no project. */
export async function fromHash(hash: string): Promise<Project> {
  try {
    const binary = atob(hash.replaceAll("-", "+").replaceAll("_", "/"));
    const packed = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
    const text = await through(packed, new DecompressionStream("deflate-raw"));
    return projectOf(JSON.parse(new TextDecoder().decode(text)));
  } catch {
    throw new Error("this address holds no project of craze that can be read");
  }
}
