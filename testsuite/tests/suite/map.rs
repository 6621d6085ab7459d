//! Which lines come from which element: what the code says in its comments and names, the map says, too.

use grafc::{Options, Product};
use grafc_backends::choice::Chosen;
use grafc_backends::{Element, Kind, Map, Target};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_testsuite::charts::{Case, cases, charts_folder, vectors_folder};

/// A chart in a target under an encoding.
struct Mapped {
    name: String,
    code: String,
    map: Map,
}

impl Mapped {
    fn new(case: &Case, encoding: Encoding, target: Target) -> Self {
        let name = format!("{} {} {}", case.name, encoding.name(), target.about().name);
        let lowering = Lowering { profile: case.profile, encoding, simplify: true };
        let options = Options::new(lowering, Product::Mapped(target));
        let (made, diagnostics) = grafc::compile(FileId::default(), &case.text, &case.name, &options);
        let made = made.unwrap_or_else(|| panic!("{name}: {diagnostics:?}"));
        Mapped { code: made.text, map: made.map.unwrap_or_else(|| panic!("{name}: no map")), name }
    }

    /// The elements that a line comes from, counted from 1.
    fn of_line(&self, line: u32) -> impl Iterator<Item = &Element> {
        let is_here = move |(first, last): &(u32, u32)| (*first..=*last).contains(&line);
        self.map.elements.iter().filter(move |element| element.lines.iter().any(is_here))
    }

    fn lines(&self) -> impl Iterator<Item = (u32, &str)> {
        (1..).zip(self.code.lines())
    }
}

/// The comment on a line, without what stands around it.
fn comment(line: &str) -> Option<&str> {
    let at = ["(* ", "/// ", "// "].iter().find_map(|open| line.find(open).map(|at| at + open.len()))?;
    Some(line[at..].trim_end().trim_end_matches("*)").trim_end())
}

/// Whether a comment is about what is written so: that alone, or that and a comment of the chart's.
fn says(comment: &str, what: &str) -> bool {
    comment.strip_prefix(what).is_some_and(|rest| rest.is_empty() || rest.starts_with(": "))
}

fn all(test: impl Fn(&Mapped)) {
    let charts = cases(&charts_folder());
    let mut count = 0;
    for about in Target::ALL.iter().filter(|about| about.mapped) {
        for case in &charts {
            for encoding in Encoding::ALL {
                test(&Mapped::new(case, encoding, about.target(&Chosen::new()).expect("what is usual")));
                count += 1;
            }
        }
    }
    assert!(count >= 16 * 5 * 5, "only {count} maps");
    // Vectors are many; what is special in them is special in any target.
    let st = Target::ALL.iter().find(|about| about.name == "st").expect("a target");
    for case in &cases(&vectors_folder()) {
        for encoding in [Encoding::SinglePhase, Encoding::Switch] {
            test(&Mapped::new(case, encoding, st.target(&Chosen::new()).expect("what is usual")));
        }
    }
}

#[test]
fn the_step_or_transition_in_a_comment_is_that_of_the_map() {
    all(|mapped| {
        let with_arrow = |e: &&Element| e.kind == Kind::Transition && e.at.as_ref().is_some_and(|at| at.is_ascii());
        let transitions: Vec<&Element> = mapped.map.elements.iter().filter(with_arrow).collect();
        for (number, line) in mapped.lines() {
            let Some(comment) = comment(line) else { continue };
            let arrow = |e: &Element| e.at.clone().unwrap_or_default();
            if transitions.iter().any(|e| says(comment, &arrow(e))) {
                let found = mapped.of_line(number).any(|e| e.kind == Kind::Transition && says(comment, &arrow(e)));
                assert!(found, "{}: line {number} is about {comment}", mapped.name);
            }
            for step in mapped.map.elements.iter().filter(|e| e.kind == Kind::Step && e.name.is_ascii()) {
                if says(comment, &format!("step {}", step.name)) {
                    let found = mapped.of_line(number).any(|e| e == step);
                    assert!(found, "{}: line {number} is about {comment}", mapped.name);
                }
            }
        }
    });
}

/// Where clearings are latched or written by their transition, each transition that has lines is named on one of them.
#[test]
fn a_transition_is_named_on_its_lines() {
    let mut named = 0;
    let count = std::cell::RefCell::new(&mut named);
    all(|mapped| {
        if mapped.name.contains("-trigger") {
            return;
        }
        let lines: Vec<&str> = mapped.code.lines().collect();
        for transition in mapped.map.elements.iter().filter(|e| e.kind == Kind::Transition && !e.lines.is_empty()) {
            let arrow = transition.at.as_deref().unwrap_or_default();
            let mut own = transition.lines.iter().flat_map(|(first, last)| *first..=*last);
            let is_named = own.any(|line| comment(lines[line as usize - 1]).is_some_and(|text| says(text, arrow)));
            // A long comment goes over several lines, and each of them may begin as the first one does.
            let is_named = is_named
                || transition.lines.iter().any(|(first, last)| {
                    let run = lines[*first as usize - 1..*last as usize].iter();
                    let bare = run.flat_map(|line| line.trim_start().trim_start_matches('/').split_whitespace());
                    bare.collect::<Vec<_>>().join(" ").contains(arrow)
                });
            assert!(is_named || !arrow.is_ascii(), "{}: {arrow} is on none of {:?}", mapped.name, transition.lines);
            **count.borrow_mut() += 1;
        }
    });
    assert!(named > 1000, "only {named} were looked for");
}

/// A variable of the chart stands on all lines of its declaration, except where it is remembered under another name.
#[test]
fn a_declaration_has_its_lines() {
    all(|mapped| {
        let lines: Vec<&str> = mapped.code.lines().collect();
        for element in mapped.map.elements.iter().filter(|e| e.kind == Kind::Declaration) {
            assert!(!element.lines.is_empty(), "{}: nothing declares {}", mapped.name, element.name);
            let (first, _) = element.lines[0];
            // Names may have to be changed: what is compared is what no target changes.
            let plain = element.name.to_lowercase();
            let simple = plain.len() > 1 && plain.chars().all(|c| c.is_ascii_lowercase());
            let own = lines[first as usize - 1..].iter().take(2).any(|line| line.to_lowercase().contains(&plain));
            assert!(own || !simple, "{}: {} is not on line {first}", mapped.name, element.name);
        }
    });
}

/// Lines lie within the text, in order, and no run meets the next.
#[test]
fn runs_of_lines_are_in_order() {
    all(|mapped| {
        let count = mapped.code.lines().count() as u32;
        for element in &mapped.map.elements {
            let mut before = 0;
            for (first, last) in &element.lines {
                assert!((before == 0 || before + 1 < *first) && first <= last && *last <= count, "{}", mapped.name);
                assert!(*first > 0);
                before = *last;
            }
        }
        let starts: Vec<u32> = mapped.map.elements.iter().map(|element| element.span.start).collect();
        assert!(starts.is_sorted(), "{}: elements come in the order of the chart", mapped.name);
    });
}
