// The words of what folds ask.
import type { Problem } from "../../engine.ts";

export const problemLine = ({ message, expected, hint }: Problem) =>
  `Problem: ${message}. Expected: ${expected}. Try: ${hint}.`;
