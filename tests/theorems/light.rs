//! Evidence for light behind things: visibility, direct light, what is gathered, the Cornell box against path
//! tracing.

mod by_rays;
mod penumbrae;
mod pictures;
mod closure;
mod cornell;
mod curved_bodies;
mod edges;
mod curved_shadows;
mod films;
mod footprints;
mod gather;
mod groups;
mod hard_cases;
mod lightmaps;
mod luminaires;
mod luminous_areas;
mod luminous_lines;
mod masks;
mod models;
mod occlusion;
mod shapes;
mod skies;
mod slits;
mod split;
mod tables;
