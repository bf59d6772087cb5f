//! Patterns as typed → valid ones, with the numbers of their pictures.

use radiosity_formats::{
    colour::luminance,
    picture::{self, Coding, Picture},
};
use radiosity_scene::{
    Fault, FaultKind, Pattern, Polynomial, Source, Term, error::Located, place::At, ranges::check_number,
};

use crate::{
    file::{EachBand, PatternFile, PatternKind, PerBand},
    include,
};

/// Most texels of a picture that are kept, 2048 × 2048: larger ones are averaged. 32 MB for each band.
const MOST_KEPT: usize = 1 << 22;

/// The pattern of a table for so many bands; its numbers are in no range yet.
pub(super) fn pattern(file: &PatternFile, bands: usize, source: &Source) -> Result<Pattern, Located> {
    let factor = factors(&file.factor, bands)?;
    let at_table = |fault| Located::at(&file.span, fault);
    match file.kind()? {
        PatternKind::Polynomial(terms) => {
            let terms = spread(terms, bands, "the polynomial").map_err(at_table)?;
            let scaled = |(terms, factor): (&Vec<Term>, f64)| Polynomial::new(terms.clone()).times(factor);
            Ok(Pattern::polynomial(terms.into_iter().zip(factor).map(scaled).collect()))
        }
        PatternKind::Cells(cells) => {
            let cells = spread(cells, bands, "the list of cells").map_err(at_table)?;
            let columns = cells[0][0].len();
            let scaled = |(rows, factor): (&Vec<Vec<At<f64>>>, f64)| {
                rows.iter().rev().flatten().map(|cell| factor * cell.value).collect()
            };
            let values = cells.into_iter().zip(factor).map(scaled).collect();
            Pattern::texels(columns, values, file.placement()).map_err(at_table)
        }
        PatternKind::Image(path) => {
            let at_path = |fault| Located::at(&path.span, fault);
            let file_path = include::beside(source.origin_at(path.span.start), &path.value);
            let picture = read(&file_path, file.encoding, source).map_err(at_path)?;
            let (channels, remark) = channels(&picture, bands, &file_path).map_err(at_path)?;
            let values = channels.into_iter().zip(factor).map(|(channel, factor)| {
                let rows = channel.chunks_exact(picture.columns).rev();
                rows.flatten().map(|value| factor * value).collect()
            });
            let pattern =
                Pattern::texels(picture.columns, values.collect(), file.placement()).map_err(at_table)?;
            let remarks = picture.remarks.iter().cloned().chain(remark.map(str::to_owned)).collect();
            Ok(pattern.of_file(&file_path, remarks))
        }
    }
}

fn read(path: &str, coding: Option<Coding>, source: &Source) -> Result<Picture, Fault> {
    let bytes = source.picture(path).ok_or_else(|| include::no_files(path))?;
    let read = picture::read(&bytes, coding, MOST_KEPT);
    read.map_err(|fault| source.shown(path, bad_picture(path, &fault.cause, &fault.cure)))
}

/// A picture that cannot be taken for a pattern.
fn bad_picture(path: &str, cause: &str, cure: &str) -> Fault {
    Fault::new(FaultKind::Foreign, format!("{path:?}: {cause}"), cure)
}

/// The numbers of each band: red, green and blue of three, the luminance of one (ITU-R BT.709), grey of any;
/// and what is told of it.
fn channels(
    picture: &Picture,
    bands: usize,
    path: &str,
) -> Result<(Vec<Vec<f64>>, Option<&'static str>), Fault> {
    match (&picture.channels[..], bands) {
        ([grey], _) => Ok((vec![grey.clone(); bands], None)),
        ([_, _, _], 3) => Ok((picture.channels.clone(), None)),
        ([red, green, blue], 1) => {
            let texels = red.iter().zip(green).zip(blue);
            let grey = texels.map(|((red, green), blue)| luminance([*red, *green, *blue])).collect();
            Ok((vec![grey], Some("luminance of its colours")))
        }
        _ => Err(bad_picture(
            path,
            &format!("it is coloured, and there are {bands} bands"),
            "give the scene one band, or three for red, green and blue; or take a grey picture, with a factor for each \
             band",
        )),
    }
}

/// A finite factor for each band.
fn factors(factor: &PerBand, bands: usize) -> Result<Vec<f64>, Located> {
    let check = |number: &At<f64>| match check_number(number.value) {
        Ok(()) if number.value >= 0.0 => Ok(number.value),
        Ok(()) => {
            Err(Located::at(&number.span, Fault::out_of_range("the factor", number.value, "factor ≥ 0")))
        }
        Err(fault) => Err(Located::at(&number.span, fault)),
    };
    match factor {
        PerBand::All(number) => Ok(vec![check(number)?; bands]),
        PerBand::Each(list) => {
            let numbers = list.value.iter().map(check).collect::<Result<Vec<_>, _>>()?;
            check_bands("the factor", numbers.len(), bands)
                .map_err(|fault| Located::at(&list.span, fault))?;
            Ok(numbers)
        }
    }
}

/// Values of all bands: one value repeated, or a list with one per band.
fn spread<'a, T>(given: &'a EachBand<T>, bands: usize, what: &'static str) -> Result<Vec<&'a T>, Fault> {
    match given {
        EachBand::All(one) => Ok(vec![one; bands]),
        EachBand::Each(list) => {
            check_bands(what, list.len(), bands)?;
            Ok(list.iter().collect())
        }
    }
}

fn check_bands(what: &'static str, found: usize, bands: usize) -> Result<(), Fault> {
    match found == bands {
        true => Ok(()),
        false => {
            let expected = format!("one for all bands or {bands}, one per band");
            Err(Fault::wrong_count(what, &expected, found))
        }
    }
}
