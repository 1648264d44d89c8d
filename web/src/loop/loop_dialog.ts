// The paper's loop, step by step, in a window of its own.
import type { Engine } from "../engine/engine";
import type { LoopState } from "../engine/messages";
import { button, element } from "../ui/elements";
import { loopDrawing } from "./loop_drawing";
import { lines, stepAt } from "./loop_steps";

export class LoopDialog {
  readonly root = element("dialog", { "aria-label": "The paper's loop", class: "loop-dialog" });
  private readonly picture = element("div", { class: "loop-picture" });
  private readonly says = element("p", { role: "status", "aria-label": "Step" });
  private readonly code = new Map(
    lines.map(({ key, text }) => [key, element("li", { class: `level${key.length}` }, text)]),
  );
  private readonly back = button("Back", () => void this.go(-1));
  private readonly next = button("Next", () => void this.go(1), { class: "main" });
  private readonly turn = button("Next crack", () => void this.go(3));
  private states = new Map<number, Promise<LoopState>>();
  private wanted = 0; // the step to be shown
  private showing = false;

  constructor(
    private readonly engine: Engine,
    private readonly seed: () => number,
  ) {
    const buttons = element("div", { class: "buttons" }, this.back, this.next, this.turn);
    buttons.append(button("Close", () => this.root.close()));
    this.root.append(
      this.picture,
      element(
        "div",
        { class: "loop-text" },
        element("h2", {}, "How it cracks (Iben & O'Brien 2006, section 3.1)"),
        element("ol", {}, ...this.code.values()),
        this.says,
        buttons,
      ),
    );
  }

  async open(): Promise<void> {
    this.states.clear(); // of another seed
    this.wanted = 0;
    this.root.showModal();
    await this.go(0);
  }

  private state(cracks: number): Promise<LoopState> {
    const known = this.states.get(cracks) ?? this.engine.loop(cracks, this.seed());
    this.states.set(cracks, known);
    return known;
  }

  /** So many steps on; those asked for while a state is computed count too. */
  private async go(by: number): Promise<void> {
    this.wanted = Math.max(this.wanted + by, 0);
    if (this.showing) return;
    this.showing = true;
    try {
      for (let shown = -1; shown !== this.wanted; ) {
        shown = this.wanted;
        await this.show(shown);
      }
    } finally {
      this.showing = false;
    }
  }

  private async show(n: number): Promise<void> {
    const { line, crack, says } = stepAt(n);
    const before = await this.state(crack);
    const after = n > 1 ? await this.state(crack + 1) : before;
    const turns = n > 1;
    const cracked = turns && line !== "3a";
    const ended = turns && after.events.length === before.events.length;
    const shown = {
      forces: line === "1" || line === "3b",
      separation: line !== "1" && line !== "3b",
      crack: turns && !ended ? crack : null,
    };
    this.picture.replaceChildren(loopDrawing(cracked ? after : before, after, shown));
    for (const [key, item] of this.code) {
      if (key === (ended ? "3" : line)) item.setAttribute("aria-current", "step");
      else item.removeAttribute("aria-current");
    }
    this.says.textContent = ended ? "No node fails any more: the loop ends." : says;
    this.back.disabled = n === 0;
    this.next.disabled = this.turn.disabled = ended;
  }
}
