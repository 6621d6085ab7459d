// What comes out: outputs, variables, delays with what is left of them, the situation of each grafcet, and flags and broken
// claims in words.

import { bdi, byId, element, mark, write } from './dom.js';
import { named } from './inputs.js';
import { cell, shown } from './values.js';
import { raised } from './result.js';
import { duration, word } from './texts.js';

/** The lists at the right. */
export class Watch {
  constructor(model, fold) {
    Object.assign(this, { model, fold });
    this.outputs = model.outputs.map((output) => row(byId('outputs'), output, 'data-output'));
    this.variables = model.internal.map((variable) => row(byId('variables'), variable, 'data-variable'));
    if (!this.outputs.length) byId('outputs').append(element('li', { class: 'none', 'data-text': 'none' }, word('none')));
    hideEmpty('variables', this.variables.length);
    this.delays = [];
    this.grafcets = this.listGrafcets();
    this.told = '';
  }

  listGrafcets() {
    const list = byId('grafcets');
    return [...this.model.grafcets, ...this.model.macros].map((part) => {
      const key = part.name ?? part.label;
      const situation = element('bdi', { class: 'situation' });
      const item = element('li', {}, bdi(shown(key), 'name'), situation);
      const frame = this.fold.foldable.find((one) => one.key === key && one.isGrafcet === (part.name !== undefined));
      const button = frame && element('button', { 'data-fold': key });
      if (button) {
        button.addEventListener('click', () => this.fold.toggle(key));
        item.prepend(button);
      }
      list.append(item);
      return { part, situation, button, frame };
    });
  }

  show(engine) {
    const { outputs, variables, flags, delays } = engine.module;
    for (const { variable, item, value } of this.outputs) showValue(item, value, variable, outputs[variable.name]);
    for (const { variable, item, value } of this.variables) showValue(item, value, variable, variables[variable.name] ?? variable.initial);
    this.showDelays(delays);
    this.showGrafcets(engine);
    this.showFlags(flags, engine.ring, engine.observed.broken ?? []);
  }

  showDelays(delays) {
    if (delays.length !== this.delays.length) {
      this.delays = delays.map(() => {
        const [title, left, bar] = [element('bdi'), element('span', { class: 'left' }), element('progress', { max: 1 })];
        return { item: element('li', {}, element('div', { class: 'row' }, title, left), bar), title, left, bar };
      });
      byId('delays').replaceChildren(...this.delays.map((delay) => delay.item));
    }
    hideEmpty('delays', delays.length);
    delays.forEach((delay, place) => {
      const { item, title, left, bar } = this.delays[place];
      const [total, rest] = [Number(delay.total), Number(delay.left)];
      write(title, shown(delay.text));
      write(left, delay.running ? duration(rest) : duration(total));
      mark(bar, 'value', String(delay.running && total > 0 ? Math.round((1 - rest / total) * 1000) / 1000 : 0));
      mark(bar, 'aria-label', `${shown(delay.text)}: ${delay.running ? duration(rest) : word('delay-rests')}`);
      item.classList.toggle('running', delay.running);
    });
  }

  showGrafcets({ situation, observed }) {
    const lists = this.model.byGrafcet(situation);
    const macros = this.model.activeMacros(situation);
    for (const { part, situation: place, button, frame } of this.grafcets) {
      if (part.name === undefined) write(place, macros.has(part.label) ? word('is-active') : '');
      else write(place, `{${lists[part.index].map(shown).join(', ')}}${(observed.frozen ?? []).includes(part.name) ? ` ${word('is-frozen')}` : ''}`);
      if (!button) continue;
      write(button, frame.isFolded ? '▸' : '▾');
      mark(button, 'aria-expanded', String(!frame.isFolded));
      mark(button, 'aria-label', word('fold', { name: shown(part.name ?? part.label) }));
    }
  }

  showFlags(flags, ring, broken) {
    const names = raised(flags);
    const key = `${document.documentElement.lang} ${names.join()} ${ring ? ring.length : ''} ${broken.join()}`;
    if (key === this.told) return;
    this.told = key;
    const claims = broken.map((place) => {
      const { kind, name } = this.model.claims[place];
      return element('div', { class: 'flag', 'data-broken': String(place) }, element('b', {}, kind), `${word('claim-broken')} `, bdi(shown(name)));
    });
    byId('flags').replaceChildren(...claims, ...names.map((name) => {
      const box = element('div', { class: 'flag', 'data-flag': name }, element('b', {}, name), word(`flag-${name}`));
      if (name === 'LIVELOCK' && ring) {
        const ringed = [...ring, ring[0]].map((situation) => `{${situation.map(shown).join(', ')}}`).join(' → ');
        box.append(element('span', { class: 'ring', 'data-ring': '' }, `${word('ring')} `, bdi(ringed)));
      }
      return box;
    }));
  }
}

function row(list, variable, attribute) {
  const value = element('span', { class: 'value' });
  const item = element('li', { [attribute]: variable.name });
  if (variable.type === 'bool') item.append(element('span', { class: 'lamp' }));
  item.append(named(variable), value);
  list.append(item);
  return { variable, item, value };
}

function showValue(item, place, { type }, value) {
  const text = cell(value, type);
  mark(item, 'data-value', text);
  write(place, type === 'time' ? duration(Number(value)) : text);
}

function hideEmpty(id, length) {
  byId(id).closest('.block').hidden = length === 0;
}
