// Plays the traces of charts and prints a line a call: the job, the row, outputs, whether each step is active, flags.

import { deepStrictEqual as equal, ok, throws } from 'node:assert';
import jobs from './jobs.mjs';

// Clocks start here, so that they wrap around within a trace.
const START = 2 ** 32 - 1500;

const lines = [];
for (const job of jobs) {
    const module = await import(`./job_${job.index}.mjs`);
    equal(Object.keys(module).length, 2);
    play(job, module.default);
    if (lines.length > 1000) flush();
}
flush();

function flush() {
    if (lines.length > 0) process.stdout.write(`${lines.join('\n')}\n`);
    lines.length = 0;
}

function play(job, Chart) {
    let chart = new Chart();
    equal(chart.situation, []);
    // What the chart has been given: what has not changed is left out.
    let known = new Map();
    job.rows.forEach(([t, restart, values], row) => {
        if (restart) {
            if (chart.restart) chart.restart();
            else chart.reset();
            if (!chart.restart) known = new Map();
        }
        const now = row % 2 === 0 ? START + t : (START + t) % 2 ** 32;
        const inputs = {};
        job.inputs.forEach((name, place) => {
            if (known.has(name) && Object.is(known.get(name), values[place])) return;
            known.set(name, values[place]);
            Object.defineProperty(inputs, name, { value: values[place], enumerable: true });
        });
        const saved = row % 3 === 1;
        const { outputs } = chart;
        if (job.watched || row % 4 >= 2) {
            const published = { ...outputs };
            let given = inputs;
            for (let count = 0; ; count++) {
                // Once a scan has begun, what is given does not count.
                const seen = chart.microStep(given, count === 0 ? now : 7);
                given = { none: true };
                if (job.watched) {
                    lines.push(`${job.index} ${JSON.stringify({ row, ...seen, situation: chart.situation })}`);
                }
                for (const name of seen.cleared) ok(seen.enabled.includes(name));
                if (seen.stable) break;
                equal({ ...chart.outputs }, published);
                if (saved && count < 3) chart = again(Chart, chart, START + t);
                // And the rest may be done at once.
                if (!job.watched && row % 4 === 3) {
                    chart.scan(given, NaN);
                    break;
                }
            }
        } else {
            ok(chart.scan(inputs, now) === outputs);
        }
        if (!job.watched) print(job, Chart, chart, row);
        if (saved) {
            const before = { ...chart.outputs };
            chart = again(Chart, chart, START + t);
            equal({ ...chart.outputs }, before);
        }
        if (chart.observed) {
            ok(chart.delays.every(({ left, total }) => left >= 0 && left <= total));
            ok(chart.observed.forced.every((label) => chart.situation.includes(label)));
        }
    });
}

// A chart that goes on with what was saved of another one.
function again(Chart, chart, now) {
    const saved = chart.save();
    const other = new Chart();
    other.restore(JSON.parse(JSON.stringify(saved)), now);
    equal(other.save(), saved);
    equal(other.situation, chart.situation);
    throws(() => other.restore({ ...saved, seal: saved.seal ^ 1 }, now), /not as they were saved/);
    throws(() => other.restore({ ...saved, program: 'another' }, now), /another program/);
    equal(other.save(), saved);
    return other;
}

function print(job, Chart, chart, row) {
    const words = [job.index, row];
    equal(Object.keys(chart.outputs), job.outputs);
    const exact = chart.save().state.outputs;
    for (const name of job.outputs) {
        const value = chart.outputs[name];
        if (typeof value === 'boolean') {
            words.push(value ? 1 : 0);
        } else {
            // A time that is no `Number` is saved as a text.
            equal(Number(exact[name]), value);
            words.push(exact[name]);
        }
    }
    const active = new Set(chart.situation);
    equal(chart.situation, Chart.steps.filter((label) => active.has(label)));
    for (const label of Chart.steps) words.push(active.has(label) ? 1 : 0);
    const { flags } = chart;
    for (const name of Object.keys(flags)) {
        ok(job.flags.includes(name) || !flags[name]);
    }
    for (const name of job.flags) words.push(flags[name] ? 1 : 0);
    lines.push(words.join(' '));
}
