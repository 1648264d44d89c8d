// Cracks as lines of one width on the screen; each piece appears when the growth comes by.
//
// A piece is two triangles of four vertices of its own. Instances of one quad would take a quarter of
// the room, but without a graphics processor each of them is a draw call by itself: forty times as
// slow.
import * as three from "three";

const vertexShader = `
  attribute vec3 other; // the piece's other end
  attribute float side, growth;
  uniform vec2 resolution;
  uniform float width, lift;
  varying float passed;
  void main() {
    vec4 a = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    vec4 b = projectionMatrix * modelViewMatrix * vec4(other, 1.0);
    vec2 along = (b.xy / b.w - a.xy / a.w) * resolution;
    vec2 across = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(0.0);
    gl_Position = a;
    gl_Position.xy += side * width * across / resolution * a.w;
    gl_Position.z -= lift * a.w; // in front of the surface that it lies on
    passed = growth;
  }`;

const fragmentShader = `
  uniform float time;
  uniform vec3 color, oldest, youngest;
  uniform bool byAge;
  varying float passed;
  void main() {
    if (passed > time + 1e-5) discard; // interpolated between equal ends, it is not quite theirs
    gl_FragColor = vec4(byAge ? mix(oldest, youngest, passed) : color, 1.0);
    #include <colorspace_fragment>
  }`;

const lineWidth = 2; // pixels of the page
const corners = 4; // of a piece: two at its first end, two at its last
const numbers = 8; // of a corner: place, other end, side, growth
const stride = corners * numbers;

export class CrackLines {
  readonly object: three.Mesh;
  private vertices = new three.InterleavedBuffer(new Float32Array(0), numbers);
  private readonly geometry = new three.BufferGeometry();
  private readonly uniforms = {
    resolution: { value: new three.Vector2(1, 1) },
    width: { value: lineWidth }, // pixels of the picture
    lift: { value: 5e-5 }, // toward the eye, in depth
    time: { value: 1 },
    color: { value: new three.Color(0x1b130e) },
    byAge: { value: false },
    oldest: { value: new three.Color(0x3a0c5e) },
    youngest: { value: new three.Color(0xf0a020) },
  };

  constructor() {
    const material = new three.ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms: this.uniforms,
      side: three.DoubleSide,
    });
    this.object = new three.Mesh(this.geometry, material);
    this.object.frustumCulled = false;
    this.object.onBeforeRender = (renderer) => {
      const { resolution, width } = this.uniforms;
      renderer.getDrawingBufferSize(resolution.value);
      width.value = Math.max(lineWidth * renderer.getPixelRatio(), 1);
    };
    this.makeRoom(0);
  }

  /** Six numbers a piece, from and to, and two, when the growth comes by its ends. */
  set(lines: Float32Array, growth: Float32Array): void {
    const count = growth.length / 2;
    this.makeRoom(count);
    const { array } = this.vertices;
    for (let corner = 0; corner < corners * count; ++corner) {
      array[numbers * corner + 7] = growth[2 * Math.floor(corner / corners) + endOf(corner)]!;
    }
    this.place(lines, 0);
    this.geometry.setDrawRange(0, 6 * count);
  }

  /** More pieces, grown from the first, behind those that were appended; `first` of them stay. Only
   * what is new goes to where it is drawn. */
  append(pieces: Float32Array, first: number): void {
    const count = first + pieces.length / 6;
    if (this.vertices.array.length < stride * count) {
      const before = this.vertices.array.subarray(0, stride * first);
      this.makeRoom(Math.max(1024, 2 * count));
      this.vertices.array.set(before);
    }
    this.place(pieces, first);
    this.vertices.addUpdateRange(stride * first, (stride * pieces.length) / 6);
    this.geometry.setDrawRange(0, 6 * count);
  }

  /** The same pieces elsewhere. */
  move(lines: Float32Array): void {
    this.place(lines, 0);
  }

  private place(lines: Float32Array, first: number): void {
    const { array } = this.vertices;
    for (let corner = 0; corner < (corners * lines.length) / 6; ++corner) {
      const piece = 6 * Math.floor(corner / corners);
      const own = piece + 3 * endOf(corner);
      const other = piece + 3 - 3 * endOf(corner);
      const at = numbers * (corners * first + corner);
      for (let k = 0; k < 3; ++k) {
        array[at + k] = lines[own + k]!;
        array[at + 3 + k] = lines[other + k]!;
      }
      array[at + 6] = corner % 2 === 0 ? -1 : 1;
    }
    this.vertices.needsUpdate = true;
  }

  /** For so many pieces, grown from the first. */
  private makeRoom(pieces: number): void {
    this.vertices = new three.InterleavedBuffer(new Float32Array(stride * pieces), numbers);
    const set = (name: string, size: number, from: number) => {
      const attribute = new three.InterleavedBufferAttribute(this.vertices, size, from);
      this.geometry.setAttribute(name, attribute);
    };
    set("position", 3, 0);
    set("other", 3, 3);
    set("side", 1, 6);
    set("growth", 1, 7);
    const index = new Uint32Array(6 * pieces);
    for (let i = 0; i < pieces; ++i) {
      // Sides are seen from each end: left of the first is right of the last.
      index.set([0, 1, 2, 0, 2, 3].map((k) => corners * i + k), 6 * i);
    }
    this.geometry.dispose(); // what was there goes from where it is drawn
    this.geometry.setIndex(new three.BufferAttribute(index, 1));
  }

  /** Draws those from `first` on alone. */
  drawFrom(first: number): void {
    const { count, start } = this.geometry.drawRange;
    this.geometry.setDrawRange(6 * first, start + count - 6 * first);
  }

  showUntil(time: number): void {
    this.uniforms.time.value = time;
  }

  /** Returns whether it is another one. */
  setColor(color: number): boolean {
    const { value } = this.uniforms.color;
    const before = value.getHex();
    return value.set(color).getHex() !== before;
  }

  /** The first cracks dark, the last ones light. */
  showAge(shown: boolean): void {
    this.uniforms.byAge.value = shown;
  }

  lift(depth: number): void {
    this.uniforms.lift.value = depth;
  }
}

/** Which end of its piece a corner is at: 0 or 1. */
const endOf = (corner: number) => (corner % corners < 2 ? 0 : 1);
