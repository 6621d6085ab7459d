// Traces as files: the CSV that `grafc sim` reads.

import { parsed, trimmed } from './cells.js';
import { table } from './table.js';
import { Trace } from './trace.js';
import { cell } from './values.js';

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

/** What a cell of the header names: `{ name, isQuoted }`; in backquotes it is a name of the chart's. */
function heading(title) {
  const bare = trimmed(title);
  const inner = /^`([^]+)`$/.exec(bare)?.[1];
  return { name: inner ?? bare, isQuoted: inner !== undefined };
}

/** What the columns are: `'time'`, `'restart'`, or the place of an input. */
function columns(titles, inputs, refuse) {
  const headings = titles.map(heading);
  const seen = new Set();
  const known = new Map(inputs.map((input, place) => [input.name, place]));
  return headings.map(({ name, isQuoted }, at) => {
    // The same name is the same column, in backquotes or not, unless it could be either.
    const key = `${isQuoted && OWN.includes(name) ? '`' : ''}${name}`;
    const isSecond = seen.has(key);
    seen.add(key);
    if (at === 0) {
      if (isQuoted || name !== 't_ms') refuse('trace-time');
      return 'time';
    }
    if (isSecond) refuse('trace-twice');
    const place = known.get(name);
    if (!isQuoted && name === 'restart') {
      if (place !== undefined && !headings.some((other) => other.isQuoted && other.name === name)) refuse('trace-either', { name });
      return 'restart';
    }
    if (place === undefined) refuse('trace-column', { name });
    return place;
  });
}

/** Milliseconds that are whole and not negative; NaN if it is anything else. */
function time(text) {
  const ms = parsed(text, 'time');
  return ms >= 0 && /^[-+]?[0-9]+$/.test(trimmed(text)) ? ms : NaN;
}

/**
 * Reads a trace. What is wrong is thrown as `{ key, gaps }`, a word of the page: nothing is read then.
 */
export function read(text, inputs) {
  const refuse = (key, gaps) => {
    throw Object.assign(new Error(key), { key, gaps });
  };
  const [head, ...rows] = table(text);
  if (!head) refuse('trace-empty');
  const misquoted = [head, ...rows].find((row) => row.isMisquoted);
  if (misquoted) refuse('trace-quote', { line: misquoted.line });
  const places = columns(head.cells, inputs, refuse);
  const trace = new Trace();
  const values = inputs.map((input) => input.initial);
  let before = 0;
  rows.forEach(({ line, cells }) => {
    if (cells.length !== places.length) refuse('trace-cells', { line });
    const changes = [];
    let t = before;
    let restart = false;
    cells.forEach((text, at) => {
      const place = places[at];
      if (place === 'time') {
        t = time(text);
        if (!(t >= before)) refuse('trace-row-time', { line });
      } else if (trimmed(text) === '') {
        return;
      } else if (place === 'restart') {
        restart = parsed(text, 'bool');
        if (restart === undefined) refuse('trace-value', { line, name: 'restart' });
      } else {
        const value = parsed(text, inputs[place].type);
        if (value === undefined) refuse('trace-value', { line, name: inputs[place].name });
        if (!Object.is(values[place], value)) changes.push([place, value]);
        values[place] = value;
      }
    });
    trace.add(t, changes, restart);
    before = t;
  });
  return trace;
}
