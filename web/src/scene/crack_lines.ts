// Cracks as lines of one width on the screen; each piece appears when the growth comes by.
import * as three from "three";

const vertexShader = `
  attribute vec3 start, end;
  attribute vec2 growth;
  uniform vec2 resolution;
  uniform float width, lift;
  varying float passed;
  void main() {
    vec4 a = projectionMatrix * modelViewMatrix * vec4(start, 1.0);
    vec4 b = projectionMatrix * modelViewMatrix * vec4(end, 1.0);
    vec2 along = (b.xy / b.w - a.xy / a.w) * resolution;
    vec2 across = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(0.0);
    gl_Position = position.x < 0.5 ? a : b;
    gl_Position.xy += position.y * width * across / resolution * gl_Position.w;
    gl_Position.z -= lift * gl_Position.w; // in front of the surface that it lies on
    passed = position.x < 0.5 ? growth.x : growth.y;
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

export class CrackLines {
  readonly object: three.Mesh;
  private room: three.InstancedInterleavedBuffer | null = null; // of what was appended
  private readonly geometry = new three.InstancedBufferGeometry();
  private readonly uniforms = {
    resolution: { value: new three.Vector2(1, 1) },
    width: { value: 2 }, // pixels
    lift: { value: 5e-5 }, // toward the eye, in depth
    time: { value: 1 },
    color: { value: new three.Color(0x1b130e) },
    byAge: { value: false },
    oldest: { value: new three.Color(0x3a0c5e) },
    youngest: { value: new three.Color(0xf0a020) },
  };

  constructor() {
    const corners = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]);
    this.geometry.setAttribute("position", new three.BufferAttribute(corners, 3));
    this.geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const material = new three.ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms: this.uniforms,
      side: three.DoubleSide,
    });
    this.object = new three.Mesh(this.geometry, material);
    this.object.frustumCulled = false;
    this.object.onBeforeRender = (renderer) =>
      renderer.getDrawingBufferSize(this.uniforms.resolution.value);
  }

  /** Six numbers a piece, from and to, and two, when the growth comes by its ends. */
  set(lines: Float32Array, growth: Float32Array): void {
    this.move(lines);
    this.geometry.setAttribute("growth", new three.InstancedBufferAttribute(growth, 2));
    this.geometry.instanceCount = growth.length / 2;
  }

  /** More pieces, grown from the first, behind those that were appended; `first` of them stay. Only
   * what is new goes to where it is drawn. */
  append(pieces: Float32Array, first: number): void {
    const count = first + pieces.length / 6;
    if (!this.room || this.room.count < count) {
      const room = new Float32Array(6 * Math.max(1024, 2 * count));
      if (this.room) room.set(this.room.array.subarray(0, 6 * first));
      this.room = this.place(room);
      const growth = new three.InstancedBufferAttribute(new Float32Array(room.length / 3), 2);
      this.geometry.setAttribute("growth", growth);
    }
    this.room.array.set(pieces, 6 * first);
    this.room.addUpdateRange(6 * first, pieces.length);
    this.room.needsUpdate = true;
    this.geometry.instanceCount = count;
  }

  /** The same pieces elsewhere. */
  move(lines: Float32Array): void {
    this.room = null;
    this.place(lines);
  }

  private place(lines: Float32Array): three.InstancedInterleavedBuffer {
    const both = new three.InstancedInterleavedBuffer(lines, 6, 1);
    this.geometry.setAttribute("start", new three.InterleavedBufferAttribute(both, 3, 0));
    this.geometry.setAttribute("end", new three.InterleavedBufferAttribute(both, 3, 3));
    return both;
  }

  showUntil(time: number): void {
    this.uniforms.time.value = time;
  }

  setColor(color: number): void {
    this.uniforms.color.value.set(color);
  }

  /** The first cracks dark, the last ones light. */
  showAge(shown: boolean): void {
    this.uniforms.byAge.value = shown;
  }

  lift(depth: number): void {
    this.uniforms.lift.value = depth;
  }
}
