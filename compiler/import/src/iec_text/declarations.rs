//! Variables and types in text.

use super::reader::Reader;
use crate::code::expression;
use crate::code::token::{Keyword, Token};
use crate::sfc::{ByName, Enumeration, Section, Structure, Variable};

impl Reader<'_> {
    /// The variables up to `END_VAR`.
    pub fn variables(&mut self, section: Section) -> Vec<Variable> {
        self.advance();
        let (range, _) = self.up_to(Keyword::EndVar);
        let behind = std::mem::replace(&mut self.at, range.start);
        let (mut constant, mut retain) = (false, false);
        let mut found = Vec::new();
        while self.at < range.end {
            match self.text_at(self.at).to_ascii_uppercase().as_str() {
                "CONSTANT" => constant = true,
                "RETAIN" | "PERSISTENT" => retain = true,
                "NON_RETAIN" => {}
                _ => {
                    let end = self.end_of_declaration(range.end);
                    found.extend(self.declaration(end, section));
                    self.at = end + 1;
                    continue;
                }
            }
            self.advance();
        }
        self.at = behind;
        found.into_iter().map(|variable| Variable { constant, retain, ..variable }).collect()
    }

    /// Where the semicolon of a declaration is.
    fn end_of_declaration(&self, most: usize) -> usize {
        (self.at..most).find(|&at| self.token_at(at) == Some(Token::Semicolon)).unwrap_or(most)
    }

    /// `a, b AT %IX0.0 : BOOL := TRUE`.
    fn declaration(&mut self, end: usize, section: Section) -> Vec<Variable> {
        let mut names = Vec::new();
        let mut address = None;
        while self.at < end {
            let span = self.span();
            if self.take(Token::Keyword(Keyword::At)) {
                address = Some(self.text_at(self.at).to_string());
                self.advance();
            } else if self.take(Token::Colon) {
                break;
            } else if let Some(name) = self.word() {
                names.push((name.to_string(), span));
            } else {
                self.advance();
            }
        }
        let assign = (self.at..end).find(|&at| self.token_at(at) == Some(Token::Assign));
        let of = (self.at..assign.unwrap_or(end)).find(|&at| self.token_at(at) == Some(Token::Keyword(Keyword::Of)));
        let mut ty = self.text_at(of.map_or(self.at, |of| of + 1)).to_string();
        if of.is_some() {
            ty = format!("ARRAY OF {ty}");
        }
        let initial = assign.map(|assign| {
            let source = self.source(assign + 1..end);
            expression(&source, self.code)
        });
        let variable = |(name, span)| Variable {
            name,
            section,
            ty: ty.clone(),
            initial,
            address: address.clone().filter(|address| address.starts_with('%') && !address.contains('*')),
            comment: None,
            constant: false,
            retain: false,
            span,
        };
        names.into_iter().map(variable).collect()
    }

    /// The types up to `END_TYPE`.
    pub fn types(&mut self, enumerations: &mut ByName<Enumeration>, structures: &mut ByName<Structure>) {
        self.advance();
        let (range, _) = self.up_to(Keyword::EndType);
        let behind = std::mem::replace(&mut self.at, range.start);
        while self.at < range.end {
            let Some(name) = self.word().map(str::to_string) else {
                self.advance();
                continue;
            };
            if !self.take(Token::Colon) {
                continue;
            }
            if self.take(Token::Keyword(Keyword::Struct)) {
                let stop = (self.at..range.end)
                    .find(|&at| self.token_at(at) == Some(Token::Keyword(Keyword::EndStruct)))
                    .unwrap_or(range.end);
                let mut members = ByName::default();
                while self.at < stop {
                    let end = self.end_of_declaration(stop);
                    members.extend(self.declaration(end, Section::Local));
                    self.at = end + 1;
                }
                self.at = stop + 1;
                structures.push(Structure { name, members });
            } else if self.take(Token::OpenParen) {
                enumerations.push(Enumeration { name, values: self.values(range.end) });
            } else {
                self.at = self.end_of_declaration(range.end) + 1;
            }
        }
        self.at = behind;
    }

    /// `Red, Green := 5, Blue)`.
    fn values(&mut self, most: usize) -> Vec<(String, i64)> {
        let mut values: Vec<(String, i64)> = Vec::new();
        let mut next = 0_i64;
        while self.at < most && !self.take(Token::CloseParen) {
            if self.take(Token::Assign) {
                if let (Ok(number), Some(last)) = (self.text_at(self.at).parse::<i64>(), values.last_mut()) {
                    last.1 = number;
                    next = number.saturating_add(1);
                }
                self.advance();
            } else if let Some(name) = self.word() {
                values.push((name.to_string(), next));
                next = next.saturating_add(1);
            } else {
                self.advance();
            }
        }
        self.at = self.end_of_declaration(most) + 1;
        values
    }

    /// The global variables of a configuration; the rest of it says who runs what.
    pub fn configuration(&mut self, globals: &mut ByName<Variable>) {
        self.advance();
        let (range, _) = self.up_to(Keyword::EndConfiguration);
        let behind = std::mem::replace(&mut self.at, range.start);
        while self.at < range.end {
            if self.token() == Some(Token::Keyword(Keyword::VarGlobal)) {
                globals.extend(self.variables(Section::Global));
            } else {
                self.advance();
            }
        }
        self.at = behind;
    }
}
