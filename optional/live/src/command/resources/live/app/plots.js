// Small plots of numbers over the last half minute: percepts, and rates of counters.

import { ink } from './colours.js';

const SPAN = 30;
const POINTS = 200;
/** Charts that are drawn anew at one call; the others have their turn at the next ones. */
const EACH_TURN = 3;

const charts = new Map();
let turn = 0;

function chartOn(canvas) {
  let chart = charts.get(canvas);
  if (!chart) {
    const axis = { ticks: { maxTicksLimit: 3, font: { size: 10 }, maxRotation: 0 }, border: { display: false } };
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
          y: axis,
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
    chart.options.scales.y.ticks.color = ink('soft');
    chart.options.scales.y.grid = { color: ink('line') };
    chart.options.scales.y.beginAtZero = canvas.dataset.counter !== undefined;
    chart.update('none');
  }
}
