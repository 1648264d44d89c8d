// Where on the input's surface a pointer is.
import * as three from "three";
import { MeshBVH } from "three-mesh-bvh";
import { steps } from "./brush";
import type { Canvas } from "./canvas";

/** A place of the canvas, 0 … 1 from the left and from the top. */
export interface Place {
  x: number;
  y: number;
}

export interface Hit {
  point: three.Vector3;
  normal: three.Vector3;
}

export class Picking {
  private tree: MeshBVH | null = null; // made when it is asked for: whoever does not paint needs none
  private readonly ray = new three.Raycaster();

  constructor(
    private readonly positions: Float32Array,
    private readonly triangles: Uint32Array,
  ) {}

  /** What is seen at a place of the canvas, null where there is nothing. */
  at({ x, y }: Place, camera: three.Camera): Hit | null {
    this.ray.setFromCamera(new three.Vector2(2 * x - 1, 1 - 2 * y), camera);
    this.tree ??= this.makeTree();
    const hit = this.tree.raycastFirst(this.ray.ray, three.DoubleSide);
    if (!hit?.face) return null;
    const normal = hit.face.normal.clone();
    if (normal.dot(this.ray.ray.direction) > 0) normal.negate();
    return { point: hit.point, normal };
  }

  private makeTree(): MeshBVH {
    const geometry = new three.BufferGeometry();
    geometry.setAttribute("position", new three.BufferAttribute(this.positions, 3));
    geometry.setIndex(new three.BufferAttribute(this.triangles.slice(), 1)); // the tree sorts it
    return new MeshBVH(geometry);
  }
}

/** The six whole numbers of a dab: see Stroke. */
export function dabOf({ point, normal }: Hit, { low, size }: Canvas): number[] {
  const place = point
    .toArray()
    .map((x, k) => Math.round(size[k]! > 0 ? (steps * (x - low[k]!)) / size[k]! : 0));
  return [...place, ...normal.toArray().map((x) => Math.round(127 * x))];
}
