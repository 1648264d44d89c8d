// Where on the input's surface a pointer is.
import * as three from "three";
import { MeshBVH } from "three-mesh-bvh";
import { steps } from "./brush";
import type { Canvas } from "./canvas";

export interface Hit {
  point: three.Vector3;
  normal: three.Vector3;
}

export class Picking {
  private readonly tree: MeshBVH;
  private readonly ray = new three.Raycaster();

  constructor(positions: Float32Array, triangles: Uint32Array) {
    const geometry = new three.BufferGeometry();
    geometry.setAttribute("position", new three.BufferAttribute(positions, 3));
    geometry.setIndex(new three.BufferAttribute(triangles.slice(), 1)); // the tree sorts it
    this.tree = new MeshBVH(geometry);
  }

  /** What is seen at a place of the canvas, null where there is nothing. */
  at(event: PointerEvent, camera: three.Camera): Hit | null {
    const box = (event.target as HTMLElement).getBoundingClientRect();
    const x = (2 * (event.clientX - box.left)) / box.width - 1;
    const y = 1 - (2 * (event.clientY - box.top)) / box.height;
    this.ray.setFromCamera(new three.Vector2(x, y), camera);
    const hit = this.tree.raycastFirst(this.ray.ray, three.DoubleSide);
    if (!hit?.face) return null;
    const normal = hit.face.normal.clone();
    if (normal.dot(this.ray.ray.direction) > 0) normal.negate();
    return { point: hit.point, normal };
  }
}

/** The six whole numbers of a dab: see Stroke. */
export function dabOf({ point, normal }: Hit, { low, size }: Canvas): number[] {
  const place = point
    .toArray()
    .map((x, k) => Math.round(size[k]! > 0 ? (steps * (x - low[k]!)) / size[k]! : 0));
  return [...place, ...normal.toArray().map((x) => Math.round(127 * x))];
}
