// What the page exports is what its command line writes, to the last byte. Needs the command:
// CRAZE_COMMAND, or build/release/craze.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { inflateSync } from "node:zlib";
import { after, before, test } from "node:test";
import { newSession, pageModules, presetNames, web } from "./session.mjs";

const command = process.env.CRAZE_COMMAND ?? join(web, "../build/release/craze");
const skip = existsSync(command) ? false : "no craze command";
const shapes = ["plate?n=30&jitter=0.3", "cup?n=48"];
const coarse = 0.25; // spacing: what is compared are bits, and few triangles have all kinds of them
const hash = (bytes) => createHash("sha256").update(bytes).digest("hex");

let Session, firstProject, openings, recipe, canvasOf, Painting, paintedAttributes, folder;
before(async () => {
  const modules = await pageModules([
    "engine/session",
    "project/project",
    "project/openings",
    "project/recipe",
    "paint/canvas",
    "paint/painting",
    "paint/layers",
  ]);
  [{ Session }, { firstProject }, openings, recipe, { canvasOf }, { Painting }, { paintedAttributes }] = modules;
  folder = mkdtempSync(join(tmpdir(), "craze-"));
});
after(() => rmSync(folder, { recursive: true }));

/** Runs the line that the page shows, in the folder. */
function runLine(line) {
  const quoted = line.replace(/^craze /, `'${command}' `);
  execFileSync("bash", ["-c", `${quoted} --quiet --no-warnings`], { cwd: folder });
}

const requestOf = (project) => ({
  input: { kind: "shape", specification: project.source.specification },
  painted: [],
  recipe: recipe.recipeRequest(project),
});

async function exported(project, name) {
  const session = await newSession(Session);
  session.crack(requestOf(project));
  return session.write(name, openings.postText(project)).find((file) => file.name === name).bytes;
}

for (const specification of shapes) {
  for (const preset of presetNames) {
    test(`${preset} on ${specification} gives the command's bytes`, { skip }, async () => {
      const source = { kind: "shape", specification };
      const project = { ...firstProject, source, preset, seed: 3, spacing: coarse };
      runLine(recipe.commandLine(project, "cracked.ply"));
      const wanted = hash(readFileSync(join(folder, "cracked.ply")));
      assert.equal(hash(await exported(project, "cracked.ply")), wanted);
    });
  }
}

for (const format of ["ply", "obj", "glb", "usda"]) {
  test(`an opened mesh with walls gives the command's ${format}`, { skip }, async () => {
    const source = { kind: "shape", specification: shapes[1] };
    const open = { gap: 0.05, wall: 0.01, curl: 0.5 };
    const project = { ...firstProject, source, spacing: coarse, load: 2, ...open };
    const name = `opened.${format}`;
    runLine(recipe.commandLine(project, name));
    assert.equal(hash(await exported(project, name)), hash(readFileSync(join(folder, name))));
  });
}

const finished = {
  "rough lines": { roughness: 0.08, gap: 0.05, wall: 0.01 },
  "thin late cracks of a mean opening": { lateWidth: 0.2, gap: 0.1, gapWidth: 0.004, wall: 0.01 },
  "solids": { thickness: 0.03, gap: 0.05 },
  "solids with rough lines": { thickness: 0.03, roughness: 0.05 },
  "gaping solids with rough lines": { thickness: 0.03, roughness: 0.05, gap: 0.05 },
  "a gap where the preset has a mean opening": { preset: "bark", gap: 0.05, wall: 0.01 },
  "smooth lines where the preset's are rough": { preset: "drying-front", roughness: 0 },
};
for (const [name, change] of Object.entries(finished)) {
  test(`${name} of a finished run give the command's bytes`, { skip }, async () => {
    const source = { kind: "shape", specification: shapes[1] };
    const project = { ...firstProject, source, spacing: coarse, load: 2, ...change };
    runLine(recipe.commandLine(project, "finished.glb"));
    const wanted = hash(readFileSync(join(folder, "finished.glb")));
    const bytes = await exported(project, "finished.glb");
    assert.equal(hash(bytes), wanted);
    const before = { ...project, roughness: 0.02, thickness: 0, gap: 0.01, gapWidth: 0 };
    assert.notEqual(hash(await exported(before, "finished.glb")), wanted);
  });
}

test("shut cracks are lines in GLB, as the command writes them", { skip }, async () => {
  const source = { kind: "shape", specification: shapes[1] };
  const project = { ...firstProject, source, spacing: coarse };
  runLine(recipe.commandLine(project, "lines.glb"));
  const bytes = await exported(project, "lines.glb");
  assert.match(new TextDecoder().decode(bytes), /"mode":1/);
  assert.equal(hash(bytes), hash(readFileSync(join(folder, "lines.glb"))));
});

test("cracks are told as they open, all of them and in their order", async () => {
  const pieces = [];
  const opened = (some) => {
    assert.equal(some.first, pieces.length / 6);
    pieces.push(...some.pieces);
  };
  const session = await newSession(Session, { progress: () => {}, opened });
  const input = { kind: "shape", specification: shapes[0] };
  const set = [["layer.spacing", "0.25"], ["mesh.output", '"simulation"'], ["layer.rounds", "0"]];
  const summary = session.crack({ input, painted: [], recipe: { base: { preset: "glaze" }, set } });
  let length = 0;
  for (let i = 0; i < pieces.length; i += 6) {
    length += Math.hypot(pieces[i + 3] - pieces[i], pieces[i + 4] - pieces[i + 1]);
  }
  // Some vertices slide after a piece was told.
  assert.ok(Math.abs(length / summary.length - 1) < 0.02, `${length}, ${summary.length}`);
});

test("a recipe of one's own comes back from TOML, and gives the command's bytes", { skip }, async () => {
  const source = { kind: "shape", specification: shapes[1] };
  const session = await newSession(Session);
  const post = `gap = 0.04\nwall = "2cm"\nthickness = "3cm"\nroughness = 0.01\n`;
  const mesh = `[mesh]\nunit = "m"\n`;
  const own = `seed = 5\n[layer]\nspacing = ${coarse}\n[material]\nscatter = 0.3\n[post]\n${post}${mesh}`;
  const { json } = session.recipe({ base: { text: own, name: "own.toml" }, set: [] });
  const change = recipe.ofOwnRecipe(JSON.parse(json));
  const project = { ...firstProject, source, ...change, load: 3 };
  assert.equal(openings.openingOf(project, "gap"), 0.04);
  const { toml } = session.recipe(recipe.wholeRecipe(project));
  assert.match(toml, /^seed = 5$[^]*^scatter = 0\.3$[^]*^max_load = 3\.0$/m);
  assert.equal(session.recipe({ base: { text: toml, name: "again" }, set: [] }).toml, toml);
  writeFileSync(join(folder, "recipe.toml"), toml);
  runLine(recipe.commandLine(project, "own.ply"));
  assert.equal(hash(await exported(project, "own.ply")), hash(readFileSync(join(folder, "own.ply"))));
});

/** What a PNG holds, unpacked. */
function unpacked(png) {
  const parts = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    if (png.toString("latin1", at + 4, at + 8) !== "IDAT") continue;
    parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  }
  return inflateSync(Buffer.concat(parts));
}

test("maps have the pixels of the command's", { skip }, async () => {
  const source = { kind: "shape", specification: shapes[1] };
  const opened = { gapWidth: 0.004, wall: 0.02, roughness: 0.08, lateWidth: 0.3 };
  const project = { ...firstProject, source, spacing: coarse, ...opened };
  runLine(`${recipe.commandLine(project, "mapped.ply")} --maps maps --map-size 64`);
  const session = await newSession(Session);
  session.crack(requestOf(project));
  const files = await session.maps(64, openings.postText(project));
  assert.equal(files.length, 13);
  for (const { name, bytes } of files.filter(({ name }) => name.endsWith(".png"))) {
    const wanted = unpacked(readFileSync(join(folder, "maps", name)));
    assert.equal(hash(unpacked(Buffer.from(bytes))), hash(wanted), name);
  }
});

const brush = { kind: "brush", radius: 20000, strength: 90, along: false, erase: false, mirror: true };
const dabs = [16000, 30000, 0, 0, 0, 127, 20000, 36000, 0, 0, 0, 127];
const painted = {
  "a mask": [{ ...brush, layer: "mask", dabs }],
  "an inverted mask": [
    { ...brush, layer: "mask", dabs },
    { ...brush, layer: "mask", kind: "invert", dabs: [] },
  ],
  "a stress along the stroke": [
    { ...brush, layer: "stress", kind: "fill", strength: 10, dabs: [] },
    { ...brush, layer: "stress", along: true, dabs },
  ],
};
for (const [name, strokes] of Object.entries(painted)) {
  test(`${name} gives the command's bytes, by the exported input`, { skip }, () =>
    expectPaintedBytes(strokes));
}

async function expectPaintedBytes(strokes) {
  const source = { kind: "shape", specification: shapes[0] };
  const project = { ...firstProject, source, spacing: coarse, strokes };
  const input = { kind: "shape", specification: source.specification };
  const session = await newSession(Session);
  const mesh = session.look(input);
  const painting = new Painting(canvasOf(mesh.positions, mesh.triangles));
  painting.follow(strokes);
  const attributes = paintedAttributes(project, painting);
  const [{ values }] = attributes;
  assert.ok(new Set(values).size > 3);
  const request = {
    input,
    painted: attributes,
    recipe: recipe.recipeRequest(project),
  };
  const [painted] = session.paintedInput(request, "painted.ply");
  writeFileSync(join(folder, painted.name), painted.bytes);
  runLine(recipe.commandLine(project, "cracked.ply"));
  session.crack(request);
  const [page] = session.write("cracked.ply", openings.postText(project));
  assert.equal(hash(page.bytes), hash(readFileSync(join(folder, "cracked.ply"))));
}
