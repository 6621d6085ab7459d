//! What is written, as Structured Text and as an instruction list, is taken by MATIEC, its C code by gcc, and the result
//! behaves.
//!
//! `iec2c` must be on the search path with its library beside it (or `MATIEC_LIB` must name the library); otherwise
//! these tests say that they checked nothing.

use super::{Build, assign, body, call, four_steps, nested, nested_deeply};
use crate::iec::{Options, Pou};
use crate::{il, st};
use grafc_diagnostics::Diagnostics;
use grafc_formula::{Arithmetic, Comparison, FormulaId, Type, Value};
use grafc_logic::scan::{Division, Flag, Origin, Preset, Program, Role, Statement, VarId};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

type Emit = fn(&Program, &Options) -> Result<String, Diagnostics>;

/// Both languages.
const LANGUAGES: [Emit; 2] = [st::emit, il::emit];

/// The compiler and its library.
struct Matiec {
    compiler: PathBuf,
    library: PathBuf,
}

/// Looks for MATIEC.
fn matiec() -> Option<Matiec> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let found = std::env::split_paths(&path).map(|folder| folder.join("iec2c")).find(|file| file.is_file());
    let found = found.and_then(|compiler| {
        let beside = compiler.canonicalize().ok()?.parent()?.join("lib");
        let given = std::env::var_os("MATIEC_LIB").map(PathBuf::from);
        let library = given.into_iter().chain([beside]).find(|folder| folder.join("ieclib.txt").is_file())?;
        Some(Matiec { compiler, library })
    });
    if found.is_none() {
        skipped("iec2c");
    }
    found
}

/// Says so on the process's own standard error, because a passing test's output is not shown.
fn skipped(tool: &str) {
    let _ = writeln!(std::io::stderr(), "skipped: {tool} is not on the search path");
}

impl Matiec {
    /// Compiles to C in a folder.
    fn compile(&self, folder: &Path, text: &str) {
        let source = folder.join("source.st");
        std::fs::write(&source, text).expect("the folder can be written");
        let mut command = Command::new(&self.compiler);
        command.arg("-I").arg(&self.library).arg("-T").arg(folder).arg(&source);
        let output = command.output().expect("iec2c runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{said}\n{text}");
    }

    /// Runs gcc on files of a folder; nothing if there is no gcc.
    fn gcc(&self, folder: &Path, arguments: &[&str]) -> bool {
        let mut command = Command::new("gcc");
        command.arg("-w").arg("-I").arg(self.library.join("C")).args(arguments).current_dir(folder);
        match command.output() {
            Ok(output) => {
                assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
                true
            }
            Err(_) => {
                skipped("gcc");
                false
            }
        }
    }
}

/// Compiles a program with its configuration, and the C code.
fn taken(program: &Program) {
    let Some(matiec) = matiec() else { return };
    for emit in LANGUAGES {
        let folder = tempfile::tempdir().expect("a folder");
        let options = Options { pou: Pou::Configuration, ..Options::default() };
        matiec.compile(folder.path(), &emit(program, &options).expect("it can be written"));
        // The file of the resource takes in the others.
        let files = std::fs::read_dir(folder.path()).expect("the folder can be read");
        let mut names = files.map(|file| file.expect("an entry").file_name().to_string_lossy().into_owned());
        let resource = names.find(|name| name.starts_with("resource") && name.ends_with(".c")).expect("a resource");
        matiec.gcc(folder.path(), &["-fsyntax-only", &resource]);
    }
}

#[test]
fn a_chart_of_four_steps() {
    taken(&four_steps());
}

#[test]
fn states_in_states() {
    taken(&nested());
    // As deep as encodings nest states, with a formula as deep as they leave it.
    taken(&nested_deeply(17, 40));
}

#[test]
fn a_body_of_a_hundred_thousand_bytes() {
    let inputs = [("a", Type::Bool), ("b", Type::Bool)];
    taken(&body(&inputs, Type::Bool, |_, i, y| (0..4200).map(|n| assign(y, i[n % 2])).collect()));
}

#[test]
fn all_names_that_charts_use() {
    let mut b = Build::new("main");
    let names = [
        "X1",
        "T1",
        "S1",
        "R1",
        "X",
        "T",
        "S",
        "R",
        "N",
        "P",
        "D",
        "L",
        "SD",
        "ET",
        "PT",
        "IN",
        "CLK",
        "CU",
        "Q",
        "on",
        "step",
        "time",
        "en",
        "null",
        "eof",
        "nan",
        "m_pi",
        "ton",
        "max",
        "int_max",
        "Насос",
        "a__b",
        "x_",
        "😀",
        "this",
        "chart",
        "cycle",
        "resource_1",
        "TRUE",
        "continue",
        "line_max",
        "big_endian",
        "plc",
        "interval",
        "data__",
    ];
    let long = "long_".repeat(2000);
    for name in names.into_iter().chain([long.as_str()]) {
        b.bit(Role::Input, name);
    }
    taken(&b.program);
}

/// Every type with every operation that its values take.
#[test]
fn all_forms() {
    let mut b = Build::new("Forms");
    let types = [Type::Int, Type::Dint, Type::Uint, Type::Udint, Type::Real, Type::Lreal, Type::Time];
    let flag = b.bit(Role::Flag(Flag::Div0), "DIV0");
    let truth = b.bit(Role::Output, "truth");
    b.program.variables[truth].address = Some("%QX0.0".into());
    let mut variables: Vec<(VarId, FormulaId)> = Vec::new();
    let widths = [Some("W"), Some("D"), Some("W"), Some("D"), Some("D"), Some("L"), None];
    for (place, ty) in types.into_iter().enumerate() {
        for (role, area) in [(Role::Input, "I"), (Role::Output, "Q"), (Role::Internal, "M")] {
            let id = b.var(role, &format!("{area}_{place}"), ty);
            b.program.variables[id].address = widths[place].map(|width| format!("%{area}{width}{place}").into());
        }
        let result = b.var(Role::Output, &format!("result_{place}"), ty);
        let value = b.var(Role::Input, &format!("value_{place}"), ty);
        let value = b.read(value);
        variables.push((result, value));
    }
    for (ty, value) in [
        (Type::Bool, Value::Bool(true)),
        (Type::Int, Value::Int(-32768)),
        (Type::Dint, Value::Int(-2_147_483_648)),
        (Type::Uint, Value::Int(65535)),
        (Type::Udint, Value::Int(4_294_967_295)),
        (Type::Real, Value::Real(f64::from(f32::MAX))),
        (Type::Real, Value::Real(f64::from(-1e-7f32))),
        (Type::Lreal, Value::Real(-1e-7)),
        (Type::Lreal, Value::Real(1e20)),
        (Type::Time, Value::Time(i64::from(i32::MAX))),
        (Type::Time, Value::Time(500)),
    ] {
        for role in [Role::Constant, Role::Internal, Role::Output] {
            let id = b.var(role, "limit_of_type", ty);
            b.program.variables[id].set_initial(value);
        }
        let result = b.var(Role::Temporary, "limit_of_type", ty);
        let value = b.pool().constant(value, ty);
        b.program.after.push(assign(result, value));
    }
    let mut out = Vec::new();
    let (result_int, int) = variables[0];
    for (place, ty) in types.into_iter().enumerate() {
        let (result, value) = variables[place];
        let constant = match ty {
            Type::Real | Type::Lreal => Value::Real(-0.5),
            Type::Time => Value::Time(90_000),
            Type::Int | Type::Dint => Value::Int(-5),
            Type::Uint | Type::Udint | Type::Bool => Value::Int(5),
        };
        let p = b.pool();
        let constant = p.constant(constant, ty);
        for op in [Arithmetic::Add, Arithmetic::Subtract, Arithmetic::Multiply] {
            if (ty, op) == (Type::Time, Arithmetic::Multiply) {
                for (_, number) in &variables[..4] {
                    let product = p.arithmetic(op, ty, *number, value);
                    out.push(assign(result, product));
                }
                let number = p.constant(Value::Int(3), Type::Int);
                let product = p.arithmetic(op, ty, constant, number);
                out.push(assign(result, product));
                continue;
            }
            for (x, y) in [(value, constant), (constant, value), (value, value)] {
                let value = p.arithmetic(op, ty, x, y);
                out.push(assign(result, value));
            }
        }
        let negative = p.negate(value);
        out.push(assign(result, negative));
        for op in [
            Comparison::Equal,
            Comparison::NotEqual,
            Comparison::Less,
            Comparison::LessEqual,
            Comparison::Greater,
            Comparison::GreaterEqual,
        ] {
            let compared = p.compare(op, value, constant);
            out.push(assign(truth, compared));
        }
        let divide = |modulo, dividend, divisor| {
            Statement::Divide(Division { target: result, modulo, dividend, divisor, flag, origin: Origin::Chart })
        };
        match ty {
            Type::Time => out.extend(variables[..4].iter().map(|(_, number)| divide(false, value, *number))),
            Type::Real | Type::Lreal => {
                out.extend([(value, constant), (constant, value), (value, value)].map(|(a, b)| divide(false, a, b)));
            }
            Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Bool => {
                for (a, b) in [(value, constant), (constant, value), (value, value)] {
                    out.extend([divide(false, a, b), divide(true, a, b)]);
                }
            }
        }
    }
    for (from, to) in [(0, 1), (0, 4), (0, 5), (1, 5), (2, 3), (2, 1), (2, 4), (2, 5), (3, 5), (4, 5)] {
        let wide = b.pool().widen(types[to], variables[from].1);
        out.push(assign(variables[to].0, wide));
        let compared = b.pool().compare(Comparison::Less, wide, variables[to].1);
        out.push(assign(truth, compared));
    }
    let eight = b.var(Role::Constant, "eight", Type::Time);
    b.program.variables[eight].set_initial(Value::Time(8000));
    let presets = [None, Some(Preset { ms: 8000, constant: Some(eight) }), Some(Preset { ms: 1500, constant: None })];
    for preset in presets {
        let timer = b.timer("timer", preset, "");
        let p = b.pool();
        let (done, elapsed) = (p.timer_done(timer), p.timer_elapsed(timer));
        let late = p.compare(Comparison::Greater, elapsed, variables[6].1);
        let both = p.and([done, late]);
        let differ = p.xor(done, both);
        out.push(call(timer, late));
        out.extend([assign(truth, both), assign(truth, differ), assign(variables[6].0, elapsed)]);
    }
    let zero = b.pool().constant(Value::Int(0), Type::Int);
    out.push(Statement::Divide(Division {
        target: result_int,
        modulo: true,
        dividend: int,
        divisor: zero,
        flag,
        origin: Origin::Chart,
    }));
    b.program.after.extend(out);
    taken(&b.program);
}

/// Plays calls at times in milliseconds and compares the lines that they print. `scan` is C code that gives the inputs,
/// calls the instance `block` of the block's type and prints.
fn plays(program: &Program, scan: &str, calls: &[(&str, &str)]) {
    let Some(matiec) = matiec() else { return };
    let block = program.name.to_uppercase();
    let head = r#"
        #include "iec_std_lib.h"
        #include "accessor.h"
        #include "POUS.h"
        TIME __CURRENT_TIME;
        BOOL __DEBUG;
        #include "POUS.c"
        #include <stdio.h>
        static TIME at(long ms) {
            TIME time = { ms / 1000, ms % 1000 * 1000000 };
            return time;
        }
    "#;
    let calls_in_c: String = calls.iter().map(|(call, _)| format!("scan({call});\n")).collect();
    let main = format!(
        "{head}\nstatic {block} block;\n{scan}\nint main(void) {{ {block}_init__(&block, 0);\n{calls_in_c}}}\n"
    );
    let expected: Vec<&str> = calls.iter().map(|(_, expected)| *expected).collect();
    for emit in LANGUAGES {
        let folder = tempfile::tempdir().expect("a folder");
        matiec.compile(folder.path(), &emit(program, &Options::default()).expect("it can be written"));
        std::fs::write(folder.path().join("main.c"), &main).expect("the folder can be written");
        if !matiec.gcc(folder.path(), &["main.c", "-o", "main"]) {
            return;
        }
        let output = Command::new(folder.path().join("main")).output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stdout);
        assert_eq!(said.lines().collect::<Vec<_>>(), expected);
    }
}

/// The stirrer runs for eight seconds; two rising edges within one call count once.
#[test]
fn four_steps_behave() {
    let scan = r#"static void scan(long ms, int start, int high, int low) {
        __CURRENT_TIME = at(ms);
        block.START.value = start, block.HIGH.value = high, block.LOW.value = low;
        FILLING_body__(&block);
        printf("%d%d%d %d%d%d%d %d %d\n", block.INLET.value, block.STIRRER.value, block.OUTLET.value, block.X1.value,
            block.X2.value, block.X3.value, block.X4.value, block.BATCHES.value, block.LIVELOCK.value);
    }"#;
    plays(
        &four_steps(),
        scan,
        &[
            ("0, 1, 0, 0", "000 1000 0 0"), // the button is held at the start: no edge
            ("100, 0, 0, 0", "000 1000 0 0"),
            ("200, 1, 0, 0", "100 0100 0 0"),
            ("300, 1, 1, 1", "010 0010 1 0"),
            ("8299, 1, 1, 1", "010 0010 1 0"),
            ("8300, 1, 0, 1", "001 0001 1 0"),
            ("9000, 1, 0, 0", "000 1000 1 0"),
            ("9100, 0, 0, 0", "000 1000 1 0"),
            ("9200, 1, 1, 1", "010 0010 2 0"), // filling is transient
        ],
    );
}

/// States in states: what is enclosed starts with the step that encloses it and ends with it.
#[test]
fn nested_states_behave() {
    let scan = r#"static void scan(int a, int b) {
        block.A.value = a, block.B.value = b;
        NESTED_body__(&block);
        printf("%d %d %d\n", block.Y.value, block.AT_G.value, block.AT_H.value);
    }"#;
    plays(
        &nested(),
        scan,
        &[
            ("0, 0", "0 -1 0"),
            ("1, 0", "0 2 21"),
            ("1, 1", "1 2 22"),
            ("1, 0", "1 2 22"),
            ("0, 1", "0 -1 0"),
            ("1, 1", "1 2 22"), // two micro-steps in one call
        ],
    );
}

/// The least number by -1 wraps around to itself, without a remainder.
#[test]
fn the_least_number_is_divided() {
    let program = body(&[("k", Type::Dint)], Type::Dint, |b, i, y| {
        let flag = b.bit(Role::Flag(Flag::Div0), "DIV0");
        let rest = b.var(Role::Output, "rest", Type::Dint);
        let dividend = b.pool().constant(Value::Int(-2_147_483_648), Type::Dint);
        let divide = |target, modulo| {
            Statement::Divide(Division { target, modulo, dividend, divisor: i[0], flag, origin: Origin::Chart })
        };
        vec![divide(y, false), divide(rest, true)]
    });
    let name = program.name.to_uppercase();
    let scan = r#"static void scan(int k) {
        block.K.value = k;
        NAME_body__(&block);
        printf("%d %d %d\n", block.Y.value, block.REST.value, block.DIV0.value);
    }"#;
    plays(
        &program,
        &scan.replace("NAME", &name),
        &[
            ("-1", "-2147483648 0 0"),
            ("2", "-1073741824 0 0"),
            ("3", "-715827882 -2 0"),
            ("1", "-2147483648 0 0"),
            ("0", "0 0 1"),
        ],
    );
}
