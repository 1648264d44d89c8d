declare module "*/generated/craze.mjs" {
  const createCraze: unknown;
  export default createCraze;
}
