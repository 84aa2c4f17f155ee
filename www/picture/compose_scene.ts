// Two turns one after the other, about fixed axes and about moving ones; pure.
import type { ComposeReport, Operand, Turn } from "../engine.ts";
import type { Step } from "../model/picture_state.ts";
import type { Camera } from "./camera.ts";
import { bodyAxes, ground, outline, type Scene, scene, turningAxis, worldAxes } from "./scene.ts";
import { composed, type Quaternion, turnAbout, turned, type Vector } from "./space.ts";

export type Axes = "fixed" | "moving";

export interface Stage {
  operand: Operand;
  turn: Turn;
}

const standing: Quaternion = { w: 1, x: 0, y: 0, z: 0 };
export const otherOperand: Record<Operand, Operand> = { p: "q", q: "p" };

/** The two turns in the order in which they are made about such axes. */
export function stagesOf(report: ComposeReport, axes: Axes): readonly [Stage, Stage] {
  const firstAboutFixed = report.declared.firstAboutFixedAxes;
  const first = axes === "fixed" ? firstAboutFixed : otherOperand[firstAboutFixed];
  const stage = (operand: Operand): Stage => ({
    operand,
    turn: operand === "p" ? report.pTurn : report.qTurn,
  });
  return [stage(first), stage(otherOperand[first])];
}

const turnOf = ({ axis, angleRad }: Turn, part: number): Quaternion =>
  axis ? turnAbout(axis, angleRad * part) : standing;

/** The pose after a turn, of which this part has been made. */
function after(pose: Quaternion, turn: Turn, axes: Axes, part: number): Quaternion {
  const next = turnOf(turn, part);
  return axes === "fixed" ? composed(next, pose) : composed(pose, next);
}

/** The picture after a step, of whose last turn this part has been made. */
export function composeScene(
  stages: readonly [Stage, Stage],
  axes: Axes,
  step: Step,
  part: number,
  camera: Camera,
  angleWords: (operand: Operand, turn: Turn) => string,
): Scene {
  const parts: Pick<Scene, "lines" | "labels">[] = [{ lines: ground(), labels: [] }, worldAxes()];
  const [first, second] = stages;
  const afterFirst = after(standing, first.turn, axes, 1);
  const [before, now] = step === 2 ? [afterFirst, second] : [standing, first];
  if (step === 0) return scene(standing, [...parts, bodyAxes(standing, "B")]);
  const pose = after(before, now.turn, axes, part);
  const { axis, angleRad } = now.turn;
  if (axis) {
    const inWorld: Vector = axes === "fixed" ? axis : turned(axis, before);
    const turning = { axis: inWorld, angleRad };
    parts.push(turningAxis(turning, angleWords(now.operand, now.turn), camera));
    parts.push({ lines: outline(before, camera, "").lines, labels: [] });
  }
  return scene(pose, [...parts, bodyAxes(pose, "B")]);
}
