// The brush in the hand: mouse, pen, finger, and what it is set to.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { addressOf, anew, browserOfTests, button, cracked, picture, progress, skip, still, visit } from "./page.mjs";

const browser = browserOfTests();
const small = addressOf({ source: { kind: "shape", specification: "plate?n=8" }, spacing: 0.5 });
const paint = (page, name) => page.getByRole("radiogroup", { name: "Paint" }).getByText(name).click();

/** The middle of the view, and places beside it. */
async function placeIn(page) {
  const { x, y, width, height } = await page.locator(".view canvas").boundingBox();
  return (right, down) => [x + width / 2 + right, y + height / 2 + down];
}

async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 3 });
  await page.mouse.up();
}

async function strokesOf(page) {
  const [saved] = await Promise.all([page.waitForEvent("download"), button(page, "Save project").click()]);
  return JSON.parse(readFileSync(await saved.path(), "utf8")).strokes;
}

test("a pen paints as hard as it presses, and a finger paints", { skip }, async () => {
  const { page, leave } = await visit(browser, { ...still, hasTouch: true }, small);
  await cracked(page);
  await paint(page, "Mask");
  const at = await placeIn(page);
  const session = await page.context().newCDPSession(page);
  for (const force of [0.2, 0.8]) {
    const [x, y] = at(0, 0);
    const pen = { x, y, button: "left", clickCount: 1, pointerType: "pen", force };
    await anew(page, async () => {
      await session.send("Input.dispatchMouseEvent", { type: "mousePressed", ...pen });
      await session.send("Input.dispatchMouseEvent", { type: "mouseReleased", ...pen });
    });
  }
  await anew(page, () => page.touchscreen.tap(...at(10, 0)));
  const strengths = (await strokesOf(page)).map(({ strength }) => strength);
  assert.deepEqual(strengths, [10, 40, 50]); // of a brush of 0.5
  await leave();
});

test("erase, mirror and along the stroke are what the brush is set to", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  await paint(page, "Stress");
  const at = await placeIn(page);
  const seen = new Set([await picture(page)]);
  const stroke = async (name) => {
    if (name) await page.getByRole("checkbox", { name }).check();
    await anew(page, () => drag(page, at(-60, 0), at(-20, 0)));
    if (name) await page.getByRole("checkbox", { name }).uncheck();
    seen.add(await picture(page));
  };
  for (const name of ["", "Mirror in x", "Along the stroke", "Erase"]) await stroke(name);
  const strokes = await strokesOf(page);
  const set = strokes.map(({ mirror, along, erase }) => [mirror, along, erase].map(Number).join(""));
  assert.deepEqual(set, ["000", "100", "010", "001"]);
  assert.equal(seen.size, 5);
  assert.ok(strokes.every(({ dabs }) => dabs.length >= 12));
  await leave();
});

test("the colour of lines cracks nothing again, and is undone", { skip }, async () => {
  const { page, leave } = await visit(browser, still, small);
  await cracked(page);
  const said = await progress(page).textContent();
  const before = await picture(page);
  await page.getByLabel("Line colour").fill("#ff2010");
  const red = await picture(page);
  assert.notEqual(red, before);
  await button(page, "Undo").click();
  assert.equal(await picture(page), before);
  await button(page, "Redo").click();
  assert.equal(await picture(page), red);
  assert.equal(await progress(page).textContent(), said);
  await leave();
});
