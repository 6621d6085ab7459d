//! Scan programs built by hand, for tests of the writer.

mod matiec;
mod writer;

use grafc_diagnostics::Span;
use grafc_formula::{Arithmetic, Comparison, FormulaId, Pool, Type, Value};
use grafc_logic::scan::{
    Arm, Elements, Flag, Heading, Held, Limit, Origin, Preset, Program, Repeat, Role, State, Statement, Step, StepId,
    Timer, TimerId, Told, VarId, Variable,
};
use index_vec::IndexVec;

/// A program under construction.
pub(crate) struct Build {
    pub(crate) program: Program,
}

impl Build {
    pub(crate) fn new(name: &str) -> Self {
        let program = Program {
            name: name.to_owned(),
            comment: None,
            variables: IndexVec::new(),
            timers: IndexVec::new(),
            pool: Pool::default(),
            steps: IndexVec::new(),
            states: Vec::new(),
            elements: Elements::default(),
            first: Vec::new(),
            started: None,
            before: Vec::new(),
            micro_step: Vec::new(),
            repeat: None,
            most: 1,
            after: Vec::new(),
            restoring: None,
            observing: None,
            claims: Vec::new(),
            assertion: None,
        };
        Build { program }
    }

    pub(crate) fn var(&mut self, role: Role, name: &str, ty: Type) -> VarId {
        self.program.variables.push(Variable::new(role, name, ty))
    }

    pub(crate) fn bit(&mut self, role: Role, name: &str) -> VarId {
        self.var(role, name, Type::Bool)
    }

    pub(crate) fn about(&mut self, id: VarId, comment: &str) -> VarId {
        self.program.variables[id].comment = Some(comment.into());
        id
    }

    pub(crate) fn timer(&mut self, name: &str, preset: Option<Preset>, comment: &str) -> TimerId {
        self.program.timers.push(Timer { name: name.to_owned(), preset, comment: Some(comment.into()) })
    }

    /// A variable that holds the given steps, and the one that it takes its next value from.
    pub(crate) fn state(&mut self, name: &str, idle: Option<i64>, values: &[i64]) -> (VarId, VarId) {
        let variable = self.var(Role::State, &format!("at_{name}"), Type::Int);
        let next = self.var(Role::Memory, &format!("next_{name}"), Type::Int);
        let mut values_held = Vec::new();
        for value in values {
            let active = self.is(variable, *value);
            let label = value.to_string().into();
            let held = Held::State(self.program.states.len(), *value);
            let step = Step { label, comment: None, span: Span::default(), held, active };
            values_held.push((self.program.steps.push(step), *value));
        }
        self.program.states.push(State { variable, idle, values: values_held, copies: vec![next] });
        (variable, next)
    }

    /// `variable = value`.
    pub(crate) fn is(&mut self, variable: VarId, value: i64) -> FormulaId {
        let (read, value) = (self.read(variable), self.pool().constant(Value::Int(value), Type::Int));
        self.pool().compare(Comparison::Equal, read, value)
    }

    /// `target := value`.
    pub(crate) fn set(&mut self, target: VarId, value: i64) -> Statement {
        assign(target, self.program.pool.constant(Value::Int(value), Type::Int))
    }

    pub(crate) fn read(&mut self, id: VarId) -> FormulaId {
        self.program.pool.variable(id, self.program.variables[id].ty)
    }

    /// `target := value`, beside which stands a transition: `5, 8 -> 9: comment`.
    pub(crate) fn noted(&mut self, target: VarId, value: FormulaId, transition: &str) -> Statement {
        let (arrow, comment) = transition.split_once(": ").map_or((transition, None), |(a, text)| (a, Some(text)));
        let (before, after) = arrow.split_once("->").expect("an arrow");
        let [before, after] = [before, after].map(|labels| {
            let labels = labels.split(',').map(str::trim).filter(|label| !label.is_empty());
            labels.map(|label| self.step(label)).collect::<Vec<StepId>>()
        });
        let comment = comment.map(Into::into);
        let t = self.program.elements.transition(None, comment, Span::default(), &before, &after);
        Statement::Assign { target, value, origin: Origin::Transition(t), told: Told::All }
    }

    /// What is done at values, beside which stand steps: `step 5: comment`, or nothing.
    pub(crate) fn case<const N: usize>(&mut self, of: VarId, arms: [(i64, &str, Vec<Statement>); N]) -> Statement {
        let arm = |(value, step, body): (i64, &str, Vec<Statement>)| {
            let Some(step) = step.strip_prefix("step ") else {
                return Arm { value, origin: Origin::Chart, told: Told::Nothing, body };
            };
            let (label, comment) = step.split_once(": ").map_or((step, None), |(label, text)| (label, Some(text)));
            let s = self.step(label);
            self.program.steps[s].comment = comment.map(Into::into);
            Arm { value, origin: Origin::Step(s), told: Told::All, body }
        };
        Statement::Case { of, arms: arms.map(arm).into() }
    }

    /// The step of a label, made if need be.
    fn step(&mut self, label: &str) -> StepId {
        let steps = &mut self.program.steps;
        steps.iter_enumerated().find(|(_, step)| step.label == label).map(|(s, _)| s).unwrap_or_else(|| {
            let (held, active) = (Held::Bit(VarId::new(0)), self.program.pool.truth(false));
            steps.push(Step { label: label.into(), comment: None, span: Span::default(), held, active })
        })
    }

    pub(crate) fn pool(&mut self) -> &mut Pool {
        &mut self.program.pool
    }
}

pub(crate) fn assign(target: VarId, value: FormulaId) -> Statement {
    Statement::assign(Origin::Chart, target, value)
}

pub(crate) fn when(condition: FormulaId, body: Vec<Statement>) -> Statement {
    Statement::when(condition, body)
}

/// Brings a timer up to date.
pub(crate) fn call(timer: TimerId, input: FormulaId) -> Statement {
    Statement::CallTimer { timer, input, origin: Origin::Chart }
}

pub(crate) fn heading(of: Heading) -> Statement {
    Statement::Heading(of)
}

/// Four steps: ready, fill, stir for a time, empty.
pub(crate) fn four_steps() -> Program {
    let mut b = Build::new("Filling");
    b.program.comment = Some("filling and stirring a tank".into());
    let start = b.bit(Role::Input, "start");
    b.about(start, "start button");
    let level = ["high", "low"].map(|name| b.bit(Role::Input, name));
    b.program.variables[start].address = Some("%ix0.0".into());
    let inlet = b.bit(Role::Output, "INLET");
    b.program.variables[inlet].address = Some("%QX0.0".into());
    b.about(inlet, "inlet valve");
    let stirrer = b.bit(Role::Output, "STIRRER");
    let outlet = b.bit(Role::Output, "OUTLET");
    let batches = b.var(Role::Internal, "batches", Type::Int);
    b.about(batches, "how often the tank was filled");
    let stir_time = b.var(Role::Constant, "stir_time", Type::Time);
    b.program.variables[stir_time].set_initial(Value::Time(8000));
    let steps: Vec<VarId> = (1..=4).map(|n| b.bit(Role::Step, &format!("X{n}"))).collect();
    b.about(steps[0], "ready");
    b.about(steps[1], "fill");
    b.program.variables[steps[0]].set_initial(Value::Bool(true));
    let livelock = b.bit(Role::Flag(Flag::Livelock), "LIVELOCK");
    b.about(livelock, "the situation did not become stable");
    let started = b.bit(Role::Memory, "started");
    b.program.started = Some(started);
    let old_start = b.bit(Role::Memory, "old_start");
    let clear: Vec<VarId> = (1..=4).map(|n| b.bit(Role::Temporary, &format!("clear_{n}"))).collect();
    let next: Vec<VarId> = (1..=4).map(|n| b.bit(Role::Temporary, &format!("next_{n}"))).collect();
    let again = b.bit(Role::Temporary, "again");
    let count = b.var(Role::Temporary, "micro_steps", Type::Uint);
    let stirred = b.timer("stirred", Some(Preset { ms: 8000, constant: Some(stir_time) }), "stir_time/X3");

    let x: Vec<FormulaId> = steps.iter().map(|step| b.read(*step)).collect();
    let n: Vec<FormulaId> = next.iter().map(|step| b.read(*step)).collect();
    let c: Vec<FormulaId> = clear.iter().map(|step| b.read(*step)).collect();
    let yes = b.pool().truth(true);
    let (cs, old, high, low) = (b.read(start), b.read(old_start), b.read(level[0]), b.read(level[1]));
    let not_started = b.read(started);
    let not_started = b.pool().not(not_started);
    b.program.first = vec![Statement::choice(
        vec![(not_started, vec![heading(Heading::MemoryOfEdges), assign(started, yes), assign(old_start, cs)])],
        vec![],
    )];
    let not_old = b.pool().not(old);
    let rise = b.pool().and([x[0], cs, not_old]);
    let filled = b.pool().and([x[1], high]);
    let done = b.pool().timer_done(stirred);
    let stir = b.pool().and([x[2], done]);
    let not_low = b.pool().not(low);
    let emptied = b.pool().and([x[3], not_low]);
    let mut body = vec![heading(Heading::Conditions), call(stirred, x[2])];
    body.push(heading(Heading::TransitionsThatClear));
    body.push(b.noted(clear[0], rise, "1 -> 2: ↑start"));
    body.push(b.noted(clear[1], filled, "2 -> 3: high"));
    body.push(b.noted(clear[2], stir, "3 -> 4: stir_time/X3"));
    body.push(b.noted(clear[3], emptied, "4 -> 1: not low"));
    body.push(heading(Heading::NextSituation));
    for i in 0..4 {
        let off = b.pool().not(c[i]);
        let stay = b.pool().and([x[i], off]);
        let value = b.pool().or([c[(i + 3) % 4], stay]);
        body.push(assign(next[i], value));
    }
    let changes: Vec<FormulaId> = (0..4).map(|i| b.pool().xor(n[i], x[i])).collect();
    let edge = b.pool().xor(cs, old);
    let any = b.pool().or(changes.into_iter().chain([edge]));
    body.push(assign(again, any));
    body.push(heading(Heading::StoredActions));
    let (one, total) = (b.pool().constant(Value::Int(1), Type::Int), b.read(batches));
    let more = b.pool().arithmetic(Arithmetic::Add, Type::Int, total, one);
    body.push(Statement::when(c[1], vec![b.noted(batches, more, "2 -> 3: on clearing")]));
    body.push(heading(Heading::Situation));
    body.extend((0..4).map(|i| assign(steps[i], n[i])));
    body.push(assign(old_start, cs));
    b.program.micro_step = body;
    b.program.repeat = Some(Repeat { again, limit: Some(Limit { count, bound: 200, flag: livelock }) });
    b.program.after = vec![
        heading(Heading::Outputs),
        assign(inlet, x[1]),
        assign(stirrer, x[2]),
        b.noted(outlet, x[3], "4 ->: until empty"),
    ];
    b.program
}

/// Two steps, the second of which encloses two others: `a` runs it, `b` moves on in it, and `y` shows its last step.
pub(crate) fn nested() -> Program {
    let mut b = Build::new("Nested");
    let (in_a, in_b) = (b.bit(Role::Input, "a"), b.bit(Role::Input, "b"));
    let y = b.bit(Role::Output, "y");
    let (at_g, next_g) = b.state("G", None, &[-1, 2]);
    let (at_h, next_h) = b.state("H", Some(0), &[21, 22]);
    let started = b.bit(Role::Memory, "started");
    b.program.started = Some(started);
    let moved = b.bit(Role::Temporary, "moved");

    let (a, on) = (b.read(in_a), b.read(in_b));
    let off = b.pool().not(a);
    let (yes, no) = (b.pool().truth(true), b.pool().truth(false));
    let not_started = b.read(started);
    let not_started = b.pool().not(not_started);
    let start = vec![assign(started, yes), b.set(at_g, -1), b.set(next_g, -1)];
    b.program.first = vec![when(not_started, start)];

    let run = when(a, vec![b.set(next_g, 2), assign(moved, yes)]);
    let stop = when(off, vec![b.set(next_g, -1), assign(moved, yes)]);
    let last = b.pool().constant(Value::Int(22), Type::Int);
    let go_on = when(on, vec![b.noted(next_h, last, "21 -> 22"), assign(moved, yes)]);
    let inner = b.case(at_h, [(21, "step 21: first", vec![go_on])]);
    let outer = b.case(at_g, [(-1, "step -1: ready", vec![run]), (2, "step 2: running", vec![stop, inner])]);
    let (now_g, then_g, then_h) = (b.read(at_g), b.read(next_g), b.read(next_h));
    let moves = b.pool().differs(then_g, now_g);
    let (empty, enter) = (b.set(next_h, 0), b.set(next_h, 21));
    let enclosed = vec![b.case(at_g, [(2, "step 2: running", vec![empty])]), b.case(next_g, [(2, "", vec![enter])])];
    let again = b.read(moved);
    b.program.micro_step = vec![
        heading(Heading::Transitions),
        assign(moved, no),
        outer,
        when(again, vec![when(moves, enclosed), assign(at_g, then_g), assign(at_h, then_h)]),
    ];
    b.program.repeat = Some(Repeat { again: moved, limit: None });
    let shown = b.is(at_h, 22);
    b.program.after = vec![assign(y, shown)];
    b.program
}

/// States nested in states, each with one arm; in the innermost a long formula of `and` and `not` in turn.
pub(crate) fn nested_deeply(levels: usize, operators: usize) -> Program {
    let mut b = Build::new("Deep");
    let (in_a, in_b, y) = (b.bit(Role::Input, "a"), b.bit(Role::Input, "b"), b.bit(Role::Output, "y"));
    let (a, on) = (b.read(in_a), b.read(in_b));
    let mut value = a;
    for _ in 0..operators / 2 {
        let both = b.pool().and([value, on]);
        value = b.pool().not(both);
    }
    let mut body = vec![when(a, vec![assign(y, value)])];
    for level in 0..levels {
        let (at, next) = b.state(&format!("G{level}"), Some(0), &[3]);
        body.push(assign(next, b.program.pool.constant(Value::Int(3), Type::Int)));
        body = vec![b.case(at, [(3, "step 3", body)])];
    }
    b.program.micro_step = body;
    b.program
}

/// A program of inputs `a`, `b`, …, one output `y`, and statements from a function.
pub(crate) fn body(
    inputs: &[(&str, Type)],
    y: Type,
    build: impl FnOnce(&mut Build, &[FormulaId], VarId) -> Vec<Statement>,
) -> Program {
    let mut b = Build::new("Body");
    let ids: Vec<VarId> = inputs.iter().map(|(name, ty)| b.var(Role::Input, name, *ty)).collect();
    let y = b.var(Role::Output, "y", y);
    let read: Vec<FormulaId> = ids.iter().map(|id| b.read(*id)).collect();
    b.program.after = vec![heading(Heading::Outputs)];
    let statements = build(&mut b, &read, y);
    b.program.after.extend(statements);
    b.program
}
