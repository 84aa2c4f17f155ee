// The examples in the documentation of the package, run as they stand: `expression; // value: words`.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

const quatlas = createRequire(import.meta.url)("../../dist/npm/quatlas.js");
const folder = new URL("../../www/package/", import.meta.url);
const sources = readdirSync(folder, { recursive: true })
  .filter((name) => name.endsWith(".ts"))
  .map((name) => readFileSync(new URL(name, folder), "utf8"));

/** Each export, and each method of one, with the lines of its example; a class comes before its methods. */
const examples = sources.flatMap((source) => {
  let around = "";
  return [
    ...source.matchAll(
      /@example\n((?: +\*.*\n)+?) +\*\/\n(export (?:class|const|function)| {2}(?:static)?) ?(\w+)/g,
    ),
  ].map(([, text, kind, name]) => {
    if (kind === "export class") around = name;
    const whole = kind.startsWith("export") ? name : `${around}.${name}`;
    return [whole, text.split("\n").map((line) => line.replace(/^ +\* ?/, ""))];
  });
});

/** The value before the words of a comment; nothing where it begins with none. */
function toldIn(comment) {
  for (let words = comment; words !== ""; words = words.slice(0, words.lastIndexOf(":"))) {
    try {
      return { value: new Function(`"use strict"; return (${words});`)() };
    } catch {}
    if (!words.includes(":")) return undefined;
  }
}

/** Equal but for digits that the comment does not show. */
function isEqual(told, found) {
  if (typeof told !== "number") {
    const isList = Array.isArray(told) && Array.isArray(found) && told.length === found.length;
    if (isList) return told.every((value, at) => isEqual(value, found[at]));
    try {
      assert.deepEqual(found, told);
      return true;
    } catch {
      return false;
    }
  }
  if (Number.isInteger(told)) return told === found;
  const decimals = `${told}`.split(".")[1].length;
  return Math.abs(told - found) <= 0.5000001 * 10 ** -decimals;
}

for (const [name, lines] of examples) {
  test(`the example of ${name} is true`, () => {
    const told = [];
    const script = lines.map((line) => {
      const [, expression, comment] = line.match(/^([^/\s].*?); \/\/ (.*)$/) ?? [];
      const value = comment === undefined ? undefined : toldIn(comment);
      if (value === undefined || /^(const|let) /.test(expression)) return line;
      told.push({ expression, ...value });
      return `found.push(${expression});`;
    });
    const found = [];
    new Function("found", ...Object.keys(quatlas), `"use strict"; ${script.join("\n")}`)(
      found,
      ...Object.values(quatlas),
    );
    assert.ok(told.length > 0, "it asserts nothing");
    for (const [at, { expression, value }] of told.entries()) {
      assert.ok(isEqual(value, found[at]), `${expression} is ${JSON.stringify(found[at])}`);
    }
  });
}

test("every function of the package has an example", () => {
  const named = examples.map(([name]) => name);
  const functions = Object.keys(quatlas).filter((name) => typeof quatlas[name] === "function");
  assert.deepEqual(
    functions.filter((name) => !named.includes(name)),
    [],
  );
  const classes = ["Rotation", "TaggedQuaternion", "Pose"];
  const methods = classes.flatMap((name) => [
    ...namesOf(quatlas[name]).map((member) => `${name}.${member}`),
    ...namesOf(quatlas[name].prototype).map((member) => `${name}.${member}`),
  ]);
  assert.ok(methods.length > 35, methods.join());
  const without = methods.filter((name) => !named.includes(name));
  assert.deepEqual(without, []);
  // What a rotation tells has its examples where it is written: in the class below it.
  const told = namesOf(Object.getPrototypeOf(quatlas.Rotation.prototype));
  assert.deepEqual(
    told.filter((name) => !named.includes(`.${name}`)),
    [],
  );
});

/** The functions of a class or of its values. */
function namesOf(holder) {
  return Object.getOwnPropertyNames(holder).filter(
    (name) => name !== "constructor" && typeof holder[name] === "function",
  );
}
