//! The tables of the textbook (Shalyto, chapter 12) for figure 12.6: situations row by row, one micro-step a row, as the
//! book prints them, and what the programs take beside what the book says that its own take.

use grafc_logic::scan::Program;
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::scan::measure;
use grafc_logic::{Encoding, Options};
use grafc_model::chart::Value;
use grafc_model::reaction::{Evolution, Profile, Stimulus};
use grafc_testsuite::binary::root;
use grafc_testsuite::{charts, runs};

/// Table 12.4: method 2, single-phase.
const TABLE_12_4: [&[usize]; 5] = [&[0], &[1], &[2, 5], &[4, 7], &[0]];

/// Table 12.2: method 1, R-triggers.
const TABLE_12_2: [&[usize]; 6] = [&[0], &[0, 1], &[1, 2, 5], &[2, 4, 5, 7], &[4, 7], &[0]];

/// The inputs of figure 12.6 in one row: which of `x0` to `x7` and `xj` are true.
#[derive(Clone, Copy)]
struct Inputs {
    x: [bool; 8],
    xj: bool,
}

impl Inputs {
    const NONE: Inputs = Inputs { x: [false; 8], xj: false };
    const ALL: Inputs = Inputs { x: [true; 8], xj: true };

    /// All but some of `x0` to `x7`.
    fn without(self, numbers: &[usize]) -> Inputs {
        let mut inputs = self;
        for number in numbers {
            inputs.x[*number] = false;
        }
        inputs
    }

    fn without_xj(self) -> Inputs {
        Inputs { xj: false, ..self }
    }
}

/// Figure 12.6 in an encoding, one micro-step a call.
fn figure_12_6(encoding: Encoding) -> Program {
    let path = charts::charts_folder().join("figure_12_6.gct");
    let text = std::fs::read_to_string(path).expect("the chart");
    let chart = charts::check("figure_12_6", &text).expect("a chart");
    let labels: Vec<&str> = chart.steps.iter().map(|step| step.label.as_str()).collect();
    assert_eq!(labels, ["Y0", "Y1", "Y2", "Y3", "Y4", "Y5", "Y6", "Y7"]);
    let profile = Profile { evolution: Evolution::Scan, ..Profile::default() };
    let options = Options { profile, encoding, ..Options::default() };
    runs::compile(&chart, &options).expect("a program")
}

/// The steps that are active after each row of inputs, one micro-step a row. The first row is the initial reaction,
/// which ends with a micro-step of its own.
fn rows(encoding: Encoding, inputs: &[Inputs]) -> Vec<Vec<usize>> {
    let program = figure_12_6(encoding);
    let mut evaluator = Evaluator::new(&program);
    let stimulus = |(row, inputs): (usize, &Inputs)| Stimulus {
        t_ms: 10 * row as i64,
        restart: false,
        inputs: inputs.x.iter().chain([&inputs.xj]).map(|x| Value::Bool(*x)).collect(),
    };
    let stimuli = inputs.iter().enumerate().map(stimulus);
    stimuli.map(|s| evaluator.react(&s).situation.into_iter().map(|step| step.index()).collect()).collect()
}

/// In how many cells two tables agree.
fn cells(one: &[Vec<usize>], other: &[Vec<usize>]) -> usize {
    assert_eq!(one.len(), other.len());
    let same = |(a, b): (&Vec<usize>, &Vec<usize>)| (0..8).filter(|y| a.contains(y) == b.contains(y)).count();
    one.iter().zip(other).map(same).sum()
}

fn table(rows: &[&[usize]]) -> Vec<Vec<usize>> {
    rows.iter().map(|row| row.to_vec()).collect()
}

/// All 40 cells. Methods 2 and 4 and the decomposition differ in how they are written, not in what they do.
#[test]
fn table_12_4_single_phase() {
    let inputs = [Inputs::NONE, Inputs::ALL, Inputs::ALL, Inputs::ALL, Inputs::ALL];
    for encoding in [Encoding::SinglePhase, Encoding::Sequent, Encoding::Switch] {
        assert_eq!(rows(encoding, &inputs), table(&TABLE_12_4), "{}", encoding.name());
    }
}

/// The conditions that table 12.2 must have been made with: `xj` holds from the last row on, and `x0` no longer does.
const INPUTS_12_2: [Inputs; 6] = [
    Inputs::NONE,
    Inputs { x: [true; 8], xj: false },
    Inputs { x: [true; 8], xj: false },
    Inputs { x: [false, true, true, true, true, true, true, true], xj: false },
    Inputs { x: [false, true, true, true, true, true, true, true], xj: false },
    Inputs { x: [false, true, true, true, true, true, true, true], xj: true },
];

/// Method 1 by the book's formulas (table 12.1), `NOT R AND (S OR Y)` for each step, from the situation before. The book
/// computes Y0 first and in place; all others read the new Y0 then.
fn method_1(y: &[usize], inputs: &Inputs, y0_in_place: bool) -> Vec<usize> {
    let mut old = [false; 8];
    for step in y {
        old[*step] = true;
    }
    let Inputs { x, xj } = *inputs;
    let y0 = !old[1] && (old[4] && old[7] && xj || old[0]);
    let [mut seen_y0, y1, y2, y3, y4, y5, y6, y7] = old;
    if y0_in_place {
        seen_y0 = y0;
    }
    let new = [
        y0,
        !(y2 || y5) && (seen_y0 && x[0] || y1),
        !(y3 || y4) && (y1 && x[1] || y2),
        !y4 && (y2 && x[3] && !x[2] || y3),
        !seen_y0 && (y2 && x[2] || y3 && x[4] || y4),
        !(y6 || y7) && (y1 && x[1] || y5),
        !y7 && (y5 && x[6] && !x[5] || y6),
        !seen_y0 && (y5 && x[5] || y6 && x[7] || y7),
    ];
    (0..8).filter(|step| new[*step]).collect()
}

/// The rows of method 1 from Y0 on.
fn method_1_rows(inputs: &[Inputs], y0_in_place: bool) -> Vec<Vec<usize>> {
    let mut situation = vec![0];
    let mut rows = Vec::new();
    for row in inputs {
        situation = method_1(&situation, row, y0_in_place);
        rows.push(situation.clone());
    }
    rows
}

/// All 48 cells come out where Y0 is computed in place. The encoding computes all steps at once: then the last hand-over,
/// from Y4 and Y7 to Y0, overlaps for one micro-step like all others, and the last row of the book comes one micro-step
/// later.
#[test]
fn table_12_2_r_trigger() {
    let book = table(&TABLE_12_2);
    assert_eq!(method_1_rows(&INPUTS_12_2, true), book);

    let mut inputs = INPUTS_12_2.to_vec();
    inputs.push(INPUTS_12_2[5]);
    let ours = rows(Encoding::RTrigger, &inputs);
    assert_eq!(ours[..5], book[..5]);
    assert_eq!((&book[5], &ours[5]), (&vec![0], &vec![0, 4, 7]), "here Y0 in place makes the difference");
    assert_eq!(ours[6], book[5]);
    assert_eq!(cells(&ours[..6], &book), 46);
}

/// With every condition true all the time 46 of 48 cells agree too: Y0 comes one row early, as `xj` is not waited for,
/// and starts the next round.
#[test]
fn table_12_2_with_all_conditions_true() {
    let mut inputs = [Inputs::ALL; 6];
    inputs[0] = Inputs::NONE;
    let ours = rows(Encoding::RTrigger, &inputs);
    let wanted: [&[usize]; 6] = [&[0], &[0, 1], &[1, 2, 5], &[2, 4, 5, 7], &[0, 4, 7], &[0, 1]];
    assert_eq!(ours, table(&wanted));
    assert_eq!(cells(&ours, &table(&TABLE_12_2)), 46);
}

/// The formulas of table 12.1 beside the encoding, also on the branches that the tables leave out.
#[test]
fn r_triggers_are_those_of_table_12_1() {
    let long_way = Inputs::ALL.without(&[2, 5]);
    let inputs = [
        Inputs::NONE,
        Inputs::ALL.without(&[1]),
        Inputs::ALL.without(&[0]),
        long_way.without(&[4, 7]),
        long_way.without(&[0, 4]),
        long_way.without(&[0, 7]),
        long_way.without_xj(),
        long_way.without(&[0]),
        long_way.without(&[0]),
        long_way,
        Inputs::NONE,
        long_way,
        long_way,
    ];
    let ours = rows(Encoding::RTrigger, &inputs);
    assert_eq!(ours, method_1_rows(&inputs, false));
    for step in 0..8 {
        assert!(ours.iter().any(|row| row.contains(&step)), "Y{step} is never active: {ours:?}");
    }
}

/// Where a step is set by the one before it while the one after it is active already, S wins, where an R-trigger would
/// never set it. By `S OR NOT R AND X`, one micro-step a row: `1 := NOT 2·1`, `2 := 1·a OR NOT 3·2`, `3 := 2·b OR 3`.
#[test]
fn s_triggers_set_what_is_set_and_reset() {
    let text = "input a, b : bool initial step 1 step 2 initial step 3 transition 1 -> 2 : a transition 2 -> 3 : b";
    let chart = charts::check("two_tokens", text).expect("a chart");
    let profile = Profile { evolution: Evolution::Scan, ..Profile::default() };
    let options = Options { profile, encoding: Encoding::STrigger, ..Options::default() };
    let program = runs::compile(&chart, &options).expect("a program");
    let mut evaluator = Evaluator::new(&program);
    for (row, (a, situation)) in
        [(false, vec![0, 2]), (true, vec![0, 1, 2]), (true, vec![1, 2]), (true, vec![2])].into_iter().enumerate()
    {
        let inputs = vec![Value::Bool(a), Value::Bool(false)];
        let response = evaluator.react(&Stimulus { t_ms: 10 * row as i64, restart: false, inputs });
        let ours: Vec<usize> = response.situation.into_iter().map(|step| step.index()).collect();
        assert_eq!(ours, situation, "row {row}");
    }
}

/// At most as many as the book's own programs, and `docs/statistics.md` says the same.
#[test]
fn the_figures_of_the_book() {
    let page = std::fs::read_to_string(root().join("docs/statistics.md")).expect("the page");
    for (method, encoding, instructions, variables) in [
        ("1, R-triggers", Encoding::RTrigger, 81, 16),
        ("4, sequents", Encoding::Sequent, 71, 14),
        ("decomposition with priorities", Encoding::Switch, 53, 6),
    ] {
        let ours = measure(&figure_12_6(encoding));
        let all = ours.state_bits + ours.states.len() + ours.auxiliary_bits + ours.auxiliary_numbers;
        let row = format!(
            "| {method} | {instructions} | {variables} | `{}` | {} | {all} |\n",
            encoding.name(),
            ours.instructions
        );
        assert!(page.contains(&row), "docs/statistics.md lacks\n{row}");
        assert!(all <= variables, "{row}");
        assert!(ours.instructions <= instructions, "{row}");
    }
    assert!(measure(&figure_12_6(Encoding::Switch)).states.len() <= 3);
}
