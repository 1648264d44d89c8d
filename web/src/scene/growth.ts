// The play head: which moment of the growth is seen.
import type { Engine } from "../engine/engine";
import type { Stage } from "./stage";

const seconds = 2.5; // of a clip

export class Growth {
  private opened = false; // whether places move, or cracks only appear
  private wanted: number | null = null; // a moment to ask for when the last one has come
  private asking = false;
  private clip = 0; // counts those that were started

  constructor(
    private readonly engine: Engine,
    private readonly stage: Stage,
    private readonly tell: (time: number) => void,
  ) {}

  setOpened(opened: boolean): void {
    this.opened = opened;
  }

  /** Shows a time, 0 … 1; ends a clip. */
  async show(time: number): Promise<void> {
    ++this.clip;
    await this.at(time);
  }

  /** From no crack to all of them; at once where motion is not wanted. */
  async play(): Promise<void> {
    const clip = ++this.clip;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return this.at(1);
    const begin = performance.now();
    const step = () => {
      if (clip !== this.clip) return;
      const time = Math.min((performance.now() - begin) / (1000 * seconds), 1);
      void this.at(time);
      if (time < 1) requestAnimationFrame(step);
    };
    step();
  }

  /** The same frame by frame, each of them seen, whatever motion is wanted: for a film. */
  async film(): Promise<void> {
    const clip = ++this.clip;
    const begin = performance.now();
    for (let time = 0; clip === this.clip && time < 1; ) {
      time = Math.min((performance.now() - begin) / (1000 * seconds), 1);
      await this.at(time);
      await new Promise(requestAnimationFrame);
    }
  }

  private async at(time: number): Promise<void> {
    this.tell(time);
    this.stage.showUntil(time);
    if (!this.opened) return;
    this.wanted = time;
    if (this.asking) return;
    this.asking = true;
    try {
      while (this.wanted !== null) {
        const moment = this.wanted;
        this.wanted = null;
        this.stage.setMoment(await this.engine.moment(moment));
      }
    } catch {
      // The result it belongs to is gone, and the next one is shown instead.
    } finally {
      this.asking = false;
    }
  }
}
