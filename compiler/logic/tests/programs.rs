//! What a scan program holds, and above all what it does not: nothing that the chart does not use, and no more than
//! is needed where the net itself proves that it is not.

use grafc_diagnostics::{Diagnostics, FileId};
use grafc_formula::Type;
use grafc_logic::scan::{Program, Role, Statement, VarId, verify};
use grafc_logic::{Analysis, Encoding, Options, compile};
use grafc_model::reaction::{Evolution, Profile};

fn compiled(text: &str, profile: Profile) -> Program {
    compiled_by(text, &Options { profile, ..Options::default() })
}

fn compiled_by(text: &str, options: &Options) -> Program {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    assert!(!diagnostics.has_errors(), "{diagnostics:?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "chart");
    let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")));
    let mut diagnostics = Diagnostics::new();
    grafc_net::passes::run(&mut net, false, &mut diagnostics);
    compile(Analysis::new(net), options).0
}

fn program(text: &str) -> Program {
    compiled(text, Profile::default())
}

/// The names of the variables of ours.
fn ours(program: &Program) -> Vec<&str> {
    let chart = [Role::Input, Role::Output, Role::Internal, Role::Constant, Role::Step];
    program.variables.iter().filter(|v| !chart.contains(&v.role)).map(|v| v.name.as_str()).collect()
}

/// How often a variable is read by the value of the assignments to another.
fn reads(program: &Program, of: &str, by: &str) -> usize {
    let name = |v: VarId| program.variables[v].name.as_str();
    let mut count = 0;
    for statement in &program.micro_step {
        if let Statement::Assign { target, value, .. } = statement
            && name(*target) == by
        {
            count += program
                .pool
                .below(*value)
                .into_iter()
                .filter(|f| matches!(program.pool.get(*f), grafc_formula::Formula::Variable(v) if name(*v) == of))
                .count();
        }
    }
    count
}

#[test]
fn four_steps_need_little() {
    let program = program(
        "input a, b, c, d : bool  output Q : bool
         initial step 1  step 2 { Q }  step 3  step 4
         transition 1 -> 2 : a  transition 2 -> 3 : b  transition 3 -> 4 : c  transition 4 -> 1 : d",
    );
    assert_eq!(
        ours(&program),
        ["again", "micro_steps", "LIVELOCK", "clr_1_2", "clr_2_3", "clr_3_4", "clr_4_1", "started"]
    );
    assert_eq!(reads(&program, "X2", "again"), 0, "one token: every clearing moves it");
    assert_eq!(program.micro_step.len(), 11, "four clearings, `again`, four steps, two headings");
}

#[test]
fn the_counter_of_micro_steps_holds_the_bound() {
    // Where both inputs are true it never rests, so there has to be a bound.
    let text = "input a, b : bool  initial step 1  step 2  transition 1 -> 2 : a  transition 2 -> 1 : b";
    let of = |bound| {
        let program = compiled(text, Profile { bound: Some(bound), ..Profile::default() });
        let repeat = program.repeat.expect("a loop");
        {
            let limit = repeat.limit.expect("no bound is proved");
            (limit.bound, program.variables[limit.count].ty)
        }
    };
    assert_eq!(of(32_767), (32_767, Type::Int));
    assert_eq!(of(32_768), (32_768, Type::Dint));
    assert_eq!(of(u32::MAX), (2_147_483_647, Type::Dint));
    assert_eq!(of(0), (1, Type::Int), "a reaction is at least one micro-step");
}

#[test]
fn what_is_proved_to_end_is_not_counted() {
    let repeat = |text: &str| program(text).repeat.map(|repeat| repeat.limit.is_some());
    let steps = "input a, b : bool  initial step 1  step 2  step 3";
    // 2 -> 3 may follow 1 -> 2 at once, and then nothing more can.
    assert_eq!(repeat(&format!("{steps}  transition 1 -> 2 : a  transition 2 -> 3 : b")), Some(false));
    // After an edge of an input nothing waits that needs no edge.
    assert_eq!(repeat(&format!("{steps}  transition 1 -> 2 : ↑a  transition 2 -> 3 : ↑b")), None);
    assert_eq!(repeat(&format!("{steps}  transition 1 -> 2 : a  transition 2 -> 1 : b")), Some(true));
}

#[test]
fn one_evolution_a_scan_has_no_loop() {
    let text = "input a : bool  initial step 1  step 2  transition 1 -> 2 : a";
    let program = compiled(text, Profile { evolution: Evolution::Scan, ..Profile::default() });
    assert!(program.repeat.is_none());
    assert_eq!(ours(&program), ["clr_1_2", "started"]);
}

#[test]
fn branches_that_exclude_each_other_keep_one_token() {
    let divergence = |second: &str| {
        program(&format!(
            "input a, b : bool  initial step 1  step 2  step 3
             transition 1 -> 2 : a and not b  transition 1 -> 3 : {second}
             transition 2 -> 1 : b  transition 3 -> 1 : not b",
        ))
    };
    assert_eq!(reads(&divergence("b"), "X2", "again"), 0);
    assert_eq!(reads(&divergence("a"), "X2", "again"), 1, "both may clear: two steps may be active");
}

#[test]
fn parallel_branches_are_components() {
    let program = program(
        "input a : bool  output P : bool
         initial step 1  step 2 { P := 1 on activation }  step 3  step 4 { P := 0 on activation }
         transition 1 -> 2, 3 : a  transition 2, 3 -> 4 : 1  transition 4 -> 1 : not a",
    );
    assert_eq!(reads(&program, "X2", "again") + reads(&program, "X3", "again"), 0);
    assert!(!ours(&program).contains(&"ALLOC_CONFLICT"), "2 and 4 are not activated at once");
}

#[test]
fn a_source_transition_brings_further_tokens() {
    let program = program("input a, b : bool  initial step 1  step 2  transition -> 1 : a  transition 1 -> 2 : b");
    assert!(reads(&program, "X1", "again") > 0);
}

#[test]
fn deep_conditions_are_cut_into_pieces() {
    let mut condition = "a".to_owned();
    for _ in 0..1000 {
        condition = format!("(b or (a and {condition}))");
    }
    let program = program(&format!("input a, b : bool  initial step 1  step 2  transition 1 -> 2 : {condition}"));
    assert!(program.pool.ids().all(|f| program.pool.depth(f) <= 60));
    // Two thousand levels, of which a piece takes at most sixty; each is named after its transition.
    let pieces = ours(&program).into_iter().filter(|name| *name == "part_1_2" || name.starts_with("part_1_2_")).count();
    assert!(ours(&program).contains(&"part_1_2") && pieces >= 2000 / 60, "{:?}", ours(&program));
}

#[test]
fn every_read_has_a_value() {
    let mut program = program("input a : bool  initial step 1  step 2  transition 1 -> 2 : ↑a");
    assert_eq!(verify(&program), Ok(()));
    let edge = program
        .micro_step
        .iter()
        .position(|s| matches!(s, Statement::Assign { target, .. } if program.variables[*target].name == "rise_a"));
    program.micro_step.remove(edge.expect("the edge"));
    assert!(verify(&program).is_err(), "`rise_a` is read and never set");
}

/// Two steps of one component are never active together, so the last transition never clears. It leaves a state as it is, and
/// yet switches an output; of an action nothing is said beside it.
#[test]
fn a_transition_that_only_switches_an_output() {
    let text = "input a, b : bool  output Q : bool
         initial step 1 { Q }  step 2
         transition 1 -> 2 : a  transition 2 -> 1 : b  transition 1, 2 -> 2 : a";
    for simplify in [false, true] {
        let program = compiled_by(text, &Options { encoding: Encoding::Switch, simplify, ..Options::default() });
        assert_eq!(verify(&program), Ok(()));
    }
}

/// Every `CASE` over states that stands in a list, with its arms and what stands in these: `at_G(1 2:[at_H(3)])`.
fn cases(program: &Program, statements: &[Statement]) -> Vec<String> {
    let case = |statement: &Statement| {
        let Statement::Case { of, arms } = statement else { return None };
        let arms = arms.iter().map(|arm| match &cases(program, &arm.body)[..] {
            [] => arm.value.to_string(),
            inside => format!("{}:[{}]", arm.value, inside.join(" ")),
        });
        let arms: Vec<String> = arms.collect();
        Some(format!("{}({})", program.variables[*of].name, arms.join(" ")))
    };
    statements.iter().filter_map(case).collect()
}

/// MAIN, whose steps have these actions, and P, its child, in what is around them; by the encoding `switch`, as it does
/// large charts.
fn run_by(actions: [&str; 3], around: &str) -> Program {
    let [zero, one, two] = actions;
    let main = if around.is_empty() { "grafcet MAIN { initial" } else { "grafcet X5/MAIN { initial activated" };
    let text = format!(
        "input a, b, m : bool output V : bool
         {around}
         {main} step 0 {{ {zero} }} step 1 {{ {one} }} step 2 {{ {two} }}
           transition 0 -> 1 : m transition 1 -> 2 : a and not m transition 2 -> 0 : b and not a and not m }}
         child grafcet P of MAIN {{ initial step 10 step 11 {{ V }}
           transition 10 -> 11 : a and not b transition 11 -> 10 : b and not a }}"
    );
    let program = compiled_by(&text, &Options { encoding: Encoding::Switch, simplify: false, ..Options::default() });
    assert_eq!(verify(&program), Ok(()));
    program
}

#[test]
fn the_machine_of_a_child_stands_in_the_arm_of_the_step_that_runs_it() {
    let program = run_by(["", "run P", ""], "");
    assert_eq!(cases(&program, &program.micro_step), ["at_MAIN(0 1:[at_P(10 11)] 2)"]);
    let program = run_by(["", "start P on activation kill P on deactivation", ""], "");
    assert_eq!(cases(&program, &program.micro_step), ["at_MAIN(0 1:[at_P(10 11)] 2)"]);
}

#[test]
fn the_machine_of_a_child_that_several_steps_run_stands_once_beside_theirs() {
    let program = run_by(["", "run P", "run P"], "");
    assert_eq!(cases(&program, &program.micro_step), ["at_MAIN(0 1 2)", "at_P(10 11)"]);
    // So it does in the arm that theirs stands in.
    let around = "grafcet TOP { initial enclosing step 5 step 6 transition 5 -> 6 : a }";
    let program = run_by(["run P", "", "run P"], around);
    assert_eq!(cases(&program, &program.micro_step), ["at_TOP(5:[at_MAIN(0 1 2) at_P(10 11)])"]);
}

#[test]
fn what_is_frozen_as_well_has_bits_beside_the_machine_that_commands_it() {
    let program = run_by(["", "run P freeze P on event ↑b", "resume P on activation"], "");
    let states: Vec<&str> = program.states.iter().map(|s| program.variables[s.variable].name.as_str()).collect();
    assert_eq!(states, ["at_MAIN"]);
    assert_eq!(cases(&program, &program.micro_step), ["at_MAIN(0 1 2)"]);
}
