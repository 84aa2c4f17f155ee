// What Frames is asked as one text, which the address holds: the question, then five fields a pose.
import type { GivenPose } from "../../engine.ts";
import { namedConventions } from "../../values.ts";

export const rowConventions = ["", "hamilton", "jpl"] as const;
/** Of the four numbers of a pose; empty for that of the page. */
export type RowConvention = (typeof rowConventions)[number];

export interface Row {
  child: string;
  parent: string;
  rotation: string;
  position: string;
  convention: RowConvention;
}
export type RowText = Exclude<keyof Row, "convention">;

export interface Rig {
  child: string;
  parent: string;
  point: string;
  rows: readonly Row[];
}

export const mostRows = 32;
export const emptyRow: Row = { child: "", parent: "", rotation: "", position: "", convention: "" };

/** Figure 1 of Yoosefian 2021: a camera C on a body I at two instants, with the numbers of case G29. */
export const openingRig: Rig = {
  child: "I2",
  parent: "G",
  point: "",
  rows: [
    { ...emptyRow, child: "I1", parent: "G", rotation: "rotvec 0.1 0.2 -0.3", position: "1 2 3" },
    ...(["1", "2"] as const).map((at) => ({
      ...emptyRow,
      child: `C${at}`,
      parent: `I${at}`,
      rotation: "rotvec 1.2 -0.4 0.5",
      position: "0.1 -0.2 0.3",
    })),
    {
      ...emptyRow,
      child: "C2",
      parent: "C1",
      rotation: "rotvec 0.506265916 0.404520876 0.444976375",
      position: "0.489495806 -0.947897524 0.632341668",
    },
  ],
};

const mark = "|";
const order = ["child", "parent", "rotation", "position"] as const satisfies RowText[];
const written = (text: string) => text.replaceAll("~", "~0").replaceAll(mark, "~1");
const read = (text: string) => text.replaceAll("~1", mark).replaceAll("~0", "~");

export function rigToText({ child, parent, point, rows }: Rig): string {
  const fields = [child, parent, point];
  for (const row of rows) fields.push(...order.map((name) => row[name]), row.convention);
  return fields.map(written).join(mark);
}

/** The rig of a text; the opening one where there is none. */
export function rigOf(text: string): Rig {
  if (text === "") return openingRig;
  const [child = "", parent = "", point = "", ...rest] = text.split(mark).map(read);
  const rows: Row[] = [];
  while (rest.length > 0 && rows.length <= mostRows) {
    const [child = "", parent = "", rotation = "", position = "", name] = rest.splice(0, 5);
    const convention = rowConventions.find((known) => known === name) ?? "";
    rows.push({ child, parent, rotation, position, convention });
  }
  return { child, parent, point, rows };
}

/** Links, so that going back returns to what was typed before. */
export const examples = [
  { name: "rig", frames: "" },
  {
    name: "jpl",
    frames: "D|W||B|W|0 0 0.6 0.8||jpl|C|B|0.6 0 0 0.8||jpl|D|C|0 0.28 0 0.96||jpl",
  },
  {
    name: "cameras",
    frames:
      "cam0|cam1||imu|cam0|[[-0.515614, -0.825047, 0.231170, 0.168900], [0.724520, -0.563857, -0.396403, 0.124200], [0.457399, -0.036904, 0.888496, 0.050500], [0, 0, 0, 1]]|||imu|cam1|[[0.622345, -0.372651, 0.688344, 0.152300], [-0.753767, -0.048262, 0.655367, -0.092700], [-0.211002, -0.926716, -0.310927, 0.033100], [0, 0, 0, 1]]||",
  },
  {
    name: "loop",
    frames:
      "C|A|1 0 0|B|A|rotvec 0 0 pi/6|1 0 0||C|B|rotvec 0 0 pi/3|2 0 0||A|C|rotvec 0 0 pi/2|2.732 1 0|",
  },
] as const;

export function posesOf({ rows }: Rig): GivenPose[] {
  return rows.map(({ convention, ...texts }) => ({
    ...texts,
    ...(convention !== "" && { convention: namedConventions[convention] }),
  }));
}
