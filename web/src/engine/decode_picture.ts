// A PNG or JPEG as the browser reads it.

export interface Pixels {
  width: number;
  height: number;
  rgba: Uint8ClampedArray; // rows from the top
}

/** The numbers as they are stored, but where they are transparent. Throws Error for no picture. */
export async function decodePicture(file: Uint8Array): Promise<Pixels> {
  const options = { premultiplyAlpha: "none", colorSpaceConversion: "none" } as const;
  const bitmap = await createImageBitmap(new Blob([file as BlobPart]), options).catch(() => {
    throw new Error("A texture of the file is no picture that this browser can read.");
  });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("This browser cannot read pictures in a worker.");
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return { width, height, rgba: context.getImageData(0, 0, width, height).data };
}
