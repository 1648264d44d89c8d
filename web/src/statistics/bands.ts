// What is measured of a pattern, and what is published of patterns like it: the numbers in brackets
// in docs/presets.md, whose keys docs/statistics.md explains.

export interface Row {
  key: string; // "angles.t"
  name: string;
  low: number; // what the plot spans
  high: number;
}

export const rows: readonly Row[] = [
  { key: "angles.t", name: "T junctions", low: 0, high: 1 },
  { key: "angles.y", name: "Y junctions", low: 0, high: 1 },
  { key: "nodes.cross", name: "X crossings", low: 0, high: 0.5 },
  { key: "nodes.end", name: "Free ends", low: 0, high: 0.6 },
  { key: "angles.min", name: "Least angle °", low: 60, high: 120 },
  { key: "angles.mid", name: "Middle angle °", low: 80, high: 140 },
  { key: "angles.max", name: "Largest angle °", low: 120, high: 180 },
  { key: "cells.sides", name: "Sides", low: 3, high: 7 },
  { key: "areas.cv", name: "Area spread", low: 0, high: 1.2 },
  { key: "edges.tortuosity", name: "Tortuosity", low: 1, high: 1.2 },
  { key: "order.leg_younger", name: "Legs younger", low: 0.5, high: 1 },
];

/** Published, by preset and key: from, to. */
export const published: Record<string, Record<string, readonly [number, number]>> = {
  glaze: { "cells.sides": [4, 4], "angles.min": [90, 90] },
  mud: { "cells.sides": [4, 4], "angles.min": [90, 90] },
  paint: {
    "angles.t": [0.61, 0.88],
    "angles.y": [0, 0.06],
    "nodes.cross": [0.03, 0.1],
    "nodes.end": [0.21, 0.47],
    "angles.min": [73, 84],
    "angles.mid": [108, 115],
    "angles.max": [164, 174],
    "areas.cv": [0.77, 0.85],
    "edges.tortuosity": [1.08, 1.09],
  },
  "mud-mature": {
    "angles.t": [0.08, 0.08],
    "angles.y": [0.42, 0.42],
    "angles.min": [98, 98],
    "angles.mid": [121, 121],
    "angles.max": [141, 141],
    "cells.sides": [5.57, 5.57],
    "areas.cv": [0.63, 0.66],
    "edges.tortuosity": [1.04, 1.04],
  },
};
