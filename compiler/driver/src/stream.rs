//! What a file name on the command line stands for: a file, or `-` for the standard streams.

use grafc::files::{self, Refusal, print, print_bytes};
use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf, is_separator};

/// What a file name on the command line stands for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Stream {
    /// `-`: standard input or standard output.
    Standard,
    /// Any other name.
    File(PathBuf),
}

impl From<OsString> for Stream {
    fn from(name: OsString) -> Self {
        if name == "-" { Stream::Standard } else { Stream::File(name.into()) }
    }
}

/// Whether the parser of the command line could give its answer. If the reader went away, it has seen enough.
pub fn answered(printed: io::Result<()>) -> Result<(), Refusal> {
    match printed.and_then(|()| io::stdout().flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Refusal::to_write("<stdout>", error)),
        Ok(()) | Err(_) => Ok(()),
    }
}

impl Stream {
    /// The name, if it is a single word and no file has it: perhaps it was meant as a command.
    pub fn as_word(&self) -> Option<&str> {
        match self {
            Stream::File(path) if !path.exists() => path.to_str(),
            Stream::File(_) | Stream::Standard => None,
        }
    }

    /// What messages call it when it is read.
    pub fn input_name(&self) -> String {
        match self {
            Stream::Standard => "<stdin>".to_string(),
            Stream::File(path) => path.display().to_string(),
        }
    }

    /// What messages call it when it is written.
    pub fn output_name(&self) -> String {
        match self {
            Stream::Standard => "<stdout>".to_string(),
            Stream::File(path) => path.display().to_string(),
        }
    }

    /// Whether a path is that of a folder: of one that is there, or with an ending that only folders have.
    pub fn is_folder(path: &Path) -> bool {
        let last = path.as_os_str().as_encoded_bytes().last();
        last.is_some_and(|byte| is_separator(char::from(*byte))) || path.is_dir()
    }

    /// The name without folders, for the head of what is made of it.
    pub fn file_name(&self) -> String {
        match self {
            Stream::File(path) => path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned(),
            Stream::Standard => "standard input".to_string(),
        }
    }

    /// The name of a chart that does not give itself one.
    pub fn chart_name(&self) -> String {
        match self {
            Stream::Standard => "chart".to_string(),
            Stream::File(path) => grafc::chart_name(path),
        }
    }

    /// Whether both name one existing file, by whatever paths.
    pub fn is_same_file(&self, other: &Stream) -> bool {
        match (self, other) {
            (Stream::File(a), Stream::File(b)) => files::is_same_file(a, b),
            (Stream::Standard, _) | (_, Stream::Standard) => false,
        }
    }

    /// Whether what is written to one would be written to the other, whether or not it is there yet.
    pub fn is_same_stream(&self, other: &Stream) -> bool {
        match (self, other) {
            (Stream::Standard, Stream::Standard) => true,
            (Stream::File(a), Stream::File(b)) => {
                let absolute = |path| std::path::absolute(path).ok();
                files::is_same_file(a, b) || absolute(a).is_some_and(|a| Some(a) == absolute(b))
            }
            (Stream::Standard, Stream::File(_)) | (Stream::File(_), Stream::Standard) => false,
        }
    }

    /// Everything that is there.
    pub fn read(&self) -> Result<Vec<u8>, Refusal> {
        match self {
            Stream::File(path) => files::read(path),
            Stream::Standard => {
                let mut bytes = Vec::new();
                match io::stdin().lock().read_to_end(&mut bytes) {
                    Ok(_) => Ok(bytes),
                    Err(error) => Err(Refusal::to_read(self.input_name(), error)),
                }
            }
        }
    }

    /// What is there, as it comes; and how much it is, if that is known.
    pub fn open(&self) -> Result<(Box<dyn Read>, Option<u64>), Refusal> {
        match self {
            Stream::Standard => Ok((Box::new(io::stdin()), None)),
            Stream::File(path) => {
                let file = File::open(path).map_err(|error| Refusal::to_read(self.input_name(), error))?;
                let length = file.metadata().ok().filter(|metadata| metadata.is_file()).map(|metadata| metadata.len());
                Ok((Box::new(file), length))
            }
        }
    }

    /// Puts a text there, whole or not at all.
    pub fn write(&self, text: &str) -> Result<(), Refusal> {
        match self {
            Stream::Standard => print(text),
            Stream::File(path) => files::write(path, text),
        }
    }

    /// Puts texts into their places: all of them or none, each whole.
    pub fn write_all<T: AsRef<[u8]>>(texts: &[(&Stream, T)]) -> Result<(), Refusal> {
        let mut staged = Vec::new();
        for (stream, text) in texts {
            if let Stream::File(path) = stream {
                staged.push(files::stage(path, text)?);
            }
        }
        for (stream, text) in texts {
            if let Stream::Standard = stream {
                print_bytes(text.as_ref())?;
            }
        }
        files::put_all(staged)
    }
}
