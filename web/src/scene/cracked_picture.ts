// A cracked surface and its crack lines.
import * as three from "three";
import type { Moment, Picture } from "../engine/messages";
import { CrackLines } from "./crack_lines";
import { Surface } from "./surface";

export class CrackedPicture {
  readonly object = new three.Group();
  readonly surface = new Surface();
  readonly lines = new CrackLines();
  there = false; // whether there is one

  constructor() {
    this.object.add(this.surface.object, this.lines.object);
  }

  set(picture: Picture): void {
    this.surface.set(picture.positions, picture.normals, picture.fragments, picture.walls);
    this.lines.set(picture.lines, picture.lineGrowth);
    this.there = true;
  }

  move(moment: Moment): void {
    this.surface.move(moment.positions);
    this.lines.move(moment.lines);
  }

  clear(): void {
    this.there = false;
  }

  show(surface: boolean, lines: boolean): void {
    this.object.visible = surface || lines;
    this.surface.object.visible = surface;
    this.lines.object.visible = lines;
  }
}
