// The engine's worker: one request after the other, a reply for each.
import createCraze from "./generated/craze.mjs";
import { instantiate, type CreateCraze } from "./craze_module";
import { holdLife } from "./life";
import { CrazeError } from "./memory";
import type { FromWorker, Kind, Requests, ToWorker } from "./messages";
import { Session } from "./session";

let session: Session | null = null;
const send = (message: FromWorker, transfer: Transferable[] = []) =>
  postMessage(message, { transfer });

type Reply = Requests[Kind]["reply"];

async function answer({ kind, request }: ToWorker): Promise<Reply> {
  if (kind === "start") {
    await holdLife(request.life);
    const craze = await instantiate(createCraze as CreateCraze, request.code);
    session = new Session(craze, {
      progress: (progress) => send({ progress }),
      opened: (opened) => send({ opened }, [opened.pieces.buffer as ArrayBuffer]),
    });
    return null;
  }
  if (!session) throw new Error("the engine was not started");
  switch (kind) {
    case "look":
      return session.look(request.input);
    case "mask":
      return session.mask(request.input, request.name);
    case "crack":
      return session.crack(request);
    case "open":
      return session.open(request);
    case "moment":
      return session.moment(request.time);
    case "write":
      return session.write(request.name, request.post);
    case "fields":
      return session.fields();
    case "statistics":
      return session.statistics(request);
    case "writeLines":
      return session.writeLines(request.name, request.post);
    case "loop":
      return session.loop(request.cracks, request.seed);
    case "maps":
      return session.maps(request.size, request.post);
    case "recipe":
      return session.recipe(request);
    case "paintedInput":
      return session.paintedInput(request, request.name);
  }
}

/** The buffers of a reply, which move instead of being copied. */
function buffersOf(reply: Reply): ArrayBuffer[] {
  if (reply === null) return [];
  const values = Array.isArray(reply) ? reply.map((file) => file.bytes) : Object.values(reply);
  return values.filter(ArrayBuffer.isView).map((view) => view.buffer as ArrayBuffer);
}

addEventListener("message", async (event: MessageEvent<ToWorker>) => {
  const { id } = event.data;
  try {
    const reply = await answer(event.data);
    send({ id, reply }, buffersOf(reply));
  } catch (error) {
    const status = error instanceof CrazeError ? error.status : 7;
    // A trap of WebAssembly where memory ends; the worker is of no use after it.
    const message = error instanceof Error ? error.message : String(error);
    send({ id, error: { status, message } });
  }
});
