import "./ui/style.css";
import { keepForOffline } from "./offline/register";
import { restore } from "./project/autosave";
import { fromHash, projectOf } from "./project/link";
import { firstProject, type Project } from "./project/project";
import { presetTable } from "./project/tables";
import { Studio } from "./studio";

interface Found {
  project: Project;
  file: { name: string; bytes: Uint8Array } | null;
}

/** What the address holds; else what was there last time; else a cup. */
async function find(): Promise<Found> {
  if (location.hash.length > 1) {
    return { project: await fromHash(location.hash.slice(1)), file: null };
  }
  const saved = await restore();
  if (!saved) return { project: firstProject, file: null };
  const project = projectOf(saved.project);
  const { source } = project;
  if (source.kind === "shape") return { project, file: null };
  if (!saved.file) return { project: firstProject, file: null };
  return { project, file: { name: source.name, bytes: saved.file } };
}

async function findOrBegin(): Promise<Found & { problem: string }> {
  try {
    const found = await find();
    if (!(found.project.preset in presetTable)) throw new Error("this preset is not known");
    return { ...found, problem: "" };
  } catch (error) {
    return { project: firstProject, file: null, problem: (error as Error).message };
  }
}

const view = document.querySelector<HTMLElement>(".view")!;
try {
  const { project, file, problem } = await findOrBegin();
  const studio = new Studio(view, project, file);
  await studio.start(problem);
  keepForOffline(); // after all that the page itself needs
} catch (error) {
  const sentence = document.createElement("p");
  sentence.role = "alert";
  sentence.textContent = `The studio cannot start: ${(error as Error).message}`;
  view.append(sentence);
}
