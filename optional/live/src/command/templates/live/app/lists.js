/** The performatives of SPEC 3. */
export const PERFORMATIVES = [
  @Performatives.def: '$2',
];
