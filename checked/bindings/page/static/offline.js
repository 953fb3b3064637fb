// SPDX-License-Identifier: MIT
// The service worker: the page works without a network once it was visited. `make` writes which files there are, and a
// name for what is in them.
const files = [/* FILES */], version = "VERSION";

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(version).then((cache) => cache.addAll(files)).then(() => self.skipWaiting()));
});

self.addEventListener("activate", (event) => {
  const isOurs = (name) => name.startsWith("oplus-") && name !== version;
  event.waitUntil(caches.keys().then((names) => Promise.all(names.filter(isOurs).map((name) => caches.delete(name))))
    .then(() => self.clients.claim()));
});

self.addEventListener("fetch", (event) => {
  event.respondWith(caches.open(version).then((cache) => cache.match(event.request, {ignoreSearch: true}))
    .then((kept) => kept ?? fetch(event.request)));
});
