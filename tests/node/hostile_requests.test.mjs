// Requests of any shape: a TypeError with words, or what the request itself threw, and the next good
// request is answered. Nothing that is asked stops the package for those who ask after it.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { test } from "node:test";
import { setFlagsFromString } from "node:v8";

// The engine of Node 20 stops, with "unreachable code", where a script whose calls of wasm it has inlined is no
// longer valid when such a call returns; thousands of requests of all shapes bring that about.
if (process.versions.node.startsWith("20.")) setFlagsFromString("--no-turbo-inline-js-wasm-calls");

/** Every instance of the wasm, the newest last. */
const instances = [];
globalThis.WebAssembly.Instance = class extends WebAssembly.Instance {
  constructor(...given) {
    super(...given);
    instances.push(this);
  }
};
const quatlas = createRequire(import.meta.url)("../../dist/npm/quatlas.js");
const { analyze, HAMILTON, identify, JPL, libraries, translate } = quatlas;

const library = (id) => ({ kind: "library", id });

/** One good request of each kind, with every member that it may have. */
const good = {
  read: () => ({
    view: "read",
    quaternion: "0 0 0.6 0.8",
    vector: "1 0 0",
    convention: { ...JPL },
    matrix: { function: "passive", direction: "body-to-world" },
    euler: { axes: "zyx", frame: "intrinsic" },
  }),
  compose: () => ({
    view: "compose",
    p: "1 0 0 0",
    q: "0.8 0 0 0.6",
    vector: "1 0 0",
    convention: { ...HAMILTON },
    matrix: { function: "active", direction: "world-to-body" },
  }),
  translate: () => ({
    view: "translate",
    quaternion: "0 0 0.6 0.8",
    from: { ...library("openvins"), order: "scalar-last", direction: "world-to-body" },
    to: { kind: "convention", convention: { ...HAMILTON } },
    worldAxes: "",
    bodyAxes: "",
  }),
  identify: () => ({
    view: "identify",
    observations: [
      { probe: "components", quaternion: "1 2 3 4", printed: "" },
      { probe: "product", a: "0 1 0 0", b: "0 0 1 0", printed: "0 0 0 -1" },
      { probe: "rotate", quaternion: "1 0 0 0", vector: "1 2 3", printed: "" },
      { probe: "matrix", quaternion: "1 0 0 0", layout: "rows", printed: "" },
      { probe: "from-matrix", matrix: "1 0 0 0 1 0 0 0 1", layout: "columns", printed: "" },
      { probe: "quarter-turn", printed: "" },
      { probe: "perturb", quaternion: "1 0 0 0", rotationVector: "0.1 0 0", printed: "" },
    ],
    name: "mine",
    language: "rust",
    unavailable: ["matrix"],
  }),
  numbers: () => ({
    view: "numbers",
    // Of names, beside which there need be no attitude.
    numbers: "(w, -x, -y, -z)",
    quaternion: "0.8 0 0 0.6",
    convention: { ...HAMILTON },
    matrix: { function: "passive", direction: "body-to-world" },
  }),
  matrices: () => ({
    view: "matrices",
    yawed: "0 -1 0 1 0 0 0 0 1",
    a: "1 0 0 0 1 0 0 0 1",
    b: "1 0 0 0 1 0 0 0 1",
    product: "1 0 0 0 1 0 0 0 1",
    matrix: "0 -1 0 1 0 0 0 0 1",
    rotationVector: "0.01 0 0",
    printed: "0 -0.99995 0.0099998 1 0 0 0 0.0099998 0.99995",
  }),
  between: () => ({
    view: "between",
    p: "1 0 0 0",
    q: "0.8 0 0 0.6",
    convention: { ...HAMILTON },
    matrix: { function: "passive", direction: "body-to-world" },
    euler: { axes: "zyx", frame: "intrinsic" },
    part: "0.5",
    duration: "0.25 s",
  }),
  chain: () => ({
    view: "chain",
    factors: [{ text: "0.8 0 0 0.6", inverse: true }],
    convention: { ...HAMILTON },
    matrix: { function: "passive", direction: "body-to-world" },
    euler: { axes: "zyx", frame: "intrinsic" },
  }),
  motion: () => ({
    view: "motion",
    quaternion: "0.8 0 0 0.6",
    convention: { ...HAMILTON },
    matrix: { function: "passive", direction: "body-to-world" },
    euler: { axes: "zyx", frame: "intrinsic" },
    rate: "0.1 0.2 0.3",
    rateEnd: "0.2 0.1 0 rad/s",
    rateAxes: "world",
    duration: "2 s",
    steps: 4,
    increment: "0.01 0 0",
    incrementSign: "formal",
    covariance: "1 4 9",
    point: "1 2 3",
  }),
  frames: () => ({
    view: "frames",
    poses: [
      { parent: "G", child: "I", rotation: "0.8 0 0 0.6", position: "1 2 3" },
      { parent: "I", child: "C", rotation: "1 0 0 0", position: "" },
    ],
    child: "C",
    parent: "G",
    point: "",
    convention: { ...HAMILTON },
    matrix: { function: "passive", direction: "body-to-world" },
    euler: { axes: "zyx", frame: "intrinsic" },
  }),
  atlas: () => ({
    view: "atlas",
    quaternion: "0 0 0.6 0.8",
    convention: { ...JPL },
    matrix: { function: "passive", direction: "body-to-world" },
  }),
  "swing-twist": () => ({
    view: "swing-twist",
    quaternion: "0.8 0 0 0.6",
    axis: "0 0 1",
    convention: { ...HAMILTON },
    matrix: { function: "passive", direction: "body-to-world" },
  }),
};

function checkGoodCall() {
  const { to } = translate({
    quaternion: "0 0 0.6 0.8",
    from: library("openvins"),
    to: library("scipy-scalar-first"),
  });
  assert.deepEqual(to.array, [0.8, 0, 0, 0.6]);
}

/** That a request is refused with these words, and that nothing is left of it. */
function checkRefused(request, message, what) {
  const made = instances.length;
  assert.throws(() => analyze(request), { name: "TypeError", message }, what);
  checkGoodCall();
  assert.equal(instances.length, made, `${what}: a refusal is no trap`);
}

/** Every object in a value with its path, the value itself first. */
function* objectsIn(value, path = "") {
  if (typeof value !== "object" || value === null) return;
  yield { object: value, path };
  for (const [name, member] of Object.entries(value)) {
    const step = Array.isArray(value) ? `[${name}]` : `${path === "" ? "" : "."}${name}`;
    yield* objectsIn(member, path + step);
  }
}

const views = Object.keys(good);
const nested = (levels) => JSON.parse("[".repeat(levels) + "]".repeat(levels));

test("every good request is answered", () => {
  for (const view of views) assert.equal(analyze(good[view]()).status, view);
});

test("an unknown member is named wherever it stands, whatever it holds", () => {
  const cycle = {};
  cycle.self = cycle;
  const values = [cycle, nested(100_000), 1, null, () => 1, Symbol("s"), 1n, new Proxy({}, {})];
  let checked = 0;
  for (const view of views) {
    const count = [...objectsIn(good[view]())].length;
    for (let at = 0; at < count; at += 1) {
      for (const value of values) {
        const request = good[view]();
        const { object, path } = [...objectsIn(request)][at];
        if (Array.isArray(object)) continue;
        object.nonsense = value;
        checkRefused(request, /has no member `nonsense`$/, `${view} ${path}`);
        object.nonsense = undefined;
        assert.equal(analyze(request).status, view, "undefined is absent");
        checked += 1;
      }
    }
  }
  assert.ok(checked > 100, `${checked}`);
});

test("a request that leads back to itself, and a member that is endlessly deep", () => {
  const eigen = library("eigen");
  eigen.self = eigen;
  const request = { view: "translate", quaternion: "0 0 0 1", from: eigen, to: eigen };
  checkRefused(request, /`from` has no member `self`/, "a cycle");
  for (const deep of [nested(6000), nested(100_000)]) {
    for (const member of ["kind", "id", "order", "direction"]) {
      const from = { ...library("eigen"), [member]: deep };
      const words = /`from\.(kind|id|order|direction)` is an object, not a text$/;
      checkRefused({ ...request, from, to: library("eigen") }, words, member);
    }
    checkRefused({ ...good.read(), convention: deep }, /convention/, "convention");
    checkRefused({ ...good.identify(), observations: deep }, /observations\[0\]/, "observations");
    checkRefused(deep, /it has no member `0`/, "the request");
  }
});

test("a value of another type is named at every member", () => {
  const wrong = [0, true, {}, [], () => "", Symbol("s"), 1n, new String("1"), null, NaN];
  let checked = 0;
  for (const view of views) {
    const paths = [...objectsIn(good[view]())];
    for (const [at, { object }] of paths.entries()) {
      for (const name of Object.keys(object)) {
        for (const value of wrong) {
          const request = good[view]();
          const place = [...objectsIn(request)][at].object;
          // These are right: null as JSON has it, an empty list, any object in place of none.
          if (value === null && /^(order|direction)$/.test(name) && place.kind === "library")
            continue;
          if (Array.isArray(value) && /^(observations|unavailable|poses)$/.test(name)) continue;
          if (value === true && name === "inverse") continue;
          // Numbers stand in place of every text that is not a name.
          const isName = /^(view|probe|id|kind|name|language|layout|parent|child|.+Axes)$/.test(
            name,
          );
          const isText = typeof place[name] === "string" && !isName && !("order" in place);
          if (isText && (typeof value === "number" || Array.isArray(value))) continue;
          place[name] = value;
          const isNumber = name === "steps" && typeof value === "number";
          const isNamed = isNumber || (typeof value === "object" && value !== null);
          const words = isNamed ? /`/ : /` is (a|null)/;
          checkRefused(request, words, `${view}.${name} ${String(value)}`);
          checked += 1;
        }
      }
    }
  }
  assert.ok(checked > 300, `${checked}`);
});

test("a member that is missing is named, unless it may be", () => {
  const optional =
    /^(matrix|euler|worldAxes|bodyAxes|order|direction|name|language|unavailable|layout|part|inverse)$/;
  const optionalIn = {
    numbers: /^quaternion$/,
    matrices: /^(?!view$)/,
    frames: /^(point|position)$/,
    between: /^duration$/,
    motion: /^(rate|rateEnd|rateAxes|duration|steps|increment|incrementSign|covariance|point)$/,
  };
  for (const view of views) {
    for (const [at, { object, path }] of [...objectsIn(good[view]())].entries()) {
      for (const name of Array.isArray(object) ? [] : Object.keys(object)) {
        const request = good[view]();
        delete [...objectsIn(request)][at].object[name];
        const isOptional =
          optionalIn[view]?.test(name) ||
          (optional.test(name) && !/convention$|^matrix$|^euler$/.test(path));
        if (isOptional && !(name === "matrix" && path !== "")) {
          assert.equal(analyze(request).status, view, `${view} ${path} ${name}`);
        } else {
          checkRefused(request, new RegExp(`${name}\` is missing$`), `${view} ${path} ${name}`);
        }
      }
    }
  }
});

test("a misspelt member tells the one that is meant", () => {
  const ends = { quaternion: "0 0 0 1", from: library("eigen"), to: library("eigen") };
  const misspelt = (message, request) => assert.throws(request, { name: "TypeError", message });
  misspelt(/`world_axes` \(is `worldAxes` meant\?\)/, () =>
    translate({ ...ends, world_axes: "NED to ENU" }),
  );
  misspelt(/`matrx` \(is `matrix` meant\?\)/, () => analyze({ ...good.read(), matrx: {} }));
  misspelt(/`eulerSequence` \(is `euler` meant\?\)/, () =>
    analyze({ ...good.read(), eulerSequence: {} }),
  );
  misspelt(/`from` has no member `diretcion` \(is `direction` meant\?\)/, () =>
    translate({ ...ends, from: { ...ends.from, diretcion: "body-to-world" } }),
  );
  misspelt(/it has no member `veiw` \(is `view` meant\?\)/, () => analyze({ veiw: "read" }));
  misspelt(/`observations\[0\]` has no member `prob` \(is `probe` meant\?\)/, () =>
    identify({ observations: [{ prob: "product" }] }),
  );
  misspelt(/`one`, `two`, `three`$/, () =>
    identify({ observations: [], one: 1, two: 2, three: 3, four: 4 }),
  );
  misspelt(new RegExp(`\`${"x".repeat(40)}…\`$`), () =>
    identify({ observations: [], ["x".repeat(1e7)]: 1 }),
  );
});

test("a choice that there is not tells those that there are", () => {
  assert.throws(() => identify({ observations: [], language: "cobol" }), {
    message: /`language` cannot be `cobol`, but one of `c`, `cpp`, `csharp`,/,
  });
  const convention = { ...JPL, order: "wxyz" };
  assert.throws(() => analyze({ ...good.read(), convention }), {
    message: /`convention\.order` cannot be `wxyz`, but one of `scalar-first`, `scalar-last`$/,
  });
});

test("no request at all is said to be none", () => {
  for (const ask of [analyze, translate, identify]) {
    assert.throws(() => ask(undefined), {
      message: /^this is not a request: it is undefined, not/,
    });
    assert.throws(() => ask(null), { message: /it is null, not an object$/ });
    assert.throws(() => ask("1 0 0 0"), { message: /it is a string, not an object$/ });
  }
});

test("translate and identify answer nothing else", () => {
  assert.throws(() => translate(good.read()), {
    name: "TypeError",
    message: /its `view` is `read`, and translate was asked$/,
  });
  assert.throws(() => identify(good.translate()), { message: /identify was asked$/ });
  assert.equal(translate(good.translate()).status, "translate");
  const { view: _, ...unnamed } = good.translate();
  assert.deepEqual(translate(unnamed), translate(good.translate()));
  assert.equal(identify(good.identify()).observations.length, 7);
});

test("what a getter or a proxy throws is passed on, however often", () => {
  const own = [new RangeError("mine"), new WebAssembly.RuntimeError("mine"), "mine", undefined];
  const thrower = (thrown) => () => {
    throw thrown;
  };
  const thrown = (run) => {
    try {
      run();
    } catch (error) {
      return [error];
    }
    return [];
  };
  const traps = ["get", "ownKeys"];
  for (const error of own) {
    for (const view of views) {
      const count = [...objectsIn(good[view]())].length;
      for (let at = 0; at < count; at += 1) {
        const request = good[view]();
        const { object } = [...objectsIn(request)][at];
        for (const name of Object.keys(object)) {
          const request = good[view]();
          const { object } = [...objectsIn(request)][at];
          Object.defineProperty(object, name, { get: thrower(error), enumerable: true });
          assert.deepEqual(
            thrown(() => analyze(request)),
            [error],
            `${view} ${name}`,
          );
        }
        for (const trap of traps) {
          const whole = { request: good[view]() };
          for (const { object: parent } of [...objectsIn(whole)]) {
            for (const [name, member] of Object.entries(parent)) {
              if (typeof member !== "object" || Array.isArray(member)) continue;
              parent[name] = new Proxy(member, { [trap]: thrower(error) });
              assert.deepEqual(
                thrown(() => analyze(whole.request)),
                [error],
                `${view} ${trap}`,
              );
              parent[name] = member;
            }
          }
        }
      }
    }
    checkGoodCall();
  }
  assert.equal(instances.length, 1);
  const { proxy, revoke } = Proxy.revocable([], {});
  revoke();
  checkRefused({ ...good.identify(), observations: proxy }, /revoked/, "a revoked proxy");
});

test("every member is read once", () => {
  for (const view of views) {
    const reads = new Map();
    const watched = (value, path) => {
      if (typeof value !== "object") return value;
      return new Proxy(value, {
        get(target, name) {
          const at = `${path}.${String(name)}`;
          reads.set(at, (reads.get(at) ?? 0) + 1);
          return watched(target[name], at);
        },
      });
    };
    assert.equal(analyze(watched(good[view](), view)).status, view);
    assert.deepEqual(
      [...reads].filter(([, count]) => count > 1),
      [],
    );
    assert.ok(reads.size > 5);
  }
});

test("lists of any length", () => {
  const observations = (list) => ({ ...good.identify(), observations: list });
  checkRefused(observations(new Array(2 ** 32 - 1)), /at most 10000 are read$/, "a long list");
  checkRefused(observations(new Array(3)), /`observations\[0\]` is missing$/, "a hole");
  const one = { probe: "quarter-turn", printed: "" };
  checkRefused(observations(new Array(1e6).fill(one)), /has 1000000 elements/, "a million");
  for (const length of [Infinity, -1, NaN, "7", 2 ** 53]) {
    const list = new Proxy([one], {
      get: (target, name) => (name === "length" ? length : target[name]),
    });
    try {
      identify({ observations: list });
    } catch (error) {
      assert.equal(error.name, "TypeError", `${length}`);
    }
    checkGoodCall();
  }
  for (const list of [new Set([one]), { length: 1, 0: one }, "observations"]) {
    checkRefused(observations(list), /`observations` is .*, not a list$/, "no list");
  }
  assert.equal(identify({ observations: new Array(100).fill(one) }).observations.length, 100);
  assert.equal(instances.length, 1);
});

test("after a trap the instance is made anew, and nothing is permanent", () => {
  assert.equal(instances.length, 1);
  const stopped = [];
  // At the end of the stack the core stops in its midst, at another place with every step back.
  const dive = () => {
    try {
      dive();
    } catch {}
    if (stopped.length >= 20) return;
    try {
      checkGoodCall();
    } catch (error) {
      if (/mistake in quatlas, please report/.test(error.message)) stopped.push(error);
    }
  };
  dive();
  assert.ok(stopped.length > 0);
  assert.ok(stopped[0].cause instanceof Error);
  checkGoodCall();
  const made = instances.length;
  assert.ok(made > 1);
  for (const view of views) assert.equal(analyze(good[view]()).status, view);
  assert.equal(instances.length, made, "once is enough");
});

test("a getter may ask something itself, also without end", () => {
  const id = () => translate(good.translate()).from.library;
  const from = Object.defineProperty({ kind: "library" }, "id", { get: id, enumerable: true });
  const asked = { quaternion: "0 0 0.6 0.8", from, to: library("eigen") };
  assert.equal(translate(asked).from.library, "openvins");
  const endless = { kind: "library" };
  const again = () => translate({ ...asked, from: endless }).status;
  Object.defineProperty(endless, "id", { get: again, enumerable: true });
  assert.throws(() => translate({ ...asked, from: endless }), Error);
  checkGoodCall();
});

test("a huge text is measured, and the memory of the wasm stays as it is", () => {
  const bytes = () => instances.at(-1).exports.memory.buffer.byteLength;
  // All of it: of so long a text not even the spaces are looked at.
  const span = (text) => ({ start: 0, end: text.length });
  const check = (text, problem, what, most = 131072) => {
    assert.equal(problem.code, "text-too-long", what);
    const length = Buffer.byteLength(text);
    assert.equal(problem.message, `the text has ${length} bytes; at most ${most} are read`, what);
    assert.deepEqual(problem.span, span(text), what);
  };
  // Of these the core itself says so: they are short enough to be copied.
  const inCore = [`  ${"é".repeat(80_000)} `, "🙂".repeat(40_000), "1 ".repeat(65_537).trimEnd()];
  const before = bytes();
  const measured = [
    ` ${" 1 0 0 0 ".repeat(1e6)}\n`,
    `${"🙂 ".repeat(70_000)}`,
    `x${"🙂".repeat(70_000)}`,
    `${" ".repeat(200_000)}\ud800 1${" ".repeat(200_000)}`,
  ];
  for (const text of [...inCore, ...measured]) {
    const what = text.slice(0, 20);
    const read = analyze({ ...good.read(), quaternion: text, vector: text });
    for (const problem of read.problems) check(text, problem, what);
    assert.equal(read.problems.length, 2);
    const composed = analyze({ ...good.compose(), p: text, q: text, vector: text });
    for (const problem of composed.problems) check(text, problem, what);
    const axes = { worldAxes: text, bodyAxes: text };
    const translated = translate({ ...good.translate(), quaternion: text, ...axes });
    assert.deepEqual(
      translated.problems.map(({ field }) => field),
      ["quaternion", "world-axes", "body-axes"],
    );
    for (const problem of translated.problems) check(text, problem, what);
    const probe = { probe: "product", a: text, b: "1 0 0 0", printed: "1 0 0 0" };
    const [{ problem }] = identify({ observations: [probe] }).observations;
    check(text, problem, what, 4096);
    const { problems } = translate({ ...good.translate(), from: library(text) });
    assert.deepEqual([problems[0].code, problems[0].span], ["unknown-library", span(text)], what);
  }
  const spaces = " ".repeat(1e6);
  const [{ span: place }] = analyze({ ...good.read(), quaternion: spaces }).problems;
  assert.deepEqual(place, { start: 0, end: 1e6 });
  checkRefused({ ...good.read(), view: "x".repeat(1e7) }, /cannot be `x{40}…`/, "a huge word");
  assert.ok(bytes() - before < 4e6, `${before} to ${bytes()} bytes`);
  const probe = { probe: "quarter-turn", printed: "1".repeat(60_000) };
  const many = { ...good.identify(), observations: new Array(1000).fill(probe) };
  assert.throws(() => analyze(many), {
    name: "TypeError",
    message: /texts together are too long$/,
  });
  checkGoodCall();
});

test("what the package exports cannot be changed, however deep", () => {
  let checked = 0;
  for (const value of [libraries, HAMILTON, JPL]) {
    for (const { object, path } of objectsIn(value)) {
      assert.ok(Object.isFrozen(object), path);
      checked += 1;
    }
  }
  assert.ok(checked > 400, `${checked}`);
  assert.throws(() => {
    libraries[0].id = "x";
  }, TypeError);
});
