//! The server: connections, limits, headers.

use crate::api::{Answer, Api};
use crate::error::ViewerError;
use crate::key::Door;
use crate::page::POLICY;
use crate::request;
use bytes::Bytes;
use demeter::results::Run;
use flate2::Compression;
use flate2::write::GzEncoder;
use http_body_util::Full;
use hyper::body::Incoming;
use hyper::header::{
    ACCEPT_ENCODING, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_TYPE, HeaderName, HeaderValue, LOCATION,
};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Request, Response, StatusCode};
use hyper_util::rt::{TokioIo, TokioTimer};
use std::convert::Infallible;
use std::io::Write;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::runtime::{Builder, Runtime};
use tokio::sync::Semaphore;

/// Most connections at a time. A browser opens six.
const MAX_CONNECTIONS: usize = 64;
/// Threads that read files.
const READERS: usize = 4;
/// Largest head of a request [bytes].
const MAX_HEAD: usize = 16 << 10;
/// How long a client may take for the head of a request, also between requests.
const HEAD_TIME: Duration = Duration::from_secs(30);
/// How long a connection may last.
const CONNECTION_TIME: Duration = Duration::from_secs(600);
/// Answers shorter than this are not compressed [bytes].
const WORTH_COMPRESSING: usize = 1 << 12;

/// How a run is served.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// The port; 0 for one that is free.
    pub port: u16,
    /// Whether answers are compressed: worth it where the page is looked at through a slow tunnel.
    pub compress: bool,
    /// Largest memory for frames that are kept [bytes].
    pub cache: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            port: 0,
            compress: false,
            cache: 512 << 20,
        }
    }
}

/// A run that is about to be served.
#[derive(Debug)]
pub struct Viewer {
    runtime: Runtime,
    listener: TcpListener,
    address: SocketAddr,
    service: Service,
}

#[derive(Clone, Debug)]
struct Service {
    api: Arc<Api>,
    door: Arc<Door>,
    readers: Arc<Semaphore>,
    compress: bool,
}

impl Viewer {
    /// Opens the folder of a run and takes a port of 127.0.0.1.
    pub fn open(folder: &Path, options: Options) -> Result<Self, ViewerError> {
        let api = Api::new(Run::open(folder)?, options.cache)?;
        let runtime = Builder::new_current_thread()
            .enable_all()
            .max_blocking_threads(READERS)
            .build()?;
        let door = Door::new().map_err(|error| ViewerError::NoKey(error.to_string()))?;
        let port = options.port;
        let listener = runtime
            .block_on(TcpListener::bind((Ipv4Addr::LOCALHOST, port)))
            .map_err(|source| ViewerError::Listen { port, source })?;
        Ok(Self {
            address: listener.local_addr()?,
            runtime,
            listener,
            service: Service {
                api: Arc::new(api),
                door: Arc::new(door),
                readers: Arc::new(Semaphore::new(READERS)),
                compress: options.compress,
            },
        })
    }

    /// Where the page is; it holds the key, so that it is for whoever may see the run only.
    pub fn url(&self) -> String {
        format!("http://{}{}", self.address, self.service.door.path())
    }

    /// An address that leads to the page once: for the command line of a browser, which everybody on the machine can read.
    pub fn url_once(&self) -> String {
        format!("http://{}{}", self.address, self.service.door.path_once())
    }

    /// The port.
    pub fn port(&self) -> u16 {
        self.address.port()
    }

    /// Serves until the process ends.
    pub fn serve(self) -> Result<Infallible, ViewerError> {
        let Self {
            runtime,
            listener,
            service,
            ..
        } = self;
        runtime.block_on(accept(listener, service))
    }
}

async fn accept(listener: TcpListener, service: Service) -> Result<Infallible, ViewerError> {
    let places = Arc::new(Semaphore::new(MAX_CONNECTIONS));
    loop {
        let Ok(place) = Arc::clone(&places).acquire_owned().await else {
            continue;
        };
        let Ok((stream, _)) = listener.accept().await else {
            // out of file descriptors, or the client went away: wait and go on
            tokio::time::sleep(Duration::from_millis(100)).await;
            continue;
        };
        // without this the last piece of an answer waits for an acknowledgement
        let _ = stream.set_nodelay(true);
        let service = service.clone();
        tokio::spawn(async move {
            let answer = service_fn(move |request| {
                let service = service.clone();
                async move { Ok::<_, Infallible>(service.answer(request).await) }
            });
            let connection = http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(HEAD_TIME)
                .max_buf_size(MAX_HEAD)
                .serve_connection(TokioIo::new(stream), answer);
            // a client that breaks off, or is too slow, is not a fault
            let _ = tokio::time::timeout(CONNECTION_TIME, connection).await;
            drop(place);
        });
    }
}

impl Service {
    async fn answer(&self, request: Request<Incoming>) -> Response<Full<Bytes>> {
        let (head, _) = request.into_parts();
        let accepts = head.headers.get(ACCEPT_ENCODING).and_then(|value| value.to_str().ok());
        let compress = self.compress && accepts.is_some_and(|list| list.contains("gzip"));
        let asked = match request::read(&head, &self.door) {
            Ok(asked) => asked,
            Err((status, problem)) => return respond(Answer::fault(status, problem), false),
        };
        let api = Arc::clone(&self.api);
        let Ok(_reader) = self.readers.acquire().await else {
            return respond(Answer::fault(StatusCode::SERVICE_UNAVAILABLE, "the server ends"), false);
        };
        let made = tokio::task::spawn_blocking(move || {
            let answer = api.answer(&asked);
            if compress { compressed(answer) } else { (answer, false) }
        });
        let (answer, is_compressed) = made.await.unwrap_or_else(|_| {
            let problem = "the answer could not be made; this is a defect of Demeter";
            (Answer::fault(StatusCode::INTERNAL_SERVER_ERROR, problem), false)
        });
        respond(answer, is_compressed)
    }
}

fn compressed(answer: Answer) -> (Answer, bool) {
    if answer.bytes.len() < WORTH_COMPRESSING {
        return (answer, false);
    }
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    let written = encoder.write_all(&answer.bytes).and_then(|()| encoder.finish());
    match written {
        Ok(bytes) => (
            Answer {
                bytes: bytes.into(),
                ..answer
            },
            true,
        ),
        Err(_) => (answer, false),
    }
}

fn respond(answer: Answer, is_compressed: bool) -> Response<Full<Bytes>> {
    let mut response = Response::new(Full::new(answer.bytes));
    *response.status_mut() = answer.status;
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(answer.kind));
    // a run that goes on changes
    headers.insert(CACHE_CONTROL, HeaderValue::from_static("no-store"));
    headers.insert("content-security-policy", POLICY.clone());
    for (name, value) in [
        ("x-content-type-options", "nosniff"),
        ("x-frame-options", "DENY"),
        ("referrer-policy", "no-referrer"),
        ("cross-origin-resource-policy", "same-origin"),
        ("cross-origin-opener-policy", "same-origin"),
    ] {
        headers.insert(HeaderName::from_static(name), HeaderValue::from_static(value));
    }
    if let Some(path) = answer.leads_to.and_then(|path| HeaderValue::try_from(path).ok()) {
        headers.insert(LOCATION, path);
    }
    if is_compressed {
        headers.insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
    }
    response
}
