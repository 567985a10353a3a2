// The service worker of a published page. It keeps the page's files, so that the page opens without a network.
//
// The files are those of one version: a file with another SHA-256 than this script names is refused. A newer version
// comes with a script of its own, which takes over once no page of the older version is open.

// `playground --out` writes the next line.
const [VERSION, FILES] = ["", {}];

/** Other pages of the site have caches of their own. */
const OURS = `${registration.scope} `;
const CACHE = OURS + VERSION;

const hex = (bytes) => Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, "0")).join("");

/** Gets a file from the network and keeps it. */
async function get(name) {
  // A copy in the browser's own cache must be as new as the server's.
  const response = await fetch(new URL(name, registration.scope), { cache: "no-cache" });
  const bytes = await response.arrayBuffer();
  const found = hex(await crypto.subtle.digest("SHA-256", bytes));
  if (found !== FILES[name]) throw new Error(`${name} belongs to another version of the page: reload it later.`);
  const file = new Response(bytes, { headers: response.headers });
  await (await caches.open(CACHE)).put(name, file.clone());
  return file;
}

const kept = async (name) => (await caches.open(CACHE)).match(name);

addEventListener("install", (event) => event.waitUntil(Promise.all(Object.keys(FILES).map(get))));

addEventListener("activate", (event) => {
  const clear = async () => {
    const old = (await caches.keys()).filter((name) => name.startsWith(OURS) && name !== CACHE);
    await Promise.all(old.map((name) => caches.delete(name)));
  };
  event.waitUntil(clear());
});

addEventListener("fetch", (event) => {
  const [url] = event.request.url.split(/[?#]/);
  const name = url.startsWith(registration.scope) ? url.slice(registration.scope.length) || "index.html" : "";
  // The guide and other sites are none of its business.
  if (name in FILES) event.respondWith(kept(name).then((response) => response ?? get(name)));
});
