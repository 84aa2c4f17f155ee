// The picture of the Read view: one attitude, its axis, a vector; turning it writes the quaternion.
import { useId, useMemo, useRef } from "preact/hooks";
import { hold } from "../dom/hold.ts";
import type { ReadReport } from "../engine.ts";
import { presetOf } from "../model/conventions.ts";
import type { Unit } from "../model/page_state.ts";
import { firstLook, type PictureState, type Reading } from "../model/picture_state.ts";
import { shownArray, shownAxis, shownRoughAngle } from "../number/format.ts";
import type { Freshness, Store } from "../state/store.ts";
import { arrowOf, wordsOf } from "../words/conventions.ts";
import {
  activeWords,
  axesWords,
  inShort,
  noTurnName,
  noTurnWords,
  otherPoseWords,
  passiveWords,
  readPictureLabel,
  samePoseWords,
  turnedAxesWords,
  turnWords,
  vectorWords,
  pictureWords as words,
} from "../words/picture.ts";
import { useMotion } from "./motion.ts";
import { operatorTurn, readingOf, readScene, vectorInWorld } from "./read_scene.ts";
import { Stage } from "./Stage.tsx";
import { saveFile, svgText } from "./save.ts";
import type { Turning } from "./scene.ts";
import { composed, ofNormOne, type Quaternion } from "./space.ts";
import { poseAsText } from "./written.ts";

export function ReadPicture({ store }: { store: Store }) {
  const shown = store.read.value;
  return shown ? <Shown store={store} {...shown} /> : null;
}

const same = (turn: Quaternion) => turn;
const inverse = ({ w, x, y, z }: Quaternion): Quaternion => ({ w, x: -x, y: -y, z: -z });

/** In a picture, more than four decimals say nothing. */
const coarse = (numbers: readonly number[]) =>
  shownArray(
    numbers.map((number) => Number(number.toFixed(4)) + 0),
    "all",
  );

function Shown({
  store,
  report,
  freshness,
}: {
  store: Store;
  report: ReadReport;
  freshness: Freshness;
}) {
  const { picture, unit } = store.state.value;
  const frame = useRef<HTMLDivElement>(null);
  const describedBy = useId();
  const motion = useMotion();
  const reading = readingOf(report, picture);
  const change = (changed: Partial<PictureState>) =>
    store.set({ picture: { ...store.state.peek().picture, ...changed } });
  const angle = shownRoughAngle(report.turn.angleDeg, unit);
  const turning = shownTurning(report, reading);
  const { scene } = useMemo(
    () => readScene(report, picture, angle, motion.progress),
    [report, picture, angle, motion.progress],
  );
  const { short, description } = describe(report, reading, picture, unit);

  const written = useRef<{ pose: Quaternion; text: string }>(undefined);
  const onTurn = (turn: Quaternion, by: "drag" | "key") => {
    const state = store.state.peek();
    // Going on from what was written last, the pose is known with more digits than the text has.
    const last = written.current?.text === state.quaternion ? written.current.pose : undefined;
    // In the active reading the body stands as the declared matrix turns it.
    const isInverse = reading === "active" && report.rules.operator === "world-to-body";
    const seen = isInverse ? inverse : same;
    const pose = seen(ofNormOne(composed(turn, seen(last ?? report.hamilton.unit))));
    const text = poseAsText(pose, state.digits);
    written.current = { pose, text };
    hold();
    // A drag is one step of the history, however long the hand rests.
    store.set(
      { quaternion: text },
      { as: `turning by ${by}`, ...(by === "drag" ? { restMs: Number.POSITIVE_INFINITY } : {}) },
    );
  };

  const save = () => {
    const stage = frame.current?.querySelector<SVGSVGElement>(".stage svg");
    if (stage) saveFile(words.fileName, svgText(stage, readPictureLabel, description.join(" ")));
  };

  return (
    <div ref={frame} class={freshness === "current" ? "" : "picture-old"}>
      <div class="picture-head">
        <fieldset class="choice">
          <legend class="visually-hidden">{words.reading}</legend>
          {(["passive", "active"] as const).map((name) => (
            <label key={name} title={words.readings[name].meaning}>
              <input
                type="radio"
                name="reading"
                value={name}
                checked={name === reading}
                onChange={() => {
                  change({ reading: name });
                  motion.start();
                }}
              />
              <span>{words.readings[name].name}</span>{" "}
              <span class="visually-hidden">{words.readings[name].meaning}</span>
            </label>
          ))}
        </fieldset>
        <p class="picture-turn">{turning ? turnWords(angle, shortAxis(turning)) : noTurnName}</p>
      </div>
      <Stage
        scene={scene}
        look={picture.look}
        label={readPictureLabel}
        describedBy={describedBy}
        onLook={(look) => change({ look })}
        onTurn={onTurn}
        onTurned={store.step}
        onCancelled={() => {
          store.step();
          store.undo();
        }}
      />
      <p class="picture-hint">{words.hands}</p>
      {/* What is read aloud says more. */}
      <p class="picture-says" aria-hidden="true">
        {short}
      </p>
      <p class="visually-hidden" id={describedBy}>
        {description.join(" ")} {words.keys}
      </p>
      <div class="picture-foot">
        <label class="picture-check">
          <input
            type="checkbox"
            checked={picture.poses === "both" && reading === "passive"}
            onChange={({ currentTarget }) =>
              change({ poses: currentTarget.checked ? "both" : "one", reading: "passive" })
            }
          />
          <span>
            {words.both(otherName(report))}{" "}
            <span class="visually-hidden">{arrowOf(report.declared.convention.direction)}</span>
          </span>
        </label>
        <button type="button" class="text-button" onClick={() => change({ look: firstLook })}>
          {words.reset}
        </button>
        <button type="button" class="text-button" onClick={save}>
          {words.save}
        </button>
      </div>
    </div>
  );
}

/** The turning that is shown. */
const shownTurning = (report: ReadReport, reading: Reading): Turning | undefined =>
  reading === "active"
    ? operatorTurn(report)
    : report.turn.axis && { ...report.turn, axis: report.turn.axis };

/** With no more digits than a heading has room for, on one line. */
const shortAxis = ({ axis }: Turning) =>
  shownAxis(
    axis.map((number) => Number(number.toFixed(2)) + 0),
    "all",
  ).replaceAll(" ", "\u00A0");

const otherHand = { right: "left", left: "right" } as const;

/** The name of the product that was not declared. */
const otherName = ({ declared }: ReadReport) =>
  wordsOf[presetOf[otherHand[declared.convention.handedness]]].name;

/** What is seen, in short below the picture and in sentences that are read aloud. */
function describe(
  report: ReadReport,
  reading: Reading,
  { poses }: PictureState,
  unit: Unit,
): { short: string; description: string[] } {
  const { turn, vector, declared } = report;
  const { handedness, direction } = declared.convention;
  const isActive = reading === "active";
  const rows = isActive ? declared.matrix : report.hamilton.matrix;
  const ends = [0, 1, 2].map((column) => coarse(rows.map((row) => row[column] ?? 0))) as [
    string,
    string,
    string,
  ];
  const sentences: string[] = [];
  const turning = shownTurning(report, reading);
  const matrix = `${wordsOf[presetOf[handedness]].matrix}(q)`;
  const hasVector = vector.some((number) => number !== 0) && declared.image !== undefined;
  const isPair = !isActive && poses === "both" && turn.axis !== undefined;
  if (isPair) {
    const isSame = turn.angleDeg === 180;
    const words = isSame ? samePoseWords : otherPoseWords;
    sentences.push(words(otherName(report), arrowOf(direction)));
  }
  if (turning === undefined) sentences.push(noTurnWords);
  else {
    const angle = shownRoughAngle(turn.angleDeg, unit, 4);
    const words = turnWords(angle, shownAxis(turning.axis, "4"));
    sentences.push(
      isActive ? activeWords(words, matrix, hasVector) : passiveWords(words, hasVector),
    );
  }
  sentences.push(isActive ? turnedAxesWords(ends) : axesWords(ends));
  const { image } = declared;
  const inWorld = vectorInWorld(report);
  if (hasVector && image && inWorld) {
    const inBody = report.rules.operator === "body-to-world" ? vector : image;
    sentences.push(
      isActive
        ? vectorWords.active(coarse(vector), coarse(image))
        : vectorWords.passive(coarse(inWorld), coarse(inBody)),
    );
  }
  const inFew = isActive ? inShort.active(matrix, hasVector) : inShort.passive(hasVector);
  const [first = ""] = sentences;
  return { short: isPair || turning === undefined ? first : inFew, description: sentences };
}
