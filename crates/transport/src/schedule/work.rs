//! Costs of the blocks of a scene, and shares of ranks in them.

use radiosity_elements::Elements;
use radiosity_kernel::blocks::held::Held;
use radiosity_kernel::{Accuracy, blocks::block::Account};
use radiosity_visibility::Visibility;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;

pub use crate::schedule::balance::Cost;
use crate::schedule::balance::{Balance, Piece, rounds};
use crate::schedule::demand::{Demand, Unreached};
use crate::schedule::task::Scene;

/// The work that a block was.
#[derive(Clone, Copy, Debug)]
pub struct BlockWork {
    piece: Piece,
    account: Account,
}

impl BlockWork {
    /// The cost of the block.
    pub fn cost(&self) -> Cost {
        Cost::of(&self.account)
    }
}

/// Integrates the blocks of all pairs of which at least one element `sends` light, and tells what each of
/// them cost.
pub fn work(
    elements: &Elements,
    sends: &(dyn Fn(usize) -> bool + Sync),
    visibility: &Visibility,
    accuracy: Accuracy,
) -> Vec<BlockWork> {
    let wanted = |a: usize, b: usize| sends(a) || sends(b);
    let unreached = Unreached::of(visibility);
    let scene = Scene::new(Demand { elements, wanted: &wanted, visibility, accuracy, unreached });
    let (tasks, _) = scene.sort(Ranks::alone());
    let goals = scene.goals(&tasks);
    let sources = scene.share(&tasks, &goals);
    let held = Held::of(Ranks::alone(), &elements.starts());
    let integrated = scene.integrate(&tasks, &goals, &sources, None, &held, &Work::alone());
    let pieces = scene.pieces(&tasks, &sources).into_iter().enumerate();
    pieces.map(|(place, piece)| BlockWork { piece, account: integrated.told(place).block }).collect()
}

/// Cost of the blocks of each of so many ranks that share this work, round by round: ranks wait for each
/// other between rounds.
pub fn shared(work: &[BlockWork], ranks: usize) -> Vec<Vec<Cost>> {
    let pieces: Vec<Piece> = work.iter().map(|work| work.piece).collect();
    let mut balance = Balance::new(ranks);
    let round = |round: Vec<usize>| {
        let mut done = vec![Cost::default(); ranks];
        let makers = balance.share(&round, &pieces);
        for (place, maker) in round.into_iter().zip(makers) {
            balance.take(maker, &pieces[place], &work[place].account);
            done[maker] += work[place].cost();
        }
        done
    };
    rounds(pieces.len(), ranks).into_iter().map(round).collect()
}
