//! View3D inputs, Mitsuba scenes, luminaires and side files of materials: right, odd and broken ones.

mod vs3;
mod mitsuba;
mod photometry;
