// The controls: time, and whatever of the run the source lets one disturb.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { live } from '/lib/lit-html/directives/live.js';
import { plain } from './text.js';

/** So fast a story is told that is new to its viewer. */
export const SLOW = 0.3;
export const RATES = [0.1, 0.3, 0.5, 1, 2, 5, 10];

/** Time: back and forth, pause, speed. */
export function player(clock, model, app) {
  const end = model.end;
  const goes = clock.following ? model.head.speed !== 0 : clock.playing;
  const rate = app.inRun ? model.head.pace : Math.abs(clock.rate);
  return html`<div class="bar">
    ${clock.live ? html`<button type="button" id="follow" aria-pressed=${clock.following} @click=${app.follow}
      title="Follow the run (End)"><span class="dot"></span>live</button>` : nothing}
    <button type="button" id="back" @click=${() => app.step(-1)} title="The event before (comma)" aria-label="the event before">|◂</button>
    <button type="button" id="reverse" @click=${app.reverse} aria-pressed=${!clock.following && clock.playing && clock.rate < 0} title="Play backwards (R)" aria-label="play backwards">◀</button>
    <button type="button" id="play" @click=${app.toggle} title=${(goes ? 'Pause ' : 'Go on with ') + (app.inRun ? 'the run' : 'what you see') + ' (Space)'}
      aria-label=${goes ? 'pause' : 'play'}>${goes ? '❚❚' : '▶'}</button>
    <button type="button" id="forth" @click=${() => app.step(1)} title="The next event (full stop)" aria-label="the next event">▸|</button>
    <input id="slider" type="range" min="0" max=${Math.max(end, 0.001)} step="any" .value=${live(String(clock.t))} aria-label="time"
      aria-valuetext=${clock.t.toFixed(1) + ' seconds'} @input=${(e) => app.goTo(Number(e.target.value))}>
    <label>speed <select id="rate" .value=${live(String(rate))} @change=${(e) => app.rate(Number(e.target.value))}>
      ${RATES.map((each) => html`<option value=${each} ?selected=${each === 1}>${each} ×</option>`)}</select></label>
    <label class="button">open a trace <input id="file" type="file" accept=".jsonl,.json,.txt" @change=${app.opened}></label>
    ${app.ofFile ? html`<button type="button" id="close-file" @click=${app.closeFile}>back to the run</button>` : nothing}
  </div>`;
}

export const button = (id, words, action, title = '') => html`<button type="button" id=${id} title=${title} @click=${action}>${words}</button>`;

/** A slider that follows the run, but not while somebody moves it. */
export const slider = (id, label, value, shown, attributes, change) => html`<label class="slide" for=${id}>${label}
  <input id=${id} type="range" min="0" max=${attributes.max} step=${attributes.step} .value=${document.activeElement?.id === id ? document.activeElement.value : String(value)}
    @input=${(e) => change(Number(e.target.value))}><b>${shown}</b></label>`;

/** When a story has been told: what one can do next. */
export const afterStory = (app, state, t) => {
  const all = [...state.behaviours.values()];
  return all.length === 0 || all.some((b) => !(b.observedAt <= t)) ? nothing : html`
    ${button('again', 'Again, slowly', () => app.play(SLOW), 'What you see, from the first event of an agent')}
    ${button('start-over', 'Start over', () => app.play(1), 'The same at its own speed')}
    ${app.controls.includes('send') ? button('now-forge', 'Now forge a message', app.nowForge) : nothing}`;
};

/** Controls of the chosen thing, of the world, and of the air. */
export function interfere(app, state, radio) {
  const can = (what) => app.controls.includes(what);
  const { chosen, mode } = app.ui;
  const anyOfBoard = ['reset', 'unplug', 'power-cut', 'move'].some(can);
  const things = [
    ...[...state.boards.values()].map((b) => ['board', b.name, b.title]),
    ...(can('obstacle') ? [...state.obstacles.keys()].map((name) => ['obstacle', name, name]) : []),
  ];
  const errors = state.radio.bitErrorRate;
  return html`
    ${anyOfBoard ? html`<select id="chosen" aria-label="chosen" .value=${live(chosen ? chosen.kind + ' ' + chosen.name : '')}
        @change=${(e) => app.choose(...e.target.value.split(/ (.*)/s, 2))}>
        <option value="">choose …</option>
        ${things.map(([kind, name, title]) => html`<option value="${kind} ${name}" ?selected=${chosen?.kind === kind && chosen.name === name}>${plain(title, 24)}</option>`)}
      </select>` : nothing}
    ${can('obstacle') || can('jam') && radio ? html`<fieldset><legend>put there</legend>
      ${can('obstacle') ? html`<button type="button" id="add-obstacle" aria-pressed=${mode === 'obstacle'} @click=${() => app.mode('obstacle')}>add an obstacle</button>` : nothing}
      ${can('jam') && radio ? html`<button type="button" id="jam" aria-pressed=${mode === 'jam'} @click=${() => app.mode('jam')}>jam here</button>` : nothing}
      </fieldset>` : nothing}
    ${can('light') || can('radio') && radio ? html`<fieldset><legend>world and air</legend>
      ${can('light') && state.light !== undefined ? slider('light', 'light', state.light, state.light, { max: 1023, step: 1 }, (value) => app.often({ do: 'light', value })) : nothing}
      ${can('radio') && radio ? slider('errors', 'bit errors', Math.round(errors * 1000), (errors * 100).toFixed(1) + ' %', { max: 50, step: 1 }, (n) => app.often({ do: 'radio', bitErrorRate: n / 1000 })) : nothing}
      ${can('radio') && radio ? slider('range', 'range', state.radio.range, state.radio.range + ' m', { max: 150, step: 5 }, (range) => app.often({ do: 'radio', range })) : nothing}
      </fieldset>` : nothing}`;
}
