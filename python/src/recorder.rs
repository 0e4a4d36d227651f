//! The recorder's file as Python reads it.

use std::path::PathBuf;

use gyradius_core::Result;
use gyradius_core::recorder::{Event, Header, Piece, Reader, Stream};
use numpy::{PyArray1, PyArray2, ToPyArray};
use pyo3::prelude::*;

use crate::errors::detached;

/// Stamps (ns) and rows of x, y, z of one stream, by its name.
type Track<'py> = (&'static str, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray2<f64>>);
/// Stream, name and full scale of a sensor.
type Sensor = (&'static str, String, Option<f64>);

/// All of a recorder's file.
#[pyclass(frozen, module = "gyradius._core")]
pub struct RecorderFile {
    header: Header,
    events: Vec<Event>,
    damage: Vec<String>,
    streams: Vec<(Stream, Vec<i64>, Vec<[f64; 3]>)>,
}

/// Reads a recorder's file past whatever is damaged.
#[pyfunction]
pub fn read_recorder(py: Python<'_>, path: PathBuf) -> PyResult<RecorderFile> {
    detached(py, || read(path))
}

fn read(path: PathBuf) -> Result<RecorderFile> {
    let mut file = RecorderFile {
        header: Header::default(),
        events: Vec::new(),
        damage: Vec::new(),
        streams: Stream::ALL.map(|stream| (stream, Vec::new(), Vec::new())).into(),
    };
    let mut reader = Reader::open(path)?;
    while let Some(piece) = reader.next_piece()? {
        match piece {
            Piece::Header(header) => file.header = header,
            Piece::Event(event) => file.events.push(event),
            Piece::Samples(samples) => {
                let mut mine = file.streams.iter_mut().filter(|track| track.0 == samples.stream);
                if let Some((_, stamps_ns, values)) = mine.next() {
                    stamps_ns.extend(samples.stamps_ns);
                    values.extend(samples.values);
                }
            }
            Piece::Resumed { .. } => {}
        }
    }
    file.damage = reader.damage().iter().map(|damage| damage.text()).collect();
    Ok(file)
}

#[pymethods]
impl RecorderFile {
    /// Model of the phone.
    #[getter]
    fn phone(&self) -> &str {
        &self.header.phone
    }

    /// Anything else that the recorder noted, by key.
    #[getter]
    fn notes(&self) -> Vec<(String, String)> {
        self.header.notes.clone().into_iter().collect()
    }

    /// Stream, name and full scale of every sensor.
    #[getter]
    fn sensors(&self) -> Vec<Sensor> {
        let sensors = self.header.sensors.iter();
        sensors.map(|sensor| (sensor.stream.name(), sensor.name.clone(), sensor.full_scale)).collect()
    }

    /// Stamp (ns) and key of every mark, in the order of the file.
    #[getter]
    fn events(&self) -> Vec<(i64, String)> {
        self.events.iter().map(|event| (event.stamp_ns, event.key.clone())).collect()
    }

    /// What is missing in the file, a sentence each.
    #[getter]
    fn damage(&self) -> Vec<String> {
        self.damage.clone()
    }

    /// Samples of every stream that has any.
    fn tracks<'py>(&self, py: Python<'py>) -> PyResult<Vec<Track<'py>>> {
        let filled = self.streams.iter().filter(|track| !track.1.is_empty());
        let track = |(stream, stamps_ns, values): &(Stream, Vec<i64>, Vec<[f64; 3]>)| {
            let rows = numpy::ndarray::ArrayView2::from(values.as_slice()).to_pyarray(py);
            Ok((stream.name(), stamps_ns.to_pyarray(py), rows))
        };
        filled.map(track).collect()
    }
}
