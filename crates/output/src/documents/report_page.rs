//! The report for people: what a scene's light and heat are, how good the numbers are, and how they were
//! found.

mod light_part;
mod overview;
mod planes;
mod surfaces;
mod heat;
mod checks;
mod settings;

use radiosity_heat::{Heat, HeatError};
use radiosity_scene::Scene;

use crate::documents::document::{Block, Document, Figure};
pub use light_part::{LightPart, PICTURE, ReportedPlane, plan_name};
use radiosity_reading::quantity::Quantity;

/// Content of a scene's report.
#[derive(Clone, Debug)]
pub struct ReportPage<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its light; none where nothing shines.
    pub light: Option<LightPart<'a>>,
    /// Its heat, where surfaces have thermal conditions, or why there is no balance.
    pub heat: Option<Result<&'a Heat, &'a HeatError>>,
    /// The command that makes the report again.
    pub command: &'a str,
}

impl ReportPage<'_> {
    /// The report as a document.
    pub fn document(&self) -> Document {
        let mut blocks = overview::blocks(self.scene, self.light.as_ref(), self.heat);
        if let Some(light) = &self.light {
            blocks.extend(picture(self.scene, light));
            blocks.extend(planes::blocks(self.scene, light));
            blocks.extend(surfaces::blocks(self.scene, light));
        }
        blocks.extend(self.heat.iter().flat_map(|heat| heat::blocks(*heat)));
        if let Some(light) = &self.light {
            blocks.extend(checks::blocks(self.scene, light));
        }
        blocks.extend(settings::blocks(self.scene, self.light.as_ref(), self.command));
        Document { title: self.title().to_owned(), subtitle: self.subtitle(), blocks }
    }

    fn title(&self) -> &str {
        self.scene.title.as_deref().unwrap_or(&self.scene.name)
    }

    fn subtitle(&self) -> String {
        let Scene { name, bands, unit, surfaces, .. } = self.scene;
        let light = self.light.as_ref().map(|_| {
            let bands =
                if bands.len() == 1 { String::new() } else { format!(" in the bands {}", bands.join(", ")) };
            format!(" · {} in {unit}{bands}", Quantity::Irradiance.name(unit))
        });
        let version = env!("CARGO_PKG_VERSION");
        format!(
            "Scene {name} · {} surfaces{} · radiosity {version}",
            surfaces.len(),
            light.unwrap_or_default()
        )
    }
}

fn picture(scene: &Scene, light: &LightPart) -> Vec<Block> {
    let shown = match &light.picture {
        Some(picture) => Block::Figure(Figure {
            name: PICTURE.to_owned(),
            picture: picture.clone(),
            alternative: format!("The scene {} through its camera", scene.name),
            caption: "Through the scene's camera, at automatic exposure.".to_owned(),
        }),
        None => Block::Text(
            "The scene has no camera, so there is no picture: [camera] with eye and target adds one."
                .to_owned(),
        ),
    };
    vec![Block::Heading("Picture".to_owned()), shown]
}
