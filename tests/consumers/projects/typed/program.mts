import { analyze, JPL, libraries, type Outcome, Rotation } from "quatlas";
import * as numbers from "quatlas/rotation";

const request = { view: "read", quaternion: "1 0 0 0", vector: "1 0 0" } as const;
const outcome: Outcome = analyze({ ...request, convention: JPL });
if (outcome.status === "read") {
  const entry: number = outcome.jpl.matrix[2][0];
  // @ts-expect-error: a row has three numbers
  console.log(entry, outcome.jpl.matrix[0][3], libraries[0]?.name.length);
}
// @ts-expect-error: the convention is missing
analyze(request);

// A rotation of one entry is one of the other.
const turned: numbers.Rotation = numbers.Rotation.identity().andThen(
  Rotation.fromQuat([0, 0, 0, 1], "eigen"),
);
const [x]: [number, number, number] = turned.apply(Float64Array.of(1, 2, 3));
// @ts-expect-error: the unit is missing
Rotation.fromEuler("ZYX", [x, 2, 3]);
// @ts-expect-error: no such sequence
Rotation.fromEuler("ZZX", [1, 2, 3], "deg");
