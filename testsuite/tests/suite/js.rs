//! Generated JavaScript, run by node: it does what the chart means, its numbers are those of every other target, and what it
//! saves is taken back as it was, or refused.

use ::grafc::{Options as Asked, Output, Product, compile as compiled};
use grafc_backends::{Target, js};
use grafc_diagnostics::FileId;
use grafc_logic::Options;
use grafc_logic::scan::Observed;
use grafc_model::chart::Chart;
use grafc_testsuite::agreement::{Agreement, AsEvaluated, triggers};
use grafc_testsuite::binary::root;
use grafc_testsuite::charts::{Case, cases, charts_folder, vectors_folder};
use grafc_testsuite::executors::js::{Tools, Typescript, run};
use grafc_testsuite::markdown::play;
use grafc_testsuite::runs::compile_observed;
use std::fs;

/// The share of JavaScript.
const TURN: usize = 2;

/// Charts in one process of node.
const BATCH: usize = 200;

/// Runs all cases in all ways that must agree, and with all that can be shown, and compares them with what is expected.
fn agree(cases: &[Case]) {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    for case in cases {
        for (place, (way, options)) in case.ways().into_iter().enumerate() {
            let observed = if place % 2 == 0 { Observed::Transitions } else { Observed::All };
            agreement.case(case, &way, |chart| compile_observed(chart, &options, observed));
        }
    }
    agreement.hold(TURN, BATCH, |jobs| run(&tools, jobs));
}

#[test]
fn vectors_agree() {
    agree(&cases(&vectors_folder()));
}

#[test]
fn charts_agree() {
    agree(&cases(&charts_folder()));
}

/// The r- and s-trigger too are written as they are evaluated.
#[test]
fn overlapping_encodings_are_written_as_they_are() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let compile = |chart: &Chart, options: &Options| compile_observed(chart, options, Observed::Transitions);
    AsEvaluated::charts(triggers, compile).hold(|jobs| run(&tools, jobs));
}

/// `docs/javascript.md`: its programs do what the page shows.
#[test]
fn the_programs_of_the_page_do_what_it_shows() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut programs = 0;
    play(&root().join("docs/javascript.md"), |folder, command| match command.split_once(' ') {
        Some(("node", script)) => {
            programs += 1;
            Some(tools.play(folder, script).unwrap_or_else(|said| panic!("{said}")))
        }
        Some(_) | None => panic!("`{command}`: the test knows no such command"),
    });
    assert!(programs >= 3, "only {programs} programs were run");
}

/// What a product makes of a text.
fn made(text: &str, observed: bool) -> Output {
    let target = Target::Js(js::Options { observed, ..js::Options::default() });
    let asked = Asked::new(Options::default(), Product::Code(target));
    let (made, diagnostics) = compiled(FileId::default(), text, "chart", &asked);
    made.unwrap_or_else(|| panic!("{diagnostics:#?}"))
}

/// A chart with something of each kind.
const VALVE: &str = "\
chart Valve
input go, back : bool
input level : int
input rate : real
input share : lreal
input pause : time
output open, close, full : bool
retain output strokes : uint := 5
output waited : time
var seen : real
const most : dint := 10
grafcet Main {
  initial step 1 { close }
  step 2 \"opening\" { open   strokes := strokes + 1 on activation   full if [level > most] }
  step 3 { open   seen := seen + rate on deactivation   waited := waited + pause on activation   full if [waited = 7ms] }
  step 4
  transition (go1) 1 -> 2 : ↑go
  transition 2 -> 3 : 500ms/X2
  transition 3 -> 4 : 1s/X3/2s
  transition 4 -> 1 : back or [share > 1.0]
}
";

/// Runs a script beside a module `valve.mjs`.
fn script(text: &str, observed: bool) {
    let Some(tools) = Tools::find_or_skip() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a temporary file");
    write("valve.mjs", &made(VALVE, observed).text);
    write("main.mjs", text);
    tools.play(folder.path(), "main.mjs").unwrap_or_else(|said| panic!("{said}"));
}

#[test]
fn a_module_keeps_to_its_interface() {
    script(
        "
import assert from 'node:assert';
import Chart, { Valve } from './valve.mjs';
assert.equal(Chart, Valve);
assert.deepEqual(Chart.steps, ['1', '2', '3', '4']);
assert(Object.isFrozen(Chart.steps));
const c = new Chart();
assert.deepEqual(c.situation, []);
const { outputs } = c;
// What is retained has its initial value before the first scan.
assert.deepEqual(outputs, { open: false, close: false, full: false, strokes: 5, waited: 0 });
// R10 and one micro-step; nothing is published until the scan is over.
assert.deepEqual(c.microStep({}, 0), { enabled: ['go1'], cleared: [], stable: true });
assert.deepEqual(c.scan({}, 1), { open: false, close: true, full: false, strokes: 5, waited: 0 });
assert.equal(c.scan({}, 2), outputs);
assert.deepEqual(c.microStep({ go: true, level: 11 }, 100), { enabled: ['go1'], cleared: ['go1'], stable: false });
assert.deepEqual([c.situation, outputs.close, outputs.strokes], [['2'], true, 5]);
// What is given now does not count, whatever it is; and the scan goes on to its end.
assert.equal(c.scan({ nothing: 1 }, 'never'), outputs);
assert.deepEqual(outputs, { open: true, close: false, full: true, strokes: 6, waited: 0 });
// What is left out stays as it was.
c.scan({ level: 3 }, 110);
assert.equal(outputs.full, false);
c.scan({ pause: 7, rate: 0.1 }, 599);
assert.deepEqual(c.situation, ['2']);
c.scan({}, 600);
assert.deepEqual([c.situation, outputs.waited, outputs.full], [['3'], 7, true]);
assert.deepEqual(c.flags, { livelock: false, alloc_conflict: false, force_conflict: false, div0: false });
const before = c.save();
for (const [given, said] of [
    [{ gо: true }, /has no input/],
    [{ go: 1 }, /is of type bool/],
    [{ level: true }, /is of type int/],
    [{ level: 1.5 }, /whole numbers of type int/],
    [{ level: 32768 }, /whole numbers of type int/],
    [{ pause: 2 ** 53 }, /whole numbers of type time/],
    [{ toString: true }, /has no input/],
]) {
    assert.throws(() => c.scan({ back: true, ...given }, 700), said);
}
for (const now of [NaN, Infinity, '1', undefined, 1n]) assert.throws(() => c.scan({}, now), /milliseconds/);
assert.deepEqual(c.save(), before);
c.restart();
assert.deepEqual([c.situation, outputs.strokes], [[], 6]);
c.scan({}, 800);
assert.deepEqual([c.situation, outputs.strokes, outputs.open], [['1'], 6, false]);
c.reset();
c.scan({}, 900);
assert.deepEqual([c.situation, outputs.strokes], [['1'], 5]);
",
        false,
    );
}

#[test]
fn what_was_saved_is_taken_as_it_was_or_refused() {
    script(
        "
import assert from 'node:assert';
import { Valve } from './valve.mjs';
const c = new Valve();
const saves = [c.save()];
c.scan({ rate: -0, share: NaN, pause: 9007199254740991 }, 0);
c.scan({ go: true, level: 11 }, 100);
saves.push(c.save());
c.microStep({}, 400);
for (let t = 500; t < 2000; t += 300) {
    c.scan({}, t);
    saves.push(c.save());
    c.microStep({ go: t % 2 === 0 }, t + 100);
    saves.push(c.save());
    c.scan({}, t + 100);
}
// The time in between does not count: 400 of 500 ms are over.
const d = new Valve();
d.scan({}, 0);
d.scan({ go: true }, 0);
d.scan({}, 400);
const half = JSON.parse(JSON.stringify(d.save()));
d.restore(half, 1_000_000);
d.scan({}, 1_000_099);
assert.deepEqual(d.situation, ['2']);
d.scan({}, 1_000_100);
assert.deepEqual(d.situation, ['3']);
// An output that the situation decides on is not saved; one that was stored is.
assert.deepEqual(half.state.outputs, { strokes: 6, waited: '0' });
for (const saved of saves) {
    const text = JSON.stringify(saved);
    const other = new Valve();
    other.restore(JSON.parse(text), 7);
    assert.equal(JSON.stringify(other.save()), text);
    const refused = (data) => {
        const now = JSON.stringify(other.save());
        assert.throws(() => other.restore(data, 0), /cannot be restored/, JSON.stringify(data));
        assert.equal(JSON.stringify(other.save()), now);
    };
    [null, undefined, 1, 'x', {}, [], { ...saved, state: null }, { ...saved, program: '0' }, { ...saved, chart: 'x' }].forEach(refused);
    // Every value of it is another, or is gone.
    for (const [group, values] of Object.entries(saved.state)) {
        if (typeof values === 'boolean') {
            refused({ ...saved, state: { ...saved.state, [group]: !values } });
            continue;
        }
        for (const [name, value] of Object.entries(values)) {
            const others = [undefined, null, typeof value === 'boolean' ? !value : Array.isArray(value) ? [!value[0], value[1]] : 17.5];
            for (const one of others) {
                refused({ ...saved, state: { ...saved.state, [group]: { ...values, [name]: one } } });
            }
        }
    }
    // Whatever the order of what was kept.
    const turned = (object) => Object.fromEntries(Object.entries(object).reverse());
    other.restore({ ...turned(saved), state: turned({ ...saved.state, m: turned(saved.state.m) }) }, 7);
    assert.equal(JSON.stringify(other.save()), text);
}
",
        false,
    );
}

/// Flags and the number of the first assertion that was false go down together.
#[test]
fn flags_are_lowered_with_what_assertion_was_false() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut asked = Asked::new(Options::default(), Product::Code(Target::Js(js::Options::default())));
    asked.controls.check_assertions = true;
    let text = "input a : bool initial step 1 assert X1 assert not a";
    let (made, diagnostics) = compiled(FileId::default(), text, "chart", &asked);
    let made = made.unwrap_or_else(|| panic!("{diagnostics:#?}"));
    let main = "
import assert from 'node:assert';
import Chart from './chart.mjs';
const c = new Chart();
assert.equal(c.scan({}, 0).ASSERTION, 0);
assert.equal(c.scan({ a: true }, 10).ASSERTION, 2);
assert.equal(c.scan({ a: false }, 20).ASSERTION, 2);
c.clearFlags();
assert.equal(c.outputs.ASSERTION, 0);
assert.equal(c.scan({}, 30).ASSERTION, 0);
assert.equal(c.scan({ a: true }, 40).ASSERTION, 2);
";
    for (name, text) in [("chart.mjs", made.text.as_str()), ("main.mjs", main)] {
        fs::write(folder.path().join(name), text).expect("a temporary file");
    }
    tools.play(folder.path(), "main.mjs").unwrap_or_else(|said| panic!("{said}"));
}

/// What a page sees: by the rules, at times where it can be told by hand.
#[test]
fn a_page_sees_more() {
    script(
        "
import assert from 'node:assert';
import Chart from './valve.mjs';
const c = new Chart();
c.scan({}, 0);
// Action 0 is `close`; 1 to 3 are those of step 2, 4 to 6 those of step 3.
assert.deepEqual(c.observed, { satisfied: [], frozen: [], forced: [], actions: [0], orders: [], broken: [], reached: [] });
c.microStep({ go: true, level: 11, rate: 0.5 }, 100);
// Activated just now; the outputs stay published until the scan is over, and with them `close`.
assert.deepEqual(c.observed.actions, [0, 2]);
assert.deepEqual(c.observed.satisfied, ['go1']);
c.scan({}, 100);
assert.deepEqual(c.observed.actions, [1, 3]);
assert.deepEqual(c.variables, { most: 10, seen: 0 });
const [opening] = c.delays;
assert.deepEqual(opening, { of: 'transition', owner: '#2', text: '500ms/X2', total: 500, left: 500, running: true });
c.scan({}, 300);
assert.equal(c.delays[0].left, 300);
",
        true,
    );
}

/// A hostile chart stays a module, and nothing of it is a tag.
#[test]
fn hostile_names_do_not_break_out() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let hostile = "\
chart class \"</script><script>alert(1)</script> */ process.exit(1) /* \u{2028} <!--\"
input __proto__ \"*/ throw 1 /*\", constructor, `in` \"\\u0022\", tür : bool
output `this`, hasOwnProperty, then : bool
initial step `</script>` \"</script>\" { `this` if __proto__ }
step `a\"b\\` { hasOwnProperty }
transition (`<!--`) `</script>` -> `a\"b\\` : constructor and `in`
transition `a\"b\\` -> `</script>` : tür
";
    let target = Target::Js(js::Options { header: vec!["</script> */ <!--".into()], observed: true });
    let asked = Asked::new(Options::default(), Product::Code(target));
    let (output, diagnostics) = compiled(FileId::default(), hostile, "chart", &asked);
    let Some(output) = output else { panic!("{diagnostics:#?}") };
    let types = output.beside.expect("declarations");
    for text in [&output.text, &types] {
        assert!(!text.contains("</") && !text.contains("<!--") && !text.contains("<script"), "{text}");
        assert!(text.chars().all(|c| !matches!(c, '\u{2028}' | '\u{2029}')), "{text}");
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a temporary file");
    write("hostile.mjs", &output.text);
    write(
        "main.mjs",
        "
import assert from 'node:assert';
import Chart from './hostile.mjs';
const c = new Chart();
assert.deepEqual(Chart.steps, ['</script>', 'a\"b\\\\']);
c.scan(JSON.parse('{\"__proto__\": true}'), 0);
assert.deepEqual(Object.entries(c.outputs), [['this', true], ['hasOwnProperty', false], ['then', false]]);
assert.deepEqual(c.microStep({ constructor: true, in: true }, 1).cleared, ['<!--']);
c.scan({}, 1);
assert.equal(c.outputs.hasOwnProperty, true);
c.restore(JSON.parse(JSON.stringify(c.save())), 1);
assert.deepEqual(c.situation, ['a\"b\\\\']);
c.scan({ 'tür': true, constructor: false }, 2);
assert.deepEqual(c.situation, ['</script>']);
",
    );
    tools.play(folder.path(), "main.mjs").unwrap_or_else(|said| panic!("{said}\n{}", output.text));
}

/// The declarations are strictly right, and those who use them are told of mistakes.
#[test]
fn declarations_are_taken() {
    let Some(typescript) = Typescript::find_or_skip() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a temporary file");
    let valve = made(VALVE, false);
    write("valve.d.mts", valve.beside.as_deref().expect("declarations"));
    write("valve.mjs", &valve.text);
    let uses = "
import Chart, { Valve, type ValveOutputs } from './valve.mjs';
const c: Valve = new Chart();
const outputs: ValveOutputs = c.scan({ go: true, level: 3 }, 0);
const open: boolean = outputs.open;
const waited: number = outputs.waited;
const { enabled, stable } = c.microStep({}, 1);
const at: '1' | '2' | '3' | '4' | undefined = c.situation[0];
const first: 'go1' | '#2' | '#3' | '#4' | undefined = enabled[0];
c.restore(c.save(), 2);
c.restart();
const livelock: boolean = c.flags.livelock;
export { open, waited, stable, at, first, livelock };
";
    write("uses.mts", uses);
    typescript.check(folder.path(), &["uses.mts"]).unwrap_or_else(|said| panic!("{said}"));
    for wrong in ["c.scan({ gone: true }, 0);", "c.scan({ go: 1 }, 0);", "c.outputs = {};", "c.scan({});"] {
        write("wrong.mts", &format!("{uses}{wrong}\n"));
        assert!(typescript.check(folder.path(), &["wrong.mts"]).is_err(), "{wrong}");
    }
    // Those of all charts that we have.
    let all: Vec<String> = cases(&charts_folder())
        .iter()
        .chain(&cases(&vectors_folder()))
        .enumerate()
        .map(|(place, case)| {
            let name = format!("chart_{place}.d.mts");
            write(&name, made(&case.text, place % 2 == 0).beside.as_deref().expect("declarations"));
            name
        })
        .collect();
    let all: Vec<&str> = all.iter().map(String::as_str).collect();
    typescript.check(folder.path(), &all).unwrap_or_else(|said| panic!("{said}"));
}
