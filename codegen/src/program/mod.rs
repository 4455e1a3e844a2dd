//! Staged straight-line programs: what an evaluator computes, one operation after another.
//!
//! A [`Program`] is a list of values, each a constant, an input, or an operation on earlier values. Equal operations are
//! one value. Every value has a [`Stage`]: the parameters it waits for, so that an evaluator on a grid computes what
//! depends on one parameter once for a whole row or column. Named results are the program's [outputs](Program::outputs).
//!
//! Constants have any type `C`: exact numbers while a program is made and proved, `f64` when it is emitted
//! ([`Program::map_constants`] leads from one to the other). [`interpret`](interpret()) runs a program over any
//! arithmetic.

mod count;
mod fuse;
mod interpret;
mod operation;
mod terms;
mod text;
mod verify;

use std::collections::BTreeMap;

pub use count::OperationCounts;
pub use interpret::{Arithmetic, Floats, Interpreter, Undefined, interpret};
pub use operation::{Constant, Input, Operation, Stage, Value, Variant};
pub use terms::Term;
pub use verify::{Fault, verify};

/// The coefficients of a polynomial that a program evaluates by Horner's scheme.
///
/// The evaluation itself is made of ordinary operations; the table gives its coefficients a name, so that emitted code
/// can show them together.
#[derive(Clone, PartialEq, Debug)]
pub struct Table {
    /// The value of the polynomial.
    pub value: Value,
    /// The name of the polynomial.
    pub name: String,
    /// The polynomial as a mathematician writes it.
    pub formula: String,
    /// The coefficients of 1, x, x², … as values that depend on no parameter.
    pub coefficients: Vec<Value>,
}

/// Named results of a program, such as the three coordinates of a point.
#[derive(Clone, PartialEq, Debug)]
pub struct Output {
    /// The name of the group.
    pub name: String,
    /// The results, in order.
    pub values: Vec<Value>,
}

/// A straight-line program with constants of type `C`.
///
/// # Example
/// ```
/// use hodograph_codegen::program::{Floats, Input, Program, Stage, Variant, interpret};
/// let mut program = Program::new();
/// let (u, v) = (program.input(Input::U), program.input(Input::V));
/// let square = program.multiply(u, u);
/// let sum = program.add(square, v);
/// program.output("sum", vec![sum]);
/// assert_eq!(program.stage(square), Stage::U);
/// assert_eq!(program.stage(sum), Stage::Both);
/// let values = interpret(&program, &[sum], &Floats { u: 3.0, v: 0.5, symbols: &[], variant: Variant::Plain }).unwrap();
/// assert_eq!(values, [9.5]);
/// ```
#[derive(Clone, Debug)]
pub struct Program<C> {
    operations: Vec<Operation<C>>,
    stages: Vec<Stage>,
    names: BTreeMap<Value, String>,
    tables: Vec<Table>,
    outputs: Vec<Output>,
    symbols: Vec<String>,
    /// All constants, by their fingerprints.
    constants: BTreeMap<u64, Vec<Value>>,
    /// Operations without constants, by a key that tells them apart.
    known: BTreeMap<(u8, u32, u32, u32), Value>,
}

impl<C: Constant> Default for Program<C> {
    fn default() -> Self {
        Program::new()
    }
}

impl<C: Constant> Program<C> {
    /// The program without values.
    #[must_use]
    pub fn new() -> Program<C> {
        Program {
            operations: Vec::new(),
            stages: Vec::new(),
            names: BTreeMap::new(),
            tables: Vec::new(),
            outputs: Vec::new(),
            symbols: Vec::new(),
            constants: BTreeMap::new(),
            known: BTreeMap::new(),
        }
    }

    /// The constant `constant`.
    pub fn constant(&mut self, constant: C) -> Value {
        let fingerprint = constant.fingerprint();
        let operation = Operation::Constant(constant);
        let alike = self.constants.get(&fingerprint).into_iter().flatten();
        if let Some(&value) = alike.into_iter().find(|&&value| *self.operation(value) == operation) {
            return value;
        }
        let value = self.push(operation);
        self.constants.entry(fingerprint).or_default().push(value);
        value
    }

    /// A parameter, or a symbol of the program.
    pub fn input(&mut self, input: Input) -> Value {
        self.unique((0, input.key(), 0, 0), Operation::Input(input))
    }

    /// The symbol of this name, a coefficient that is known when the program is run.
    pub fn symbol(&mut self, name: &str) -> Value {
        let place = self.symbols.iter().position(|known| known == name).unwrap_or_else(|| {
            self.symbols.push(name.to_string());
            self.symbols.len() - 1
        });
        self.input(Input::Symbol(place as u32))
    }

    /// a + b, where adding 0 is no operation.
    pub fn add(&mut self, a: Value, b: Value) -> Value {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        self.unique((1, a.0, b.0, 0), Operation::Add(a, b))
    }

    /// a − b, where subtracting 0 is no operation.
    pub fn subtract(&mut self, a: Value, b: Value) -> Value {
        if self.is_zero(b) {
            return a;
        }
        if self.is_zero(a) {
            return self.negate(b);
        }
        self.unique((2, a.0, b.0, 0), Operation::Subtract(a, b))
    }

    /// a · b, where multiplying by 1 or 0 is no operation.
    pub fn multiply(&mut self, a: Value, b: Value) -> Value {
        if self.is_one(a) || self.is_zero(b) {
            return b;
        }
        if self.is_one(b) || self.is_zero(a) {
            return a;
        }
        self.unique((3, a.0, b.0, 0), Operation::Multiply(a, b))
    }

    /// a / b, where dividing by 1 is no operation.
    pub fn divide(&mut self, a: Value, b: Value) -> Value {
        if self.is_one(b) {
            return a;
        }
        self.unique((4, a.0, b.0, 0), Operation::Divide(a, b))
    }

    /// −a
    pub fn negate(&mut self, a: Value) -> Value {
        match self.operations[a.index()] {
            Operation::Negate(b) => b,
            _ if self.is_zero(a) => a,
            Operation::Constant(ref constant) => {
                let negated = constant.negated();
                self.constant(negated)
            }
            _ => self.unique((5, a.0, 0, 0), Operation::Negate(a)),
        }
    }

    /// √a
    pub fn square_root(&mut self, a: Value) -> Value {
        self.unique((6, a.0, 0, 0), Operation::SquareRoot(a))
    }

    /// a · b + c
    pub fn multiply_add(&mut self, a: Value, b: Value, c: Value) -> Value {
        self.unique((7, a.0, b.0, c.0), Operation::MultiplyAdd(a, b, c))
    }

    /// a where b > 0 and −a where b < 0
    pub fn orient(&mut self, a: Value, b: Value) -> Value {
        self.unique((8, a.0, b.0, 0), Operation::Orient(a, b))
    }

    /// The power of two that brings the largest of |a|, |b| and |c| to between 1 and 2.
    pub fn scale(&mut self, a: Value, b: Value, c: Value) -> Value {
        self.unique((9, a.0, b.0, c.0), Operation::Scale(a, b, c))
    }

    /// Gives `value` a name, if it has none and no other value has this one; names make text and code readable. Constants
    /// and inputs are called what they are.
    pub fn name(&mut self, value: Value, name: &str) {
        let taken = self.names.contains_key(&value) || self.names.values().any(|known| known == name);
        let input = matches!(self.operation(value), Operation::Input(_));
        if !taken && !input && self.stage(value) > Stage::Symbols {
            self.names.insert(value, name.to_string());
        }
    }

    /// Records the coefficients of a polynomial that the program evaluates.
    pub fn table(&mut self, table: Table) {
        if self.tables.iter().all(|known| known.value != table.value) {
            self.tables.push(table);
        }
    }

    /// Adds a group of results.
    pub fn output(&mut self, name: &str, values: Vec<Value>) {
        self.outputs.push(Output { name: name.to_string(), values });
    }

    /// Gives the output `name` the values of the output `other`, which is no output by itself then; nothing changes if there is
    /// no output `other`.
    pub fn replace_output(&mut self, name: &str, other: &str) {
        let Some(place) = self.outputs.iter().position(|output| output.name == other) else { return };
        let Output { values, .. } = self.outputs.remove(place);
        for output in self.outputs.iter_mut().filter(|output| output.name == name) {
            output.values.clone_from(&values);
        }
    }

    /// Gives the output `name` other values.
    pub fn set_output(&mut self, name: &str, values: Vec<Value>) {
        for output in self.outputs.iter_mut().filter(|output| output.name == name) {
            output.values.clone_from(&values);
        }
    }

    /// The same values as these of another program, with their operations added where they are not there.
    pub fn import(&mut self, other: &Program<C>, values: &[Value]) -> Vec<Value> {
        let mut known: BTreeMap<Value, Value> = BTreeMap::new();
        for value in other.needed(values) {
            let of = |value: &Value| known[value];
            let same = match other.operation(value) {
                Operation::Constant(constant) => self.constant(constant.clone()),
                Operation::Input(Input::Symbol(place)) => self.symbol(&other.symbols[*place as usize]),
                Operation::Input(input) => self.input(*input),
                Operation::Add(a, b) => self.add(of(a), of(b)),
                Operation::Subtract(a, b) => self.subtract(of(a), of(b)),
                Operation::Multiply(a, b) => self.multiply(of(a), of(b)),
                Operation::Divide(a, b) => self.divide(of(a), of(b)),
                Operation::Negate(a) => self.negate(of(a)),
                Operation::SquareRoot(a) => self.square_root(of(a)),
                Operation::MultiplyAdd(a, b, c) => self.multiply_add(of(a), of(b), of(c)),
                Operation::Orient(a, b) => self.orient(of(a), of(b)),
                Operation::Scale(a, b, c) => self.scale(of(a), of(b), of(c)),
            };
            if let Some(name) = other.name_of(value) {
                self.name(same, name);
            }
            known.insert(value, same);
        }
        values.iter().map(|value| known[value]).collect()
    }

    /// The operations of all values, each after its operands.
    #[must_use]
    pub fn operations(&self) -> &[Operation<C>] {
        &self.operations
    }

    /// The operation of a value.
    #[must_use]
    pub fn operation(&self, value: Value) -> &Operation<C> {
        &self.operations[value.index()]
    }

    /// The stage of a value.
    #[must_use]
    pub fn stage(&self, value: Value) -> Stage {
        self.stages[value.index()]
    }

    /// The name of a value, if it has one.
    #[must_use]
    pub fn name_of(&self, value: Value) -> Option<&str> {
        self.names.get(&value).map(String::as_str)
    }

    /// The coefficients of the polynomials that it evaluates.
    #[must_use]
    pub fn tables(&self) -> &[Table] {
        &self.tables
    }

    /// The names of its symbols, in the order of their first use.
    #[must_use]
    pub fn symbols(&self) -> &[String] {
        &self.symbols
    }

    /// The groups of results, in the order in which they were added.
    #[must_use]
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }

    /// The results of the group `name`; none if there is no such group.
    #[must_use]
    pub fn results(&self, name: &str) -> &[Value] {
        self.outputs.iter().find(|output| output.name == name).map_or(&[], |output| &output.values)
    }

    /// All values.
    pub fn values(&self) -> impl Iterator<Item = Value> + use<C> {
        (0..self.operations.len() as u32).map(Value)
    }

    /// The values that `results` are computed from, these included, in the order of computation.
    #[must_use]
    pub fn needed(&self, results: &[Value]) -> Vec<Value> {
        let mut wanted = vec![false; self.operations.len()];
        for result in results {
            wanted[result.index()] = true;
        }
        for value in self.values().collect::<Vec<_>>().into_iter().rev() {
            if wanted[value.index()] {
                for operand in self.operation(value).operands() {
                    wanted[operand.index()] = true;
                }
            }
        }
        self.values().filter(|value| wanted[value.index()]).collect()
    }

    /// The same program with constants of another type.
    ///
    /// # Errors
    /// The first error of `map`.
    pub fn map_constants<D: Constant, E>(
        &self,
        mut map: impl FnMut(&C) -> Result<D, E>,
    ) -> Result<Program<D>, E> {
        let operation = |operation: &Operation<C>| {
            Ok(match *operation {
                Operation::Constant(ref constant) => Operation::Constant(map(constant)?),
                Operation::Input(input) => Operation::Input(input),
                Operation::Add(a, b) => Operation::Add(a, b),
                Operation::Subtract(a, b) => Operation::Subtract(a, b),
                Operation::Multiply(a, b) => Operation::Multiply(a, b),
                Operation::Divide(a, b) => Operation::Divide(a, b),
                Operation::Negate(a) => Operation::Negate(a),
                Operation::SquareRoot(a) => Operation::SquareRoot(a),
                Operation::MultiplyAdd(a, b, c) => Operation::MultiplyAdd(a, b, c),
                Operation::Orient(a, b) => Operation::Orient(a, b),
                Operation::Scale(a, b, c) => Operation::Scale(a, b, c),
            })
        };
        let operations: Vec<Operation<D>> =
            self.operations.iter().map(operation).collect::<Result<_, E>>()?;
        let mut constants: BTreeMap<u64, Vec<Value>> = BTreeMap::new();
        for (place, operation) in operations.iter().enumerate() {
            if let Operation::Constant(constant) = operation {
                constants.entry(constant.fingerprint()).or_default().push(Value(place as u32));
            }
        }
        Ok(Program {
            operations,
            stages: self.stages.clone(),
            names: self.names.clone(),
            tables: self.tables.clone(),
            outputs: self.outputs.clone(),
            symbols: self.symbols.clone(),
            constants,
            known: self.known.clone(),
        })
    }

    fn is_zero(&self, value: Value) -> bool {
        matches!(self.operation(value), Operation::Constant(constant) if constant.is_zero())
    }

    fn is_one(&self, value: Value) -> bool {
        matches!(self.operation(value), Operation::Constant(constant) if constant.is_one())
    }

    fn unique(&mut self, key: (u8, u32, u32, u32), operation: Operation<C>) -> Value {
        if let Some(&value) = self.known.get(&key) {
            return value;
        }
        let value = self.push(operation);
        self.known.insert(key, value);
        value
    }

    fn push(&mut self, operation: Operation<C>) -> Value {
        let stage = match operation {
            Operation::Input(input) => input.stage(),
            _ => operation.operands().iter().fold(Stage::Constant, |stage, &a| stage.join(self.stage(a))),
        };
        let value = Value(self.operations.len() as u32);
        self.operations.push(operation);
        self.stages.push(stage);
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_operations_are_one_value() {
        let mut program = Program::new();
        let (u, two) = (program.input(Input::U), program.constant(2.0));
        let twice = program.multiply(two, u);
        assert_eq!(program.input(Input::U), u);
        assert_eq!(program.constant(2.0), two);
        assert_eq!(program.multiply(two, u), twice);
        assert_ne!(program.add(two, u), twice);
    }

    #[test]
    fn neutral_elements_cost_nothing() {
        let mut program = Program::new();
        let (u, zero, one) = (program.input(Input::U), program.constant(0.0), program.constant(1.0));
        assert_eq!(program.add(zero, u), u);
        assert_eq!(program.add(u, zero), u);
        assert_eq!(program.subtract(u, zero), u);
        assert_eq!(program.multiply(one, u), u);
        assert_eq!(program.multiply(u, zero), zero);
        assert_eq!(program.divide(u, one), u);
        let negative = program.subtract(zero, u);
        assert_eq!(*program.operation(negative), Operation::Negate(u));
        assert_eq!(program.negate(negative), u);
    }

    #[test]
    fn stages_join() {
        use Stage::{Both, Constant, Symbols, U, V};
        for (a, b, joined) in [
            (Constant, V, V),
            (V, U, Both),
            (U, U, U),
            (Both, V, Both),
            (Constant, Constant, Constant),
            (Constant, Symbols, Symbols),
            (Symbols, V, V),
        ] {
            assert_eq!(a.join(b), joined);
            assert_eq!(b.join(a), joined);
        }
    }

    #[test]
    fn imported_values_are_the_same() {
        let mut other = Program::new();
        let (u, c, two) = (other.input(Input::U), other.symbol("c"), other.constant(2.0));
        let (sum, product) = (other.add(u, c), other.multiply(two, u));
        let quotient = other.divide(sum, product);
        other.name(product, "twice");
        let mut program = Program::new();
        let (v, two) = (program.input(Input::V), program.constant(2.0));
        let u = program.input(Input::U);
        let twice = program.multiply(two, u);
        let before = program.operations().len();
        let imported = program.import(&other, &[product, quotient]);
        assert_eq!((imported[0], program.name_of(twice)), (twice, Some("twice")));
        // The symbol, the sum and the quotient are new.
        assert_eq!(program.operations().len(), before + 3);
        program.output("result", vec![v]);
        program.set_output("result", imported);
        let numbers = Floats { u: 3.0, v: 0.0, symbols: &[6.0], variant: Variant::Plain };
        assert_eq!(interpret(&program, program.results("result"), &numbers).unwrap(), [6.0, 1.5]);
    }

    #[test]
    fn only_needed_values_are_listed() {
        let mut program = Program::<f64>::new();
        let (u, v) = (program.input(Input::U), program.input(Input::V));
        let square = program.multiply(u, u);
        program.add(u, v);
        assert_eq!(program.needed(&[square]), [u, square]);
    }
}
