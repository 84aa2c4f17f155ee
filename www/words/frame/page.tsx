// The words of the frame of the page, and what is said aloud of a result.
import type { View } from "../../model/page_state.ts";
import type { RepositoryLink } from "../../model/repository.ts";
import type { Tab } from "../../model/tabs.ts";

export const name = "quatlas";
export const skip = "Go to the result";
export const tagline = "One rotation, every convention.";
export const tabsLabel = "Views";
export const tabWords: Record<Tab, string> = {
  read: "Read",
  compose: "Compose",
  motion: "Motion",
  frames: "Frames",
  libraries: "Libraries",
};
export const viewNames: Record<View, string> = {
  read: "Read",
  compose: "Compose",
  motion: "Motion",
  frames: "Frames",
  translate: "Translate",
  identify: "Identify",
  libraries: "All libraries",
};

/** What a mistake of ours looks like. */
export const failure = (message: string) => (
  <>
    The core stopped on this input, which is a mistake in quatlas, not in your text:{" "}
    <code>{message}</code>. The last good result stays below; go on with another text, or reload the
    page.
  </>
);

export const colophon =
  "Computed in your browser; nothing you type is sent anywhere. The address of the page holds what you typed: share it as a link.";

export const licences = "Licences";
export const repositoryLinks: Record<RepositoryLink, string> = {
  source: "Source",
  report: "Report a problem",
};

export const spokenProblem = (
  symbol: string,
  {
    code,
    message,
    expected,
    hint,
  }: { code: string; message: string; expected: string; hint: string },
) =>
  message === ""
    ? `Problem in ${symbol}: ${code}.`
    : `Problem in ${symbol}: ${message}. Expected ${expected}. Try ${hint}.`;
export const spokenNoTurn = "Result: no rotation.";
export const spokenTurn = (angle: string, axis: string) =>
  `Result: a rotation by ${angle} about ${axis}.`;
