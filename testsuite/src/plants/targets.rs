//! A chart in every target and every encoding, and the compilers that take the text unchanged.

use super::Plant;
use crate::executors::{ironplc, matiec, strucpp};
use grafc::Product;
use grafc_backends::{Target, awl, c, iec61131_10, il, js, plcopen, rust, scl, st, tcpou};
use grafc_diagnostics::{Code, FileId};
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::Profile;

/// The compilers that are asked; none by default.
#[derive(Default)]
pub struct Compilers {
    matiec: Option<matiec::Tools>,
    ironplc: Option<ironplc::Tools>,
    strucpp: Option<strucpp::Tools>,
}

impl Compilers {
    /// Those that are here, and what the others lack.
    pub fn find() -> (Self, Vec<String>) {
        let mut missing = Vec::new();
        let compilers = Compilers {
            matiec: matiec::Tools::find().map_err(|said| missing.push(said)).ok(),
            ironplc: ironplc::Tools::find().map_err(|said| missing.push(said)).ok(),
            strucpp: strucpp::Tools::find().map_err(|said| missing.push(said)).ok(),
        };
        (compilers, missing)
    }

    /// Those that are here; a line says of each other what it lacks.
    ///
    /// # Panics
    /// If one is missing that is required.
    pub fn find_or_skip() -> Self {
        Compilers {
            matiec: matiec::Tools::find_or_skip(),
            ironplc: ironplc::Tools::find_or_skip(),
            strucpp: strucpp::Tools::find_or_skip(),
        }
    }
}

/// What came of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Written {
    /// So many texts were written.
    pub texts: usize,
    /// So many were given to a compiler, which took them.
    pub taken: usize,
    /// So many drawings as a sequential function chart were refused, because it would mean something else (E0503).
    pub undrawn: usize,
}

/// Writes a chart for every target in every encoding, which these compilers then read; an error is what grafc or a compiler
/// said.
pub fn targets<'c>(plant: &Plant, compilers: impl Fn(Encoding) -> &'c Compilers) -> Result<Written, String> {
    let mut written = Written::default();
    for encoding in Encoding::ALL {
        for product in products() {
            let lowering = Options { profile: Profile::default(), encoding, simplify: true };
            let options = grafc::Options::new(lowering, product);
            let (made, diagnostics) = grafc::compile(FileId::default(), &plant.text, &plant.name, &options);
            let Some(made) = made else {
                if is_drawing(&options.product) && diagnostics.iter().any(|message| message.code == Code::E0503) {
                    written.undrawn += 1;
                    continue;
                }
                return Err(format!("{:?}, {}: {diagnostics:#?}", options.product, encoding.name()));
            };
            written.texts += 1;
            for (compiler, taken) in taken(compilers(encoding), &options.product, &made.text) {
                taken.map_err(|said| format!("{compiler}, {}: {said}", encoding.name()))?;
                written.taken += 1;
            }
        }
    }
    Ok(written)
}

/// So many texts a chart has in one encoding: a target with each dialect and body that it knows.
pub const PRODUCTS: usize = 14;

fn products() -> [Product; PRODUCTS] {
    let plcopen = |dialect, body| {
        Product::Code(Target::Plcopen(plcopen::Options { dialect, body, ..plcopen::Options::default() }))
    };
    [
        Product::Code(Target::St(st::Options::default())),
        Product::Code(Target::Il(il::Options::default())),
        plcopen(plcopen::Dialect::Neutral, plcopen::Body::St),
        plcopen(plcopen::Dialect::Codesys, plcopen::Body::St),
        plcopen(plcopen::Dialect::Neutral, plcopen::Body::Il),
        plcopen(plcopen::Dialect::Neutral, plcopen::Body::Ld),
        plcopen(plcopen::Dialect::Neutral, plcopen::Body::Sfc),
        Product::Code(Target::Scl(scl::Options::default())),
        Product::Code(Target::Tcpou(tcpou::Options::default())),
        Product::Code(Target::Iec61131_10(iec61131_10::Options::default())),
        Product::Code(Target::Awl(awl::Options::default())),
        Product::Code(Target::Rust(rust::Options::default())),
        Product::Code(Target::Js(js::Options::default())),
        Product::Code(Target::C(c::Options::default())),
    ]
}

fn is_drawing(product: &Product) -> bool {
    matches!(product, Product::Code(Target::Plcopen(options)) if options.body == plcopen::Body::Sfc)
}

/// What the compilers say that read the language.
fn taken(compilers: &Compilers, product: &Product, text: &str) -> Vec<(&'static str, Result<(), String>)> {
    let mut said = Vec::new();
    if matches!(product, Product::Code(Target::St(_) | Target::Il(_))) {
        said.extend(compilers.matiec.iter().map(|tools| ("MATIEC", matiec::accepts(tools, text))));
    }
    if matches!(product, Product::Code(Target::St(_))) {
        said.extend(compilers.ironplc.iter().map(|tools| ("IronPLC", ironplc::accepts(tools, text))));
        said.extend(compilers.strucpp.iter().map(|tools| ("STruC++", strucpp::accepts(tools, text))));
    }
    said
}
