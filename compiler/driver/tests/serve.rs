//! `grafc serve`: requests as a browser makes them, and as a page of somebody else would.

mod common;

use common::{FAULTY, Folder, VALVE};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpStream, UdpSocket};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A server, ended when it is dropped.
struct Served {
    child: Child,
    port: u16,
}

impl Served {
    fn start(folder: &Folder) -> Served {
        let mut child = Command::new(assert_cmd::cargo::cargo_bin!("grafc"))
            .args(["serve", "valve.gct", "--port", "0"])
            .current_dir(folder.path("."))
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut address = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut address).unwrap();
        let port = address.trim().strip_prefix("http://127.0.0.1:").and_then(|rest| rest.strip_suffix('/'));
        Served { child, port: port.unwrap_or_else(|| panic!("it printed {address:?}")).parse().unwrap() }
    }

    /// What is said to a request with these lines beyond the first.
    fn asked(&self, first: &str, fields: &str) -> String {
        let mut answer = String::new();
        self.open(first, &format!("{fields}Connection: close\r\n")).read_to_string(&mut answer).unwrap();
        answer
    }

    fn page(&self) -> String {
        self.asked("GET / HTTP/1.1", &format!("Host: 127.0.0.1:{}\r\n", self.port))
    }

    fn open(&self, first: &str, fields: &str) -> BufReader<TcpStream> {
        let mut stream = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        write!(stream, "{first}\r\n{fields}\r\n").unwrap();
        BufReader::new(stream)
    }

    fn events(&self) -> Events {
        Events(self.open("GET /events HTTP/1.1", &format!("Host: localhost:{}\r\n", self.port)))
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

struct Events(BufReader<TcpStream>);

impl Events {
    /// The next event: the version of the page, and the errors.
    fn next(&mut self) -> (Option<String>, Option<String>) {
        loop {
            let mut line = String::new();
            assert_ne!(self.0.read_line(&mut line).unwrap(), 0, "the server went away");
            if let Some(data) = line.strip_prefix("data: ") {
                let data: serde_json::Value = serde_json::from_str(data).unwrap();
                let text = |name: &str| data[name].as_str().map(str::to_string);
                return (text("page"), text("errors"));
            }
        }
    }

    /// The next with other errors or another page than this.
    fn after(&mut self, before: &(Option<String>, Option<String>)) -> (Option<String>, Option<String>) {
        loop {
            let next = self.next();
            if next != *before {
                return next;
            }
        }
    }
}

#[test]
fn a_save_is_told_and_errors_leave_the_last_good_page() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let served = Served::start(&folder);
    let first = served.page();
    assert!(first.starts_with("HTTP/1.1 200"), "{first}");
    assert!(first.contains("one valve") && first.contains("data-step=\"2\""));
    let mut events = served.events();
    let good = events.next();
    assert!(good.0.is_some() && good.1.is_none(), "{good:?}");

    std::fs::write(folder.path("valve.gct"), FAULTY).unwrap();
    let faulty = events.after(&good);
    assert_eq!(faulty.0, good.0, "the page is the last good one");
    let errors = faulty.1.clone().unwrap();
    assert!(errors.contains("E0201") && errors.contains("nowhere"), "{errors}");
    assert!(served.page().contains("one valve"));

    std::fs::write(folder.path("valve.gct"), VALVE.replace("one valve", "another valve")).unwrap();
    let mended = events.after(&faulty);
    assert!(mended.0.is_some() && mended.0 != good.0 && mended.1.is_none(), "{mended:?}");
    assert!(served.page().contains("another valve"));

    // A browser that opens late is told how things are.
    assert_eq!(served.events().next(), mended);
}

#[test]
fn a_chart_with_errors_from_the_start_has_a_page_that_waits() {
    let folder = Folder::new(&[("valve.gct", FAULTY)]);
    let served = Served::start(&folder);
    assert!(served.page().contains("The chart has errors"));
    let mut events = served.events();
    let faulty = events.next();
    assert!(faulty.0.is_none() && faulty.1.is_some(), "{faulty:?}");
    std::fs::write(folder.path("valve.gct"), VALVE).unwrap();
    assert!(events.after(&faulty).0.is_some());
    assert!(served.page().contains("one valve"));
}

#[test]
fn a_chart_that_goes_away_is_an_error_over_the_last_page() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let served = Served::start(&folder);
    let mut events = served.events();
    let good = events.next();
    std::fs::remove_file(folder.path("valve.gct")).unwrap();
    let gone = events.after(&good);
    assert!(gone.1.unwrap().contains("cannot read"));
    assert_eq!(gone.0, good.0);
}

#[test]
fn other_names_other_pages_and_other_requests_are_refused() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let served = Served::start(&folder);
    let own = format!("Host: 127.0.0.1:{}\r\n", served.port);
    let refused = |first: &str, fields: &str, status: &str| {
        let answer = served.asked(first, fields);
        assert!(answer.starts_with(&format!("HTTP/1.1 {status}")), "{first} {fields}: {answer}");
        assert!(!answer.contains("one valve"), "{answer}");
    };
    for path in ["/", "/events", "/nowhere"] {
        let get = format!("GET {path} HTTP/1.1");
        refused(&get, &format!("Host: evil.example:{}\r\n", served.port), "403");
        refused(&get, "", "403");
        refused(&get, &format!("{own}{own}"), "403");
        refused(&get, &format!("{own}Host: evil.example\r\n"), "403");
        refused(&get, &format!("{own}Origin: http://evil.example\r\n"), "403");
        refused(&get, &format!("{own}Origin: null\r\n"), "403");
    }
    refused("POST / HTTP/1.1", &format!("{own}Content-Length: 0\r\n"), "405");
    refused("GET /../valve.gct HTTP/1.1", &own, "404");
    refused("GET /valve.gct HTTP/1.1", &own, "404");
    assert!(served.asked("GET /?again HTTP/1.1", &own).contains("one valve"));
}

#[test]
fn only_this_machine_can_reach_it() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let served = Served::start(&folder);
    // No packet is sent: this only asks which address would be used.
    let outward = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0))
        .and_then(|socket| socket.connect("192.0.2.1:9").and_then(|()| socket.local_addr()));
    match outward {
        Ok(address) if !address.ip().is_loopback() => {
            assert!(TcpStream::connect((address.ip(), served.port)).is_err(), "{address} answers");
        }
        Ok(_) | Err(_) => assert!(served.page().contains("one valve"), "this machine has no other address"),
    }
}

#[test]
fn what_cannot_be_served_is_refused() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    folder.run(&["serve", "-"]).ends(2, "standard input cannot be watched").ends(2, "grafc page");
    let taken = Served::start(&folder);
    folder.run(&["serve", "valve.gct", "--port", &taken.port.to_string()]).ends(2, "cannot be had");
}
