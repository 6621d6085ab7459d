//! Values that live within one scan: in which parts of it each is used, for targets that write the parts apart.

use grafc_formula::{Formula, FormulaId};
use grafc_logic::scan::{Choice, Division, Program, Role, Statement, VarId};
use rustc_hash::FxHashMap;

/// The parts of a scan: once before the micro-steps, a micro-step, once after them; and what gives memory back.
pub(crate) const PARTS: usize = 4;

/// The statements of each part, in the order of [`PARTS`].
pub(crate) fn parts(program: &Program) -> [Vec<&[Statement]>; PARTS] {
    let restoring = program.restoring.as_ref().map_or(&[][..], |restoring| &restoring.statements);
    [vec![&program.first, &program.before], vec![&program.micro_step], vec![&program.after], vec![restoring]]
}

/// What is done with a temporary.
#[derive(Clone, Copy, Default)]
pub(crate) struct Uses {
    /// In which parts.
    pub(crate) parts: [bool; PARTS],
    /// How often it is written.
    written: u32,
    /// Whether it is written inside of another statement.
    within: bool,
}

impl Uses {
    /// Whether its value goes from one part to another.
    pub(crate) fn crosses(self) -> bool {
        self.parts.iter().filter(|part| **part).count() > 1
    }

    /// Whether it is written once, in every run of its part.
    pub(crate) fn is_constant(self) -> bool {
        self.written == 1 && !self.within
    }
}

/// What is done with temporaries.
pub(crate) fn temporaries(program: &Program) -> FxHashMap<VarId, Uses> {
    let mut walk = Walk { program, part: 0, uses: FxHashMap::default(), seen: vec![PARTS; program.pool.len()] };
    for (part, sections) in parts(program).into_iter().enumerate() {
        walk.part = part;
        sections.into_iter().for_each(|section| walk.block(section, false));
    }
    if let Some(repeat) = program.repeat {
        (walk.part) = 1;
        walk.touch(repeat.again);
        if let Some(limit) = repeat.limit {
            walk.touch(limit.count);
            walk.part = 0;
            walk.touch(limit.count);
        }
    }
    walk.uses
}

struct Walk<'p> {
    program: &'p Program,
    part: usize,
    uses: FxHashMap<VarId, Uses>,
    /// The part in which each formula was met last.
    seen: Vec<usize>,
}

impl Walk<'_> {
    fn touch(&mut self, v: VarId) {
        if self.program.variables[v].role == Role::Temporary {
            self.uses.entry(v).or_default().parts[self.part] = true;
        }
    }

    fn write(&mut self, v: VarId, within: bool) {
        self.touch(v);
        if let Some(uses) = self.uses.get_mut(&v) {
            uses.written += 1;
            uses.within |= within;
        }
    }

    fn formula(&mut self, root: FormulaId) {
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut self.seen[id.index()], self.part) == self.part {
                continue;
            }
            if let Formula::Variable(v) = self.program.pool.get(id) {
                self.touch(*v);
            }
            open.extend(self.program.pool.operands(id));
        }
    }

    /// Statements nest no deeper than lowering nests them.
    fn block(&mut self, statements: &[Statement], within: bool) {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    self.write(*target, within);
                    self.formula(*value);
                }
                Statement::Divide(Division { target, dividend, divisor, .. }) => {
                    // Under a guard.
                    self.write(*target, true);
                    self.formula(*dividend);
                    self.formula(*divisor);
                }
                Statement::CallTimer { input, .. } => self.formula(*input),
                Statement::Case { of, arms } => {
                    self.touch(*of);
                    arms.iter().for_each(|arm| self.block(&arm.body, true));
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    for (when, body) in branches {
                        self.formula(*when);
                        self.block(body, true);
                    }
                    self.block(otherwise, true);
                }
            }
        }
    }
}
