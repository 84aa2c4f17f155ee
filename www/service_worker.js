// The service worker: keeps every file of one build, so that the page opens without a network.
// The build writes `version` and `files` before this text (tasks/precache.ts): each file by its path
// from the folder of the page, with the hash of its content; the page itself is the empty path.

const scope = self.registration.scope;
/** Ends in a space, so that the page of another folder of the same host is never meant. */
const cachePrefix = `quatlas ${scope} `;
const cacheName = cachePrefix + version;
/** In this folder a name holds the hash of the content: the same name is the same file. */
const hashedFolder = "assets/";
const anyVariant = { ignoreSearch: true, ignoreVary: true };

addEventListener("install", (event) => event.waitUntil(keepFiles()));
addEventListener("activate", (event) => event.waitUntil(takeOver()));
addEventListener("message", ({ data }) => {
  if (data === "take over") self.skipWaiting();
});
addEventListener("fetch", (event) => {
  const path = pathOf(event.request);
  if (path === undefined) return;
  if (Object.hasOwn(files, path)) event.respondWith(kept(event.request, path));
  // A tab of the version before may still ask for its parts.
  else if (path.startsWith(hashedFolder)) event.respondWith(keptByAny(event.request));
});

/** The path from the folder of the page; nothing for a request that is not ours to answer. */
function pathOf({ method, url }) {
  const { origin, pathname } = new URL(url);
  const address = origin + pathname;
  if (method !== "GET" || !address.startsWith(scope)) return undefined;
  const path = address.slice(scope.length);
  return path === "index.html" ? "" : path;
}

async function kept(request, path) {
  const file = caches.open(cacheName).then((cache) => cache.match(scope + path, anyVariant));
  return (await file.catch(nothing)) ?? fetch(request);
}

async function keptByAny(request) {
  return (await caches.match(request, anyVariant).catch(nothing)) ?? fetch(request);
}

/** Of a store that fails, on a full disk or in a damaged profile: then the network answers. */
const nothing = () => undefined;

async function keepFiles() {
  const cache = await caches.open(cacheName);
  await Promise.all(
    Object.entries(files).map(async ([path, integrity]) => {
      const isHashed = path.startsWith(hashedFolder);
      const earlier = isHashed ? await caches.match(scope + path, anyVariant) : undefined;
      // The hash is checked, so that a half published version is not kept: the next visit tries again.
      const mode = isHashed ? "default" : "no-cache";
      const file = earlier ?? (await fetch(scope + path, { integrity, cache: mode }));
      if (!file.ok) throw new Error(`${path} was answered with ${file.status}`);
      await cache.put(scope + path, file);
    }),
  );
}

async function takeOver() {
  await self.clients.claim();
  // Another open tab may be of the version before, whose files then stay until the next version.
  const tabs = await self.clients.matchAll({ type: "window", includeUncontrolled: true });
  // Those of this page: other pages of the same host use none of these files.
  if (tabs.filter(({ url }) => url.startsWith(scope)).length > 1) return;
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(cachePrefix) && name !== cacheName);
  await Promise.all(old.map((name) => caches.delete(name)));
}
