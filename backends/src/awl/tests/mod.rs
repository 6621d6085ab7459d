//! Statement lists, read line by line.

mod conditions;
mod numbers;
mod whole;

use super::{Mnemonics, Options, emit, instructions};
use crate::st::tests::{Build, assign, body, call, nested, nested_deeply, when};
use grafc_diagnostics::Code;
use grafc_formula::{Comparison, FormulaId, Type, Value};
use grafc_logic::scan::{Flag, Limit, Preset, Program, Repeat, Role, Statement};

fn text(program: &Program) -> String {
    emit(program, &Options::default()).expect("it can be written")
}

/// The instructions of the function block as one line, `A #a, = #y`, without what `RESTART` does and without `BE`.
fn list(program: &Program) -> Listing {
    let text = text(program);
    let (_, body) = text.split_once("\nBEGIN\n").expect("a body");
    let (body, _) = body.split_once("\nEND_FUNCTION_BLOCK").expect("its end");
    let lines = body.lines().map(|line| line.split("//").next().unwrap_or_default());
    let words = |line: &str| line.split_ascii_whitespace().collect::<Vec<_>>().join(" ");
    let lines: Vec<String> = lines.map(words).filter(|line| line.ends_with(';')).collect();
    assert_eq!(instructions(program).expect("it can be counted"), lines.len() as u64, "{text}");
    let all = lines.join(" ");
    let (_, restart) = all.split_once("JCN ").expect("a jump over the restart");
    let (_, after) = restart.split_once(&format!("{}: ", &restart[..4])).expect("the label behind the restart");
    Listing(after.trim_end_matches(" BE;").trim_end_matches("BE;").trim_end_matches(';').replace(';', ","))
}

/// Instructions on a line; labels are the same if each stands at the same places.
#[derive(Debug)]
struct Listing(String);

impl Listing {
    /// With the labels counted as they come.
    fn counted(text: &str) -> String {
        let words: Vec<&str> = text.split(' ').collect();
        let mut labels: Vec<&str> = Vec::new();
        let jumps = words.windows(2).filter(|pair| matches!(pair[0], "JC" | "JCN" | "JU")).map(|pair| pair[1]);
        let places = words.iter().filter(|word| word.len() == 5 && word.ends_with(':'));
        let names = jumps.map(|word| word.trim_end_matches(',')).chain(places.map(|word| word.trim_end_matches(':')));
        let all: std::collections::BTreeSet<&str> = names.collect();
        let mut out = Vec::new();
        for word in &words {
            let name = word.trim_end_matches([',', ':']);
            if !all.contains(name) {
                out.push((*word).to_owned());
                continue;
            }
            let place = labels.iter().position(|label| *label == name).unwrap_or_else(|| {
                labels.push(name);
                labels.len() - 1
            });
            out.push(format!("label {place}{}", &word[name.len()..]));
        }
        out.join(" ")
    }
}

impl std::ops::Deref for Listing {
    type Target = String;

    fn deref(&self) -> &String {
        &self.0
    }
}

impl std::fmt::Display for Listing {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl PartialEq<String> for Listing {
    fn eq(&self, expected: &String) -> bool {
        *self == expected.as_str()
    }
}

impl PartialEq<&str> for Listing {
    fn eq(&self, expected: &&str) -> bool {
        Listing::counted(&self.0) == Listing::counted(expected)
    }
}

const BITS: [(&str, Type); 5] =
    [("f5", Type::Bool), ("g", Type::Bool), ("h", Type::Bool), ("j", Type::Bool), ("k", Type::Bool)];

/// Bits are set and reset where a condition holds, without a jump; a jump that is not taken leaves a true result behind.
#[test]
fn bits_are_set_and_reset() {
    let program = body(&BITS, Type::Bool, |b, i, y| {
        let z = b.bit(Role::Output, "y2");
        let n = b.var(Role::Output, "count", Type::Int);
        let (yes, no) = (b.pool().truth(true), b.pool().truth(false));
        let (both, zero) = (b.pool().and([i[0], i[1]]), b.pool().constant(Value::Int(0), Type::Int));
        vec![
            when(both, vec![assign(y, yes), assign(z, no)]),
            when(i[2], vec![assign(z, yes), assign(n, zero)]),
            Statement::choice(vec![(i[3], vec![assign(y, no)])], vec![assign(y, yes)]),
            assign(y, no),
            assign(z, no),
        ]
    });
    assert_eq!(
        list(&program),
        "A #f5, A #g, S #y, R #y2, A #h, JCN M002, S #y2, L 0, T #count, \
         M002: A #j, JCN M004, R #y, JU M003, M004: SET, = #y, M003: CLR, = #y, = #y2"
    );
}

/// A timer is started by the rise of its input; what it measures is a difference of the block's clock.
#[test]
fn a_timer_reads_the_clock() {
    let mut b = Build::new("Wait");
    let (go, y) = (b.bit(Role::Input, "go"), b.bit(Role::Output, "y"));
    let ends = b.timer("d_go", Some(Preset { ms: 1500, constant: None }), "1500ms/go");
    let go = b.read(go);
    let done = b.pool().timer_done(ends);
    b.program.after = vec![call(ends, go), assign(y, done)];
    let program = b.program;
    // Half of 2^31 ms is 1073741824.
    let clock = [
        "    L     #NOW;",
        "      L     #last_now;",
        "      -D;",
        "      AD    DW#16#7FFFFFFF;",
        "      L     L#1073741824;",
        "      >D;",
        "      JC    MMNS;                         // NOW was put back: no time",
        "      TAK;",
        "      L     #clock;",
        "      +D;",
        "      T     #clock;",
        "MMNS: L     #NOW;",
    ];
    assert!(text(&program).contains(&clock.join("\n")));
    assert_eq!(
        list(&program),
        "A #go, FP #d_go_run, JCN M002, L #clock, T #d_go_start, \
         M002: L #clock, L #d_go_start, -D, L L#1500, >=D, O #d_go, A #d_go_run, = #d_go, A #d_go, = #y"
    );
    let text = text(&program);
    for declared in ["NOW : TIME;", "d_go : BOOL;", "d_go_run : BOOL;", "d_go_start : DINT;", "clock : DINT;"] {
        assert!(text.contains(&format!("    {declared}")), "{declared} in {text}");
    }
}

/// The time since the start does not fall where the difference wraps around after 24 days.
#[test]
fn a_timer_measures() {
    let mut b = Build::new("Measure");
    let (go, y) = (b.bit(Role::Input, "go"), b.var(Role::Output, "y", Type::Time));
    let since = b.timer("T_go", None, "");
    let go = b.read(go);
    let elapsed = b.pool().timer_elapsed(since);
    b.program.after = vec![call(since, go), assign(y, elapsed)];
    assert_eq!(
        list(&b.program),
        "A #go, FP #T_go_run, JCN M002, L #clock, T #T_go_start, M002: A #T_go_run, JC M003, L L#0, JU M004, \
         M003: L #clock, L #T_go_start, -D, L #T_go, <D, JC M005, TAK, M004: T #T_go, M005: L #T_go, T #y"
    );
}

#[test]
fn the_loop_has_a_bound() {
    let counted = |ty: Type, bound: u32| {
        let mut b = Build::new("Loop");
        let (again, count) = (b.bit(Role::Temporary, "again"), b.var(Role::Temporary, "micro_steps", ty));
        let go = b.bit(Role::Input, "go");
        let flag = b.bit(Role::Flag(Flag::Livelock), "LIVELOCK");
        let go = b.read(go);
        b.program.micro_step = vec![b.noted(again, go, "1 -> 1: on and on")];
        b.program.repeat = Some(Repeat { again, limit: Some(Limit { count, bound, flag }) });
        list(&b.program)
    };
    assert_eq!(
        counted(Type::Dint, 2_147_483_647),
        "L 0, T #micro_steps, M002: L #micro_steps, L L#1, +D, T #micro_steps, A #go, = #again, \
         L #micro_steps, L L#2147483647, <D, A #again, JC M002, A #again, S #LIVELOCK"
    );
    assert_eq!(
        counted(Type::Uint, 200),
        "L 0, T #micro_steps, M002: L #micro_steps, L 1, +I, T #micro_steps, A #go, = #again, \
         L #micro_steps, L L#200, <D, A #again, JC M002, A #again, S #LIVELOCK"
    );
}

/// Everything that keeps its value is as before the first call: bits by their initial value, all zeros at once.
#[test]
fn restart() {
    let mut b = Build::new("Again");
    let (x1, x2) = (b.bit(Role::Step, "X1"), b.bit(Role::Step, "X2"));
    b.program.variables[x1].set_initial(Value::Bool(true));
    let (n, k) = (b.var(Role::Internal, "n", Type::Int), b.var(Role::Output, "k2", Type::Real));
    let (t, c) = (b.var(Role::Temporary, "tmp", Type::Int), b.var(Role::Constant, "limit", Type::Int));
    b.program.variables[k].set_initial(Value::Real(2.5));
    b.program.variables[c].set_initial(Value::Int(7));
    let (_, _, limit) = (x2, t, b.read(c));
    b.program.after = vec![assign(n, limit)];
    let text = text(&b.program);
    let (_, part) = text.split_once("TITLE =restart: as before the first call\n").expect("a network");
    let (part, _) = part.split_once("\nM001:").or(part.split_once("\n\n")).expect("its end");
    let words: Vec<&str> = part.split_ascii_whitespace().take_while(|word| *word != "NETWORK").collect();
    assert_eq!(words.join(" "), "A #RESTART; JCN S5S7; S #X1; R #X2; L L#0; T #n; L 2.5; T #k2;");
    // The constant is in the declarations for STEP 7 and in the data block for awlsim.
    assert!(
        text.contains("    limit : INT := 7;\n")
            && text.contains("BEGIN\n    X1 := TRUE;\n    k2 := 2.5;\n    limit := 7;"),
        "{text}"
    );
}

/// What S7-300 and S7-400 do not have is an error with its place.
#[test]
fn what_does_not_fit() {
    let codes = |program: &Program| -> Vec<Code> {
        emit(program, &Options::default()).expect_err("it does not fit").iter().map(|one| one.code).collect()
    };
    let program = body(&[("x", Type::Lreal)], Type::Bool, |b, i, y| {
        let zero = b.pool().constant(Value::Real(0.0), Type::Lreal);
        vec![assign(y, b.program.pool.compare(Comparison::Less, i[0], zero))]
    });
    assert_eq!(codes(&program), [Code::E0504]);
    let program = body(&[("w", Type::Time)], Type::Bool, |b, i, y| {
        let long = b.pool().constant(Value::Time(2_147_483_648), Type::Time);
        vec![assign(y, b.program.pool.compare(Comparison::Less, i[0], long))]
    });
    assert_eq!(codes(&program), [Code::E0505]);
    // 11,000 times three instructions are more than 32,768.
    let program = body(&BITS, Type::Bool, |b, i, y| {
        let both = b.pool().and([i[0], i[1]]);
        (0..11_000).map(|_| assign(y, both)).collect()
    });
    assert_eq!(codes(&program), [Code::E0506]);
}

/// Names are short, known to no STL, and as near to the chart's as they can be.
#[test]
fn names_fit_into_the_language() {
    let mut b = Build::new("Überlaufbecken der zweiten Reinigungsstufe");
    let wanted = [
        "m",
        "M10",
        "t1",
        "Tür",
        "X1",
        "SPB",
        "JC",
        "a_name_of_more_than_24_letters_A",
        "a_name_of_more_than_24_letters_B",
    ];
    let inputs: Vec<_> = wanted.iter().map(|name| b.bit(Role::Input, name)).collect();
    let y = b.bit(Role::Output, "RESTART");
    let all: Vec<FormulaId> = inputs.iter().map(|id| b.read(*id)).collect();
    let all = b.pool().and(all);
    b.program.after = vec![assign(y, all)];
    assert_eq!(
        list(&b.program),
        "A #m_1, A #M10_1, A #t1_1, A #Tuer, A #X1, A #SPB_1, A #JC_1, A #a_name_of_more_than_24_l, \
         A #a_name_of_more_than_sjd, = #RESTART"
    );
    let text = text(&b.program);
    assert!(text.is_ascii());
    assert!(text.contains("    RESTART_1 : BOOL;") && text.contains("// `M10`\n"), "{text}");
    assert!(text.contains("    a_name_of_more_than_") && text.contains("TITLE =Ueberlaufbecken_der_zwei\n"));
}

/// Labels are four characters long however many there are, and no two are the same.
#[test]
fn labels() {
    let mut code = super::code::Code::new(Mnemonics::default(), false);
    let labels: Vec<String> = (0..12_999).map(|_| code.new_label()).collect();
    assert!(code.labels_suffice());
    assert!(labels.iter().all(|label| label.len() == 4 && label.is_ascii()));
    let mut unique = labels.clone();
    unique.sort();
    unique.dedup();
    assert_eq!(unique.len(), 12_999);
    code.new_label();
    assert!(!code.labels_suffice());
}

#[test]
fn deep_programs_are_written() {
    let program = nested_deeply(60, 80);
    let text = text(&program);
    assert!(text.ends_with("END_DATA_BLOCK\n"), "{text}");
    assert!(instructions(&nested()).is_ok());
}
