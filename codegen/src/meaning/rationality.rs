//! Whether a value is a rational function.

use hodograph_algebra::{CurveError, OffsetError, Poly};

use super::assumptions::Assumptions;
use super::expression::shortened;
use super::fault::Fault;
use super::finding::Finding;
use super::relation::{cut, print};
use super::scope::Scope;
use super::value::Value;
use super::{functions, generic, roots, surfaces};
use crate::language::ast::{Expr, ExprKind};

/// Whether the value of an expression exists as a rational function of the given parameters, over the real numbers.
pub(super) fn is_rational(assumptions: &Assumptions, expr: &Expr) -> Result<Finding, Fault> {
    let scope = &assumptions.scope;
    let unknowns = || generic::unknowns(scope, expr);
    match scope.evaluate(expr) {
        Ok(value) if roots::is_rooted(&value) && value.scalar().is_none() => {
            let parts = roots::parts(&value, expr.span())?.unwrap_or_default();
            let message = match parts.iter().find(|part| !part.is_rational()) {
                Some(part) => *roots::irrational(expr.span(), part).diagnostic,
                None => *Fault::new(expr.span(), "it has a square root").diagnostic,
            };
            Ok(Finding::new(false, message.message).about_variables(unknowns()))
        }
        Err(fault) if fault.irrational => {
            Ok(Finding::new(false, fault.diagnostic.message).about_variables(unknowns()))
        }
        Err(fault) => match functions::symbolic_root(scope, expr)? {
            // Over the real numbers a function of the symbols is a constant.
            Some(radicand) if assumptions.with_nonnegative(&radicand).samples().points.is_empty() => {
                let text =
                    format!("no values of the symbols were found for which {radicand} is not negative");
                Ok(Finding::undecided(text).about_variables(unknowns()))
            }
            Some(radicand) => {
                let text =
                    format!("it contains the square root of {radicand}, which depends on the symbols alone");
                let mut finding = Finding::new(true, text).about_variables(unknowns());
                if !functions::is_positive_everywhere(&radicand) && !assumptions.state_nonnegative(&radicand)
                {
                    finding.conditions.push(format!("{radicand} >= 0"));
                }
                Ok(finding)
            }
            None => match symbolic_frame(scope, expr) {
                Some(radicand) => Ok(over_symbols(&radicand).about_variables(unknowns())),
                None => Err(fault),
            },
        },
        Ok(value) => match value.bare() {
            Value::AdaptedFrame(frame) => {
                match frame.rational().map_err(|error| Fault::curve(expr.span(), &error)) {
                    Ok(frame) => {
                        let parts = frame.f.components().iter().chain(frame.g.components());
                        let text = match &frame.rotation {
                            Some(w) => format!(
                                "rational, of the angle 2*arg(W) with W = {}",
                                shortened(&w.to_string())
                            ),
                            None => format!("rational, f = {}", print(frame.f.components())),
                        };
                        Ok(Finding::new(true, text).about(parts))
                    }
                    Err(fault) if fault.irrational => {
                        Ok(Finding::new(false, fault.diagnostic.message).about_variables(unknowns()))
                    }
                    Err(fault) => match symbolic_frame(scope, expr) {
                        Some(radicand) => Ok(over_symbols(&radicand).about_variables(unknowns())),
                        None => Err(fault),
                    },
                }
            }
            Value::Offset(offset) => match offset.as_ref() {
                Ok(surface) => {
                    let degree = surface.homogeneous().degree();
                    Ok(Finding::new(true, format!("rational, of degree {degree}"))
                        .about(surface.position().components()))
                }
                Err(error @ OffsetError::SymbolicRadical { radicand, .. }) => {
                    Ok(Finding::new(true, error.to_string())
                        .about_variables(radicand.occurring_variables().into_iter().chain(unknowns())))
                }
                Err(error @ OffsetError::Irrational { .. }) => {
                    Ok(Finding::new(false, error.to_string()).about_variables(unknowns()))
                }
                Err(error) => Err(Fault::offset(expr.span(), error)),
            },
            other => {
                let components = other.complex().map(|z| vec![z.re, z.im]).or_else(|| other.components());
                let derived = components.as_deref().map_or_else(|| other.kind().to_owned(), print);
                Ok(Finding::new(true, derived).about(components.iter().flatten()))
            }
        },
    }
}

/// The polynomial in symbols alone under the root in a Frenet frame, for an expression that is such a frame, or a member of one.
fn symbolic_frame(scope: &Scope, expr: &Expr) -> Option<Poly> {
    let radicand = |expr: &Expr| match scope.evaluate(expr).ok()?.bare() {
        Value::AdaptedFrame(frame) => match frame.rational() {
            Err(CurveError::SymbolicFrenet { radicand }) => Some(*radicand),
            _ => None,
        },
        _ => None,
    };
    let expr = generic::resolved(scope, expr);
    match expr.kind() {
        ExprKind::Member { object, .. } => radicand(expr).or_else(|| radicand(object)),
        _ => None,
    }
}

/// A squared length is nowhere negative, and where it vanishes for all values of the parameter the curve is a straight line.
fn over_symbols(radicand: &Poly) -> Finding {
    let text = format!(
        "|s' x s''|^2 is a square times {}, which depends on the symbols alone",
        cut(radicand.to_string())
    );
    Finding::new(true, text).in_general(true)
}

/// Whether a surface is a Pythagorean-normal surface in its parameters.
pub(super) fn is_pn(scope: &Scope, expr: &Expr) -> Result<Finding, Fault> {
    let surface = surfaces::surface(scope, expr)?;
    let normal = surface.normal().map_err(|error| Fault::offset(expr.span(), &error))?;
    let squared = normal.squared_length();
    let split = squared.split();
    let derived = if split.is_square() {
        format!(
            "R_u x R_v has the direction N with |N|^2 = {}*({})^2",
            split.unit,
            cut(split.root.to_string())
        )
    } else {
        format!(
            "|N|^2 for the direction N of R_u x R_v has the factor {} to an odd power",
            cut(split.odd.to_string())
        )
    };
    Ok(Finding::new(normal.is_rational(), derived).about(surface.position().components()))
}
