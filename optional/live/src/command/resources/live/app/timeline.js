// The time line: a lifeline for each board, and going down, in the order of time, what was said, sent and done. Only
// the rows in sight are in the page.

import { html, nothing, render, svg } from '/lib/lit-html/lit-html.js';
import { hueClass, letter } from './colours.js';
import { isFor } from './packet.js';
import { YOU, plain, seconds } from './text.js';
import { sentence } from './phrases.js';

const ROW = 24;
const HEAD = 30;
const TIME = 66;
const LEAST_COLUMN = 44;
/** A narrower column has a letter for its head. */
const NAMED = 88;
const LETTER = 6.7;

const CIRCLED = (n) => (n >= 1 && n <= 20 ? String.fromCharCode(0x245f + n) : n + '.');

/** As much of the words as a row has room for. */
const fitting = (words, width) => plain(words, Math.max(1, Math.floor((width - TIME - 24) / LETTER) - 1));

export class Timeline {
  #box;
  #space;
  #sticky = true;
  #drawn = '';
  #count = 0;
  #rows = [];

  /** `pick` is called with the mark of a row that was clicked. */
  constructor(box, pick) {
    this.#box = box;
    this.#box.addEventListener('scroll', () => {
      this.#sticky = box.scrollTop + box.clientHeight > this.#count * ROW + HEAD - 2 * ROW;
      this.#drawn = '';
    });
    this.#box.addEventListener('click', (event) => {
      const row = event.target.closest('[data-t]');
      const mark = row && this.#rows.find((each) => each.n === Number(row.dataset.n));
      if (mark) pick(mark);
    });
  }

  draw(model, state, t) {
    const boards = [...state.boards.values()];
    this.#count = model.marksUpTo(t);
    const width = Math.max(this.#box.clientWidth - 2, TIME + boards.length * LEAST_COLUMN);
    const key = [model.revisionAt(t), this.#count, model.marks.length && model.marks[0].n, boards.map((b) => b.title).join(), width, this.#box.clientHeight].join('|');
    if (key === this.#drawn) return;
    this.#drawn = key;
    const height = HEAD + this.#count * ROW + 8;
    // The injector has half a column of its own.
    const column = (width - TIME - 10) / Math.max(1, boards.length + (state.injector ? 0.5 : 0));
    // Whatever has no board begins at the left.
    const x = (name) => TIME + (name === undefined ? 7 : column * ((state.boards.get(name)?.index ?? boards.length - 0.1) + 0.35));
    if (this.#sticky) {
      if (this.#space) this.#space.style.height = height + 'px';
      this.#box.scrollTop = height;
    }
    const first = Math.max(0, Math.floor(this.#box.scrollTop / ROW) - 4);
    const last = Math.min(this.#count, first + Math.ceil(this.#box.clientHeight / ROW) + 8);
    const top = first * ROW;
    const rows = model.marks.slice(first, last);
    this.#rows = rows;
    const tall = HEAD + (last - first) * ROW + 8;
    render(html`<div class="space"><svg width=${width} height=${tall} viewBox="0 0 ${width} ${tall}" role="img"
        aria-label="Time line">
      ${boards.map((b) => svg`<line class="life" x1=${x(b.name)} x2=${x(b.name)} y1="0" y2=${tall}></line>`)}
      ${rows.map((mark, i) => this.#row(model, mark, HEAD + (i + 0.5) * ROW, x, width, state, boards))}
      </svg><div class="heads">${boards.map((b) => html`<b class="head ${hueClass(b)}" title=${plain(b.title, 30)}>${column < NAMED ? letter(b) : plain(b.title, 12)}</b>`)}</div></div>`, this.#box);
    this.#space = this.#box.querySelector('.space');
    this.#space.style.height = height + 'px';
    this.#space.querySelector('svg').style.top = top + 'px';
    this.#space.querySelector('.heads').style.width = width + 'px';
    this.#space.querySelectorAll('.head').forEach((head, i) => {
      head.style.left = x(boards[i].name) + 'px';
    });
  }

  #row(model, mark, y, x, width, state, boards) {
    const time = svg`<text class="time" x=${TIME - 8} y=${y + 4}>${seconds(mark.t)}</text>`;
    const hue = mark.board === undefined ? '' : hueClass(state.boards.get(mark.board));
    return svg`<g class="row ${mark.kind} ${hue}" data-t=${mark.t} data-n=${mark.n}><rect class="hit" x="0" y=${y - ROW / 2} width=${width} height=${ROW}></rect>
      <title>${sentence(model, state, mark) ?? plain(mark.text, 80)}${mark.line ? ' Click: why?' : ''}</title>${time}${this.#content(model, mark, y, x, width, state, boards)}</g>`;
  }

  #content(model, mark, y, x, width, state, boards) {
    switch (mark.kind) {
      case 'said': return this.#boxed((mark.agent === mark.board ? '' : plain(mark.agent, 20) + ': ') + '“' + plain(mark.text, 70) + '”', x(mark.board), y, width);
      case 'pin': case 'acted': case 'heard': return this.#boxed(plain(mark.text, 60), x(mark.board), y, width);
      case 'packet': case 'ack': return this.#arrows(mark, y, x, width, state, boards);
      case 'behaviour': return svg`<text class="done" x=${TIME} y=${y + 4}>✓ ${CIRCLED(mark.number)} ${fitting(mark.text, width - 40)}</text>`;
      case 'verdict': return svg`<text class=${mark.accepted ? 'done' : 'bad'} x=${TIME} y=${y + 4}>${fitting(mark.text, width)}</text>`;
      default: return svg`<line class="cut" x1=${TIME} x2=${width} y1=${y} y2=${y}></line>${this.#boxed(sentence(model, state, mark) ?? plain(mark.text), mark.board && state.boards.has(mark.board) ? x(mark.board) : TIME + 20, y, width)}`;
    }
  }

  /** Words or an action of a board: a box that begins at its lifeline, and is never wider than the picture. */
  #boxed(words, at, y, width) {
    const shown = fitting(words, width);
    const long = shown.length * LETTER + 14;
    const left = Math.max(TIME, Math.min(at - 7, width - long - 6));
    return svg`<rect class="box" x=${left} y=${y - 10} width=${long} height="20" rx="6"></rect>
      <text class="mono" x=${left + 7} y=${y + 4} textLength=${shown.length * LETTER}>${shown}</text>`;
  }

  /** A packet: an arrow to each board that it is for; plain ones are dashed. */
  #arrows(mark, y, x, width, state, boards) {
    const p = mark.packet;
    const from = p.board;
    const to = p.to.length > 0 ? p.to : boards.filter((b) => b.name !== from && isFor(p.destination, b.address)).map((b) => b.name);
    const lost = (name) => p.heard.some((h) => h.board === name && h.why);
    const heard = (name) => p.heard.some((h) => h.board === name);
    const ends = to.filter((name) => state.boards.has(name));
    const x0 = x(from);
    const right = ends.map(x).filter((end) => end > x0);
    const near = right.length ? Math.min(...right) : ends.length ? Math.max(...ends.map(x)) : x0 + 60;
    const words = mark.kind === 'ack' ? 'got it'
      : plain(p.destination, 4) + (p.sealed ? ' sealed' : ' ' + plain(p.content ?? p.kind, 30));
    const label = (from === 'injector' ? YOU + ': ' : '') + words;
    const middle = Math.min((x0 + near) / 2, width - (label.length * LETTER) / 2);
    return svg`${ends.map((name) => {
      const end = x(name);
      const way = end > x0 ? -1 : 1;
      // To those that it has not reached it fades.
      if (!heard(name)) return svg`<line class="arrow unheard" x1=${x0} x2=${x0 - way * Math.min(40, Math.abs(end - x0) / 2)} y1=${y + 4} y2=${y + 4}></line>`;
      return svg`<line class="arrow ${p.sealed || mark.kind === 'ack' ? '' : 'plain'}" x1=${x0} x2=${end + way * 7} y1=${y + 4} y2=${y + 4}></line>
        <path class="tip" d="M${end},${y + 4} l${way * 9},-4 v8 z"></path>
        ${lost(name) ? svg`<text class="lost" x=${end + way * 14} y=${y + 9}>✗</text>` : nothing}`;
    })}<circle class="tip" cx=${x0} cy=${y + 4} r="3"></circle>
      <text class="label" x=${middle} y=${y - 1}>${label}</text>`;
  }
}

/** The behaviours with their marks. */
export function behaviours(state, t, goTo) {
  const all = [...state.behaviours.values()].sort((a, b) => a.number - b.number);
  const done = all.filter((b) => b.observedAt !== undefined).length;
  return all.length === 0 ? nothing : html`<h3>What should happen: ${done} of ${all.length} seen</h3>
    <ol class="behaviours">${all.map((b) => html`<li class="behaviour" data-number=${b.number}
      data-observed=${b.observedAt !== undefined}><span class="mark">${b.observedAt !== undefined ? '✓' : '○'}</span>
      <button type="button" class="link" ?disabled=${b.observedAt === undefined} @click=${() => goTo(b.observedAt)}>${plain(b.text, 120)}</button></li>`)}</ol>`;
}
