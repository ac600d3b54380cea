// The run as a fold of its events. Knows nothing of drawing, of the network, or of the clock.
//
// States are never changed: each event makes a new one that shares what is the same. So a checkpoint is a reference,
// and any moment is at most CHECKPOINT events away from one. What is only appended (packets, marks, readings) is kept
// once, in order of time; who draws a moment takes what is not later.

import { isFor } from './packet.js';

const CHECKPOINT = 256;
/** As many as the server keeps. Beyond, the oldest quarter is forgotten. */
const MOST_EVENTS = 200_000;
const MOST_BOARDS = 64;
const MOST_BELIEFS = 200;
const LINES_SAID = 12;
/** How many readings of its counters are kept: one comes a second. */
const COUNTINGS = 40;
/** A change of a belief or counter is shown as new for so long, in seconds. */
export const NEW_FOR = 2.5;
/** A pin that changed within this time blinks: the time line shows only its first change. */
const BLINK = 1;

const text = (x) => (typeof x === 'string' ? x : x === undefined || x === null ? '' : String(x));
const number = (x, otherwise = 0) => (Number.isFinite(x) ? x : otherwise);
const texts = (x) => (Array.isArray(x) ? x.map(text) : []);
const objects = (x) => (Array.isArray(x) ? x.filter((o) => o && typeof o === 'object') : []);
const place = (x) =>
  Array.isArray(x) && Number.isFinite(x[0]) && Number.isFinite(x[1]) ? [x[0], x[1]] : undefined;
const numbers = (x) =>
  new Map(Object.entries(x && typeof x === 'object' ? x : {}).filter(([, value]) => Number.isFinite(value)));

const put = (map, key, value) => new Map(map).set(key, value);
const without = (map, key) => {
  const rest = new Map(map);
  rest.delete(key);
  return rest;
};

export const START = {
  t: 0,
  radio: { bitRate: 2000, range: 100, bitErrorRate: 0 },
  speed: 1,
  light: undefined,
  boards: new Map(),
  obstacles: new Map(),
  stranger: undefined,
  jams: [],
  jamPlace: undefined,
  behaviours: new Map(),
  note: '',
  verdict: undefined,
  skipped: 0,
};

const board = (name, index) => ({
  name,
  index,
  title: name,
  address: '',
  place: undefined,
  before: undefined,
  placedAt: -1,
  heading: undefined,
  port: '',
  offUntil: undefined,
  reset: undefined,
  online: undefined,
  firmware: '',
  actions: [],
  pins: new Map(),
  percepts: [],
  beliefs: new Map(),
  intentions: [],
  counters: new Map(),
  counted: [],
  said: [],
  acted: undefined,
});

/** What an event does to a board. (Without a prototype: a stranger's trace may name an event `constructor`.) */
const ofBoard = {
  __proto__: null,
  place: (b, e) => {
    const to = place(e.position);
    return to ? { place: to, before: b.place, placedAt: e.t, heading: Number.isFinite(e.heading) ? e.heading : b.heading } : {};
  },
  device: (b, e) => ({ address: text(e.address), title: text(e.title) || b.name }),
  'host-id': (b, e) => ({ address: text(e.id) }),
  board: (b, e) => ({
    online: e.online === true,
    port: e.online === true ? 'open' : 'unplugged',
    address: text(e.address),
    title: text(e.address) || b.name,
    firmware: text(e.firmware),
    actions: texts(e.actions).slice(0, 100),
  }),
  port: (b, e) => ({ port: text(e.state) }),
  reset: (b, e) => ({
    reset: { t: e.t, why: text(e.why) },
    offUntil: undefined,
    pins: new Map([...b.pins].map(([pin, p]) => [pin, { ...p, level: 0 }])),
  }),
  fault: (b, e) => (e.do === 'power-cut' ? { offUntil: number(e.until, e.t) } : {}),
  pin: (b, e) => {
    const pin = text(e.pin);
    return { pins: put(b.pins, pin, { name: text(e.name) || pin, level: number(e.level), t: e.t }) };
  },
  percepts: (b, e) => ({ percepts: texts(e.percepts).slice(0, 64) }),
  beliefs: (b, e) => {
    const beliefs = new Map([...b.beliefs].filter(([, belief]) => !(belief.gone && e.t - belief.t > NEW_FOR)));
    for (const gone of texts(e.remove)) if (beliefs.has(gone)) beliefs.set(gone, { t: e.t, gone: true });
    for (const added of texts(e.add)) if (beliefs.size < MOST_BELIEFS) beliefs.set(added, { t: e.t, gone: false });
    return { beliefs };
  },
  intentions: (b, e) => ({ intentions: texts(e.intentions).slice(0, 20) }),
  'counters-of-board': (b, e) => {
    const counters = numbers(e.counters);
    const rises = [...counters].filter(([name, value]) => value > (b.counters.get(name) ?? 0));
    const risen = { t: e.t, rises: new Map(rises.map(([name, value]) => [name, value - (b.counters.get(name) ?? 0)])) };
    return { counters, counted: [...b.counted, risen].slice(-COUNTINGS) };
  },
  said: (b, e) => ({ said: [...b.said, { t: e.t, text: text(e.text) }].slice(-LINES_SAID) }),
  acted: (b, e) => ({ acted: { t: e.t, action: text(e.action), error: e.error === undefined ? '' : text(e.error) } }),
};

/** What a command does that no other event tells. */
const ofCommand = {
  __proto__: null,
  speed: (s, e) => ({ speed: number(e.value, s.speed) }),
  radio: (s, e) => ({
    radio: { ...s.radio, bitErrorRate: number(e.bitErrorRate, s.radio.bitErrorRate), range: number(e.range, s.radio.range) },
  }),
  light: (s, e) => ({ light: number(e.value, s.light) }),
  obstacle: (s, e) => {
    const name = text(e.name);
    if (e.remove === true) return { obstacles: without(s.obstacles, name) };
    const before = s.obstacles.get(name);
    const at = place(e.position) ?? before?.place;
    return at ? { obstacles: put(s.obstacles, name, { name, place: at, radius: number(e.radius, before?.radius ?? 0.5) }) } : {};
  },
  send: (s, e) => ({ stranger: place(e.position) ?? s.stranger }),
  jam: (s, e) => jam(s, e.t, e.t + number(e.duration, 0), place(e.position)),
};

/** A jam is told as a command, as a fault, or as both: the command knows the place. */
function jam(s, start, until, at) {
  const same = s.jams.find((known) => Math.abs(known.start - start) < 0.01);
  const rest = s.jams.filter((known) => known !== same && known.until > start - 10).slice(-20);
  return { jams: [...rest, { start, until, place: at ?? same?.place }] };
}

const ofRun = {
  __proto__: null,
  scenario: (s, e) => {
    let boards = s.boards;
    for (const b of objects(e.boards).slice(0, MOST_BOARDS)) {
      const known = boards.get(text(b.name)) ?? board(text(b.name), boards.size);
      boards = put(boards, known.name, {
        ...known,
        place: place(b.position) ?? [0, 0],
        heading: Number.isFinite(b.heading) ? b.heading : undefined,
        pins: new Map(objects(b.watch).map((w) => [text(w.pin), { name: text(w.name), level: 0, t: 0 }])),
      });
    }
    return {
      boards,
      light: Number.isFinite(e.world?.light) ? e.world.light : undefined,
      radio: { ...s.radio, ...Object.fromEntries(numbers(e.radio)) },
      obstacles: new Map(objects(e.world?.obstacles).filter((o) => place(o.position)).map((o) =>
        [text(o.name), { name: text(o.name), place: place(o.position), radius: number(o.radius, 0.5) }])),
    };
  },
  command: (s, e) => ofCommand[e.do]?.(s, e) ?? {},
  fault: (s, e) => (e.do === 'jam' ? jam(s, e.t, number(e.until, e.t), place(e.position)) : {}),
  behaviour: (s, e) => {
    const n = number(e.number);
    const before = s.behaviours.get(n);
    const observedAt = e.observed === true ? before?.observedAt ?? e.t : undefined;
    return { behaviours: put(s.behaviours, n, { number: n, text: text(e.text) || before?.text || '', observedAt }) };
  },
  note: (s, e) => ({ note: text(e.text) }),
  verdict: (s, e) => ({ verdict: { text: text(e.text), accepted: e.accepted === true } }),
  skipped: (s, e) => ({ skipped: s.skipped + number(e.count) }),
};

/** The state after an event. */
export function fold(state, event) {
  let next = { ...state, t: Math.max(state.t, event.t), ...(ofRun[event.event]?.(state, event) ?? {}) };
  const change = ofBoard[event.event];
  const name = event.board;
  // A stranger has no board.
  if (typeof name === 'string' && change && (next.boards.has(name) || next.boards.size < MOST_BOARDS)) {
    const b = next.boards.get(name) ?? board(name, next.boards.size);
    next.boards = put(next.boards, name, { ...b, ...change(b, event) });
  }
  return next;
}

/** The number of entries whose `at` is not later than t. */
function upTo(entries, t, at = (entry) => entry.t) {
  let low = 0;
  let high = entries.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (at(entries[middle]) <= t) low = middle + 1;
    else high = middle;
  }
  return low;
}

export class Model {
  #events = [];
  /** The time of each event, but never less than that of the one before. */
  #times = [];
  #checkpoints = [START];
  #head = START;
  #cursor = { index: 0, state: START };
  #readings = new Map();
  #last = new Map();
  #numbered = 0;

  /** What could be read of the air, in order of the ends. */
  packets = [];
  /** Rows of the time line. */
  marks = [];
  /** Collisions and damaged packets. */
  losses = [];
  /** Events that were none. */
  refused = 0;

  get end() {
    return this.#head.t;
  }

  get head() {
    return this.#head;
  }

  get length() {
    return this.#events.length;
  }

  /** Takes an event; false, and counted, if it is none. */
  add(event) {
    // Only the server knows what it left out, and not when that was.
    if (event?.event === 'skipped') event = { t: this.end, ...event };
    if (event === null || typeof event !== 'object' || !Number.isFinite(event.t) || typeof event.event !== 'string') {
      this.refused++;
      return false;
    }
    if (this.#events.length >= MOST_EVENTS) this.#forget();
    const before = this.#head;
    this.#head = fold(before, event);
    this.#note(event, before);
    this.#events.push(event);
    this.#times.push(this.#head.t);
    if (this.#events.length % CHECKPOINT === 0) this.#checkpoints.push(this.#head);
    return true;
  }

  /** The state at a time, forwards and backwards. */
  stateAt(t) {
    const index = upTo(this.#times, t, (time) => time);
    if (index === this.#events.length) return this.#head;
    const back = Math.floor(index / CHECKPOINT);
    let { index: i, state } = this.#cursor;
    if (i > index || i < back * CHECKPOINT) {
      i = back * CHECKPOINT;
      state = this.#checkpoints[back];
    }
    for (; i < index; i++) state = fold(state, this.#events[i]);
    this.#cursor = { index, state };
    return state;
  }

  /** The packets that are on the air at a time, and those that ended at most `after` seconds before. */
  onAir(t, after) {
    const found = [];
    for (let i = upTo(this.packets, t - after); i < this.packets.length && found.length < 64; i++) {
      const packet = this.packets[i];
      if (packet.start <= t) found.push(packet);
      else if (packet.start > t + 1) break;
    }
    return found;
  }

  /** The last packets that have ended, newest first. */
  heardAir(t, most) {
    const n = upTo(this.packets, t);
    return this.packets.slice(Math.max(0, n - most), n).reverse();
  }

  lossesSince(t, after) {
    return this.losses.slice(upTo(this.losses, t - after), upTo(this.losses, t));
  }

  /** How many rows of the time line there are at a time. */
  marksUpTo(t) {
    return upTo(this.marks, t);
  }

  /** The readings of a board in a stretch of time: `{t, values}`. */
  readings(board, from, to) {
    const all = this.#readings.get(board) ?? [];
    // The one before holds still at the beginning.
    return all.slice(Math.max(0, upTo(all, from) - 1), upTo(all, to));
  }

  /** The time of the next mark after t, or of the last one before it. */
  neighbour(t, direction) {
    const n = upTo(this.marks, direction > 0 ? t + 1e-6 : t - 1e-6);
    return (direction > 0 ? this.marks[n] : this.marks[n - 1])?.t ?? (direction > 0 ? this.end : 0);
  }

  #forget() {
    const gone = Math.floor(MOST_EVENTS / 4 / CHECKPOINT) * CHECKPOINT;
    this.#events.splice(0, gone);
    this.#times.splice(0, gone);
    this.#checkpoints.splice(0, gone / CHECKPOINT);
    this.#cursor = { index: 0, state: this.#checkpoints[0] };
    const begin = this.#times[0];
    for (const log of [this.packets, this.marks, this.losses, ...this.#readings.values()]) {
      log.splice(0, upTo(log, begin));
    }
  }

  #note(e, before) {
    const s = this.#head;
    switch (e.event) {
      case 'rf-tx':
        this.#packet(e, s);
        break;
      case 'rf-rx':
      case 'rf-damaged':
        this.#heard(e);
        if (e.event === 'rf-damaged') this.losses.push({ t: s.t, board: text(e.board), why: text(e.why) });
        break;
      case 'rf-collision':
        this.losses.push({ t: s.t, board: text(e.board), why: 'collision', boards: texts(e.boards) });
        break;
      case 'host-handed':
        this.#handed(e);
        break;
      case 'percepts':
        this.#reading(e, s);
        break;
      case 'said':
        this.#mark(s, 'said', e.board, text(e.text));
        break;
      case 'pin':
        this.#pin(e, s);
        break;
      case 'message':
        this.#mark(s, 'heard', e.board, `${text(e.from)} → ${text(e.to)}: ${text(e.force)} ${text(e.text)}`, { event: e });
        break;
      case 'acted':
        this.#mark(s, 'acted', e.board, e.error === undefined ? text(e.action) : `${text(e.action)}: ${text(e.error)}`);
        break;
      case 'behaviour':
        if (e.observed === true && before.behaviours.get(e.number)?.observedAt === undefined) {
          this.#mark(s, 'behaviour', undefined, text(e.text), { number: number(e.number) });
        }
        break;
      case 'fault':
      case 'command':
        this.#disturbed(e, s);
        break;
      case 'reset':
        if (e.why === 'watchdog') this.#mark(s, 'fault', e.board, 'reset by its watchdog');
        break;
      case 'verdict':
        this.#mark(s, 'verdict', undefined, text(e.text), { accepted: e.accepted === true });
        break;
    }
  }

  #mark(s, kind, name, words, more = {}) {
    this.marks.push({ t: s.t, n: this.#numbered++, kind, board: typeof name === 'string' ? name : undefined, text: words, ...more });
  }

  #packet(e, s) {
    const name = text(e.board);
    const packet = {
      n: this.#numbered++,
      t: s.t,
      start: number(e.start, s.t),
      end: number(e.end, s.t),
      board: name,
      place: name === 'stranger' ? s.stranger : s.boards.get(name)?.place,
      payload: text(e.payload),
      destination: text(e.destination),
      origin: text(e.origin),
      kind: text(e.kind),
      sealed: e.sealed === true,
      content: typeof e.content === 'string' ? e.content : undefined,
      answers: text(e.answers),
      bits: number(e.bits),
      heard: [],
      handed: [],
    };
    const boards = [...s.boards.values()];
    packet.to = packet.kind === 'acknowledgement'
      ? this.#answered(packet)
      : boards.filter((b) => b.name !== name && isFor(packet.destination, b.address)).map((b) => b.name);
    // The same bytes again within two seconds: a repeat of a message, or a replay.
    packet.again = this.packets.slice(-8).some((p) => p.payload === packet.payload && p.kind !== 'acknowledgement');
    this.packets.push(packet);
    this.#mark(s, packet.kind === 'acknowledgement' ? 'ack' : 'packet', name, '', { packet });
  }

  /** The board for which an acknowledgement is: of whom the acknowledger last heard a unicast for itself. */
  #answered(answer) {
    for (let i = this.packets.length - 1; i >= Math.max(0, this.packets.length - 64); i--) {
      const p = this.packets[i];
      if (p.kind !== 'acknowledgement' && p.board !== 'stranger' && (p.destination === answer.origin || p.kind === 'piece')) {
        p.answeredAt ??= answer.t;
        return [p.board];
      }
    }
    return [];
  }

  #heard(e) {
    const start = number(e.start, e.t);
    for (let i = this.packets.length - 1; i >= Math.max(0, this.packets.length - 64); i--) {
      const p = this.packets[i];
      if (p.board === e.from && Math.abs(p.start - start) < 0.002) {
        p.heard.push({ t: this.#head.t, board: text(e.board), why: e.event === 'rf-rx' ? '' : text(e.why) || 'damaged' });
        return;
      }
    }
  }

  #handed(e) {
    for (let i = this.packets.length - 1; i >= Math.max(0, this.packets.length - 64); i--) {
      const p = this.packets[i];
      const here = p.heard.some((h) => h.board === e.board && !h.why);
      if (here && p.origin === e.origin && p.destination === e.destination) {
        p.handed.push({ t: this.#head.t, board: text(e.board) });
        return;
      }
    }
  }

  #reading(e, s) {
    const name = text(e.board);
    const values = new Map();
    for (const percept of texts(e.percepts)) {
      const [, functor, value] = /^([a-z]\w*)\((-?\d+(?:\.\d+)?)\)$/.exec(percept) ?? [];
      if (functor !== undefined && values.size < 8) values.set(functor, Number(value));
    }
    if (!this.#readings.has(name) && this.#readings.size >= MOST_BOARDS) return;
    const all = this.#readings.get(name) ?? [];
    all.push({ t: s.t, values });
    this.#readings.set(name, all);
  }

  #pin(e, s) {
    const key = text(e.board) + ' ' + text(e.pin);
    const { t = -BLINK, blinks = false } = this.#last.get(key) ?? {};
    const often = s.t - t < BLINK;
    const words = (text(e.name) || 'pin ' + text(e.pin)) + (often ? ' blinks' : number(e.level) ? ' on' : ' off');
    if (!(often && blinks)) this.#mark(s, 'pin', e.board, words);
    this.#last.set(key, { t: s.t, blinks: often });
  }

  #disturbed(e, s) {
    const what = text(e.do);
    // Of a dragged vehicle or slider only the first command of a second is a row of its own.
    const key = e.event === 'command' ? 'command ' + what : what;
    const t = this.#last.get(key + text(e.board))?.t ?? -1;
    if (e.event === 'command') this.#last.set(key + text(e.board), { t: s.t });
    if (e.event === 'command' && (what === 'send' || what === 'act' || s.t - t < 1)) return;
    // The fault that a command made.
    if (e.event === 'fault' && s.t - (this.#last.get('command ' + what + text(e.board))?.t ?? -1) < 0.1) return;
    this.#mark(s, 'fault', e.board, what, { event: e });
  }
}
