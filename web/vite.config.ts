import { defineConfig } from "vite";
import { offline } from "./scripts/offline.mjs";

// One static folder that works from any path: every address in it is relative.
export default defineConfig({
  base: "./",
  plugins: [offline()],
  worker: { format: "es" },
  build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 1200 },
});
