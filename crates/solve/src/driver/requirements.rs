//! Requirements of methods on the scenes that they light.

use radiosity_scene::{MaskedPair, Scene, SceneSurface};
use radiosity_work::wording::{option, set};

use super::direct::Direct;
use super::failure::Failure;
use super::options::Options;
use super::outline::Outline;

/// Refuses what cannot carry the light of luminaires or of a sky.
pub(super) fn require_diffuse(scene: &Scene, options: &Options) -> Result<(), Failure> {
    require_even(scene, options)?;
    let shines = scene.luminaires.iter().find(|own| own.emits()).filter(|_| options.masks.is_some());
    if let Some(own) = shines {
        return Err(Failure::Unmasked { luminaire: own.name.clone() });
    }
    let is_frame = scene.source.as_ref().is_some_and(|own| own.moment.is_some());
    if options.masks.is_some() && !is_frame {
        scene.masks.iter().try_for_each(|pair| require_light_between(scene, pair))?;
    }
    let what = match options {
        Options { masks: Some(_), .. } => set("shadows", "mask"),
        Options { direct: Direct::Projected, .. } => set("direct", "projected"),
        Options { kernel: Some(_), .. } => option("kernel") + " with the rules of 1993",
        _ => return Ok(()),
    };
    match scene.surfaces.iter().find(|own| own.radiance.is_some()) {
        Some(own) => {
            let light = if own.is_opening() { "an opening to a sky" } else { "a luminaire" };
            Err(Failure::NotDiffuse { surface: own.name.clone(), light, what })
        }
        None => Ok(()),
    }
}

/// Refuses a pair that was chosen for a mask and that no light goes between.
fn require_light_between(scene: &Scene, pair: &MaskedPair) -> Result<(), Failure> {
    let refused = |why| {
        let MaskedPair { emitter, receiver, .. } = pair;
        Err(Failure::NoMask { emitter: emitter.clone(), receiver: receiver.clone(), why })
    };
    let sending = pair.emitters.iter().copied().filter(|own| scene.surfaces[*own].material.sends());
    let sending: Vec<usize> = sending.collect();
    if sending.is_empty() {
        return refused("the emitter sends no light, it neither emits nor reflects");
    }
    let outlines = |list: &[usize]| list.iter().map(|own| Outline::of(&scene.surfaces[*own])).collect();
    let [emitters, receivers]: [Vec<Outline>; 2] = [&sending, &pair.receivers].map(|list| outlines(list));
    let receives = |emitter: &Outline| receivers.iter().any(|own| own.exchanges_with(emitter));
    match emitters.iter().any(receives) {
        true => Ok(()),
        false => refused("their fronts do not see each other"),
    }
}

/// Refuses functions over several elements where S does not commute with their projection: power would be
/// lost.
fn require_even(scene: &Scene, options: &Options) -> Result<(), Failure> {
    let basis = options.basis;
    if basis.is_elementwise() {
        return Ok(());
    }
    let varies = |own: &&SceneSurface| own.material.reflectance_pattern.is_some() || own.material.transmits();
    match scene.surfaces.iter().find(varies) {
        Some(own) => Err(Failure::NotEven { surface: own.name.clone(), basis: basis.name() }),
        None => Ok(()),
    }
}
