// The page's own way to the engine, in node.
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "vite";
import { loadCraze } from "../scripts/load_craze.mjs";

export const web = dirname(dirname(fileURLToPath(import.meta.url)));
const generated = join(web, "src/engine/generated");
const folder = join(web, "node_modules/.cache/craze-tests");

/** The modules of the page, by their paths below src/, as node can load them. */
export async function pageModules(paths) {
  const input = Object.fromEntries(paths.map((path) => [path, join(web, "src", `${path}.ts`)]));
  const output = { dir: folder, entryFileNames: "[name].mjs", format: "es" };
  await build({
    configFile: false,
    root: web,
    logLevel: "warn",
    build: { ssr: true, outDir: folder, emptyOutDir: true, rollupOptions: { input, output } },
  });
  return Promise.all(paths.map((path) => import(join(folder, `${path}.mjs`))));
}

export const presetNames = Object.keys(
  JSON.parse(readFileSync(join(generated, "presets.json"), "utf8")),
);

const silent = { progress: () => {}, opened: () => {} };

export async function newSession(Session, listener = silent) {
  return new Session(await loadCraze(generated), listener);
}
