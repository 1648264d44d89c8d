// Elements by what they are; a control has its name from its label.

type Attributes = Record<string, string>;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

export function button(name: string, press: () => void, attributes: Attributes = {}) {
  const made = element("button", { type: "button", ...attributes }, name);
  made.addEventListener("click", press);
  return made;
}

/** A row of choices of which one holds; `choose` is told when a person picks another. */
export function radioGroup(name: string, choices: readonly Choice[], choose: (v: string) => void) {
  const group = element("fieldset", { role: "radiogroup", "aria-label": name });
  group.append(element("legend", {}, name));
  for (const { value, label, help, picture } of choices) {
    const input = element("input", { type: "radio", name: `radio-${name}`, value });
    input.addEventListener("change", () => choose(value));
    const row = element("label", { title: help ?? "" }, input);
    if (picture) row.append(element("img", { src: picture, alt: "", width: "72", height: "54" }));
    row.append(label);
    group.append(row);
  }
  const show = (value: string) => {
    for (const input of group.querySelectorAll("input")) input.checked = input.value === value;
  };
  return { group, show };
}

export interface Choice {
  value: string;
  label: string;
  help?: string;
  picture?: string | undefined; // its address
}

export function combobox(name: string, choices: readonly Choice[], choose: (v: string) => void) {
  const select = element("select", { "aria-label": name });
  for (const { value, label } of choices) select.append(element("option", { value }, label));
  select.addEventListener("change", () => choose(select.value));
  return { row: element("label", { class: "row" }, element("span", {}, name), select), select };
}

export function checkbox(name: string, change: (checked: boolean) => void) {
  const input = element("input", { type: "checkbox" });
  input.addEventListener("change", () => change(input.checked));
  return { row: element("label", { class: "row" }, input, element("span", {}, name)), input };
}
