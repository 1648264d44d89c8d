// What should not hurt: broken files, a worker that ends, run after run.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  addressOf,
  anew,
  browserOfTests,
  button,
  copied,
  cracked,
  memoryOfBrowsers,
  drop,
  exported,
  picture,
  progress,
  skip,
  still,
  visit,
} from "./page.mjs";

const plate = addressOf({ source: { kind: "shape", specification: "plate?n=8" }, spacing: 0.5 });

const browser = browserOfTests();

const triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const header = (rest) => `ply\nformat ascii 1.0\n${rest}end_header\n`;
const vertices = "property float x\nproperty float y\nproperty float z\n";
const faces = "property list uchar int vertex_indices\n";
const stl = (count) => [...Array(80).fill(32), ...new Uint8Array(new Uint32Array([count]).buffer)];
const glb = (json) => {
  const length = Math.ceil(json.length / 4) * 4;
  const head = new Uint8Array(new Uint32Array([0x46546c67, 2, 20 + length, length, 0x4e4f534a]).buffer);
  return [...head, ...Buffer.from(json.padEnd(length))];
};

// Each is none, or says what it is not.
const hostile = {
  "empty.obj": "",
  "no-vertex.obj": `${triangle}f 1 2 4\n`,
  "far-back.obj": `${triangle}f -1 -2 -9\n`,
  "nan.obj": "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
  "infinite.obj": "v 1e999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
  "letters.obj": "v a b c\nf x y z\n",
  "many.ply": header(`element vertex 4000000000\n${vertices}element face 1\n${faces}`),
  "negative.ply": header(`element vertex -1\n${vertices}`),
  "short.ply": `${header(`element vertex 3\n${vertices}element face 1\n${faces}`)}0 0 0\n`,
  "no-end.ply": "ply\nformat ascii 1.0\nelement vertex 3\n",
  "short.stl": stl(1000),
  "none.stl": stl(0),
  "noise.glb": Array.from({ length: 400 }, (_, i) => (i * 197 + 31) % 256),
  "cut.glb": [0x67, 0x6c, 0x54, 0x46, 2, 0, 0, 0],
  "no-json.glb": glb("{"),
  "loop.glb": glb('{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]}'),
  "no-buffer.glb": glb('{"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":7}}]}],"nodes":[{"mesh":0}]}'),
  "off.off": "OFF\n3 1 0\n0 0 0\n",
  "picture.png": "\x89PNG\r\n",
  "project.craze": '{"preset": 7}',
  "broken.craze": "{",
};

test("hostile files are one sentence each, and the page lives on", { skip }, async () => {
  const { page, leave } = await visit(browser, still, plate);
  await cracked(page);
  const bytes = await exported(page, "PLY");
  const command = await copied(page, "Copy command");
  const alert = page.getByRole("alert").filter({ hasText: /\w/ });
  for (const [name, content] of Object.entries(hostile)) {
    await drop(page, name, content);
    await alert.waitFor();
    const said = await alert.textContent();
    assert.doesNotMatch(said, /\n|undefined|\[object/, name);
    await button(page, "Copy command").click(); // takes the alert away
    await alert.waitFor({ state: "detached" });
  }
  assert.equal(await copied(page, "Copy command"), command);
  assert.deepEqual(await exported(page, "PLY"), bytes);
  await leave();
});

/** In the page: keeps the worker that was asked last to crack. */
function keepWorker() {
  const Own = globalThis.Worker;
  globalThis.Worker = class extends Own {
    postMessage(message, ...rest) {
      if (message.kind === "crack") globalThis.cracking = this;
      super.postMessage(message, ...rest);
    }
  };
}

test("a worker that is killed while it cracks takes nothing with it", { skip }, async () => {
  const stroke = {
    kind: "fill", layer: "strength", along: false, radius: 0, strength: 40, erase: false, mirror: false, dabs: [],
  };
  const painted = addressOf({ source: { kind: "shape", specification: "cup?n=48" }, spacing: 0.2, strokes: [stroke] });
  const { page, leave } = await visit(browser, { ...still, init: keepWorker }, painted);
  await cracked(page);
  const bytes = await exported(page, "PLY");
  const seen = await picture(page);
  await page.getByText("mud-mature").click();
  await progress(page).filter({ hasText: /crack: \d+ cracks/ }).waitFor();
  await page.evaluate(() => {
    globalThis.cracking.terminate(); // no event tells of it
  });
  await page.getByRole("alert").filter({ hasText: "The engine has stopped" }).waitFor();
  assert.deepEqual(await exported(page, "PLY"), bytes);
  assert.match(await copied(page, "Copy command"), /painted\.ply .*mud-mature.*paint_strength/);
  await anew(page, () => button(page, "Undo").click());
  assert.deepEqual(await exported(page, "PLY"), bytes);
  assert.equal(await picture(page), seen);
  await leave();
});

test("fifty runs take no more memory than ten", { skip }, async () => {
  const { page, leave } = await visit(browser, still, plate);
  await cracked(page);
  const runs = async (count) => {
    for (let i = 0; i < count; ++i) {
      await anew(page, () => button(page, "New seed").click());
    }
    const session = await page.context().newCDPSession(page);
    await session.send("HeapProfiler.collectGarbage");
    await session.detach();
    return memoryOfBrowsers();
  };
  const before = await runs(10);
  const after = await runs(40);
  // An instance of the engine alone would be 16 MB a run.
  assert.ok(after < before + 100e6, `${before / 1e6} MB, then ${after / 1e6} MB`);
  await leave();
});
