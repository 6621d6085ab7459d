// The inputs: what is true or false is a button, which a click toggles and a press holds; a number has a slider and a field.

import { parsed } from './cells.js';
import { bdi, byId, element, mark } from './dom.js';
import { range, shown } from './values.js';
import { word } from './texts.js';

/** A press that is longer holds: it ends where the finger goes up. */
const HOLD = 350;

/** The list of inputs. `change` is called with a place and a value. */
export class Inputs {
  constructor(model, engine, keys, change) {
    Object.assign(this, { model, engine, change });
    this.presses = new Map();
    this.list = byId('inputs').querySelector('.list');
    this.rows = model.inputs.map((input, place) => (input.type === 'bool' ? this.button(input, place, keys) : this.number(input, place)));
    if (!this.rows.length) this.list.append(element('p', { class: 'none', 'data-text': 'none' }, word('none')));
  }

  button(input, place, keys) {
    const button = element('button', { 'data-input': input.name, 'aria-pressed': 'false' }, element('span', { class: 'lamp' }), named(input));
    button.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      button.setPointerCapture(event.pointerId);
      this.down(place);
    });
    button.addEventListener('pointerup', () => this.up(place));
    button.addEventListener('pointercancel', () => this.cancel(place));
    // A click without a pointer: by Enter, by the space bar, or by a tool that reads the page out.
    button.addEventListener('click', (event) => {
      if (event.detail === 0) this.toggle(place);
    });
    this.list.append(element('div', { class: 'input' }, button, keys.button(input, place)));
    return { place, show: (value, waits) => {
      mark(button, 'aria-pressed', String(value));
      button.classList.toggle('waits', waits);
    } };
  }

  number(input, place) {
    const [low, high] = slider(input);
    const [least, most] = range(input.type);
    const isReal = input.type === 'real' || input.type === 'lreal';
    const step = isReal ? String((high - low) / 200) : '1';
    const limits = Number.isFinite(least) ? { min: least, max: most } : {};
    const field = element('input', { type: 'number', 'data-input': input.name, ...limits, step: isReal ? 'any' : '1' });
    const bar = element('input', { type: 'range', min: low, max: high, step, 'data-slider': input.name });
    const title = named(input, input.type === 'time' ? 'ms' : '');
    for (const one of [field, bar]) one.setAttribute('aria-label', [shown(input.name), input.comment ? shown(input.comment) : ''].filter(Boolean).join(', '));
    const take = (text, source) => {
      const value = parsed(text, input.type);
      mark(field, 'aria-invalid', String(value === undefined));
      if (value === undefined) return;
      this.change(place, value);
      if (source !== bar) bar.value = String(value);
      if (source !== field) field.value = String(value);
    };
    field.addEventListener('input', () => take(field.value, field));
    bar.addEventListener('input', () => take(bar.value, bar));
    this.list.append(element('div', { class: 'input' }, element('div', { class: 'number' }, title, bar, field)));
    return { place, show: (value, waits) => {
      title.classList.toggle('waits', waits);
      if (document.activeElement !== field && Number(field.value) !== value || field.value === '') field.value = String(value);
      if (document.activeElement !== bar) bar.value = String(value);
    } };
  }

  toggle(place) {
    this.change(place, !this.engine.pending[place]);
  }

  /** A press begins: the value changes at once. */
  down(place) {
    if (this.presses.has(place)) return;
    this.presses.set(place, performance.now());
    this.toggle(place);
  }

  /** A press ends: after a long one the value is what it was before. */
  up(place) {
    const since = this.presses.get(place);
    this.presses.delete(place);
    if (since !== undefined && performance.now() - since >= HOLD) this.toggle(place);
  }

  /** A press that turned out to be none. */
  cancel(place) {
    if (this.presses.delete(place)) this.toggle(place);
  }

  show() {
    for (const { place, show } of this.rows) show(this.engine.pending[place], this.engine.waits(place));
  }
}

/** The name of a variable with its comment. */
export function named(variable, unit = '') {
  const text = element('span', { class: 'text' }, bdi(shown(variable.name) + (unit && ` (${unit})`), 'name'));
  if (variable.comment) text.append(bdi(shown(variable.comment), 'about'));
  return text;
}

/** Where a slider begins and ends: it holds what the input is compared with, and where it starts. */
function slider({ type, initial, marks = [] }) {
  const [least, most] = range(type);
  const known = [...marks, initial].filter((value) => typeof value === 'number' && Number.isFinite(value));
  const top = Math.max(...known, 0);
  const bottom = Math.min(...known, 0);
  const high = top > 0 ? Math.ceil(top * 1.5) : type === 'time' ? 10000 : 100;
  const low = bottom < 0 ? Math.floor(bottom * 1.5) : 0;
  return [Math.max(low, least), Math.min(high, most)];
}
