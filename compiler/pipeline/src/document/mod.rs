//! A text that is looked at again and again while it changes: the stages, each run when it is asked for, and run again
//! only when what it depends on has changed.
//!
//! ```text
//! text ─▶ tree ─▶ checked ─▶ net ─▶ analysis ─▶ warnings
//!                                      │  options
//!                                      ▼     ▼
//!                                   program, sequence ─▶ output of a target
//! ```
//!
//! The stages up to `checked` are cheap: they are what an editor asks for at each keystroke. From the analysis on there
//! are proofs. A document can be shared between threads, so that one can wait for the proofs while another answers.

mod emit;
#[cfg(test)]
mod tests;

use crate::compile::bounded;
use crate::stages::flatten;
use grafc_diagnostics::{Diagnostics, Edit, FileId, Misfit, SourceFile, SourceMap, Span, apply};
use grafc_logic::scan::{Observed, Program};
use grafc_logic::sequence::{Sequence, sequence};
use grafc_logic::{Analysis, Options};
use grafc_model::Checked;
use grafc_model::chart::{Chart, Tables};
use grafc_model::symbols::Symbols;
use grafc_net::Net;
use grafc_syntax::ast;
use std::ops::Range;
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// A chart's text with all that is known of it.
pub struct Document {
    sources: SourceMap,
    file: FileId,
    default_name: String,
    options: Options,
    of_text: OfText,
    of_options: OfOptions,
    #[cfg(test)]
    pub(crate) runs: tests::Runs,
}

/// What depends on the text alone.
#[derive(Default)]
struct OfText {
    tree: OnceLock<(ast::Chart, Diagnostics)>,
    checked: OnceLock<Checked>,
    /// What tree and chart have to say, in order of place.
    diagnostics: OnceLock<Diagnostics>,
    /// For encodings that do exactly what the rules say.
    exact: OfNet,
    /// For encodings in which steps overlap.
    overlapping: OfNet,
    warnings: OnceLock<Diagnostics>,
}

/// A flat net, and what is proved of it.
#[derive(Default)]
struct OfNet {
    net: OnceLock<Option<Arc<Net>>>,
    analysis: OnceLock<Option<Analysis>>,
}

/// What depends on the options as well.
#[derive(Default)]
struct OfOptions {
    /// By form.
    programs: [OnceLock<Option<(Program, Diagnostics)>>; 4],
    sequence: OnceLock<Option<Result<Sequence, Diagnostics>>>,
}

/// What a program is made with beside a call.
#[derive(Clone, Copy)]
enum Form {
    /// Nothing.
    Plain,
    /// With what gives saved memory back.
    Saved,
    /// And what is shown of transitions.
    Seen,
    /// And all that can be shown.
    SeenWhole,
}

impl Document {
    /// A text; `name` is what messages call it. A chart without a heading is named after that, as after its file.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let name = name.into();
        let default_name = chart_name(Path::new(&name));
        let mut sources = SourceMap::new();
        let file = sources.add(name, text);
        Document {
            sources,
            file,
            default_name,
            options: Options::default(),
            of_text: OfText::default(),
            of_options: OfOptions::default(),
            #[cfg(test)]
            runs: tests::Runs::default(),
        }
    }

    /// Names a chart without a heading otherwise than after its file.
    pub fn named(mut self, default_name: impl Into<String>) -> Self {
        self.default_name = default_name.into();
        self.of_text = OfText::default();
        self.of_options = OfOptions::default();
        self
    }

    /// The text, as messages are rendered with it.
    pub fn sources(&self) -> &SourceMap {
        &self.sources
    }

    /// The text with its lines: it turns bytes into places, as messages or editors count them, and back.
    pub fn source(&self) -> &SourceFile {
        self.sources.file(self.file)
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.source().text
    }

    /// Puts another text in its place.
    pub fn set_text(&mut self, text: impl Into<String>) {
        let name = self.source().name.clone();
        self.sources = SourceMap::new();
        self.file = self.sources.add(name, text);
        self.of_text = OfText::default();
        self.of_options = OfOptions::default();
    }

    /// Puts a text in the place of some bytes.
    ///
    /// # Errors
    /// If they are not there, or the range begins or ends within a character. The document is as it was then.
    pub fn edit(&mut self, range: Range<usize>, text: impl Into<String>) -> Result<(), Misfit> {
        let offset = |byte: usize| u32::try_from(byte).unwrap_or(u32::MAX);
        let span = Span { file: self.file, start: offset(range.start), end: offset(range.end) };
        self.apply(&[Edit { span, text: text.into() }])
    }

    /// Makes edits that belong together, as those of a [`Fix`](grafc_diagnostics::Fix); all places are those of the text
    /// before.
    ///
    /// # Errors
    /// If they do not fit the text, or overlap. The document is as it was then.
    pub fn apply(&mut self, edits: &[Edit]) -> Result<(), Misfit> {
        let text = apply(self.file, self.text(), edits)?;
        self.set_text(text);
        Ok(())
    }

    /// What was chosen: what the chart means, and how the situation is held.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// Chooses otherwise. What depends on the text alone is kept.
    pub fn set_options(&mut self, options: Options) {
        if options != self.options {
            self.options = options;
            self.of_options = OfOptions::default();
        }
    }

    /// Takes the bound on micro-steps that is known to be enough, where one is, in the place of the usual one.
    pub fn bound_as_known(&mut self, as_known: bool) {
        if as_known && let Some(analysis) = self.analysis() {
            let options = bounded(&self.options, true, analysis);
            self.set_options(options);
        }
    }

    /// The syntax tree. There is always one: what cannot be read is left out.
    pub fn tree(&self) -> &ast::Chart {
        &self.parsed().0
    }

    fn parsed(&self) -> &(ast::Chart, Diagnostics) {
        self.of_text.tree.get_or_init(|| {
            #[cfg(test)]
            self.runs.count("tree");
            grafc_syntax::parse(self.file, self.text())
        })
    }

    /// What the text came to: the chart as far as it goes, its names, and what is wrong with it.
    pub fn checked(&self) -> &Checked {
        self.of_text.checked.get_or_init(|| {
            let tree = self.tree();
            #[cfg(test)]
            self.runs.count("checked");
            grafc_model::examine(tree, &self.default_name)
        })
    }

    /// The chart, if nothing is wrong with the text.
    pub fn chart(&self) -> Option<&Chart> {
        self.checked().chart().filter(|_| self.tree().is_whole)
    }

    /// The chart as far as it goes, whatever is wrong.
    pub fn tables(&self) -> &Tables {
        self.checked().tables()
    }

    /// What is declared where, and which names refer to it.
    pub fn symbols(&self) -> &Symbols {
        &self.checked().symbols
    }

    /// What is wrong with the text, and what may not be meant as far as that can be told without proofs; in order of
    /// place.
    pub fn diagnostics(&self) -> &Diagnostics {
        self.of_text.diagnostics.get_or_init(|| {
            let mut diagnostics = self.parsed().1.clone();
            diagnostics.append(self.checked().diagnostics.clone());
            self.tables().allowances.apply(&mut diagnostics);
            diagnostics.sort_by_place();
            diagnostics
        })
    }

    /// What may not be meant as far as only proofs can tell, in order of place. A text with errors gets no warnings.
    pub fn warnings(&self) -> &Diagnostics {
        self.of_text.warnings.get_or_init(|| {
            let analysis = self.analysis_of(false);
            #[cfg(test)]
            self.runs.count("warnings");
            let Some(analysis) = analysis else { return Diagnostics::new() };
            let mut diagnostics = grafc_logic::warn(analysis);
            let allowances = &self.tables().allowances;
            allowances.apply(&mut diagnostics);
            let without_effect = allowances.without_effect(&[self.diagnostics(), &diagnostics]);
            diagnostics.append(without_effect);
            diagnostics.sort_by_place();
            diagnostics
        })
    }

    /// The flat net for the encoding that was chosen, if there is a chart.
    pub fn net(&self) -> Option<&Net> {
        self.net_of(self.options.encoding.overlaps()).map(|net| &**net)
    }

    /// What is proved of the net for the encoding that was chosen, if there is a chart.
    pub fn analysis(&self) -> Option<&Analysis> {
        self.analysis_of(self.options.encoding.overlaps())
    }

    fn of_net(&self, overlap: bool) -> &OfNet {
        if overlap { &self.of_text.overlapping } else { &self.of_text.exact }
    }

    fn net_of(&self, overlap: bool) -> Option<&Arc<Net>> {
        let net = self.of_net(overlap).net.get_or_init(|| {
            let chart = self.chart()?;
            #[cfg(test)]
            self.runs.count("net");
            flatten(chart.clone(), overlap, &mut Diagnostics::new()).map(Arc::new)
        });
        net.as_ref()
    }

    fn analysis_of(&self, overlap: bool) -> Option<&Analysis> {
        let analysis = self.of_net(overlap).analysis.get_or_init(|| {
            let net = self.net_of(overlap)?;
            #[cfg(test)]
            self.runs.count("analysis");
            Some(Analysis::new(net.clone()))
        });
        analysis.as_ref()
    }

    /// The scan program under the options, if there is a chart.
    pub fn program(&self) -> Option<&Program> {
        let (program, diagnostics) = self.lowered(Form::Plain)?;
        Some(program).filter(|_| !diagnostics.has_errors())
    }

    /// What the chosen encoding has to say: that it does not do exactly what the rules say, where that can be seen.
    pub fn program_diagnostics(&self) -> Option<&Diagnostics> {
        self.lowered(Form::Plain).map(|(_, diagnostics)| diagnostics)
    }

    fn lowered(&self, form: Form) -> Option<&(Program, Diagnostics)> {
        let lowered = self.of_options.programs[form as usize].get_or_init(|| {
            let analysis = self.analysis()?.clone();
            #[cfg(test)]
            self.runs.count("program");
            let (program, mut diagnostics) = match form {
                Form::Plain => grafc_logic::compile(analysis, &self.options),
                Form::Saved => grafc_logic::compile_saved(analysis, &self.options),
                Form::Seen => grafc_logic::compile_observed(analysis, &self.options, Observed::Transitions),
                Form::SeenWhole => grafc_logic::compile_observed(analysis, &self.options, Observed::All),
            };
            self.tables().allowances.apply(&mut diagnostics);
            Some((program, diagnostics))
        });
        lowered.as_ref()
    }

    fn drawn(&self) -> Option<&Result<Sequence, Diagnostics>> {
        let drawn = self.of_options.sequence.get_or_init(|| {
            let analysis = self.analysis()?;
            #[cfg(test)]
            self.runs.count("sequence");
            Some(sequence(analysis, self.options.profile))
        });
        drawn.as_ref()
    }
}

/// The name of a chart that does not give itself one: that of its file.
pub fn chart_name(file: &Path) -> String {
    file.file_stem().map_or("chart".to_string(), |stem| stem.to_string_lossy().into_owned())
}
