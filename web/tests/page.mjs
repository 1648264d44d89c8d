// The built page in Debian's Chromium, from a folder below the root of a plain file server.
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { dirname, extname, join, normalize } from "node:path";
import { after, before } from "node:test";
import { fileURLToPath } from "node:url";
import { deflateRawSync, gzipSync } from "node:zlib";
import { chromium } from "playwright-core";

const dist = join(dirname(dirname(fileURLToPath(import.meta.url))), "dist");
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
export const missing = [executablePath, dist].find((path) => !existsSync(path));
export const skip = missing ? `no ${missing}` : false;

const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };
const below = "/some/where/";

const ofThePage = (path) =>
  path.startsWith(below) ? join(dist, path.slice(below.length) || "index.html") : "";

function serve(fileOf) {
  const server = createServer((request, response) => {
    const file = fileOf(normalize(new URL(request.url, "http://localhost").pathname));
    if (!existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" });
    response.end(readFileSync(file));
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

/** A browser, and a server of what `fileOf` has for a path. */
export async function openBrowser(fileOf = ofThePage) {
  const server = await serve(fileOf);
  const browser = await chromium.launch({
    executablePath,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  const origin = `http://127.0.0.1:${server.address().port}`;
  const close = async () => {
    await browser.close();
    server.close();
  };
  return { browser, origin, address: origin + below, close };
}

/** Bytes of memory that this process's browsers hold, what they share counted once. */
export function memoryOfBrowsers() {
  const parents = new Map();
  for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      parents.set(pid, readFileSync(`/proc/${pid}/stat`, "utf8").replace(/.*\) /, "").split(" ")[1]);
    } catch {
      // It has ended.
    }
  }
  const isOurs = (pid) => pid === String(process.pid) || (parents.has(pid) && isOurs(parents.get(pid)));
  let bytes = 0;
  for (const pid of parents.keys()) {
    if (pid === String(process.pid) || !isOurs(pid)) continue;
    try {
      const rollup = readFileSync(`/proc/${pid}/smaps_rollup`, "utf8");
      bytes += 1024 * Number(/^Pss: +(\d+)/m.exec(rollup)[1]);
    } catch {
      // Likewise.
    }
  }
  return bytes;
}

/** A browser for all tests of a file, there once they run. */
export function browserOfTests() {
  const held = {};
  before(async () => {
    if (!skip) Object.assign(held, await openBrowser());
  });
  after(() => held.close?.());
  return held;
}

/** In the page: what a canvas has drawn stays in it, so that it can be looked at from within. */
function keepDrawings() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, { ...options, preserveDrawingBuffer: true });
  };
}

/** A new person's page. Nothing may be said on its console, and nothing asked of another origin:
 * leave() looks. */
export async function visit({ browser, origin, address }, { init, ...options } = {}, hash = "") {
  const context = await browser.newContext({ acceptDownloads: true, ...options });
  await context.grantPermissions(["clipboard-read", "clipboard-write"], { origin });
  await context.addInitScript(keepDrawings);
  if (init) await context.addInitScript(init); // runs in the page before all else
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  const said = [];
  const asked = [];
  page.on("console", (message) => message.type() === "error" && said.push(message.text()));
  page.on("pageerror", (error) => said.push(error.message));
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(address + hash);
  const leave = async () => {
    await context.close();
    assert.deepEqual(said, []);
    assert.deepEqual(asked.filter((url) => !url.startsWith(origin) && !/^(data|blob):/.test(url)), []);
  };
  return { page, leave };
}

export const still = { viewport: { width: 640, height: 480 }, reducedMotion: "reduce" };
export const button = (page, name) => page.getByRole("button", { name, exact: true });

export const slider = (page, name) => page.getByRole("slider", { name, exact: true });

/** What a button has copied. */
export async function copied(page, name) {
  const pasted = () => page.evaluate(() => navigator.clipboard.readText());
  // The status may speak of what was copied before.
  await page.evaluate(() => navigator.clipboard.writeText(""));
  await button(page, name).click();
  await page.waitForFunction(async () => (await navigator.clipboard.readText()) !== "");
  return pasted();
}

/** Drops a file on the page: a text, or numbers of bytes. */
export async function drop(page, name, content) {
  const data = await page.evaluateHandle(
    ([name, content]) => {
      const transfer = new DataTransfer();
      const part = typeof content === "string" ? content : new Uint8Array(content);
      transfer.items.add(new File([part], name));
      return transfer;
    },
    [name, content],
  );
  await page.dispatchEvent("body", "drop", { dataTransfer: data });
}

/** What stands behind the page's address for a project; what is left out is as at first. */
export const addressOf = (project) =>
  `#${deflateRawSync(JSON.stringify(project)).toString("base64url")}`;

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What shuts people out. */
export async function violations(page) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  return violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`);
}

export async function exported(page, format) {
  await page.getByRole("combobox", { name: "Export format" }).selectOption({ label: format });
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, "Export").click()]);
  return readFileSync(await download.path());
}

/** What the canvas shows, as text that is equal for equal pictures. */
export async function picture(page) {
  return (await page.locator(".view canvas").screenshot()).toString("base64");
}

export const progress = (page) => page.getByRole("status", { name: "Progress" });

/** Waits until a run has ended well; returns what it says. */
export async function cracked(page) {
  await progress(page).filter({ hasText: /\d+ cracks, \d+ fragments in/ }).waitFor();
  return progress(page).textContent();
}

/** Does it, and waits until the run that comes of it has ended well. */
export async function anew(page, change) {
  await progress(page).evaluate((region) => (region.textContent = "")); // of what was before
  await change();
  return cracked(page);
}

/** Keeps the paths that a page asks for, and says how many bytes they are by gzip. */
export function loadOf(page) {
  const paths = new Set();
  page.on("response", (answer) => answer.ok() && paths.add(new URL(answer.url()).pathname));
  return () =>
    [...paths].reduce((sum, path) => sum + gzipSync(readFileSync(ofThePage(path)), { level: 6 }).length, 0);
}
