// A scene as the elements of an SVG; colours are custom properties, so that they follow the theme.
import { useMemo } from "preact/hooks";
import { type Camera, type OnPaper, onPaper } from "./camera.ts";
import { fontSize, frameSize, type Stood } from "./labels.ts";
import { type Lettered, lettered } from "./lettering.ts";
import { type PaintedLine, type Plane, painted, planesOf } from "./occlusion.ts";
import { penOf } from "./pens.ts";
import type { Scene } from "./scene.ts";
import { dot, turned } from "./space.ts";

export function Drawing({ scene, camera }: { scene: Scene; camera: Camera }) {
  // Labels stay where they were, if they can, on the same paper.
  const last = useMemo(() => new Map<string, Stood>(), [camera.paper]);
  const planes = scene.isBare ? [] : planesOf(scene.pose, camera);
  const { behind, before } = painted(scene.lines, planes, camera);
  const letters = lettered(scene, camera, planes, [...behind, ...before], last);
  return (
    <>
      <g fill="none" stroke-linecap="round" pointer-events="none">
        {behind.map((line, at) => (
          <PenLine key={at} line={line} />
        ))}
      </g>
      <g class="picture-body" stroke-linejoin="round" stroke-linecap="round">
        {planes
          .filter(({ isFacing }) => isFacing)
          .map((plane) => (
            <Side key={plane.face} plane={plane} scene={scene} camera={camera} />
          ))}
      </g>
      <g fill="none" stroke-linecap="round" pointer-events="none">
        {before.map((line, at) => (
          <PenLine key={at} line={line} />
        ))}
      </g>
      <g
        font-family="IBM Plex Serif, STIX Two Text, Times New Roman, serif"
        font-style="italic"
        font-size={fontSize}
        text-anchor="middle"
        pointer-events="none"
      >
        {letters.map((lettering, index) => (
          <Lettering key={index} {...lettering} />
        ))}
      </g>
    </>
  );
}

/** Hundredths of a unit of paper are finer than any screen. */
const fine = (number: number) => Number(number.toFixed(2));
const tipLength = 8;
const tipWidth = 3.2;
/** The line that letters stand on. */
const belowMiddle = 5;

function PenLine({ line: { from, to, pen, tip } }: { line: PaintedLine }) {
  const { colour, width, dash, opacity } = penOf(pen);
  const [across, down] = [to.across - from.across, to.down - from.down];
  const length = Math.hypot(across, down);
  // A tip needs a shaft that shows its direction.
  const hasTip = tip !== undefined && length > 0.5;
  const [u, v] = hasTip ? [across / length, down / length] : [0, 0];
  const cut = hasTip ? Math.min(length, tipLength * 0.7) : 0;
  const size = width > 2 ? 1.15 : 0.85;
  const base = { across: to.across - u * tipLength * size, down: to.down - v * tipLength * size };
  const side = tipWidth * size;
  return (
    <>
      <line
        x1={fine(from.across)}
        y1={fine(from.down)}
        x2={fine(to.across - u * cut)}
        y2={fine(to.down - v * cut)}
        stroke={colour}
        stroke-width={width}
        {...(dash ? { "stroke-dasharray": dash } : {})}
        {...(opacity ? { "stroke-opacity": opacity } : {})}
      />
      {hasTip && (
        <path
          d={`M${fine(to.across)} ${fine(to.down)}L${fine(base.across - v * side)} ${fine(base.down + u * side)}L${fine(base.across + v * side)} ${fine(base.down - u * side)}Z`}
          fill={colour}
        />
      )}
    </>
  );
}

const pathOf = (points: readonly OnPaper[]) =>
  `M${points.map(({ across, down }) => `${fine(across)} ${fine(down)}`).join("L")}Z`;

/** How dark a side is that looks away from the light, which comes over the viewer's shoulder. */
const darkest = 0.12;

function Side({ plane, scene, camera }: { plane: Plane; scene: Scene; camera: Camera }) {
  const { face, normal } = plane;
  const place = (point: Parameters<typeof turned>[0]) => onPaper(turned(point, scene.pose), camera);
  const d = pathOf(face.corners.map(place));
  const light = dot(normal, camera.back) * 0.55 + dot(normal, camera.up) * 0.45;
  const shade = fine(darkest * (1 - Math.max(0, light)));
  return (
    <>
      <path d={d} fill={face.letter ? `var(--side-${face.letter})` : "var(--side)"} />
      <path
        d={d}
        fill="var(--picture-shade)"
        fill-opacity={shade}
        stroke="var(--picture-edge)"
        stroke-width="0.8"
      />
      {face.strokes.length > 0 && (
        <path
          d={face.strokes
            .map(([from, to]) => {
              const [a, b] = [place(from), place(to)];
              return `M${fine(a.across)} ${fine(a.down)}L${fine(b.across)} ${fine(b.down)}`;
            })
            .join("")}
          fill="none"
          stroke={`var(--axis-${face.letter})`}
          stroke-width="1.3"
          stroke-opacity="0.7"
        />
      )}
    </>
  );
}

/** What stands behind the solid has a fainter letter. */
function Lettering({ label: { text, frame, pen }, place, isHidden }: Lettered) {
  return (
    <text
      x={fine(place.across)}
      y={fine(place.down + belowMiddle)}
      fill={penOf(pen).colour}
      stroke="var(--picture-paper)"
      stroke-width="3"
      stroke-linejoin="round"
      paint-order="stroke"
      {...(isHidden ? { opacity: 0.55 } : {})}
    >
      {text}
      {frame && (
        <tspan font-size={frameSize} dy="3">
          {frame}
        </tspan>
      )}
    </text>
  );
}
