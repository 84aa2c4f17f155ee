// The built package as a user has it: packed, unpacked into a project, imported and required.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { gzipSync, inflateRawSync } from "node:zlib";

const root = fileURLToPath(new URL("../..", import.meta.url));
const project = mkdtempSync(join(tmpdir(), "quatlas-"));
const installed = join(project, "node_modules", "quatlas");
let quatlas;
let required;
let packedBytes;

before(async () => {
  // --ignore-scripts: it has just been built, and a package must install without scripts.
  const [{ filename, files, size }] = JSON.parse(
    execFileSync("npm", ["pack", "--json", "--ignore-scripts", "--pack-destination", project], {
      cwd: root,
      encoding: "utf8",
      shell: process.platform === "win32",
    }),
  );
  assert.ok(files.length > 0);
  packedBytes = size;
  mkdirSync(installed, { recursive: true });
  execFileSync("tar", ["-xzf", join(project, filename), "-C", installed, "--strip-components=1"]);
  const require = createRequire(join(project, "index.cjs"));
  required = require("quatlas");
  // An import from inside the project, so that Node resolves the package by its name.
  cpSync(join(root, "tests", "node", "reexport.mjs"), join(project, "reexport.mjs"));
  quatlas = await import(pathToFileURL(join(project, "reexport.mjs")).href);
});

after(() => rmSync(project, { recursive: true, force: true }));

test("import and require give the same instance", () => {
  assert.deepEqual(Object.keys(quatlas).sort(), [
    "HAMILTON",
    "HAMILTON_SCALAR_LAST",
    "JPL",
    "JPL_BODY_TO_WORLD",
    "MY_LAB",
    "Pose",
    "QuatlasError",
    "Rotation",
    "TaggedQuaternion",
    "analyze",
    "atlas",
    "between",
    "chain",
    "compose",
    "frames",
    "identify",
    "identifyMatrices",
    "identifyNumbers",
    "libraries",
    "motion",
    "rateMatrix",
    "read",
    "swingTwist",
    "translate",
  ]);
  assert.equal(quatlas.analyze, required.analyze);
  assert.equal(quatlas.JPL, required.JPL);
});

test("the package leaves nothing behind in the global object that is seen", () => {
  const named = "console.log(Object.keys(globalThis).join())";
  const run = (program) => execFileSync(process.execPath, ["-e", program], { cwd: project });
  assert.deepEqual(run(`require("quatlas"); ${named}`), run(named));
});

test("every link and picture of the README leads somewhere from where the package is read", () => {
  const manifest = JSON.parse(readFileSync(join(installed, "package.json"), "utf8"));
  const readme = readFileSync(join(installed, "README.md"), "utf8");
  const targets = [...readme.matchAll(/\]\(([^)\s]+)\)|(?:src|href)="([^"]+)"/g)].map(
    ([, markdown, html]) => markdown ?? html,
  );
  assert.ok(targets.length > 10, `${targets}`);
  const isOutside = (target) => /^(?:https?:|mailto:|#)/.test(target);
  // A registry completes what is relative by the repository that the package names, and by nothing else.
  const missing = targets.filter(
    (target) =>
      !isOutside(target) && !existsSync(join(manifest.repository ? root : installed, target)),
  );
  assert.deepEqual(missing, []);
});

test("the entry of numbers is not larger than it may be", () => {
  const { length } = gzipSync(readFileSync(join(installed, "dist/npm/quatlas_rotation.js")));
  // 30 kB were wanted, and are not reached.
  assert.ok(length <= 40_000, `${length}`);
});

test("the tarball is not larger than it may be", () => {
  assert.ok(packedBytes <= 1_000_000, `${packedBytes}`);
});

test("the package has types, no install scripts and no dependencies", () => {
  const manifest = JSON.parse(readFileSync(join(installed, "package.json"), "utf8"));
  assert.equal(manifest.dependencies, undefined);
  for (const script of ["preinstall", "install", "postinstall", "prepare"]) {
    assert.equal(manifest.scripts[script], undefined, script);
  }
  assert.equal(manifest.types, manifest.exports["."].require.types);
  for (const { types } of [manifest.exports["."].import, manifest.exports["."].require]) {
    const text = readFileSync(join(installed, types), "utf8");
    assert.match(text, /export declare function analyze\(request: Request\): Outcome;/);
    assert.match(text, /export interface ReadReport/);
    assert.doesNotMatch(text, /pkg\/quatlas|\[`/);
  }
});

test("the types are whole, for import and for require, and refuse what is wrong", () => {
  const program = `import { analyze, identify, identifyMatrices, identifyNumbers, JPL, libraries, type Outcome, translate } from "quatlas";
    const request = { view: "read", quaternion: "1 0 0 0", vector: "1 0 0" } as const;
    const outcome: Outcome = analyze({ ...request, convention: JPL });
    if (outcome.status === "read") {
      const entry: number = outcome.jpl.matrix[2][0];
      // @ts-expect-error: a row has three numbers
      console.log(entry, outcome.jpl.matrix[0][3]);
    }
    // @ts-expect-error: the convention is missing
    analyze(request);
    const from = { kind: "library", id: libraries[0].id } as const;
    const translated = translate({ quaternion: "1 0 0 0", from, to: { kind: "convention", convention: JPL } });
    if (translated.status === "translate") console.log(translated.to.array satisfies number[]);
    const { next } = identify({ observations: [{ probe: "quarter-turn", printed: "" }] });
    console.log(next?.code satisfies string | undefined);
    const told = identifyNumbers({ numbers: "30 20 10", quaternion: "1 0 0 0", convention: JPL });
    if (told.status === "numbers") {
      const { meaning } = told.readings[0];
      if (meaning.kind === "euler-angles") console.log(meaning.turnsAbout satisfies string[]);
      // @ts-expect-error: not every meaning has a scale
      console.log(meaning.scale);
    }
    const matrices = identifyMatrices({ yawed: "0 -1 0 1 0 0 0 0 1" });
    if (matrices.status === "matrices") console.log(matrices.operator satisfies string | undefined);
    // @ts-expect-error: no such probe
    identify({ observations: [{ probe: "half-turn", printed: "" }] });
  `;
  for (const name of ["typed.mts", "typed.cts"]) writeFileSync(join(project, name), program);
  const tsc = join(root, "node_modules", "typescript", "bin", "tsc");
  const options = [
    "--noEmit",
    "--strict",
    "--module",
    "nodenext",
    "--types",
    "",
    "--lib",
    "es2023,dom",
  ];
  execFileSync(process.execPath, [tsc, ...options, "typed.mts", "typed.cts"], {
    cwd: project,
    stdio: "inherit",
  });
});

test("the wasm inside is the optimised file", () => {
  const optimised = readFileSync(join(root, "pkg", "quatlas_bg.wasm"));
  const script = readFileSync(join(installed, "dist/npm/quatlas.js"), "utf8");
  const inside = script.match(/["`]([A-Za-z0-9+/=]{100000,})["`]/)[1];
  assert.deepEqual(inflateRawSync(Buffer.from(inside, "base64")), optimised);
  assert.deepEqual(readFileSync(join(installed, "dist/npm/quatlas_bg.wasm")), optimised);
  const target = process.env.CARGO_TARGET_DIR ?? join(root, "target");
  const built = join(target, "wasm32-unknown-unknown/release/quatlas.wasm");
  assert.ok(optimised.length < readFileSync(built).length / 2, "smaller than what rustc wrote");
});

test("a quarter turn about z, from the numbers of a JPL filter", () => {
  const outcome = quatlas.analyze({
    view: "read",
    quaternion: "0 0 1/√2 1/√2",
    vector: "1 0 0",
    convention: quatlas.JPL,
  });
  assert.equal(outcome.status, "read");
  // The world's x axis lies along the body's −y; the body's x axis along the world's y.
  assert.deepEqual(outcome.jpl.image, [0, -1, 0]);
  assert.deepEqual(outcome.hamilton.image, [0, 1, 0]);
});

test("the examples of the README run as they are printed", async () => {
  const readme = readFileSync(join(root, "README.md"), "utf8");
  const examples = [...readme.matchAll(/```js\n(.*?)```/gs)];
  assert.equal(examples.length, 5);
  for (const [, example] of examples) {
    const file = join(project, "example.mjs");
    writeFileSync(file, example);
    execFileSync(process.execPath, [file], { cwd: project });
  }
});

test("from a JPL filter to SciPy: the scalar moves and nothing is conjugated", () => {
  const end = (id) => ({ kind: "library", id });
  const translated = quatlas.translate({
    quaternion: "0 0 0.6 0.8",
    from: end("openvins"),
    to: end("scipy-scalar-first"),
  });
  assert.equal(translated.status, "translate");
  assert.equal(translated.change, "reordered");
  assert.deepEqual(translated.to.array, [0.8, 0, 0, 0.6]);
  const problem = quatlas.translate({ quaternion: "🙂 oops", from: end("eigen"), to: end("tf3") });
  assert.equal(problem.status, "problems");
  assert.equal(problem.problems[0].code, "unknown-library");
});

test("a library is told from what it printed, and problems stay at their observations", () => {
  const product = (printed) => ({ probe: "product", a: "0 1 0 0", b: "0 0 1 0", printed });
  const report = quatlas.identify({ observations: [product("0 0 0 -1")], language: "rust" });
  assert.deepEqual(report.settled, ["constructor", "array", "handedness"]);
  assert.deepEqual(report.remaining.handedness, ["left"]);
  assert.equal(report.next.probe.probe, "rotate");
  assert.match(report.next.code, /^println!\("\{:\?\}", Quaternion::new\(0\.5, /);
  assert.ok(report.libraries.some(({ id }) => id === "panda3d"));
  const [observation] = quatlas.identify({ observations: [product("🙂 oops")] }).observations;
  assert.equal(observation.status, "problem");
  // The emoji takes two UTF-16 units.
  assert.equal(observation.problem.span.end, 2);
});

test("a small turn with the formal sign is told by the quarter turn", () => {
  const half = "w: 0.5, x: 0.5, y: 0.5, z: 0.5";
  // The exponential of φ on the left of the numbers as they stand.
  const printed = "w: 0.474385, x: 0.524365, y: 0.474385, z: 0.524365";
  const small = { probe: "perturb", quaternion: half, rotationVector: "0.1 0 0", printed };
  const yawed = { probe: "quarter-turn", printed: "w: 0.7071, x: 0, y: 0, z: -0.7071" };
  const alone = quatlas.identify({ observations: [small] });
  assert.deepEqual(alone.settled, []);
  assert.deepEqual(alone.remaining.incrementSign, ["physical", "formal"]);
  const { settled, remaining, contradiction } = quatlas.identify({ observations: [small, yawed] });
  assert.deepEqual(settled, ["attitude", "perturbation", "incrementSign"]);
  assert.deepEqual(
    settled.map((choice) => remaining[choice]),
    [["conjugated"], ["local"], ["formal"]],
  );
  assert.equal(contradiction, undefined);
});

test("three numbers are told beside a quaternion, and nine beside a matrix", () => {
  const { HAMILTON, identifyNumbers } = quatlas;
  const quaternion = "w=0.77781 x=-0.52878 y=-0.19588 z=0.27755";
  const told = identifyNumbers({
    numbers: "314.45, 301.32, 65.83",
    quaternion,
    convention: HAMILTON,
  });
  assert.equal(told.status, "numbers");
  const [reading] = told.readings;
  assert.deepEqual([told.decides, told.fitting], [true, 1]);
  assert.deepEqual(reading.meaning, {
    kind: "euler-angles",
    sequence: { axes: "yxz", frame: "intrinsic" },
    unit: "degrees",
    turnsAbout: ["x", "y", "z"],
  });
  assert.equal(reading.direction, "body-to-world");
  assert.equal(reading.text, "YXZ 301.32 314.45 65.83 deg");
  const rewriting = identifyNumbers({ numbers: "(-q2, q1, -q4, q3)", convention: HAMILTON });
  const [{ meaning, world, body }] = rewriting.readings;
  assert.deepEqual(meaning, { kind: "quaternion", order: "scalar-first" });
  assert.deepEqual(world, { axes: "x -y -z", factor: "180deg about [1, 0, 0]" });
  assert.equal(body, undefined);
  const problem = identifyNumbers({ numbers: "🙂 1 2", quaternion, convention: HAMILTON });
  assert.equal(problem.problems[0].field, "numbers");
  // The emoji takes two UTF-16 units.
  assert.equal(problem.problems[0].span.end, 6);
});

test("a library of matrices is told from what it printed", () => {
  const { identifyMatrices } = quatlas;
  const told = identifyMatrices({
    yawed: "0 1 0 -1 0 0 0 0 1",
    matrix: "0 1 0 -1 0 0 0 0 1",
    rotationVector: "0.1 0 0",
    // Exp(−φ) on the left of R_BW: the body turned about its own x axis.
    printed: "0 1 0 -0.995004 0 0.099833 0.099833 0 0.995004",
  });
  const { operator, function: does, perturbation, incrementSign } = told;
  assert.equal(told.status, "matrices");
  assert.deepEqual([operator, does], ["world-to-body", undefined]);
  assert.deepEqual([perturbation, incrementSign], ["local", "physical"]);
  const { problems } = identifyMatrices({ product: "🙂 oops" });
  assert.deepEqual([problems[0].field, problems[0].span.end], ["product", 2]);
});

test("the table of libraries is exported, with what was printed", () => {
  const read = (name) => JSON.parse(readFileSync(join(installed, "src/library", name), "utf8"));
  assert.deepEqual(quatlas.libraries, read("libraries.json"));
  assert.ok(quatlas.libraries.length >= 60);
  const require = createRequire(join(project, "index.cjs"));
  assert.deepEqual(require("quatlas/libraries.json"), quatlas.libraries);
  const { observations } = require("quatlas/observations.json");
  const run = quatlas.libraries.filter(({ known }) => known === "run");
  assert.deepEqual(observations.map(({ id }) => id).sort(), run.map(({ id }) => id).sort());
});

test("the golden cases of one attitude in every handedness, function and direction", () => {
  const { cases } = JSON.parse(readFileSync(join(root, "tests/vectors/golden.json"), "utf8"));
  const chosen = cases.filter(({ kind }) => kind === "convention");
  assert.equal(chosen.length, 8);
  for (const { id, convention, output, input, tol } of chosen) {
    const outcome = quatlas.analyze({
      view: "read",
      quaternion: output.q_WB_wxyz.join(", "),
      vector: input.x.join(" "),
      convention: {
        order: "scalar-first",
        handedness: convention.handedness.toLowerCase(),
        function: convention.function.toLowerCase(),
        direction: convention.direction === "B2W" ? "body-to-world" : "world-to-body",
        perturbation: "local",
      },
    });
    assert.equal(outcome.status, "read", id);
    const { matrix, image } = convention.tau === 1 ? outcome.hamilton : outcome.jpl;
    close(matrix.flat(), output.S.flat(), tol, `${id} S`);
    close(image, output.S_x, tol, `${id} S x`);
  }
});

test("every bad input of the problem files is a problem with the same message", () => {
  const folder = join(root, "tests", "text", "problems");
  const files = readdirSync(folder).filter((name) => name.endsWith(".txt"));
  let compared = 0;
  for (const name of files) {
    const [upper, lower] = readFileSync(join(folder, name), "utf8").split(/---\n(?!.*---\n)/s);
    if (upper.startsWith("@")) continue;
    const quaternion = upper.replace(/\n$/, "");
    const { HAMILTON: convention } = quatlas;
    const outcome = quatlas.analyze({ view: "read", quaternion, vector: "1 0 0", convention });
    assert.equal(outcome.status, "problems", name);
    const [problem] = outcome.problems;
    assert.ok(lower.startsWith(`${problem.code}: ${problem.message}\n`), name);
    compared += 1;
  }
  assert.ok(compared > 40, `${compared} files`);
});

test("spans count UTF-16 units, as strings of JavaScript do", () => {
  const text = '{"🙂": [0, 0, oops, 1]}';
  const { problems } = quatlas.analyze({
    view: "read",
    quaternion: text,
    vector: "1 0 0",
    convention: quatlas.HAMILTON,
  });
  assert.equal(text.slice(problems[0].span.start, problems[0].span.end), "oops");
});

test("no NaN, no infinity and no -0 reaches JavaScript", () => {
  for (const quaternion of ["-1 -0 -0 0", "1e-310 0 0 0", "1.7e308 1.7e308 1.7e308 1.7e308"]) {
    for (const convention of [quatlas.HAMILTON, quatlas.JPL]) {
      const request = { quaternion, vector: "-0 1.7e308 1.7e308", convention, view: "read" };
      checkNumbers(quatlas.analyze(request), quaternion);
      const { vector } = request;
      const [from, to] = [convention, quatlas.JPL].map((of) => ({
        kind: "convention",
        convention: of,
      }));
      const axes = { worldAxes: "y x -z", bodyAxes: "z x y" };
      checkNumbers(quatlas.translate({ quaternion, from, to }), quaternion);
      checkNumbers(quatlas.translate({ quaternion, from, to, ...axes }), quaternion);
      const printed = "1e308 -1e308 1e-320 0";
      const probe = { probe: "product", a: quaternion, b: quaternion, printed };
      checkNumbers(quatlas.identify({ observations: [probe] }), quaternion);
      checkNumbers(
        quatlas.analyze({ view: "compose", p: quaternion, q: quaternion, vector, convention }),
        quaternion,
      );
    }
  }
});

test("a request that is not of its type is a TypeError that names what is wrong", () => {
  const request = { view: "read", quaternion: "1 0 0 0", vector: "1 0 0" };
  assert.throws(() => quatlas.analyze(request), { name: "TypeError", message: /convention/ });
  const convention = { ...quatlas.JPL, handedness: "both" };
  assert.throws(() => quatlas.analyze({ ...request, convention }), {
    name: "TypeError",
    message: /both/,
  });
  assert.throws(() => quatlas.analyze(undefined), {
    name: "TypeError",
    message: /it is undefined, not an object$/,
  });
  assert.throws(() => quatlas.identify({ observations: [{ probe: "oops" }] }), {
    name: "TypeError",
    message: /oops/,
  });
});

function checkNumbers(value, what) {
  if (typeof value === "number") {
    assert.ok(Number.isFinite(value) && !Object.is(value, -0), `${what}: ${value}`);
  } else if (value !== null && typeof value === "object") {
    for (const member of Object.values(value)) checkNumbers(member, what);
  }
}

function close(got, expected, tolerance, what) {
  assert.equal(got.length, expected.length, what);
  for (const [at, wanted] of expected.entries()) {
    const allowed = tolerance * Math.max(1, Math.abs(wanted));
    assert.ok(Math.abs(got[at] - wanted) <= allowed, `${what}: got ${got}, expected ${expected}`);
  }
}
