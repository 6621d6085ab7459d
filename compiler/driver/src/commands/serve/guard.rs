//! Who may ask. A page of any web site can send requests to this machine, or have its own name lead here (DNS
//! rebinding): what is asked for by another name, or on behalf of another page, is refused.

/// Whether a request is for this server by a name of this machine, and comes from no page but its own.
pub fn is_ours(port: u16, host: Option<&str>, origin: Option<&str>) -> bool {
    let ours = |name: &str| {
        ["127.0.0.1", "localhost"].iter().any(|own| {
            // Browsers leave out the port of the protocol.
            name.eq_ignore_ascii_case(&format!("{own}:{port}")) || port == 80 && name.eq_ignore_ascii_case(own)
        })
    };
    let from_ours = |origin: &str| origin.strip_prefix("http://").is_some_and(ours);
    host.is_some_and(ours) && origin.is_none_or(from_ours)
}

#[cfg(test)]
mod tests {
    use super::is_ours;

    #[test]
    fn this_machine_by_its_own_name_and_nobody_else() {
        for host in ["127.0.0.1:60848", "localhost:60848", "LOCALHOST:60848"] {
            assert!(is_ours(60848, Some(host), None), "{host}");
            assert!(is_ours(60848, Some(host), Some("http://127.0.0.1:60848")), "{host}");
        }
        for host in [
            "127.0.0.1",
            "127.0.0.1:80",
            "evil.example",
            "evil.example:60848",
            "127.0.0.1.evil.example:60848",
            "localhost:608480",
            "",
        ] {
            assert!(!is_ours(60848, Some(host), None), "{host}");
        }
        assert!(!is_ours(60848, None, None), "HTTP/1.0 without a name");
        for origin in ["null", "http://evil.example", "https://localhost:60848", "http://localhost:1", "file://", ""] {
            assert!(!is_ours(60848, Some("localhost:60848"), Some(origin)), "{origin}");
        }
        assert!(is_ours(80, Some("localhost"), None));
    }
}
