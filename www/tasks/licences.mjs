// The licences of what is shipped, with their notices: the crates in the wasm and the packages in the page.
// Their texts stand in the folders that cargo and npm unpacked; nothing is fetched for this.
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { ask, root, Stop } from "./shell.mjs";

const licenceFile = /^(licen[cs]e|copying|copyright|notice)/i;
/** Of these another one is taken where a crate or package offers MIT: its notice says all that is asked. */
const alternatives = /apache|unlicense|copying/i;

const read = (...path) => readFileSync(join(...path), "utf8").trim();

/** quatlas itself. */
export const ownLicences = () => ({
  names: ["quatlas"],
  licence: "MIT OR Apache-2.0",
  texts: [read(root, "LICENSE-MIT"), read(root, "LICENSE-APACHE")],
});

/** The standard library is in every wasm, and in no list of crates. */
const standardLibrary = () => ({
  names: [
    "Rust standard library (std, alloc, core and what they hold), The Rust Project Contributors",
  ],
  licence: "MIT OR Apache-2.0",
  texts: [read(root, "LICENSE-APACHE")],
});

/** What is compiled into the wasm: the crates that are no macros, no build scripts and no tests. */
export function cratesInWasm() {
  const options = ["--format-version", "1", "--locked"];
  const target = ["--filter-platform", "wasm32-unknown-unknown"];
  const answer = ask("cargo", "metadata", ...options, ...target);
  if (answer === undefined) throw new Stop("cargo cannot list the crates of Cargo.lock");
  const { packages, resolve } = JSON.parse(answer);
  const packageOf = new Map(packages.map((found) => [found.id, found]));
  const dependenciesOf = new Map(resolve.nodes.map(({ id, deps }) => [id, deps]));
  const isMacro = (id) => packageOf.get(id).targets.some(({ kind }) => kind.includes("proc-macro"));
  const found = new Set();
  const waiting = [resolve.root];
  for (let id = waiting.pop(); id !== undefined; id = waiting.pop()) {
    if (found.has(id)) continue;
    found.add(id);
    const linked = dependenciesOf
      .get(id)
      .filter(({ dep_kinds }) => dep_kinds.some(({ kind }) => kind === null))
      .map(({ pkg }) => pkg);
    waiting.push(...linked.filter((other) => !isMacro(other)));
  }
  found.delete(resolve.root);
  const crates = [...found].sort().map((id) => packageOf.get(id));
  return [
    ...crates.map(({ name, version, license, manifest_path }) =>
      withTexts(`${name} ${version}`, license, dirname(manifest_path)),
    ),
    standardLibrary(),
  ];
}

/** A package of node_modules, by its name. */
export function nodePackage(packageName) {
  const folder = join(root, "node_modules", packageName);
  const { version, license } = JSON.parse(read(folder, "package.json"));
  return withTexts(`${packageName} ${version}`, license, folder);
}

function withTexts(name, licence, folder) {
  const files = readdirSync(folder).filter((file) => licenceFile.test(file));
  const offersMit = / OR /.test(licence) && files.some((file) => /mit/i.test(file));
  const chosen = files.filter((file) => !(offersMit && alternatives.test(file)));
  if (chosen.length === 0) throw new Stop(`${name} has no text of its licence (${licence})`);
  return { names: [name], licence, texts: chosen.map((file) => read(folder, file)) };
}

/** One text with all of them; what several share stands there once. */
export function licencesText(title, parts) {
  const shared = new Map();
  for (const { names, licence, texts } of parts) {
    for (const text of texts) {
      const plain = text.replaceAll("\r\n", "\n");
      const users = shared.get(plain) ?? [];
      shared.set(plain, [...users, ...names.map((name) => `${name} (${licence})`)]);
    }
  }
  const line = "-".repeat(72);
  const blocks = [...shared].map(
    ([text, users]) => `${line}\n${users.join("\n")}\n${line}\n\n${text}\n`,
  );
  return [`${title}\n`, ...blocks].join("\n");
}
