// A card for each agent and its board.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { repeat } from '/lib/lit-html/directives/repeat.js';
import { hueClass, letter } from './colours.js';
import { NEW_FOR } from './state.js';
import { SPAN } from './plots.js';
import { plain } from './text.js';
import { REFUSALS } from './phrases.js';

const LINES = 3;
/** Percepts by which the library tells of the board itself. */
const OWN = new Set(['port', 'peer']);
const BELIEFS = 14;

const OPENNESS = {
  __proto__: null,
  open: 'talks with other devices; agents can come and go',
  closed: 'talks with other devices by radio',
  limitedOpen: 'agents can come and go, but it cannot talk',
  totallyClosed: 'is cut off: it can talk with nobody',
};

const PORTS = { __proto__: null, open: 'agent connected', closed: 'no agent connected', unplugged: 'unplugged', plugged: 'plugged in' };

const NUMERIC = /^([a-z]\w*)\((-?\d+(?:\.\d+)?)\)$/;

const WAYS = {
  __proto__: null,
  unicast: (who) => 'from ' + who + ', sealed',
  multicast: (who) => 'to the group, by ' + who,
  broadcast: (who) => 'shouted by ' + who + ', perhaps forged',
};

const RANKS = Object.keys(WAYS);

/** Annotations of a term: in an intention there is no room for them. */
const SOURCES = /\[[^[\]]*source\([^[\]]*\]/g;

/** All ways by which it came: what is sealed stays so, whoever shouts the same. */
const ways = (casts) => casts.sort(([, a], [, b]) => RANKS.indexOf(a) - RANKS.indexOf(b)).map(([, how, who]) => WAYS[how]?.(who) ?? how + ' ' + who).join('; also ');

/** A belief without its annotations, and these in plain words. */
function parted(belief) {
  const [, term, annotations] = /^(.*)\[([^\]]*)\]$/s.exec(belief) ?? [, belief, ''];
  const casts = [...annotations.matchAll(/cast\((\w+),\s*"?([^")]*)"?\)/g)];
  const [, source] = /source\("?([^")]*)"?\)/.exec(annotations) ?? [];
  const from = casts.length ? ways(casts) : source === 'percept' ? 'sensed' : source === 'self' ? 'own' : source ? 'from ' + source : '';
  const hidden = annotations.includes('hide_in_mind_inspector');
  return { term, from, functor: term.split('(')[0], hidden, sensed: source === 'percept' };
}

/** The openness of the agent, as it believes it. */
function openness(board) {
  for (const [belief, { gone }] of board.beliefs) {
    const [, state] = /^openness\((\w+)\)/.exec(belief) ?? [];
    if (state && !gone) return state;
  }
  return undefined;
}

/** The beliefs that are shown: of a percept that changes, only the present one. */
function shownBeliefs(board, t) {
  const all = [...board.beliefs].map(([belief, state]) => ({ belief, ...parted(belief), ...state }))
    .filter((b) => !b.hidden && b.functor !== 'openness' && !(b.gone && t - b.t > NEW_FOR));
  const held = new Set(all.filter((b) => b.sensed && !b.gone).map((b) => b.functor));
  const newest = new Map(all.filter((b) => b.sensed && b.gone).map((b) => [b.functor, b]));
  return all.filter((b) => !(b.sensed && b.gone) || (!held.has(b.functor) && newest.get(b.functor) === b));
}

const belief = (b, t) => html`<li class="belief ${b.gone ? 'gone' : t - b.t < NEW_FOR && !b.sensed ? 'new' : ''}">
  <span class="sign">${b.gone ? '−' : t - b.t < NEW_FOR && !b.sensed ? '+' : ''}</span><code>${plain(b.term, 80)}</code>
  <small>${plain(b.from, 120)}</small></li>`;

function mind(board, t) {
  const all = shownBeliefs(board, t);
  const beliefs = all.filter((b) => !OWN.has(b.functor));
  const own = all.filter((b) => OWN.has(b.functor));
  const more = beliefs.length - BELIEFS;
  return html`
    ${board.said.length === 0 ? nothing : html`<h3>says</h3>
    <ul class="said">${board.said.slice(-LINES).map((line) => html`<li class=${t - line.t < NEW_FOR ? 'new' : ''}>“${plain(line.text)}”</li>`)}</ul>`}
    ${beliefs.length === 0 ? nothing : html`<h3>believes</h3>
    <ul class="beliefs">${repeat(beliefs.slice(0, BELIEFS), (b) => b.belief, (b) => belief(b, t))}
      ${more > 0 ? html`<li><small>and ${more} more</small></li>` : nothing}</ul>`}
    ${own.length === 0 ? nothing : html`<details class="own"><summary>${own.length} about its board</summary>
    <ul class="beliefs">${repeat(own, (b) => b.belief, (b) => belief(b, t))}</ul></details>`}
    ${board.intentions.length === 0 ? nothing : html`<h3>intends</h3>
    <ul class="intentions">${board.intentions.slice(0, 5).map((i) => html`<li title=${plain(i)}><code>${plain(i.replaceAll(SOURCES, ''), 120)}</code></li>`)}</ul>`}`;
}

/** So many are drawn, as many as the model keeps; the others are told as they are. */
const PLOTS = 8;

export function percepts(board) {
  const numbers = board.percepts.map((p) => NUMERIC.exec(p)).filter(Boolean)
    .filter(([, name], i, all) => all.findIndex((other) => other[1] === name) === i).slice(0, PLOTS);
  const others = board.percepts.filter((p) => !numbers.some(([plotted]) => plotted === p));
  return html`
    <div class="plots">${repeat(numbers, ([, name]) => name, ([, name, value]) => html`<figure>
      <figcaption><code>${plain(name, 24)}</code> <b>${value}</b> <small>${SPAN} s</small></figcaption>
      <div class="plotted"><canvas class="plot" data-board=${board.name} data-percept=${name}></canvas></div></figure>`)}</div>
    ${others.length === 0 ? nothing : html`<ul class="chips">${others.map((p) => html`<li><code>${plain(p, 60)}</code></li>`)}</ul>`}`;
}

const lamps = (board) => (board.pins.size === 0 ? nothing : html`<ul class="lamps">${[...board.pins].map(([pin, p]) => html`
  <li class="lamp" data-pin=${pin} data-on=${p.level ? 1 : 0}>${plain(p.name || 'pin ' + pin, 20)} <small>${p.level ? 'on' : 'off'}</small></li>`)}</ul>`);

const refused = (board) => {
  const some = [...board.counters].filter(([name, n]) => REFUSALS[name] && n > 0);
  return some.length === 0 ? nothing : html`<p class="refused">refused so far: ${some.map(([name, n], i) =>
    html`${i ? ', ' : ''}<span title=${name}>${n} × ${REFUSALS[name].short}</span>`)}</p>`;
};

/** Output of its sketch, and warnings of the library: neither is said by its agent. */
export const log = (board) => html`
  ${board.printed.length === 0 ? nothing : html`<h3>its sketch prints</h3>
    <details class="printed"><summary><code>${plain(board.printed.at(-1).text, 80)}</code></summary>
      <ul>${board.printed.slice(0, -1).reverse().map((line) => html`<li><code>${plain(line.text)}</code></li>`)}</ul></details>`}
  ${board.warned.length === 0 ? nothing : html`<details class="warned"><summary>${board.warned.length} ${board.warned.length === 1 ? 'warning' : 'warnings'}</summary>
    <ul>${board.warned.map((line) => html`<li>${plain(line.text, 300)}</li>`)}</ul></details>`}`;

export function stateOf(board, t) {
  if (board.offUntil !== undefined && t < board.offUntil) return 'no power';
  return PORTS[board.port] ?? plain(board.port, 20);
}

export function card(board, t, chosen, choose) {
  const state = openness(board);
  return html`<section class="agent ${hueClass(board)} ${chosen ? 'chosen' : ''}" data-board=${board.name} data-port=${board.port}
      data-openness=${state ?? ''} @click=${() => choose(board.name)}>
    <h2><span class="letter">${letter(board)}</span> ${plain(board.title, 30)} <code>${plain(board.address, 8)}</code>
      <span class="state">${stateOf(board, t)}</span></h2>
    ${state ? html`<p class="openness" title="openness(${state})">${plain(board.title, 30)} ${board.port === 'open' && state === 'totallyClosed' ? 'does not talk with other devices' : OPENNESS[state] ?? state}.</p>` : nothing}
    <div>${mind(board, t)}</div>
    ${board.percepts.length || board.pins.size ? html`<h3>its board</h3>${lamps(board)}${percepts(board)}` : nothing}
    ${refused(board)}${log(board)}
  </section>`;
}
