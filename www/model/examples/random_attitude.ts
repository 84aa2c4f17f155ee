// A random attitude as text; pure.

/**
 * `w: 0.18…, x: …`: a unit quaternion as text, uniform over all attitudes, from numbers that are uniform
 * from 0 to 1 (Shoemake 1992, "Uniform random rotations"). Of q and −q it is the one with w ≥ 0.
 */
export function randomAttitude(random: () => number): string {
  const share = random();
  const [first, second] = [2 * Math.PI * random(), 2 * Math.PI * random()];
  const [short, long] = [Math.sqrt(1 - share), Math.sqrt(share)];
  const x = short * Math.sin(first);
  const y = short * Math.cos(first);
  const z = long * Math.sin(second);
  const w = long * Math.cos(second);
  const sign = w < 0 ? -1 : 1;
  return Object.entries({ w, x, y, z })
    .map(([name, number]) => `${name}: ${sign * number + 0}`)
    .join(", ");
}
