// The state of a run, and what an event does to it. States are never changed: each event makes a new one that shares
// what is the same.

export const MOST_BOARDS = 64;
const MOST_BELIEFS = 1000;
const LINES_SAID = 12;
/** How many readings of its counters are kept: one comes a second. */
const COUNTINGS = 40;
/** A change of a belief or counter is shown as new for so long, in seconds. */
export const NEW_FOR = 2.5;

export const text = (x) => (typeof x === 'string' ? x : x === undefined || x === null ? '' : String(x));
export const number = (x, otherwise = 0) => (Number.isFinite(x) ? x : otherwise);
export const texts = (x) => (Array.isArray(x) ? x.map(text) : []);
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

/** The line of the log that tells the same as an event; nothing where that has none. */
export function lineOf(e) {
  switch (e.event) {
    case 'pin': return { event: 'pin', t: e.t, board: e.board, pin: e.pin };
    case 'rf-tx': return Number.isFinite(e.packet) ? { event: 'rf-tx', packet: e.packet } : undefined;
    case 'acted': return e.request > 0 ? { event: 'agent-action', agent: e.agent, request: e.request } : undefined;
    default: return undefined;
  }
}

export const START = {
  t: 0,
  radio: { bitRate: 2000, range: 100, bitErrorRate: 0 },
  speed: 1,
  /** Its speed where it is not paused. */
  pace: 1,
  light: undefined,
  boards: new Map(),
  agents: new Map(),
  /** Whatever the run says of itself. */
  about: '',
  /** Words of agents that tell nothing of the story. */
  aside: new Set(),
  /** Heights of roads, in metres, which go along x. */
  roads: [],
  /** The speed at which a story that waits for its first viewer is to be told. */
  waits: undefined,
  obstacles: new Map(),
  injector: undefined,
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
  /** Whether the emulator tells of it. */
  traced: false,
  offUntil: undefined,
  reset: undefined,
  online: undefined,
  firmware: '',
  radio: true,
  actions: [],
  /** The arguments of its actions, as its agent's program writes them. */
  uses: new Map(),
  pins: new Map(),
  sensors: [],
  percepts: [],
  counters: new Map(),
  counted: [],
  /** How much of the last hour it has sent, in words; empty where that is not known. */
  airtime: '',
  printed: [],
  warned: [],
  acted: undefined,
});

const agent = (name) => ({ name, board: undefined, ended: undefined, beliefs: new Map(), intentions: [], said: [], warned: [] });

const logged = (lines, e) => [...lines, { t: e.t, text: text(e.text) }].slice(-LINES_SAID);

/** Effects of events on an agent. One that no event names has its board's name. */
const ofAgent = {
  __proto__: null,
  agent: (a, e) => ({ ended: e.ended === true ? e.t : undefined }),
  beliefs: (a, e) => {
    const beliefs = new Map([...a.beliefs].filter(([, belief]) => !(belief.gone && e.t - belief.t > NEW_FOR)));
    for (const gone of texts(e.remove)) if (beliefs.has(gone)) beliefs.set(gone, { t: e.t, gone: true });
    for (const added of texts(e.add)) if (beliefs.size < MOST_BELIEFS) beliefs.set(added, { t: e.t, gone: false });
    return { beliefs };
  },
  intentions: (a, e) => ({ intentions: texts(e.intentions).slice(0, 20) }),
  said: (a, e) => ({ said: logged(a.said, e) }),
};

/** Effects of events on a board. (Without a prototype: a trace may name an event `constructor`.) */
const ofBoard = {
  __proto__: null,
  place: (b, e) => {
    const to = place(e.position);
    const stands = to && b.place && to[0] === b.place[0] && to[1] === b.place[1] && (e.heading ?? b.heading) === b.heading;
    return to && !stands ? { place: to, before: b.place, placedAt: e.t, heading: Number.isFinite(e.heading) ? e.heading : b.heading } : {};
  },
  device: (b, e) => ({ address: text(e.address), title: text(e.title) || b.name }),
  'host-id': (b, e) => ({ address: text(e.id) }),
  board: (b, e) => ({
    online: e.online === true,
    port: b.traced ? b.port : e.online === true ? 'open' : 'unplugged',
    address: text(e.address) || b.address,
    ...(e.online === true ? {
      firmware: text(e.firmware),
      radio: e.radio !== false,
      actions: texts(e.actions).slice(0, 100),
      uses: new Map(Object.entries(e.arguments && typeof e.arguments === 'object' ? e.arguments : {}).map(([name, use]) => [name, text(use)])),
    } : {}),
  }),
  port: (b, e) => ({ port: text(e.state) }),
  reset: (b, e) => ({
    reset: { t: e.t, why: text(e.why) },
    pins: new Map([...b.pins].map(([pin, p]) => [pin, { ...p, level: 0, line: undefined }])),
  }),
  fault: (b, e) => (e.do === 'power-cut' ? { offUntil: number(e.until, e.t) } : {}),
  pin: (b, e) => {
    const pin = text(e.pin);
    return { pins: put(b.pins, pin, { name: text(e.name) || pin, level: number(e.level), t: e.t, line: lineOf(e) }) };
  },
  /** A sensor is held at a value, or let go. */
  command: (b, e) => (e.do !== 'sensor' ? {} : {
    sensors: b.sensors.map((s) => (s.pin === e.pin ? { ...s, held: Number.isFinite(e.value) ? e.value : undefined } : s)),
  }),
  percepts: (b, e) => ({ percepts: texts(e.percepts).slice(0, 64) }),
  'counters-of-board': (b, e) => {
    const counters = numbers(e.counters);
    const rises = [...counters].filter(([name, value]) => value > (b.counters.get(name) ?? 0));
    const risen = { t: e.t, rises: new Map(rises.map(([name, value]) => [name, value - (b.counters.get(name) ?? 0)])) };
    return { counters, counted: [...b.counted, risen].slice(-COUNTINGS), airtime: text(e.airtime) };
  },
  printed: (b, e) => ({ printed: [...b.printed, ...text(e.text).split(/[\r\n]+/).filter(Boolean).map((line) => ({ t: e.t, text: line }))].slice(-LINES_SAID) }),
  uart: (b, e) => ofBoard.printed(b, { ...e, text: e.line ?? e.hex }),
  warned: (b, e) => ({ warned: logged(b.warned, e) }),
  acted: (b, e) => ({ acted: { t: e.t, action: text(e.action), error: e.error === undefined ? '' : text(e.error), line: lineOf(e) } }),
};

/** Effects of commands that no other event tells. */
const ofCommand = {
  __proto__: null,
  speed: (s, e) => ({ speed: number(e.value, s.speed), pace: number(e.value) || s.pace }),
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
  send: (s, e) => ({ injector: place(e.position) ?? s.injector }),
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
        traced: true,
        place: place(b.position) ?? [0, 0],
        heading: Number.isFinite(b.heading) ? b.heading : undefined,
        sensors: objects(b.sensors).slice(0, 16).map(({ type, pin }) => ({ type: text(type), pin: Number.isFinite(pin) ? pin : text(pin), held: undefined })),
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
  about: (s, e) => ({ about: text(e.text), aside: new Set(texts(e.aside)), roads: (Array.isArray(e.roads) ? e.roads : []).filter(Number.isFinite).slice(0, 6) }),
  story: (s, e) => ({ waits: Number.isFinite(e.speed) ? e.speed : undefined }),
  verdict: (s, e) => ({ verdict: { text: text(e.text), accepted: e.accepted === true } }),
  skipped: (s, e) => ({ skipped: s.skipped + number(e.count) }),
};

/** The state after an event. */
export function fold(state, event) {
  let next = { ...state, t: Math.max(state.t, event.t), ...(ofRun[event.event]?.(state, event) ?? {}) };
  const change = ofBoard[event.event];
  const name = event.board;
  // The injector has no board.
  if (typeof name === 'string' && change && (next.boards.has(name) || next.boards.size < MOST_BOARDS)) {
    const b = next.boards.get(name) ?? board(name, next.boards.size);
    const changes = change(b, event);
    // A vehicle that tells again where it stands changes nothing.
    if (Object.keys(changes).length > 0 || !next.boards.has(name)) next.boards = put(next.boards, name, { ...b, ...changes });
  }
  const mind = ofAgent[event.event] ?? (event.event === 'warned' && typeof name !== 'string' ? ofBoard.warned : undefined);
  const who = typeof event.agent === 'string' ? event.agent : mind && name;
  if (typeof who === 'string' && (next.agents.has(who) ? mind || (typeof name === 'string' && name !== next.agents.get(who).board) : mind && next.agents.size < MOST_BOARDS)) {
    const a = next.agents.get(who) ?? agent(who);
    next.agents = put(next.agents, who, { ...a, board: typeof name === 'string' ? name : a.board, ...(mind?.(a, event) ?? {}) });
  }
  return next;
}

/** The agents of a board that have not ended; without a name, those without a board. */
export const agentsAt = (state, name) => [...state.agents.values()].filter((a) => a.board === name && a.ended === undefined);
