// The chart as it runs: scans and micro-steps at simulated times, breakpoints, and the way back. It knows nothing of a page.

import { Trace } from './trace.js';
import { History } from './history.js';
import { restarted } from './result.js';

/** So many ways back are kept. */
const MOST_UNDO = 500;
/** So many situations of one scan are kept, to show the ring of a livelock. */
const MOST_PATH = 4000;
const NOTHING = Object.freeze(Object.create(null));

/** A chart with its time, inputs and trace. */
export class Engine {
  constructor(Chart, model) {
    this.Chart = Chart;
    this.model = model;
    this.breaks = { steps: new Set(), transitions: new Set() };
    this.undos = [];
    this.start();
  }

  /** Begins anew: the initial reaction with inputs at their declared values. */
  start(first = []) {
    this.module = new this.Chart();
    this.trace = new Trace();
    this.history = new History(this.model);
    this.time = 0;
    this.pending = this.model.inputs.map((input) => input.initial);
    this.latched = [...this.pending];
    for (const [place, value] of first) this.pending[place] = value;
    this.given = NOTHING;
    this.isBegun = false;
    this.isRestarting = false;
    this.situation = [];
    this.enabled = [];
    this.cleared = new Set();
    this.acted = new Set();
    this.fresh = { cleared: new Set(), acted: new Set() };
    this.ring = null;
    this.seen = null;
    this.scans = 0;
  }

  /** The initial reaction. */
  initial(t = 0) {
    this.isRestarting = false;
    this.giveAll();
    this.begin(t);
    this.finish();
  }

  giveAll() {
    this.given = Object.create(null);
    this.model.inputs.forEach((input, place) => (this.given[input.name] = this.pending[place]));
  }

  /** What an input is from the next scan on. */
  set(place, value) {
    this.pending[place] = this.model.inputs[place].type === 'real' ? Math.fround(value) : value;
  }

  /** Whether an input has been changed since the scan before. */
  waits(place) {
    return !Object.is(this.pending[place], this.latched[place]);
  }

  get hasWaiting() {
    return this.pending.some((value, place) => !Object.is(value, this.latched[place]));
  }

  /** Begins a scan: time and inputs are taken, and the trace gets a row. */
  begin(t) {
    const changes = [];
    const restart = this.isRestarting;
    this.isRestarting = false;
    if (restart) {
      this.module = restarted(this.module, this.Chart);
      this.situation = [];
      this.giveAll();
    }
    this.pending.forEach((value, place) => {
      if (!this.waits(place)) return;
      changes.push([place, value]);
      if (this.given === NOTHING) this.given = Object.create(null);
      this.given[this.model.inputs[place].name] = value;
      this.latched[place] = value;
    });
    this.time = t;
    this.trace.add(t, changes, restart);
    this.isBegun = true;
    this.cleared = new Set();
    this.acted = new Set();
    this.path = [];
    this.flagged = this.module.flags.livelock;
  }

  /** One micro-step of the scan that is begun. The answer is the breakpoint that it met, or null. */
  advance() {
    const result = this.module.microStep(this.given, this.time);
    this.given = NOTHING;
    this.seen = null;
    this.enabled = result.enabled;
    for (const name of result.cleared) {
      this.cleared.add(name);
      this.fresh.cleared.add(name);
    }
    const before = this.situation;
    const now = this.module.situation;
    const isSame = before.length === now.length && before.every((label, place) => label === now[place]);
    if (!isSame) this.situation = now;
    // What is stored is done in one micro-step: it is remembered for who looks later.
    if (!result.stable || !isSame) {
      for (const action of this.observed.actions ?? []) {
        this.acted.add(action);
        this.fresh.acted.add(action);
      }
    }
    if (this.path.length < MOST_PATH) this.path.push(this.situation);
    if (result.stable) this.end();
    return this.met(result.cleared, before);
  }

  /** Ends the scan: everything is published. */
  end() {
    this.isBegun = false;
    this.scans += 1;
    const { outputs, variables, flags } = this.module;
    this.history.add(this.time, this.latched, outputs, variables, this.situation);
    if (flags.livelock && !this.flagged) this.ring = ring(this.path);
  }

  met(cleared, before) {
    const { steps, transitions } = this.breaks;
    if (transitions.size) {
      const name = cleared.find((name) => transitions.has(name));
      if (name !== undefined) return { kind: 'transition', name };
    }
    if (steps.size && before !== this.situation) {
      const macros = this.model.activeMacros(this.situation);
      const macrosBefore = this.model.activeMacros(before);
      for (const name of steps) {
        const is = this.situation.includes(name) || macros.has(name);
        if (is && !before.includes(name) && !macrosBefore.has(name)) return { kind: 'step', name };
      }
    }
    return null;
  }

  /** Goes on to the end of the scan, or to a breakpoint, which is the answer. */
  finish() {
    while (this.isBegun) {
      const hit = this.advance();
      if (hit) return hit;
    }
    return null;
  }

  /** A scan at a time; if one is begun, that one is finished. */
  scan(t) {
    if (!this.isBegun) this.begin(t);
    return this.finish();
  }

  /** A micro-step; if no scan is begun, the first of one at a time. */
  microStep(t) {
    if (!this.isBegun) this.begin(t);
    return this.advance();
  }

  /** The time at which the next delay ends, or null. */
  get nextEnd() {
    const left = this.module.delays.filter((delay) => delay.running && Number(delay.left) > 0).map((delay) => Number(delay.left));
    return left.length ? this.time + Math.min(...left) : null;
  }

  /** What the last micro-step looked like. */
  get observed() {
    return this.seen ?? this.module.observed ?? {};
  }

  /** Remembers where we are, so that `undo` comes back to it. */
  remember() {
    if (this.undos.length >= MOST_UNDO) this.undos.shift();
    this.undos.push({
      saved: this.module.save(),
      seen: this.observed,
      traceMark: this.trace.mark(),
      historyMark: this.history.mark(),
      pending: [...this.pending],
      latched: [...this.latched],
      cleared: new Set(this.cleared),
      acted: new Set(this.acted),
      ...this.parts(),
    });
  }

  parts() {
    const { module, trace, history, time, isBegun, isRestarting, situation, enabled, ring, path, flagged, given, scans } = this;
    return { module, trace, history, time, isBegun, isRestarting, situation, enabled, ring, path, flagged, given, scans };
  }

  /** Goes back to where `remember` was called last. */
  undo() {
    const back = this.undos.pop();
    if (!back) return false;
    const { saved, traceMark, historyMark, ...rest } = back;
    Object.assign(this, rest);
    this.module.restore(saved, this.time);
    this.trace.cut(traceMark);
    this.history.cut(historyMark);
    this.fresh = { cleared: new Set(), acted: new Set() };
    return true;
  }
}

/** The situations that a livelock goes round in: from the last one back to where it was before. */
function ring(path) {
  const key = (situation) => situation.join('\u0000');
  const last = key(path.at(-1));
  for (let at = path.length - 2; at >= 0; at--) {
    if (key(path[at]) === last) return path.slice(at, -1);
  }
  return path.slice(-8);
}
