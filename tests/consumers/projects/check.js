// In every kind of script: what a consumer has of quatlas is tried, and what goes wrong in a page is its title.
// In ASCII, since the pages say no encoding.
// The numbers are known from elsewhere: quarter turns, a filter and SciPy, and angles of a game engine.
globalThis.checkQuatlas = ({ identifyNumbers, HAMILTON, JPL, libraries, read, translate }) => {
  const expect = (found, expected) => {
    const [one, other] = [JSON.stringify(found), JSON.stringify(expected)];
    if (one !== other) throw new Error(`${one} is not ${other}`);
  };
  // x y z w of a JPL filter, world to body: the body is yawed by a quarter turn.
  const yawed = read({
    quaternion: "0 0 \u221a\u00bd \u221a\u00bd",
    vector: "1 0 0",
    convention: JPL,
  });
  expect(yawed.jpl.image, [0, -1, 0]);
  expect(yawed.hamilton.image, [0, 1, 0]);
  expect(HAMILTON.order, "scalar-first");
  const library = (id) => ({ kind: "library", id });
  const [from, to] = [library("openvins"), library("scipy-scalar-first")];
  expect(translate({ quaternion: "0 0 0.6 0.8", from, to }).to.array, [0.8, 0, 0, 0.6]);
  // A text with letters beyond ASCII, in and out.
  const refused = read({ quaternion: "\u{1f642} 1 0 0", vector: "1 0 0", convention: JPL });
  expect(refused.problems[0].span, { start: 0, end: 2 });
  const { name } = libraries.find(({ id }) => id === "staubli-rxryrz");
  expect(name, "St\u00e4ubli Rx, Ry, Rz");
  const told = identifyNumbers({
    numbers: "314.45, 301.32, 65.83",
    quaternion: "w=0.77781 x=-0.52878 y=-0.19588 z=0.27755",
    convention: HAMILTON,
  });
  expect(told.readings[0].text, "YXZ 301.32 314.45 65.83 deg");
  return "ok";
};

if (typeof document === "object") {
  const tell = (error) => {
    document.title = String(error?.message ?? error);
  };
  addEventListener("error", ({ error, message }) => tell(error ?? message));
  addEventListener("unhandledrejection", ({ reason }) => tell(reason));
}
