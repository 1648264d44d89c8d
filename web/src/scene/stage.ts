// What is seen: the input until there are cracks and while it is painted, else the cracked surface.
import type { InputMesh, Moment, Picture } from "../engine/messages";
import { CrackLines } from "./crack_lines";
import { Surface } from "./surface";
import { Viewer } from "./viewer";

export class Stage {
  readonly viewer: Viewer;
  private readonly input = new Surface();
  private readonly cracked = new Surface();
  private readonly lines = new CrackLines();
  private mesh: InputMesh | null = null;
  private hasPicture = false;
  private painting = false;

  constructor(canvas: HTMLCanvasElement) {
    this.viewer = new Viewer(canvas);
    this.viewer.scene.add(this.input.object, this.cracked.object, this.lines.object);
    this.update();
  }

  setInput(mesh: InputMesh, low: readonly number[], size: readonly number[]): void {
    this.mesh = mesh;
    this.hasPicture = false;
    const positions = new Float32Array(3 * mesh.triangles.length);
    mesh.triangles.forEach((vertex, corner) =>
      positions.set(mesh.positions.subarray(3 * vertex, 3 * vertex + 3), 3 * corner),
    );
    this.input.set(positions, mesh.normals, null, null);
    this.viewer.frame(low, size);
    this.update();
  }

  setPicture(picture: Picture): void {
    this.cracked.set(picture.positions, picture.normals, picture.fragments, picture.walls);
    this.lines.set(picture.lines, picture.lineGrowth);
    this.hasPicture = true;
    this.update();
  }

  setMoment(moment: Moment): void {
    this.cracked.move(moment.positions);
    this.lines.move(moment.lines);
    this.viewer.draw();
  }

  showUntil(time: number): void {
    this.lines.showUntil(time);
    this.viewer.draw();
  }

  setLook(material: string): void {
    this.input.setLook(material);
    this.cracked.setLook(material);
    this.viewer.draw();
  }

  showFragments(colored: boolean): void {
    this.cracked.showFragments(colored);
    this.viewer.draw();
  }

  /** Shows the input with this paint on it, one value per vertex; null: no longer. */
  showPaint(paint: Float32Array | null, color: number): void {
    this.painting = paint !== null;
    if (this.mesh) this.input.overlay(paint, this.mesh.triangles, color);
    this.update();
  }

  private update(): void {
    const cracks = this.hasPicture && !this.painting;
    this.input.object.visible = !cracks;
    this.cracked.object.visible = cracks;
    this.lines.object.visible = this.hasPicture;
    this.viewer.draw();
  }
}
