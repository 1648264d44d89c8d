// Whether a worker still lives: no event tells of one that ends by itself. It holds a lock, which is
// let go with it, and the page waits for that. Without locks (an address that is neither https nor
// this machine) nothing is told.

/** In the worker: holds the lock for as long as it lives; resolved once it has it. */
export async function holdLife(name: string): Promise<void> {
  const { locks } = navigator;
  if (!locks) return;
  await new Promise<void>((held) => {
    void locks.request(name, () => {
      held();
      return new Promise(() => {});
    });
  });
}

/** In the page, once the worker holds it: resolved when the worker is gone. */
export async function endOfLife(name: string): Promise<void> {
  const { locks } = navigator;
  if (!locks) return new Promise(() => {});
  await locks.request(name, () => {});
}

let count = 0;

/** A name that no other worker has, of this page or another. */
export function newLife(): string {
  return `craze-worker-${Math.random()}-${count++}`;
}
