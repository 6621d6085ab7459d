//! The targets, in one list.
//!
//! A target is a folder with a file `target.rs`, which holds what this list asks of it: `NAME`, `TITLE`, `EXTENSION`,
//! `BESIDE`, `MAPPED` and `CHOICES`; `options` makes its options of what was chosen, `spelled` says them as a command line would, and `emit`
//! writes.

use crate::choice::{Choice, Chosen, Refusal};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Observed;

/// What is known of a target before anything is chosen.
#[derive(Debug)]
pub struct About {
    /// The name, as the command line has it.
    pub name: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// What the name of a file ends with, without the dot.
    pub extension: &'static str,
    /// If it writes a second file: by what the name of its file ends with, what that of the other one beside it ends with;
    /// the first is what is usual.
    pub beside: &'static [(&'static str, &'static str)],
    /// Whether it can say which lines come from which element of the chart.
    pub mapped: bool,
    /// What it leaves to choose.
    pub choices: &'static [&'static Choice],
    make: fn(&Chosen) -> Result<Target, Refusal>,
}

impl About {
    /// What the name of a file of its may end with, what is usual first.
    pub fn endings(&self) -> impl Iterator<Item = &'static str> {
        let others = self.beside.iter().map(|(own, _)| *own).filter(|own| *own != self.extension);
        std::iter::once(self.extension).chain(others)
    }

    /// Whether the name of a file of its ends with this, in whatever case.
    pub fn has_ending(&self, ending: &str) -> bool {
        self.endings().any(|own| own.eq_ignore_ascii_case(ending))
    }

    /// What the name of the second file ends with, beside one that ends with this; none if there is no second file.
    pub fn ending_beside(&self, ending: &str) -> Option<&'static str> {
        let of = self.beside.iter().find(|(own, _)| own.eq_ignore_ascii_case(ending)).or(self.beside.first());
        of.map(|(_, beside)| *beside)
    }

    /// The target with what was chosen. Choices that it does not know are of no effect.
    ///
    /// # Errors
    /// Values that do not go together.
    pub fn target(&self, chosen: &Chosen) -> Result<Target, Refusal> {
        (self.make)(chosen)
    }
}

macro_rules! targets {
    ($($(#[$doc:meta])* $Target:ident => $folder:ident,)*) => {
        /// A target, with what its language alone leaves to choose.
        #[derive(Clone, PartialEq, Eq, Debug)]
        pub enum Target {
            $($(#[$doc])* $Target(crate::$folder::Options),)*
        }

        impl Target {
            /// What is known of all targets.
            pub const ALL: &'static [About] = &[$(About {
                name: crate::$folder::target::NAME,
                title: crate::$folder::target::TITLE,
                extension: crate::$folder::target::EXTENSION,
                beside: crate::$folder::target::BESIDE,
                mapped: crate::$folder::target::MAPPED,
                choices: crate::$folder::target::CHOICES,
                make: |chosen| crate::$folder::target::options(chosen).map(Target::$Target),
            },)*];

            /// What is known of this one.
            pub fn about(&self) -> &'static About {
                let name = match self {
                    $(Target::$Target(_) => crate::$folder::target::NAME,)*
                };
                // Both are made of one list.
                Target::ALL.iter().find(|about| about.name == name).unwrap_or(&Target::ALL[0])
            }

            /// The target and what was chosen, as a command line would say it; what is usual is said, too.
            pub fn spelled(&self) -> (&'static str, String) {
                match self {
                    $(Target::$Target(options) =>
                        (crate::$folder::target::NAME, crate::$folder::target::spelled(options)),)*
                }
            }

            /// Puts lines at the head of what is written, as a comment.
            pub fn set_header(&mut self, lines: Vec<String>) {
                match self {
                    $(Target::$Target(options) => options.header = lines,)*
                }
            }

            /// Adds a line to the head of what is written, if it has one.
            pub fn add_to_header(&mut self, line: String) {
                let header = match self {
                    $(Target::$Target(options) => &mut options.header,)*
                };
                if !header.is_empty() {
                    header.push(line);
                }
            }

            /// Writes.
            ///
            /// # Errors
            /// What the stages before said, if that is an error; what the target cannot do; or a fault of grafc.
            pub fn emit(&self, source: &mut dyn Source) -> Result<Output, Diagnostics> {
                match self {
                    $(Target::$Target(options) => crate::$folder::target::emit(source, options),)*
                }
            }
        }
    };
}

impl Target {
    /// Whether it writes the statements of a scan program, and not a sequential function chart.
    pub fn writes_statements(&self) -> bool {
        match self {
            Target::Sfc(_) => false,
            Target::Plcopen(options) => options.body != crate::plcopen::Body::Sfc,
            Target::St(_)
            | Target::Il(_)
            | Target::Awl(_)
            | Target::Scl(_)
            | Target::Tcpou(_)
            | Target::Iec61131_10(_)
            | Target::Rust(_)
            | Target::Js(_)
            | Target::C(_) => true,
        }
    }

    /// Whether its code saves the memory of a chart and gives it back.
    pub fn saves_memory(&self) -> bool {
        match self {
            Target::Rust(_) | Target::Js(_) | Target::C(_) => true,
            Target::St(_)
            | Target::Il(_)
            | Target::Sfc(_)
            | Target::Awl(_)
            | Target::Plcopen(_)
            | Target::Scl(_)
            | Target::Tcpou(_)
            | Target::Iec61131_10(_) => false,
        }
    }

    /// What the name of its file ends with, without the dot.
    pub fn extension(&self) -> &'static str {
        match self {
            Target::C(crate::c::Options { files: crate::c::Files::Sketch(_), .. }) => "ino",
            Target::C(_)
            | Target::St(_)
            | Target::Il(_)
            | Target::Sfc(_)
            | Target::Awl(_)
            | Target::Plcopen(_)
            | Target::Scl(_)
            | Target::Tcpou(_)
            | Target::Iec61131_10(_)
            | Target::Rust(_)
            | Target::Js(_) => self.about().extension,
        }
    }

    /// What the name of the second file ends with, beside one that ends with this; none if there is no second file.
    pub fn ending_beside(&self, ending: &str) -> Option<&'static str> {
        match self {
            Target::C(options) if options.files != crate::c::Files::Two => None,
            Target::C(_)
            | Target::St(_)
            | Target::Il(_)
            | Target::Sfc(_)
            | Target::Awl(_)
            | Target::Plcopen(_)
            | Target::Scl(_)
            | Target::Tcpou(_)
            | Target::Iec61131_10(_)
            | Target::Rust(_)
            | Target::Js(_) => self.about().ending_beside(ending),
        }
    }

    /// Tells a target what the file beside its own is called, which its code may have to name.
    pub fn set_beside(&mut self, name: &str) {
        match self {
            Target::C(options) => options.include = Some(name.to_owned()),
            Target::St(_)
            | Target::Il(_)
            | Target::Sfc(_)
            | Target::Awl(_)
            | Target::Plcopen(_)
            | Target::Scl(_)
            | Target::Tcpou(_)
            | Target::Iec61131_10(_)
            | Target::Rust(_)
            | Target::Js(_) => {}
        }
    }

    /// How much of its micro-steps its code shows.
    pub fn shows(&self) -> Observed {
        match self {
            Target::Js(options) => options.shown(),
            Target::Rust(_)
            | Target::C(_)
            | Target::St(_)
            | Target::Il(_)
            | Target::Sfc(_)
            | Target::Awl(_)
            | Target::Plcopen(_)
            | Target::Scl(_)
            | Target::Tcpou(_)
            | Target::Iec61131_10(_) => Observed::Nothing,
        }
    }
}

targets! {
    /// IEC 61131-3 Structured Text.
    St => st,
    /// IEC 61131-3 instruction list.
    Il => il,
    /// An IEC 61131-3 sequential function chart in text.
    Sfc => sfc,
    /// Siemens STL.
    Awl => awl,
    /// A PLCopen XML project.
    Plcopen => plcopen,
    /// Siemens SCL.
    Scl => scl,
    /// A TwinCAT program organisation unit.
    Tcpou => tcpou,
    /// The exchange format of IEC 61131-10.
    Iec61131_10 => iec61131_10,
    /// Rust.
    Rust => rust,
    /// JavaScript.
    Js => js,
    /// C.
    C => c,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::choice::{Value, Values};

    #[test]
    fn every_target_is_itself_and_has_a_name_of_its_own() {
        for (place, about) in Target::ALL.iter().enumerate() {
            let target = about.target(&Chosen::new()).expect("what is usual goes together");
            assert_eq!((target.about().name, target.spelled().0), (about.name, about.name));
            assert!(Target::ALL[..place].iter().all(|other| other.name != about.name), "{}", about.name);
        }
    }

    #[test]
    fn what_is_usual_can_be_chosen_and_changes_nothing() {
        for about in Target::ALL {
            let usual = about.target(&Chosen::new());
            for choice in about.choices {
                if let Values::Names(names) = choice.values {
                    assert!(names().iter().any(|(name, _)| *name == choice.default), "{}", choice.name);
                    let chosen = Chosen::new().with(choice, Value::Name(choice.default.to_owned()));
                    assert_eq!(about.target(&chosen), usual, "--{} {}", choice.name, choice.default);
                }
            }
        }
    }
}
