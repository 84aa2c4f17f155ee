// What libraries printed: a file of its own, read only when someone asks for it.

/** A quaternion, a vector, a matrix, several of these, or what was said in their place. */
export type Observed =
  | number
  | string
  | readonly Observed[]
  | { readonly [name: string]: Observed };

export interface Evidence {
  /** What went in. */
  inputs: { readonly [name: string]: Observed };
  /** What was printed, by the name of the observation. */
  printed: { readonly [name: string]: Observed };
}

/** What a library printed; nothing where nothing is recorded. */
export async function evidenceOf(id: string): Promise<Evidence | undefined> {
  const { default: file } = await import("../../src/library/observations.json");
  const inputs = file.inputs as unknown as Evidence["inputs"];
  const records = file.observations as unknown as ({ id: string } & Evidence["printed"])[];
  const record = records.find((record) => record.id === id);
  if (record === undefined) return undefined;
  const { id: _, ...printed } = record;
  return { inputs, printed };
}
