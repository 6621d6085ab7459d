//! The textual form of sequential function charts (IEC 61131-3, 2.6): `INITIAL_STEP … END_STEP`,
//! `TRANSITION … END_TRANSITION`, `ACTION … END_ACTION`, with the declarations around them.
//!
//! Each element is read by itself, up to the word that ends it; what is not understood in one never reaches the next.

mod chart;
mod declarations;
mod reader;

use crate::code::tree::Code;
use crate::sfc::{Chart, Project, Section, Unit};
use chart::Links;
use grafc_diagnostics::{Code as ErrorCode, Diagnostic, Diagnostics, FileId};
use reader::Reader;

use crate::code::token::{Keyword, Token};

/// The project of a text.
pub fn read(file: FileId, text: &str, diagnostics: &mut Diagnostics) -> Project {
    let mut project = Project::default();
    let mut code = Code::default();
    let mut reader = Reader::new(file, text, &mut code, diagnostics);
    let mut open: Option<(Unit, Chart, Links)> = None;
    while let Some(token) = reader.token() {
        let Token::Keyword(keyword) = token else {
            reader.advance();
            continue;
        };
        match keyword {
            Keyword::Program | Keyword::FunctionBlock => {
                close(&mut project, open.take(), &mut reader);
                open = reader.unit().map(|unit| (unit, Chart::default(), Links::default()));
            }
            Keyword::EndProgram | Keyword::EndFunctionBlock => {
                reader.advance();
                close(&mut project, open.take(), &mut reader);
            }
            Keyword::Function => reader.skip_to(Keyword::EndFunction),
            Keyword::Configuration => reader.configuration(&mut project.globals),
            Keyword::Type => reader.types(&mut project.enumerations, &mut project.structures),
            Keyword::Var
            | Keyword::VarInput
            | Keyword::VarOutput
            | Keyword::VarInOut
            | Keyword::VarExternal
            | Keyword::VarGlobal
            | Keyword::VarTemp => {
                let section = section(keyword);
                let variables = reader.variables(section);
                match &mut open {
                    Some((unit, ..)) if section != Section::Global => unit.variables.extend(variables),
                    _ => project.globals.extend(variables),
                }
            }
            Keyword::InitialStep | Keyword::Step => {
                let step = reader.step(keyword == Keyword::InitialStep);
                if let (Some((_, chart, _)), Some(step)) = (&mut open, step) {
                    chart.steps.push(step);
                }
            }
            Keyword::Transition => {
                let transition = reader.transition();
                if let (Some((.., links)), Some(transition)) = (&mut open, transition) {
                    links.transitions.push(transition);
                }
            }
            Keyword::Action => {
                let action = reader.action();
                if let (Some((unit, ..)), Some(action)) = (&mut open, action) {
                    unit.actions.push(action);
                }
            }
            _ => reader.advance(),
        }
    }
    if let Some((unit, ..)) = &open {
        let message = format!("the text ends within `{}`", unit.name);
        let help = "end it with `END_PROGRAM` or `END_FUNCTION_BLOCK`, or take the file from a copy that is whole";
        reader.diagnostics.push(Diagnostic::new(ErrorCode::E0705, unit.span, message).help(help));
    }
    close(&mut project, open, &mut reader);
    project.code = code;
    project
}

/// Ends a unit: its transitions name steps that may stand behind them.
fn close(project: &mut Project, open: Option<(Unit, Chart, Links)>, reader: &mut Reader) {
    let Some((mut unit, mut chart, links)) = open else { return };
    links.resolve(&mut chart, reader.diagnostics);
    if !chart.steps.is_empty() || !chart.transitions.is_empty() {
        unit.chart = Some(chart);
    }
    project.units.push(unit);
}

fn section(keyword: Keyword) -> Section {
    match keyword {
        Keyword::VarInput => Section::Input,
        Keyword::VarOutput => Section::Output,
        Keyword::VarInOut => Section::InOut,
        Keyword::VarExternal => Section::External,
        Keyword::VarGlobal => Section::Global,
        _ => Section::Local,
    }
}
