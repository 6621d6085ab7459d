//! Rungs, a line each: `a /b [c | d e] -> y, S z`.

use super::rung::{Contact, End, Item, Rung, Sink, Storage};
use super::{Names, Repeated, draw, emit};
use crate::keywords::Family;
use crate::plcopen::Options;
use crate::st::tests::{Build, assign, body, call, four_steps, when};
use grafc_formula::{Arithmetic, Comparison, FormulaId, Type, Value};
use grafc_logic::scan::{Division, Flag, Origin, Preset, Program, Role, Statement, VarId};

fn rungs(program: &Program) -> Vec<Rung> {
    let mut names = Names::new(program, Family::Iec);
    let repeated = program.repeat.map(|repeat| Repeated::new(program, &mut names, repeat));
    draw(program, &mut names, repeated.as_ref()).0
}

fn lines(program: &Program) -> Vec<String> {
    rungs(program).iter().map(line).collect()
}

fn line(rung: &Rung) -> String {
    let series = |contacts: &[Contact]| {
        let spelt = contacts.iter().map(|c| format!("{}{}", if c.negated { "/" } else { "" }, c.name));
        spelt.collect::<Vec<_>>().join(" ")
    };
    let item = |item: &Item| match item {
        Item::Contact(contact) => series(std::slice::from_ref(contact)),
        Item::Group(branches) => {
            format!("[{}]", branches.iter().map(|branch| series(branch)).collect::<Vec<_>>().join(" | "))
        }
    };
    let end = match &rung.end {
        End::Coils(coils) => {
            let spelt = coils.iter().map(|coil| match coil.storage {
                Storage::Plain => coil.name.to_string(),
                Storage::Set => format!("S {}", coil.name),
                Storage::Reset => format!("R {}", coil.name),
            });
            spelt.collect::<Vec<_>>().join(", ")
        }
        End::Block(block) => {
            let inputs = block.inputs.iter().map(|(pin, text)| format!(", {pin} = {text}")).collect::<String>();
            let outputs = block.outputs.iter().filter_map(|(pin, sink)| match sink {
                Sink::Open | Sink::Rail => None,
                Sink::Coil(name) | Sink::Variable(name) => Some(format!(" {pin} -> {name}")),
            });
            let name = block.instance.as_ref().map(|name| format!(" {name}")).unwrap_or_default();
            format!("{}{name}({}{inputs}){}", block.kind, block.power, outputs.collect::<String>())
        }
    };
    let items: Vec<String> = rung.items.iter().map(item).collect();
    format!("{} -> {end}", items.join(" ")).trim_start().to_owned()
}

const BITS: [(&str, Type); 5] =
    [("a", Type::Bool), ("b", Type::Bool), ("c", Type::Bool), ("d", Type::Bool), ("e", Type::Bool)];

/// The rungs of `y := value`.
fn check(build: fn(&mut Build, &[FormulaId]) -> FormulaId, expected: &[&str]) {
    let program = body(&BITS, Type::Bool, |b, read, y| vec![assign(y, build(b, read))]);
    assert_eq!(lines(&program), expected);
}

#[test]
fn formulas_are_contacts() {
    check(|_, i| i[0], &["a -> y"]);
    check(|b, i| b.pool().not(i[0]), &["/a -> y"]);
    check(|b, _| b.pool().truth(true), &["-> y"]);
    check(|b, _| b.pool().truth(false), &["-> R y"]);
    check(|b, i| b.pool().and([i[0], i[1]]), &["a b -> y"]);
    check(|b, i| b.pool().or([i[0], i[1]]), &["[a | b] -> y"]);
    check(
        |b, i| {
            let either = b.pool().or([i[0], i[1]]);
            b.pool().not(either)
        },
        &["/a /b -> y"],
    );
    check(
        |b, i| {
            let both = b.pool().and([i[0], i[1]]);
            b.pool().not(both)
        },
        &["[/a | /b] -> y"],
    );
    check(|b, i| b.pool().xor(i[0], i[1]), &["[a /b | /a b] -> y"]);
    check(
        |b, i| {
            let other = b.pool().xor(i[0], i[1]);
            b.pool().not(other)
        },
        &["[a b | /a /b] -> y"],
    );
    check(
        |b, i| {
            let (first, second) = (b.pool().xor(i[0], i[1]), b.pool().xor(i[2], i[3]));
            b.pool().or([first, second])
        },
        &["[a /b | /a b | c /d | /c d] -> y"],
    );
    check(
        |b, i| {
            let (ab, cd) = (b.pool().and([i[0], i[1]]), b.pool().and([i[2], i[3]]));
            b.pool().or([ab, cd])
        },
        &["[a b | c d] -> y"],
    );
}

/// Branches of one contact and of several do not begin together at the rail; a contact before them helps, if there is
/// one.
#[test]
fn branches_at_the_rail_are_alike() {
    check(
        |b, i| {
            let bc = b.pool().and([i[1], i[2]]);
            b.pool().or([i[0], bc])
        },
        &["b c -> part_1", "[a | part_1] -> y"],
    );
    check(
        |b, i| {
            let (bc, de) = (b.pool().and([i[1], i[2]]), b.pool().and([i[3], i[4]]));
            b.pool().or([bc, i[0], de])
        },
        &["[b c | d e] -> part_1", "[a | part_1] -> y"],
    );
    check(
        |b, i| {
            let bc = b.pool().and([i[1], i[2]]);
            let sum = b.pool().or([i[0], bc]);
            b.pool().and([sum, i[3]])
        },
        &["d [a | b c] -> y"],
    );
    check(
        |b, i| {
            let bc = b.pool().and([i[1], i[2]]);
            let (first, second) = (b.pool().or([i[0], bc]), b.pool().or([i[3], i[4]]));
            b.pool().and([first, second])
        },
        &["b c -> part_1", "[a | part_1] [d | e] -> y"],
    );
}

/// A branch that has a group in it is a rung of its own.
#[test]
fn groups_do_not_nest() {
    check(
        |b, i| {
            let cd = b.pool().and([i[2], i[3]]);
            let inner = b.pool().or([i[1], cd]);
            let branch = b.pool().and([inner, i[0]]);
            b.pool().or([i[4], branch])
        },
        &["a [b | c d] -> part_1", "[e | part_1] -> y"],
    );
}

/// The ways through a rung multiply: six groups of two are 64, a seventh begins a new rung.
#[test]
fn long_rungs_are_cut() {
    let names: Vec<String> = (0..14).map(|n| format!("i{n}")).collect();
    let inputs: Vec<(&str, Type)> = names.iter().map(|name| (name.as_str(), Type::Bool)).collect();
    let program = body(&inputs, Type::Bool, |b, i, y| {
        let sums: Vec<FormulaId> = i.chunks(2).map(|pair| b.pool().or([pair[0], pair[1]])).collect();
        let value = b.pool().and(sums);
        vec![assign(y, value)]
    });
    let first = "[i0 | i1] [i2 | i3] [i4 | i5] [i6 | i7] [i8 | i9] [i10 | i11] -> part_1";
    assert_eq!(lines(&program), [first, "part_1 [i12 | i13] -> y"]);
}

#[test]
fn what_keeps_its_variable_is_set_and_reset() {
    let check = |build: fn(&mut Build, &[FormulaId], FormulaId) -> FormulaId, expected: &[&str]| {
        let program = body(&BITS, Type::Bool, |b, i, y| {
            let own = b.read(y);
            vec![assign(y, build(b, i, own))]
        });
        assert_eq!(lines(&program), expected);
    };
    // Activation wins: it comes last.
    check(
        |b, i, own| {
            let not_b = b.pool().not(i[1]);
            let stays = b.pool().and([own, not_b]);
            b.pool().or([i[0], stays])
        },
        &["b -> R y", "a -> S y"],
    );
    // y := a OR c OR y AND NOT (b OR d)
    check(
        |b, i, own| {
            let (not_b, not_d) = (b.pool().not(i[1]), b.pool().not(i[3]));
            let stays = b.pool().and([own, not_b, not_d]);
            b.pool().or([i[0], i[2], stays])
        },
        &["[b | d] -> R y", "[a | c] -> S y"],
    );
    // Deactivation wins.
    check(
        |b, i, own| {
            let not_b = b.pool().not(i[1]);
            let set = b.pool().or([i[0], own]);
            b.pool().and([not_b, set])
        },
        &["a -> S y", "b -> R y"],
    );
    check(|b, i, own| b.pool().or([own, i[0]]), &["a -> S y"]);
    check(|b, i, own| b.pool().and([own, i[0]]), &["/a -> R y"]);
    // What sets reads the variable itself.
    check(
        |b, i, own| {
            let not_own = b.pool().not(own);
            let (set, stays) = (b.pool().and([i[0], not_own]), b.pool().and([own, i[1]]));
            b.pool().or([set, stays])
        },
        &["[a /y | y b] -> y"],
    );
    check(|b, _, own| b.pool().not(own), &["/y -> y"]);
}

#[test]
fn constants_share_the_rung_of_their_condition() {
    let program = body(&BITS, Type::Bool, |b, i, y| {
        let (z, x) = (b.bit(Role::Output, "z"), b.bit(Role::Step, "x"));
        let (yes, no) = (b.pool().truth(true), b.pool().truth(false));
        let read = [x, z].map(|id| b.read(id));
        let leaves = b.pool().and([read[0], i[0]]);
        let joins = b.pool().and([read[0], read[1]]);
        vec![
            // What the condition reads is written last.
            when(leaves, vec![b.noted(x, no, "x -> y"), assign(y, yes)]),
            // Of two things that it reads one would be written too early.
            when(joins, vec![b.noted(x, no, "x, z ->"), assign(z, no)]),
        ]
    });
    assert_eq!(lines(&program), ["x a -> S y, R x", "x z -> part_1", "part_1 -> R x, R z"]);
    let comments: Vec<Vec<String>> = rungs(&program).into_iter().map(|rung| rung.comments).collect();
    let [first, second] = ["x -> y", "x, z ->"].map(str::to_owned);
    assert_eq!(comments, [vec!["outputs".to_owned(), first], vec![second], vec![]]);
}

#[test]
fn a_branch_is_chosen_before_anything_is_done() {
    let program = body(&BITS, Type::Bool, |b, i, y| {
        let n = b.var(Role::Output, "n", Type::Int);
        let (one, read, yes) = (b.pool().constant(Value::Int(1), Type::Int), b.read(n), b.pool().truth(true));
        let (more, own) = (b.pool().arithmetic(Arithmetic::Add, Type::Int, read, one), b.read(y));
        let value = b.pool().and([i[2], i[3]]);
        vec![Statement::choice(
            vec![(own, vec![assign(n, more), assign(y, i[4])]), (i[1], vec![assign(y, value), assign(n, one)])],
            vec![assign(y, yes)],
        )]
    });
    assert_eq!(
        lines(&program),
        [
            // y is written in a branch.
            "y -> part_1",
            "/part_1 b -> part_2",
            "/part_1 /part_2 -> part_3",
            "part_1 -> ADD(EN, IN1 = n, IN2 = 1) OUT -> n",
            "part_1 e -> S y",
            "part_1 /e -> R y",
            "c d -> part_4",
            "part_2 part_4 -> S y",
            "part_2 /part_4 -> R y",
            "part_2 -> MOVE(EN, IN = 1) OUT -> n",
            "part_3 -> S y",
        ]
    );
}

/// What is written is what the variable was not before either rung.
#[test]
fn a_variable_is_inverted_under_a_condition() {
    let program = body(&BITS, Type::Bool, |b, i, y| {
        let own = b.read(y);
        let value = b.pool().not(own);
        vec![when(i[0], vec![assign(y, value)])]
    });
    assert_eq!(lines(&program), ["/y -> part_1", "a part_1 -> S y", "a /part_1 -> R y"]);
}

#[test]
fn a_choice_compares_before_it_writes() {
    let mut b = Build::new("Choice");
    let at = b.var(Role::State, "at_G1", Type::Int);
    let y = b.bit(Role::Output, "y");
    let (yes, to_two) = (b.pool().truth(true), b.set(at, 2));
    b.program.after = vec![b.case(at, [(1, "step 1", vec![to_two]), (2, "step 2", vec![assign(y, yes)])])];
    assert_eq!(
        lines(&b.program),
        [
            "-> EQ(EN, IN1 = at_G1, IN2 = 1) OUT -> part_1",
            "-> EQ(EN, IN1 = at_G1, IN2 = 2) OUT -> part_2",
            "part_1 -> MOVE(EN, IN = 2) OUT -> at_G1",
            "part_2 -> S y",
        ]
    );
}

#[test]
fn comparisons_have_rungs_of_their_own() {
    let inputs = [("n", Type::Int), ("k", Type::Dint), ("a", Type::Bool)];
    let program = body(&inputs, Type::Bool, |b, i, y| {
        let five = b.pool().constant(Value::Int(5), Type::Int);
        let wide = b.pool().widen(Type::Dint, i[0]);
        let (above, less) =
            (b.pool().compare(Comparison::Greater, i[0], five), b.pool().compare(Comparison::LessEqual, wide, i[1]));
        let not_less = b.pool().not(less);
        let value = b.pool().and([i[2], above, not_less]);
        vec![assign(y, value)]
    });
    assert_eq!(
        lines(&program),
        [
            "-> GT(EN, IN1 = n, IN2 = 5) OUT -> part_1",
            "-> LE(EN, IN1 = INT_TO_DINT(n), IN2 = k) OUT -> part_2",
            "a part_1 /part_2 -> y",
        ]
    );
}

#[test]
fn a_division_is_guarded() {
    let program = body(&[("n", Type::Dint), ("k", Type::Dint)], Type::Dint, |b, i, target| {
        let flag = b.bit(Role::Flag(Flag::Div0), "DIV0");
        vec![Statement::Divide(Division {
            target,
            modulo: false,
            dividend: i[0],
            divisor: i[1],
            flag,
            origin: Origin::Chart,
        })]
    });
    assert_eq!(
        lines(&program),
        [
            "-> EQ(EN, IN1 = k, IN2 = 0) OUT -> part_1",
            "part_1 -> S DIV0",
            "-> EQ(EN, IN1 = k, IN2 = -1) OUT -> part_2",
            "part_1 -> MOVE(EN, IN = 0) OUT -> y",
            "part_2 -> SUB(EN, IN1 = 0, IN2 = n) OUT -> y",
            "/part_1 /part_2 -> DIV(EN, IN1 = n, IN2 = k) OUT -> y",
        ]
    );
    let by_nothing = body(&[("n", Type::Int)], Type::Int, |b, i, target| {
        let flag = b.bit(Role::Flag(Flag::Div0), "DIV0");
        let divisor = b.pool().constant(Value::Int(0), Type::Int);
        vec![Statement::Divide(Division {
            target,
            modulo: false,
            dividend: i[0],
            divisor,
            flag,
            origin: Origin::Chart,
        })]
    });
    assert_eq!(lines(&by_nothing), ["-> MOVE(EN, IN = 0) OUT -> y", "-> S DIV0"]);
}

/// A text with a literal of a time in its middle would be a puzzle to Beremiz.
#[test]
fn operators_are_functions() {
    let inputs = [("t", Type::Time), ("n", Type::Int), ("x", Type::Real)];
    let check = |ty: Type, build: fn(&mut Build, &[FormulaId]) -> FormulaId, expected: &str| {
        let program = body(&inputs, ty, |b, i, y| vec![assign(y, build(b, i))]);
        assert_eq!(lines(&program), [expected]);
    };
    check(
        Type::Time,
        |b, i| {
            let second = b.pool().constant(Value::Time(1000), Type::Time);
            b.pool().arithmetic(Arithmetic::Subtract, Type::Time, i[0], second)
        },
        "-> SUB(EN, IN1 = t, IN2 = T#1s) OUT -> y",
    );
    check(
        Type::Time,
        |b, i| b.pool().arithmetic(Arithmetic::Multiply, Type::Time, i[1], i[0]),
        "-> MUL(EN, IN1 = t, IN2 = n) OUT -> y",
    );
    check(Type::Int, |b, i| b.pool().negate(i[1]), "-> SUB(EN, IN1 = 0, IN2 = n) OUT -> y");
    check(Type::Real, |b, i| b.pool().negate(i[2]), "-> MUL(EN, IN1 = x, IN2 = REAL#-1.0) OUT -> y");
    check(Type::Dint, |b, i| b.pool().widen(Type::Dint, i[1]), "-> MOVE(EN, IN = INT_TO_DINT(n)) OUT -> y");
}

/// `EN` is an input like others, and keeps what it was given.
#[test]
fn a_timer_that_waits_once_always_waits() {
    let program = body(&[("a", Type::Bool), ("b", Type::Bool)], Type::Bool, |b, i, _| {
        let timer = b.timer("on_a", Some(Preset { ms: 1500, constant: None }), "");
        let not_a = b.pool().not(i[0]);
        vec![when(i[1], vec![call(timer, i[0])]), call(timer, not_a)]
    });
    assert_eq!(
        lines(&program),
        [
            "b -> TON on_a(EN, IN = a, PT = T#1500ms) Q -> on_a_Q",
            "/a -> part_1",
            "-> TON on_a(EN, IN = part_1, PT = T#1500ms) Q -> on_a_Q",
        ]
    );
}

#[test]
fn a_timer_has_its_variable() {
    let program = body(&[("a", Type::Bool), ("b", Type::Bool)], Type::Bool, |b, i, y| {
        let timer = b.timer("on_a", Some(Preset { ms: 1500, constant: None }), "");
        let (unbounded, never) = (b.timer("T2", None, ""), b.pool().truth(false));
        let (both, done) = (b.pool().and([i[0], i[1]]), b.pool().timer_done(timer));
        vec![call(timer, both), assign(y, done), call(unbounded, never)]
    });
    assert_eq!(
        lines(&program),
        [
            "a b -> TON on_a(IN, PT = T#1500ms) Q -> on_a_Q",
            "on_a_Q -> y",
            "-> R part_1",
            "part_1 -> TON T2(IN, PT = T#2147483647ms) ET -> T2_ET",
        ]
    );
}

/// What comes once before the micro-steps waits for the first; outputs that divide for the last.
#[test]
fn the_loop_calls_the_rungs() {
    let mut program = four_steps();
    let timer = program.timers.indices().next().expect("a timer");
    let high = program.variables.iter_enumerated().find(|(_, v)| v.name == "high").map(|(id, _)| id).expect("an input");
    let high = program.pool.variable(high, Type::Bool);
    let event = program.variables.push(variable(Role::Temporary, "event", Type::Bool));
    program.before = vec![call(timer, high), assign(event, high)];
    let target = program.variables.push(variable(Role::Output, "n", Type::Int));
    let flag = program.variables.push(variable(Role::Flag(Flag::Div0), "DIV0", Type::Bool));
    let dividend = program.pool.variable(target, Type::Int);
    let divide =
        Statement::Divide(Division { target, modulo: false, dividend, divisor: dividend, flag, origin: Origin::Chart });
    program.after.push(divide);
    let all = lines(&program);
    let called = "high -> TON stirred(IN, PT = stir_time) Q -> stirred_Q";
    for expected in [called, "/further high -> S event", "/further /high -> R event"] {
        assert!(all.contains(&expected.to_owned()), "{all:?}");
    }
    assert!(all.contains(&"[/again | last] -> part_6".to_owned()), "{all:?}");
    assert!(all.contains(&"part_6 /part_7 -> DIV(EN, IN1 = n, IN2 = n) OUT -> n".to_owned()), "{all:?}");
    let text = emit(&program, &Options::default()).expect("it can be written");
    let (_, statements) = text.split_once("<![CDATA[further := FALSE;").expect("the loop");
    let (statements, _) = statements.split_once("]]>").expect("its end");
    let words: Vec<&str> = statements.split_whitespace().collect();
    assert_eq!(
        words.join(" "),
        "micro_steps := 0; REPEAT micro_steps := micro_steps + 1; last := (micro_steps >= 200); \
         rungs(start := start, high := high, low := low, further := further, last := last); \
         INLET := rungs.INLET; STIRRER := rungs.STIRRER; OUTLET := rungs.OUTLET; n := rungs.n; DIV0 := rungs.DIV0; \
         further := rungs.again; UNTIL NOT further OR (micro_steps >= 200) END_REPEAT; \
         IF further THEN LIVELOCK := TRUE; END_IF;"
    );
}

fn variable(role: Role, name: &str, ty: Type) -> grafc_logic::scan::Variable {
    let mut b = Build::new("other");
    let id: VarId = b.var(role, name, ty);
    b.program.variables[id].clone()
}

#[test]
fn a_program_that_does_nothing_has_a_rung() {
    let mut b = Build::new("Nothing");
    b.var(Role::Output, "n", Type::Int);
    assert_eq!(lines(&b.program), ["-> MOVE(EN, IN = n) OUT -> n"]);
    b.bit(Role::Output, "y");
    assert_eq!(lines(&b.program), ["y -> y"]);
}
