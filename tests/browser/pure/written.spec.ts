// What turning the body writes: the turn that was made, short to read, of which nothing has to be noted.
import { expect, test } from "@playwright/test";
import { isNormOne } from "../../../www/number/format.ts";
import { composed, ofNormOne, type Quaternion, turnAbout } from "../../../www/picture/space.ts";
import { poseAsText } from "../../../www/picture/written.ts";
import {
  asText,
  hamilton,
  jpl,
  randomAttitude,
  randomFrom,
  randomVector,
  reportOf,
} from "../support/attitudes.ts";

test("a pose is written as its angle and axis, with the decimals that are shown", () => {
  const turn = turnAbout([0, 0.6, 0.8], 1);
  expect(poseAsText(turn, "4")).toBe("57.3deg about 0 0.6 0.8");
  expect(poseAsText(turn, "6")).toBe("57.2958deg about 0 0.6 0.8");
  expect(poseAsText(turn, "all")).toBe("57.295779513082deg about 0 0.6 0.8");
  // 1 + 2i + 3j + 4k.
  const other = ofNormOne({ w: 1, x: 2, y: 3, z: 4 });
  expect(poseAsText(other, "6")).toBe("158.9605deg about 0.371391 0.557086 0.742781");
});

test("an axis of the world has its letter, and the shorter turn is written", () => {
  const about = (degrees: number) => turnAbout([0, 0, 1], (degrees * Math.PI) / 180);
  expect(poseAsText(about(45), "all")).toBe("45deg about z");
  expect(poseAsText(about(-45), "6")).toBe("45deg about -z");
  expect(poseAsText(about(190), "6")).toBe("170deg about -z");
  expect(poseAsText(about(180), "6")).toBe("180deg about z");
  expect(poseAsText({ w: -1, x: 0, y: 0, z: 0 }, "6")).toBe("0deg about z");
});

/** The angle between two attitudes that are near each other, of which either sign may be given. */
function apartDeg(one: Quaternion, other: Quaternion): number {
  const chord = (sign: 1 | -1) =>
    Math.hypot(...(["w", "x", "y", "z"] as const).map((name) => one[name] - sign * other[name]));
  return (2 * Math.min(chord(1), chord(-1)) * 180) / Math.PI;
}

test("50 drags and turns by keys write no note of their own, and what they turned to", () => {
  const random = randomFrom(11);
  // Of these conventions, one has the numbers of the other and one their conjugate.
  const conventions = [hamilton, jpl, { ...jpl, direction: "body-to-world" } as const];
  const most = { length: { 4: 40, 6: 50, all: 85 }, apart: { 4: 0.02, 6: 3e-4, all: 1e-10 } };
  const wrong: unknown[] = [];
  for (let drag = 0; drag < 50; drag += 1) {
    let pose: Quaternion = randomAttitude(random);
    for (let step = 0; step < 5; step += 1) {
      const angleDeg = drag % 2 ? 5 : 20 * random();
      const turn = turnAbout(randomVector(random), (angleDeg * Math.PI) / 180);
      pose = ofNormOne(composed(turn, pose));
    }
    for (const digits of ["4", "6", "all"] as const) {
      const text = poseAsText(pose, digits);
      for (const convention of conventions) {
        const { notes, quaternion, hamilton } = reportOf(text, "0 0 0", convention);
        const apart = apartDeg(hamilton.unit, pose);
        const isRight =
          notes.length === 0 &&
          isNormOne(quaternion.norm) &&
          text.length < most.length[digits] &&
          apart < most.apart[digits];
        if (!isRight) wrong.push({ text, notes, norm: quaternion.norm, apart });
      }
    }
  }
  expect(wrong).toEqual([]);
});

test("the numbers that were written before had a norm to note", () => {
  const { w, x, y, z } = turnAbout([0, 0, 1], Math.PI / 2);
  const rounded = { w: +w.toFixed(6), x, y, z: +z.toFixed(6) };
  const { notes } = reportOf(asText(rounded), "0 0 0", hamilton);
  expect(notes.map(({ fact }) => fact.kind)).toContain("normalised");
});
