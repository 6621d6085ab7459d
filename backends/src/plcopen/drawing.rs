//! What drawings share: objects with a place and a size, pins, wires.

use crate::xml::Xml;

/// A point of the sheet; `y` grows downwards.
pub(super) type Point = (i64, i64);

/// Opens an object.
pub(super) fn open(xml: &mut Xml, name: &'static str, id: usize, size: Point, more: &[(&str, &str)]) {
    let (id, width, height) = (id.to_string(), size.0.to_string(), size.1.to_string());
    let mut attributes = vec![("localId", id.as_str())];
    attributes.extend(more);
    attributes.extend([("width", width.as_str()), ("height", height.as_str())]);
    xml.open(name, &attributes);
}

fn point(xml: &mut Xml, name: &'static str, at: Point) {
    xml.empty(name, &[("x", &at.0.to_string()), ("y", &at.1.to_string())]);
}

/// The corner of an object, or a point of a wire.
pub(super) fn position(xml: &mut Xml, at: Point) {
    point(xml, "position", at);
}

/// The place of a pin in its object.
pub(super) fn relative(xml: &mut Xml, at: Point, corner: Point) {
    point(xml, "relPosition", (at.0 - corner.0, at.1 - corner.1));
}

/// An output at a place in its object.
pub(super) fn output(xml: &mut Xml, name: &'static str, pin: Option<&str>, at: Point) {
    match pin {
        Some(pin) => xml.open(name, &[("formalParameter", pin)]),
        None => xml.open(name, &[]),
    }
    point(xml, "relPosition", at);
    xml.close();
}

/// A wire from an object, or from a pin of it; its points are stored from where it ends to where it comes from.
pub(super) fn connection(xml: &mut Xml, from: usize, pin: Option<&str>, points: &[Point]) {
    let id = from.to_string();
    let mut attributes = vec![("refLocalId", id.as_str())];
    attributes.extend(pin.map(|pin| ("formalParameter", pin)));
    xml.open("connection", &attributes);
    for at in points.iter().rev() {
        position(xml, *at);
    }
    xml.close();
}
