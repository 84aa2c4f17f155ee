// The scene of one attitude, from the report of the core; pure.
import type { ReadReport } from "../engine.ts";
import type { PictureState, Reading } from "../model/picture_state.ts";
import { type Camera, cameraOf } from "./camera.ts";
import { visibleEdges } from "./occlusion.ts";
import {
  bodyAxes,
  ground,
  outline,
  type Scene,
  scene,
  type Turning,
  turningAxis,
  vectorArrow,
  wayOf,
  worldAxes,
} from "./scene.ts";
import { type Quaternion, times, turnAbout, turned, type Vector } from "./space.ts";

/** The reading that is shown: the chosen one, or the declared function. */
export function readingOf(report: ReadReport, { reading }: PictureState): Reading {
  return reading ?? report.declared.convention.function;
}

/** What the declared matrix does to a vector that is turned; nothing where there is no turn. */
export function operatorTurn({ turn, rules }: ReadReport): Turning | undefined {
  const { axis, angleRad } = turn;
  if (axis === undefined) return undefined;
  return rules.operator === "body-to-world"
    ? { axis, angleRad }
    : { axis: times(axis, -1), angleRad };
}

/** The vector on the world axes, where its coordinates are those of the declared matrix's side. */
export function vectorInWorld({ rules, vector, declared }: ReadReport): Vector | undefined {
  return rules.operator === "body-to-world" ? declared.image : vector;
}

const standing: Quaternion = { w: 1, x: 0, y: 0, z: 0 };

/** The turn that the active picture makes: that of the declared matrix. */
function operatorPose(report: ReadReport, part: number): Quaternion {
  const turning = operatorTurn(report);
  return turning ? turnAbout(turning.axis, turning.angleRad * part) : standing;
}

function poseOf({ axis, angleRad }: ReadReport["turn"], part: number): Quaternion {
  return axis ? turnAbout(axis, angleRad * part) : standing;
}

/** The letter of each product, below the axes of its pose. */
const letterOf = { right: "H", left: "J" } as const;
const otherHand = { right: "left", left: "right" } as const;

export function readScene(
  report: ReadReport,
  picture: PictureState,
  angleWords: string,
  progress: number,
): { scene: Scene; camera: Camera } {
  const camera = cameraOf(picture.look);
  const { turn, declared } = report;
  const parts: Pick<Scene, "lines" | "labels">[] = [{ lines: ground(), labels: [] }, worldAxes()];
  const isActive = readingOf(report, picture) === "active";
  const pose = isActive ? operatorPose(report, progress) : poseOf(turn, progress);
  const turning = isActive ? operatorTurn(report) : turn.axis && { ...turn, axis: turn.axis };
  if (turning) parts.push(turningAxis(turning, angleWords, camera));
  if (isActive) {
    // The body is turned as the vector is; its outline stays where it was.
    if (turning) parts.push({ lines: visibleEdges(standing, camera, "ghost"), labels: [] });
    parts.push(vectorArrow(report.vector, "v", "before"));
    if (declared.image && turning) {
      const done = { axis: turning.axis, angleRad: turning.angleRad * progress };
      const after = progress < 1 ? turnedBy(report.vector, done) : declared.image;
      parts.push({ lines: wayOf(report.vector, done), labels: [] });
      parts.push(vectorArrow(after, "v′", "after"));
    }
  } else {
    const { handedness } = declared.convention;
    const isPair = picture.poses === "both";
    parts.push(bodyAxes(pose, isPair ? letterOf[handedness] : "B"));
    const inWorld = vectorInWorld(report);
    if (inWorld) parts.push(vectorArrow(inWorld, "v", "after"));
    if (isPair && turn.axis) {
      const other = turnAbout(turn.axis, -turn.angleRad);
      parts.push(outline(other, camera, letterOf[otherHand[handedness]]));
    }
  }
  return { scene: scene(pose, parts), camera };
}

function turnedBy(vector: Vector, { axis, angleRad }: Turning): Vector {
  return turned(vector, turnAbout(axis, angleRad));
}
