//! Names of the two sides of a sheet.

/// Ending of the name of a back, behind that of its front.
const BACK: &str = ":back";

/// The name of the back of the surface `front`.
pub fn back_of(front: &str) -> String {
    format!("{front}{BACK}")
}

/// The name of the front of a surface that is named as a back.
pub fn front_of(back: &str) -> Option<&str> {
    back.strip_suffix(BACK)
}

/// Whether one surface is named the back of the other: both are sides of one sheet.
pub fn are_sides_of_one([one, other]: [&str; 2]) -> bool {
    front_of(one) == Some(other) || front_of(other) == Some(one)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn backs_are_named_after_their_fronts() {
        assert_eq!((back_of("a").as_str(), front_of("a:back"), front_of("a")), ("a:back", Some("a"), None));
        assert!(are_sides_of_one(["a", "a:back"]) && are_sides_of_one(["a:back", "a"]));
        assert!(!are_sides_of_one(["a", "a"]));
    }
}
