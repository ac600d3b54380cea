// Small plots of numbers over the last half minute: percepts, and rates of counters.

import { ink } from './colours.js';

export const SPAN = 30;
const POINTS = 200;
/** Charts that are drawn anew at one call; the others have their turn at the next ones. */
const EACH_TURN = 3;

/** A plot spans at least this part of the value, so that noise looks small. */
const LEAST_SPAN = 0.25;

/** The ends of the axis: what it shows is as large as it looks. */
export function rangeOf(values) {
  const low = Math.min(...values);
  const high = Math.max(...values);
  if (values.length === 0) return [0, 1];
  if (high - low >= LEAST_SPAN * Math.max(Math.abs(low), Math.abs(high), 4)) return [low, high];
  const span = Math.max(high - low, LEAST_SPAN * Math.max(Math.abs(low), Math.abs(high)), 1);
  const step = 10 ** Math.floor(Math.log10(span));
  const middle = (low + high) / 2;
  return [Math.floor((middle - span / 2) / step) * step, Math.ceil((middle + span / 2) / step) * step];
}

const charts = new Map();
let turn = 0;

function chartOn(canvas) {
  let chart = charts.get(canvas);
  if (!chart) {
    chart = new Chart(canvas, {
      type: 'line',
      data: { datasets: [{ data: [], borderWidth: 1.5, pointRadius: 0, stepped: true }] },
      options: {
        animation: false,
        parsing: false,
        normalized: true,
        maintainAspectRatio: false,
        events: [],
        plugins: { legend: { display: false }, tooltip: { enabled: false } },
        scales: {
          x: { type: 'linear', display: false, min: -SPAN, max: 0 },
          y: {
            border: { display: false },
            afterBuildTicks: (scale) => (scale.ticks = [scale.min, scale.max].map((value) => ({ value }))),
            ticks: { font: { size: 10 }, autoSkip: false },
          },
        },
      },
    });
    charts.set(canvas, chart);
  }
  return chart;
}

/** Draws some of the plots that are on the screen; `points` gives those of a canvas from a time to a time, as `{t, y}`. */
export function drawPlots(t, points) {
  for (const [canvas, chart] of charts) {
    if (!canvas.isConnected) {
      chart.destroy();
      charts.delete(canvas);
    }
  }
  const seen = [...document.querySelectorAll('canvas.plot')].filter((canvas) => {
    const { top, bottom } = canvas.getBoundingClientRect();
    return bottom > 0 && top < innerHeight;
  });
  for (let i = 0; i < Math.min(EACH_TURN, seen.length); i++) {
    const canvas = seen[turn++ % seen.length];
    const chart = chartOn(canvas);
    const all = points(canvas, t - SPAN, t);
    const each = Math.ceil(all.length / POINTS);
    const data = all.filter((_, k) => k % each === 0 || k === all.length - 1).map((p) => ({ x: Math.max(p.t - t, -SPAN), y: p.y }));
    // The last value holds until now.
    if (data.length > 0) data.push({ x: 0, y: data[data.length - 1].y });
    chart.data.datasets[0].data = data;
    chart.data.datasets[0].borderColor = ink('ink');
    const { y } = chart.options.scales;
    y.ticks.color = ink('soft');
    y.grid = { color: ink('line') };
    const values = data.map((point) => point.y);
    [y.min, y.max] = canvas.dataset.counter ? [0, Math.ceil(Math.max(1, ...values))] : rangeOf(values);
    chart.update('none');
  }
}
