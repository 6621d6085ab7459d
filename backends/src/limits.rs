//! What must hold before a program is written. A breach is a fault of grafc, not of the chart.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_formula::{Formula, FormulaId, Value};
use grafc_logic::scan::{Choice, Division, Program, Statement, VarId, is_empty};

/// MATIEC takes 150 nested parentheses; a reader takes far fewer.
const DEEPEST_FORMULA: u32 = 100;
/// Shared formulas are written out at each use; more than this is a lack of temporaries.
const LARGEST_FORMULA: u32 = 1_000_000;
/// Nested `If` and `Case` statements: what is bounded here may recurse. MATIEC takes 36 nested `CASE`; the nesting of
/// states in `logic` ends before that.
const DEEPEST_BLOCK: u32 = 100;

/// Checks a whole program.
pub(crate) fn check(program: &Program) -> Result<(), Diagnostics> {
    let mut check = Check { program, sizes: sizes(program), diagnostics: Diagnostics::new() };
    for block in program.sections() {
        check.block(block, 0);
    }
    if program.repeat.is_some_and(|repeat| repeat.limit.is_none()) && is_empty(&program.micro_step) {
        check.fault(None, "the stability loop is empty");
    }
    for (id, variable) in program.variables.iter_enumerated() {
        if matches!(variable.initial(), Value::Real(x) if !x.is_finite()) {
            check.fault(Some(id), "an initial value is not a number");
        }
    }
    if check.diagnostics.has_errors() { Err(check.diagnostics) } else { Ok(()) }
}

/// For each formula, how deep and how large it is when written out.
pub(crate) fn sizes(program: &Program) -> Vec<(u32, u32)> {
    let mut sizes: Vec<(u32, u32)> = Vec::with_capacity(program.pool.len());
    for id in program.pool.ids() {
        let below = program.pool.operands(id).map(|operand| sizes[operand.index()]);
        let (depth, size) =
            below.fold((0, 1), |(depth, size): (u32, u32), (d, s)| (depth.max(d + 1), size.saturating_add(s)));
        sizes.push((depth, size));
    }
    sizes
}

struct Check<'p> {
    program: &'p Program,
    sizes: Vec<(u32, u32)>,
    diagnostics: Diagnostics,
}

impl Check<'_> {
    fn fault(&mut self, at: Option<VarId>, what: &str) {
        let span = at.and_then(|id| self.program.variables[id].span).unwrap_or_default();
        self.diagnostics.push(
            Diagnostic::new(Code::E0901, span, format!("internal error: {what}"))
                .note("no code can be written from this scan program"),
        );
    }

    fn formula(&mut self, at: Option<VarId>, id: FormulaId) {
        let (depth, size) = self.sizes[id.index()];
        if depth > DEEPEST_FORMULA {
            self.fault(at, "a formula is nested too deeply");
        } else if size > LARGEST_FORMULA {
            self.fault(at, "a formula is too large");
        }
        if matches!(self.program.pool.get(id), Formula::Constant(Value::Real(x)) if !x.is_finite()) {
            self.fault(at, "a constant is not a number");
        }
    }

    fn body(&mut self, statements: &[Statement], depth: u32) {
        if is_empty(statements) {
            self.fault(None, "a branch is empty");
        }
        self.block(statements, depth);
    }

    fn block(&mut self, statements: &[Statement], depth: u32) {
        if depth > DEEPEST_BLOCK {
            return self.fault(None, "statements are nested too deeply");
        }
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => self.formula(Some(*target), *value),
                Statement::Divide(Division { target, dividend, divisor, .. }) => {
                    self.formula(Some(*target), *dividend);
                    self.formula(Some(*target), *divisor);
                }
                Statement::CallTimer { input, .. } => self.formula(None, *input),
                Statement::Case { of, arms } => {
                    if arms.is_empty() {
                        self.fault(Some(*of), "a choice has no arms");
                    }
                    for arm in arms {
                        self.body(&arm.body, depth + 1);
                    }
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    for (condition, body) in branches {
                        self.formula(None, *condition);
                        self.body(body, depth + 1);
                    }
                    self.block(otherwise, depth + 1);
                }
            }
        }
    }
}
