//! Leaves out what nothing reads: assignments to temporaries of no use, and the temporaries themselves.
//!
//! Some are made before it is known whether they will be needed: the mark that something clears, whether a grafcet is
//! frozen, an edge in a condition that another formula makes superfluous.

use crate::formula::{Formula, FormulaId, Pool};
use crate::scan::{Program, Role, Statement, VarId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// Sweeps a program.
pub(crate) fn sweep(program: &mut Program) {
    let used = Uses::of(program);
    let is_dead = |v: VarId| program.variables[v].role == Role::Temporary && !used[v];
    let dead: IndexVec<VarId, bool> = program.variables.indices().map(is_dead).collect();
    if dead.iter().all(|dead| !dead) {
        return;
    }
    let Program { first, before, micro_step, after, pool, .. } = program;
    for section in [first, before, micro_step, after] {
        *section = swept(pool, std::mem::take(section), &dead);
    }
    renumber(program, &dead);
}

/// Which variables something reads that counts.
struct Uses<'p> {
    program: &'p Program,
    used: IndexVec<VarId, bool>,
    /// The values that each temporary is given.
    values: FxHashMap<VarId, Vec<FormulaId>>,
    /// Formulas that count.
    open: Vec<FormulaId>,
}

impl Uses<'_> {
    fn of(program: &Program) -> IndexVec<VarId, bool> {
        let used = program.variables.iter().map(|_| false).collect();
        let mut uses = Uses { program, used, values: FxHashMap::default(), open: Vec::new() };
        for section in [&program.first, &program.before, &program.micro_step, &program.after] {
            uses.statements(section);
        }
        uses.open.extend(program.steps.iter().map(|step| step.active));
        if let Some(repeat) = program.repeat {
            uses.reads(repeat.again);
            repeat.limit.iter().for_each(|limit| uses.reads(limit.count));
        }
        let mut seen = vec![false; program.pool.len()];
        while let Some(id) = uses.open.pop() {
            if std::mem::replace(&mut seen[id.index()], true) {
                continue;
            }
            if let Formula::Variable(v) = program.pool.get(id) {
                uses.reads(*v);
            }
            uses.open.extend(program.pool.operands(id));
        }
        uses.used
    }

    fn reads(&mut self, v: VarId) {
        if !std::mem::replace(&mut self.used[v], true) {
            self.open.extend(self.values.remove(&v).unwrap_or_default());
        }
    }

    /// Recurses as deep as statements are nested, which the encodings bound.
    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    if self.program.variables[*target].role == Role::Temporary && !self.used[*target] {
                        self.values.entry(*target).or_default().push(*value);
                    } else {
                        self.open.push(*value);
                    }
                }
                // It may raise a flag.
                Statement::Divide { target, dividend, divisor, .. } => {
                    self.open.extend([*dividend, *divisor]);
                    self.reads(*target);
                }
                Statement::CallTimer { input, .. } => self.open.push(*input),
                Statement::Case { of, arms } => {
                    self.reads(*of);
                    arms.iter().for_each(|arm| self.statements(&arm.body));
                }
                Statement::If { branches, otherwise } => {
                    for (when, body) in branches {
                        self.open.push(*when);
                        self.statements(body);
                    }
                    self.statements(otherwise);
                }
            }
        }
    }
}

/// The statements without assignments to what is dead. Recurses as deep as statements are nested.
fn swept(pool: &mut Pool, statements: Vec<Statement>, dead: &IndexVec<VarId, bool>) -> Vec<Statement> {
    let mut out: Vec<Statement> = Vec::with_capacity(statements.len());
    for statement in statements {
        match statement {
            Statement::Assign { target, .. } if dead[target] => {}
            Statement::Case { of, mut arms } => {
                for arm in &mut arms {
                    arm.body = swept(pool, std::mem::take(&mut arm.body), dead);
                }
                arms.retain(|arm| !arm.body.is_empty());
                if !arms.is_empty() {
                    out.push(Statement::Case { of, arms });
                }
            }
            Statement::If { branches, otherwise } => {
                let swept_branches = branches.into_iter().map(|(when, body)| (when, swept(pool, body, dead))).collect();
                let otherwise = swept(pool, otherwise, dead);
                out.extend(without_empty_branches(pool, swept_branches, otherwise));
            }
            Statement::Heading(_)
            | Statement::Assign { .. }
            | Statement::Divide { .. }
            | Statement::CallTimer { .. } => out.push(statement),
        }
    }
    // A heading over nothing goes too: what follows it is another one, or the end.
    let mut after_is_statement = false;
    let mut kept: Vec<Statement> = Vec::with_capacity(out.len());
    for statement in out.into_iter().rev() {
        let is_heading = matches!(statement, Statement::Heading(_));
        if !is_heading || after_is_statement {
            kept.push(statement);
        }
        after_is_statement = !is_heading;
    }
    kept.reverse();
    kept
}

/// An `If` whose branches all do something: what comes after a branch that does nothing happens where that is not taken.
fn without_empty_branches(
    pool: &mut Pool,
    branches: Vec<(FormulaId, Vec<Statement>)>,
    otherwise: Vec<Statement>,
) -> Option<Statement> {
    let mut kept = Vec::with_capacity(branches.len());
    let mut not_taken: Vec<FormulaId> = Vec::new();
    for (when, body) in branches {
        if body.is_empty() {
            not_taken.push(pool.not(when));
        } else {
            kept.push((pool.and(not_taken.iter().copied().chain([when])), body));
        }
    }
    if otherwise.is_empty() || not_taken.is_empty() {
        return (!kept.is_empty()).then_some(Statement::If { branches: kept, otherwise });
    }
    kept.push((pool.and(not_taken), otherwise));
    Some(Statement::If { branches: kept, otherwise: Vec::new() })
}

/// Takes the dead variables out of the table, and formulas that nothing uses out of the pool.
fn renumber(program: &mut Program, dead: &IndexVec<VarId, bool>) {
    let mut new: IndexVec<VarId, VarId> = program.variables.indices().collect();
    let mut table = IndexVec::with_capacity(program.variables.len());
    for (old, variable) in std::mem::take(&mut program.variables).into_iter_enumerated() {
        if !dead[old] {
            new[old] = table.push(variable);
        }
    }
    program.variables = table;
    for state in &mut program.states {
        state.variable = new[state.variable];
        state.copies.retain(|v| !dead[*v]);
        state.copies.iter_mut().for_each(|v| *v = new[*v]);
    }
    for preset in program.timers.iter_mut().filter_map(|timer| timer.preset.as_mut()) {
        preset.constant = preset.constant.map(|v| new[v]);
    }
    if let Some(repeat) = &mut program.repeat {
        repeat.again = new[repeat.again];
        if let Some(limit) = &mut repeat.limit {
            limit.count = new[limit.count];
        }
    }
    let mut roots: Vec<FormulaId> = program.steps.iter().map(|step| step.active).collect();
    let Program { first, before, micro_step, after, .. } = program;
    for section in [first, before, micro_step, after] {
        visit(section, &mut |v| *v = new[*v], &mut |f| roots.push(*f));
    }
    let (pool, formulas) = program.pool.compacted(roots, &new);
    program.pool = pool;
    let Program { first, before, micro_step, after, .. } = program;
    for section in [first, before, micro_step, after] {
        visit(section, &mut |_| (), &mut |f| *f = formulas[f]);
    }
    program.steps.iter_mut().for_each(|step| step.active = formulas[&step.active]);
}

/// Every variable that statements name themselves, and every formula that they hold.
fn visit(statements: &mut [Statement], variable: &mut dyn FnMut(&mut VarId), formula: &mut dyn FnMut(&mut FormulaId)) {
    for statement in statements {
        match statement {
            Statement::Heading(_) => {}
            Statement::Assign { target, value, .. } => {
                variable(target);
                formula(value);
            }
            Statement::Divide { target, dividend, divisor, flag, .. } => {
                variable(target);
                variable(flag);
                formula(dividend);
                formula(divisor);
            }
            Statement::CallTimer { input, .. } => formula(input),
            Statement::Case { of, arms } => {
                variable(of);
                arms.iter_mut().for_each(|arm| visit(&mut arm.body, variable, formula));
            }
            Statement::If { branches, otherwise } => {
                for (when, body) in branches {
                    formula(when);
                    visit(body, variable, formula);
                }
                visit(otherwise, variable, formula);
            }
        }
    }
}
