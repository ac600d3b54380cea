// Events in plain words.

import { YOU, listed, plain, rounded } from './text.js';

/** Why a board refuses what it hears: the counters that tell it (SPEC 4.5). */
export const REFUSALS = {
  __proto__: null,
  radioBadTag: { short: 'wrong tag', why: 'forged: its tag is wrong' },
  radioReplayed: { short: 'heard before', why: 'replayed: its number was used before' },
  radioStale: { short: 'too old', why: 'too old: its number is below what was accepted before' },
  radioNoKey: { short: 'no key', why: 'it has no key for this sender' },
  radioOwn: { short: 'my own name', why: 'a fake: it claims to come from this very board' },
  radioBadFrames: { short: 'no frame', why: 'not understood: its bytes are no frame' },
  radioReserved: { short: 'reserved address', why: 'not understood: its address is reserved' },
  radioFragmentsDropped: { short: 'impossible fragment', why: 'a fragment of an impossible shape' },
  radioReplayFull: { short: 'too many senders', why: 'it cannot remember the number of one more sender' },
  radioQueueFull: { short: 'queue full', why: 'good, but no place was left: nobody took the messages before' },
  radioBlocked: { short: 'radio closed', why: 'its agent wants no messages' },
};

/** Not refused, but not taken either. */
const LEFT = {
  __proto__: null,
  radioNotForUs: 'ignored it: it is for another device or group',
  radioRepeats: 'has had it already, and takes it only once',
  radioDamaged: 'heard only damaged bytes',
  radioBadProofs: 'left it: as an answer to its own message it proves nothing',
  radioMissed: 'missed it: it was busy',
};

export const titleOf = (state, name) =>
  name === 'injector' ? YOU : plain(state.boards.get(name)?.title ?? name ?? '', 24);

const titleOfAddress = (state, address) =>
  plain([...state.boards.values()].find((b) => b.address === address)?.title ?? address, 24);

/** So many of the last packets are looked at. */
export const LAST = 500;
/** A packet that nobody has heard within this time, in seconds, is lost. */
const HEARD_WITHIN = 1;

/** The last sealed packet to one device that has it: what there is to forge. */
export const genuine = (packets) => packets.find((p) => p.board !== 'injector' && p.sealed && p.kind === 'unicast' && p.to.length === 1 && p.handed.length > 0);

/** The board that an attack was to deceive: for a shout, the one that last had a sealed packet from the same sender. */
export function victim(packets, packet) {
  const to = packet.kind === 'broadcast' ? genuine(packets.filter((p) => p.origin === packet.origin && p.t < packet.start))?.to : packet.to;
  return to?.length === 1 ? to[0] : undefined;
}

const ATTACKS = {
  __proto__: null,
  shout: (p, who) => `You shouted “${plain(p.content ?? '', 30)}” as ${who}`,
  replay: () => 'You replayed a packet',
  flip: () => 'You changed one bit',
  key: () => 'You made up a key',
};

export const ALREADY = 'had it already and repeats its answer; its agent hears nothing';

/** An attack, and what has come of it at the board that it was for. */
function attackWords(model, state, p, t) {
  const did = (ATTACKS[p.attack] ?? (() => 'You sent a packet'))(p, titleOfAddress(state, p.origin));
  const board = victim(model.heardAir(t, LAST), p);
  if (board === undefined) return did + '.';
  const who = titleOf(state, board);
  const heard = p.heard.find((h) => h.board === board && h.t <= t);
  if (!heard) return t < p.end + HEARD_WITHIN ? `${did} …` : `${did}: ${who} did not hear it.`;
  const { what, counters } = outcome(model, p, heard, t);
  const came = {
    damaged: 'heard it damaged', untold: 'heard it …', repeated: ALREADY,
    taken: p.sealed ? 'took it' : 'heard it, as a shout only, which proves nothing',
    refused: 'refused it, ' + REFUSALS[counters[0]]?.short,
    left: LEFT[counters[0]],
  }[what] ?? 'heard it, and told of no refusal';
  return `${did}: ${who} ${came}.`;
}

/** A packet in words for people who have never seen one. */
function packetWords(model, state, p, t) {
  if (p.board === 'injector') return attackWords(model, state, p, t);
  const who = titleOf(state, p.board);
  if (p.kind === 'broadcast') {
    return `${who} calls to all in range: “${plain(p.content ?? '', 40)}”. An open lock: everybody can read it, and nobody can be sure who sent it.`;
  }
  const again = p.again ? ', once more in case the first was lost' : '';
  if (p.kind === 'multicast') {
    return `${who} sends to the group ${plain(p.destination, 4)}${again}. A closed lock: only those with the group’s key can read it.`;
  }
  if (p.kind === 'unicast') {
    const done = p.answeredAt !== undefined && p.answeredAt <= state.t ? ' The answer came back: it has arrived.' : '';
    return `${who} sends to ${titleOfAddress(state, p.destination)} alone${again}. A closed lock: only these two have the key.${done}`;
  }
  if (p.kind === 'fragment') return `${who} sends a part of a longer message.`;
  return `${who} sends bytes that no board understands.`;
}

const FAULTS = {
  __proto__: null,
  reset: (who) => `${who} is reset: its sketch starts again, its agent finds it again.`,
  unplug: (who) => `${who} loses its cable: the agent cannot reach its board.`,
  plug: (who) => `${who} has its cable again.`,
  'power-cut': (who) => `${who} loses its power: all that is not in its EEPROM is gone.`,
  jam: () => 'Somebody jams the radio: whoever is near hears only noise.',
  move: (who) => `${who} is moved by hand.`,
  obstacle: (who, e) => (e.remove ? `The obstacle “${plain(e.name, 20)}” is taken away.` : `An obstacle stands in the way: “${plain(e.name, 20)}”.`),
  light: (who, e) => `The light of the world is now ${plain(e.value, 6)} of 1023.`,
  sensor: (who, e) => (e.value === null ? `A sensor of ${who} measures the world again.` : `A sensor of ${who} now measures ${plain(e.value, 8)}.`),
  radio: (who, e) => (Number.isFinite(e.range) ? `Range is now ${rounded(e.range)} m.` : Number.isFinite(e.bitErrorRate) ? `${rounded(e.bitErrorRate * 100)} % of all bits are now inverted.` : 'The air is changed.'),
  speed: (who, e) => (e.value === 0 ? 'The run is paused.' : `The run goes at ${plain(e.value, 6)} times the speed of life.`),
};

/** A row of the time line as a sentence; nothing for rows that need none. */
export function sentence(model, state, mark, t = state.t) {
  const who = titleOf(state, mark.board);
  switch (mark.kind) {
    case 'packet': return packetWords(model, state, mark.packet, t);
    case 'said': return `${mark.agent === mark.board ? 'The agent of ' + who : 'The agent ' + plain(mark.agent, 24)} says: “${plain(mark.text, 90)}”`;
    case 'fault': return (FAULTS[mark.text] ?? (() => `${who} ${plain(mark.text, 60)}.`))(who, mark.event ?? {});
    case 'heard': return `A message came: ${plain(mark.text, 120)}`;
    case 'acted': return `${who} did: ${plain(mark.text, 120)}`;
    case 'verdict':
      return mark.accepted ? 'The protocol’s model allows all that the boards did.' : plain(mark.text, 120);
    default: return undefined;
  }
}

/** The last sentences up to a time, newest first; none is there twice. */
export function story(model, state, t, most = 3) {
  const found = [];
  const take = (n, at, words) => words && !found.some((line) => line.words === words) && found.push({ n, t: at, words });
  model.onAir(t, 0).filter((p) => p.kind !== 'acknowledgement').slice(-most).reverse()
    .forEach((packet) => take(packet.n, packet.start, packetWords(model, state, packet, t)));
  for (let i = model.marksUpTo(t) - 1; i >= 0 && found.length < most; i--) {
    const mark = model.marks[i];
    if (!mark.aside) take(mark.n, mark.t, sentence(model, state, mark, t));
  }
  return found;
}

/** Within so many seconds after a packet each board has told its counters, also in a fast run. */
const TOLD_WITHIN = 30;

/** One of these tells of each packet that a board hears. */
const HEARD = ['radioReceived', 'radioDamaged', 'radioMissed'];

/**
 * The outcome, by a time, of a packet at a board that heard it, as its host and its counters tell: `damaged`, `taken`,
 * `untold` yet, `refused`, `repeated` (had before), `left`, or `ignored`; with the `counters` that rose.
 */
export function outcome(model, packet, { board, why, t: heardAt }, t) {
  if (why) return { what: 'damaged', counters: [] };
  if (packet.handed.some((x) => x.board === board && x.t <= t)) return { what: 'taken', counters: [] };
  // A board tells its counters once a second: the first time after it has heard the packet says what came of that.
  const told = model.stateAt(Math.min(t, packet.t + TOLD_WITHIN)).boards.get(board)?.counted
    .find((c) => c.t >= heardAt && c.t <= t && HEARD.some((name) => c.rises.has(name)));
  if (!told) return { what: 'untold', counters: [] };
  const risen = (names) => Object.keys(names).filter((name) => told.rises.has(name));
  // Another packet may have come within the same second.
  const refusals = risen(REFUSALS);
  const left = risen(LEFT);
  const isOurs = left.length === 0 || refusals[0] === 'radioOwn' || packet.to.includes(board) || packet.kind === 'no frame';
  if (left[0] === 'radioRepeats' && packet.kind === 'unicast' && packet.to.includes(board)) return { what: 'repeated', counters: left.slice(0, 1) };
  if (refusals.length > 0 && isOurs) return { what: 'refused', counters: refusals };
  return left.length > 0 ? { what: 'left', counters: left.slice(0, 1) } : { what: 'ignored', counters: [] };
}

/** How many packets of the attacker a board had already. */
export const repeats = (model, board, t) => model.packets.filter((p) => p.attack === 'replay' && p.to.includes(board)).slice(-LAST)
  .filter((p) => p.heard.some((h) => h.board === board && h.t <= t && outcome(model, p, h, t).what === 'repeated')).length;

/** The fate of a packet, at a time: a sentence for each of these boards. */
export function fate(model, state, packet, t, boards = [...state.boards.keys()]) {
  if (t < packet.t) return ['It is on the air …'];
  const heard = packet.heard.filter((h) => h.t <= t && boards.includes(h.board));
  const sentences = heard.map((h) => {
    const who = titleOf(state, h.board);
    const { what, counters } = outcome(model, packet, h, t);
    switch (what) {
      case 'damaged': return `${who} did not hear it undamaged: ${plain(h.why, 40)}.`;
      case 'taken':
        return `${who} took it` + (packet.sealed ? ': its tag is right.' : ': a broadcast has no lock, so anybody may shout. Its agent decides what it believes.');
      case 'refused': return `${who} refused it: ${counters.map((name) => `${REFUSALS[name].why} (${name})`).join(', or ')}.`;
      case 'repeated': return `${who} ${ALREADY} (${counters[0]}).`;
      case 'left': return `${who} ${LEFT[counters[0]]} (${counters[0]}).`;
      case 'untold': return `${who} heard it, and has not yet told what it did …`;
      default: return `${who} heard it, and no counter of a refusal rose.`;
    }
  });
  const others = boards.filter((name) => !heard.some((h) => h.board === name) && name !== packet.board);
  if (others.length > 0) sentences.push(`Not heard by ${listed(others.map((name) => titleOf(state, name)))}.`);
  return sentences;
}
