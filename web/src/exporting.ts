// Everything that leaves the page as a file.
import { zipSync } from "three/examples/jsm/libs/fflate.module.js";
import type { Engine } from "./engine/engine";
import type { CrackRequest, OutputFile, Post, RecipeRequest } from "./engine/messages";
import { recordFilm } from "./scene/film";
import type { Growth } from "./scene/growth";
import type { Stage } from "./scene/stage";

const firstDay = new Date(1980, 0, 1); // that ZIP knows: the same bytes every time
const mapSize = 1024; // texels a side, as craze crack --maps has it

/** What is exported: a run's result, and how it is opened. */
export interface Exported {
  request(): CrackRequest;
  post(): Post;
  /** All of it, how it is opened too. */
  recipe(): RecipeRequest;
}

export class Exporting {
  constructor(
    private readonly engine: Engine,
    private readonly stage: Stage,
    private readonly growth: Growth,
    private readonly what: Exported,
  ) {}

  /** `format` is the name of an extension, painted.ply or maps.zip. Throws Error. */
  async files(format: string): Promise<OutputFile[]> {
    const name = `cracked.${format}`;
    switch (format) {
      case "painted.ply":
        return this.engine.paintedInput(this.what.request(), format);
      case "toml": {
        const { toml } = await this.engine.recipe(this.what.recipe());
        return [{ name: "recipe.toml", bytes: new TextEncoder().encode(toml) }];
      }
      case "maps.zip": {
        const maps = await this.engine.maps(mapSize, this.what.post());
        const files = Object.fromEntries(maps.map(({ name, bytes }) => [name, bytes]));
        return [{ name: format, bytes: zipSync(files, { level: 0, mtime: firstDay }) }];
      }
      case "svg":
        return this.engine.writeLines(name, this.what.post());
      case "png":
        return [await fileOf(name, await this.stage.viewer.picture())];
      case "webm": {
        const film = await recordFilm(this.stage.viewer.canvas, () => this.growth.film());
        return [await fileOf(name, film)];
      }
      default:
        return this.engine.write(name, this.what.post());
    }
  }
}

async function fileOf(name: string, blob: Blob): Promise<OutputFile> {
  return { name, bytes: new Uint8Array(await blob.arrayBuffer()) };
}
