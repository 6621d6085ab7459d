//! The stable codes of all messages.
//!
//! Ranges: 01 lexing and parsing, 02 names and types, 03 structure, 04 meaning, 05 limits of a target or an encoding,
//! 06 traces, 07 charts of other tools, 09 faults of grafc itself. A code is never used again for something else. Each has a page in
//! `docs/errors/`, which `grafc explain CODE` prints.

/// How bad it is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Severity {
    /// No output is made.
    Error,
    /// Output is made, but the chart may not mean what its author thinks.
    Warning,
}

macro_rules! codes {
    ($($code:ident $slug:literal $severity:ident;)*) => {
        /// A stable code of a message.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Code {
            $(#[doc = $slug] $code,)*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$code,)*];

            /// The code as it is printed: `E0201`.
            pub fn as_str(self) -> &'static str {
                match self { $(Code::$code => stringify!($code),)* }
            }

            /// A name for the fault: `unknown-name`.
            pub fn slug(self) -> &'static str {
                match self { $(Code::$code => $slug,)* }
            }

            /// Whether it stops the compilation.
            pub fn severity(self) -> Severity {
                match self { $(Code::$code => Severity::$severity,)* }
            }

            /// The code of this spelling, in any case.
            pub fn parse(text: &str) -> Option<Code> {
                Code::ALL.iter().copied().find(|c| c.as_str().eq_ignore_ascii_case(text))
            }

            /// The code of this spelling or of this name, in any case.
            pub fn find(asked: &str) -> Option<Code> {
                let by_name = || Code::ALL.iter().copied().find(|code| code.slug().eq_ignore_ascii_case(asked));
                Code::parse(asked).or_else(by_name)
            }

            /// The page on it, in Markdown.
            pub fn page(self) -> &'static str {
                match self { $(Code::$code => include_str!(concat!("../../../docs/errors/", stringify!($code), ".md")),)* }
            }
        }
    };
}

codes! {
    E0101 "unexpected-character" Error;
    E0102 "unterminated-comment" Error;
    E0103 "unterminated-string" Error;
    E0104 "malformed-name" Error;
    E0105 "malformed-number" Error;
    E0106 "malformed-duration" Error;
    E0107 "unexpected-token" Error;
    E0108 "assignment-without-event" Error;
    E0109 "text-too-long" Error;
    E0110 "not-utf8" Error;

    E0201 "unknown-name" Error;
    E0202 "declared-twice" Error;
    E0203 "names-differ-by-case" Error;
    E0204 "implicit-name-taken" Error;
    E0205 "type-mismatch" Error;
    E0206 "not-a-condition" Error;
    E0207 "not-assignable" Error;
    E0208 "not-a-constant" Error;
    E0209 "not-a-delay" Error;
    E0210 "out-of-range" Error;
    E0211 "constant-without-value" Error;
    E0212 "malformed-address" Error;
    E0213 "address-taken" Error;
    E0214 "nothing-to-retain" Error;
    E0215 "not-a-warning" Error;
    E0216 "control-input-declared" Error;
    E0217 "chosen-otherwise" Error;

    E0301 "unknown-step" Error;
    E0302 "unknown-grafcet" Error;
    E0303 "step-named-twice" Error;
    E0304 "transition-without-steps" Error;
    E0305 "arc-crosses-frame" Error;
    E0306 "macro-step-expansion" Error;
    E0307 "action-on-macro-step" Error;
    E0308 "initial-step-in-inactive-enclosure" Error;
    E0309 "initial-enclosure-without-initial-step" Error;
    E0310 "enclosure-without-activation-link" Error;
    E0311 "enclosure-of-two-steps" Error;
    E0312 "grafcet-never-activated" Error;
    E0313 "cyclic-hierarchy" Error;
    E0314 "forces-its-own-grafcet" Error;
    E0315 "forced-step-outside-grafcet" Error;
    E0316 "forced-macro-step" Error;
    E0317 "steps-outside-grafcets" Error;
    E0318 "not-an-enclosing-step" Error;
    E0319 "activation-link-outside-enclosure" Error;
    E0320 "enclosing-step-without-enclosure" Error;
    E0321 "chart-without-steps" Error;
    E0322 "commander-not-the-parent" Error;
    E0323 "beyond-automaton" Error;
    E0324 "arc-output-without-evolution" Error;

    E0411 "cyclic-continuous-actions" Error;
    E0412 "assigned-and-allocated" Error;
    E0413 "edge-inside-edge" Error;
    E0414 "edge-in-continuous-action" Error;
    E0415 "edge-in-delay" Error;
    E0416 "edge-or-delay-in-claim" Error;
    E0417 "assumption-beyond-inputs" Error;
    E0418 "claim-without-step" Error;
    E0419 "each-scan-under-stable" Error;

    W0401 "output-read" Warning;
    W0402 "level-event" Warning;
    W0403 "negated-edge" Warning;
    W0404 "enclosure-may-be-empty" Warning;
    W0405 "self-loop-with-events" Warning;
    W0406 "source-transition-on-level" Warning;
    W0407 "always-true-cycle" Warning;
    W0408 "transient-step-with-continuous-action" Warning;
    W0409 "non-exclusive-divergence" Warning;
    W0410 "counter-race" Warning;
    W0411 "orders-not-exclusive" Warning;
    W0412 "allocation-conflict" Warning;
    W0413 "visible-overlap" Warning;
    W0414 "step-never-active" Warning;
    W0415 "transition-never-cleared" Warning;
    W0416 "dead-end" Warning;
    W0417 "constant-condition" Warning;
    W0418 "step-entered-while-active" Warning;
    W0419 "never-read" Warning;
    W0420 "never-set" Warning;
    W0421 "same-transition-twice" Warning;
    W0422 "off-delay-of-active-step" Warning;
    W0423 "negated-off-delay" Warning;
    W0424 "ring-of-inputs" Warning;
    W0425 "allowance-without-effect" Warning;
    W0426 "deceptive-name" Warning;
    W0427 "child-never-started" Warning;
    W0428 "restart-leaves-dead" Warning;

    E0503 "not-a-sequential-function-chart" Error;
    E0504 "no-double-precision" Error;
    E0505 "time-too-long-for-target" Error;
    E0506 "block-too-long" Error;
    E0507 "no-pin" Error;

    E0601 "malformed-trace" Error;
    E0602 "unknown-trace-column" Error;
    E0603 "bad-trace-value" Error;
    E0604 "trace-goes-back-in-time" Error;
    E0605 "recording-differs" Error;
    E0606 "too-many-calls" Error;
    E0607 "expectation-not-met" Error;
    E0608 "test-without-chart" Error;
    E0609 "assertion-false" Error;
    E0610 "faulty-scenario" Error;
    E0611 "until-not-reached" Error;
    W0601 "delay-ends-between-rows" Warning;
    W0602 "assumption-broken" Warning;

    E0701 "malformed-xml" Error;
    E0702 "xml-beyond-bounds" Error;
    E0703 "unknown-chart-format" Error;
    E0704 "broken-reference" Error;
    E0705 "malformed-element" Error;
    E0706 "several-charts" Error;
    E0707 "malformed-kiss2" Error;
    W0701 "import-changed" Warning;
    W0702 "import-doubtful" Warning;
    W0703 "import-lost" Warning;

    E0901 "internal-error" Error;
}

impl Code {
    /// Whether the fault is there for certain even if other parts of the text could not be read.
    ///
    /// What is unknown, missing or never activated may stand in an unreadable part; a name given twice, a type that does
    /// not fit or an edge inside an edge is wrong whatever stands there.
    pub fn is_certain_beside_syntax_errors(self) -> bool {
        use Code::*;
        matches!(
            self,
            E0202
                | E0203
                | E0204
                | E0205
                | E0206
                | E0207
                | E0210
                | E0211
                | E0212
                | E0213
                | E0214
                | E0215
                | E0217
                | E0303
                | E0307
                | E0314
                | E0413
                | E0414
                | E0415
                | E0416
                | E0417
                | E0418
        )
    }
}
