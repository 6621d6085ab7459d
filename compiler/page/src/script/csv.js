// Traces as files: the CSV that `grafc sim` reads.

import { Trace } from './trace.js';
import { cell, parsed, same } from './values.js';

/** Columns of the trace's own; an input of such a name stands in backquotes. */
const OWN = ['t_ms', 'restart', 'situation', 'flags'];

/** A name as a head of a column. */
export function column(name) {
  return quoted(OWN.includes(name) || name !== name.trim() || /[`]/.test(name) ? `\`${name}\`` : name);
}

/** A cell that holds a comma or a quotation mark. */
export function quoted(text) {
  return /[",;\t\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** The trace as CSV: all inputs in the first row, then what changes. */
export function written(trace, inputs) {
  const restarts = trace.hasRestart;
  const lines = [['t_ms', ...(restarts ? ['restart'] : []), ...inputs.map((input) => column(input.name))].join(',')];
  let isFirst = true;
  for (const { t, changes, restart } of trace.rows()) {
    const cells = inputs.map((input) => (isFirst ? cell(input.initial, input.type) : ''));
    for (const [place, value] of changes) cells[place] = cell(value, inputs[place].type);
    lines.push([t, ...(restarts ? [restart ? '1' : ''] : []), ...cells].join(','));
    isFirst = false;
  }
  return `${lines.join('\n')}\n`;
}

/** The fields of a text, line by line. */
function fields(text) {
  const head = text.slice(0, text.search(/[\r\n]|$/));
  const separator = /[,;\t]/.exec(head.replace(/"[^"]*"|`[^`]*`/g, ''))?.[0] ?? ',';
  const rows = [];
  let row = [];
  let field = '';
  let isQuoted = false;
  const endRow = () => {
    row.push(field);
    if (row.length > 1 || row[0].trim() !== '') rows.push(row);
    row = [];
    field = '';
  };
  for (let at = 0; at < text.length; at++) {
    const c = text[at];
    if (isQuoted) {
      if (c !== '"') field += c;
      else if (text[at + 1] === '"') field += text[++at];
      else isQuoted = false;
    } else if (c === '"' && field.trim() === '') {
      isQuoted = true;
      field = '';
    } else if (c === separator) {
      row.push(field);
      field = '';
    } else if (c === '\n') {
      endRow();
    } else if (c !== '\r') {
      field += c;
    }
  }
  if (field !== '' || row.length) endRow();
  return rows;
}

/**
 * Reads a trace. What is wrong is thrown as `{ key, gaps }`, a word of the page: nothing is read then.
 */
export function read(text, inputs) {
  const refuse = (key, gaps) => {
    throw Object.assign(new Error(key), { key, gaps });
  };
  const [head, ...rows] = fields(text.replace(/^\ufeff/, ''));
  if (!head || !rows.length) refuse('trace-empty');
  const places = head.map((title, at) => {
    const bare = title.trim();
    const inner = /^`(.*)`$/.exec(bare)?.[1];
    if (inner === undefined && at === 0 && bare === 't_ms') return 'time';
    if (inner === undefined && bare === 'restart') return 'restart';
    const place = inputs.findIndex((input) => input.name === (inner ?? bare));
    if (place < 0) refuse('trace-column', { name: bare });
    return place;
  });
  if (places.indexOf('time') !== 0) refuse('trace-time');
  if (new Set(places).size !== places.length) refuse('trace-twice');
  const trace = new Trace();
  const values = inputs.map((input) => input.initial);
  let before = 0;
  rows.forEach((row, number) => {
    const line = number + 2;
    if (row.length !== places.length) refuse('trace-cells', { line });
    const changes = [];
    let t = before;
    let restart = false;
    row.forEach((text, at) => {
      const place = places[at];
      if (place === 'time') {
        t = /^\s*\d+\s*$/.test(text) ? Number(text) : NaN;
        if (!(t >= before) || t > 4294967295) refuse('trace-row-time', { line });
      } else if (text.trim() === '') {
        return;
      } else if (place === 'restart') {
        restart = parsed(text, 'bool');
        if (restart === undefined) refuse('trace-value', { line, name: 'restart' });
      } else {
        const value = parsed(text, inputs[place].type);
        if (value === undefined) refuse('trace-value', { line, name: inputs[place].name });
        if (!same(values[place], value)) changes.push([place, value]);
        values[place] = value;
      }
    });
    trace.add(t, changes, restart);
    before = t;
  });
  return trace;
}
