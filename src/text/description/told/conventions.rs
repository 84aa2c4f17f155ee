//! What labels and comments tell of products and directions.

use crate::convention::matrix::MatrixConvention;
use crate::convention::order::OrderSource;
use crate::convention::{Convention, Direction, Handedness};
use crate::problem::fault::Fault;
use crate::text::description::ParsedRotation;
use crate::text::description::told::{Saying, Told};
use crate::text::vocabulary::Comment;
use crate::text::vocabulary::labels::{LabelWord, words_of};

/// What a text tells in place of what is declared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ToldConvention {
    /// Which coordinates the numbers take to which.
    pub(crate) direction: Direction,
    /// The product, where another one is declared.
    pub(crate) handedness: Option<Handedness>,
}

impl<'t> Told<'t> {
    /// What a comment says of the product and of directions. What a library makes "of them" is something else
    /// than the numbers; active leads the other way.
    pub(super) fn take_convention(&mut self, word: LabelWord, comment: &Comment<'t>) {
        let words = words_of(comment.text);
        let word = match word {
            LabelWord::Direction(direction) if words.contains(&"active") => {
                LabelWord::Direction(direction.reversed())
            }
            LabelWord::Direction(_) | LabelWord::Handedness(_) => word,
            _ => return,
        };
        if !comment.text.contains(" of them") {
            self.conventions.push(Saying {
                word,
                written: comment.text,
                span: comment.span,
            });
        }
    }

    /// What is declared, with the product and the direction that the text tells; which, where that is another one.
    pub(crate) fn directed(
        &self,
        rotation: &ParsedRotation,
        convention: Convention,
        matrix: MatrixConvention,
    ) -> (Convention, MatrixConvention, Option<ToldConvention>) {
        let mut direction = None;
        let mut handedness = None;
        for saying in &self.conventions {
            match saying.word {
                LabelWord::Direction(told) => direction = direction.or(Some(told)),
                LabelWord::Handedness(told) => handedness = handedness.or(Some(told)),
                _ => {}
            }
        }
        let Some(direction) = direction else {
            return (convention, matrix, None);
        };
        match rotation {
            ParsedRotation::Quaternion(parsed) => {
                // Whose product it is tells nothing of an order that is not told.
                let told = handedness.filter(|told| {
                    *told != convention.handedness && parsed.order_source != OrderSource::Declared
                });
                let mut own = convention;
                own.handedness = told.unwrap_or(own.handedness);
                if own.operator() != direction {
                    own.direction = own.direction.reversed();
                }
                let fact = ToldConvention {
                    direction,
                    handedness: told,
                };
                (own, matrix, (own != convention).then_some(fact))
            }
            ParsedRotation::Matrix(_) if matrix.operator() != direction => {
                let own = MatrixConvention {
                    direction: matrix.direction.reversed(),
                    ..matrix
                };
                let fact = ToldConvention {
                    direction,
                    handedness: None,
                };
                (convention, own, Some(fact))
            }
            _ => (convention, matrix, None),
        }
    }

    /// That no label and no comment names another convention than is declared.
    ///
    /// Angles with their axes are always those of the body's attitude: what leads from the world to the body
    /// is the opposite of them.
    pub(crate) fn check(
        &self,
        rotation: &ParsedRotation,
        convention: Convention,
        matrix: MatrixConvention,
    ) -> Result<(), Fault> {
        if !cfg!(feature = "whole") {
            return Ok(());
        }
        let direction = match rotation {
            ParsedRotation::Quaternion(_) => convention.operator(),
            ParsedRotation::Matrix(_) => matrix.operator(),
            _ => Direction::BodyToWorld,
        };
        for &Saying { word, span, .. } in &self.conventions {
            let agrees = match word {
                LabelWord::Handedness(handedness) => handedness == convention.handedness,
                LabelWord::Direction(told) => told == direction,
                _ => true,
            };
            if !agrees {
                let what = word.in_words();
                return Err(match (word, rotation) {
                    (LabelWord::Handedness(_), _)
                    | (_, ParsedRotation::Quaternion(_) | ParsedRotation::Matrix(_)) => {
                        Fault::told_otherwise(span, what)
                    }
                    _ => Fault::opposite_attitude(span, what),
                });
            }
        }
        Ok(())
    }
}
