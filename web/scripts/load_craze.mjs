// The engine in node, which is no worker of a page: what its module expects of one is put there.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

/** An instance of the engine in `folder`, and textAt(pointer). */
export async function loadCraze(folder) {
  globalThis.self ??= globalThis;
  globalThis.location ??= { href: "" };
  const { default: createCraze } = await import(pathToFileURL(join(folder, "craze.mjs")));
  const module = await WebAssembly.compile(readFileSync(join(folder, "craze.wasm")));
  const craze = await createCraze({
    instantiateWasm(imports, ready) {
      WebAssembly.instantiate(module, imports).then(ready);
      return {};
    },
  });
  craze.textAt = (pointer) => {
    const end = craze.HEAPU8.indexOf(0, pointer);
    return new TextDecoder().decode(craze.HEAPU8.subarray(pointer, end));
  };
  return craze;
}
