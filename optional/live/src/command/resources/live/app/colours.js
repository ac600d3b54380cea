// One colour, letter and dash for each board. The first eight hues are far apart also for the colour-blind (after Okabe
// and Ito); letters and dashes tell the same without any colour. style.css has the hues, for light and dark.

const HUES = 8;
const DASHES = [[], [9, 4], [2, 4], [12, 4, 2, 4]];

let theme = {};

/** Reads the colours from the style sheet, again when light and dark change. */
export function readColours() {
  const style = getComputedStyle(document.documentElement);
  const value = (name) => style.getPropertyValue(name).trim();
  theme = { hues: Array.from({ length: HUES }, (_, i) => value('--hue-' + i)) };
  for (const name of ['ink', 'soft', 'line', 'paper', 'road', 'bad', 'good', 'injector']) theme[name] = value('--' + name);
}

export const ink = (name) => theme[name];

/** The colour of a board; the injector has none. */
export const hue = (board) => (board ? theme.hues[board.index % HUES] : theme.injector);

export const hueClass = (board) => (board ? 'hue-' + (board.index % HUES) : 'hue-injector');

/** The dashes of its outline. */
export const dash = (board) => DASHES[board ? Math.floor(board.index / HUES) % DASHES.length : 1];

/** Its first letter; of `V12` and the like the number too. */
export function letter(board) {
  const [, number = ''] = /(\d{1,2})$/.exec(board.title) ?? [];
  return (Array.from(board.title)[0]?.toUpperCase() ?? '?') + number;
}
