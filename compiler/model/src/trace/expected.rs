//! A test as a table: before a column `|` a stimulus trace, behind it what is expected of outputs, variables, steps, the
//! situation and flags. A blank cell expects nothing; `{}` is an empty situation, or no flag.
//!
//! Each cell that is not as the chart has it is an error of its own, with its place.

use super::columns::{BAR, Heading, bar, columns, kind_of, unknown};
use super::given::Given;
use super::results::{About, Results, own_columns};
use super::row::Row;
use super::rows::Rows;
use super::said::{Kept, Said};
use crate::chart::{Chart, Value, Variable, VariableKind};
use crate::reaction::{Response, Stimulus};
use crate::resolve::suggest::Suggestions;
use crate::simulate::Probe;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use std::collections::BTreeMap;
use std::io::{self, Read};

/// A test that is read as its run goes on.
pub struct Expectations<'a, R> {
    rows: Rows<R>,
    said: Said,
    given: Given<'a>,
    results: Results<'a>,
    /// What stands behind the column `|`; none is a column that was reported.
    expected: Vec<Option<About>>,
    probes: Vec<Probe>,
    /// The place of the column `|`.
    bar: usize,
    header: Row,
    row: Row,
    /// Whether the row at hand can be compared.
    is_read: bool,
    is_over: bool,
    /// Whether a cell expected something.
    has_expected: bool,
}

impl<'a, R: Read> Expectations<'a, R> {
    /// A test of a chart, whose header is read. The caller has the text.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn new(file: FileId, text: R, chart: &'a Chart) -> io::Result<Self> {
        let (mut rows, mut said, mut header) = (Rows::new(text)?, Said::new(file, Kept::Whole), Row::default());
        let found = rows.header(&mut header, &mut said)?;
        let width = if found { header.len() } else { 0 };
        let bar = bar(&header);
        let given = Given::new(&mut said, &header, chart, bar.unwrap_or(width).min(width));
        let results = Results::new(chart);
        let mut expected = Vec::new();
        match bar {
            Some(bar) => expected = roles(&mut said, &header, bar + 1, &results),
            None if found => {
                let place = said.place(&header, 0..header.text.len());
                let message = format!("the test has no column `{BAR}`");
                let help = format!("write what is given, `{BAR}`, and what is expected: `t_ms,a,{BAR},V,situation`");
                said.error(Diagnostic::new(Code::E0601, place, message).help(help));
            }
            None => {}
        }
        let mut probes = Vec::new();
        for about in expected.iter_mut().flatten() {
            if let About::Probe(probe, place) = about {
                *place = probes.len();
                probes.push(*probe);
            }
        }
        let (bar, row) = (bar.unwrap_or(width), Row::default());
        let (is_read, has_expected) = (false, false);
        let is_over = !found;
        Ok(Expectations {
            rows,
            said,
            given,
            results,
            expected,
            probes,
            bar,
            header,
            row,
            is_read,
            is_over,
            has_expected,
        })
    }

    /// What has to be looked at after each call, beside outputs and situation.
    pub fn probes(&self) -> &[Probe] {
        &self.probes
    }

    /// Whether something is wrong so far: with the table, or with what the chart does.
    pub fn has_errors(&self) -> bool {
        self.said.has_errors()
    }

    /// How many errors there are so far.
    pub fn faults(&self) -> usize {
        self.said.errors()
    }

    /// What the next row gives, if there is one.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn next_row(&mut self) -> io::Result<Option<Stimulus>> {
        self.is_read = false;
        if self.is_over {
            return Ok(None);
        }
        let next = self.given.next(&mut self.rows, &mut self.row, &mut self.said, self.header.len())?;
        self.is_over = next.is_none();
        Ok(next.map(|(stimulus, fits)| {
            self.is_read = fits;
            stimulus
        }))
    }

    /// Reads what the row at hand expects, and compares it with what its call came to, if there was one; with what the
    /// probes showed.
    pub fn compare(&mut self, done: Option<(&Response, &[Value])>) {
        if !self.is_read {
            return;
        }
        for (place, about) in self.expected.iter().enumerate() {
            let (Some(about), column) = (*about, self.bar + 1 + place) else { continue };
            let text = self.row.cell(column);
            if text.is_empty() {
                continue;
            }
            self.has_expected = true;
            let Some(expected) = self.results.read(about, text, (&self.row, column), &mut self.said) else { continue };
            let Some((response, looks)) = done else { continue };
            let Some(found) = self.results.done(about, response, looks) else { continue };
            if !self.results.agree(about, &expected, &found) {
                let [expected, found] = [expected, found].map(|saying| self.results.spelled(about, &saying));
                let (t_ms, name) = (self.given.times.latest(), self.results.name(about));
                let message = format!("at {t_ms} ms `{name}` is {found}, expected {expected}");
                let place = self.said.cell(&self.row, column);
                self.said.error(Diagnostic::new(Code::E0607, place, message));
            }
        }
    }

    /// The places of the times of the latest row, and of the row before it.
    pub fn places(&mut self) -> (Span, Span) {
        let before = self.said.cell(&self.given.times.before, 0);
        (self.said.cell(&self.row, 0), before)
    }

    /// Says something else about the test.
    pub fn say(&mut self, diagnostic: Diagnostic) {
        self.said.say(diagnostic);
    }

    /// All that is to be said; also that nothing was expected, if that is so.
    pub fn finish(mut self) -> Diagnostics {
        if !self.has_expected && !self.said.has_errors() {
            let place = self.said.place(&self.header, 0..self.header.text.len());
            let error = Diagnostic::new(Code::E0601, place, "the test expects nothing")
                .note("a blank cell expects nothing")
                .help(format!("write values of outputs, variables or `situation` behind the column `{BAR}`"));
            self.said.error(error);
        }
        self.said.finish().0
    }
}

fn roles(said: &mut Said, header: &Row, start: usize, results: &Results) -> Vec<Option<About>> {
    let chart = results.chart;
    let mut roles: BTreeMap<&str, Option<About>> = BTreeMap::new();
    let outputs = results.outputs.iter().enumerate();
    roles.extend(outputs.map(|(place, v)| (v.name.as_str(), Some(About::Output(place)))));
    for column in start..header.len() {
        let name = Heading::read(header.cell(column)).name;
        let other = Probe::of(name, chart).filter(|probe| match *probe {
            Probe::Variable(id) => match chart.variables[id].kind {
                VariableKind::Internal | VariableKind::Constant => true,
                VariableKind::Input | VariableKind::Output => false,
            },
            Probe::Step(_) | Probe::Duration(_) | Probe::Macro(_) | Probe::Grafcet(_) | Probe::Frozen(_) => true,
        });
        if let Some(probe) = other {
            // Its place among the probes is known once all are.
            roles.insert(name, Some(About::Probe(probe, 0)));
        }
    }
    let candidates: Vec<&Variable> =
        chart.variables.iter().filter(|v| matches!(v.kind, VariableKind::Output | VariableKind::Internal)).collect();
    let looks = Suggestions::new();
    let fault = |name: &str, span| match chart.variables.iter().find(|variable| variable.name == name) {
        Some(variable) => {
            let message = format!("`{name}` is {} of the chart: nothing is expected of it", kind_of(variable));
            Diagnostic::new(Code::E0602, span, message).help(format!("what is given stands before the column `{BAR}`"))
        }
        None => unknown(format!("the chart has no output or variable `{name}`"), name, span, &candidates, &looks),
    };
    columns(said, header, start..header.len(), (None, None), &own_columns(Some), &roles, fault)
}
