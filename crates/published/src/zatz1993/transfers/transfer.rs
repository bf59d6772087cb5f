//! The transfer between two pieces: the sides that the rule takes, and their sum.

use radiosity_kernel::PairKind;

use super::contact::{Contact, common_side};
use super::piece::Piece;
use super::rules::{HybridReading, PaperRules};
use super::side::Side;
use super::sum::Sum;

/// A piece with its sides where it has no edge in common with the other one.
#[derive(Clone, Debug)]
pub(super) struct Tile<'a> {
    /// The piece.
    pub piece: Piece<'a>,
    receiving: Side,
    sending: Side,
    /// One point more in each direction, so that the points of an element with itself never coincide, where κ
    /// is 0/0.
    sending_to_itself: Option<Side>,
}

/// A rule with its number of points per direction above the order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rule {
    pub rules: PaperRules,
    pub extra: usize,
}

impl Rule {
    fn points(self, piece: &Piece) -> usize {
        piece.element.basis.order() + self.extra
    }

    /// A piece with its sides.
    pub(super) fn tile(self, piece: Piece<'_>) -> Tile<'_> {
        let points = self.points(&piece);
        let sending_to_itself = (!piece.patch.is_flat()).then(|| Side::sending(&piece, points + 1));
        let (receiving, sending) = (Side::receiving(&piece, points), Side::sending(&piece, points));
        Tile { piece, receiving, sending, sending_to_itself }
    }

    /// Adds what a piece receives from itself.
    pub(super) fn add_own(self, sum: &mut Sum, tile: &Tile) {
        if let Some(sending) = &tile.sending_to_itself {
            sum.add(&tile.receiving, sending);
        }
    }

    /// Adds what one piece receives from another; how they touch.
    pub(super) fn add(self, sum: &mut Sum, receiver: &Tile, emitter: &Tile) -> PairKind {
        let PaperRules::Hybrid(reading) = self.rules else {
            sum.add(&receiver.receiving, &emitter.sending);
            let touches = common_side(&receiver.piece, &emitter.piece).is_some();
            return if touches { PairKind::Edge } else { PairKind::Separated };
        };
        match Contact::of(&receiver.piece, &emitter.piece) {
            Contact::None => {
                sum.add(&receiver.receiving, &emitter.sending);
                PairKind::Separated
            }
            Contact::Edge(edge) => {
                self.add_edge(sum, &edge, reading);
                PairKind::Edge
            }
            Contact::Cut([receivers, emitters]) => {
                for (p, q) in receivers.iter().flat_map(|p| emitters.iter().map(move |q| (p, q))) {
                    self.add_parts(sum, p, q, reading);
                }
                PairKind::Contact
            }
        }
    }

    fn add_edge(self, sum: &mut Sum, [p, q]: &[Piece; 2], reading: HybridReading) {
        let receiving = Side::receiving_at_edge(p, self.points(p), reading);
        sum.add(&receiving, &Side::sending_at_edge(q, self.points(q), reading));
    }

    fn add_parts(self, sum: &mut Sum, p: &Piece, q: &Piece, reading: HybridReading) {
        match common_side(p, q) {
            Some(edge) => self.add_edge(sum, &edge, reading),
            None => sum.add(&Side::receiving(p, self.points(p)), &Side::sending(q, self.points(q))),
        }
    }
}
