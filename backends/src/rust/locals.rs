//! Where local variables are declared: as deep inside as can be, and with their first value if that is certain.
//!
//! A temporary of the scan program becomes a `let` in the innermost block that holds all its uses. If the first of them
//! is an assignment right there, the `let` is that assignment. Else, if each part of the block gives it a value before
//! reading it, it is a variable of its own in each part. Else it comes before the first statement that has to do with it,
//! with the zero of its type.

use super::code::Code;
use grafc_formula::{Formula, FormulaId};
use grafc_logic::scan::{Division, Program, Role, Statement, VarId};
use rustc_hash::{FxHashMap, FxHashSet};

/// The block of the whole function.
pub(super) const ROOT: usize = 0;

/// The declarations of one program.
#[derive(Default)]
pub(super) struct Locals {
    /// Variables to be declared before a statement, by block and place in it.
    before: FxHashMap<(usize, usize), Vec<VarId>>,
    /// Assignments that declare their target, and whether it is written again.
    with: FxHashMap<(VarId, usize, usize), bool>,
    /// Quotients that nothing reads: they may raise a flag.
    unread: FxHashSet<VarId>,
}

impl Locals {
    /// Finds all declarations of a function; what is shared with others, which stands here in order, is declared
    /// elsewhere.
    pub fn new(program: &Program, code: &[Code], shared: &[VarId]) -> Self {
        let mut finder = Finder {
            program,
            blocks: vec![StatementBlock::default()],
            uses: FxHashMap::default(),
            read: FxHashMap::default(),
        };
        finder.code(ROOT, code);
        finder.uses.retain(|v, _| shared.binary_search(v).is_err());
        finder.locals()
    }

    /// The variables to be declared before a statement.
    pub fn before(&self, block: usize, place: usize) -> &[VarId] {
        self.before.get(&(block, place)).map_or(&[], Vec::as_slice)
    }

    /// Whether the assignment at a place declares its target, and if so, whether that is written again.
    pub fn with(&self, block: usize, place: usize, target: VarId) -> Option<bool> {
        self.with.get(&(target, block, place)).copied()
    }

    /// Whether nothing reads a variable.
    pub fn is_unread(&self, target: VarId) -> bool {
        self.unread.contains(&target)
    }
}

/// A block of statements.
#[derive(Clone, Copy, Default)]
struct StatementBlock {
    parent: usize,
    /// The place of the statement in the parent that holds it.
    place: usize,
    depth: usize,
}

/// One use of a variable.
#[derive(Clone, Copy)]
struct Use {
    block: usize,
    place: usize,
    /// Whether it is written, not read.
    assigned: bool,
}

struct Finder<'p> {
    program: &'p Program,
    blocks: Vec<StatementBlock>,
    /// In the order of the text; reading comes before writing.
    uses: FxHashMap<VarId, Vec<Use>>,
    /// The temporaries that a formula reads.
    read: FxHashMap<FormulaId, Vec<VarId>>,
}

impl Finder<'_> {
    /// A new block in a statement of another.
    fn block(&mut self, parent: usize, place: usize) -> usize {
        self.blocks.push(StatementBlock { parent, place, depth: self.blocks[parent].depth + 1 });
        self.blocks.len() - 1
    }

    /// The code of a block. Blocks are numbered in the order in which they are written.
    fn code(&mut self, block: usize, code: &[Code]) {
        for (place, code) in code.iter().enumerate() {
            match code {
                Code::Plain(statement) => self.statement(block, place, statement),
                // The limit counts from one micro-step to the next.
                Code::Loop(_) => {
                    if let Some(limit) = self.program.repeat.and_then(|repeat| repeat.limit) {
                        self.uses(block, place, limit.count, false);
                    }
                }
                Code::Again(again) => self.uses(block, place, *again, false),
                Code::Call(_) => {}
                Code::If(choice) => {
                    for (when, body) in &choice.branches {
                        self.formula(block, place, *when);
                        let inside = self.block(block, place);
                        self.code(inside, body);
                    }
                    let inside = self.block(block, place);
                    self.code(inside, &choice.otherwise);
                }
                Code::Arms(of, arms) => {
                    self.uses(block, place, *of, false);
                    for (_, body) in arms {
                        let inside = self.block(block, place);
                        self.code(inside, body);
                    }
                }
                Code::Table(of, _) => self.uses(block, place, *of, false),
            }
        }
    }

    fn statements(&mut self, block: usize, place: usize, statements: &[Statement]) {
        let inside = self.block(block, place);
        for (place, statement) in statements.iter().enumerate() {
            self.statement(inside, place, statement);
        }
    }

    fn statement(&mut self, block: usize, place: usize, statement: &Statement) {
        match statement {
            Statement::Heading(_) => {}
            Statement::Assign { target, value, .. } => {
                self.formula(block, place, *value);
                self.uses(block, place, *target, true);
            }
            Statement::Divide(Division { target, dividend, divisor, .. }) => {
                self.formula(block, place, *dividend);
                self.formula(block, place, *divisor);
                self.uses(block, place, *target, true);
            }
            Statement::CallTimer { input, .. } => self.formula(block, place, *input),
            Statement::Case { of, arms } => {
                self.uses(block, place, *of, false);
                arms.iter().for_each(|arm| self.statements(block, place, &arm.body));
            }
            Statement::If(choice) => {
                for (when, body) in &choice.branches {
                    self.formula(block, place, *when);
                    self.statements(block, place, body);
                }
                self.statements(block, place, &choice.otherwise);
            }
        }
    }

    fn formula(&mut self, block: usize, place: usize, id: FormulaId) {
        let Finder { program, uses, read, .. } = self;
        let pool = &program.pool;
        let read = read.entry(id).or_insert_with(|| {
            let variables = pool.below(id).into_iter().filter_map(|f| match pool.get(f) {
                Formula::Variable(v) => Some(*v),
                _ => None,
            });
            variables.filter(|v| program.variables[*v].role == Role::Temporary).collect()
        });
        for v in read {
            uses.entry(*v).or_default().push(Use { block, place, assigned: false });
        }
    }

    fn uses(&mut self, block: usize, place: usize, v: VarId, assigned: bool) {
        if self.program.variables[v].role == Role::Temporary {
            self.uses.entry(v).or_default().push(Use { block, place, assigned });
        }
    }

    fn locals(mut self) -> Locals {
        let mut locals = Locals::default();
        let mut all: Vec<(VarId, Vec<Use>)> = std::mem::take(&mut self.uses).into_iter().collect();
        all.sort_unstable_by_key(|(v, _)| *v);
        for (v, uses) in all {
            if uses.iter().all(|u| u.assigned) {
                locals.unread.insert(v);
            }
            let mut declarations = Vec::new();
            if self.declare(ROOT, &uses, &mut declarations) {
                locals.with.extend(declarations.into_iter().map(|(u, again)| ((v, u.block, u.place), again)));
            } else {
                let (block, place) = self.innermost(&uses);
                locals.before.entry((block, place)).or_default().push(v);
            }
        }
        locals
    }

    /// Finds the assignments that declare a variable of which these are all uses within a block. False if some use may
    /// read a value that none of them gives.
    fn declare(&self, block: usize, uses: &[Use], declarations: &mut Vec<(Use, bool)>) -> bool {
        let Some(first) = uses.first() else { return true };
        if first.block == block {
            let writes = uses.iter().filter(|u| u.assigned).count();
            declarations.push((*first, writes > 1));
            return first.assigned;
        }
        // Each inner block must do for itself.
        let mut rest = uses;
        while let Some(first) = rest.first() {
            if first.block == block {
                return false;
            }
            let inside = self.inside(block, first.block);
            let end = rest.iter().position(|u| u.block == block || self.inside(block, u.block) != inside);
            let (own, others) = rest.split_at(end.unwrap_or(rest.len()));
            if !self.declare(inside, own, declarations) {
                return false;
            }
            rest = others;
        }
        true
    }

    /// The block right inside another that holds a third.
    fn inside(&self, outer: usize, mut inner: usize) -> usize {
        while self.blocks[inner].parent != outer {
            inner = self.blocks[inner].parent;
        }
        inner
    }

    /// The innermost block that holds all uses, and the place of the first one in it.
    fn innermost(&self, uses: &[Use]) -> (usize, usize) {
        let mut found = uses.first().map_or((ROOT, 0), |u| (u.block, u.place));
        for u in uses {
            let (mut block, mut place) = (u.block, u.place);
            while found.0 != block {
                let (known, new) = (self.blocks[found.0], self.blocks[block]);
                if known.depth >= new.depth {
                    found = (known.parent, known.place);
                }
                if new.depth >= known.depth {
                    (block, place) = (new.parent, new.place);
                }
            }
            // Uses come in order, so the first one stays the first.
            found.1 = found.1.min(place);
        }
        found
    }
}
