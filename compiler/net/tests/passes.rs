//! The net as built, and what each pass does to it.

use grafc_diagnostics::{Diagnostics, FileId};
use grafc_model::chart::{ExprKind, MacroId, StepId, TransitionId, Value};
use grafc_net::net::Forced;
use grafc_net::{Fact, Net, build, passes};

fn net(text: &str) -> Net {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    assert!(!diagnostics.has_errors(), "{diagnostics:?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "chart");
    build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")))
}

/// The net of a text after all passes; those for overlapping steps only if asked.
fn flat(text: &str, overlap: bool) -> Net {
    let mut net = net(text);
    let mut diagnostics = Diagnostics::new();
    passes::run(&mut net, overlap, &mut diagnostics);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    net
}

fn labels(net: &Net, steps: &[StepId]) -> Vec<String> {
    steps.iter().map(|s| net.places[*s].label.to_string()).collect()
}

const MACRO: &str = "
    input a, b, c : bool
    initial step 1
    macro step M3
    step 2
    transition 1 -> M3 : a
    transition M3 -> 2 : b
    expansion M3 {
      step E3
      macro step M4
      step S3
      transition E3 -> M4 : c
      transition M4 -> S3 : c
    }
    expansion M4 { step E4 step S4 transition E4 -> S4 : 1 }
";

#[test]
fn arcs_of_a_macro_step_lead_to_its_entry_and_from_its_exit() {
    let built = net(MACRO);
    assert_eq!(labels(&built, &built.transitions[TransitionId::new(0)].post), [""; 0], "still an arc into M3");
    let net = flat(MACRO, false);
    assert!(net.facts.contains(&Fact::NoMacroSteps));
    let arcs: Vec<_> = net.transitions.iter().map(|t| (labels(&net, &t.pre), labels(&net, &t.post))).collect();
    let arc = |from: &str, to: &str| (vec![from.to_owned()], vec![to.to_owned()]);
    assert_eq!(arcs, [arc("1", "E3"), arc("S3", "2"), arc("E3", "E4"), arc("S4", "S3"), arc("E4", "S4")]);
}

#[test]
fn the_activity_of_a_macro_step_is_that_of_its_expansion() {
    let net = net(MACRO);
    let outer = &net.macro_steps[MacroId::new(0)];
    assert_eq!(labels(&net, &outer.places), ["E3", "S3"]);
    assert_eq!(outer.inner, [MacroId::new(1)], "nested expansions count too");
}

#[test]
fn the_order_of_the_higher_grafcet_wins_then_the_first() {
    // G1 is above G2, so the order of step 1 comes first though it is declared last.
    let net = flat(
        "grafcet G2 {
           initial step 20 { force G3{*} force G3{INIT} }
           step 21 { force G3{} }
           transition 20 -> 21 : 1
         }
         grafcet G3 { initial step 30 step 31 initial step 32 transition 30 -> 31 : 1 transition 31 -> 32 : 1 }
         grafcet G1 { initial step 1 { force G2{20} force G3{32, 31} } step 2 transition 1 -> 2 : 1 }",
        false,
    );
    let grafcet = net.grafcets.iter().find(|g| g.name == "G3").expect("G3");
    let orders: Vec<(&str, Option<Vec<String>>)> = grafcet
        .orders
        .iter()
        .map(|order| {
            let steps = match &order.forced {
                Forced::Steps(steps) => Some(labels(&net, steps)),
                Forced::Current => None,
            };
            (net.places[order.step].label.as_str(), steps)
        })
        .collect();
    let set = |labels: &[&str]| Some(labels.iter().map(|l| (*l).to_string()).collect());
    // {INIT} is what the chart marks, although step 1 forces another start.
    assert_eq!(orders, [("1", set(&["31", "32"])), ("20", None), ("20", set(&["30", "32"])), ("21", set(&[]))]);
}

/// The labels of the initial places after all passes, and whether orders disagree in them.
fn start(text: &str) -> (Vec<String>, bool) {
    let net = flat(text, false);
    let initial: Vec<StepId> = net.places.indices().filter(|s| net.places[*s].initial).collect();
    (labels(&net, &initial), net.conflict_at_start)
}

/// What two grafcets look like that make and obey orders.
fn forced(orders: &str, more: &str) -> (Vec<String>, bool) {
    start(&format!(
        "grafcet G1 {{ initial step 1 {{ {orders} }} initial step 2 {{ {more} }} transition 1 -> 2 : 1 }}
         grafcet G2 {{ initial step 10 step 11 transition 10 -> 11 : 1 }}"
    ))
}

#[test]
fn orders_of_initial_steps_decide_on_the_start() {
    assert_eq!(forced("", ""), (vec!["1".into(), "2".into(), "10".into()], false));
    assert_eq!(forced("force G2{11}", ""), (vec!["1".into(), "2".into(), "11".into()], false));
    assert_eq!(forced("force G2{}", ""), (vec!["1".into(), "2".into()], false));
    assert_eq!(forced("force G2{*}", ""), (vec!["1".into(), "2".into(), "10".into()], false));
    // Orders on the same situation agree, others do not: the first wins.
    assert_eq!(forced("force G2{10}", "force G2{INIT}"), (vec!["1".into(), "2".into(), "10".into()], false));
    assert_eq!(forced("force G2{10}", "force G2{*}"), (vec!["1".into(), "2".into(), "10".into()], true));
    assert_eq!(forced("force G2{}", "force G2{11}"), (vec!["1".into(), "2".into()], true));
}

#[test]
fn links_count_at_the_start_unless_the_enclosing_step_is_initial() {
    let text = |orders: &str| {
        format!(
            "grafcet G1 {{ initial step 1 {{ {orders} }} step 2 transition 1 -> 2 : 1 }}
             grafcet G2 {{ initial enclosing step 20 enclosing step 21 transition 20 -> 21 : 1 }}
             grafcet X20/G3 {{ initial step 30 activated step 31 transition 30 -> 31 : 1 }}
             grafcet X21/G4 {{ step 40 activated step 41 transition 40 -> 41 : 1 }}"
        )
    };
    assert_eq!(start(&text("")).0, ["1", "20", "30"]);
    assert_eq!(start(&text("force G2{21}")).0, ["1", "21", "41"]);
    assert_eq!(start(&text("force G3{}")).0, ["1", "20"]);
    // An enclosure of an inactive step obeys no order, so its orders do not disagree either.
    assert_eq!(start(&text("force G4{40}")), (vec!["1".into(), "20".into(), "30".into()], false));
    assert!(!start(&text("force G4{40} force G4{}")).1);
    assert!(start(&text("force G2{21} force G4{40} force G4{}")).1);
}

const NESTED: &str = "
    grafcet G1 { initial step 1 { force G2{*} force G5{*} } step 2 transition 1 -> 2 : 1 }
    grafcet G2 { initial enclosing step 20 step 21 transition 20 -> 21 : 1 }
    grafcet X20/G3 { initial enclosing activated step 30 step 31 transition 30 -> 31 : 1 }
    grafcet X30/G4 { initial enclosing activated step 40 transition -> 40 : 1 }
    grafcet X40/G5 { initial enclosing activated step 50 transition 50 -> : 1 }
    grafcet X50/G6 { initial activated step 60 transition -> 60 : 1 }
";

#[test]
fn freezing_comes_from_the_nearest_grafcet_with_orders() {
    let net = flat(NESTED, false);
    let frozen_with: Vec<Option<&str>> =
        net.grafcets.iter().map(|g| g.frozen_with.map(|p| net.grafcets[p].name.as_str())).collect();
    assert_eq!(frozen_with, [None, None, Some("G2"), Some("G2"), Some("G2"), Some("G5")]);
}

#[test]
fn what_an_enclosure_holds_is_within_the_enclosing_step() {
    let net = flat(NESTED, false);
    let within = |around: &[StepId]| {
        assert!(around.len() < 2);
        around.first().map(|s| net.places[*s].label.as_str())
    };
    let places: Vec<_> = net.places.iter().map(|p| (p.label.as_str(), within(&p.within))).collect();
    let expected = [
        ("1", None),
        ("2", None),
        ("20", None),
        ("21", None),
        ("30", Some("20")),
        ("31", Some("20")),
        ("40", Some("30")),
        ("50", Some("40")),
        ("60", Some("50")),
    ];
    assert_eq!(places, expected);
    let transitions: Vec<_> = net.transitions.iter().map(|t| within(&t.within)).collect();
    assert_eq!(transitions, [None, None, Some("20"), Some("30"), Some("40"), Some("50")]);
    assert!(net.grafcets.iter().all(|g| g.enclosing_step.is_none()));
}

/// What each of these grafcets is within, and how many commands are left.
fn nested(text: &str, grafcets: &[&str]) -> (Vec<Vec<String>>, usize) {
    let net = flat(text, false);
    assert!(net.facts.contains(&Fact::NestedChildren));
    let within = |name: &&str| {
        let g = net.grafcets.indices().find(|g| net.grafcets[*g].name == **name).expect("the grafcet");
        labels(&net, net.within(g))
    };
    (grafcets.iter().map(within).collect(), net.commands().count())
}

/// MAIN, steps 1 to 3 of which have these actions, and P, a child of it.
fn commanded(actions: [&str; 3], more: &str) -> (Vec<String>, usize) {
    let [one, two, three] = actions;
    let (within, left) = nested(
        &format!(
            "input a : bool
             grafcet MAIN {{
               initial step 0 step 1 {{ {one} }} step 2 {{ {two} }} step 3 {{ {three} }}
               transition 0 -> 1 : a transition 1 -> 2 : a transition 2 -> 3 : a
             }}
             child grafcet P of MAIN {{ initial step 10 step 11 transition 10 -> 11 : a }}
             {more}"
        ),
        &["P"],
    );
    (within[0].clone(), left)
}

#[test]
fn a_child_that_steps_run_is_within_them() {
    let within = |steps: &[&str]| (steps.iter().map(|s| (*s).to_owned()).collect(), 0);
    assert_eq!(commanded(["run P", "", ""], ""), within(&["1"]));
    assert_eq!(commanded(["", "run P", "run P"], ""), within(&["2", "3"]));
    let pair = "start P on activation kill P on deactivation";
    assert_eq!(commanded([pair, "", ""], ""), within(&["1"]), "the same as `run`");
    assert_eq!(commanded(["kill P on deactivation start P on activation", "", ""], ""), within(&["1"]));
    // Frozen by an order it keeps its situation; what is around it may be frozen without it.
    assert_eq!(commanded(["run P", "force P{*}", ""], ""), within(&["1"]));
    assert_eq!(commanded(["run P", "", ""], "grafcet TOP { initial step 90 { force MAIN{*} } }"), within(&["1"]));
}

#[test]
fn a_child_that_is_commanded_otherwise_stays_one() {
    let stays = |actions, more: &str, commands: usize| {
        assert_eq!(commanded(actions, more), (vec![], commands), "{actions:?} {more}");
    };
    stays(["run P", "kill P on activation", ""], "", 2);
    stays(["run P freeze P on deactivation", "resume P on activation", ""], "", 3);
    stays(["start P on activation", "kill P on activation", ""], "", 2);
    stays(["start P on activation", "kill P on deactivation", ""], "", 2);
    // Where one hands over to the other, these restart.
    let pair = "start P on activation kill P on deactivation";
    stays([pair, pair, ""], "", 4);
    stays([pair, "run P", ""], "", 3);
    // Orders activate it while nothing runs it.
    stays(["run P", "force P{11}", ""], "", 1);
    stays(["run P", "force P{INIT}", ""], "", 1);
    // Frozen or killed, MAIN does the same to P.
    stays(["run P", "", ""], "grafcet TOP { initial step 90 { freeze MAIN on deactivation } }", 2);
    // What P starts is killed with P.
    let q = |actions: &str| {
        format!(
            "grafcet X11/E {{ initial activated step 20 {{ {actions} }} step 21 transition 20 -> 21 : a }}
             child grafcet Q of P {{ initial step 30 }}"
        )
    };
    let more = q("start Q on activation").replace("X11/E", "X10/E");
    let text = |more: &str| {
        format!(
            "input a : bool
             grafcet MAIN {{ initial step 0 {{ run P }} }}
             child grafcet P of MAIN {{ initial enclosing step 10 }}
             {more}"
        )
    };
    assert_eq!(nested(&text(&more), &["P", "Q"]), (vec![vec![], vec![]], 2));
    let more = q("run Q").replace("X11/E", "X10/E");
    let expected = vec![vec!["0".to_owned()], vec!["10".to_owned()], vec!["20".to_owned()]];
    assert_eq!(nested(&text(&more), &["P", "E", "Q"]), (expected, 0));
}

#[test]
fn a_nested_child_begins_with_what_runs_it_and_is_not_frozen_with_it() {
    let net = flat(
        "grafcet TOP { initial step 90 { force MAIN{*} } }
         grafcet MAIN { initial step 1 { run P } }
         child grafcet P of MAIN { initial enclosing step 10 step 11 transition 10 -> 11 : 1 transition -> 11 : 1 }
         grafcet X10/E { activated step 20 initial step 21 }",
        false,
    );
    let of = |wanted: fn(&grafc_net::net::Place) -> bool| {
        let steps: Vec<StepId> = net.places.indices().filter(|s| wanted(&net.places[*s])).collect();
        labels(&net, &steps)
    };
    // 20, since links of what a child encloses count at the start (R15).
    assert_eq!(of(|place| place.initial), ["90", "1", "10", "20"]);
    assert_eq!(of(|place| place.activated), ["10", "20"]);
    let frozen_with: Vec<bool> = net.grafcets.iter().map(|g| g.frozen_with.is_some()).collect();
    assert_eq!(frozen_with, [false; 4]);
    assert!(net.transitions.iter().all(|t| labels(&net, &t.within) == ["1"]), "source transitions as well");
}

/// The arcs of a net in which no two places hand over to each other: `1 2 -> 3`.
fn arcs(net: &Net) -> Vec<String> {
    let side = |steps: &[StepId]| labels(net, steps).join(" ");
    net.transitions.iter().map(|t| format!("{} -> {}", side(&t.pre), side(&t.post))).collect()
}

#[test]
fn a_ring_of_two_gets_a_third_place() {
    let text = "initial step 1 step 2 transition 1 -> 2 : 1 transition 2 -> 1 : 1";
    assert_eq!(arcs(&flat(text, false)), ["1 -> 2", "2 -> 1"], "only where steps overlap");
    let net = flat(text, true);
    assert_eq!(arcs(&net), ["1 -> 2", "2 -> 2_1", "2_1 -> 1"]);
    let (place, transition) = (net.places.last().expect("a place"), net.transitions.last().expect("a transition"));
    assert!(place.auxiliary && !place.initial && !place.activated);
    assert_eq!(net.places.iter().filter(|place| place.auxiliary).count(), 1);
    assert_eq!(labels(&net, &net.grafcets[place.grafcet].steps), ["1", "2", "2_1"]);
    assert_eq!(net.exprs[transition.condition].kind, ExprKind::Literal(Value::Bool(true)));
    assert_eq!((place.span, transition.span), (net.transitions[1].span, net.transitions[1].span));
}

#[test]
fn only_rings_of_two_are_broken() {
    for text in [
        "initial step 1 step 2 step 3 transition 1 -> 2 : 1 transition 2 -> 3 : 1 transition 3 -> 1 : 1",
        "initial step 1 step 2 transition 1 -> 1 : 1 transition 1 -> 2 : 1",
        // Both stay active: nothing is handed over.
        "initial step 1 initial step 2 transition 1, 2 -> 1, 2 : 1",
        // Step 2 is needed for the way on and kept, so it does not follow 1.
        "initial step 1 initial step 2 step 3 transition 1, 2 -> 2, 3 : 1 transition 2 -> 1 : 1",
    ] {
        assert!(flat(text, true).places.iter().all(|place| !place.auxiliary), "{text}");
    }
}

#[test]
fn one_place_serves_all_ways_back() {
    // Two transitions back to 1, from two steps, one of them in parallel with 4.
    let net = flat(
        "initial step 1 step 2 step 3 step 4
         transition 1 -> 2, 3 : 1
         transition 2 -> 1 : 1
         transition 3 -> 4, 1 : 1
         transition 4 -> 1 : 1",
        true,
    );
    assert_eq!(arcs(&net), ["1 -> 2 3", "2 -> 2_1", "3 -> 4 2_1", "4 -> 1", "2_1 -> 1"]);
}

#[test]
fn a_resource_that_is_taken_and_given_back_is_a_ring() {
    // 1 and R hand over to 2, which gives R back: R and 2 are a ring, 1 and 2 are not.
    let net = flat(
        "initial step R initial step 1 step 2 step 3
         transition 1, R -> 2 : 1
         transition 2 -> 3, R : 1",
        true,
    );
    assert_eq!(arcs(&net), ["1 R -> 2", "2 -> 3 2_R", "2_R -> R"]);
}

#[test]
fn a_new_label_is_like_no_other() {
    let net = flat(
        "initial step A step B step B_A step 1 step M macro step M_1
         transition A -> B : 1 transition B -> A, B_A : 1
         transition 1 -> M : 1 transition M -> 1 : 1 transition M -> M_1 : 1
         expansion M_1 { step E_1 step S_1 transition E_1 -> S_1 : 1 }",
        true,
    );
    let new: Vec<&str> = net.places.iter().filter(|p| p.auxiliary).map(|p| p.label.as_str()).collect();
    assert_eq!(new, ["B_A_2", "M_1_2"]);
}

#[test]
fn a_new_place_stands_where_the_one_after_it_stands() {
    let net = flat(
        "input a : bool
         grafcet G1 { initial enclosing step 1 step 2 transition 1 -> 2 : a }
         grafcet X1/G2 {
           initial activated step 10
           macro step M1
           transition 10 -> M1 : a
         }
         expansion M1 { step E1 step S1 transition E1 -> S1 : a transition S1 -> E1 : a }",
        true,
    );
    let (id, place) = net.places.iter_enumerated().next_back().expect("a place");
    assert_eq!(place.label, "S1_E1");
    assert_eq!(labels(&net, &place.within), ["1"]);
    assert_eq!(net.grafcets[place.grafcet].name, "G2");
    assert!(net.macro_steps[MacroId::new(0)].places.contains(&id), "the macro-step is active with it");
    assert_eq!(net.transitions.last().map(|t| &t.within), Some(&place.within));
}

#[test]
fn wide_transitions_are_searched_no_longer_than_they_are_wide() {
    // 20 000 ways from one side to the other and back: 400 million pairs.
    let side = |first: usize| (first..first + 20_000).map(|n| n.to_string()).collect::<Vec<_>>();
    let steps = |side: &[String]| side.iter().map(|n| format!("step {n}\n")).collect::<String>();
    let (left, right) = (side(100_000), side(200_000));
    let mut net = net(&format!(
        "initial step 1\n{2}{3}transition 1 -> {0} : 1\ntransition {0} -> {1} : 1\ntransition {1} -> {0} : 1\n",
        left.join(", "),
        right.join(", "),
        steps(&left),
        steps(&right)
    ));
    let pass = passes::ORDER.iter().find(|pass| pass.name == "break-two-step-rings").expect("the pass");
    (pass.run)(&mut net, &mut Diagnostics::new());
    // Each step of the left side has its place, whether its ring was looked for or not.
    assert!(net.transitions[TransitionId::new(2)].post.iter().all(|s| net.places[*s].auxiliary));
    assert_eq!(net.places.iter().filter(|place| place.auxiliary).count(), 20_000);
}
