//! A scan as functions: one for most charts, several for large ones.
//!
//! rustc takes a time for a function that grows with the square of its length. So the statements of a large program are
//! split: runs of them become functions of their own, and of a large `Case` each arm, which a table finds by the value: as
//! quick as a `match`, however many there are. What more than one function needs lies in a struct that the scan passes on.

use super::code::{Choice, Code, Needs};
use super::places::Places;
use super::uses::{Uses, shared};
use crate::limits;
use grafc_formula::FormulaId;
use grafc_logic::scan::{Arm, Origin, Program, Statement, Told, VarId};
use rustc_hash::FxHashSet;

/// Programs with so many times more statements than one function should have are split.
const LARGE: usize = 3;
/// A run of statements so many times shorter than a function should be stays where it is.
const SHORT: usize = 10;
/// Operands that weigh as much as a statement.
const FORMULA: usize = 8;

/// What stands above the function of a micro-step.
const MICRO_STEP: &str = "one micro-step; true if another is needed";

/// What stands above the function that gives outputs back.
const RESTORE_OUTPUTS: &str = "what follows from the memory that has been restored";

/// What stands above a function.
#[derive(Clone, Copy)]
pub(super) enum About {
    /// These words.
    Words(&'static str),
    /// What is said of where it comes from.
    Origin(Origin, Told),
}

/// A function.
#[derive(Default)]
pub(super) struct Function<'p> {
    /// What stands above its statements.
    pub about: Option<About>,
    /// What it does.
    pub code: Vec<Code<'p>>,
    /// What it needs, together with the functions that it calls.
    pub needs: Needs,
    /// The table that it is in, if it is an arm.
    pub table: Option<usize>,
}

/// An arm for each value of a state: a list of functions.
pub(super) struct Table {
    /// In the order of the values; none for those that nothing is done at.
    pub arms: Vec<Option<usize>>,
    /// The function that stands first in the text.
    pub first: usize,
    /// What the arms need together: all functions of a table are called alike.
    pub needs: Needs,
}

/// The functions of a scan; the first is the scan itself.
pub(super) struct Split<'p> {
    pub functions: Vec<Function<'p>>,
    pub tables: Vec<Table>,
    /// The function of a micro-step, if there is a loop.
    pub micro_step: Option<usize>,
    /// The function that gives outputs back, if the situation decides on any.
    pub restore_outputs: Option<usize>,
    /// Temporaries that several functions need, in order.
    pub shared: Vec<VarId>,
    /// Statements of a function, about.
    pub longest: usize,
}

impl<'p> Split<'p> {
    /// Splits the program if it is large.
    pub fn new(program: &'p Program, places: &Places, longest: usize) -> Self {
        let sections = [&program.first, &program.before, &program.micro_step, &program.after];
        let weights = Weights { sizes: limits::sizes(program) };
        let large = sections.iter().map(|section| weights.all(section)).sum::<usize>() > longest.saturating_mul(LARGE);
        let functions = vec![Function::default()];
        let mut splitter = Splitter { places, weights, large, longest, functions, tables: Vec::new(), about: None };
        let mut code = splitter.block(&program.first);
        code.extend(splitter.block(&program.before));
        let micro_step = program.repeat.map(|repeat| {
            // In a function of its own whatever its length: put into the loop, it would make LLVM read all inputs first.
            let function = splitter.reserve();
            let mut code = splitter.block(&program.micro_step);
            code.push(Code::Again(repeat.again));
            splitter.functions[function] =
                Function { about: Some(About::Words(MICRO_STEP)), code, ..Function::default() };
            function
        });
        match micro_step {
            Some(function) => code.push(Code::Loop(function)),
            None => code.extend(splitter.block(&program.micro_step)),
        }
        code.extend(splitter.block(&program.after));
        splitter.functions[0].code = code;
        let restored = program.restoring.as_ref().filter(|restoring| !restoring.statements.is_empty());
        let restore_outputs = restored.map(|restoring| {
            let function = splitter.reserve();
            let code = splitter.block(&restoring.statements);
            splitter.functions[function] =
                Function { about: Some(About::Words(RESTORE_OUTPUTS)), code, ..Function::default() };
            function
        });
        let Splitter { functions, tables, .. } = splitter;
        let uses: Vec<Uses> = functions.iter().map(|function| Uses::of(program, places, &function.code)).collect();
        let mut split =
            Split { functions, tables, micro_step, restore_outputs, shared: shared(program, &uses), longest };
        split.tell_needs(&uses);
        split
    }

    /// What a function is called.
    pub fn name(&self, function: usize) -> String {
        if self.micro_step == Some(function) {
            "micro_step".to_owned()
        } else if self.restore_outputs == Some(function) {
            "restore_outputs".to_owned()
        } else {
            format!("part_{function}")
        }
    }

    /// Whether a function only calls the arms of the active steps. To put it where it is called saves a call then.
    pub fn only_finds(&self, function: usize) -> bool {
        let code = &self.functions[function].code;
        let mut finds = code.iter().filter(|code| matches!(code, Code::Table(..) | Code::Call(_)));
        finds.next().is_some()
            && code.iter().all(|code| match code {
                Code::Table(..) | Code::Call(_) | Code::Again(_) => true,
                Code::Plain(Statement::Heading(_) | Statement::Assign { .. }) => true,
                Code::Plain(_) | Code::Loop(_) | Code::If(..) | Code::Arms(..) => false,
            })
    }

    /// Functions call only those after them.
    fn tell_needs(&mut self, uses: &[Uses]) {
        let shared: FxHashSet<VarId> = self.shared.iter().copied().collect();
        for index in (0..self.functions.len()).rev() {
            let mut needs = uses[index].needs;
            needs.values = uses[index].temporaries.iter().any(|v| shared.contains(v));
            for callee in &uses[index].calls {
                needs.and(self.functions[*callee].needs);
            }
            for table in &uses[index].tables {
                needs.and(self.tables[*table].needs);
            }
            let function = &mut self.functions[index];
            function.needs = needs;
            if let Some(table) = function.table {
                self.tables[table].needs.and(needs);
            }
        }
    }

    /// What a function is given.
    pub fn given(&self, function: usize) -> Needs {
        let function = &self.functions[function];
        function.table.map_or(function.needs, |table| self.tables[table].needs)
    }
}

/// How long statements are: one each, and more where a formula takes several lines.
struct Weights {
    /// Of each formula how large it is when written out.
    sizes: Vec<(u32, u32)>,
}

impl Weights {
    /// Statements nest no deeper than lowering nests them.
    fn all(&self, statements: &[Statement]) -> usize {
        statements.iter().map(|statement| self.of(statement)).sum()
    }

    fn of(&self, statement: &Statement) -> usize {
        match statement {
            Statement::Heading(_) => 0,
            Statement::Assign { value, .. } => 1 + self.formula(*value),
            Statement::Divide(_) => 1,
            Statement::CallTimer { input, .. } => 1 + self.formula(*input),
            Statement::Case { arms, .. } => 1 + arms.iter().map(|arm| self.all(&arm.body)).sum::<usize>(),
            Statement::If(choice) => {
                let branch = |(when, body): &(FormulaId, Vec<Statement>)| self.formula(*when) + self.all(body);
                1 + choice.branches.iter().map(branch).sum::<usize>() + self.all(&choice.otherwise)
            }
        }
    }

    fn formula(&self, id: FormulaId) -> usize {
        self.sizes[id.index()].1 as usize / FORMULA
    }
}

struct Splitter<'p, 'a> {
    places: &'a Places<'a>,
    weights: Weights,
    large: bool,
    longest: usize,
    functions: Vec<Function<'p>>,
    tables: Vec<Table>,
    /// The last heading.
    about: Option<About>,
}

impl<'p> Splitter<'p, '_> {
    fn block(&mut self, statements: &'p [Statement]) -> Vec<Code<'p>> {
        if !self.large || self.weights.all(statements) <= self.longest {
            return statements.iter().map(Code::Plain).collect();
        }
        let mut out = Vec::new();
        let mut run: Vec<Code<'p>> = Vec::new();
        let mut run_weight = 0;
        for statement in statements {
            let weight = self.weights.of(statement);
            if run_weight + weight > self.longest {
                self.outline(&mut out, &mut run, run_weight);
                run_weight = 0;
            }
            if let Statement::Heading(heading) = statement {
                self.about = Some(About::Words(heading.text()));
            }
            match statement {
                Statement::If(choice) if weight > self.longest => {
                    let branches = choice.branches.iter().map(|(when, body)| (*when, self.block(body))).collect();
                    out.push(Code::If(Box::new(Choice { branches, otherwise: self.block(&choice.otherwise) })));
                }
                Statement::Case { of, arms } if weight > self.longest => out.push(self.case(*of, arms)),
                Statement::Heading(_)
                | Statement::Assign { .. }
                | Statement::Divide(_)
                | Statement::CallTimer { .. }
                | Statement::If(_)
                | Statement::Case { .. } => {
                    run.push(Code::Plain(statement));
                    run_weight += weight;
                }
            }
        }
        self.outline(&mut out, &mut run, run_weight);
        out
    }

    /// A run of statements becomes a function, a short one does not: it would cost the call.
    fn outline(&mut self, out: &mut Vec<Code<'p>>, run: &mut Vec<Code<'p>>, weight: usize) {
        let run = std::mem::take(run);
        if weight <= self.longest / SHORT {
            return out.extend(run);
        }
        let function = self.reserve();
        self.functions[function].code = run;
        out.push(Code::Call(function));
    }

    fn case(&mut self, of: VarId, arms: &'p [Arm]) -> Code<'p> {
        // The call of a function takes longer than the whole rest of an idle scan: only where there are many.
        let state = self.places.state(of).filter(|_| arms.len() > self.longest);
        let Some(state) = state else {
            let arms = arms.iter().map(|arm| (arm, self.block(&arm.body))).collect();
            return Code::Arms(of, arms);
        };
        let table = self.tables.len();
        let first = self.functions.len();
        self.tables.push(Table { arms: vec![None; state.variants.len()], first, needs: Needs::default() });
        for arm in arms {
            self.about = Some(About::Origin(arm.origin, arm.told));
            let function = self.reserve();
            self.tables[table].arms[state.place(arm.value)] = Some(function);
            self.functions[function].table = Some(table);
            self.functions[function].code = self.block(&arm.body);
        }
        Code::Table(of, table)
    }

    /// A number for a function, before those that it calls.
    fn reserve(&mut self) -> usize {
        self.functions.push(Function { about: self.about, ..Function::default() });
        self.functions.len() - 1
    }
}
