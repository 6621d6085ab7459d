//! Pages in a browser: clicked through as a user does, and held against `grafc sim`.

use grafc_testsuite::binary::{grafc, root};
use grafc_testsuite::browser::Tools;
use grafc_testsuite::charts::{charts_folder, check, vectors_folder};
use grafc_testsuite::named_trace::NamedTrace;
use grafc_testsuite::plants::plants;
use grafc_testsuite::random::{ChartKind, checked, trace};
use grafc_testsuite::xmi::collection;
use serde_json::{Value as Json, json};
use std::fs;
use std::path::Path;

/// Runs a command in a folder.
fn run(folder: &Path, arguments: &[&str]) -> String {
    let output = grafc().args(arguments).current_dir(folder).output().expect("the command runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Writes a chart and its page; the name of the page.
fn page(folder: &Path, name: &str, text: &str) -> String {
    let (chart, page) = (format!("{name}.gct"), format!("{name}.html"));
    fs::write(folder.join(&chart), text).expect("the chart");
    run(folder, &["page", &chart, "-o", &page, "--quiet"]);
    page
}

/// What `grafc sim` makes of a trace.
fn simulated(folder: &Path, name: &str, trace: &str) -> String {
    let file = format!("{name}.trace.csv");
    fs::write(folder.join(&file), trace).expect("the trace");
    run(folder, &["sim", &format!("{name}.gct"), "--trace", &file, "--quiet"])
}

/// A result, row by row.
fn rows(result: &str, outputs: usize) -> Vec<Json> {
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        json!({
            "outputs": cells[1..=outputs],
            "situation": words(cells[outputs + 1]),
            "flags": words(cells[outputs + 2]),
        })
    };
    result.lines().skip(1).map(row).collect()
}

fn weigh_mix() -> String {
    fs::read_to_string(charts_folder().join("weigh_mix_b4.gct")).expect("the chart")
}

/// Orders of all kinds, a number, a ring without rest, and a designation that two transitions have.
const STATES: &str = "\
chart States
input m, n, p, round : bool
input level : int
output high : bool
grafcet G1 {
  initial step 0
  step 1 { force G2{12} }
  step 2 { force G2{*} }
  transition (1) 0 -> 1 : m
  transition 1 -> 2 : n
  transition 2 -> 0 : p
}
grafcet G2 {
  initial step 10
  step 11
  step 12
  transition 10 -> 11 : p
  transition 11 -> 12 : p
  transition 12 -> 10 : not p and n and m
}
grafcet G3 {
  initial step 20 { high if [level > 50] }
}
grafcet G4 {
  initial step 30
  step 31
  transition (1) 30 -> 31 : round
  transition 31 -> 30 : round
}
";

/// Claims of each kind; which of them hold is to be seen from the chart alone.
const CLAIMS: &str = "\
chart Claims
input up, down, call_up, call_down : bool
output Lift, Lower : bool
initial step 1
step 2 { Lift }
step 3 { Lower }
transition 1 -> 2 : call_up and not up
transition 1 -> 3 : call_down and not down
transition 2 -> 1 : up
transition 3 -> 1 : down
assume \"the platform is at one place\" : not (up and down)
assert not (Lift and Lower)
assert \"nobody calls while it goes up\" : not X2 or not call_up
reach X3
";

/// Names that would be markup or script, or turn what follows around.
const HOSTILE: &str = "\
chart `</script><script>window.harmed=1</script>` \"</title><img src=x onerror='window.harmed=1'> ]]> -->\"
input  `</script><script>harmed=1</script>` \"<b>bold</b> & \u{202e}turned\u{202c}\" : bool
input  `\"quoted\" & 'so' ${harmed=1}` : bool
input  `__proto__`, `constructor`, `a,b` : bool
output `]]>` \"--> <img src=x onerror=harmed=1>\" : bool
var    `<!--` : int
initial step `<g onload=\"harmed=1\">` \"'; harmed=1; //\"
step `\u{202e}2` { `]]>`  `<!--` := `<!--` + 1 on activation }
transition (`</title>`) `<g onload=\"harmed=1\">` -> `\u{202e}2` :
  `</script><script>harmed=1</script>` and `\"quoted\" & 'so' ${harmed=1}` and `__proto__` and `constructor` and `a,b`
transition `\u{202e}2` -> `<g onload=\"harmed=1\">` : not `\"quoted\" & 'so' ${harmed=1}`
";

#[test]
fn pages_do_what_a_user_expects() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let b4 = page(folder, "b4", &weigh_mix());
    let states = page(folder, "states", STATES);
    let claims = page(folder, "claims", CLAIMS);
    let hostile = page(folder, "hostile", HOSTILE);
    let frozen = fs::read_to_string(vectors_folder().join("s3.gct")).expect("a vector");
    let frozen = page(folder, "frozen", &frozen);
    let out = folder.join("saved");
    let jobs = [
        json!({ "do": "click_through", "page": b4 }),
        json!({ "do": "breakpoints", "page": b4 }),
        json!({ "do": "traces", "page": b4, "out": out }),
        json!({ "do": "looks", "page": b4 }),
        json!({ "do": "keyboard", "page": b4 }),
        json!({ "do": "states", "page": states }),
        json!({ "do": "claims", "page": claims }),
        json!({ "do": "children", "page": frozen }),
        json!({
            "do": "hostile",
            "page": hostile,
            "steps": ["<g onload=\"harmed=1\">", "\u{202e}2"],
            "inputs": ["</script><script>harmed=1</script>", "\"quoted\" & 'so' ${harmed=1}", "__proto__", "constructor", "a,b"],
            "then": ["\u{202e}2"],
            "inHeader": "\"\"\"quoted\"\" & 'so' ${harmed=1}\",__proto__,constructor,\"a,b\"",
        }),
        json!({ "do": "live", "page": b4 }),
    ];
    let said = tools.play(folder, &jobs).unwrap_or_else(|fault| panic!("{fault}"));
    eprint(&said);
    // What the page saved, `grafc sim` reads, and makes of it the same, word for word.
    let saved = fs::read_to_string(out.with_extension("csv")).expect("a trace");
    assert!(saved.lines().count() > 20, "{saved}");
    let result = simulated(folder, "b4", &saved);
    assert_eq!(fs::read_to_string(out.with_extension("result.csv")).expect("a result"), result);
    run(folder, &["sim", "b4.gct", "--trace", "b4.trace.csv", "-o", "b4.vcd", "--quiet"]);
    let read = |path: &Path| fs::read_to_string(path).expect("waveforms");
    assert_eq!(read(&out.with_extension("vcd")), read(&folder.join("b4.vcd")));
}

#[test]
fn pages_and_simulations_agree_row_by_row() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let mut jobs = Vec::new();
    // As they are seen, scan by scan: macro-steps; enclosures and orders; numbers and actions on clearing; children.
    let charts = ["weigh_mix_b4", "weigh_mix_b6", "figure_3", "operating_hours"].map(|name| (charts_folder(), name));
    for (of, name) in charts.into_iter().chain(["s3", "s5a", "s15"].map(|name| (vectors_folder(), name))) {
        let read = |ending: &str| fs::read_to_string(of.join(format!("{name}{ending}"))).expect("a chart");
        let text = read(".gct");
        let page = page(folder, name, &text);
        let trace = read(".trace.csv");
        let result = simulated(folder, name, &trace);
        assert_eq!(result, read(".expected.csv"), "{name}");
        let outputs = result.lines().next().expect("a header").split(',').count() - 3;
        let rows = rows(&result, outputs);
        jobs.push(json!({ "do": "rows", "page": page, "trace": trace, "rows": rows, "result": result }));
    }
    // Random charts of the whole language, at full speed.
    let kinds = [ChartKind::Hierarchical, ChartKind::Flat, ChartKind::Plain];
    for seed in 7100..7109 {
        let drawn = checked(seed, kinds[seed as usize % 3]);
        let name = format!("random_{seed}");
        let page = page(folder, &name, &drawn.text);
        let trace = NamedTrace::of(&drawn.chart, &trace(seed, &drawn.chart, 40)).to_csv();
        let result = simulated(folder, &name, &trace);
        let (trace_file, waves) = (format!("{name}.trace.csv"), format!("{name}.vcd"));
        run(folder, &["sim", &format!("{name}.gct"), "--trace", &trace_file, "-o", &waves, "--quiet"]);
        let waves = fs::read_to_string(folder.join(waves)).expect("waveforms");
        jobs.push(json!({ "do": "result", "page": page, "trace": trace, "result": result, "vcd": waves }));
    }
    // Names that are words of the format of waveforms.
    let text = "chart `$end` input `$end`, `$a b` : bool initial step `$end`";
    let page = page(folder, "words", text);
    let trace = "t_ms,$end,$a b\n0,0,1\n5,1,0\n";
    let result = simulated(folder, "words", trace);
    run(folder, &["sim", "words.gct", "--trace", "words.trace.csv", "-o", "words.vcd", "--quiet"]);
    let waves = fs::read_to_string(folder.join("words.vcd")).expect("waveforms");
    jobs.push(json!({ "do": "result", "page": page, "trace": trace, "result": result, "vcd": waves }));
    let said = tools.play(folder, &jobs).unwrap_or_else(|fault| panic!("{fault}"));
    eprint(&said);
}

#[test]
fn a_plant_runs_a_thousand_scans_a_second() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let chart = fs::read_to_string(charts_folder().join("weigh_mix_b6.gct")).expect("the chart");
    let mut charts = vec![("b6".to_owned(), chart)];
    // The largest of the collection, where it is there.
    let plants = collection().and_then(plants).unwrap_or_default();
    let largest = plants.into_iter().max_by_key(|plant| plant.chart.steps.len());
    charts.extend(largest.map(|plant| ("plant".to_owned(), plant.text)));
    let mut jobs = Vec::new();
    for (name, text) in charts {
        check(&name, &text).expect("a chart without errors");
        let page = page(folder, &name, &text);
        let size = fs::metadata(folder.join(&page)).expect("the page").len();
        assert!(size < 400_000, "{name}: {size} bytes");
        jobs.push(json!({ "do": "speed", "page": page, "ms": 1500 }));
    }
    let said = tools.play(folder, &jobs).unwrap_or_else(|fault| panic!("{fault}"));
    eprint(&said);
}

/// The page in the book of the first chart of the README. `UPDATE_EXPECT=1` makes it anew.
#[test]
fn the_page_of_the_book_is_what_grafc_makes() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the README");
    let lamp = readme.split("file=lamp.gct").nth(1).and_then(|rest| rest.split_once('\n'));
    let lamp = lamp.and_then(|(_, rest)| rest.split_once("```")).expect("the chart").0;
    let folder = tempfile::tempdir().expect("a folder");
    let made = fs::read_to_string(folder.path().join(page(folder.path(), "lamp", lamp))).expect("the page");
    let path = root().join("docs/pages/lamp.html");
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        fs::write(&path, &made).expect("the page");
    }
    let known = fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(known == made, "{} is not what grafc makes: UPDATE_EXPECT=1 makes it anew", path.display());
}

/// For who asks for it with `--nocapture`.
fn eprint(said: &str) {
    use std::io::Write as _;
    let _ = std::io::stderr().write_all(said.as_bytes());
}

#[test]
fn a_page_asks_for_nothing_and_has_no_markup_of_the_charts() {
    let folder = tempfile::tempdir().expect("a folder");
    let html = fs::read_to_string(folder.path().join(page(folder.path(), "hostile", HOSTILE))).expect("the page");
    // The frame of the page has so many scripts: two blocks of data and one that runs.
    assert_eq!(html.matches("<script").count(), 3);
    assert_eq!(html.matches("</script").count(), 3);
    // The name of a language, which nobody is asked for.
    let html = html.replace("http://www.w3.org/2000/svg", "");
    for wrong in ["<img", "<b>", "http:", "https:", "//cdn", "@import", "url(", "javascript:", "<g on"] {
        assert!(!html.contains(wrong), "{wrong}");
    }
    // No tag has something to do when something happens.
    let tags =
        html.split("<script").next().expect("markup").split('<').skip(1).filter_map(|rest| rest.split('>').next());
    for tag in tags {
        let unquoted: String = tag.split('"').step_by(2).collect();
        assert!(!unquoted.contains(" on"), "{tag}");
    }
    assert!(html.contains("default-src &#39;none&#39;") || html.contains("default-src 'none'"));
    // The same text gives the same page, byte by byte.
    let again = fs::read_to_string(folder.path().join(page(folder.path(), "hostile", HOSTILE))).expect("the page");
    assert!(html == again.replace("http://www.w3.org/2000/svg", ""));
}
