// The core of numbers, with its wasm inside: calls leave their answers in registers that both sides see.
import {
  registers as addressOfRegisters,
  CallOutcome,
  initSync,
} from "../../../pkg/rotation/quatlas_rotation.js";
import wasm from "../../../pkg/rotation/quatlas_rotation_bg.wasm?packed";
import { compiled } from "../compiled.ts";
import { unpacked } from "../packed.ts";
import { QuatlasError } from "../quatlas_error.ts";
import type { Numbers } from "./checks.ts";

/** A function of the core; what it does not take is left out by JavaScript. */
// biome-ignore lint/suspicious/noExplicitAny: each takes as many numbers as it takes
type Call = (...choices: any[]) => number;

const REGISTERS = 16;

/** What the wasm has beside its functions; it is compiled when it is first asked. */
interface Instance {
  memory: WebAssembly.Memory;
  stackPointer: WebAssembly.Global;
}

let instance: Instance | undefined;
/** Where the stack of the wasm begins. */
let emptyStack: unknown;
let seen = new Float64Array(0);

/** The numbers that both sides see: what a call takes, and then what it left. */
export function registers(): Float64Array {
  // None yet, or a memory that grew and is another buffer.
  if (seen.length === 0) seen = view();
  return seen;
}

function view(): Float64Array<ArrayBuffer> {
  instance ??= started();
  return new Float64Array(instance.memory.buffer as ArrayBuffer, addressOfRegisters(), REGISTERS);
}

function started(): Instance {
  const { memory, stackPointer } = initSync({
    module: compiled(unpacked(wasm)),
  }) as unknown as Instance;
  emptyStack = stackPointer.value;
  return { memory, stackPointer };
}

/** Puts numbers into the registers from a place on; one by one, as `set` takes three times as long for so few. */
export function put(numbers: Numbers, from = 0): void {
  const to = registers();
  for (let at = 0; at < numbers.length; at += 1) to[from + at] = numbers[at] as number;
}

/** What a call of the core gives. It throws where the stack of JavaScript is full, which leaves that of the wasm as it was. */
export function called(call: Call, one?: number, two?: number, three?: number): number {
  try {
    return call(one, two, three);
  } catch (cause) {
    if (instance !== undefined) instance.stackPointer.value = emptyStack;
    const hint = "the stack was full, or this is a mistake in quatlas; please report the second";
    throw new QuatlasError("core-stopped", "the core stopped", hint, { cause });
  }
}

/** Nothing where the answer stands in the registers, and else what is thrown. */
export function settle(outcome: number, what: string): void {
  if (outcome === CallOutcome.Done) return;
  switch (outcome) {
    case CallOutcome.Reflection:
      throw new QuatlasError(
        "reflection",
        `${what} has a negative determinant`,
        "it is a mirror image; look for an axis that was flipped or two that were exchanged",
      );
    case CallOutcome.Singular:
      throw new QuatlasError(
        "not-unique",
        `${what} has no one rotation`,
        "give more or other numbers",
      );
    case CallOutcome.TooLarge:
      throw new QuatlasError(
        "too-large",
        `${what} is larger than any number`,
        "ask for another description",
      );
    default:
      throw new QuatlasError(
        "zero-quaternion",
        `${what} is no rotation`,
        "give numbers that are not all zero",
      );
  }
}
