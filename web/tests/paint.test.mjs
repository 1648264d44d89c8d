// Paint that the file brings, and paint by keys.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { crc32, deflateSync } from "node:zlib";
import { test } from "node:test";
import {
  addressOf,
  anew,
  browserOfTests,
  button,
  copied,
  cracked,
  drop,
  exported,
  picture,
  skip,
  slider,
  still,
  violations,
  visit,
} from "./page.mjs";
import { web } from "./session.mjs";

const command = process.env.CRAZE_COMMAND ?? join(web, "../build/release/craze");
const withCommand = existsSync(command);

const browser = browserOfTests();
const paint = (page, name) => page.getByRole("radiogroup", { name: "Paint" }).getByText(name).click();
const ofTheFile = (page) => page.getByRole("combobox", { name: "Of the file" });
const says = (page) => page.locator(".brush-says");

/** What the copied command writes beside these files. */
function runs(line, files) {
  const folder = mkdtempSync(join(tmpdir(), "craze-"));
  try {
    for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
    const quoted = line.replace(/^craze /, `'${command}' `);
    execFileSync("bash", ["-c", `${quoted} --quiet --no-warnings`], { cwd: folder });
    return readFileSync(join(folder, "cracked.ply"));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const side = 16;

/** A square whose vertices are red at the left and green at the right. */
function coloredPlate() {
  const vertices = [];
  const faces = [];
  for (let j = 0; j <= side; ++j) {
    for (let i = 0; i <= side; ++i) {
      vertices.push(`${i / side} ${j / side} 0 ${i < side / 2 ? "255 0" : "0 255"} 0`);
      const v = j * (side + 1) + i;
      if (i === side || j === side) continue;
      faces.push(`3 ${v} ${v + 1} ${v + side + 2}`, `3 ${v} ${v + side + 2} ${v + side + 1}`);
    }
  }
  const colors = ["red", "green", "blue"].map((name) => `property uchar ${name}\n`).join("");
  const places = ["x", "y", "z"].map((name) => `property float ${name}\n`).join("");
  return `ply\nformat ascii 1.0\nelement vertex ${vertices.length}\n${places}${colors}element face ${faces.length}\nproperty list uchar int vertex_indices\nend_header\n${[...vertices, ...faces].join("\n")}\n`;
}

/** Black at the left, white at the right. */
function halvesPng() {
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc(body), 4);
    return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
  };
  const head = Buffer.from([0, 0, 0, 8, 0, 0, 0, 8, 8, 0, 0, 0, 0]);
  const row = Buffer.from([0, 0, 0, 0, 0, 255, 255, 255, 255]);
  const rows = deflateSync(Buffer.concat(Array(8).fill(row)));
  const end = chunk("IEND", Buffer.alloc(0));
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", head), chunk("IDAT", rows), end]);
}

function crc(bytes) {
  if (crc32) return crc32(bytes); // node 20.15
  let c = ~0;
  for (const byte of bytes) {
    c ^= byte;
    for (let k = 0; k < 8; ++k) c = (c >>> 1) ^ (c & 1 ? 0xedb88320 : 0);
  }
  return ~c >>> 0;
}

/** A square in GLB with that picture on it, but for its margin: pictures repeat. */
function texturedPlate() {
  const [places, uvs, indices] = [[], [], []];
  for (let j = 0; j <= side; ++j) {
    for (let i = 0; i <= side; ++i) {
      places.push(i / side, j / side, 0);
      uvs.push(0.1 + (0.8 * i) / side, 0.9 - (0.8 * j) / side);
      const v = j * (side + 1) + i;
      if (i < side && j < side) indices.push(v, v + 1, v + side + 2, v, v + side + 2, v + side + 1);
    }
  }
  const png = halvesPng();
  const parts = [new Float32Array(places), new Float32Array(uvs), new Uint32Array(indices), png].map(
    (part) => Buffer.concat([Buffer.from(part.buffer, part.byteOffset, part.byteLength), Buffer.alloc(-part.byteLength & 3)]),
  );
  let byteOffset = 0;
  const bufferViews = parts.map((part) => {
    const view = { buffer: 0, byteOffset, byteLength: part.length };
    byteOffset += part.length;
    return view;
  });
  const count = (side + 1) ** 2;
  const json = JSON.stringify({
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2, material: 0 }] }],
    materials: [{ name: "tile", pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    images: [{ bufferView: 3, mimeType: "image/png" }],
    accessors: [
      { bufferView: 0, componentType: 5126, count, type: "VEC3", min: [0, 0, 0], max: [1, 1, 0] },
      { bufferView: 1, componentType: 5126, count, type: "VEC2" },
      { bufferView: 2, componentType: 5125, count: indices.length, type: "SCALAR" },
    ],
    bufferViews,
    buffers: [{ byteLength: byteOffset }],
  });
  const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4));
  const head = (...numbers) => Buffer.from(new Uint32Array(numbers).buffer);
  return Buffer.concat([
    head(0x46546c67, 2, 28 + text.length + byteOffset, text.length, 0x4e4f534a), text,
    head(byteOffset, 0x004e4942), ...parts,
  ]);
}

const small = addressOf({ source: { kind: "shape", specification: "plate?n=8" }, spacing: 0.5 });

async function open(page, name, content) {
  await cracked(page);
  await anew(page, () => drop(page, name, content));
}

/** Of an exported SVG: from where to where its cracks go, from the left. */
function acrossOf(lines) {
  const places = [...lines.toString().matchAll(/[ML] ?([-\d.e]+)[ ,]/g)].map(([, x]) => Number(x));
  assert.ok(places.length > 4);
  return [Math.min(...places), Math.max(...places)];
}

test("a mask is taken from vertex colours, painted over and undone", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  const file = coloredPlate();
  await open(page, "colored.ply", file);
  const plain = await copied(page, "Copy command");
  assert.equal(await button(page, "Take").isDisabled(), true); // nothing to paint with
  await paint(page, "Mask");
  const bare = await picture(page);
  await ofTheFile(page).selectOption({ label: "Vertex colour, red" });
  await anew(page, () => button(page, "Take").click());
  assert.notEqual(await picture(page), bare); // the paint is seen
  const taken = await copied(page, "Copy command");
  assert.match(taken, /^craze crack colored\.ply .*where\.attribute="color_r"/);
  const bytes = await exported(page, "PLY");
  if (withCommand) assert.deepEqual(runs(taken, { "colored.ply": file }), bytes);
  const red = await exported(page, "Lines (SVG)"); // from the first crack on
  assert.ok(acrossOf(red)[1] < 0.6, acrossOf(red).join());
  await anew(page, () => button(page, "Invert").click());
  const inverted = await copied(page, "Copy command");
  assert.match(inverted, /^craze crack painted\.ply .*where\.attribute="paint_mask"/);
  const green = await exported(page, "Lines (SVG)");
  assert.ok(acrossOf(green)[0] > 0.4, acrossOf(green).join());
  assert.notDeepEqual(green, red);
  if (withCommand) {
    const painted = await exported(page, "Painted input (PLY)");
    assert.deepEqual(runs(inverted, { "painted.ply": painted }), await exported(page, "PLY"));
  }
  await anew(page, () => button(page, "Undo").click());
  assert.deepEqual(await exported(page, "PLY"), bytes);
  await anew(page, () => button(page, "Undo").click());
  assert.equal(await copied(page, "Copy command"), plain);
  await leave();
});

test("a mask is taken from a texture, and comes back with the project", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await open(page, "tile.glb", [...texturedPlate()]);
  await paint(page, "Mask");
  await ofTheFile(page).selectOption({ label: "Texture, grey" });
  await anew(page, () => button(page, "Take").click());
  const line = await copied(page, "Copy command");
  assert.match(line, /^craze crack painted\.ply .*where\.attribute="paint_mask"/);
  const lines = await exported(page, "Lines (SVG)"); // in the picture's own places
  assert.ok(acrossOf(lines)[0] > 0.4, acrossOf(lines).join());
  const bytes = await exported(page, "PLY");
  if (withCommand) {
    const painted = await exported(page, "Painted input (PLY)");
    assert.deepEqual(runs(line, { "painted.ply": painted }), bytes);
  }
  const [saved] = await Promise.all([page.waitForEvent("download"), button(page, "Save project").click()]);
  const project = readFileSync(await saved.path(), "utf8");
  await anew(page, () => drop(page, "other.ply", coloredPlate()));
  await anew(page, () => drop(page, "project.craze", project));
  assert.deepEqual(await exported(page, "PLY"), bytes);
  await page.goto("about:blank");
  await page.goto(browser.address); // what the browser kept
  await cracked(page);
  assert.deepEqual(await exported(page, "PLY"), bytes);
  const wrong = project.replace('"from":"texture"', '"from":"texture:q"');
  assert.notEqual(wrong, project);
  await drop(page, "project.craze", wrong);
  await page.getByRole("alert").filter({ hasText: "texture:q" }).waitFor();
  await leave();
});

test("a stroke is drawn by keys, told and undone", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  const plain = await copied(page, "Copy command");
  await paint(page, "Mask");
  const bare = await picture(page);
  const view = page.locator(".view canvas");
  for (let i = 0; i < 60 && !(await view.evaluate((canvas) => canvas === document.activeElement)); ++i) {
    await page.keyboard.press("Shift+Tab");
  }
  assert.match(await says(page).textContent(), /^Brush: 50 % from the left.*Space puts it down/);
  assert.equal(await page.locator(".ring").isVisible(), true);
  await page.keyboard.press("ArrowLeft");
  assert.match(await says(page).textContent(), /^Brush: 46 % from the left/);
  await page.keyboard.press("Shift+ArrowLeft");
  assert.match(await says(page).textContent(), /^Brush: 46 % /); // 4 pixels
  assert.equal(await copied(page, "Copy command"), plain); // nothing is painted yet
  await view.focus();
  const size = Number(await slider(page, "Brush size").getAttribute("aria-valuetext"));
  await page.keyboard.press("]");
  const larger = Number(await slider(page, "Brush size").getAttribute("aria-valuetext"));
  assert.ok(Math.abs(larger / size - 1.25) < 0.05, `${size}, ${larger}`);
  await page.keyboard.press("Space");
  assert.match(await says(page).textContent(), /^Brush down: /);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Escape");
  assert.match(await says(page).textContent(), /taken back/);
  assert.equal(await button(page, "Undo").isDisabled(), true);
  await page.keyboard.press("Space");
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowRight");
  await anew(page, () => page.keyboard.press("Space"));
  assert.match(await copied(page, "Copy command"), /painted\.ply .*where\.attribute="paint_mask"/);
  assert.notEqual(await picture(page), bare);
  await anew(page, () => page.keyboard.press("Control+z"));
  assert.equal(await copied(page, "Copy command"), plain);
  await leave();
});

test("a blow falls by a key, and the view turns beside it", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  await paint(page, "Impact");
  const view = page.locator(".view canvas");
  await view.focus();
  const before = await picture(page);
  await page.keyboard.press("Control+ArrowLeft");
  assert.notEqual(await picture(page), before); // turned
  for (let i = 0; i < 40; ++i) await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  assert.match(await says(page).textContent(), /^Hammer: .* 0 % from the top, off the surface\.$/);
  assert.equal(await button(page, "Undo").isDisabled(), true);
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowDown");
  await anew(page, () => page.keyboard.press("Enter"));
  assert.match(await copied(page, "Copy command"), /impact\.0\.point=/);
  await leave();
});

test("all keys are listed", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  await page.keyboard.press("?");
  const dialog = page.getByRole("dialog", { name: "Keys" });
  await dialog.waitFor();
  await dialog.getByRole("row", { name: /Space or Enter/ }).waitFor();
  assert.deepEqual(await violations(page), []);
  await page.keyboard.press("Escape");
  assert.equal(await dialog.isVisible(), false);
  await button(page, "Keys").click();
  await dialog.getByRole("button", { name: "Close" }).click();
  await leave();
});
