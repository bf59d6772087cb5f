//! The points of a probe: a CSV file of positions and normals.
//!
//! Columns x,y,z,nx,ny,nz. With a header line they may stand in any order, and other columns are ignored;
//! without one there are exactly these six. Lines that start with # are comments. Normals may have any length
//! but 0.

use radiosity_geom::DVec3;
use radiosity_language::csv_rows::{Row, rows};
use radiosity_language::input;
use radiosity_reading::probe::Probe;
use radiosity_scene::ranges::LARGEST;
use radiosity_work::ranks::Ranks;

use crate::error::CliError;

/// Names of the columns.
pub(crate) const COLUMNS: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// The points, each with its line in the file.
#[derive(Debug)]
pub(crate) struct Points {
    /// The name shown in messages.
    origin: String,
    /// The points, in the order of the file.
    pub(crate) probes: Vec<Probe>,
    /// The line of each point, from 1.
    pub(crate) lines: Vec<usize>,
}

impl Points {
    /// Reads a file, or standard input for `-`, which the first of these ranks shares.
    pub(crate) fn load(source: &str, ranks: &Ranks) -> Result<Self, CliError> {
        let origin = if source == "-" { "<stdin>" } else { source };
        let text = input::bytes(source, ranks).map_err(|reason| {
            let cure = "give the path of a CSV file of points, or - for standard input";
            CliError::refused(format!("{origin}: cannot be read: {reason}"), cure)
        })?;
        Self::parse(&text, origin)
    }

    fn parse(text: &[u8], origin: &str) -> Result<Self, CliError> {
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        let text = std::str::from_utf8(text).map_err(|fault| {
            let line = 1 + text[..fault.valid_up_to()].iter().filter(|byte| **byte == b'\n').count();
            let cause = format!("{origin}:{line}: this is no text: {fault}");
            CliError::refused(cause, "save the file as UTF-8")
        })?;
        let mut points = Self { origin: origin.to_owned(), probes: Vec::new(), lines: Vec::new() };
        let mut columns: Option<Columns> = None;
        for row in rows(text) {
            let Row { fields, line, .. } = row;
            if let [field] = fields.as_slice()
                && field.contains([';', '\t'])
            {
                return Err(points.error(line, "there is no comma in it".to_owned(), COMMAS));
            }
            match &columns {
                None if is_header(&fields) => columns = Some(points.header(&fields, line)?),
                _ => {
                    let columns =
                        columns.get_or_insert(Columns { places: std::array::from_fn(|k| k), count: 6 });
                    let probe = columns.probe(&fields);
                    points.probes.push(probe.map_err(|(fault, cure)| points.error(line, fault, cure))?);
                    points.lines.push(line);
                }
            }
        }
        match points.probes.is_empty() {
            true => Err(CliError::refused(format!("{origin}: there are no points in it"), FORM)),
            false => Ok(points),
        }
    }

    fn header(&self, record: &[String], line: usize) -> Result<Columns, CliError> {
        let mut places = [0; 6];
        for (place, name) in places.iter_mut().zip(COLUMNS) {
            let mut found = (0..record.len()).filter(|k| record[*k].eq_ignore_ascii_case(name));
            let missing = || self.error(line, format!("the header has no column '{name}'"), FORM);
            *place = found.next().ok_or_else(missing)?;
            if found.next().is_some() {
                let fault = format!("the header has two columns '{name}'");
                return Err(self.error(line, fault, "leave one out"));
            }
        }
        Ok(Columns { places, count: record.len() })
    }

    /// The error of a line.
    pub(crate) fn error(&self, line: usize, fault: String, cure: &str) -> CliError {
        CliError::refused(format!("{}:{line}: {fault}", self.origin), cure)
    }
}

/// Form of the lines of a file.
const FORM: &str = "write six numbers a line, x,y,z,nx,ny,nz: a point and its normal";

/// Cure of a file with other marks between its numbers.
const COMMAS: &str = "part the numbers by commas, with points in them: 0.5,1,0,0,0,1";

/// Indices of the six columns in a line, and number of all columns.
struct Columns {
    places: [usize; 6],
    count: usize,
}

impl Columns {
    fn probe(&self, record: &[String]) -> Result<Probe, (String, &'static str)> {
        if record.len() != self.count {
            let fault = format!("there are {} columns instead of {}", record.len(), self.count);
            return Err((fault, FORM));
        }
        let mut numbers = [0.0; 6];
        for ((number, place), name) in numbers.iter_mut().zip(self.places).zip(COLUMNS) {
            let text = &record[place];
            let parsed = text.parse().ok().filter(|x: &f64| x.is_finite());
            let fault = || format!("column {} ({name}): '{text}' is no finite number", place + 1);
            *number = parsed.ok_or_else(|| (fault(), "write a number such as 0.25 or 1e-3"))?;
        }
        let [x, y, z, nx, ny, nz] = numbers;
        if let Some(place) = [x, y, z].iter().position(|x| x.abs() > LARGEST) {
            let fault =
                format!("column {} ({}): farther off than 1e30", self.places[place] + 1, COLUMNS[place]);
            return Err((fault, "give the point in the unit of the scene, whose numbers end at 1e30"));
        }
        Probe::along(DVec3::new(x, y, z), DVec3::new(nx, ny, nz)).ok_or_else(|| {
            let fault = format!("column {} (nx): the normal is zero", self.places[3] + 1);
            (fault, "give the direction that the light is received along, of any length but 0")
        })
    }
}

/// Whether no field of a line is a number.
fn is_header(record: &[String]) -> bool {
    record.iter().all(|field| field.parse::<f64>().is_err())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_may_stand_in_any_order_with_others_between() {
        let text = b"# desk\nname, nz,ny,nx, x,y,z\nlamp,2,0,0,1,2,3\n";
        let points = Points::parse(text, "desk.csv").unwrap();
        assert_eq!(points.probes, [Probe { position: DVec3::new(1.0, 2.0, 3.0), normal: DVec3::Z }]);
        assert_eq!(points.lines, [3]);
    }

    #[test]
    fn very_short_and_long_normals_have_a_direction() {
        let points = Points::parse(b"0,0,0,1e-300,0,0\n0,0,0,0,-1e300,0\n", "a").unwrap();
        assert_eq!(points.probes.iter().map(|p| p.normal).collect::<Vec<_>>(), [DVec3::X, -DVec3::Y]);
    }

    #[test]
    fn faults_name_line_and_column() {
        let message = |text: &str| Points::parse(text.as_bytes(), "p.csv").unwrap_err().to_string();
        assert_eq!(
            message("0,0,0,0,0,1\n0,zero,0,0,0,1\n"),
            "p.csv:2: column 2 (y): 'zero' is no finite number"
        );
        assert_eq!(message("0,0,0,0,0,0\n"), "p.csv:1: column 4 (nx): the normal is zero");
        let spaced = "\u{feff}# desk\n\n0,0,0,0,0,1\n# wall\n\n0,zero,0,0,0,1\n";
        assert_eq!(message(spaced), "p.csv:6: column 2 (y): 'zero' is no finite number");
        assert_eq!(message("x;y;z;nx;ny;nz\n"), "p.csv:1: there is no comma in it");
        assert_eq!(message("0,0,0,0,0\n"), "p.csv:1: there are 5 columns instead of 6");
        assert_eq!(message("x,y,z,nx,ny\n0,0,0,0,1\n"), "p.csv:1: the header has no column 'nz'");
        assert_eq!(message(""), "p.csv: there are no points in it");
        assert_eq!(message("0,0,1e31,0,0,1\n"), "p.csv:1: column 3 (z): farther off than 1e30");
        assert_eq!(message("0,0,inf,0,0,1\n"), "p.csv:1: column 3 (z): 'inf' is no finite number");
    }
}
