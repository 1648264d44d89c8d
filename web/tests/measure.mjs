// What the page takes, against the command on one thread. `npm run measure`, on a machine that does
// nothing else; prints rows of a table. Times are the least of some, the two by turns.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { addressOf, button, cracked, loadOf, memoryOfBrowsers, openBrowser, progress, still, visit } from "./page.mjs";
import { web } from "./session.mjs";

const command = process.env.CRAZE_COMMAND ?? join(web, "../build/release/craze");
const times = 3;
const folder = mkdtempSync(join(tmpdir(), "craze-"));
const say = (what, value) => console.log(`| ${what} | ${value} |`);
const least = (values) => Math.min(...values);

/** Seconds of the command from its start to the written file. */
function native(...words) {
  const begin = performance.now();
  const output = join(folder, "native.ply");
  execFileSync(command, ["crack", ...words, "-o", output, "--threads", "1", "--quiet", "--no-warnings"]);
  return (performance.now() - begin) / 1000;
}

/** In the page: a run by a press of a button; milliseconds to its first crack and to its end, the
 * longest time between two frames, and the longest task of the page's thread while it is at work. */
async function watch(name) {
  const region = document.querySelector("[role=status]");
  region.textContent = "";
  const tasks = [0];
  const observer = new PerformanceObserver((list) => tasks.push(...list.getEntries().map((e) => e.duration)));
  observer.observe({ type: "longtask" });
  const begin = performance.now();
  [...document.querySelectorAll("button")].find((made) => made.textContent === name).click();
  let [first, longest, last] = [null, 0, performance.now()];
  for (;;) {
    await new Promise(requestAnimationFrame);
    const now = performance.now();
    longest = Math.max(longest, now - last);
    last = now;
    if (first === null && /^crack: \d|fragments in/.test(region.textContent)) first = now - begin;
    if (/fragments in/.test(region.textContent)) break;
  }
  const whole = performance.now() - begin;
  await new Promise((resolve) => setTimeout(resolve, 100));
  observer.disconnect();
  return { first, whole, longest, task: Math.max(...tasks) };
}

async function cold(browser) {
  const context = await browser.browser.newContext(still);
  await context.addInitScript(() => {
    const look = () => {
      const ready = [...document.querySelectorAll("button")].some((made) => made.textContent === "Open");
      if (ready) globalThis.interactive = performance.now();
      else requestAnimationFrame(look);
    };
    look();
  });
  const page = await context.newPage();
  const bytes = loadOf(page);
  await page.goto(browser.address);
  await cracked(page);
  const found = await page.evaluate(() => [globalThis.interactive, performance.now()]);
  const loaded = bytes();
  await context.close();
  return { interactive: found[0], there: found[1], bytes: loaded };
}

async function twentyThousand(browser) {
  const shape = "plate?n=100&jitter=0.3";
  const start = addressOf({ source: { kind: "shape", specification: shape }, spacing: 0.1 });
  const { page, leave } = await visit(browser, still, start);
  await cracked(page);
  const [runs, natives] = [[], []];
  for (let i = 0; i < 2 * times; ++i) {
    const keys = ["layer.spacing=0.1", `seed=${i + 2}`].flatMap((key) => ["--set", key]);
    natives.push(native(`shape:${shape}`, "--preset", "glaze", ...keys));
    runs.push(await page.evaluate(watch, "New seed"));
  }
  const of = (name) => least(runs.map((run) => run[name]));
  const worst = (name) => Math.max(...runs.map((run) => run[name]));
  const wholes = runs.map((run, i) => run.whole / 1000 / natives[i]);
  say("first crack drawn after a change, 20,000 triangles", `${(of("first") / 1000).toFixed(2)} s`);
  say("whole run, the command's on one thread being 1", least(wholes).toFixed(2));
  say("the command", `${least(natives).toFixed(2)} s`);
  say("longest task of the page's own thread meanwhile", `${worst("task").toFixed(0)} ms`);
  say("longest time between two frames, best and worst run", `${of("longest").toFixed(0)}, ${worst("longest").toFixed(0)} ms`);
  await leave();
}

/** A torus of 2 · side² triangles with bumps, binary PLY. */
function large(side) {
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${side * side}\nproperty float x\nproperty float y\nproperty float z\nelement face ${2 * side * side}\nproperty list uchar int vertex_indices\nend_header\n`;
  const places = new Float32Array(3 * side * side);
  const faces = Buffer.alloc(26 * side * side);
  for (let i = 0; i < side; ++i) {
    for (let j = 0; j < side; ++j) {
      const [u, v] = [(2 * Math.PI * i) / side, (2 * Math.PI * j) / side];
      const r = 0.4 + 0.01 * Math.sin(9 * u) * Math.sin(7 * v);
      places.set([(1 + r * Math.cos(v)) * Math.cos(u), (1 + r * Math.cos(v)) * Math.sin(u), r * Math.sin(v)], 3 * (i * side + j));
      const corner = (a, b) => ((i + a) % side) * side + ((j + b) % side);
      const corners = [[corner(0, 0), corner(1, 0), corner(1, 1)], [corner(0, 0), corner(1, 1), corner(0, 1)]];
      corners.forEach((three, k) => {
        const at = 13 * (2 * (i * side + j) + k);
        faces[at] = 3;
        three.forEach((vertex, c) => faces.writeInt32LE(vertex, at + 1 + 4 * c));
      });
    }
  }
  return Buffer.concat([Buffer.from(header), Buffer.from(places.buffer), faces]);
}

async function halfAMillion(browser) {
  const small = addressOf({ source: { kind: "shape", specification: "plate?n=8" }, spacing: 0.5 });
  const { page, leave } = await visit(browser, still, small);
  page.setDefaultTimeout(600_000);
  await cracked(page);
  const file = join(folder, "large.ply");
  writeFileSync(file, large(500));
  let peak = 0;
  const timer = setInterval(() => (peak = Math.max(peak, memoryOfBrowsers())), 200);
  const idle = memoryOfBrowsers();
  const clock = async (what, body) => {
    const begin = performance.now();
    await body();
    say(what, `${((performance.now() - begin) / 1000).toFixed(1)} s`);
  };
  const bar = () => page.evaluate(() => document.querySelector(".panel > progress").classList.contains("idle"));
  await clock("500,000 triangles: read, cracked and seen", async () => {
    const [chooser] = await Promise.all([page.waitForEvent("filechooser"), button(page, "Open").click()]);
    await chooser.setFiles(file);
    await progress(page).filter({ hasText: /^(load|start|repair|remesh|prepare|crack)/ }).waitFor();
    if (await bar()) throw new Error("there is no progress bar");
    await cracked(page);
  });
  for (const format of ["PLY", "GLB"]) {
    await clock(`the same exported as ${format}`, async () => {
      await page.getByRole("combobox", { name: "Export format" }).selectOption({ label: format });
      const [download] = await Promise.all([page.waitForEvent("download"), button(page, "Export").click()]);
      await download.path();
    });
  }
  clearInterval(timer);
  say("the command on one thread", `${native(file, "--preset", "glaze").toFixed(1)} s`);
  say("memory at most, all processes of the browser", `${(peak / 1e9).toFixed(2)} GB`);
  say("of which the browser with a small plate", `${(idle / 1e9).toFixed(2)} GB`);
  await leave();
}

const browser = await openBrowser();
try {
  const colds = [];
  for (let i = 0; i < times; ++i) colds.push(await cold(browser));
  say("first load, by gzip", `${(colds[0].bytes / 1e6).toFixed(2)} MB`);
  say("controls answer, cold cache", `${(least(colds.map((c) => c.interactive)) / 1000).toFixed(2)} s`);
  say("the cracked cup is there, cold cache", `${(least(colds.map((c) => c.there)) / 1000).toFixed(2)} s`);
  await twentyThousand(browser);
  await halfAMillion(browser);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
