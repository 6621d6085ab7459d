//! Programs that time themselves and take turns.
//!
//! A program prints the ns that an idle scan and one that clears take, and the bytes of what it scans. The programs take
//! turns: a figure is the median of the turns, and a ratio is the median of the ratios within a turn. Where other load
//! slows the machine for a while, it stands in the figures, and hardly in the ratios.

use crate::programs::call;
use std::path::PathBuf;
use std::process::Command;

/// What a program says of one turn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// Ns a scan in which nothing happens.
    pub(crate) idle: f64,
    /// Ns a scan in which each token moves.
    pub(crate) clearing: f64,
    /// What is kept from scan to scan.
    pub(crate) bytes: usize,
}

/// Lets all programs take so many turns; the samples of each, turn by turn.
pub(crate) fn take(programs: &[PathBuf], turns: usize) -> Result<Vec<Vec<Sample>>, String> {
    let mut samples: Vec<Vec<Sample>> = programs.iter().map(|_| Vec::new()).collect();
    for _ in 0..turns {
        for (program, samples) in programs.iter().zip(&mut samples) {
            samples.push(read(&call(&mut Command::new(program))?)?);
        }
    }
    Ok(samples)
}

/// Reads what a program printed.
fn read(printed: &str) -> Result<Sample, String> {
    let words: Vec<&str> = printed.split_whitespace().collect();
    let sample = match words.as_slice() {
        [idle, clearing, bytes] => match (idle.parse(), clearing.parse(), bytes.parse()) {
            (Ok(idle), Ok(clearing), Ok(bytes)) => Some(Sample { idle, clearing, bytes }),
            _ => None,
        },
        _ => None,
    };
    sample.ok_or_else(|| format!("`{printed}` is not what a program that times itself prints"))
}

/// The median of a figure.
pub(crate) fn figure(samples: &[Sample], of: fn(&Sample) -> f64) -> f64 {
    median(samples.iter().map(of).collect())
}

/// The median of the ratios of one program to another, turn by turn.
pub(crate) fn ratio(samples: &[Sample], to: &[Sample], of: fn(&Sample) -> f64) -> f64 {
    median(samples.iter().zip(to).map(|(own, other)| of(own) / of(other)).collect())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => values[n / 2],
        n => f64::midpoint(values[n / 2 - 1], values[n / 2]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_middle_one() {
        assert_eq!(median(vec![9.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![9.0, 1.0, 2.0, 4.0]), 3.0);
    }

    /// In the second turn the machine is slow: both figures tell of it, the ratio does not.
    #[test]
    fn a_ratio_is_one_within_turns() {
        let sample = |idle: f64| Sample { idle, clearing: 0.0, bytes: 1 };
        let (own, other) = ([sample(2.0), sample(80.0)], [sample(1.0), sample(40.0)]);
        assert_eq!(ratio(&own, &other, |sample| sample.idle), 2.0);
        assert_eq!(figure(&own, |sample| sample.idle), 41.0);
    }

    #[test]
    fn what_is_no_sample_is_refused() {
        assert!(read("1.5 2.5 16\n").is_ok());
        assert!(read("1.5 2.5\n").is_err());
        assert!(read("1.5 x 16\n").is_err());
    }
}
