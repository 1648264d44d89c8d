// The built page as a person and as a screen reader find it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { presetNames } from "./session.mjs";
import {
  addressOf,
  anew,
  browserOfTests,
  button,
  copied,
  cracked,
  drop,
  exported,
  progress,
  skip,
  slider,
  still,
  violations,
  visit,
} from "./page.mjs";

const buttons = ["Open", "Crack", "Cancel", "Undo", "Redo", "Export", "Copy command", "Copy link", "New seed"];
const sliders = ["Spacing", "Load", "Gap", "Mean opening", "Wall", "Curl", "Late width", "Thickness", "Roughness", "Growth", "Brush size", "Brush strength"];
const paints = ["None", "Stress", "Strength", "Spacing", "Mask", "Impact"];

const browser = browserOfTests();

test("a cracked cup is there, and every control has its role and name", { skip }, async () => {
  const { page, leave } = await visit(browser, still);
  await cracked(page);
  for (const name of buttons) assert.equal(await button(page, name).count(), 1, name);
  for (const name of sliders) assert.equal(await slider(page, name).count(), 1, name);
  for (const name of paints) {
    const radio = page.getByRole("radiogroup", { name: "Paint" }).getByRole("radio", { name });
    assert.equal(await radio.count(), 1, name);
  }
  const presets = page.getByRole("radiogroup", { name: "Preset" }).getByRole("radio");
  assert.equal(await presets.count(), presetNames.length);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    assert.deepEqual(await violations(page), []);
  }
  await leave();
});

test("opening the cracks, and taking it back, cracks nothing again", { skip }, async () => {
  const { page, leave } = await visit(browser, still);
  const said = await cracked(page);
  const before = await exported(page, "PLY");
  const phases = page.evaluate(
    () =>
      new Promise((resolve) => {
        const seen = [];
        const region = document.querySelector("[role=status]");
        new MutationObserver(() => seen.push(region.textContent)).observe(region, { childList: true });
        globalThis.stopLooking = () => resolve(seen);
      }),
  );
  const names = ["Gap", "Wall", "Curl", "Late width", "Roughness", "Mean opening", "Thickness"];
  for (const name of [...names, "Growth"]) {
    await slider(page, name).focus();
    await page.keyboard.press(name === "Late width" ? "PageDown" : "PageUp");
  }
  const opened = await exported(page, "PLY");
  assert.notDeepEqual(opened, before);
  for (let i = 0; i < names.length; ++i) await page.keyboard.press("Control+z");
  assert.equal(await button(page, "Undo").isDisabled(), true);
  assert.deepEqual(await exported(page, "PLY"), before);
  for (let i = 0; i < names.length; ++i) await button(page, "Redo").click();
  assert.deepEqual(await exported(page, "PLY"), opened);
  await page.evaluate(() => globalThis.stopLooking());
  const ofRuns = /^(start|prepare|crack)\b|^\d+ cracks/;
  assert.deepEqual((await phases).filter((text) => ofRuns.test(text)), []);
  assert.match(said, /cracks/);
  await leave();
});

test("a link brings the same cracks and the same command back", { skip }, async () => {
  const first = await visit(browser, still);
  await cracked(first.page);
  await anew(first.page, () => button(first.page, "New seed").click());
  const command = await copied(first.page, "Copy command");
  assert.equal(
    command,
    "craze crack 'shape:cup?n=96' -o cracked.ply --preset glaze --set layer.spacing=0.14 --set seed=2",
  );
  const link = await copied(first.page, "Copy link");
  const bytes = await exported(first.page, "PLY");
  await first.leave();
  const second = await visit(browser, still, new URL(link).hash);
  await cracked(second.page);
  assert.equal(await copied(second.page, "Copy command"), command);
  assert.deepEqual(await exported(second.page, "PLY"), bytes);
  await second.leave();
});

test("a recipe is exported as TOML, and taken back", { skip }, async () => {
  const plate = addressOf({ source: { kind: "shape", specification: "plate?n=20" }, spacing: 0.3, seed: 4 });
  const first = await visit(browser, still, plate);
  await cracked(first.page);
  const toml = (await exported(first.page, "Recipe (TOML)")).toString();
  assert.match(toml, /^seed = 4$[^]*^spacing = 0\.3$/m);
  const bytes = await exported(first.page, "PLY");
  await first.leave();
  const other = addressOf({ source: { kind: "shape", specification: "plate?n=20" }, preset: "mud" });
  const { page, leave } = await visit(browser, still, other);
  await cracked(page);
  await drop(page, "broken.toml", "seed = [");
  await page.getByRole("alert").filter({ hasText: "broken.toml" }).waitFor();
  await anew(page, () => drop(page, "mine.toml", toml));
  assert.equal(await page.locator("[aria-label=Preset] :checked").count(), 0);
  assert.deepEqual(await exported(page, "PLY"), bytes);
  assert.equal(await copied(page, "Copy command"), "craze crack 'shape:plate?n=20' -o cracked.ply --recipe recipe.toml");
  await button(page, "Undo").click();
  await cracked(page);
  assert.match(await copied(page, "Copy command"), /--preset mud/);
  await leave();
});

test("a run that is cancelled leaves the last result", { skip }, async () => {
  const { page, leave } = await visit(browser, still);
  await cracked(page);
  const before = await exported(page, "PLY");
  await page.getByText("mud-mature").click();
  await progress(page).filter({ hasText: /crack: \d+ cracks/ }).waitFor();
  await button(page, "Cancel").click();
  assert.equal(await progress(page).textContent(), "Cancelled.");
  assert.deepEqual(await exported(page, "PLY"), before);
  await leave();
});

test("a broken file is one sentence, and the page goes on", { skip }, async () => {
  const { page, leave } = await visit(browser, still);
  await cracked(page);
  await drop(page, "broken.obj", "v 0 0 0\nf 1 2 3\n");
  const alert = page.getByRole("alert").filter({ hasText: "broken.obj" });
  await alert.waitFor();
  assert.doesNotMatch(await alert.textContent(), /\n/);
  const tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  await anew(page, () => drop(page, "mine.obj", tetrahedron));
  assert.match(await copied(page, "Copy command"), /^craze crack mine\.obj /);
  await leave();
});

test("a stroke on the surface changes the recipe, and is undone", { skip }, async () => {
  const { page, leave } = await visit(browser, still);
  await cracked(page);
  const plain = await copied(page, "Copy command");
  await page.getByRole("radiogroup", { name: "Paint" }).getByText("Mask").click();
  const box = await page.locator("canvas").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height * 0.6];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y, { steps: 4 });
  await page.mouse.up();
  await cracked(page);
  assert.match(await copied(page, "Copy command"), /painted\.ply .*where\.attribute="paint_mask"/);
  await button(page, "Undo").click();
  await cracked(page); // its progress would take the place of what copying says
  assert.equal(await copied(page, "Copy command"), plain);
  await leave();
});
