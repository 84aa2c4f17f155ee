// The numbers that a library printed, with all digits.
import { useEffect, useState } from "preact/hooks";
import type { Library } from "../engine.ts";
import { shown, shownArray } from "../format.ts";
import { type Evidence, evidenceOf, type Observed } from "../observations.ts";

const names: Record<string, string> = {
  arrayOfA: "a as an array",
  constructed1234: "0.1, 0.2, 0.3, 0.4 into the constructor, as w x y z",
  productAB: "a * b",
  productIJ: "i * j",
  matrixA: "matrix of a",
  matrixB: "matrix of b",
  matrixAB: "matrix of a * b",
  matrix2A: "matrix of 2 a",
  matrix0: "matrix of 0",
  rotateAV: "v rotated by a",
  rotate2AV: "v rotated by 2 a",
  rotate0V: "v rotated by 0",
  rotateABV: "v rotated by a * b",
  rotateBThenA: "v rotated by b, then by a",
  rotateAThenB: "v rotated by a, then by b",
  norm2A: "norm of 2 a",
  constructed0: "0, 0, 0, 0 into the constructor",
  nan: "NaN into the constructor",
  axisAngleZ: "+0.3 rad about z",
  axisAngleZMatrix: "+0.3 rad about z, as a matrix",
  fromMatrix: "of twelve matrices",
  slerpPositive: "slerp from a to b, half way",
  slerpNegative: "slerp from a to −b, half way",
  inverse0: "inverse of 0",
  normalize0: "0 normalised",
  euler: "Euler angles",
  other: "besides",
};

export function EvidenceOf({ library }: { library: Library }) {
  const [evidence, setEvidence] = useState<Evidence | "none" | "failed" | undefined>(undefined);
  useEffect(() => {
    let isWanted = true;
    evidenceOf(library.id).then(
      (found) => isWanted && setEvidence(found ?? "none"),
      () => isWanted && setEvidence("failed"),
    );
    return () => {
      isWanted = false;
    };
  }, [library.id]);
  return (
    <details class="evidence">
      <summary>What it printed</summary>
      {evidence === undefined && <p class="absent">Loading the recorded numbers …</p>}
      {evidence === "none" && <p class="absent">No numbers are recorded.</p>}
      {evidence === "failed" && (
        <p class="absent">The recorded numbers could not be loaded: reload the page.</p>
      )}
      {typeof evidence === "object" && <Printed evidence={evidence} />}
    </details>
  );
}

function Printed({ evidence }: { evidence: Evidence }) {
  const { a, b, v } = evidence.inputs;
  return (
    <>
      <p>
        Quaternions by name as w x y z, whatever the order of the library, but for the array. In:{" "}
        <var>a</var> = <code>{written(a)}</code>, <var>b</var> = <code>{written(b)}</code>,{" "}
        <var>v</var> = <code>{written(v)}</code>.
      </p>
      <dl class="printed">
        {Object.entries(names).flatMap(([name, words]) => {
          const value = evidence.printed[name];
          return value === undefined
            ? []
            : [
                <div key={name} class="record-fact">
                  <dt>{words}</dt>
                  <dd>
                    <pre>{written(value)}</pre>
                  </dd>
                </div>,
              ];
        })}
      </dl>
    </>
  );
}

/** Numbers in brackets, one list a line. */
function written(value: Observed | undefined): string {
  if (value === undefined) return "";
  if (typeof value === "number") return shown(value, "all");
  if (typeof value === "string") return value;
  if (isList(value)) {
    if (value.every((part) => typeof part === "number")) return shownArray(value, "all");
    if (value.every((part) => typeof part !== "object")) {
      return `[${value.map((part) => written(part)).join(", ")}]`;
    }
    return value.map((part) => written(part)).join("\n");
  }
  const { call, out } = value;
  if (call !== undefined) return `${call}:\n${written(out)}`;
  return Object.entries(value)
    .map(([name, part]) => `${name}:\n${written(part)}`)
    .join("\n");
}

const isList = (value: Observed): value is readonly Observed[] => Array.isArray(value);
