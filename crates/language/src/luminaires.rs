//! Luminaires as typed → valid ones, and the surfaces of those that are areas.

use std::{collections::BTreeMap, sync::Arc};

use radiosity_photometry::{Photometry, luminaire as photometry};
use radiosity_scene::{
    Distribution, Extent, Fault, Luminaire, Source, Strength, SurfaceDraft,
    error::{Located, title},
    luminaire::check_intensity,
    luminous_surface::luminous_surfaces,
    material::check_flux,
    names::UniqueNames,
    place::At,
    surface_draft::DraftPlaces,
};

use crate::{
    file::{ExtentFile, LuminaireFile, PerBand},
    include,
    instances::PlacedLuminaire,
    validation::spread,
};

/// Every luminaire, each of a name of its own, and the surfaces of those that are areas.
pub(super) fn luminaires(
    files: &[PlacedLuminaire<'_>],
    bands: usize,
    source: &Source,
) -> Result<(Vec<Luminaire>, Vec<SurfaceDraft>), Located> {
    let mut names = UniqueNames::default();
    let mut tables = Tables { source, known: BTreeMap::new() };
    let mut luminaire = |placed: &PlacedLuminaire<'_>| {
        let span = &placed.file.name.span;
        let added = names.add(&placed.name, source.line(span.start));
        let own = added.map_err(|fault| Located::at(span, fault));
        let own = own.and_then(|()| luminaire(placed, bands, &mut tables));
        own.map_err(|error| error.within(|| title("luminaire", &placed.name)))
    };
    let own = files.iter().map(&mut luminaire).collect::<Result<Vec<_>, _>>()?;
    let surfaces = own.iter().zip(files);
    let surfaces = surfaces.map(|(own, placed)| luminous_surfaces(own, || Some(typed(placed.file, source))));
    let surfaces = surfaces.collect::<Result<Vec<_>, _>>()?;
    Ok((own, surfaces.into_iter().flatten().collect()))
}

/// Places in the text of the surface that a luminaire's extent makes.
fn typed(LuminaireFile { name, span, extent, .. }: &LuminaireFile, source: &Source) -> DraftPlaces {
    DraftPlaces {
        place: source.place(span),
        name: name.span.clone(),
        name_line: source.line(name.span.start),
        shape: extent.as_ref().map_or(span, |extent| &extent.span).clone(),
        materials: [None, None],
        flux: None,
        opening: None,
    }
}

fn luminaire(
    PlacedLuminaire { file, name, motion, .. }: &PlacedLuminaire<'_>,
    bands: usize,
    tables: &mut Tables<'_>,
) -> Result<Luminaire, Located> {
    let LuminaireFile { span, position, aim, along, extent, group, dimming, .. } = file;
    let numbers = file.strength().map_or(span, PerBand::span);
    let strength = strength(file, bands)?;
    let distribution = match (&file.spot, &file.photometry) {
        (Some(spot), _) => spot.clone(),
        (None, Some(file)) => Distribution::Table(tables.named(file)?),
        (None, None) => Distribution::Point,
    };
    let own = Luminaire::new(name, *position, distribution, strength);
    let mut own = own.map_err(|fault| Located::at(numbers, fault))?;
    if let Some(extent) = extent {
        let known = extent_of(extent.value, &own.distribution).and_then(|known| own.of_extent(known));
        own = known.map_err(|fault| Located::at(&extent.span, fault))?;
    }
    if let Some(aim) = aim {
        own = own.aimed(aim.value).map_err(|fault| Located::at(&aim.span, fault))?;
    }
    if let Some(along) = along {
        own = own.turned(along.value).map_err(|fault| Located::at(&along.span, fault))?;
    }
    if let Some(dimming) = dimming {
        own = own.at_factor(dimming.value).map_err(|fault| Located::at(&dimming.span, fault))?;
    }
    if let Some(group) = group {
        own = own.in_group(&group.value).map_err(|fault| Located::at(&group.span, fault))?;
    }
    let mut own = own.moved(motion);
    own.place = tables.source.place(span);
    Ok(own)
}

/// Flux or intensity of a luminaire per band.
fn strength(file: &LuminaireFile, bands: usize) -> Result<Strength, Located> {
    match (&file.flux, &file.intensity) {
        (Some(flux), _) => Ok(Strength::Flux(spread(flux, bands, "the flux", check_flux)?)),
        (None, Some(intensity)) => {
            Ok(Strength::Intensity(spread(intensity, bands, "the intensity", check_intensity)?))
        }
        (None, None) => Ok(Strength::AsMeasured(bands)),
    }
}

/// Extent that the light of a luminaire comes out of: typed, or the opening of its photometric file.
fn extent_of(file: ExtentFile, distribution: &Distribution) -> Result<Extent, Fault> {
    match (file, distribution) {
        (ExtentFile::Typed(extent), _) => Ok(extent),
        (ExtentFile::OfTable, Distribution::Table(table)) => Extent::of_opening(&table.opening),
        (ExtentFile::OfTable, _) => Err(Fault::bad_extent(
            "there is no photometric file",
            "give its sides, e.g. extent = [1.2, 0.3], or its diameter, e.g. extent = 0.2",
        )),
    }
}

/// The photometric files of a scene, each read once.
struct Tables<'a> {
    source: &'a Source,
    known: BTreeMap<String, Arc<Photometry>>,
}

impl Tables<'_> {
    /// The table in the file of that name.
    fn named(&mut self, name: &At<String>) -> Result<Arc<Photometry>, Located> {
        let path = include::beside(self.source.origin_at(name.span.start), &name.value);
        if let Some(known) = self.known.get(&path) {
            return Ok(Arc::clone(known));
        }
        let text = self.source.included_text(&path);
        let (text, _) = text.ok_or_else(|| Located::at(&name.span, include::no_files(&path)))?;
        let table = photometry::read(&path, text.as_bytes())
            .map_err(|refusal| Fault::foreign(refusal.to_string(), refusal.cure))
            .map_err(|fault| Located::at(&name.span, self.source.shown(&path, fault)))?;
        let table = Arc::new(table);
        self.known.insert(path, Arc::clone(&table));
        Ok(table)
    }
}
