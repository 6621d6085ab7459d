//! What MATIEC refuses beyond reserved words, and Beremiz with it.
//!
//! With `-p`, as Beremiz calls it, MATIEC first looks through the whole text for the names of program organisation units,
//! and passes over what is in them sign by sign: a name that has `END_PROGRAM` within it ends the unit there. Where it
//! looks whether a body is an instruction list, it does the same. And it then knows the names of all units when it
//! reads its own library, in which a parameter of the same name is no name any more.

/// What ends a unit or a body behind `END_`, wherever it stands.
pub const ENDS: [&str; 5] = ["ACTION", "CONFIGURATION", "FUNCTION", "PROGRAM", "TRANSITION"];

/// Parameters and variables of the functions and function blocks in its library, in upper case; those of the standard
/// ones as well, since every body of theirs is read.
pub const PINS: &str = "
    AUTO BUSY CD CDT CD_T CLAIM CLK CU CURRENT_TIME CU_T CV CYCLE DTERM EPS ERROR ET G IN IN0 IN1 IN2 ITERM K KP L LD M
    MN MX N OFFSET P PDT PREV_IN PT PV Q Q1 QD QU Q_INTERNAL R R1 RELEASE RUN S S1 SP START_TIME STATE T TD TR X0 X1 X2
    X3 XI XIN XIN1 XIN2 XOUT
";
