// Cracks while they are computed.
import type { OpenedPieces } from "../engine/messages";
import { CrackLines } from "./crack_lines";

export class LiveCracks {
  private readonly lines = new CrackLines();
  readonly object = this.lines.object;
  private count = 0; // of pieces
  private drawn = 0; // of them, in the picture that is there

  /** Lies on the mesh that the cracks grow on, which is not quite the one that is seen. */
  constructor() {
    this.lines.lift(3e-4);
    this.clear();
  }

  get empty(): boolean {
    return this.count === 0;
  }

  clear(): void {
    this.count = this.drawn = 0;
    this.lines.set(new Float32Array(0), new Float32Array(0));
  }

  /** Returns whether what was drawn of them stays: only new ones came. */
  add({ first, pieces }: OpenedPieces): boolean {
    const more = !this.empty && first >= this.drawn;
    this.lines.append(pieces, first);
    this.count = first + pieces.length / 6;
    return more;
  }

  setColor(color: number): boolean {
    return this.lines.setColor(color);
  }

  /** They are drawn now, all of them or those that were not yet. */
  draw(all: boolean): void {
    this.lines.drawFrom(all ? 0 : this.drawn);
    this.drawn = this.count;
  }
}
