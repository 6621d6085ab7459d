//! The compiler for build scripts: a chart in, a Rust module in `$OUT_DIR` out.
//!
//! What the command line says on standard error, a build script must say to cargo: warnings as `cargo::warning`, since
//! cargo shows nothing else of a script that did its work, and errors on standard error, since cargo shows all of a
//! script that did not.

use crate::compile::compile;
use crate::document::chart_name;
use crate::fault;
use crate::files::{self, Refusal, print};
use crate::options::{Options, Product};
use crate::sources;
use grafc_backends::Target;
use grafc_backends::rust::{self, Runtime};
use grafc_diagnostics::{Code, Diagnostics, Policy, SourceMap, render};
use grafc_logic::Encoding;
use grafc_model::chart::ControlNames;
use grafc_model::reaction::{Asked, Evolution, LivelockOutputs, Profile};
use std::fmt;
use std::io::Write;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};

/// Compiles a chart to Rust, from a build script.
///
/// In `Cargo.toml`:
///
/// ```toml
/// [build-dependencies]
/// grafc = "0.1"
/// ```
///
/// In `build.rs`, beside it:
///
/// ```no_run
/// fn main() {
///     grafc::Build::new("tank.gct").compile();
/// }
/// ```
///
/// And in the program:
///
/// ```ignore
/// include!(concat!(env!("OUT_DIR"), "/tank.rs"));
///
/// let mut tank = tank::Tank::new();
/// ```
///
/// The code is that of `grafc tank.gct --target rust`, in a module, so that it can be included. Cargo runs the script
/// again when the chart changes.
#[allow(clippy::needless_doctest_main, reason = "the example is a whole build script")]
#[derive(Clone, Debug)]
pub struct Build {
    chart: PathBuf,
    module: Option<String>,
    out_dir: Option<PathBuf>,
    runtime: Runtime,
    lowering: grafc_logic::Options,
    asked: Asked,
    bound_as_known: bool,
    controls: ControlNames,
    policy: Policy,
}

impl Build {
    /// For the chart in this file. A relative path begins at the folder of `Cargo.toml`, where cargo runs build scripts.
    pub fn new(chart: impl Into<PathBuf>) -> Self {
        Build {
            chart: chart.into(),
            module: None,
            out_dir: None,
            runtime: Runtime::default(),
            lowering: grafc_logic::Options::default(),
            asked: Asked::default(),
            bound_as_known: false,
            controls: ControlNames::default(),
            policy: Policy::default(),
        }
    }

    /// The name of the module, and of the file with `.rs` after it; without it, the name of the chart's file. The module
    /// is named in snake case, and so that Rust takes it.
    ///
    /// Charts in one folder have different names; those in different folders may need this:
    ///
    /// ```no_run
    /// grafc::Build::new("left/press.gct").module("left_press").compile();
    /// grafc::Build::new("right/press.gct").module("right_press").compile();
    /// ```
    pub fn module(&mut self, name: impl Into<String>) -> &mut Self {
        self.module = Some(name.into());
        self
    }

    /// The folder to write to, which must be there; without it, the one that cargo names in `OUT_DIR`.
    pub fn out_dir(&mut self, folder: impl Into<PathBuf>) -> &mut Self {
        self.out_dir = Some(folder.into());
        self
    }

    /// Where the code has from what it needs at run time: from itself, or, as with `--runtime crate`, from the crate
    /// `grafc-runtime`, on which the program must then depend.
    ///
    /// ```no_run
    /// grafc::Build::new("tank.gct").runtime(grafc::Runtime::Crate).compile();
    /// ```
    pub fn runtime(&mut self, runtime: Runtime) -> &mut Self {
        self.runtime = runtime;
        self
    }

    /// How the situation is held and the next one found, as `--encoding`.
    ///
    /// ```no_run
    /// grafc::Build::new("tank.gct").encoding(grafc::Encoding::Switch).compile();
    /// ```
    pub fn encoding(&mut self, encoding: Encoding) -> &mut Self {
        self.lowering.encoding = encoding;
        self
    }

    /// Whether formulas are shortened by what is proved; they are, unless `false` is given here, as with `-O0`.
    pub fn optimize(&mut self, optimize: bool) -> &mut Self {
        self.lowering.simplify = optimize;
        self
    }

    /// To a stable situation at each scan, or by one micro-step a scan as SFC does, as `--evolution`. This changes what
    /// the chart means.
    pub fn evolution(&mut self, evolution: Evolution) -> &mut Self {
        self.lowering.profile.evolution = evolution;
        self.asked.evolution = Some(evolution);
        self
    }

    /// Whether initial steps do their actions on activation at the start, as `--initial-actions`; they do, unless `false`
    /// is given here. This changes what the chart means.
    pub fn initial_actions(&mut self, initial_actions: bool) -> &mut Self {
        self.lowering.profile.initial_actions = initial_actions;
        self.asked.initial_actions = Some(initial_actions);
        self
    }

    /// After how many micro-steps a scan gives up and raises LIVELOCK, as `--bound`; 0 is taken as 1, and more than
    /// 2,147,483,647 as that. This changes what the chart means.
    pub fn bound(&mut self, micro_steps: u32) -> &mut Self {
        self.lowering.profile.bound = Some(micro_steps.clamp(1, Profile::LARGEST_BOUND));
        (self.asked.bound, self.asked.bound_as_known) = (self.lowering.profile.bound, false);
        self
    }

    /// The bound that is known to be enough for every reaction that comes to rest, where one is known, as `--bound auto`.
    pub fn bound_auto(&mut self) -> &mut Self {
        self.lowering.profile.bound = None;
        self.bound_as_known = true;
        (self.asked.bound, self.asked.bound_as_known) = (None, true);
        self
    }

    /// What outputs of continuous actions do in a scan that LIVELOCK ends, as `--livelock-outputs`.
    pub fn livelock_outputs(&mut self, outputs: LivelockOutputs) -> &mut Self {
        self.lowering.profile.livelock_outputs = outputs;
        self.asked.livelock_outputs = Some(outputs);
        self
    }

    /// An input that starts the chart anew while it is true, as `--reset-input`.
    pub fn reset_input(&mut self, name: impl Into<String>) -> &mut Self {
        self.controls.reset = Some(name.into().into());
        self
    }

    /// Whether such a reset leaves retained variables as they are, as `--reset-keeps-retained`.
    pub fn reset_keeps_retained(&mut self, keeps: bool) -> &mut Self {
        self.controls.reset_keeps_retained = keeps;
        self
    }

    /// An input that lowers the flags while it is true, as `--clear-flags-input`.
    pub fn clear_flags_input(&mut self, name: impl Into<String>) -> &mut Self {
        self.controls.clear_flags = Some(name.into().into());
        self
    }

    /// Whether an output tells the number of the first assertion that was false, as `--check-assertions`.
    pub fn check_assertions(&mut self, checks: bool) -> &mut Self {
        self.controls.check_assertions = checks;
        self
    }

    /// Every warning is an error, as with `-D warnings`, unless the text or [`allow`](Self::allow) allows it. For a build
    /// that nobody looks at:
    ///
    /// ```no_run
    /// let mut build = grafc::Build::new("tank.gct");
    /// if std::env::var_os("CI").is_some() {
    ///     build.deny_warnings();
    /// }
    /// build.compile();
    /// ```
    pub fn deny_warnings(&mut self) -> &mut Self {
        self.policy.deny_all = true;
        self
    }

    /// A warning is an error, as with `-D W0409`.
    ///
    /// ```no_run
    /// grafc::Build::new("tank.gct").deny(grafc::Code::W0409).compile();
    /// ```
    pub fn deny(&mut self, warning: Code) -> &mut Self {
        self.policy.deny.insert(warning);
        self
    }

    /// A warning is not shown, and no error either, as with `--allow W0409`. With its reason it stands in the text:
    /// `allow W0409 "interlocked by hardware"`.
    ///
    /// ```no_run
    /// grafc::Build::new("tank.gct").deny_warnings().allow(grafc::Code::W0401).compile();
    /// ```
    pub fn allow(&mut self, warning: Code) -> &mut Self {
        self.policy.allow.insert(warning);
        self
    }

    /// Compiles the chart, and returns the file that was written.
    ///
    /// If that fails, this prints what [`try_compile`](Self::try_compile) would return and ends the process, with the
    /// exit code of the command line. Cargo then shows the messages as they are.
    pub fn compile(&self) -> PathBuf {
        self.try_compile().unwrap_or_else(|error| {
            // If that fails there is nowhere left to say so.
            let _ = std::io::stderr().lock().write_all(error.text.as_bytes());
            std::process::exit(error.exit_code)
        })
    }

    /// Compiles the chart, and returns the file that was written. Warnings go to cargo.
    ///
    /// # Errors
    /// Of a chart with errors, all messages, rendered as the command line renders them; else why a file cannot be read
    /// or written. The file is written whole or not at all: after an error it is as it was.
    ///
    /// ```no_run
    /// fn main() -> Result<(), grafc::BuildError> {
    ///     let path = grafc::Build::new("tank.gct").try_compile()?;
    ///     let code = std::fs::read_to_string(path).expect("what was just written");
    ///     println!("cargo::warning=the tank takes {} lines", code.lines().count());
    ///     Ok(())
    /// }
    /// ```
    pub fn try_compile(&self) -> Result<PathBuf, BuildError> {
        let mut report = Report::default();
        // Not `fault::guard`, which takes the hook of a process that is not ours here.
        let (text, exit_code) = match panic::catch_unwind(AssertUnwindSafe(|| self.run(&mut report))) {
            Ok(Ok(path)) => return Ok(path),
            Ok(Err(Failure::Chart)) => (report.text(), 1),
            Ok(Err(Failure::WrongUse(what, help))) => {
                (report.text() + &format!("error: {what}\n  = help: {help}\n"), 2)
            }
            Ok(Err(Failure::Files(refusal))) => (report.text() + &refusal.to_string(), 3),
            Err(payload) => (fault::of_panic(payload.as_ref()), fault::EXIT_CODE.into()),
        };
        Err(BuildError { text, exit_code })
    }

    /// The file that was written.
    fn run(&self, report: &mut Report) -> Result<PathBuf, Failure> {
        print(&format!("cargo::rerun-if-changed={}\n", self.chart.display()))?;
        let name = chart_name(&self.chart);
        let module = self.module.clone().unwrap_or_else(|| name.clone());
        let options = rust::Options { runtime: self.runtime, module: Some(module.clone()), ..rust::Options::default() };
        let target = Target::Rust(options);
        let path = self.folder()?.join(format!("{module}.{}", target.about().extension));
        if files::is_same_file(&path, &self.chart) {
            let what = format!("the output would overwrite `{}`", self.chart.display());
            return Err(Failure::WrongUse(what, "choose another name with `module`"));
        }
        let source = self.chart.file_name().unwrap_or(self.chart.as_os_str()).to_string_lossy();
        let (lowering, controls, policy) = (self.lowering, self.controls.clone(), self.policy.clone());
        let bound_as_known = self.bound_as_known;
        let (asked, source, product) = (self.asked, Some(source.into_owned()), Product::Code(target));
        let options = Options { lowering, asked, source, bound_as_known, controls, product, policy };
        let made = report.compile(&self.chart, &name, &options)?;
        files::write(&path, &made)?;
        print(&report.warnings())?;
        Ok(path)
    }

    fn folder(&self) -> Result<PathBuf, Failure> {
        self.out_dir.clone().or_else(|| std::env::var_os("OUT_DIR").map(PathBuf::from)).ok_or_else(|| {
            let help = "call `Build` from a build script, or name a folder with `out_dir`";
            Failure::WrongUse("there is no `OUT_DIR` to write to".to_string(), help)
        })
    }
}

/// Why there is no file.
enum Failure {
    /// The chart has errors.
    Chart,
    /// It was called in a way that makes no sense: what, and what to do.
    WrongUse(String, &'static str),
    /// A file cannot be read or written.
    Files(Refusal),
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        Failure::Files(refusal)
    }
}

/// The text of the chart and all messages about it.
#[derive(Default)]
struct Report {
    sources: SourceMap,
    diagnostics: Diagnostics,
}

impl Report {
    /// The code.
    fn compile(&mut self, chart: &Path, name: &str, options: &Options) -> Result<String, Failure> {
        let file = match sources::add(&mut self.sources, chart.display().to_string(), files::read(chart)?) {
            Ok(file) => file,
            Err(diagnostic) => {
                self.diagnostics.push(diagnostic);
                return Err(Failure::Chart);
            }
        };
        let (made, diagnostics) = compile(file, &self.sources.file(file).text, name, options);
        self.diagnostics = diagnostics;
        self.diagnostics.sort_by_place();
        made.map(|made| made.text).ok_or(Failure::Chart)
    }

    /// All messages, as the command line prints them.
    fn text(&self) -> String {
        render::human(&self.sources, &self.diagnostics, false) + &render::summary(&self.diagnostics)
    }

    /// All messages, in lines that cargo shows. It takes one line at a time.
    fn warnings(&self) -> String {
        let text = render::human(&self.sources, &self.diagnostics, false);
        text.lines().filter(|line| !line.is_empty()).map(|line| format!("cargo::warning={line}\n")).collect()
    }
}

/// Why a chart was not compiled: the text that the command line would print.
///
/// `Debug` gives the same text, since that is what is printed of an error that `main` returns.
pub struct BuildError {
    text: String,
    exit_code: i32,
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for BuildError {}
