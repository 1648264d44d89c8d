// A surface to paint on.

export interface Canvas {
  positions: Float32Array; // three per vertex
  normals: Float32Array; // three per vertex, of any length
  low: [number, number, number];
  size: [number, number, number]; // of the box
  diagonal: number;
}

export function canvasOf(positions: Float32Array, triangles: Uint32Array): Canvas {
  const low: Canvas["low"] = [Infinity, Infinity, Infinity];
  const high: Canvas["low"] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3]!, positions[i]!);
    high[i % 3] = Math.max(high[i % 3]!, positions[i]!);
  }
  const size: Canvas["size"] = [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
  const diagonal = Math.sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]);
  return { positions, normals: vertexNormals(positions, triangles), low, size, diagonal };
}

/** Which side of a wall a vertex is on; not for looking at. */
function vertexNormals(p: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(p.length);
  for (let f = 0; f < triangles.length; f += 3) {
    const [a, b, c] = [3 * triangles[f]!, 3 * triangles[f + 1]!, 3 * triangles[f + 2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const at of [a, b, c]) for (let k = 0; k < 3; ++k) normals[at + k]! += normal[k]!;
  }
  return normals;
}
