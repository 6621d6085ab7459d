// What a page that is loaded again takes over from the one before it: inputs, what was done, and what was chosen. If the
// chart is still the same it goes on exactly where it was; if it has changed, what was done is done again with the new one.

import { parsed } from './cells.js';
import { Trace } from './trace.js';
import { cell } from './values.js';

/** Where it lies between two pages. */
const KEY = 'grafc-keep';
/** What is done again takes no longer than so many rows. */
const MOST = 300000;

/** What makes two charts the same: the script with the module, and the names. */
function identity() {
  const policy = document.querySelector('meta[http-equiv="Content-Security-Policy"]').content;
  return `${/script-src '[^']*'/.exec(policy)?.[0]} ${document.getElementById('chart-data').textContent}`;
}

/** Plain data that JSON can carry. */
export function keep(engine, settings, fold, pan) {
  const { inputs } = engine.model;
  const named = ([place, value]) => [inputs[place].name, cell(value, inputs[place].type)];
  return {
    chart: identity(),
    inputs: engine.pending.map((value, place) => named([place, value])),
    trace: engine.trace.entries.map((entry) => ({ ...entry, changes: entry.changes.map(named) })),
    time: engine.time,
    saved: engine.isBegun ? null : engine.module.save(),
    breaks: { steps: [...engine.breaks.steps], transitions: [...engine.breaks.transitions] },
    settings: settings.values,
    folded: fold.frames.filter((frame) => frame.isFolded).map((frame) => frame.key),
    box: pan.isFit ? null : pan.box,
  };
}

/** Takes what was kept, once. Null if nothing was. */
export function kept() {
  try {
    const text = sessionStorage.getItem(KEY);
    sessionStorage.removeItem(KEY);
    return text === null ? null : JSON.parse(text);
  } catch {
    return null;
  }
}

/** Goes on where another page was. Whether inputs and situation could be taken over. */
export function goOn(engine, { chart, inputs, trace, time, saved, breaks }) {
  const { model } = engine;
  const placed = ([name, text]) => {
    const place = model.input.get(name);
    const value = place === undefined ? undefined : parsed(text, model.inputs[place].type);
    return value === undefined ? [] : [[place, value]];
  };
  const rows = new Trace();
  rows.entries = trace.map((entry) => ({ ...entry, changes: entry.changes.flatMap(placed) }));
  rows.length = rows.entries.reduce((sum, entry) => sum + entry.count, 0);
  const known = new Set([...model.steps, ...model.macros].map((step) => step.label));
  breaks.steps.filter((key) => known.has(key)).forEach((key) => engine.breaks.steps.add(key));
  breaks.transitions.filter((key) => model.byTransition.has(key)).forEach((key) => engine.breaks.transitions.add(key));
  let isWhole = true;
  if (rows.length > 0 && rows.length <= MOST) {
    again(engine, rows);
    if (saved && chart === identity()) engine.module.restore(saved, time);
  } else {
    isWhole = rows.length === 0;
  }
  for (const [place, value] of inputs.flatMap(placed)) engine.set(place, value);
  return isWhole;
}

/** Does a trace again, without a look at breakpoints. */
function again(engine, rows) {
  const { breaks } = engine;
  engine.breaks = { steps: new Set(), transitions: new Set() };
  engine.start();
  let isFirst = true;
  for (const { t, changes, restart } of rows.rows()) {
    engine.isRestarting = restart;
    for (const [place, value] of changes) engine.set(place, value);
    if (isFirst) engine.initial(t);
    else engine.scan(t);
    isFirst = false;
  }
  engine.breaks = breaks;
}
