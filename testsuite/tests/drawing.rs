//! Drawings: the lint over every chart there is, and what a drawing promises besides.

use grafc_drawing::{Options, Page, draw, svg};
use grafc_model::chart::{Chart, Tables};
use grafc_testsuite::charts::{charts_folder, check, vectors_folder};
use grafc_testsuite::drawing_lint::lint;
use grafc_testsuite::random::{ChartKind, Draw, checked, checked_draw};
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
        let options = Options { page, revision: page.map(|_| "A".to_string()), ..SINGLE };
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
fn a_thousand_random_charts_are_drawn_without_faults() {
    let mut found = Vec::new();
    for seed in 0..1000 {
        let kind = [ChartKind::Hierarchical, ChartKind::Flat, ChartKind::Plain][seed as usize % 3];
        let drawn = if seed % 10 == 9 { checked_draw(seed, Draw { kind, size: 4 }) } else { checked(seed, kind) };
        let pictures = draw(&drawn.chart, &SINGLE).expect("nothing was asked for");
        found.extend(lint(&drawn.chart, &pictures).into_iter().map(|fault| format!("{seed} {kind:?}: {fault}")));
        if seed % 20 == 0 {
            found.extend(faults(&format!("{seed} {kind:?}"), &drawn.chart));
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
