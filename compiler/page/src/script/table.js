// The rows and cells of a CSV text, taken apart as `grafc sim` does it.

import { trimmed } from './cells.js';

/** What parts the cells: the first of the three signs in the header; a line `sep=;` before it says nothing more. */
function separator(text, from) {
  let isQuoted = false;
  for (let at = from; at < text.length; at++) {
    const c = text[at];
    if (c === '"') isQuoted = !isQuoted;
    else if (isQuoted) continue;
    else if (c === ',' || c === ';' || c === '\t') return c;
    else if (c === '\n' || c === '\r') return ',';
  }
  return ',';
}

/** Where the table begins behind a line that says what parts its cells, as spreadsheets write it. */
function behindHint(text) {
  const end = text.indexOf('\n') + 1 || text.length;
  return end < 16 && /^sep=[,;]?[\t\n\f\r ]*$/.test(text.slice(0, end)) ? end : 0;
}

/**
 * The rows: `{ line, cells, isMisquoted }`, the line from 1; misquoted is one with a quote that is not closed, or something
 * behind a closing one. Blank lines are none.
 */
export function table(whole) {
  const text = whole.replace(/^\ufeff/, '');
  const begin = behindHint(text);
  let first = begin;
  while (text[first] === '\n' || text[first] === '\r') first += 1;
  const sign = separator(text, first);
  const rows = [];
  let cells = [];
  let cell = '';
  // A cell is quoted if a quote is its very first sign.
  let isBegun = false;
  let isQuoted = false;
  let isClosed = false;
  let isMisquoted = false;
  let line = begin ? 2 : 1;
  let lineOfRow = line;
  const endCell = () => {
    cells.push(cell);
    cell = '';
    isBegun = false;
    isMisquoted ||= isQuoted;
    isClosed = false;
  };
  const endRow = () => {
    if (!isBegun && !cells.length) return;
    endCell();
    rows.push({ line: lineOfRow, cells, isMisquoted });
    cells = [];
    isMisquoted = false;
  };
  for (let at = begin; at < text.length; at++) {
    const c = text[at];
    const isEnd = c === '\n' || c === '\r';
    if (!isBegun && !cells.length) lineOfRow = line;
    if (isQuoted) {
      if (c !== '"') cell += c;
      else if (text[at + 1] === '"') cell += text[++at];
      else {
        isQuoted = false;
        isClosed = true;
      }
    } else if (c === '"' && !isBegun) {
      isBegun = true;
      isQuoted = true;
    } else if (c === sign) {
      endCell();
    } else if (isEnd) {
      endRow();
    } else {
      isBegun = true;
      cell += c;
      isMisquoted ||= isClosed && trimmed(c) !== '';
    }
    if (isEnd && !(c === '\n' && text[at - 1] === '\r')) line += 1;
  }
  endRow();
  return rows;
}
