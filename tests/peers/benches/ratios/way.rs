//! The ways in which many points are evaluated, and their parameters.

use hodograph::Float;

/// Points of a row, which stay in the cache where they are not stored.
pub(crate) const COLUMNS: usize = 1000;

/// Which points are evaluated, and where they go.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Way {
    /// A grid into memory.
    StoredGrid,
    /// The rows of a grid, one after the other into the same place.
    Rows,
    /// Independent points into memory.
    StoredPoints,
    /// Lists of independent points, one after the other into the same place.
    Points,
    /// Independent points by a call each.
    Calls,
}

impl Way {
    /// The title of a work: what is evaluated, and in which way.
    pub(crate) fn title(self, quantity: &str) -> String {
        let way = match self {
            Self::StoredGrid => "of a grid, stored",
            Self::Rows => "of a grid, rows in cache",
            Self::StoredPoints => "at independent parameters, stored",
            Self::Points => "at independent parameters, in cache",
            Self::Calls => "by single calls",
        };
        format!("{quantity} {way}")
    }

    /// The place of the results of a row.
    pub(crate) fn place(self, row: usize) -> std::ops::Range<usize> {
        let stored = matches!(self, Self::StoredGrid | Self::StoredPoints);
        let first = if stored { row * COLUMNS } else { 0 };
        first..first + COLUMNS
    }
}

/// The parameters of a number of rows.
pub(crate) struct Parameters<F> {
    /// Those of the columns and of the rows of a grid.
    pub(crate) us: Vec<F>,
    pub(crate) vs: Vec<F>,
    /// Those of independent points.
    pub(crate) scattered_us: Vec<F>,
    pub(crate) scattered_vs: Vec<F>,
}

impl<F: Float> Parameters<F> {
    /// Parameters in the unit square.
    pub(crate) fn new(rows: usize) -> Self {
        let equidistant = |count: usize| (0..count).map(|k| F::of(k as f64 / (count - 1) as f64)).collect();
        // Multiples of irrational numbers modulo 1 spread evenly.
        let scattered = |step: f64| (0..rows * COLUMNS).map(|k| F::of((k as f64 * step).fract())).collect();
        Self {
            us: equidistant(COLUMNS),
            vs: equidistant(rows),
            scattered_us: scattered(0.754_877_666_246_692_8),
            scattered_vs: scattered(0.569_840_290_998_053_3),
        }
    }

    /// Those of a row of points.
    #[inline(always)]
    pub(crate) fn row(&self, way: Way, j: usize) -> (&[F], Vs<'_, F>) {
        match way {
            Way::StoredGrid | Way::Rows => (&self.us, Vs::All(self.vs[j])),
            Way::StoredPoints => {
                let row = way.place(j);
                (&self.scattered_us[row.clone()], Vs::Each(&self.scattered_vs[row]))
            }
            Way::Points | Way::Calls => {
                (&self.scattered_us[..COLUMNS], Vs::Each(&self.scattered_vs[j..j + COLUMNS]))
            }
        }
    }

    /// Those of a point, of all points row by row.
    pub(crate) fn at(&self, way: Way, k: usize) -> (f64, f64) {
        let (us, vs) = self.row(way, k / COLUMNS);
        (us[k % COLUMNS].to_f64(), vs.at(k % COLUMNS).to_f64())
    }
}

/// The parameters v of a row.
#[derive(Clone, Copy)]
pub(crate) enum Vs<'a, F> {
    All(F),
    Each(&'a [F]),
}

impl<F: Copy> Vs<'_, F> {
    #[inline(always)]
    pub(crate) fn at(self, i: usize) -> F {
        match self {
            Self::All(v) => v,
            Self::Each(vs) => vs[i],
        }
    }
}
