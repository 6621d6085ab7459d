//! Words of the text in messages.

/// A word as a message shows it: the first characters of a long one, without control characters.
pub(crate) fn shorten(word: &str) -> String {
    const MOST: usize = 40;
    let mut shown: String = word.chars().take(MOST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if word.chars().nth(MOST).is_some() {
        shown.push('…');
    }
    shown
}
