// The words on the road: elements over the canvas, so placed that none covers another and none is cut.

import { render } from '/lib/lit-html/lit-html.js';

/** Pixels between labels. */
const GAP = 2;
/** Farther than this from its place a label has a line to it. */
const NEAR = 12;
/** Distances of a label from a thing that has no place beside it. */
const RINGS = [0, 8, 24, 48, 80, 120, 170, 230];
/** Turns from the side that is liked best. */
const TURNS = [0, 180, 90, -90, 45, -45, 135, -135];

const meet = (a, b) => a.x < b.x + b.w + GAP && b.x < a.x + a.w + GAP && a.y < b.y + b.h + GAP && b.y < a.y + a.h + GAP;

export class Labels {
  #layer;
  #made = new Map();
  #taken = [];
  #bodies = [];
  #room;

  constructor(layer) {
    this.#layer = layer;
  }

  /** Begins a picture; what is put first is placed first. `taken` are boxes `{x, y, w, h}` without labels. */
  begin(w, h, taken) {
    this.#room = { w, h };
    this.#taken = taken;
    this.#bodies = [];
    for (const label of this.#made.values()) label.used = false;
  }

  /** A thing that labels cover only where there is no other place. */
  body(x, y, [w, h]) {
    this.#bodies.push({ x: x - w, y: y - h, w: 2 * w, h: 2 * h });
  }

  /**
   * Puts words beside a place; the result is the end of the line that leads there, if it is far.
   * `reach` is the half size of what stands there, `side` the angle of the side that is liked best (90: below).
   */
  put(key, words, [x, y], { reach = [20, 14], side = 90, look = '', opacity = 1, content = words, act } = {}) {
    const label = this.#label(key, act);
    if (label.words !== words || label.look !== look) {
      render(content, label.element);
      label.element.className = 'note ' + look;
      Object.assign(label, { words, look, w: Math.ceil(label.element.offsetWidth), h: label.element.offsetHeight });
    }
    const box = this.#place(label, x, y, reach, side);
    Object.assign(label, { box, used: true });
    label.element.style.visibility = box ? 'visible' : 'hidden';
    if (!box) return undefined;
    label.element.style.transform = `translate(${Math.round(box.x)}px, ${Math.round(box.y)}px)`;
    label.element.style.opacity = opacity;
    this.#taken.push(box);
    const end = [Math.max(box.x, Math.min(x, box.x + box.w)), Math.max(box.y, Math.min(y, box.y + box.h))];
    return Math.hypot(end[0] - x, end[1] - y) > Math.hypot(...reach) + NEAR ? end : undefined;
  }

  /** Takes away what was not put. */
  end() {
    for (const [key, label] of this.#made) {
      if (label.used) continue;
      label.element.remove();
      this.#made.delete(key);
    }
  }

  /** The key of the label under a pixel. */
  under(x, y) {
    for (const [key, { box }] of this.#made) {
      if (box && x >= box.x && x <= box.x + box.w && y >= box.y && y <= box.y + box.h) return key;
    }
    return undefined;
  }

  #label(key, act) {
    let label = this.#made.get(key);
    if (!label) {
      const element = document.createElement(act ? 'button' : 'span');
      element.dataset.key = key;
      if (act) element.addEventListener('click', () => label.act());
      this.#layer.append(element);
      label = { element };
      this.#made.set(key, label);
    }
    label.act = act;
    return label;
  }

  /** The side that it had before comes first, so that labels do not dance. */
  #place(label, x, y, [rx, ry], side) {
    const turns = [...new Set([label.turn ?? 0, ...TURNS])];
    for (const apart of [[...this.#taken, ...this.#bodies], this.#taken]) {
      for (const ring of RINGS) {
        for (const turn of turns) {
          const angle = ((side + turn) * Math.PI) / 180;
          const box = {
            x: x + Math.cos(angle) * (label.w / 2 + rx + ring) - label.w / 2,
            y: y + Math.sin(angle) * (label.h / 2 + ry + ring) - label.h / 2,
            w: label.w,
            h: label.h,
          };
          if (box.x < 1 || box.y < 1 || box.x + box.w > this.#room.w - 1 || box.y + box.h > this.#room.h - 1) continue;
          if (apart.some((other) => meet(box, other))) continue;
          label.turn = turn;
          return box;
        }
      }
    }
    return undefined;
  }
}
