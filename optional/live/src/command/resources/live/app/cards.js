// A card for each agent and its board.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { repeat } from '/lib/lit-html/directives/repeat.js';
import { hueClass, letter } from './colours.js';
import { NEW_FOR, agentsAt } from './state.js';
import { SPAN } from './plots.js';
import { plain, seconds } from './text.js';
import { REFUSALS, repeats } from './phrases.js';
import { actions, goal, say } from './do.js';
import { sensor } from './menu.js';
import { asking } from './why.js';

const LINES = 3;
/** Percepts by which the library tells of the board itself. */
const OWN = new Set(['port', 'peer']);
const BELIEFS = 14;
/** So many boards have room for all that one can have them do. */
const FEW = 3;

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
function openness(agent) {
  for (const [belief, { gone }] of agent.beliefs) {
    const [, state] = /^openness\((\w+)\)/.exec(belief) ?? [];
    if (state && !gone) return state;
  }
  return undefined;
}

/** The beliefs that are shown: of a percept that changes, only the present one. */
function shownBeliefs(agent, t) {
  const all = [...agent.beliefs].map(([belief, state]) => ({ belief, ...parted(belief), ...state }))
    .filter((b) => !b.hidden && b.functor !== 'openness' && !(b.gone && t - b.t > NEW_FOR));
  const held = new Set(all.filter((b) => b.sensed && !b.gone).map((b) => b.functor));
  const newest = new Map(all.filter((b) => b.sensed && b.gone).map((b) => [b.functor, b]));
  return all.filter((b) => !(b.sensed && b.gone) || (!held.has(b.functor) && newest.get(b.functor) === b));
}

const belief = (app, agent, b, t) => html`<li class="belief ${b.gone ? 'gone' : t - b.t < NEW_FOR && !b.sensed ? 'new' : ''}">
  <span class="sign">${b.gone ? '−' : t - b.t < NEW_FOR && !b.sensed ? '+' : ''}</span>${asking(app, { what: b.term, agent: agent.name, until: t }, b.term, html`<code>${plain(b.term, 80)}</code>`)}
  <small>${plain(b.from, 120)}</small></li>`;

function mind(app, agent, t) {
  const all = shownBeliefs(agent, t);
  const beliefs = all.filter((b) => !OWN.has(b.functor));
  const own = all.filter((b) => OWN.has(b.functor));
  const more = beliefs.length - BELIEFS;
  return html`
    ${agent.said.length === 0 ? nothing : html`<h3>says</h3>
    <ul class="said">${agent.said.slice(-LINES).map((line) => html`<li class=${t - line.t < NEW_FOR ? 'new' : ''}>“${plain(line.text)}”</li>`)}</ul>`}
    ${beliefs.length === 0 ? nothing : html`<h3>believes</h3>
    <ul class="beliefs">${repeat(beliefs.slice(0, BELIEFS), (b) => b.belief, (b) => belief(app, agent, b, t))}
      ${more > 0 ? html`<li><small>and ${more} more</small></li>` : nothing}</ul>`}
    ${own.length === 0 ? nothing : html`<details class="own"><summary>${own.length} about its board</summary>
    <ul class="beliefs">${repeat(own, (b) => b.belief, (b) => belief(app, agent, b, t))}</ul></details>`}
    ${agent.intentions.length === 0 ? nothing : html`<h3>intends</h3>
    <ul class="intentions">${agent.intentions.slice(0, 5).map((i) => html`<li title=${plain(i)}>${asking(app, { what: i.split(' / ')[0], agent: agent.name, until: t }, i.split(' / ')[0].replaceAll(SOURCES, ''),
      html`<code>${plain(i.replaceAll(SOURCES, ''), 120)}</code>`)}</li>`)}</ul>`}`;
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

export const lamps = (app, board) => (board.pins.size === 0 ? nothing : html`<ul class="lamps">${[...board.pins].map(([pin, p]) => html`
  <li class="lamp" data-pin=${pin} data-on=${p.level ? 1 : 0}>${asking(app, p.line && { line: p.line }, `${p.name || pin} ${p.level ? 'on' : 'off'}`, html`${plain(p.name || 'pin ' + pin, 20)} <small>${p.level ? 'on' : 'off'}</small>`)}</li>`)}</ul>`);

const refused = (model, board, t) => {
  const again = repeats(model, board.name, t);
  const some = [...board.counters].filter(([name, n]) => REFUSALS[name] && n > 0).map(([name, n]) => [name, n, REFUSALS[name].short]);
  if (again > 0) some.push(['radioRepeats', again, 'had already']);
  return some.length === 0 ? nothing : html`<p class="refused">refused so far: ${some.map(([name, n, why], i) =>
    html`${i ? ', ' : ''}<span title=${name}>${n} × ${why}</span>`)}</p>`;
};

/** What laws limit. */
export const airtime = (board) => (board.airtime === '' ? nothing : html`<p class="airtime"><small>has sent ${plain(board.airtime, 120)}</small></p>`);

/** Output of its sketch, and warnings of the library: neither is said by its agent. */
export const log = (board) => html`
  ${board.printed.length === 0 ? nothing : html`<h3>its sketch prints</h3>
    <details class="printed"><summary><code>${plain(board.printed.at(-1).text, 80)}</code></summary>
      <ul>${board.printed.slice(0, -1).reverse().map((line) => html`<li><code>${plain(line.text)}</code></li>`)}</ul></details>`}
  ${warnings(board)}`;

const warnings = ({ warned }) => (warned.length === 0 ? nothing : html`<details class="warned"><summary>${warned.length} ${warned.length === 1 ? 'warning' : 'warnings'}</summary>
  <ul>${warned.map((line) => html`<li>${plain(line.text, 300)}</li>`)}</ul></details>`);

export function stateOf(board, t, speaks = false) {
  if (board.offUntil !== undefined && t < board.offUntil) return 'no power';
  if (board.port === 'closed' && speaks) return 'its agent has not opened it';
  return PORTS[board.port] ?? plain(board.port, 20);
}

/** What an agent of this openness can do; one that speaks is not called cut off. */
function opennessWords(agent, state, title) {
  return html`<p class="openness" title="openness(${state})">${plain(title, 30)} ${state === 'totallyClosed' && (agent.said.length > 0 || agent.connected) ? 'does not talk with other devices' : OPENNESS[state] ?? state}.</p>`;
}

function mindOf(app, agent, title, connected, t) {
  const state = openness(agent);
  return html`<div class="mind" data-agent=${agent.name}>
    ${state ? opennessWords({ ...agent, connected }, state, title) : nothing}
    <div>${mind(app, agent, t)}</div></div>`;
}

/** The card of an agent without a board. */
export const boardless = (app, agent, t) => html`<section class="agent hue-injector" data-agent=${agent.name}>
  <h2>${plain(agent.name, 30)} <span class="state">without a board</span></h2>
  ${mindOf(app, agent, agent.name, false, t)}${goal(app, agent.name)}${warnings(agent)}</section>`;

/** What one can have agents and their board do; where there are many, it opens by a click. */
const doing = (app, agents, board, state) => (!app.controls.includes('act') ? nothing : html`<details class="do" ?open=${state.boards.size <= FEW}><summary>have it act</summary>
  ${agents.map((agent) => goal(app, agent.name, agents.length > 1))}${actions(app, board, agents[0].name)}${say(app, board, agents[0].name, state)}${airtime(board)}</details>`);

/** The card of a board, with its agents. */
export function card(app, model, state, board, t, chosen) {
  const agents = agentsAt(state, board.name);
  const speaks = agents.some((agent) => agent.said.length > 0);
  const first = agents[0]?.name;
  const sensors = board.heading === undefined && app.controls.includes('sensor') ? board.sensors.map((each) => sensor(app, board, each, 'card-')) : [];
  return html`<section class="agent ${hueClass(board)} ${chosen ? 'chosen' : ''}" data-board=${board.name} data-port=${board.port}
      data-openness=${(agents[0] && openness(agents[0])) ?? ''} @click=${(e) => e.target.closest('button, input, select, summary, label') || app.choose('board', board.name)}>
    <h2><span class="letter">${letter(board)}</span> ${plain(board.title, 30)} <code>${plain(board.address, 8)}</code>
      <span class="state">${stateOf(board, t, speaks)}</span></h2>
    ${agents.map((agent) => html`${agents.length === 1 && agent.name === board.name ? nothing : html`<h2 class="name">${plain(agent.name, 30)}</h2>`}
      ${mindOf(app, agent, agents.length === 1 ? board.title : agent.name, board.port === 'open', t)}`)}
    ${board.percepts.length || board.pins.size || sensors.length || first !== undefined ? html`<h3>its board</h3>${lamps(app, board)}${sensors}
      ${first === undefined ? nothing : doing(app, agents, board, state)}
      ${done(app, board)}${percepts(board)}` : nothing}
    ${refused(model, board, t)}${log(board)}
  </section>`;
}

/** The last action that the board was asked for. */
export const done = (app, board) => (!board.acted ? nothing : html`<p class="acted" aria-live="polite"><small>${seconds(board.acted.t, 1)}</small> ${asking(app, board.acted.line && { line: board.acted.line }, board.acted.action, html`<code>${plain(board.acted.action, 60)}</code>`)} ${board.acted.error ? html`<b class="bad">✗ ${plain(board.acted.error)}</b>` : '✓ done'}</p>`);
