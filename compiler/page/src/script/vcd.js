// A run as a value change dump, word for word as `grafc sim -o x.vcd` writes it.

import { run, raised } from './result.js';
import { cell, same } from './values.js';

const WIDTHS = { bool: 1, int: 16, uint: 16, dint: 32, udint: 32, real: 64, lreal: 64, time: 64 };

/** The text. */
export function dump(Chart, model, trace) {
  const lines = ['$timescale 1 ms $end', `$scope module ${token(model.name)} $end`];
  const signals = [];
  const scope = (name, within) => {
    if (!within.length) return;
    lines.push(`$scope module ${token(name)} $end`);
    for (const [label, type, look] of within) {
      const id = code(signals.length);
      const kind = type === 'bool' ? 'wire' : type === 'real' || type === 'lreal' ? 'real' : 'integer';
      lines.push(`$var ${kind} ${WIDTHS[type]} ${id} ${token(label)} $end`);
      signals.push({ id, type, look, before: undefined });
    }
    lines.push('$upscope $end');
  };
  const internal = model.internal.filter((variable) => variable.kind === 'internal');
  scope('inputs', model.inputs.map((input, place) => [input.name, input.type, (chart, inputs) => inputs[place]]));
  scope('outputs', model.outputs.map((output) => [output.name, output.type, (chart) => chart.outputs[output.name]]));
  scope('variables', internal.map((variable) => [variable.name, variable.type, (chart) => chart.variables[variable.name]]));
  for (const grafcet of model.grafcets) {
    const own = model.steps.filter((step) => step.grafcet === grafcet.index);
    scope(grafcet.name, own.map((step) => [`X${step.label}`, 'bool', (chart, inputs, active) => active.has(step.label)]));
  }
  scope('flags', ['LIVELOCK', 'ALLOC_CONFLICT', 'FORCE_CONFLICT', 'DIV0'].map((flag) => [flag, 'bool', (chart, inputs, active, flags) => flags.includes(flag)]));
  if (trace.hasRestart) scope('controller', [['restart', 'bool', (chart, inputs, active, flags, restart) => restart]]);
  lines.push('$upscope $end', '$enddefinitions $end');
  let time = null;
  run(Chart, model, trace, (t, chart, inputs, restart) => {
    const isFirst = time === null;
    if (time !== t) lines.push(`#${t}`);
    time = t;
    if (isFirst) lines.push('$dumpvars');
    const [active, flags] = [new Set(chart.situation), raised(chart.flags)];
    for (const signal of signals) {
      const value = signal.look(chart, inputs, active, flags, restart);
      if (signal.before !== undefined && same(signal.before, value)) continue;
      signal.before = value;
      lines.push(change(signal, value));
    }
    if (isFirst) lines.push('$end');
  });
  return `${lines.join('\n')}\n`;
}

function change({ id, type }, value) {
  if (type === 'bool') return `${value ? 1 : 0}${id}`;
  if (type === 'real' || type === 'lreal') return `r${cell(value, 'lreal')} ${id}`;
  const width = WIDTHS[type];
  return `b${BigInt.asUintN(width, BigInt(value)).toString(2).padStart(width, '0')} ${id}`;
}

/** The n-th of the short words that signals go by. */
function code(n) {
  let out = '';
  for (let rest = n; ; rest = Math.floor(rest / 94) - 1) {
    out += String.fromCharCode(33 + (rest % 94));
    if (rest < 94) return out;
  }
}

/** A name without white space; one that begins as the format's own words do, such as `$end`, is escaped. */
function token(name) {
  const word = name.split(/\p{White_Space}+/u).filter(Boolean).join('_');
  return word.startsWith('$') ? `\\${word}` : word;
}
