// What the page shows of a result, and how it comes to be.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  addressOf,
  anew,
  browserOfTests,
  button,
  cracked,
  exported,
  loadOf,
  picture,
  skip,
  still,
  violations,
  visit,
} from "./page.mjs";

const small = addressOf({ source: { kind: "shape", specification: "cup?n=24" }, spacing: 0.3 });
const show = (page, view) => page.getByRole("combobox", { name: "Show" }).selectOption(view);

const browser = browserOfTests();

test("cracks are seen while they are computed", { skip }, async () => {
  const long = addressOf({ preset: "mud", spacing: 0.08 });
  const { page, leave } = await visit(browser, still, long);
  await cracked(page); // a run that begins with the page may be over before its first frame is
  // Frame by frame, and from within: a picture of the page takes longer than the cracks do.
  const pictures = page.evaluate(async () => {
    const small = new OffscreenCanvas(64, 48).getContext("2d", { willReadFrequently: true });
    const seen = new Set();
    let runs = false;
    for (let said = ""; !runs || !/fragments in/.test(said); ) {
      await new Promise(requestAnimationFrame);
      said = document.querySelector("[role=status]").textContent;
      runs ||= !/fragments in/.test(said);
      if (!/^crack/.test(said)) continue;
      small.drawImage(document.querySelector(".view canvas"), 0, 0, 64, 48);
      seen.add(small.getImageData(0, 0, 64, 48).data.join());
    }
    return seen.size;
  });
  await anew(page, () => button(page, "New seed").click());
  assert.ok((await pictures) > 3, `${await pictures} pictures`);
  await leave();
});

/** In the page: keeps how many corners each draw call has, while cracks are computed. */
function keepDraws() {
  globalThis.draws = [];
  const { prototype } = WebGL2RenderingContext;
  for (const [name, at] of [["drawElements", 1], ["drawArrays", 2], ["drawElementsInstanced", 1], ["drawArraysInstanced", 2]]) {
    const draw = prototype[name];
    prototype[name] = function (...given) {
      const said = document.querySelector("[role=status]")?.textContent ?? "";
      if (/^crack: /.test(said)) globalThis.draws.push({ name, corners: given[at] });
      return draw.apply(this, given);
    };
  }
}

test("without a graphics processor new cracks alone are drawn while they are computed", { skip }, async () => {
  const long = addressOf({ preset: "mud", spacing: 0.1, source: { kind: "shape", specification: "cup?n=64" } });
  const { page, leave } = await visit(browser, { ...still, init: keepDraws }, long);
  await cracked(page);
  await page.evaluate(() => (globalThis.draws = []));
  await anew(page, () => button(page, "New seed").click());
  const drawn = await page.evaluate(() => globalThis.draws);
  assert.ok(drawn.length > 4, `${drawn.length} draws`);
  assert.deepEqual(drawn.filter(({ name }) => /Instanced/.test(name)), []); // each would be a draw by itself
  const surfaces = drawn.filter(({ corners }) => corners > 3 * 5000);
  assert.ok(surfaces.length <= 3, `the surface is drawn ${surfaces.length} of ${drawn.length} times`);
  await leave();
});

test("each way to look at a result is another picture, and the first comes back", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  const first = await picture(page);
  const seen = new Set([first]);
  for (const view of ["Fragments", "Age of cracks", "Stress", "Separation ς"]) {
    await show(page, view);
    // The state is asked of the engine.
    if (/Stress|Sep/.test(view)) await page.getByText(/force/).filter({ visible: true }).waitFor();
    seen.add(await picture(page));
  }
  await page.getByRole("checkbox", { name: "Principal directions" }).uncheck();
  seen.add(await picture(page));
  await show(page, "Surface");
  assert.equal(await picture(page), first);
  await page.getByRole("checkbox", { name: "Wireframe" }).check();
  seen.add(await picture(page));
  assert.equal(seen.size, 7);
  await leave();
});

test("a kept result stays at the left while the right changes", { skip }, async () => {
  const wide = { ...still, viewport: { width: 920, height: 480 } };
  const { page, leave } = await visit(browser, wide, small);
  await cracked(page);
  const halves = async () => {
    const { x, y, width, height } = await page.locator(".view canvas").boundingBox();
    const half = { y, width: width / 2 - 2, height };
    const left = await page.screenshot({ clip: { x, ...half } });
    const right = await page.screenshot({ clip: { x: x + width / 2 + 2, ...half } });
    return [left.toString("base64"), right.toString("base64")];
  };
  const [left, right] = await halves();
  await button(page, "Compare").click();
  await anew(page, () => button(page, "New seed").click());
  const [kept, other] = await halves();
  assert.equal(kept, left);
  assert.notEqual(other, right);
  await button(page, "Stop comparing").click();
  assert.notEqual((await halves())[0], left);
  await leave();
});

test("statistics stand beside what is published", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  await button(page, "Measure").click();
  const row = page.getByRole("row", { name: /^Sides/ });
  await row.waitFor();
  const [measured, published] = await row.getByRole("cell").allTextContents();
  assert.match(measured, /^[\d.]+ ± [\d.]+$/);
  assert.equal(published, "4");
  assert.deepEqual(await violations(page), []);
  await leave();
});

test("the paper's loop is gone through step by step, to its end", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  await button(page, "How it cracks").click();
  const dialog = page.getByRole("dialog", { name: "The paper's loop" });
  const next = dialog.getByRole("button", { name: "Next", exact: true });
  for (const line of ["1.", "2.", "3a.", "3b.", "3c."]) {
    await dialog.locator("[aria-current=step]").filter({ hasText: line }).waitFor();
    await next.click();
  }
  await dialog.locator("[aria-current=step]").filter({ hasText: "3a." }).waitFor();
  assert.deepEqual(await violations(page), []);
  const turn = dialog.getByRole("button", { name: "Next crack" });
  const status = dialog.getByRole("status");
  for (let said = await status.textContent(); await turn.isEnabled(); said = await status.textContent()) {
    await turn.click();
    await page.waitForFunction(
      (before) => document.querySelector("dialog [role=status]").textContent !== before,
      said,
    );
  }
  assert.match(await status.textContent(), /loop ends/);
  await page.keyboard.press("Escape");
  assert.equal(await dialog.isVisible(), false);
  await leave();
});

test("pictures, lines, films and maps are exported", { skip }, async () => {
  const plate = addressOf({ source: { kind: "shape", specification: "plate?n=20" }, spacing: 0.3 });
  const { page, leave } = await visit(browser, still, plate);
  await cracked(page);
  const begins = (bytes, wanted) => assert.equal(bytes.subarray(0, wanted.length).toString("latin1"), wanted);
  begins(await exported(page, "Picture (PNG)"), "\x89PNG");
  assert.match((await exported(page, "Lines (SVG)")).toString(), /<svg[^]*<path/);
  begins(await exported(page, "Film (WebM)"), "\x1aE\xdf\xa3");
  begins(await exported(page, "GLB"), "glTF");
  const maps = await exported(page, "Maps (ZIP of PNG)");
  begins(maps, "PK");
  assert.ok(maps.includes("maps.json"));
  const mask = maps.indexOf("mask.png"); // its first record, then the file itself
  begins(maps.subarray(mask + "mask.png".length), "\x89PNG");
  await leave();
});

test("the page opens without a network once it was there", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  await page.evaluate(() => navigator.serviceWorker.ready);
  const away = page.context();
  await away.setOffline(true);
  await page.reload();
  await cracked(page);
  await away.setOffline(false);
  await leave();
});

test("the page is at most 1.5 MB to load", { skip }, async () => {
  const context = await browser.browser.newContext(still);
  const page = await context.newPage();
  const bytes = loadOf(page);
  await page.goto(browser.address + small);
  await cracked(page);
  assert.ok(bytes() > 1e6, `${bytes()}`); // the engine alone
  assert.ok(bytes() < 1.5e6, `${bytes()}`);
  await context.close();
});
