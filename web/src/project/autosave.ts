// The project and its file stay in the browser. The file is stored once, when it is opened; changes
// store the project alone.
import type { Project } from "./project";

const shelf = "studio";

function done<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

async function openShelf(mode: IDBTransactionMode): Promise<IDBObjectStore> {
  const request = indexedDB.open("craze", 1);
  request.onupgradeneeded = () => request.result.createObjectStore(shelf);
  return (await done(request)).transaction(shelf, mode).objectStore(shelf);
}

async function put(key: string, value: unknown): Promise<void> {
  await done((await openShelf("readwrite")).put(value, key));
}

export const saveProject = (project: Project) => put("project", project);
export const saveFile = (bytes: Uint8Array) => put("file", bytes);

/** What was saved last; null where nothing was. */
export async function restore(): Promise<{ project: unknown; file: Uint8Array | null } | null> {
  const project: unknown = await done((await openShelf("readonly")).get("project"));
  if (!project) return null;
  const file = (await done((await openShelf("readonly")).get("file"))) as Uint8Array | undefined;
  return { project, file: file ?? null };
}
