// A plugin of Vite: makes service_worker.js of src/offline/ and the names of all that was built.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";

export function offline() {
  return {
    name: "offline",
    apply: "build",
    enforce: "post", // after the page's worker has been added
    generateBundle(_, bundle) {
      const files = ["./", ...Object.keys(bundle).filter((name) => !name.endsWith(".html")).sort()];
      const contents = createHash("sha256");
      for (const file of Object.values(bundle)) contents.update(file.code ?? file.source);
      const version = contents.digest("hex").slice(0, 16);
      const lists = `const files = ${JSON.stringify(files)};\nconst version = "${version}";\n`;
      const source = lists + readFileSync("src/offline/service_worker.js", "utf8");
      this.emitFile({ type: "asset", fileName: "service_worker.js", source });
    },
  };
}
