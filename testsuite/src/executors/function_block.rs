//! A job as a function block of IEC 61131-3, for tools that compile one and let its variables be read.

use super::jobs::Job;
use ecow::EcoString;
use grafc_backends::st;
use grafc_diagnostics::Diagnostics;
use grafc_formula::{Comparison, Formula, FormulaId};
use grafc_logic::scan::{Program, VarId};
use grafc_model::chart::Value;
use index_vec::IndexVec;

/// A job as a function block.
pub(crate) struct FunctionBlock {
    /// The scan program, under a name that is unique among the jobs.
    pub program: Program,
    /// What its variables are called in the text.
    pub names: IndexVec<VarId, EcoString>,
    /// What the block is called.
    pub name: String,
    /// The text.
    pub text: String,
    /// The instance within it that holds what is kept over a restart, if the block does not itself.
    pub holder: Option<String>,
}

/// When a step is active.
pub(crate) enum Activity {
    /// While this variable is true.
    Bit(VarId),
    /// While this variable has this value.
    Value(VarId, i64),
}

/// The program of a job, under a name that no other has. A function block has no addresses.
pub(crate) fn named(index: usize, program: &Program) -> Program {
    let mut program = Program { name: format!("Job_{index}"), ..program.clone() };
    for variable in &mut program.variables {
        variable.address = None;
    }
    program
}

impl FunctionBlock {
    /// The job as Structured Text.
    pub fn structured_text(index: usize, job: &Job) -> Result<Self, String> {
        let emit = |program: &Program| st::emit(program, &st::Options::default());
        Self::new(index, job, emit, st::names)
    }

    /// The job in a language: what emits its text, and what names its variables.
    pub fn new(
        index: usize,
        job: &Job,
        emit: impl FnOnce(&Program) -> Result<String, Diagnostics>,
        names: impl FnOnce(&Program) -> IndexVec<VarId, EcoString>,
    ) -> Result<Self, String> {
        let program = named(index, &job.program);
        let text = emit(&program).map_err(|diagnostics| format!("{diagnostics:#?}"))?;
        let name = text
            .lines()
            .find_map(|line| line.trim().strip_prefix("FUNCTION_BLOCK "))
            .ok_or("the text has no function block")?
            .trim()
            .to_string();
        Ok(FunctionBlock { names: names(&program), program, name, text, holder: None })
    }

    /// The names of what is kept over a restart.
    pub fn kept(&self) -> impl Iterator<Item = String> {
        let holder = self.holder.as_ref().map(|holder| format!("{holder}.")).unwrap_or_default();
        let kept = self.program.variables.iter_enumerated().filter(|(_, variable)| variable.retain);
        kept.map(move |(id, _)| format!("{holder}{}", self.names[id]))
    }

    /// When each step is active; an error if one is held in a way that is not known here.
    pub fn activities(&self) -> Result<Vec<Activity>, String> {
        self.program.steps.iter().map(|step| self.activity(step.active)).collect()
    }

    fn activity(&self, id: FormulaId) -> Result<Activity, String> {
        let pool = &self.program.pool;
        match pool.get(id) {
            Formula::Variable(variable) => Ok(Activity::Bit(*variable)),
            Formula::Compare(Comparison::Equal, [a, b]) => match (pool.get(*a), pool.get(*b)) {
                (Formula::Variable(variable), Formula::Constant(Value::Int(n))) => Ok(Activity::Value(*variable, *n)),
                (a, b) => Err(format!("a step is active where {a:?} = {b:?}, which nothing here can read")),
            },
            other => Err(format!("a step is active where {other:?} is true, which nothing here can read")),
        }
    }
}
