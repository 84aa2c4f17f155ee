// All English of the page stands in www/words, so that a translation has one place to go.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path/posix";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { parseSync } from "vite";

const page = fileURLToPath(new URL("../../www", import.meta.url));

/** Letters that are symbols: the product of two units, and the unit of an angle. */
const symbols = /\b(?:ij|rad)\b/g;

const hasLetters = (text) => /\p{Script=Latin}{2}/u.test(text.replace(symbols, ""));

/** Two words of a sentence; names, numbers and what is typed into fields are none. */
const hasWords = (text) => /\p{Ll}{2}[,.:;!?]? +\p{Ll}{2}/u.test(text);

/** Attributes that are read or heard, and those that hold several names for the browser. */
const spoken = ["alt", "aria-description", "aria-label", "placeholder", "title"];
const technical = ["aria-describedby", "aria-labelledby", "class", "d", "viewBox"];

/** The English in a file. */
function englishIn(file, source) {
  const { program, errors } = parseSync(file, source, { lang: "tsx" });
  assert.deepEqual(errors, [], file);
  return englishOf(program, hasWords);
}

/** The English below a node, of which texts are judged by `isEnglish`. */
function englishOf(node, isEnglish) {
  if (Array.isArray(node)) return node.flatMap((part) => englishOf(part, isEnglish));
  if (node === null || typeof node !== "object") return [];
  const below = (judge, part = Object.values(node)) => englishOf(part, judge);
  switch (node.type) {
    case "ImportDeclaration":
    case "ExportAllDeclaration":
      return [];
    case "Literal":
      return typeof node.value === "string" && isEnglish(node.value) ? [node.value] : [];
    case "TemplateElement":
      return isEnglish(node.value.cooked) ? [node.value.cooked] : [];
    case "JSXText":
      return hasLetters(node.value) ? [node.value.trim()] : [];
    case "JSXAttribute":
      if (technical.includes(node.name.name)) return [];
      return below(spoken.includes(node.name.name) ? hasLetters : hasWords, node.value);
    // What is computed is no text any more.
    case "CallExpression":
    case "BinaryExpression":
    case "MemberExpression":
      return below(hasWords);
    case "ConditionalExpression":
      return [
        ...below(hasWords, node.test),
        ...below(isEnglish, [node.consequent, node.alternate]),
      ];
    case "JSXElement":
    case "JSXFragment":
      return [
        ...below(hasWords, node.openingElement?.attributes ?? []),
        ...below(hasLetters, node.children),
      ];
    default:
      return below(isEnglish);
  }
}

/** The scripts below a folder of the page. */
function sourcesIn(folder) {
  return readdirSync(`${page}/${folder}`, { recursive: true })
    .filter((name) => /\.tsx?$/.test(name))
    .map((name) => `${folder}/${name.replaceAll("\\", "/")}`)
    .map((file) => ({ file, source: readFileSync(`${page}/${file}`, "utf8") }));
}

const views = sourcesIn("view");

test("no view has English of its own", () => {
  assert.ok(views.length > 30, `${views.length} files`);
  const found = views.flatMap(({ file, source }) =>
    englishIn(file, source).map((text) => `${file}: ${text}`),
  );
  assert.deepEqual(found, []);
});

test("English is found wherever it stands, and symbols are none", () => {
  const english = [
    "const a = <p>Read</p>;",
    "const a = <p>{isOld ? 'old' : 'new'}</p>;",
    "const a = <p>{isOld && `from before`}</p>;",
    "const a = <p>{name ?? 'nameless'}</p>;",
    "const a = <section aria-label='Input' />;",
    "const a = <button title={`Copy`} />;",
    "const a = <Row note='the same rotation' />;",
    "const a = { name: 'Euler angles' };",
    "const a = (at) => `observation of `;",
    "const a = <p>{shown(`no turn`)}</p>;",
  ];
  for (const source of english) assert.notDeepEqual(englishIn("a.tsx", source), [], source);
  const other = [
    "const a = <p><var>R</var>(<var>q</var>) = 0.785 rad, ij = k, [w, x, y, z]</p>;",
    "const a = <p class='card wide'>{text === 'from' ? words.from : words.to}</p>;",
    "const a = <TextField name='worldAxes' />;",
    "const a = { from: library('eigen'), worldAxes: 'NED to ENU', printed: '[1. 0. 0. 0.]' };",
    "const a = <p>{report[side === 'from' ? 'from' : 'to'].text}</p>;",
  ];
  for (const source of other) assert.deepEqual(englishIn("a.tsx", source), [], source);
});

test("words know nothing of the page but its types and how it writes numbers", () => {
  for (const { file, source } of sourcesIn("words")) {
    const { module } = parseSync(file, source, { lang: "tsx" });
    const foreign = module.staticImports
      .filter(({ entries }) => entries.some(({ isType }) => !isType))
      .map(({ moduleRequest }) => join(dirname(file), moduleRequest.value))
      // Sentences hold numbers.
      .filter((from) => !from.startsWith("words/") && from !== "number/format.ts");
    assert.deepEqual(foreign, [], file);
  }
});
