//! What the writer writes.

use super::{Build, assign, body, call, four_steps, heading, nested, nested_deeply, when};
use crate::st::{Options, Pou, emit};
use expect_test::{Expect, expect};
use grafc_diagnostics::Code;
use grafc_formula::{Arithmetic, Comparison, FormulaId, Type, Value};
use grafc_logic::scan::{Division, Flag, Heading, Origin, Preset, Program, Repeat, Role, Statement, VarId};

fn check(program: &Program, pou: Pou, expected: Expect) {
    let header = vec!["grafc 0.1.0, filling.gct".to_owned(), "--target st --encoding single-phase".to_owned()];
    expected.assert_eq(&emit(program, &Options { pou, header, interval_ms: 20 }).expect("it can be written"));
}

/// The statements alone.
fn check_body(program: &Program, expected: Expect) {
    let text = emit(program, &Options::default()).expect("it can be written");
    let (_, body) = text.split_once("END_VAR\n\n(* outputs *)\n").expect("a body");
    expected.assert_eq(body.trim_end_matches("END_FUNCTION_BLOCK\n"));
}

#[test]
fn a_function_block() {
    check(
        &four_steps(),
        Pou::FunctionBlock,
        expect![[r#"
            (* grafc 0.1.0, filling.gct
               --target st --encoding single-phase *)

            (* filling and stirring a tank *)
            FUNCTION_BLOCK Filling

            VAR_INPUT
                start : BOOL;     (* start button *)
                high, low : BOOL;
            END_VAR

            VAR_OUTPUT
                INLET : BOOL;     (* inlet valve *)
                STIRRER, OUTLET : BOOL;
                LIVELOCK : BOOL;  (* the situation did not become stable *)
            END_VAR

            VAR CONSTANT
                stir_time : TIME := T#8s;
            END_VAR

            VAR
                (* internal variables *)
                batches : INT;    (* how often the tank was filled *)

                (* steps *)
                X1 : BOOL := TRUE;    (* ready *)
                X2 : BOOL;            (* fill *)
                X3, X4 : BOOL;

                (* timers *)
                stirred : TON;    (* stir_time/X3 *)

                (* memory from call to call *)
                started, old_start : BOOL;

                (* values within one call *)
                clear_1, clear_2, clear_3, clear_4, next_1, next_2, next_3, next_4, again : BOOL;
                micro_steps : UINT;
            END_VAR

            IF NOT started THEN
                (* memory of edges *)
                started := TRUE;
                old_start := start;
            END_IF;

            micro_steps := 0;
            REPEAT
                micro_steps := micro_steps + 1;

                (* conditions *)
                stirred(IN := X3, PT := stir_time);

                (* transitions that clear *)
                clear_1 := X1 AND start AND NOT old_start;    (* 1 -> 2: ↑start *)
                clear_2 := X2 AND high;                       (* 2 -> 3: high *)
                clear_3 := X3 AND stirred.Q;                  (* 3 -> 4: stir_time/X3 *)
                clear_4 := X4 AND NOT low;                    (* 4 -> 1: not low *)

                (* next situation *)
                next_1 := clear_4 OR (X1 AND NOT clear_1);
                next_2 := clear_1 OR (X2 AND NOT clear_2);
                next_3 := clear_2 OR (X3 AND NOT clear_3);
                next_4 := clear_3 OR (X4 AND NOT clear_4);
                again :=
                    (next_1 <> X1)
                    OR (next_2 <> X2)
                    OR (next_3 <> X3)
                    OR (next_4 <> X4)
                    OR (start <> old_start);

                (* stored actions *)
                IF clear_2 THEN
                    batches := batches + 1;   (* 2 -> 3: on clearing *)
                END_IF;

                (* situation *)
                X1 := next_1;
                X2 := next_2;
                X3 := next_3;
                X4 := next_4;
                old_start := start;
            UNTIL NOT again OR (micro_steps >= 200)
            END_REPEAT;
            IF again THEN
                LIVELOCK := TRUE;
            END_IF;

            (* outputs *)
            INLET := X2;
            STIRRER := X3;
            OUTLET := X4;     (* 4 ->: until empty *)

            END_FUNCTION_BLOCK
        "#]],
    );
}

#[test]
fn a_configuration() {
    let text =
        emit(&four_steps(), &Options { pou: Pou::Configuration, ..Options::default() }).expect("it can be written");
    let (_, frame) = text.split_once("END_FUNCTION_BLOCK\n").expect("a block");
    expect![[r#"

        PROGRAM Filling_program

        VAR
            start AT %IX0.0 : BOOL;   (* start button *)
            INLET AT %QX0.0 : BOOL;   (* inlet valve *)
        END_VAR

        VAR
            high, low, STIRRER, OUTLET : BOOL;
            LIVELOCK : BOOL;  (* the situation did not become stable *)
            chart : Filling;
        END_VAR

        chart(start := start, high := high, low := low);
        INLET := chart.INLET;
        STIRRER := chart.STIRRER;
        OUTLET := chart.OUTLET;
        LIVELOCK := chart.LIVELOCK;

        END_PROGRAM

        CONFIGURATION Filling_configuration
            RESOURCE resource_1 ON PLC
                TASK cycle(INTERVAL := T#20ms, PRIORITY := 0);
                PROGRAM main WITH cycle : Filling_program;
            END_RESOURCE
        END_CONFIGURATION
    "#]]
    .assert_eq(frame);
}

#[test]
fn parentheses() {
    let inputs = [("a", Type::Bool), ("b", Type::Bool), ("c", Type::Bool), ("n", Type::Int)];
    let program = body(&inputs, Type::Bool, |b, v, y| {
        let (a, bb, c, n) = (v[0], v[1], v[2], v[3]);
        let p = b.pool();
        let not_a = p.not(a);
        let both = p.and([a, bb]);
        let either = p.or([bb, c]);
        let three = p.constant(Value::Int(3), Type::Int);
        let less = p.constant(Value::Int(-3), Type::Int);
        let above = p.compare(Comparison::Greater, n, three);
        let sum = p.arithmetic(Arithmetic::Subtract, Type::Int, n, less);
        let product = p.arithmetic(Arithmetic::Multiply, Type::Int, less, n);
        let equal = p.compare(Comparison::Equal, sum, product);
        let differ = p.xor(a, bb);
        let far = p.xor(both, c);
        let values = [
            p.and([not_a, either]),
            p.or([both, c, above]),
            p.not(both),
            p.not(above),
            p.not(differ),
            p.not(far),
            p.or([differ, far]),
            p.and([equal, differ]),
            p.xor(not_a, above),
            p.not(equal),
        ];
        values.map(|value| assign(y, value)).into()
    });
    check_body(
        &program,
        expect![[r#"
        y := NOT a AND (b OR c);
        y := (a AND b) OR c OR (n > 3);
        y := NOT (a AND b);
        y := NOT (n > 3);
        y := (a = b);
        y := ((a AND b) = c);
        y := (a <> b) OR ((a AND b) XOR c);
        y := (n - (-3) = -3 * n) AND (a <> b);
        y := NOT a XOR (n > 3);
        y := (n - (-3) <> -3 * n);

    "#]],
    );
}

/// What a `NOT` stands before has a variable in it, else it stands before each operand: STruC++ takes nothing else.
#[test]
fn negations_of_comparisons() {
    let inputs = [("a", Type::Bool), ("b", Type::Bool), ("n", Type::Int), ("k", Type::Int)];
    let program = body(&inputs, Type::Bool, |b, v, y| {
        let (a, bb, n, k) = (v[0], v[1], v[2], v[3]);
        let p = b.pool();
        let (not_a, not_b) = (p.not(a), p.not(bb));
        let three = p.constant(Value::Int(3), Type::Int);
        let (above, below) = (p.compare(Comparison::Greater, n, three), p.compare(Comparison::Less, k, three));
        let (apart, joined) = (p.xor(above, below), p.or([above, not_a]));
        let values = [
            p.or([above, below]),
            p.and([above, not_a]),
            p.and([below, joined]),
            p.and([below, apart]),
            p.and([above, a]),
            p.or([not_a, not_b]),
            apart,
        ];
        values.map(|value| assign(y, p.not(value))).into()
    });
    check_body(
        &program,
        expect![[r#"
        y := NOT (n > 3) AND NOT (k < 3);
        y := NOT (n > 3) OR a;
        y := NOT (k < 3) OR (NOT (n > 3) AND a);
        y := NOT (k < 3) OR ((n > 3) = (k < 3));
        y := NOT ((n > 3) AND a);
        y := a AND b;
        y := ((n > 3) = (k < 3));

    "#]],
    );
}

#[test]
fn division() {
    let inputs = [("a", Type::Dint), ("b", Type::Dint), ("r", Type::Real), ("t", Type::Time), ("u", Type::Uint)];
    let program = body(&inputs, Type::Dint, |b, v, y| {
        let flag = b.bit(Role::Flag(Flag::Div0), "DIV0");
        let share = b.var(Role::Output, "share", Type::Time);
        let ratio = b.var(Role::Output, "ratio", Type::Real);
        let p = b.pool();
        let (two, zero) = (p.constant(Value::Int(2), Type::Dint), p.constant(Value::Int(0), Type::Dint));
        let least = p.constant(Value::Int(-2_147_483_648), Type::Dint);
        let next = p.constant(Value::Int(-2_147_483_647), Type::Dint);
        let remainder = p.arithmetic(Arithmetic::Modulo, Type::Dint, v[0], two);
        let divide = |target, modulo, dividend, divisor| {
            Statement::Divide(Division { target, modulo, dividend, divisor, flag, origin: Origin::Chart })
        };
        vec![
            divide(y, false, v[0], v[1]),
            divide(y, true, two, v[1]),
            // Of constants the least alone overflows.
            divide(y, false, least, v[1]),
            divide(y, true, least, v[1]),
            divide(y, true, next, v[1]),
            assign(y, remainder),
            divide(y, false, v[0], zero),
            divide(ratio, false, v[2], v[2]),
            divide(share, false, v[3], v[4]),
        ]
    });
    check_body(
        &program,
        expect![[r#"
        IF b = 0 THEN
            y := 0;
            DIV0 := TRUE;
        ELSIF b = -1 THEN
            y := 0 - a;
        ELSE
            y := a / b;
        END_IF;
        IF b = 0 THEN
            y := 0;
            DIV0 := TRUE;
        ELSE
            y := 2 MOD b;
        END_IF;
        IF b = 0 THEN
            y := 0;
            DIV0 := TRUE;
        ELSIF b = -1 THEN
            y := -2147483648;
        ELSE
            y := -2147483648 / b;
        END_IF;
        IF b = 0 THEN
            y := 0;
            DIV0 := TRUE;
        ELSIF b = -1 THEN
            y := 0;
        ELSE
            y := -2147483648 MOD b;
        END_IF;
        IF b = 0 THEN
            y := 0;
            DIV0 := TRUE;
        ELSE
            y := -2147483647 MOD b;
        END_IF;
        y := a MOD 2;
        y := 0;
        DIV0 := TRUE;
        IF r = REAL#0.0 THEN
            ratio := REAL#0.0;
            DIV0 := TRUE;
        ELSE
            ratio := r / r;
        END_IF;
        IF u = 0 THEN
            share := T#0ms;
            DIV0 := TRUE;
        ELSE
            share := t / u;
        END_IF;

    "#]],
    );
}

#[test]
fn types() {
    let inputs = [("n", Type::Int), ("u", Type::Uint), ("t", Type::Time), ("r", Type::Real)];
    let program = body(&inputs, Type::Dint, |b, v, y| {
        let time = b.var(Role::Output, "time", Type::Time);
        let real = b.var(Role::Output, "large", Type::Lreal);
        let word = b.var(Role::Output, "word", Type::Uint);
        let watch = b.timer("watch", None, "how long");
        let p = b.pool();
        let wide = p.widen(Type::Dint, v[0]);
        let half = p.constant(Value::Real(0.5), Type::Lreal);
        let long = p.widen(Type::Lreal, v[3]);
        let long = p.arithmetic(Arithmetic::Multiply, Type::Lreal, long, half);
        let twice = p.arithmetic(Arithmetic::Multiply, Type::Time, v[0], v[2]);
        let (back, negative) = (p.negate(v[2]), p.negate(v[0]));
        let negative = p.widen(Type::Dint, negative);
        let under = p.negate(v[1]);
        let elapsed = p.timer_elapsed(watch);
        let limit = p.constant(Value::Time(1500), Type::Time);
        let late = p.compare(Comparison::GreaterEqual, elapsed, limit);
        vec![
            call(watch, late),
            assign(y, wide),
            assign(y, negative),
            assign(real, long),
            assign(time, twice),
            assign(time, back),
            assign(word, under),
        ]
    });
    check_body(
        &program,
        expect![[r#"
        watch(IN := (watch.ET >= T#1500ms), PT := T#2147483647ms);
        y := INT_TO_DINT(n);
        y := INT_TO_DINT(-n);
        large := REAL_TO_LREAL(r) * 0.5;
        time_1 := t * n;
        time_1 := T#0ms - t;
        word_1 := 0 - u;

    "#]],
    );
}

#[test]
fn long_lines() {
    let program = body(&[], Type::Bool, |b, _, y| {
        let limit = b.timer("limit", Some(Preset { ms: 90_000, constant: None }), "all of it");
        let many: Vec<FormulaId> = (0..14)
            .map(|n| {
                let id = b.bit(Role::Input, &format!("limit_switch_{n}"));
                b.read(id)
            })
            .collect();
        let p = b.pool();
        let all = p.and(many.iter().copied());
        let none = p.not(all);
        let either = p.or([none, many[3]]);
        vec![
            b.noted(
                y,
                all,
                "4 -> 5: every limit switch, which is said here at such length that it cannot stand behind the statement",
            ),
            assign(y, either),
            call(limit, all),
            Statement::choice(vec![(all, vec![b.noted(y, many[0], "5 -> 4: short")])], vec![assign(y, none)]),
        ]
    });
    check_body(
        &program,
        expect![[r#"
            (* 4 -> 5: every limit switch, which is said here at such length that it cannot stand behind the
               statement *)
            y :=
                limit_switch_0
                AND limit_switch_1
                AND limit_switch_2
                AND limit_switch_3
                AND limit_switch_4
                AND limit_switch_5
                AND limit_switch_6
                AND limit_switch_7
                AND limit_switch_8
                AND limit_switch_9
                AND limit_switch_10
                AND limit_switch_11
                AND limit_switch_12
                AND limit_switch_13;
            y :=
                NOT (
                    limit_switch_0
                    AND limit_switch_1
                    AND limit_switch_2
                    AND limit_switch_3
                    AND limit_switch_4
                    AND limit_switch_5
                    AND limit_switch_6
                    AND limit_switch_7
                    AND limit_switch_8
                    AND limit_switch_9
                    AND limit_switch_10
                    AND limit_switch_11
                    AND limit_switch_12
                    AND limit_switch_13
                )
                OR limit_switch_3;
            limit_1(
                IN :=
                    limit_switch_0
                    AND limit_switch_1
                    AND limit_switch_2
                    AND limit_switch_3
                    AND limit_switch_4
                    AND limit_switch_5
                    AND limit_switch_6
                    AND limit_switch_7
                    AND limit_switch_8
                    AND limit_switch_9
                    AND limit_switch_10
                    AND limit_switch_11
                    AND limit_switch_12
                    AND limit_switch_13,
                PT := T#90s
            );
            IF
                limit_switch_0
                AND limit_switch_1
                AND limit_switch_2
                AND limit_switch_3
                AND limit_switch_4
                AND limit_switch_5
                AND limit_switch_6
                AND limit_switch_7
                AND limit_switch_8
                AND limit_switch_9
                AND limit_switch_10
                AND limit_switch_11
                AND limit_switch_12
                AND limit_switch_13
            THEN
                y := limit_switch_0;  (* 5 -> 4: short *)
            ELSE
                y :=
                    NOT (
                        limit_switch_0
                        AND limit_switch_1
                        AND limit_switch_2
                        AND limit_switch_3
                        AND limit_switch_4
                        AND limit_switch_5
                        AND limit_switch_6
                        AND limit_switch_7
                        AND limit_switch_8
                        AND limit_switch_9
                        AND limit_switch_10
                        AND limit_switch_11
                        AND limit_switch_12
                        AND limit_switch_13
                    );
            END_IF;

        "#]],
    );
}

#[test]
fn hostile_texts() {
    let mut b = Build::new("насос *) (* {x}");
    b.program.comment = Some("ends *) here\nand (* there".into());
    let x = b.bit(Role::Input, "on");
    b.about(x, "*)");
    b.program.variables[x].address = Some("%IX0.0 : BOOL; END_VAR".into());
    let y = b.bit(Role::Output, "ON_1");
    let value = b.read(x);
    b.program.after = vec![heading(Heading::Outputs), b.noted(y, value, "4 -> 5: a *)\r\n b")];
    check(
        &b.program,
        Pou::Program,
        expect![[r#"
            (* grafc 0.1.0, filling.gct
               --target st --encoding single-phase *)

            (* `насос * ) ( * [x]`: ends * ) here and ( * there *)
            FUNCTION_BLOCK nasos_x

            VAR_INPUT
                on_2 : BOOL;  (* `on`: * ) *)
            END_VAR

            VAR_OUTPUT
                ON_1 : BOOL;
            END_VAR

            (* outputs *)
            ON_1 := on_2;     (* 4 -> 5: a * ) b *)

            END_FUNCTION_BLOCK

            PROGRAM nasos_x_program

            VAR
                on_2 : BOOL;  (* `on`: * ) *)
                ON_1 : BOOL;
                chart : nasos_x;
            END_VAR

            chart(on_2 := on_2);
            ON_1 := chart.ON_1;

            END_PROGRAM
        "#]],
    );
}

#[test]
fn an_empty_body_is_filled() {
    let mut b = Build::new("Empty");
    b.bit(Role::Step, "X1");
    let text = emit(&b.program, &Options::default()).expect("it can be written");
    assert!(text.contains("\n(* nothing ever changes *)\nX1 := X1;\n"), "{text}");
}

#[test]
fn states() {
    check(
        &nested(),
        Pou::FunctionBlock,
        expect![[r#"
            (* grafc 0.1.0, filling.gct
               --target st --encoding single-phase *)

            FUNCTION_BLOCK Nested

            VAR_INPUT
                a, b : BOOL;
            END_VAR

            VAR_OUTPUT
                y : BOOL;
            END_VAR

            VAR
                (* steps *)
                at_G : INT;   (* -1, 2 *)
                at_H : INT;   (* 0 none, 21, 22 *)

                (* memory from call to call *)
                next_G, next_H : INT;
                started : BOOL;

                (* values within one call *)
                moved : BOOL;
            END_VAR

            IF NOT started THEN started := TRUE; at_G := -1; next_G := -1; END_IF;

            REPEAT
                (* transitions *)
                moved := FALSE;
                CASE at_G OF
                    -1:  (* step -1: ready *)
                        IF a THEN next_G := 2; moved := TRUE; END_IF;
                    2:  (* step 2: running *)
                        IF NOT a THEN next_G := -1; moved := TRUE; END_IF;
                        CASE at_H OF
                            21:  (* step 21: first *)
                                IF b THEN next_H := 22; moved := TRUE; END_IF;  (* 21 -> 22 *)
                        END_CASE;
                END_CASE;
                IF moved THEN
                    IF next_G <> at_G THEN
                        CASE at_G OF
                            2:  (* step 2: running *)
                                next_H := 0;
                        END_CASE;
                        CASE next_G OF
                            2:
                                next_H := 21;
                        END_CASE;
                    END_IF;
                    at_G := next_G;
                    at_H := next_H;
                END_IF;
            UNTIL NOT moved
            END_REPEAT;

            y := (at_H = 22);

            END_FUNCTION_BLOCK
        "#]],
    );
}

#[test]
fn what_the_values_of_a_state_stand_for() {
    for (idle, values, expected) in [
        (None, vec![1, 2, 3], "1 to 3"),
        (Some(0), vec![3, 1, 2, 12, 13, 20], "0 none, 1 to 3, 12, 13, 20"),
        (Some(-1), vec![0, 7], "-1 none, 0, 7"),
        (Some(0), (1..=500).map(|n| 2 * n).collect(), "0 none, 2, 4"),
    ] {
        let mut b = Build::new("Values");
        b.state("G", idle, &values);
        let text = emit(&b.program, &Options::default()).expect("it can be written");
        assert!(text.contains(&format!("(* {expected}")), "{text}");
        assert!(text.lines().all(|line| line.len() <= 110), "{text}");
    }
}

#[test]
fn nesting() {
    for levels in [1, 16, 64, 99] {
        let text = emit(&nested_deeply(levels, 40), &Options::default()).expect("it can be written");
        assert_eq!(text.lines().filter(|line| line.trim_start().starts_with("CASE at_")).count(), levels, "{text}");
        assert_eq!(text.lines().filter(|line| line.trim_start() == "END_CASE;").count(), levels, "{text}");
        // However deep, there is room for a line.
        assert!(text.lines().any(|line| line.trim_start() == "IF a THEN"), "{text}");
        assert!(text.lines().all(|line| line.trim_start().len() <= 100), "{text}");
    }
    let diagnostics = emit(&nested_deeply(100, 40), &Options::default()).expect_err("too deep");
    assert!(diagnostics.iter().all(|d| d.code == Code::E0901 && d.message.contains("nested too deeply")));
}

#[test]
fn a_long_remark_of_an_arm_stands_below_its_label() {
    let mut b = Build::new("Body");
    let (at, _) = b.state("G", None, &[1]);
    let y = b.bit(Role::Output, "y");
    let yes = b.pool().truth(true);
    let remark =
        "step 1: a comment of such a length that it cannot stand behind the value, not even if nothing else is there";
    b.program.after = vec![
        heading(Heading::Outputs),
        b.case(at, [(1, remark, vec![assign(y, yes)]), (2, "step 2: *)", vec![assign(y, yes)])]),
    ];
    check_body(
        &b.program,
        expect![[r#"
            CASE at_G OF
                1:
                    (* step 1: a comment of such a length that it cannot stand behind the value, not even if
                       nothing else is there *)
                    y := TRUE;
                2:  (* step 2: * ) *)
                    y := TRUE;
            END_CASE;

        "#]],
    );
}

#[test]
fn faults_of_grafc_are_reported() {
    let mut deep = Build::new("Deep");
    let (a, y) = (deep.bit(Role::Input, "a"), deep.bit(Role::Output, "y"));
    let a = deep.read(a);
    let mut value = a;
    for _ in 0..60 {
        let negated = deep.pool().not(value);
        let other = deep.read(y);
        value = deep.pool().and([negated, other]);
    }
    deep.program.after = vec![assign(y, value)];
    let mut branch = Build::new("Branch");
    let a = branch.bit(Role::Input, "a");
    let a = branch.read(a);
    branch.program.after = vec![when(a, vec![heading(Heading::Outputs)])];
    let mut arm = Build::new("Arm");
    let (at, _) = arm.state("G", None, &[1]);
    let mut arms = Build::new("Arms");
    let (none, _) = arms.state("G", None, &[1]);
    arm.program.after = vec![arm.case(at, [(1, "step 1", vec![heading(Heading::Outputs)])])];
    arms.program.after = vec![arms.case(none, [])];
    let mut idle = Build::new("Idle");
    let again = idle.bit(Role::Memory, "again");
    idle.program.repeat = Some(Repeat { again, limit: None });
    for program in [deep.program, branch.program, arm.program, arms.program, idle.program] {
        let diagnostics = emit(&program, &Options::default()).expect_err("it cannot be written");
        assert!(diagnostics.iter().all(|d| d.code == Code::E0901));
    }
}

#[test]
fn a_hundred_thousand_steps() {
    let mut b = Build::new("Large");
    let again = b.bit(Role::Temporary, "again");
    let steps: Vec<VarId> = (0..100_000).map(|n| b.bit(Role::Step, &format!("X{n}"))).collect();
    let read: Vec<FormulaId> = steps.iter().map(|id| b.read(*id)).collect();
    let any = b.pool().or(read.iter().copied());
    b.program.after = steps.iter().zip(read.iter().rev()).map(|(step, value)| assign(*step, *value)).collect();
    b.program.after.push(assign(again, any));
    let text = emit(&b.program, &Options::default()).expect("it can be written");
    assert!(text.lines().count() > 200_000);
    assert!(text.lines().all(|line| line.len() <= 100));
}
