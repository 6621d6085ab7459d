//! Writing in place: each block of statements after all others that read what it writes.
//!
//! A micro-step computes everything from the old situation. Copying all of it first would be right and wasteful; here
//! the blocks are put in such an order that a variable is written only once everyone has read it. Where the order goes
//! round in a circle, the variable is copied before it is written, and those that have yet to read it read the copy.

use crate::lower::Lowering;
use crate::scan::{Choice, Origin, Role, Statement, VarId};
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
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
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

/// Which blocks have to wait for which, kept up to date block by block: all in all, what it takes is in proportion to what
/// the blocks read and write.
struct Waiting<'a> {
    blocks: &'a [Bundle],
    /// For each variable the blocks that have yet to read it.
    readers: BTreeMap<VarId, BTreeSet<usize>>,
    /// For each variable the blocks that write it, in order.
    writers: BTreeMap<VarId, Vec<usize>>,
    /// For each block how many of the variables that it writes others have yet to read.
    awaited: Vec<usize>,
    /// The blocks that are not written yet.
    all: BTreeSet<usize>,
    /// Those of them that nothing has to come before.
    ready: BTreeSet<usize>,
}

impl<'a> Waiting<'a> {
    fn new(blocks: &'a [Bundle]) -> Self {
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
        let all = (0..blocks.len()).collect();
        let mut waiting = Waiting { blocks, readers, writers, awaited: Vec::new(), all, ready: BTreeSet::new() };
        let awaited =
            |(index, block): (usize, &Bundle)| block.writes.iter().filter(|v| waiting.is_awaited(**v, index)).count();
        waiting.awaited = blocks.iter().enumerate().map(awaited).collect();
        waiting.ready = waiting.all.iter().copied().filter(|index| waiting.awaited[*index] == 0).collect();
        waiting
    }

    /// Whether a block other than this one has yet to read the variable.
    fn is_awaited(&self, v: VarId, index: usize) -> bool {
        self.readers.get(&v).is_some_and(|set| set.len() > usize::from(set.contains(&index)))
    }

    /// The next block: the first that is ready; else the first of all, in which case some of what it writes is awaited.
    fn take(&mut self) -> Option<usize> {
        let index = self.ready.pop_first().or_else(|| self.all.first().copied())?;
        self.all.remove(&index);
        Some(index)
    }

    /// A block has read what it reads.
    fn has_read(&mut self, index: usize) {
        for v in &self.blocks[index].reads {
            let Some(set) = self.readers.get_mut(v) else { continue };
            set.remove(&index);
            match set.len() {
                0 => self.release(*v, Some(index)),
                // The last one to read it may be the one to write it.
                1 => {
                    let last = set.first().copied().unwrap_or_default();
                    if self.writers.get(v).is_some_and(|list| list.binary_search(&last).is_ok()) {
                        self.less(last);
                    }
                }
                _ => {}
            }
        }
    }

    /// Those that have yet to read the variable read a copy.
    fn is_copied(&mut self, v: VarId) {
        if let Some(set) = self.readers.remove(&v) {
            let alone = set.first().copied().filter(|_| set.len() == 1);
            self.release(v, alone);
        }
    }

    /// Nobody has yet to read the variable. The one that was the last to do so has not waited for itself.
    fn release(&mut self, v: VarId, last: Option<usize>) {
        let writers = self.writers.get(&v).cloned().unwrap_or_default();
        writers.into_iter().filter(|writer| Some(*writer) != last).for_each(|writer| self.less(writer));
    }

    /// One variable less to wait for.
    fn less(&mut self, writer: usize) {
        self.awaited[writer] -= 1;
        if self.awaited[writer] == 0 && self.all.contains(&writer) {
            self.ready.insert(writer);
        }
    }
}

/// The statements of all blocks, in an order in which they do together what each does alone.
pub(super) fn in_order(lowering: &mut Lowering, blocks: Vec<Bundle>, out: &mut Vec<Statement>) {
    let mut waiting = Waiting::new(&blocks);
    let mut copies = Copies::default();
    while let Some(index) = waiting.take() {
        let block = &blocks[index];
        waiting.has_read(index);
        let mut fresh = Vec::new();
        for v in block.writes.iter().copied().filter(|v| waiting.is_awaited(*v, index)).collect::<Vec<_>>() {
            let variable = &lowering.symbols.table[v];
            let (name, ty) = (format!("was_{}", variable.name), variable.ty);
            let copy = lowering.symbols.fresh(Role::Temporary, name, ty, None);
            lowering.situation.kept_in(v, copy);
            let value = lowering.symbols.read(&mut lowering.pool, v);
            let origin = lowering.situation.step_of(v).map_or(Origin::Chart, Origin::Step);
            out.push(Statement::assign(origin, copy, value));
            fresh.push((v, copy));
            waiting.is_copied(v);
        }
        // The block itself comes first and reads the variable.
        let mut statements = block.statements.clone();
        if !copies.of.is_empty() {
            redirect(lowering, &copies, &mut statements);
        }
        out.extend(statements);
        for (v, copy) in fresh {
            copies.of.insert(v, copy);
            copies.read.insert(v, lowering.symbols.read(&mut lowering.pool, copy));
        }
    }
}

/// The copies that are read from now on.
#[derive(Default)]
struct Copies {
    /// Of each variable that has one.
    of: FxHashMap<VarId, VarId>,
    /// The same as formulas.
    read: FxHashMap<VarId, FormulaId>,
}

/// The statements, reading copies.
fn redirect(lowering: &mut Lowering, copies: &Copies, statements: &mut [Statement]) {
    for statement in statements {
        match statement {
            Statement::Heading(_) | Statement::Divide(_) => {}
            Statement::Assign { value, .. } => *value = lowering.pool.substitute(*value, &copies.read),
            Statement::CallTimer { input, .. } => *input = lowering.pool.substitute(*input, &copies.read),
            Statement::Case { of, arms } => {
                *of = copies.of.get(of).copied().unwrap_or(*of);
                arms.iter_mut().for_each(|arm| redirect(lowering, copies, &mut arm.body));
            }
            Statement::If(choice) => {
                let Choice { branches, otherwise } = &mut **choice;
                for (when, body) in branches {
                    *when = lowering.pool.substitute(*when, &copies.read);
                    redirect(lowering, copies, body);
                }
                redirect(lowering, copies, otherwise);
            }
        }
    }
}
