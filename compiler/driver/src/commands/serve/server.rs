//! Requests and answers: the page at `/`, and at `/events` what is on the board, whenever that changes.

use super::board::{Board, Shown};
use super::guard::is_ours;
use crate::report::Failure;
use std::io::{self, Write};
use std::net::Ipv4Addr;
use std::sync::Arc;
use std::time::Duration;
use tiny_http::{Header, Method, Request, Response, Server as Listener};

/// IEC 60848.
const PORT: u16 = 60848;

/// So often something is sent to browsers, whether or not there is news: those that went away are found so.
const SIGN_OF_LIFE: Duration = Duration::from_secs(15);

/// Shown until there is a first good page.
const WAITING: &str = include_str!("waiting.html");

/// What listens for requests.
pub struct Server {
    listener: Listener,
    port: u16,
}

/// Takes a port of this machine, which others cannot reach.
pub fn bind(port: Option<u16>) -> Result<Server, Failure> {
    let bound = match port {
        Some(port) => Listener::http((Ipv4Addr::LOCALHOST, port)),
        None => Listener::http((Ipv4Addr::LOCALHOST, PORT)).or_else(|_| Listener::http((Ipv4Addr::LOCALHOST, 0))),
    };
    let listener = bound.map_err(|error| {
        let what = format!("port {} cannot be had: {error}", port.unwrap_or(PORT));
        Failure::WrongUse(what, "name another, or leave `--port` out".to_string())
    })?;
    let port = listener.server_addr().to_ip().map_or(PORT, |address| address.port());
    Ok(Server { listener, port })
}

impl Server {
    /// What a browser is given to open.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Answers requests, as long as there is somebody who listens.
    pub fn run(&self, board: &Arc<Board>) {
        for request in self.listener.incoming_requests() {
            // A browser that went away does not want its answer.
            let _ = self.answer(request, board);
        }
    }

    fn answer(&self, request: Request, board: &Arc<Board>) -> io::Result<()> {
        let field = |name: &'static str| {
            let mut found = request.headers().iter().filter(|header| header.field.equiv(name));
            found.next().map(|header| header.value.as_str())
        };
        // Which of two would count is anyone's guess.
        let is_once =
            |name: &'static str| request.headers().iter().filter(|header| header.field.equiv(name)).count() < 2;
        let is_clear = is_once("Host") && is_once("Origin");
        if !is_clear || !is_ours(self.port, field("Host"), field("Origin")) {
            return request
                .respond(plain(403, "This page is for this machine alone, by the address that grafc printed.\n"));
        }
        if !matches!(request.method(), Method::Get | Method::Head) {
            return request.respond(plain(405, "There is nothing here but to read.\n"));
        }
        match request.url().split('?').next() {
            Some("/") => {
                let page = board.shown().page.map_or_else(|| WAITING.to_string(), |(_, page)| page);
                // Its length is known: it goes out in one piece, and not in chunks that part characters.
                let page = Response::from_string(page).with_chunked_threshold(usize::MAX);
                request.respond(with_headers(page, "text/html; charset=utf-8"))
            }
            Some("/events") => {
                let board = board.clone();
                std::thread::spawn(move || events(request, &board));
                Ok(())
            }
            Some(_) | None => request.respond(plain(404, "The page is at `/`.\n")),
        }
    }
}

fn plain(status: u16, text: &str) -> Response<io::Cursor<Vec<u8>>> {
    with_headers(Response::from_string(text).with_status_code(status), "text/plain; charset=utf-8")
}

/// Nothing is kept by the browser, or taken for something else, or shown within another page.
fn with_headers<R: io::Read>(response: Response<R>, kind: &str) -> Response<R> {
    let fields = [
        ("Content-Type", kind),
        ("Cache-Control", "no-store"),
        ("X-Content-Type-Options", "nosniff"),
        ("X-Frame-Options", "DENY"),
        ("Cross-Origin-Resource-Policy", "same-origin"),
    ];
    fields.into_iter().fold(response, |response, (name, value)| {
        match Header::from_bytes(name, value) {
            Ok(header) => response.with_header(header),
            // They are all written above.
            Err(()) => response,
        }
    })
}

/// Sends what is on the board, and again at each change, until the browser goes away (server-sent events).
fn events(request: Request, board: &Board) {
    let mut out = request.into_writer();
    let head = "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\n\
                X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\nretry: 500\n\n";
    let mut shown = board.shown();
    let mut text = head.to_string() + &event(&shown);
    while out.write_all(text.as_bytes()).and_then(|()| out.flush()).is_ok() {
        let next = board.after(shown.change, SIGN_OF_LIFE);
        // A comment, which no script sees.
        text = if next.change == shown.change { ":\n\n".to_string() } else { event(&next) };
        shown = next;
    }
}

/// The version of the last good page, and what is wrong since, as one line of JSON.
fn event(shown: &Shown) -> String {
    let version = shown.page.as_ref().map(|(version, _)| version);
    format!("data: {}\n\n", serde_json::json!({ "page": version, "errors": shown.errors }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_event_is_one_line_whatever_the_errors_say() {
        let errors = Some("two\nlines \u{2028} \"</script>\"".to_string());
        let text = event(&Shown { change: 1, page: None, errors });
        assert_eq!(text.matches('\n').count(), 2, "{text}");
        assert!(text.starts_with("data: {") && text.ends_with("}\n\n"), "{text}");
    }
}
