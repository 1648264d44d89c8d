// Numbers as colours: dark and blue for little, light and yellow for much, in steps that look even.

const stops = [0x2b0b57, 0x6a176e, 0xa52c60, 0xd94d3d, 0xf68f13, 0xf7d94c] as const;

/** Linear red, green and blue, 0 … 1, of t in 0 … 1. */
export function heatColor(t: number): [number, number, number] {
  const x = Math.min(Math.max(t, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(x), stops.length - 2);
  const mixed = (shift: number) => {
    const channel = (stop: number) => ((stop >> shift) & 255) / 255;
    return channel(stops[i]!) + (x - i) * (channel(stops[i + 1]!) - channel(stops[i]!));
  };
  return [linear(mixed(16)), linear(mixed(8)), linear(mixed(0))];
}

/** The same as a gradient of CSS, from left to right. */
export const heatGradient = `linear-gradient(to right, ${stops
  .map((stop) => `#${stop.toString(16).padStart(6, "0")}`)
  .join(", ")})`;

const linear = (x: number) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

/** What all but the largest hundredth of the values stay below: what a scale ends at. */
export function scaleEnd(values: ArrayLike<number>): number {
  const sorted = Float32Array.from(values).sort();
  return sorted[Math.floor(0.99 * (sorted.length - 1))] ?? 0;
}
