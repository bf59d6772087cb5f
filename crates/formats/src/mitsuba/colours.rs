//! Colours: linear red, green and blue of numbers, colours, spectra and textures.

use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::short;

use super::element::{Element, Remarks, words};
use super::ids::Ids;
use super::spectra;
use crate::colour;

/// Most textures in one another. Textures that hold themselves end here.
const DEEPEST: usize = 16;

/// Red, green and blue of the two kinds of squares of a checkerboard, where the scene does not say.
const SQUARES: [(&str, f64); 2] = [("color0", 0.4), ("color1", 0.2)];

const SPECTRA: &str =
    "spectra become red, green and blue by their means over 600 to 700, 500 to 600 and 400 to 500 nm";

/// The colour that an element states.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Colour {
    /// Linear red, green and blue, all ≥ 0.
    Known([f64; 3]),
    /// Kind of element whose colour cannot be told: "bitmap".
    Unknown(String),
}

/// Context in which colours are read.
pub(super) struct Colours<'a, 'b> {
    /// Elements by their ids.
    pub(super) ids: &'b Ids<'a>,
    /// Remarks on colours that are changed.
    pub(super) remarks: &'b mut Remarks,
}

impl<'a> Colours<'a, '_> {
    /// The colour that a name is given to in an element; none without one.
    ///
    /// # Errors
    /// Values that are no numbers or below 0, ids that nothing has.
    pub(super) fn property(&mut self, element: &'a Element, name: &str) -> Result<Option<Colour>, Refusal> {
        self.inner(element, name, 0)
    }

    fn inner(&mut self, element: &'a Element, name: &str, depth: usize) -> Result<Option<Colour>, Refusal> {
        let Some(stated) = self.ids.property(element, name)? else { return Ok(None) };
        if depth >= DEEPEST {
            return Err(stated.refusal(
                format!("textures are in one another more than {DEEPEST} deep, or in a circle"),
                "take some out",
            ));
        }
        let colour = self.of(stated, depth)?;
        match &colour {
            Colour::Known(values) if !values.iter().all(|value| *value >= 0.0) => {
                Err(stated.refusal(format!("{} is below 0", short(name)), "write 0 or more"))
            }
            _ => Ok(Some(colour)),
        }
    }

    fn of(&mut self, stated: &'a Element, depth: usize) -> Result<Colour, Refusal> {
        match (stated.tag.as_str(), stated.kind()) {
            ("float" | "integer", _) => stated.triple("value").map(Colour::Known),
            ("rgb", _) => rgb(stated, false).map(Colour::Known),
            ("srgb", _) => rgb(stated, true).map(Colour::Known),
            ("spectrum", "") => self.spectrum(stated),
            ("spectrum" | "texture", kind) => self.texture(stated, kind, depth),
            (tag, _) => {
                stated.pass_over();
                Ok(Colour::Unknown(short(tag)))
            }
        }
    }

    /// A spectrum: one number, or values at wavelengths.
    fn spectrum(&mut self, stated: &'a Element) -> Result<Colour, Refusal> {
        if stated.attribute("value").is_none() && stated.attribute("filename").is_some() {
            return Ok(Colour::Unknown("file of a spectrum".to_owned()));
        }
        if stated.required("value")?.contains(':') {
            let pairs = spectra::pairs(stated, "value")?;
            return self.means(stated, &pairs);
        }
        stated.triple("value").map(Colour::Known)
    }

    fn means(&mut self, stated: &Element, pairs: &[[f64; 2]]) -> Result<Colour, Refusal> {
        self.remarks.add(SPECTRA, stated);
        spectra::bands(pairs, stated).map(Colour::Known)
    }

    /// A spectrum or a texture of a type.
    fn texture(&mut self, stated: &'a Element, kind: &str, depth: usize) -> Result<Colour, Refusal> {
        match kind {
            "uniform" => Ok(Colour::Known([stated.float("value")?.unwrap_or(1.0); 3])),
            "srgb" => Ok(self.inner(stated, "color", depth + 1)?.unwrap_or(Colour::Known([1.0; 3]))),
            "d65" => {
                let scale = stated.float("scale")?.unwrap_or(1.0);
                let colour = self.inner(stated, "color", depth + 1)?.unwrap_or(Colour::Known([1.0; 3]));
                Ok(match colour {
                    Colour::Known(values) => Colour::Known(values.map(|value| scale * value)),
                    unknown => unknown,
                })
            }
            "regular" => self.regular(stated),
            "irregular" => self.irregular(stated),
            "checkerboard" => self.checkerboard(stated, depth),
            kind => {
                stated.pass_over();
                Ok(Colour::Unknown(short(kind)))
            }
        }
    }

    /// Values at wavelengths from `wavelength_min` to `wavelength_max` at equal distances.
    fn regular(&mut self, stated: &'a Element) -> Result<Colour, Refusal> {
        let values = list(stated, "values")?;
        let ends = [stated.float("wavelength_min")?, stated.float("wavelength_max")?];
        let [Some(first), Some(last)] = ends else {
            return Err(stated.refusal(
                "the spectrum has no wavelength_min or no wavelength_max",
                "write both as <float>, in nm",
            ));
        };
        let step = (last - first) / (values.len().max(2) - 1) as f64;
        let pairs: Vec<[f64; 2]> =
            values.iter().enumerate().map(|(k, value)| [first + k as f64 * step, *value]).collect();
        self.means(stated, &pairs)
    }

    /// Colour of an `irregular` spectrum: values at wavelengths (nm).
    fn irregular(&mut self, stated: &'a Element) -> Result<Colour, Refusal> {
        let (wavelengths, values) = (list(stated, "wavelengths")?, list(stated, "values")?);
        if wavelengths.len() != values.len() {
            return Err(stated.refusal(
                format!("the spectrum has {} wavelengths and {} values", wavelengths.len(), values.len()),
                "write a value for each wavelength",
            ));
        }
        let pairs: Vec<[f64; 2]> = wavelengths.into_iter().zip(values).map(|(x, y)| [x, y]).collect();
        self.means(stated, &pairs)
    }

    /// The mean of the colours of a checkerboard, both of which cover half of it.
    fn checkerboard(&mut self, stated: &'a Element, depth: usize) -> Result<Colour, Refusal> {
        self.remarks.add("checkerboards are even: the mean of their two colours", stated);
        stated.property("to_uv").into_iter().for_each(Element::pass_over);
        let mut mean = [0.0; 3];
        for (name, default) in SQUARES {
            match self.inner(stated, name, depth + 1)?.unwrap_or(Colour::Known([default; 3])) {
                Colour::Known(values) => (0..3).for_each(|band| mean[band] += 0.5 * values[band]),
                unknown => return Ok(unknown),
            }
        }
        Ok(Colour::Known(mean))
    }
}

/// The numbers of a property that is a text.
fn list(stated: &Element, name: &str) -> Result<Vec<f64>, Refusal> {
    match stated.property(name) {
        Some(property) => property.numbers("value"),
        None => {
            let cure = format!("write <string name=\"{name}\" value=\"…\"/> in it");
            Err(stated.refusal(format!("the spectrum has no {name}"), cure))
        }
    }
}

/// Red, green and blue: three numbers, one for all, or `#rrggbb`, which is coded as sRGB.
fn rgb(stated: &Element, is_coded: bool) -> Result<[f64; 3], Refusal> {
    let value = stated.required("value")?.trim();
    if words(value).count() == 1
        && let Some(digits) = value.strip_prefix('#')
    {
        let is_right = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        let code = u32::from_str_radix(digits, 16).ok().filter(|_| is_right).ok_or_else(|| {
            stated.refusal(format!("'{}' is no colour", short(value)), "write six digits: #rrggbb")
        })?;
        return Ok([16, 8, 0].map(|shift| colour::of_srgb(f64::from((code >> shift) & 0xff) / 255.0)));
    }
    let values = stated.triple("value")?;
    Ok(if is_coded { values.map(colour::of_srgb) } else { values })
}
