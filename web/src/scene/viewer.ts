// The view: camera, light, and when to draw. Nothing is drawn while nothing changes.
import * as three from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";

const turn = Math.PI / 24; // of an arrow key

/** Two pictures side by side under one camera: left of `at`, 0 … 1 of the width, and right of it. */
export interface Split {
  at: number;
  show(side: "left" | "right"): void;
}

const hurriedPixels = 150_000; // of a picture that is drawn by the processor while it has other work

/** Whether a graphics processor draws: without one each picture costs the time of the run beside it,
 * and smooth edges as much as all the rest. */
function hasGraphics(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(gl!.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return !/swiftshader|llvmpipe|software/i.test(name);
}

export class Viewer {
  split: Split | null = null;
  readonly scene = new three.Scene();
  readonly camera = new three.PerspectiveCamera(30, 1, 0.01, 100);
  readonly controls: OrbitControls;
  /** What is drawn over the scene, as long as it only grows without the scene: drawOver(). */
  readonly over = new three.Scene();
  onOver: (all: boolean) => void = () => {}; // before it is drawn: all of it, or what is new
  private readonly renderer: three.WebGLRenderer;
  private readonly graphics = hasGraphics();
  private hurried = false;
  private asked = false;
  private whole = false; // whether all is to be drawn in the next frame
  private readonly middle = new three.Vector3();
  private radius = 1;

  /** Throws Error where there is no WebGL. */
  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new three.WebGLRenderer({
      canvas,
      antialias: this.graphics,
      preserveDrawingBuffer: !this.graphics, // for drawOver()
      alpha: true,
    });
    this.renderer.toneMapping = three.ACESFilmicToneMapping;
    this.camera.up.set(0, 0, 1);
    const room = new three.PMREMGenerator(this.renderer);
    this.scene.environment = room.fromScene(new RoomEnvironment()).texture;
    this.scene.environmentIntensity = 0.55;
    room.dispose();
    this.scene.add(new three.HemisphereLight(0xffffff, 0x8d8478, 0.7));
    const sun = new three.DirectionalLight(0xffffff, 1.1);
    sun.position.set(-2, -3, 4);
    this.scene.add(sun);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    canvas.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
  }

  /** Draws once, in the next frame. */
  draw(): void {
    this.whole = true;
    this.ask();
  }

  /** The same where only more came over the scene. Without a graphics processor it alone is drawn. */
  drawOver(): void {
    this.whole ||= this.graphics || this.split !== null;
    this.ask();
  }

  private ask(): void {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.whole) this.render();
      else this.renderOver(false);
    });
  }

  /** Whether there is a run to compute beside: then large pictures are drawn coarsely where the
   * processor draws them. Returns whether what is drawn should be plain too. */
  hurry(hurried: boolean): boolean {
    this.hurried = hurried && !this.graphics;
    if (this.renderer.getPixelRatio() !== this.pixelRatio()) {
      this.renderer.setPixelRatio(this.pixelRatio());
      this.draw();
    }
    return this.hurried;
  }

  private pixelRatio(): number {
    const ratio = Math.min(devicePixelRatio, 2);
    if (!this.hurried) return ratio;
    const { clientWidth, clientHeight } = this.canvas;
    return Math.min(ratio, Math.sqrt(hurriedPixels / Math.max(clientWidth * clientHeight, 1)));
  }

  /** What is seen now, as PNG. */
  picture(): Promise<Blob> {
    this.render(); // a canvas keeps nothing from frame to frame
    return new Promise((resolve, reject) =>
      this.canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("no picture")))),
    );
  }

  private render(): void {
    this.whole = false;
    if (!this.split) return this.renderAll();
    const { width, height } = this.renderer.getSize(new three.Vector2());
    const left = Math.round(this.split.at * width);
    this.renderer.setScissorTest(true);
    this.split.show("left");
    this.renderer.setScissor(0, 0, left, height);
    this.renderAll();
    this.split.show("right");
    this.renderer.setScissor(left, 0, width - left, height);
    this.renderAll();
    this.renderer.setScissorTest(false);
  }

  private renderAll(): void {
    this.renderer.render(this.scene, this.camera);
    this.renderOver(true);
  }

  private renderOver(all: boolean): void {
    this.onOver(all);
    this.renderer.autoClear = false;
    this.renderer.render(this.over, this.camera);
    this.renderer.autoClear = true;
  }

  /** Which axis points up. */
  setUp(axis: "y" | "z"): void {
    this.camera.up.set(0, axis === "y" ? 1 : 0, axis === "z" ? 1 : 0);
    this.controls.dispose();
    Object.assign(this, { controls: new OrbitControls(this.camera, this.canvas) });
    this.controls.addEventListener("change", () => this.draw());
  }

  /** Looks at all of a box. */
  frame(low: readonly number[], size: readonly number[]): void {
    this.middle.set(low[0]! + size[0]! / 2, low[1]! + size[1]! / 2, low[2]! + size[2]! / 2);
    this.radius = Math.hypot(...size) / 2 || 1;
    this.reframe();
  }

  private reframe(): void {
    const across = Math.min(this.camera.aspect, 1);
    const distance = this.radius / Math.sin((this.camera.fov * Math.PI) / 360) / across;
    const z = this.camera.up.z === 1;
    const direction = z ? new three.Vector3(0.45, -1, 0.62) : new three.Vector3(0.45, 0.62, 1);
    this.camera.position.copy(this.middle).addScaledVector(direction.normalize(), distance);
    this.camera.near = distance / 100;
    this.camera.far = distance * 10;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(this.middle);
    this.controls.update();
    this.draw();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    this.renderer.setPixelRatio(this.pixelRatio());
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Pixels of the page that a unit of length has at a place. */
  pixelsPerLength(place: three.Vector3): number {
    const depth = -place.clone().applyMatrix4(this.camera.matrixWorldInverse).z;
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * Math.max(depth, this.camera.near);
    return this.canvas.clientHeight / (2 * half);
  }

  private key(event: KeyboardEvent): void {
    if (event.altKey) return;
    if ((event.ctrlKey || event.metaKey) && !event.key.startsWith("Arrow")) return;
    const around = new three.Spherical();
    const turned = new three.Quaternion().setFromUnitVectors(
      this.camera.up,
      new three.Vector3(0, 1, 0),
    );
    const offset = this.camera.position.clone().sub(this.controls.target).applyQuaternion(turned);
    around.setFromVector3(offset);
    if (event.key === "ArrowLeft") around.theta -= turn;
    else if (event.key === "ArrowRight") around.theta += turn;
    else if (event.key === "ArrowUp") around.phi -= turn;
    else if (event.key === "ArrowDown") around.phi += turn;
    else if (event.key === "+") around.radius /= 1.15;
    else if (event.key === "-") around.radius *= 1.15;
    else if (event.key === "f") return this.reframe();
    else return;
    event.preventDefault();
    around.makeSafe();
    offset.setFromSpherical(around).applyQuaternion(turned.invert());
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }
}
