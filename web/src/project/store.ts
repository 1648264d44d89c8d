// The one place where the project is; every change can be undone. States share what did not change,
// so that a step of the history costs what the change itself does.
import type { Project } from "./project";

const longest = 500; // steps that can be undone

export class Store {
  private past: Project[] = [];
  private future: Project[] = [];
  private readonly listeners: ((now: Project, before: Project) => void)[] = [];

  constructor(private now: Project) {}

  get project(): Project {
    return this.now;
  }
  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }

  onChange(listener: (now: Project, before: Project) => void): void {
    this.listeners.push(listener);
  }

  change(change: Partial<Project>): void {
    this.past.push(this.now);
    if (this.past.length > longest) this.past.shift();
    this.future = [];
    this.show({ ...this.now, ...change });
  }

  undo(): void {
    this.step(this.past, this.future);
  }

  redo(): void {
    this.step(this.future, this.past);
  }

  private step(from: Project[], to: Project[]): void {
    const next = from.pop();
    if (!next) return;
    to.push(this.now);
    this.show(next);
  }

  private show(next: Project): void {
    const before = this.now;
    this.now = next;
    for (const listener of this.listeners) listener(next, before);
  }
}
