// The presets' pictures, those of the Blender add-on, which has them from the command.

const found = import.meta.glob<string>("../../../blender/craze_blender/pictures/*.png", {
  eager: true,
  query: "?url",
  import: "default",
});

/** The address of a preset's picture; undefined where it has none. */
export function pictureOf(preset: string): string | undefined {
  return Object.entries(found).find(([path]) => path.endsWith(`/${preset}.png`))?.[1];
}
