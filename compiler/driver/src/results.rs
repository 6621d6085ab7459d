//! Where the results of a run go as they are made: a table or a waveform, into a file or on standard output.
//!
//! A file appears once the run is over, whole; standard output, and what cannot be replaced, have the rows up to the first
//! error.

use crate::stream::Stream;
use crate::waveform::Waveform;
use grafc::files::{self, Refusal, Writing};
use grafc::{Results, Simulation};
use grafc_model::simulate::Call;
use grafc_model::trace::Table;
use std::cell::{Cell, RefCell};
use std::io::{self, BufWriter, ErrorKind, Stdout, Write};
use std::rc::Rc;

/// How results are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// CSV
    Table,
    /// VCD
    Waveform,
}

/// The results of a run.
pub struct Written<'a> {
    simulation: &'a Simulation,
    form: Form,
    place: Option<Place>,
    name: String,
    /// Made when the run begins.
    writer: Option<Writer<'a>>,
    /// Whether somebody waits for each row.
    is_live: Rc<Cell<bool>>,
}

enum Writer<'a> {
    Table(Box<Table<'a, Place>>),
    Waveform(Box<Waveform<Place>>),
}

/// Where they are written to, known to the writer and to who ends the run.
#[derive(Clone)]
struct Place(Rc<RefCell<Out>>);

enum Out {
    Standard(BufWriter<Stdout>),
    File(Writing),
    /// It is put, or gone.
    Done,
}

impl<'a> Written<'a> {
    /// Results of a run that is to begin; with no output, nowhere.
    pub fn new(
        simulation: &'a Simulation,
        form: Form,
        output: Option<&Stream>,
        is_live: Rc<Cell<bool>>,
    ) -> Result<Self, Refusal> {
        let out = match output {
            Some(Stream::Standard) => Some(Out::Standard(BufWriter::with_capacity(1 << 16, io::stdout()))),
            Some(Stream::File(path)) => Some(Out::File(files::begin(path)?)),
            None => None,
        };
        let name = output.map(Stream::output_name).unwrap_or_default();
        let place = out.map(|out| Place(Rc::new(RefCell::new(out))));
        Ok(Written { simulation, form, place, name, writer: None, is_live })
    }

    /// The run is over. A file is put into its place if all went well.
    pub fn end(mut self, is_whole: bool) -> Result<(), Refusal> {
        let refused = |error| Refusal::to_write(self.name.clone(), error);
        if let Some(Writer::Table(table)) = &mut self.writer {
            allow_closed(table.flush()).map_err(refused)?;
        }
        let Some(Place(place)) = self.place else { return Ok(()) };
        match place.replace(Out::Done) {
            Out::Standard(mut out) => allow_closed(out.flush()).map_err(refused),
            Out::File(writing) if is_whole => writing.put(),
            Out::File(_) | Out::Done => Ok(()),
        }
    }
}

/// If standard output was closed early, the reader has seen enough.
fn allow_closed(written: io::Result<()>) -> io::Result<()> {
    written.or_else(|error| if error.kind() == ErrorKind::BrokenPipe { Ok(()) } else { Err(error) })
}

impl Results for Written<'_> {
    fn begin(&mut self, restarts: bool) -> io::Result<()> {
        let Some(place) = self.place.clone() else { return Ok(()) };
        self.writer = Some(match self.form {
            Form::Table => {
                let mut table = Table::new(place, &self.simulation.chart, self.simulation.shown(restarts));
                table.header()?;
                Writer::Table(Box::new(table))
            }
            Form::Waveform => Writer::Waveform(Box::new(Waveform::new(self.simulation, restarts, place)?)),
        });
        Ok(())
    }

    fn called(&mut self, call: Call) -> io::Result<()> {
        match &mut self.writer {
            Some(Writer::Table(table)) => {
                table.row(call.stimulus, call.response, call.looks)?;
                if self.is_live.get() { table.flush() } else { Ok(()) }
            }
            Some(Writer::Waveform(waveform)) => waveform.called(call),
            None => Ok(()),
        }
    }
}

impl Write for Place {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut *self.0.borrow_mut() {
            Out::Standard(out) => out.write(bytes),
            Out::File(writing) => writing.write(bytes),
            Out::Done => Ok(bytes.len()),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut *self.0.borrow_mut() {
            Out::Standard(out) => out.flush(),
            Out::File(writing) => writing.flush(),
            Out::Done => Ok(()),
        }
    }
}
