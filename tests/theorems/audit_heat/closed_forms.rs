//! View factors of `tests/data/view_factors.json`: 45 closed forms, from contacts to small squares.

use radiosity::Work;
use radiosity::audit::{Effort, Mean, ViewFactorReferee};
use radiosity_test_support::data::{list, number, table};
use radiosity_test_support::scenes::typed;
use serde_json::{Value, json};

use super::scored::{SEEN, Scored, apart};

/// The surfaces of a scene of the table, named by their numbers, as a scene file.
fn text(scene: &Value) -> String {
    let named = |(index, surface): (usize, &Value)| {
        let mut surface = surface.clone();
        surface["name"] = json!(format!("s{index}"));
        surface
    };
    let surfaces: Vec<Value> = list(&scene["surfaces"]).iter().enumerate().map(named).collect();
    json!({ "surfaces": surfaces }).to_string()
}

/// Sums of relative differences from what is exact.
#[derive(Default)]
struct Together {
    count: f64,
    sum: f64,
    variance: f64,
}

impl Together {
    fn add(&mut self, mean: &Mean, exact: f64) {
        self.count += 1.0;
        self.sum += mean.value / exact - 1.0;
        self.variance += (mean.error / exact).powi(2);
    }

    fn mean(&self) -> Mean {
        Mean { value: self.sum / self.count, error: self.variance.sqrt() / self.count }
    }
}

#[test]
fn rays_find_what_has_a_closed_form() {
    let mut scored = Scored::default();
    let mut together = Together::default();
    let data = table("view_factors.json");
    for scene in list(&data["scenes"]) {
        let referee = ViewFactorReferee::of(&typed(&text(scene)));
        for row in list(&scene["factors"]) {
            let [from, to] = [1, 2].map(|k| number(&row[k]) as usize);
            let (id, exact) = (row[0].to_string(), number(&row[3]));
            for seed in 0..8 {
                let effort = Effort::of_walks(8192.0).seeded(seed);
                let found = referee.rows(&[from], &effort, &Work::alone())[0].to(to);
                scored.add(&id, &found, exact);
                together.add(&found, exact);
            }
        }
    }
    scored.check(300);
    // All rows right or all a hundredth too large: the mean of relative differences tells.
    let mean = together.mean();
    assert!(apart(&mean, 0.0) < SEEN, "{mean:?}");
    assert!(apart(&mean, 0.01) > SEEN, "{mean:?}");
}
