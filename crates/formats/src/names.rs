//! Names that no two surfaces of a model share.

use std::collections::HashMap;

/// Makes names unique: the second `desk` becomes `desk-2`.
#[derive(Debug, Default)]
pub struct UniqueNames {
    /// Number that was last tried behind each name.
    used: HashMap<String, usize>,
}

impl UniqueNames {
    /// `wanted`, or `wanted-2`, `wanted-3`, … if it is taken; blank names become `surface`.
    pub fn take(&mut self, wanted: &str) -> String {
        let wanted = if wanted.trim().is_empty() { "surface" } else { wanted.trim() };
        let mut number = self.used.get(wanted).copied().unwrap_or(0) + 1;
        let mut name = if number == 1 { wanted.to_owned() } else { format!("{wanted}-{number}") };
        while self.used.contains_key(&name) {
            number += 1;
            name = format!("{wanted}-{number}");
        }
        self.used.insert(wanted.to_owned(), number);
        self.used.entry(name.clone()).or_insert(1);
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_comes_twice() {
        let mut names = UniqueNames::default();
        let made: Vec<String> = ["desk", "desk-2", "desk", "desk", " ", "surface", "desk-2"]
            .iter()
            .map(|x| names.take(x))
            .collect();
        assert_eq!(made, ["desk", "desk-2", "desk-3", "desk-4", "surface", "surface-2", "desk-2-2"]);
    }
}
