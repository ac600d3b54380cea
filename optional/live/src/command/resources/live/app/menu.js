// The menu of the chosen vehicle, house or obstacle: what can be done with it, and its sensors.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { live } from '/lib/lit-html/directives/live.js';
import { button, slider } from './controls.js';
import { plain, rounded } from './text.js';

/** The emulated sensors (its README): what they measure, and the most that a slider gives. */
const SENSORS = {
  __proto__: null,
  'hc-sr04': { words: 'distance', most: 400, unit: ' cm' },
  ldr: { words: 'light', most: 1023, unit: '' },
  digital: { words: 'level', most: 1, unit: '' },
};

/** A slider for what a sensor measures; a button to be pressed for one that has but two levels. `place` tells two of it apart. */
export function sensor(app, board, { type, pin, held }, place = '') {
  if (!SENSORS[type]) return nothing;
  const { words, most, unit } = SENSORS[type];
  const id = place + 'sensor-' + (place ? board.name + '-' : '') + pin;
  const set = (value) => ({ do: 'sensor', board: board.name, pin, value });
  const free = held === undefined ? nothing : button(place + 'free-' + pin, 'let go', () => app.send(set(null)), 'Let it measure the world again');
  if (most === 1) {
    return html`<p class="sensor">${[0, 1].map((level) => html`<button type="button" id="${id}-${level}" aria-pressed=${held === level} @click=${() => app.send(set(level))}>${pin} ${level ? 'high' : 'low'}</button>`)}${free}</p>`;
  }
  return html`<p class="sensor">${slider(id, `${words} at ${pin}`, held ?? most, held === undefined ? 'as it is' : held + unit, { max: most, step: 1 },
    (value) => app.often(set(value)))}${free}</p>`;
}

export function menu(app, state) {
  const can = (what) => app.controls.includes(what);
  const { chosen } = app.ui;
  const board = chosen?.kind === 'board' ? state.boards.get(chosen.name) : undefined;
  const at = app.placeOfChosen(state);
  if (!chosen || app.controls.length === 0) return nothing;
  const on = (body) => () => app.send({ ...body, board: board.name });
  return html`<h2>${plain(board?.title ?? chosen.name, 30)}
      <button type="button" id="close-menu" class="link" aria-label="close the menu" @click=${() => app.choose()}>✕</button></h2>
    <p>${board ? html`
      ${can('unplug') && board.port !== 'unplugged' ? button('unplug', 'unplug', on({ do: 'unplug' }), 'Pull the cable between agent and board') : nothing}
      ${can('plug') && board.port === 'unplugged' ? button('plug', 'plug in', on({ do: 'plug' })) : nothing}
      ${can('reset') ? button('reset', 'reset', on({ do: 'reset' }), 'Press the reset button') : nothing}
      ${can('power-cut') ? button('power-cut', 'cut power', on({ do: 'power-cut', duration: 1 }), 'No power for one second') : nothing}
      ${can('jam') ? button('jam-chosen', 'jam here', app.jamChosen, 'Jam the radio where it stands, for two seconds') : nothing}`
      : button('remove', 'take away', app.removeChosen)}</p>
    ${at ? html`<form class="place" @submit=${app.moveChosen} @input=${app.typing} @change=${app.typing}>
      <label>x <input id="x" type="number" step="any" .value=${live(app.typed?.x ?? rounded(at[0]))} required></label>
      <label>y <input id="y" type="number" step="any" .value=${live(app.typed?.y ?? rounded(at[1]))} required></label>
      <button id="move">move</button></form>` : nothing}
    ${can('sensor') ? board?.sensors.map((each) => sensor(app, board, each)) : nothing}`;
}
