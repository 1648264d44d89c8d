// Usage: node validate.mjs FILE.glb... Prints what the Khronos validator finds; fails on any error.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';

const { validateBytes } = createRequire(import.meta.url)('gltf-validator');

let errors = 0;
for (const file of process.argv.slice(2)) {
  const { issues } = await validateBytes(new Uint8Array(await readFile(file)));
  errors += issues.numErrors;
  for (const { severity, code, pointer, message } of issues.messages) {
    if (severity <= 1) console.log(`${file}: ${['error', 'warning'][severity]} ${code} ${pointer}: ${message}`);
  }
}
process.exit(errors > 0 ? 1 : 0);
