// Keys of the keyboard that stand for inputs: each is chosen by its user, and works as a press of the button does.

import { element, mark } from './dom.js';
import { shown } from './values.js';
import { word } from './texts.js';

/** Keys that the page or the browser needs. */
const TAKEN = ['Tab', 'Enter', ' ', 'Escape', 'Shift', 'Control', 'Alt', 'Meta', 'AltGraph', 'ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight'];

/** Which key is for which input. */
export class Keys {
  constructor(settings) {
    this.settings = settings;
    this.byKey = new Map();
    this.buttons = new Map();
    this.asked = null;
    this.inputs = null;
    window.addEventListener('keydown', (event) => this.down(event), true);
    window.addEventListener('keyup', (event) => this.up(event), true);
  }

  /** The button that asks for a key. */
  button(input, place) {
    const button = element('button', { class: 'key', 'aria-pressed': 'false' });
    button.addEventListener('click', () => this.ask(this.asked === place ? null : place));
    button.addEventListener('blur', () => this.asked === place && this.ask(null));
    this.buttons.set(place, { button, input });
    return button;
  }

  ask(place) {
    this.asked = place;
    this.show();
  }

  /** Gives an input its key, and takes it from whatever had it; an empty one takes it away. */
  assign(place, key) {
    for (const [known, of] of this.byKey) if (known === key || of === place) this.byKey.delete(known);
    if (key) this.byKey.set(key, place);
    this.settings.set('keys', [...this.byKey]);
    this.asked = null;
    this.show();
  }

  show() {
    for (const [place, { button, input }] of this.buttons) {
      const key = [...this.byKey].find(([, of]) => of === place)?.[0];
      button.textContent = this.asked === place ? '?' : (key?.toUpperCase() ?? '⌨');
      button.classList.toggle('set', key !== undefined);
      mark(button, 'aria-pressed', String(this.asked === place));
      const gaps = { name: shown(input.name), key: key ?? '' };
      const text = this.asked === place ? word('key-asked', gaps) : key ? word('key-is', gaps) : word('key-none', gaps);
      mark(button, 'aria-label', text);
      button.title = text;
    }
  }

  down(event) {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (this.asked !== null) {
      if (event.key === 'Tab') return;
      event.preventDefault();
      event.stopPropagation();
      if (event.key === 'Delete' || event.key === 'Backspace') this.assign(this.asked, '');
      else if (event.key === 'Escape') this.ask(null);
      else if (!TAKEN.includes(event.key)) this.assign(this.asked, key);
      return;
    }
    const place = this.byKey.get(key);
    if (place === undefined || event.ctrlKey || event.altKey || event.metaKey || isTyping(event)) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat) this.inputs.down(place);
  }

  up(event) {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const place = this.byKey.get(key);
    if (place !== undefined) this.inputs.up(place);
  }
}

/** Whether somebody is writing into a field. */
export function isTyping(event) {
  return ['number', 'text', 'file'].includes(event.target.type) || event.target.localName === 'select';
}
