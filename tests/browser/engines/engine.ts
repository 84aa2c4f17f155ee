// What the tests ask of a browser, whatever drives it.

/** A place in the window, in CSS pixels. */
export interface Point {
  x: number;
  y: number;
}

/** The keys that are pressed, with the names of the Web platform. */
export type Key = "Control" | "Meta" | "a" | "v";

/** A browser with a profile of its own and one page, used as a person uses it. */
export interface Engine {
  /** The errors in the console, where the driver tells them. */
  readonly consoleErrors: string[];
  /** Loads an address anew, in a page that is so wide. */
  open(address: string, widthPx: number): Promise<void>;
  /** Makes the page wider than it was opened. */
  widen(widthPx: number): Promise<void>;
  reload(): Promise<void>;
  /** What a function that stands by itself returns in the page. */
  evaluate<Result, Argument = undefined>(
    run: (argument: Argument) => Result | Promise<Result>,
    argument?: Argument,
  ): Promise<Result>;
  /** Types into what has the focus. */
  type(text: string): Promise<void>;
  /** Presses keys together: the last one while the others are held. */
  press(...keys: Key[]): Promise<void>;
  /** The mouse goes down at the first place, over the others, and up at the last. */
  drag(...places: Point[]): Promise<void>;
  close(): Promise<void>;
}

export type EngineName = "chromium" | "firefox" | "webkit";

/** High enough for the first screen. */
export const heightPx = 800;

interface Mouse {
  move(x: number, y: number): Promise<void>;
  down(): Promise<void>;
  up(): Promise<void>;
}

/** A drag with the mouse of a driver that has one. */
export const draggedBy =
  (mouse: Mouse): Engine["drag"] =>
  async (...places) => {
    const [{ x, y } = { x: 0, y: 0 }, ...others] = places;
    await mouse.move(x, y);
    await mouse.down();
    for (const place of others) await mouse.move(place.x, place.y);
    await mouse.up();
  };
