// What a canvas shows for a while, as WebM.

/** Records while `play` lasts. Throws Error where the browser cannot. */
export async function recordFilm(
  canvas: HTMLCanvasElement,
  play: () => Promise<void>,
): Promise<Blob> {
  const type = ["video/webm;codecs=vp9", "video/webm"].find((name) =>
    globalThis.MediaRecorder?.isTypeSupported(name),
  );
  if (!type) throw new Error("This browser records no WebM.");
  const stream = canvas.captureStream(30);
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 8_000_000 });
  const parts: Blob[] = [];
  recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
  const ended = new Promise((resolve) => recorder.addEventListener("stop", resolve));
  recorder.start();
  try {
    await play();
  } finally {
    recorder.stop();
    await ended;
    for (const track of stream.getTracks()) track.stop();
  }
  return new Blob(parts, { type: "video/webm" });
}
