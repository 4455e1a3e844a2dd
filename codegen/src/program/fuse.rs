//! Products that are added at once: where a machine may round a product and a sum together.

use std::collections::{BTreeMap, BTreeSet};

use super::{Constant, Operation, Program, Table, Value};

impl<C: Constant> Program<C> {
    /// The same program with [`Operation::MultiplyAdd`] for every sum with a product of its own stage.
    ///
    /// It computes the same numbers, in the plain variant with the same bits. Of a sum of two products one is fused: the
    /// second, unless only that is needed by itself. Values that no output needs are left out.
    ///
    /// # Example
    /// ```
    /// use hodograph_codegen::program::{Input, Program};
    /// let mut program = Program::<f64>::new();
    /// let (u, v) = (program.input(Input::U), program.input(Input::V));
    /// let product = program.multiply(u, v);
    /// let difference = program.subtract(u, product);
    /// program.output("difference", vec![difference]);
    /// assert!(program.fused().to_string().contains("%2 * v + u"));
    /// ```
    #[must_use]
    pub fn fused(&self) -> Program<C> {
        let results: Vec<Value> = self.outputs().iter().flat_map(|output| output.values.clone()).collect();
        let needed = self.needed(&results);
        let mut fused = Program::new();
        for symbol in self.symbols() {
            fused.symbol(symbol);
        }
        let mut copy = Copy { kept: self.kept(&needed, &results), from: self, fused, moved: BTreeMap::new() };
        for &value in &needed {
            copy.value(value);
        }
        copy.finish()
    }

    /// The products that are needed by themselves.
    fn kept(&self, needed: &[Value], results: &[Value]) -> BTreeSet<Value> {
        let is_product = |value: &Value| matches!(self.operation(*value), Operation::Multiply(..));
        let mut kept: BTreeSet<Value> = results.iter().copied().filter(is_product).collect();
        let mut sums = Vec::new();
        for &value in needed {
            let operands = self.operation(value).operands();
            let later = |operand: &Value| self.stage(*operand) == self.stage(value);
            if !matches!(self.operation(value), Operation::Add(..) | Operation::Subtract(..)) {
                kept.extend(operands.into_iter().filter(is_product));
            } else if operands.iter().all(|operand| is_product(operand) && later(operand)) {
                sums.push(operands);
            } else {
                kept.extend(operands.into_iter().filter(|operand| is_product(operand) && !later(operand)));
            }
        }
        for operands in sums {
            if operands.iter().all(|operand| !kept.contains(operand)) {
                kept.insert(operands[0]);
            }
        }
        kept
    }
}

/// A program, and what of it has been copied.
struct Copy<'a, C> {
    from: &'a Program<C>,
    kept: BTreeSet<Value>,
    fused: Program<C>,
    moved: BTreeMap<Value, Value>,
}

impl<C: Constant> Copy<'_, C> {
    /// The factors of a product.
    fn product(&self, value: Value) -> Option<(Value, Value)> {
        match *self.from.operation(value) {
            Operation::Multiply(a, b) => Some((self.moved[&a], self.moved[&b])),
            _ => None,
        }
    }

    /// Adds the operation of a value, unless it is a product that is fused wherever it occurs.
    fn value(&mut self, value: Value) {
        let operation = self.from.operation(value);
        if matches!(operation, Operation::Multiply(..)) && !self.kept.contains(&value) {
            return;
        }
        let (first, second) = match *operation {
            Operation::Add(a, b) | Operation::Subtract(a, b) => {
                let stage = self.from.stage(value);
                let product = |value: Value| self.product(value).filter(|_| self.from.stage(value) == stage);
                match (product(a), product(b)) {
                    (Some(first), Some(_)) if !self.kept.contains(&a) => (Some(first), None),
                    (Some(_), second @ Some(_)) => (None, second),
                    products => products,
                }
            }
            _ => (None, None),
        };
        let of = |value: Value| self.moved[&value];
        let fused = &mut self.fused;
        let new = match *operation {
            Operation::Add(a, b) => match (first, second) {
                (_, Some((x, y))) => fused.multiply_add(x, y, of(a)),
                (Some((x, y)), None) => fused.multiply_add(x, y, of(b)),
                (None, None) => fused.add(of(a), of(b)),
            },
            Operation::Subtract(a, b) => match (first, second) {
                (_, Some((x, y))) => {
                    let x = fused.negate(x);
                    fused.multiply_add(x, y, of(a))
                }
                (Some((x, y)), None) => {
                    let c = fused.negate(of(b));
                    fused.multiply_add(x, y, c)
                }
                (None, None) => fused.subtract(of(a), of(b)),
            },
            Operation::Constant(ref constant) => fused.constant(constant.clone()),
            Operation::Input(input) => fused.input(input),
            Operation::Multiply(a, b) => fused.multiply(of(a), of(b)),
            Operation::Divide(a, b) => fused.divide(of(a), of(b)),
            Operation::Negate(a) => fused.negate(of(a)),
            Operation::SquareRoot(a) => fused.square_root(of(a)),
            Operation::MultiplyAdd(a, b, c) => fused.multiply_add(of(a), of(b), of(c)),
            Operation::Orient(a, b) => fused.orient(of(a), of(b)),
            Operation::Scale(a, b, c) => fused.scale(of(a), of(b), of(c)),
        };
        self.moved.insert(value, new);
    }

    /// The copy with the names, tables and outputs of the program.
    fn finish(self) -> Program<C> {
        let Copy { from, mut fused, moved, .. } = self;
        for (value, new) in &moved {
            if let Some(name) = from.name_of(*value) {
                fused.name(*new, name);
            }
        }
        for table in from.tables() {
            let Some(&value) = moved.get(&table.value) else { continue };
            let mut coefficients = Vec::new();
            for coefficient in &table.coefficients {
                // The coefficients 0 and 1 take no operation.
                coefficients.extend(match (moved.get(coefficient), from.operation(*coefficient)) {
                    (Some(&coefficient), _) => Some(coefficient),
                    (None, Operation::Constant(constant)) => Some(fused.constant(constant.clone())),
                    (None, _) => None,
                });
            }
            if coefficients.len() == table.coefficients.len() {
                fused.table(Table { value, coefficients, ..table.clone() });
            }
        }
        for output in from.outputs() {
            fused.output(&output.name, output.values.iter().map(|value| moved[value]).collect());
        }
        fused
    }
}

#[cfg(test)]
mod tests {
    use crate::program::{Floats, Input, Program, Variant, interpret};

    #[test]
    fn bits_of_the_plain_variant_do_not_change() {
        let mut program = Program::<f64>::new();
        let (u, v) = (program.input(Input::U), program.input(Input::V));
        let (product, square) = (program.multiply(u, v), program.multiply(u, u));
        let sum = program.add(product, square);
        let third = program.multiply(sum, v);
        let difference = program.subtract(third, u);
        let last = program.subtract(v, difference);
        program.output("results", vec![sum, difference, last]);
        let fused = program.fused();
        assert_eq!(fused.count_all(fused.results("results")).total(), 6);
        for k in 1..50 {
            let (u, v) = (f64::from(k) / 7.0, 1.0 / f64::from(k));
            let run = |program: &Program<f64>, variant| {
                interpret(program, program.results("results"), &Floats { u, v, symbols: &[], variant })
            };
            assert_eq!(run(&program, Variant::Plain), run(&fused, Variant::Plain));
        }
        let (u, v) = (0.1, 0.3);
        let numbers = interpret(
            &fused,
            fused.results("results"),
            &Floats { u, v, symbols: &[], variant: Variant::Fused },
        );
        assert_eq!(numbers.unwrap()[0], u.mul_add(u, u * v));
    }

    #[test]
    fn products_of_earlier_stages_stay() {
        let mut program = Program::<f64>::new();
        let (u, v) = (program.input(Input::U), program.input(Input::V));
        let (product, square) = (program.multiply(u, v), program.multiply(v, v));
        let sum = program.add(product, square);
        program.output("results", vec![sum]);
        assert!(program.fused().to_string().contains("u * v + %2"), "{}", program.fused());
    }

    #[test]
    fn products_that_are_needed_elsewhere_are_computed_twice_and_counted_once() {
        let mut program = Program::<f64>::new();
        let (u, v) = (program.input(Input::U), program.input(Input::V));
        let product = program.multiply(u, v);
        let sum = program.add(product, v);
        program.output("results", vec![product, sum]);
        let fused = program.fused();
        assert!(fused.to_string().contains("u * v + v"), "{fused}");
        assert_eq!(fused.count_all(fused.results("results")).to_string(), "2 operations (1 +, 1 ×)");
    }
}
