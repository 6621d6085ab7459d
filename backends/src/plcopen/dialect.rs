//! What differs between the readers of PLCopen XML.

use crate::iec::literals::time;
use crate::xml::Xml;
use ecow::{EcoString, eco_format};

/// Which tools read it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Dialect {
    /// Beremiz and the editors that come from it. They take only the newer namespace, and texts only in an element that
    /// is literally called `xhtml:p`; a project without a configuration does not run there.
    #[default]
    Neutral,
    /// CODESYS, TwinCAT and tools based on CODESYS. They write the older namespace themselves, and some take no other;
    /// tasks are theirs to define, so there is none unless an interval is asked for.
    Codesys,
}

impl Dialect {
    /// The namespace of the root.
    pub(super) fn namespace(self) -> &'static str {
        match self {
            Dialect::Neutral => "http://www.plcopen.org/xml/tc6_0201",
            Dialect::Codesys => "http://www.plcopen.org/xml/tc6_0200",
        }
    }

    /// The interval of the task, if there is a task.
    pub(super) fn interval(self, wanted_ms: Option<u32>) -> Option<u32> {
        match self {
            Dialect::Neutral => Some(wanted_ms.unwrap_or(20)),
            Dialect::Codesys => wanted_ms,
        }
    }

    /// An interval as the readers take it: a literal of IEC 61131-3, or a duration of ISO 8601.
    pub(super) fn duration(self, ms: u32) -> EcoString {
        match self {
            Dialect::Neutral => time(i64::from(ms)),
            Dialect::Codesys => eco_format!("PT{}.{:03}S", ms / 1000, ms % 1000),
        }
    }

    /// A formatted text within the open element. No blank may stand between `xhtml:p` and what it holds.
    pub(super) fn formatted(self, xml: &mut Xml, text: &str) {
        match self {
            Dialect::Neutral => xml.cdata("xhtml:p", &[], text),
            Dialect::Codesys => xml.text("xhtml", &[("xmlns", XHTML)], text),
        }
    }

    /// An element with a formatted text.
    pub(super) fn documentation(self, xml: &mut Xml, text: &str) {
        xml.open("documentation", &[]);
        self.formatted(xml, text);
        xml.close();
    }

    /// A body in a textual language.
    pub(super) fn body(self, xml: &mut Xml, language: &'static str, text: &str) {
        xml.open(language, &[]);
        self.formatted(xml, text);
        xml.close();
    }
}

/// The namespace of formatted texts.
pub(super) const XHTML: &str = "http://www.w3.org/1999/xhtml";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations() {
        for (ms, neutral, codesys) in [(20, "T#20ms", "PT0.020S"), (1500, "T#1500ms", "PT1.500S")] {
            assert_eq!(Dialect::Neutral.duration(ms), neutral);
            assert_eq!(Dialect::Codesys.duration(ms), codesys);
        }
    }
}
