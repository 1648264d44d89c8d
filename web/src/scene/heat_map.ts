// Stress and separation on the mesh that the cracks grew on, with their principal directions.
import * as three from "three";
import type { Fields } from "../engine/messages";
import { heatColor, scaleEnd } from "./heat_colors";
import { Surface } from "./surface";

export type HeatName = "stress" | "separation";

const mostMarks = 3000; // directions drawn at a time

export class HeatMap {
  readonly object = new three.Group();
  private readonly surface = new Surface();
  private readonly marks = new three.LineSegments(
    new three.BufferGeometry(),
    new three.LineBasicMaterial({ color: 0xffffff }),
  );

  constructor() {
    this.object.add(this.surface.object, this.marks);
    this.surface.material.roughness = 1;
  }

  /** Shows one of them; returns what the scale ends at. */
  set(fields: Fields, name: HeatName): number {
    const { positions, triangles, normals } = fields;
    const corners = new Float32Array(3 * triangles.length);
    triangles.forEach((vertex, corner) =>
      corners.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * corner),
    );
    this.surface.set(corners, normals, null, null);
    const values = name === "stress" ? fields.stress : fields.separation;
    const largest = values.filter((_, i) => i % 2 === 0);
    const end = scaleEnd(largest) || 1;
    this.surface.color((corner) =>
      heatColor(
        largest[name === "stress" ? Math.floor(corner / 3) : triangles[corner]!]! / end,
      ),
    );
    this.setMarks(fields, name, end);
    return end;
  }

  showMarks(shown: boolean): void {
    this.marks.visible = shown;
  }

  private setMarks(fields: Fields, name: HeatName, end: number): void {
    const { positions, triangles, stress, stressDirection } = fields;
    const faces = triangles.length / 3;
    const places: number[] = [];
    const length = 0.6 * Math.sqrt(areaOf(fields) / Math.min(faces, mostMarks));
    const mark = (x: number, y: number, z: number, direction: ArrayLike<number>, size: number) => {
      for (const sign of [-0.5, 0.5]) {
        const s = sign * size * length;
        places.push(x + s * direction[0]!, y + s * direction[1]!, z + s * direction[2]!);
      }
    };
    const count = name === "stress" ? faces : positions.length / 3;
    const stride = Math.max(1, Math.ceil(count / mostMarks));
    for (let i = 0; i < count; i += stride) {
      if (name === "stress") {
        const [a, b, c] = [3 * triangles[3 * i]!, 3 * triangles[3 * i + 1]!, 3 * triangles[3 * i + 2]!];
        const middle = (k: number) => (positions[a + k]! + positions[b + k]! + positions[c + k]!) / 3;
        const direction = stressDirection.subarray(3 * i, 3 * i + 3);
        mark(middle(0), middle(1), middle(2), direction, Math.min(stress[2 * i]! / end, 1));
      } else {
        const [x, y, z] = positions.subarray(3 * i, 3 * i + 3);
        const direction = fields.separationDirection.subarray(3 * i, 3 * i + 3);
        mark(x!, y!, z!, direction, Math.min(fields.separation[2 * i]! / end, 1));
      }
    }
    this.marks.geometry.dispose();
    this.marks.geometry = new three.BufferGeometry();
    const attribute = new three.Float32BufferAttribute(places, 3);
    this.marks.geometry.setAttribute("position", attribute);
  }
}

function areaOf({ positions: p, triangles }: Fields): number {
  const [u, v] = [new three.Vector3(), new three.Vector3()];
  let area = 0;
  for (let f = 0; f < triangles.length; f += 3) {
    const [a, b, c] = [3 * triangles[f]!, 3 * triangles[f + 1]!, 3 * triangles[f + 2]!];
    u.set(p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!);
    v.set(p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!);
    area += u.cross(v).length() / 2;
  }
  return area;
}
