//! Where several polynomials in two variables vanish together on a box.

use super::interval::Interval;
use super::roots::RealRoot;
use super::subdivision::Point;
use super::zeros::{EdgeZeros, ZeroSet};
use crate::surface::locus::factors;
use crate::{Poly, Variable};

/// The isolated common zeros on the box `domain`, in two variables, of polynomials that occur in no others.
///
/// `None` if they have a factor in common, or a zero may have two coordinates that are no exact numbers (`RealRoot::exact`).
///
/// Factors are zero one by one, in all combinations. Of what is left, one variable is eliminated by resultants, and the others
/// are solved at every root (Cox, Little and O'Shea, *Ideals, Varieties, and Algorithms*, chapter 3, sections 1 and 6).
pub(crate) fn common_zeros(polys: &[Poly], domain: &[(Variable, Interval)]) -> Option<ZeroSet> {
    let [first, second] = domain else { return None };
    let known = |variable: &Variable| [first, second].iter().any(|(other, _)| other == variable);
    if !polys.iter().flat_map(Poly::occurring_variables).all(|variable| known(&variable)) {
        return None;
    }
    let pending = polys.iter().filter(|poly| !poly.is_zero()).cloned().collect();
    let mut search = Search { domain: [first, second], zeros: ZeroSet::default() };
    search.split(&[], pending)?;
    Some(search.zeros)
}

struct Search<'a> {
    domain: [&'a (Variable, Interval); 2],
    zeros: ZeroSet,
}

impl Search<'_> {
    /// Adds the zeros of a system, of which the polynomials in `done` are not split any more.
    fn split(&mut self, done: &[Poly], mut pending: Vec<Poly>) -> Option<()> {
        if done.iter().chain(&pending).any(Poly::is_constant) {
            return Some(());
        }
        pending.sort_by_key(|poly| std::cmp::Reverse(poly.terms().len()));
        let Some(next) = pending.pop() else { return self.solve(done) };
        for factor in factors(&next, &[done, &pending].concat()) {
            // What a factor divides vanishes with it.
            let without = |polys: &[Poly]| -> Vec<Poly> {
                polys.iter().filter(|poly| !factor.divides(poly)).cloned().collect()
            };
            let mut chosen = without(done);
            if !chosen.iter().any(|poly| poly.divides(&factor)) {
                chosen.push(factor.clone());
            }
            self.split(&chosen, without(&pending))?;
        }
        Some(())
    }

    /// Adds the zeros of polynomials of which no two have a factor in common.
    fn solve(&mut self, polys: &[Poly]) -> Option<()> {
        let rational = |roots: &[RealRoot]| roots.iter().all(|root| root.exact().is_some());
        for axis in 0..2 {
            let roots = self.eliminated(polys, 1 - axis)?;
            if rational(&roots) {
                return roots.iter().try_for_each(|root| self.above(polys, axis, root.exact()?));
            }
        }
        None
    }

    /// The values of the other variable at which the polynomials may vanish together.
    fn eliminated(&self, polys: &[Poly], axis: usize) -> Option<Vec<RealRoot>> {
        let variable = &self.domain[axis].0;
        let (moving, fixed): (Vec<&Poly>, Vec<&Poly>) =
            polys.iter().partition(|poly| poly.contains(variable));
        let mut all: Vec<Poly> = fixed.into_iter().cloned().collect();
        if let [first, others @ ..] = moving.as_slice() {
            all.extend(others.iter().map(|other| first.resultant(other, variable)));
        }
        let (other, interval) = self.domain[1 - axis];
        Poly::gcd_many(&all).real_roots_in(other, interval)
    }

    /// Adds the zeros at which the variable of an axis has this value.
    fn above(&mut self, polys: &[Poly], axis: usize, value: &Poly) -> Option<()> {
        let (variable, (other, interval)) = (&self.domain[axis].0, self.domain[1 - axis]);
        let restricted: Vec<Poly> = polys.iter().map(|poly| poly.substitute(variable, value)).collect();
        for root in Poly::gcd_many(&restricted).real_roots_in(other, interval)? {
            let Some(exact) = root.exact() else {
                self.add(variable, value, root);
                continue;
            };
            let point = Point::from([(variable.clone(), value.clone()), (other.clone(), exact.clone())]);
            if !self.zeros.points.contains(&point) {
                self.zeros.points.push(point);
            }
        }
        Some(())
    }

    /// Adds a zero on the line where a variable has this value.
    fn add(&mut self, fixed: &Variable, value: &Poly, root: RealRoot) {
        let known = &mut self.zeros.roots;
        match known.iter_mut().find(|edge| edge.fixed == *fixed && edge.value == *value) {
            Some(edge) if edge.roots.iter().any(|other| other.compare(&root).is_eq()) => {}
            Some(edge) => edge.roots.push(root),
            None => known.push(EdgeZeros { fixed: fixed.clone(), value: value.clone(), roots: vec![root] }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ratio;

    fn texts(polys: impl Fn(&Poly, &Poly) -> Vec<Poly>) -> Option<Vec<String>> {
        let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
        let (x, y) = (Poly::variable(&u), Poly::variable(&v));
        let around = Interval::new(Poly::integer(-1), Poly::integer(1)).unwrap();
        let zeros = common_zeros(&polys(&x, &y), &[(u.clone(), around), (v.clone(), Interval::unit())])?;
        let mut texts: Vec<String> =
            zeros.points.iter().map(|point| format!("({}, {})", point[&u], point[&v])).collect();
        let roots = zeros.roots.iter().flat_map(|edge| {
            let text =
                |root: &RealRoot| format!("{} = {}: {}", edge.fixed.name(), edge.value, root.to_decimal(4));
            edge.roots.iter().map(text)
        });
        texts.extend(roots);
        texts.sort();
        Some(texts)
    }

    #[test]
    fn zeros_are_exact_numbers() {
        let one = Poly::one();
        // A circle and a line through its center; 3u² = 1 at v = 0 alone.
        let found = texts(|x, y| vec![x.pow(2) + y.pow(2) - &one, x - y]);
        assert_eq!(found.unwrap(), ["(1/2*sqrt2, 1/2*sqrt2)"]);
        let found = texts(|x, y| vec![x.pow(2).scale(&ratio(3, 1)) - &one, y * (x + y + &one), y * x]);
        assert_eq!(found.unwrap(), ["(-1/3*sqrt3, 0)", "(1/3*sqrt3, 0)"]);
        // Three polynomials, any two of which have further zeros.
        let found = texts(|x, y| vec![x * (y - &one), y * (x - &one), x + y - x * y.pow(2) - &one]);
        assert_eq!(found.unwrap(), ["(1, 1)"]);
        assert_eq!(texts(|x, y| vec![x - y, x + y + &one]).unwrap(), [""; 0]);
        assert_eq!(texts(|_, _| vec![one.clone(), Poly::zero()]).unwrap(), [""; 0]);
    }

    #[test]
    fn what_is_no_number_or_no_point_is_left() {
        // The cubic root of 1/2, with a number and with itself, and a line.
        let cubic = |x: &Poly| x.pow(3) - Poly::constant(ratio(1, 2));
        assert_eq!(texts(|x, y| vec![cubic(x), y.clone()]).unwrap(), ["v = 0: 0.7937"]);
        assert!(texts(|x, y| vec![cubic(x), x - y]).is_none());
        assert!(texts(|x, y| vec![(x - y) * x, (x - y) * y]).is_none());
        assert!(texts(|x, _| vec![x.clone(), Poly::zero()]).is_none());
    }
}
