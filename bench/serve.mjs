// A built page as a host serves it: compressed beforehand, never kept, over HTTP/1.1 (HTTP/2 would ask
// for a certificate). It can also be the slow line itself, for browsers that have none.
import { once } from "node:events";
import { readdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, relative, sep } from "node:path";
import { encodings, mediaTypeOf } from "../www/tasks/page_parts.mjs";

/** These are compressed by themselves. */
const compressed = [".woff2", ".png"];
/** The service worker would fetch every file beside the page, on the same line. */
const notServed = "service_worker.js";

/**
 * The answers to all paths of a folder. The prelude is a script that runs in the page before all else; a
 * policy in the page holds only for what stands after it.
 */
export function answersOf(folder, encoding, prelude) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && entry.name !== notServed)
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)));
  const answers = files.map((file) => {
    const path = `/${file.replaceAll(sep, "/")}`;
    const bytes = readFileSync(join(folder, file));
    const isPage = path === "/index.html";
    const content = isPage && prelude !== undefined ? withPrelude(bytes, prelude) : bytes;
    const isEncoded = !compressed.includes(extname(file));
    const headers = {
      "content-type": mediaTypeOf(file),
      "cache-control": "no-cache",
      ...(isEncoded && { "content-encoding": encoding }),
    };
    const body = isEncoded ? encodings[encoding](content) : content;
    return [isPage ? "/" : path, { headers, body }];
  });
  return new Map(answers);
}

const withPrelude = (bytes, prelude) =>
  String(bytes).replace("<head>", () => `<head><script>${prelude}</script>`);

/** Serves from an origin that nobody has seen, so that nothing is left of a run before. */
export async function serve(answers, line) {
  const send = line === undefined ? sendAtOnce : slowSender(line);
  const server = createServer(({ url, headers }, response) => {
    const { pathname } = new URL(url, "http://localhost");
    const { status, ...answer } = answerTo(answers.get(pathname), headers["accept-encoding"] ?? "");
    send(response, status, answer);
  });
  server.listen(0, "localhost");
  await once(server, "listening");
  const close = () => {
    server.close();
    server.closeAllConnections();
  };
  return { address: `http://localhost:${server.address().port}/`, close };
}

function answerTo(answer, accepted) {
  const nothing = { headers: {}, body: Buffer.alloc(0) };
  if (answer === undefined) return { status: 404, ...nothing };
  const encoding = answer.headers["content-encoding"] ?? "";
  return accepted.includes(encoding) ? { status: 200, ...answer } : { status: 406, ...nothing };
}

function sendAtOnce(response, status, { headers, body }) {
  response.writeHead(status, { ...headers, "content-length": body.length }).end(body);
}

/** Every answer waits for the latency; then all that are on their way share the bytes of each tick. */
function slowSender({ latencyMs, downBitsPerSecond }) {
  const bytesPerMs = downBitsPerSecond / 8000;
  const underWay = [];
  let timer;
  let last = 0;
  const tick = () => {
    const now = performance.now();
    let budget = Math.floor((now - last) * bytesPerMs);
    last = now;
    while (budget > 0 && underWay.length > 0) {
      const share = Math.max(1, Math.floor(budget / underWay.length));
      for (const one of underWay.splice(0)) {
        const chunk = one.body.subarray(one.at, one.at + Math.min(share, budget));
        one.at += chunk.length;
        budget -= chunk.length;
        if (chunk.length > 0) one.response.write(chunk);
        if (one.at === one.body.length) one.response.end();
        else if (!one.response.destroyed) underWay.push(one);
      }
    }
    if (underWay.length === 0) timer = clearInterval(timer);
  };
  return (response, status, { headers, body }) => {
    setTimeout(() => {
      response.writeHead(status, { ...headers, "content-length": body.length });
      if (body.length === 0) return response.end();
      response.flushHeaders();
      underWay.push({ response, body, at: 0 });
      if (timer === undefined) {
        last = performance.now();
        timer = setInterval(tick, 5);
      }
    }, latencyMs);
  };
}
