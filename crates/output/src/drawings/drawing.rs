//! Drawings of lines, disks and texts, written as SVG or drawn on a picture.

use std::fmt::Write;

use super::lettering::Lettering;
use super::markup::escaped;
use super::picture::{Colour, Picture};
use super::stroke::Stroke;

/// Pixels per unit of a picture. Chosen.
const ZOOM: f64 = 2.0;
/// Size of letters in SVG over the height of a line.
const LETTER: f64 = 0.8;

/// Shapes on white, in units from the left upper corner.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Units across and down.
    pub(super) size: [f64; 2],
    /// In the order in which they cover each other.
    pub(super) shapes: Vec<Shape>,
}

/// A shape of a drawing.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// Lines through points.
    Lines { lines: Vec<Vec<[f64; 2]>>, width: f64, colour: Colour },
    /// A disk.
    Disk { center: [f64; 2], radius: f64, colour: Colour },
    /// A line of text.
    Text(Words),
}

/// A line of text.
#[derive(Clone, Debug)]
pub(super) struct Words {
    pub(super) text: String,
    /// Height of the line.
    pub(super) size: f64,
    /// The place in the middle of its height, with the part `before` of its length before it.
    pub(super) place: [f64; 2],
    pub(super) before: f64,
    pub(super) colour: Colour,
    /// Whether the text runs upwards.
    pub(super) upright: bool,
}

impl Drawing {
    /// The text of an SVG file, a shape a line.
    pub fn svg(&self) -> String {
        let [width, height] = self.size;
        let head = format!("width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\"");
        let shapes: String = self.shapes.iter().map(Shape::svg).collect();
        format!(
            "<svg {head} xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{shapes}</svg>\n"
        )
    }

    /// The drawing in pixels.
    pub fn picture(&self) -> Picture {
        let [width, height] = self.size.map(|length| (ZOOM * length) as u32);
        let mut picture = Picture::filled(width, height, [255; 3]);
        self.shapes.iter().for_each(|shape| shape.draw(&mut picture));
        picture
    }
}

impl Shape {
    fn svg(&self) -> String {
        match self {
            Self::Lines { lines, width, colour } => {
                let point = |(k, [x, y]): (usize, &[f64; 2])| {
                    format!("{}{x:.1} {y:.1}", if k == 0 { 'M' } else { 'L' })
                };
                let path: String = lines.iter().flat_map(|line| line.iter().enumerate().map(point)).collect();
                let stroke = code(*colour);
                format!("<path d=\"{path}\" fill=\"none\" stroke=\"{stroke}\" stroke-width=\"{width}\"/>\n")
            }
            Self::Disk { center: [x, y], radius, colour } => {
                format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{}\"/>\n", code(*colour))
            }
            Self::Text(words) => words.svg(),
        }
    }

    fn draw(&self, picture: &mut Picture) {
        match self {
            Self::Lines { lines, width, colour } => {
                let mut stroke = Stroke::new(picture.size());
                for line in lines {
                    let line: Vec<[f64; 2]> = line.iter().map(|point| point.map(|x| ZOOM * x)).collect();
                    stroke.line(&line, ZOOM * width);
                }
                stroke.draw(picture, *colour, 1.0);
            }
            Self::Disk { center, radius, colour } => {
                picture.disk(center.map(|x| ZOOM * x), ZOOM * radius, *colour);
            }
            Self::Text(words) => words.draw(picture),
        }
    }
}

impl Words {
    fn svg(&self) -> String {
        let [x, y] = self.place.map(|x| format!("{x:.1}"));
        let anchor = match self.before {
            0.0 => "start",
            1.0 => "end",
            _ => "middle",
        };
        let turn = if self.upright { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
        let mut line = format!("<text x=\"{x}\" y=\"{y}\" dy=\"0.35em\" text-anchor=\"{anchor}\"{turn}");
        let (size, fill) = (LETTER * self.size, code(self.colour));
        let end = writeln!(line, " font-size=\"{size:.1}\" fill=\"{fill}\">{}</text>", escaped(&self.text));
        end.expect("a text takes everything");
        line
    }

    fn draw(&self, picture: &mut Picture) {
        let size = (ZOOM * self.size) as u32;
        let line = Lettering { text: &self.text, size, colour: self.colour, upright: self.upright };
        let [length, height] = line.extent().map(f64::from);
        let [x, y] = self.place.map(|x| ZOOM * x);
        let corner = match self.upright {
            true => [x - 0.5 * height, y + self.before * length],
            false => [x - self.before * length, y - 0.5 * height],
        };
        line.draw(picture, corner.map(|x| x as i32));
    }
}

/// The colour in CSS's notation.
fn code([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}
