// The engine as the page uses it. Each run has a worker of its own: one that is cancelled is ended,
// and the last result stays in the worker that made it until the next one is there.
import wasmUrl from "./generated/craze.wasm?url";
import type * as m from "./messages";
import { Cancelled, WorkerClient } from "./worker_client";

const later = 400; // ms: another worker starts once the present one has begun

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(wasmUrl);
  if (!response.ok) throw new Error(`cannot load the engine (${response.status})`);
  // Not compileStreaming(): a plain file server may not know the type of .wasm.
  return WebAssembly.compile(await response.arrayBuffer());
}

export class Engine {
  onProgress: (progress: m.Progress) => void = () => {};
  onOpened: (pieces: m.OpenedPieces) => void = () => {};
  private readonly code = compile();
  private spare: WorkerClient | null = new WorkerClient(this.code); // for what comes next
  private running: WorkerClient | null = null;
  private result: WorkerClient | null = null;

  /** The surface of an input. Throws CrazeError. */
  look(input: m.Input): Promise<m.InputMesh> {
    return this.alone((worker) => worker.ask("look", { input }));
  }

  /** One of the masks of an input, one number per vertex. Throws CrazeError, and Error. */
  async mask(input: m.Input, name: string): Promise<Float32Array> {
    return (await this.alone((worker) => worker.ask("mask", { input, name }))).values;
  }

  /** Cracks it, ending a run that is under way. Throws CrazeError, and Cancelled. */
  async crack(request: m.CrackRequest): Promise<m.Summary> {
    this.cancel();
    const worker = this.take();
    this.running = worker;
    try {
      const summary = await worker.ask("crack", request);
      if (this.running !== worker) throw new Cancelled();
      this.result?.end();
      this.result = worker;
      worker.onProgress = () => {}; // what is made of a result is quick
      worker.onOpened = () => {};
      return summary;
    } catch (error) {
      worker.end();
      throw error;
    } finally {
      if (this.running === worker) this.running = null;
    }
  }

  get isRunning(): boolean {
    return this.running !== null;
  }

  cancel(): void {
    this.running?.end();
    this.running = null;
  }

  /** What comes of the last run. Nothing is cracked again. */
  open(post: m.Post): Promise<m.Picture> {
    return this.last().ask("open", post);
  }

  /** At a time of the growth, 0 … 1, of what was opened last. */
  moment(time: number): Promise<m.Moment> {
    return this.last().ask("moment", { time });
  }

  write(name: string, post: m.Post): Promise<m.OutputFile[]> {
    return this.last().ask("write", { name, post });
  }

  fields(): Promise<m.Fields> {
    return this.last().ask("fields", null);
  }

  statistics(post: m.Post): Promise<m.Statistics> {
    return this.last().ask("statistics", post);
  }

  writeLines(name: string, post: m.Post): Promise<m.OutputFile[]> {
    return this.last().ask("writeLines", { name, post });
  }

  /** Maps of the last run and what they stand for, `size` texels a side. Throws CrazeError. */
  maps(size: number, post: m.Post): Promise<m.OutputFile[]> {
    return this.last().ask("maps", { size, post });
  }

  /** All keys of a recipe. Throws CrazeError where it is none. */
  recipe(request: m.RecipeRequest): Promise<m.RecipeTexts> {
    return this.alone((worker) => worker.ask("recipe", request));
  }

  /** The paper's loop after so many cracks. */
  loop(cracks: number, seed: number): Promise<m.LoopState> {
    return this.next().ask("loop", { cracks, seed });
  }

  paintedInput(request: m.CrackRequest, name: string): Promise<m.OutputFile[]> {
    return this.alone((worker) => worker.ask("paintedInput", { ...request, name }));
  }

  private last(): WorkerClient {
    if (!this.result) throw new Error("nothing is cracked yet");
    return this.result;
  }

  private take(): WorkerClient {
    const worker = this.next();
    worker.onProgress = (progress) => this.onProgress(progress);
    worker.onOpened = (pieces) => this.onOpened(pieces);
    this.spare = null;
    setTimeout(() => this.next(), later);
    return worker;
  }

  /** One that has nothing to do. */
  private next(): WorkerClient {
    if (!this.spare || this.spare.isGone) this.spare = new WorkerClient(this.code);
    return this.spare;
  }

  private async alone<T>(work: (worker: WorkerClient) => Promise<T>): Promise<T> {
    const worker = this.take();
    try {
      return await work(worker);
    } finally {
      worker.end();
    }
  }
}
