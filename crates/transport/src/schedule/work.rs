//! Costs of the blocks of a scene, and shares of ranks in them.

use radiosity_elements::Elements;
use radiosity_kernel::blocks::held::Held;
use radiosity_kernel::{Accuracy, blocks::block::Account};
use radiosity_visibility::Visibility;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;

pub use crate::schedule::balance::cost;
use crate::schedule::balance::{Balance, Piece, rounds};
use crate::schedule::task::{Scene, Unreached};

/// The work that a block was.
#[derive(Clone, Copy, Debug)]
pub struct BlockWork {
    piece: Piece,
    account: Account,
}

impl BlockWork {
    /// Terms of its rules.
    pub fn samples(&self) -> u64 {
        self.account.samples
    }

    /// Segments tested for visibility.
    pub fn rays(&self) -> u64 {
        self.account.rays
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
    let unreached = if visibility.casts() { Unreached::Left } else { Unreached::Kept };
    let scene = Scene::new(elements, visibility, &wanted, accuracy, unreached);
    let (tasks, _) = scene.sort(Ranks::alone());
    let goals = scene.goals(&tasks);
    let sources = scene.share(&tasks, &goals);
    let held = Held::of(Ranks::alone(), &elements.starts());
    let integrated = scene.integrate(&tasks, &goals, &sources, (None, &held), &Work::alone());
    let pieces = scene.pieces(&tasks, &sources).into_iter().enumerate();
    pieces.map(|(place, piece)| BlockWork { piece, account: integrated.told(place).block }).collect()
}

/// Kernel samples and rays of each of so many ranks that share this work, round by round: ranks wait for each
/// other between rounds.
pub fn shared(work: &[BlockWork], ranks: usize) -> Vec<Vec<[u64; 2]>> {
    let pieces: Vec<Piece> = work.iter().map(|work| work.piece).collect();
    let mut balance = Balance::new(ranks);
    let round = |round: Vec<usize>| {
        let mut done = vec![[0; 2]; ranks];
        let makers = balance.share(&round, &pieces);
        for (place, maker) in round.into_iter().zip(makers) {
            balance.take(maker, &pieces[place], &work[place].account);
            done[maker][0] += work[place].samples();
            done[maker][1] += work[place].rays();
        }
        done
    };
    rounds(pieces.len(), ranks).into_iter().map(round).collect()
}
