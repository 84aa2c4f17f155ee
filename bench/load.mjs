// How soon the page is there: that of this tree and that of the baseline, in one run, in the same
// browsers, on a slow line and on a fast one. `npm start` or `npm test` builds this one first; then
// `node bench/load.mjs`, with `--runs 15` for more runs of each, `--encoding br` for brotli, and
// `--throttle server` where the server is to be the slow line of Chromium too, as it is of the others.
import { availableParallelism, loadavg } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { BASELINE, baseline } from "../www/tasks/baseline.mjs";
import { setUpEngines } from "../www/tasks/engines.mjs";
import { encodings } from "../www/tasks/page_parts.mjs";
import { exists, main, root, Stop, say } from "../www/tasks/shell.mjs";
import { startEngine } from "./browsers.mjs";
import { answersOf, serve } from "./serve.mjs";
import { watch } from "./watch.mjs";

const slow = { latencyMs: 150, downBitsPerSecond: 1_600_000, upBitsPerSecond: 750_000 };

/** With the goals: the most that this tree may take of what the baseline takes. */
const lines = [
  { name: "slow line", network: slow, goals: { matrixMs: 0.25, heardMs: 0.65, liveMs: 0.65 } },
  {
    name: "slow line, CPU x4",
    network: slow,
    processor: { timesSlower: 4 },
    goals: { matrixMs: 0.35, heardMs: 0.7, liveMs: 0.7 },
  },
  // More times, as these are short and differ more.
  { name: "fast line", times: 3, goals: { heardMs: 1.1, liveMs: 1.1 } },
];

/** As long as the text of the opening, so that nothing moves; its matrix is that of 60° about z. */
const typed = {
  text: "cos(pi/6) + sin(pi/6) k",
  numbers: [0.5, -0.866025, 0, 0.866025, 0.5, 0, 0, 0, 1],
};
const watched = { typed, longestMs: 25_000 };

/** What is seen, as far as the engine tells it: a ratio, or what this tree may have at most. */
const measures = [
  { of: "paintMs", words: "first paint, ms" },
  { of: "matrixMs", words: "first matrix, ms" },
  { of: "heardMs", words: "live: typing is heard, ms" },
  { of: "liveMs", words: "live: typing is answered, ms" },
  { of: "matrixBytes", words: "bytes to the first matrix" },
  { of: "liveBytes", words: "bytes to live" },
  { of: "allBytes", words: "bytes in all" },
  { of: "shift", words: "layout shift", most: 0 },
  { of: "lost", words: "typed text lost", most: 0 },
];

await main(async () => {
  const { runs, encoding, throttle } = chosen();
  if (!exists("dist", "page")) throw new Stop("there is no page yet: npm start builds it");
  const folders = { before: await baseline(), now: root };
  warnOfOtherWork();
  const columns = [];
  for (const name of await setUpEngines()) {
    const engine = await startEngine(name);
    const answers = answersFor(engine, folders, encoding);
    const isThrottling = engine.throttles && throttle === "browser";
    for (const line of lines.filter(({ processor }) => isThrottling || !processor)) {
      const title = `${name}, ${line.name}`;
      say(title);
      const visit = async (page) => {
        const site = await serve(answers[page], isThrottling ? undefined : line.network);
        const seen = await engine.load(site.address, { watched, line: isThrottling ? line : {} });
        site.close();
        return seen;
      };
      const pairs = await pairsOf(runs * (line.times ?? 1), visit);
      if (pairs === undefined) {
        say(`${title} is left out: what was typed had no answer, or the page did not come`);
        continue;
      }
      const results = resultsOf(pairs, line.goals);
      console.log(`\n${tableOf(["", BASELINE, "this tree", "ratio", "goal"], rowsOf(results))}\n`);
      columns.push({ title, results });
    }
    await engine.close();
  }
  const head = [`this tree / ${BASELINE}`, ...columns.map(({ title }) => title)];
  console.log(tableOf(head, keptRows(columns)));
});

function warnOfOtherWork() {
  const [waiting] = loadavg();
  if (waiting <= availableParallelism()) return;
  say("this machine is busy with other things: only large differences mean something");
}

function chosen() {
  const text = (value) => ({ type: "string", default: value });
  const options = { runs: text("7"), encoding: text("gzip"), throttle: text("browser") };
  try {
    const { values } = parseArgs({ options });
    const isOneOf = (value, ...all) => {
      if (!all.includes(value)) throw new Stop(`${value} is none of ${all.join(", ")}`);
    };
    isOneOf(values.encoding, ...Object.keys(encodings));
    isOneOf(values.throttle, "browser", "server");
    if (!/^[1-9]\d?$/.test(values.runs)) throw new Stop(`--runs takes 1 to 99, not ${values.runs}`);
    return { ...values, runs: Number(values.runs) };
  } catch (error) {
    throw error instanceof Stop ? error : new Stop(error.message);
  }
}

/** Of both pages; the script that watches comes with them where the browser has no way for it. */
function answersFor({ throttles }, folders, encoding) {
  const prelude = throttles ? undefined : `(${watch})(${JSON.stringify(watched)})`;
  const of = (folder) => answersOf(join(folder, "dist", "page"), encoding, prelude);
  return { before: of(folders.before), now: of(folders.now) };
}

/**
 * What was seen of both pages: before, now, now, before, and so on; the first pair is thrown away. Nothing
 * where one was never live: WebKit takes brotli only over HTTPS.
 */
async function pairsOf(runs, visit) {
  const pairs = [];
  for (let run = 0; run <= runs; run += 1) {
    const order = run % 2 === 0 ? ["before", "now"] : ["now", "before"];
    const pair = {};
    for (const page of order) {
      pair[page] = await visit(page);
      if (pair[page].liveMs === undefined) return undefined;
    }
    pairs.push(pair);
  }
  return pairs.slice(1);
}

/** What was measured, and what of it is kept: the ratio, or the most, and what became of the goal. */
function resultsOf(pairs, goals) {
  const isMeasured = ({ of }) => pairs[0].now[of] !== undefined;
  return measures.filter(isMeasured).map(({ of, words, most }) => {
    const before = spread(pairs.map(({ before }) => before[of]));
    const now = spread(pairs.map(({ now }) => now[of]));
    // Of each pair: what else the machine does slows both of them.
    const ratio = spread(pairs.map(({ before, now }) => now[of] / before[of]));
    const isRatio = most === undefined;
    const [value, goal] = isRatio ? [ratio.median, goals[of]] : [now.most, most];
    const outcome = goal === undefined ? "" : `${goal} ${value <= goal ? "met" : "missed"}`;
    return { words, before, now, ratio, isRatio, value, outcome };
  });
}

function rowsOf(results) {
  return results.map(({ words, before, now, ratio, isRatio, outcome }) => {
    const digits = isRatio ? 0 : 4;
    return [words, told(before, digits), told(now, digits), isRatio ? told(ratio, 2) : "", outcome];
  });
}

/** A row for each measure, with a cell for each engine and line. */
function keptRows(columns) {
  const keptOf = ({ value, isRatio, outcome }) => {
    const kept = isRatio ? value.toFixed(2) : String(value);
    return outcome === "" ? kept : `${kept} (${outcome})`;
  };
  return measures.map(({ words }) => {
    const found = columns.map(({ results }) => results.find((result) => result.words === words));
    return [words.replace(", ms", ""), ...found.map((result) => (result ? keptOf(result) : ""))];
  });
}

function spread(numbers) {
  const sorted = numbers.toSorted((one, other) => one - other);
  return { median: sorted[Math.floor(sorted.length / 2)], least: sorted[0], most: sorted.at(-1) };
}

function told({ median, least, most }, digits) {
  const [middle, from, to] = [median, least, most].map((number) => number.toFixed(digits));
  return from === to ? middle : `${middle} (${from} to ${to})`;
}

/** A table of Markdown that can be read as it is. */
function tableOf(head, rows) {
  const all = [head, ...rows];
  const widths = head.map((_, column) => Math.max(...all.map((cells) => cells[column].length)));
  const [first, ...others] = all.map((cells) =>
    cells.map((cell, column) => cell.padEnd(widths[column])),
  );
  const bars = widths.map((width) => "-".repeat(Math.max(3, width)));
  return [first, bars, ...others].map((cells) => `| ${cells.join(" | ")} |`).join("\n");
}
