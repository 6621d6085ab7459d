//! A list of values as bytes, and back: a fingerprint, the values one after the other, a seal.
//!
//! What is written here serves all memory (`saved`) and what is retained over a restart (`retained`).

use super::places::Places;
use crate::types::size;
use crate::writer::Writer;
use grafc_logic::scan::{Program, TimerId, VarId};

/// The bytes of the fingerprint and of the seal.
const AROUND: usize = 8 + 4;

/// A value of the memory.
#[derive(Clone, Copy)]
pub(super) enum Piece {
    /// So many words of the packed situation.
    Situation(usize),
    Variable(VarId),
    Timer(TimerId),
}

/// What is saved, and what the functions are called that do it.
pub(super) struct Record<'a> {
    /// What is saved, as a document says it.
    pub what: &'a str,
    /// The constants of the length and of the fingerprint, with what the latter is.
    pub constants: [&'a str; 2],
    pub fingerprint: (&'a str, u64),
    /// The function that saves, and what it does.
    pub save: (&'a str, &'a [&'a str]),
    /// The function that gives back, what it does, and what it is given beside the bytes.
    pub restore: (&'a str, &'a [&'a str], &'a str),
    pub pieces: Vec<Piece>,
    /// When what has been given back is refused.
    pub refused: Vec<String>,
    /// What is done then.
    pub then: Option<String>,
}

impl Record<'_> {
    /// Writes constants and functions, in functions of at most about `longest` lines.
    pub fn write(&self, out: &mut Writer, program: &Program, places: &Places, longest: usize) {
        let length: usize = AROUND + self.pieces.iter().map(|piece| bytes(*piece, program, places)).sum::<usize>();
        let ([name, print], (about, value)) = (self.constants, self.fingerprint);
        out.line(&format!("/// How many bytes {}.", self.what));
        out.line(&format!("pub const {name}: usize = {length};"));
        out.blank();
        out.line(&format!("/// {about}"));
        out.line(&format!("const {print}: u64 = 0x{value:016x};"));
        let lines: Vec<String> = self.pieces.iter().flat_map(|piece| put(*piece, places)).collect();
        self.save(out, &lines, longest);
        let lines: Vec<String> = self.pieces.iter().flat_map(|piece| take(*piece, places)).collect();
        self.restore(out, &lines, longest);
    }

    fn save(&self, out: &mut Writer, lines: &[String], longest: usize) {
        let ([name, print], (function, about)) = (self.constants, self.save);
        let chunks = Chunks::new(function, lines, longest);
        out.blank();
        about.iter().for_each(|line| out.line(&format!("/// {line}")));
        out.open(&format!("pub fn {function}(&self) -> [u8; Self::{name}] {{"));
        out.line(&format!("let mut bytes = [0; Self::{name}];"));
        out.line("let mut out = Saver::new(&mut bytes);");
        out.line(&format!("out.put(Self::{print});"));
        match &chunks {
            None => lines.iter().for_each(|line| out.line(line)),
            Some(chunks) => chunks.call(out, |name| format!("self.{name}(&mut out);")),
        }
        out.line("seal(&mut bytes);");
        out.line("bytes");
        out.close("}");
        if let Some(chunks) = chunks {
            chunks.write(out, |_| "(&self, out: &mut Saver)".to_owned(), None);
        }
    }

    fn restore(&self, out: &mut Writer, lines: &[String], longest: usize) {
        let ([name, print], (function, about, given)) = (self.constants, self.restore);
        let chunks = Chunks::new(function, lines, longest);
        // Only timers ask for the time.
        let timers = |lines: &[String]| lines.iter().any(|line| line.contains("Timer::resumed("));
        out.blank();
        about.iter().for_each(|line| out.line(&format!("/// {line}")));
        out.open(&format!("pub fn {function}(bytes: &[u8]{given}) -> Option<Self> {{"));
        out.open(&format!("if bytes.len() != Self::{name} {{"));
        out.line("return None;");
        out.close("}");
        out.line("let mut from = Restorer::sealed(bytes)?;");
        out.open(&format!("if from.take() != Some(Self::{print}) {{"));
        out.line("return None;");
        out.close("}");
        out.line("let mut chart = Self::new();");
        match &chunks {
            None => lines.iter().for_each(|line| out.line(&line.replace("self.", "chart."))),
            Some(chunks) => {
                for (name, lines) in chunks.parts() {
                    let now = if timers(lines) { ", now" } else { "" };
                    out.line(&format!("chart.{name}(&mut from{now})?;"));
                }
            }
        }
        for when in &self.refused {
            out.open(&format!("if {when} {{"));
            out.line("return None;");
            out.close("}");
        }
        self.then.iter().for_each(|line| out.line(line));
        out.line("Some(chart)");
        out.close("}");
        if let Some(chunks) = chunks {
            let now = |lines: &[String]| if timers(lines) { ", now: u32" } else { "" };
            let head = |lines: &[String]| format!("(&mut self, from: &mut Restorer{}) -> Option<()>", now(lines));
            chunks.write(out, head, Some("Some(())"));
        }
    }
}

/// How many bytes a piece takes. A state is saved as the number of its variant.
fn bytes(piece: Piece, program: &Program, places: &Places) -> usize {
    match piece {
        Piece::Situation(words) => 4 * words,
        Piece::Variable(id) if places.state(id).is_some() => 4,
        Piece::Variable(id) => size(program.variables[id].ty),
        Piece::Timer(_) => 1 + 8,
    }
}

/// The lines that save a piece.
fn put(piece: Piece, places: &Places) -> Vec<String> {
    match piece {
        Piece::Situation(words) => (0..words).map(|word| format!("out.put(self.situation[{word}]);")).collect(),
        Piece::Variable(id) => {
            let place = places.read(id);
            let number = if places.state(id).is_some() { " as u32" } else { "" };
            vec![format!("out.put({place}{number});")]
        }
        Piece::Timer(id) => {
            let timer = places.timer(id);
            vec![format!("out.put({timer}.state().0);"), format!("out.put({timer}.state().1);")]
        }
    }
}

/// The lines that give a piece back.
fn take(piece: Piece, places: &Places) -> Vec<String> {
    match piece {
        Piece::Situation(words) => (0..words).map(|word| format!("self.situation[{word}] = from.take()?;")).collect(),
        Piece::Variable(id) => {
            let place = places.read(id);
            vec![match places.state(id) {
                Some(state) => format!("{place} = *{}::ALL.get(from.take::<u32>()? as usize)?;", state.ty),
                None => format!("{place} = from.take()?;"),
            }]
        }
        Piece::Timer(id) => {
            vec![format!("{} = Timer::resumed((from.take()?, from.take()?), now)?;", places.timer(id))]
        }
    }
}

/// The lines of a function that is too long for rustc, as functions of their own.
struct Chunks<'l> {
    function: &'l str,
    lines: std::slice::Chunks<'l, String>,
}

impl<'l> Chunks<'l> {
    fn new(function: &'l str, lines: &'l [String], longest: usize) -> Option<Self> {
        (lines.len() > longest).then(|| Chunks { function, lines: lines.chunks(longest) })
    }

    /// The names of all parts, and what they do.
    fn parts(&self) -> impl Iterator<Item = (String, &'l [String])> {
        let function = self.function;
        (1..).map(move |part| format!("{function}_{part}")).zip(self.lines.clone())
    }

    /// Writes the calls of all parts.
    fn call(&self, out: &mut Writer, call: impl Fn(&str) -> String) {
        self.parts().for_each(|(name, _)| out.line(&call(&name)));
    }

    /// Writes the parts; `end` is the last line of each.
    fn write(self, out: &mut Writer, head: impl Fn(&[String]) -> String, end: Option<&str>) {
        for (name, lines) in self.parts() {
            out.blank();
            out.line("#[inline(never)]");
            out.open(&format!("fn {name}{} {{", head(lines)));
            lines.iter().for_each(|line| out.line(line));
            end.iter().for_each(|line| out.line(line));
            out.close("}");
        }
    }
}
