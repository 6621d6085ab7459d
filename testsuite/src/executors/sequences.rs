//! Sequential function charts as jobs: what MATIEC makes of them, from whatever text.

use super::jobs::Job;
use super::matiec::miscalculates;
use super::task::{Outcome, Task};
use ecow::{EcoString, eco_format};
use grafc_backends::st;
use grafc_diagnostics::Diagnostics;
use grafc_logic::Analysis;
use grafc_logic::scan::{Held, Program, Step, VarId};
use grafc_logic::sequence::{self, Sequence};
use grafc_model::chart::ExprKind;
use grafc_net::passes;
use index_vec::IndexVec;

/// Whether MATIEC might read the time of a step wrongly. It adds up what passes between calls, and 1.9 s and 0.1 s are 1 s
/// and a thousand milliseconds to it, which is less than 2 s.
fn loses_a_second(task: &Task) -> bool {
    let times: Vec<i64> = task.stimuli.iter().map(|stimulus| stimulus.t_ms).collect();
    let since = |start: usize, end: usize| (times[end] - times[start]) % 1000;
    let full = |start: usize| (start + 1..times.len()).any(|end| since(start, end) == 0 && since(start, end - 1) != 0);
    let reads = task.chart.exprs.iter().any(|expr| matches!(expr.kind, ExprKind::StepTime(_)));
    reads && (0..times.len()).any(full)
}

/// The chart of a task as a sequential function chart, if it can be one.
fn of_task(task: &Task) -> Option<Sequence> {
    let mut net = grafc_net::build(task.chart);
    passes::run(&mut net, false, &mut Diagnostics::new());
    sequence::sequence(&Analysis::new(net), task.profile).ok()
}

/// A task as a job, and its chart; why not, where MATIEC cannot run it.
pub(crate) fn job(task: &Task) -> Result<(Job, Sequence), Outcome> {
    if miscalculates(task.chart) {
        return Err(Outcome::PassedOver("MATIEC computes products of times wrongly"));
    }
    if task.chart.variables.is_empty() {
        return Err(Outcome::PassedOver("MATIEC reads no block without variables"));
    }
    let sequence = of_task(task).ok_or(Outcome::PassedOver("no sequential function chart (E0503)"))?;
    if loses_a_second(task) {
        return Err(Outcome::PassedOver("MATIEC does not carry whole seconds of a step's time"));
    }
    Ok((Job { program: variables_of(&sequence), stimuli: task.stimuli.to_vec() }, sequence))
}

/// The variables of a sequential function chart as a program of a job.
pub fn variables_of(sequence: &Sequence) -> Program {
    let mut program = sequence.program.clone();
    let of_chart = sequence.steps.iter().filter(|step| !step.auxiliary);
    let steps = of_chart.map(|step| Step {
        label: program.variables[step.active].name.as_str().into(),
        comment: None,
        span: grafc_diagnostics::Span::default(),
        held: Held::Bit(step.active),
        active: program.pool.variable(step.active, grafc_formula::Type::Bool),
    });
    program.steps = steps.collect();
    program
}

/// MATIEC numbers steps in the order in which they are declared.
pub(crate) fn names(
    sequence: &Sequence,
    program: &Program,
    blocks: &str,
) -> Result<IndexVec<VarId, EcoString>, String> {
    let mut names = st::names(program);
    let declared = blocks.lines().filter_map(|line| {
        let line = line.trim();
        let head = line.strip_prefix("STEP ").or_else(|| line.strip_prefix("INITIAL_STEP "))?;
        head.split(':').next().map(str::trim)
    });
    let declared: Vec<&str> = declared.collect();
    let named = Sequence { program: program.clone(), ..sequence.clone() };
    let instance = grafc_backends::sfc::instance(&named).map(|name| format!("{name}.")).unwrap_or_default();
    for step in &sequence.steps {
        let name = &names[step.active];
        let place = declared.iter().position(|known| known == name);
        let place = place.ok_or_else(|| format!("step {name} is not declared in\n{blocks}"))?;
        names[step.active] = eco_format!("{instance}__step_list[{place}].X");
    }
    Ok(names)
}
