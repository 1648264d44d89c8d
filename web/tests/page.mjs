// The built page in Debian's Chromium, from a folder below the root of a plain file server.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { dirname, extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const dist = join(dirname(dirname(fileURLToPath(import.meta.url))), "dist");
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
export const missing = [executablePath, dist].find((path) => !existsSync(path));
export const skip = missing ? `no ${missing}` : false;

const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };
const below = "/some/where/";

function serve() {
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    const file = join(dist, path.slice(below.length) || "index.html");
    if (!path.startsWith(below) || !existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" });
    response.end(readFileSync(file));
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

export async function openBrowser() {
  const server = await serve();
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

/** A new person's page. Nothing may be said on its console, and nothing asked of another origin:
 * leave() looks. */
export async function visit({ browser, origin, address }, options = {}, hash = "") {
  const context = await browser.newContext({ acceptDownloads: true, ...options });
  await context.grantPermissions(["clipboard-read", "clipboard-write"], { origin });
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

export const progress = (page) => page.getByRole("status", { name: "Progress" });

/** Waits until a run has ended well; returns what it says. */
export async function cracked(page) {
  await progress(page).filter({ hasText: /\d+ cracks, \d+ fragments in/ }).waitFor();
  return progress(page).textContent();
}
