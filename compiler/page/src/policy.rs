//! What the page may do: run its own script and have its own look, both known by their hashes, and nothing else. So no
//! text of a user's could do harm even if it became markup.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest as _, Sha256};

/// The content of `Content-Security-Policy`. Only what is served may ask the server that it came from.
pub(crate) fn policy(style: &str, scripts: &[&str], is_live: bool) -> String {
    let scripts: Vec<String> = scripts.iter().map(|script| hash(script)).collect();
    let connect = if is_live { "; connect-src 'self'" } else { "" };
    format!(
        "default-src 'none'; style-src {}; script-src {}{connect}; base-uri 'none'; form-action 'none'",
        hash(style),
        scripts.join(" ")
    )
}

fn hash(text: &str) -> String {
    format!("'sha256-{}'", STANDARD.encode(Sha256::digest(text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_are_those_of_the_recommendation() {
        // The example of the recommendation CSP level 2, 7.2.5.
        assert_eq!(hash("alert('Hello, world.');"), "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
    }
}
