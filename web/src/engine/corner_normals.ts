// Normals for looking at: smooth, but for edges sharper than the crease.

const cosineOfCrease = Math.cos((40 * Math.PI) / 180);

/** Three numbers per corner, unit. `positions`: three per vertex; vertices at one place count as
 * one, so that a shut crack or a seam is not seen in the shading. */
export function cornerNormals(positions: ArrayLike<number>, triangles: Int32Array): Float32Array {
  const count = triangles.length / 3;
  const flat = new Float32Array(3 * count); // twice the area long
  for (let f = 0; f < count; ++f) flat.set(normalOf(positions, triangles, f), 3 * f);

  const places = weld(positions);
  const fan = cornersOf(places, triangles);
  const normals = new Float32Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; ++corner) {
    const own = Math.floor(corner / 3);
    let x = 0;
    let y = 0;
    let z = 0;
    const place = places[triangles[corner]!]!;
    for (let i = fan.first[place]!; i < fan.first[place + 1]!; ++i) {
      const other = Math.floor(fan.corners[i]! / 3);
      if (other !== own && cosine(flat, own, other) < cosineOfCrease) continue;
      x += flat[3 * other]!;
      y += flat[3 * other + 1]!;
      z += flat[3 * other + 2]!;
    }
    const length = Math.hypot(x, y, z) || 1;
    normals.set([x / length, y / length, z / length], 3 * corner);
  }
  return normals;
}

function normalOf(p: ArrayLike<number>, triangles: Int32Array, f: number) {
  const a = 3 * triangles[3 * f]!;
  const b = 3 * triangles[3 * f + 1]!;
  const c = 3 * triangles[3 * f + 2]!;
  const u = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!] as const;
  const v = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!] as const;
  return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
}

function cosine(flat: Float32Array, f: number, g: number): number {
  const [a, b] = [3 * f, 3 * g];
  const dot = flat[a]! * flat[b]! + flat[a + 1]! * flat[b + 1]! + flat[a + 2]! * flat[b + 2]!;
  const lengths =
    Math.hypot(flat[a]!, flat[a + 1]!, flat[a + 2]!) *
    Math.hypot(flat[b]!, flat[b + 1]!, flat[b + 2]!);
  return lengths > 0 ? dot / lengths : 1;
}

/** The number of each vertex's place: those at the same place have the same. */
function weld(positions: ArrayLike<number>): Uint32Array {
  const places = new Uint32Array(positions.length / 3);
  const found = new Map<string, number>();
  for (let v = 0; v < places.length; ++v) {
    const key = `${positions[3 * v]},${positions[3 * v + 1]},${positions[3 * v + 2]}`;
    const place = found.get(key) ?? found.size;
    found.set(key, place);
    places[v] = place;
  }
  return places;
}

/** The corners at each place p: corners[first[p]] … corners[first[p + 1] - 1]. */
function cornersOf(places: Uint32Array, triangles: Int32Array) {
  const first = new Uint32Array(places.length + 1);
  for (const vertex of triangles) ++first[places[vertex]! + 1]!;
  for (let i = 0; i < places.length; ++i) first[i + 1]! += first[i]!;
  const next = first.slice();
  const corners = new Uint32Array(triangles.length);
  triangles.forEach((vertex, corner) => (corners[next[places[vertex]!]!++] = corner));
  return { first, corners };
}
