// What the page needs of the core before the core is there: the names of its choices as lists, and its
// named conventions. All of it is told by the built core, so nothing of it can differ from the core's.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { exists, root } from "./shell.mjs";

const script = join("pkg", "values.js");
const types = join("pkg", "values.d.ts");

/** Whether both files are there. */
export const areValuesWritten = () => exists(script) && exists(types);

/** Writes `pkg/values.js` and its types: one constant for each list, and what the core is asked. */
export async function writeValues() {
  const declared = readFileSync(join(root, "pkg", "quatlas.d.ts"), "utf8");
  const lists = listsIn(declared);
  const constants = [...lists, ...(await askedOfCore(lists))];
  const title = "// Written by www/tasks/values.mjs from the built core.\n";
  const line = ({ name, value }) => `export const ${name} = ${JSON.stringify(value)};\n`;
  const typeLine = ({ name, type }) => `export declare const ${name}: ${type};\n`;
  writeFileSync(join(root, script), title + constants.map(line).join(""));
  const imported =
    'import type { Convention, Direction, Function, NamedConvention } from "./quatlas.js";\n';
  writeFileSync(join(root, types), title + imported + constants.map(typeLine).join(""));
}

/** For each type that is a choice of names, such as `EulerAxes`, the list `eulerAxesValues`. */
function listsIn(declared) {
  const choices = declared.matchAll(/^export type (\w+) = ("[^"]+"(?: \| "[^"]+")*);$/gm);
  return [...choices].map(([, type, union]) => {
    const value = union.split(" | ").map((name) => JSON.parse(name));
    return {
      name: `${type.charAt(0).toLowerCase()}${type.slice(1)}Values`,
      value,
      type: `readonly ${JSON.stringify(value)}`,
    };
  });
}

/** The named conventions, and for a function and a direction the direction of the matrix that acts. */
async function askedOfCore(lists) {
  const core = await import(pathToFileURL(join(root, "pkg", "quatlas.js")).href);
  core.initSync({ module: readFileSync(join(root, "pkg", "quatlas_bg.wasm")) });
  const presets = core.presets();
  const tableOf = (list, of) =>
    Object.fromEntries(
      lists.find(({ name }) => name === list).value.map((value) => [value, of(value)]),
    );
  const operatorOf = (does) => (direction) =>
    core.describeConvention({ ...presets.hamilton, function: does, direction }).rules.operator;
  return [
    {
      name: "namedConventions",
      value: tableOf("namedConventionValues", (name) => presets[name]),
      type: "Readonly<Record<NamedConvention, Readonly<Convention>>>",
    },
    {
      name: "operatorDirections",
      value: tableOf("functionValues", (does) => tableOf("directionValues", operatorOf(does))),
      type: "Readonly<Record<Function, Readonly<Record<Direction, Direction>>>>",
    },
  ];
}
