// A worker with the engine, asked through promises.
import { endOfLife, newLife } from "./life";
import { CrazeError } from "./memory";
import type { FromWorker, Kind, OpenedPieces, Progress, Requests } from "./messages";

interface Waiting {
  resolve(reply: Requests[Kind]["reply"]): void;
  reject(reason: Error): void;
}

/** Rejects what was asked of a worker that was ended. */
export class Cancelled extends Error {
  constructor() {
    super("cancelled");
    this.name = "Cancelled";
  }
}

export class WorkerClient {
  onProgress: (progress: Progress) => void = () => {};
  onOpened: (pieces: OpenedPieces) => void = () => {};
  private readonly worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  private readonly waiting = new Map<number, Waiting>();
  private next = 0;
  private gone: Error | null = null; // why it answers no longer

  constructor(code: Promise<WebAssembly.Module>) {
    this.worker.addEventListener("message", (event: MessageEvent<FromWorker>) =>
      this.hear(event.data),
    );
    this.worker.addEventListener("error", (event) => this.fail(new Error(event.message)));
    const life = newLife();
    this.started = code.then((compiled) => this.post("start", { code: compiled, life }));
    void this.started.then(() => endOfLife(life)).then(
      () => this.fail(new Error("The engine has stopped: crack it again.")),
      () => {},
    );
    this.started.catch(() => {}); // told to whoever asks
  }

  private readonly started: Promise<null>;

  async ask<K extends Kind>(kind: K, request: Requests[K]["request"]): Promise<Requests[K]["reply"]> {
    await this.started;
    return this.post(kind, request);
  }

  /** Ends it at once; what it was asked is rejected with Cancelled. */
  end(): void {
    this.worker.terminate();
    this.fail(new Cancelled());
  }

  get isGone(): boolean {
    return this.gone !== null;
  }

  private post<K extends Kind>(kind: K, request: Requests[K]["request"]) {
    return new Promise<Requests[K]["reply"]>((resolve, reject) => {
      if (this.gone) return reject(this.gone);
      const id = this.next++;
      this.waiting.set(id, { resolve: resolve as Waiting["resolve"], reject });
      this.worker.postMessage({ id, kind, request });
    });
  }

  private hear(message: FromWorker): void {
    if ("progress" in message) return this.onProgress(message.progress);
    if ("opened" in message) return this.onOpened(message.opened);
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if ("reply" in message) waiting?.resolve(message.reply);
    else waiting?.reject(new CrazeError(message.error.status, message.error.message));
  }

  private fail(reason: Error): void {
    this.gone ??= reason;
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    for (const { reject } of waiting) reject(reason);
  }
}
