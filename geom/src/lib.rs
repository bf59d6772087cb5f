//! Curved parametric surfaces used as they are: jets, ray hits, contacts.
