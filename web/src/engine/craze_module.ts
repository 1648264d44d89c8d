// The engine's module as craze.h declares it: pointers are numbers, int64_t are BigInt. Handles are
// pointers; 0 stands for NULL.

type Pointer = number;
type Status = number;

export interface FileSystem {
  writeFile(path: string, data: Uint8Array): void;
  readFile(path: string): Uint8Array;
  mkdir(path: string): void;
  readdir(path: string): string[];
  unlink(path: string): void;
}

export interface CrazeModule {
  readonly HEAPU8: Uint8Array;
  readonly HEAP32: Int32Array;
  readonly HEAPF64: Float64Array;
  readonly FS: FileSystem;
  addFunction(callback: (...values: never[]) => number | void, signature: string): Pointer;
  _malloc(bytes: number): Pointer;
  _free(pointer: Pointer): void;
  _craze_version(): Pointer;
  _craze_text_free(text: Pointer): void;
  _craze_mesh_read(path: Pointer, progress: Pointer, user: Pointer, error: Pointer): Pointer;
  _craze_mesh_shape(specification: Pointer, error: Pointer): Pointer;
  _craze_mesh_warning(mesh: Pointer, index: bigint): Pointer;
  _craze_mesh_free(mesh: Pointer): void;
  _craze_mesh_masks(mesh: Pointer, error: Pointer): Pointer;
  _craze_mesh_mask(mesh: Pointer, name: Pointer, values: Pointer, error: Pointer): Status;
  _craze_mesh_material_name(mesh: Pointer, index: bigint): Pointer;
  _craze_mesh_texture(mesh: Pointer, material: bigint, file: Pointer, error: Pointer): Status;
  _craze_mesh_mask_picture(
    mesh: Pointer,
    material: bigint,
    pixels: Pointer,
    type: number,
    width: bigint,
    height: bigint,
    channels: number,
    values: Pointer,
    error: Pointer,
  ): Status;
  _craze_mesh_set(
    mesh: Pointer,
    name: Pointer,
    values: Pointer,
    rows: bigint,
    columns: number,
    error: Pointer,
  ): Status;
  _craze_mesh_shading(mesh: Pointer, crease: number, normals: Pointer, error: Pointer): Status;
  _craze_mesh_array(mesh: Pointer, name: Pointer, array: Pointer, error: Pointer): Status;
  _craze_mesh_array_name(mesh: Pointer, index: bigint): Pointer;
  _craze_mesh_write(
    mesh: Pointer,
    path: Pointer,
    progress: Pointer,
    user: Pointer,
    error: Pointer,
  ): Status;
  _craze_job_new(): Pointer;
  _craze_job_free(job: Pointer): void;
  _craze_job_set_mesh(job: Pointer, mesh: Pointer, error: Pointer): Status;
  _craze_job_set_preset(job: Pointer, preset: Pointer, error: Pointer): Status;
  _craze_job_set(job: Pointer, key: Pointer, value: Pointer, error: Pointer): Status;
  _craze_job_set_recipe(job: Pointer, text: Pointer, name: Pointer, error: Pointer): Status;
  _craze_job_recipe(job: Pointer, error: Pointer): Pointer;
  _craze_job_recipe_toml(job: Pointer, error: Pointer): Pointer;
  _craze_job_set_max_cracks(job: Pointer, cracks: bigint, error: Pointer): Status;
  _craze_job_set_opened(job: Pointer, opened: Pointer, user: Pointer): void;
  _craze_job_set_threads(job: Pointer, threads: number, error: Pointer): Status;
  _craze_job_set_progress(job: Pointer, progress: Pointer, user: Pointer): void;
  _craze_job_run(job: Pointer, error: Pointer): Status;
  _craze_job_summary(job: Pointer, error: Pointer): Pointer;
  _craze_job_statistics(job: Pointer, error: Pointer): Pointer;
  _craze_job_fields(job: Pointer, error: Pointer): Pointer;
  _craze_job_lines(job: Pointer, error: Pointer): Pointer;
  _craze_lines_array(lines: Pointer, name: Pointer, array: Pointer, error: Pointer): Status;
  _craze_lines_write(lines: Pointer, path: Pointer, error: Pointer): Status;
  _craze_lines_free(lines: Pointer): void;
  _craze_job_open_post(job: Pointer, text: Pointer, error: Pointer): Pointer;
  _craze_job_with_post(job: Pointer, text: Pointer, error: Pointer): Pointer;
  _craze_opening_free(opening: Pointer): void;
  _craze_opening_mesh(opening: Pointer, error: Pointer): Pointer;
  _craze_opening_warning(opening: Pointer, index: bigint): Pointer;
  _craze_opening_vertex_count(opening: Pointer): bigint;
  _craze_opening_positions_at(
    opening: Pointer,
    time: number,
    positions: Pointer,
    error: Pointer,
  ): Status;
  _craze_job_bake(
    job: Pointer,
    size: number,
    names: Pointer,
    greenUp: number,
    gap: number,
    wall: number,
    error: Pointer,
  ): Pointer;
  _craze_maps_free(maps: Pointer): void;
  _craze_maps_name(maps: Pointer, index: bigint): Pointer;
  _craze_maps_array(maps: Pointer, index: bigint, array: Pointer, error: Pointer): Status;
  _craze_maps_range(
    maps: Pointer,
    index: bigint,
    low: Pointer,
    high: Pointer,
    error: Pointer,
  ): Status;
}

export interface ModuleOptions {
  instantiateWasm(
    imports: WebAssembly.Imports,
    ready: (instance: WebAssembly.Instance) => void,
  ): object;
}

export type CreateCraze = (options: ModuleOptions) => Promise<CrazeModule>;

/** An instance of its own memory, of code that is compiled already. */
export function instantiate(
  create: CreateCraze,
  code: WebAssembly.Module,
): Promise<CrazeModule> {
  return create({
    instantiateWasm(imports, ready) {
      void WebAssembly.instantiate(code, imports).then(ready);
      return {};
    },
  });
}
