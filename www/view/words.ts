// The names of conventions; they stand in the words, and what follows from them in conventions.ts.
export * from "../words/conventions.ts";
export * from "./conventions.ts";
