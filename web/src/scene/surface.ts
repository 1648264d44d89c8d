// A surface with corners of its own per triangle, and its colours.
import * as three from "three";

const looks: Record<string, { color: number; roughness: number }> = {
  glaze: { color: 0xb9cbbb, roughness: 0.22 },
  mud: { color: 0x9a7b5c, roughness: 0.95 },
  glass: { color: 0xcfe4e6, roughness: 0.08 },
  plaster: { color: 0xd8d2c8, roughness: 0.9 },
  clay: { color: 0xb9795a, roughness: 0.8 },
  paint: { color: 0xb04a3a, roughness: 0.45 },
};

const plainTint = new three.Color(1.25, 1.25, 1.25); // as bright as with the environment's light

type Rgb = readonly [number, number, number];

/** A colour per number, far from those of the numbers beside it. */
function colorOf(number: number): three.Color {
  return new three.Color().setHSL((number * 0.618034) % 1, 0.45, 0.62);
}

export class Surface {
  readonly object: three.Mesh<three.BufferGeometry, three.Material>;
  readonly material: three.MeshStandardMaterial;
  private readonly plain: three.MeshLambertMaterial; // without the environment's light
  private look = ""; // not set yet
  private overlaid = false; // whether a colour is mixed in
  private fragments: Int32Array | null = null;
  private walls: Uint8Array | null = null;
  private colored = false;

  constructor() {
    const common = {
      vertexColors: true,
      side: three.DoubleSide,
      polygonOffset: true, // lines that lie on it are in front
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    };
    this.material = new three.MeshStandardMaterial(common);
    this.plain = new three.MeshLambertMaterial({ ...common, color: plainTint });
    this.object = new three.Mesh(new three.BufferGeometry(), this.material);
    this.setLook("clay");
  }

  /** Three numbers per corner each; per triangle its fragment, and whether it is a wall. */
  set(
    positions: Float32Array,
    normals: Float32Array,
    fragments: Int32Array | null,
    walls: Uint8Array | null,
  ): void {
    this.fragments = fragments;
    this.walls = walls;
    this.overlaid = false;
    this.object.geometry.dispose();
    this.object.geometry = new three.BufferGeometry();
    this.object.geometry.setAttribute("normal", new three.BufferAttribute(normals, 3));
    const colors = new Float32Array(positions.length);
    this.object.geometry.setAttribute("color", new three.BufferAttribute(colors, 3));
    this.move(positions);
    this.paintAll();
  }

  move(positions: Float32Array): void {
    this.object.geometry.setAttribute("position", new three.BufferAttribute(positions, 3));
    this.object.geometry.computeBoundingSphere();
  }

  /** How the surface looks, by the names of picture.material; returns whether that is new. */
  setLook(name: string): boolean {
    const look = name in looks ? name : "clay";
    if (look === this.look) return false;
    this.look = look;
    this.material.roughness = looks[look]!.roughness;
    this.paintAll();
    return true;
  }

  showFragments(colored: boolean): void {
    this.colored = colored;
    this.paintAll();
  }

  showWireframe(shown: boolean): void {
    this.material.wireframe = this.plain.wireframe = shown;
  }

  /** Plainly lit, which takes half the time where the processor draws. */
  showPlain(plain: boolean): void {
    this.object.material = plain ? this.plain : this.material;
  }

  /** Linear colours of its corners. */
  color(of: (corner: number) => Rgb): void {
    const colors = this.object.geometry.getAttribute("color");
    if (!colors) return;
    for (let corner = 0; corner < colors.count; ++corner) colors.setXYZ(corner, ...of(corner));
    colors.needsUpdate = true;
  }

  /** Mixes a colour in: `paint` is one per vertex, 0 … 1. */
  overlay(paint: Float32Array | null, triangles: Uint32Array, color: number): void {
    if (!paint) {
      if (this.overlaid) this.paintAll();
      this.overlaid = false;
      return;
    }
    this.overlaid = true;
    const [base, mixed] = [new three.Color(looks[this.look]!.color), new three.Color()];
    const top = new three.Color(color);
    this.color((corner) => {
      mixed.lerpColors(base, top, 0.85 * Math.min(paint[triangles[corner]!]!, 1));
      return [mixed.r, mixed.g, mixed.b];
    });
  }

  private paintAll(): void {
    const base = new three.Color(looks[this.look]!.color);
    const wall = base.clone().multiplyScalar(0.25);
    let [face, rgb]: [number, Rgb] = [-1, [0, 0, 0]];
    this.color((corner) => {
      const f = Math.floor(corner / 3);
      if (f === face) return rgb;
      face = f;
      const own = this.colored && this.fragments ? colorOf(this.fragments[f]!) : base;
      const { r, g, b } = this.walls?.[f] ? wall : own;
      return (rgb = [r, g, b]);
    });
  }
}
