// Puts the page together, and draws what has changed once a frame.

import { Model } from './model.js';
import { Engine } from './engine.js';
import { Clock } from './clock.js';
import { Settings } from './settings.js';
import { View } from './view.js';
import { Pan } from './pan.js';
import { Fold } from './fold.js';
import { Names, transitionName } from './names.js';
import { Inputs } from './inputs.js';
import { Keys } from './keys.js';
import { Watch } from './watch.js';
import { Breakpoints } from './breakpoints.js';
import { TimingPanel } from './timing_panel.js';
import { bind, bindSettings, say, showControls } from './controls.js';
import { fileName, onFile, save } from './files.js';
import { read, written } from './csv.js';
import { result } from './result.js';
import { dump } from './vcd.js';
import { goOn, keep, kept } from './keep.js';
import { byId, mark, write } from './dom.js';
import { shown } from './values.js';
import { chooseLanguage, duration, onLanguage, word } from './texts.js';
import { Chart } from './chart.js';

let broken = null;
let isAsked = false;
const model = new Model(JSON.parse(byId('chart-data').textContent));
const engine = new Engine(Chart, model);
engine.initial();
const settings = new Settings();
const before = kept();
if (before) Object.assign(settings.values, before.settings);
const clock = new Clock(engine, settings, happened);
const canvas = document.querySelector('.canvas');
const svg = canvas.querySelector('svg');
const view = new View(svg, model);
const pan = new Pan(canvas, svg);
const keys = new Keys(settings);
const inputs = new Inputs(model, engine, keys, change);
keys.inputs = inputs;
const fold = new Fold(svg, pan, model, draw);
const names = new Names(svg, model, view, pan, (kind, key) => breakpoints.toggle(kind, key));
const watch = new Watch(model, fold);
const breakpoints = new Breakpoints(model, engine, draw);
const timing = new TimingPanel(engine, settings);

function change(place, value) {
  clock.takeOver();
  engine.set(place, value);
  inputs.show();
  draw();
}

/** What the clock has to say. */
function happened(what, hit) {
  if (what === 'break') {
    broken = hit;
    say(word('broken', { where: hit.kind === 'step' ? word('step-named', { label: shown(hit.name) }) : transitionName(model.byTransition.get(hit.name)) }));
  } else {
    broken = null;
  }
  if (what === 'no-delay') say(word('no-delay'));
  if (what === 'nothing-to-undo') say(word('nothing-to-undo'));
  if (what === 'replayed') say(word('replayed'));
  if (what === 'taken-over') say(word('taken-over'));
  // A run draws within its own frame.
  if (what === 'changed' && clock.isRunning) drawNow(performance.now());
  else draw();
}

/** Draws in the next frame, however often it is asked for. */
function draw() {
  if (isAsked) return;
  isAsked = true;
  requestAnimationFrame((now) => {
    isAsked = false;
    drawNow(now);
  });
}

function drawNow(now) {
  view.show(engine, clock.isRunning, now);
  if (!clock.isRunning) names.show(engine.breaks);
  inputs.show();
  watch.show(engine);
  timing.show();
  write(byId('time'), duration(engine.time));
  const state = byId('state');
  const key = broken ? 'break' : clock.isRunning ? 'running' : engine.isBegun ? 'within' : 'paused';
  mark(state, 'data-state', key);
  write(state, { break: word('state-break'), running: word(clock.isSlow ? 'state-slow' : 'state-running'), within: word('state-within'), paused: word('state-paused') }[key]);
  if (!clock.isRunning || clock.stats.frames % 30 === 0) showControls(clock);
}

function load(text) {
  let trace;
  try {
    trace = read(text, model.inputs);
  } catch (refusal) {
    if (!refusal.key) throw refusal;
    say(word(refusal.key, refusal.gaps));
    return;
  }
  clock.load(trace);
  say(word('loaded', { rows: trace.length }));
}

/** A copy of what was done, which a replay can play while it is done anew. */
function copied() {
  return read(written(engine.trace, model.inputs), model.inputs);
}

bind({
  run: () => clock.run(),
  pause: () => clock.pause(),
  scan: () => clock.scan(),
  'micro-step': () => clock.microStep(),
  jump: () => clock.jump(),
  undo: () => clock.undo(),
  replay: () => clock.play(copied()),
  reset: () => clock.reset(),
  'save-trace': () => save(fileName(model.name, 'trace.csv'), written(engine.trace, model.inputs), 'text/csv'),
  'save-result': () => save(fileName(model.name, 'result.csv'), result(Chart, model, engine.trace), 'text/csv'),
  'save-vcd': () => save(fileName(model.name, 'vcd'), dump(Chart, model, engine.trace), 'text/plain'),
  'load-trace': () => byId('file').click(),
  'zoom-in': () => pan.zoom(1.25),
  'zoom-out': () => pan.zoom(0.8),
  fit: () => pan.fit(),
  'timing-in': () => timing.zoom(1.5),
  'timing-out': () => timing.zoom(1 / 1.5),
  'timing-all': () => timing.all(),
}, clock, keys);
bindSettings(settings);
onFile(load);

function theme() {
  const chosen = settings.get('theme');
  if (chosen === 'auto') delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = chosen;
}

onLanguage(() => {
  keys.show();
  watch.told = '';
  breakpoints.show();
  if (!clock.isRunning) draw();
});
settings.onChange((name, value) => {
  if (name === 'theme') theme();
  if (name === 'language') chooseLanguage(value);
  draw();
});
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
matchMedia('print').addEventListener('change', () => drawNow(performance.now()));

if (before) {
  if (!goOn(engine, before)) say(word('kept-inputs'));
  keys.byKey = new Map(before.settings.keys.filter(([, place]) => model.inputs[place]?.type === 'bool'));
  before.folded.forEach((key) => fold.toggle(key));
  if (before.box) {
    pan.isFit = false;
    pan.show(before.box);
  }
  breakpoints.show();
}
theme();
chooseLanguage(settings.get('language'));
drawNow(performance.now());

window.grafc = {
  word,
  keep: () => keep(engine, settings, fold, pan),
  trace: () => written(engine.trace, model.inputs),
  result: () => result(Chart, model, engine.trace),
  vcd: () => dump(Chart, model, engine.trace),
  load,
  stats: () => ({ ...clock.stats, now: performance.now() }),
};
