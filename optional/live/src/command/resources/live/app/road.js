// The road from above, on a canvas: one moment of the run.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { dash, hue, hueClass, ink, letter } from './colours.js';
import { Labels } from './labels.js';
import { REFUSALS } from './phrases.js';
import { YOU, plain } from './text.js';

/** Pixels around all that "fit" shows: room for words. */
const MARGIN = { side: 70, end: 50 };
/** A frame is at least so wide and tall, in metres. */
const LEAST = [30, 12];
/** Pixels a metre. */
const SCALES = [0.2, 100];
/** The effect of a packet stays visible for so long, in emulated seconds. */
const AFTERGLOW = 1;
/** A ring that has ended fades. */
const FADE = 0.25;
const LOSS_GLOW = 0.9;
const REFUSAL_GLOW = 3;
/** Between two `place` events a vehicle glides. */
const STEP = 0.05;
/** Pixels within which a pointer takes hold of something. */
const REACH = 24;
const VEHICLE = { length: 34, width: 16 };
const STATION = 24;
const BOARD = { length: 32, width: 22 };
/** Arrows are so far from the edge. */
const EDGE = 12;
const ARROWS = '→↘↓↙←↖↑↗';
/** More boards than this are drawn smaller, with a letter in place of the name. */
const CROWD = 10;
/** Up to so many boards show their pins by name. */
const FEW = 3;

/** A lock: closed if the packet is sealed. */
const lock = (closed) => html`<svg class="lock" width="12" height="14"><path d=${closed ? 'M3.5 7V4a2.5 2.5 0 0 1 5 0v3' : 'M3.5 7V4a2.5 2.5 0 0 1 5-.8'}></path><rect x="1" y="6.5" width="10" height="7" rx="1.5"></rect></svg>`;

const fading = (packet, t) => (t > packet.end ? 1 - (t - packet.end) / FADE : 1);

const still = matchMedia('(prefers-reduced-motion: reduce)');

export class Road {
  #canvas;
  #g;
  #ui;
  #labels;
  /** The part of the world that the camera shows, in metres: only its user changes that. */
  #frame;
  #framed;
  /** Whether the frame is that of `fit`. */
  #fitted = false;
  #window;
  #view;
  #shown;
  #hatch;
  #width = 1;
  #height = 1;

  /** `ui` has `chosen`, `mode`, `held` (what the pointer holds, and where), `standing` (the injector's place); `resized` is called when all is to be drawn anew. */
  constructor(canvas, layer, ui, resized) {
    this.#canvas = canvas;
    this.#labels = new Labels(layer);
    this.#g = canvas.getContext('2d');
    this.#ui = ui;
    new ResizeObserver(() => {
      this.#measure();
      resized();
    }).observe(canvas);
    this.#measure();
  }

  #measure() {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    this.#width = this.#canvas.clientWidth || 1;
    this.#height = this.#canvas.clientHeight || 1;
    this.#canvas.width = Math.round(this.#width * ratio);
    this.#canvas.height = Math.round(this.#height * ratio);
    this.#g.setTransform(ratio, 0, 0, ratio, 0, 0);
    // Only a window of another size shows all again: words that take another line do not move the view.
    const seen = innerWidth + ' ' + innerHeight;
    if (this.#fitted && seen !== this.#window) this.fit();
    else if (this.#frame) this.#look();
    this.#window = seen;
    this.changed = true;
  }

  /** Pixels of a place. */
  #at([x, y]) {
    const { scale, left, top } = this.#view;
    return [(x - left) * scale, (top - y) * scale];
  }

  /** The place where something is drawn, in pixels. */
  pixels({ kind, name }) {
    const thing = this.#things().find((each) => each.kind === kind && each.name === name);
    return thing && this.#within(this.#at(thing.place));
  }

  /** The place under a pixel, to a decimetre. */
  placeAt(x, y) {
    const { scale, left, top } = this.#view;
    return [Math.round((left + x / scale) * 10) / 10, Math.round((top - y / scale) * 10) / 10];
  }

  /** The thing under a pixel, or under its label: `{kind, name, place}`. */
  under(x, y) {
    const key = this.#labels.under(x, y);
    const things = this.#things();
    const labelled = things.find((thing) => key === thing.kind + ' ' + thing.name);
    if (labelled) return labelled;
    let best;
    let nearest = REACH;
    for (const thing of things) {
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
      ...[...s.boards.values()].filter((b) => b.place).map((b) => ({ kind: 'board', name: b.name, place: b.place, title: plain(b.title, 16), board: b })),
      ...[...s.obstacles.values()].map((o) => ({ kind: 'obstacle', name: o.name, place: o.place, title: plain(o.name, 20) })),
      ...(this.#ui.standing ? [{ kind: 'injector', name: 'injector', place: this.#ui.standing, title: YOU }] : []),
    ];
  }

  /** Whether anything moves or fades at a time, or is held. */
  moves(model, state, t) {
    return this.#ui.held !== undefined || model.onAir(t, AFTERGLOW).length > 0 || model.lossesSince(t, LOSS_GLOW).length > 0
      || state.jams.some((jam) => jam.start <= t && t < jam.until)
      || [...state.boards.values()].some((b) => t - b.placedAt < 2 * STEP || (b.offUntil ?? 0) > t || b.counted.some((c) => c.t <= t && t - c.t < REFUSAL_GLOW + 1 && [...c.rises.keys()].some((name) => REFUSALS[name])));
  }

  draw(model, state, t) {
    this.changed = false;
    const g = this.#g;
    this.#shown = state;
    if (this.#framed !== model && (state.boards.size > 0 || !this.#frame)) {
      this.fit();
      this.#framed = state.boards.size > 0 ? model : undefined;
    }
    g.clearRect(0, 0, this.#width, this.#height);
    this.#labels.begin(this.#width, this.#height, [
      ...this.#overlays(),
      { x: 0, y: this.#height - 20, w: 60 + 10 * this.#view.scale, h: 20 },
    ]);
    this.#ground(state);
    for (const jam of state.jams) if (jam.start <= t && t < jam.until) this.#jam(jam, state);
    for (const obstacle of state.obstacles.values()) this.#obstacle(obstacle);
    const packets = model.onAir(t, AFTERGLOW);
    for (const packet of packets) this.#ring(packet, state, t);
    if (this.#ui.standing) this.#injector();
    for (const board of state.boards.values()) if (board.place) this.#board(board, t);
    this.#names(t);
    for (const board of state.boards.values()) this.#refusal(board, t);
    for (const loss of model.lossesSince(t, LOSS_GLOW)) this.#loss(loss, state, t);
    for (const packet of packets) this.#label(packet, state, t);
    for (const packet of packets) this.#arrivals(packet, state, t);
    this.#labels.end();
  }

  /** Whatever else is over the canvas: the camera's buttons, a menu. */
  #overlays() {
    const others = [...this.#canvas.parentElement.children].filter((each) => each !== this.#canvas && each.id !== 'labels');
    return others.map((each) => ({ x: each.offsetLeft, y: each.offsetTop, w: each.offsetWidth, h: each.offsetHeight })).filter(({ w }) => w > 0);
  }

  /** Shows all that stands on the road. */
  fit() {
    this.#fitted = true;
    const { radio } = this.#shown ?? {};
    // Where nothing drives, the range of radios is what there is to see.
    const reach = this.#shown && this.#ranged(this.#shown) ? radio.range : 0;
    const places = this.#things().flatMap(({ place: [x, y], board }) => (board ? [[x - reach, y - reach], [x + reach, y + reach]] : [[x, y]]));
    const [x, y] = [0, 1].map((axis) => {
      const all = places.length ? places.map((p) => p[axis]) : [0];
      return [Math.min(...all), Math.max(...all)];
    });
    this.#frame = {
      x: (x[0] + x[1]) / 2,
      y: (y[0] + y[1]) / 2,
      wide: Math.max(x[1] - x[0], LEAST[0]),
      tall: Math.max(y[1] - y[0], LEAST[1]),
    };
    this.#look();
  }

  /** Whether radios' ranges are drawn. */
  #ranged(state) {
    const boards = [...state.boards.values()];
    return boards.every((b) => b.heading === undefined) && boards.some((b) => b.radio);
  }

  /** Shows more or less; what is under the pixel stays there. */
  zoom(factor, x = this.#width / 2, y = this.#height / 2) {
    const scale = Math.max(SCALES[0], Math.min(this.#view.scale * factor, SCALES[1]));
    const part = this.#view.scale / scale;
    const [dx, dy] = [x - this.#width / 2, y - this.#height / 2].map((d) => (d * (1 - part)) / this.#view.scale);
    const f = this.#frame;
    this.#fitted = false;
    this.#frame = { x: f.x + dx, y: f.y - dy, wide: f.wide * part, tall: f.tall * part };
    this.#look();
  }

  /** Moves what is shown by so many pixels. */
  pan(dx, dy) {
    const { scale } = this.#view;
    this.#fitted = false;
    this.#frame = { ...this.#frame, x: this.#frame.x - dx / scale, y: this.#frame.y + dy / scale };
    this.#look();
  }

  #look() {
    this.changed = true;
    const { x, y, wide, tall } = this.#frame;
    const room = [this.#width - 2 * MARGIN.side, this.#height - 2 * MARGIN.end].map((pixels) => Math.max(pixels, 50));
    const scale = Math.min(room[0] / wide, room[1] / tall);
    this.#view = { scale, left: x - this.#width / scale / 2, top: y + this.#height / scale / 2 };
  }

  #ground(state) {
    const g = this.#g;
    const { scale, top } = this.#view;
    g.fillStyle = ink('road');
    for (const y of state.roads) g.fillRect(0, (top - y) * scale - 16, this.#width, 32);
    g.strokeStyle = ink('paper');
    g.lineWidth = 2;
    g.setLineDash([14, 14]);
    for (const y of state.roads) this.#line(0, (top - y) * scale, this.#width, (top - y) * scale);
    g.setLineDash([]);
    if (this.#ranged(state)) for (const b of state.boards.values()) if (b.radio && b.place) this.#range(b, state.radio.range);
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

  #range(board, range) {
    const g = this.#g;
    g.strokeStyle = hue(board);
    g.globalAlpha = 0.5;
    g.setLineDash([2, 6]);
    g.beginPath();
    g.arc(...this.#at(this.#heldPlace('board', board.name, board.place)), range * this.#view.scale, 0, 2 * Math.PI);
    g.stroke();
    g.setLineDash([]);
    g.globalAlpha = 1;
  }

  #line(x1, y1, x2, y2) {
    const g = this.#g;
    g.beginPath();
    g.moveTo(x1, y1);
    g.lineTo(x2, y2);
    g.stroke();
  }

  #words(words, x, y, { align = 'center', size = 12, colour = ink('ink'), bold = false } = {}) {
    const g = this.#g;
    g.font = `${bold ? '600 ' : ''}${size}px system-ui, sans-serif`;
    g.textBaseline = 'middle';
    g.textAlign = align;
    g.fillStyle = colour;
    g.fillText(words, x, y);
  }

  /** Words beside a place, or at the edge where that is outside; where they are far, with a line. */
  #say(key, words, at, options = {}) {
    const [x, y] = this.#within(at);
    const end = this.#labels.put(key, words, [x, y], options);
    if (!end || options.act) return;
    const g = this.#g;
    g.strokeStyle = ink('soft');
    g.lineWidth = 1;
    this.#line(x, y, ...end);
  }

  #within([x, y]) {
    return [Math.max(EDGE, Math.min(x, this.#width - EDGE)), Math.max(EDGE, Math.min(y, this.#height - EDGE))];
  }

  #isInside([x, y]) {
    return x >= 0 && y >= 0 && x <= this.#width && y <= this.#height;
  }

  /** Names of things at their places; for a thing outside, an arrow at the edge, which shows the place by a click. */
  #names(t) {
    const all = this.#things().map((thing) => ({
      ...thing,
      key: thing.kind + ' ' + thing.name,
      place: thing.board ? this.#placeOf(thing.board, t) : this.#heldPlace(thing.kind, thing.name, thing.place),
    }));
    const inside = all.filter((thing) => this.#isInside(this.#at(thing.place)));
    for (const { place } of inside) this.#labels.body(...this.#at(place), [VEHICLE.length / 2, VEHICLE.width / 2 + 3]);
    for (const thing of inside) this.#name(thing, t);
    for (const thing of all) if (!inside.includes(thing)) this.#arrow(thing);
  }

  #name({ key, title, board, place }, t) {
    if (!board) {
      this.#say(key, title, this.#at(place), { look: 'soft' });
      return;
    }
    const off = board.offUntil !== undefined && t < board.offUntil;
    const trouble = off ? 'no power' : board.port === 'unplugged' ? 'unplugged' : '';
    const pins = [...board.pins.values()];
    // Few boards have room for the names of their pins.
    const lamps = this.#shown.boards.size <= FEW && board.heading === undefined
      ? pins.slice(0, 6).map((pin) => (pin.level ? '● ' : '○ ') + plain(pin.name, 16)).join(' ')
      : '●'.repeat(Math.min(4, pins.filter((pin) => pin.level).length));
    const crowded = this.#shown.boards.size > CROWD;
    const name = crowded ? '' : title;
    this.#say(key, [letter(board), name, lamps, trouble].join('|'), this.#at(place), {
      look: 'name ' + hueClass(board),
      content: html`<b class="letter">${letter(board)}</b>${name ? ' ' + name : nothing}${lamps ? html` <i>${lamps}</i>` : nothing}${trouble ? html` <em>${trouble}</em>` : nothing}`,
    });
  }

  #arrow({ key, title, board, place }) {
    const at = this.#at(place);
    const [x, y] = this.#within(at);
    const angle = (Math.atan2(at[1] - y, at[0] - x) * 180) / Math.PI;
    this.#say('edge ' + key, ARROWS[Math.round((angle + 360) / 45) % 8] + ' ' + title, at, {
      reach: [0, 0],
      side: angle + 180,
      look: 'edge ' + (board ? hueClass(board) : 'soft'),
      act: () => this.pan(this.#width / 2 - this.#at(place)[0], this.#height / 2 - this.#at(place)[1]),
    });
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
      this.#say('jam ' + jam.start, 'jam', [x, y], { reach: [0, 0], look: 'bad' });
    } else {
      g.fillRect(0, 0, this.#width, this.#height);
      this.#say('jam', 'jam: noise everywhere', [this.#width / 2, 0], { reach: [0, 0], look: 'bad' });
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

  /** The place where a board is drawn: it glides from place to place. */
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
    if (board.heading === undefined && this.#shown.roads.length === 0) {
      // A board, with its plug.
      g.roundRect(-BOARD.length / 2, -BOARD.width / 2, BOARD.length, BOARD.width, 3);
      g.fill();
      g.stroke();
      g.setLineDash([]);
      g.fillStyle = ink('paper');
      g.globalAlpha *= 0.75;
      g.fillRect(-BOARD.length / 2 - 3, -5, 9, 10);
      g.fillRect(0, -4, 10, 8);
    } else if (board.heading === undefined) {
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
    if (this.#isChosen('board', board.name)) this.#halo(x, y, 24);
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
    const board = state.boards.get(packet.board);
    const thin = packet.kind === 'acknowledgement';
    const words = thin ? 'got it' : packet.destination === '////' ? 'to all: ' + plain(packet.content ?? '', 24)
      : 'to ' + plain(state.boards.get(packet.to[0])?.title ?? packet.destination, 16) +
        (packet.destination.startsWith('//') ? ' and group' : '');
    this.#say('packet ' + packet.n, words, this.#at(packet.place), {
      side: -90,
      look: (thin ? 'thin ' : packet.sealed ? 'sealed ' : 'open ') + hueClass(board),
      opacity: fading(packet, t),
      content: html`${thin ? nothing : lock(packet.sealed)} ${words}`,
    });
  }

  /** The outcome of a packet, at each board that heard it. */
  #arrivals(packet, state, t) {
    if (packet.kind === 'acknowledgement') return;
    const sender = state.boards.get(packet.board);
    for (const heard of packet.heard) {
      const board = state.boards.get(heard.board);
      if (heard.t > t || heard.why || !board?.place) continue;
      const opened = packet.handed.some((handed) => handed.board === heard.board && handed.t <= t);
      if (!opened && (!packet.sealed || packet.to.includes(heard.board))) continue;
      this.#say('heard ' + packet.n + board.name, opened ? (packet.sealed ? '✓ opens it' : '✓ hears it') : 'not for it', this.#at(this.#placeOf(board, t)), {
        side: -90,
        look: opened ? 'good' : hueClass(sender),
        opacity: Math.max(0, Math.min(1, 2 * (1 - (t - heard.t) / AFTERGLOW))),
        content: opened ? undefined : lock(true),
      });
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
    g.restore();
    this.#say('lost ' + loss.t + loss.board, '✗ ' + plain(loss.why, 24), [x, y], { side: -90, look: 'bad', opacity: 1 - age });
  }

  /** A board that has just counted a packet as refused says why. */
  #refusal(board, t) {
    const last = board.counted.findLast((c) => c.t <= t && t - c.t < REFUSAL_GLOW && [...c.rises.keys()].some((name) => REFUSALS[name]));
    if (!last || !board.place) return;
    const name = [...last.rises.keys()].find((n) => REFUSALS[n]);
    this.#say('refused ' + board.name, '✗ refused: ' + REFUSALS[name].short, this.#at(this.#placeOf(board, t)), { side: -90, look: 'bad' });
  }
}
