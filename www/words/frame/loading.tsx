// What is said while parts of the page are loaded, and where they cannot be.

export const loadingLine = (name: string) => `Loading ${name} …`;

export const notLoadedLine = (name: string) =>
  `${name} could not be loaded. What you typed is kept. Check the connection and`;

export const retryWord = "try again";

export const coreNotLoaded = (reason: string) =>
  `The core could not be loaded (${reason}). Check the connection.`;

/** Where the browser was not allowed to compile it. */
export const coreForbidden = (reason: string) =>
  `The core could not be started (${reason}). A content policy of this host forbids it; it must allow 'wasm-unsafe-eval'.`;
