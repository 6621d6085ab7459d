//! The rungs as elements, each with its place, its size and the points of its wires.

use super::layout::{
    CONTACT, FIRST_PIN, LEFT, Layout, PIN, PINS, Placed, RAIL, TEXT_HEIGHT, TURN, block_size, row, text_width,
};
use super::rung::{BlockCall, Coil, Contact, End, Item, Rung, Sink, Storage};
use crate::plcopen::dialect::Dialect;
use crate::plcopen::drawing::{Point, connection, open, output, position, relative};
use crate::xml::Xml;

/// Writes all rungs, from the top down: what they do, they do in the order of the elements.
pub(super) fn write(xml: &mut Xml, rungs: &[Rung], layout: &Layout, dialect: Dialect) {
    let mut sheet = Sheet { layout, dialect, next: 1 };
    xml.open("LD", &[]);
    for (rung, placed) in rungs.iter().zip(&layout.rungs) {
        sheet.rung(xml, rung, placed);
    }
    xml.close();
}

struct Sheet<'l> {
    layout: &'l Layout,
    dialect: Dialect,
    /// The next local id.
    next: usize,
}

/// Where power comes from: an object, its pin, and where that is.
#[derive(Clone, Copy)]
struct Source {
    object: usize,
    pin: Option<&'static str>,
    at: Point,
}

/// What the next thing is wired to.
enum Feed {
    /// The left rail, straight.
    Rail(usize),
    /// Sources that meet at this column.
    Sources(Vec<Source>, i64),
}

impl Sheet<'_> {
    fn id(&mut self) -> usize {
        self.next += 1;
        self.next - 1
    }

    fn rung(&mut self, xml: &mut Xml, rung: &Rung, placed: &Placed) {
        for note in &placed.notes {
            let id = self.id();
            open(xml, "comment", id, note.size, &[]);
            position(xml, note.at);
            xml.open("content", &[]);
            self.dialect.formatted(xml, &note.lines.join("\n"));
            xml.close();
            xml.close();
        }
        let mut feed = Feed::Rail(self.left_rail(xml, rung, placed));
        for (place, item) in rung.items.iter().enumerate() {
            let lefts = &placed.contacts[place];
            let (part, meet) = placed.turns[place];
            let branches: Vec<&[Contact]> = match item {
                Item::Contact(contact) => vec![std::slice::from_ref(contact)],
                Item::Group(branches) => branches.iter().map(Vec::as_slice).collect(),
            };
            let mut ends = Vec::with_capacity(branches.len());
            for (line, branch) in branches.into_iter().enumerate() {
                let y = row(placed, line);
                let mut last = None;
                for (contact, left) in branch.iter().zip(&lefts[line]) {
                    let before = last.map(|source| Feed::Sources(vec![source], part));
                    last = Some(self.contact(xml, contact, (*left, y), before.as_ref().unwrap_or(&feed), placed, part));
                }
                ends.extend(last);
            }
            feed = Feed::Sources(ends, meet);
        }
        let ends = match &rung.end {
            End::Coils(coils) => self.coils(xml, coils, placed, &feed),
            End::Block(block) => self.block(xml, block, placed, &feed),
        };
        self.right_rail(xml, placed, &ends);
    }

    /// The left rail, with a pin for each row that begins there.
    fn left_rail(&mut self, xml: &mut Xml, rung: &Rung, placed: &Placed) -> usize {
        let rows = match (rung.items.first(), &rung.end) {
            (Some(Item::Contact(_)), _) | (None, End::Block(_)) => 1,
            (Some(Item::Group(branches)), _) => branches.len(),
            (None, End::Coils(coils)) => coils.len(),
        };
        let id = self.id();
        open(xml, "leftPowerRail", id, (RAIL, placed.height), &[]);
        position(xml, (LEFT, placed.top));
        for line in 0..rows {
            output(xml, "connectionPointOut", Some(""), (RAIL, row(placed, line) - placed.top));
        }
        xml.close();
        id
    }

    /// The right rail, with a pin for each wire that ends there.
    fn right_rail(&mut self, xml: &mut Xml, placed: &Placed, ends: &[Source]) {
        let corner = (self.layout.right, placed.top);
        let id = self.id();
        open(xml, "rightPowerRail", id, (RAIL, placed.height), &[]);
        position(xml, corner);
        for end in ends {
            let pin = (corner.0, end.at.1);
            xml.open("connectionPointIn", &[]);
            relative(xml, pin, corner);
            connection(xml, end.object, end.pin, &[end.at, pin]);
            xml.close();
        }
        xml.close();
    }

    /// An input at a place, fed from what is on its left; the wire turns at `part`.
    fn input(&self, xml: &mut Xml, pin: Point, corner: Point, feed: &Feed, placed: &Placed, part: i64) {
        xml.open("connectionPointIn", &[]);
        relative(xml, pin, corner);
        match feed {
            Feed::Rail(rail) => connection(xml, *rail, None, &[(LEFT + RAIL, pin.1), pin]),
            Feed::Sources(sources, meet) => {
                for source in sources {
                    let mut points = vec![source.at];
                    for (x, to) in [(*meet, placed.row), (part, pin.1)] {
                        let from = points.last().map_or(to, |at| at.1);
                        // Within a branch nothing turns.
                        if from != to && (source.at.1 != pin.1 || sources.len() > 1) {
                            points.extend([(x, from), (x, to)]);
                        }
                    }
                    points.push(pin);
                    connection(xml, source.object, source.pin, &points);
                }
            }
        }
        xml.close();
    }

    fn contact(
        &mut self,
        xml: &mut Xml,
        contact: &Contact,
        (left, y): Point,
        feed: &Feed,
        placed: &Placed,
        part: i64,
    ) -> Source {
        let (id, corner) = (self.id(), (left, y - PIN));
        let negated: &[(&str, &str)] = if contact.negated { &[("negated", "true")] } else { &[] };
        open(xml, "contact", id, CONTACT, negated);
        position(xml, corner);
        self.input(xml, (left, y), corner, feed, placed, part);
        output(xml, "connectionPointOut", None, (CONTACT.0, PIN));
        xml.text("variable", &[], &contact.name);
        xml.close();
        Source { object: id, pin: None, at: (left + CONTACT.0, y) }
    }

    fn coil(&mut self, xml: &mut Xml, coil: &Coil, y: i64, feed: &Feed, placed: &Placed) -> Source {
        let left = self.layout.coils;
        let (id, corner) = (self.id(), (left, y - PIN));
        let storage: &[(&str, &str)] = match coil.storage {
            Storage::Plain => &[],
            Storage::Set => &[("storage", "set")],
            Storage::Reset => &[("storage", "reset")],
        };
        open(xml, "coil", id, CONTACT, storage);
        position(xml, corner);
        self.input(xml, (left, y), corner, feed, placed, self.layout.turn);
        output(xml, "connectionPointOut", None, (CONTACT.0, PIN));
        xml.text("variable", &[], &coil.name);
        xml.close();
        Source { object: id, pin: None, at: (left + CONTACT.0, y) }
    }

    /// Coils below each other; what leads on from them.
    fn coils(&mut self, xml: &mut Xml, coils: &[Coil], placed: &Placed, feed: &Feed) -> Vec<Source> {
        let lines = coils.iter().enumerate();
        lines.map(|(line, coil)| self.coil(xml, coil, row(placed, line), feed, placed)).collect()
    }

    /// A block with the texts at its inputs, then what its outputs lead to; what goes on to the right rail.
    fn block(&mut self, xml: &mut Xml, block: &BlockCall, placed: &Placed, feed: &Feed) -> Vec<Source> {
        let size = block_size(block);
        let corner = (placed.block, placed.row - FIRST_PIN);
        let pin_at = |place: usize| placed.row + PINS * i64::try_from(place).unwrap_or(0);
        let mut texts = Vec::with_capacity(block.inputs.len());
        for (place, (_, text)) in block.inputs.iter().enumerate() {
            let (id, y, width) = (self.id(), pin_at(place + 1), text_width(text) + 10);
            let left = placed.block - TURN - width;
            open(xml, "inVariable", id, (width, TEXT_HEIGHT), &[]);
            position(xml, (left, y - TEXT_HEIGHT / 2));
            output(xml, "connectionPointOut", None, (width, TEXT_HEIGHT / 2));
            xml.text("expression", &[], text);
            xml.close();
            texts.push(Source { object: id, pin: None, at: (left + width, y) });
        }
        let id = self.id();
        let mut attributes = vec![("typeName", block.kind)];
        attributes.extend(block.instance.as_deref().map(|name| ("instanceName", name)));
        open(xml, "block", id, size, &attributes);
        position(xml, corner);
        xml.open("inputVariables", &[]);
        xml.open("variable", &[("formalParameter", block.power)]);
        self.input(xml, (corner.0, placed.row), corner, feed, placed, corner.0 - TURN);
        xml.close();
        for ((name, _), text) in block.inputs.iter().zip(texts) {
            xml.open("variable", &[("formalParameter", name)]);
            xml.open("connectionPointIn", &[]);
            let pin = (corner.0, text.at.1);
            relative(xml, pin, corner);
            connection(xml, text.object, None, &[text.at, pin]);
            xml.close();
            xml.close();
        }
        xml.close();
        xml.empty("inOutVariables", &[]);
        xml.open("outputVariables", &[]);
        for (place, (name, _)) in block.outputs.iter().enumerate() {
            xml.open("variable", &[("formalParameter", name)]);
            output(xml, "connectionPointOut", None, (size.0, pin_at(place) - corner.1));
            xml.close();
        }
        xml.close();
        xml.close();
        let mut ends = Vec::new();
        for (place, (name, sink)) in block.outputs.iter().enumerate() {
            let source = Source { object: id, pin: Some(name), at: (corner.0 + size.0, pin_at(place)) };
            match sink {
                Sink::Open => {}
                Sink::Rail => ends.push(source),
                Sink::Coil(name) => {
                    let coil = Coil { name: name.clone(), storage: Storage::Plain };
                    ends.push(self.coil(xml, &coil, source.at.1, &Feed::Sources(vec![source], 0), placed));
                }
                Sink::Variable(name) => self.result(xml, name, placed.behind, source),
            }
        }
        ends
    }

    /// A variable that takes what a block gives.
    fn result(&mut self, xml: &mut Xml, name: &str, left: i64, source: Source) {
        let (id, width) = (self.id(), text_width(name) + 10);
        let corner = (left, source.at.1 - TEXT_HEIGHT / 2);
        open(xml, "outVariable", id, (width, TEXT_HEIGHT), &[]);
        position(xml, corner);
        xml.open("connectionPointIn", &[]);
        let pin = (left, source.at.1);
        relative(xml, pin, corner);
        connection(xml, source.object, source.pin, &[source.at, pin]);
        xml.close();
        xml.text("expression", &[], name);
        xml.close();
    }
}
