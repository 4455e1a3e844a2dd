//! What is known of many values on one box.

use super::dyadic::Dyadic;
use super::format::{Error, Spread};
use super::interval::Interval;
use super::place::Place;

/// What is known of values: their exact numbers on a box, and their errors in each of the formats.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    /// How many errors a value has.
    formats: usize,
    /// The exact numbers; `None` where they are not bounded.
    places: Vec<Option<Place>>,
    /// The errors of a value in all formats, one value after another.
    errors: Vec<Error>,
    /// For scales: the powers of two that they may be.
    spreads: Vec<Spread>,
}

impl Cells {
    /// Cells of which nothing is known.
    pub(super) fn new(values: usize, formats: usize) -> Cells {
        Cells {
            formats,
            places: vec![None; values],
            errors: vec![Error::UNKNOWN; values * formats],
            spreads: vec![(0, 0); values],
        }
    }

    /// The exact numbers of a value.
    pub(super) fn place(&self, value: usize) -> Option<&Place> {
        self.places[value].as_ref()
    }

    /// The error of a value in a format.
    pub(super) fn error(&self, value: usize, format: usize) -> &Error {
        &self.errors[value * self.formats + format]
    }

    /// The powers of two that a scale may be.
    pub(super) fn spread(&self, value: usize) -> Spread {
        self.spreads[value]
    }

    pub(super) fn set_place(&mut self, value: usize, place: Option<Place>) {
        self.places[value] = place;
    }

    pub(super) fn set_error(&mut self, value: usize, format: usize, error: Error) {
        self.errors[value * self.formats + format] = error;
    }

    pub(super) fn set_spread(&mut self, value: usize, spread: Spread) {
        self.spreads[value] = spread;
    }

    /// Forgets what is known of a value.
    pub(super) fn forget(&mut self, value: usize) {
        self.places[value] = None;
        for format in 0..self.formats {
            self.set_error(value, format, Error::UNKNOWN);
        }
    }

    /// Whether a value and its error in a format are bounded.
    pub(super) fn is_bounded_in(&self, value: usize, format: usize) -> bool {
        self.places[value].is_some() && self.error(value, format).is_known
    }

    /// Takes over what is known of the value `from` of other cells as what is known of `value`.
    pub(super) fn copy(&mut self, value: usize, other: &Cells, from: usize) {
        self.places[value] = other.places[from];
        self.spreads[value] = other.spreads[from];
        let mut format = 0;
        while format < self.formats {
            self.errors[value * self.formats + format] = other.errors[from * self.formats + format];
            format += 1;
        }
    }

    /// The cells of some values alone.
    pub(super) fn of(&self, values: &[usize]) -> Cells {
        let mut cells = Cells::new(values.len(), self.formats);
        for (place, &value) in values.iter().enumerate() {
            cells.copy(place, self, value);
        }
        cells
    }

    /// What is known on both of two boxes.
    pub(super) fn join(&mut self, other: &Cells) {
        for value in 0..self.places.len() {
            self.places[value] = match (&self.places[value], &other.places[value]) {
                (Some(a), Some(b)) => Some(Place::of(&a.range.hull(&b.range))),
                _ => None,
            };
            let ((a, b), (c, d)) = (self.spreads[value], other.spreads[value]);
            self.spreads[value] = (a.min(c), b.max(d));
        }
        for (error, other) in self.errors.iter_mut().zip(&other.errors) {
            *error = error.max(other);
        }
    }

    /// Makes use of what is known on two boxes that this one is made of.
    pub(super) fn refine(&mut self, first: &Cells, second: &Cells) {
        for (value, place) in self.places.iter_mut().enumerate() {
            if let (Some(a), Some(b)) = (&first.places[value], &second.places[value]) {
                *place = Some(match place {
                    Some(known) => known.within(a, b),
                    None => Place::of(&a.range.hull(&b.range)),
                });
                self.spreads[value] = {
                    let ((a, b), (c, d)) = (first.spreads[value], second.spreads[value]);
                    (a.min(c), b.max(d))
                };
            }
        }
        let parts = first.errors.iter().zip(&second.errors);
        for (error, (a, b)) in self.errors.iter_mut().zip(parts) {
            let both = a.max(b);
            if both.is_known {
                *error = both;
            }
        }
    }

    /// min |x|, or 0 if nothing is known.
    pub(super) fn least(&self, value: usize) -> Dyadic {
        self.place(value).map_or(Dyadic::ZERO, |place| place.least)
    }

    /// The exact numbers of a value.
    pub(super) fn range(&self, value: usize) -> Option<Interval> {
        self.place(value).map(|place| place.range)
    }
}
