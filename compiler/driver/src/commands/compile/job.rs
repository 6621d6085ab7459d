//! A chart, what is made of it, and where that goes: all of it or nothing.

use crate::map::{self, Made};
use crate::stream::Stream;
use grafc::files::{self, Refusal};
use grafc::{Output, Product};
use grafc_diagnostics::SourceMap;
use grafc_logic::Encoding;
use std::path::PathBuf;

/// A chart, what is made of it, and where that goes.
pub struct Job<'a> {
    /// The chart.
    pub chart: &'a Stream,
    /// What is made of it.
    pub product: Product,
    /// Where that goes.
    pub output: Stream,
    /// Where what the target writes beside it goes, if it writes two files.
    pub beside: Option<Stream>,
    /// Where the map goes, if one is asked for.
    pub map: Option<Stream>,
    /// Folders that are made if they are not there.
    pub folders: Vec<PathBuf>,
}

impl Job<'_> {
    /// Puts the text, what stands beside it and its map into their places: all or none.
    pub fn write(&self, made: &Output, encoding: Encoding, sources: &SourceMap) -> Result<(), Refusal> {
        for folder in &self.folders {
            files::make_folder(folder)?;
        }
        let map = self.map.as_ref().zip(made.map.as_ref()).map(|(stream, map)| {
            let chart = self.chart.file_name();
            let output = Some(&self.output).filter(|output| **output != Stream::Standard).map(Stream::file_name);
            let target = self.target_name();
            let about = Made { chart: &chart, output: output.as_deref(), target, encoding: encoding.name() };
            (stream, map::json(map, &about, sources))
        });
        let mut texts = vec![(&self.output, made.text.as_str())];
        texts.extend(self.beside.as_ref().zip(made.beside.as_deref()));
        texts.extend(map.as_ref().map(|(stream, text)| (*stream, text.as_str())));
        Stream::write_all(&texts)
    }

    /// The target; only code has one.
    fn target_name(&self) -> &'static str {
        match &self.product {
            Product::Code(target) | Product::Mapped(target) => target.about().name,
            Product::Tree
            | Product::Chart
            | Product::NetAfter(_)
            | Product::Net
            | Product::Equations
            | Product::Program => "",
        }
    }
}
