// The page of one board without any agent: what it perceives, what it can do, what it hears, what it counts.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { airtime, done, log, percepts, stateOf } from './cards.js';
import { actions, say } from './do.js';
import { plain, seconds } from './text.js';
import { REFUSALS } from './phrases.js';

const MESSAGES = 50;
/** A rate is taken over so many seconds. */
const OVER = 5;

/** How fast a counter rises, a second. */
export function rate(board, name, t) {
  const risen = board.counted.filter((c) => c.t <= t && t - c.t < OVER).reduce((sum, c) => sum + (c.rises.get(name) ?? 0), 0);
  return risen / OVER;
}

const AIR = [['radioReceived', 'heard well'], ['radioDamaged', 'heard damaged'], ['radioSent', 'sent'], ['radioNotForUs', 'for others']];

// SPEC 4.5: the longest time since the boot, or one in seconds, not a count.
const isTime = (name) => /(Millis|Micros)$/.test(name);
const isSeconds = (name) => /^(radioAirtime|airtimeWait)$/.test(name);

/** Groups of counters, by the beginnings of their names (SPEC 4.5); refusals are one of their own. */
const GROUPS = [['refused', (name) => REFUSALS[name]], ['radio', (name) => name.startsWith('radio')], ['serial line', (name) => name.startsWith('serial')], ['sketch and others', () => true]];

const groups = (board) => GROUPS.map(([title], i) => [title, [...board.counters].filter(([name]) => GROUPS.findIndex(([, has]) => has(name)) === i)])
  .filter(([, all]) => all.length > 0);

const radio = (board, messages, t) => html`<h3>messages</h3>
    <ul class="messages">${messages.map((m) => html`<li><small>${seconds(m.t, 1)}</small> <code>${plain(m.event.from, 8)} → ${plain(m.event.to, 8)}</code> ${plain(m.event.performative, 12)} <b>${plain(m.event.text, 160)}</b></li>`)}
      ${messages.length === 0 ? html`<li class="hint">none yet</li>` : nothing}</ul>
    <h3>the air</h3>${airtime(board)}
    <div class="plots">${AIR.map(([name, words]) => html`<figure><figcaption>${words} <b>${rate(board, name, t).toFixed(1)}</b> a second</figcaption>
      <div class="plotted"><canvas class="plot" data-board=${board.name} data-counter=${name}></canvas></div></figure>`)}</div>`;

export function boardPage(app, model, state, t) {
  const board = [...state.boards.values()][0];
  if (!board) return html`<p class="hint">Waiting for the board …</p>`;
  const messages = [];
  for (let i = model.marksUpTo(t) - 1; i >= 0 && messages.length < MESSAGES; i--) {
    if (model.marks[i].kind === 'heard') messages.push(model.marks[i]);
  }
  return html`<section class="agent hue-0" data-board=${board.name}>
    <h2>${plain(board.name, 30)} <code>${plain(board.address, 8)}</code> <small>${plain(board.firmware, 40)}</small>
      <span class="state">${board.online === false ? 'not there' : stateOf(board, t).replace('agent connected', 'online')}</span></h2>
    <h3>perceives</h3>${board.percepts.length ? percepts(board) : html`<p class="hint">no percepts</p>`}
    <h3>can do</h3>${board.actions.length ? actions(app, board) : html`<p class="hint">this sketch has named no actions</p>`}${say(app, board, undefined, state)}
    ${done(app, board)}
    ${log(board)}
  </section>
  <section class="agent hue-0">${board.radio ? radio(board, messages, t) : html`<p class="hint">this board has no radio</p>`}
    ${groups(board).map(([title, all]) => html`<h3>${title}</h3>
    <table class="counters"><tbody>${all.map(([name, value]) => html`<tr class=${REFUSALS[name] ? 'bad' : ''} data-counter=${name} title=${REFUSALS[name]?.why ?? ''}><td>${plain(name, 40)}</td><td>${value}</td><td>${isTime(name) ? 'longest' : isSeconds(name) ? 'seconds' : `${rate(board, name, t).toFixed(1)} a second`}</td></tr>`)}</tbody></table>`)}
  </section>`;
}
