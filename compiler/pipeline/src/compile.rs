//! The way from text to code, stage by stage.
//!
//! ```text
//! text ─parse─▶ syntax tree ─check─▶ chart ─flatten─▶ flat net ─analyse─▶ what is proved ─compile─▶ scan program ─emit─▶ code
//! ```
//!
//! Functions of their arguments alone: nothing is read, written or printed. A stage reports all it finds; after a
//! stage that found an error, no other begins, except that a text with syntax errors is checked as far as it was read.
//! What lies between two stages can be had as text.
//!
//! Here each stage is run once, and what it was made of is dropped as soon as possible. To ask again and again about a
//! text that changes takes a [`Document`](crate::Document).

use crate::header::header;
use crate::options::{Options, Product};
use crate::stages::{Last, check as resolve, flatten, net_after, parse, warn};
use grafc_backends::{Output, Source, Target};
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_logic::scan::{Observed, WorstCase};
use grafc_logic::{Analysis, Options as Lowering, scan};
use grafc_model::chart::Chart;

/// As far as what is asked for. There is a text exactly if no message is an error, or taken for one; and none after a pass that is not run.
pub fn compile(file: FileId, text: &str, default_name: &str, options: &Options) -> (Option<Output>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let made = make(file, text, default_name, options, &mut diagnostics);
    options.policy.apply(&mut diagnostics);
    (made.filter(|_| !diagnostics.has_errors()), diagnostics)
}

/// As far as the checked chart. There is one exactly if no message is an error. Who takes warnings for errors applies a
/// [`Policy`](grafc_diagnostics::Policy) to what is said.
pub fn check(file: FileId, text: &str, default_name: &str) -> (Option<Chart>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let tree = parse(file, text, &mut diagnostics);
    let chart = resolve(&tree, default_name, &mut diagnostics);
    let net = chart.clone().and_then(|chart| flatten(chart, false, &mut diagnostics));
    if let (Some(chart), Some(net)) = (&chart, net) {
        warn(&Analysis::new(net), &chart.allowances, &mut diagnostics);
    }
    (chart.filter(|_| !diagnostics.has_errors()), diagnostics)
}

fn make(
    file: FileId,
    text: &str,
    default_name: &str,
    options: &Options,
    diagnostics: &mut Diagnostics,
) -> Option<Output> {
    let Options { lowering, asked, source, bound_as_known, controls, product, policy: _ } = options;

    let tree = parse(file, text, diagnostics);
    if let Product::Tree = product {
        return Some(grafc_syntax::dump(&tree).into());
    }
    let mut chart = resolve(&tree, default_name, diagnostics)?;
    drop(tree);
    let against = chart.options.against(asked);
    if against.has_errors() {
        diagnostics.append(against);
        return None;
    }
    let lowering = &Lowering { profile: chart.options.over(lowering.profile), ..*lowering };
    if let Err(found) = chart.control(controls) {
        diagnostics.append(found);
        return None;
    }
    let allowances = chart.allowances.clone();
    let overlaps = lowering.encoding.overlaps();
    let is_asked_again = overlaps || matches!(product, Product::Chart | Product::NetAfter(_));
    let kept = is_asked_again.then(|| chart.clone());
    let mut analysis = Analysis::new(flatten(chart, false, diagnostics)?);
    warn(&analysis, &allowances, diagnostics);
    match (kept, product) {
        (Some(chart), Product::Chart) => return Some(grafc_model::dump(&chart).into()),
        (Some(chart), Product::NetAfter(pass)) => return net_after(&chart, overlaps, pass).map(Output::from),
        // It was warned of the net that does what the rules say; this one is drawn for the encoding.
        (Some(chart), _) => analysis = Analysis::new(flatten(chart, true, diagnostics)?),
        (None, _) => {}
    }
    if let Product::Net = product {
        return Some(grafc_net::dump(analysis.net()).into());
    }
    let head = |target: &Target| {
        let mut target = target.clone();
        if let Some(source) = source {
            let lines = header(source, lowering, *bound_as_known, controls, &target);
            target.set_header(lines);
        }
        target
    };
    let bounded = &bounded(lowering, *bound_as_known, &analysis);
    let mut last = Last::new(analysis, bounded);
    let made = match product {
        Product::Code(target) => emit(&head(target), &mut last),
        Product::Mapped(target) => {
            last.wants_map = true;
            emit(&head(target), &mut last)
        }
        Product::Equations => last.program().map(|program| scan::equations(program).into()),
        Product::Program => last.program().map(|program| scan::dump(program).into()),
        Product::Tree | Product::Chart | Product::NetAfter(_) | Product::Net => return None,
    };
    diagnostics.append(last.diagnostics);
    allowances.apply(diagnostics);
    made.map_err(|found| diagnostics.append(found)).ok()
}

/// The options with the bound that is known to be enough, if it is wanted and there is one that is no larger than usual.
pub(crate) fn bounded(lowering: &Lowering, as_known: bool, analysis: &Analysis) -> Lowering {
    let mut bounded = *lowering;
    // Where steps overlap, a hand-over takes longer.
    if as_known && !lowering.encoding.overlaps() {
        let net = analysis.net();
        let usual = lowering.profile.bound_for(net.places.len(), net.transitions.len());
        bounded.profile.bound = analysis.known_bound().map(|known| known.min(usual)).or(lowering.profile.bound);
        bounded.profile = net.options.over(bounded.profile);
    }
    bounded
}

/// The code, with the worst case of a call in its head.
fn emit(target: &Target, last: &mut Last) -> Result<Output, Diagnostics> {
    if !target.writes_statements() {
        return target.emit(last);
    }
    let program = match (target.shows(), target.saves_memory()) {
        (Observed::Nothing, false) => last.program()?,
        (Observed::Nothing, true) => last.saved_program()?,
        (observed, _) => last.observed_program(observed)?,
    };
    let WorstCase { micro_steps, statements } = program.worst_case();
    let mut target = target.clone();
    let plural = if micro_steps == 1 { "" } else { "s" };
    target.add_to_header(format!("A call takes at most {micro_steps} micro-step{plural}, {statements} statements."));
    target.emit(last)
}
