//! A chart as one HTML file on which it lives: the drawing, the module of `--target js`, and a script that lets one click
//! through it. The file needs nothing from outside and asks nobody for anything.
//!
//! | file | what |
//! | --- | --- |
//! | `data` | what the script has to know of the chart, as JSON |
//! | `texts` | the words of the page in its languages, from `texts.json` |
//! | `script` | the files of the script as one |
//! | `policy` | what the page may do: nothing but run its own script |
//!
//! The script is in `script`, a file a thing, each an ES module; the frame of the page and its look are in `templates`.

mod data;
mod policy;
mod script;
mod texts;

pub use texts::Language;

use askama::Template;
use grafc_model::chart::Tables;
use texts::Texts;

/// What can be chosen of a page.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// The language that it begins with; there is a switch on it.
    pub language: Language,
    /// Who serves it: then the page may ask where it comes from, and keeps inputs and situation when it is loaded again.
    pub live: Option<Live<'a>>,
}

/// What is served beyond a file: the page is loaded again when its chart is saved, with what `window.grafc.keep()` gives in the
/// item `grafc-keep` of `sessionStorage`, and shows errors over the last good drawing. The server tells of both at `/events`.
#[derive(Clone, Copy, Debug)]
pub struct Live<'a> {
    /// What tells the chart apart from others that the server tells of.
    pub version: &'a str,
}

impl Live<'_> {
    fn script(self) -> String {
        format!("const own = {};\n{LIVE}", serde_json::Value::from(self.version))
    }
}

#[derive(Template)]
#[template(path = "page.html")]
struct Page<'a> {
    chart: &'a Tables,
    texts: Texts,
    language: Language,
    policy: String,
    drawing: String,
    data: String,
    words: String,
    style: &'a str,
    script: &'a str,
    live: Option<&'a str>,
}

/// Writes the page of a chart; `module` is what the target `js` makes of it, with what a page observes.
///
/// # Errors
/// If the text cannot be put together, which would be a fault of grafc.
pub fn page(chart: &Tables, module: &str, options: &Options<'_>) -> Result<String, askama::Error> {
    // All on one sheet, without asking for a step or grafcet that there may not be.
    let pictures = grafc_drawing::draw(chart, &grafc_drawing::Options::default()).unwrap_or_default();
    let script = script::in_html(&script::joined(module));
    let live = options.live.map(|live| script::in_html(&live.script()));
    let scripts: Vec<&str> = std::iter::once(script.as_str()).chain(live.as_deref()).collect();
    let page = Page {
        chart,
        texts: Texts(options.language),
        language: options.language,
        policy: policy::policy(STYLE, &scripts, live.is_some()),
        drawing: pictures.iter().map(grafc_drawing::svg_in_html).collect(),
        data: data::json(chart).map_err(|error| askama::Error::Custom(Box::new(error)))?,
        words: data::in_html(texts::TABLE),
        style: STYLE,
        script: &script,
        live: live.as_deref(),
    };
    page.render()
}

/// The script of what is served.
const LIVE: &str = include_str!("live.js");

/// The look.
const STYLE: &str = include_str!("../templates/page.css");
