// Cracks while they are computed.
import type { OpenedPieces } from "../engine/messages";
import { CrackLines } from "./crack_lines";

export class LiveCracks {
  private readonly lines = new CrackLines();
  readonly object = this.lines.object;
  private pieces: Float32Array[] = [];

  /** Lies on the mesh that the cracks grow on, which is not quite the one that is seen. */
  constructor() {
    this.lines.lift(3e-4);
    this.clear();
  }

  get empty(): boolean {
    return this.pieces.length === 0;
  }

  clear(): void {
    this.pieces = [];
    this.lines.set(new Float32Array(0), new Float32Array(0));
  }

  add({ first, pieces }: OpenedPieces): void {
    if (first === 0) this.pieces = [];
    this.pieces.push(pieces);
    const all = new Float32Array(this.pieces.reduce((sum, some) => sum + some.length, 0));
    let at = 0;
    for (const some of this.pieces) {
      all.set(some, at);
      at += some.length;
    }
    this.pieces = [all];
    this.lines.set(all, new Float32Array(all.length / 3));
  }
}
