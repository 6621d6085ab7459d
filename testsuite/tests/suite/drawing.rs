//! Drawings: the lint over every chart there is, and what a drawing promises besides.

use grafc_drawing::{Group, Options, Page, Picture, Shape, draw, svg};
use grafc_model::chart::{Chart, Tables};
use grafc_testsuite::charts::{charts_folder, check, vectors_folder};
use grafc_testsuite::drawing_lint::lint;
use grafc_testsuite::random::{ChartKind, Draw, checked, checked_draw, with_claims};
use quick_xml::Reader;
use quick_xml::events::Event;
use std::fs;
use std::path::{Path, PathBuf};

const SINGLE: Options = Options { grafcet: None, situation: Vec::new(), page: None, revision: None };

/// The charts of a folder, by name.
fn charts(folder: &Path) -> Vec<(String, Chart)> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "gct"));
    paths.sort();
    let read = |path: &PathBuf| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(path).expect("a text");
        let chart = check(&name, &text).unwrap_or_else(|error| panic!("{error}"));
        (name, chart)
    };
    paths.iter().map(read).collect()
}

/// What is wrong with the drawings of a chart, on one sheet and on pages.
fn faults(name: &str, chart: &Tables) -> Vec<String> {
    let mut found = Vec::new();
    for page in [None, Some(Page::A4), Some(Page::A3)] {
        // All steps are active: their dots must have room.
        let situation = chart.steps.iter().map(|step| step.label.to_string()).collect();
        let options = Options { page, revision: page.map(|_| "A".to_string()), situation, ..SINGLE };
        let pictures = draw(chart, &options).expect("nothing was asked for that is not there");
        found.extend(lint(chart, &pictures).into_iter().map(|fault| format!("{name}, {page:?}: {fault}")));
        let texts = pictures.iter().map(|picture| svg(picture, page));
        found.extend(texts.filter_map(|text| xml_fault(&text)).map(|fault| format!("{name}, {page:?}: {fault}")));
    }
    found
}

/// Where a parser refuses a text as XML.
fn xml_fault(text: &str) -> Option<String> {
    let mut reader = Reader::from_str(text);
    let mut open = 0_usize;
    loop {
        match reader.read_event() {
            Ok(Event::Start(start)) => {
                open += 1;
                if let Some(fault) = start.attributes().find_map(Result::err) {
                    return Some(fault.to_string());
                }
            }
            Ok(Event::End(_)) => open -= 1,
            Ok(Event::Eof) if open == 0 => return None,
            Ok(Event::Eof) => return Some("it ends within an element".to_owned()),
            Ok(_) => {}
            Err(fault) => return Some(fault.to_string()),
        }
    }
}

#[test]
fn a_text_that_is_no_xml_is_noticed() {
    assert_eq!(xml_fault("<svg><g a=\"1\">&lt;</g></svg>"), None);
    for wrong in ["<svg><g></svg></g>", "<svg>", "<svg a=\"1\" a=\"2\"></svg>", "<svg"] {
        assert!(xml_fault(wrong).is_some(), "{wrong}");
    }
}

fn assert_no_faults(found: &[String]) {
    assert!(found.is_empty(), "{} faults, such as\n{}", found.len(), found[..found.len().min(12)].join("\n"));
}

#[test]
fn charts_vectors_and_imports_are_drawn_without_faults() {
    let imports = charts_folder().with_file_name("imports");
    let folders = [charts_folder(), vectors_folder(), imports];
    let all: Vec<(String, Chart)> = folders.iter().flat_map(|folder| charts(folder)).collect();
    assert!(all.len() > 130, "only {} charts", all.len());
    let found: Vec<String> = all.iter().flat_map(|(name, chart)| faults(name, chart)).collect();
    assert_no_faults(&found);
}

#[test]
fn pages_are_never_drawn_much_smaller() {
    // A step is a centimetre wide on paper; what misses a page by less than half is drawn smaller, the rest is cut.
    let folders = [charts_folder(), vectors_folder()];
    for (name, chart) in folders.iter().flat_map(|folder| charts(folder)) {
        let pictures = draw(&chart, &Options { page: Some(Page::A4), ..SINGLE }).expect("nothing was asked for");
        let most = f64::from(Page::A4.millimetres().0 * 4) * 1.5 + 1.0;
        assert!(pictures.iter().all(|picture| f64::from(picture.bounds.width()) <= most), "{name}");
    }
}

#[test]
fn a_thousand_random_charts_are_drawn_without_faults() {
    let mut found = Vec::new();
    for seed in 0..1000 {
        let kind = [ChartKind::Hierarchical, ChartKind::Flat, ChartKind::Plain][seed as usize % 3];
        let drawn = if seed % 10 == 9 { checked_draw(seed, Draw { kind, size: 4 }) } else { checked(seed, kind) };
        let pictures = draw(&drawn.chart, &SINGLE).expect("nothing was asked for");
        found.extend(lint(&drawn.chart, &pictures).into_iter().map(|fault| format!("{seed} {kind:?}: {fault}")));
        if seed % 20 == 0 {
            let (_, claimed) = with_claims(&drawn);
            found.extend(faults(&format!("{seed} {kind:?}"), &claimed));
        }
    }
    assert_no_faults(&found);
}

#[test]
fn the_same_chart_gives_the_same_bytes() {
    for (_, chart) in charts(&charts_folder()) {
        let text = || -> Vec<String> {
            draw(&chart, &SINGLE).expect("a drawing").iter().map(|picture| svg(picture, None)).collect()
        };
        assert_eq!(text(), text());
    }
}

/// A chart with a step more on the way of one transition,.
fn with_a_step_more(text: &str, line: usize) -> Option<String> {
    let lines: Vec<&str> = text.lines().collect();
    let (head, condition) = lines[line].split_once(" : ")?;
    let (before, after) = head.split_once("->")?;
    if !before.trim_start().starts_with("transition") || after.contains(',') || after.trim().is_empty() {
        return None;
    }
    let new = format!("  step New\n{before}-> New : {condition}\n  transition New -> {} : 1", after.trim());
    let changed = lines.iter().enumerate().map(|(at, old)| if at == line { new.as_str() } else { *old });
    Some(changed.collect::<Vec<_>>().join("\n"))
}

/// Where each step and transition stands within its grafcet, by class and name.
fn places(chart: &Chart) -> Vec<(String, (i32, i32))> {
    let pictures = draw(chart, &SINGLE).expect("a drawing");
    let elements = pictures.iter().flat_map(|picture| &picture.groups).flat_map(|frame| &frame.groups);
    let named = elements.filter(|group| !group.class.starts_with("link") && !group.class.starts_with("sync"));
    named.map(|group| (format!("{} {}", group.class, group.data[0].1), (group.at.x, group.at.y))).collect()
}

#[test]
fn a_step_that_is_added_moves_nothing_above_it() {
    let mut tried = 0;
    for name in ["press_a", "weigh_mix_b2", "figure_12_6", "lock_12_2", "weigh_mix_b3"] {
        let path = charts_folder().join(format!("{name}.gct"));
        let text = fs::read_to_string(path).expect("a chart");
        // Transitions without a designation are called by their number, which an edit changes.
        let mut numbered = String::new();
        for (number, line) in text.lines().enumerate() {
            let is_bare = line.trim_start().starts_with("transition") && !line.contains("transition (");
            let line =
                if is_bare { line.replacen("transition", &format!("transition (t{number})"), 1) } else { line.into() };
            numbered.push_str(&line);
            numbered.push('\n');
        }
        let before = places(&check(name, &numbered).unwrap_or_else(|error| panic!("{error}")));
        for line in 0..numbered.lines().count() {
            let Some(changed) = with_a_step_more(&numbered, line) else { continue };
            let after = places(&check(name, &changed).unwrap_or_else(|error| panic!("{error}")));
            let at = |name: &str| after.iter().find(|(known, _)| known == name).map(|(_, place)| *place);
            let (_, new) = at("step New").expect("the new step");
            // A way past other steps stands beside them until it has a step of its own, too.
            let designation =
                numbered.lines().nth(line).and_then(|line| line.split(['(', ')']).nth(1)).unwrap_or_default();
            let was =
                before.iter().find(|(name, _)| *name == format!("transition {designation}")).map(|(_, place)| *place);
            let is_straight = was.is_some_and(|(x, _)| x == 0);
            for (name, (x, y)) in before.iter().filter(|(_, (_, y))| *y < new) {
                let (now_x, now_y) = at(name).unwrap_or_else(|| panic!("{name} is gone"));
                assert_eq!(now_y, *y, "{name} has moved up or down: {line}\n{changed}");
                // The first column stays where it is; a branch beside it may have to make room.
                assert!(!is_straight || *x != 0 || now_x == 0, "{name} has moved sideways\n{changed}");
            }
            tried += 1;
        }
    }
    assert!(tried > 30, "only {tried} steps were added");
}

/// The drawing of a chart on pages of A4.
fn on_a4(name: &str, text: &str) -> (Chart, Vec<Picture>) {
    let chart = check(name, text).unwrap_or_else(|error| panic!("{error}"));
    let pictures = draw(&chart, &Options { page: Some(Page::A4), ..SINGLE }).expect("a drawing");
    (chart, pictures)
}

/// All texts of a class, with where they stand.
fn texts(picture: &Picture, wanted: &str) -> Vec<(String, i32, i32)> {
    fn of(group: &Group, x: i32, y: i32, wanted: &str, found: &mut Vec<(String, i32, i32)>) {
        let (x, y) = (x + group.at.x, y + group.at.y);
        for shape in &group.shapes {
            if let Shape::Text { at, class, text, .. } = shape {
                if *class == wanted {
                    found.push((text.clone(), x + at.x, y + at.y));
                }
            }
        }
        group.groups.iter().for_each(|inner| of(inner, x, y, wanted, found));
    }
    let mut found = Vec::new();
    picture.groups.iter().for_each(|group| of(group, 0, 0, wanted, &mut found));
    found
}

/// A row stands on one page, and rows keep the order of the text.
#[test]
fn claims_go_on_on_the_next_page() {
    let claims: String = (0..150).map(|number| format!("assert \"number {number}\" : X1 or not X1\n")).collect();
    let (chart, pages) = on_a4("claims", &format!("initial step 1\n{claims}"));
    assert_no_faults(&lint(&chart, &pages));
    assert!(pages.len() > 1, "150 rows of more than 20 units each are higher than two tables side by side on a page");
    let rows: Vec<String> = pages.iter().flat_map(|page| texts(page, "comment")).map(|(text, ..)| text).collect();
    let expected: Vec<String> = (0..150).map(|number| format!("\"number {number}\"")).collect();
    assert_eq!(rows, expected);
    // They are claims about the whole chart.
    let options = Options { grafcet: Some(chart.grafcets[0].name.to_string()), ..SINGLE };
    assert!(texts(&draw(&chart, &options).expect("a drawing")[0], "comment").is_empty());
}

#[test]
fn a_wide_parallel_region_is_cut_beside_its_branches() {
    // Fourteen branches of two steps, much wider than a page.
    let mut text = String::from("input a : bool\noutput V : bool\ninitial step 1\nstep 99\n");
    for branch in 10..24 {
        text.push_str(&format!("step {branch} \"a branch\" {{ V if a }}\nstep {}\n", branch + 20));
        text.push_str(&format!("transition ({branch}) {branch} -> {} : a\n", branch + 20));
    }
    let all = |first: usize| (first..first + 14).map(|step| step.to_string()).collect::<Vec<_>>().join(", ");
    text.push_str(&format!("transition (1) 1 -> {} : a\ntransition (2) {} -> 99 : a\n", all(10), all(30)));
    text.push_str("transition (3) 99 -> 1 : a\n");
    let (chart, pictures) = on_a4("Wide", &text);
    assert_eq!(lint(&chart, &pictures), Vec::<String>::new());
    let pages: Vec<Vec<String>> =
        pictures.iter().map(|picture| texts(picture, "label").into_iter().map(|(label, ..)| label).collect()).collect();
    for branch in 10..24 {
        let page = |step: usize| pages.iter().position(|labels| labels.contains(&step.to_string()));
        assert_eq!(page(branch), page(branch + 20), "the branch {branch} is on two pages");
    }
    // Each page that has a part of the region has a double line over it and one under it.
    for picture in &pictures {
        let mut syncs =
            picture.groups.iter().flat_map(|frame| &frame.groups).filter(|group| group.class.starts_with("sync"));
        assert!(syncs.clone().count() >= 2 && syncs.all(|sync| ["1", "2"].contains(&sync.data[0].1.as_str())));
    }
    // One label stands for all links of a double line to another page.
    let labels: Vec<String> = texts(&pictures[0], "label-text").into_iter().map(|(text, ..)| text).collect();
    assert!(labels.iter().any(|text| text.ends_with(" to 23, page 2")), "{labels:?}");
    assert!(labels.len() <= 4, "{labels:?}");
}

#[test]
fn a_label_of_where_a_link_comes_from_stands_right_at_its_step() {
    // Six branches of forty steps, and from the end of the last one a jump into the first.
    let mut text = String::from("input a : bool\ninitial step 1\n");
    let branch = |branch: usize| (0..40).map(move |step| 100 * branch + step);
    for step in (1..7).flat_map(branch) {
        text.push_str(&format!("step {step} \"of a branch\"\n"));
        if step % 100 < 39 {
            text.push_str(&format!("transition ({step}) {step} -> {} : a\n", step + 1));
        }
    }
    text.push_str("transition (1) 1 -> 100, 200, 300, 400, 500, 600 : a\ntransition (J) 639 -> 110 : a\n");
    let (chart, pictures) = on_a4("Long", &text);
    assert_eq!(lint(&chart, &pictures), Vec::<String>::new());
    let mut tried = 0;
    for picture in &pictures {
        let steps = texts(picture, "label");
        for (label, x, y) in texts(picture, "label-text").into_iter().filter(|(text, ..)| text.starts_with("from ")) {
            let near = |(_, step_x, step_y): &&(String, i32, i32)| {
                (x - step_x).abs() <= 40 && (0..=90).contains(&(step_y - y))
            };
            assert!(steps.iter().any(|step| near(&step)), "{label} at {x} {y}");
            tried += 1;
        }
    }
    assert!(tried > 6, "{tried}");
}

#[test]
fn title_blocks_are_equal_on_all_pages() {
    let plain: String = (2..30).map(|n| format!("transition ({n}) {} -> {n} : a\nstep {n}\n", n - 1)).collect();
    let mut wide = String::from("initial step 100\n");
    for n in 101..107 {
        wide.push_str(&format!("step {n} \"a rather long comment\"\ntransition ({n}) 100 -> {n} : a\n"));
    }
    let text = format!("input a : bool\ngrafcet G1 {{ initial step 1\n{plain} }}\ngrafcet G2 {{ {wide} }}");
    let (_, pictures) = on_a4("Blocks", &text);
    let times: Vec<f64> = pictures.iter().map(|picture| f64::from(picture.bounds.width()) / 840.0).collect();
    assert!(times.iter().any(|times| *times > 1.1) && times.contains(&1.0), "{times:?}");
    for (picture, times) in pictures.iter().zip(&times) {
        let block = picture.groups.iter().find(|group| group.class == "title-block").expect("a title block");
        let on_paper = |length: i32| f64::from(length) / times;
        assert!((on_paper(block.at.x) - 40.0).abs() < 1.0, "{}", block.at.x);
        let Some(Shape::Rect { bounds, .. }) = block.shapes.first() else { panic!("a frame") };
        assert!((on_paper(bounds.width()) - 760.0).abs() < 2.0 && (on_paper(bounds.height()) - 36.0).abs() < 1.0);
    }
}

#[test]
fn the_comment_of_an_expansion_is_beside_its_name() {
    let text = "input a : bool initial step 1 macro step M2 \"load\" transition 1 -> M2 : a transition M2 -> 1 : a
        expansion M2 \"from the left\" { step E2 step S2 transition E2 -> S2 : a }";
    let chart = check("Expansion", text).unwrap_or_else(|error| panic!("{error}"));
    let picture = &draw(&chart, &SINGLE).expect("a drawing")[0];
    let comments: Vec<String> = texts(picture, "comment").into_iter().map(|(text, ..)| text).collect();
    assert_eq!(comments, ["\"load\"", "\"from the left\""]);
    let frame = picture.groups.iter().find(|group| group.data[0].0 == "data-expansion").expect("a frame");
    assert_eq!(frame.title.as_deref(), Some("from the left"));
}

#[test]
fn a_list_of_steps_is_broken_behind_a_comma() {
    let steps: String = (100..130).map(|n| format!("step {n} transition 1 -> {n} : a ")).collect();
    let list = (100..130).map(|n| n.to_string()).collect::<Vec<_>>().join(", ");
    let text = format!(
        "input a : bool grafcet G1 {{ initial step 9 {{ force G2{{{list}}} }} }} grafcet G2 {{ initial step 1 {steps} }}"
    );
    let chart = check("List", &text).unwrap_or_else(|error| panic!("{error}"));
    let picture = &draw(&chart, &Options { grafcet: Some("G1".to_string()), ..SINGLE }).expect("a drawing")[0];
    let lines: Vec<String> = texts(picture, "text").into_iter().map(|(text, ..)| text).collect();
    assert!(lines.len() > 1 && lines.iter().all(|line| !line.trim_start().starts_with(',')), "{lines:?}");
}

#[test]
fn children_and_pulse_orders_are_in_the_drawing() {
    let text = "input a, b : bool grafcet MAIN { initial step 1 { run P } step 2 { freeze Q on event ↑a kill P on activation \
                start Q on deactivation } transition 1 -> 2 : a transition 2 -> 1 : b · FQ { resume Q } } \
                child grafcet P of MAIN { initial step 10 } grafcet Q { initial step 20 }";
    let chart = check("orders", text).expect("a chart without errors");
    let pictures = draw(&chart, &SINGLE).expect("nothing was asked for that is not there");
    assert_no_faults(&lint(&chart, &pictures));
    let drawn = svg(&pictures[0], None);
    for wanted in ["run P", "freeze Q", "kill P", "start Q", "resume Q", "P, child of MAIN", "Q"] {
        assert_eq!(drawn.matches(&format!(">{wanted}<")).count(), 1, "{wanted}\n{drawn}");
    }
    for order in ["run", "freeze", "kill", "start", "resume"] {
        assert_eq!(drawn.matches(&format!("data-kind=\"{order}\"")).count(), 1, "{order}\n{drawn}");
    }
    // Who reads it by program finds each under its own number, also the one on clearing.
    for number in 0..5 {
        assert_eq!(drawn.matches(&format!("data-order=\"{number}\"")).count(), 1, "{number}");
    }
}
