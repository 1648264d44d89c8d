// A scene before and after it cracked, as three.js shows both: with textures, a skin and animations.
// Needs the command: CRAZE_COMMAND, or build/release/craze.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { missing, openBrowser } from "./page.mjs";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const command = process.env.CRAZE_COMMAND ?? join(web, "../build/release/craze");
const scene = join(web, "../tests/gltf/truck.py");
const needed = missing ?? [command, scene].find((path) => !existsSync(path));
const skip = needed ? `no ${needed}` : false;

const width = 360;
const height = 240;
const near = 2; // pixels
const fine = 4; // samples along a pixel's side, of which a new vertex on an edge may turn one
const moments = [0, 0.5]; // seconds

const viewer = `<!doctype html><link rel="icon" href="data:,">
<script type="importmap">
  {"imports": {"three": "/three/build/three.module.js", "three/": "/three/"}}
</script>
<script type="module">
  import * as three from "three";
  import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

  const canvas = document.body.appendChild(document.createElement("canvas"));
  const renderer = new three.WebGLRenderer({ canvas, preserveDrawingBuffer: true });
  renderer.setSize(${fine * width}, ${fine * height});
  const isCrack = (thing) => /^crack_line/.test(thing.material?.name);

  /** RGBA rows of the scene at a moment of all its animations: whole, and its lines alone. */
  globalThis.show = async (file, moment) => {
    const { scene, animations, cameras } = await new GLTFLoader().loadAsync(file);
    scene.add(new three.AmbientLight(0xffffff, 0.5));
    const mixer = new three.AnimationMixer(scene);
    for (const clip of animations) mixer.clipAction(clip).play();
    mixer.setTime(moment);
    /** Means over pixels. */
    const pixels = () => {
      renderer.render(scene, cameras[0]);
      const gl = renderer.getContext();
      const samples = new Uint8Array(4 * ${fine * fine * width * height});
      gl.readPixels(0, 0, ${fine * width}, ${fine * height}, gl.RGBA, gl.UNSIGNED_BYTE, samples);
      const rows = new Array(4 * ${width * height}).fill(0);
      for (let i = 0; i < samples.length; ++i) {
        const x = Math.floor(((i >> 2) % ${fine * width}) / ${fine});
        const y = Math.floor((i >> 2) / ${fine * fine * width});
        rows[4 * (y * ${width} + x) + (i & 3)] += samples[i] / ${fine * fine};
      }
      return rows;
    };
    const names = { nodes: [], materials: new Set() };
    const whole = pixels();
    const lines = new Set();
    scene.traverse((thing) => {
      if (isCrack(thing)) return lines.add(thing);
      if (thing.name) names.nodes.push(thing.name);
      if (!thing.isMesh) return;
      names.materials.add(thing.material.name);
      thing.material.visible = false;
    });
    scene.background = null;
    for (const line of lines) {
      line.material = new three.MeshBasicMaterial({ side: three.DoubleSide });
    }
    const alone = pixels();
    return {
      whole,
      alone,
      lines: lines.size,
      nodes: names.nodes.filter((name) => !/^crack_lines/.test(name)).sort(),
      materials: [...names.materials].sort(),
      clips: animations.map((clip) => clip.name).sort(),
    };
  };
  document.title = "ready";
</script>`;

const said = [];
let folder, browser, page;
before(async () => {
  if (skip) return;
  folder = mkdtempSync(join(tmpdir(), "craze-"));
  writeFileSync(join(folder, "viewer.html"), viewer);
  const run = (program, ...rest) => execFileSync(program, rest, { cwd: folder });
  run("python3", scene, "truck.glb");
  const glaze = ["--preset", "glaze", "--set", "layer.relative_spacing=0.12", "--quiet"];
  run(command, "crack", "truck.glb", ...glaze, "-o", "cracked.glb");
  const fileOf = (path) => join(path.startsWith("/three/") ? join(web, "node_modules") : folder, path);
  browser = await openBrowser(fileOf);
  page = await browser.browser.newPage();
  page.on("pageerror", (error) => said.push(error.message));
  page.on("console", (message) => message.type() === "error" && said.push(message.text()));
  await page.goto(`${browser.origin}/viewer.html`);
  await page.waitForFunction(() => document.title === "ready");
});
after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});

const show = (file, moment) => page.evaluate(([f, m]) => globalThis.show(f, m), [file, moment]);

/** Where a pixel within `near` of one that is lit is. */
function around(rows) {
  const found = new Uint8Array(width * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      if (rows[4 * (y * width + x)] === 0) continue;
      for (let v = Math.max(y - near, 0); v <= Math.min(y + near, height - 1); ++v) {
        found.fill(1, v * width + Math.max(x - near, 0), v * width + Math.min(x + near, width - 1) + 1);
      }
    }
  }
  return found;
}

const farthest = (a, b) => a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i])), 0);

test("three.js shows a cracked scene as it was but for its cracks", { skip }, async () => {
  const start = await show("truck.glb", moments[0]);
  const later = await show("truck.glb", moments[1]);
  assert.ok(farthest(start.whole, later.whole) > 60, "nothing moves");
  for (const moment of moments) {
    const whole = moment === moments[0] ? start : later;
    const cracked = await show("cracked.glb", moment);
    for (const kind of ["nodes", "materials", "clips"]) assert.deepEqual(cracked[kind], whole[kind]);
    assert.ok(cracked.lines > 0);
    const mask = around(cracked.alone);
    const share = mask.reduce((sum, one) => sum + one, 0) / mask.length;
    assert.ok(share > 0.01 && share < 0.6, `cracks cover ${share} of the picture`);
    let apart = 0;
    let at = 0;
    for (let i = 0; i < 4 * width * height; ++i) {
      const difference = Math.abs(whole.whole[i] - cracked.whole[i]);
      if (mask[i >> 2]) at = Math.max(at, difference);
      else apart = Math.max(apart, difference);
    }
    assert.ok(at > 60, `no crack is seen: ${at} of 255`);
    assert.ok(apart <= 255 / fine ** 2, `at ${moment} s pixels away from cracks differ by ${apart} of 255`);
    console.log(`${moment} s: cracks near ${share.toFixed(3)}, differs by ${apart.toFixed(1)} of 255 away from them, by ${at.toFixed(1)} at them`);
  }
  assert.deepEqual(said, []);
});
