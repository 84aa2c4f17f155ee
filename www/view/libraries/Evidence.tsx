// The numbers that a library printed, with all digits.
import { useEffect, useState } from "preact/hooks";
import type { Library } from "../../engine.ts";
import { type Evidence, evidenceOf, type Observed } from "../../model/evidence.ts";
import { shown, shownArray } from "../../number/format.ts";
import * as words from "../../words/libraries/evidence.tsx";
import "../parts/result.css";
import "./evidence.css";

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
      <summary>{words.title}</summary>
      {evidence === undefined && <p class="absent">{words.loading}</p>}
      {evidence === "none" && <p class="absent">{words.none}</p>}
      {evidence === "failed" && <p class="absent">{words.failed}</p>}
      {typeof evidence === "object" && <Printed evidence={evidence} />}
    </details>
  );
}

function Printed({ evidence }: { evidence: Evidence }) {
  const { a, b, v } = evidence.inputs;
  return (
    <>
      <p>
        {words.inputs(
          <code>{written(a)}</code>,
          <code>{written(b)}</code>,
          <code>{written(v)}</code>,
        )}
      </p>
      <dl class="printed">
        {Object.entries(words.observedNames).flatMap(([name, called]) => {
          const value = evidence.printed[name];
          return value === undefined
            ? []
            : [
                <div key={name} class="record-fact">
                  <dt>{called}</dt>
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
