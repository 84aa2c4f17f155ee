// The error of each kind of step against the length of the step, both on scales of powers of ten.
import type { PathReport } from "../../engine.ts";
import * as words from "../../words/motion/motion.tsx";

const width = 320;
const height = 220;
const left = 44;
const bottom = 30;
const edge = 8;

export function ErrorPlot({ path }: { path: PathReport }) {
  const series = path.integrators.map((rows) =>
    rows.flatMap(([, step, error]) =>
      error > 0 ? [{ step: Math.log10(step), error: Math.log10(error) }] : [],
    ),
  );
  const points = series.flat();
  if (points.length === 0) return null;
  const bounds = (numbers: number[]) => [Math.min(...numbers), Math.max(...numbers)] as const;
  const [shortest, longest] = bounds(points.map(({ step }) => step));
  const [least, most] = bounds(points.map(({ error }) => error)).map((number, at) =>
    at === 0 ? Math.floor(number) : Math.ceil(number),
  ) as [number, number];
  const across = (step: number) =>
    left + ((step - shortest) / (longest - shortest || 1)) * (width - left - edge);
  const down = (error: number) =>
    edge + ((most - error) / (most - least || 1)) * (height - bottom - edge);
  const every = Math.ceil((most - least) / 5) || 1;
  const decades = Array.from(
    { length: Math.floor((most - least) / every) + 1 },
    (_, at) => least + at * every,
  );
  return (
    <svg
      class="motion-plot"
      viewBox={`0 0 ${width} ${height}`}
      role="img"
      aria-label={words.plotName}
    >
      {decades.map((decade) => (
        <g key={decade}>
          <path class="grid" d={`M${left} ${down(decade)} H${width - edge}`} />
          <text x={left - 5} y={down(decade) + 4} text-anchor="end">
            1e{decade}
          </text>
        </g>
      ))}
      {[shortest, longest].map((step, at) => (
        <text key={step} x={across(step)} y={height - 14} text-anchor={at === 0 ? "start" : "end"}>
          {Number((10 ** step).toPrecision(2))}
        </text>
      ))}
      <text x={(left + width) / 2} y={height - 3} text-anchor="middle">
        {words.plotStep}
      </text>
      {series.map((line, at) => (
        <g key={words.kinds[at]} class={`series-${at}`}>
          <polyline
            points={line.map(({ step, error }) => `${across(step)},${down(error)}`).join(" ")}
          />
          {line.map(({ step, error }) => (
            <circle key={step} cx={across(step)} cy={down(error)} r="2.4" />
          ))}
        </g>
      ))}
    </svg>
  );
}
