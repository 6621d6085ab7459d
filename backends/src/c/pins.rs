//! Which variable is connected to which pin: a file with a line for each, `lamp = 13` or `button = 2 pullup inverted`.

/// The lines of such a file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Pins {
    /// The file, as the head of the code names it.
    pub file: String,
    /// Its lines, in order.
    pub list: Vec<Pin>,
}

/// What one variable is connected to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Pin {
    /// The variable, as the chart calls it.
    pub variable: String,
    /// The pin, as the board calls it: `13`, `A0`, `LED_BUILTIN`.
    pub pin: String,
    /// Whether the board pulls the input up.
    pub pullup: bool,
    /// Whether a low level is true.
    pub inverted: bool,
}

impl Pins {
    /// Reads a file: `NAME = PIN`, then `pullup` and `inverted` where that is so; what stands behind `#` is a remark.
    ///
    /// # Errors
    /// All that is wrong, line by line.
    pub fn parse(file: &str, text: &str) -> Result<Pins, String> {
        let (mut list, mut wrong) = (Vec::<Pin>::new(), Vec::new());
        for (number, line) in (1..).zip(text.lines()) {
            let line = line.split('#').next().unwrap_or_default().trim();
            if line.is_empty() {
                continue;
            }
            match pin(line) {
                Ok(pin) if list.iter().any(|other| other.variable == pin.variable) => {
                    wrong.push(format!("line {number}: `{}` has a pin already", pin.variable));
                }
                Ok(pin) => list.push(pin),
                Err(said) => wrong.push(format!("line {number}: {said}")),
            }
        }
        if wrong.is_empty() { Ok(Pins { file: file.to_owned(), list }) } else { Err(wrong.join("; ")) }
    }
}

fn pin(line: &str) -> Result<Pin, String> {
    let (variable, rest) = line.rsplit_once('=').ok_or_else(|| format!("`{line}` has no `=`"))?;
    let variable = variable.trim().trim_matches('`').to_owned();
    let mut words = rest.split_whitespace();
    let pin = words.next().unwrap_or_default();
    let is_number = pin.len() <= 3 && pin.parse::<u8>().is_ok_and(|n| n.to_string() == pin);
    let is_name = pin.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && pin.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if variable.is_empty() {
        return Err("no variable stands before `=`".to_owned());
    }
    if !is_number && !is_name {
        return Err(format!("`{pin}` is no pin: it is a number up to 255, or a name such as `A0` or `LED_BUILTIN`"));
    }
    let mut found = Pin { variable, pin: pin.to_owned(), pullup: false, inverted: false };
    for word in words {
        match word {
            "pullup" => found.pullup = true,
            "inverted" => found.inverted = true,
            other => return Err(format!("`{other}` is neither `pullup` nor `inverted`")),
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_a_variable() {
        let text = "# the lamp\nbutton = 2 inverted pullup\n\n lamp=LED_BUILTIN # on the board\n`a = b` = A0\n";
        let pin = |variable: &str, pin: &str, both: bool| Pin {
            variable: variable.into(),
            pin: pin.into(),
            pullup: both,
            inverted: both,
        };
        let list = vec![pin("button", "2", true), pin("lamp", "LED_BUILTIN", false), pin("a = b", "A0", false)];
        assert_eq!(Pins::parse("lamp.pins", text), Ok(Pins { file: "lamp.pins".into(), list }));
    }

    #[test]
    fn all_that_is_wrong_is_said_at_once() {
        let said = Pins::parse("", "a\nb = 256\nc = 1 up\n= 3\nd = 4;\ne = 5\ne = 6\nf = 007").expect_err("faults");
        let lines: Vec<&str> = said.split("; ").map(|said| said.split(':').next().unwrap_or_default()).collect();
        assert_eq!(lines, ["line 1", "line 2", "line 3", "line 4", "line 5", "line 7", "line 8"], "{said}");
    }
}
