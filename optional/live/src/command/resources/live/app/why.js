// Why something happened, or did not: the server answers, by the log of the run.

import { html, nothing } from '/lib/lit-html/lit-html.js';
import { plain } from './text.js';

/** A line of an answer that has a time; the last one has none. */
const LINK = /^ *([\d.]+) s {2}(.*)$/s;

/** Words of which one can ask by a click; `question` is nothing where one cannot. */
export const asking = (app, question, title, words) => (!app.canAsk || !question ? words
  : html`<button type="button" class="link ask" title="why?" @click=${() => app.ask(question, title)}>${words}</button>`);

/** The box for what did not happen. */
export function box(app, state, t) {
  if (app.ofFile) return html`<small>To ask why: <code>javino watch --trace FILE</code> or <code>javino why FILE</code></small>`;
  if (!app.canAsk) return nothing;
  const agents = [...state.agents.values()].filter((a) => a.ended === undefined);
  return html`<form id="ask" @submit=${(e) => {
    e.preventDefault();
    const data = new FormData(e.target);
    const what = data.get('what').trim();
    app.ask({ what, ...(data.get('agent') && { agent: data.get('agent') }), ...(app.past && { until: t }) }, what);
  }}><input name="what" placeholder="why (not) dark(3)" size="13" required
      aria-label="why, or why not" title="A belief, goal (!go), event (+dark(_)), action or pin: why it is so, or why not">
    ${agents.length > 1 ? html`<select name="agent" aria-label="of which agent" title="Of which agent"><option value="">of any</option>${agents.map((a) =>
      html`<option value=${a.name}>of ${plain(a.name, 16)}</option>`)}</select>` : nothing}<button>?</button></form>`;
}

/** What was answered last. */
export function answer(app, { title, lines, error }) {
  const shown = (line) => {
    const [, t, words] = LINK.exec(line) ?? [];
    return t === undefined ? html`<li class="cause">${plain(line, 400)}</li>`
      : html`<li><button type="button" class="link" title="go there" @click=${() => app.goTo(Number(t))}>${Number(t).toFixed(3)} s</button> <span>${plain(words, 400)}</span></li>`;
  };
  return html`<h3>Why ${plain(title, 60)}? <button type="button" class="link" id="close-why" aria-label="close the answer" @click=${app.closeWhy}>✕</button></h3>
    ${error ? html`<p class="bad">${plain(error, 300)}</p>` : !lines ? html`<p class="hint">…</p>` : html`<ol>${lines.map(shown)}</ol>`}`;
}
