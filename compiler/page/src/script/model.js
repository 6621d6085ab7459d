// What the page knows of its chart: lists in order of declaration, and what is found by name.

import { revived } from './values.js';

/** The chart behind a page, made of the JSON in it. */
export class Model {
  constructor(data) {
    this.name = data.name;
    this.comment = data.comment ?? null;
    this.variables = data.variables.map((variable, index) => ({ ...variable, index, initial: revived(variable.initial) }));
    this.steps = data.steps.map((step, index) => ({ ...step, index }));
    this.macros = data.macros.map((macro, index) => ({ ...macro, index }));
    this.grafcets = data.grafcets.map((grafcet, index) => ({ ...grafcet, index }));
    this.claims = data.claims ?? [];
    // What the module calls them.
    const names = data.transitions.map(({ designation }, index) => designation ?? `#${index + 1}`);
    // Where two would be called the same, all go by their numbers.
    const isClear = new Set(names).size === names.length;
    this.transitions = data.transitions.map((transition, index) => ({ ...transition, index, name: isClear ? names[index] : `#${index + 1}` }));
    this.inputs = this.variables.filter((variable) => variable.kind === 'input');
    this.outputs = this.variables.filter((variable) => variable.kind === 'output');
    this.internal = this.variables.filter((variable) => variable.kind === 'internal' || variable.kind === 'constant');
    this.step = new Map(this.steps.map((step) => [step.label, step]));
    this.input = new Map(this.inputs.map((input, place) => [input.name, place]));
    this.byTransition = new Map(this.transitions.map((transition) => [transition.name, transition]));
  }

  /** The labels of the macro-steps that are active: those with an active step in their expansion, or in one within. */
  activeMacros(situation) {
    const active = new Set();
    for (const label of situation) {
      for (let at = this.step.get(label)?.within; at !== undefined; at = this.macros[at].within) {
        active.add(this.macros[at].label);
      }
    }
    return active;
  }

  /** A situation by grafcet: a list of labels each. */
  byGrafcet(situation) {
    const lists = this.grafcets.map(() => []);
    for (const label of situation) lists[this.step.get(label).grafcet].push(label);
    return lists;
  }
}
