//! A program without what no claim depends on: its cone of influence. A counter that only counts makes no difference to what
//! steps are active, and may count for longer than anybody looks.

use grafc_formula::{Formula, FormulaId, TimerId, VarId};
use grafc_logic::scan::{Arm, Choice, Flag, Program, Role, SeenBody, Statement};
use index_vec::IndexVec;

/// The program whose statements are those that claims depend on.
pub(crate) fn cone(program: &Program) -> Program {
    let mut wiring = Wiring::new(program);
    for section in [&program.first, &program.before, &program.micro_step, &program.after] {
        wiring.statements(section, None);
    }
    let needed = wiring.needed();
    let kept = |section: &[Statement]| kept(section, &needed);
    Program {
        first: kept(&program.first),
        before: kept(&program.before),
        micro_step: kept(&program.micro_step),
        after: kept(&program.after),
        ..program.clone()
    }
}

/// What something is made of: formulas, and the choice that it stands in.
#[derive(Clone, Default)]
struct Sources {
    formulas: Vec<FormulaId>,
    variables: Vec<VarId>,
    choices: Vec<usize>,
}

/// Which variables and timers are made of what.
struct Wiring<'p> {
    program: &'p Program,
    of_variable: IndexVec<VarId, Sources>,
    of_timer: IndexVec<TimerId, Sources>,
    /// Of each choice between statements.
    of_choice: Vec<Sources>,
}

/// What claims depend on.
struct Needed {
    variables: IndexVec<VarId, bool>,
    timers: IndexVec<TimerId, bool>,
}

impl<'p> Wiring<'p> {
    fn new(program: &'p Program) -> Self {
        Wiring {
            program,
            of_variable: program.variables.iter().map(|_| Sources::default()).collect(),
            of_timer: program.timers.iter().map(|_| Sources::default()).collect(),
            of_choice: Vec::new(),
        }
    }

    /// Statements nest no deeper than lowering nests them.
    fn statements(&mut self, statements: &[Statement], choice: Option<usize>) {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    let sources = &mut self.of_variable[*target];
                    sources.formulas.push(*value);
                    sources.choices.extend(choice);
                }
                Statement::Divide(division) => {
                    for target in [division.target, division.flag] {
                        let sources = &mut self.of_variable[target];
                        sources.formulas.extend([division.dividend, division.divisor]);
                        sources.choices.extend(choice);
                    }
                }
                Statement::CallTimer { timer, input, .. } => {
                    let sources = &mut self.of_timer[*timer];
                    sources.formulas.push(*input);
                    sources.choices.extend(choice);
                }
                Statement::Case { of, .. } => {
                    let sources =
                        Sources { variables: vec![*of], choices: choice.into_iter().collect(), ..Sources::default() };
                    self.choice(statement, sources);
                }
                Statement::If(of) => {
                    let formulas = of.branches.iter().map(|(when, _)| *when).collect();
                    let sources = Sources { formulas, choices: choice.into_iter().collect(), ..Sources::default() };
                    self.choice(statement, sources);
                }
            }
        }
    }

    fn choice(&mut self, statement: &Statement, sources: Sources) {
        let own = self.of_choice.len();
        self.of_choice.push(sources);
        statement.bodies().for_each(|body| self.statements(body, Some(own)));
    }

    /// What claims are made of, themselves.
    fn roots(&self) -> Sources {
        let program = self.program;
        let mut roots = Sources::default();
        roots.formulas.extend(program.steps.iter().map(|step| step.active));
        roots.variables.extend(program.repeat.map(|repeat| repeat.again));
        roots.variables.extend(program.started);
        if let Some(observing) = &program.observing {
            roots.variables.extend(observing.transitions.iter().map(|seen| seen.cleared));
        }
        for flag in [Flag::AllocConflict, Flag::ForceConflict] {
            roots.variables.extend(program.of_role(Role::Flag(flag)).map(|(v, _)| v));
        }
        for claim in &program.claims {
            match claim.body {
                SeenBody::Condition(v) => roots.variables.push(v),
                SeenBody::Leads(from, to) => roots.variables.extend([from, to]),
            }
        }
        roots
    }

    fn needed(&self) -> Needed {
        let mut needed = Needed {
            variables: self.of_variable.iter().map(|_| false).collect(),
            timers: self.of_timer.iter().map(|_| false).collect(),
        };
        let mut formulas: Vec<bool> = vec![false; self.program.pool.len()];
        let mut choices = vec![false; self.of_choice.len()];
        let mut open = vec![self.roots()];
        while let Some(sources) = open.pop() {
            let mut variables = sources.variables;
            let mut below = sources.formulas;
            while let Some(formula) = below.pop() {
                if std::mem::replace(&mut formulas[formula.index()], true) {
                    continue;
                }
                match self.program.pool.get(formula) {
                    Formula::Variable(v) => variables.push(*v),
                    Formula::TimerDone(t) | Formula::TimerElapsed(t) => {
                        if !std::mem::replace(&mut needed.timers[*t], true) {
                            open.push(self.of_timer[*t].clone());
                        }
                    }
                    Formula::Constant(_)
                    | Formula::Not(_)
                    | Formula::And(_)
                    | Formula::Or(_)
                    | Formula::Xor(..)
                    | Formula::Compare(..)
                    | Formula::Arithmetic(..)
                    | Formula::Negate(_)
                    | Formula::Widen(_) => {}
                }
                below.extend(self.program.pool.operands(formula));
            }
            for v in variables {
                if !std::mem::replace(&mut needed.variables[v], true) {
                    open.push(self.of_variable[v].clone());
                }
            }
            for choice in sources.choices {
                if !std::mem::replace(&mut choices[choice], true) {
                    open.push(self.of_choice[choice].clone());
                }
            }
        }
        needed
    }
}

/// Statements nest no deeper than lowering nests them.
fn kept(statements: &[Statement], needed: &Needed) -> Vec<Statement> {
    let is_left = |statement: &Statement| statement.bodies().any(|body| !body.is_empty());
    let of = |statement: &Statement| match statement {
        Statement::Heading(_) => None,
        Statement::Assign { target, .. } => needed.variables[*target].then(|| statement.clone()),
        Statement::Divide(division) => {
            (needed.variables[division.target] || needed.variables[division.flag]).then(|| statement.clone())
        }
        Statement::CallTimer { timer, .. } => needed.timers[*timer].then(|| statement.clone()),
        Statement::Case { of, arms } => {
            let arms = arms.iter().map(|arm| Arm { body: kept(&arm.body, needed), ..arm.clone() });
            Some(Statement::Case { of: *of, arms: arms.collect() }).filter(is_left)
        }
        Statement::If(choice) => {
            let Choice { branches, otherwise } = &**choice;
            let branches = branches.iter().map(|(when, body)| (*when, kept(body, needed)));
            let choice = Statement::choice(branches.collect(), kept(otherwise, needed));
            Some(choice).filter(is_left)
        }
    };
    statements.iter().filter_map(of).collect()
}
