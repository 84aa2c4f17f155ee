import { analyze, JPL, libraries, type Outcome } from "quatlas";

const request = { view: "read", quaternion: "1 0 0 0", vector: "1 0 0" } as const;
const outcome: Outcome = analyze({ ...request, convention: JPL });
if (outcome.status === "read") {
  const entry: number = outcome.jpl.matrix[2][0];
  // @ts-expect-error: a row has three numbers
  console.log(entry, outcome.jpl.matrix[0][3], libraries[0]?.name.length);
}
// @ts-expect-error: the convention is missing
analyze(request);
