//! `grafc draw`.

mod common;

use common::{FAULTY, Folder, VALVE};

/// Names that would be markup, or turn what follows around.
const HOSTILE: &str = "\
chart Hostile \"a & b < c ]]> </svg>\"
input  `</script><script>alert(1)</script>`, `\"quoted\" & 'so'` : bool
output `]]>` \"--> <b>\" : bool
initial step `<g onload=\"x\">` \"\u{202e}turned\u{202c}\"
step `\u{202e}2` { `]]>` }
transition (`</title>`) `<g onload=\"x\">` -> `\u{202e}2` : `</script><script>alert(1)</script>`
transition `\u{202e}2` -> `<g onload=\"x\">` : not `\"quoted\" & 'so'`
";

fn ring(steps: usize) -> String {
    let mut text = String::from("input a : bool\ninitial step 0\n");
    (1..steps).for_each(|step| text.push_str(&format!("step {step}\n")));
    (0..steps).for_each(|step| text.push_str(&format!("transition {step} -> {} : a\n", (step + 1) % steps)));
    text
}

#[test]
fn svg_has_its_names_and_goes_to_standard_output() {
    let folder = Folder::new(&[("a.gct", VALVE)]);
    let printed = folder.run(&["draw", "a.gct"]).is_done().out.clone();
    for part in [
        "<g class=\"step initial\" data-step=\"1\"",
        "<g class=\"step\" data-step=\"2\"",
        "<g class=\"transition\" data-transition=\"1\"",
        "<g class=\"action\" data-owner=\"2\"",
        "<g class=\"link before\" data-from=\"1\" data-to=\"1\"",
        "<g class=\"link after up\" data-from=\"2\" data-to=\"1\"",
        "<g class=\"frame\" data-grafcet=\"G1\"",
        "role=\"img\"",
        "<title id=\"grafc-title\">Valve</title>",
    ] {
        assert!(printed.contains(part), "{part} is not in\n{printed}");
    }
    folder.run(&["draw", "a.gct", "-o", "a.svg"]).is_done();
    assert_eq!(folder.read("a.svg"), printed);
    assert_eq!(folder.names(), ["a.gct", "a.svg"]);
}

#[test]
fn the_ending_says_what_is_made() {
    let folder = Folder::new(&[("a.gct", VALVE)]);
    for (name, start) in
        [("a.pdf", b"%PDF".as_slice()), ("a.png", b"\x89PNG".as_slice()), ("b.SVG", b"<svg".as_slice())]
    {
        folder.run(&["draw", "a.gct", "-o", name]).is_done();
        let once = std::fs::read(folder.path(name)).unwrap();
        assert!(once.starts_with(start), "{name}");
        folder.run(&["draw", "a.gct", "-o", name]).is_done();
        assert!(once == std::fs::read(folder.path(name)).unwrap(), "{name}: the same chart, other bytes");
    }
    folder.run(&["draw", "a.gct", "-o", "a.jpg"]).ends(2, "choose a name that ends in");
    folder.run(&["draw", "a.gct", "-o", "a"]).ends(2, "does not say what to make");
    folder.run(&["draw", "a.gct", "-o", "a.gct"]).ends(2, "");
    assert_eq!(folder.read("a.gct"), VALVE);
}

#[test]
fn pages_are_files_with_numbers_and_one_document_of_pdf() {
    let folder = Folder::new(&[("ring.gct", &ring(100))]);
    folder.run(&["draw", "ring.gct", "-o", "ring.svg", "--page", "a4", "--revision", "B <2>"]).is_done();
    let pages: Vec<String> = folder.names().into_iter().filter(|name| name.ends_with(".svg")).collect();
    assert_eq!(pages, ["ring-1.svg", "ring-2.svg", "ring-3.svg"]);
    let first = folder.read("ring-1.svg");
    assert!(first.contains("width=\"210mm\" height=\"297mm\""), "{first}");
    // Where the page ends, the link goes on to the first step that is not on it.
    let shown = first.matches("data-step=").count();
    let onwards = format!(">step {shown}, page 2<");
    assert!(
        first.contains(&onwards) && first.contains(">1 of 3<") && first.contains(">B &lt;2&gt;<"),
        "{onwards} {first}"
    );
    assert!(folder.read("ring-2.svg").contains(&format!(">from step {}, page 1<", shown - 1)));
    folder.run(&["draw", "ring.gct", "-o", "ring.pdf", "--page", "a4"]).is_done();
    let document = std::fs::read(folder.path("ring.pdf")).unwrap();
    assert!(document.windows(8).any(|part| part == b"/Count 3"));
    folder.run(&["draw", "ring.gct", "--page", "a4"]).ends(2, "several pages cannot be printed");
    folder.run(&["draw", "ring.gct", "-o", "single.svg", "--revision", "B"]).is_done();
    assert!(folder.read("single.svg").contains("title-block"));
}

#[test]
fn active_steps_bear_a_dot() {
    let folder = Folder::new(&[("a.gct", VALVE)]);
    let dots = |arguments: &[&str]| {
        let printed = folder.run(&[&["draw", "a.gct"], arguments].concat()).is_done().out.clone();
        (printed.matches("class=\"fill dot\"").count(), printed)
    };
    assert_eq!(dots(&[]).0, 0);
    let (count, printed) = dots(&["--situation", "2"]);
    assert_eq!(count, 1);
    assert!(printed.contains("<g class=\"step active\" data-step=\"2\""));
    assert_eq!(dots(&["--situation", "1, 2"]).0, 2);
    folder.run(&["draw", "a.gct", "--situation", "1,7"]).ends(2, "the chart has no step `7`");
}

#[test]
fn one_grafcet_or_expansion_can_be_drawn_alone() {
    let chart = "grafcet G1 { initial step 1 macro step M2 transition 1 -> M2 : 1 }
        expansion M2 { step E2 step S2 transition E2 -> S2 : 1 } grafcet G3 { initial step 9 }";
    let folder = Folder::new(&[("a.gct", chart)]);
    let steps = |grafcet: &str| {
        let run = folder.run(&["draw", "a.gct", "-q", "--grafcet", grafcet]);
        assert_eq!(run.code, 0, "{}", run.err);
        let labels = run.out.split("data-step=\"").skip(1).filter_map(|rest| rest.split('"').next());
        let mut labels: Vec<String> = labels.map(str::to_string).collect();
        labels.sort();
        labels.join(" ")
    };
    assert_eq!(steps("G1"), "1 E2 M2 S2");
    assert_eq!(steps("M2"), "E2 S2");
    assert_eq!(steps("G3"), "9");
    folder.run(&["draw", "a.gct", "--grafcet", "G4"]).ends(2, "no grafcet or expansion `G4`");
}

#[test]
fn a_chart_with_errors_is_not_drawn() {
    let folder = Folder::new(&[("a.gct", FAULTY)]);
    folder.run(&["draw", "a.gct", "-o", "a.svg"]).ends(1, "nowhere");
    folder.run(&["draw", "b.gct", "-o", "a.svg"]).ends(3, "b.gct");
    assert_eq!(folder.names(), ["a.gct"]);
}

#[test]
fn names_are_exact_for_programs_and_harmless_for_viewers() {
    let folder = Folder::new(&[("a.gct", HOSTILE)]);
    let run = folder.run(&["draw", "a.gct", "-q"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let svg = &run.out;
    for name in [
        "data-step=\"&lt;g onload=&quot;x&quot;&gt;\"",
        "data-step=\"\u{202e}2\"",
        "data-transition=\"&lt;/title&gt;\"",
        "data-variable=\"]]&gt;\"",
    ] {
        assert!(svg.contains(name), "{name} is not in\n{svg}");
    }
    for harm in ["<script", "onload=\"x", "]]>", "alert(1)</script>"] {
        assert!(!svg.contains(harm), "{harm} is in\n{svg}");
    }
    // What is shown turns nothing around.
    let texts = svg.split("<text").skip(1).filter_map(|rest| rest.split('>').nth(1));
    assert!(texts.into_iter().all(|text| !text.contains('\u{202e}')), "{svg}");
    folder.run(&["draw", "a.gct", "-q", "-o", "a.pdf"]).is_done();
    folder.run(&["draw", "a.gct", "-q", "-o", "a.png"]).is_done();
}

#[test]
fn what_is_too_large_for_png_says_what_to_do() {
    let folder = Folder::new(&[("ring.gct", &ring(500))]);
    folder.run(&["draw", "ring.gct", "-o", "ring.png"]).ends(2, "too large for PNG");
    assert_eq!(folder.names(), ["ring.gct"]);
}
