//! Writing in place: each block of statements after all others that read what it writes.
//!
//! A micro-step computes everything from the old situation. Copying all of it first would be right and wasteful; here
//! the blocks are put in such an order that a variable is written only once everyone has read it. Where the order goes
//! round in a circle, the variable is copied before it is written, and those that have yet to read it read the copy.

use crate::lower::Lowering;
use crate::scan::{Origin, Role, Statement, VarId};
use grafc_formula::{Formula, FormulaId};
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet};

/// Statements that belong together, and what they touch of the variables that the blocks write: those of the situation,
/// and outputs that are written with it.
pub(super) struct Bundle {
    pub(super) statements: Vec<Statement>,
    reads: BTreeSet<VarId>,
    writes: BTreeSet<VarId>,
}

impl Bundle {
    /// Looks for what the statements read and write of these variables.
    pub(super) fn new(lowering: &Lowering, statements: Vec<Statement>, of_interest: impl Fn(VarId) -> bool) -> Self {
        let mut block = Bundle { statements: Vec::new(), reads: BTreeSet::new(), writes: BTreeSet::new() };
        block.look(lowering, &statements, &of_interest);
        block.statements = statements;
        block
    }

    /// Statements nest no deeper than lowering nests them.
    fn look(&mut self, lowering: &Lowering, statements: &[Statement], of_interest: &impl Fn(VarId) -> bool) {
        let reads = |block: &mut Bundle, root: FormulaId| {
            for f in lowering.pool.below(root) {
                if let Formula::Variable(v) = lowering.pool.get(f)
                    && of_interest(*v)
                {
                    block.reads.insert(*v);
                }
            }
        };
        for statement in statements {
            match statement {
                Statement::Heading(_) | Statement::Divide(_) => {}
                Statement::Assign { target, value, .. } => {
                    reads(self, *value);
                    if of_interest(*target) {
                        self.writes.insert(*target);
                    }
                }
                Statement::CallTimer { input, .. } => reads(self, *input),
                Statement::Case { of, arms } => {
                    if of_interest(*of) {
                        self.reads.insert(*of);
                    }
                    arms.iter().for_each(|arm| self.look(lowering, &arm.body, of_interest));
                }
                Statement::If { branches, otherwise } => {
                    for (when, body) in branches {
                        reads(self, *when);
                        self.look(lowering, body, of_interest);
                    }
                    self.look(lowering, otherwise, of_interest);
                }
            }
        }
    }
}

/// The statements of all blocks, in an order in which they do together what each does alone.
pub(super) fn in_order(lowering: &mut Lowering, blocks: Vec<Bundle>, out: &mut Vec<Statement>) {
    // For each variable the blocks that have yet to read it, and those that write it.
    let mut readers: BTreeMap<VarId, BTreeSet<usize>> = BTreeMap::new();
    let mut writers: BTreeMap<VarId, Vec<usize>> = BTreeMap::new();
    for (index, block) in blocks.iter().enumerate() {
        for v in &block.reads {
            readers.entry(*v).or_default().insert(index);
        }
        for v in &block.writes {
            writers.entry(*v).or_default().push(index);
        }
    }
    // What a block writes and others have yet to read.
    let awaited = |readers: &BTreeMap<VarId, BTreeSet<usize>>, index: usize| -> Vec<VarId> {
        let others = |v: &&VarId| readers.get(v).is_some_and(|set| set.iter().any(|reader| *reader != index));
        blocks[index].writes.iter().filter(others).copied().collect()
    };
    let mut waiting: BTreeSet<usize> = (0..blocks.len()).collect();
    let mut ready: BTreeSet<usize> = waiting.iter().copied().filter(|i| awaited(&readers, *i).is_empty()).collect();
    let mut copies: FxHashMap<VarId, VarId> = FxHashMap::default();
    while let Some(first) = waiting.first().copied() {
        let index = ready.pop_first().unwrap_or(first);
        waiting.remove(&index);
        let block = &blocks[index];
        let mut read: Vec<VarId> = block.reads.iter().copied().collect();
        for v in &read {
            if let Some(set) = readers.get_mut(v) {
                set.remove(&index);
            }
        }
        let mut fresh = Vec::new();
        for v in awaited(&readers, index) {
            let variable = &lowering.symbols.table[v];
            let (name, ty) = (format!("was_{}", variable.name), variable.ty);
            let copy = lowering.symbols.fresh(Role::Temporary, name, ty, None);
            lowering.situation.kept_in(v, copy);
            let value = lowering.symbols.read(&mut lowering.pool, v);
            let origin = lowering.situation.step_of(v).map_or(Origin::Chart, Origin::Step);
            out.push(Statement::assign(origin, copy, value));
            fresh.push((v, copy));
            readers.remove(&v);
            read.push(v);
        }
        // The block itself comes first and reads the variable.
        out.extend(redirected(lowering, &copies, block.statements.clone()));
        copies.extend(fresh);
        for writer in read.iter().filter_map(|v| writers.get(v)).flatten() {
            if waiting.contains(writer) && awaited(&readers, *writer).is_empty() {
                ready.insert(*writer);
            }
        }
    }
}

/// The statements, reading copies.
fn redirected(
    lowering: &mut Lowering,
    copies: &FxHashMap<VarId, VarId>,
    mut statements: Vec<Statement>,
) -> Vec<Statement> {
    if !copies.is_empty() {
        let mut by: FxHashMap<VarId, FormulaId> = FxHashMap::default();
        for (v, copy) in copies {
            by.insert(*v, lowering.symbols.read(&mut lowering.pool, *copy));
        }
        redirect(lowering, copies, &by, &mut statements);
    }
    statements
}

fn redirect(
    lowering: &mut Lowering,
    copies: &FxHashMap<VarId, VarId>,
    by: &FxHashMap<VarId, FormulaId>,
    statements: &mut [Statement],
) {
    for statement in statements {
        match statement {
            Statement::Heading(_) | Statement::Divide(_) => {}
            Statement::Assign { value, .. } => *value = lowering.pool.substitute(*value, by),
            Statement::CallTimer { input, .. } => *input = lowering.pool.substitute(*input, by),
            Statement::Case { of, arms } => {
                *of = copies.get(of).copied().unwrap_or(*of);
                arms.iter_mut().for_each(|arm| redirect(lowering, copies, by, &mut arm.body));
            }
            Statement::If { branches, otherwise } => {
                for (when, body) in branches {
                    *when = lowering.pool.substitute(*when, by);
                    redirect(lowering, copies, by, body);
                }
                redirect(lowering, copies, by, otherwise);
            }
        }
    }
}
