//! Surfaces from which heat gets to no known temperature and not out of the scene.
//!
//! A walk that reflects all ends nowhere else. Rays from surfaces of unknown temperature tell what they see:
//! those that see a known temperature or nothing are settled, and so are those that see what is
//! settled, and both sides of a sheet with either.

use std::collections::BTreeSet;

use radiosity_geom::Rect;

use crate::random::{OF_PROBES, Random};
use crate::rays::{Place, Rays};
use crate::spread::Spread;
use crate::walk::cosine_direction;

use super::roles::{Role, Roles};

/// Rays from each surface. Chosen: an opening that all of them miss takes less than a hundredth of its view,
/// and a walk would meet hundreds of walls before it.
const PROBES: usize = 512;

/// The sight of a surface, by rays.
enum Seen {
    /// Something that ends walks; or the surface exchanges nothing.
    End,
    /// These surfaces, none of which ends a walk.
    Others(BTreeSet<usize>),
}

/// The surfaces from which no walk ends.
pub(super) fn floating(rays: &Rays, roles: &Roles) -> Vec<usize> {
    let mut open: Vec<(usize, BTreeSet<usize>)> = Vec::new();
    for surface in (0..rays.count()).filter(|own| !is_known(&roles.list[*own])) {
        if let Seen::Others(mut others) = seen(rays, roles, surface) {
            if let Role::Sheet { sheet, .. } = roles.list[surface] {
                others.extend(roles.pairs[sheet].sides);
            }
            open.push((surface, others));
        }
    }
    loop {
        let unsettled: BTreeSet<usize> = open.iter().map(|(surface, _)| *surface).collect();
        open.retain(|(_, others)| others.is_subset(&unsettled));
        if open.len() == unsettled.len() {
            return unsettled.into_iter().collect();
        }
    }
}

fn is_known(role: &Role) -> bool {
    matches!(role, Role::Temperature { .. })
}

/// The sight of a surface from its bare points, up to the first ray that ends a walk.
fn seen(rays: &Rays, roles: &Roles, surface: usize) -> Seen {
    let spread = Spread::over(rays.shape(surface), Rect::FULL);
    let mut random = Random::of(&[surface as u64, OF_PROBES]);
    let mut pair = || [random.next(), random.next()];
    let mut others = BTreeSet::new();
    for _ in 0..PROBES {
        let Some(on) = spread.point(pair()) else { continue };
        let along = cosine_direction(on.normal, pair());
        let place = Place::on(surface, &on);
        if !rays.is_bare(&place) {
            continue;
        }
        match rays.first(rays.left(&place, on.normal), along) {
            Some(place) if !is_known(&roles.list[place.surface]) => _ = others.insert(place.surface),
            _ => return Seen::End,
        }
    }
    if others.is_empty() { Seen::End } else { Seen::Others(others) }
}
