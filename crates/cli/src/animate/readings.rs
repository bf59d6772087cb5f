//! Irradiance at points, frame after frame.

use radiosity_output::table::{Column, Table, Value};
use radiosity_reading::checked_readings::{CheckedReadings, PrintedReading};
use radiosity_reading::own_error::OwnError;
use radiosity_reading::probe::{ProbeReading, probe};
use radiosity_reading::quality;
use radiosity_reading::read_error::ReadError;
use radiosity_solve::Options;
use radiosity_solve::animation::frame::Frame;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;

use crate::destination::Destination;
use crate::error::CliError;
use crate::points::{COLUMNS, Points};
use crate::sensors::Sensors;

/// The readings of all frames so far.
#[derive(Debug)]
pub(super) struct Readings {
    sensors: Sensors,
    how: quality::ReadSettings,
    frames: Vec<FrameReadings>,
}

/// The readings of a frame.
#[derive(Debug)]
struct FrameReadings {
    /// Number of the frame.
    frame: usize,
    readings: Vec<ProbeReading>,
    /// The method's own estimates of their errors.
    own: OwnError,
}

impl FrameReadings {
    /// The errors that are told after what was `found`, in this frame if it `is_judged`, else in another.
    fn errors(&self, found: Option<&CheckedReadings>, is_judged: bool) -> Vec<f64> {
        let of = |own: &ProbeReading| self.own.of_reading(&own.irradiance, own.uncertainty);
        let estimates = self.readings.iter().map(of);
        match is_judged {
            true => CheckedReadings::all_told(found, estimates),
            false => CheckedReadings::all_told_of_others(found, estimates),
        }
    }
}

impl Readings {
    /// Readings of no frame yet.
    pub(super) fn new(points: Points, how: quality::ReadSettings) -> Self {
        Self { sensors: Sensors::Points(points), how, frames: Vec::new() }
    }

    /// Reads the points in a frame that was solved with these options.
    pub(super) fn read(
        &mut self,
        number: usize,
        frame: &Frame,
        options: &Options,
        work: &Work<'_>,
    ) -> Result<(), CliError> {
        let reader = self.how.reader(&frame.solution, &frame.visibility);
        let read = probe(&reader, &self.sensors.probes(), frame.scene.middle, work);
        let read = read.map_err(|(index, fault)| self.sensors.unreadable(index, fault))?;
        let own = OwnError::of_frame(frame, options, &self.how);
        self.frames.push(FrameReadings { frame: number, readings: read, own });
        Ok(())
    }

    /// A reading of the last frame as a referee judges it, and their number.
    pub(super) fn printed(&self, number: usize, frame: &Frame) -> Option<PrintedReading> {
        let FrameReadings { readings, own, .. } = self.frames.last()?;
        let reading = readings.get(number)?;
        PrintedReading::of_probe(reading, &frame.scene, own, None)
    }

    /// Number of the points.
    pub(super) fn count(&self) -> usize {
        self.sensors.probes().len()
    }

    /// The error of readings by rays, of all frames.
    pub(super) fn error(&self) -> Option<ReadError> {
        let readings = self.frames.iter().flat_map(|own| &own.readings);
        ReadError::of(readings.map(|reading| reading.uncertainty.deviation))
    }

    /// Prints `frame,point,x,y,z,nx,ny,nz,E_<band>…,error`, a row for each frame and point, with the errors that
    /// follow from what was found in the frame of the number `judged`.
    pub(super) fn write(
        &self,
        bands: &[String],
        judged: usize,
        found: Option<&CheckedReadings>,
        ranks: &Ranks,
    ) -> Result<(), CliError> {
        let columns = [
            Column::numbers("frame", ""),
            Column::numbers("point", ""),
            Column::several("place", COLUMNS),
            Column::bands("irradiance", 'E', bands),
            Column::numbers("error", ""),
        ];
        let rows = self.frames.iter().flat_map(|own| {
            let errors = own.errors(found, own.frame == judged);
            own.readings.iter().zip(errors).enumerate().map(move |(point, (reading, error))| {
                let ProbeReading { probe, irradiance, .. } = reading;
                let place = [probe.position.to_array(), probe.normal.to_array()].concat();
                let place = Value::numbers(place);
                [Value::from(own.frame), point.into(), place, Value::numbers(irradiance), error.into()]
            })
        });
        let table = Table::new(columns, rows);
        Destination::of(None, ranks).write(|writer| table.listed().csv(writer))
    }
}
