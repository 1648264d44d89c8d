// The paper's loop as steps that can be gone through, forth and back.

export const lines = [
  { key: "1", text: "1. Initialise the stress field." },
  { key: "2", text: "2. Compute the failure criterion of each node: a queue by the largest value of ς." },
  { key: "3", text: "3. While failure can occur:" },
  { key: "3a", text: "3a. Crack the mesh at the top of the queue." },
  { key: "3b", text: "3b. Evolve the stress field: relax it." },
  { key: "3c", text: "3c. Update the mesh and the queue." },
] as const;

export type LineKey = (typeof lines)[number]["key"];

export interface LoopStep {
  line: LineKey;
  crack: number; // how many cracks are open before this turn of the loop
  says: string;
}

/** The n-th step from the beginning: two to begin with, then three to a turn. */
export function stepAt(n: number): LoopStep {
  if (n === 0) return { line: "1", crack: 0, says: "Tension pulls at every node: its forces." };
  if (n === 1) {
    return { line: "2", crack: 0, says: "ς of each node as an ellipse; red where it exceeds τ." };
  }
  const crack = Math.floor((n - 2) / 3);
  const turn: Omit<LoopStep, "crack">[] = [
    {
      line: "3a",
      says: `Crack ${crack + 1} opens through the node with the largest ς, across its tension.`,
    },
    { line: "3b", says: "The forces beside the new crack go, those ahead of its tips grow." },
    {
      line: "3c",
      says: "ς anew. At the new tips the residual of Eq. 8 helps the crack on: the filled discs.",
    },
  ];
  return { crack, ...turn[(n - 2) % 3]! };
}
