//! Texts that come as bytes.

use grafc_diagnostics::{Code, Diagnostic, FileId, SourceMap, Span};

/// Adds a text. The error is that of a text which is not UTF-8, at its first bad byte.
pub fn add(sources: &mut SourceMap, name: impl Into<String>, bytes: Vec<u8>) -> Result<FileId, Diagnostic> {
    let error = match String::from_utf8(bytes) {
        Ok(text) => return Ok(sources.add(name, text)),
        Err(error) => error,
    };
    let at = error.utf8_error().valid_up_to();
    let byte = error.as_bytes()[at];
    // Up to the first bad byte, offsets in the text shown are those of the file.
    let file = sources.add(name, String::from_utf8_lossy(error.as_bytes()));
    let span = Span::new(file, at, at + char::REPLACEMENT_CHARACTER.len_utf8());
    Err(Diagnostic::new(Code::E0110, span, format!("byte 0x{byte:02X} at offset {at} is not UTF-8"))
        .help("save the file as UTF-8"))
}
