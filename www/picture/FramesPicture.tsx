// The picture of the Frames view: each frame where it stands.
import { useId, useMemo, useRef } from "preact/hooks";
import type { FramesReport } from "../engine.ts";
import type { Store } from "../state/store.ts";
import * as words from "../words/frames/picture.ts";
import { pictureWords } from "../words/picture.ts";
import { framesScene } from "./frames_scene.ts";
import { Stage } from "./Stage.tsx";
import { saveFile, svgText } from "./save.ts";

export function FramesPicture({ store }: { store: Store }) {
  const report = store.frames.value?.report;
  return report ? <Shown store={store} report={report} /> : null;
}

function Shown({ store, report }: { store: Store; report: FramesReport }) {
  const frame = useRef<HTMLDivElement>(null);
  const describedBy = useId();
  const { look } = store.state.value.picture;
  const scene = useMemo(() => framesScene(report), [report]);
  const placed = report.frames.filter(({ matrix }) => matrix !== undefined);
  const hasPositions = placed.some(({ origin }) => origin?.some((number) => number !== 0));
  const description = hasPositions
    ? words.says(placed.map(({ name }) => name).join(", "))
    : words.nothing;
  const save = () => {
    const stage = frame.current?.querySelector<SVGSVGElement>(".stage svg");
    if (stage) saveFile(words.file, svgText(stage, words.name, description));
  };
  return (
    <div ref={frame}>
      <div class="frames-picture-head">
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
      <p class="picture-says" id={describedBy}>
        {description} <span>{pictureWords.lookOnly}</span>
      </p>
    </div>
  );
}
