// What one can have an agent and its board do.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { PERFORMATIVES } from './lists.js';
import { plain } from './text.js';

/** Actions whose fields for arguments were asked for. */
const opened = new Set();

const submitted = (act) => (e) => {
  e.preventDefault();
  act(new FormData(e.target));
};

/** The board's actions as buttons; a field only where the agent's program gives arguments, or where one was asked for. */
export const actions = (app, board, agent) => (!app.controls.includes('act') || board.actions.length === 0 ? nothing : html`
  <ul class="actions">${board.actions.map((name) => {
    const use = board.uses.get(name);
    const key = board.name + ' ' + name;
    return html`<li><form @submit=${submitted((data) => {
      const given = (data.get('arguments') ?? '').trim();
      app.send({ do: 'act', ...(agent && { agent }), action: given ? `${name}(${given})` : name });
    })}><button data-action=${name}>${plain(name, 40)}</button>${use || opened.has(key)
      ? html` <input name="arguments" aria-label="arguments of ${name}" placeholder=${use || '3, "text"'} size="10">`
      : use === undefined ? html`<button type="button" class="link" aria-label="give ${name} arguments" title="with arguments"
        @click=${() => { opened.add(key); app.redraw(); }}>(…)</button>` : nothing}</form></li>`;
  })}</ul>`);

/** A message in the board's name: to all, or to one device, sealed by the board's own key. */
export const say = (app, board, agent, state) => (!app.controls.includes('say') || !board.radio ? nothing : html`
  <form class="say" @submit=${submitted((data) => app.send({ do: 'say', ...(agent && { agent }), to: data.get('to').trim(), performative: data.get('performative'), content: data.get('content') }))}>
    <label>say to <input name="to" value="////" size="5" maxlength="4" required list="addresses" title="//// is all; to a device it is sealed by the board's key"></label>
    <datalist id="addresses">${[...state.boards.values()].filter((b) => b.address && b !== board).map((b) => html`<option value=${b.address}>${plain(b.title, 20)}</option>`)}<option value="////">all</option></datalist>
    <select name="performative" aria-label="performative">${PERFORMATIVES.map((each) => html`<option>${each}</option>`)}</select>
    <input name="content" aria-label="content" placeholder="dark(3)" size="10" required><button>say</button></form>`);

/** A goal for an agent. */
export const goal = (app, agent, named) => (!app.controls.includes('goal') ? nothing : html`
  <form class="goal" data-agent=${agent} @submit=${submitted((data) => app.send({ do: 'goal', agent, goal: data.get('goal').trim() }))}>
    <label>goal ${named ? 'of ' + plain(agent, 16) + ' ' : ''}! <input name="goal" placeholder="patrol(3)" size="14" required></label><button>give</button></form>`);
