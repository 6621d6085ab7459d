//! Where local variables are declared: as deep inside as can be, and with their first value if that is certain.
//!
//! A temporary of the scan program becomes a `let` in the innermost block that holds all its uses. If the first of them
//! is an assignment right there, the `let` is that assignment; else it comes before the first statement that has to do
//! with it, with the zero of its type.

use grafc_logic::formula::{Formula, FormulaId};
use grafc_logic::scan::{Program, Role, Statement, VarId};
use rustc_hash::FxHashMap;

/// The block of the whole function.
pub(super) const ROOT: usize = 0;

/// The declarations of one program.
#[derive(Default)]
pub(super) struct Locals {
    /// Variables to be declared before a statement, by block and place in it.
    before: FxHashMap<(usize, usize), Vec<VarId>>,
    /// For each variable that is declared by an assignment, the place of that.
    with: FxHashMap<VarId, (usize, usize)>,
    /// How often each is written.
    writes: FxHashMap<VarId, usize>,
}

impl Locals {
    /// Finds all declarations. The statements of the loop, if there is one, are a block in that of the function.
    pub fn new(program: &Program) -> Self {
        let mut finder = Finder {
            program,
            blocks: vec![Block::default()],
            found: FxHashMap::default(),
            writes: FxHashMap::default(),
            read: FxHashMap::default(),
        };
        let mut place = finder.sequence(ROOT, 0, &program.first);
        place = finder.sequence(ROOT, place, &program.before);
        match program.repeat {
            None => place = finder.sequence(ROOT, place, &program.micro_step),
            Some(repeat) => {
                let inside = finder.block(ROOT, place);
                let end = finder.sequence(inside, 0, &program.micro_step);
                finder.reads(inside, end, repeat.again);
                if let Some(limit) = repeat.limit {
                    // It counts from call to call of the loop.
                    finder.uses(ROOT, place, limit.count, false);
                    *finder.writes.entry(limit.count).or_default() += 2;
                }
                place += 1;
            }
        }
        finder.sequence(ROOT, place, &program.after);
        finder.locals()
    }

    /// The variables to be declared before a statement.
    pub fn before(&self, block: usize, place: usize) -> &[VarId] {
        self.before.get(&(block, place)).map_or(&[], Vec::as_slice)
    }

    /// Whether the assignment at a place declares its target.
    pub fn with(&self, block: usize, place: usize, target: VarId) -> bool {
        self.with.get(&target) == Some(&(block, place))
    }

    /// Whether a variable is written after its declaration.
    pub fn is_mutable(&self, target: VarId) -> bool {
        let declared_by_assignment = usize::from(self.with.contains_key(&target));
        self.writes.get(&target).copied().unwrap_or_default() > declared_by_assignment
    }
}

/// A block of statements.
#[derive(Clone, Copy, Default)]
struct Block {
    parent: usize,
    /// The place of the statement in the parent that holds it.
    place: usize,
    depth: usize,
}

/// The innermost block of all uses so far.
struct Found {
    block: usize,
    /// The statement there in which the first use is.
    place: usize,
    /// Whether that is an assignment of the variable in that very block.
    assigned: bool,
}

struct Finder<'p> {
    program: &'p Program,
    blocks: Vec<Block>,
    found: FxHashMap<VarId, Found>,
    writes: FxHashMap<VarId, usize>,
    /// The temporaries that a formula reads.
    read: FxHashMap<FormulaId, Vec<VarId>>,
}

impl Finder<'_> {
    /// A new block in a statement of another.
    fn block(&mut self, parent: usize, place: usize) -> usize {
        self.blocks.push(Block { parent, place, depth: self.blocks[parent].depth + 1 });
        self.blocks.len() - 1
    }

    /// Statements from a place of a block on; returns the place after them. Blocks are numbered in the order in which
    /// they are written.
    fn sequence(&mut self, block: usize, start: usize, statements: &[Statement]) -> usize {
        for (offset, statement) in statements.iter().enumerate() {
            let place = start + offset;
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    self.formula(block, place, *value);
                    self.written(block, place, *target);
                }
                Statement::Divide { target, dividend, divisor, .. } => {
                    self.formula(block, place, *dividend);
                    self.formula(block, place, *divisor);
                    self.written(block, place, *target);
                }
                Statement::CallTimer { input, .. } => self.formula(block, place, *input),
                Statement::Case { of, arms } => {
                    self.reads(block, place, *of);
                    for arm in arms {
                        let inside = self.block(block, place);
                        self.sequence(inside, 0, &arm.body);
                    }
                }
                Statement::If { branches, otherwise } => {
                    for (when, body) in branches {
                        self.formula(block, place, *when);
                        let inside = self.block(block, place);
                        self.sequence(inside, 0, body);
                    }
                    let inside = self.block(block, place);
                    self.sequence(inside, 0, otherwise);
                }
            }
        }
        start + statements.len()
    }

    fn formula(&mut self, block: usize, place: usize, id: FormulaId) {
        let read = match self.read.remove(&id) {
            Some(known) => known,
            None => {
                let pool = &self.program.pool;
                let variables = pool.below(id).into_iter().filter_map(|f| match pool.get(f) {
                    Formula::Variable(v) => Some(*v),
                    _ => None,
                });
                variables.filter(|v| self.program.variables[*v].role == Role::Temporary).collect()
            }
        };
        for v in &read {
            self.reads(block, place, *v);
        }
        self.read.insert(id, read);
    }

    fn reads(&mut self, block: usize, place: usize, v: VarId) {
        self.uses(block, place, v, false);
    }

    fn written(&mut self, block: usize, place: usize, v: VarId) {
        *self.writes.entry(v).or_default() += 1;
        self.uses(block, place, v, true);
    }

    fn uses(&mut self, mut block: usize, mut place: usize, v: VarId, assigned: bool) {
        if self.program.variables[v].role != Role::Temporary {
            return;
        }
        let Some(found) = self.found.get_mut(&v) else {
            self.found.insert(v, Found { block, place, assigned });
            return;
        };
        while found.block != block {
            let (known, new) = (self.blocks[found.block], self.blocks[block]);
            if known.depth >= new.depth {
                (found.block, found.place, found.assigned) = (known.parent, known.place, false);
            }
            if new.depth >= known.depth {
                (block, place) = (new.parent, new.place);
            }
        }
        // Uses come in order, so the first one stays the first.
        found.place = found.place.min(place);
    }

    fn locals(self) -> Locals {
        let mut locals = Locals { writes: self.writes, ..Locals::default() };
        let mut found: Vec<(VarId, Found)> = self.found.into_iter().collect();
        found.sort_unstable_by_key(|(v, _)| *v);
        for (v, found) in found {
            if found.assigned {
                locals.with.insert(v, (found.block, found.place));
            } else {
                locals.before.entry((found.block, found.place)).or_default().push(v);
            }
        }
        locals
    }
}
