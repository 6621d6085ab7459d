//! What a scan program takes: memory, statements, and instructions of a machine with one accumulator.
//!
//! Encodings are compared by the evolution: variables and statements of the initial reaction and the counter of the
//! stability loop are left out, inputs, outputs, flags and variables of the chart are the same for all. Instructions
//! are counted as an instruction list of IEC 61131-3 would hold them (Shalyto, chapter 12, counts alike):
//!
//! ```text
//! X1 := clr_3 OR (X1 AND NOT clr_1);          LD X1  ANDN clr_1  OR clr_3  ST X1          4
//! IF X1 AND a THEN X1 := FALSE; X2 := TRUE    LD X1  AND a  R X1  S X2                    4
//! ```
//!
//! All rules are in `docs/statistics.md`; a change here is a change there.

use crate::scan::{Division, Program, Role, Statement, VarId};
use grafc_formula::{Formula, FormulaId, Pool, Type};
use index_vec::IndexVec;

/// What the evolution of a program takes.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Measure {
    /// Steps with a bit of their own.
    pub state_bits: usize,
    /// How many values each multi-valued variable has, the idle one included.
    pub states: Vec<usize>,
    /// Boolean variables of ours that the evolution uses: memory and temporaries.
    pub auxiliary_bits: usize,
    /// The same with a number, a time or a real in them.
    pub auxiliary_numbers: usize,
    /// Timers.
    pub timers: usize,
    /// Statements, nested ones too, without headings.
    pub statements: u64,
    /// Instructions.
    pub instructions: u64,
}

/// Measures a program.
pub fn measure(program: &Program) -> Measure {
    let mut tally = Tally {
        program,
        loads: loads(&program.pool),
        seen: vec![false; program.pool.len()],
        used: program.variables.iter().map(|_| false).collect(),
        statements: 0,
    };
    let sections = [&program.before, &program.micro_step, &program.after];
    let instructions = sections.map(|section| tally.section(section)).into_iter().fold(0, u64::saturating_add);
    let count = |wanted: &dyn Fn(VarId, Role, Type) -> bool| {
        program.variables.iter_enumerated().filter(|(id, v)| wanted(*id, v.role, v.ty)).count()
    };
    let auxiliary = |id, role| matches!(role, Role::Memory | Role::Temporary) && tally.used[id];
    Measure {
        state_bits: count(&|_, role, _| role == Role::Step),
        states: program.states.iter().map(|s| s.values.len() + usize::from(s.idle.is_some())).collect(),
        auxiliary_bits: count(&|id, role, ty| auxiliary(id, role) && ty == Type::Bool),
        auxiliary_numbers: count(&|id, role, ty| auxiliary(id, role) && ty != Type::Bool),
        timers: program.timers.len(),
        statements: tally.statements,
        instructions,
    }
}

/// For each formula the instructions that leave its value in the accumulator. A formula that several others share is
/// written out in each, so the numbers may grow beyond all bounds where the pool does not.
fn loads(pool: &Pool) -> Vec<u64> {
    let mut loads: Vec<u64> = Vec::with_capacity(pool.len());
    for id in pool.ids() {
        let sum = pool.operands(id).fold(0, |sum: u64, o| sum.saturating_add(loads[o.index()]));
        let nested = pool.operands(id).filter(|o| is_nested(pool, *o));
        let more = match pool.get(id) {
            Formula::Constant(_) | Formula::Variable(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) => 1,
            // LDN, ANDN, ORN; of anything longer NOT, or the N of its parenthesis.
            Formula::Not(a) => u64::from(!pool.is_leaf(*a)),
            // Operands come in any order, so one parenthesis is avoided by taking it first.
            Formula::And(_) | Formula::Or(_) | Formula::Xor(..) | Formula::Compare(..) => {
                (nested.count() as u64).saturating_sub(1)
            }
            Formula::Arithmetic(_, [_, b]) => u64::from(is_nested(pool, *b)),
            Formula::Negate(_) | Formula::Widen(_) => 1,
        };
        loads.push(sum.saturating_add(more));
    }
    loads
}

/// Whether an operand that is not taken first needs a `)` beyond what loads it.
fn is_nested(pool: &Pool, operand: FormulaId) -> bool {
    match pool.get(operand) {
        Formula::Constant(_) | Formula::Variable(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) => false,
        // In a parenthesis the NOT that was counted becomes an N and makes room for the `)`.
        Formula::Not(_) => false,
        Formula::And(_)
        | Formula::Or(_)
        | Formula::Xor(..)
        | Formula::Compare(..)
        | Formula::Arithmetic(..)
        | Formula::Negate(_)
        | Formula::Widen(_) => true,
    }
}

struct Tally<'p> {
    program: &'p Program,
    loads: Vec<u64>,
    /// Formulas whose variables are among those used.
    seen: Vec<bool>,
    used: IndexVec<VarId, bool>,
    statements: u64,
}

impl Tally<'_> {
    /// The instructions of a section.
    fn section(&mut self, statements: &[Statement]) -> u64 {
        self.body(statements, false)
    }

    /// The instructions of statements. At the start of a branch the accumulator is true, so constants are moved by one
    /// instruction that is carried out only then; after any other statement they have to be loaded as well.
    fn body(&mut self, statements: &[Statement], mut branch_taken: bool) -> u64 {
        let mut sum: u64 = 0;
        for statement in statements {
            sum = sum.saturating_add(match statement {
                Statement::Heading(_) => continue,
                Statement::Assign { target, value, .. } => {
                    self.used[*target] = true;
                    let load = self.load(*value);
                    if branch_taken && is_move(&self.program.pool, statement) { 1 } else { load.saturating_add(1) }
                }
                // IF divisor = 0 THEN flag := TRUE; target := 0; ELSE target := dividend / divisor; END_IF
                Statement::Divide(Division { target, dividend, divisor, flag, .. }) => {
                    self.used[*target] = true;
                    self.used[*flag] = true;
                    self.load(*dividend);
                    self.load(*divisor);
                    8
                }
                Statement::CallTimer { input, .. } => self.load(*input).saturating_add(2),
                Statement::Case { of, arms } => {
                    self.used[*of] = true;
                    arms.iter()
                        .fold(1, |sum: u64, arm| sum.saturating_add(1).saturating_add(self.body(&arm.body, true)))
                }
                Statement::If(choice) => self.choice(&choice.branches, &choice.otherwise),
            });
            self.statements += 1;
            branch_taken = branch_taken && is_move(&self.program.pool, statement);
        }
        sum
    }

    /// The instructions of an `IF`.
    fn choice(&mut self, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement]) -> u64 {
        let mut sum: u64 = 0;
        for (index, (when, body)) in branches.iter().enumerate() {
            let last = index + 1 == branches.len() && otherwise.is_empty();
            let moves = body.iter().all(|statement| is_move(&self.program.pool, statement));
            let jumps = u64::from(!moves) + u64::from(!last);
            sum = sum.saturating_add(self.load(*when)).saturating_add(jumps).saturating_add(self.body(body, true));
        }
        // Here every condition was found false.
        sum.saturating_add(self.body(otherwise, false))
    }

    /// The instructions that load a value; notes the variables that it reads.
    fn load(&mut self, root: FormulaId) -> u64 {
        let mut stack = vec![root];
        while let Some(id) = stack.pop() {
            if std::mem::replace(&mut self.seen[id.index()], true) {
                continue;
            }
            if let Formula::Variable(v) = self.program.pool.get(id) {
                self.used[*v] = true;
            }
            stack.extend(self.program.pool.operands(id));
        }
        self.loads[root.index()]
    }
}

/// Whether a statement gives a variable a constant, or is nothing at all.
fn is_move(pool: &Pool, statement: &Statement) -> bool {
    match statement {
        Statement::Heading(_) => true,
        Statement::Assign { value, .. } => pool.as_constant(*value).is_some(),
        Statement::Divide(_) | Statement::CallTimer { .. } | Statement::Case { .. } | Statement::If(_) => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::by_hand::{arm, assign, call, empty, variable};
    use crate::scan::{Flag, Heading, Origin, State, Timer};
    use crate::{Analysis, Encoding, Options, compile};
    use grafc_diagnostics::{Diagnostics, FileId};
    use grafc_formula::{Arithmetic, Comparison, Value};
    use grafc_model::chart::StepId;
    use grafc_model::reaction::{Evolution, Profile};

    /// Five Boolean inputs to write formulas with.
    fn bits(program: &mut Program) -> [FormulaId; 5] {
        [(); 5].map(|()| {
            let v = variable(program, Role::Input, Type::Bool);
            program.pool.variable(v, Type::Bool)
        })
    }

    #[test]
    fn formulas_are_loaded_operand_by_operand() {
        let mut program = empty();
        let [a, b, c, d, e] = bits(&mut program);
        let (m, n) = (variable(&mut program, Role::Input, Type::Dint), variable(&mut program, Role::Input, Type::Int));
        let pool = &mut program.pool;
        let (m, n) = (pool.variable(m, Type::Dint), pool.variable(n, Type::Int));
        let (yes, seven, eight) =
            (pool.truth(true), pool.constant(Value::Int(7), Type::Int), pool.constant(Value::Int(8), Type::Int));
        let (not_a, not_b) = (pool.not(a), pool.not(b));
        let (ab, cd, a_or_b, c_or_d) = (pool.and([a, b]), pool.and([c, d]), pool.or([a, b]), pool.or([c, d]));
        let neither = pool.not(a_or_b);
        let stays = pool.and([a, not_b]);
        let (at_seven, at_eight) =
            (pool.compare(Comparison::Equal, n, seven), pool.compare(Comparison::Equal, n, eight));
        let wide = pool.widen(Type::Dint, n);
        let table = [
            (a, 1, "LD a"),
            (not_a, 1, "LDN a"),
            (yes, 1, "LD TRUE"),
            (pool.or([c, stays]), 3, "LD a, ANDN b, OR c"),
            (neither, 3, "LD a, OR b, NOT"),
            (pool.and([c, neither]), 4, "LD c, ANDN( a, OR b, )"),
            (pool.and([neither, c_or_d]), 5, "LD c, OR d, ANDN( a, OR b, )"),
            (pool.or([ab, cd, e]), 6, "LD a, AND b, OR( c, AND d, ), OR e"),
            (pool.xor(e, ab), 3, "LD a, AND b, XOR e"),
            (pool.xor(cd, ab), 5, "LD c, AND d, XOR( a, AND b, )"),
            (at_seven, 2, "LD n, EQ 7"),
            (pool.and([a, at_seven]), 3, "LD n, EQ 7, AND a"),
            (pool.or([at_seven, at_eight]), 5, "LD n, EQ 7, OR( n, EQ 8, )"),
            (pool.arithmetic(Arithmetic::Add, Type::Int, n, seven), 2, "LD n, ADD 7"),
            (pool.negate(n), 2, "LD n, NEG"),
            (wide, 2, "LD n, INT_TO_DINT"),
            (pool.arithmetic(Arithmetic::Subtract, Type::Dint, wide, m), 3, "LD n, INT_TO_DINT, SUB m"),
            (pool.arithmetic(Arithmetic::Subtract, Type::Dint, m, wide), 4, "LD m, SUB( n, INT_TO_DINT, )"),
        ];
        let loads = loads(pool);
        for (formula, count, listing) in table {
            assert_eq!(loads[formula.index()], count, "{listing}");
        }
    }

    /// Statements, instructions.
    fn counts(program: &mut Program, micro_step: Vec<Statement>) -> (u64, u64) {
        program.micro_step = micro_step;
        let measure = measure(program);
        (measure.statements, measure.instructions)
    }

    #[test]
    fn branches_that_only_move_constants_need_no_jump() {
        let mut program = empty();
        let [a, b, ..] = bits(&mut program);
        let x = variable(&mut program, Role::Step, Type::Bool);
        let y = variable(&mut program, Role::Output, Type::Bool);
        let (yes, no) = (program.pool.truth(true), program.pool.truth(false));
        let moves = || vec![assign(x, no), Statement::Heading(Heading::Outputs), assign(y, yes)];
        let p = &mut program;

        // LD TRUE, ST x
        assert_eq!(counts(p, vec![assign(x, yes)]), (1, 2));
        // LD a, R x, S y
        let one = Statement::when(a, moves());
        assert_eq!(counts(p, vec![one.clone()]), (3, 3));
        // LD a, R x, S y, JMPC end, LD b, R x, S y
        let two = Statement::choice(vec![(a, moves()), (b, moves())], Vec::new());
        assert_eq!(counts(p, vec![two]), (5, 7));
        // LD a, R x, S y, JMPC end, LD b, ST y
        let other = Statement::choice(vec![(a, moves())], vec![assign(y, b)]);
        assert_eq!(counts(p, vec![other]), (4, 6));
        // LD a, JMPCN end, S x, LD b, ST y, LD FALSE, ST x
        let body = vec![assign(x, yes), assign(y, b), assign(x, no)];
        let mixed = Statement::when(a, body);
        assert_eq!(counts(p, vec![mixed]), (4, 7));
        // LD b, JMPCN next, LD a, R x, S y, JMP end, next: LD a, ST y
        let nested = Statement::choice(vec![(b, vec![one])], vec![assign(y, a)]);
        assert_eq!(counts(p, vec![nested]), (5, 8));
    }

    #[test]
    fn an_arm_is_a_comparison_that_branches() {
        let mut program = empty();
        let [a, ..] = bits(&mut program);
        let at = variable(&mut program, Role::State, Type::Int);
        let next = variable(&mut program, Role::Memory, Type::Int);
        let y = variable(&mut program, Role::Output, Type::Bool);
        program.states.push(State {
            variable: at,
            idle: Some(0),
            values: vec![(StepId::new(0), 3)],
            copies: Vec::new(),
        });
        program.states.push(State {
            variable: at,
            idle: None,
            values: vec![(StepId::new(1), 1), (StepId::new(2), 2)],
            copies: Vec::new(),
        });
        let (yes, three) = (program.pool.truth(true), program.pool.constant(Value::Int(3), Type::Int));
        let moves = Statement::when(a, vec![assign(next, three)]);
        let case = Statement::Case { of: at, arms: vec![arm(1, vec![moves]), arm(2, vec![assign(y, yes)])] };
        // LD at, 1: LD a, MOVE 3 next; 2: S y
        assert_eq!(counts(&mut program, vec![case]), (4, 1 + (1 + 2) + (1 + 1)));
        let measure = measure(&program);
        assert_eq!(measure.states, [2, 2], "one step and none, two steps");
        assert_eq!((measure.state_bits, measure.auxiliary_bits, measure.auxiliary_numbers), (0, 0, 1));
    }

    #[test]
    fn timers_and_divisions_have_their_price() {
        let mut program = empty();
        let [a, b, ..] = bits(&mut program);
        let both = program.pool.and([a, b]);
        let timer = program.timers.push(Timer { name: String::new(), preset: None, comment: None });
        // LD a, AND b, ST timer.IN, CAL timer
        let call = call(timer, both);
        assert_eq!(counts(&mut program, vec![call.clone()]), (1, 4));
        assert_eq!(measure(&program).timers, 1);

        let n = variable(&mut program, Role::Input, Type::Int);
        let (flag, target) = (
            variable(&mut program, Role::Flag(Flag::Div0), Type::Bool),
            variable(&mut program, Role::Temporary, Type::Int),
        );
        let n = program.pool.variable(n, Type::Int);
        // LD n, EQ 0, S flag, MOVE 0 target, JMPC end, LD n, DIV n, ST target
        let divide =
            Statement::Divide(Division { target, modulo: false, dividend: n, divisor: n, flag, origin: Origin::Chart });
        assert_eq!(counts(&mut program, vec![divide]), (1, 8));
        assert_eq!((measure(&program).auxiliary_bits, measure(&program).auxiliary_numbers), (0, 1), "no flags");
    }

    #[test]
    fn what_only_the_initial_reaction_uses_does_not_count() {
        let mut program = empty();
        let started = variable(&mut program, Role::Memory, Type::Bool);
        let old = variable(&mut program, Role::Memory, Type::Bool);
        let [a, ..] = bits(&mut program);
        let (is_started, was) = (program.pool.variable(started, Type::Bool), program.pool.variable(old, Type::Bool));
        let at_first = program.pool.not(is_started);
        program.first = vec![Statement::when(at_first, vec![assign(old, a)])];
        assert_eq!(measure(&program), Measure::default());
        let y = variable(&mut program, Role::Output, Type::Bool);
        program.before = vec![assign(y, a)];
        program.after = vec![assign(y, was)];
        let read = Measure { auxiliary_bits: 1, statements: 2, instructions: 4, ..Measure::default() };
        assert_eq!(measure(&program), read, "old is read, which is use enough");
    }

    fn compiled(text: &str, evolution: Evolution) -> Program {
        let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
        assert!(!diagnostics.has_errors(), "{diagnostics:?}");
        let (chart, diagnostics) = grafc_model::check(&tree, "chart");
        let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")));
        let mut diagnostics = Diagnostics::new();
        grafc_net::passes::run(&mut net, false, &mut diagnostics);
        let profile = Profile { evolution, ..Profile::default() };
        let options = Options { profile, encoding: Encoding::SinglePhase, ..Options::default() };
        compile(Analysis::new(net), &options).0
    }

    #[test]
    fn two_steps_in_a_ring() {
        let text = "input a, b : bool  output Q : bool  initial step 1  step 2 { Q }
                    transition 1 -> 2 : a  transition 2 -> 1 : not a and b";
        // clr_1 := X1 AND a              LD ST and one more     3
        // clr_2 := X2 AND NOT a AND b                           4
        // X1 := clr_2 OR X1 AND NOT clr_1                       4
        // X2 := clr_1 OR X2 AND NOT clr_2                       4
        // Q := X2                                               2
        let scan = Measure { state_bits: 2, auxiliary_bits: 2, statements: 5, instructions: 17, ..Measure::default() };
        assert_eq!(measure(&compiled(text, Evolution::Scan)), scan);
    }

    #[test]
    fn the_stability_loop_counts_by_what_it_asks_for() {
        let text = "input a, b : bool  initial step 1  step 2  step 3
                    transition 1 -> 2 : a  transition 2 -> 3 : b  transition 3 -> 1 : a";
        // As above three clearings of 3 and three steps of 4, and again := clr_1 OR clr_2 OR clr_3 of 4.
        let stable =
            Measure { state_bits: 3, auxiliary_bits: 4, statements: 7, instructions: 25, ..Measure::default() };
        assert_eq!(measure(&compiled(text, Evolution::Stable)), stable);
    }

    #[test]
    fn shared_formulas_cannot_overflow_the_count() {
        let mut program = empty();
        let [mut all, mut any, c, d, _] = bits(&mut program);
        for _ in 0..200 {
            let (left, right) = (program.pool.xor(all, any), program.pool.or([any, c]));
            all = program.pool.and([left, right]);
            any = program.pool.xor(left, d);
        }
        let y = variable(&mut program, Role::Output, Type::Bool);
        program.after = vec![assign(y, all), assign(y, any)];
        assert_eq!(measure(&program).instructions, u64::MAX);
    }
}
