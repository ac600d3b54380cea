// Packets that anyone can hear, and an attacker's uses of them.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { live } from '/lib/lit-html/directives/live.js';
import { repeat } from '/lib/lit-html/directives/repeat.js';
import { hueClass } from './colours.js';
import { broadcast, fieldsOf, hexOf } from './packet.js';
import { YOU, plain, rounded, seconds } from './text.js';
import { fate, titleOf } from './phrases.js';
import { PERFORMATIVES } from './lists.js';

const ROWS = 100;
const CHOICES = 40;

const KINDS = { __proto__: null, broadcast: 'to all', multicast: 'to a group', unicast: 'to one', acknowledgement: 'answer', fragment: 'fragment', reserved: 'reserved', 'no frame': 'no frame' };

const grouped = (bytes) => hexOf(bytes).replace(/(.{8})(?=.)/g, '$1\u200a');

const readable = (packet) => (packet.content !== undefined ? plain(packet.content, 80)
  : packet.kind === 'acknowledgement' ? 'a proof: ' + plain(packet.answers, 12)
  : packet.sealed ? 'sealed: only who has the key can read it' : '');

/** The list of packets, newest first, as far as anyone can read them. */
export function sniffer(model, state, t, chosen, choose) {
  const packets = model.heardAir(t, ROWS);
  return html`<p class="hint">Everybody near hears these bytes. Addresses are open; of a sealed packet the content is not, and its tag shows any change.
    Choose a packet to inject it again.</p>
  <div class="scroll"><table class="sniffer"><thead><tr><th>time</th><th>from → to</th><th></th><th>bytes</th><th>what anyone can read</th></tr></thead>
  <tbody>${repeat(packets, (p) => p.n, (p) => html`<tr class="packet ${p.n === chosen ? 'chosen' : ''}" data-n=${p.n} data-kind=${p.kind} @click=${() => choose(p.n)}>
    <td>${seconds(p.t)}</td>
    <td class=${hueClass(state.boards.get(p.board))}><button type="button" class="link" aria-pressed=${p.n === chosen}><code>${plain(p.origin, 4)} → ${plain(p.destination, 4)}</code></button>
      ${p.board === 'injector' ? html`<b> ${YOU}</b>` : nothing}</td>
    <td>${KINDS[p.kind] ?? plain(p.kind, 20)}${p.sealed ? ', sealed' : p.content === undefined ? '' : ', open'}${p.trailer === 'parity' ? ', with parity' : ''}</td>
    <td class="bytes">${fieldsOf(p).map((f) => html`<span class="field ${f.name.replace(' ', '-')}" title="${f.name}: ${plain(f.text, 90)}"><code>${grouped(f.bytes)}</code><small>${f.name}</small></span>`)}</td>
    <td class="readable">${readable(p)}</td></tr>`)}</tbody></table></div>`;
}

/** The attacker, without any key: shouts, replays, flips bits; and what became of it. */
export function injector(app, model, state, t) {
  const ui = app.ui;
  const packets = model.heardAir(t, CHOICES).filter((p) => p.board !== 'injector' || p.n === ui.packet);
  const packet = packets.find((p) => p.n === ui.packet) ?? packets.find((p) => p.kind !== 'acknowledgement');
  const bits = packet ? packet.payload.length * 4 : 0;
  const flip = Math.min(ui.flip, Math.max(0, bits - 1));
  const field = packet && fieldsOf(packet).find((f) => flip >> 3 >= f.at && flip >> 3 < f.at + f.bytes.length);
  const last = model.heardAir(t, CHOICES * 4).find((p) => p.board === 'injector');
  const at = app.standing(state);
  return html`<div class="injector">
    <div>    <form class="place" title="You are an attacker with a radio and without any key, at the “?”: drag it, or type a place" @submit=${app.stand} @input=${app.typingStand} @change=${app.typingStand}><label>x <input id="injector-x" type="number" step="any" .value=${live(app.typedStand?.x ?? rounded(at[0]))} required></label>
      <label>y <input id="injector-y" type="number" step="any" .value=${live(app.typedStand?.y ?? rounded(at[1]))} required></label>
      <button>stand there</button></form>
    <form id="shout" @submit=${(e) => {
      e.preventDefault();
      const data = new FormData(e.target);
      app.shout(() => broadcast(data.get('origin'), data.get('performative'), data.get('term')));
    }}><fieldset><legend>Shout to all</legend>
      <label>as <input name="origin" value="EVIL" size="5" maxlength="4" required></label>
      <select name="performative" aria-label="performative">${PERFORMATIVES.map((each) => html`<option>${each}</option>`)}</select>
      <input name="term" aria-label="term" value="hello" size="18">
      <button id="shout-send">shout</button></fieldset></form>
    <fieldset><legend>Send what was heard</legend>
      ${packet ? html`<select id="recorded" aria-label="recorded packet" @change=${(e) => app.choosePacket(Number(e.target.value))}>
        ${repeat(packets, (p) => p.n, (p) => html`<option value=${p.n} ?selected=${p.n === packet.n}>${seconds(p.t)} ${titleOf(state, p.board)} → ${plain(p.destination, 4)} ${KINDS[p.kind] ?? ''}${p.sealed ? ', sealed' : ''}</option>`)}</select>
      <button type="button" id="replay" @click=${() => app.replay(packet)}>replay it as it was</button><br>
      <label>bit <input id="flip" type="number" min="0" max=${bits - 1} .value=${live(String(flip))} @input=${(e) => app.flip(Number(e.target.value))}></label>
      <input type="range" aria-label="bit" min="0" max=${bits - 1} .value=${live(String(flip))} @input=${(e) => app.flip(Number(e.target.value))}>
      <span>of ${bits}, in the ${field?.name ?? 'bytes'}</span>
      <button type="button" id="send-flipped" @click=${() => app.replay(packet, flip)}>send it with this bit inverted</button>`
      : html`<p>Nothing was heard yet.</p>`}</fieldset></div>
    <div><h3>What became of it</h3>
    <div id="injector-result" aria-live="polite" data-n=${last?.n ?? ''}>${last ? html`<p>${seconds(last.t)}: <code>${plain(last.origin, 4)} → ${plain(last.destination, 4)}</code> ${readable(last)}</p>
      <ul>${fate(model, state, last, t).map((line) => html`<li>${line}</li>`)}</ul>` : html`<p>You have sent nothing yet.</p>`}</div></div>
  </div>`;
}
