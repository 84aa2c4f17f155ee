// What was recorded of a library, computed again by its adapter and compared number by number.

/** By the keys of src/library/observations.json: how each was found, in the calls of any library. */
const RECIPES = {
  arrayOfA: (library, { a }) => library.array(library.named(...a)),
  constructed1234: (library) => library.components(library.construct(0.1, 0.2, 0.3, 0.4)),
  productAB: (library, { a, b }) =>
    library.components(library.product(library.named(...a), library.named(...b))),
  productIJ: (library) =>
    library.components(library.product(library.named(0, 1, 0, 0), library.named(0, 0, 1, 0))),
  matrixA: (library, { a }) => library.matrix(library.named(...a)),
  matrixB: (library, { b }) => library.matrix(library.named(...b)),
  matrixAB: (library, { a, b }) =>
    library.matrix(library.product(library.named(...a), library.named(...b))),
  matrix2A: (library, { a }) => library.matrix(library.named(...twice(a))),
  matrix0: (library) => library.matrix(library.named(0, 0, 0, 0)),
  rotateAV: (library, { a, v }) => library.rotate(library.named(...a), v),
  rotate2AV: (library, { a, v }) => library.rotate(library.named(...twice(a)), v),
  rotate0V: (library, { v }) => library.rotate(library.named(0, 0, 0, 0), v),
  rotateABV: (library, { a, b, v }) =>
    library.rotate(library.product(library.named(...a), library.named(...b)), v),
  rotateBThenA: (library, { a, b, v }) =>
    library.rotate(library.named(...a), library.rotate(library.named(...b), v)),
  rotateAThenB: (library, { a, b, v }) =>
    library.rotate(library.named(...b), library.rotate(library.named(...a), v)),
  norm2A: (library, { a }) => library.norm(library.named(...twice(a))),
  constructed0: (library) => library.components(library.construct(0, 0, 0, 0)),
  nan: (library, { v }) => library.rotate(library.named(Number.NaN, 0, 0, 1), v),
  axisAngleZ: (library, { axisAngle }) => library.components(library.aboutZ(axisAngle)),
  fromMatrix: (library, { fromMatrix }) =>
    fromMatrix.map((rows) => library.components(library.fromMatrix(rows))),
  slerpPositive: (library, { a, b }) =>
    library.components(library.slerp(library.named(...a), library.named(...b), 0.5)),
  slerpNegative: (library, { a, b }) =>
    library.components(library.slerp(library.named(...a), library.named(...negated(b)), 0.5)),
  inverse0: (library) => library.components(library.inverse(library.named(0, 0, 0, 0))),
  normalize0: (library) => library.components(library.normalize(library.named(0, 0, 0, 0))),
};

const twice = (components) => components.map((component) => 2 * component);
const negated = (components) => components.map((component) => -component);

/** What is recorded, each under one name: Euler calls and other findings as well as plain keys. */
export function entriesOf({ id, euler = [], other = {}, ...plain }) {
  return [
    ...Object.entries(plain).map(([key, recorded]) => ({ name: key, recorded })),
    ...euler.map(({ call, args, out }) => ({ name: `euler ${call}`, recorded: out, call, args })),
    ...Object.entries(other).map(([text, recorded]) => ({
      name: `other ${text}`,
      recorded,
      text,
    })),
  ];
}

/** The same by the library itself; an error where it throws one. */
export function runAgain(library, { name, call, args, text }, inputs) {
  const ways = [
    RECIPES[name] && (() => RECIPES[name](library, inputs)),
    library.euler[call] && (() => library.euler[call](...args)),
    library.other?.[text] && (() => library.other[text](inputs)),
  ];
  const way = ways.find((each) => each !== undefined);
  if (way === undefined) throw new Error(`${name} is neither run again nor listed as such`);
  try {
    return { value: way() };
  } catch (error) {
    return { error };
  }
}

/** What differs, one line each: the place, the number now and the number recorded. */
export function differences(name, { value, error }, recorded, tolerance) {
  const isText = typeof recorded === "string" && recorded !== "NaN";
  if (isText && !name.startsWith("other ")) {
    return error ? [] : [`${name}: ${show(value)}, recorded the error ${recorded}`];
  }
  if (error) return [`${name}: ${error}, recorded ${show(recorded)}`];
  if (Array.isArray(recorded)) {
    if (!Array.isArray(value) || value.length !== recorded.length) {
      return [`${name}: ${show(value)}, recorded ${show(recorded)}`];
    }
    return recorded.flatMap((member, at) =>
      differences(`${name}[${at}]`, { value: value[at] }, member, tolerance),
    );
  }
  return isSame(value, recorded, tolerance)
    ? []
    : [`${name}: ${show(value)}, recorded ${show(recorded)}`];
}

function isSame(value, recorded, tolerance) {
  if (recorded === "NaN") return Number.isNaN(value);
  if (typeof recorded === "string") return String(value) === recorded;
  return Math.abs(value - recorded) <= tolerance * Math.max(1, Math.abs(recorded));
}

const show = (value) => JSON.stringify(value, (_, part) => (Number.isNaN(part) ? "NaN" : part));
