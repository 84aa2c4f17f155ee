// What is said of the records that match.
import type { BehaviourAxis } from "../../engine.ts";
import { notEstablished } from "../library_behaviour.ts";
import { aboutOf } from "./choices.ts";

export const title = (count: number, all: number) => `Records that match: ${count} of ${all}`;
export const none = "No record of the table behaves like this. It may be right all the same.";
export const agree = "Establish all five choices, and agree";
export const leaveOpen = "Leave one or two choices open, and agree";
export const sayLittle = (count: number) => `${count} more establish too little to disagree`;
export const more = (count: number) => `${count} more`;
export const unestablished = (choices: readonly BehaviourAxis[]) =>
  `${notEstablished}: ${aboutOf(choices)}`;
