// Four ways to forge a packet without its key, each with its end foretold; and the real outcome at the vehicle that
// it was for.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { hueClass, letter } from './colours.js';
import { broadcast, bytesOf, fieldsOf } from './packet.js';
import { ALREADY, LAST, fate, genuine, outcome, titleOf, victim } from './phrases.js';
import { seal } from './seal.js';

/** A packet that nobody has heard within this time, in seconds, is lost. */
const HEARD_WITHIN = 1;
const KEY_BYTES = 16;
const bytesIn = (packet, name) => fieldsOf(packet).find((f) => f.name === name);

/** Its content, as its addressee's host was told: an attacker may have guessed it. */
const saidBy = (packet) => packet.handed[0].content || 'tell;hello';

/** The command that sends a forgery of a packet; the emulator makes its CRC right. */
const FORGERIES = {
  shout: (packet) => ({ payload: broadcast(packet.origin, ...saidBy(packet).split(/;(.*)/s, 2)) }),
  replay: (packet) => ({ payload: packet.payload }),
  flip: (packet) => ({ payload: packet.payload, flip: bytesIn(packet, 'ciphertext').at * 8 }),
  async key(packet) {
    const nonce = bytesIn(packet, 'nonce').bytes.slice();
    // The next one, so that it is the tag alone that is wrong.
    for (let i = nonce.length - 1; ++nonce[i] === 256 && i > 0; i--);
    const key = crypto.getRandomValues(new Uint8Array(KEY_BYTES));
    return { payload: await seal(key, packet.destination, packet.origin, nonce, new TextEncoder().encode(saidBy(packet))) };
  },
};

/** The buttons, with what will come of it. */
export function forgeries(app, model, state, t) {
  if (!app.controls.includes('send')) return nothing;
  const packet = genuine(model.heardAir(t, LAST));
  const from = packet ? titleOf(state, packet.board) : 'somebody';
  const able = packet && state.speed !== 0;
  const forge = (way) => async () => {
    app.follow();
    app.forge(await FORGERIES[way](packet));
  };
  const attempt = (way, words, end) => html`<span class="attempt"><button type="button" id="forge-${way}" ?disabled=${!able}
    aria-describedby="forge-${way}-end" @click=${forge(way)}>${words}</button><small id="forge-${way}-end">${end}</small></span>`;
  return html`<fieldset><legend>${packet ? `Try to forge what ${from} sent to ${titleOf(state, packet.to[0])}` : 'Try to forge: wait for a sealed packet to one device'}${packet && !able ? ': the run is paused' : ''}; you have no key</legend>
    ${attempt('shout', `shout as ${from}`, 'heard as a shout only')}
    ${attempt('replay', 'replay the last packet', 'refused: heard before')}
    ${attempt('flip', 'change one bit', 'refused: wrong tag')}
    ${attempt('key', 'make up a key', 'refused: wrong tag')}</fieldset>`;
}

const AGAIN = (packet) => (packet.kind === 'broadcast' ? 'it has heard the same shout just now, and takes it only once'
  : 'it has had this very packet before, and its number counts only once; nobody can change the number without the key');

/** Why its addressee refuses a packet, by the counters that tell it. */
const REASONS = {
  __proto__: null,
  radioBadTag: () => 'its tag is wrong, because whoever has not the key cannot make the tag',
  radioReplayed: AGAIN,
  radioStale: AGAIN,
  radioRepeats: AGAIN,
};

/** A board's reaction to a forgery, in one sentence. */
function verdict(model, state, packet, board, t) {
  const who = titleOf(state, board);
  const heard = packet.heard.find((h) => h.board === board && h.t <= t);
  if (!heard) return t < packet.end + HEARD_WITHIN ? 'It is on the air …' : `${who} did not hear it: move the “?” nearer.`;
  const { what, counters } = outcome(model, packet, heard, t);
  if (what === 'repeated') return `${who} ${ALREADY}. Nobody can change the packet's number without the key.`;
  const why = counters.filter((name) => REASONS[name]).map((name) => REASONS[name](packet)).join('; or ');
  if (why) return `${who} refused it: ${why}.`;
  if (what === 'taken' && !packet.sealed) return `${who} heard it as a shout only: a shout has no tag, so it proves nothing, and the agent is told that anybody can have sent it.`;
  if (what === 'untold') return `${who} has heard it, and tells in a second what it did …`;
  return fate(model, state, packet, t, [board])[0];
}

/** The outcome of the last forgery, for the vehicle that it was for. */
export function verdicts(app, model, state, t) {
  const packets = model.heardAir(t, LAST);
  const packet = model.onAir(t, 0).find((p) => p.board === 'injector') ?? packets.find((p) => p.board === 'injector');
  const board = packet && state.boards.get(victim(packets, packet));
  if (!board || app.ui.read === String(packet.n)) return { board: undefined, shown: nothing };
  const others = fate(model, state, packet, t, [...state.boards.keys()].filter((name) => name !== board.name));
  return { board, shown: html`<p class=${hueClass(board)} data-n=${packet.n}><b class="letter">${letter(board)}</b> <span role="status">${verdict(model, state, packet, board.name, t)}</span>
      <button type="button" class="link" aria-label="close" @click=${() => app.read(packet.n)}>✕</button></p>
    <details><summary>the others</summary><ul>${others.map((line) => html`<li>${line}</li>`)}</ul></details>` };
}
