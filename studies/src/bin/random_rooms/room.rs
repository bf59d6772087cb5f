//! A random room.

use glam::DVec3;

use crate::draft::Draft;
use crate::{lights, shell, things};
use radiosity_test_support::random::Random;

/// Draws one.
pub(crate) fn draw(random: &mut Random) -> Draft {
    let mut draft = Draft::default();
    let size = DVec3::new(random.between(3.0, 7.0), random.between(3.0, 7.0), random.between(2.4, 3.4));
    shell::draw(&mut draft, random, size);
    let has_window = draft.kinds().contains("window");
    if !has_window || random.unit() < 0.3 {
        lights::draw(&mut draft, random, size);
    }
    things::draw(&mut draft, random, size);
    draft
}
