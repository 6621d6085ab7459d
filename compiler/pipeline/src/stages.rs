//! The stages, each as one function: it takes what the stage before gave, and adds what it has to say.

use grafc_backends::Source;
use grafc_diagnostics::{Allowances, Code, Diagnostic, Diagnostics, FileId, Span};
use grafc_logic::scan::{Observed, Program};
use grafc_logic::sequence::Sequence;
use grafc_logic::{Analysis, Options};
use grafc_model::chart::Chart;
use grafc_net::Net;
use grafc_net::passes::{self, Pass};
use grafc_syntax::ast;

/// Text to syntax tree. There is always one: what cannot be read is left out.
pub fn parse(file: FileId, text: &str, diagnostics: &mut Diagnostics) -> ast::Chart {
    let (tree, found) = grafc_syntax::parse(file, text);
    diagnostics.append(found);
    tree
}

/// Syntax tree to chart, if no message is an error.
pub fn check(tree: &ast::Chart, default_name: &str, diagnostics: &mut Diagnostics) -> Option<Chart> {
    let (chart, found) = grafc_model::check(tree, default_name);
    diagnostics.append(found);
    if let Some(chart) = &chart {
        chart.allowances.apply(diagnostics);
    }
    // The author sees all faults at once, in the order of the text.
    diagnostics.sort_by_place();
    chart.filter(|_| !diagnostics.has_errors())
}

/// Chart to flat net; for encodings in which steps overlap it is another one.
pub fn flatten(chart: Chart, overlap: bool, diagnostics: &mut Diagnostics) -> Option<Net> {
    let mut net = grafc_net::into_net(chart);
    passes::run(&mut net, overlap, diagnostics);
    Some(net).filter(|_| !diagnostics.has_errors())
}

/// The net after a pass as a text; none if the pass is not run.
pub fn net_after(chart: &Chart, overlap: bool, pass: &str) -> Option<String> {
    let mut found = None;
    let look = |ran: &Pass, net: &Net| found = found.take().or((ran.name == pass).then(|| grafc_net::dump(net)));
    // What they have to say has been said.
    passes::run_and_look(&mut grafc_net::build(chart), overlap, &mut Diagnostics::new(), look);
    found
}

/// What may not be meant, as far as only proofs can tell, and the text does not allow it.
pub fn warn(analysis: &Analysis, allowances: &Allowances, diagnostics: &mut Diagnostics) {
    diagnostics.append(grafc_logic::warn(analysis));
    allowances.apply(diagnostics);
    diagnostics.append(allowances.without_effect(&[diagnostics]));
    diagnostics.sort_by_place();
}

/// The last stages, of which each thing that is made asks for the one that it is made of.
pub struct Last<'o> {
    /// Used up by the program: the net and what is proved of it would take more room than that does.
    analysis: Option<Analysis>,
    options: &'o Options,
    program: Option<Program>,
    sequence: Option<Sequence>,
    /// Whether somebody asks which lines come from which element of the chart.
    pub wants_map: bool,
    /// What the stages that were run had to say.
    pub diagnostics: Diagnostics,
}

impl<'o> Last<'o> {
    /// None has been run.
    pub fn new(analysis: Analysis, options: &'o Options) -> Self {
        let (program, sequence, diagnostics) = (None, None, Diagnostics::new());
        Last { analysis: Some(analysis), options, program, sequence, wants_map: false, diagnostics }
    }
}

impl Last<'_> {
    fn lowered(
        &mut self,
        compile: impl Fn(Analysis, &Options) -> (Program, Diagnostics),
    ) -> Result<&Program, Diagnostics> {
        let program = match self.program.take() {
            Some(program) => program,
            None => {
                let analysis = self.analysis.take().ok_or_else(used_up)?;
                let (program, found) = compile(analysis, self.options);
                if found.has_errors() {
                    return Err(found);
                }
                self.diagnostics.append(found);
                program
            }
        };
        Ok(self.program.insert(program))
    }
}

impl Source for Last<'_> {
    fn program(&mut self) -> Result<&Program, Diagnostics> {
        self.lowered(grafc_logic::compile)
    }

    fn saved_program(&mut self) -> Result<&Program, Diagnostics> {
        self.lowered(grafc_logic::compile_saved)
    }

    fn observed_program(&mut self, observed: Observed) -> Result<&Program, Diagnostics> {
        self.lowered(|analysis, options| grafc_logic::compile_observed(analysis, options, observed))
    }

    fn sequence(&mut self) -> Result<&Sequence, Diagnostics> {
        let sequence = match self.sequence.take() {
            Some(sequence) => sequence,
            None => {
                let analysis = self.analysis.as_ref().ok_or_else(used_up)?;
                grafc_logic::sequence::sequence(analysis, self.options.profile)?
            }
        };
        Ok(self.sequence.insert(sequence))
    }

    fn wants_map(&self) -> bool {
        self.wants_map
    }
}

/// A target asks for things in the wrong order.
fn used_up() -> Diagnostics {
    let mut fault = Diagnostics::new();
    fault.push(Diagnostic::new(Code::E0901, Span::default(), "internal error: the program has been made already"));
    fault
}
