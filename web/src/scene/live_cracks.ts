// Cracks while they are computed.
import type { OpenedPieces } from "../engine/messages";
import { CrackLines } from "./crack_lines";

export class LiveCracks {
  private readonly lines = new CrackLines();
  readonly object = this.lines.object;
  private count = 0; // of pieces

  /** Lies on the mesh that the cracks grow on, which is not quite the one that is seen. */
  constructor() {
    this.lines.lift(3e-4);
    this.clear();
  }

  get empty(): boolean {
    return this.count === 0;
  }

  clear(): void {
    this.count = 0;
    this.lines.set(new Float32Array(0), new Float32Array(0));
  }

  add({ first, pieces }: OpenedPieces): void {
    this.lines.append(pieces, first);
    this.count = first + pieces.length / 6;
  }
}
