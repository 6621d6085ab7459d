// The result of a trace as `grafc sim` writes it: a row a row, by a chart of its own.

import { cell } from './values.js';
import { quoted } from './csv.js';

const FLAGS = [['livelock', 'LIVELOCK'], ['alloc_conflict', 'ALLOC_CONFLICT'], ['force_conflict', 'FORCE_CONFLICT'], ['div0', 'DIV0']];

/** The names of the flags that are raised. */
export function raised(flags) {
  return FLAGS.filter(([key]) => flags[key]).map(([, name]) => name);
}

/** A chart after a restart of the controller: a new one, with what it retains if it retains something. */
export function restarted(chart, Chart) {
  if (!chart.restart) return new Chart();
  chart.restart();
  return chart;
}

/** Runs a trace through a new chart, and calls back after each row with the chart and its inputs. */
export function run(Chart, model, trace, each) {
  let chart = new Chart();
  const values = model.inputs.map((input) => input.initial);
  let isFirst = true;
  for (const { t, changes, restart } of trace.rows()) {
    const given = Object.create(null);
    if (restart && !isFirst) chart = restarted(chart, Chart);
    if (restart || isFirst) model.inputs.forEach((input, place) => (given[input.name] = values[place]));
    isFirst = false;
    for (const [place, value] of changes) {
      values[place] = value;
      given[model.inputs[place].name] = value;
    }
    chart.scan(given, t);
    each(t, chart, values, restart);
  }
}

/** Labels as a table has them: parted by blanks, one that holds a blank in backquotes. */
export function labels(situation) {
  return situation.map((label) => (/\s/.test(label) ? `\`${label}\`` : label)).join(' ');
}

/** The whole table. */
export function result(Chart, model, trace) {
  const lines = [['t_ms', ...model.outputs.map((output) => quoted(output.name)), 'situation', 'flags'].join(',')];
  run(Chart, model, trace, (t, chart) => {
    const outputs = model.outputs.map((output) => cell(chart.outputs[output.name], output.type));
    lines.push([t, ...outputs, quoted(labels(chart.situation)), raised(chart.flags).join(' ')].join(','));
  });
  return `${lines.join('\n')}\n`;
}
