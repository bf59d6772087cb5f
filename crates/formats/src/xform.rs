//! Transforms: similarities, and the words that MGF and Radiance write them with.
//!
//! Sources: MGF 2.0, "Hierarchical Contexts and Transformations"; Radiance, manual page `xform(1)`. Both
//! share one grammar: `-t x y z`, `-rx degrees` …, `-s factor`, `-mx` …, `-i n` (what follows, n times),
//! `-a n` (what follows 0, 1, …, n − 1 times, for n instances). What is written first is done first.

use glam::{DMat3, DVec3};
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::{number, short};

use crate::model::Shape;

/// Most instances that one transform makes: a tenth of the surfaces that a model may have.
const MOST_INSTANCES: usize = 100_000;

/// Sine and cosine of an angle in degrees. Those of quarter turns are exact.
pub(crate) fn sin_cos(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    match turned {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => turned.to_radians().sin_cos(),
    }
}

/// A rotation, a uniform scale, perhaps a mirror, then a translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Similarity {
    /// Rotation, scale and mirror.
    linear: DMat3,
    translation: DVec3,
    /// Factor by which lengths grow, > 0.
    scale: f64,
    is_mirror: bool,
}

impl Similarity {
    /// The transform that changes nothing.
    pub(crate) const IDENTITY: Self =
        Self { linear: DMat3::IDENTITY, translation: DVec3::ZERO, scale: 1.0, is_mirror: false };

    fn translation(translation: DVec3) -> Self {
        Self { translation, ..Self::IDENTITY }
    }

    /// A scale by `factor` ≠ 0; a negative one also inverts at the origin.
    fn scale(factor: f64) -> Self {
        Self {
            linear: DMat3::from_diagonal(DVec3::splat(factor)),
            scale: factor.abs(),
            is_mirror: factor < 0.0,
            ..Self::IDENTITY
        }
    }

    /// A mirror image along an axis, 0 to 2.
    fn mirror(axis: usize) -> Self {
        let mut signs = DVec3::ONE;
        signs[axis] = -1.0;
        Self { linear: DMat3::from_diagonal(signs), is_mirror: true, ..Self::IDENTITY }
    }

    /// A rotation about an axis, 0 to 2, counter-clockwise seen from its tip. Quarter turns are exact.
    pub(crate) fn rotation(axis: usize, degrees: f64) -> Self {
        let (sin, cos) = sin_cos(degrees);
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut linear = DMat3::IDENTITY;
        linear.col_mut(next)[next] = cos;
        linear.col_mut(next)[last] = sin;
        linear.col_mut(last)[next] = -sin;
        linear.col_mut(last)[last] = cos;
        Self { linear, ..Self::IDENTITY }
    }

    /// The composition of this transform and then `next`.
    pub(crate) fn then(&self, next: &Self) -> Self {
        Self {
            linear: next.linear * self.linear,
            translation: next.point(self.translation),
            scale: self.scale * next.scale,
            is_mirror: self.is_mirror != next.is_mirror,
        }
    }

    /// This transform, done `times` times.
    fn repeated(&self, times: u32) -> Self {
        let (mut done, mut square, mut left) = (Self::IDENTITY, *self, times);
        while left > 0 {
            if left % 2 == 1 {
                done = done.then(&square);
            }
            square = square.then(&square);
            left /= 2;
        }
        done
    }

    /// Image of a point (length).
    pub(crate) fn point(&self, point: DVec3) -> DVec3 {
        self.linear * point + self.translation
    }

    /// Image of a direction, its length scaled too.
    pub(crate) fn direction(&self, direction: DVec3) -> DVec3 {
        self.linear * direction
    }

    /// Image of a shape. A mirror image keeps the front: the side that faced outwards still does.
    pub(crate) fn shape(&self, shape: &Shape) -> Shape {
        let direction = |x| self.direction(x);
        let mut moved = shape.map(|x| self.point(x), direction, direction, |length| self.scale * length);
        if self.is_mirror {
            moved.reverse_rings();
        }
        moved
    }
}

/// A part of a transform that is done several times.
#[derive(Clone, Copy, Debug)]
struct Block {
    once: Similarity,
    times: Times,
}

#[derive(Clone, Copy, Debug)]
enum Times {
    /// So many repetitions in every instance.
    Always(u32),
    /// 0, 1, … repetitions, in so many instances.
    Array(u32),
}

/// The transforms that a list of words makes: one, or one for each instance of an array.
#[derive(Clone, Debug)]
pub(crate) struct Transforms {
    blocks: Vec<Block>,
    count: usize,
}

impl Transforms {
    /// Reads words up to the first that is no flag of a transform. Returns how many were read.
    ///
    /// # Errors
    /// A flag without its numbers, a scale of 0, an array of no or of too many instances.
    pub(crate) fn parse(words: &[&str]) -> Result<(Self, usize), Refusal> {
        let mut blocks = vec![Block { once: Similarity::IDENTITY, times: Times::Always(1) }];
        let (mut count, mut read) = (1_usize, 0);
        while let Some(flag) = words.get(read) {
            let rest = &words[read + 1..];
            if *flag == "-i" || *flag == "-a" {
                let times = repetitions(flag, rest)?;
                count = if matches!(times, Times::Array(_)) { instances(count, times)? } else { count };
                blocks.push(Block { once: Similarity::IDENTITY, times });
                read += 2;
                continue;
            }
            let Some((step, used)) = step(flag, rest)? else { break };
            if let Some(block) = blocks.last_mut() {
                block.once = block.once.then(&step);
            }
            read += 1 + used;
        }
        Ok((Self { blocks, count }, read))
    }

    /// Whether the words make an array, if only of one instance.
    pub(crate) fn is_array(&self) -> bool {
        self.blocks.iter().any(|block| matches!(block.times, Times::Array(_)))
    }

    /// Number of instances.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// The transform of instance `index`; of several arrays the last runs fastest.
    pub(crate) fn instance(&self, index: usize) -> Similarity {
        let mut left = index;
        let mut total = Similarity::IDENTITY;
        for block in self.blocks.iter().rev() {
            let times = match block.times {
                Times::Always(times) => times,
                Times::Array(count) => {
                    let own = left % count as usize;
                    left /= count as usize;
                    own as u32
                }
            };
            total = block.once.repeated(times).then(&total);
        }
        total
    }
}

/// The number behind `-i` or `-a`.
fn repetitions(flag: &str, rest: &[&str]) -> Result<Times, Refusal> {
    let word = rest.first().copied().unwrap_or("");
    match (flag, word.parse::<u32>()) {
        ("-i", Ok(times)) => Ok(Times::Always(times)),
        ("-a", Ok(count)) if count > 0 => Ok(Times::Array(count)),
        ("-a", _) => refuse(format!("-a {} makes no array", short(word)), "write a whole number from 1"),
        _ => refuse(format!("-i {} is no number of repetitions", short(word)), "write a whole number from 0"),
    }
}

/// The number of instances after a further array.
fn instances(count: usize, times: Times) -> Result<usize, Refusal> {
    let own = match times {
        Times::Array(own) => own as usize,
        Times::Always(_) => 1,
    };
    count.checked_mul(own).filter(|count| *count <= MOST_INSTANCES).ok_or_else(|| {
        Refusal::new(format!("an array has more than {MOST_INSTANCES} instances"), "make it smaller")
    })
}

/// Transform of a flag, and the number of words behind it that are its arguments; none if it is no flag of a
/// transform.
fn step(flag: &str, rest: &[&str]) -> Result<Option<(Similarity, usize)>, Refusal> {
    let value = |index: usize| {
        let word = rest.get(index).ok_or_else(|| {
            Refusal::new(format!("{flag} lacks a number"), "write its numbers behind it, parted by blanks")
        })?;
        number(word, &format!("a number of {flag}"))
    };
    let step = match flag {
        "-t" => (Similarity::translation(DVec3::new(value(0)?, value(1)?, value(2)?)), 3),
        "-rx" => (Similarity::rotation(0, value(0)?), 1),
        "-ry" => (Similarity::rotation(1, value(0)?), 1),
        "-rz" => (Similarity::rotation(2, value(0)?), 1),
        "-s" => match value(0)? {
            0.0 => return refuse("a scale is 0", "write another factor behind -s"),
            factor => (Similarity::scale(factor), 1),
        },
        "-mx" => (Similarity::mirror(0), 0),
        "-my" => (Similarity::mirror(1), 0),
        "-mz" => (Similarity::mirror(2), 0),
        _ => return Ok(None),
    };
    Ok(Some(step))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> Transforms {
        let words: Vec<&str> = text.split_whitespace().collect();
        let (transforms, read) = Transforms::parse(&words).expect("these words are a transform");
        assert_eq!(read, words.len());
        transforms
    }

    fn refused(text: &str) -> Refusal {
        let words: Vec<&str> = text.split_whitespace().collect();
        Transforms::parse(&words).expect_err("these words are refused")
    }

    #[test]
    fn what_is_written_first_is_done_first() {
        let moved = parsed("-t 1 0 0 -rz 90 -s 2").instance(0);
        assert_eq!(moved.point(DVec3::ZERO), DVec3::new(0.0, 2.0, 0.0));
        assert_eq!(moved.direction(DVec3::X), DVec3::new(0.0, 2.0, 0.0));
        assert_eq!(moved.scale, 2.0);
        let turned = parsed("-rx 90").instance(0).point(DVec3::Y);
        assert_eq!(turned, DVec3::Z);
        assert_eq!(parsed("-ry -270").instance(0).point(DVec3::Z), DVec3::X);
    }

    #[test]
    fn the_array_of_the_specification_has_sixty_places() {
        let array = parsed("-a 3 -t 1 0 0 -a 4 -t 0 1 0 -a 5 -t 0 0 1 -i 1 -t 15 30 45");
        assert_eq!(array.count(), 60);
        let places: Vec<DVec3> =
            (0..60).map(|k| array.instance(k).point(DVec3::ZERO) - DVec3::new(15.0, 30.0, 45.0)).collect();
        for (x, y, z) in (0..3).flat_map(|x| (0..4).flat_map(move |y| (0..5).map(move |z| (x, y, z)))) {
            let place = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
            assert_eq!(places.iter().filter(|other| **other == place).count(), 1);
        }
        let twice = parsed("-rz 30 -i 3 -t 1 0 0").instance(0).point(DVec3::ZERO);
        assert_eq!(twice, DVec3::new(3.0, 0.0, 0.0));
        assert_eq!(parsed("-i 0 -t 1 0 0").instance(0), Similarity::IDENTITY);
    }

    #[test]
    fn a_mirror_image_keeps_its_front() {
        let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let normal = |points: &[DVec3]| (points[1] - points[0]).cross(points[2] - points[0]).normalize();
        for (text, expected) in
            [("-mx", DVec3::Z), ("-mz", -DVec3::Z), ("-s -1", -DVec3::Z), ("-mx -my", DVec3::Z)]
        {
            let shape = Shape::Polygon { outline: square.to_vec(), holes: Vec::new() };
            let Shape::Polygon { outline, .. } = parsed(text).instance(0).shape(&shape) else { panic!() };
            assert_eq!(normal(&outline), expected, "{text}");
            let Shape::Quad(corners) = parsed(text).instance(0).shape(&Shape::Quad(square)) else { panic!() };
            assert_eq!(normal(&corners), expected, "{text}");
        }
    }

    #[test]
    fn bad_words_are_refused_with_a_cure() {
        let told = [
            ("-t 1 2", "-t lacks a number"),
            ("-rz one", "which is no number"),
            ("-s 0", "a scale is 0"),
            ("-a 0", "makes no array"),
            ("-a 1e9", "makes no array"),
            ("-a 1000 -t 1 0 0 -a 1000", "more than 100000 instances"),
            ("-i", "is no number of repetitions"),
            ("-t 1e999 0 0", "is 1e999"),
        ];
        for (words, cause) in told {
            let fault = refused(words);
            assert!(fault.cause.contains(cause) && !fault.cure.is_empty(), "{words}: {fault:?}");
        }
        assert_eq!(Transforms::parse(&["-t", "1", "2", "3", "file.rad"]).map(|(_, read)| read), Ok(4));
    }
}
