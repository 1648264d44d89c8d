// One run of the engine in one instance: an input, its cracks, and what is made of them. The
// instance is thrown away with the worker that holds it, so nothing is freed that lives as long.
import { crackEdges } from "./crack_edges";
import type { CrazeModule } from "./craze_module";
import { fieldsOf } from "./fields";
import { mapFiles } from "./map_files";
import { maskNames, maskValues } from "./masks";
import { Memory } from "./memory";
import type * as m from "./messages";
import { loopState } from "./paper_loop";
import { setRecipe } from "./set_recipe";
import { shading } from "./shading";

const folder = "/studio";

/** Who is told while the engine is at work. */
export interface Listener {
  progress(progress: m.Progress): void;
  opened(pieces: m.OpenedPieces): void;
}

export class Session {
  private readonly memory: Memory;
  private readonly callback: number;
  private readonly openedCallback: number;
  private mesh = 0;
  private job = 0;
  private opening = 0;
  private opened: { triangles: Int32Array; edges: Uint32Array } | null = null;

  constructor(
    private readonly craze: CrazeModule,
    listener: Listener,
  ) {
    this.memory = new Memory(craze);
    craze.FS.mkdir(folder);
    const tell = (_: number, phase: number, fraction: number, cracks: bigint, load: number) => {
      listener.progress({
        phase: this.memory.text(phase),
        fraction: fraction < 0 ? null : fraction,
        cracks: Number(cracks),
        load,
      });
      return 0;
    };
    this.callback = craze.addFunction(tell, "iiidjd");
    const show = (_: number, first: bigint, pieces: number, count: bigint) =>
      listener.opened({
        first: Number(first),
        pieces: Float32Array.from(this.memory.numbers(pieces, 6 * Number(count))),
      });
    this.openedCallback = craze.addFunction(show, "vijij");
  }

  look(input: m.Input): m.InputMesh {
    this.read(input);
    const positions = this.memory.meshArray(this.mesh, "vertices").values;
    const triangles = this.triangles(this.mesh);
    return {
      positions: Float32Array.from(positions),
      triangles: Uint32Array.from(triangles),
      normals: shading(this.craze, this.memory, this.mesh, triangles.length),
      masks: maskNames(this.craze, this.memory, this.mesh),
      warnings: this.memory.list((i) => this.craze._craze_mesh_warning(this.mesh, i)),
    };
  }

  async mask(input: m.Input, name: string): Promise<{ values: Float32Array }> {
    this.read(input);
    return { values: await maskValues(this.craze, this.memory, this.mesh, name) };
  }

  crack(request: m.CrackRequest): m.Summary {
    const { craze, memory } = this;
    this.read(request.input);
    this.paint(request.painted);
    this.job = craze._craze_job_new();
    memory.check((e) => craze._craze_job_set_threads(this.job, 1, e));
    memory.check((e) => craze._craze_job_set_mesh(this.job, this.mesh, e));
    setRecipe(craze, memory, this.job, request.recipe);
    craze._craze_job_set_progress(this.job, this.callback, 0);
    craze._craze_job_set_opened(this.job, this.openedCallback, 0);
    memory.check((e) => craze._craze_job_run(this.job, e));
    return this.summary();
  }

  open(post: m.Post): m.Picture {
    const { memory } = this;
    const opening = this.makeOpening(post);
    const mesh = memory.made((e) => this.craze._craze_opening_mesh(opening, e));
    try {
      const triangles = this.triangles(mesh);
      const positions = memory.meshArray(mesh, "vertices").values;
      const source = memory.meshArray(mesh, "face:source_face").values;
      const walls = Uint8Array.from(source, (face) => (face < 0 ? 1 : 0));
      const growth = memory.meshArray(mesh, "vertex:crack_growth").values;
      const distance = memory.meshArray(mesh, "vertex:crack_distance").values;
      const edges = crackEdges(triangles, distance, walls);
      this.opened = { triangles, edges };
      return {
        ...this.places(positions),
        normals: shading(this.craze, memory, mesh, triangles.length),
        fragments: Int32Array.from(memory.meshArray(mesh, "face:fragment").values),
        walls,
        lineGrowth: Float32Array.from(edges, (vertex) => growth[vertex]!),
        warnings: memory.list((i) => this.craze._craze_opening_warning(opening, i)),
      };
    } finally {
      this.craze._craze_mesh_free(mesh);
    }
  }

  moment(time: number): m.Moment {
    const count = 3 * Number(this.craze._craze_opening_vertex_count(this.opening));
    return this.memory.withNumbers(count, null, (at) => {
      this.memory.check((e) =>
        this.craze._craze_opening_positions_at(this.opening, time, at, e),
      );
      return this.places(this.memory.numbers(at, count));
    });
  }

  /** The opened mesh in the format of the name's extension, and what is written beside it. */
  write(name: string, post: m.Post): m.OutputFile[] {
    const { craze, memory } = this;
    const opening = this.newOpening(post);
    try {
      const mesh = memory.made((e) => craze._craze_opening_mesh(opening, e));
      try {
        return this.writeMesh(mesh, name);
      } finally {
        craze._craze_mesh_free(mesh);
      }
    } finally {
      craze._craze_opening_free(opening);
    }
  }

  fields(): m.Fields {
    return fieldsOf(this.craze, this.memory, this.job);
  }

  statistics(post: m.Post): Promise<m.Statistics> {
    return this.withPost(post, (job) =>
      JSON.parse(this.memory.taken((e) => this.craze._craze_job_statistics(job, e))),
    );
  }

  maps(size: number, post: m.Post): Promise<m.OutputFile[]> {
    return this.withPost(post, (job) => mapFiles(this.craze, this.memory, job, size));
  }

  recipe(request: m.RecipeRequest): m.RecipeTexts {
    const { craze, memory } = this;
    const job = craze._craze_job_new();
    try {
      setRecipe(craze, memory, job, request);
      return {
        toml: memory.taken((e) => craze._craze_job_recipe_toml(job, e)),
        json: memory.taken((e) => craze._craze_job_recipe(job, e)),
      };
    } finally {
      craze._craze_job_free(job);
    }
  }

  loop(cracks: number, seed: number): m.LoopState {
    return loopState(this.craze, this.memory, cracks, seed);
  }

  /** The cracks as lines in the format of the name's extension. */
  async writeLines(name: string, post: m.Post): Promise<m.OutputFile[]> {
    const { craze, memory } = this;
    const lines = await this.withPost(post, (job) =>
      memory.made((e) => craze._craze_job_lines(job, e)),
    );
    try {
      memory.withText(`${folder}/${name}`, (path) =>
        memory.check((e) => craze._craze_lines_write(lines, path, e)),
      );
      return this.takeFiles();
    } finally {
      craze._craze_lines_free(lines);
    }
  }

  /** The input with what was painted on it, for the command. */
  paintedInput(request: m.CrackRequest, name: string): m.OutputFile[] {
    this.read(request.input);
    this.paint(request.painted);
    return this.writeMesh(this.mesh, name);
  }

  private read(input: m.Input): void {
    const { craze, memory } = this;
    craze._craze_mesh_free(this.mesh);
    this.mesh = 0;
    if (input.kind === "shape") {
      this.mesh = memory.withText(input.specification, (text) =>
        memory.made((e) => craze._craze_mesh_shape(text, e)),
      );
      return;
    }
    const path = `${folder}/${input.name}`;
    craze.FS.writeFile(path, input.bytes);
    try {
      this.mesh = memory.withText(path, (text) =>
        memory.made((e) => craze._craze_mesh_read(text, this.callback, 0, e)),
      );
    } finally {
      craze.FS.unlink(path);
    }
  }

  private paint(painted: m.PaintedAttribute[]): void {
    for (const { name, values, columns } of painted) {
      const rows = BigInt(values.length / columns);
      this.memory.withText(`vertex:${name}`, (text) =>
        this.memory.withNumbers(values.length, values, (at) =>
          this.memory.check((e) =>
            this.craze._craze_mesh_set(this.mesh, text, at, rows, columns, e),
          ),
        ),
      );
    }
  }

  private makeOpening(post: m.Post): number {
    this.craze._craze_opening_free(this.opening);
    this.opening = 0;
    this.opening = this.newOpening(post);
    return this.opening;
  }

  private newOpening(post: m.Post): number {
    return this.memory.withText(post, (text) =>
      this.memory.made((e) => this.craze._craze_job_open_post(this.job, text, e)),
    );
  }

  /** Runs body with the job as it would be with this [post]; it is freed when body has ended. */
  private async withPost<T>(post: m.Post, body: (job: number) => T): Promise<Awaited<T>> {
    const job = this.memory.withText(post, (text) =>
      this.memory.made((e) => this.craze._craze_job_with_post(this.job, text, e)),
    );
    try {
      return await body(job);
    } finally {
      this.craze._craze_job_free(job);
    }
  }

  private triangles(mesh: number): Int32Array {
    return this.memory.meshArray(mesh, "faces").values as Int32Array;
  }

  private places(positions: ArrayLike<number>): m.Moment {
    const { triangles, edges } = this.opened!;
    return { positions: placesOf(positions, triangles), lines: placesOf(positions, edges) };
  }

  private summary(): m.Summary {
    const report = JSON.parse(this.memory.taken((e) => this.craze._craze_job_summary(this.job, e)));
    return {
      cracks: report.cracks.events,
      fragments: report.cracks.fragments,
      length: report.cracks.length,
      triangles: report.input.triangles,
      seconds: report.time.total,
      warnings: report.warnings,
    };
  }

  private writeMesh(mesh: number, name: string): m.OutputFile[] {
    const { craze, memory } = this;
    memory.withText(`${folder}/${name}`, (path) =>
      memory.check((e) => craze._craze_mesh_write(mesh, path, this.callback, 0, e)),
    );
    return this.takeFiles();
  }

  private takeFiles(): m.OutputFile[] {
    const { craze } = this;
    const names = craze.FS.readdir(folder).filter((found) => found !== "." && found !== "..");
    return names.map((found) => {
      const bytes = craze.FS.readFile(`${folder}/${found}`);
      craze.FS.unlink(`${folder}/${found}`);
      return { name: found, bytes };
    });
  }
}

/** The three coordinates of each vertex in the list, one after the other. */
function placesOf(positions: ArrayLike<number>, vertices: ArrayLike<number>): Float32Array {
  const places = new Float32Array(3 * vertices.length);
  for (let i = 0; i < vertices.length; ++i) {
    for (let k = 0; k < 3; ++k) places[3 * i + k] = positions[3 * vertices[i]! + k]!;
  }
  return places;
}
