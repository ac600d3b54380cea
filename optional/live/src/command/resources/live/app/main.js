// Puts the parts together: events into the model, the clock's moment onto the page, hands into commands.

import { html, nothing, render } from '/lib/lit-html/lit-html.js';
import { sniffer, injector } from './air.js';
import { boardPage, rate } from './board.js';
import { boardless, card } from './cards.js';
import { Clock } from './clock.js';
import { readColours } from './colours.js';
import { forgeries, verdicts } from './forge.js';
import { SLOW, afterStory, interfere, player } from './controls.js';
import { JAM, RADIUS, hands, keys } from './hands.js';
import { menu } from './menu.js';
import { Model } from './model.js';
import { agentsAt } from './state.js';
import { drawPlots } from './plots.js';
import { Road } from './road.js';
import * as source from './source.js';
import { YOU, plain, seconds } from './text.js';
import { Timeline, behaviours } from './timeline.js';
import { story } from './phrases.js';
import { answer, box } from './why.js';

/** The text of the page is made anew so often, in ms, while something moves; the road then with each frame. */
const TEXT_EVERY = 100;
/** Text and road so often, where something changes and nothing moves, as a lamp that blinks. */
const STILL_EVERY = 500;
/** And so often plots, and all where nothing has moved and nobody has touched anything for so long. */
const REST_EVERY = 1000;
const REST_AFTER = 10_000;
const IDLE_TEXT_EVERY = 2000;
/** Where nothing moves, that is noticed within so many ms: less than the clock is behind. */
const IDLE_EVERY = 400;
/** Something that is dragged gives a command so often, in ms. */
const COMMAND_EVERY = 100;
/** So long an error stays, in ms. */
const ERROR_STAYS = 8000;

/** Between a vehicle and its menu, in pixels. */
const MENU_AWAY = 34;

const $ = (id) => document.getElementById(id);

const run = { model: new Model(), clock: new Clock(true), about: { source: 'run', live: true, controls: [] }, ended: false };
let shown = run;

const ui = { chosen: undefined, mode: '', held: undefined, standing: undefined, stood: undefined, packet: undefined, flip: 100, tab: 'timeline' };

let road;
let timeline;
let errorTimer;

function showError(error) {
  $('error').textContent = plain(error, 300);
  clearTimeout(errorTimer);
  if (error) errorTimer = setTimeout(() => showError(''), ERROR_STAYS);
}

/** Actions of the user. The parts of the page call these. */
const app = {
  ui,
  typed: undefined,
  typedStand: undefined,
  get controls() {
    return shown.about.controls;
  },
  get ofFile() {
    return shown !== run;
  },

  async send(body) {
    showError(await source.command(body));
  },
  /** Sends commands of a dragged thing: at most ten a second, and always the last one. */
  often(body) {
    later = body;
    if (!waiting) flush();
  },

  redraw: () => drawText(),
  /** Plays from the first event of an agent. */
  play(speed) {
    const { clock, model } = shown;
    clock.leave(model.begin ?? 0, model);
    clock.rate = speed;
    clock.playing = true;
  },
  nowForge() {
    app.follow();
    $('forge').querySelector('button')?.focus();
  },
  /** Closes what is open over the road. */
  letGo() {
    app.choose();
    ui.why = undefined;
    ui.read = $('forged').querySelector('[data-n]')?.dataset.n ?? ui.read;
    drawText();
  },

  get canAsk() {
    return shown.about.why === true;
  },
  /** Whether another moment than the present is shown. */
  get past() {
    return !shown.clock.following;
  },
  /** Has the server answer a question, and shows it. */
  async ask(question, title) {
    const why = { title };
    ui.why = why;
    drawText();
    const { answer: lines, error } = await source.post('/why', question);
    if (ui.why !== why) return;
    ui.why = lines ? { title, lines } : { title, error: error ?? 'The server refused the question' };
    drawText();
    $('why').scrollIntoView({ block: 'nearest' });
  },
  closeWhy() {
    ui.why = undefined;
    drawText();
  },
  /** A row of the time line: the page goes there, and tells why. */
  pick(mark) {
    app.goTo(mark.t);
    if (mark.line && app.canAsk) app.ask({ line: mark.line }, whatOf(mark));
  },

  choose(kind, name) {
    ui.chosen = name === undefined ? undefined : { kind, name };
    app.typed = undefined;
    drawText();
    placeMenu();
  },
  mode(mode) {
    ui.mode = ui.mode === mode ? '' : mode;
    drawText();
  },
  placeOfChosen(state) {
    const { kind, name } = ui.chosen ?? {};
    if (!app.controls.includes(kind === 'obstacle' ? 'obstacle' : 'move')) return undefined;
    return kind === 'board' ? state.boards.get(name)?.place : kind === 'obstacle' ? state.obstacles.get(name)?.place : undefined;
  },
  /** The command that puts something elsewhere. */
  moved({ kind, name }, position) {
    if (kind !== 'obstacle') return { do: 'move', board: name, position };
    return { do: 'obstacle', name, position, radius: shown.model.head.obstacles.get(name)?.radius ?? RADIUS };
  },
  typing: () => (app.typed = { x: $('x').value, y: $('y').value }),
  moveChosen(event) {
    event.preventDefault();
    const to = [Number($('x').value), Number($('y').value)];
    app.typed = undefined;
    app.send(app.moved(ui.chosen, to));
  },
  removeChosen() {
    if (ui.chosen?.kind === 'obstacle') app.send({ do: 'obstacle', name: ui.chosen.name, remove: true });
    ui.chosen = undefined;
  },
  jamChosen() {
    const at = shown.model.stateAt(shown.clock.t).boards.get(ui.chosen?.name)?.place;
    if (at && app.controls.includes('jam')) app.send({ do: 'jam', duration: JAM, position: at });
  },

  standing: (state) => ui.stood ?? state.injector ?? (shown.corner ??= corner(state)) ?? [0, 0],
  typingStand: () => (app.typedStand = { x: $('injector-x').value, y: $('injector-y').value }),
  stand(event) {
    event.preventDefault();
    ui.stood = [Number($('injector-x').value), Number($('injector-y').value)];
    app.typedStand = undefined;
  },
  shout(payload) {
    try {
      app.forge({ payload: payload() });
    } catch (error) {
      showError(error.message);
    }
  },
  replay(packet, flip) {
    app.forge({ payload: packet.payload, ...(flip === undefined ? {} : { flip }) });
  },
  forge(forgery) {
    app.send({ do: 'send', position: app.standing(shown.model.head), ...forgery });
  },
  read(n) {
    ui.read = String(n);
    drawText();
  },
  choosePacket(n) {
    ui.packet = n;
    drawText();
  },
  flip(bit) {
    ui.flip = Math.max(0, Math.floor(bit) || 0);
    drawText();
  },

  follow: () => shown.clock.follow(),
  /** Whether time is the run's own: pause and speed are then the run's too. */
  get inRun() {
    return shown.clock.following && app.controls.includes('speed') && !shown.ended;
  },
  toggle() {
    const { clock, model } = shown;
    if (app.inRun) app.send({ do: 'speed', value: model.head.speed === 0 ? model.head.pace : 0 });
    else clock.toggle(model);
  },
  reverse() {
    const { clock, model } = shown;
    if (clock.following) clock.leave(clock.t, model);
    const on = !(clock.playing && clock.rate < 0);
    clock.rate = Math.abs(clock.rate) * (on ? -1 : 1);
    clock.playing = on;
  },
  step: (direction) => shown.clock.leave(shown.model.neighbour(shown.clock.t, direction), shown.model),
  goTo: (t) => shown.clock.leave(t, shown.model),
  rate(rate) {
    const { clock, model } = shown;
    if (app.inRun) return app.send({ do: 'speed', value: rate });
    if (clock.following) clock.leave(clock.t, model), (clock.playing = true);
    clock.rate = rate * Math.sign(clock.rate);
  },
  opened: (event) => event.target.files[0] && openFile(event.target.files[0]),
  closeFile() {
    shown = run;
    drawText();
  },
};

const whatOf = ({ kind, text, packet }) => (kind === 'packet' ? `this packet to ${packet.destination}` : kind === 'ack' ? 'this answer' : text);

let later;
let waiting = false;
function flush() {
  if (later === undefined) return;
  app.send(later);
  later = undefined;
  waiting = true;
  setTimeout(() => {
    waiting = false;
    flush();
  }, COMMAND_EVERY);
}

/** The first place of the attacker: at a corner, in nobody's way. */
function corner(state) {
  const places = [...state.boards.values()].map((b) => b.place).filter(Boolean);
  return places.length === 0 ? undefined : [Math.round(Math.min(...places.map((p) => p[0]))), Math.round(Math.max(...places.map((p) => p[1])))];
}

async function openFile(file) {
  const { events, bad } = await source.read(file);
  const model = new Model();
  for (const event of events) model.add(event);
  if (model.length === 0) {
    showError(`${file.name} is no trace: none of its lines is an event. Open the trace.jsonl of a run`);
    return;
  }
  const odd = bad.length + model.refused;
  showError(odd ? `${odd} lines of ${file.name} are no events and were left out` + (bad.length ? `; the first is line ${bad[0]}` : '') : '');
  shown = { model, clock: new Clock(false), about: { source: 'trace', live: false, controls: [] }, ended: true };
  drawText();
}

const TABS = { timeline: 'Time line', air: 'Sniffer: what anyone hears', injector: 'Inject packets' };

const LEGEND = html`<ul aria-label="Legend">
  <li><svg width="30" height="16"><circle class="mark-ring" cx="15" cy="8" r="6"></circle></svg>closed lock: only the key opens it</li>
  <li><svg width="30" height="16"><circle class="mark-ring dashed" cx="15" cy="8" r="6"></circle></svg>open lock: all can read it</li>
  <li><svg width="30" height="16"><circle class="mark-ring thin" cx="15" cy="8" r="6"></circle></svg>thin ring: “got it”</li>
  <li><b class="bad">✗</b> lost or refused</li>
  <li><b>?</b> ${YOU}</li>
  <li><svg width="30" height="16"><path class="mark-hatch" d="M4 14 14 2M11 14 21 2M18 14 28 2"></path></svg>jammed</li></ul>`;

function helpOnKeys() {
  const can = app.controls.length > 0;
  return html`<details id="keys"><summary>Keys</summary><p>Space: pause. Left and right: 1 s back and forth. Comma, full stop: event before, next event. R: backwards. + and −: speed. End: live.
    ${can ? 'On the road: Page Up and Page Down choose, arrows move what is chosen (with Shift by 5 m), F shows all, J jams there, Delete takes an obstacle away, Escape lets go.' : ''}</p></details>`;
}

const WHAT = {
  run: 'Boards and their agents. What they tell each other by radio, everybody near can hear.',
  trace: 'A recorded run. Play it forwards and backwards; nothing here can be changed.',
  board: 'One board, without any agent: what it perceives, and what it can do.',
};

/** The text of the page, for the moment that is shown. */
function drawText() {
  const { model, clock, about } = shown;
  const t = clock.t;
  const state = model.stateAt(t);
  const ofBoard = about.source === 'board';
  document.body.dataset.source = about.source;
  $('source').textContent = about.source === 'run' && model.head.speed === 0 ? 'paused' : { run: 'live', board: 'board' }[about.source] ?? 'trace';
  $('what').textContent = state.about || (WHAT[about.source] ?? '');
  tellTime(t);
  const radio = [...state.boards.values()].some((b) => b.radio);
  const sends = radio && app.controls.includes('send');
  ui.standing = sends ? app.standing(state) : state.injector;
  const lines = story(model, state, t);
  const more = [
    state.skipped ? `${state.skipped} events were left out: too many came for this page` : '',
    model.refused ? `${model.refused} lines were no events` : '',
    run.lost && !app.ofFile ? 'the server does not answer' : '',
  ].filter(Boolean);
  render(html`${lines.length === 0 ? html`<li>${plain(state.note || 'Waiting for something to happen …', 200)}</li>` : nothing}
    ${lines.map((line) => html`<li data-n=${line.n}>${line.words}</li>`)}${more.length ? html`<li class="bad" id="losses">${more.join('; ')}</li>` : nothing}`, $('story'));
  render(player(clock, model, app), $('player'));
  render(afterStory(app, state, t), $('after'));
  render(ofBoard || !sends ? nothing : forgeries(app, model, state, t), $('forge'));
  render(ofBoard ? nothing : interfere(app, state, radio), $('interfere'));
  render(menu(app, state), $('menu'));
  const cards = ofBoard ? [] : [...[...state.boards.values()].map((b) => card(app, model, state, b, t, ui.chosen?.name === b.name)),
    ...agentsAt(state, undefined).map((agent) => boardless(app, agent, t))];
  const half = Math.floor(cards.length / 2);
  render(ofBoard ? boardPage(app, model, state, t)
    : [cards.slice(0, half), cards.slice(half)].map((column) => html`<div class="column">${column}</div>`), $('cards'));
  if (ofBoard) return;
  render(html`${radio ? LEGEND : nothing}${helpOnKeys()}`, $('legend'));
  const forged = verdicts(app, model, state, t);
  render(forged.shown, $('forged'));
  $('forged').hidden = !forged.board;
  const tabs = Object.keys(TABS).filter((tab) => tab === 'timeline' || radio && (tab !== 'injector' || sends || state.injector));
  if (!tabs.includes(ui.tab)) ui.tab = 'timeline';
  document.body.dataset.tab = ui.tab;
  render(tabs.map((tab) => html`<button type="button" role="tab" id="tab-${tab}" aria-selected=${tab === ui.tab} aria-controls="panel"
    @click=${() => { ui.tab = tab; drawText(); }}>${TABS[tab]}</button>`), $('tabs'));
  render(html`<div id="timeline-panel" ?hidden=${ui.tab !== 'timeline'}><div class="sides"><div id="timeline" tabindex="0" aria-label="Time line"></div><div ?hidden=${state.behaviours.size === 0 && !state.verdict}>${behaviours(state, t, app.goTo)}
      ${state.verdict ? html`<p id="verdict" class=${state.verdict.accepted ? 'good' : 'bad'}>${plain(state.verdict.text, 200)}</p>` : nothing}</div></div></div>
    ${ui.tab === 'air' ? sniffer(model, state, t, ui.packet, app.choosePacket) : nothing}
    ${ui.tab === 'injector' ? injector(app, model, state, t) : nothing}`, $('panel'));
  render(box(app, state, t), $('asking'));
  render(ui.why ? answer(app, ui.why) : nothing, $('why'));
  $('why').hidden = !ui.why;
  document.body.dataset.why = ui.why ? 1 : 0;
  timeline ??= new Timeline($('timeline'), app.pick);
  if (ui.tab === 'timeline') timeline.draw(model, state, t);
}

let opened = '';

/** The menu opens beside what was chosen, and stays there while there is as much room; while something is dragged it is not in the way. */
function placeMenu() {
  const box = $('menu');
  const room = $('scene');
  const key = ui.chosen && !ui.held?.down ? [ui.chosen.kind, ui.chosen.name, room.clientWidth, room.clientHeight].join(' ') : '';
  box.hidden = key === '' || box.childElementCount === 0;
  if (box.hidden) opened = '';
  if (box.hidden || key === opened) return;
  opened = key;
  const [x, y] = road.pixels(ui.chosen) ?? [0, 0];
  const left = x + MENU_AWAY + box.offsetWidth < room.clientWidth ? x + MENU_AWAY : x - MENU_AWAY - box.offsetWidth;
  box.style.left = Math.max(2, Math.min(left, room.clientWidth - box.offsetWidth - 2)) + 'px';
  box.style.top = Math.max(2, Math.min(y - box.offsetHeight / 2, room.clientHeight - box.offsetHeight - 2)) + 'px';
}

function points(canvas, from, to) {
  const { board, percept, counter } = canvas.dataset;
  if (counter) {
    const b = shown.model.stateAt(to).boards.get(board);
    return b ? b.counted.filter((c) => c.t >= from).map((c) => ({ t: c.t, y: rate(b, counter, c.t) })) : [];
  }
  return shown.model.readings(board, from, to).filter((r) => r.values.has(percept)).map((r) => ({ t: r.t, y: r.values.get(percept) }));
}

let textAt = 0;
let plotsAt = 0;
let stirred = 0;
let drawn = {};
let frames = 0;
let framesAt = 0;
let next;

/** Draws what has changed since; where nothing moves, it is asked seldom, and costs next to nothing. */
function frame(now) {
  const { model, clock, about, ended } = shown;
  clock.tick(now, model, ended);
  begin(model, clock);
  const t = clock.t;
  const state = model.stateAt(t);
  if (ui.held && !ui.held.down && now > ui.held.until) ui.held = undefined;
  const revision = model.revisionAt(t);
  const moves = about.source !== 'board' && road.moves(model, state, t);
  const urgent = road.changed || moves || drawn.moves || drawn.model !== model;
  const changed = urgent || drawn.revision !== revision;
  if (urgent) stirred = now;
  const every = now - stirred < REST_AFTER ? STILL_EVERY : REST_EVERY;
  if (about.source !== 'board' && (urgent || (changed && now - textAt >= every))) road.draw(model, state, t);
  drawn.urgent ||= urgent;
  if (now - textAt >= (drawn.urgent ? TEXT_EVERY : changed ? every : IDLE_TEXT_EVERY)) {
    textAt = now;
    drawText();
    placeMenu();
    if (urgent || now - plotsAt >= REST_EVERY) {
      plotsAt = now;
      drawPlots(t, points);
    }
    drawn = { model, revision };
  } else if (urgent) {
    tellTime(t);
  }
  drawn.moves = moves;
  frames++;
  if (now - framesAt >= 1000) {
    document.documentElement.dataset.fps = Math.round((frames * 1000) / (now - framesAt));
    frames = 0;
    framesAt = now;
  }
  next = moves || ui.held ? requestAnimationFrame(frame) : -setTimeout(() => frame(performance.now()), IDLE_EVERY);
}

/** Draws soon: somebody does something. */
function wake(event) {
  if (event.type === 'pointermove' && event.buttons === 0) return;
  road.changed = true;
  soon();
}

function soon() {
  if (next > 0) return;
  clearTimeout(-next);
  next = requestAnimationFrame(frame);
}

/** A record begins where its agents do; a story that waits for its first viewer has it now. */
function begin(model, clock) {
  if (!clock.live && !shown.begun && model.begin !== undefined) {
    shown.begun = true;
    if (clock.t < model.begin) clock.t = model.begin;
  }
  const { waits, speed } = model.head;
  if (!waits || app.ofFile || !app.controls.includes('speed') || (waits !== 1) === Boolean(shown.slowed)) return;
  shown.slowed = waits !== 1 && waits;
  if (waits !== 1 || speed === SLOW) app.send({ do: 'speed', value: waits });
}

function tellTime(t) {
  $('clock').firstChild.data = seconds(t);
  $('clock').dataset.t = t.toFixed(3);
}

document.addEventListener('dragover', (e) => e.preventDefault());
document.addEventListener('drop', (e) => {
  e.preventDefault();
  if (e.dataTransfer.files[0]) openFile(e.dataTransfer.files[0]);
});
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
  readColours();
  road.recolour();
  road.changed = true;
});

readColours();
road = new Road($('road'), $('labels'), ui, soon);
render(html`<button type="button" id="fit" title="Show all (F)" @click=${() => road.fit()}>fit</button>
  <button type="button" id="nearer" aria-label="nearer" @click=${() => road.zoom(1.5)}>+</button>
  <button type="button" id="farther" aria-label="farther" @click=${() => road.zoom(1 / 1.5)}>−</button>`, $('camera'));
hands($('road'), road, app, () => shown);
keys(app, () => shown);
for (const type of ['pointerdown', 'pointermove', 'pointerup', 'click', 'keydown', 'input', 'change', 'wheel']) document.addEventListener(type, wake, { capture: true, passive: true });
next = requestAnimationFrame(frame);
try {
  run.about = await source.about();
  run.clock = new Clock(run.about.live);
  source.follow((events) => events.forEach((event) => run.model.add(event)), (lost) => {
    run.lost = lost;
    run.ended = lost;
  });
} catch (error) {
  showError(error.message);
}
