// The geometry of the picture, against numbers made by hand.
import { expect, test } from "@playwright/test";
import { pictureFrom, pictureToTexts } from "../../../www/address/picture.ts";
import type { ComposeReport } from "../../../www/engine.ts";
import { firstLook } from "../../../www/model/picture_state.ts";
import { cameraOf, onPaper, orbited, turnAsSeen } from "../../../www/picture/camera.ts";
import { composeScene, stagesOf } from "../../../www/picture/compose_scene.ts";
import { isHidden, painted, planesOf, visibleEdges } from "../../../www/picture/occlusion.ts";
import { worldAxes } from "../../../www/picture/scene.ts";
import { faces } from "../../../www/picture/solid.ts";
import {
  composed,
  directionOf,
  dot,
  turnAbout,
  turned,
  type Vector,
} from "../../../www/picture/space.ts";

const standing = { w: 1, x: 0, y: 0, z: 0 };
/** The eye on the world's x axis. */
const fromX = cameraOf({ azimuthDeg: 0, elevationDeg: 0 });
const planes = planesOf(standing, fromX);
const close = (vector: readonly number[], expected: readonly number[]) => {
  for (const [at, number] of expected.entries()) expect(vector[at]).toBeCloseTo(number, 12);
};

test("the drawing is as large as its paper, and no axis ends beyond it", () => {
  for (const paper of [
    { width: 282, height: 240 },
    { width: 282, height: 330 },
    { width: 392, height: 450 },
  ]) {
    for (let elevationDeg = -89; elevationDeg <= 89; elevationDeg += 8) {
      const camera = cameraOf({ azimuthDeg: 3 * elevationDeg, elevationDeg }, paper);
      const free = worldAxes().lines.map(({ to }) => {
        const { across, down } = onPaper(to, camera);
        return Math.min(across, paper.width - across, down, paper.height - down);
      });
      expect(Math.min(...free)).toBeGreaterThan(4);
    }
    const across = 2 * 1.52 * cameraOf(firstLook, paper).scale;
    expect(across / Math.min(paper.width, paper.height)).toBeGreaterThan(0.9);
  }
});

test("turns are right-handed, and the left one of two comes last", () => {
  const aboutZ = turnAbout([0, 0, 1], Math.PI / 2);
  const aboutX = turnAbout([1, 0, 0], Math.PI / 2);
  close(turned([1, 0, 0], aboutZ), [0, 1, 0]);
  close(turned([0, 1, 0], aboutX), [0, 0, 1]);
  // First about x, y goes to z; then about z, z stays.
  close(turned([0, 1, 0], composed(aboutZ, aboutX)), [0, 0, 1]);
  close(turned([0, 1, 0], composed(aboutX, aboutZ)), [-1, 0, 0]);
});

test("from the x axis, y is to the right, z is up, and what is nearer is larger", () => {
  const middle = onPaper([0, 0, 0], fromX);
  expect(onPaper([0, 1, 0], fromX).across).toBeGreaterThan(middle.across);
  expect(onPaper([0, 0, 1], fromX).down).toBeLessThan(middle.down);
  const width = (x: number) => onPaper([x, 1, 0], fromX).across - onPaper([x, -1, 0], fromX).across;
  // Seven units to the origin: at 1 it is six sevenths as far.
  expect(width(1) / width(0)).toBeCloseTo(7 / 6, 12);
});

test("what is in front follows the hand", () => {
  // The eye goes to the left, so the front goes to the right; never over the pole.
  expect(orbited({ azimuthDeg: 170, elevationDeg: 80 }, 20, 30)).toEqual({
    azimuthDeg: -170,
    elevationDeg: 89,
  });
  const right = turned([1, 0, 0], turnAsSeen(fromX, 90, 0));
  close(right, [0, 1, 0]);
  close(turned([1, 0, 0], turnAsSeen(fromX, 0, 90)), [0, 0, -1]);
});

test("the solid is closed and convex, and its sides look outwards", () => {
  const corners = faces.flatMap((face) => face.corners);
  for (const { normal, corners: own } of faces) {
    const offset = dot(normal, own[0] as Vector);
    expect(offset).toBeGreaterThan(0);
    for (const corner of own) expect(dot(normal, corner)).toBeCloseTo(offset, 12);
    for (const corner of corners) expect(dot(normal, corner)).toBeLessThan(offset + 1e-12);
  }
  // Every edge belongs to two sides, which go along it in opposite senses (Euler: 12 − 20 + 10 = 2).
  const edges = faces.flatMap(({ corners: own }) =>
    own.map((corner, at) => [corner, own[(at + 1) % own.length]].join(" | ")),
  );
  expect(new Set(edges).size).toBe(2 * 20);
  for (const edge of edges) expect(edges).toContain(edge.split(" | ").reverse().join(" | "));
});

test("a line is hidden where it is behind the solid, and left out inside it", () => {
  const line = (from: Vector, to: Vector) =>
    painted([{ from, to, pen: "world-x", tip: "arrow" }], planes, fromX);
  const count = ({ behind, before }: ReturnType<typeof line>) => [behind.length, before.length];
  expect(count(line([-2, -1, 0], [-2, 1, 0]))).toEqual([1, 0]);
  expect(count(line([2, -1, 0], [2, 1, 0]))).toEqual([0, 1]);
  expect(count(line([-0.1, 0, 0], [0.1, 0, 0]))).toEqual([0, 0]);
  // Through the solid: a piece behind it and a piece before it, with the tip.
  const through = line([-2, 0, 0], [2, 0, 0]);
  expect(count(through)).toEqual([1, 1]);
  expect([through.behind[0]?.tip, through.before[0]?.tip]).toEqual([undefined, "arrow"]);
  const entry = through.behind[0]?.to.depth ?? 0;
  // The rear side stands at x = −0.56, seven units from the eye at the origin.
  expect(entry).toBeCloseTo(7.56, 12);
  expect(isHidden([-2, 0, 0], planes, fromX)).toBe(true);
  expect(isHidden([2, 0, 0], planes, fromX)).toBe(false);
  expect(isHidden([-2, 1, 0], planes, fromX)).toBe(false);
});

test("only edges of sides that are seen are drawn", () => {
  // From the nose: the front, and the four slanting sides; 4 + 4 + 4 edges.
  expect(visibleEdges(standing, fromX, "ghost")).toHaveLength(12);
  // From behind: the rear alone.
  const fromBehind = cameraOf({ azimuthDeg: 180, elevationDeg: 0 });
  expect(visibleEdges(standing, fromBehind, "ghost")).toHaveLength(4);
});

test("two turns in order, about fixed axes and about moving ones, make the product", () => {
  // p: a quarter turn about z, q: one about x; Hamilton's p ⊙ q = (1 + k)(1 + i)/2 = (1 + i + j + k)/2.
  const quarterAbout = (axis: Vector) => ({ axis, angleRad: Math.PI / 2 });
  const report = {
    declared: { firstAboutFixedAxes: "q" },
    pTurn: quarterAbout([0, 0, 1]),
    qTurn: quarterAbout([1, 0, 0]),
  } as unknown as ComposeReport;
  const half = Math.SQRT1_2;
  const shown = (axes: "fixed" | "moving", step: 0 | 1 | 2) => {
    const scene = composeScene(stagesOf(report, axes), axes, step, 1, fromX, () => "");
    const { w, x, y, z } = scene.pose;
    const axis = scene.lines.find(({ pen }) => pen === "turn-axis");
    return { pose: [w, x, y, z], axis: axis && directionOf(axis.to) };
  };
  close(shown("fixed", 0).pose, [1, 0, 0, 0]);
  close(shown("fixed", 1).pose, [half, half, 0, 0]);
  close(shown("moving", 1).pose, [half, 0, 0, half]);
  for (const axes of ["fixed", "moving"] as const) {
    close(shown(axes, 2).pose, [0.5, 0.5, 0.5, 0.5]);
  }
  // The second turn: about the world's z, and about the x that the first one carried to y.
  close(shown("fixed", 2).axis ?? [], [0, 0, 1]);
  close(shown("moving", 2).axis ?? [], [0, 1, 0]);
});

test("how the picture is shown reads back from the address, and nonsense is the opening", () => {
  const shown = {
    look: { azimuthDeg: -120, elevationDeg: 35 },
    reading: "active",
    poses: "both",
    step: 1,
  } as const;
  const from = (texts: [string, string][]) => pictureFrom(new URLSearchParams(texts));
  expect(from(pictureToTexts(shown))).toEqual(shown);
  const opening = from([]);
  expect(pictureToTexts(opening)).toEqual([]);
  // That of the addresses from before the opening had another one.
  const before = { azimuthDeg: 30, elevationDeg: 22 };
  expect(from([["look", "30,22"]]).look).toEqual(before);
  expect(pictureToTexts({ ...opening, look: before })).toEqual([["look", "30,22"]]);
  expect(
    from([
      ["look", "NaN,1e9"],
      ["picture", "both"],
      ["poses", "__proto__"],
      ["step", "3"],
    ]),
  ).toEqual(opening);
});
