// Usage: node validate.mjs [--as BEFORE.glb] FILE.glb... Prints what the Khronos validator finds; fails on any
// error, and with --as on any kind of warning that BEFORE.glb does not give.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';

const { validateBytes } = createRequire(import.meta.url)('gltf-validator');

const validate = async (file) => (await validateBytes(new Uint8Array(await readFile(file)))).issues;

let files = process.argv.slice(2);
let known = null;
if (files[0] === '--as') {
  known = new Set((await validate(files[1])).messages.map(({ code }) => code));
  files = files.slice(2);
}
let errors = 0;
for (const file of files) {
  const issues = await validate(file);
  errors += issues.numErrors;
  if (known) errors += issues.messages.filter(({ severity, code }) => severity === 1 && !known.has(code)).length;
  for (const { severity, code, pointer, message } of issues.messages) {
    if (severity <= 1) console.log(`${file}: ${['error', 'warning'][severity]} ${code} ${pointer}: ${message}`);
  }
}
process.exit(errors > 0 ? 1 : 0);
