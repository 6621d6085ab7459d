//! A weighing-mixing plant (IEC 60848, annex B), simulated, and run by its chart.
//!
//! `cargo run` plays a minute of it at once, `cargo run -- --real-time` in a minute.

mod plant;

// The module `weigh_mix`, which build.rs made from weigh_mix.gct.
include!(concat!(env!("OUT_DIR"), "/weigh_mix.rs"));

use grafc_runtime::Runner;
use plant::{Plant, TICK};
use std::time::{Duration, Instant};
use weigh_mix::{Outputs, WeighMix};

/// An output: how it is read from all, and what it means when it goes on and off.
type Effect = (fn(&Outputs) -> bool, &'static str, &'static str);

const EFFECTS: [Effect; 8] = [
    (|o| o.va, "valve A opens", "valve A closes"),
    (|o| o.vb, "valve B opens", "valve B closes"),
    (|o| o.vc, "valve C opens", "valve C closes"),
    (|o| o.bm, "belt runs", "belt stops"),
    (|o| o.mr, "mixer turns", "mixer stops"),
    (|o| o.tm_down, "mixer tips", "tipping ends"),
    (|o| o.tm_up, "mixer comes up", "mixer is up"),
    (|o| o.emc, "manual control on", "manual control off"),
];

/// Something the operator does: when, in milliseconds, what it is called, and what it does to the plant.
type Deed = (u32, &'static str, fn(&mut Plant));

/// A batch, a second one that is stopped and cleared away, and a third.
const SHIFT: [Deed; 13] = [
    (0, "finds the emergency stop pressed", |p| (p.panel.pbes, p.panel.ssmanu) = (true, true)),
    (1_000, "releases the emergency stop", |p| p.panel.pbes = false),
    (2_000, "selects automatic", |p| (p.panel.ssauto, p.panel.ssmanu) = (true, false)),
    (3_000, "presses start", |p| p.panel.cs = true),
    (3_500, "lets go of start", |p| p.panel.cs = false),
    (30_000, "presses start", |p| p.panel.cs = true),
    (31_500, "presses the emergency stop", |p| (p.panel.pbes, p.panel.cs) = (true, false)),
    (32_000, "selects manual", |p| (p.panel.ssauto, p.panel.ssmanu) = (false, true)),
    (33_000, "releases the emergency stop", |p| p.panel.pbes = false),
    (34_000, "takes the powder out of the weighing unit", Plant::clear_weighing_unit),
    (35_000, "selects automatic", |p| (p.panel.ssauto, p.panel.ssmanu) = (true, false)),
    (36_000, "presses start", |p| p.panel.cs = true),
    (36_500, "lets go of start", |p| p.panel.cs = false),
];

/// When the simulation ends, in milliseconds.
const END: u32 = 62_000;

fn main() {
    let real_time = std::env::args().any(|argument| argument == "--real-time");
    let start = Instant::now();
    let mut plant = Plant::default();
    let mut runner = Runner::new(WeighMix::new(), TICK);
    let mut before = *runner.chart().outputs();
    let mut situation = String::new();

    println!("time (s)  steps   weight (kg)");
    for now in (0..=END).step_by(TICK as usize) {
        if real_time {
            let due = start + Duration::from_millis(u64::from(now));
            std::thread::sleep(due.saturating_duration_since(Instant::now()));
        }
        let seconds = f64::from(now) / 1000.0;
        for (_, name, deed) in SHIFT.iter().filter(|(when, ..)| *when == now) {
            println!("{seconds:8.1}  operator {name}");
            deed(&mut plant);
        }

        // The controller: inputs in, outputs out.
        let Some(outputs) = runner.poll(&plant.inputs(), now).copied() else { continue };

        let steps: Vec<&str> = runner.chart().active_steps().map(|step| step.label()).collect();
        let steps = steps.join(" ");
        if steps != situation || outputs != before {
            let effects = effects(&before, &outputs).join(", ");
            println!("{}", format!("{seconds:8.1}  {steps:8}{:11.1}  {effects}", plant.weight()).trim_end());
            (situation, before) = (steps, outputs);
        }
        for noise in plant.pass(&outputs) {
            println!("{:8.1}  {noise}", seconds + f64::from(TICK) / 1000.0);
        }
    }
    assert!(!runner.chart().flags().any(), "nothing goes wrong at run time");
}

/// What changes in the plant: first what goes off.
fn effects(before: &Outputs, now: &Outputs) -> Vec<&'static str> {
    let off = EFFECTS.iter().filter(|(is_on, ..)| is_on(before) && !is_on(now)).map(|(_, _, off)| *off);
    let on = EFFECTS.iter().filter(|(is_on, ..)| !is_on(before) && is_on(now)).map(|(_, on, _)| *on);
    off.chain(on).collect()
}
