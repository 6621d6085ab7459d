//! Each rule notices the picture that breaks it.

use super::lint;
use crate::charts::check;
use grafc_drawing::{Group, Options, Picture, Shape, draw};
use grafc_model::chart::Chart;

const CHART: &str = "input a : bool output V : bool
    grafcet G1 { initial step 1 { V } enclosing step 2 step 3
      transition (1) 1 -> 2, 3 : a transition (2) 2, 3 -> 1 : a transition (3) 1 -> 3 : a }
    grafcet X2/G2 { activated step 9 }";

fn drawn() -> (Chart, Vec<Picture>) {
    let chart = check("chart", CHART).unwrap_or_else(|error| panic!("{error}"));
    let pictures = draw(&chart, &Options::default()).expect("a drawing");
    assert_eq!(lint(&chart, &pictures), Vec::<String>::new());
    (chart, pictures)
}

fn find<'p>(pictures: &'p mut [Picture], class: &str, name: &str) -> &'p mut Group {
    let elements = pictures[0].groups.iter_mut().flat_map(|frame| &mut frame.groups);
    let is_it =
        |group: &&mut Group| group.class.starts_with(class) && group.data.iter().any(|(_, value)| value == name);
    elements.into_iter().find(is_it).expect("the element")
}

/// Changes the picture, and expects one of its faults to be said so.
fn notices(change: impl FnOnce(&mut [Picture]), expected: &str) {
    let (chart, mut pictures) = drawn();
    change(&mut pictures);
    let found = lint(&chart, &pictures);
    assert!(found.iter().any(|fault| fault.contains(expected)), "`{expected}` is not said: {found:#?}");
}

#[test]
fn a_symbol_that_is_missing_or_there_twice() {
    notices(|pictures| pictures[0].groups[0].groups.retain(|group| group.data[0].1 != "3"), "step `3` is there -1");
    let twice = |pictures: &mut [Picture]| {
        let copy = find(pictures, "step", "9").clone();
        pictures[0].groups[1].groups.push(Group { at: grafc_layout::Point { x: 300, y: 0 }, ..copy });
    };
    notices(twice, "step `9` is there 1");
    notices(|pictures| find(pictures, "step initial", "1").groups.clear(), "action `` is there -1");
}

#[test]
fn boxes_and_texts_that_overlap() {
    let near = |pictures: &mut [Picture]| {
        let other = find(pictures, "step", "3").at;
        find(pictures, "step enclosing", "2").at = grafc_layout::Point { x: other.x - 20, y: other.y };
    };
    notices(near, "overlaps");
    let long = |pictures: &mut [Picture]| {
        for shape in &mut find(pictures, "transition", "1").shapes {
            if let Shape::Text { text, class: "condition", .. } = shape {
                *text = "a condition that is much longer than it was".to_string();
            }
        }
    };
    notices(long, "the text `a condition");
}

#[test]
fn lines_through_boxes_and_along_each_other() {
    notices(|pictures| find(pictures, "step", "3").at.y += 20, "runs through");
    notices(|pictures| find(pictures, "transition", "2").at.x += 30, "runs through");
    notices(|pictures| find(pictures, "transition", "2").at.x += 15, "ends in nothing");
    // The link from step 3 onto the axis of the other branch.
    let along = |pictures: &mut [Picture]| {
        let by = find(pictures, "step enclosing", "2").at.x - find(pictures, "step", "3").at.x;
        let elements = pictures[0].groups[0].groups.iter_mut();
        let is_it = |group: &&mut Group| group.class == "link before" && group.data[0].1 == "3";
        elements.into_iter().find(is_it).expect("the link").at.x += by;
    };
    notices(along, "run along");
}

#[test]
fn lines_through_double_lines_and_crosses_that_join() {
    // A link of the double line is moved, so that it goes down through the double line that forks.
    let through = |pictures: &mut [Picture]| {
        let is_it =
            |group: &&mut Group| group.class == "link after" && group.data[0].1 == "1" && group.data[1].1 == "2";
        let link = pictures[0].groups[0].groups.iter_mut().find(is_it).expect("the link");
        for shape in &mut link.shapes {
            if let Shape::Path { lines, .. } = shape {
                lines.iter_mut().flatten().for_each(|point| point.y -= 6);
            }
        }
    };
    notices(through, "through the double line");
    let cross = |pictures: &mut [Picture]| {
        let point = |x: i32, y: i32| grafc_layout::Point { x: 400 + x, y };
        let lines = vec![
            vec![point(0, 0), point(0, 40)],
            vec![point(-20, 20), point(0, 20)],
            vec![point(20, 20), point(0, 20)],
        ];
        let link = pictures[0].groups[0].groups.iter_mut().find(|group| group.class == "link after").expect("a link");
        link.shapes.push(Shape::Path { lines, closed: false, style: grafc_drawing::Style::Line });
    };
    notices(cross, "joins in a cross");
}

#[test]
fn what_leaves_its_frame_or_the_sheet() {
    notices(|pictures| find(pictures, "step", "9").at.x += 45, "cuts");
    notices(|pictures| find(pictures, "step", "9").at.x += 2000, "outside of the sheet");
    notices(|pictures| pictures[0].bounds.right -= 60, "outside of the sheet");
}
