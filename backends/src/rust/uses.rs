//! What the functions of a scan use, and so have to be given.

use super::code::{Code, Needs};
use super::places::Places;
use grafc_formula::{Formula, FormulaId};
use grafc_logic::scan::{Division, Program, Role, Statement, VarId};
use rustc_hash::{FxHashMap, FxHashSet};

/// What a function uses itself.
pub(super) struct Uses<'p> {
    program: &'p Program,
    places: &'p Places<'p>,
    pub needs: Needs,
    pub temporaries: FxHashSet<VarId>,
    pub calls: Vec<usize>,
    pub tables: Vec<usize>,
    seen: FxHashSet<FormulaId>,
}

impl<'p> Uses<'p> {
    /// Reads the code of a function.
    pub fn of(program: &'p Program, places: &'p Places<'p>, code: &[Code]) -> Self {
        let mut uses = Uses {
            program,
            places,
            needs: Needs::default(),
            temporaries: FxHashSet::default(),
            calls: Vec::new(),
            tables: Vec::new(),
            seen: FxHashSet::default(),
        };
        uses.all(code);
        uses.seen = FxHashSet::default();
        uses
    }

    fn all(&mut self, code: &[Code]) {
        for code in code {
            match code {
                Code::Plain(statement) => self.statement(statement),
                Code::Loop(function) => {
                    let limit = self.program.repeat.and_then(|repeat| repeat.limit);
                    limit.iter().for_each(|limit| self.variable(limit.count));
                    self.calls.push(*function);
                }
                Code::Again(again) => self.variable(*again),
                Code::Call(function) => self.calls.push(*function),
                Code::If(choice) => {
                    for (when, body) in &choice.branches {
                        self.formula(*when);
                        self.all(body);
                    }
                    self.all(&choice.otherwise);
                }
                Code::Arms(of, arms) => {
                    self.variable(*of);
                    arms.iter().for_each(|(_, body)| self.all(body));
                }
                Code::Table(of, table) => {
                    self.variable(*of);
                    self.tables.push(*table);
                }
            }
        }
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Heading(_) => {}
            Statement::Assign { target, value, .. } => {
                self.variable(*target);
                self.formula(*value);
            }
            Statement::Divide(Division { target, dividend, divisor, .. }) => {
                self.variable(*target);
                self.formula(*dividend);
                self.formula(*divisor);
            }
            Statement::CallTimer { input, .. } => {
                self.needs.now = true;
                self.formula(*input);
            }
            Statement::Case { of, arms } => {
                self.variable(*of);
                arms.iter().flat_map(|arm| &arm.body).for_each(|statement| self.statement(statement));
            }
            Statement::If(choice) => {
                for (when, body) in &choice.branches {
                    self.formula(*when);
                    body.iter().for_each(|statement| self.statement(statement));
                }
                choice.otherwise.iter().for_each(|statement| self.statement(statement));
            }
        }
    }

    fn formula(&mut self, id: FormulaId) {
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            if !self.seen.insert(id) {
                continue;
            }
            if let Formula::Variable(v) = self.program.pool.get(id) {
                self.variable(*v);
            }
            open.extend(self.program.pool.operands(id));
        }
    }

    fn variable(&mut self, v: VarId) {
        match self.program.variables[v].role {
            Role::Input => self.needs.inputs = true,
            Role::Temporary => {
                self.temporaries.insert(v);
            }
            Role::Step => self.needs.steps |= self.places.packed(v).is_some(),
            Role::Output
            | Role::Internal
            | Role::Constant
            | Role::State
            | Role::Flag(_)
            | Role::Memory
            | Role::Observed => {}
        }
    }
}

/// The temporaries that more than one function uses.
pub(super) fn shared(program: &Program, uses: &[Uses]) -> Vec<VarId> {
    let mut counts: FxHashMap<VarId, usize> = FxHashMap::default();
    for v in uses.iter().flat_map(|uses| &uses.temporaries) {
        *counts.entry(*v).or_default() += 1;
    }
    program.variables.indices().filter(|v| counts.get(v).is_some_and(|count| *count > 1)).collect()
}
