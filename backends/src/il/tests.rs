//! Instruction lists, read line by line.

use super::{Options, emit, instructions};
use crate::st::tests::{Build, assign, body, call, four_steps, heading, when};
use expect_test::expect;
use grafc_formula::{Arithmetic, Comparison, FormulaId, Type, Value};
use grafc_logic::scan::{Division, Flag, Heading, Origin, Preset, Program, Repeat, Role, Statement, Told, VarId};

/// The body of the function block as one line: `LD a, ST y`. Its instructions are as many as are counted.
fn list(program: &Program) -> String {
    let text = emit(program, &Options::default()).expect("it can be written");
    let (_, body) = text.rsplit_once("END_VAR\n").expect("declarations");
    let body = body.trim().trim_end_matches("END_FUNCTION_BLOCK");
    let lines = body.lines().map(|line| line.split("(* ").next().unwrap_or_default());
    let words = |line: &str| line.split_ascii_whitespace().collect::<Vec<_>>().join(" ");
    let lines: Vec<String> = lines.map(words).filter(|line| !line.is_empty()).collect();
    let count = lines.iter().filter(|line| !line.ends_with(':')).count();
    assert_eq!(instructions(program).expect("it can be counted"), count as u64, "{text}");
    lines.join(", ")
}

const BITS: [(&str, Type); 5] =
    [("a", Type::Bool), ("b", Type::Bool), ("c", Type::Bool), ("d", Type::Bool), ("e", Type::Bool)];

#[test]
fn formulas_of_truth_values() {
    let check = |build: fn(&mut Build, &[FormulaId]) -> FormulaId, expected: &str| {
        let program = body(&BITS, Type::Bool, |b, read, y| vec![assign(y, build(b, read))]);
        assert_eq!(list(&program), format!("{expected}, ST y"));
    };
    check(|_, i| i[0], "LD a");
    check(|b, i| b.pool().not(i[0]), "LDN a");
    check(|b, i| b.pool().and([i[0], i[1]]), "LD a, AND b");
    check(
        |b, i| {
            let not_a = b.pool().not(i[0]);
            b.pool().xor(i[1], not_a)
        },
        "LD b, XORN a",
    );
    check(
        |b, i| {
            let either = b.pool().or([i[0], i[1]]);
            b.pool().not(either)
        },
        "LD a, OR b, NOT",
    );
    // The operand that needs a parenthesis comes first.
    check(
        |b, i| {
            let not_b = b.pool().not(i[1]);
            let stays = b.pool().and([i[0], not_b]);
            b.pool().or([i[2], stays])
        },
        "LD a, ANDN b, OR c",
    );
    // A second one stands in one.
    check(
        |b, i| {
            let (ab, cd) = (b.pool().and([i[0], i[1]]), b.pool().and([i[2], i[3]]));
            b.pool().or([ab, i[4], cd])
        },
        "LD a, AND b, OR e, OR( c, AND d, )",
    );
    check(
        |b, i| {
            let (ab, cd) = (b.pool().and([i[0], i[1]]), b.pool().and([i[2], i[3]]));
            let not_cd = b.pool().not(cd);
            b.pool().or([ab, not_cd])
        },
        "LD a, AND b, ORN( c, AND d, )",
    );
    // A parenthesis begins with a value.
    check(
        |b, i| {
            let (not_c, ab) = (b.pool().not(i[2]), b.pool().and([i[0], i[1]]));
            let cd = b.pool().and([not_c, i[3]]);
            b.pool().or([ab, cd])
        },
        "LD a, AND b, OR( d, ANDN c, )",
    );
    check(
        |b, i| {
            let (not_c, not_d, ab) = (b.pool().not(i[2]), b.pool().not(i[3]), b.pool().and([i[0], i[1]]));
            let cd = b.pool().and([not_c, not_d]);
            b.pool().or([ab, cd])
        },
        "LD a, AND b, OR( c, NOT, ANDN d, )",
    );
}

/// Of `(p OR q) AND (r OR s AND t OR u AND v)` the second factor has a parenthesis itself, so it comes first; of two
/// such factors the second is stored.
#[test]
fn no_parenthesis_within_a_parenthesis() {
    let product = |b: &mut Build, i: &[FormulaId], first: usize| {
        let (ab, cd) = (b.pool().and([i[first], i[1]]), b.pool().and([i[2], i[3]]));
        b.pool().or([ab, cd])
    };
    let one = body(&BITS, Type::Bool, |b, i, y| {
        let (sum, either) = (product(b, i, 0), b.pool().or([i[0], i[4]]));
        let value = b.pool().and([either, sum]);
        vec![assign(y, value)]
    });
    assert_eq!(list(&one), "LD a, AND b, OR( c, AND d, ), AND( a, OR e, ), ST y");
    let two = body(&BITS, Type::Bool, |b, i, y| {
        let (first, second) = (product(b, i, 0), product(b, i, 4));
        let not_second = b.pool().not(second);
        let value = b.pool().and([first, not_second]);
        let again = b.pool().and([second, first, i[0]]);
        vec![assign(y, value), assign(y, again)]
    });
    assert_eq!(
        list(&two),
        "LD e, AND b, OR( c, AND d, ), ST part_1, LD a, AND b, OR( c, AND d, ), ANDN part_1, ST y, \
         LD a, AND b, OR( c, AND d, ), ST part_1, LD e, AND b, OR( c, AND d, ), AND part_1, AND a, ST y"
    );
    // Two that are needed at once have a variable each.
    let three = body(&BITS, Type::Bool, |b, i, y| {
        let factors = [product(b, i, 0), product(b, i, 4), {
            let (ae, bc) = (b.pool().and([i[0], i[4]]), b.pool().and([i[1], i[2]]));
            b.pool().or([ae, bc])
        }];
        let value = b.pool().and(factors);
        vec![assign(y, value)]
    });
    assert_eq!(
        list(&three),
        "LD e, AND b, OR( c, AND d, ), ST part_1, LD a, AND e, OR( b, AND c, ), ST part_2, \
         LD a, AND b, OR( c, AND d, ), AND part_1, AND part_2, ST y"
    );
    let text = emit(&two, &Options::default()).expect("it can be written");
    assert!(text.contains("    (* values within one call *)\n    part_1 : BOOL;\n"), "{text}");
}

#[test]
fn numbers_and_times() {
    let inputs = [("n", Type::Int), ("k", Type::Dint), ("u", Type::Uint), ("x", Type::Real), ("t", Type::Time)];
    let check = |ty: Type, build: fn(&mut Build, &[FormulaId]) -> FormulaId, expected: &str| {
        let program = body(&inputs, ty, |b, read, y| vec![assign(y, build(b, read))]);
        assert_eq!(list(&program), format!("{expected}, ST y"));
    };
    check(
        Type::Int,
        |b, i| {
            let five = b.pool().constant(Value::Int(-5), Type::Int);
            b.pool().arithmetic(Arithmetic::Subtract, Type::Int, five, i[0])
        },
        "LD -5, SUB n",
    );
    check(
        Type::Dint,
        |b, i| {
            let wide = b.pool().widen(Type::Dint, i[0]);
            b.pool().arithmetic(Arithmetic::Subtract, Type::Dint, i[1], wide)
        },
        "LD k, SUB( n, INT_TO_DINT, )",
    );
    check(
        Type::Dint,
        |b, i| {
            let wide = b.pool().widen(Type::Dint, i[0]);
            b.pool().arithmetic(Arithmetic::Subtract, Type::Dint, wide, i[1])
        },
        "LD n, INT_TO_DINT, SUB k",
    );
    check(Type::Time, |b, i| b.pool().arithmetic(Arithmetic::Multiply, Type::Time, i[0], i[4]), "LD t, MUL n");
    check(Type::Int, |b, i| b.pool().negate(i[0]), "LD 0, SUB n");
    check(Type::Uint, |b, i| b.pool().negate(i[2]), "LD 0, SUB u");
    check(Type::Time, |b, i| b.pool().negate(i[4]), "LD T#0ms, SUB t");
    check(Type::Real, |b, i| b.pool().negate(i[3]), "LD x, MUL REAL#-1.0");
    // A comparison turns round where that saves a parenthesis.
    check(
        Type::Bool,
        |b, i| {
            let wide = b.pool().widen(Type::Dint, i[0]);
            b.pool().compare(Comparison::Less, i[1], wide)
        },
        "LD n, INT_TO_DINT, GT k",
    );
    check(
        Type::Bool,
        |b, i| {
            let (seven, p) = (b.pool().constant(Value::Int(7), Type::Int), b.pool());
            let (low, high) =
                (p.compare(Comparison::LessEqual, i[0], seven), p.compare(Comparison::Equal, i[0], seven));
            p.and([low, high])
        },
        "LD n, LE 7, AND( n, EQ 7, )",
    );
}

/// Truth values that are stored after a condition, and constants one after the other, need no load.
#[test]
fn what_is_in_the_accumulator_is_not_loaded_again() {
    let program = body(&BITS, Type::Bool, |b, i, y| {
        let z = b.bit(Role::Output, "z");
        let (yes, no) = (b.pool().truth(true), b.pool().truth(false));
        let first = Statement::choice(
            vec![(i[0], vec![assign(y, yes), assign(z, no)]), (i[1], vec![assign(y, i[2]), assign(z, yes)])],
            vec![assign(y, no), assign(z, yes)],
        );
        vec![first, assign(y, no), assign(z, no)]
    });
    assert_eq!(
        list(&program),
        "LD a, JMPCN next_y, ST y, STN z, JMP done_y, next_y:, LD b, JMPCN next_y_1, LD c, ST y, LD TRUE, ST z, JMP done_y, \
         next_y_1:, ST y, STN z, done_y:, LD FALSE, ST y, ST z"
    );
}

#[test]
fn a_choice_tries_its_arms() {
    let build = |count: i64| {
        let mut b = Build::new("Choice");
        let at = b.var(Role::State, "at_G1", Type::Int);
        let y = b.bit(Role::Output, "y");
        let yes = b.pool().truth(true);
        // From the last to the first.
        let arms = (1..=count).rev().map(|value| grafc_logic::scan::Arm {
            value,
            origin: Origin::Chart,
            told: Told::Nothing,
            body: vec![if value == 2 { b.set(at, 1) } else { assign(y, yes) }],
        });
        let arms = arms.collect();
        b.program.after = vec![Statement::Case { of: at, arms }];
        b.program
    };
    // A later arm may not be found by what an earlier one has written.
    assert_eq!(
        list(&build(2)),
        "LD at_G1, EQ 2, JMPCN next_at_G1, LD 1, ST at_G1, JMP done_at_G1, next_at_G1:, LD at_G1, EQ 1, JMPCN done_at_G1, ST y, done_at_G1:"
    );
    // Nine arms are halved: 1 to 4, 5 to 9.
    let nine = list(&build(9));
    assert!(
        nine.starts_with(
            "LD at_G1, GE 5, JMPC upper_at_G1, LD at_G1, EQ 1, JMPCN next_at_G1, ST y, JMP done_at_G1, next_at_G1:, "
        ),
        "{nine}"
    );
    assert!(
        nine.contains("EQ 4, JMPCN done_at_G1, ST y, JMP done_at_G1, upper_at_G1:, LD at_G1, EQ 5, JMPCN "),
        "{nine}"
    );
    assert!(nine.ends_with("LD at_G1, EQ 9, JMPCN done_at_G1, ST y, done_at_G1:"), "{nine}");
    // Four instructions an arm, one more in that of 2, three for the halving, and no jump at the very end.
    assert_eq!(instructions(&build(9)).expect("a count"), 9 * 5 + 1 + 3 - 1);
}

#[test]
fn a_division_is_guarded() {
    let divide = |ty: Type, modulo: bool| {
        body(&[("n", ty), ("k", ty)], ty, |b, i, target| {
            let flag = b.bit(Role::Flag(Flag::Div0), "DIV0");
            vec![Statement::Divide(Division {
                target,
                modulo,
                dividend: i[0],
                divisor: i[1],
                flag,
                origin: Origin::Chart,
            })]
        })
    };
    assert_eq!(
        list(&divide(Type::Int, false)),
        "LD k, EQ 0, JMPCN divide_y, ST DIV0, LD 0, JMP quotient_y, divide_y:, LD n, DIV k, quotient_y:, ST y"
    );
    assert_eq!(
        list(&divide(Type::Dint, false)),
        "LD k, EQ 0, JMPCN divide_y, ST DIV0, LD 0, JMP quotient_y, \
         divide_y:, LD k, EQ -1, JMPCN divide_y_1, LD 0, SUB n, JMP quotient_y, \
         divide_y_1:, LD n, DIV k, quotient_y:, ST y"
    );
    assert_eq!(
        list(&divide(Type::Dint, true)),
        "LD k, EQ 0, JMPCN divide_y, ST DIV0, LD 0, JMP quotient_y, \
         divide_y:, LD k, EQ -1, JMPCN divide_y_1, LD 0, JMP quotient_y, \
         divide_y_1:, LD n, MOD k, quotient_y:, ST y"
    );
    // A constant too may be the one that overflows.
    let constant = |value: i64, modulo: bool| {
        let program = body(&[("k", Type::Dint)], Type::Dint, |b, i, target| {
            let flag = b.bit(Role::Flag(Flag::Div0), "DIV0");
            let dividend = b.pool().constant(Value::Int(value), Type::Dint);
            vec![Statement::Divide(Division { target, modulo, dividend, divisor: i[0], flag, origin: Origin::Chart })]
        });
        list(&program)
    };
    assert!(constant(-2_147_483_648, true).contains("LD k, EQ -1, JMPCN divide_y_1, LD 0, JMP quotient_y"));
    assert!(constant(-2_147_483_648, false).contains("EQ -1, JMPCN divide_y_1, LD -2147483648, JMP quotient_y"));
    assert!(!constant(-2_147_483_647, true).contains("EQ -1"));
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
    assert_eq!(list(&by_nothing), "LD 0, ST y, LD TRUE, ST DIV0");
}

#[test]
fn a_timer_is_given_its_inputs_before_it_is_called() {
    let program = body(&[("a", Type::Bool), ("b", Type::Bool)], Type::Bool, |b, i, y| {
        let timer = b.timer("on_a", Some(Preset { ms: 1500, constant: None }), "");
        let unbounded = b.timer("T2", None, "");
        let (both, done) = (b.pool().and([i[0], i[1]]), b.pool().timer_done(timer));
        vec![call(timer, both), assign(y, done), call(unbounded, i[0])]
    });
    assert_eq!(
        list(&program),
        "LD a, AND b, ST on_a.IN, LD T#1500ms, ST on_a.PT, CAL on_a, LD on_a.Q, ST y, \
         LD a, ST T2.IN, LD T#2147483647ms, ST T2.PT, CAL T2"
    );
}

#[test]
fn the_loop_jumps_back() {
    let mut b = Build::new("Loop");
    let (a, again) = (b.bit(Role::Input, "a"), b.bit(Role::Temporary, "again"));
    let a = b.read(a);
    b.program.micro_step = vec![assign(again, a)];
    b.program.repeat = Some(Repeat { again, limit: None });
    assert_eq!(list(&b.program), "micro_step:, LD a, ST again, LD again, JMPC micro_step");
}

/// MATIEC gives up on a long body unless it begins with a word that has `END_ACTION` in it.
#[test]
fn a_long_body_is_announced() {
    let begins = |assignments: usize| {
        let program = body(&BITS, Type::Bool, |_, i, y| (0..assignments).map(|n| assign(y, i[n % 5])).collect());
        let text = emit(&program, &Options::default()).expect("it can be written");
        text.contains("\nno_end_action:\n\n(* outputs *)\n    LD    a\n")
    };
    // An assignment takes 24 bytes.
    assert!(!begins(600) && begins(700));
}

/// What an operator is called nothing else can be; neither can a label be called like a variable.
#[test]
fn operators_are_no_names() {
    let mut b = Build::new("LD");
    let names = ["S", "R", "in", "CLK", "jmpc", "done", "X1"];
    let ids: Vec<VarId> = names.iter().map(|name| b.bit(Role::Output, name)).collect();
    let when_s = b.read(ids[0]);
    let yes = b.pool().truth(true);
    b.program.after = vec![when(when_s, vec![assign(ids[1], yes)])];
    assert_eq!(super::names(&b.program).raw, ["S_1", "R_1", "in_1", "CLK_1", "jmpc_1", "done", "X1"]);
    assert_eq!(list(&b.program), "LD S_1, JMPCN done_R, ST R_1, done_R:");
}

#[test]
fn comments_stand_where_the_reader_looks() {
    let program = body(&BITS, Type::Bool, |b, i, y| {
        let at = b.var(Role::State, "at_G1", Type::Int);
        let both = b.pool().and([i[0], i[1]]);
        let long = "2 -> 1: a remark that is *) far too long to stand behind anything, so it stands on a line before what it is for";
        let arms = [(1, "step 1", vec![when(both, vec![b.noted(y, both, "1 -> 2"), b.noted(y, i[2], long)])])];
        vec![b.case(at, arms), heading(Heading::Situation)]
    });
    let text = emit(&program, &Options { header: vec!["from a.gct".to_owned()], ..Options::default() });
    let text = text.expect("it can be written");
    let (_, lines) = text.rsplit_once("END_VAR\n").expect("declarations");
    expect![[r#"

        (* outputs *)
            LD    at_G1                   (* step 1 *)
            EQ    1
            JMPCN done_at_G1
            LD    a
            AND   b
            JMPCN done_at_G1
            LD    a                       (* 1 -> 2 *)
            AND   b
            ST    y
        (* 2 -> 1: a remark that is * ) far too long to stand behind anything, so it stands on a line
           before what it is for *)
            LD    c
            ST    y
        done_at_G1:

        (* situation *)

        END_FUNCTION_BLOCK
    "#]]
    .assert_eq(lines);
}

#[test]
fn a_program_around_it() {
    let options = Options { pou: super::Pou::Program, ..Options::default() };
    let text = emit(&four_steps(), &options).expect("it can be written");
    let (_, frame) = text.split_once("PROGRAM Filling_program\n").expect("a program");
    let (_, lines) = frame.rsplit_once("END_VAR\n").expect("declarations");
    expect![[r#"

            LD    start
            ST    chart.start
            LD    high
            ST    chart.high
            LD    low
            ST    chart.low
            CAL   chart
            LD    chart.INLET
            ST    INLET
            LD    chart.STIRRER
            ST    STIRRER
            LD    chart.OUTLET
            ST    OUTLET
            LD    chart.LIVELOCK
            ST    LIVELOCK

        END_PROGRAM
    "#]]
    .assert_eq(lines);
}
