// Usage: node read.mjs NAME... Compares NAME.usda, as TinyUSDZ reads it, with the run's report NAME.json.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';

// The package is made for pages: node looks like one here.
globalThis.window = globalThis;
process.type = 'renderer';
const { default: start } = await import('tinyusdz/tinyusdz.js');
const wasmBinary = await readFile(new URL('node_modules/tinyusdz/tinyusdz.wasm', import.meta.url));
const native = await start({ wasmBinary });

for (const name of process.argv.slice(2)) {
  const usd = new native.TinyUSDZLoaderNative();
  usd.setLoadTextureInNative(false);
  assert.ok(usd.loadFromBinary(new Uint8Array(await readFile(`${name}.usda`)), `${name}.usda`), name);
  const { output } = JSON.parse(await readFile(`${name}.json`, 'utf8'));
  let triangles = 0;
  for (let i = 0; i < usd.numMeshes(); ++i) {
    const mesh = usd.getMesh(i);
    assert.ok(mesh.faceVertexCounts.every((n) => n === 3), name);
    assert.ok(mesh.points.every(Number.isFinite), name);
    const points = mesh.points.length / 3;
    assert.ok(mesh.faceVertexIndices.every((v) => v < points), name);
    triangles += mesh.faceVertexCounts.length;
  }
  assert.equal(triangles, output.triangles, name);
  assert.equal(usd.numMeshes() > 1, name === 'pieces');
  if (name !== 'scene' && name !== 'clamped') continue;
  // Base colours of brick, stripes twice; normals and emission of brick.
  const wraps = [0, 1, 2, 3, 4].map((i) => usd.getTexture(i)).map(({ wrapS, wrapT }) => `${wrapS} ${wrapT}`);
  assert.deepEqual(wraps, new Array(5).fill(name === 'clamped' ? 'clamp_to_edge mirror' : 'repeat repeat'));
}
