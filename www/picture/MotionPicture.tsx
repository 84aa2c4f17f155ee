// The picture of the Motion view: the body on its way, played, stepped, or held at a moment.
import { useEffect, useId, useMemo, useRef, useState } from "preact/hooks";
import type { PathReport } from "../engine.ts";
import { choicesOf, textOf, wayWith } from "../model/motion_choices.ts";
import { shown } from "../number/format.ts";
import type { Store } from "../state/store.ts";
import { mistakeWords } from "../words/motion/mistakes.ts";
import * as words from "../words/motion/picture.ts";
import { pictureWords } from "../words/picture.ts";
import { cameraOf } from "./camera.ts";
import { motionIsReduced } from "./motion.ts";
import { motionScene } from "./motion_scene.ts";
import { Stage } from "./Stage.tsx";
import { saveFile, svgText } from "./save.ts";

/** How long the whole way takes at the usual speed. */
const playedMs = 5000;
const speeds = { "½": 0.5, "1": 1, "2": 2 } as const;
type Speed = keyof typeof speeds;

export function MotionPicture({ store }: { store: Store }) {
  const path = store.motion.value?.report.path;
  return path ? <Shown store={store} path={path} /> : <p class="picture-wait">{words.nothing}</p>;
}

function Shown({ store, path }: { store: Store; path: PathReport }) {
  const frame = useRef<HTMLDivElement>(null);
  const describedBy = useId();
  const state = store.state.value;
  const { look } = state.picture;
  const choices = choicesOf(state);
  const [way = []] = path.ways;
  const last = way.length - 1;
  const [played, setPlayed] = useState<number>();
  const [speed, setSpeed] = useState<Speed>("1");
  const moment = played ?? Math.min(choices.moment, last);
  const goesOn = useRef(false);
  const hold = (at: number) => {
    // A frame that was asked for before may still come.
    goesOn.current = false;
    setPlayed(undefined);
    const moment = Math.max(0, Math.min(last, at));
    store.set({ motion: textOf({ ...choicesOf(store.state.peek()), moment }) });
  };
  const isPlaying = played !== undefined;
  const at = useRef(0);
  useEffect(() => {
    if (!isPlaying) return;
    let before: number | undefined;
    let next = 0;
    const step = (now: number) => {
      if (!goesOn.current) return;
      at.current += (((now - (before ?? now)) * speeds[speed]) / playedMs) * last;
      before = now;
      if (at.current >= last) return hold(last);
      setPlayed(at.current);
      next = requestAnimationFrame(step);
    };
    next = requestAnimationFrame(step);
    return () => cancelAnimationFrame(next);
  }, [isPlaying, speed, path]);
  const play = () => {
    at.current = moment >= last ? 0 : moment;
    goesOn.current = true;
    setPlayed(at.current);
  };
  const camera = cameraOf(look);
  const { drawn } = choices;
  const mistaken = drawn && wayWith(drawn, path);
  const scene = useMemo(
    () => motionScene(way, mistaken, moment, camera),
    [path, drawn, moment, look],
  );
  const description = words.says(drawn && mistakeWords[drawn]);
  const time = words.at(
    shown(Number((((way[last]?.[0] ?? 0) * moment) / last).toPrecision(4)), "all"),
  );
  const save = () => {
    const stage = frame.current?.querySelector<SVGSVGElement>(".stage svg");
    if (stage) saveFile(words.file, svgText(stage, words.name, description));
  };
  const button = (name: string, sign: string, onClick: () => void) => (
    <button type="button" class="motion-button" aria-label={name} title={name} onClick={onClick}>
      {sign}
    </button>
  );
  return (
    <div ref={frame}>
      <div class="motion-head">
        <h2>{words.name}</h2>
        <button type="button" class="text-button" onClick={save}>
          {pictureWords.save}
        </button>
      </div>
      <Stage
        scene={scene}
        look={look}
        label={words.name}
        describedBy={describedBy}
        onLook={(turned) => store.set({ picture: { ...store.state.peek().picture, look: turned } })}
      />
      <div class="motion-player">
        {/* Nothing moves by itself for those who asked for that. */}
        {!motionIsReduced() &&
          (isPlaying
            ? button(words.pause, "❚❚", () => hold(Math.round(moment)))
            : button(words.play, "▶", play))}
        {button(words.back, "‹", () => hold(Math.ceil(moment) - 1))}
        {button(words.forward, "›", () => hold(Math.floor(moment) + 1))}
        <input
          type="range"
          min={0}
          max={last}
          step={1}
          value={Math.round(moment)}
          aria-label={words.moment}
          aria-valuetext={time}
          onInput={({ currentTarget }) => hold(Number(currentTarget.value))}
        />
        <output class="motion-time">{time}</output>
        {!motionIsReduced() && (
          <select
            aria-label={words.speed}
            value={speed}
            onChange={({ currentTarget }) => setSpeed(currentTarget.value as Speed)}
          >
            {(Object.keys(speeds) as Speed[]).map((each) => (
              <option key={each} value={each}>
                ×{each}
              </option>
            ))}
          </select>
        )}
      </div>
      <p class="picture-says" id={describedBy}>
        {description} <span>{pictureWords.lookOnly}</span>
      </p>
    </div>
  );
}
