//! TwinCAT 3: a `.TcPOU` file with the function block, to be added to a PLC project as an existing item.
//!
//! Declaration and implementation are plain Structured Text, without the closing keyword. The identity that the format
//! asks for comes from the name of the block, so the same chart always gives the same file.

pub(crate) mod target;

use crate::comment::clean;
use crate::iec::declarations;
use crate::st::{self, Style};
use crate::writer::{self, Writer};
use crate::xml::Xml;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Program;
use uuid::Uuid;

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// Which chart, which version, which options.
    pub header: Vec<String>,
}

/// What TwinCAT keeps on every controller. `RETAIN` needs a device for it.
const PERSISTENT: &str = "PERSISTENT";

/// Writes a program as one program organisation unit.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    let parts = st::parts(program, Style::default())?;
    let mut declaration = Writer::new(&writer::IEC);
    declaration.block_comment(options.header.iter().map(|line| clean(line)));
    declaration.comment(parts.description.as_deref().unwrap_or_default());
    declaration.line(&format!("FUNCTION_BLOCK {}", parts.block));
    let interface = declarations::with_temporaries(parts.interface);
    declarations::write(&mut declaration, interface, PERSISTENT);

    let id = format!("{{{}}}", Uuid::new_v5(&Uuid::NAMESPACE_URL, format!("grafc:{}", parts.block).as_bytes()));
    let mut xml = Xml::new();
    xml.open("TcPlcObject", &[("Version", "1.1.0.1"), ("ProductVersion", "3.1.4024.12")]);
    xml.open("POU", &[("Name", &parts.block), ("Id", &id), ("SpecialFunc", "None")]);
    xml.cdata("Declaration", &[], &declaration.finish());
    xml.open("Implementation", &[]);
    xml.cdata("ST", &[], &parts.body);
    Ok(xml.finish())
}
