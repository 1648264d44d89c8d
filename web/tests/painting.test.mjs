// The paint on a surface keeps in step with a list of strokes, whatever was painted before.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import { pageModules } from "./session.mjs";

let Painting, canvasOf;
before(async () => {
  [{ Painting }, { canvasOf }] = await pageModules(["paint/painting", "paint/canvas"]);
});

/** A square of 2 · side² triangles, a little bent. */
function plate(side) {
  const positions = [];
  const triangles = [];
  for (let j = 0; j <= side; ++j) {
    for (let i = 0; i <= side; ++i) {
      positions.push(i / side, j / side, 0.1 * Math.sqrt(i / side));
      const v = j * (side + 1) + i;
      if (i < side && j < side) triangles.push(v, v + 1, v + side + 2, v, v + side + 2, v + side + 1);
    }
  }
  return canvasOf(Float32Array.from(positions), Uint32Array.from(triangles));
}

/** Numbers that look like chance, the same every time. */
function chance(seed) {
  let state = seed;
  return (below) => {
    state = (state * 1664525 + 1013904223) % 2 ** 32;
    return Math.floor((state / 2 ** 32) * below);
  };
}

const names = ["stress", "strength", "spacing", "mask"];

function someStroke(next) {
  const kind = ["brush", "brush", "brush", "fill", "invert", "file"][next(6)];
  const dabs = [];
  for (let i = 3 + next(6); kind === "brush" && i > 0; --i) dabs.push(next(65536), next(65536), next(65536), 0, 0, 127);
  const flags = { along: next(2) === 1, erase: next(3) === 0, mirror: next(2) === 1 };
  const numbers = { radius: 4000 + next(20000), strength: 1 + next(100) };
  return { kind, layer: names[next(4)], from: "own", ...flags, ...numbers, dabs };
}

const all = (painting) => [...names.map((name) => painting.values(name)), painting.tension];

function paintingOf(canvas, strokes) {
  const painting = new Painting(canvas);
  painting.provide("own", Float32Array.from({ length: canvas.positions.length / 3 }, (_, v) => (v % 7) / 7));
  painting.follow(strokes);
  return painting;
}

test("whatever came before, the paint is that of the strokes, to the last bit", () => {
  const canvas = plate(12);
  const next = chance(5);
  const painting = paintingOf(canvas, []);
  let strokes = [];
  for (let turn = 0; turn < 300; ++turn) {
    if (next(3) === 0) strokes = strokes.slice(0, next(strokes.length + 1)); // undone
    else strokes = [...strokes, someStroke(next)];
    painting.follow(strokes);
    assert.deepEqual(all(painting), all(paintingOf(canvas, strokes)));
  }
});

test("a stroke that grows dab by dab is the stroke, and is taken back as a whole", () => {
  const canvas = plate(12);
  const next = chance(9);
  for (let turn = 0; turn < 40; ++turn) {
    const before = [someStroke(next), someStroke(next)];
    const stroke = { ...someStroke(next), kind: "brush", dabs: [] };
    const painting = paintingOf(canvas, before);
    for (let i = 0; i < 12; ++i) {
      stroke.dabs = [...stroke.dabs, next(65536), next(65536), next(65536), 0, 0, 127];
      painting.follow([...before, { ...stroke }]);
    }
    assert.deepEqual(all(painting), all(paintingOf(canvas, [...before, stroke])));
    painting.follow(before);
    assert.deepEqual(all(painting), all(paintingOf(canvas, before)));
  }
});

test("what is remembered of strokes is bounded, and all of them are undone nevertheless", () => {
  const canvas = plate(200); // 160 kB a stroke of the whole surface
  const next = chance(2);
  const whole = () => ({ ...someStroke(next), kind: "fill", erase: false, layer: "mask", dabs: [] });
  const strokes = Array.from({ length: 600 }, whole); // 97 MB of them
  const painting = paintingOf(canvas, []);
  for (let i = 1; i <= strokes.length; ++i) painting.follow(strokes.slice(0, i));
  assert.ok(painting.memory <= 64 * 1024 * 1024, `${painting.memory}`);
  assert.ok(painting.memory > 32 * 1024 * 1024, `${painting.memory}`);
  const few = strokes.slice(0, 3);
  painting.follow(few);
  assert.deepEqual(all(painting), all(paintingOf(canvas, few)));
});
