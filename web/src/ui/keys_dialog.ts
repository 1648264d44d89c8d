// What the keys do, in a window of its own.
import { button, element } from "./elements";

const keys: readonly (readonly [string, string])[] = [
  ["Ctrl+Z, Ctrl+Shift+Z", "undo, redo"],
  ["?", "this list"],
  ["In the view", ""],
  ["Arrow keys", "turn it"],
  ["+ and -", "zoom"],
  ["F", "show all of it"],
  ["In the view, with a paint or Impact chosen", ""],
  ["Arrow keys", "move the brush; with Shift in small steps"],
  ["Ctrl+arrow keys", "turn the view"],
  ["Space or Enter", "put the brush down, and up again; Impact: strike"],
  ["Escape", "give up the stroke"],
  ["[ ] or , .", "smaller and larger brush"],
];

export class KeysDialog {
  readonly root = element("dialog", { "aria-label": "Keys", class: "keys-dialog" });

  constructor() {
    const rows = keys.map(([key, does]) =>
      does
        ? element("tr", {}, element("th", { scope: "row" }, element("kbd", {}, key)), element("td", {}, does))
        : element("tr", {}, element("th", { scope: "colgroup", colspan: "2" }, key)),
    );
    const close = element("div", { class: "buttons" }, button("Close", () => this.root.close()));
    const table = element("table", {}, element("tbody", {}, ...rows));
    this.root.append(element("h2", {}, "Keys"), table, close);
  }

  open(): void {
    if (!this.root.open) this.root.showModal();
  }
}
