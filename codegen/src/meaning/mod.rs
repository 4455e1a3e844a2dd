//! The meaning of the sweep language: from the syntax tree to curves, surfaces and verdicts.
//!
//! The grammar is that of [`language`](crate::language). This is the reference of what clauses, names, operators,
//! functions, members and relations stand for. FN is Farouki and Nittler, *Rational swept surface constructions based
//! on differential and integral sweep curve properties*, 2014; numbers in brackets are its equations. GE is Georgiev, *Rational
//! generalized offsets of rational surfaces*, 2012.
//!
//! ```
//! use hodograph_algebra::budget::DEFAULT_LIMIT;
//! use hodograph_codegen::language::{ast::Verdict, parse_text};
//! use hodograph_codegen::meaning::{Judgement, models};
//!
//! /// What becomes of the claims of a text.
//! fn judge(text: &str) -> Vec<Judgement> {
//!     let (file, _source) = parse_text("example.sweep", text).unwrap();
//!     let (models, mistakes) = models(&file);
//!     assert!(mistakes.is_empty());
//!     let check = |model: &hodograph_codegen::meaning::Model| -> Vec<Judgement> {
//!         model.claims.iter().map(|claim| model.check(claim, DEFAULT_LIMIT).unwrap()).collect()
//!     };
//!     models.iter().flat_map(check).collect()
//! }
//!
//! // The oriented-translation sweep (17) of a line along a PH cubic.
//! let judgements = judge(r#"sweep cylinder {
//!     profile p(u) = u*k;
//!     path s(v) = ph([1, 1 + I]);
//!     surface R = s + p.x*s.normal + p.z*k;
//!     domain u in 0..1, v in 0..1;
//!     claim "degree": degree(R) == (1, 3);
//!     claim "normal": parallel(normal(R), s.normal);
//! }"#);
//! assert!(judgements.iter().all(|judgement| judgement.verdict == Verdict::Proved));
//! assert_eq!(judgements[0].derived, "(1, 3)");
//! ```
//!
//! # Exactness
//!
//! A value is a rational function (or two, or three) of parameters, symbols and unknown functions over a tower of real
//! square roots; nothing is ever rounded. Two values are equal if they are the same function, which also says that a
//! claim speaks of all points at which both sides are defined.
//!
//! # Clauses
//!
//! A name is defined before it is used. Domains alone are read first, wherever they stand, and claims last: they may
//! use all names. The *parameters* of an item are those of its surface in their order, then, by name, all others that
//! stand in parentheses behind a defined name or have a domain.
//!
//! | clause | what it means |
//! | --- | --- |
//! | `source "FN (17)";` | where the formula is taken from; at most one |
//! | `symbol c, d;` | unknown real constants |
//! | `function x(u), z(u);` | unknown smooth functions of one parameter |
//! | `let a = …;` | a name for a value of any kind, angles such as `3*pi/8` included |
//! | `let f(u, v) = …;` | the same; `f` alone is the value, `f(a, b)` the value with `a`, `b` for `u`, `v` |
//! | `profile p(u) = …;` | the curve that is swept |
//! | `path s(v) = …;` | the curve along which it is swept; its polynomials give their names to parts of the code |
//! | `curve c(t) = …;` | any other curve |
//! | `frames F(v) = …;` | a motion through frames; see *Frames* |
//! | `surface R = …;` | the surface `R(u, v)`; once in a sweep, never in a lemma |
//! | `surface R(s, t) = …;` | the same with other parameters |
//! | `domain u in 0..1, v in -1..sqrt(2);` | closed intervals; the ends are numbers, the first is the smaller one |
//! | `prefer accurate;` | evaluators are to be accurate rather than `fast`, the default: see *Preferences* |
//! | `substitute v = …;` | after `surface`: a rational function in place of a parameter of the surface |
//! | `claim "id": relation;` | what is to be settled; see *Claims* |
//!
//! - `symbol`, `let`, `function` and the curves' clauses may stand in any number. A sweep needs a domain for both
//!   parameters of its surface and has no other one. In a lemma domains are needed only by what asks for them:
//!   inequalities, roots of functions, total arc lengths.
//! - The three kinds of curves differ in their roles alone: each takes a vector (`x*i + z*k`, `(x, y)`, `(x, y, z)`) or
//!   one of the *Constructors*, depends on its own parameter and on no other, and has all *Members of curves*.
//! - An unknown function `x(u)` stands for `x` at the parameter as it is: `x`, `diff(x, u)`, …, up to the sixth
//!   derivative. It has no value at a point, no degree, and no place in a surface; a lemma can state identities for all
//!   functions.
//! - A surface is a vector with components in its two parameters and in symbols. From its clause on `W`, `X`, `Y`, `Z`
//!   are its homogeneous coordinates (10): polynomials without common factor.
//! - `substitute v = f;` replaces a parameter of the surface by a scalar of its parameters: `R(u, v)` becomes
//!   `R(u, f)`, with all its coordinates and members, over the domain that is stated for `v`. The curves stay as they are.
//!   Errors: no surface before it; a denominator that vanishes.
//!
//! # Preferences
//!
//! Without `prefer accurate;` evaluators are `fast`: of several schemes for a polynomial, each of which is proved to be the same
//! polynomial, the one with the fewest operations and steps of latency is taken, unless another one is much more accurate. With it the
//! one with the least error figure is taken, and the point is summed over the Bernstein basis: where the control points'
//! coordinates have one sign nothing cancels, so that each coordinate is accurate relative to itself. It costs two to four
//! times as many operations. That holds for the point, and for what is made of it: grids of points and offsets. The separated point,
//! derivatives and homogeneous coordinates may cancel as before. Families are always `fast`.
//!
//! ```
//! use hodograph_codegen::{language::parse_text, meaning::models};
//!
//! let text = "sweep saddle {
//!     surface R = (u, v, u*v);
//!     substitute v = v^2;
//!     domain u in 0..1, v in 0..1;
//! }";
//! let (models, _mistakes) = models(&parse_text("saddle.sweep", text).unwrap().0);
//! let surface = models[0].surface.as_ref().unwrap();
//! assert_eq!(surface.homogeneous().to_string(), "(1, u, v^2, u*v^2)");
//! ```
//!
//! # Names
//!
//! Names are ASCII. Each has one meaning in an item; these have theirs already:
//!
//! | names | what they are |
//! | --- | --- |
//! | `i`, `j`, `k` | the unit vectors in the x-, y- and z-direction |
//! | `I` | the imaginary unit |
//! | `pi` | π, which stands in angles only |
//! | `W`, `X`, `Y`, `Z` | in a sweep: the surface's homogeneous coordinates, known after `surface` |
//! | names of parameters | the parameter; it needs no clause |
//! | names of functions | those below |
//! | `sqrt2`, …, `theta`, `theta2`, … | how square roots are printed; write `sqrt(2)` |
//! | `x_u`, `x_uu`, … | for an unknown function `x(u)`: how its derivatives are printed; write `diff(x, u)` |
//! | `a0`, `b0`, `x0`, `y0`, `w0`, … | the symbols of a curve with symbolic coefficients; see *Constructors* |
//! | `s_x`, `s_y`, `s_z`, `s_m`, `s_arclength` | for a curve `s` of `regular_curve` or `curve_from_hodograph` |
//!
//! # Values and operators
//!
//! | kind | written | counts as |
//! | --- | --- | --- |
//! | scalar | `0.25`, `2/3`, `1e-3`, `sqrt(2)`, `u^2*c` | complex number |
//! | complex number | `1 + 2*I` | scalar, if its imaginary part is zero |
//! | quaternion | `quat(w, x, y, z)` | scalar or vector, if its other part is zero |
//! | vector | `(x, y)`, `(x, y, z)`, `x*i + z*k` | of a pair, z is 0 |
//! | homogeneous coordinates | `(w, x, y, z)` | |
//! | list | `[a, b, c]` | the argument of a constructor only |
//! | frame, motion | `frame(…)`, the name of a motion | |
//! | curve, surface | its name | its position vector |
//! | frame of a curve | `s.frame`, `s.rmf`, `s.frenet` | its members alone have values |
//! | degree | `degree(…)` | stands on the left side of a relation only |
//! | formula in fundamental forms | `R.L`, `R.H/R.K` | scalar, for the surface's forms; see *Fundamental forms* |
//! | scalar or vector with a root | `sqrt(1 + u^2)`, `R.unit_normal` | `a + b*sqrt(q)` with one radicand q |
//!
//! | operator | for |
//! | --- | --- |
//! | `a + b`, `a - b` | two scalars or complex numbers; two vectors; two tuples of one length |
//! | `a*b` | two scalars or complex numbers; a scalar and a vector or tuple, in either order; a quaternion with a scalar, a vector or a quaternion, where the order counts |
//! | `a/b` | anything that `*` takes, by a scalar or complex number that is not identically zero |
//! | `a + b`, `a - b`, `-a` | quaternions, to which scalars and vectors can be added |
//! | `-a` | scalars, complex numbers, vectors, tuples |
//! | `a^n` | a scalar or complex number, with an integer −1000 ≤ n ≤ 1000 ([`MAX_EXPONENT`]) |
//! | `f(a, b)` | the value of a function, curve, member of a curve or surface at these values of its parameters |
//!
//! A call takes scalars: numbers, but also `s(1 - v)` or `R(u, c)`. It is an error where the denominator vanishes,
//! unless the zero cancels, and where it would need an unknown function at another point.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! let judgements = judge(r#"lemma values {
//!     let f(u, v) = u^2*v + u;
//!     let angle = 3*pi/4;
//!     claim "power": -2^2 == -4;
//!     claim "complex": (1 + 2*I)/(3 - I) == (1 + 7*I)/10;
//!     claim "vectors": 2*(1, 2) - i == (1, 4, 0);
//!     claim "call": f(2, v) == 4*v + 2;
//!     claim "angle": cos(angle) == -sqrt(2)/2;
//! }"#);
//! assert!(judgements.iter().all(|(verdict, _)| verdict == "proved"));
//! assert_eq!(judgements[3].1, "both sides are 4*v + 2");
//! assert_eq!(judgements[4].1, "both sides are -1/2*sqrt2");
//! ```
//!
//! # Functions
//!
//! Where a function takes a vector, it takes pairs, curves and surfaces as well.
//!
//! ## Derivatives and products
//!
//! - `diff(f, u)`: the partial derivative `∂f/∂u` of a scalar, complex number or vector. `diff(f, u, n)` is the n-th
//!   one, `0 ≤ n ≤ 100`. The derivative of a curve by its parameter can be called: `diff(s, v)(1)`.
//! - `dot(a, b)`, `cross(a, b)`: the products of two vectors.
//! - `norm2(a)`: `a·a` of a vector; `|a|²` of a complex number or quaternion.
//! - `conj(z)`, `re(z)`, `im(z)`: conjugate, real part, imaginary part of a complex number; the conjugate of a quaternion.
//! - `quat(w, x, y, z)`: the quaternion `w + x*i + y*j + z*k` of four scalars. In products with it `i`, `j`, `k` are Hamilton's
//!   units, as in `A*i*conj(A)`.
//!
//! ## Roots and angles
//!
//! - `sqrt(a)`: the square root that is not negative. Of a number it is exact: it stays in a tower of square roots of
//!   at most 16 storeys. Of a function `f^2*q` with squarefree q it is `|f|*sqrt(q)`, where f keeps one sign on the domain: a rational
//!   function if q is a positive number, else a value with a root, for sums, products, quotients, `diff`, calls and relations; sums of roots of
//!   different radicands have no form. Where a rational function is needed, as in curves and surfaces, it is an error. Errors: a negative
//!   number; a sign of f that changes, or that depends on symbols; a radicand that depends on symbols alone.
//! - `abs(a)`: the absolute value of a number.
//! - `cos(q*pi)`, `sin(q*pi)`, `exp(I*q*pi)`: for rational `q` whose denominator is a power of two, up to 2¹⁰
//!   ([`MAX_ANGLE_HALVINGS`](hodograph_algebra::MAX_ANGLE_HALVINGS)), times a product of different ones of 3, 5 and 17:
//!   what square roots can construct. Errors: other angles.
//!
//! ## Polynomials
//!
//! - `gcd(f, g, …)`: the greatest common divisor of polynomials in all variables, without numeric factor: that of
//!   numbers is 1.
//! - `degree(f, g, …)`: the degrees in the two parameters, the largest of all arguments for each; a vector or a surface
//!   stands for its four homogeneous coordinates. Zero has the degree −1. Errors: denominators, unknown functions, a
//!   lemma with more or fewer than two parameters. In a lemma the parameters come in alphabetical order.
//! - `degree(f, g, …, parameter = v)`: the degree in one parameter.
//! - `resultant(f, g, parameter = v)`: the resultant of two polynomials in one parameter, a polynomial in the other
//!   variables. It vanishes where they have a common zero, real or complex, or where both leading coefficients vanish.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! let judgements = judge(r#"lemma polynomials {
//!     symbol c;
//!     let f(u, v) = u^2*v - 1;
//!     claim "gcd": gcd(2*v^2 - 2, 3*v + 3) == v + 1;
//!     claim "degrees": degree(f, v^3) == (2, 3);
//!     claim "degree": degree(f, parameter = u) == 2;
//!     claim "resultant": resultant(v^2 + 1, v - c, parameter = v) == c^2 + 1;
//! }"#);
//! assert!(judgements.iter().all(|(verdict, _)| verdict == "proved"));
//! assert_eq!(judgements[3].1, "both sides are c^2 + 1");
//! ```
//!
//! ## Surfaces
//!
//! - `homogeneous(R)`: the coordinates `(W, X, Y, Z)` of (10) without common factor, of a surface, an offset or any
//!   vector.
//! - `normal(R)`: the direction of (11) in lowest terms: three coprime polynomials, the numerator of `R_u × R_v`. It
//!   points the way of `R_u × R_v` at the beginning of the domain, and has no length of its own. Error: `R_u × R_v` is
//!   zero everywhere.
//! - `offset(R, d)`: the offset surface `R + d·N` of (12) with the unit normal `N`, for a scalar `d`. Errors, except in
//!   `is_rational`: it is not rational in the given parameters, or only over a root of the symbols.
//! - `offset(s, d)`: the offset curve of (8), as `s.offset(d)`.
//! - `pipe(s, r)`: the pipe of radius `r` around a curve with a rational parametric speed, `s + r*((1 - u^2)*f + 2*u*g)/(1 + u^2)` with
//!   the frame `(t, f, g)` of `s.frame` and the surface's other parameter `u`.
//! - `canal(s, r)`: the envelope of the spheres around `s` with the radius `r(v)`, a function of the curve's parameter. It
//!   is rational exactly if `σ² − r'²` is nowhere negative, as a sum `p² + q²` of two squares. They are found where the factors of odd
//!   multiplicity of `σ − r'` and `σ + r'` are quadratics. Errors: it is negative somewhere; finding `p` and `q` needs more than square roots.
//! - `pipe(s, r, frame = s.rmf)`, `canal(s, r, frame = s.rmf)`: the same with another rational frame, which begins the circles
//!   elsewhere.
//! - `similarity_offset(R, f, d)`: the surface `R + d*f*n1` of GE (4.10) with the unit normal n1, for a similarity function `f`, a formula
//!   in the fundamental forms of R that scales as a length does; see *Fundamental forms*. It is rational for every rational surface, and the
//!   same on both sides of it. R may be a vector in the two parameters of the item.
//! - `similarity(a, ratio = rho, rotation = (w, x, y, z), translation = t)`: the image of a vector, or of a surface as a vector, under the
//!   direct similarity GE (2.1): turned by a quaternion, of any length but zero, then multiplied by the ratio, then shifted. Each part may
//!   be left out; the image of a difference of points is that without `translation`.
//! - `bezier_patch([[p00, p01, …], [p10, …], …])`: the Bézier patch over the unit square with these control points, a row for each index of the first
//!   parameter; a vector in the two parameters of the item. `bezier_patch([[…], …], weights = [[w00, …], …])`: the rational one. Errors: rows of
//!   different lengths; weights that cancel.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! let judgements = judge(r#"sweep cone {
//!     symbol r;
//!     path s(v) = ((1 - v^2)/(1 + v^2), 2*v/(1 + v^2));
//!     surface R = 3*(1 - u)*s + 4*u*k;
//!     domain u in 0..1/2, v in 0..1;
//!     claim "weight": W == 1 + v^2;
//!     claim "degree": degree(R) == (1, 2);
//!     claim "of W": degree(W, parameter = v) == 2;
//!     claim "normal": parallel(normal(R), 4*s + 3*k);
//!     claim "offset": offset(R, r) == R - r*(4*s + 3*k)/5;
//!     claim "derivative": diff(R, u) == 4*k - 3*s;
//! }"#);
//! assert!(judgements.iter().all(|(verdict, _)| verdict == "proved"));
//! assert_eq!(judgements[0].1, "both sides are v^2 + 1");
//! ```
//!
//! ### Fundamental forms
//!
//! For a surface, or a vector in the two parameters of the item, with domains for both; all can be called, as in `R.K(1/2, 0)`.
//!
//! | member | what it is | equation | weight |
//! | --- | --- | --- | --- |
//! | `E`, `F`, `G` | `R_u·R_u`, `R_u·R_v`, `R_v·R_v` | GE (4.2) | 2 |
//! | `L`, `M`, `N` | `R_uu·n1`, `R_uv·n1`, `R_vv·n1` | GE (4.3) | 1 |
//! | `K` | the Gaussian curvature `(L*N - M^2)/(E*G - F^2)` | GE (5.2) | −2 |
//! | `H` | the mean curvature `(E*N - 2*F*M + G*L)/(2*(E*G - F^2))` | GE (5.2) | −1 |
//! | `unit_normal` | `n1 = (R_u × R_v)/√(E*G - F^2)`; beyond a curve where the normal is zero, its smooth continuation | GE (4.4) | |
//!
//! What is made of them by `+`, `-`, `*`, `/`, `^` stays a formula, with functions of parameters and symbols for its coefficients. A similarity of ratio
//! ρ multiplies a formula of the weight w by ρʷ; those of weight 1, such as `R.L - 2*R.M + R.N`, `R.H/R.K`, `1/R.H`, `R.E/R.L`, are the
//! similarity functions (GE Definition 4.1). Errors of `similarity_offset`: another weight, or terms of different weights; a divisor that is zero on the whole
//! surface, such as `R.K` on developable surfaces and `R.H` on minimal ones; the forms of another surface.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! let judgements = judge(r#"sweep saddle {
//!     symbol d, rho;
//!     let S = bezier_patch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]]);
//!     surface R = similarity_offset(S, S.L - 2*S.M + S.N, d);
//!     domain u in 0..1, v in 0..1;
//!     claim "patch": S == (u, v, u*v);
//!     claim "offset": R == S - 2*d*(-v, -u, 1)/(1 + u^2 + v^2);
//!     claim "degree": degree(R) == (3, 3);
//!     claim "E": S.E == 1 + v^2;
//!     claim "M": S.M == 1/sqrt(1 + u^2 + v^2);
//!     claim "K": S.K(1, 1) == -1/9;
//!     claim "normal": S.unit_normal == 1/sqrt(1 + u^2 + v^2)*(-v, -u, 1);
//!     claim "focal": similarity_offset(S, S.H/S.K, d) == S + d*u*v*(-v, -u, 1);
//!     claim "image": similarity(S, ratio = rho, rotation = (1, 0, 0, 1)) == rho*(-v, u, u*v);
//!     claim "negative": S.K < 0;
//! }"#);
//! assert!(judgements.iter().all(|(verdict, _)| verdict == "proved"));
//! assert_eq!(judgements[4].1, "both sides are (1/(u^2 + v^2 + 1))*sqrt(u^2 + v^2 + 1)");
//! ```
//!
//! # Constructors
//!
//! These make curves, and stand in the clause of a curve.
//!
//! - `ph([w0, …, wk])`: the planar Pythagorean-hodograph curve `s' = w²` with `s(0) = 0`, where the preimage
//!   `w(v) = Σ w_j·C(k, j)·vʲ(1 − v)ᵏ⁻ʲ` has these complex Bernstein coefficients (9). Its degree is 2k + 1. Errors: no
//!   coefficient that differs from zero.
//! - `ph(n)`: the same with an odd degree n ≤ 201 ([`MAX_PH_DEGREE`](hodograph_algebra::MAX_PH_DEGREE)) and symbols for
//!   coefficients, `w_j = aj + I*bj`: every PH curve of this degree with a primitive hodograph (7). Sweeps have room for the symbols
//!   of n ≤ 21.
//! - `ph(…, start = (x, y))`: with `s(0) = (x, y)`. `ph(…, factor = h)`: with the hodograph `h·w²`, for a nonzero
//!   polynomial `h`.
//! - `ph_hermite(a, da, b, db)`: the planar PH quintic with `s(0) = a`, `s'(0) = da`, `s(1) = b`, `s'(1) = db`, four
//!   pairs of numbers: of the four solutions that of least absolute rotation index (see
//!   [`Hermite`](hodograph_algebra::Hermite)). Errors: a tangent that is zero; a tie, which lists the candidates.
//! - `ph_hermite(…, solution = n)`: the solution with the number n from 0 to 3.
//! - `bezier([p0, …, pk])`: the Bézier curve with two control points at least, in the plane or in space.
//! - `bezier([…], weights = [w0, …, wk])`: the rational one; a scalar weight for each point. Errors: weights that
//!   cancel.
//! - `polynomial_curve(n)`: every planar curve of degree `1 ≤ n ≤ 32`: `x = x0 + x1*v + …`, `y = y0 + y1*v + …`.
//! - `rational_curve(n)`: the same over the weight `w0 + w1*v + …`.
//! - `regular_curve(sigma, kappa)`: every regular planar curve with this parametric speed and curvature, given by
//!   scalars of the curve's parameter, unknown functions mostly: a curve in its moving frame (4).
//! - `curve_from_hodograph(h)`: the curve with `s' = h` for a vector `h`, without the integration: coordinates, and the
//!   arc length if `|h|` is rational, are symbols of which only the derivatives are known.
//!
//! - `ph_spatial([A0, …, Ak])`: the spatial PH curve `s' = A i A*` with `s(0) = 0`, where the preimage
//!   `A(v) = Σ A_j·C(k, j)·vʲ(1 − v)ᵏ⁻ʲ` has these quaternions for Bernstein coefficients. Its degree is 2k + 1.
//! - `ph_spatial(n)`: the same with an odd degree and symbols, `A_j = quat(aj, bj, cj, dj)`. Sweeps have room for those of n ≤ 9.
//! - `rrmf(A0, A1, c)`: the quintic `ph_spatial([A0, A1, A2])` with `A2 = -(c + A1*i*conj(A1))*A0*i/norm2(A0)`. For quaternions `A0 != 0` and
//!   `A1` and scalars `c` these are all quintics, but for those that begin with a cusp, for which `A0 i A2* + A2 i A0* = 2 A1 i A1*`
//!   (Farouki 2010): they have rational rotation-minimizing frames.
//! - `rrmf_hermite(a, da, db)`: such a quintic with `s(0) = a`, `s'(0) = da`, `s'(1) = db`, numbers each. It has three independent square
//!   roots at most: the lengths of the tangents, and one more. With `middle = z` for a real or complex number z it is that with `A1 =
//!   A0*(z + y*j)` for a complex y; `|z|^2` lies between bounds, which are stated if it does not. With `solution = 1` it is the other one of the
//!   two for a middle, with `A2*i*conj(A0)` of a scalar part that is not positive. For tangents that are not parallel these are all, each one for
//!   one middle and solution; tangents of the same direction are joined by a straight line (see
//!   [`SpatialHermite`](hodograph_algebra::SpatialHermite)).
//! - `ph_spatial(…, start = (x, y, z))`, `rrmf(…, start = (x, y, z))`: with that `s(0)`.
//!
//! The coefficients of `ph(n)`, `ph_spatial(n)`, `polynomial_curve` and `rational_curve` are symbols of the item. If it has several such
//! curves, the curve's name precedes theirs: `s_a0`.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! let judgements = judge(r#"lemma curves {
//!     function sigma(v), kappa(v);
//!     curve a(v) = ph([1, I], start = (5, 6), factor = 2);
//!     curve b(v) = ph(3);
//!     curve c(v) = ph_hermite((0, 0), (1, 0), (1, 0), (1, 0));
//!     curve d(v) = bezier([(1, 0), (1, 1), (0, 1)], weights = [1, 1, 2]);
//!     curve e(v) = polynomial_curve(1);
//!     curve f(v) = regular_curve(sigma, kappa);
//!     curve g(v) = curve_from_hodograph((1 - v^2, 2*v));
//!     claim "ph": a.hodograph == 2*(1 - 2*v, 2*v*(1 - v));
//!     claim "every PH cubic": b.speed(1) == b_a1^2 + b_b1^2;
//!     claim "Hermite": c == v*i;
//!     claim "circle": norm2(d) == 1;
//!     claim "line": e == (e_x0 + e_x1*v, e_y0 + e_y1*v);
//!     claim "(4)": diff(f.normal, v) == sigma*kappa*f.tangent;
//!     claim "hodograph": diff(g.arclength, v) == 1 + v^2;
//! }"#);
//! assert!(judgements.iter().all(|(verdict, _)| verdict == "proved"));
//! assert_eq!(judgements[0].1, "both sides are (-4*v + 2, -4*v^2 + 4*v, 0)");
//! ```
//!
//! # Members of curves
//!
//! For a curve `s(v)`; all but `offset` can be called, as in `s.normal(1/2)`.
//!
//! | member | what it is | equation |
//! | --- | --- | --- |
//! | `x`, `y`, `z` | the coordinates | |
//! | `hodograph` | the derivative `s'` | |
//! | `speed` | the parametric speed `σ = ‖s'‖` | (2) |
//! | `tangent` | the unit tangent `t = s'/σ` | (3) |
//! | `axis` | the unit vector `e` orthogonal to the plane of the curve | |
//! | `normal` | the unit normal `n = t × e`, to the right of the tangent | (3) |
//! | `curvature` | the signed curvature `κ = (s' × s'')·e/σ³` | (5) |
//! | `arclength` | the arc length `∫σ` from the beginning of the domain, or from 0 without one | (6) |
//! | `length` | the total arc length over the domain, `S` | (29) |
//! | `torsion` | `τ = (s' × s'')·s'''/‖s' × s''‖²` | |
//! | `preimage` | the preimage of `ph`, a complex polynomial, or of `ph_spatial`, a quaternion | |
//! | `frame`, `rmf`, `frenet` | see *Frames of curves* | |
//! | `offset(d)` | the offset curve `s + d·n` | (8) |
//! | `involute` | `s − s(v)·t`, with the arc length `s(v)` | (24) |
//! | `evolute` | `s − n/κ` | (28) |
//!
//! A curve may lie in any plane. The last component of `e` that is not zero is positive: `e` is `k` in the xy-plane, `j` in
//! the xz-plane, `i` in the yz-plane, and `(-3, 0, 4)/5` in the plane 4z = 3x. For a straight line, which lies in many
//! planes, it is that of the coordinate plane in which it lies, else of one to which it is parallel; xy before xz before
//! yz. Errors:
//!
//! - `speed`, and `tangent`, `normal`, `curvature`, `arclength` and all below it in the table: the curve is a point; `‖s'‖²`
//!   is not the square of a rational function; the root of it changes its sign on the domain, or anywhere if there is
//!   none. Where the sign depends on symbols, what is claimed of the curve holds under a condition such as `c > 0`: see
//!   [`Judgement::condition`].
//! - `axis`, `normal`, `curvature`, `offset`, `evolute`: the curve lies in no plane, or is a straight line that is parallel
//!   to no coordinate plane; or `e` contains the square root of a polynomial in symbols.
//! - `arclength`, `length`, `involute`: the integral of the speed is not a rational function, since it contains logarithms
//!   or arctangents, which the message shows; it is not known, since unknown functions occur in it; the speed has a pole
//!   on the domain. Symbols stand for general values. `length` needs a domain.
//! - `evolute`: the curvature is zero everywhere.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! // w = 1 + I v, so s = (v − v³/3, v²).
//! let judgements = judge(r#"lemma members {
//!     path s(v) = ph([1, 1 + I]);
//!     domain v in 0..1;
//!     claim "position": s == (v - v^3/3, v^2);
//!     claim "hodograph": s.hodograph == (1 - v^2, 2*v);
//!     claim "(2)": s.speed == 1 + v^2;
//!     claim "(3)": s.tangent(1) == j;
//!     claim "(3)": s.normal(1) == i;
//!     claim "axis": s.axis == k;
//!     claim "(5)": s.curvature == 2/(1 + v^2)^2;
//!     claim "(6)": s.arclength == v + v^3/3;
//!     claim "(6)": s.length == 4/3;
//!     claim "(8)": s.offset(3) == s + 3*s.normal;
//!     claim "(24)": s.involute(1) == (2/3, -1/3);
//!     claim "(28)": s.evolute(1) == (-4/3, 1);
//! }"#);
//! assert!(judgements.iter().all(|(verdict, _)| verdict == "proved"));
//! assert_eq!(judgements[8].1, "both sides are 4/3");
//! ```
//!
//! Rational curves, and curves in other planes, have the same members. The speed of this one in the plane x = y is the
//! derivative of a rational function; that of the circle is not:
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! let judgements = judge(r#"lemma arc_lengths {
//!     curve s(v) = (3*v^2 - 1)/(3*v^3)*(i + j)/sqrt(2) - k/v^2;
//!     curve c(v) = ((1 - v^2)/(1 + v^2), 2*v/(1 + v^2));
//!     domain v in 1..2;
//!     claim "speed": s.speed == (1 + v^2)/v^4;
//!     claim "axis": s.axis == (j - i)/sqrt(2);
//!     claim "arc length": s.arclength == 4/3 - 1/v - 1/(3*v^3);
//!     claim "circle": is_rational(c.arclength);
//! }"#);
//! let verdicts: Vec<&str> = judgements.iter().map(|(verdict, _)| verdict.as_str()).collect();
//! assert_eq!(verdicts, ["proved", "proved", "proved", "refuted"]);
//! assert_eq!(
//!     judgements[3].1,
//!     "the arc length is not rational: the integral of the parametric speed 2/(v^2 + 1) consists of logarithms or \
//!      arctangents",
//! );
//! ```
//!
//! Where symbols decide on the sign of the parametric speed, its condition is part of the judgement:
//!
//! ```
//! use hodograph_codegen::{language::parse_text, meaning::models};
//!
//! let text = r#"lemma line { symbol c; curve s(v) = c*v*(3, 4); claim "speed": s.speed == 5*c; }"#;
//! let (models, _mistakes) = models(&parse_text("line.sweep", text).unwrap().0);
//! let judgement = models[0].check(&models[0].claims[0], u64::MAX).unwrap();
//! assert_eq!(judgement.derived, "both sides are 5*c");
//! assert_eq!(judgement.condition.as_deref(), Some("c > 0"));
//! ```
//!
//! # Frames of curves
//!
//! A frame `(t, f, g)` of a curve is right-handed and orthonormal, with the unit tangent `t`. A curve of rational parametric
//! speed has three, which a plane contains or not:
//!
//! - `s.frame`, the Euler-Rodrigues frame `(A i A*, A j A*, A k A*)/σ` of the preimage `A`. It is always rational. For a
//!   curve that is given otherwise `A` is the quaternion polynomial of least degree along `σ + x' − z' j + y' k`.
//! - `s.rmf`, the rotation-minimizing frame that begins as `s.frame` where the domain does, or at 0. Whether it is rational is
//!   decided for every PH curve: if it is, it is the Euler-Rodrigues frame of `A*W` for a complex polynomial `W`, which is
//!   found from the residues of the function by which `s.frame` turns (see [`Rotation`](hodograph_algebra::Rotation)).
//! - `s.frenet`, the tangent, the principal normal and the binormal.
//!
//! | member | what it is |
//! | --- | --- |
//! | `tangent`, `f`, `g` | the vectors |
//! | `normal`, `binormal` | those of `frenet` |
//! | `spin` | `f'·g`, the rotation about the tangent by the parameter; of `frenet` that is `σ τ`, also where the frame is not rational |
//! | `preimage` | the quaternion polynomial of which it is the Euler-Rodrigues frame; not of `frenet` |
//! | `rotation` | of `rmf`: the complex polynomial `W` with the angle `2 arg W` between it and `frame` |
//!
//! All can be called, as in `s.rmf.f(1/2)`; where the Frenet frame is not rational, its vectors at numbers are made of square
//! roots. Errors: those of `speed`; the frame is not rational, with the reason. `is_rational(s.rmf)` is refuted then, for a curve
//! with symbols in general.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! let judgements = judge(r#"lemma frames {
//!     let A1 = quat(1, 2, 1, 0);
//!     path s(v) = rrmf(2, A1, 2);
//!     curve c(v) = ph_spatial([1, A1]);
//!     curve h(v) = rrmf_hermite((1, 0, 0), 4*i, 4*j, middle = (2 + I)/3);
//!     let A(v) = s.preimage;
//!     claim "product": A1*i*conj(A1) == (4, 4, -2);
//!     claim "hodograph": s.hodograph == A*i*conj(A);
//!     claim "speed": s.speed(0) == 4;
//!     claim "no rotation": dot(diff(s.rmf.f, v), s.rmf.g) == 0;
//!     claim "right-handed": cross(s.rmf.tangent, s.rmf.f) == s.rmf.g;
//!     claim "rotation": 2*s.rmf.rotation == (1 - v)^2*4 + 2*(1 - v)*v*(2 - 4*I) + v^2*(6 + 2*I);
//!     claim "Frenet": s.frenet.normal(0) == -s.rmf.g(0);
//!     claim "its spin": s.frenet.spin(0) == 6;
//!     claim "Hermite": h.hodograph(1) == 4*j;
//!     claim "cubic": is_rational(c.frenet);
//!     claim "no frame": is_rational(c.rmf), expect refuted;
//! }"#);
//! let verdicts: Vec<&str> = judgements.iter().map(|(verdict, _)| verdict.as_str()).collect();
//! assert_eq!(verdicts[..10], ["proved"; 10]);
//! assert_eq!(verdicts[10], "refuted");
//! assert!(judgements[10].1.contains("at the zeros of 5*v^2 + 1 the residues"));
//! ```
//!
//! # Frames
//!
//! A motion moves a curve through frames: positions, orientations and sizes (JW is Johnstone and Williams, *A rational model of the surface swept by a
//! curve*, 1995; its Definition 1). It is piecewise rational in its parameter, with a piece between each two frames.
//!
//! - `frame(p, q)`, `frame(p, q, s)`: the frame with the position p, the unit quaternion q = `(w, x, y, z)` or `quat(w, x, y, z)` and the scale s, which is 1
//!   where it is not given.
//! - `frames([f0, f1, …])`: the motion through two to 64 frames ([`MAX_FRAMES`](hodograph_algebra::MAX_FRAMES)).
//! - `frames_file("turn.json")`: the same with the frames in a file, `[{"position": [0, 0, 0.5], "quaternion": ["3/5", 0, 0, "4/5"],
//!   "scale": 1}, …]`. Its numbers are decimals, or texts with decimals or quotients of integers; all of them are exact. The path is
//!   relative to the folder of the source; in the body of a macro, to that of `Cargo.toml`.
//!
//! Both stand in a clause `frames F(v) = …;` alone. Options follow with their names:
//!
//! | option | what it is |
//! | --- | --- |
//! | `knots = [0, 1, 3]` | the parameter at each frame; 0, 1, 2, … without |
//! | `end = natural`, `rest`, `periodic` | the splines bend least; have zero derivatives at both ends; go on smoothly where they began, if the last frame is the first |
//! | `tangents = [a, b]` | the derivatives of the position at both ends, in place of what `end` says |
//! | `continuity = 2`, `1` | the splines are cubic and C², or quadratic and C¹; `(2, 1, 2)`: those of position, orientation and scale |
//! | `orientation = sphere`, `direct` | as in JW by the map M of 4-space onto the unit quaternions; or by the spline through the quaternions themselves, and its homogeneous Euler–Rodrigues matrix, of half the degree |
//! | `preimage = projective`, `unit`, `positive` | for `sphere`, the point of 4-space for a quaternion: `(x, y, z, 1 − w)`, which takes no root; the same of length 1; as JW (5) has it |
//! | `normalize = yes` | divide the quaternions by their lengths, which may adjoin square roots |
//!
//! A quaternion and its negative are one orientation; that one is taken which is nearer to the one before (the shortest arc). The same
//! choice is made among a point of 4-space and its negative, which M maps to one quaternion, except with `positive`. M⁻¹ is undefined at
//! the orientation without a turn: there a point of the hyperplane that M maps to it is taken, as [`Motion`](hodograph_algebra::Motion)
//! says.
//!
//! | member of a motion `F` | what it is |
//! | --- | --- |
//! | `F.position`, `F.scale` | the position `P(v)` of the reference point, the size `S(v)` |
//! | `F.quaternion` | the unit quaternion of the orientation; with `direct`, one of any length |
//! | `F.curve` | the curve in 4-space that the orientation comes from, a tuple of four |
//! | `F.weight` | the denominator of the rotation matrix `O(v)` |
//! | `F.rotate(c)` | `O(v) c`, for a point or a curve c |
//! | `F.sweep(c)` | the sweep `P(v) + O(v) S(v) c`, exactly (JW (1)) |
//! | `F.published(c)` | the surface of the control net that JW prints in Theorem 7.1, or 7.2 where scales differ, with the rotation (11); Lemma 6.2 prints the transposed matrix |
//!
//! An item with three frames or more is evaluated once for each piece. Its parameter runs from the first knot to the last one; `domain`
//! need not say so. All frames of an item have one parameter and the same knots; in a sweep it is the surface's second parameter. Of a
//! sweep in several pieces each piece is a [`Model`] of its own: see [`Model::piece`]. A claim holds if it holds on all pieces; a value
//! `f(1/2)` is taken in the piece that it belongs to.
//!
//! - `continuity(f)`, in claims: up to which order the derivatives of f by the frames' parameter agree at all joints; 9 at most, −1 where
//!   f itself jumps.
//! - `bernstein([b0, …, bn], t)`: the polynomial in t with these scalars or vectors for Bernstein coefficients.
//! - `bernstein_product([b0, …, bm], [c0, …, cn])`: the list of the Bernstein coefficients of the product (JW Lemma 5.1).
//! - `bernstein_coefficient(f, v, n, k)`: the k-th Bernstein coefficient of degree n of a polynomial on the domain of v.
//!
//! Errors: fewer than two frames, or more than 64; a quaternion that is zero or has another length than 1; a scale that is not positive; a
//! frame that is the one before it; knots that do not increase; an end that the splines cannot have. In a file they are shown with the
//! file's line and column.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::models};
//! # fn judge(text: &str) -> Vec<(String, String)> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     let check = |claim| models[0].check(claim, u64::MAX).unwrap();
//! #     models[0].claims.iter().map(check).map(|j| (j.verdict.to_string(), j.derived)).collect()
//! # }
//! let judgements = judge(r#"sweep turn {
//!     profile c(u) = (0, u, 0);
//!     frames F(v) = frames([
//!         frame((0, 0, 0), (1, 0, 0, 0)),
//!         frame((2, 0, 0), (4/5, 0, 0, 3/5)),
//!         frame((2, 2, 0), (-3/5, 0, 0, -4/5))], orientation = direct);
//!     surface R = F.sweep(c);
//!     domain u in 0..1;
//!     claim "frame": R(1, 1) == (2, 0, 0) + (-24, 7, 0)/25;
//!     claim "shortest arc": F.quaternion(2).z == 4/5;
//!     claim "degree": degree(R) == (1, 9);
//!     claim "joint": continuity(R) == 2;
//!     claim "rigid": norm2(diff(R, u)) == 1;
//!     claim "product": bernstein(bernstein_product([0, 1], [1, 1]), u) == u;
//!     claim "coefficient": bernstein_coefficient(u^2, u, 3, 2) == 1/3;
//! }"#);
//! assert!(judgements.iter().all(|(verdict, _)| verdict == "proved"), "{judgements:?}");
//! assert_eq!(judgements[3].1, "both sides are 2");
//! ```
//!
//! # Members of surfaces and vectors
//!
//! | of | members |
//! | --- | --- |
//! | vectors | `x`, `y`, `z` |
//! | quaternions | `w`, `x`, `y`, `z`, and `vector`, the part without `w` |
//! | homogeneous coordinates | `W`, `X`, `Y`, `Z` |
//! | surfaces and their offsets | `x`, `y`, `z`; `W`, `X`, `Y`, `Z` without common factor (10); those of *Fundamental forms* |
//!
//! # Claims
//!
//! `claim "id": relation, "note", expect refuted, when c == 1;` settles a relation. After it stand, in any order,
//! remarks, the verdict that is expected (*proved* if none is given), and conditions; see *Conditions*. Ids need not be
//! unique. Two kinds of remarks have a word before them, for the reader of a source that is wrong; see *Errors of sources*.
//!
//! | relation | holds if |
//! | --- | --- |
//! | `a == b` | both are the same function: scalars, complex numbers, vectors, tuples of one length |
//! | `a != b` | they are not: `not a == b` |
//! | `a < b`, `a <= b`, `a > b`, `a >= b` | it holds for the scalars at all points of the domain |
//! | `degree(…) == (2, 9)` | the degrees are these; with `<=` and the others, if it holds for both |
//! | `degree(…, parameter = v) == 4` | the degree is this |
//! | `positive(a)` | `a > 0` on the domain |
//! | `parallel(a, b)` | neither is zero and each is a multiple of the other by a scalar function: vectors, or tuples of one length |
//! | `coprime(f, g, …)` | the polynomials, two at least, have no common factor |
//! | `is_pn(R)` | the unit normal of the surface is rational in the given parameters, over the real numbers: a Pythagorean-normal surface |
//! | `is_rational(a)` | the value exists as a rational function of the given parameters, over the real numbers |
//! | `approx(a, 1.4142)` | the number differs from the decimal by half a unit of its last digit at most |
//! | `not relation` | the relation is refuted |
//!
//! - *Proved* and *refuted* are exact. *Undecided* are inequalities whose sides contain symbols or unknown functions,
//!   or a denominator that may vanish on the domain, or that touch zero where subdivision finds no end; and all that
//!   exceeds the budget; and what holds or fails in general, where no values of the symbols near which its conditions hold
//!   were found. `not` leaves them undecided.
//! - An inequality needs a domain for each parameter that occurs; the ends of the intervals belong to it.
//! - What is proved of symbols and unknown functions holds for all of their values, except that degrees and common
//!   factors, also those that `gcd` and `homogeneous` find, are those of general values: special values of symbols can
//!   lower a degree or bring a common factor, and which ones do stands among
//!   the *Conditions*. What is refuted may hold for special values. [`Judgement::scope`] says it.
//! - Where an equality, `parallel` or an inequality is refuted, [`Judgement::witness`] is a point at which it fails,
//!   with both sides, for values of the symbols that satisfy the claim's conditions.
//! - `is_rational` is refuted for irrational speeds, arc lengths and roots, for what is made of them, and for offsets of
//!   surfaces; in other parameters they may be rational. What depends on symbols alone is a number: `sqrt(c)` is rational
//!   where `c >= 0`. The offset at the distance 0 is the surface itself.
//!
//! ```
//! # use hodograph_codegen::{language::parse_text, meaning::{Judgement, models}};
//! # fn judge(text: &str) -> Vec<Judgement> {
//! #     let (models, mistakes) = models(&parse_text("example", text).unwrap().0);
//! #     assert!(mistakes.is_empty(), "{mistakes:?}");
//! #     models[0].claims.iter().map(|claim| models[0].check(claim, u64::MAX).unwrap()).collect()
//! # }
//! let judgements = judge(r#"lemma relations {
//!     symbol c;
//!     curve q(v) = (v, v^2);
//!     domain u in 0..1, v in 0..1;
//!     claim "1": u*v <= 1;
//!     claim "2": u*v < 1;
//!     claim "3": positive(c);
//!     claim "4": parallel((u, v, 1), (u*v, v^2, v));
//!     claim "5": coprime(u^2 - 1, v, u + 1);
//!     claim "6": is_rational(q.speed), "a parabola", expect refuted;
//!     claim "7": approx(sqrt(2), 1.4142);
//!     claim "8": not u == v;
//!     claim "9": degree(c*u*v) <= (1, 1);
//!     claim "10": c^2 == c, when c == 1;
//! }"#);
//! let verdicts: Vec<String> = judgements.iter().map(|judgement| judgement.verdict.to_string()).collect();
//! assert_eq!(
//!     verdicts,
//!     [
//!         "proved", "refuted", "undecided", "proved", "proved", "refuted", "proved", "proved", "proved", "proved",
//!     ],
//! );
//! assert_eq!(judgements[1].witness.as_deref(), Some("u = 1, v = 1"));
//! assert_eq!(judgements[5].expected, judgements[5].verdict);
//! assert_eq!(judgements[8].scope, "all c");
//! assert_eq!(judgements[9].condition.as_deref(), Some("c == 1"));
//! ```
//!
//! ## Conditions
//!
//! [`Judgement::condition`] is what must hold of the symbols, which are real: relations of the language, joined by `and`.
//!
//! - Stated ones: `when c1 == 2*c0` puts a scalar in place of a symbol, the last one in which the equation is linear with a
//!   number for its coefficient; `when c0 != 0`, `when c0 > 0`, `when not c0 <= 1` are taken for granted. They contain no
//!   parameters. Equations come first. Errors: an equation that cannot be solved; a condition that never holds.
//! - The signs that parametric speeds are taken to have.
//! - For a statement on degrees, `coprime`, and an equation with `gcd`, `homogeneous` or a homogeneous coordinate: that not
//!   all leading coefficients vanish, and that no new common factor appears (of surfaces, that W is not zero either). A
//!   bound that special values cannot break, such as `degree(X) <= (2, 9)`, needs none. For `a != b`: that not all
//!   coefficients of the difference vanish. Two polynomials with a resultant that is too long are given as `resultant(f, g, parameter = v) != 0`. `general values of the symbols` stands for what
//!   is not determined within the budget. See [`Conditions`](hodograph_algebra::Conditions).
//!
//! ```
//! use hodograph_codegen::{language::parse_text, meaning::models};
//!
//! let text = r#"sweep parabolas {
//!     symbol a, b, c;
//!     surface R = (u, v*(u - a)/(u - b), c*v^2);
//!     domain u in 0..1, v in 0..1;
//!     claim "Z": degree(Z) == (1, 2);
//!     claim "Z": degree(Z) == (1, 2), when c > 0;
//!     claim "Z": degree(Z) == (1, 2), when a == b + 1;
//!     claim "bound": degree(Z) <= (1, 2);
//!     claim "other": R.z != v^2;
//! }"#;
//! let (models, _mistakes) = models(&parse_text("parabolas.sweep", text).unwrap().0);
//! let condition = |claim| models[0].check(claim, u64::MAX).unwrap().condition.unwrap_or_default();
//! let conditions: Vec<String> = models[0].claims.iter().map(condition).collect();
//! assert_eq!(conditions[..3], ["c != 0 and a - b != 0", "c > 0 and a - b != 0", "a == b + 1 and c != 0"]);
//! assert_eq!(conditions[3..], ["", "c - 1 != 0"]);
//! ```
//!
//! ## Errors of sources
//!
//! A claim that a source makes and that does not hold is stated as the source has it, with `expect refuted`.
//!
//! - `effect major "…"` says what the mistake means for whoever uses what is claimed, and how grave that is: `major` if one
//!   gets another surface or a wrong value; `moderate` if a condition is missing, or what is possible is missed; `minor` if a
//!   number is misprinted, or nothing is computed from it.
//! - `instead "…"` marks a further claim of the same id as what holds in place of those that are refuted, and says in words
//!   what differs. It is proved like any other.
//!
//! The command `hodograph errors` makes a page of them: [`Judgement::effect`], [`Judgement::instead`]. How a verdict comes
//! about, step by step, is what [`Model::explain`] says.
//!
//! ```
//! use hodograph_codegen::language::{ast::{Severity, Verdict}, parse_text};
//! use hodograph_codegen::meaning::models;
//!
//! let text = r#"lemma square {
//!     claim "(1)": (1 + 2)^2 == 1^2 + 2^2, "as printed", effect major "areas come out too small", expect refuted;
//!     claim "(1)": (1 + 2)^2 == 1^2 + 2*1*2 + 2^2, instead "with the mixed product";
//! }"#;
//! let (models, _mistakes) = models(&parse_text("square.sweep", text).unwrap().0);
//! let judge = |index: usize| models[0].check(&models[0].claims[index], u64::MAX).unwrap();
//! let (printed, right) = (judge(0), judge(1));
//! assert_eq!(printed.effect, Some((Severity::Major, "areas come out too small".to_owned())));
//! assert_eq!((printed.verdict, right.verdict), (Verdict::Refuted, Verdict::Proved));
//! assert_eq!(right.instead.as_deref(), Some("with the mixed product"));
//!
//! let explanation = models[0].explain(&models[0].claims[0], u64::MAX, false).unwrap();
//! let steps: Vec<String> =
//!     explanation.steps.iter().map(|step| format!("{}: {}", step.what, step.formula)).collect();
//! assert_eq!(
//!     steps,
//!     [
//!         "claim: (1 + 2)^2 == 1^2 + 2^2",
//!         "left side: (1 + 2)^2 = 9",
//!         "right side: 1^2 + 2^2 = 5",
//!         "difference: 4",
//!         "witness: left 9, right 5",
//!         "verdict: refuted",
//!     ],
//! );
//! ```
//!
//! # Limits
//!
//! | what | limit |
//! | --- | --- |
//! | length of a text | 2²⁰ bytes ([`MAX_LENGTH`](crate::language::MAX_LENGTH)) |
//! | nesting of an expression | 256 levels to be read ([`MAX_DEPTH`](crate::language::MAX_DEPTH)), 64 to be evaluated |
//! | exponents | ±1000 ([`MAX_EXPONENT`]) |
//! | numbers | 4096 digits; decimals up to 4096 places up or down ([`MAX_DECIMAL_EXPONENT`](hodograph_algebra::MAX_DECIMAL_EXPONENT)) |
//! | independent square roots in a number | 16 |
//! | order of `diff` | 100; 6 for an unknown function |
//! | degree of `ph(n)`; of symbolic curves | 201; 32, and no more symbols than one polynomial has room for: 22 in a sweep, those of `ph(21)` |
//! | control points of `bezier`, coefficients of `bernstein`; control points of `bezier_patch` | 101; 33 rows and columns |
//! | frames of a motion | 64 ([`MAX_FRAMES`](hodograph_algebra::MAX_FRAMES)) |
//! | work for all clauses of a file, but for the claims | [`DEFAULT_LIMIT`](hodograph_algebra::budget::DEFAULT_LIMIT) units, or what [`models_within`] is given |
//! | work for one claim | what [`Model::check`] is given |
//!
//! # Mistakes
//!
//! [`models`] reports the mistakes of all clauses, and unknown names in claims; [`Model::check`] those in the claim
//! itself. What depends on a definition with a mistake is not reported again.
//!
//! ```
//! use hodograph_codegen::language::{Report, parse_text};
//! use hodograph_codegen::meaning::models;
//!
//! let text = "lemma mistakes {\n  let a = 1 + i;\n  let b = 2*a;\n  let c = sqrt(-2);\n}";
//! let (file, source) = parse_text("t", text).unwrap();
//! let report = Report::new(source, models(&file).1);
//! assert_eq!(
//!     report.lines(),
//!     ["t:2:15: a number and a vector cannot be added", "t:4:16: the radicand -2 is negative"],
//! );
//! ```
#![doc = include_str!("frames.md")]

mod assumptions;
mod bernstein;
mod calls;
mod curves;
mod explain;
mod expression;
mod fault;
mod finding;
mod frames;
mod frames_file;
mod functions;
mod generality;
mod generic;
mod group;
mod inequality;
mod item;
mod judgement;
mod members;
mod number;
mod pieces;
mod products;
mod rationality;
mod relation;
mod roots;
mod scope;
mod spatial;
mod surfaces;
mod value;
mod witness;

pub use explain::{Explanation, Step};
pub use expression::MAX_EXPONENT;
pub use group::{CoefficientGroup, CoefficientKind};
pub use item::{Model, models, models_within};
pub use judgement::Judgement;
pub use number::number;
pub use pieces::Piece;
