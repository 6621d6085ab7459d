// What each signal did over time, for the timing diagram: a change an entry.

import { same } from './values.js';

/** So many changes of one signal are kept; then the older half is forgotten. */
const MOST = 200000;

/** The changes of one signal. */
class Signal {
  constructor(key, name, kind, type, about) {
    Object.assign(this, { key, name, kind, type, about });
    this.times = [];
    this.values = [];
    this.forgotten = 0;
  }

  add(t, value) {
    const last = this.values.length - 1;
    if (last >= 0 && same(this.values[last], value)) return;
    if (this.values.length >= MOST) {
      this.times.splice(0, MOST / 2);
      this.values.splice(0, MOST / 2);
      this.forgotten += MOST / 2;
    }
    this.times.push(t);
    this.values.push(value);
  }

  /** The place of the last change at or before a time; -1 if there is none. */
  at(t) {
    let low = 0;
    let high = this.times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= t) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  get length() {
    return this.forgotten + this.times.length;
  }

  cut(length) {
    const kept = Math.max(0, length - this.forgotten);
    this.times.length = kept;
    this.values.length = kept;
  }
}

/** The signals of a chart: its variables, and a lane a grafcet with the situation in it. */
export class History {
  constructor(model) {
    this.model = model;
    const ofVariable = (variable) => new Signal(`${variable.kind} ${variable.name}`, variable.name, variable.kind, variable.type, variable.comment);
    this.inputs = model.inputs.map(ofVariable);
    this.outputs = model.outputs.map(ofVariable);
    this.internal = model.internal.filter((variable) => variable.kind === 'internal').map(ofVariable);
    this.grafcets = model.grafcets.map((grafcet) => new Signal(`grafcet ${grafcet.name}`, grafcet.name, 'grafcet', 'situation', grafcet.comment));
    this.signals = [...this.grafcets, ...this.inputs, ...this.outputs, ...this.internal];
    this.end = 0;
    this.situation = null;
  }

  /** Notes what is after a scan. */
  add(t, inputs, outputs, variables, situation) {
    this.end = t;
    this.inputs.forEach((signal, place) => signal.add(t, inputs[place]));
    for (const signal of this.outputs) signal.add(t, outputs[signal.name]);
    for (const signal of this.internal) signal.add(t, variables[signal.name]);
    if (this.situation === situation) return;
    this.situation = situation;
    this.model.byGrafcet(situation).forEach((labels, place) => this.grafcets[place].add(t, labels.join(', ')));
  }

  /** A place to which `cut` goes back. */
  mark() {
    return { end: this.end, lengths: this.signals.map((signal) => signal.length) };
  }

  cut({ end, lengths }) {
    this.end = end;
    this.situation = null;
    this.signals.forEach((signal, place) => signal.cut(lengths[place]));
  }
}
