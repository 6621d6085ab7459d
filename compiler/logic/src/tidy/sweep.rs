//! Leaves out what nothing reads: assignments to temporaries whose value is not needed any more, and temporaries that
//! then have no use.
//!
//! Some are made before it is known whether they will be needed: the mark that something clears, whether a grafcet is
//! frozen, an edge in a condition that another formula makes superfluous. What is read later is found backwards from the
//! end of the call; the loop is gone through until nothing new is found.

use crate::scan::{Choice, Division, Held, Program, Role, Statement, VarId};
use grafc_formula::{Formula, FormulaId, Pool};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

#[cfg(test)]
mod tests;

/// Sweeps a program.
pub(crate) fn sweep(program: &mut Program) {
    let variables = program.variables.iter();
    let mut needed = Needed {
        temporary: variables.map(|v| v.role == Role::Temporary).collect(),
        is: program.variables.iter().map(|_| false).collect(),
        changes: Vec::new(),
        read: Reads::default(),
    };
    let Program { first, before, micro_step, after, restoring, pool, repeat, .. } = program;
    if let Some(restoring) = restoring {
        needed.go_back(pool, &mut restoring.statements, true);
        needed.is.iter_mut().for_each(|needed| *needed = false);
        needed.changes.clear();
    }
    needed.go_back(pool, after, true);
    if let Some(repeat) = repeat {
        // What is needed at the end of the loop: what follows, which is what `is` says now, and what the next micro-step
        // reads.
        loop {
            needed.is[repeat.again] = true;
            let at_end = needed.is.clone();
            needed.go_back(pool, micro_step, false);
            let more = needed.is.iter_enumerated().any(|(v, needed)| *needed && !at_end[v]);
            let at_start = std::mem::replace(&mut needed.is, at_end);
            if !more {
                break;
            }
            needed.is.iter_mut_enumerated().filter(|(v, _)| at_start[*v]).for_each(|(_, needed)| *needed = true);
        }
    }
    needed.go_back(pool, micro_step, true);
    needed.go_back(pool, before, true);
    needed.go_back(pool, first, true);
    let used = used(program);
    let is_dead = |v: VarId| program.variables[v].role == Role::Temporary && !used[v];
    let dead: IndexVec<VarId, bool> = program.variables.indices().map(is_dead).collect();
    if dead.iter().any(|dead| *dead) {
        renumber(program, &dead);
    }
}

/// Which temporaries are read later, at the place that has been reached.
struct Needed {
    temporary: IndexVec<VarId, bool>,
    is: IndexVec<VarId, bool>,
    /// What has changed, and what it was before: to go back to the end of an `If` for its next branch.
    changes: Vec<(VarId, bool)>,
    read: Reads,
}

/// Which formulas read temporaries.
#[derive(Default)]
struct Reads {
    /// Of each formula that was there when this was last asked.
    any: Vec<bool>,
    /// The number of the last walk that came by a formula, and that of the walk now.
    seen: Vec<u32>,
    walk: u32,
    stack: Vec<FormulaId>,
}

impl Reads {
    /// Looks at what has come into the pool. Operands come first, and formulas are only added.
    fn know(&mut self, pool: &Pool, temporary: &IndexVec<VarId, bool>) {
        self.any.reserve(pool.len() - self.any.len());
        for new in (self.any.len()..pool.len()).map(FormulaId::from_usize) {
            let reads = match pool.get(new) {
                Formula::Variable(v) => temporary[*v],
                _ => pool.operands(new).any(|operand| self.any[operand.index()]),
            };
            self.any.push(reads);
        }
        self.seen.resize(pool.len(), 0);
    }
}

impl Needed {
    fn set(&mut self, v: VarId, value: bool) {
        let old = std::mem::replace(&mut self.is[v], value);
        if old != value {
            self.changes.push((v, old));
        }
    }

    fn reads(&mut self, pool: &Pool, id: FormulaId) {
        if self.read.any.len() < pool.len() {
            self.read.know(pool, &self.temporary);
        }
        if !self.read.any[id.index()] {
            return;
        }
        self.read.walk += 1;
        let mut stack = std::mem::take(&mut self.read.stack);
        stack.push(id);
        while let Some(id) = stack.pop() {
            let seen = std::mem::replace(&mut self.read.seen[id.index()], self.read.walk) == self.read.walk;
            if seen || !self.read.any[id.index()] {
                continue;
            }
            match pool.get(id) {
                Formula::Variable(v) => self.set(*v, true),
                _ => stack.extend(pool.operands(id)),
            }
        }
        self.read.stack = stack;
    }

    /// From the end of statements to their start; the last time, assignments that nobody needs are taken out. Recurses as
    /// deep as statements are nested, which the encodings bound.
    fn go_back(&mut self, pool: &mut Pool, statements: &mut Vec<Statement>, take_out: bool) {
        // The places of what goes, the last first, and whether a heading here would be over nothing: what follows it is
        // another one, or the end.
        let (mut gone, mut over_nothing) = (Vec::new(), true);
        for (place, statement) in statements.iter_mut().enumerate().rev() {
            let is_needed = match statement {
                Statement::Heading(_) => !over_nothing,
                _ => self.pass(pool, statement, take_out),
            };
            if is_needed {
                over_nothing = matches!(statement, Statement::Heading(_));
            } else if take_out {
                gone.push(place);
            }
        }
        if gone.is_empty() {
            return;
        }
        let mut places = 0..;
        statements.retain(|_| {
            let goes = gone.last().copied() == places.next();
            if goes {
                gone.pop();
            }
            !goes
        });
    }

    /// From the end of a statement to its start; whether it is needed.
    fn pass(&mut self, pool: &mut Pool, statement: &mut Statement, take_out: bool) -> bool {
        match statement {
            Statement::Heading(_) => {}
            Statement::Assign { target, value, .. } => {
                if self.temporary[*target] {
                    if !self.is[*target] {
                        return false;
                    }
                    self.set(*target, false);
                }
                self.reads(pool, *value);
            }
            // It may raise a flag, so it stays.
            Statement::Divide(Division { target, dividend, divisor, .. }) => {
                self.set(*target, false);
                self.reads(pool, *dividend);
                self.reads(pool, *divisor);
            }
            Statement::CallTimer { input, .. } => self.reads(pool, *input),
            Statement::Case { of, arms } => {
                let nothing = &mut Vec::new();
                let bodies = arms.iter_mut().map(|arm| &mut arm.body).chain([nothing]);
                self.branches(pool, bodies, take_out);
                if take_out {
                    arms.retain(|arm| !arm.body.is_empty());
                    if arms.is_empty() {
                        return false;
                    }
                }
                if self.temporary[*of] {
                    self.set(*of, true);
                }
            }
            Statement::If(choice) => {
                let Choice { branches, otherwise } = &mut **choice;
                let bodies = branches.iter_mut().map(|(_, body)| body).chain([&mut *otherwise]);
                self.branches(pool, bodies, take_out);
                if take_out {
                    match without_empty_branches(pool, std::mem::take(branches), std::mem::take(otherwise)) {
                        Some(rest) => *statement = rest,
                        None => return false,
                    }
                }
                if let Statement::If(choice) = statement {
                    choice.branches.iter().for_each(|(when, _)| self.reads(pool, *when));
                }
            }
        }
        true
    }

    /// Several ways to one end: needed before them is what is needed on any.
    fn branches<'s>(&mut self, pool: &mut Pool, bodies: impl Iterator<Item = &'s mut Vec<Statement>>, take_out: bool) {
        let start = self.changes.len();
        let mut count = 0;
        // Of each variable that a way changes, on how many ways it is needed, and on how many it changes.
        let mut touched: FxHashMap<VarId, (usize, usize)> = FxHashMap::default();
        for body in bodies {
            count += 1;
            self.go_back(pool, body, take_out);
            let changed: FxHashSet<VarId> = self.changes[start..].iter().map(|(v, _)| *v).collect();
            for v in changed {
                let entry = touched.entry(v).or_default();
                entry.0 += usize::from(self.is[v]);
                entry.1 += 1;
            }
            while self.changes.len() > start {
                if let Some((v, old)) = self.changes.pop() {
                    self.is[v] = old;
                }
            }
        }
        for (v, (needed, changed)) in touched {
            let on_another = changed < count && self.is[v];
            self.set(v, needed > 0 || on_another);
        }
    }
}

/// Which variables something reads.
fn used(program: &Program) -> IndexVec<VarId, bool> {
    let mut used: IndexVec<VarId, bool> = program.variables.iter().map(|_| false).collect();
    let mut roots: Vec<FormulaId> = program.steps.iter().map(|step| step.active).collect();
    if let Some(repeat) = program.repeat {
        used[repeat.again] = true;
        repeat.limit.iter().for_each(|limit| used[limit.count] = true);
    }
    for section in program.sections() {
        collect(section, &mut roots, &mut used);
    }
    let mut seen = vec![false; program.pool.len()];
    while let Some(id) = roots.pop() {
        if std::mem::replace(&mut seen[id.index()], true) {
            continue;
        }
        if let Formula::Variable(v) = program.pool.get(id) {
            used[*v] = true;
        }
        roots.extend(program.pool.operands(id));
    }
    used
}

/// The formulas of statements, and the variables that they need beside these: what a `Case` asks, where a quotient goes.
fn collect(statements: &[Statement], roots: &mut Vec<FormulaId>, used: &mut IndexVec<VarId, bool>) {
    for statement in statements {
        match statement {
            Statement::Heading(_) => {}
            Statement::Assign { value, .. } => roots.push(*value),
            Statement::Divide(Division { target, dividend, divisor, .. }) => {
                used[*target] = true;
                roots.extend([*dividend, *divisor]);
            }
            Statement::CallTimer { input, .. } => roots.push(*input),
            Statement::Case { of, arms } => {
                used[*of] = true;
                arms.iter().for_each(|arm| collect(&arm.body, roots, used));
            }
            Statement::If(choice) => {
                let Choice { branches, otherwise } = &**choice;
                for (when, body) in branches {
                    roots.push(*when);
                    collect(body, roots, used);
                }
                collect(otherwise, roots, used);
            }
        }
    }
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
        return (!kept.is_empty()).then_some(Statement::choice(kept, otherwise));
    }
    kept.push((pool.and(not_taken), otherwise));
    Some(Statement::choice(kept, Vec::new()))
}

/// Takes the dead variables out of the table, and formulas that nothing uses out of the pool.
fn renumber(program: &mut Program, dead: &IndexVec<VarId, bool>) {
    let mut new: IndexVec<VarId, VarId> = program.variables.indices().collect();
    let (mut kept, mut old) = (0, 0..);
    program.variables.raw.retain(|_| {
        let id = VarId::from_usize(old.next().unwrap_or_default());
        new[id] = VarId::from_usize(kept);
        kept += usize::from(!dead[id]);
        !dead[id]
    });
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
            limit.flag = new[limit.flag];
        }
    }
    program.started = program.started.map(|v| new[v]);
    if let Some(observing) = &mut program.observing {
        observing.each_variable(|v| *v = new[*v]);
    }
    program.assertion = program.assertion.map(|v| new[v]);
    for variable in program.claims.iter_mut().flat_map(|claim| claim.variables()) {
        *variable = new[*variable];
    }
    for step in &mut program.steps {
        if let Held::Bit(v) = &mut step.held {
            *v = new[*v];
        }
    }
    let mut roots: Vec<FormulaId> = program.steps.iter().map(|step| step.active).collect();
    let Program { first, before, micro_step, after, restoring, .. } = program;
    let restored = restoring.iter_mut().map(|restoring| &mut restoring.statements);
    for section in [first, before, micro_step, after].into_iter().chain(restored) {
        visit(section, &mut |v| *v = new[*v], &mut |f| roots.push(*f));
    }
    let (pool, formulas) = program.pool.compacted(roots, &new);
    program.pool = pool;
    let Program { first, before, micro_step, after, restoring, .. } = program;
    let restored = restoring.iter_mut().map(|restoring| &mut restoring.statements);
    for section in [first, before, micro_step, after].into_iter().chain(restored) {
        visit(section, &mut |_| (), &mut |f| *f = formulas[*f]);
    }
    program.steps.iter_mut().for_each(|step| step.active = formulas[step.active]);
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
            Statement::Divide(Division { target, dividend, divisor, flag, .. }) => {
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
            Statement::If(choice) => {
                let Choice { branches, otherwise } = &mut **choice;
                for (when, body) in branches {
                    formula(when);
                    visit(body, variable, formula);
                }
                visit(otherwise, variable, formula);
            }
        }
    }
}
