//! PDF: all sheets in one file, each a page of its size.

use super::scene;
use grafc::drawing::Picture;
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, TextStr};
use std::collections::BTreeMap;
use svg2pdf::ConversionOptions;

/// Points of PDF in a unit of SVG, of which there are 96 in an inch.
const POINTS: f32 = 0.75;
/// A side of a page is no longer than this, by the standard of PDF.
const LONGEST: f32 = 14400.0;

/// The document.
pub fn pdf(svgs: impl Iterator<Item = String>, pictures: &[Picture]) -> Result<Vec<u8>, String> {
    let fault = |error: &dyn std::fmt::Display| format!("the drawing cannot be converted: {error}");
    let mut pdf = Pdf::new();
    let mut next = Ref::new(1);
    let (catalog, pages, information) = (next.bump(), next.bump(), next.bump());
    let mut kids = Vec::new();
    for svg in svgs {
        let tree = scene::tree(&svg)?;
        let (chunk, drawing) = svg2pdf::to_chunk(&tree, ConversionOptions::default()).map_err(|e| fault(&e))?;
        let mut moved = BTreeMap::new();
        chunk.renumber_into(&mut pdf, |old| *moved.entry(old).or_insert_with(|| next.bump()));
        let drawing = *moved.get(&drawing).ok_or_else(|| fault(&"its page is missing"))?;
        let (wide, high) = (tree.size().width() * POINTS, tree.size().height() * POINTS);
        if wide > LONGEST || high > LONGEST {
            return Err(format!(
                "the drawing of {wide} by {high} points is too large for a page of PDF, which has sides of {LONGEST} points at most"
            ));
        }
        let (page, content) = (next.bump(), next.bump());
        let mut made = pdf.page(page);
        made.media_box(Rect::new(0.0, 0.0, wide, high)).parent(pages).contents(content);
        made.resources().x_objects().pair(Name(b"D"), drawing);
        made.finish();
        let mut stream = Content::new();
        stream.transform([wide, 0.0, 0.0, high, 0.0, 0.0]).x_object(Name(b"D"));
        pdf.stream(content, &stream.finish());
        kids.push(page);
    }
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).count(kids.len() as i32).kids(kids);
    let title = pictures.first().map(|picture| picture.title.as_str()).unwrap_or_default();
    pdf.document_info(information).title(TextStr(title)).producer(TextStr("grafc"));
    Ok(pdf.finish())
}
