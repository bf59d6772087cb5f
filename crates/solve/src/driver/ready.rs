//! A scene ready for blocks: its elements, its visibility and its first light.

use std::time::Duration;

use radiosity_scene::Scene;
use radiosity_solvers::method::Access;
use radiosity_transport::Demand;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Progress, Stage, Work};

use super::column_choice::ColumnChoice;
use super::cut_scene::CutScene;
use super::decisions::AssemblyPlan;
use super::direct_price::seconds_of_direct;
use super::emission::Emission;
use super::failure::Failure;
use super::first_light::{EnteringLight, FirstLight, LitScene};
use super::kept_model::KeptModel;
use super::light_method::LightMethod;
use super::options::Options;
use super::outcome::timed;
use super::shooting::Shooter;
use crate::geometry::AssemblyGeometry;

/// A scene ready for blocks.
#[derive(Debug)]
pub(super) struct Ready {
    pub cut: CutScene,
    /// Direct light and its first bounce, for the emission of the scene.
    pub first: FirstLight,
}

impl Ready {
    /// The elements of `scene`, its visibility and first light.
    ///
    /// # Errors
    /// A scene that cannot be cut into elements, or memory that does not suffice.
    pub(super) fn of(
        scene: &Scene,
        options: &Options,
        plan: AssemblyPlan<'_>,
        before: Option<&KeptModel>,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        let mut cut = CutScene::of(scene, options, plan, before, work)?;
        let CutScene { elements, choice, rays, .. } = &cut;
        let wanted = |a, b| cut.sends(a) || cut.sends(b);
        let geometry = AssemblyGeometry { scene, elements, wanted: &wanted };
        // The choice may depend on time or memory, which no fingerprint holds.
        work.ranks.note_assembly(&(options.of_transfers(), choice.sampled, *rays, geometry));
        let light = || {
            let (emissions, lit_scene) = (cut.emissions(), cut.lit_scene(work.ranks));
            let way = cut.direct_way(&emissions);
            // Of scenes that follow the first one nobody asks how long they take.
            if before.is_none_or(|kept| kept.blocks.elements().is_none()) {
                let seconds = seconds_of_direct(&lit_scene, &emissions, way);
                work.report(Progress::Expected { stage: Stage::Direct, seconds });
            }
            FirstLight::by(&lit_scene, emissions, way)
        };
        let mut took = Duration::ZERO;
        let light = || work.during(Stage::Direct, light);
        let first = timed(&mut took, light);
        cut.seconds.direct = took;
        Ok(Self { cut, first })
    }

    /// The first light of each emission: that of the scene it was assembled from, if it emits as much. With a
    /// subspace, light that enters apart is projected on it.
    pub(super) fn first_light(
        &self,
        scene: &Scene,
        emissions: &[Emission],
        ranks: &Ranks,
    ) -> Vec<EnteringLight> {
        let first = self.first.reflected(emissions).unwrap_or_else(|| {
            let lit_scene = self.lit_scene(scene, ranks);
            let anew = Emission::all(scene, self.cut.elements.list());
            let first = self.first.anew(&lit_scene, anew);
            first.reflected(emissions).expect("the emission is the same")
        });
        match &self.cut.subspace {
            None => first,
            Some(subspace) => first.into_iter().map(|own| own.within(subspace)).collect(),
        }
    }

    /// A scene of these surfaces, as direct light is computed from it.
    pub(super) fn lit_scene<'a>(&'a self, scene: &'a Scene, ranks: &'a Ranks) -> LitScene<'a> {
        LitScene { scene, ..self.cut.lit_scene(ranks) }
    }

    /// The shooter of the light of a scene of these surfaces.
    pub(super) fn shooter<'a>(
        &'a self,
        scene: &'a Scene,
        emissions: &'a [Emission],
        first: &'a [EnteringLight],
    ) -> Shooter<'a> {
        let elements = self.cut.elements.list();
        Shooter { names: &scene.bands, elements, emissions, first, options: &self.cut.options }
    }

    /// Why all columns have to be integrated before the first shot of a solver that shoots, if they have to.
    pub(super) fn all_first(&self, ranks: &Ranks) -> Option<&'static str> {
        let CutScene { options, choice, subspace, .. } = &self.cut;
        Some(match options {
            _ if choice.sampled => "rays carry the light",
            Options { kernel: Some(_), .. } => "the rules of 1993 make the whole matrix",
            Options { method: LightMethod::Collocation, .. } => "collocation makes whole rows",
            _ if subspace.is_some() => "functions of the basis reach over elements",
            _ if !ranks.are_alone() => "several processes share the blocks",
            _ if ranks.journal().is_some() => "blocks are kept in a file",
            _ if self.first.is_reflected() => "masks of what emitters reflect take the light of all",
            Options { columns: Some(ColumnChoice::All), .. } => "that was asked for",
            _ => return None,
        })
    }

    /// Whether the light is shot, each column integrated when it is first shot.
    ///
    /// # Errors
    /// [`Failure::AllFirst`] where that is asked for and cannot be.
    pub(super) fn is_lazy(&self, ranks: &Ranks) -> Result<bool, Failure> {
        let Options { solver, bounces, columns, .. } = self.cut.options;
        let shoots = solver.access == Access::Columns && bounces.is_none();
        match self.all_first(ranks) {
            Some(why) if shoots && columns == Some(ColumnChoice::Shot) => Err(Failure::AllFirst { why }),
            all_first => Ok(shoots && all_first.is_none()),
        }
    }

    /// The pairs of which an element is `wanted` that sends light.
    pub(super) fn demand<'a>(&'a self, wanted: &'a (dyn Fn(usize, usize) -> bool + Sync)) -> Demand<'a> {
        let CutScene { elements, visibility, options, .. } = &self.cut;
        Demand::all(elements, visibility, options.accuracy()).of(wanted)
    }
}
