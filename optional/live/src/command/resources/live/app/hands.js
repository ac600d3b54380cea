// Pointer and keys, on the road and for the time.

import { RATES } from './controls.js';

/** A dropped thing stays where it is until the run shows it there, at most so long, in ms. */
const HOLD = 1200;
/** The radius of a new obstacle, in metres. */
export const RADIUS = 0.5;
/** A jam lasts so long, in seconds. */
export const JAM = 2;
/** A pointer that moves by fewer pixels has clicked. */
const SLIP = 3;
const WITH_CHOSEN = { Delete: 'removeChosen', j: 'jamChosen' };

/** Moves what the pointer or the keyboard holds. */
function hold(app, thing, to, down) {
  app.ui.held = { ...thing, place: to, down, until: performance.now() + HOLD };
  if (thing.kind === 'injector') app.ui.stood = to;
  else app.often(app.moved(thing, to));
}

const movable = (app, thing) => thing && app.controls.includes({ board: 'move', obstacle: 'obstacle', injector: 'send' }[thing.kind]);

/** On the road things are dragged, and the road itself; it can be used by keys alone. `shown` gives what the page shows now. */
export function hands(canvas, road, app, shown) {
  const spot = (e) => [e.offsetX, e.offsetY];
  let from;
  let grip;
  let dragged = false;
  canvas.addEventListener('pointerdown', (e) => {
    const at = spot(e);
    if (app.ui.mode) {
      const position = road.placeAt(...at);
      if (app.ui.mode === 'jam') app.send({ do: 'jam', duration: JAM, position });
      else app.send({ do: 'obstacle', name: freshName(shown().model.head), position, radius: RADIUS });
      app.mode('');
      return;
    }
    const thing = road.under(...at);
    if (!thing || thing.kind !== 'injector') app.choose(thing?.kind, thing?.name);
    canvas.setPointerCapture(e.pointerId);
    from = at;
    dragged = false;
    // Whatever of it was taken hold of stays under the pointer.
    grip = movable(app, thing) && { ...thing, off: road.placeAt(...at).map((metres, axis) => thing.place[axis] - metres) };
  });
  canvas.addEventListener('pointermove', (e) => {
    const at = spot(e);
    dragged ||= from && Math.hypot(at[0] - from[0], at[1] - from[1]) > SLIP;
    if (!from || !dragged) return;
    if (grip) hold(app, { kind: grip.kind, name: grip.name }, road.placeAt(...at).map((metres, axis) => metres + grip.off[axis]), true);
    else road.pan(at[0] - from[0], at[1] - from[1]);
    from = at;
  });
  for (const end of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(end, () => {
      from = undefined;
      if (app.ui.held?.down) app.ui.held = { ...app.ui.held, down: false, until: performance.now() + HOLD };
    });
  }
  canvas.addEventListener('wheel', (e) => {
    e.preventDefault();
    road.zoom(2 ** (-Math.max(-100, Math.min(e.deltaY, 100)) / 250), ...spot(e));
  });
  canvas.addEventListener('keydown', (e) => {
    const state = shown().model.stateAt(shown().clock.t);
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
    if (e.key === 'PageDown' || e.key === 'PageUp') {
      const things = [...[...state.boards.keys()].map((name) => ['board', name]), ...[...state.obstacles.keys()].map((name) => ['obstacle', name])];
      const now = things.findIndex(([kind, name]) => app.ui.chosen?.kind === kind && app.ui.chosen.name === name);
      if (things.length) app.choose(...things[(now + (e.key === 'PageDown' ? 1 : things.length - 1) + (now < 0 && e.key === 'PageUp' ? 1 : 0)) % things.length]);
    } else if (step && movable(app, app.ui.chosen)) {
      const at = app.ui.held?.name === app.ui.chosen.name ? app.ui.held.place : app.placeOfChosen(state);
      const far = e.shiftKey ? 5 : 1;
      if (at) hold(app, app.ui.chosen, [at[0] + step[0] * far, at[1] + step[1] * far], false);
    } else if (e.key === 'f') {
      road.fit();
    } else if (WITH_CHOSEN[e.key]) {
      app[WITH_CHOSEN[e.key]]();
    } else {
      return;
    }
    e.preventDefault();
    e.stopPropagation();
  });
}

function freshName({ obstacles }) {
  for (let n = 1; ; n++) if (!obstacles.has('obstacle' + n)) return 'obstacle' + n;
}

/** Keys for time, and to let go, wherever the focus is. */
export function keys(app, shown) {
  document.addEventListener('keydown', (e) => {
    if (e.key === 'Escape') {
      app.ui.mode = '';
      app.letGo();
    }
    if (e.ctrlKey || e.metaKey || e.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName)) return;
    const { clock, model } = shown();
    const faster = { '+': 1, '-': -1 }[e.key];
    if (e.key === ' ' && e.target.tagName !== 'BUTTON' && e.target.tagName !== 'SUMMARY') app.toggle();
    else if (e.key === 'ArrowLeft' || e.key === 'ArrowRight') app.goTo(clock.t + (e.key === 'ArrowLeft' ? -1 : 1));
    else if (e.key === ',' || e.key === '.') app.step(e.key === ',' ? -1 : 1);
    else if (e.key === 'r') app.reverse();
    else if (e.key === 'End') clock.live ? clock.follow() : app.goTo(model.end);
    else if (e.key === 'Home') app.goTo(0);
    else if (faster) app.rate(nextRate(app.inRun ? model.head.pace : Math.abs(clock.rate), faster));
    else return;
    e.preventDefault();
  });
}

function nextRate(now, direction) {
  return RATES[Math.max(0, Math.min(RATES.length - 1, RATES.indexOf(now) + direction))];
}
