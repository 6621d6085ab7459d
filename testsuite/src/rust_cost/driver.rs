//! The Rust program that checks and times one spelling.
//!
//! It does what the C program of [`crate::scan_cost`] does. The scan is called through a pointer that rustc cannot see
//! through, so that it is not inlined, and the same loop without a call is subtracted. The call itself counts, which
//! takes a nanosecond or two: the processor does what surrounds it at the same time as a scan so short, and what would
//! be left without it would be noise. Of many short slices the least counts. Before anything is timed, the outputs are
//! compared with what they must be, some hundred scans long and with inputs that must not matter; and once more after
//! all that was timed.

use crate::rings::Rings;
use std::fmt::Write as _;

/// Slices of about a millisecond in which a program times one thing.
pub(super) const SLICES: usize = 16;

/// How often the tokens are moved and the outputs compared before anything is timed.
pub(super) const CHECKED: usize = 400;

const BODY: &str = r#"
type Scan = for<'a> fn(&'a mut Ring, &Inputs, u32) -> &'a Outputs;

struct Bench {
    chart: Ring,
    inputs: Inputs,
    now: u32,
    /// The place of the tokens in their rings.
    at: usize,
    scan: Scan,
}

impl Bench {
    fn put(&mut self, step: usize, value: bool) {
        // SAFETY: there is a field of type `bool`.
        unsafe { (&raw mut self.inputs).cast::<bool>().add(INPUTS[step] as usize).write(value) }
    }

    fn output(&self, step: usize) -> bool {
        // SAFETY: there is a field of type `bool`.
        unsafe { std::ptr::from_ref(self.chart.outputs()).cast::<bool>().add(OUTPUTS[step] as usize).read() }
    }

    fn call<const SCANS: bool>(&mut self) {
        let inputs = black_box(&self.inputs);
        if SCANS {
            black_box((self.scan)(&mut self.chart, inputs, self.now));
        }
        self.now = self.now.wrapping_add(1);
    }

    fn next(&self) -> usize {
        if self.at + 1 == WALKED { 0 } else { self.at + 1 }
    }

    fn idle<const SCANS: bool>(&mut self, scans: u64) {
        for _ in 0..scans {
            self.call::<SCANS>();
        }
    }

    fn clearing<const SCANS: bool>(&mut self, scans: u64) {
        for _ in 0..scans {
            for ring in 0..RINGS {
                self.put(ring * LENGTH + self.at, true);
            }
            self.call::<SCANS>();
            for ring in 0..RINGS {
                self.put(ring * LENGTH + self.at, false);
            }
            self.at = self.next();
        }
    }

    /// Each output is on if a token is at its step.
    fn compare(&self, when: &str) {
        for step in 0..STEPS {
            let expected = step % LENGTH == self.at;
            assert_eq!(self.output(step), expected, "{when}, tokens at {}: output {step}", self.at);
        }
    }

    /// Moves the tokens, with all inputs on but those of the steps that they come to.
    fn clearing_among_others(&mut self) {
        let next = self.next();
        for step in 0..STEPS {
            self.put(step, step % LENGTH != next);
        }
        self.call::<true>();
        self.at = next;
        self.compare("among others");
        for step in 0..STEPS {
            self.put(step, false);
        }
    }

    fn check(&mut self) {
        self.idle::<true>(2);
        self.compare("at the start");
        for cleared in 0..CHECKED {
            if cleared % 2 == 0 { self.clearing::<true>(1) } else { self.clearing_among_others() }
            self.idle::<true>(1);
            self.compare("after a clearing");
        }
    }

    /// Ns a scan: the least of some short slices, because all that comes in between makes a slice longer.
    fn least(&mut self, what: fn(&mut Self, u64)) -> f64 {
        let mut timed = |scans: u64| {
            let begin = Instant::now();
            what(self, scans);
            begin.elapsed().as_nanos() as f64
        };
        let mut scans = 1;
        let mut best = timed(scans);
        while best < 1e6 {
            scans *= 2;
            best = timed(scans);
        }
        for _ in 0..SLICES {
            best = best.min(timed(scans));
        }
        best / scans as f64
    }

    fn cost(&mut self, what: fn(&mut Self, u64), around: fn(&mut Self, u64)) -> f64 {
        let all = self.least(what);
        // Without scans the tokens do not move.
        let before = self.at;
        let around = self.least(around);
        self.at = before;
        all - around
    }
}

fn main() {
    let mut bench = Bench { chart: Ring::new(), inputs: Inputs::default(), now: 0, at: 0, scan: black_box(Ring::scan) };
    bench.check();
    let idle = bench.cost(Bench::idle::<true>, Bench::idle::<false>);
    let clearing = bench.cost(Bench::clearing::<true>, Bench::clearing::<false>);
    bench.compare("at the end");
    println!("{idle:.4} {clearing:.4} {}", size_of::<Ring>());
}
"#;

/// The program, beside a crate `chart`.
pub(super) fn write(rings: Rings) -> String {
    let mut out = String::from(
        "use chart::{Inputs, Outputs, Ring};\nuse std::hint::black_box;\nuse std::mem::{offset_of, size_of};\n\
         use std::time::Instant;\n\n",
    );
    let (steps, tokens, length) = (rings.steps, rings.tokens, rings.length());
    let constants = [
        ("STEPS", steps),
        ("RINGS", tokens),
        ("LENGTH", length),
        ("WALKED", rings.walked),
        ("SLICES", SLICES),
        ("CHECKED", CHECKED),
    ];
    for (name, value) in constants {
        let _ = writeln!(out, "const {name}: usize = {value};");
    }
    for (name, of, letter) in [("INPUTS", "Inputs", 'x'), ("OUTPUTS", "Outputs", 'w')] {
        let _ = writeln!(out, "\n/// Where each field lies.\nstatic {name}: [u32; STEPS] = [");
        for i in 0..steps {
            let _ = writeln!(out, "    offset_of!({of}, {letter}_{i}) as u32,");
        }
        out.push_str("];\n");
    }
    out.push_str(BODY);
    out
}
