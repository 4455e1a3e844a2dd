//! Derivatives of formulas in which unknown functions occur.

use std::collections::BTreeMap;

use super::vector::Vector;
use crate::{Fraction, Poly, Variable, budget};

/// How many derivatives of an unknown function are kept.
const MOST_DERIVATIVES: usize = 6;

/// The rules by which symbols that stand for functions of a parameter are differentiated.
///
/// An unknown function `x(u)` is a symbol `x` whose derivative by `u` is a further symbol `x_u`, and so on. With such
/// symbols an identity is proved for every profile, or for every sweep curve, at once.
///
/// # Example
/// ```
/// use hodograph_algebra::{Calculus, Fraction, Variable};
/// let u = Variable::new(0, "u");
/// let mut calculus = Calculus::new();
/// let x = calculus.function("x", &u);
/// let square = Fraction::from(x.clone()).pow(2);
/// assert_eq!(calculus.derivative(&square, &u).to_string(), "2*x*x_u");
/// ```
#[derive(Clone, Debug, Default)]
pub struct Calculus {
    /// The derivative of a symbol by the parameter that it depends on.
    rules: BTreeMap<Variable, (Variable, Fraction)>,
    /// Derivatives of an order that is not kept.
    beyond: Vec<Variable>,
}

impl Calculus {
    /// No unknown functions: derivatives are those of polynomials.
    #[must_use]
    pub fn new() -> Calculus {
        Calculus::default()
    }

    /// Declares an unknown function of `parameter`, and gives its symbol.
    pub fn function(&mut self, name: &str, parameter: &Variable) -> Poly {
        let order = |k: usize| {
            let suffix = if k == 0 { String::new() } else { format!("_{}", parameter.name().repeat(k)) };
            Variable::new(Variable::SYMBOL, &format!("{name}{suffix}"))
        };
        for k in 0..MOST_DERIVATIVES {
            let derivative = Poly::variable(&order(k + 1)).into();
            self.rules.insert(order(k), (parameter.clone(), derivative));
        }
        self.beyond.push(order(MOST_DERIVATIVES));
        Poly::variable(&order(0))
    }

    /// Declares a symbol with a given derivative by `parameter`, and gives it.
    pub fn symbol_with_derivative(&mut self, name: &str, parameter: &Variable, derivative: Fraction) -> Poly {
        let symbol = Variable::new(Variable::SYMBOL, name);
        self.rules.insert(symbol.clone(), (parameter.clone(), derivative));
        Poly::variable(&symbol)
    }

    /// The same rules with scalars in place of symbols; `None` where a denominator vanishes.
    #[must_use]
    pub fn specialized(&self, values: &BTreeMap<Variable, Fraction>) -> Option<Calculus> {
        let rule = |(symbol, (parameter, derivative)): (&Variable, &(Variable, Fraction))| {
            Some((symbol.clone(), (parameter.clone(), derivative.substitute(values)?)))
        };
        let rules = self.rules.iter().map(rule).collect::<Option<_>>()?;
        Some(Calculus { rules, beyond: self.beyond.clone() })
    }

    /// Whether `variable` stands for a function, or for a derivative of one.
    #[must_use]
    pub fn is_function(&self, variable: &Variable) -> bool {
        self.rules.contains_key(variable) || self.beyond.contains(variable)
    }

    /// The parameter that the function `variable` depends on.
    #[must_use]
    pub fn parameter_of(&self, variable: &Variable) -> Option<&Variable> {
        self.rules.get(variable).map(|(parameter, _)| parameter)
    }

    /// Whether the value of `f` depends on `parameter`, directly or through a function.
    #[must_use]
    pub fn depends_on(&self, f: &Fraction, parameter: &Variable) -> bool {
        f.occurring_variables().iter().any(|v| v == parameter || self.parameter_of(v) == Some(parameter))
    }

    /// The derivative by `parameter`, reduced.
    ///
    /// Leaves the computation (see [`budget`]) where it needs a higher derivative of an unknown function than is kept.
    #[must_use]
    pub fn derivative(&self, f: &Fraction, parameter: &Variable) -> Fraction {
        if self.rules.is_empty() {
            return f.derivative(parameter);
        }
        f.derivation(&|poly| self.poly_derivative(poly, parameter))
    }

    /// The derivative of a vector by `parameter`.
    #[must_use]
    pub fn vector_derivative(&self, vector: &Vector, parameter: &Variable) -> Vector {
        vector.map(|component| self.derivative(component, parameter))
    }

    fn poly_derivative(&self, poly: &Poly, parameter: &Variable) -> Fraction {
        let mut sum = Fraction::from(poly.derivative(parameter));
        for variable in poly.occurring_variables() {
            if self.beyond.contains(&variable) {
                budget::refuse(format!(
                    "`{variable}` is the highest derivative of an unknown function that is kept"
                ));
            }
            if let Some((own, rule)) = self.rules.get(&variable)
                && own == parameter
            {
                sum = &sum + &(&Fraction::from(poly.derivative(&variable)) * rule);
            }
        }
        sum
    }
}
