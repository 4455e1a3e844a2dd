//! The functions that evaluate a surface, and what Rust has for them.

use hodograph::{Float, Surface, Undefined};
use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_tests::surfaces::{Evaluator, moved};

/// How C names a precision, and its functions.
#[derive(Clone, Copy)]
pub(crate) struct Type {
    pub(crate) precision: Precision,
    pub(crate) name: &'static str,
    pub(crate) suffix: &'static str,
    pub(crate) bits: &'static str,
}

pub(crate) const TYPES: [Type; 2] = [
    Type { precision: Precision::Double, name: "double", suffix: "", bits: "uint64_t" },
    Type { precision: Precision::Single, name: "float", suffix: "f", bits: "uint32_t" },
];

impl Type {
    pub(crate) fn digits(self, number: f64) -> String {
        match self.precision {
            Precision::Double => format!("{:016x}", number.to_bits()),
            Precision::Single => format!("{:08x}", (number as f32).to_bits()),
        }
    }

    pub(crate) fn line(self, numbers: &[f64]) -> String {
        numbers.iter().map(|&number| self.digits(number)).collect::<Vec<String>>().join(" ")
    }

    /// What is printed of a result: its bits, or why there is none.
    pub(crate) fn outcome(self, outcome: &Outcome) -> String {
        match outcome {
            Ok(numbers) => self.line(numbers),
            Err(Undefined::Pole) => "pole".to_owned(),
            Err(Undefined::Singular) => "singular".to_owned(),
            Err(Undefined::Parameter) => "parameter".to_owned(),
            Err(Undefined::Overflow) => "overflow".to_owned(),
            Err(other) => panic!("C does not know {other:?}"),
        }
    }
}

/// The numbers of a result, or why there is none.
pub(crate) type Outcome = Result<Vec<f64>, Undefined>;

/// The bits of a result's numbers.
pub(crate) fn bits(outcome: &Outcome) -> Result<Vec<u64>, Undefined> {
    outcome
        .as_ref()
        .map(|numbers| numbers.iter().map(|number| number.to_bits()).collect())
        .map_err(|&error| error)
}

/// A place with a distance: u, v and r.
pub(crate) type Place = (f64, f64, f64);

/// A function that evaluates a surface at a place; C and Rust have one name for it.
pub(crate) struct Function {
    pub(crate) name: &'static str,
    /// The struct of its result, if it is one.
    pub(crate) structure: Option<&'static str>,
    /// The task that its numbers are of, the first of them there and their count.
    pub(crate) task: &'static str,
    first: usize,
    pub(crate) size: usize,
    /// What begins the names of its batches.
    pub(crate) batch: Option<&'static str>,
}

impl Function {
    const fn new(
        (name, structure): (&'static str, Option<&'static str>),
        (task, first, size): (&'static str, usize, usize),
        batch: Option<&'static str>,
    ) -> Function {
        Function { name, structure, task, first, size, batch }
    }

    /// The declaration of a variable for the result, and how it is passed.
    pub(crate) fn result(&self, kind: Type, variable: &str) -> (String, String) {
        match (self.structure, self.size) {
            (Some(structure), _) => {
                (format!("{structure}{} {variable}", kind.suffix), format!("&{variable}"))
            }
            (None, 1) => (format!("{} {variable}", kind.name), format!("&{variable}")),
            (None, size) => (format!("{} {variable}[{size}]", kind.name), variable.to_owned()),
        }
    }

    /// The definition of a pointer to the function, which the compiler does not see through: it has to inline the function once.
    pub(crate) fn pointer(
        &self,
        Type { name: real, suffix, .. }: Type,
        (name, member): (&str, &str),
    ) -> String {
        let surface = if member.is_empty() { String::new() } else { format!("const {name}_surface *, ") };
        let distance = if self.is_offset() { format!("{real}, ") } else { String::new() };
        let result = self.structure.map_or(real.to_owned(), |structure| format!("{structure}{suffix}"));
        let function = format!("{name}_{}{suffix}", self.name);
        format!(
            "hodograph_status (*volatile evaluate)({surface}{distance}{real}, {real}, {result} *) = {function}"
        )
    }

    /// Whether its first parameter is a distance.
    pub(crate) fn is_offset(&self) -> bool {
        self.name.starts_with("offset")
    }

    /// Whether there is no result where the surface has no normal.
    pub(crate) fn needs_normal(&self) -> bool {
        self.is_offset() || ["Normal", "Local"].contains(&self.task) && !self.name.starts_with("speed")
    }

    /// The result, from the numbers of tasks.
    pub(crate) fn outcome(&self, surface: &dyn Evaluator, rounding: Rounding, (u, v, r): Place) -> Outcome {
        let numbers = |task: &str| surface.numbers(task, rounding, (u, v));
        let is_finite = |numbers: &[f64]| numbers.iter().all(|number| number.is_finite());
        let result = match (self.name, rounding) {
            (name, _) if name.starts_with("offset") && !r.is_finite() => return Err(Undefined::Parameter),
            ("offset_point", rounding) => moved(&numbers("Point"), &numbers("Normal"), r, rounding),
            ("offset_first_order", rounding) => {
                let local = numbers("Local");
                moved(&local[..9], &[&local[18..21], &local[33..39]].concat(), r, rounding)
            }
            _ => numbers(self.task)[self.first..self.first + self.size].to_vec(),
        };
        if is_finite(&result) {
            return Ok(result);
        }
        let homogeneous = numbers("Homogeneous");
        let has_point = is_finite(&homogeneous) && is_finite(&numbers("Point"));
        Err(if !(u.is_finite() && v.is_finite()) {
            Undefined::Parameter
        } else if homogeneous[0] == 0.0 && self.task != "Homogeneous" {
            Undefined::Pole
        } else if self.needs_normal() && has_point && !is_finite(&numbers("Normal")) {
            Undefined::Singular
        } else {
            Undefined::Overflow
        })
    }
}

/// What the runtime's method gives.
pub(crate) fn runtime<F: Float>(surface: &dyn Surface<F>, method: &str, place: Place) -> Outcome {
    fn wide<F: Float>(numbers: impl AsRef<[F]>) -> Vec<f64> {
        numbers.as_ref().iter().map(|number| number.to_f64()).collect()
    }
    let (u, v, r) = (F::of(place.0), F::of(place.1), F::of(place.2));
    match method {
        "homogeneous" => surface.homogeneous(u, v).map(wide),
        "point" => surface.point(u, v).map(wide),
        "separated_point" => surface.separated_point(u, v).map(wide),
        "partial_u" => surface.partial_u(u, v).map(wide),
        "partial_v" => surface.partial_v(u, v).map(wide),
        "first_order" => surface.first_order(u, v).map(|result| wide(result.numbers())),
        "second_order" => surface.second_order(u, v).map(|result| wide(result.numbers())),
        "unit_normal" => surface.unit_normal(u, v).map(wide),
        "local_geometry" => surface.local_geometry(u, v).map(|result| wide(result.numbers())),
        "speed_u" => surface.speed_u(u, v).map(|speed| wide([speed])),
        "speed_v" => surface.speed_v(u, v).map(|speed| wide([speed])),
        "offset_point" => surface.offset_point(r, u, v).map(wide),
        "offset_first_order" => surface.offset_first_order(r, u, v).map(|result| wide(result.numbers())),
        _ => panic!("there is no method {method}"),
    }
}

pub(crate) const FUNCTIONS: [Function; 13] = {
    const FIRST: Option<&str> = Some("hodograph_first_order");
    const SECOND: Option<&str> = Some("hodograph_second_order");
    const LOCAL: Option<&str> = Some("hodograph_local_geometry");
    [
        Function::new(("homogeneous", None), ("Homogeneous", 0, 4), Some("homogeneous_")),
        Function::new(("point", None), ("Point", 0, 3), Some("")),
        Function::new(("separated_point", None), ("Separated", 0, 3), Some("separated_")),
        Function::new(("partial_u", None), ("First", 3, 3), None),
        Function::new(("partial_v", None), ("First", 6, 3), None),
        Function::new(("first_order", FIRST), ("First", 0, 9), Some("first_")),
        Function::new(("second_order", SECOND), ("Second", 0, 18), Some("second_")),
        Function::new(("unit_normal", None), ("Normal", 0, 3), Some("normal_")),
        Function::new(("local_geometry", LOCAL), ("Local", 0, 39), Some("local_")),
        Function::new(("speed_u", None), ("Local", 31, 1), None),
        Function::new(("speed_v", None), ("Local", 32, 1), None),
        Function::new(("offset_point", None), ("Normal", 0, 3), None),
        Function::new(("offset_first_order", FIRST), ("Local", 0, 9), None),
    ]
};
