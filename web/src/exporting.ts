// Everything that leaves the page as a file.
import type { Engine } from "./engine/engine";
import type { CrackRequest, OutputFile, Post } from "./engine/messages";
import { recordFilm } from "./scene/film";
import type { Growth } from "./scene/growth";
import type { Stage } from "./scene/stage";

/** What is exported: a run's result, and how it is opened. */
export interface Exported {
  request(): CrackRequest;
  post(): Post;
}

export class Exporting {
  constructor(
    private readonly engine: Engine,
    private readonly stage: Stage,
    private readonly growth: Growth,
    private readonly what: Exported,
  ) {}

  /** `format` is the name of an extension, or painted.ply. Throws Error. */
  async files(format: string): Promise<OutputFile[]> {
    const name = `cracked.${format}`;
    switch (format) {
      case "painted.ply":
        return this.engine.paintedInput(this.what.request(), format);
      case "svg":
        return this.engine.writeLines(name);
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
