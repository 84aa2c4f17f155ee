// Where the labels of the picture stand: on no other label, on the paper, and in peace under a hand.
import { expect, test } from "@playwright/test";
import type { ReadReport } from "../../../www/engine.ts";
import { opening } from "../../../www/model/page_state.ts";
import { firstLook, firstPicture, type PictureState } from "../../../www/model/picture_state.ts";
import { cameraOf, type Paper, usualPaper } from "../../../www/picture/camera.ts";
import { lineHeight, placed, type Stood } from "../../../www/picture/labels.ts";
import { type Lettered, lettered } from "../../../www/picture/lettering.ts";
import { painted, planesOf } from "../../../www/picture/occlusion.ts";
import { readScene } from "../../../www/picture/read_scene.ts";
import { composed, ofNormOne, turnAbout } from "../../../www/picture/space.ts";
import {
  asText,
  hamilton,
  jpl,
  randomAttitude,
  randomFrom,
  randomVector,
  reportOf,
} from "../support/attitudes.ts";

/** The drawing in the lowest and in a usual card of 310 px, in a high one of 420 px, and on a phone. */
const papers: Paper[] = [
  { width: 282, height: 240 },
  { width: 282, height: 330 },
  { width: 392, height: 450 },
  { width: 330, height: 330 },
];
const pictures: PictureState[] = [
  firstPicture,
  { ...firstPicture, poses: "both" },
  { ...firstPicture, reading: "active" },
];

function labelsOf(
  report: ReadReport,
  picture: PictureState,
  paper: Paper,
  last = new Map<string, Stood>(),
): Lettered[] {
  const { scene } = readScene(report, picture, `${report.turn.angleDeg.toPrecision(3)}°`, 1);
  const camera = cameraOf(picture.look, paper);
  const planes = planesOf(scene.pose, camera);
  const { behind, before } = painted(scene.lines, planes, camera);
  return lettered(scene, camera, planes, [...behind, ...before], last);
}

const nameOf = ({ label: { text, frame = "" } }: Lettered) => text + frame;

/** What is wrong with the places of labels. */
function wrong(labels: readonly Lettered[], paper: Paper): string[] {
  const rounding = 1e-9;
  return labels.flatMap((one, at) => {
    const { across, down } = one.place;
    const isOff =
      Math.min(across, paper.width - across) < one.width / 2 - rounding ||
      Math.min(down, paper.height - down) < lineHeight / 2 - rounding;
    const under = labels
      .slice(at + 1)
      .filter(
        ({ place, width }) =>
          Math.abs(place.across - across) < (width + one.width) / 2 - rounding &&
          Math.abs(place.down - down) < lineHeight - rounding,
      );
    return [
      ...(isOff ? [`${nameOf(one)} is cut`] : []),
      ...under.map((other) => `${nameOf(one)} and ${nameOf(other)}`),
    ];
  });
}

test("the labels of the opening are clear of each other and of the edges", () => {
  const { quaternion, vector } = opening;
  for (const convention of [hamilton, jpl]) {
    const report = reportOf(quaternion, vector, convention);
    for (const picture of pictures) {
      for (const paper of papers) {
        const labels = labelsOf(report, picture, paper);
        expect(labels.length).toBeGreaterThan(5);
        expect(wrong(labels, paper)).toEqual([]);
      }
    }
  }
});

test("so are those of 200 attitudes with any vector, from the first look and from any other", () => {
  const random = randomFrom(13);
  const found: string[] = [];
  for (let run = 0; run < 200; run += 1) {
    const [attitude, vector] = [randomAttitude(random), randomVector(random)];
    const report = reportOf(asText(attitude), vector.join(" "), run % 2 ? jpl : hamilton);
    const paper = papers[run % papers.length] ?? usualPaper;
    const elsewhere = { azimuthDeg: 360 * random() - 180, elevationDeg: 178 * random() - 89 };
    for (const picture of pictures) {
      for (const look of [firstLook, elsewhere]) {
        const labels = labelsOf(report, { ...picture, look }, paper);
        const where = `${asText(attitude)}, ${vector}`;
        found.push(...wrong(labels, paper).map((what) => `${what}: ${where}`));
      }
    }
  }
  expect(found).toEqual([]);
});

test("while the body is dragged, a label goes along with its line and seldom to another side", () => {
  const random = randomFrom(7);
  const counted = { keeping: 0, anew: 0, steps: 0 };
  for (let run = 0; run < 5; run += 1) {
    // A drag by one pixel turns by 0.6°.
    const step = turnAbout(randomVector(random), (0.6 * Math.PI) / 180);
    const vector = randomVector(random).join(" ");
    let attitude = randomAttitude(random);
    const last = new Map<string, Stood>();
    const before: Record<string, Lettered[]> = {};
    for (let pixel = 0; pixel < 120; pixel += 1) {
      attitude = ofNormOne(composed(step, attitude));
      const report = reportOf(asText(attitude), vector, hamilton);
      for (const [way, labels] of [
        ["keeping", labelsOf(report, firstPicture, usualPaper, last)],
        ["anew", labelsOf(report, firstPicture, usualPaper)],
      ] as const) {
        for (const [at, { place }] of labels.entries()) {
          const from = before[way]?.[at]?.place ?? place;
          const moved = Math.hypot(place.across - from.across, place.down - from.down);
          if (moved > 14) counted[way] += 1;
          if (way === "keeping") counted.steps += 1;
        }
        before[way] = labels;
      }
    }
  }
  // Of the labels of a drag by 100 pixels, which turns by 60°, about three.
  expect(counted.keeping / counted.steps).toBeLessThan(0.006);
  expect(counted.keeping).toBeLessThan(counted.anew / 2);
});

test("a label stands beyond the end of its line, beside one that is there, and not on another label", () => {
  const at = (across: number, down: number) => ({ across, down, depth: 1 });
  const paper = { width: 300, height: 300 };
  const label = { key: "x", from: at(100, 150), tip: at(200, 150), width: 20 };
  const alone = placed([label], [], paper, new Map())[0];
  expect(alone?.down).toBeCloseTo(150, 9);
  expect(alone?.across).toBeCloseTo(200 + 5 + 10, 9);
  const line = { from: at(150, 150), to: at(280, 150), weight: 1 };
  const beside = placed([label], [line], paper, new Map())[0];
  expect(Math.abs((beside?.down ?? 150) - 150)).toBeGreaterThan(6);
  const [first, second] = placed([label, { ...label, key: "y" }], [], paper, new Map());
  expect(first).toEqual(alone);
  expect(second).not.toEqual(alone);
});
