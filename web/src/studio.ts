// The page at work: a change of the project becomes a run, an opening or nothing of the kind.
import { Engine } from "./engine/engine";
import { CrazeError } from "./engine/memory";
import type { CrackRequest, Input, Post, Summary } from "./engine/messages";
import { Cancelled } from "./engine/worker_client";
import { Exporting } from "./exporting";
import { Brushing } from "./brushing";
import { canvasOf, type Canvas } from "./paint/canvas";
import { paintedAttributes } from "./paint/layers";
import { Painting } from "./paint/painting";
import { saveFile, saveProject } from "./project/autosave";
import { ownRecipeOf, projectOf, toHash } from "./project/link";
import { isOpened, postText } from "./project/openings";
import { cracksOtherwise, opensOtherwise, type LayerName, type Project } from "./project/project";
import type { Stroke } from "./project/project";
import {
  commandLine,
  ofOwnRecipe,
  recipeRequest,
  wholeRecipe,
} from "./project/recipe";
import { Store } from "./project/store";
import { Growth } from "./scene/growth";
import { Stage } from "./scene/stage";
import { Seeing } from "./seeing";
import { acceptDrops, chooseFile, download } from "./ui/hand_over";
import { KeysDialog } from "./ui/keys_dialog";
import { Panel, type Actions, type Paint } from "./ui/panel";

const accepted = ".obj,.ply,.stl,.off,.glb,.craze,.toml";
const paintColors: Record<LayerName, number> = {
  stress: 0xd0342c,
  strength: 0x2c6fd0,
  spacing: 0x2ca05a,
  mask: 0x8a4fd0,
};

interface OpenFile {
  name: string;
  bytes: Uint8Array;
}

export class Studio {
  private readonly engine = new Engine();
  private readonly store: Store;
  private readonly stage: Stage;
  private readonly panel: Panel;
  private readonly growth: Growth;
  private readonly brushing: Brushing;
  private readonly keys = new KeysDialog();
  private readonly seeing: Seeing;
  private readonly exporting: Exporting;
  private surface: { canvas: Canvas; triangles: Uint32Array; painting: Painting } | null = null;
  private layer: LayerName | null = null;
  private cracked = false; // whether there is a result to open

  constructor(
    view: HTMLElement,
    project: Project,
    private file: OpenFile | null,
  ) {
    this.store = new Store(project);
    this.stage = new Stage(view.querySelector("canvas")!);
    this.growth = new Growth(this.engine, this.stage, (time) => this.panel.growth.show(time));
    this.exporting = new Exporting(this.engine, this.stage, this.growth, {
      request: () => this.request(),
      post: () => this.post(),
      recipe: () => wholeRecipe(this.store.project),
    });
    this.seeing = new Seeing(this.engine, this.stage, this.store, (body) => this.attempt(body));
    const actions: Actions = {
      open: () => chooseFile(accepted, (file) => void this.take(file)),
      crack: () => void this.crack(),
      cancel: () => this.engine.cancel(),
      undo: () => this.store.undo(),
      redo: () => this.store.redo(),
      exportFile: (format) => void this.attempt(() => this.exportFile(format)),
      copyCommand: () => void this.copy(this.command("cracked.ply"), "The command is copied."),
      copyLink: () => void this.attempt(() => this.copyLink()),
      newSeed: () => this.store.change({ seed: this.store.project.seed + 1 }),
      saveProject: () => this.saveProjectFile(),
      play: () => void this.growth.play(),
      change: (change) => this.store.change(change),
      growth: (time) => void this.growth.show(time),
      paint: (paint) => this.choosePaint(paint),
      fill: () => this.paintAll("fill"),
      invert: () => this.paintAll("invert"),
      takeMask: (name) => void this.attempt(() => this.takeMask(name)),
      keys: () => this.keys.open(),
    };
    const { panel, statistics } = this.seeing;
    this.panel = new Panel(actions, { see: panel.root, statistics: statistics.root });
    view.after(this.panel.root);
    view.after(this.keys.root);
    this.brushing = new Brushing(view, this.stage.viewer, this.panel.brushSize, {
      settings: () => ({
        size: this.panel.brushSize.value,
        strength: this.panel.brushStrength.value,
        along: this.panel.along.input.checked,
        erase: this.panel.erase.input.checked,
        mirror: this.panel.mirror.input.checked,
      }),
      preview: (stroke) => this.previewStroke(stroke),
      finish: (stroke) => this.store.change({ strokes: [...this.store.project.strokes, stroke] }),
      drop: () => this.refresh(),
      impact: (point) =>
        this.store.change({ impacts: [...this.store.project.impacts, point] }),
    });
    acceptDrops(document.body, (file) => void this.take(file));
    document.addEventListener("keydown", (event) => this.key(event));
    this.engine.onProgress = ({ phase, fraction, cracks }) =>
      this.panel.tell(cracks > 0 ? `${phase}: ${cracks} cracks` : phase, fraction);
    this.engine.onOpened = (pieces) => this.stage.addLive(pieces);
    this.store.onChange((now, before) => void this.follow(now, before));
  }

  /** `problem`: a sentence about what could not be taken up, or "". */
  async start(problem: string): Promise<void> {
    await this.showInput();
    await this.crack();
    if (problem) this.panel.complain(problem);
  }

  private async follow(now: Project, before: Project): Promise<void> {
    this.save();
    if (now.source !== before.source) await this.showInput();
    this.refresh();
    if (cracksOtherwise(now, before)) await this.crack();
    else if (opensOtherwise(now, before)) await this.attempt(() => this.open(1, false));
  }

  private refresh(): void {
    const { project, canUndo, canRedo } = this.store;
    this.panel.show(project, this.surface?.canvas.diagonal ?? 1, canUndo, canRedo);
    this.seeing.showLook();
    this.surface?.painting.follow(project.strokes);
    this.showPaint();
  }

  private async showInput(): Promise<void> {
    await this.attempt(async () => {
      this.panel.tell("load", null);
      const mesh = await this.engine.look(this.input());
      const canvas = canvasOf(mesh.positions, mesh.triangles);
      const { triangles } = mesh;
      this.surface = { canvas, triangles, painting: new Painting(canvas) };
      this.stage.viewer.setUp(
        this.store.project.source.kind === "shape" || canvas.size[2] === 0 ? "z" : "y",
      );
      this.stage.setInput(mesh, canvas.low, canvas.size);
      this.brushing.setSurface(canvas, triangles);
      this.panel.masks.set(mesh.masks);
      this.cracked = false;
      this.seeing.clear();
      for (const name of this.surface.painting.missing(this.store.project.strokes)) {
        await this.provide(name);
      }
      this.refresh();
      this.panel.tell(mesh.warnings.join(" "));
    });
  }

  private async crack(): Promise<void> {
    await this.attempt(async () => {
      const began = performance.now();
      this.panel.tell("start", null);
      const summary = await this.run();
      this.cracked = true;
      const seconds = ((performance.now() - began) / 1000).toFixed(2);
      const live = this.stage.isLive; // they were seen growing already
      await this.open(live ? 1 : 0, true);
      const warnings = summary.warnings.length > 0 ? ` ${summary.warnings.join(" ")}` : "";
      this.panel.tell(
        `${summary.cracks} cracks, ${summary.fragments} fragments in ${seconds} s.${warnings}`,
      );
      if (!live) void this.growth.play();
    });
  }

  private async run(): Promise<Summary> {
    try {
      return await this.engine.crack(this.request());
    } catch (error) {
      if (!this.engine.isRunning) this.stage.endLive();
      throw error;
    }
  }

  /** Opens the last result and shows it at a time of its growth; `anew`: for the first time. */
  private async open(time: number, anew: boolean): Promise<void> {
    if (!this.cracked) return;
    const picture = await this.engine.open(this.post());
    this.stage.setPicture(picture);
    if (picture.warnings.length > 0) this.panel.tell(picture.warnings.join(" "));
    this.growth.setOpened(isOpened(this.store.project));
    await this.growth.show(time);
    await this.seeing.show(picture, anew);
  }

  private input(): Input {
    const { source } = this.store.project;
    if (source.kind === "shape") return source;
    if (this.file?.name !== source.name) throw new Error(`Open ${source.name} again to go on.`);
    return { kind: "file", ...this.file };
  }

  private request(): CrackRequest {
    const { project } = this.store;
    const painting = this.surface?.painting;
    const missing = painting?.missing(project.strokes) ?? [];
    if (missing.length > 0) throw new Error(`The file has no ${missing[0]} to be a mask.`);
    painting?.follow(project.strokes);
    const painted = painting ? paintedAttributes(project, painting) : [];
    return { input: this.input(), painted, recipe: recipeRequest(project) };
  }

  private post(): Post {
    return postText(this.store.project);
  }

  private choosePaint(paint: Paint): void {
    this.layer = paint === "None" || paint === "Impact" ? null : (paint.toLowerCase() as LayerName);
    this.brushing.hold(paint === "Impact" ? "impact" : this.layer);
    this.showPaint();
  }

  /** The whole surface at once; what the brush is set to holds for it. */
  private paintAll(kind: "fill" | "invert"): void {
    const { panel, layer, store } = this;
    if (!layer) return;
    const strength = Math.round(100 * panel.brushStrength.value);
    const erase = panel.erase.input.checked;
    const whole = { kind, layer, strength, erase, along: false, mirror: false };
    const stroke: Stroke = { ...whole, radius: 0, dabs: [] };
    store.change({ strokes: [...store.project.strokes, stroke] });
  }

  /** A mask of the file becomes the paint. */
  private async takeMask(from: string): Promise<void> {
    const { layer, store, surface } = this;
    if (!layer || !surface) return;
    if (surface.painting.missing([fileStroke(layer, from)]).length > 0) await this.provide(from);
    store.change({ strokes: [...store.project.strokes, fileStroke(layer, from)] });
  }

  private async provide(name: string): Promise<void> {
    const { surface } = this;
    surface?.painting.provide(name, await this.engine.mask(this.input(), name));
  }

  private showPaint(): void {
    const values = this.layer ? (this.surface?.painting.seen(this.layer) ?? null) : null;
    this.stage.showPaint(values, this.layer ? paintColors[this.layer] : 0);
  }

  private previewStroke(stroke: Stroke): void {
    this.surface?.painting.follow([...this.store.project.strokes, stroke]);
    this.showPaint();
  }

  private async take(file: File): Promise<void> {
    await this.attempt(async () => {
      const bytes = new Uint8Array(await file.arrayBuffer());
      if (file.name.endsWith(".craze")) return this.takeProject(new TextDecoder().decode(bytes));
      if (file.name.endsWith(".toml")) return this.takeRecipe(file.name, new TextDecoder().decode(bytes));
      await this.engine.look({ kind: "file", name: file.name, bytes }); // or what is wrong with it
      this.file = { name: file.name, bytes };
      await saveFile(bytes);
      this.store.change({
        source: { kind: "file", name: file.name },
        spacing: null,
        strokes: [],
        impacts: [],
      });
    });
  }

  private async takeRecipe(name: string, text: string): Promise<void> {
    const { json } = await this.engine.recipe({ base: { text, name }, set: [] });
    this.store.change(ofOwnRecipe(ownRecipeOf(JSON.parse(json))!));
  }

  private takeProject(text: string): void {
    const { file, ...rest } = JSON.parse(text);
    const project = projectOf(rest);
    if (project.source.kind === "file" && typeof file === "string") {
      const bytes = Uint8Array.from(atob(file), (letter) => letter.charCodeAt(0));
      this.file = { name: project.source.name, bytes };
      void saveFile(bytes);
    }
    this.store.change(project);
  }

  private saveProjectFile(): void {
    let file: string | undefined;
    if (this.store.project.source.kind === "file" && this.file) {
      file = "";
      for (const byte of this.file.bytes) file += String.fromCharCode(byte);
      file = btoa(file);
    }
    download("project.craze", JSON.stringify({ ...this.store.project, file }));
  }

  private async exportFile(format: string): Promise<void> {
    this.panel.tell("write", null);
    const files = await this.exporting.files(format);
    for (const { name, bytes } of files) download(name, bytes);
    this.panel.tell(`${files.map(({ name }) => name).join(", ")} written.`);
  }

  private command(output: string): string {
    return commandLine(this.store.project, output);
  }

  private async copyLink(): Promise<void> {
    if (this.store.project.source.kind === "file") {
      throw new Error("A link holds built-in shapes alone; save the project instead.");
    }
    const address = new URL(location.href);
    address.hash = await toHash(this.store.project);
    history.replaceState(null, "", address);
    await this.copy(address.href, "The link is copied.");
  }

  private async copy(text: string, done: string): Promise<void> {
    await this.attempt(async () => {
      await navigator.clipboard.writeText(text);
      this.panel.tell(done);
    });
  }

  private save(): void {
    saveProject(this.store.project).catch(() =>
      this.panel.complain("This browser keeps nothing: save the project to a file."),
    );
  }

  private key(event: KeyboardEvent): void {
    if (event.key === "?") return this.keys.open();
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    event.preventDefault();
    if (event.shiftKey) this.store.redo();
    else this.store.undo();
  }

  /** Runs it; what goes wrong becomes one sentence. */
  private async attempt(body: () => Promise<void>): Promise<void> {
    try {
      this.panel.complain("");
      await body();
    } catch (error) {
      if (error instanceof Cancelled) return this.panel.tell("Cancelled.");
      this.panel.tell("");
      const message = error instanceof Error ? error.message : String(error);
      this.panel.complain(error instanceof CrazeError ? message.replace("/studio/", "") : message);
    }
  }
}

function fileStroke(layer: LayerName, from: string): Stroke {
  const plain = { strength: 100, erase: false, along: false, mirror: false, radius: 0, dabs: [] };
  return { kind: "file", layer, from, ...plain };
}
