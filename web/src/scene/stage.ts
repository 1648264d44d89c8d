// What is seen: the input until there are cracks and while it is painted, cracks as they are
// computed, else the cracked surface, or its state, or another result beside it.
import type { Fields, InputMesh, Moment, OpenedPieces, Picture } from "../engine/messages";
import { CrackedPicture } from "./cracked_picture";
import { HeatMap, type HeatName } from "./heat_map";
import { LiveCracks } from "./live_cracks";
import { Surface } from "./surface";
import { Viewer } from "./viewer";

export class Stage {
  readonly viewer: Viewer;
  private readonly input = new Surface();
  private readonly cracked = new CrackedPicture();
  private readonly kept = new CrackedPicture();
  private readonly live = new LiveCracks();
  private readonly heat = new HeatMap();
  private mesh: InputMesh | null = null;
  private painting = false;
  private hot = false;

  constructor(canvas: HTMLCanvasElement) {
    this.viewer = new Viewer(canvas);
    const { input, cracked, kept, live, heat } = this;
    for (const { object } of [input, cracked, kept, heat]) this.viewer.scene.add(object);
    this.viewer.over.add(live.object);
    this.viewer.onOver = (all) => live.draw(all);
    this.update();
  }

  setInput(mesh: InputMesh, low: readonly number[], size: readonly number[]): void {
    this.mesh = mesh;
    this.cracked.clear();
    this.endLive();
    this.keep(null);
    this.hot = false;
    const positions = new Float32Array(3 * mesh.triangles.length);
    for (let i = 0; i < positions.length; ++i) {
      positions[i] = mesh.positions[3 * mesh.triangles[Math.floor(i / 3)]! + (i % 3)]!;
    }
    this.input.set(positions, mesh.normals, null, null);
    this.viewer.frame(low, size);
    this.update();
  }

  setPicture(picture: Picture): void {
    this.cracked.set(picture);
    this.endLive();
  }

  /** Pieces of crack of a run that is under way. */
  addLive(pieces: OpenedPieces): void {
    if (this.live.add(pieces)) return this.viewer.drawOver();
    this.input.showPlain(this.viewer.hurry(true));
    this.update();
  }

  get isLive(): boolean {
    return !this.live.empty;
  }

  /** No run is under way: the last picture is seen again. */
  endLive(): void {
    this.live.clear();
    this.input.showPlain(this.viewer.hurry(false));
    this.update();
  }

  /** The state of the result in the place of its surface; returns what the scale ends at. */
  showHeat(fields: Fields, name: HeatName): number {
    const end = this.heat.set(fields, name);
    this.hot = true;
    this.update();
    return end;
  }

  hideHeat(): void {
    this.hot = false;
    this.update();
  }

  showMarks(shown: boolean): void {
    this.heat.showMarks(shown);
    this.viewer.draw();
  }

  setMoment(moment: Moment): void {
    this.cracked.move(moment);
    this.viewer.draw();
  }

  showUntil(time: number): void {
    this.cracked.lines.showUntil(time);
    this.viewer.draw();
  }

  setLook(material: string): void {
    const surfaces = [this.input, this.cracked.surface];
    if (surfaces.filter((surface) => surface.setLook(material)).length > 0) this.viewer.draw();
  }

  showFragments(colored: boolean): void {
    this.cracked.surface.showFragments(colored);
    this.viewer.draw();
  }

  showAge(shown: boolean): void {
    this.cracked.lines.showAge(shown);
    this.viewer.draw();
  }

  setLineColor(color: number): void {
    const all = [this.cracked.lines, this.kept.lines, this.live];
    if (all.filter((lines) => lines.setColor(color)).length > 0) this.viewer.draw();
  }

  showWireframe(shown: boolean): void {
    this.input.showWireframe(shown);
    this.cracked.surface.showWireframe(shown);
    this.viewer.draw();
  }

  /** Keeps a picture to see beside those to come, with its look; null: none any more. */
  keep(picture: { picture: Picture; material: string } | null): void {
    if (picture) {
      this.kept.surface.setLook(picture.material);
      this.kept.set(picture.picture);
    } else {
      this.kept.clear();
    }
    this.viewer.split = picture ? { at: 0.5, show: (side) => this.showSide(side) } : null;
    this.update();
  }

  /** Where the two pictures meet, 0 … 1 of the width. */
  splitAt(at: number): void {
    if (this.viewer.split) this.viewer.split.at = at;
    this.viewer.draw();
  }

  /** Shows the input with this paint on it, one value per vertex; null: no longer. */
  showPaint(paint: Float32Array | null, color: number): void {
    if (!paint && !this.painting) return;
    this.painting = paint !== null;
    if (this.mesh) this.input.overlay(paint, this.mesh.triangles, color);
    this.update();
  }

  private showSide(side: "left" | "right"): void {
    this.arrange();
    if (side === "right") return;
    for (const { object } of [this.input, this.cracked, this.live, this.heat]) object.visible = false;
    this.kept.show(true, true);
  }

  private update(): void {
    this.arrange();
    this.viewer.draw();
  }

  private arrange(): void {
    const running = !this.live.empty;
    const hot = this.hot && !running && !this.painting;
    const cracks = this.cracked.there && !this.painting && !running && !hot;
    this.input.object.visible = !cracks && !hot;
    this.cracked.show(cracks, this.cracked.there && !running);
    this.live.object.visible = running;
    this.heat.object.visible = hot;
    this.kept.show(false, false);
  }
}
