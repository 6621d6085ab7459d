//! Sequential function charts in text (IEC 61131-3, 2.6): the function block holds steps, transitions and actions.
//!
//! ```text
//! STEP Fill :
//!     valve(N);
//!     late(D, T#5s);
//!     Fill_entry(P1);
//! END_STEP
//!
//! TRANSITION FROM Fill TO (Mix, Heat) := full AND NOT stop; END_TRANSITION
//!
//! ACTION Fill_entry :
//!     batches := batches + 1;
//! END_ACTION
//! ```
//!
//! What of a chart can be one, and what its boxes hold, is shared with the drawings (`crate::sequence`). Here all steps are
//! declared before the first condition, so that a condition names the steps that it reads.
//!
//! MATIEC runs it. It does actions in the order in which they are declared, and an action of two steps, or of a step by two
//! qualifiers, as the last of them has it: so none is shared, and those at the exit of steps come first, those in each scan
//! last, in the order in which GRAFCET takes them (R7).

pub(crate) mod target;

use crate::comment::clean;
use crate::iec::declarations;
use crate::iec::frame;
use crate::iec::names::Names;
pub use crate::iec::{Options, Pou};
use crate::keywords::Family;
use crate::limits;
use crate::sequence::texts::{Activity, Content, Qualifier, Statement, Texts};
use crate::sequence::units::{Fresh, Units};
use crate::st;
use crate::writer::{self, Writer};
use ecow::EcoString;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::StepId;
use grafc_logic::sequence::Sequence;

/// Writes a sequential function chart as text.
///
/// An error is a fault of grafc.
pub fn emit(sequence: &Sequence, options: &Options) -> Result<String, Diagnostics> {
    let program = &sequence.program;
    limits::check(program)?;
    let texts = Texts::new(sequence, Activity::Named);
    let units = Units::new(sequence, &texts);
    let mut out = Writer::new(&writer::IEC);
    out.block_comment(options.header.iter().map(|line| clean(line)));
    let description = units.parts.description.as_deref().unwrap_or_default();
    match &units.drawn {
        None => chart(&mut out, sequence, &texts, &units, (&units.parts.block, description)),
        Some((name, _)) => {
            chart(&mut out, sequence, &texts, &units, (name, "the chart itself"));
            around(&mut out, &units, description);
        }
    }
    let names = Names::new(program, Family::Iec);
    frame::write(&mut out, program, &names, options, |out, inputs, published| {
        st::call::write(out, &names.instance, inputs, published);
    });
    Ok(out.finish())
}

/// The instance whose variables hold the situation, if something is found before or after the chart.
pub fn instance(sequence: &Sequence) -> Option<EcoString> {
    crate::sequence::instance(sequence)
}

/// The function block that calls the chart.
fn around(out: &mut Writer, units: &Units, description: &str) {
    out.blank();
    out.comment(description);
    out.line(&format!("FUNCTION_BLOCK {}", units.parts.block));
    declarations::write(out, &units.parts.interface, declarations::RETAIN);
    out.blank();
    for line in units.parts.body.lines() {
        match line {
            "" => out.blank(),
            line => out.line(line),
        }
    }
    out.blank();
    out.line("END_FUNCTION_BLOCK");
}

/// The function block of the chart.
fn chart(out: &mut Writer, sequence: &Sequence, texts: &Texts, units: &Units, (name, description): (&str, &str)) {
    let interface = units.interface();
    out.blank();
    out.comment(description);
    out.line(&format!("FUNCTION_BLOCK {name}"));
    declarations::write(out, interface, declarations::RETAIN);
    let variables = interface.iter().flat_map(|block| block.entries()).map(|entry| entry.name.as_str());
    let names = [name, &units.parts.block, &units.parts.program].into_iter();
    let mut fresh = Fresh::new(variables.chain(texts.steps.iter().map(EcoString::as_str)).chain(names));
    let mut bodies: [Vec<(String, Vec<&Statement>)>; 3] = Default::default();
    // A network begins with an initial step (IEC 61131-3, 2.6.2).
    let first = sequence.steps.iter_enumerated().find(|(_, step)| step.initial);
    let others = sequence.steps.iter_enumerated().filter(|(place, _)| Some(*place) != first.map(|(place, _)| place));
    for (place, step) in first.into_iter().chain(others) {
        out.blank();
        self::step(out, texts, place, step.initial, &mut fresh, &mut bodies);
    }
    out.blank();
    for (transition, condition) in sequence.transitions.iter().zip(&texts.conditions) {
        let (before, after) = (steps(texts, &transition.before), steps(texts, &transition.after));
        self::transition(out, &before, &after, condition);
    }
    for (name, statements) in bodies.iter().flatten() {
        out.blank();
        out.open(&format!("ACTION {name} :"));
        statements.iter().flat_map(|statement| &statement.lines).for_each(|line| out.line(line));
        out.close("END_ACTION");
    }
    out.blank();
    out.line("END_FUNCTION_BLOCK");
}

/// A step with its actions; those that have bodies are added to them.
fn step<'t>(
    out: &mut Writer,
    texts: &'t Texts,
    place: StepId,
    initial: bool,
    fresh: &mut Fresh,
    bodies: &mut [Vec<(String, Vec<&'t Statement>)>; 3],
) {
    let (name, rows) = (&texts.steps[place.index()], &texts.actions[place.index()]);
    let mut actions = Vec::new();
    for row in rows {
        if let Content::Variable(variable) = &row.content {
            let time = row.qualifier.time().map(|time| format!(", {time}")).unwrap_or_default();
            actions.push(format!("{variable}({}{time});", row.qualifier.name()));
        }
    }
    let moments = [(Qualifier::P0, "exit"), (Qualifier::P1, "entry"), (Qualifier::N, "active")];
    for ((qualifier, moment), bodies) in moments.into_iter().zip(bodies) {
        let of_moment = rows.iter().filter(|row| row.qualifier == qualifier);
        let statements: Vec<&Statement> = of_moment.filter_map(|row| row.content.statement()).collect();
        if !statements.is_empty() {
            let action = fresh.name(&format!("{name}_{moment}"));
            actions.push(format!("{action}({});", qualifier.name()));
            bodies.push((action, statements));
        }
    }
    out.comment(&texts.comments[place.index()]);
    let keyword = if initial { "INITIAL_STEP" } else { "STEP" };
    if actions.is_empty() {
        return out.line(&format!("{keyword} {name} : END_STEP"));
    }
    out.open(&format!("{keyword} {name} :"));
    actions.iter().for_each(|action| out.line(action));
    out.close("END_STEP");
}

/// A transition, on one line if that is not too long.
fn transition(out: &mut Writer, before: &str, after: &str, condition: &str) {
    let head = format!("TRANSITION FROM {before} TO {after} :=");
    let whole = format!("{head} {condition}; END_TRANSITION");
    if out.indent() + whole.chars().count() <= out.width() {
        return out.line(&whole);
    }
    out.open(&head);
    out.line(&format!("{condition};"));
    out.close("END_TRANSITION");
}

/// Steps in a transition.
fn steps(texts: &Texts, steps: &[StepId]) -> String {
    let names: Vec<&str> = steps.iter().map(|step| texts.steps[step.index()].as_str()).collect();
    match names[..] {
        [name] => name.to_owned(),
        _ => format!("({})", names.join(", ")),
    }
}
