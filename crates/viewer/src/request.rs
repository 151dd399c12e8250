//! What is asked for. Only numbers are read from a request; anything else is no path of the viewer.

use crate::key::{Door, Way};
use hyper::header::{HOST, ORIGIN};
use hyper::http::request::Parts;
use hyper::{Method, StatusCode};

/// Longest path with its query [bytes].
const MAX_PATH: usize = 2048;
/// Most columns of one answer.
const MAX_COLUMNS: usize = 64;
/// Most moments of one answer.
const MAX_MOMENTS: usize = 64;
/// By which names the page may be reached. The port is not looked at: a tunnel (`ssh -L`) has another one.
const HOSTS: [&str; 2] = ["127.0.0.1", "localhost"];

/// What is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Request {
    /// The path of the page, to which whoever asks is led.
    LeadTo(String),
    Page,
    Script,
    Style,
    Licences,
    State {
        moments: usize,
    },
    Series {
        columns: Vec<usize>,
        from: usize,
    },
    Frame {
        step: u64,
    },
    Walls {
        step: u64,
    },
    Grain {
        step: u64,
        id: u32,
    },
    History {
        id: u32,
        moments: Vec<usize>,
    },
    Contacts {
        step: u64,
    },
}

/// Why a request is refused.
pub(crate) type Refusal = (StatusCode, &'static str);

/// What is said to whoever does not know the key, whatever was asked for.
pub(crate) const NO_KEY: &str =
    "this address lacks the key of the viewer: open the whole address that `demeter view` tells";

/// Reads a request, and refuses what does not come from the page of this server.
pub(crate) fn read(head: &Parts, door: &Door) -> Result<Request, Refusal> {
    if head.method != Method::GET {
        return Err((StatusCode::METHOD_NOT_ALLOWED, "only GET is answered"));
    }
    let host = head.headers.get(HOST).and_then(|host| host.to_str().ok());
    if !host.is_some_and(is_this_machine) || head.headers.get_all(HOST).iter().count() > 1 {
        return Err((
            StatusCode::MISDIRECTED_REQUEST,
            "this server answers for 127.0.0.1 and localhost only",
        ));
    }
    let origin = head
        .headers
        .get(ORIGIN)
        .map(|origin| origin.to_str().unwrap_or_default());
    if origin.is_some_and(|origin| !origin.strip_prefix("http://").is_some_and(is_this_machine)) {
        return Err((StatusCode::FORBIDDEN, "other sites may not ask this server"));
    }
    let path = match door.way(head.uri.path()) {
        Way::In(path) => path,
        Way::Page(path) => return Ok(Request::LeadTo(path)),
        Way::Closed => return Err((StatusCode::FORBIDDEN, NO_KEY)),
    };
    if head
        .uri
        .path_and_query()
        .is_none_or(|path| path.as_str().len() > MAX_PATH)
    {
        return Err((StatusCode::URI_TOO_LONG, "the path is too long"));
    }
    parse(path, head.uri.query().unwrap_or_default()).ok_or((StatusCode::NOT_FOUND, "there is no such page"))
}

/// Whether `name` or `name:port` names this machine.
fn is_this_machine(host: &str) -> bool {
    let (name, port) = host.rsplit_once(':').unwrap_or((host, "80"));
    HOSTS.iter().any(|own| own.eq_ignore_ascii_case(name)) && number::<u16>(port).is_some()
}

fn parse(path: &str, query: &str) -> Option<Request> {
    let parts: Vec<&str> = path.strip_prefix('/')?.split('/').collect();
    match parts.as_slice() {
        [""] => Some(Request::Page),
        ["viewer.js"] => Some(Request::Script),
        ["viewer.css"] => Some(Request::Style),
        ["licences.txt"] => Some(Request::Licences),
        ["api", "state"] => Some(Request::State {
            moments: value(query, "moments")?,
        }),
        ["api", "series"] => {
            let columns = numbers(query, "columns")?;
            (columns.len() <= MAX_COLUMNS).then_some(Request::Series {
                columns,
                from: value(query, "from")?,
            })
        }
        ["api", "contacts", step] => Some(Request::Contacts { step: number(step)? }),
        ["api", "frame", step] => Some(Request::Frame { step: number(step)? }),
        ["api", "walls", step] => Some(Request::Walls { step: number(step)? }),
        ["api", "grain", step, id] => Some(Request::Grain {
            step: number(step)?,
            id: number(id)?,
        }),
        ["api", "history", id] => {
            let moments = numbers(query, "moments")?;
            (moments.len() <= MAX_MOMENTS).then_some(Request::History {
                id: number(id)?,
                moments,
            })
        }
        _ => None,
    }
}

fn field<'q>(query: &'q str, name: &str) -> Option<&'q str> {
    let mut pairs = query.split('&').filter_map(|pair| pair.split_once('='));
    pairs.find(|(key, _)| *key == name).map(|(_, value)| value)
}

fn value<T: std::str::FromStr>(query: &str, name: &str) -> Option<T> {
    number(field(query, name)?)
}

/// Numbers between commas.
fn numbers(query: &str, name: &str) -> Option<Vec<usize>> {
    field(query, name)?.split(',').map(number).collect()
}

/// A number of digits only: no sign, no space.
fn number<T: std::str::FromStr>(text: &str) -> Option<T> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit());
    text.parse().ok().filter(|_| digits)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked_at(door: &Door, method: &str, path: &str, headers: &[(&str, &str)]) -> Result<Request, StatusCode> {
        let mut request = hyper::Request::builder().method(method).uri(path);
        for (name, value) in headers {
            request = request.header(*name, *value);
        }
        read(&request.body(()).unwrap().into_parts().0, door).map_err(|refusal| refusal.0)
    }

    /// Asks for a path behind the key.
    fn asked(method: &str, path: &str, headers: &[(&str, &str)]) -> Result<Request, StatusCode> {
        let door = Door::new().unwrap();
        asked_at(
            &door,
            method,
            &format!("{}{path}", door.path().trim_end_matches('/')),
            headers,
        )
    }

    fn get(path: &str) -> Result<Request, StatusCode> {
        asked("GET", path, &[("Host", "127.0.0.1:8000")])
    }

    #[test]
    fn requests_name_numbers() {
        assert_eq!(get("/"), Ok(Request::Page));
        assert_eq!(get("/api/frame/120"), Ok(Request::Frame { step: 120 }));
        assert_eq!(get("/api/grain/120/7"), Ok(Request::Grain { step: 120, id: 7 }));
        let series = Request::Series {
            columns: vec![1, 4],
            from: 20,
        };
        assert_eq!(get("/api/series?from=20&columns=1,4"), Ok(series));
        let history = Request::History {
            id: 7,
            moments: vec![3, 0],
        };
        assert_eq!(get("/api/history/7?moments=3,0"), Ok(history));
    }

    #[test]
    fn nothing_else_is_a_path() {
        for path in [
            "/api/frame/../../etc/passwd",
            "/../Cargo.toml",
            "/api/frame/..%2f..%2fetc%2fpasswd",
            "/api/frame/1/../../run.json",
            "/api/frame/-1",
            "/api/frame/+1",
            "/api/frame/1e3",
            "/api/frame/99999999999999999999999",
            "/api/frame/",
            "//etc/passwd",
            "/run.json",
            "/api/grain/1",
            "/api/grain/1/4294967296",
            "/api/series?columns=a&from=0",
            "/api/series?columns=&from=0",
            "/api/series?columns=1",
            "/api/state",
            "/api/history/7",
            "/api/history/7?moments=",
            "/api/history/7?moments=-1",
            "/viewer.js/",
        ] {
            assert_eq!(get(path), Err(StatusCode::NOT_FOUND), "{path}");
        }
        let columns = vec!["1"; MAX_COLUMNS + 1].join(",");
        assert_eq!(
            get(&format!("/api/series?columns={columns}&from=0")),
            Err(StatusCode::NOT_FOUND)
        );
        let moments = vec!["1"; MAX_MOMENTS + 1].join(",");
        assert_eq!(
            get(&format!("/api/history/7?moments={moments}")),
            Err(StatusCode::NOT_FOUND)
        );
        assert_eq!(
            get(&format!("/?{}", "x".repeat(MAX_PATH))),
            Err(StatusCode::URI_TOO_LONG)
        );
    }

    #[test]
    fn only_this_machine_asks() {
        for host in ["127.0.0.1", "localhost:9000", "LOCALHOST:1"] {
            assert!(asked("GET", "/", &[("Host", host)]).is_ok(), "{host}");
        }
        for host in [
            "evil.example:8000",
            "127.0.0.1.evil.example",
            "localhost@evil.example",
            "",
            "127.0.0.1:x",
            "[::1]:80",
        ] {
            assert_eq!(
                asked("GET", "/", &[("Host", host)]),
                Err(StatusCode::MISDIRECTED_REQUEST),
                "{host}"
            );
        }
        let twice = [("Host", "localhost"), ("Host", "evil.example")];
        assert_eq!(asked("GET", "/", &twice), Err(StatusCode::MISDIRECTED_REQUEST));
        assert_eq!(asked("GET", "/", &[]), Err(StatusCode::MISDIRECTED_REQUEST));
        let foreign = [("Host", "localhost"), ("Origin", "http://evil.example")];
        assert_eq!(asked("GET", "/", &foreign), Err(StatusCode::FORBIDDEN));
        let own = [("Host", "localhost"), ("Origin", "http://localhost:8000")];
        assert!(asked("GET", "/", &own).is_ok());
        for method in ["POST", "PUT", "DELETE", "HEAD", "OPTIONS", "CONNECT"] {
            assert_eq!(
                asked(method, "/", &own),
                Err(StatusCode::METHOD_NOT_ALLOWED),
                "{method}"
            );
        }
    }

    #[test]
    fn without_the_key_all_is_refused_alike() {
        let door = Door::new().unwrap();
        let own = [("Host", "localhost")];
        let other = Door::new().unwrap().path();
        for path in [
            "/",
            "/viewer.js",
            "/api/frame/1",
            "/nothing",
            &other,
            &format!("{other}api/frame/1"),
        ] {
            assert_eq!(asked_at(&door, "GET", path, &own), Err(StatusCode::FORBIDDEN), "{path}");
        }
        let page = door.path();
        let bare = page.trim_end_matches('/');
        assert_eq!(asked_at(&door, "GET", bare, &own), Ok(Request::LeadTo(page.clone())));
        assert_eq!(asked_at(&door, "GET", &page, &own), Ok(Request::Page));
        // the key does not make up for being another site
        let foreign = [("Host", "localhost"), ("Origin", "http://evil.example")];
        assert_eq!(asked_at(&door, "GET", &page, &foreign), Err(StatusCode::FORBIDDEN));
        assert_eq!(
            asked_at(&door, "POST", &page, &own),
            Err(StatusCode::METHOD_NOT_ALLOWED)
        );
    }
}
