//! Where the objects of a drawn body stand on its sheet: nothing on something else, and wires from pin to pin.

use crate::plcopen_lint::document::{Document, Id};
use std::collections::BTreeMap;

/// Where power, or control, goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Flow {
    /// From left to right, as in a ladder.
    Right,
    /// From the top down, as in a sequential function chart.
    Down,
}

/// The sheet of one body.
pub struct Sheet<'d> {
    document: &'d Document,
    body: Id,
}

impl<'d> Sheet<'d> {
    /// The sheet of the first body in a language, `LD` or `SFC`.
    pub fn of(document: &'d Document, language: &str) -> Option<Sheet<'d>> {
        Some(Sheet { document, body: document.all(language).next()? })
    }

    /// What is drawn, in document order.
    pub fn objects(&self) -> &'d [Id] {
        &self.document.get(self.body).children
    }

    /// The same by the number that wires name.
    pub fn numbered(&self) -> BTreeMap<&'d str, Id> {
        self.objects().iter().filter_map(|id| Some((self.document.attribute(*id, "localId")?, *id))).collect()
    }

    /// The place and the size of an object: left, top, right, bottom.
    pub fn frame(&self, object: Id) -> Option<[i64; 4]> {
        let (x, y) = self.point(self.document.child(object, "position")?)?;
        Some([x, y, x + self.number(object, "width")?, y + self.number(object, "height")?])
    }

    fn number(&self, id: Id, key: &str) -> Option<i64> {
        self.document.attribute(id, key)?.parse().ok()
    }

    fn point(&self, id: Id) -> Option<(i64, i64)> {
        Some((self.number(id, "x")?, self.number(id, "y")?))
    }

    /// Where on the sheet a pin of an object is.
    fn pin(&self, object: Id, pin: Id) -> Option<(i64, i64)> {
        let [left, top, ..] = self.frame(object)?;
        let (x, y) = self.point(self.document.child(pin, "relPosition")?)?;
        Some((left + x, top + y))
    }

    /// Nothing is off the sheet or touches something else; the error says what.
    pub fn stands_clear(&self) -> Result<(), String> {
        let frames: Option<Vec<[i64; 4]>> = self.objects().iter().map(|id| self.frame(*id)).collect();
        let mut frames = frames.ok_or("an object has no place or no size")?;
        if let Some(frame) = frames.iter().find(|[left, top, ..]| *left < 0 || *top < 0) {
            return Err(format!("{frame:?} is off the sheet"));
        }
        frames.sort_unstable_by_key(|frame| frame[1]);
        for (place, a) in frames.iter().enumerate() {
            // Only what begins above the lower end can touch it.
            let near = frames[place + 1..].iter().take_while(|b| b[1] <= a[3]);
            if let Some(b) = near.into_iter().find(|b| a[2] >= b[0] && b[2] >= a[0]) {
                return Err(format!("{a:?} and {b:?} touch"));
            }
        }
        Ok(())
    }

    /// Each wire begins at the pin that it is written with, ends at a pin of what it names, and runs square and never
    /// against the flow; the error says which does not.
    pub fn is_wired(&self, flow: Flow) -> Result<(), String> {
        let objects = self.numbered();
        for &object in self.objects() {
            for input in self.document.within(object).filter(|id| self.document.name(*id) == "connectionPointIn") {
                for wire in self.document.children(input, "connection") {
                    let from = self.document.attribute(wire, "refLocalId").and_then(|number| objects.get(number));
                    let from = *from.ok_or("a wire comes from nothing")?;
                    let points: Option<Vec<_>> =
                        self.document.children(wire, "position").map(|id| self.point(id)).collect();
                    let points = points.ok_or("a point of a wire has no place")?;
                    if points.first().copied() != self.pin(object, input) {
                        return Err(format!("{points:?} begins at no pin"));
                    }
                    if !self
                        .document
                        .within(from)
                        .any(|id| self.is_output(id) && self.pin(from, id) == points.last().copied())
                    {
                        return Err(format!("{points:?} ends at no pin"));
                    }
                    for pair in points.windows(2) {
                        let (to, from) = (pair[0], pair[1]);
                        if to.0 != from.0 && to.1 != from.1 {
                            return Err(format!("{points:?} does not run square"));
                        }
                        let against = match flow {
                            Flow::Right => to.0 < from.0,
                            Flow::Down => to.1 < from.1,
                        };
                        if against {
                            return Err(format!("{points:?} runs against the flow"));
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn is_output(&self, id: Id) -> bool {
        ["connectionPointOut", "connectionPointOutAction"].contains(&self.document.name(id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A contact at 20,20 and a coil at 60,20, with a wire between them.
    const RUNG: &str = "<LD>\
        <contact localId=\"1\" width=\"20\" height=\"10\"><position x=\"20\" y=\"20\"/>\
        <connectionPointOut><relPosition x=\"20\" y=\"5\"/></connectionPointOut></contact>\
        <coil localId=\"2\" width=\"20\" height=\"10\"><position x=\"60\" y=\"20\"/>\
        <connectionPointIn><relPosition x=\"0\" y=\"5\"/><connection refLocalId=\"1\">\
        <position x=\"60\" y=\"25\"/><position x=\"40\" y=\"25\"/></connection></connectionPointIn></coil></LD>";

    fn said(right: &str, wrong: &str, flow: Flow) -> [Result<(), String>; 2] {
        assert!(RUNG.contains(right), "{right}");
        let document = Document::read(&RUNG.replacen(right, wrong, 1)).expect("XML");
        let sheet = Sheet::of(&document, "LD").expect("a ladder");
        [sheet.stands_clear(), sheet.is_wired(flow)]
    }

    #[test]
    fn what_is_right_is_taken() {
        assert_eq!(said("LD", "LD", Flow::Right), [Ok(()), Ok(())]);
        assert_eq!(said("LD", "LD", Flow::Down), [Ok(()), Ok(())], "a level wire goes down, too");
    }

    #[test]
    fn what_is_wrong_is_said() {
        let stands = |right: &str, wrong: &str| said(right, wrong, Flow::Right)[0].clone().expect_err(wrong);
        assert_eq!(stands("x=\"20\" y=\"20\"", "x=\"-1\" y=\"20\""), "[-1, 20, 19, 30] is off the sheet");
        assert_eq!(stands("width=\"20\"", "width=\"40\""), "[20, 20, 60, 30] and [60, 20, 80, 30] touch");
        assert_eq!(stands("height=\"10\"", ""), "an object has no place or no size");
        let wired = |right: &str, wrong: &str| said(right, wrong, Flow::Right)[1].clone().expect_err(wrong);
        assert_eq!(wired("refLocalId=\"1\"", "refLocalId=\"3\""), "a wire comes from nothing");
        assert_eq!(wired("x=\"60\" y=\"25\"", "x=\"60\" y=\"26\""), "[(60, 26), (40, 25)] begins at no pin");
        assert_eq!(wired("x=\"40\" y=\"25\"", "x=\"41\" y=\"25\""), "[(60, 25), (41, 25)] ends at no pin");
        assert_eq!(wired("x=\"0\" y=\"5\"/>", "x=\"0\" y=\"6\"/>"), "[(60, 25), (40, 25)] begins at no pin");
        let right = "<position x=\"40\" y=\"25\"/>";
        let through = |x, y| wired(right, &format!("<position x=\"{x}\" y=\"{y}\"/>{right}"));
        assert_eq!(through(50, 30), "[(60, 25), (50, 30), (40, 25)] does not run square");
        assert_eq!(through(30, 25), "[(60, 25), (30, 25), (40, 25)] runs against the flow");
    }

    /// The coil below the contact, and above it.
    #[test]
    fn down_is_not_up() {
        for (y, expected) in [(40, Ok(())), (0, Err("[(60, 5), (60, 25), (40, 25)] runs against the flow".to_string()))]
        {
            let pin = format!("x=\"60\" y=\"{}\"/>", y + 5);
            let text = RUNG.replace("x=\"60\" y=\"20\"", &format!("x=\"60\" y=\"{y}\""));
            let text = text.replace("x=\"60\" y=\"25\"/>", &format!("{pin}<position x=\"60\" y=\"25\"/>"));
            let document = Document::read(&text).expect("XML");
            let sheet = Sheet::of(&document, "LD").expect("a ladder");
            assert_eq!(sheet.is_wired(Flow::Down), expected);
            assert_eq!(sheet.is_wired(Flow::Right), Ok(()));
        }
    }
}
