// Makes text from outside harmless. It is always shown as text, never as markup; here it also loses all power over
// the line in which it stands.

// Characters that turn the direction of writing, have no width, or begin a new line.
const INVISIBLE = /[\u00AD\u061C\u180E\u200B-\u200F\u2028-\u202E\u2060-\u206F\uFEFF\uFFF9-\uFFFB]/g;
const CONTROLS = /[\u0000-\u001F\u007F-\u009F]/g;

const codePoint = (c) => '⟨U+' + c.charCodeAt(0).toString(16).toUpperCase().padStart(4, '0') + '⟩';

/** The text with its control characters visible, cut to a length. */
export function plain(text, most = 200) {
  const cut = Array.from(String(text).slice(0, 2 * most));
  const shown = cut.length > most || String(text).length > 2 * most ? cut.slice(0, most).join('') + '…' : cut.join('');
  return shown
    .replace(CONTROLS, (c) => (c === '\n' ? '↵' : codePoint(c)))
    .replace(INVISIBLE, codePoint);
}

/** `3.250 s`. */
export const seconds = (t, digits = 3) => t.toFixed(digits) + ' s';

/** To a centimetre. */
export const rounded = (metres) => String(Math.round(metres * 100) / 100);

/** `a, b and c`. */
export function listed(words) {
  return words.length < 2 ? words.join('') : words.slice(0, -1).join(', ') + ' and ' + words[words.length - 1];
}

/** What an attacker is called. */
export const YOU = 'you, the attacker';
