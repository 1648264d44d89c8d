// Builds the WebAssembly engine and puts it where the page takes it from, with the tables that it
// knows: src/engine/generated/{craze.mjs, craze.wasm, parameters.json, presets.json}.
// CRAZE_WASM=FOLDER takes craze.mjs and craze.wasm from there instead of building them.
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { loadCraze } from "./load_craze.mjs";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const root = dirname(web);
const generated = join(web, "src/engine/generated");

function build() {
  // Where Debian keeps the modules that emscripten's tools ask for.
  const environment = { ...process.env, NODE_PATH: "/usr/share/nodejs" };
  const cmake = (...options) =>
    execFileSync("cmake", options, { cwd: root, env: environment, stdio: "inherit" });
  cmake("--preset", "wasm");
  cmake("--build", "--preset", "wasm", "--target", "craze_wasm");
  return join(root, "build/wasm/bindings/wasm");
}

const from = process.env.CRAZE_WASM ?? build();
mkdirSync(generated, { recursive: true });
for (const file of ["craze.mjs", "craze.wasm"]) {
  copyFileSync(join(from, file), join(generated, file));
}

const craze = await loadCraze(generated);
for (const table of ["parameters", "presets"]) {
  const text = craze[`_craze_${table}`](0);
  writeFileSync(join(generated, `${table}.json`), craze.textAt(text));
  craze._craze_text_free(text);
}
