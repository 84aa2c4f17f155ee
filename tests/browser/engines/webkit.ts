// WebKit as Linux has it (WebKitGTK), over WebDriver, on a screen that nobody sees.
import { type Engine, heightPx, type Key } from "./engine.ts";
import { openSession } from "./webdriver.ts";
import { startDriver } from "./webkit_driver.ts";

/** The window is never narrower; a frame in it is. */
const narrowestWindowPx = 447;
/** Wide enough for any frame. */
const windowPx = 1400;
/** https://www.w3.org/TR/webdriver2/#keyboard-actions */
const codes: Partial<Record<Key, string>> = {
  Control: "\uE009",
  Meta: "\uE03D",
};

export async function startWebKit(): Promise<Engine> {
  const { server, stop } = await startDriver();
  const session = await openSession(server, {}).catch(async (error) => {
    await stop();
    throw error;
  });
  const evaluate: Engine["evaluate"] = async (run, argument) => {
    const script = `const done = arguments[1];
      new Promise((settle) => settle((${run})(arguments[0] ?? undefined)))
        .then((result) => done({ result }), (error) => done({ error: String(error) }));`;
    const answer = await session.execute(script, [argument ?? null]);
    const { result, error } = answer as { result: never; error?: string };
    if (error !== undefined) throw new Error(error);
    return result;
  };
  const keyboard = (actions: object[]) => session.act({ type: "key", id: "keyboard", actions });
  let isFramed = false;
  return {
    // WebDriver has no console.
    consoleErrors: [],
    open: async (address, width) => {
      await session.switchToFrame(null);
      await session.resize(windowPx, heightPx);
      isFramed = width < narrowestWindowPx;
      if (isFramed) {
        await session.navigate(new URL("frame.html", address).href);
        await evaluate(openFrame, { address, width, height: heightPx });
        await session.switchToFrame(0);
      } else {
        await session.resize(width, heightPx);
        await session.navigate("about:blank");
        await session.navigate(address);
      }
    },
    widen: async (width) => {
      if (!isFramed) return void (await session.resize(width, heightPx));
      await session.switchToFrame(null);
      await evaluate(widenFrame, width);
      await session.switchToFrame(0);
    },
    reload: async () => void (await session.refresh()),
    evaluate,
    type: async (text) => {
      const typed = [...text].flatMap((value) => [
        { type: "keyDown", value },
        { type: "keyUp", value },
      ]);
      await keyboard(typed);
    },
    press: async (...keys) => {
      const values = keys.map((key) => codes[key] ?? key);
      await keyboard([
        ...values.map((value) => ({ type: "keyDown", value })),
        ...values.toReversed().map((value) => ({ type: "keyUp", value })),
      ]);
    },
    drag: async (...places) => {
      const [first, ...moves] = places.map(({ x, y }) => ({
        ...{ type: "pointerMove", origin: "viewport", duration: 0 },
        ...{ x: Math.round(x), y: Math.round(y) },
      }));
      const [down, up] = [
        { type: "pointerDown", button: 0 },
        { type: "pointerUp", button: 0 },
      ];
      const actions = [first as object, down, ...moves, up];
      const parameters = { pointerType: "mouse" };
      await session.act({ type: "pointer", id: "mouse", parameters, actions });
    },
    close: async () => {
      // What the driver cannot close is stopped with it.
      await session.close().catch(() => {});
      await stop();
    },
  };
}

/** Fills an empty page with a frame. To be run in the page. */
function openFrame(of: { address: string; width: number; height: number }) {
  const frame = document.createElement("iframe");
  frame.src = of.address;
  [frame.width, frame.height] = [String(of.width), String(of.height)];
  document.body.append(frame);
  return new Promise<void>((loaded) => {
    frame.addEventListener("load", () => loaded());
  });
}

/** To be run in the page. */
function widenFrame(width: number) {
  const frame = document.querySelector("iframe");
  if (frame !== null) frame.width = String(width);
}
