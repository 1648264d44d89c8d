// The page opens without a network once it was there.

/** Does nothing where the browser or the address has no service workers. */
export function keepForOffline(): void {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  navigator.serviceWorker.register("./service_worker.js").catch(() => {});
}
