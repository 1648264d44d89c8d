// Keeps the page, so that it opens without a network once it was there. Before this stand, when the
// page is built, `files`, all it consists of, and `version`, which changes with them.
/* global files, version */

const mine = `craze ${registration.scope} `;
const shelf = mine + version;

async function keep() {
  await (await caches.open(shelf)).addAll(files);
  await skipWaiting();
}

async function forgetOthers() {
  for (const name of await caches.keys()) {
    if (name.startsWith(mine) && name !== shelf) await caches.delete(name);
  }
  await clients.claim();
}

/** The page itself is asked for anew where there is a network; its parts never change. */
async function answer(request) {
  const kept = await caches.open(shelf);
  if (request.mode !== "navigate") return (await kept.match(request)) ?? fetch(request);
  try {
    return await fetch(request);
  } catch {
    return (await kept.match("./")) ?? Response.error();
  }
}

addEventListener("install", (event) => event.waitUntil(keep()));
addEventListener("activate", (event) => event.waitUntil(forgetOthers()));
addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method === "GET" && request.url.startsWith(registration.scope)) {
    event.respondWith(answer(request));
  }
});
