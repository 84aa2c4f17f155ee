// A session of WebDriver, of which a few commands are used: https://www.w3.org/TR/webdriver2/#endpoints

export type Session = Awaited<ReturnType<typeof openSession>>;

export async function openSession(server: string, capabilities: Record<string, unknown>) {
  const ask = async (method: "GET" | "POST" | "DELETE", path: string, parameters?: unknown) => {
    const body = parameters === undefined ? {} : { body: JSON.stringify(parameters) };
    const answer = await fetch(server + path, { method, ...body });
    const { value } = (await answer.json()) as { value: unknown };
    if (!answer.ok) throw new Error(`${method} ${path}: ${JSON.stringify(value)}`);
    return value;
  };
  const opened = await ask("POST", "/session", { capabilities: { alwaysMatch: capabilities } });
  const session = `/session/${(opened as { sessionId: string }).sessionId}`;
  const command = (path: string, parameters: object) => ask("POST", session + path, parameters);
  return {
    navigate: (url: string) => command("/url", { url }),
    refresh: () => command("/refresh", {}),
    resize: (width: number, height: number) => command("/window/rect", { width, height }),
    /** The number of a frame in the page; null is the page itself. */
    switchToFrame: (id: number | null) => command("/frame", { id }),
    /** A script that hands its result to its last argument. */
    execute: (script: string, args: unknown[]) => command("/execute/async", { script, args }),
    act: (...actions: object[]) => command("/actions", { actions }),
    close: () => ask("DELETE", session),
  };
}
