// Breakpoints on steps and transitions: the run stops in the micro-step in which the step becomes active or the transition
// is cleared.

import { bdi, byId, element } from './dom.js';
import { transitionName } from './names.js';
import { shown } from './values.js';
import { word } from './texts.js';

/** The list of breakpoints, and the field that adds one. */
export class Breakpoints {
  constructor(model, engine, changed) {
    Object.assign(this, { model, engine, changed });
    byId('breakpoint-add').addEventListener('change', (event) => {
      const [kind, place] = event.target.value.split(' ');
      event.target.value = '';
      const key = this.keys(kind)[Number(place)];
      if (key !== undefined) this.toggle(kind, key);
    });
    this.show();
  }

  keys(kind) {
    if (kind === 'transition') return [...this.model.byTransition.keys()];
    return [...this.model.steps, ...this.model.macros].map((step) => step.label);
  }

  /** Sets one, or takes it away. */
  toggle(kind, key) {
    const set = kind === 'step' ? this.engine.breaks.steps : this.engine.breaks.transitions;
    if (!set.delete(key)) set.add(key);
    this.show();
    this.changed();
  }

  title(kind, key) {
    return kind === 'step' ? word('step-named', { label: shown(key) }) : transitionName(this.model.byTransition.get(key));
  }

  show() {
    const { steps, transitions } = this.engine.breaks;
    const set = [...[...steps].map((key) => ['step', key]), ...[...transitions].map((key) => ['transition', key])];
    const items = set.map(([kind, key]) => {
      const away = element('button', { 'aria-label': word('breakpoint-remove', { name: this.title(kind, key) }) }, '✕');
      away.addEventListener('click', () => this.toggle(kind, key));
      return element('li', {}, bdi(this.title(kind, key)), away);
    });
    byId('breakpoints').replaceChildren(...items);
    const options = ['step', 'transition'].flatMap((kind) =>
      this.keys(kind).map((key, place) => element('option', { value: `${kind} ${place}` }, this.title(kind, key))));
    byId('breakpoint-add').replaceChildren(element('option', { value: '' }, word('breakpoint-add')), ...options);
  }
}
