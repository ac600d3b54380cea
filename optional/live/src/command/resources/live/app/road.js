// The road from above, on a canvas: one moment of the run.

import { dash, hue, ink, letter } from './colours.js';
import { REFUSALS } from './phrases.js';
import { plain } from './text.js';

/** Pixels around all that stands on the road: above are locks and words, below names. */
const MARGIN = { side: 60, top: 66, bottom: 56 };
/** What a packet did stays visible for so long, in emulated seconds. */
const AFTERGLOW = 1;
/** A ring that has ended fades. */
const FADE = 0.25;
const LOSS_GLOW = 0.9;
const REFUSAL_GLOW = 3;
/** Between two `place` events a vehicle glides. */
const STEP = 0.05;
/** Pixels within which a pointer takes hold of something. */
const REACH = 24;
const VEHICLE = { length: 40, width: 20 };
const STATION = 26;
/** More boards than this are drawn smaller, with a name only on the board. */
const CROWD = 10;

const fading = (packet, t) => (t > packet.end ? 1 - (t - packet.end) / FADE : 1);

const still = matchMedia('(prefers-reduced-motion: reduce)');

export class Road {
  #canvas;
  #g;
  #ui;
  #view;
  #shown;
  #hatch;
  #width = 1;
  #height = 1;

  /** `ui` has `chosen`, `mode`, `held` (what the pointer holds, and where), `standing` (the injector's place). */
  constructor(canvas, ui) {
    this.#canvas = canvas;
    this.#g = canvas.getContext('2d');
    this.#ui = ui;
    new ResizeObserver(() => this.#fit()).observe(canvas);
    this.#fit();
  }

  #fit() {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    this.#width = this.#canvas.clientWidth || 1;
    this.#height = this.#canvas.clientHeight || 1;
    this.#canvas.width = Math.round(this.#width * ratio);
    this.#canvas.height = Math.round(this.#height * ratio);
    this.#g.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.#view = undefined;
  }

  /** Pixels of a place. */
  #at([x, y]) {
    const { scale, left, top } = this.#view;
    return [(x - left) * scale, (top - y) * scale];
  }

  /** The place under a pixel, to a decimetre. */
  placeAt(x, y) {
    const { scale, left, top } = this.#view;
    return [Math.round((left + x / scale) * 10) / 10, Math.round((top - y / scale) * 10) / 10];
  }

  /** Where something is drawn, in pixels. */
  pixels({ kind, name }) {
    const thing = this.#things().find((each) => each.kind === kind && each.name === name);
    return thing && this.#at(thing.place);
  }

  /** What is under a pixel: `{kind, name}`. */
  under(x, y) {
    let best;
    let nearest = REACH;
    for (const thing of this.#things()) {
      const [px, py] = this.#at(thing.place);
      const distance = Math.hypot(px - x, py - y);
      if (distance < nearest) [nearest, best] = [distance, thing];
    }
    return best;
  }

  #things() {
    const s = this.#shown;
    if (!s) return [];
    return [
      ...[...s.boards.values()].filter((b) => b.place).map((b) => ({ kind: 'board', name: b.name, place: b.place })),
      ...[...s.obstacles.values()].map((o) => ({ kind: 'obstacle', name: o.name, place: o.place })),
      ...(this.#ui.standing ? [{ kind: 'injector', name: 'injector', place: this.#ui.standing }] : []),
    ];
  }

  draw(model, state, t) {
    const g = this.#g;
    this.#shown = state;
    this.#look(state);
    g.clearRect(0, 0, this.#width, this.#height);
    this.#ground(state);
    for (const jam of state.jams) if (jam.start <= t && t < jam.until) this.#jam(jam, state);
    for (const obstacle of state.obstacles.values()) this.#obstacle(obstacle);
    const packets = model.onAir(t, AFTERGLOW);
    for (const packet of packets) this.#ring(packet, state, t);
    if (this.#ui.standing) this.#injector();
    for (const board of state.boards.values()) if (board.place) this.#board(board, t);
    for (const packet of packets) this.#label(packet, state, t);
    for (const packet of packets) this.#arrivals(packet, state, t);
    for (const loss of model.lossesSince(t, LOSS_GLOW)) this.#loss(loss, state, t);
    for (const board of state.boards.values()) this.#refusal(board, t);
  }

  /** Looks at all that stands on the road; stays where it is while something is dragged. */
  #look(state) {
    if (this.#view && this.#ui.held?.down) return;
    const places = this.#things().map((thing) => thing.place);
    const xs = places.length ? places.map((p) => p[0]) : [0];
    const ys = places.length ? places.map((p) => p[1]) : [0];
    const low = [Math.min(...xs), Math.min(...ys)];
    const high = [Math.max(...xs), Math.max(...ys)];
    const wide = Math.max(this.#width - 2 * MARGIN.side, 50);
    const tall = Math.max(this.#height - MARGIN.top - MARGIN.bottom, 50);
    const scale = Math.min(wide / Math.max(high[0] - low[0], 30), tall / Math.max(high[1] - low[1], 12));
    const aim = {
      scale,
      left: (low[0] + high[0]) / 2 - this.#width / scale / 2,
      top: (low[1] + high[1]) / 2 + (tall / 2 + MARGIN.top) / scale,
    };
    const now = this.#view;
    this.#view = now
      ? Object.fromEntries(Object.keys(aim).map((key) => [key, now[key] + (aim[key] - now[key]) * 0.15]))
      : aim;
  }

  #ground(state) {
    const g = this.#g;
    const { scale, top } = this.#view;
    const lines = new Set();
    for (const b of state.boards.values()) {
      if (b.heading === undefined || !b.place || Math.abs(Math.sin((b.heading * Math.PI) / 180)) > 0.05) continue;
      if (lines.size < 6) lines.add(Math.round(b.place[1] / 4) * 4);
    }
    g.fillStyle = ink('road');
    for (const y of lines) g.fillRect(0, (top - y) * scale - 16, this.#width, 32);
    g.strokeStyle = ink('paper');
    g.lineWidth = 2;
    g.setLineDash([14, 14]);
    for (const y of lines) this.#line(0, (top - y) * scale, this.#width, (top - y) * scale);
    g.setLineDash([]);
    // A scale: ten metres.
    g.strokeStyle = g.fillStyle = ink('soft');
    g.lineWidth = 1;
    const x = 10;
    const y = this.#height - 10;
    this.#line(x, y, x + 10 * scale, y);
    this.#line(x, y - 4, x, y + 4);
    this.#line(x + 10 * scale, y - 4, x + 10 * scale, y + 4);
    this.#words('10 m', x + 10 * scale + 6, y, { align: 'left', size: 11, colour: ink('soft') });
  }

  #line(x1, y1, x2, y2) {
    const g = this.#g;
    g.beginPath();
    g.moveTo(x1, y1);
    g.lineTo(x2, y2);
    g.stroke();
  }

  #words(words, x, y, { align = 'center', size = 12, colour = ink('ink'), bold = false, boxed = false } = {}) {
    const g = this.#g;
    g.font = `${bold ? '600 ' : ''}${size}px system-ui, sans-serif`;
    g.textBaseline = 'middle';
    g.textAlign = align;
    if (boxed) {
      const width = g.measureText(words).width + 10;
      x = Math.min(Math.max(x, width / 2 + 2), this.#width - width / 2 - 2);
      g.fillStyle = ink('paper');
      g.globalAlpha *= 0.9;
      g.beginPath();
      g.roundRect(x - width / 2, y - size * 0.75, width, size * 1.5, 4);
      g.fill();
      g.globalAlpha /= 0.9;
    }
    g.fillStyle = colour;
    g.fillText(words, x, y);
  }

  #jam(jam, state) {
    const g = this.#g;
    this.#hatch ??= this.#hatching();
    g.save();
    g.fillStyle = g.createPattern(this.#hatch, 'repeat');
    g.globalAlpha = 0.35;
    if (jam.place) {
      const [x, y] = this.#at(jam.place);
      g.beginPath();
      g.arc(x, y, state.radio.range * this.#view.scale, 0, 2 * Math.PI);
      g.fill();
      g.globalAlpha = 1;
      this.#words('jam', x, y, { bold: true, colour: ink('bad'), boxed: true });
    } else {
      g.fillRect(0, 0, this.#width, this.#height);
      g.globalAlpha = 1;
      this.#words('jam: noise everywhere', this.#width / 2, 16, { bold: true, colour: ink('bad'), boxed: true });
    }
    g.restore();
  }

  #hatching() {
    const tile = document.createElement('canvas');
    tile.width = tile.height = 12;
    const g = tile.getContext('2d');
    g.strokeStyle = ink('bad');
    g.lineWidth = 2;
    g.beginPath();
    g.moveTo(-3, 15);
    g.lineTo(15, -3);
    g.moveTo(-3, 3);
    g.lineTo(3, -3);
    g.moveTo(9, 15);
    g.lineTo(15, 9);
    g.stroke();
    return tile;
  }

  /** Colours have changed. */
  recolour() {
    this.#hatch = undefined;
  }

  #heldPlace(kind, name, place) {
    const held = this.#ui.held;
    return held && held.kind === kind && held.name === name ? held.place : place;
  }

  #obstacle(obstacle) {
    const g = this.#g;
    const [x, y] = this.#at(this.#heldPlace('obstacle', obstacle.name, obstacle.place));
    const r = Math.max(8, obstacle.radius * this.#view.scale);
    g.beginPath();
    for (let i = 0; i < 7; i++) {
      const angle = (i * 2 * Math.PI) / 7 + 0.3;
      g.lineTo(x + r * Math.cos(angle), y + r * Math.sin(angle));
    }
    g.closePath();
    g.fillStyle = ink('soft');
    g.fill();
    if (this.#isChosen('obstacle', obstacle.name)) this.#halo(x, y, r + 6);
    this.#words(plain(obstacle.name, 20), x, y + r + 9, { size: 11, colour: ink('soft') });
  }

  #isChosen(kind, name) {
    return this.#ui.chosen?.kind === kind && this.#ui.chosen.name === name;
  }

  #halo(x, y, r) {
    const g = this.#g;
    g.strokeStyle = ink('ink');
    g.lineWidth = 2;
    g.setLineDash([4, 3]);
    g.beginPath();
    g.arc(x, y, r, 0, 2 * Math.PI);
    g.stroke();
    g.setLineDash([]);
  }

  /** Where a board is drawn: it glides from place to place. */
  #placeOf(board, t) {
    let place = board.place;
    if (board.before && t - board.placedAt < STEP && Math.hypot(place[0] - board.before[0], place[1] - board.before[1]) < 5) {
      const part = Math.max(0, (t - board.placedAt) / STEP);
      place = place.map((end, i) => board.before[i] + (end - board.before[i]) * part);
    }
    return this.#heldPlace('board', board.name, place);
  }

  #board(board, t) {
    const g = this.#g;
    const [x, y] = this.#at(this.#placeOf(board, t));
    const off = board.offUntil !== undefined && t < board.offUntil;
    g.save();
    g.translate(x, y);
    if (this.#shown.boards.size > CROWD) g.scale(0.7, 0.7);
    g.globalAlpha = off ? 0.4 : 1;
    g.fillStyle = hue(board);
    g.strokeStyle = ink('ink');
    g.lineWidth = 1.5;
    g.setLineDash(dash(board));
    g.beginPath();
    if (board.heading === undefined) {
      // A station: a house.
      g.moveTo(-STATION / 2, STATION / 2);
      g.lineTo(-STATION / 2, -STATION / 4);
      g.lineTo(0, -STATION * 0.7);
      g.lineTo(STATION / 2, -STATION / 4);
      g.lineTo(STATION / 2, STATION / 2);
      g.closePath();
      g.fill();
      g.stroke();
    } else {
      g.rotate((-board.heading * Math.PI) / 180);
      g.roundRect(-VEHICLE.length / 2, -VEHICLE.width / 2, VEHICLE.length, VEHICLE.width, [5, 10, 10, 5]);
      g.fill();
      g.stroke();
      g.setLineDash([]);
      g.fillStyle = ink('paper');
      g.globalAlpha *= 0.75;
      g.fillRect(VEHICLE.length / 2 - 11, -VEHICLE.width / 2 + 4, 4, VEHICLE.width - 8);
      g.rotate((board.heading * Math.PI) / 180);
    }
    g.restore();
    this.#words(letter(board), x - (board.heading === undefined ? 0 : 2), y + 1, { bold: true, size: this.#shown.boards.size > CROWD ? 10 : 13, colour: ink('paper') });
    if (this.#isChosen('board', board.name)) this.#halo(x, y, 27);
    const states = [off && 'no power', board.port === 'unplugged' && !off && 'unplugged'].filter(Boolean);
    if (this.#shown.boards.size <= CROWD) this.#words(plain(board.title, 16), x, y + 25, { bold: true, colour: hue(board), boxed: true });
    if (states.length) this.#words(states.join(', '), x, y + 42, { size: 11, bold: true, colour: ink('bad'), boxed: true });
    const lamps = [...board.pins.values()].filter((pin) => pin.level);
    lamps.slice(0, 4).forEach((pin, i) => {
      g.beginPath();
      g.arc(x - 18 + i * 12, y - 20, 4.5, 0, 2 * Math.PI);
      g.fillStyle = ink('good');
      g.fill();
      g.strokeStyle = ink('ink');
      g.lineWidth = 1;
      g.stroke();
    });
  }

  #injector() {
    const g = this.#g;
    const [x, y] = this.#at(this.#heldPlace('injector', 'injector', this.#ui.standing));
    g.beginPath();
    g.arc(x, y, 12, 0, 2 * Math.PI);
    g.fillStyle = ink('paper');
    g.fill();
    g.strokeStyle = ink('injector');
    g.lineWidth = 2;
    g.setLineDash([4, 3]);
    g.stroke();
    g.setLineDash([]);
    this.#words('?', x, y + 1, { bold: true, size: 14, colour: ink('injector') });
    this.#words('Injector', x, y + 21, { size: 11, colour: ink('injector') });
  }

  #ring(packet, state, t) {
    if (!packet.place || t > packet.end + FADE) return;
    const g = this.#g;
    const board = state.boards.get(packet.board);
    const [x, y] = this.#at(packet.place);
    const part = still.matches ? 1 : Math.min(1, (t - packet.start) / Math.max(packet.end - packet.start, 0.001));
    const radius = Math.max(14, part * state.radio.range * this.#view.scale);
    const thin = packet.kind === 'acknowledgement';
    g.save();
    g.globalAlpha = fading(packet, t);
    g.strokeStyle = g.fillStyle = hue(board);
    g.lineWidth = thin ? 1.5 : 5;
    g.setLineDash(packet.sealed || thin ? [] : [14, 8]);
    g.beginPath();
    g.arc(x, y, radius, 0, 2 * Math.PI);
    g.stroke();
    if (!thin) {
      g.globalAlpha *= 0.07;
      g.fill();
      g.globalAlpha /= 0.07;
    }
    g.restore();
  }

  /** Over a sender: for whom the packet is, and its lock. */
  #label(packet, state, t) {
    if (!packet.place || t > packet.end + FADE) return;
    const g = this.#g;
    const [x, y] = this.#at(packet.place);
    const board = state.boards.get(packet.board);
    const thin = packet.kind === 'acknowledgement';
    g.save();
    g.globalAlpha = fading(packet, t);
    if (!thin) this.#lock(x, y - 37, packet.sealed, hue(board));
    const label = thin ? 'got it' : packet.destination === '////' ? 'to all: ' + plain(packet.content ?? '', 24)
      : 'to ' + plain(state.boards.get(packet.to[0])?.title ?? packet.destination, 16) +
        (packet.destination.startsWith('//') ? ' and group' : '');
    this.#words(label, x, y - (thin ? 32 : 55), { size: thin ? 11 : 12, bold: !thin, colour: hue(board), boxed: true });
    g.restore();
  }

  /** A lock on a round plate: closed if the packet is sealed. */
  #lock(x, y, closed, colour, size = 9) {
    const g = this.#g;
    g.save();
    g.fillStyle = ink('paper');
    g.strokeStyle = colour;
    g.lineWidth = 2;
    g.setLineDash([]);
    g.beginPath();
    g.arc(x, y, size + 3, 0, 2 * Math.PI);
    g.fill();
    g.stroke();
    g.fillStyle = colour;
    g.fillRect(x - size * 0.55, y - size * 0.1, size * 1.1, size * 0.8);
    g.beginPath();
    const shift = closed ? 0 : size * 0.55;
    g.arc(x + shift, y - size * 0.15 - (closed ? 0 : 1), size * 0.36, Math.PI, closed ? 2 * Math.PI : 1.8 * Math.PI);
    g.stroke();
    g.restore();
  }

  /** What became of a packet, at each board that heard it. */
  #arrivals(packet, state, t) {
    if (packet.kind === 'acknowledgement') return;
    const sender = state.boards.get(packet.board);
    for (const heard of packet.heard) {
      const board = state.boards.get(heard.board);
      if (heard.t > t || heard.why || !board?.place) continue;
      const [x, y] = this.#at(this.#placeOf(board, t));
      const g = this.#g;
      g.save();
      g.globalAlpha = Math.max(0, Math.min(1, 2 * (1 - (t - heard.t) / AFTERGLOW)));
      if (packet.handed.some((handed) => handed.board === heard.board && handed.t <= t)) {
        this.#words(packet.sealed ? '✓ opens it' : '✓ hears it', x, y - 34, { bold: true, size: 12, colour: ink('good'), boxed: true });
      } else if (packet.sealed && !packet.to.includes(heard.board)) {
        this.#lock(x + 24, y - 16, true, hue(sender), 7);
      }
      g.restore();
    }
  }

  #loss(loss, state, t) {
    const board = state.boards.get(loss.board);
    if (!board?.place) return;
    const g = this.#g;
    const [x, y] = this.#at(this.#placeOf(board, t));
    const age = (t - loss.t) / LOSS_GLOW;
    g.save();
    g.globalAlpha = 1 - age;
    g.strokeStyle = ink('bad');
    g.lineWidth = 3;
    g.beginPath();
    for (let i = 0; i < 8; i++) {
      const angle = (i * Math.PI) / 4 + 0.2;
      g.moveTo(x + 20 * Math.cos(angle), y + 20 * Math.sin(angle));
      g.lineTo(x + 32 * Math.cos(angle), y + 32 * Math.sin(angle));
    }
    g.stroke();
    this.#words('✗ ' + plain(loss.why, 24), x, y - 42, { bold: true, colour: ink('bad'), boxed: true });
    g.restore();
  }

  /** A board that has just counted a packet as refused says why. */
  #refusal(board, t) {
    const last = board.counted.findLast((c) => t - c.t < REFUSAL_GLOW && [...c.rises.keys()].some((name) => REFUSALS[name]));
    if (!last || !board.place) return;
    const name = [...last.rises.keys()].find((n) => REFUSALS[n]);
    const [x, y] = this.#at(this.#placeOf(board, t));
    this.#words('✗ refused: ' + REFUSALS[name].short, x, y - 58, { bold: true, colour: ink('bad'), boxed: true });
  }
}
