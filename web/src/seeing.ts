// What is seen of a result, beside the result itself: its state as a heat map, another result, the
// paper's loop. What is dear is asked of the engine when it is looked at.
import type { Engine } from "./engine/engine";
import type { Picture } from "./engine/messages";
import { LoopDialog } from "./loop/loop_dialog";
import { baseRecipe } from "./project/base_recipe";
import { postText } from "./project/openings";
import type { Store } from "./project/store";
import type { Stage } from "./scene/stage";
import { SeePanel, type View } from "./ui/see_panel";
import { StatisticsPanel } from "./ui/statistics_panel";

export class Seeing {
  readonly panel: SeePanel;
  readonly statistics: StatisticsPanel;
  private readonly loop: LoopDialog;
  private view: View = "Surface";
  private picture: { picture: Picture; material: string } | null = null;

  /** `attempt` runs what may go wrong and says what did. */
  constructor(
    private readonly engine: Engine,
    private readonly stage: Stage,
    private readonly store: Store,
    private readonly attempt: (body: () => Promise<void>) => Promise<void>,
  ) {
    this.loop = new LoopDialog(engine, () => store.project.seed);
    document.body.append(this.loop.root);
    this.panel = new SeePanel({
      view: (view) => void this.choose(view),
      wireframe: (shown) => this.stage.showWireframe(shown),
      directions: (shown) => this.stage.showMarks(shown),
      lineColor: (lineColor, chosen) => {
        if (chosen) this.store.change({ lineColor });
        else this.stage.setLineColor(lineColor);
      },
      compare: () => this.compare(),
      stopComparing: () => this.stopComparing(),
      divide: (at) => this.stage.splitAt(at),
      loop: () => void this.attempt(() => this.loop.open()),
    });
    this.statistics = new StatisticsPanel(() => void this.attempt(() => this.measure()));
  }

  /** How it looks, as the project has it. */
  showLook(): void {
    const { project } = this.store;
    this.stage.setLook(baseRecipe(project).picture.material);
    this.stage.setLineColor(project.lineColor);
    this.panel.showLineColor(project.lineColor);
  }

  /** A result was opened; `anew`: it is of another run than the one before. */
  async show(picture: Picture, anew: boolean): Promise<void> {
    const { picture: look } = baseRecipe(this.store.project);
    this.picture = { picture, material: look.material };
    this.statistics.clear(); // rough lines have others
    if (anew) await this.showHeat();
  }

  /** There is no result any more. */
  clear(): void {
    this.picture = null;
    this.stopComparing();
    this.statistics.clear();
  }

  private async choose(view: View): Promise<void> {
    this.view = view;
    this.stage.showFragments(view === "Fragments");
    this.stage.showAge(view === "Age of cracks");
    await this.attempt(() => this.showHeat());
  }

  private async showHeat(): Promise<void> {
    const name =
      this.view === "Stress" ? "stress" : this.view === "Separation ς" ? "separation" : null;
    if (!name || !this.picture) {
      this.stage.hideHeat();
      this.panel.showScale(null);
      return;
    }
    const end = this.stage.showHeat(await this.engine.fields(), name);
    this.panel.showScale({ end, unit: name === "stress" ? "force / length" : "force" });
  }

  private compare(): void {
    this.stage.keep(this.picture);
    this.panel.showComparing(this.picture !== null);
  }

  private stopComparing(): void {
    this.stage.keep(null);
    this.panel.showComparing(false);
  }

  private async measure(): Promise<void> {
    const { project } = this.store;
    this.statistics.show(await this.engine.statistics(postText(project)), project.preset);
  }
}
