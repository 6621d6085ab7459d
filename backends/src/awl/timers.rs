//! Time.
//!
//! A clock of the block's own counts the milliseconds that pass from call to call, and a timer remembers what it showed
//! when the timer was started. Both wrap around after 32 bits, so a difference is right for 24 days; a timer that has run
//! out stays so without it. The time that has passed since the last call is the difference of `NOW` at 31 bits, which is
//! right whether `NOW` wraps around after 31 or after 32. Where it is more than half of that, `NOW` was put back: no time
//! counts, so that no delay ends by it.

use super::code::Code;
use super::numbers::long;
use super::{AwlNames, Local, local};
use crate::namer::Namer;
use ecow::{EcoString, eco_format};
use grafc_formula::Type;
use grafc_logic::scan::{Preset, Reads, TimerId};

/// Half the range of 31 bits.
const HALF: &str = "L#1073741824";

/// The variables that measure time for all timers.
pub(super) struct Clock {
    /// The input.
    pub now: EcoString,
    /// What the input was at the last call.
    pub before: EcoString,
    /// The block's own clock.
    pub clock: EcoString,
}

impl Clock {
    /// The usual names, if they are free.
    pub fn new(namer: &mut Namer) -> Self {
        Clock { now: namer.name("NOW"), before: namer.name("last_now"), clock: namer.name("clock") }
    }

    /// Brings the clock up to date.
    pub fn update(&self, code: &mut Code) {
        code.network("the clock: milliseconds since the call before");
        code.about("the clock");
        let back = code.new_label();
        code.number("L", &local(&self.now));
        code.number("L", &local(&self.before));
        code.number("-D", "");
        code.number("AD", "DW#16#7FFFFFFF");
        code.number("L", HALF);
        code.comparison(">D");
        code.remark(Some("NOW was put back: no time"));
        code.jump_if(&back);
        code.number("TAK", "");
        code.number("L", &local(&self.clock));
        code.number("+D", "");
        code.instruction("T", &local(&self.clock));
        code.label(back);
        code.number("L", &local(&self.now));
        code.instruction("T", &local(&self.before));
    }

    /// What keeps its value, and what it is.
    pub fn kept(&self) -> [(Local, &'static str); 2] {
        let local = |name: &EcoString| Local { name: name.clone(), ty: Type::Dint };
        [
            (local(&self.before), "NOW at the call before"),
            (local(&self.clock), "milliseconds, counted from call to call"),
        ]
    }
}

/// The variables of one timer.
pub(super) struct TimerNames {
    /// Whether it has run out.
    pub done: EcoString,
    /// For how long it has run.
    pub elapsed: EcoString,
    /// Whether it runs.
    run: EcoString,
    /// What the clock showed when it was started.
    start: EcoString,
    /// Whether somebody asks for how long it has run.
    measures: bool,
    /// Whether somebody asks whether it has run out.
    ends: bool,
}

impl TimerNames {
    /// The timer's name is that of what is read of it.
    pub fn new(reads: Reads, name: EcoString, namer: &mut Namer) -> Self {
        let Reads { end: ends, elapsed: measures } = reads;
        let mut further = |end: &str| namer.name(&eco_format!("{name}_{end}"));
        let (run, start) = (further("run"), further("start"));
        let elapsed = if ends && measures { further("time") } else { name.clone() };
        TimerNames { done: name, elapsed, run, start, measures, ends }
    }

    /// What keeps its value; the first is what the timer is called after.
    pub fn kept(&self) -> Vec<Local> {
        let local = |name: &EcoString, ty| Local { name: name.clone(), ty };
        let done = self.ends.then(|| local(&self.done, Type::Bool));
        let elapsed = self.measures.then(|| local(&self.elapsed, Type::Time));
        let others = [local(&self.run, Type::Bool), local(&self.start, Type::Dint)];
        done.into_iter().chain(elapsed).chain(others).collect()
    }
}

/// Brings a timer up to date; the result of logic operation is its input.
pub(super) fn call(code: &mut Code, names: &AwlNames, timer: TimerId, preset: Preset) {
    let Some(clock) = names.clock.as_ref().map(|clock| local(&clock.clock)) else { return };
    let timer = &names.timers[timer];
    let (run, start) = (local(&timer.run), local(&timer.start));
    let runs = code.new_label();
    code.bit("FP", &run);
    code.jump_unless(&runs);
    code.number("L", &clock);
    code.instruction("T", &start);
    code.label(runs);
    if timer.measures {
        measure(code, &clock, &start, &run, &local(&timer.elapsed));
    }
    if timer.ends {
        let done = local(&timer.done);
        code.number("L", &clock);
        code.number("L", &start);
        code.number("-D", "");
        code.number("L", &preset.constant.map_or_else(|| long(preset.ms), |constant| names.variable(constant)));
        code.comparison(">=D");
        code.bit("O", &done);
        code.bit("A", &run);
        code.assign(&done);
    }
    code.rlo = None;
}

/// The time since the start while the timer runs, else 0; it does not fall when the difference wraps around.
fn measure(code: &mut Code, clock: &str, start: &str, run: &str, elapsed: &str) {
    let [on, store, keep] = [(); 3].map(|()| code.new_label());
    code.bit("A", run);
    code.jump_if(&on);
    code.number("L", "L#0");
    code.jump(&store);
    code.label(on);
    code.number("L", clock);
    code.number("L", start);
    code.number("-D", "");
    code.number("L", elapsed);
    code.comparison("<D");
    code.jump_if(&keep);
    code.number("TAK", "");
    code.label(store);
    code.instruction("T", elapsed);
    code.label(keep);
}
