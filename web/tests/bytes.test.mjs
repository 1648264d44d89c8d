// What the page exports is what its command line writes, to the last byte. Needs the command:
// CRAZE_COMMAND, or build/release/craze.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { newSession, pageModules, presetNames, web } from "./session.mjs";

const command = process.env.CRAZE_COMMAND ?? join(web, "../build/release/craze");
const skip = existsSync(command) ? false : "no craze command";
const shapes = ["plate?n=30&jitter=0.3", "cup?n=48"];
const coarse = 0.25; // spacing: what is compared are bits, and few triangles have all kinds of them
const hash = (bytes) => createHash("sha256").update(bytes).digest("hex");

let Session, firstProject, recipe, canvasOf, Painting, layers, folder;
before(async () => {
  const modules = await pageModules([
    "engine/session",
    "project/project",
    "project/recipe",
    "paint/brush",
    "paint/painting",
    "paint/layers",
  ]);
  [{ Session }, { firstProject }, recipe, { canvasOf }, { Painting }, { layers }] = modules;
  folder = mkdtempSync(join(tmpdir(), "craze-"));
});
after(() => rmSync(folder, { recursive: true }));

/** Runs the line that the page shows, in the folder. */
function runLine(line) {
  const quoted = line.replace(/^craze /, `'${command}' `);
  execFileSync("bash", ["-c", `${quoted} --quiet --no-warnings`], { cwd: folder });
}

async function exported(project, name) {
  const session = await newSession(Session);
  session.crack({
    input: { kind: "shape", specification: project.source.specification },
    painted: [],
    recipe: { preset: project.preset, set: recipe.changedKeys(project) },
  });
  return session.write(name, project).find((file) => file.name === name).bytes;
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

for (const format of ["ply", "obj"]) {
  test(`an opened mesh with walls gives the command's ${format}`, { skip }, async () => {
    const source = { kind: "shape", specification: shapes[1] };
    const open = { gap: 0.05, wall: 0.01, curl: 0.5 };
    const project = { ...firstProject, source, spacing: coarse, load: 2, ...open };
    const name = `opened.${format}`;
    runLine(recipe.commandLine(project, name));
    assert.equal(hash(await exported(project, name)), hash(readFileSync(join(folder, name))));
  });
}

test("what was painted gives the command's bytes, by the exported input", { skip }, async () => {
  const source = { kind: "shape", specification: shapes[0] };
  const stroke = { layer: "mask", radius: 20000, strength: 90, erase: false, mirror: true };
  const strokes = [{ ...stroke, dabs: [16000, 30000, 0, 0, 0, 127, 20000, 36000, 0, 0, 0, 127] }];
  const project = { ...firstProject, source, spacing: coarse, strokes };
  const input = { kind: "shape", specification: source.specification };
  const session = await newSession(Session);
  const mesh = session.look(input);
  const painting = new Painting(canvasOf(mesh.positions, mesh.triangles));
  painting.follow(strokes);
  const values = Float32Array.from(painting.values("mask"), layers.mask.value);
  assert.ok(values.some((value) => value > 0.5) && values.some((value) => value === 0));
  const request = {
    input,
    painted: [{ name: layers.mask.attribute, values }],
    recipe: { preset: project.preset, set: recipe.changedKeys(project) },
  };
  const [painted] = session.paintedInput(request, "painted.ply");
  writeFileSync(join(folder, painted.name), painted.bytes);
  runLine(recipe.commandLine(project, "cracked.ply"));
  session.crack(request);
  const [page] = session.write("cracked.ply", project);
  assert.equal(hash(page.bytes), hash(readFileSync(join(folder, "cracked.ply"))));
});
