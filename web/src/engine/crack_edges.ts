// The cracks of a cut mesh: its open edges that lie on a crack, those of walls left out.

/** Pairs of vertices, two numbers an edge. `triangles`: three vertices each; `distance`: per vertex,
 * 0 on a crack; `walls`: per triangle, 1 where it is a wall. */
export function crackEdges(
  triangles: Int32Array,
  distance: ArrayLike<number>,
  walls: Uint8Array,
): Uint32Array {
  const vertices = distance.length;
  const open = new Set<number>();
  for (let corner = 0; corner < triangles.length; ++corner) {
    if (walls[Math.floor(corner / 3)]) continue;
    const from = triangles[corner]!;
    const to = triangles[corner % 3 === 2 ? corner - 2 : corner + 1]!;
    if (distance[from] !== 0 || distance[to] !== 0) continue;
    if (!open.delete(to * vertices + from)) open.add(from * vertices + to);
  }
  const edges = new Uint32Array(2 * open.size);
  let at = 0;
  for (const key of open) {
    edges[at++] = Math.floor(key / vertices);
    edges[at++] = key % vertices;
  }
  return edges;
}
