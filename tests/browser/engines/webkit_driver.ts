// The driver of WebKit and the screen that it draws on, as processes.
import { type ChildProcess, spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Readable } from "node:stream";
import { setTimeout as pause } from "node:timers/promises";

/** The driver on a port and a screen that nobody else has; it starts the browser itself. */
export async function startDriver() {
  const driver = process.env["QUATLAS_WEBKIT"];
  if (!driver) throw new Error("QUATLAS_WEBKIT has no path of a WebKitWebDriver");
  const home = mkdtempSync(join(tmpdir(), "quatlas-webkit-"));
  const running: { child: ChildProcess; signal: NodeJS.Signals }[] = [];
  const endAll = () => {
    for (const { child, signal } of running.toReversed()) endGroup(child, signal);
  };
  process.on("exit", endAll);
  const stop = async () => {
    endAll();
    await Promise.all(running.map(({ child }) => ended(child)));
    process.off("exit", endAll);
    rmSync(home, { recursive: true, force: true, maxRetries: 5 });
  };
  const start = (
    signal: NodeJS.Signals,
    command: string,
    args: string[],
    environment: Record<string, string> = {},
  ) => {
    const child = spawn(command, args, {
      // A group of its own, to be ended with all that it has started.
      detached: true,
      stdio: ["ignore", "ignore", "ignore", "pipe"],
      env: { ...process.env, ...environment },
    });
    running.push({ child, signal });
    return child;
  };
  try {
    const screen = start("SIGTERM", "Xvfb", ["-displayfd", "3", "-screen", "0", "1400x1000x24"]);
    const [display] = await Promise.race([
      once(screen.stdio[3] as Readable, "data"),
      once(screen, "exit").then(() => Promise.reject(new Error("Xvfb has no screen"))),
    ]);
    const port = await freePort();
    const child = start("SIGKILL", driver, [`--port=${port}`], {
      DISPLAY: `:${String(display).trim()}`,
      HOME: home,
      XDG_CACHE_HOME: join(home, "cache"),
      XDG_CONFIG_HOME: join(home, "config"),
      XDG_DATA_HOME: join(home, "data"),
      // Nothing is drawn by a graphics card, and nobody listens to the page.
      WEBKIT_DISABLE_COMPOSITING_MODE: "1",
      LIBGL_ALWAYS_SOFTWARE: "1",
      NO_AT_BRIDGE: "1",
    });
    const server = `http://127.0.0.1:${port}`;
    while (!(await isReady(server))) {
      if (child.exitCode !== null) throw new Error(`${driver} has ended: ${child.exitCode}`);
      await pause(50);
    }
    return { server, stop };
  } catch (error) {
    await stop();
    throw error;
  }
}

const isReady = (server: string) =>
  fetch(`${server}/status`).then(
    ({ ok }) => ok,
    () => false,
  );

async function ended(child: ChildProcess) {
  const hasEnded = child.exitCode !== null || child.signalCode !== null;
  if (child.pid !== undefined && !hasEnded) await once(child, "exit");
}

function endGroup({ pid }: ChildProcess, signal: NodeJS.Signals) {
  if (pid === undefined) return;
  try {
    process.kill(-pid, signal);
  } catch {
    // It has ended by itself.
  }
}

async function freePort(): Promise<number> {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address() as { port: number };
  server.close();
  await once(server, "close");
  return port;
}
