// The run: all its events, and its state at any moment. Knows nothing of drawing, of the network, or of the clock.
//
// A checkpoint is a reference to a state, and any moment is at most CHECKPOINT events away from one. Lists that only
// grow (packets, marks, readings) are kept once, in order of time; a picture of a moment takes what is not later.

import { isFor } from './packet.js';
import { MOST_BOARDS, START, fold, lineOf, number, text, texts } from './state.js';

const CHECKPOINT = 256;
/** As many as the server keeps. Beyond, the oldest quarter is forgotten. */
const MOST_EVENTS = 200_000;
/** A pin that changed within this time blinks: the time line shows only its first change. */
const BLINK = 1;
/** Packets that are on the air at one time are few. */
const MOST_EARLY = 64;

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

/** Events by which a run is known to have begun. */
const AGENTS = new Set(['said', 'beliefs', 'intentions', 'acted']);
/** An attack may use any of so many packets before. */
const USED = 500;

const idIn = (packet) => packet.payload.slice(24, 26) + packet.payload.slice(28, 32);

/** The number of bits in which two payloads differ, 2 for all that differ in more. */
function bitsApart(one, other) {
  let bits = 0;
  for (let i = 0; i < one.length && bits < 2; i++) {
    let differing = parseInt(one[i], 16) ^ parseInt(other[i], 16);
    for (; differing; differing &= differing - 1) bits++;
  }
  return Math.min(bits, 2);
}

export class Model {
  #events = [];
  /** The time of each event, but never less than that of the one before. */
  #times = [];
  #revisions = [];
  #checkpoints = [START];
  #head = START;
  #cursor = { index: 0, state: START };
  #readings = new Map();
  #last = new Map();
  #numbered = 0;
  /** Rises with each event that changes what can be seen: that a board was polled does not. */
  #revision = 0;
  /** Reactions of boards to a packet that has not ended: they have it before its trailer. */
  #early = [];

  /** Packets that could be read on the air, in order of their ends. */
  packets = [];
  /** Rows of the time line. */
  marks = [];
  /** Collisions and damaged packets. */
  losses = [];
  /** Events that were none. */
  refused = 0;
  /** The time of the first event of an agent. */
  begin;

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
    if (Object.keys(before).some((key) => key !== 't' && before[key] !== this.#head[key])) this.#revision++;
    if (this.begin === undefined && AGENTS.has(event.event)) this.begin = this.#head.t;
    this.#events.push(event);
    this.#times.push(this.#head.t);
    this.#revisions.push(this.#revision);
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

  /** Another number wherever something else is to be seen than at another time, but for what moves meanwhile. */
  revisionAt(t) {
    return this.#revisions[upTo(this.#times, t, (time) => time) - 1] ?? -1;
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
    this.#revisions.splice(0, gone);
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
        this.#catchUp();
        break;
      case 'rf-rx':
      case 'rf-damaged':
        this.#arrived({ e, t: s.t });
        if (e.event === 'rf-damaged') this.losses.push({ t: s.t, board: text(e.board), why: text(e.why) });
        break;
      case 'rf-collision':
        this.losses.push({ t: s.t, board: text(e.board), why: 'collision', boards: texts(e.boards) });
        break;
      case 'host-handed':
        this.#arrived({ e, t: s.t });
        break;
      case 'percepts':
        this.#reading(e, s);
        break;
      case 'said':
        this.#mark(s, 'said', e.board, text(e.text), { agent: text(e.agent) || text(e.board), aside: s.aside.has(text(e.text)) });
        break;
      case 'pin':
        this.#pin(e, s);
        break;
      case 'message':
        this.#mark(s, 'heard', e.board, `${text(e.from)} → ${text(e.to)}: ${text(e.performative)} ${text(e.text)}`, { event: e });
        break;
      case 'acted':
        this.#mark(s, 'acted', e.board, e.error === undefined ? text(e.action) : `${text(e.action)}: ${text(e.error)}`, { line: lineOf(e) });
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
    this.#revision++;
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
      place: name === 'injector' ? s.injector : s.boards.get(name)?.place,
      payload: text(e.payload),
      destination: text(e.destination),
      origin: text(e.origin),
      kind: text(e.kind),
      sealed: e.sealed === true,
      content: typeof e.content === 'string' ? e.content : undefined,
      answers: text(e.answers),
      trailer: text(e.trailer),
      bits: number(e.bits),
      heard: [],
      handed: [],
    };
    if (name === 'injector') packet.attack = this.#attack(packet);
    const boards = [...s.boards.values()];
    packet.to = packet.kind === 'acknowledgement'
      ? this.#answered(packet)
      : boards.filter((b) => b.name !== name && isFor(packet.destination, b.address)).map((b) => b.name);
    // The same bytes again within two seconds: a repeat of a message, or a replay.
    packet.again = this.packets.slice(-8).some((p) => p.payload === packet.payload && p.kind !== 'acknowledgement');
    this.packets.push(packet);
    this.#mark(s, packet.kind === 'acknowledgement' ? 'ack' : 'packet', name, '', { packet, line: lineOf(e) });
  }

  /** What the attacker did with what was heard before: `shout`, `replay`, `flip`, `key`, or nothing that is known. */
  #attack({ payload, kind, origin, destination }) {
    if (kind === 'broadcast') return 'shout';
    const genuine = this.packets.slice(-USED).filter((p) => p.board !== 'injector' && p.payload.length === payload.length);
    if (genuine.some((p) => p.payload === payload)) return 'replay';
    if (genuine.some((p) => bitsApart(p.payload, payload) === 1)) return 'flip';
    return genuine.some((p) => p.sealed && p.origin === origin && p.destination === destination) ? 'key' : '';
  }

  /** The board for which an acknowledgement is: of whom the acknowledger last heard a unicast for itself. */
  #answered(answer) {
    for (let i = this.packets.length - 1; i >= Math.max(0, this.packets.length - 64); i--) {
      const p = this.packets[i];
      if (p.kind !== 'acknowledgement' && p.board !== 'injector' && (p.destination === answer.origin || p.kind === 'fragment')) {
        p.answeredAt ??= answer.t;
        return [p.board];
      }
    }
    return [];
  }

  #arrived(arrival) {
    this.#revision++;
    if (arrival.e.event === 'host-handed' ? this.#handed(arrival) : this.#heard(arrival)) return;
    this.#early.push(arrival);
    if (this.#early.length > MOST_EARLY) this.#early.shift();
  }

  #catchUp() {
    const { start, end, trailer } = this.packets.at(-1);
    if (!trailer) return;
    const early = this.#early;
    this.#early = [];
    for (const arrival of early) {
      if (arrival.t > start && arrival.t <= end) this.#arrived(arrival);
      else this.#early.push(arrival);
    }
  }

  /** Whether there is a packet of which somebody has heard. */
  #heard({ e, t }) {
    const start = number(e.start, e.t);
    for (let i = this.packets.length - 1; i >= Math.max(0, this.packets.length - 64); i--) {
      const p = this.packets[i];
      if (p.board === e.from && Math.abs(p.start - start) < 0.002) {
        p.heard.push({ t, board: text(e.board), why: e.event === 'rf-rx' ? '' : text(e.why) || 'damaged' });
        return true;
      }
    }
    return false;
  }

  /** Whether there is a packet that was handed over. */
  #handed({ e, t }) {
    const fitting = this.packets.slice(-64).filter((p) => p.origin === e.origin && p.destination === e.destination
      && p.heard.some((h) => h.board === e.board && !h.why));
    // A message's id is in the nonce of its packet (SPEC 4.3). A later one with the same id is a copy.
    const packet = fitting.find((p) => p.sealed && idIn(p) === e.id) ?? fitting.findLast((p) => !p.sealed || p.kind === 'fragment');
    packet?.handed.push({ t, board: text(e.board), content: text(e.content) });
    return packet !== undefined;
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
    if (!(often && blinks)) this.#mark(s, 'pin', e.board, words, { line: lineOf(e) });
    this.#last.set(key, { t: s.t, blinks: often });
  }

  #disturbed(e, s) {
    const what = text(e.do);
    const isCommand = e.event === 'command';
    // A dragged vehicle or slider sends many commands: those of a second are one row, which tells the last.
    const key = (isCommand ? 'command ' : '') + what + text(e.board);
    const { t = -1, mark } = this.#last.get(key) ?? {};
    if (isCommand) this.#last.set(key, { t: s.t, mark });
    if (isCommand && (what === 'send' || what === 'act')) return;
    if (isCommand && mark && s.t - t < 1) {
      mark.event = e;
      this.#revision++;
      return;
    }
    // The fault that a command made.
    if (e.event === 'fault' && s.t - (this.#last.get('command ' + what + text(e.board))?.t ?? -1) < 0.1) return;
    this.#mark(s, 'fault', e.board, what, { event: e });
    if (isCommand) this.#last.set(key, { t: s.t, mark: this.marks.at(-1) });
  }
}
