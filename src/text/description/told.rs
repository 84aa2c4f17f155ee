//! What labels and comments tell of all the numbers beside them.

use crate::convention::angle::AngleUnit;
use crate::convention::matrix::MatrixConvention;
use crate::convention::order::ComponentOrder;
use crate::convention::{Convention, Direction};
use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted};
use crate::text::description::ParsedRotation;
use crate::text::grammar::lex::{Token, TokenKind};
use crate::text::vocabulary::decimal_words::is_decimal;
use crate::text::vocabulary::labels::{Derived, LabelWord, meanings_of, words_of};
use crate::text::vocabulary::phrases::{is_mark, is_name, is_sequence};
use crate::text::vocabulary::{Comment, Telling, is_listed};

/// What labels and comments tell, as far as it is no part of a form.
#[derive(Clone, Debug, Default)]
pub(crate) struct Told<'t> {
    /// That of four components, by a comment.
    pub(crate) order: Option<ComponentOrder>,
    /// The same by a label.
    label_order: Option<ComponentOrder>,
    /// That of all the angles, by a comment.
    pub(crate) unit: Option<AngleUnit>,
    /// Whether the nine numbers of a matrix stand by rows or by columns.
    layout: Option<Saying<'t>>,
    /// Whose product it is, and directions.
    conventions: Vec<Saying<'t>>,
    /// A letter that names many matrices which are no rotation.
    symbol: Option<Saying<'t>>,
}

/// What a label or a comment says, as it is written, and where.
#[derive(Clone, Copy, Debug)]
struct Saying<'t> {
    word: LabelWord,
    written: &'t str,
    span: Span,
}

impl<'t> Told<'t> {
    /// What the labels and the comments of a text tell; a problem where a comment says that the numbers are
    /// something else, or where only the whole core knows what is said.
    pub(crate) fn of(telling: &Telling<'t>, text: &'t str, wanted: Wanted) -> Result<Self, Fault> {
        // Without the feature `whole` no comment has words (`blank.rs`), and labels are plain.
        if !cfg!(feature = "whole") {
            return check_plain(&telling.tokens, wanted).map(|()| Self::default());
        }
        let mut told = Self::default();
        for (at, span) in labels(&telling.tokens) {
            told.take_label(&text[span.start..span.end], span, &telling.tokens[at + 1..]);
        }
        told.take_comments(&telling.comments, wanted)?;
        Ok(told)
    }

    fn take_label(&mut self, written: &'t str, span: Span, value: &[Token<'_>]) {
        const SYMBOLS: [&str; 6] = ["J", "K", "P", "S", "W", "Σ"];
        let saying = |word| Saying {
            word,
            written,
            span,
        };
        if SYMBOLS.contains(&written.trim_matches(['"', '\''])) {
            self.symbol = Some(saying(LabelWord::Quantity("a covariance or an inertia")));
        }
        for word in meanings_of(written) {
            match word {
                LabelWord::Order(order) => self.label_order = Some(order),
                LabelWord::Handedness(_) | LabelWord::Direction(_) => {
                    self.conventions.push(saying(word));
                }
                // `cols: 3` counts them.
                LabelWord::Columns | LabelWord::Rows | LabelWord::Elements if !is_count(value) => {
                    self.layout = Some(saying(word));
                }
                _ => {}
            }
        }
    }

    fn take_comments(&mut self, comments: &[Comment<'t>], wanted: Wanted) -> Result<(), Fault> {
        let mut letters = String::new();
        let mut units = Vec::new();
        for comment in comments {
            let refused =
                |word: LabelWord| Fault::other_comment(comment.span, word.in_words(), wanted);
            let words = words_of(comment.text);
            // `x`, or `qx`
            let (mut own, mut of_q) = (String::new(), String::new());
            for word in &words {
                let letter = word.trim_start_matches('q');
                if is_component(word) {
                    own.push_str(word);
                } else if is_component(letter) {
                    of_q.push_str(letter);
                }
            }
            let own = if own.is_empty() { of_q } else { own };
            // Of all four by themselves, or of one beside each number.
            if own.len() == 4 {
                self.take_letters(&own, comment, wanted)?;
            } else {
                letters += &own;
            }
            for (at, word) in words.iter().enumerate() {
                // `# 90 deg` says what this angle is.
                let follows_number = at > 0 && is_decimal(words[at - 1]);
                if let Some(unit) = AngleUnit::named(&word.to_ascii_lowercase())
                    && !follows_number
                {
                    units.push(unit);
                }
            }
            for word in meanings_of(comment.text) {
                let saying = Saying {
                    word,
                    written: comment.text,
                    span: comment.span,
                };
                match word {
                    LabelWord::Derived(made) if is_told_in_prose(made, wanted) => {
                        return Err(refused(word));
                    }
                    LabelWord::LeftHanded => return Err(Fault::left_handed(comment.span)),
                    LabelWord::OtherOrder => return Err(Fault::other_order(comment.span, wanted)),
                    LabelWord::Quantity(_) if wanted == Wanted::Quaternion && words.len() < 3 => {
                        return Err(refused(word));
                    }
                    LabelWord::Order(order) => self.take_order(order, comment, wanted)?,
                    LabelWord::Handedness(_) | LabelWord::Direction(_) => {
                        self.conventions.push(saying);
                    }
                    LabelWord::Columns | LabelWord::Rows if comment.text.contains("major") => {
                        self.layout = Some(saying);
                    }
                    _ => {}
                }
            }
        }
        if let [unit, others @ ..] = &units[..]
            && others.iter().all(|other| other == unit)
        {
            self.unit = Some(*unit);
        }
        match comments {
            [first, ..] => self.take_letters(&letters, first, wanted),
            [] => Ok(()),
        }
    }

    /// `# x y z w`, `/* x */ 0.1, /* y */ …`
    fn take_letters(
        &mut self,
        letters: &str,
        comment: &Comment<'t>,
        wanted: Wanted,
    ) -> Result<(), Fault> {
        let lower = letters.to_ascii_lowercase();
        match (wanted, lower.as_str()) {
            (Wanted::Quaternion, "wxyz") => {
                self.take_order(ComponentOrder::ScalarFirst, comment, wanted)
            }
            (Wanted::Quaternion, "xyzw") => {
                self.take_order(ComponentOrder::ScalarLast, comment, wanted)
            }
            (Wanted::Vector, "xyz") => Ok(()),
            _ => {
                let names = match wanted {
                    Wanted::Quaternion => "wxyz",
                    Wanted::Vector => "xyz",
                };
                let is_permuted =
                    lower.len() == names.len() && names.chars().all(|name| lower.contains(name));
                if is_permuted {
                    Err(Fault::other_order(comment.span, wanted))
                } else {
                    Ok(())
                }
            }
        }
    }

    /// The order that a comment tells; a problem where a label or another comment tells the other one.
    fn take_order(
        &mut self,
        order: ComponentOrder,
        comment: &Comment<'t>,
        wanted: Wanted,
    ) -> Result<(), Fault> {
        if [self.order, self.label_order].contains(&Some(order.other())) {
            return Err(Fault::other_order(comment.span, wanted));
        }
        self.order = Some(order);
        Ok(())
    }

    /// How a label says that the nine numbers of a rotation stand; a problem where they are no rotation by their
    /// label, or where there are no nine.
    pub(crate) fn layout_of(
        &self,
        rotation: &ParsedRotation,
        has_rows: bool,
    ) -> Result<Option<Layout>, Fault> {
        let ParsedRotation::Matrix(matrix) = rotation else {
            return match self.layout {
                Some(Saying {
                    word: LabelWord::Columns,
                    written,
                    span,
                }) => Err(Fault::unknown_argument(span, written)),
                _ => Ok(None),
            };
        };
        if let Some(symbol) = self.symbol
            && *matrix == matrix.transpose()
        {
            let what = symbol.word.in_words();
            return Err(Fault::other_label(
                symbol.span,
                symbol.written,
                what,
                Wanted::Quaternion,
            ));
        }
        Ok(match self.layout.map(|saying| saying.word) {
            Some(LabelWord::Columns) => Some(Layout::Columns),
            Some(LabelWord::Elements) if !has_rows => Some(Layout::Columns),
            Some(LabelWord::Rows) => Some(Layout::Rows),
            _ => None,
        })
    }

    /// What the label of a rotation in a whole block tells, and what is said around it; a problem where that says
    /// that the numbers are something else.
    #[cfg(feature = "whole")]
    pub(crate) fn around(
        label: &'t str,
        span: Span,
        remarks: &[Comment<'t>],
    ) -> Result<Self, Fault> {
        let mut told = Self::default();
        // `view = Matrix4`: the type behind a name is no word of it.
        let name = label.split('=').next().unwrap_or(label);
        told.take_label(name, span, &[]);
        // What it names in a block was used there.
        told.label_order = None;
        told.take_comments(remarks, Wanted::Quaternion)?;
        told.layout = None;
        Ok(told)
    }

    /// What is declared, with the direction that the text tells; whether that is another one.
    pub(crate) fn directed(
        &self,
        rotation: &ParsedRotation,
        convention: Convention,
        matrix: MatrixConvention,
    ) -> (Convention, MatrixConvention, Option<Direction>) {
        let mut directions = self
            .conventions
            .iter()
            .filter_map(|saying| match saying.word {
                LabelWord::Direction(direction) => Some(direction),
                _ => None,
            });
        let Some(told) = directions.next() else {
            return (convention, matrix, None);
        };
        let turned_convention = Convention {
            direction: convention.direction.reversed(),
            ..convention
        };
        let turned_matrix = MatrixConvention {
            direction: matrix.direction.reversed(),
            ..matrix
        };
        match rotation {
            ParsedRotation::Quaternion(_) if convention.operator() != told => {
                (turned_convention, matrix, Some(told))
            }
            ParsedRotation::Matrix(_) if matrix.operator() != told => {
                (convention, turned_matrix, Some(told))
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

/// That labels have none but plain words, of which the meaning need not be known.
pub(crate) fn check_plain(tokens: &[Token<'_>], wanted: Wanted) -> Result<(), Fault> {
    let mut label = 0;
    let is_permuted = |name: &&Token<'_>| {
        name.text.len() == 3 && is_sequence(name.text) && !name.text.eq_ignore_ascii_case("xyz")
    };
    for (at, token) in tokens.iter().enumerate() {
        if is_mark(Some(token)) {
            let names = &tokens[label..at];
            let other = names.iter().find(|name| !is_plain(name.text));
            // Of vectors `zyx = …` is another order.
            let order = names.last().filter(|_| wanted == Wanted::Vector);
            if let Some(name) = other.or(order.filter(is_permuted)) {
                return Err(Fault::other_label(name.span, "", "", wanted));
            }
        }
        if !is_name(token) || token.angle_unit().is_some() {
            label = at + 1;
        }
    }
    Ok(())
}

/// The labels that are read without the feature `whole`, besides single letters and sequences of axes.
const PLAIN: &str = "quat quaternion rotation qw qx qy qz orientation q_wxyz q_xyzw rpy ypr rpy_deg euler euler_zyx \
    euler_xyz axis angle roll pitch yaw rotvec rvec rotation_vector gibbs mrp half vector matrix unit degrees \
    order double";

/// Whether a label says nothing besides what its form is.
fn is_plain(name: &str) -> bool {
    let is_letter = name.len() == 1 && !matches!(name, "t" | "J" | "K" | "P" | "S" | "W");
    is_letter || is_sequence(name) || is_listed(name, PLAIN)
}

/// How a label says that nine numbers stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Layout {
    Rows,
    Columns,
}

/// The marks of the labels among tokens, and where the names stand that are before each.
fn labels(tokens: &[Token<'_>]) -> Vec<(usize, Span)> {
    let mut labels = Vec::new();
    // Where the names begin that stand before the next token.
    let mut start = 0;
    for (at, token) in tokens.iter().enumerate() {
        if is_mark(Some(token)) && start < at {
            labels.push((at, tokens[start].span.to(tokens[at - 1].span)));
        }
        if !is_name(token) {
            start = at + 1;
        }
    }
    labels
}

/// Whether what follows a mark is one number.
fn is_count(value: &[Token<'_>]) -> bool {
    let is_number = |token: &Token<'_>| matches!(token.kind, TokenKind::Number(_));
    matches!(value, [number, rest @ ..] if is_number(number)
        && rest.first().is_none_or(|next| is_name(next)
            || matches!(next.kind, TokenKind::Close(_))
            || (next.kind == TokenKind::Comma && rest.get(1).is_none_or(is_name))))
}

fn is_component(word: &str) -> bool {
    matches!(word, "w" | "x" | "y" | "z" | "W" | "X" | "Y" | "Z")
}

/// Whether a word in a sentence says that the numbers are made of others; a minus there may be any.
fn is_told_in_prose(made: Derived, wanted: Wanted) -> bool {
    match made {
        Derived::Negative | Derived::Difference => false,
        Derived::Rate => wanted == Wanted::Quaternion,
        _ => true,
    }
}
