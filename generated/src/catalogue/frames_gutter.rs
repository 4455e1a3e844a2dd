/// A gutter: half a circle that goes downhill through four frames, turns to both sides and is wider in the middle.
///
/// Position, orientation and size are C2 cubic splines through the frames; that of the orientation is in the 4-space that Euler's map M folds
/// onto the sphere of unit quaternions, with rational points for the rational frames.
///
/// ```text
/// profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));
/// frames F(v) = frames_file("gutter.json");
/// surface R = F.sweep(c);
/// domain u in -1..1;
/// ```
///
/// Source: `JW (1)`.
///
/// - Degree (2, 15): W (2, 12), X (2, 15), Y (2, 15), Z (2, 15).
/// - Domain: u from -1.0 to 1.0, v from 0.0 to 1.0.
/// - W ≠ 0 on the domain: certified.
/// - R_u × R_v ≠ 0 on the domain: certified.
///
/// | operations | at one place | on a grid for each v | for each u | for each point |
/// | --- | --- | --- | --- | --- |
/// | homogeneous coordinates | 183: 78 +, 105 × | 70 +, 94 × | 2 +, 1 × | 6 +, 10 × |
/// | point | 171: 77 +, 93 ×, 1 ÷ | 69 +, 83 × | 2 +, 1 × | 6 +, 9 ×, 1 ÷ |
/// | point, separated | 177: 77 +, 98 ×, 2 ÷ | 69 +, 89 ×, 1 ÷ | 2 +, 3 ×, 1 ÷ | 6 +, 6 × |
/// | point and first derivatives | 425: 192 +, 230 ×, 3 ÷ | 175 +, 205 ×, 2 ÷ | 2 +, 7 ×, 1 ÷ | 15 +, 18 × |
/// | point, first and second derivatives | 653: 293 +, 357 ×, 3 ÷ | 263 +, 308 ×, 2 ÷ | 4 +, 13 ×, 1 ÷ | 26 +, 36 × |
/// | unit normal | 819: 405 +, 412 ×, 1 ÷, 1 √ | 391 +, 388 × | 3 × | 14 +, 21 ×, 1 ÷, 1 √ |
/// | everything: derivatives, normal, fundamental forms, curvatures | 2363: 1124 +, 1227 ×, 8 ÷, 4 √ | 1027 +, 1074 ×, 3 ÷ | 4 +, 15 ×, 1 ÷ | 93 +, 138 ×, 4 ÷, 4 √ |
///
/// | error at most | `f64` plain | fused | `f32` plain | fused | size from | to | each, `f64` plain | relative |
/// | --- | --- | --- | --- | --- | --- | --- | --- | --- |
/// | homogeneous | 2.54e2 | 2.19e2 | 1.36e11 | 1.17e11 | 1.83e17 | 2.24e17 | 8.88e1, 2.46e2, 1.41e2, 2.54e2 | 1.02e-15, –, –, 1.73e-14 |
/// | point | 3.94e-15 | 2.97e-15 | 2.36e-6 | 1.84e-6 | 4.15e0 | 4.41e0 | 1.99e-15, 2.81e-15, 3.94e-15 | –, –, 1.61e-14 |
/// | separated point | 4.06e-15 | 3.03e-15 | 2.42e-6 | 1.87e-6 | 4.15e0 | 4.41e0 | 1.94e-15, 2.78e-15, 4.06e-15 | –, –, 1.63e-14 |
/// | partial u | 6.02e-15 | 4.72e-15 | 3.57e-6 | 2.88e-6 | 2.25e0 | 2.34e0 | 3.04e-15, 5.01e-15, 6.02e-15 | –, –, – |
/// | partial v | 3.66e-15 | 3.11e-15 | 1.96e-6 | 1.67e-6 | 4.64e0 | 4.72e0 | 3.66e-15, 2.43e-15, 1.76e-15 | 9.25e-16, 2.33e-14, – |
/// | partial uu | 1.88e-14 | 1.55e-14 | 1.11e-5 | 9.28e-6 | 4.79e0 | 5.06e0 | 5.17e-15, 9.99e-15, 1.88e-14 | –, –, – |
/// | partial uv | 5.44e-15 | 4.43e-15 | 2.92e-6 | 2.38e-6 | 1.42e0 | 1.54e0 | 5.44e-15, 4.5e-15, 3.28e-15 | –, –, – |
/// | partial vv | 1.68e-14 | 1.5e-14 | 9.27e-6 | 8.29e-6 | 4.27e0 | 4.49e0 | 1.12e-14, 1.44e-14, 1.68e-14 | –, –, – |
/// | unit normal | 5.46e-15 | 4.55e-15 | 3.06e-6 | 2.57e-6 | 9.43e-1 | 1e0 | 2.42e-15, 5.46e-15, 4.07e-15 | –, –, – |
/// | first form | 5.07e-14 | 4.3e-14 | 2.76e-5 | 2.34e-5 | 2.53e1 | 2.62e1 | 3.88e-14, 3.4e-14, 5.07e-14 | 1.07e-14, –, 2.45e-15 |
/// | second form | 5.04e-14 | 4.33e-14 | 2.74e-5 | 2.36e-5 | 4.66e0 | 6.33e0 | 4e-14, 4.48e-14, 5.04e-14 | 1.68e-14, –, – |
/// | gaussian | 1.55e-13 | 1.39e-13 | 8.41e-5 | 7.56e-5 | 8.08e-2 | 2.42e0 | 1.55e-13 | – |
/// | mean | 2.95e-14 | 2.61e-14 | 1.61e-5 | 1.43e-5 | 4.43e-1 | 1.2e0 | 2.95e-14 | – |
/// | principal | 7.66e-14 | 6.88e-14 | 4.17e-5 | 3.74e-5 | 8.28e-1 | 2.77e0 | 7.65e-14, 7.66e-14 | –, – |
/// | speeds | 8.05e-15 | 6.8e-15 | 4.64e-6 | 3.9e-6 | 5.01e0 | 5.12e0 | 8.05e-15, 5.6e-15 | 4.53e-15, 1.29e-15 |
/// | normal u | 1.37e-13 | 1.24e-13 | 7.41e-5 | 6.73e-5 | 1.8e0 | 5.02e0 | 1.37e-13, 1.18e-13, 7.75e-14 | –, –, – |
/// | normal v | 1.58e-13 | 1.41e-13 | 8.52e-5 | 7.58e-5 | 4.19e-1 | 3.67e0 | 1.58e-13, 1.09e-13, 7.22e-14 | –, –, – |
#[allow(
    clippy::approx_constant,
    clippy::doc_markdown,
    clippy::excessive_precision,
    clippy::float_cmp,
    clippy::many_single_char_names,
    clippy::missing_const_for_fn,
    clippy::possible_missing_comma,
    clippy::similar_names,
    clippy::suboptimal_flops,
    clippy::trivially_copy_pass_by_ref,
    clippy::unreadable_literal,
    clippy::unused_self
)]
pub mod frames_gutter_1 {
    /// The surface `frames_gutter_1` as a value.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct FramesGutter1;
    impl FramesGutter1 {
        /// The name of the sweep.
        pub const NAME: &'static str = "frames_gutter_1";
        /// The formula that it was generated from.
        pub const FORMULA: &'static str = "profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));\nframes F(v) = frames_file(\"gutter.json\");\nsurface R = F.sweep(c);\ndomain u in -1..1;";
        /// Where the formula is from.
        pub const SOURCE: ::core::option::Option<&'static str> = ::core::option::Option::Some(
            "JW (1)",
        );
        /// The patch degree in u and v.
        pub const DEGREE: (u32, u32) = (2, 15);
        /// The parameters over which the surface is stated.
        pub const DOMAIN: ::hodograph::Domain = ::hodograph::Domain {
            u: [-1.0, 1.0],
            v: [0.0, 1.0],
        };
        /// Homogeneous Bézier control points (W, X, Y, Z) over the domain, rounded; the index of u is the outer one.
        pub const CONTROL_NET: [[f64; 4]; 48] = [
            [
                1.07824571296875e17,
                5.79664895292e16,
                -9.0917678517525e16,
                2.1564914259375e17,
            ],
            [
                9.3883330166175e16,
                8.1803627577504e16,
                -6.6284357270103e16,
                1.82648062175175e17,
            ],
            [
                8.240091277003432e16,
                9.817658186539062e16,
                -4.721798344534226e16,
                1.5553055348836147e17,
            ],
            [
                7.31132247684678e16,
                1.0933921978683157e17,
                -3.2640715834625056e16,
                1.3350763628521314e17,
            ],
            [
                6.573691587883289e16,
                1.171908824924616e17,
                -2.1539045617878784e16,
                1.1580122634970122e17,
            ],
            [
                5.999400744796277e16,
                1.2323769181429982e17,
                -1.3034732021198128e16,
                1.0168270600196981e17,
            ],
            [
                5.563035995472815e16,
                1.2861300912893344e17,
                -6417932287820707.0,
                9.050009547637272e16,
            ],
            [
                5.242604099699306e16,
                1.341391603851325e17,
                -1146633005240360.0,
                8.169294612624691e16,
            ],
            [
                5.019719476826027e16,
                1.4040427678228838e17,
                3175059837448051.0,
                7.479511532964574e16,
            ],
            [
                4.879069882808803e16,
                1.4782752959449728e17,
                6824032721586993.0,
                6.9427096818667864e16,
            ],
            [
                4.807432782146978e16,
                1.5669440429647587e17,
                9979105547494892.0,
                6.528170433658494e16,
            ],
            [
                4.7925931410673176e16,
                1.67158676487076e17,
                1.2733874361255066e16,
                6.210878164102684e16,
            ],
            [
                4.822500151036167e16,
                1.7922346845179904e17,
                1.5108262496497286e16,
                5.970423111010239e16,
            ],
            [
                4.884892193892857e16,
                1.9272277384473213e17,
                1.7066558023392858e16,
                5.790474943392857e16,
            ],
            [4.96744970625e16, 2.0732283028125e17, 1.854430621875e16, 5.6585631375e16],
            [5.05838671875e16, 2.22553828125e17, 1.9480341796875e16, 5.565744140625e16],
            [0.0, 0.0, 0.0, -1.07824571296875e17],
            [0.0, -794061500400000.0, 2722496572800000.0, -9.53209911168e16],
            [0.0, -1562890033542857.3, 5142937508228571.0, -8.47979967669786e16],
            [0.0, -2298998183515516.5, 7293477907175736.0, -7.61117910850929e16],
            [0.0, -2990176273459384.5, 9211742177367244.0, -6.907600577226666e16],
            [0.0, -3620298701197223.0, 1.0940097430953134e16, -6.349095587871476e16],
            [0.0, -4170542517593101.0, 1.25230817839887e16, -5.9168724174702984e16],
            [0.0, -4621030252991371.0, 1.4002265533657728e16, -5.59506864122937e16],
            [0.0, -4952822677076140.0, 1.540859617450857e16, -5.3715629048210024e16],
            [0.0, -5150057524325281.0, 1.6753231453145912e16, -5.237837229840149e16],
            [0.0, -5201933084372967.0, 1.801868462159114e16, -5.188033347574138e16],
            [0.0, -5104254463796374.0, 1.9152553538039736e16, -5.217448854538947e16],
            [0.0, -4860427617914835.0, 2.0066146897816484e16, -5.32078097462639e16],
            [0.0, -4482103467857143.0, 2.0639929255714284e16, -5.490473461071429e16],
            [0.0, -3990211875000000.0, 2.07363290625e16, -5.715544359375e16],
            [0.0, -3417187500000000.0, 2.0218359375e16, -5.9812646484375e16],
            [
                1.07824571296875e17,
                -5.79664895292e16,
                9.0917678517525e16,
                2.1564914259375e17,
            ],
            [
                9.3883330166175e16,
                -2.4297189552504e16,
                9.2162254381353e16,
                1.88093055320775e17,
            ],
            [
                8.240091277003432e16,
                903447178095085.8,
                9.180399651491083e16,
                1.6581642850481862e17,
            ],
            [
                7.31132247684678e16,
                1.992092016319662e16,
                9.066559256427373e16,
                1.480945920995646e17,
            ],
            [
                6.573691587883289e16,
                3.469100357344315e16,
                8.940906962727131e16,
                1.342247107044357e17,
            ],
            [
                5.999400744796277e16,
                4.676841771513578e16,
                8.852363647205014e16,
                1.2356290086387608e17,
            ],
            [
                5.563035995472815e16,
                5.735456090362649e16,
                8.834332077061504e16,
                1.1554625904435011e17,
            ],
            [
                5.242604099699306e16,
                6.736385819674051e16,
                8.908371095167093e16,
                1.0969747719356238e17,
            ],
            [
                5.019719476826027e16,
                7.750103261178302e16,
                9.088168488247638e16,
                1.056123076786629e17,
            ],
            [
                4.879069882808803e16,
                8.832250451523086e16,
                9.382213796054568e16,
                1.029335597249597e17,
            ],
            [
                4.807432782146978e16,
                1.0026485656181763e17,
                9.79426909023327e16,
                1.0131907357976723e17,
            ],
            [
                4.7925931410673176e16,
                1.1363911928254643e17,
                1.032189035883112e17,
                1.0041388871710632e17,
            ],
            [
                4.822500151036167e16,
                1.2860549809548992e17,
                1.0954246738578003e17,
                9.983652490573536e16,
            ],
            [
                4.884892193892857e16,
                1.4515175680955357e17,
                1.1670676569160714e17,
                9.918460794535714e16,
            ],
            [4.96744970625e16, 1.6309508371875e17, 1.2440912090625e17, 9.80582895e16],
            [5.05838671875e16, 1.82117109375e17, 1.32271259765625e17, 9.609416015625e16],
        ];
        /// Proved bounds of the errors of the evaluators over the domain.
        pub const BOUNDS: ::hodograph::Bounds = ::hodograph::Bounds {
            homogeneous: ::hodograph::Bound {
                errors: [254.0, 219.0, 136000000000.0, 117000000000.0],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 1.83e17,
                most: 2.24e17,
            },
            point: ::hodograph::Bound {
                errors: [3.94e-15, 2.97e-15, 2.36e-6, 1.84e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.15,
                most: 4.41,
            },
            coordinates: [
                [1.99e-15, 1.76e-15, 1.1e-6, 9.69e-7],
                [2.81e-15, 2.41e-15, 1.56e-6, 1.34e-6],
                [3.94e-15, 2.97e-15, 2.36e-6, 1.84e-6],
            ],
            separated_point: ::hodograph::Bound {
                errors: [4.06e-15, 3.03e-15, 2.42e-6, 1.87e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.15,
                most: 4.41,
            },
            partial_u: ::hodograph::Bound {
                errors: [6.02e-15, 4.72e-15, 3.57e-6, 2.88e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 2.25,
                most: 2.34,
            },
            partial_v: ::hodograph::Bound {
                errors: [3.66e-15, 3.11e-15, 1.96e-6, 1.67e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.64,
                most: 4.72,
            },
            partial_uu: ::hodograph::Bound {
                errors: [1.88e-14, 1.55e-14, 1.11e-5, 9.28e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.79,
                most: 5.06,
            },
            partial_uv: ::hodograph::Bound {
                errors: [5.44e-15, 4.43e-15, 2.92e-6, 2.38e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 1.42,
                most: 1.54,
            },
            partial_vv: ::hodograph::Bound {
                errors: [1.68e-14, 1.5e-14, 9.27e-6, 8.29e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.27,
                most: 4.49,
            },
            unit_normal: ::hodograph::Bound {
                errors: [5.46e-15, 4.55e-15, 3.06e-6, 2.57e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.943,
                most: 1.0,
            },
            first_form: ::hodograph::Bound {
                errors: [5.07e-14, 4.3e-14, 2.76e-5, 2.34e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 25.3,
                most: 26.2,
            },
            second_form: ::hodograph::Bound {
                errors: [5.04e-14, 4.33e-14, 2.74e-5, 2.36e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.66,
                most: 6.33,
            },
            gaussian: ::hodograph::Bound {
                errors: [1.55e-13, 1.39e-13, 8.41e-5, 7.56e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.0808,
                most: 2.42,
            },
            mean: ::hodograph::Bound {
                errors: [2.95e-14, 2.61e-14, 1.61e-5, 1.43e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.443,
                most: 1.2,
            },
            principal: ::hodograph::Bound {
                errors: [7.66e-14, 6.88e-14, 4.17e-5, 3.74e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.828,
                most: 2.77,
            },
            speeds: ::hodograph::Bound {
                errors: [8.05e-15, 6.8e-15, 4.64e-6, 3.9e-6],
                relative_errors: [4.53e-15, 3.66e-15, 2.65e-6, 2.18e-6],
                size: 5.01,
                most: 5.12,
            },
            normal_u: ::hodograph::Bound {
                errors: [1.37e-13, 1.24e-13, 7.41e-5, 6.73e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 1.8,
                most: 5.02,
            },
            normal_v: ::hodograph::Bound {
                errors: [1.58e-13, 1.41e-13, 8.52e-5, 7.58e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.419,
                most: 3.67,
            },
        };
        /// What points need of u alone.
        #[inline(always)]
        fn values_of_u<R: ::hodograph::Real>(u: R) -> OfU<R> {
            let p4 = u * u;
            let p1 = u.mul_add(u, R::of(1.0));
            let z_numerator = u.mul_add(u, R::of(-1.0));
            let p1_inverse = R::of(1.0) / p1;
            let z_numerator_over_p1 = z_numerator * p1_inverse;
            let t228 = p1_inverse * p1_inverse;
            let p2 = R::of(12.0).mul_add(p4, R::of(-4.0));
            let p3 = R::of(2.0).mul_add(p4, R::of(-6.0)) * u;
            let t236 = t228 * p1_inverse;
            let t698 = u * p4;
            OfU {
                u,
                p4,
                p1,
                z_numerator,
                z_numerator_over_p1,
                t173: u * p1_inverse,
                t229: R::of(-4.0) * u * t228,
                t230: z_numerator * t228,
                t236,
                t237: p2 * t236,
                t238: p3 * t236,
                t698,
                t699: u * t698,
            }
        }
        /// What points need of v alone.
        #[inline(always)]
        fn values_of_v<R: ::hodograph::Real>(v: R) -> OfV<R> {
            let t9 = v * v;
            let q1 = R::of(-0.3).mul_add(t9, R::of(1.8)) * v;
            let q2 = (R::of(-0.16666666666666666) * v)
                .mul_add(v, R::of(-0.3333333333333333))
                .mul_add(v, R::of(2.0));
            let t21 = v - R::of(0.5);
            let t28 = t21 * t21;
            let t37 = t28 * t28;
            let t48 = t37 * t37;
            let q3 = R::of(461661814849.0)
                .mul_add(
                    t37,
                    R::of(2769970889094.0)
                        .mul_add(t21, R::of(-2274840721067.5))
                        .mul_add(
                            t28,
                            R::of(-30745111603852.5)
                                .mul_add(t21, R::of(12693645645129.938)),
                        ),
                )
                .mul_add(
                    t48,
                    R::of(143650662940788.75)
                        .mul_add(t21, R::of(-102644609387763.06))
                        .mul_add(
                            t28,
                            R::of(-149875108126217.8)
                                .mul_add(t21, R::of(256784226803051.56)),
                        )
                        .mul_add(
                            t37,
                            R::of(-625101617313225.9)
                                .mul_add(t21, R::of(818265326920246.1))
                                .mul_add(
                                    t28,
                                    R::of(-313490417557873.56)
                                        .mul_add(t21, R::of(440976160728430.4)),
                                ),
                        ),
                );
            let t64 = t9 * t9;
            let t73 = t64 * t64;
            let q4 = R::of(-28147927500.0)
                .mul_add(
                    t64,
                    R::of(62144775000.0)
                        .mul_add(
                            t9,
                            R::of(-743687752500.0).mul_add(v, R::of(663548580000.0)),
                        ),
                )
                .mul_add(
                    t73,
                    R::of(1865317140000.0)
                        .mul_add(v, R::of(-2043221872500.0))
                        .mul_add(
                            t9,
                            R::of(-4237797960000.0).mul_add(v, R::of(-10113375645000.0)),
                        )
                        .mul_add(
                            t64,
                            R::of(31886403322500.0)
                                .mul_add(v, R::of(6581576340000.0))
                                .mul_add(
                                    t9,
                                    R::of(12266025750000.0).mul_add(v, R::of(-55143159750000.0)),
                                ),
                        ),
                );
            let t75 = q4 * q1;
            let q5 = R::of(-61357296000.0)
                .mul_add(
                    t64,
                    R::of(598174377000.0)
                        .mul_add(
                            t9,
                            R::of(-1661727768000.0).mul_add(v, R::of(770499405000.0)),
                        ),
                )
                .mul_add(
                    t73,
                    R::of(16183273734000.0)
                        .mul_add(v, R::of(-20437143072000.0))
                        .mul_add(
                            t9,
                            R::of(-41071501539000.0).mul_add(v, R::of(6438958401000.0)),
                        )
                        .mul_add(
                            t64,
                            R::of(10090880448000.0)
                                .mul_add(v, R::of(99244501560000.0))
                                .mul_add(
                                    t9,
                                    R::of(-146832601500000.0)
                                        .mul_add(v, R::of(189062262000000.0)),
                                ),
                        ),
                );
            let t99 = q5 * q1;
            let q6 = (R::of(-11076865742.45) * v)
                .mul_add(t9, R::of(303736070334.0).mul_add(v, R::of(-590857055758.0)))
                .mul_add(
                    t64,
                    R::of(-2275869694774.0)
                        .mul_add(v, R::of(11510368781857.0))
                        .mul_add(
                            t9,
                            R::of(-9206505352757.5).mul_add(v, R::of(-82612790473848.0)),
                        ),
                )
                .mul_add(
                    t73,
                    R::of(181734831384282.0)
                        .mul_add(v, R::of(173928533509507.0))
                        .mul_add(
                            t9,
                            R::of(-732093503375910.8)
                                .mul_add(v, R::of(484246678350767.0)),
                        )
                        .mul_add(
                            t64,
                            R::of(545230907122068.75)
                                .mul_add(v, R::of(-1733012601471900.0))
                                .mul_add(
                                    t9,
                                    R::of(1562947522509375.0)
                                        .mul_add(v, R::of(-898538094140625.0)),
                                ),
                        ),
                );
            let q7 = (R::of(-0.422) * v)
                .mul_add(v, R::of(2.532))
                .mul_add(v, R::of(-5.11));
            let t136 = q7 * q5;
            let q8 = R::of(10275306079.9)
                .mul_add(t21, R::of(77064795599.25))
                .mul_add(
                    t28,
                    R::of(-240249708590.625).mul_add(t21, R::of(-2006397201991.6875)),
                )
                .mul_add(
                    t37,
                    R::of(-49271424600.53125)
                        .mul_add(t21, R::of(355544354648.6156))
                        .mul_add(
                            t28,
                            R::of(-25896333456244.07)
                                .mul_add(t21, R::of(89866303499846.1)),
                        ),
                )
                .mul_add(
                    t48,
                    R::of(204440681548808.38)
                        .mul_add(t21, R::of(-499979929464581.2))
                        .mul_add(
                            t28,
                            R::of(-277119237607558.66)
                                .mul_add(t21, R::of(487871824863980.44)),
                        )
                        .mul_add(
                            t37,
                            R::of(-805241747348296.5)
                                .mul_add(t21, R::of(1738876402232025.5))
                                .mul_add(
                                    t28,
                                    R::of(-359833058317405.44)
                                        .mul_add(t21, R::of(769859673648453.9)),
                                ),
                        ),
                );
            let t168 = R::of(2.0) * t99;
            let q3_inverse = R::of(1.0) / q3;
            let t172 = t75 * q3_inverse;
            let t174 = t136 * q3_inverse;
            let t178 = t99 * q3_inverse;
            let q8_over_q3 = q8 * q3_inverse;
            let q6_over_q3 = q6 * q3_inverse;
            let t183 = t168 * q3_inverse;
            let t191 = R::of(240.0) * v * q3;
            let q9 = R::of(-0.075).mul_add(t9, R::of(0.45));
            let q10 = R::of(-0.9).mul_add(t9, R::of(1.8));
            let q11 = R::of(-0.5).mul_add(t9, R::of(-0.3333333333333333));
            let q12 = R::of(1.721277573783075e16)
                .mul_add(
                    t64,
                    R::of(-4.773909322499625e17)
                        .mul_add(
                            t9,
                            R::of(3.367054806070725e17)
                                .mul_add(v, R::of(4.6062934657869645e18)),
                        ),
                )
                .mul_add(
                    t73 * t73,
                    R::of(-9.257359336323539e18)
                        .mul_add(v, R::of(-5.646423856889003e18))
                        .mul_add(
                            t9,
                            R::of(7.418334268842674e19)
                                .mul_add(v, R::of(-1.4977332347470476e20)),
                        )
                        .mul_add(
                            t64,
                            R::of(-5.102787102406942e19)
                                .mul_add(v, R::of(7.419092641819402e20))
                                .mul_add(
                                    t9,
                                    R::of(-1.078404023303948e21)
                                        .mul_add(v, R::of(-9.760948399165815e20)),
                                ),
                        )
                        .mul_add(
                            t73,
                            R::of(1.9576643478309828e21)
                                .mul_add(v, R::of(2.723541974738406e21))
                                .mul_add(
                                    t9,
                                    R::of(-7.457448630173865e20)
                                        .mul_add(v, R::of(-1.2214948268769637e22)),
                                )
                                .mul_add(
                                    t64,
                                    R::of(6.851822207715709e21)
                                        .mul_add(v, R::of(9.042433181767337e21))
                                        .mul_add(
                                            t9,
                                            R::of(-1.561555120963581e21)
                                                .mul_add(v, R::of(-2.9753112203659685e21)),
                                        ),
                                ),
                        ),
                );
            let t323 = t48 * t48;
            let q13 = R::of(5.277908964363235e16)
                .mul_add(
                    t37,
                    R::of(5.277908964363235e17)
                        .mul_add(t21, R::of(9.10521977716435e17))
                        .mul_add(
                            t28,
                            R::of(-5.814911430812088e18)
                                .mul_add(t21, R::of(-1.6066250993274352e19)),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(2.6936635103494836e19)
                        .mul_add(t21, R::of(6.922333191789462e19))
                        .mul_add(
                            t28,
                            R::of(-3.910965527876362e19)
                                .mul_add(t21, R::of(1.2872855854370767e20)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.14093525206605e20)
                                .mul_add(t21, R::of(-5.418827159200994e20))
                                .mul_add(
                                    t28,
                                    R::of(1.2061600949632854e21)
                                        .mul_add(t21, R::of(-7.783068999037173e21)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-3.037157601812813e21)
                                .mul_add(t21, R::of(2.9513405678941358e22))
                                .mul_add(
                                    t28,
                                    R::of(-1.0642230026836338e22)
                                        .mul_add(t21, R::of(-1.0596080872982659e22)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(2.816038283168297e22)
                                        .mul_add(t21, R::of(-2.4899483281682004e22))
                                        .mul_add(
                                            t28,
                                            R::of(2.4587636556956957e22)
                                                .mul_add(t21, R::of(2.5919771522200083e21)),
                                        ),
                                ),
                        ),
                );
            let q14 = R::of(3.75206798414448e16)
                .mul_add(
                    t37,
                    R::of(3.75206798414448e17)
                        .mul_add(t21, R::of(6.472905054856173e17))
                        .mul_add(
                            t28,
                            R::of(-4.1338232920465085e18)
                                .mul_add(t21, R::of(-1.14215054454557e19)),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(2.268658262226706e19)
                        .mul_add(t21, R::of(8.212053594582145e19))
                        .mul_add(
                            t28,
                            R::of(3.1605589126400336e19)
                                .mul_add(t21, R::of(-1.2232078375276508e20)),
                        )
                        .mul_add(
                            t37,
                            R::of(-9.005755407740376e20)
                                .mul_add(t21, R::of(-9.67831987750225e20))
                                .mul_add(
                                    t28,
                                    R::of(3.6351779528606614e21)
                                        .mul_add(t21, R::of(2.502460764484363e21)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-5.162807509450888e21)
                                .mul_add(t21, R::of(5.563911400099045e21))
                                .mul_add(
                                    t28,
                                    R::of(5.467685224450276e21)
                                        .mul_add(t21, R::of(-1.2318482098423947e22)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-5.974596176860681e21)
                                        .mul_add(t21, R::of(-3.530708557854324e21))
                                        .mul_add(
                                            t28,
                                            R::of(-1.1243954140025547e22)
                                                .mul_add(t21, R::of(5.526302010199067e21)),
                                        ),
                                ),
                        ),
                );
            let q15 = R::of(2.0944885929391844e16)
                .mul_add(
                    t37,
                    R::of(2.0944885929391843e17)
                        .mul_add(t21, R::of(1.2477890373080226e17))
                        .mul_add(
                            t28,
                            R::of(-4.4365716861245957e18)
                                .mul_add(t21, R::of(-5.607384545317975e18)),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(6.456243882149243e19)
                        .mul_add(t21, R::of(1.1204509209016703e20))
                        .mul_add(
                            t28,
                            R::of(-4.4179235253543954e20)
                                .mul_add(t21, R::of(-8.724495739921354e20)),
                        )
                        .mul_add(
                            t37,
                            R::of(9.794779697455506e20)
                                .mul_add(t21, R::of(2.463242775640772e21))
                                .mul_add(
                                    t28,
                                    R::of(1.671981081088889e21)
                                        .mul_add(t21, R::of(-2.759503750531974e21)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-4.1163572670926983e21)
                                .mul_add(t21, R::of(3.4572703239640423e21))
                                .mul_add(
                                    t28,
                                    R::of(-2.7465080639729368e22)
                                        .mul_add(t21, R::of(9.26506619165951e21)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-2.178877672121525e21)
                                        .mul_add(t21, R::of(7.810769250857194e21))
                                        .mul_add(
                                            t28,
                                            R::of(1.4433282376481397e22)
                                                .mul_add(t21, R::of(3.936574496649187e21)),
                                        ),
                                ),
                        ),
                );
            let q16 = R::of(-2.2578761900303548e16)
                .mul_add(
                    t37,
                    R::of(-2.257876190030355e17)
                        .mul_add(t21, R::of(-3.016746456242898e17))
                        .mul_add(
                            t28,
                            R::of(3.2782038078534994e18)
                                .mul_add(t21, R::of(6.728059788992139e18)),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-2.947917579088217e19)
                        .mul_add(t21, R::of(-4.760863787760893e19))
                        .mul_add(
                            t28,
                            R::of(2.315719430489551e20)
                                .mul_add(t21, R::of(3.8653979998743187e20)),
                        )
                        .mul_add(
                            t37,
                            R::of(-5.224393846871579e20)
                                .mul_add(t21, R::of(-1.4467740490437367e21))
                                .mul_add(
                                    t28,
                                    R::of(-1.33491609494175e21)
                                        .mul_add(t21, R::of(1.9074950542537023e21)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(2.101831134287823e21)
                                .mul_add(t21, R::of(-4.975917821776599e21))
                                .mul_add(
                                    t28,
                                    R::of(1.092686718459319e22)
                                        .mul_add(t21, R::of(5.167110173555406e21)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(9.464059319652001e20)
                                        .mul_add(t21, R::of(-1.692429638367918e22))
                                        .mul_add(
                                            t28,
                                            R::of(3.802901939825358e20)
                                                .mul_add(t21, R::of(-7.436035872330023e20)),
                                        ),
                                ),
                        ),
                );
            let q17 = R::of(679457.0)
                .mul_add(t9, R::of(-7279534.0))
                .mul_add(
                    t64,
                    R::of(4430370.0)
                        .mul_add(v, R::of(21793202.0))
                        .mul_add(t9, R::of(-29067870.0).mul_add(v, R::of(29975625.0))),
                );
            let t460 = q17 * q3;
            let t461 = R::of(1.0) / t460;
            let t462 = q12 * t461;
            let t463 = q13 * t461;
            let t464 = q14 * t461;
            let t465 = q15 * t461;
            let t466 = q16 * t461;
            let t467 = R::of(2.0) * q14 * t461;
            let q19 = (R::of(1773319432500.0) * v)
                .mul_add(
                    t64,
                    R::of(-10812313512000.0)
                        .mul_add(v, R::of(29450034999000.0))
                        .mul_add(
                            t9,
                            R::of(-9592437690000.0).mul_add(v, R::of(-170840978685000.0)),
                        ),
                )
                .mul_add(
                    t73,
                    R::of(130129488414000.0)
                        .mul_add(v, R::of(259218973440000.0))
                        .mul_add(
                            t9,
                            R::of(-27039040434000.0)
                                .mul_add(v, R::of(-515818719742500.0)),
                        )
                        .mul_add(
                            t64,
                            R::of(-403570981260000.0)
                                .mul_add(v, R::of(644588619066000.0))
                                .mul_add(
                                    t9,
                                    R::of(170338712022000.0).mul_add(v, R::of(44157692700000.0)),
                                ),
                        ),
                );
            let q20 = (R::of(8153484.0) * v)
                .mul_add(v, R::of(-58236272.0))
                .mul_add(v, R::of(26582220.0))
                .mul_add(v, R::of(87172808.0))
                .mul_add(v, R::of(-58135740.0));
            let q21 = R::of(60939359560068.0)
                .mul_add(
                    t28,
                    R::of(304696797800340.0).mul_add(t21, R::of(-204735664896075.0)),
                )
                .mul_add(
                    t48,
                    R::of(-2213648035477380.0)
                        .mul_add(t21, R::of(710844156127276.5))
                        .mul_add(
                            t28,
                            R::of(6033327843513128.0)
                                .mul_add(t21, R::of(-3079338281632892.0)),
                        )
                        .mul_add(
                            t37,
                            R::of(-2997502162524356.0)
                                .mul_add(t21, R::of(3081410721636618.5))
                                .mul_add(
                                    t28,
                                    R::of(-3750609703879355.0)
                                        .mul_add(t21, R::of(1636530653840492.3)),
                                ),
                        ),
                );
            let t529 = R::of(2.0) * (q20 * q17);
            let q23 = (R::of(5437483571520.0) * v)
                .mul_add(
                    t64,
                    R::of(-63614656648296.0)
                        .mul_add(v, R::of(133951606886592.0))
                        .mul_add(
                            t9,
                            R::of(130836945101940.0)
                                .mul_add(v, R::of(-1268415656171460.0)),
                        ),
                )
                .mul_add(
                    t73,
                    R::of(1372810159031328.0)
                        .mul_add(v, R::of(3044774363926176.0))
                        .mul_add(
                            t9,
                            R::of(-5760745850339172.0)
                                .mul_add(v, R::of(-114527770436520.0)),
                        )
                        .mul_add(
                            t64,
                            R::of(3685952717546040.0)
                                .mul_add(v, R::of(655324676378712.0))
                                .mul_add(
                                    t9,
                                    R::of(719630425779840.0)
                                        .mul_add(v, R::of(-1757839099939200.0)),
                                ),
                        ),
                );
            let q25 = (R::of(3865509648000.0) * v)
                .mul_add(
                    t64,
                    R::of(-45223689560400.0)
                        .mul_add(v, R::of(65804419612800.0))
                        .mul_add(
                            t9,
                            R::of(93012046281000.0).mul_add(v, R::of(-706148289234000.0)),
                        ),
                )
                .mul_add(
                    t73,
                    R::of(541299013243200.0)
                        .mul_add(v, R::of(2321275218242400.0))
                        .mul_add(
                            t9,
                            R::of(-1626178892095800.0)
                                .mul_add(v, R::of(-2308679007138000.0)),
                        )
                        .mul_add(
                            t64,
                            R::of(-363664506924000.0)
                                .mul_add(v, R::of(746560383076800.0))
                                .mul_add(
                                    t9,
                                    R::of(731528545248000.0)
                                        .mul_add(v, R::of(-528597365400000.0)),
                                ),
                        ),
                );
            let q27 = R::of(2157814276779.0)
                .mul_add(t21, R::of(14025792799063.5))
                .mul_add(
                    t37,
                    R::of(-37478954540137.5)
                        .mul_add(t21, R::of(-264844430662902.75))
                        .mul_add(
                            t28,
                            R::of(-5419856706058.4375)
                                .mul_add(t21, R::of(31998991918375.406)),
                        ),
                )
                .mul_add(
                    t48,
                    R::of(-1864536008849573.0)
                        .mul_add(t21, R::of(5032512995991381.0))
                        .mul_add(
                            t28,
                            R::of(8586508625049951.0)
                                .mul_add(t21, R::of(-1.4999397883937434e16)),
                        )
                        .mul_add(
                            t37,
                            R::of(-5542384752151173.0)
                                .mul_add(t21, R::of(5854461898367765.0))
                                .mul_add(
                                    t28,
                                    R::of(-4831450484089779.0)
                                        .mul_add(t21, R::of(3477752804464051.0)),
                                ),
                        ),
                );
            let q29 = R::of(-2326141805914.5)
                .mul_add(t21, R::of(-15119921738444.25))
                .mul_add(
                    t37,
                    R::of(2023061756771.25)
                        .mul_add(t21, R::of(99452847425072.63))
                        .mul_add(
                            t28,
                            R::of(-92746914310794.22)
                                .mul_add(t21, R::of(-84328745803608.8)),
                        ),
                )
                .mul_add(
                    t48,
                    R::of(972757536971442.5)
                        .mul_add(t21, R::of(-2694207903600963.0))
                        .mul_add(
                            t28,
                            R::of(-4729930137062166.0)
                                .mul_add(t21, R::of(7460745229141610.0)),
                        )
                        .mul_add(
                            t37,
                            R::of(3301259842872881.5)
                                .mul_add(t21, R::of(-3182058502453940.0))
                                .mul_add(
                                    t28,
                                    R::of(2210128085889030.3)
                                        .mul_add(t21, R::of(-1717143744697500.5)),
                                ),
                        ),
                );
            let q30 = R::of(6.32997165389242e24)
                .mul_add(
                    t28,
                    R::of(8.228963150060146e25)
                        .mul_add(t21, R::of(2.8762001521695894e26)),
                )
                .mul_add(
                    t48,
                    R::of(-6.062833080403021e26)
                        .mul_add(t21, R::of(-5.660782700526699e27))
                        .mul_add(
                            t28,
                            R::of(-4.115380073529191e27)
                                .mul_add(t21, R::of(4.422804150987401e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(8.527259430094479e28)
                                .mul_add(t21, R::of(-1.9932298654607092e29))
                                .mul_add(
                                    t28,
                                    R::of(-6.0992913110139984e29)
                                        .mul_add(t21, R::of(6.484457491317964e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(2.368680454824592e30)
                        .mul_add(t21, R::of(-2.0987631814035598e30))
                        .mul_add(
                            t28,
                            R::of(-3.933514319666393e30)
                                .mul_add(t21, R::of(5.437341590367509e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(-3.9622932754817194e30)
                                .mul_add(t21, R::of(6.865296599044623e29))
                                .mul_add(
                                    t28,
                                    R::of(1.4139174537308292e31)
                                        .mul_add(t21, R::of(-2.624633382755828e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(2.353053740201596e31)
                                .mul_add(t21, R::of(-1.8234992090063701e31))
                                .mul_add(
                                    t28,
                                    R::of(1.8482345798524539e31)
                                        .mul_add(t21, R::of(-1.51991564418773e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(1.1302363127558872e31)
                                        .mul_add(t21, R::of(-2.2311565730193994e31))
                                        .mul_add(
                                            t28,
                                            R::of(2.823929764957766e30)
                                                .mul_add(t21, R::of(-1.1259958749883533e31)),
                                        ),
                                ),
                        ),
                );
            let q31 = R::of(4.661945848559156e24)
                .mul_add(
                    t28,
                    R::of(6.060529603126903e25)
                        .mul_add(t21, R::of(2.3143539407823288e26)),
                )
                .mul_add(
                    t48,
                    R::of(-1.0954874168951786e26)
                        .mul_add(t21, R::of(-2.6085158736269986e27))
                        .mul_add(
                            t28,
                            R::of(-5.700659552435085e27)
                                .mul_add(t21, R::of(-2.0916038561695532e27)),
                        )
                        .mul_add(
                            t37,
                            R::of(4.287428119255457e28)
                                .mul_add(t21, R::of(1.77253846931771e29))
                                .mul_add(
                                    t28,
                                    R::of(-7.062643300190259e28)
                                        .mul_add(t21, R::of(-1.241485946723713e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-3.224009379118933e29)
                        .mul_add(t21, R::of(4.00821515802095e30))
                        .mul_add(
                            t28,
                            R::of(1.703489270909446e30)
                                .mul_add(t21, R::of(-5.594142187535572e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(-3.6687683908157193e30)
                                .mul_add(t21, R::of(1.5352278532938707e30))
                                .mul_add(
                                    t28,
                                    R::of(-2.845436691371936e30)
                                        .mul_add(t21, R::of(7.775125170545958e30)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(3.3215463056530717e31)
                                .mul_add(t21, R::of(-5.418894189751389e31))
                                .mul_add(
                                    t28,
                                    R::of(5.511766063559196e31)
                                        .mul_add(t21, R::of(-7.595683392075022e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(3.64394753443134e31)
                                        .mul_add(t21, R::of(-1.6429795516504507e31))
                                        .mul_add(
                                            t28,
                                            R::of(1.066754510728142e31)
                                                .mul_add(t21, R::of(7.644840466952367e30)),
                                        ),
                                ),
                        ),
                );
            let q32 = R::of(-5.753281486288875e24)
                .mul_add(
                    t28,
                    R::of(-7.479265932175537e25)
                        .mul_add(t21, R::of(-2.228013469052006e26)),
                )
                .mul_add(
                    t48,
                    R::of(8.756886248093223e26)
                        .mul_add(t21, R::of(5.251126085426034e27))
                        .mul_add(
                            t28,
                            R::of(-2.370080938265161e26)
                                .mul_add(t21, R::of(-3.9587894485443414e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(-5.509041230421452e28)
                                .mul_add(t21, R::of(9.22004825733505e28))
                                .mul_add(
                                    t28,
                                    R::of(5.244544914958442e29)
                                        .mul_add(t21, R::of(4.113934409908538e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-2.973584665247018e30)
                        .mul_add(t21, R::of(-2.1009702520383697e30))
                        .mul_add(
                            t28,
                            R::of(1.0856622314234024e31)
                                .mul_add(t21, R::of(-5.507738978753253e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.0773404896023148e31)
                                .mul_add(t21, R::of(4.063246861898785e31))
                                .mul_add(
                                    t28,
                                    R::of(-6.598544145456797e31)
                                        .mul_add(t21, R::of(1.76600463258251e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(8.252690616859868e31)
                                .mul_add(t21, R::of(-2.013133408981787e32))
                                .mul_add(
                                    t28,
                                    R::of(3.343961237782186e32)
                                        .mul_add(t21, R::of(-3.460274712609277e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(2.861152856938561e32)
                                        .mul_add(t21, R::of(-2.1779264300302666e32))
                                        .mul_add(
                                            t28,
                                            R::of(8.01594011088356e31)
                                                .mul_add(t21, R::of(-4.969476108379414e31)),
                                        ),
                                ),
                        ),
                );
            let q33 = R::of(2.12432098588475e25)
                .mul_add(
                    t28,
                    R::of(2.761617281650175e26).mul_add(t21, R::of(7.031157035469e26)),
                )
                .mul_add(
                    t48,
                    R::of(-4.662168824017085e27)
                        .mul_add(t21, R::of(-2.113522057044993e28))
                        .mul_add(
                            t28,
                            R::of(3.6715095170593996e28)
                                .mul_add(t21, R::of(2.422384208250753e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(-2.050527194278221e29)
                                .mul_add(t21, R::of(-1.5906213453174962e30))
                                .mul_add(
                                    t28,
                                    R::of(1.0999905361353906e30)
                                        .mul_add(t21, R::of(6.111621368921776e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-5.242895989679745e30)
                        .mul_add(t21, R::of(-1.0136645054512206e31))
                        .mul_add(
                            t28,
                            R::of(1.4690345511853825e31)
                                .mul_add(t21, R::of(-1.233990785116433e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(-9.768890432552965e29)
                                .mul_add(t21, R::of(5.732530959443789e31))
                                .mul_add(
                                    t28,
                                    R::of(-8.809864375583266e31)
                                        .mul_add(t21, R::of(4.272052045346788e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(3.670013248709522e31)
                                .mul_add(t21, R::of(-1.5927202353625449e32))
                                .mul_add(
                                    t28,
                                    R::of(2.523829600232415e32)
                                        .mul_add(t21, R::of(-2.855882242914084e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(2.7259092990640515e32)
                                        .mul_add(t21, R::of(-1.634780572466376e32))
                                        .mul_add(
                                            t28,
                                            R::of(8.206856162221776e31)
                                                .mul_add(t21, R::of(-3.6046672521424616e31)),
                                        ),
                                ),
                        ),
                );
            let q34 = R::of(-4.6781363857997074e24)
                .mul_add(
                    t28,
                    R::of(-6.0815773015396195e25)
                        .mul_add(t21, R::of(-1.8540089441784596e26)),
                )
                .mul_add(
                    t48,
                    R::of(7.222874752405417e26)
                        .mul_add(t21, R::of(3.4833837825848243e27))
                        .mul_add(
                            t28,
                            R::of(-1.1339700451866254e28)
                                .mul_add(t21, R::of(-5.018006797087147e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.5231899407734248e29)
                                .mul_add(t21, R::of(5.627617835420776e29))
                                .mul_add(
                                    t28,
                                    R::of(-1.229422623006103e30)
                                        .mul_add(t21, R::of(-3.4984794454296595e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(6.977363172707162e30)
                        .mul_add(t21, R::of(9.850162977522396e30))
                        .mul_add(
                            t28,
                            R::of(-2.582275257069479e31)
                                .mul_add(t21, R::of(4.493708505564654e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(3.447098684421249e31)
                                .mul_add(t21, R::of(-7.821099161760289e31))
                                .mul_add(
                                    t28,
                                    R::of(1.020569548605825e32)
                                        .mul_add(t21, R::of(-1.1408443946834539e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-1.6594698315918503e32)
                                .mul_add(t21, R::of(3.7844014257638936e32))
                                .mul_add(
                                    t28,
                                    R::of(-6.189808151482856e32)
                                        .mul_add(t21, R::of(6.266619926821887e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-5.30682868839446e32)
                                        .mul_add(t21, R::of(4.052478209795325e32))
                                        .mul_add(
                                            t28,
                                            R::of(-1.3427634052742989e32)
                                                .mul_add(t21, R::of(9.639012885049177e31)),
                                        ),
                                ),
                        ),
                );
            let q35 = R::of(8.420645494439473e24)
                .mul_add(
                    t28,
                    R::of(1.0946839142771314e26)
                        .mul_add(t21, R::of(4.708760320325711e26)),
                )
                .mul_add(
                    t48,
                    R::of(3.267366862214481e26)
                        .mul_add(t21, R::of(-4.0858609571412634e27))
                        .mul_add(
                            t28,
                            R::of(-1.8215068288745191e28)
                                .mul_add(t21, R::of(-2.0634721323762146e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.3542345745883257e29)
                                .mul_add(t21, R::of(4.352098652171862e29))
                                .mul_add(
                                    t28,
                                    R::of(-4.06288365351572e29)
                                        .mul_add(t21, R::of(-2.4823550605826084e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(3.211176113493812e29)
                        .mul_add(t21, R::of(6.931849689830061e30))
                        .mul_add(
                            t28,
                            R::of(2.0735974910520043e30)
                                .mul_add(t21, R::of(-1.1425358401726724e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.0762436573744714e31)
                                .mul_add(t21, R::of(2.053899664443889e31))
                                .mul_add(
                                    t28,
                                    R::of(-1.4509103002233914e30)
                                        .mul_add(t21, R::of(-1.7179115157181812e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(7.963286419343361e31)
                                .mul_add(t21, R::of(-1.0688422419904951e32))
                                .mul_add(
                                    t28,
                                    R::of(7.744634117067396e31)
                                        .mul_add(t21, R::of(-8.932969485055813e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-1.8744669255859735e31)
                                        .mul_add(t21, R::of(2.636535835444799e31))
                                        .mul_add(
                                            t28,
                                            R::of(-1.8648480911012718e31)
                                                .mul_add(t21, R::of(2.0943843102985225e31)),
                                        ),
                                ),
                        ),
                );
            let q36 = R::of(-2.849282585810364e24)
                .mul_add(
                    t28,
                    R::of(-3.7040673615534737e25)
                        .mul_add(t21, R::of(-1.1623077412583944e26)),
                )
                .mul_add(
                    t48,
                    R::of(3.9618279310520325e26)
                        .mul_add(t21, R::of(2.423680249152925e27))
                        .mul_add(
                            t28,
                            R::of(-2.244317380301797e27)
                                .mul_add(t21, R::of(-2.604532551166395e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(3.4285565599000486e27)
                                .mul_add(t21, R::of(1.6921664848618165e29))
                                .mul_add(
                                    t28,
                                    R::of(4.972770042723681e28)
                                        .mul_add(t21, R::of(-5.2128207703247736e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-1.1899132297035214e29)
                        .mul_add(t21, R::of(1.7159686661360508e29))
                        .mul_add(
                            t28,
                            R::of(-5.457507791061417e29)
                                .mul_add(t21, R::of(3.0566506961874585e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.1049302367743613e30)
                                .mul_add(t21, R::of(-5.805935785951211e30))
                                .mul_add(
                                    t28,
                                    R::of(-7.678061262023263e30)
                                        .mul_add(t21, R::of(1.3778397348254426e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(4.607799945412792e31)
                                .mul_add(t21, R::of(-8.260823210085132e31))
                                .mul_add(
                                    t28,
                                    R::of(5.199551309182534e31)
                                        .mul_add(t21, R::of(-1.9592487847770013e30)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-2.8512317784226494e31)
                                        .mul_add(t21, R::of(4.390713483159316e31))
                                        .mul_add(
                                            t28,
                                            R::of(-3.0105226048371103e31)
                                                .mul_add(t21, R::of(-1.1561353364924359e31)),
                                        ),
                                ),
                        ),
                );
            let q37 = R::of(2.1516673147196105e24)
                .mul_add(
                    t28,
                    R::of(2.7971675091354935e25)
                        .mul_add(t21, R::of(8.427829982032703e25)),
                )
                .mul_add(
                    t48,
                    R::of(-3.037041106658653e26)
                        .mul_add(t21, R::of(-1.539610981890921e27))
                        .mul_add(
                            t28,
                            R::of(2.88021965155177e27)
                                .mul_add(t21, R::of(1.7997944440068783e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(-2.6750515752938066e27)
                                .mul_add(t21, R::of(-5.723350934864955e28))
                                .mul_add(
                                    t28,
                                    R::of(-3.5759442856940948e28)
                                        .mul_add(t21, R::of(-3.194436366275468e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-3.7349979868292275e28)
                        .mul_add(t21, R::of(2.2316169309410722e30))
                        .mul_add(
                            t28,
                            R::of(-6.2996223280021404e29)
                                .mul_add(t21, R::of(1.2307821243446963e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(8.954872604666377e30)
                                .mul_add(t21, R::of(-4.189274072978207e31))
                                .mul_add(
                                    t28,
                                    R::of(-8.002327509352531e30)
                                        .mul_add(t21, R::of(9.009136828239508e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-7.092070994026182e31)
                                .mul_add(t21, R::of(4.601489292883271e31))
                                .mul_add(
                                    t28,
                                    R::of(3.1466997265552598e31)
                                        .mul_add(t21, R::of(-1.2381184779843156e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(1.3403221743529304e32)
                                        .mul_add(t21, R::of(-5.645474493348139e31))
                                        .mul_add(
                                            t28,
                                            R::of(5.429292079796992e31)
                                                .mul_add(t21, R::of(6.044330111488722e30)),
                                        ),
                                ),
                        ),
                );
            let q38 = R::of(1.403440915739912e24)
                .mul_add(
                    t28,
                    R::of(1.8244731904618858e25)
                        .mul_add(t21, R::of(5.144324836791138e25)),
                )
                .mul_add(
                    t48,
                    R::of(-2.734873105220351e26)
                        .mul_add(t21, R::of(-1.6947842178830236e27))
                        .mul_add(
                            t28,
                            R::of(-1.1647436685881628e27)
                                .mul_add(t21, R::of(8.116715996375114e27)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.7249623155264397e28)
                                .mul_add(t21, R::of(2.9549320603371757e28))
                                .mul_add(
                                    t28,
                                    R::of(3.3551003579774565e28)
                                        .mul_add(t21, R::of(-2.5092799418105195e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-6.693313696436177e29)
                        .mul_add(t21, R::of(-4.035095478598583e29))
                        .mul_add(
                            t28,
                            R::of(3.41658572567587e29)
                                .mul_add(t21, R::of(5.078683119267659e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.0991129621868298e31)
                                .mul_add(t21, R::of(-6.191748858923469e30))
                                .mul_add(
                                    t28,
                                    R::of(-3.6737123104332893e31)
                                        .mul_add(t21, R::of(-1.3576661360277466e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(5.010717670603833e31)
                                .mul_add(t21, R::of(4.4353489716150537e30))
                                .mul_add(
                                    t28,
                                    R::of(-1.7176231218937112e31)
                                        .mul_add(t21, R::of(1.1098265785907834e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-4.767017951218315e31)
                                        .mul_add(t21, R::of(1.3829536325104682e31))
                                        .mul_add(
                                            t28,
                                            R::of(1.4242844000766857e31)
                                                .mul_add(t21, R::of(7.490949265813928e30)),
                                        ),
                                ),
                        ),
                );
            let q39 = R::of(2.12432098588475e25)
                .mul_add(
                    t28,
                    R::of(2.761617281650175e26).mul_add(t21, R::of(7.110303306142429e26)),
                )
                .mul_add(
                    t48,
                    R::of(-4.5491728173064874e27)
                        .mul_add(t21, R::of(-2.0531632729282773e28))
                        .mul_add(
                            t28,
                            R::of(3.8236252973303624e28)
                                .mul_add(t21, R::of(2.4431181754597046e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(-2.0477652632890353e29)
                                .mul_add(t21, R::of(-1.6080831044306197e30))
                                .mul_add(
                                    t28,
                                    R::of(1.0339557974994648e30)
                                        .mul_add(t21, R::of(6.033693609227097e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-5.154936363219497e30)
                        .mul_add(t21, R::of(-9.665042685069855e30))
                        .mul_add(
                            t28,
                            R::of(1.5201401848186234e31)
                                .mul_add(t21, R::of(-1.3133819177462282e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(-2.680093516252774e30)
                                .mul_add(t21, R::of(6.003768888554708e31))
                                .mul_add(
                                    t28,
                                    R::of(-7.883798254800374e31)
                                        .mul_add(t21, R::of(4.0215854404366055e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(1.5500655050467987e31)
                                .mul_add(t21, R::of(-1.656829303861667e32))
                                .mul_add(
                                    t28,
                                    R::of(2.813205614607419e32)
                                        .mul_add(t21, R::of(-2.7355518227712524e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(2.4873087432539708e32)
                                        .mul_add(t21, R::of(-1.6302116638591596e32))
                                        .mul_add(
                                            t28,
                                            R::of(7.7918925562643145e31)
                                                .mul_add(t21, R::of(-2.9599574889010334e31)),
                                        ),
                                ),
                        ),
                );
            let q40 = R::of(-4.6781363857997074e24)
                .mul_add(
                    t28,
                    R::of(-6.0815773015396195e25)
                        .mul_add(t21, R::of(-1.6814846559513544e26)),
                )
                .mul_add(
                    t48,
                    R::of(9.346094061822188e26)
                        .mul_add(t21, R::of(4.2781210590511367e27))
                        .mul_add(
                            t28,
                            R::of(-1.1222216120920322e28)
                                .mul_add(t21, R::of(-5.522031645574407e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.3845464512137072e29)
                                .mul_add(t21, R::of(5.1441340186947915e29))
                                .mul_add(
                                    t28,
                                    R::of(-1.3053857029738825e30)
                                        .mul_add(t21, R::of(-3.2219657085094876e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(7.905661466354639e30)
                        .mul_add(t21, R::of(1.0541373036284072e31))
                        .mul_add(
                            t28,
                            R::of(-2.686012462778601e31)
                                .mul_add(t21, R::of(-2.62932457950286e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(2.3053520242092143e31)
                                .mul_add(t21, R::of(-6.763044255547233e31))
                                .mul_add(
                                    t28,
                                    R::of(1.4311569470642564e32)
                                        .mul_add(t21, R::of(1.4572764441356726e30)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-2.2012376596210517e32)
                                .mul_add(t21, R::of(3.699505070408066e32))
                                .mul_add(
                                    t28,
                                    R::of(-6.0844554984265054e32)
                                        .mul_add(t21, R::of(6.186892029280337e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-4.717600847163762e32)
                                        .mul_add(t21, R::of(3.864795043159992e32))
                                        .mul_add(
                                            t28,
                                            R::of(-1.451606491577599e32)
                                                .mul_add(t21, R::of(8.55093880257646e31)),
                                        ),
                                ),
                        ),
                );
            let q41 = R::of(8.420645494439473e24)
                .mul_add(
                    t28,
                    R::of(1.0946839142771314e26)
                        .mul_add(t21, R::of(4.6049406442867823e26)),
                )
                .mul_add(
                    t48,
                    R::of(2.3062390847217662e26)
                        .mul_add(t21, R::of(-4.0788908715659544e27))
                        .mul_add(
                            t28,
                            R::of(-1.5961860599052523e28)
                                .mul_add(t21, R::of(-1.6257938293243046e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.2766694299578131e29)
                                .mul_add(t21, R::of(4.336008173698294e29))
                                .mul_add(
                                    t28,
                                    R::of(-4.4264586720685976e29)
                                        .mul_add(t21, R::of(-3.002197999314477e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(3.3590653074738036e29)
                        .mul_add(t21, R::of(9.937541554765297e30))
                        .mul_add(
                            t28,
                            R::of(2.2780220563617925e30)
                                .mul_add(t21, R::of(-1.1096745369378067e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(-4.421532357433404e30)
                                .mul_add(t21, R::of(-2.365630402881254e31))
                                .mul_add(
                                    t28,
                                    R::of(-8.362994991773937e30)
                                        .mul_add(t21, R::of(8.595535469712441e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(1.0227261746186114e31)
                                .mul_add(t21, R::of(-6.605178764897792e31))
                                .mul_add(
                                    t28,
                                    R::of(7.686561680720926e31)
                                        .mul_add(t21, R::of(-1.809313657998841e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(1.1355338821240733e32)
                                        .mul_add(t21, R::of(-4.443762722230271e31))
                                        .mul_add(
                                            t28,
                                            R::of(4.056928345699493e31)
                                                .mul_add(t21, R::of(3.121633748980892e31)),
                                        ),
                                ),
                        ),
                );
            let q42 = R::of(-9.179254239702784e24)
                .mul_add(
                    t28,
                    R::of(-1.193303051161362e26)
                        .mul_add(t21, R::of(-3.917165810708253e26)),
                )
                .mul_add(
                    t48,
                    R::of(1.1340446744817193e27)
                        .mul_add(t21, R::of(8.439251209394126e27))
                        .mul_add(
                            t28,
                            R::of(1.3829767155953765e27)
                                .mul_add(t21, R::of(-7.257183818691928e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(-8.476029493668274e28)
                                .mul_add(t21, R::of(3.394505159482035e29))
                                .mul_add(
                                    t28,
                                    R::of(6.220403968035839e29)
                                        .mul_add(t21, R::of(-9.682325092662107e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-2.3000174362133986e30)
                        .mul_add(t21, R::of(1.9526337021869227e30))
                        .mul_add(
                            t28,
                            R::of(4.0612449470294177e30)
                                .mul_add(t21, R::of(-3.1525254085970585e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.842846990729262e30)
                                .mul_add(t21, R::of(-3.447705533956498e29))
                                .mul_add(
                                    t28,
                                    R::of(-1.6272344955209402e31)
                                        .mul_add(t21, R::of(1.7509646597424812e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-2.584585761199928e30)
                                .mul_add(t21, R::of(-1.89436457375194e29))
                                .mul_add(
                                    t28,
                                    R::of(1.2276958879504085e31)
                                        .mul_add(t21, R::of(-1.767169160043965e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(5.551129809465909e30)
                                        .mul_add(t21, R::of(4.6240617984203325e30))
                                        .mul_add(
                                            t28,
                                            R::of(-7.726231903203783e28)
                                                .mul_add(t21, R::of(6.318499728903331e30)),
                                        ),
                                ),
                        ),
                );
            let q43 = R::of(-2.5102785338395454e24)
                .mul_add(
                    t28,
                    R::of(-3.263362093991409e25)
                        .mul_add(t21, R::of(-1.4234174769137745e26)),
                )
                .mul_add(
                    t48,
                    R::of(-1.6410892822242215e26)
                        .mul_add(t21, R::of(7.915978500376067e26))
                        .mul_add(
                            t28,
                            R::of(5.797653464602815e27)
                                .mul_add(t21, R::of(1.4444933314331437e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(-4.020583969206961e28)
                                .mul_add(t21, R::of(-2.2754559030362942e29))
                                .mul_add(
                                    t28,
                                    R::of(8.69040570104204e28)
                                        .mul_add(t21, R::of(1.4374609285760996e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(2.9967909596092744e29)
                        .mul_add(t21, R::of(-4.6854661802124725e30))
                        .mul_add(
                            t28,
                            R::of(-2.5395105659960885e30)
                                .mul_add(t21, R::of(6.689733624445947e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(7.142240620009903e30)
                                .mul_add(t21, R::of(4.885345592400549e29))
                                .mul_add(
                                    t28,
                                    R::of(-1.4265276455363917e30)
                                        .mul_add(t21, R::of(-1.6735167190739242e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-2.901042486127191e31)
                                .mul_add(t21, R::of(5.139677476413689e31))
                                .mul_add(
                                    t28,
                                    R::of(-3.7680262512994454e31)
                                        .mul_add(t21, R::of(6.538404788072171e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-2.434041452558121e31)
                                        .mul_add(t21, R::of(2.3654904037219106e30))
                                        .mul_add(
                                            t28,
                                            R::of(-6.332951602373609e30)
                                                .mul_add(t21, R::of(-9.557862732816398e30)),
                                        ),
                                ),
                        ),
                );
            let q44 = R::of(7.156722402028787e24)
                .mul_add(
                    t28,
                    R::of(9.303739122637423e25)
                        .mul_add(t21, R::of(2.9149702409582253e26)),
                )
                .mul_add(
                    t48,
                    R::of(-9.281088496427548e26)
                        .mul_add(t21, R::of(-6.050603747253102e27))
                        .mul_add(
                            t28,
                            R::of(-3.4820610356662785e26)
                                .mul_add(t21, R::of(4.393112170892602e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(6.147749401243213e28)
                                .mul_add(t21, R::of(-1.0505226279269201e29))
                                .mul_add(
                                    t28,
                                    R::of(-5.6202806694775306e29)
                                        .mul_add(t21, R::of(-3.918984488791702e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(3.235778400130917e30)
                        .mul_add(t21, R::of(2.460156519490654e30))
                        .mul_add(
                            t28,
                            R::of(-1.1500425506912525e31)
                                .mul_add(t21, R::of(3.2207780666434984e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.0013870527558964e31)
                                .mul_add(t21, R::of(-3.5756442903705293e31))
                                .mul_add(
                                    t28,
                                    R::of(7.117427975708969e31)
                                        .mul_add(t21, R::of(-1.9459501604891546e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-8.878075828810571e31)
                                .mul_add(t21, R::of(1.9881330655123895e32))
                                .mul_add(
                                    t28,
                                    R::of(-3.366490584895412e32)
                                        .mul_add(t21, R::of(3.4781707781538e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-2.7957085171738846e32)
                                        .mul_add(t21, R::of(2.1288510793714298e32))
                                        .mul_add(
                                            t28,
                                            R::of(-7.266986408496679e31)
                                                .mul_add(t21, R::of(4.460249646277672e31)),
                                        ),
                                ),
                        ),
                );
            let q45 = R::of(1.6457926300120292e26)
                .mul_add(t21, R::of(2.0572407875150366e27))
                .mul_add(
                    t48,
                    R::of(6.902880365207015e27)
                        .mul_add(t21, R::of(-1.3944516084926949e28))
                        .mul_add(
                            t28,
                            R::of(-1.2453721941158738e29)
                                .mul_add(t21, R::of(-8.6422981544113e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(8.845608301974802e29)
                                .mul_add(t21, R::of(1.620179291717951e30))
                                .mul_add(
                                    t28,
                                    R::of(-3.5878137578292764e30)
                                        .mul_add(t21, R::of(-1.0368795228723796e31)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(1.0375131986108742e31)
                        .mul_add(t21, R::of(3.553020682236888e31))
                        .mul_add(
                            t28,
                            R::of(-2.9382684539649835e31)
                                .mul_add(t21, R::of(-5.113568615566311e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(6.524809908441011e31)
                                .mul_add(t21, R::of(-4.358522603029892e31))
                                .mul_add(
                                    t28,
                                    R::of(6.865296599044624e30)
                                        .mul_add(t21, R::of(1.2725257083577464e32)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-2.0997067062046624e32)
                                .mul_add(t21, R::of(1.647137618141117e32))
                                .mul_add(
                                    t28,
                                    R::of(-1.094099525403822e32)
                                        .mul_add(t21, R::of(9.24117289926227e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-6.07966257675092e31)
                                        .mul_add(t21, R::of(3.3907089382676616e31))
                                        .mul_add(
                                            t28,
                                            R::of(-4.462313146038799e31)
                                                .mul_add(t21, R::of(2.823929764957766e30)),
                                        ),
                                ),
                        ),
                );
            let q46 = R::of(1.2121059206253805e26)
                .mul_add(t21, R::of(1.5151324007817255e27))
                .mul_add(
                    t48,
                    R::of(5.554449457877589e27)
                        .mul_add(t21, R::of(-2.5196210588589105e27))
                        .mul_add(
                            t28,
                            R::of(-5.738734921979398e28)
                                .mul_add(t21, R::of(-1.1971385060113677e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(-4.183207712339106e28)
                                .mul_add(t21, R::of(8.146113426585369e29))
                                .mul_add(
                                    t28,
                                    R::of(3.190569244771878e30)
                                        .mul_add(t21, R::of(-1.200649361032344e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-1.9863775147579407e31)
                        .mul_add(t21, R::of(-4.836014068678399e30))
                        .mul_add(
                            t28,
                            R::of(5.6115012212293305e31)
                                .mul_add(t21, R::of(2.21453605218228e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(-6.712970625042686e31)
                                .mul_add(t21, R::of(-4.0356452298972913e31))
                                .mul_add(
                                    t28,
                                    R::of(1.5352278532938707e31)
                                        .mul_add(t21, R::of(-2.5608930222347424e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(6.220100136436767e31)
                                .mul_add(t21, R::of(2.3250824139571502e32))
                                .mul_add(
                                    t28,
                                    R::of(-3.251336513850834e32)
                                        .mul_add(t21, R::of(2.7558830317795976e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-3.038273356830009e32)
                                        .mul_add(t21, R::of(1.093184260329402e32))
                                        .mul_add(
                                            t28,
                                            R::of(-3.2859591033009014e31)
                                                .mul_add(t21, R::of(1.066754510728142e31)),
                                        ),
                                ),
                        ),
                );
            let q47 = R::of(-1.4958531864351075e26)
                .mul_add(t21, R::of(-1.8698164830438845e27))
                .mul_add(
                    t48,
                    R::of(-5.347232325724815e27)
                        .mul_add(t21, R::of(2.014083837061441e28))
                        .mul_add(
                            t28,
                            R::of(1.1552477387937277e29)
                                .mul_add(t21, R::of(-4.977169970356839e27)),
                        )
                        .mul_add(
                            t37,
                            R::of(-7.917578897088682e29)
                                .mul_add(t21, R::of(-1.0467178337800758e30))
                                .mul_add(
                                    t28,
                                    R::of(1.659608686320309e30)
                                        .mul_add(t21, R::of(8.915726355429352e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(6.582295055853661e30)
                        .mul_add(t21, R::of(-4.460376997870527e31))
                        .mul_add(
                            t28,
                            R::of(-2.9413583528537173e31)
                                .mul_add(t21, R::of(1.4113609008504231e32)),
                        )
                        .mul_add(
                            t37,
                            R::of(-6.609286774503905e31)
                                .mul_add(t21, R::of(-1.1850745385625464e32))
                                .mul_add(
                                    t28,
                                    R::of(4.063246861898785e32)
                                        .mul_add(t21, R::of(-5.938689730911117e32)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(1.412803706066008e32)
                                .mul_add(t21, R::of(5.7768834318019075e32))
                                .mul_add(
                                    t28,
                                    R::of(-1.2078800453890721e33)
                                        .mul_add(t21, R::of(1.671980618891093e33)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-1.384109885043711e33)
                                        .mul_add(t21, R::of(8.583458570815682e32))
                                        .mul_add(
                                            t28,
                                            R::of(-4.355852860060533e32)
                                                .mul_add(t21, R::of(8.01594011088356e31)),
                                        ),
                                ),
                        ),
                );
            let t1729 = R::of(5.52323456330035e26)
                .mul_add(t21, R::of(6.904043204125437e27));
            let q48 = t1729
                .mul_add(
                    t48,
                    R::of(1.68747768851256e28)
                        .mul_add(t21, R::of(-1.0722988295239296e29))
                        .mul_add(
                            t28,
                            R::of(-4.649748525498984e29)
                                .mul_add(t21, R::of(7.710169985824739e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(4.844768416501506e30)
                                .mul_add(t21, R::of(-3.89600166912862e30))
                                .mul_add(
                                    t28,
                                    R::of(-2.8631184215714935e31)
                                        .mul_add(t21, R::of(1.8699839114301642e31)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(9.778594190274841e31)
                        .mul_add(t21, R::of(-7.864343984519618e31))
                        .mul_add(
                            t28,
                            R::of(-1.419130307631709e32)
                                .mul_add(t21, R::of(1.9097449165409973e32)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.4807889421397194e32)
                                .mul_add(t21, R::of(-1.0745779475808262e31))
                                .mul_add(
                                    t28,
                                    R::of(5.732530959443789e32)
                                        .mul_add(t21, R::of(-7.92887793802494e32)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(3.41764163627743e32)
                                .mul_add(t21, R::of(2.5690092740966653e32))
                                .mul_add(
                                    t28,
                                    R::of(-9.556321412175269e32)
                                        .mul_add(t21, R::of(1.2619148001162075e33)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-1.1423528971656336e33)
                                        .mul_add(t21, R::of(8.177727897192155e32))
                                        .mul_add(
                                            t28,
                                            R::of(-3.269561144932752e32)
                                                .mul_add(t21, R::of(8.206856162221776e31)),
                                        ),
                                ),
                        ),
                );
            let t1779 = R::of(-1.2163154603079239e26)
                .mul_add(t21, R::of(-1.520394325384905e27));
            let q49 = t1779
                .mul_add(
                    t48,
                    R::of(-4.4496214660283034e27)
                        .mul_add(t21, R::of(1.6612611930532459e28))
                        .mul_add(
                            t28,
                            R::of(7.663444321686613e28)
                                .mul_add(t21, R::of(-2.3813370948919135e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.0036013594174293e30)
                                .mul_add(t21, R::of(2.8940608874695073e30))
                                .mul_add(
                                    t28,
                                    R::of(1.0129712103757397e31)
                                        .mul_add(t21, R::of(-2.0900184591103754e31)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-5.597567112687455e31)
                        .mul_add(t21, R::of(1.0466044759060741e32))
                        .mul_add(
                            t28,
                            R::of(1.3790228168531353e32)
                                .mul_add(t21, R::of(-3.356957834190322e32)),
                        )
                        .mul_add(
                            t37,
                            R::of(5.392450206677585e31)
                                .mul_add(t21, R::of(3.791808552863374e32))
                                .mul_add(
                                    t28,
                                    R::of(-7.82109916176029e32)
                                        .mul_add(t21, R::of(9.185125937452425e32)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-9.12675515746763e31)
                                .mul_add(t21, R::of(-1.1616288821142951e33))
                                .mul_add(
                                    t28,
                                    R::of(2.2706408554583363e33)
                                        .mul_add(t21, R::of(-3.094904075741428e33)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(2.506647970728755e33)
                                        .mul_add(t21, R::of(-1.5920486065183378e33))
                                        .mul_add(
                                            t28,
                                            R::of(8.10495641959065e32)
                                                .mul_add(t21, R::of(-1.3427634052742989e32)),
                                        ),
                                ),
                        ),
                );
            let t1829 = R::of(2.189367828554263e26)
                .mul_add(t21, R::of(2.7367097856928286e27));
            let q50 = t1829
                .mul_add(
                    t48,
                    R::of(1.1301024768781705e28)
                        .mul_add(t21, R::of(7.514943783093306e27))
                        .mul_add(
                            t28,
                            R::of(-8.98889410571078e28)
                                .mul_add(t21, R::of(-3.82516434063649e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(-4.126944264752429e29)
                                .mul_add(t21, R::of(2.573045691717819e30))
                                .mul_add(
                                    t28,
                                    R::of(7.833777573909352e30)
                                        .mul_add(t21, R::of(-6.906902210976724e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-3.9717680969321734e31)
                        .mul_add(t21, R::of(4.8167641702407176e30))
                        .mul_add(
                            t28,
                            R::of(9.704589565762086e31)
                                .mul_add(t21, R::of(2.6956767383676057e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.371043008207207e32)
                                .mul_add(t21, R::of(-1.1838680231119184e32))
                                .mul_add(
                                    t28,
                                    R::of(2.0538996644438892e32)
                                        .mul_add(t21, R::of(-1.3058192702010522e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-1.374329212574545e32)
                                .mul_add(t21, R::of(5.574300493540353e32))
                                .mul_add(
                                    t28,
                                    R::of(-6.413053451942971e32)
                                        .mul_add(t21, R::of(3.8723170585336984e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-3.573187794022325e32)
                                        .mul_add(t21, R::of(-5.62340077675792e31))
                                        .mul_add(
                                            t28,
                                            R::of(5.273071670889598e31)
                                                .mul_add(t21, R::of(-1.8648480911012718e31)),
                                        ),
                                ),
                        ),
                );
            let q51 = R::of(-7.408134723106947e25)
                .mul_add(t21, R::of(-9.260168403883684e26))
                .mul_add(
                    t48,
                    R::of(-2.7895385790201463e27)
                        .mul_add(t21, R::of(9.112204241419675e27))
                        .mul_add(
                            t28,
                            R::of(5.332096548136435e28)
                                .mul_add(t21, R::of(-4.713066498633774e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(-5.2090651023327895e29)
                                .mul_add(t21, R::of(6.514257463810093e28))
                                .mul_add(
                                    t28,
                                    R::of(3.04589967275127e30)
                                        .mul_add(t21, R::of(8.453709072630258e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-8.340513232519638e30)
                        .mul_add(t21, R::of(-1.784869844555282e30))
                        .mul_add(
                            t28,
                            R::of(2.4023561325904712e30)
                                .mul_add(t21, R::of(-7.094760128379842e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(3.6679808354249504e31)
                                .mul_add(t21, R::of(1.2154232604517975e31))
                                .mul_add(
                                    t28,
                                    R::of(-5.805935785951211e31)
                                        .mul_add(t21, R::of(-6.910255135820937e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(1.102271787860354e32)
                                .mul_add(t21, R::of(3.2254599617889544e32))
                                .mul_add(
                                    t28,
                                    R::of(-4.956493926051079e32)
                                        .mul_add(t21, R::of(2.599775654591267e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-7.836995139108005e30)
                                        .mul_add(t21, R::of(-8.553695335267948e31))
                                        .mul_add(
                                            t28,
                                            R::of(8.781426966318632e31)
                                                .mul_add(t21, R::of(-3.0105226048371103e31)),
                                        ),
                                ),
                        ),
                );
            let q52 = R::of(5.594335018270987e25)
                .mul_add(t21, R::of(6.992918772838733e26))
                .mul_add(
                    t48,
                    R::of(2.0226791956878486e27)
                        .mul_add(t21, R::of(-6.985194545314902e27))
                        .mul_add(
                            t28,
                            R::of(-3.387144160160026e28)
                                .mul_add(t21, R::of(6.0484612682587175e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(3.5995888880137566e29)
                                .mul_add(t21, R::of(-5.0825979930582326e28))
                                .mul_add(
                                    t28,
                                    R::of(-1.030203168275692e30)
                                        .mul_add(t21, R::of(-6.079105285679961e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-5.111098186040749e30)
                        .mul_add(t21, R::of(-5.6024969802438414e29))
                        .mul_add(
                            t28,
                            R::of(3.1242637033175013e31)
                                .mul_add(t21, R::of(-8.189509026402782e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.4769385492136357e31)
                                .mul_add(t21, R::of(9.850359865133016e31))
                                .mul_add(
                                    t28,
                                    R::of(-4.1892740729782076e32)
                                        .mul_add(t21, R::of(-7.2020947584172785e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(7.207309462591606e32)
                                .mul_add(t21, R::of(-4.964449695818327e32))
                                .mul_add(
                                    t28,
                                    R::of(2.7608935757299623e32)
                                        .mul_add(t21, R::of(1.57334986327763e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-4.9524739119372626e32)
                                        .mul_add(t21, R::of(4.020966523058791e32))
                                        .mul_add(
                                            t28,
                                            R::of(-1.1290948986696278e32)
                                                .mul_add(t21, R::of(5.429292079796992e31)),
                                        ),
                                ),
                        ),
                );
            let q53 = R::of(3.6489463809237716e25)
                .mul_add(t21, R::of(4.5611829761547146e26))
                .mul_add(
                    t48,
                    R::of(1.234637960829873e27)
                        .mul_add(t21, R::of(-6.290208142006807e27))
                        .mul_add(
                            t28,
                            R::of(-3.7285252793426515e28)
                                .mul_add(t21, R::of(-2.445961704035142e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.623343199275023e29)
                                .mul_add(t21, R::of(3.2774283995002356e29))
                                .mul_add(
                                    t28,
                                    R::of(5.318877708606916e29)
                                        .mul_add(t21, R::of(5.703670608561676e29)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-4.014847906896831e30)
                        .mul_add(t21, R::of(-1.0039970544654265e31))
                        .mul_add(
                            t28,
                            R::of(-5.649133670038016e30)
                                .mul_add(t21, R::of(4.4415614433786313e30)),
                        )
                        .mul_add(
                            t37,
                            R::of(6.094419743121191e31)
                                .mul_add(t21, R::of(1.209024258405513e32))
                                .mul_add(
                                    t28,
                                    R::of(-6.191748858923468e31)
                                        .mul_add(t21, R::of(-3.30634107938996e32)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-1.0861329088221972e32)
                                .mul_add(t21, R::of(3.507502369422683e32))
                                .mul_add(
                                    t28,
                                    R::of(2.661209382969032e31)
                                        .mul_add(t21, R::of(-8.588115609468556e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(4.439306314363133e31)
                                        .mul_add(t21, R::of(-1.4301053853654945e32))
                                        .mul_add(
                                            t28,
                                            R::of(2.7659072650209364e31)
                                                .mul_add(t21, R::of(1.4242844000766857e31)),
                                        ),
                                ),
                        ),
                );
            let q54 = t1729
                .mul_add(
                    t48,
                    R::of(1.7064727934741827e28)
                        .mul_add(t21, R::of(-1.0463097479804922e29))
                        .mul_add(
                            t28,
                            R::of(-4.51695920044221e29)
                                .mul_add(t21, R::of(8.029613124393762e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(4.8862363509194093e30)
                                .mul_add(t21, R::of(-3.890754000249167e30))
                                .mul_add(
                                    t28,
                                    R::of(-2.8945495879751156e31)
                                        .mul_add(t21, R::of(1.7577248557490903e31)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(9.653909774763355e31)
                        .mul_add(t21, R::of(-7.732404544829246e31))
                        .mul_add(
                            t28,
                            R::of(-1.3531059759097797e32)
                                .mul_add(t21, R::of(1.97618224026421e32)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.5760583012954738e32)
                                .mul_add(t21, R::of(-2.948102867878051e31))
                                .mul_add(
                                    t28,
                                    R::of(6.003768888554708e32)
                                        .mul_add(t21, R::of(-7.095418429320337e32)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(3.2172683523492844e32)
                                .mul_add(t21, R::of(1.0850458535327591e32))
                                .mul_add(
                                    t28,
                                    R::of(-9.940975823170002e32)
                                        .mul_add(t21, R::of(1.4066028073037095e33)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-1.094220729108501e33)
                                        .mul_add(t21, R::of(7.461926229761914e32))
                                        .mul_add(
                                            t28,
                                            R::of(-3.260423327718319e32)
                                                .mul_add(t21, R::of(7.7918925562643145e31)),
                                        ),
                                ),
                        ),
                );
            let q55 = t1779
                .mul_add(
                    t48,
                    R::of(-4.0355631742832505e27)
                        .mul_add(t21, R::of(2.149601634219103e28))
                        .mul_add(
                            t28,
                            R::of(9.411866329912502e28)
                                .mul_add(t21, R::of(-2.3566653853932677e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.1044063291148814e30)
                                .mul_add(t21, R::of(2.630638257306044e30))
                                .mul_add(
                                    t28,
                                    R::of(9.259441233650624e30)
                                        .mul_add(t21, R::of(-2.2191556950556e31)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-5.15514513361518e31)
                        .mul_add(t21, R::of(1.1858492199531958e32))
                        .mul_add(
                            t28,
                            R::of(1.4757922250797703e32)
                                .mul_add(t21, R::of(-3.491816201612181e32)),
                        )
                        .mul_add(
                            t37,
                            R::of(-3.155189495403432e31)
                                .mul_add(t21, R::of(2.5358872266301358e32))
                                .mul_add(
                                    t28,
                                    R::of(-6.763044255547234e32)
                                        .mul_add(t21, R::of(1.2880412523578308e33)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(1.165821155308538e31)
                                .mul_add(t21, R::of(-1.540866361734736e33))
                                .mul_add(
                                    t28,
                                    R::of(2.2197030422448395e33)
                                        .mul_add(t21, R::of(-3.042227749213253e33)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(2.4747568117121347e33)
                                        .mul_add(t21, R::of(-1.4152802541491287e33))
                                        .mul_add(
                                            t28,
                                            R::of(7.729590086319983e32)
                                                .mul_add(t21, R::of(-1.451606491577599e32)),
                                        ),
                                ),
                        ),
                );
            let q56 = t1829
                .mul_add(
                    t48,
                    R::of(1.1051857546288278e28)
                        .mul_add(t21, R::of(5.304349894860063e27))
                        .mul_add(
                            t28,
                            R::of(-8.9735599174451e28)
                                .mul_add(t21, R::of(-3.35199072580103e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(-3.251587658648609e29)
                                .mul_add(t21, R::of(2.4256719169198448e30))
                                .mul_add(
                                    t28,
                                    R::of(7.804814712656929e30)
                                        .mul_add(t21, R::of(-7.524979742516616e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-4.8035167989031635e31)
                        .mul_add(t21, R::of(5.038597961210705e30))
                        .mul_add(
                            t28,
                            R::of(1.3912558176671416e32)
                                .mul_add(t21, R::of(2.9614286732703302e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.3316094443253681e32)
                                .mul_add(t21, R::of(-4.863685593176745e31))
                                .mul_add(
                                    t28,
                                    R::of(-2.3656304028812538e32)
                                        .mul_add(t21, R::of(-7.526695492596543e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(6.876428375769953e32)
                                .mul_add(t21, R::of(7.15908322233028e31))
                                .mul_add(
                                    t28,
                                    R::of(-3.9631072589386746e32)
                                        .mul_add(t21, R::of(3.843280840360463e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-7.237254631995364e32)
                                        .mul_add(t21, R::of(3.40660164637222e32))
                                        .mul_add(
                                            t28,
                                            R::of(-8.887525444460542e31)
                                                .mul_add(t21, R::of(4.056928345699493e31)),
                                        ),
                                ),
                        ),
                );
            let q57 = R::of(-2.386606102322724e26)
                .mul_add(t21, R::of(-2.983257627903405e27))
                .mul_add(
                    t48,
                    R::of(-9.401197945699807e27)
                        .mul_add(t21, R::of(2.608302751307954e28))
                        .mul_add(
                            t28,
                            R::of(1.856635266066708e29)
                                .mul_add(t21, R::of(2.9042511027502907e28)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.4514367637383855e30)
                                .mul_add(t21, R::of(-1.6104456037969722e30))
                                .mul_add(
                                    t28,
                                    R::of(6.110109287067663e30)
                                        .mul_add(t21, R::of(1.0574686745660927e31)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-1.549172014825937e31)
                        .mul_add(t21, R::of(-3.450026154320098e31))
                        .mul_add(
                            t28,
                            R::of(2.733687183061692e31)
                                .mul_add(t21, R::of(5.279618431138243e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(-3.7830304903164697e31)
                                .mul_add(t21, R::of(2.0271316898021884e31))
                                .mul_add(
                                    t28,
                                    R::of(-3.447705533956498e30)
                                        .mul_add(t21, R::of(-1.4645110459688463e32)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(1.400771727793985e32)
                                .mul_add(t21, R::of(-1.80921003283995e31))
                                .mul_add(
                                    t28,
                                    R::of(-1.136618744251164e30)
                                        .mul_add(t21, R::of(6.1384794397520425e31)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-7.06867664017586e31)
                                        .mul_add(t21, R::of(1.6653389428397726e31))
                                        .mul_add(
                                            t28,
                                            R::of(9.248123596840665e30)
                                                .mul_add(t21, R::of(-7.726231903203783e28)),
                                        ),
                                ),
                        ),
                );
            let q58 = R::of(-6.526724187982818e25)
                .mul_add(t21, R::of(-8.158405234978523e26))
                .mul_add(
                    t48,
                    R::of(-3.416201944593059e27)
                        .mul_add(t21, R::of(-3.7745053491157094e27))
                        .mul_add(
                            t28,
                            R::of(1.7415152700827347e28)
                                .mul_add(t21, R::of(1.217507227566591e29)),
                        )
                        .mul_add(
                            t37,
                            R::of(2.8889866628662873e29)
                                .mul_add(t21, R::of(-7.639109541493224e29))
                                .mul_add(
                                    t28,
                                    R::of(-4.0958206254653297e30)
                                        .mul_add(t21, R::of(1.4773689691771468e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(2.2999374857217594e31)
                        .mul_add(t21, R::of(4.495186439413912e30))
                        .mul_add(
                            t28,
                            R::of(-6.5596526522974615e31)
                                .mul_add(t21, R::of(-3.3013637357949153e31)),
                        )
                        .mul_add(
                            t37,
                            R::of(8.027680349335136e31)
                                .mul_add(t21, R::of(7.856464682010893e31))
                                .mul_add(
                                    t28,
                                    R::of(4.8853455924005493e30)
                                        .mul_add(t21, R::of(-1.2838748809827526e31)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-1.3388133752591393e32)
                                .mul_add(t21, R::of(-2.0307297402890337e32))
                                .mul_add(
                                    t28,
                                    R::of(3.083806485848213e32)
                                        .mul_add(t21, R::of(-1.884013125649723e32)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(2.6153619152288683e32)
                                        .mul_add(t21, R::of(-7.302124357674363e31))
                                        .mul_add(
                                            t28,
                                            R::of(4.730980807443821e30)
                                                .mul_add(t21, R::of(-6.332951602373609e30)),
                                        ),
                                ),
                        ),
                );
            let q59 = R::of(1.8607478245274847e26)
                .mul_add(t21, R::of(2.325934780659356e27))
                .mul_add(
                    t48,
                    R::of(6.995928578299741e27)
                        .mul_add(t21, R::of(-2.134650354178336e28))
                        .mul_add(
                            t28,
                            R::of(-1.3311328243956825e29)
                                .mul_add(t21, R::of(-7.312328174899184e27)),
                        )
                        .mul_add(
                            t37,
                            R::of(8.786224341785205e29)
                                .mul_add(t21, R::of(1.1680723862362105e30))
                                .mul_add(
                                    t28,
                                    R::of(-1.8909407302684563e30)
                                        .mul_add(t21, R::of(-9.554477138111803e30)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-6.270375182066723e30)
                        .mul_add(t21, R::of(4.8536676001963755e31))
                        .mul_add(
                            t28,
                            R::of(3.4442191272869156e31)
                                .mul_add(t21, R::of(-1.4950553158986283e32)),
                        )
                        .mul_add(
                            t37,
                            R::of(3.864933679972198e31)
                                .mul_add(t21, R::of(1.1015257580314859e32))
                                .mul_add(
                                    t28,
                                    R::of(-3.575644290370529e32)
                                        .mul_add(t21, R::of(6.4056851781380726e32)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-1.5567601283913237e32)
                                .mul_add(t21, R::of(-6.2146530801674e32))
                                .mul_add(
                                    t28,
                                    R::of(1.1928798393074337e33)
                                        .mul_add(t21, R::of(-1.683245292447706e33)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(1.39126831126152e33)
                                        .mul_add(t21, R::of(-8.387125551521653e32))
                                        .mul_add(
                                            t28,
                                            R::of(4.2577021587428596e32)
                                                .mul_add(t21, R::of(-7.266986408496679e31)),
                                        ),
                                ),
                        ),
                );
            let q60 = (R::of(0.0016666666666666668) * v)
                .mul_add(v, R::of(0.006666666666666667))
                .mul_add(v, R::of(0.03333333333333333));
            OfV {
                t3: R::of(4.0) * v,
                q1,
                q2,
                q3,
                t75,
                t99,
                q6,
                t136,
                q8,
                t168,
                t172,
                t174,
                t178,
                q8_over_q3,
                q6_over_q3,
                t183,
                t187: R::of(60.0) * q3,
                t191,
                t195: q9 * t191,
                t197: R::of(60.0) * q2 * q3,
                t198: R::of(60.0) * t75,
                t199: R::of(60.0) * t99,
                t200: R::of(60.0) * q6,
                t201: R::of(60.0) * t136,
                t202: R::of(60.0) * q8,
                t204: R::of(120.0) * t99,
                q10,
                q11,
                t462,
                t463,
                t464,
                t465,
                t466,
                t467,
                t469: R::of(-1.8) * v,
                t470: R::of(-1.0) * v,
                t534: (-t172).mul_add(q21, (-t462).mul_add(t529, q19)) * q3_inverse,
                t565: (-t174).mul_add(q21, (-t463).mul_add(t529, q23)) * q3_inverse,
                t596: (-t178).mul_add(q21, (-t464).mul_add(t529, q25)) * q3_inverse,
                t628: (-q8_over_q3).mul_add(q21, (-t465).mul_add(t529, q27))
                    * q3_inverse,
                t660: (-q6_over_q3).mul_add(q21, (-t466).mul_add(t529, q29))
                    * q3_inverse,
                t666: (-t183).mul_add(q21, (-t467).mul_add(t529, R::of(2.0) * q25))
                    * q3_inverse,
                q30,
                q31,
                q32,
                q33,
                q34,
                q35,
                q36,
                q37,
                q38,
                q39,
                q40,
                q41,
                q42,
                q43,
                q44,
                t1513: R::of(2.0) * q36,
                t1514: R::of(2.0) * q37,
                t1515: R::of(2.0) * q38,
                t1517: R::of(3.0) * q39,
                t1518: R::of(3.0) * q40,
                t1519: R::of(3.0) * q41,
                t1520: R::of(4.0) * q42,
                t1521: R::of(4.0) * q43,
                t1522: R::of(4.0) * q44,
                q45,
                q46,
                q47,
                q48,
                q49,
                q50,
                q51,
                q52,
                q53,
                q54,
                q55,
                q56,
                q57,
                q58,
                q59,
                t2318: q60 / (q17 * t460),
            }
        }
    }
    /// What points need of u alone.
    struct OfU<R> {
        u: R,
        p4: R,
        p1: R,
        z_numerator: R,
        z_numerator_over_p1: R,
        t173: R,
        t229: R,
        t230: R,
        t236: R,
        t237: R,
        t238: R,
        t698: R,
        t699: R,
    }
    /// What points need of v alone.
    struct OfV<R> {
        t3: R,
        q1: R,
        q2: R,
        q3: R,
        t75: R,
        t99: R,
        q6: R,
        t136: R,
        q8: R,
        t168: R,
        t172: R,
        t174: R,
        t178: R,
        q8_over_q3: R,
        q6_over_q3: R,
        t183: R,
        t187: R,
        t191: R,
        t195: R,
        t197: R,
        t198: R,
        t199: R,
        t200: R,
        t201: R,
        t202: R,
        t204: R,
        q10: R,
        q11: R,
        t462: R,
        t463: R,
        t464: R,
        t465: R,
        t466: R,
        t467: R,
        t469: R,
        t470: R,
        t534: R,
        t565: R,
        t596: R,
        t628: R,
        t660: R,
        t666: R,
        q30: R,
        q31: R,
        q32: R,
        q33: R,
        q34: R,
        q35: R,
        q36: R,
        q37: R,
        q38: R,
        q39: R,
        q40: R,
        q41: R,
        q42: R,
        q43: R,
        q44: R,
        t1513: R,
        t1514: R,
        t1515: R,
        t1517: R,
        t1518: R,
        t1519: R,
        t1520: R,
        t1521: R,
        t1522: R,
        q45: R,
        q46: R,
        q47: R,
        q48: R,
        q49: R,
        q50: R,
        q51: R,
        q52: R,
        q53: R,
        q54: R,
        q55: R,
        q56: R,
        q57: R,
        q58: R,
        q59: R,
        t2318: R,
    }
    impl ::hodograph::Stages<::hodograph::Homogeneous> for FramesGutter1 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 3];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 10];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 3] {
            let values = Self::values_of_u(u);
            [values.u, values.p1, values.z_numerator]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 10] {
            let values = Self::values_of_v(v);
            [
                values.t187,
                values.t191,
                values.t195,
                values.t197,
                values.t198,
                values.t199,
                values.t200,
                values.t201,
                values.t202,
                values.t204,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 3], of_v: [R; 10]) -> [R; 4] {
            let [u, p1, z_numerator] = of_u;
            let [t187, t191, t195, t197, t198, t199, t200, t201, t202, t204] = of_v;
            let t207 = -z_numerator;
            [
                p1 * t187,
                t207.mul_add(t198, u.mul_add(t201, p1 * t191)),
                t207.mul_add(t199, u.mul_add(t202, p1 * t195)),
                t207.mul_add(t200, u.mul_add(t204, p1 * t197)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Point> for FramesGutter1 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 3];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 10];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 3] {
            let values = Self::values_of_u(u);
            [values.u, values.p1, values.z_numerator]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 10] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.q3,
                values.t75,
                values.t99,
                values.q6,
                values.t136,
                values.q8,
                values.t168,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 3], of_v: [R; 10]) -> [R; 3] {
            let [u, p1, z_numerator] = of_u;
            let [t3, q1, q2, q3, t75, t99, q6, t136, q8, t168] = of_v;
            let weight_inverse = R::of(1.0) / (p1 * q3);
            let t218 = u * weight_inverse;
            let t220 = -(z_numerator * weight_inverse);
            [
                t220.mul_add(t75, t218.mul_add(t136, t3)),
                t220.mul_add(t99, t218.mul_add(q8, q1)),
                t220.mul_add(q6, t218.mul_add(t168, q2)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Separated> for FramesGutter1 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 2];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 9];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 2] {
            let values = Self::values_of_u(u);
            [values.z_numerator_over_p1, values.t173]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 9] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t172,
                values.t174,
                values.t178,
                values.q8_over_q3,
                values.q6_over_q3,
                values.t183,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 2], of_v: [R; 9]) -> [R; 3] {
            let [z_numerator_over_p1, t173] = of_u;
            let [t3, q1, q2, t172, t174, t178, q8_over_q3, q6_over_q3, t183] = of_v;
            let t176 = -z_numerator_over_p1;
            [
                t176.mul_add(t172, t173.mul_add(t174, t3)),
                t176.mul_add(t178, t173.mul_add(q8_over_q3, q1)),
                t176.mul_add(q6_over_q3, t173.mul_add(t183, q2)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::First> for FramesGutter1 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 4];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 17];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 4] {
            let values = Self::values_of_u(u);
            [values.z_numerator_over_p1, values.t173, values.t229, values.t230]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 17] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t172,
                values.t174,
                values.t178,
                values.q8_over_q3,
                values.q6_over_q3,
                values.t183,
                values.q10,
                values.q11,
                values.t462,
                values.t463,
                values.t464,
                values.t465,
                values.t466,
                values.t467,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 4], of_v: [R; 17]) -> [R; 9] {
            let [z_numerator_over_p1, t173, t229, t230] = of_u;
            let [t3, q1, q2, t172, t174, t178, q8_over_q3, q6_over_q3, t183, q10, q11,
            t462, t463, t464, t465, t466, t467] = of_v;
            let t176 = -z_numerator_over_p1;
            let t668 = -t230;
            [
                t176.mul_add(t172, t173.mul_add(t174, t3)),
                t176.mul_add(t178, t173.mul_add(q8_over_q3, q1)),
                t176.mul_add(q6_over_q3, t173.mul_add(t183, q2)),
                t668.mul_add(t174, t229 * t172),
                t668.mul_add(q8_over_q3, t229 * t178),
                t668.mul_add(t183, t229 * q6_over_q3),
                t176.mul_add(t462, t173.mul_add(t463, R::of(4.0))),
                t176.mul_add(t464, t173.mul_add(t465, q10)),
                t176.mul_add(t466, t173.mul_add(t467, q11)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Second> for FramesGutter1 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 6];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 25];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 6] {
            let values = Self::values_of_u(u);
            [
                values.z_numerator_over_p1,
                values.t173,
                values.t229,
                values.t230,
                values.t237,
                values.t238,
            ]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 25] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t172,
                values.t174,
                values.t178,
                values.q8_over_q3,
                values.q6_over_q3,
                values.t183,
                values.q10,
                values.q11,
                values.t462,
                values.t463,
                values.t464,
                values.t465,
                values.t466,
                values.t467,
                values.t469,
                values.t470,
                values.t534,
                values.t565,
                values.t596,
                values.t628,
                values.t660,
                values.t666,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 6], of_v: [R; 25]) -> [R; 18] {
            let [z_numerator_over_p1, t173, t229, t230, t237, t238] = of_u;
            let [t3, q1, q2, t172, t174, t178, q8_over_q3, q6_over_q3, t183, q10, q11,
            t462, t463, t464, t465, t466, t467, t469, t470, t534, t565, t596, t628, t660,
            t666] = of_v;
            let t176 = -z_numerator_over_p1;
            let t668 = -t230;
            [
                t176.mul_add(t172, t173.mul_add(t174, t3)),
                t176.mul_add(t178, t173.mul_add(q8_over_q3, q1)),
                t176.mul_add(q6_over_q3, t173.mul_add(t183, q2)),
                t668.mul_add(t174, t229 * t172),
                t668.mul_add(q8_over_q3, t229 * t178),
                t668.mul_add(t183, t229 * q6_over_q3),
                t176.mul_add(t462, t173.mul_add(t463, R::of(4.0))),
                t176.mul_add(t464, t173.mul_add(t465, q10)),
                t176.mul_add(t466, t173.mul_add(t467, q11)),
                t238.mul_add(t174, t237 * t172),
                t238.mul_add(q8_over_q3, t237 * t178),
                t238.mul_add(t183, t237 * q6_over_q3),
                t668.mul_add(t463, t229 * t462),
                t668.mul_add(t465, t229 * t464),
                t668.mul_add(t467, t229 * t466),
                t176.mul_add(t534, t173 * t565),
                t176.mul_add(t596, t173.mul_add(t628, t469)),
                t176.mul_add(t660, t173.mul_add(t666, t470)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Normal> for FramesGutter1 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 4];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 15];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 4] {
            let values = Self::values_of_u(u);
            [values.u, values.p4, values.t698, values.t699]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 15] {
            let values = Self::values_of_v(v);
            [
                values.q30,
                values.q31,
                values.q32,
                values.q33,
                values.q34,
                values.q35,
                values.q36,
                values.q37,
                values.q38,
                values.q39,
                values.q40,
                values.q41,
                values.q42,
                values.q43,
                values.q44,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 4], of_v: [R; 15]) -> [R; 3] {
            let [u, p4, t698, t699] = of_u;
            let [q30, q31, q32, q33, q34, q35, q36, q37, q38, q39, q40, q41, q42, q43,
            q44] = of_v;
            let t1492 = t699
                .mul_add(q42, t698.mul_add(q39, p4.mul_add(q36, u.mul_add(q33, q30))));
            let t1496 = t699
                .mul_add(q43, t698.mul_add(q40, p4.mul_add(q37, u.mul_add(q34, q31))));
            let t1500 = t699
                .mul_add(q44, t698.mul_add(q41, p4.mul_add(q38, u.mul_add(q35, q32))));
            let t1501 = R::scale(t1492, t1496, t1500);
            let t1502 = t1492 * t1501;
            let t1503 = t1496 * t1501;
            let t1504 = t1500 * t1501;
            let t1509 = R::of(1.0)
                / t1504.mul_add(t1504, t1503.mul_add(t1503, t1502 * t1502)).sqrt();
            [t1502 * t1509, t1503 * t1509, t1504 * t1509]
        }
    }
    impl ::hodograph::Stages<::hodograph::Local> for FramesGutter1 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 11];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 65];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 11] {
            let values = Self::values_of_u(u);
            [
                values.u,
                values.p4,
                values.z_numerator_over_p1,
                values.t173,
                values.t229,
                values.t230,
                values.t236,
                values.t237,
                values.t238,
                values.t698,
                values.t699,
            ]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 65] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t172,
                values.t174,
                values.t178,
                values.q8_over_q3,
                values.q6_over_q3,
                values.t183,
                values.q10,
                values.q11,
                values.t462,
                values.t463,
                values.t464,
                values.t465,
                values.t466,
                values.t467,
                values.t469,
                values.t470,
                values.t534,
                values.t565,
                values.t596,
                values.t628,
                values.t660,
                values.t666,
                values.q30,
                values.q31,
                values.q32,
                values.q33,
                values.q34,
                values.q35,
                values.q36,
                values.q37,
                values.q38,
                values.q39,
                values.q40,
                values.q41,
                values.q42,
                values.q43,
                values.q44,
                values.t1513,
                values.t1514,
                values.t1515,
                values.t1517,
                values.t1518,
                values.t1519,
                values.t1520,
                values.t1521,
                values.t1522,
                values.q45,
                values.q46,
                values.q47,
                values.q48,
                values.q49,
                values.q50,
                values.q51,
                values.q52,
                values.q53,
                values.q54,
                values.q55,
                values.q56,
                values.q57,
                values.q58,
                values.q59,
                values.t2318,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 11], of_v: [R; 65]) -> [R; 39] {
            let [u, p4, z_numerator_over_p1, t173, t229, t230, t236, t237, t238, t698,
            t699] = of_u;
            let [t3, q1, q2, t172, t174, t178, q8_over_q3, q6_over_q3, t183, q10, q11,
            t462, t463, t464, t465, t466, t467, t469, t470, t534, t565, t596, t628, t660,
            t666, q30, q31, q32, q33, q34, q35, q36, q37, q38, q39, q40, q41, q42, q43,
            q44, t1513, t1514, t1515, t1517, t1518, t1519, t1520, t1521, t1522, q45, q46,
            q47, q48, q49, q50, q51, q52, q53, q54, q55, q56, q57, q58, q59, t2318] = of_v;
            let t176 = -z_numerator_over_p1;
            let t668 = -t230;
            let t669 = t668.mul_add(t174, t229 * t172);
            let t671 = t668.mul_add(q8_over_q3, t229 * t178);
            let t673 = t668.mul_add(t183, t229 * q6_over_q3);
            let t675 = t176.mul_add(t462, t173.mul_add(t463, R::of(4.0)));
            let t677 = t176.mul_add(t464, t173.mul_add(t465, q10));
            let t679 = t176.mul_add(t466, t173.mul_add(t467, q11));
            let t1492 = t699
                .mul_add(q42, t698.mul_add(q39, p4.mul_add(q36, u.mul_add(q33, q30))));
            let t1496 = t699
                .mul_add(q43, t698.mul_add(q40, p4.mul_add(q37, u.mul_add(q34, q31))));
            let t1500 = t699
                .mul_add(q44, t698.mul_add(q41, p4.mul_add(q38, u.mul_add(q35, q32))));
            let t1501 = R::scale(t1492, t1496, t1500);
            let t1502 = t1492 * t1501;
            let t1503 = t1496 * t1501;
            let t1504 = t1500 * t1501;
            let t1508 = t1504.mul_add(t1504, t1503.mul_add(t1503, t1502 * t1502)).sqrt();
            let t1509 = R::of(1.0) / t1508;
            let t1510 = t1502 * t1509;
            let t1511 = t1503 * t1509;
            let t1512 = t1504 * t1509;
            let t1525 = t698.mul_add(t1520, p4.mul_add(t1517, u.mul_add(t1513, q33)));
            let t1528 = t698.mul_add(t1521, p4.mul_add(t1518, u.mul_add(t1514, q34)));
            let t1531 = t698.mul_add(t1522, p4.mul_add(t1519, u.mul_add(t1515, q35)));
            let t2276 = t699
                .mul_add(q57, t698.mul_add(q54, p4.mul_add(q51, u.mul_add(q48, q45))));
            let t2280 = t699
                .mul_add(q58, t698.mul_add(q55, p4.mul_add(q52, u.mul_add(q49, q46))));
            let t2284 = t699
                .mul_add(q59, t698.mul_add(q56, p4.mul_add(q53, u.mul_add(q50, q47))));
            let t2285 = t1501 * t1509;
            let t2289 = t673.mul_add(t673, t671.mul_add(t671, t669 * t669));
            let t2292 = t673.mul_add(t679, t671.mul_add(t677, t669 * t675));
            let t2295 = t679.mul_add(t679, t677.mul_add(t677, t675 * t675));
            let t2300 = -(t1531.mul_add(t673, t1528.mul_add(t671, t1525 * t669))
                * t2285);
            let t2310 = -(t2284.mul_add(t673, t2280.mul_add(t671, t2276 * t669))
                * t2285);
            let area = t236 * t2318;
            let t2322 = (-t1512).mul_add(t671, t1511 * t673);
            let t2325 = (-t1510).mul_add(t673, t1512 * t669);
            let t2328 = (-t1511).mul_add(t669, t1510 * t671);
            let t2333 = t2284.mul_add(t2328, t2280.mul_add(t2325, t2276 * t2322))
                * t2285;
            let t2335 = R::of(1.0) / t2289;
            let t2341 = t2300 * t2335;
            let t2342 = -(t1531.mul_add(t2328, t1528.mul_add(t2325, t1525 * t2322))
                * t2285) * t2335;
            let t2345 = -t2292.mul_add(t2342, t2333) / (area * (t1508 / t1501));
            let t2346 = -t2333 * t2335;
            let t2347 = t2310 * t2335;
            let t2368 = t2300.mul_add(t2335, t2345);
            let t2375 = R::of(0.5) * t2300.mul_add(t2335, -t2345);
            let t2378 = t2342.mul_add(t2342, t2375 * t2375).sqrt();
            [
                t176.mul_add(t172, t173.mul_add(t174, t3)),
                t176.mul_add(t178, t173.mul_add(q8_over_q3, q1)),
                t176.mul_add(q6_over_q3, t173.mul_add(t183, q2)),
                t669,
                t671,
                t673,
                t675,
                t677,
                t679,
                t238.mul_add(t174, t237 * t172),
                t238.mul_add(q8_over_q3, t237 * t178),
                t238.mul_add(t183, t237 * q6_over_q3),
                t668.mul_add(t463, t229 * t462),
                t668.mul_add(t465, t229 * t464),
                t668.mul_add(t467, t229 * t466),
                t176.mul_add(t534, t173 * t565),
                t176.mul_add(t596, t173.mul_add(t628, t469)),
                t176.mul_add(t660, t173.mul_add(t666, t470)),
                t1510,
                t1511,
                t1512,
                t2289,
                t2292,
                t2295,
                t2300,
                t2310,
                -(t2284.mul_add(t679, t2280.mul_add(t677, t2276 * t675)) * t2285),
                (-t2342).mul_add(t2342, t2341 * t2345),
                R::of(0.5) * t2368,
                R::of(0.5).mul_add(t2368, t2378),
                R::of(0.5).mul_add(t2368, -t2378),
                t2289.sqrt(),
                t2295.sqrt(),
                -t2342.mul_add(t2322, t2341 * t669),
                -t2342.mul_add(t2325, t2341 * t671),
                -t2342.mul_add(t2328, t2341 * t673),
                -t2346.mul_add(t2322, t2347 * t669),
                -t2346.mul_add(t2325, t2347 * t671),
                -t2346.mul_add(t2328, t2347 * t673),
            ]
        }
    }
    impl ::hodograph::Sweep for FramesGutter1 {}
    impl ::hodograph::Patch for FramesGutter1 {
        fn name(&self) -> &str {
            Self::NAME
        }
        fn degree(&self) -> (u32, u32) {
            Self::DEGREE
        }
        fn domain(&self) -> ::hodograph::Domain {
            Self::DOMAIN
        }
        fn control_net(&self) -> &[[f64; 4]] {
            &Self::CONTROL_NET
        }
        fn bounds(&self) -> ::core::option::Option<&::hodograph::Bounds> {
            ::core::option::Option::Some(&Self::BOUNDS)
        }
    }
}
/// A gutter: half a circle that goes downhill through four frames, turns to both sides and is wider in the middle.
///
/// Position, orientation and size are C2 cubic splines through the frames; that of the orientation is in the 4-space that Euler's map M folds
/// onto the sphere of unit quaternions, with rational points for the rational frames.
///
/// ```text
/// profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));
/// frames F(v) = frames_file("gutter.json");
/// surface R = F.sweep(c);
/// domain u in -1..1;
/// ```
///
/// Source: `JW (1)`.
///
/// - Degree (2, 15): W (2, 12), X (2, 14), Y (2, 15), Z (2, 15).
/// - Domain: u from -1.0 to 1.0, v from 1.0 to 2.0.
/// - W ≠ 0 on the domain: certified.
/// - R_u × R_v ≠ 0 on the domain: certified.
///
/// | operations | at one place | on a grid for each v | for each u | for each point |
/// | --- | --- | --- | --- | --- |
/// | homogeneous coordinates | 162: 69 +, 93 × | 61 +, 82 × | 2 +, 1 × | 6 +, 10 × |
/// | point | 151: 69 +, 81 ×, 1 ÷ | 61 +, 71 × | 2 +, 1 × | 6 +, 9 ×, 1 ÷ |
/// | point, separated | 157: 69 +, 86 ×, 2 ÷ | 61 +, 77 ×, 1 ÷ | 2 +, 3 ×, 1 ÷ | 6 +, 6 × |
/// | point and first derivatives | 391: 177 +, 211 ×, 3 ÷ | 160 +, 186 ×, 2 ÷ | 2 +, 7 ×, 1 ÷ | 15 +, 18 × |
/// | point, first and second derivatives | 600: 271 +, 326 ×, 3 ÷ | 241 +, 277 ×, 2 ÷ | 4 +, 13 ×, 1 ÷ | 26 +, 36 × |
/// | unit normal | 739: 378 +, 359 ×, 1 ÷, 1 √ | 364 +, 335 × | 3 × | 14 +, 21 ×, 1 ÷, 1 √ |
/// | everything: derivatives, normal, fundamental forms, curvatures | 2172: 1057 +, 1103 ×, 8 ÷, 4 √ | 960 +, 950 ×, 3 ÷ | 4 +, 15 ×, 1 ÷ | 93 +, 138 ×, 4 ÷, 4 √ |
///
/// | error at most | `f64` plain | fused | `f32` plain | fused | size from | to | each, `f64` plain | relative |
/// | --- | --- | --- | --- | --- | --- | --- | --- | --- |
/// | homogeneous | 3.5e2 | 3.08e2 | 1.84e11 | 1.61e11 | 3.97e17 | 4.3e17 | 3.01e1, 3.5e2, 1.62e2, 1.09e2 | 6.59e-16, 1.14e-15, 3.4e-14, – |
/// | point | 3.05e-15 | 2.75e-15 | 1.57e-6 | 1.41e-6 | 8.28e0 | 8.49e0 | 2.55e-15, 3.05e-15, 2.75e-15 | 3.71e-16, 3.35e-14, – |
/// | separated point | 2.92e-15 | 2.64e-15 | 1.51e-6 | 1.36e-6 | 8.28e0 | 8.49e0 | 2.54e-15, 2.92e-15, 2.72e-15 | 3.79e-16, 3.32e-14, – |
/// | partial u | 5.97e-15 | 5.44e-15 | 3.13e-6 | 2.84e-6 | 2.83e0 | 3.14e0 | 1.98e-15, 5.97e-15, 4.52e-15 | –, –, – |
/// | partial v | 2.96e-15 | 2.5e-15 | 1.58e-6 | 1.33e-6 | 4.92e0 | 5e0 | 2.45e-15, 2.96e-15, 2.7e-15 | 6.67e-16, –, – |
/// | partial uu | 1.46e-14 | 1.43e-14 | 7.71e-6 | 7.55e-6 | 5.81e0 | 6.58e0 | 3.73e-15, 1.21e-14, 1.46e-14 | –, –, – |
/// | partial uv | 5.51e-15 | 5.13e-15 | 2.94e-6 | 2.74e-6 | 2.14e0 | 2.61e0 | 4.12e-15, 4.78e-15, 5.51e-15 | –, –, – |
/// | partial vv | 1.21e-14 | 9.7e-15 | 6.6e-6 | 5.34e-6 | 4.18e0 | 4.57e0 | 3.94e-15, 1.21e-14, 1.15e-14 | –, –, – |
/// | unit normal | 5.62e-15 | 4.88e-15 | 3.12e-6 | 2.72e-6 | 9.62e-1 | 1e0 | 1.33e-15, 5.62e-15, 3.34e-15 | –, –, – |
/// | first form | 4.91e-14 | 4.47e-14 | 2.58e-5 | 2.35e-5 | 2.92e1 | 3e1 | 4.91e-14, 3.4e-14, 4.44e-14 | 7.27e-15, –, 2.29e-15 |
/// | second form | 4.23e-14 | 3.91e-14 | 2.29e-5 | 2.12e-5 | 5.75e0 | 7.42e0 | 4.23e-14, 2.04e-14, 2.7e-14 | 1.37e-14, 5.12e-13, – |
/// | gaussian | 2.02e-14 | 1.86e-14 | 1.09e-5 | 9.99e-6 | 9.1e-2 | 5.07e-1 | 2.02e-14 | – |
/// | mean | 1.25e-14 | 1.1e-14 | 6.65e-6 | 5.84e-6 | 4.17e-1 | 7.27e-1 | 1.25e-14 | 1.31e-13 |
/// | principal | 2.93e-14 | 2.54e-14 | 1.58e-5 | 1.37e-5 | 7.6e-1 | 1.46e0 | 2.92e-14, 2.93e-14 | –, 2.87e-13 |
/// | speeds | 7.72e-15 | 7.16e-15 | 4.07e-6 | 3.76e-6 | 5.39e0 | 5.48e0 | 7.72e-15, 4.94e-15 | 3.11e-15, 1.26e-15 |
/// | normal u | 5.69e-14 | 5.25e-14 | 3.03e-5 | 2.79e-5 | 1.79e0 | 3.51e0 | 4.41e-14, 5.69e-14, 4.05e-14 | –, –, – |
/// | normal v | 4.01e-14 | 3.54e-14 | 2.17e-5 | 1.92e-5 | 5.89e-1 | 1.48e0 | 4.01e-14, 2.64e-14, 2.02e-14 | –, –, – |
#[allow(
    clippy::approx_constant,
    clippy::doc_markdown,
    clippy::excessive_precision,
    clippy::float_cmp,
    clippy::many_single_char_names,
    clippy::missing_const_for_fn,
    clippy::possible_missing_comma,
    clippy::similar_names,
    clippy::suboptimal_flops,
    clippy::trivially_copy_pass_by_ref,
    clippy::unreadable_literal,
    clippy::unused_self
)]
pub mod frames_gutter_2 {
    /// The surface `frames_gutter_2` as a value.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct FramesGutter2;
    impl FramesGutter2 {
        /// The name of the sweep.
        pub const NAME: &'static str = "frames_gutter_2";
        /// The formula that it was generated from.
        pub const FORMULA: &'static str = "profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));\nframes F(v) = frames_file(\"gutter.json\");\nsurface R = F.sweep(c);\ndomain u in -1..1;";
        /// Where the formula is from.
        pub const SOURCE: ::core::option::Option<&'static str> = ::core::option::Option::Some(
            "JW (1)",
        );
        /// The patch degree in u and v.
        pub const DEGREE: (u32, u32) = (2, 15);
        /// The parameters over which the surface is stated.
        pub const DOMAIN: ::hodograph::Domain = ::hodograph::Domain {
            u: [-1.0, 1.0],
            v: [1.0, 2.0],
        };
        /// Homogeneous Bézier control points (W, X, Y, Z) over the domain, rounded; the index of u is the outer one.
        pub const CONTROL_NET: [[f64; 4]; 48] = [
            [5.05838671875e16, 2.22553828125e17, 1.9480341796875e16, 5.565744140625e16],
            [5.14932373125e16, 2.3778482596875e17, 2.0416377375e16, 5.47292514375e16],
            [
                5.248640243892857e16,
                2.5364676521973213e17,
                2.0810700335892856e16,
                5.419198955892857e16,
            ],
            [
                5.346789592403394e16,
                2.6981167055168995e17,
                2.0717997396263704e16,
                5.397799653158717e16,
            ],
            [
                5.435705594756003e16,
                2.8589637562276605e17,
                2.0196306870032276e16,
                5.403977237858679e16,
            ],
            [
                5.5086575120278456e16,
                3.0148676135334605e17,
                1.9323026319734216e16,
                5.433168533832756e16,
            ],
            [
                5.560358234217469e16,
                3.161652486960874e17,
                1.8197734359455136e16,
                5.479423083613548e16,
            ],
            [
                5.587146398688835e16,
                3.295443743494645e17,
                1.6934261922985086e16,
                5.534288112752907e16,
            ],
            [
                5.587146398688835e16,
                3.413042648084077e17,
                1.5643967031464766e16,
                5.586455294427982e16,
            ],
            [
                5.560358234217469e16,
                3.5123057301898784e17,
                1.4415178227669526e16,
                5.62249315107475e16,
            ],
            [
                5.5086575120278456e16,
                3.5924874747820256e17,
                1.3296406990934056e16,
                5.628650166093593e16,
            ],
            [
                5.435705594756003e16,
                3.6545007126924986e17,
                1.2289765227084706e16,
                5.593193212762057e16,
            ],
            [
                5.346789592403394e16,
                3.701064789729631e17,
                1.135573040744456e16,
                5.50842530236117e16,
            ],
            [
                5.248640243892857e16,
                3.7367652423889286e17,
                1.0424502858535714e16,
                5.371689589007143e16,
            ],
            [5.14932373125e16, 3.768145126875e17, 9407157750000000.0, 5.1852241125e16],
            [5.05838671875e16, 3.8040890625e17, 8201250000000000.0, 4.955396484375e16],
            [0.0, -3417187500000000.0, 2.0218359375e16, -5.9812646484375e16],
            [0.0, -2844163125000000.0, 1.97003896875e16, -6.2469849375e16],
            [0.0, -2190005967857142.8, 1.8568050505714284e16, -6.553354617321429e16],
            [0.0, -1508925558733516.5, 1.6751754841826374e16, -6.882675260208774e16],
            [0.0, -859561477895274.8, 1.4210590333007868e16, -7.214754657163816e16],
            [0.0, -299611831848761.25, 1.0951035766816712e16, -7.527252601275315e16],
            [0.0, 118874819794729.27, 7042739390404162.0, -7.797291292498643e16],
            [0.0, 353424094660825.2, 2626372922590422.5, -8.004008674495742e16],
            [0.0, 374330109053832.2, -2090879020622618.3, -8.131598923889837e16],
            [0.0, 167429332979154.84, -6854737052937773.0, -8.172098560619771e16],
            [0.0, -262867842676483.53, -1.1396072525523284e16, -8.127017351821318e16],
            [0.0, -890258420521978.0, -1.5468182944095164e16, -8.007134965767048e16],
            [0.0, -1664618078185714.3, -1.8878212548957364e16, -7.830409588620062e16],
            [0.0, -2514348424285714.5, -2.1504131076857144e16, -7.618684678875e16],
            [0.0, -3354675750000000.0, -2.3295407625e16, -7.394301675e16],
            [0.0, -4100625000000000.0, -2.426203125e16, -7.177517578125e16],
            [5.05838671875e16, 1.82117109375e17, 1.32271259765625e17, 9.609416015625e16],
            [5.14932373125e16, 2.0113913503125e17, 1.40133398625e17, 9.41300308125e16],
            [
                5.248640243892857e16,
                2.2123985943455357e17,
                1.4815532112910714e17,
                9.132809057035714e16,
            ],
            [
                5.346789592403394e16,
                2.4213822323332877e17,
                1.559767851646183e17,
                8.748150621523992e16,
            ],
            [
                5.435705594756003e16,
                2.6347221895755562e17,
                1.6320972911801872e17,
                8.246095304460253e16,
            ],
            [
                5.5086575120278456e16,
                2.848168853273538e17,
                1.694560624434979e17,
                7.6233756871961e16,
            ],
            [
                5.560358234217469e16,
                3.057123431875633e17,
                1.7433740458353786e17,
                6.887970961694381e16,
            ],
            [
                5.587146398688835e16,
                3.257004574498656e17,
                1.7753372163665437e17,
                6.059562697270992e16,
            ],
            [
                5.587146398688835e16,
                3.4436603907758266e17,
                1.788240165281747e17,
                5.168279490303459e16,
            ],
            [
                5.560358234217469e16,
                3.6137781130955386e17,
                1.781199607153235e17,
                4.251545740487196e16,
            ],
            [
                5.5086575120278456e16,
                3.7652540872778054e17,
                1.7548268177229805e17,
                3.3494356609889356e16,
            ],
            [
                5.435705594756003e16,
                3.8975067689186925e17,
                1.711162707609663e17,
                2.4995566239430236e16,
            ],
            [
                5.346789592403394e16,
                4.011731294188326e17,
                1.6533905215343747e17,
                1.7327827925696968e16,
            ],
            [
                5.248640243892857e16,
                4.1111050964110714e17,
                1.585415186064643e17,
                1.0708633736357142e16,
            ],
            [5.14932373125e16, 4.200992218125e17, 1.5114261825e17, 5261425875000000.0],
            [5.05838671875e16, 4.2893296875e17, 1.435503515625e17, 1029902343750000.0],
        ];
        /// Proved bounds of the errors of the evaluators over the domain.
        pub const BOUNDS: ::hodograph::Bounds = ::hodograph::Bounds {
            homogeneous: ::hodograph::Bound {
                errors: [350.0, 308.0, 184000000000.0, 161000000000.0],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 3.97e17,
                most: 4.3e17,
            },
            point: ::hodograph::Bound {
                errors: [3.05e-15, 2.75e-15, 1.57e-6, 1.41e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 8.28,
                most: 8.49,
            },
            coordinates: [
                [2.55e-15, 2.48e-15, 1.37e-6, 1.33e-6],
                [3.05e-15, 2.75e-15, 1.57e-6, 1.41e-6],
                [2.75e-15, 2.43e-15, 1.45e-6, 1.27e-6],
            ],
            separated_point: ::hodograph::Bound {
                errors: [2.92e-15, 2.64e-15, 1.51e-6, 1.36e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 8.28,
                most: 8.49,
            },
            partial_u: ::hodograph::Bound {
                errors: [5.97e-15, 5.44e-15, 3.13e-6, 2.84e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 2.83,
                most: 3.14,
            },
            partial_v: ::hodograph::Bound {
                errors: [2.96e-15, 2.5e-15, 1.58e-6, 1.33e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.92,
                most: 5.0,
            },
            partial_uu: ::hodograph::Bound {
                errors: [1.46e-14, 1.43e-14, 7.71e-6, 7.55e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 5.81,
                most: 6.58,
            },
            partial_uv: ::hodograph::Bound {
                errors: [5.51e-15, 5.13e-15, 2.94e-6, 2.74e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 2.14,
                most: 2.61,
            },
            partial_vv: ::hodograph::Bound {
                errors: [1.21e-14, 9.7e-15, 6.6e-6, 5.34e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.18,
                most: 4.57,
            },
            unit_normal: ::hodograph::Bound {
                errors: [5.62e-15, 4.88e-15, 3.12e-6, 2.72e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.962,
                most: 1.0,
            },
            first_form: ::hodograph::Bound {
                errors: [4.91e-14, 4.47e-14, 2.58e-5, 2.35e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 29.2,
                most: 30.0,
            },
            second_form: ::hodograph::Bound {
                errors: [4.23e-14, 3.91e-14, 2.29e-5, 2.12e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 5.75,
                most: 7.42,
            },
            gaussian: ::hodograph::Bound {
                errors: [2.02e-14, 1.86e-14, 1.09e-5, 9.99e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.091,
                most: 0.507,
            },
            mean: ::hodograph::Bound {
                errors: [1.25e-14, 1.1e-14, 6.65e-6, 5.84e-6],
                relative_errors: [1.31e-13, 1.21e-13, 7.01e-5, 6.46e-5],
                size: 0.417,
                most: 0.727,
            },
            principal: ::hodograph::Bound {
                errors: [2.93e-14, 2.54e-14, 1.58e-5, 1.37e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.76,
                most: 1.46,
            },
            speeds: ::hodograph::Bound {
                errors: [7.72e-15, 7.16e-15, 4.07e-6, 3.76e-6],
                relative_errors: [3.11e-15, 2.9e-15, 1.64e-6, 1.52e-6],
                size: 5.39,
                most: 5.48,
            },
            normal_u: ::hodograph::Bound {
                errors: [5.69e-14, 5.25e-14, 3.03e-5, 2.79e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 1.79,
                most: 3.51,
            },
            normal_v: ::hodograph::Bound {
                errors: [4.01e-14, 3.54e-14, 2.17e-5, 1.92e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.589,
                most: 1.48,
            },
        };
        /// `q15 = 296450*v^6 - 2668050*v^5 + 14150063*v^4 - 44879628*v^3 + 73571219*v^2 - 54774006*v + 34835202`
        const Q15: [f64; 4] = [21491631.28125, -4896272.125, 4144875.5, 296450.0];
        /// `q18 = 3557400*v^5 - 26680500*v^4 + 113200504*v^3 - 269277768*v^2 + 294284876*v - 109548012`
        ///
        /// Without its factor that is a power of the parameter.
        const Q18: [f64; 3] = [-19585088.5, 33159004.0, 3557400.0];
        /// The polynomial `q19` of v.
        const Q19: [f64; 6] = [
            -420915500652649.6,
            2425605031529106.0,
            -835394656735132.5,
            799511617384914.0,
            221174701555500.0,
            11600503530000.0,
        ];
        /// `q58 = -1/120*v^3 + 3/100*v^2 - 7/300*v + 13/300`
        const Q58: [f64; 4] = [
            0.04770833333333333,
            0.010416666666666666,
            -0.0075,
            -0.008333333333333333,
        ];
        /// What points need of u alone.
        #[inline(always)]
        fn values_of_u<R: ::hodograph::Real>(u: R) -> OfU<R> {
            let p4 = u * u;
            let p1 = u.mul_add(u, R::of(1.0));
            let z_numerator = u.mul_add(u, R::of(-1.0));
            let p1_inverse = R::of(1.0) / p1;
            let z_numerator_over_p1 = z_numerator * p1_inverse;
            let t206 = p1_inverse * p1_inverse;
            let p2 = R::of(12.0).mul_add(p4, R::of(-4.0));
            let p3 = R::of(2.0).mul_add(p4, R::of(-6.0)) * u;
            let t214 = t206 * p1_inverse;
            let t643 = u * p4;
            OfU {
                u,
                p4,
                p1,
                z_numerator,
                z_numerator_over_p1,
                t153: u * p1_inverse,
                t207: R::of(-4.0) * u * t206,
                t208: z_numerator * t206,
                t214,
                t215: p2 * t214,
                t216: p3 * t214,
                t643,
                t644: u * t643,
            }
        }
        /// What points need of v alone.
        #[inline(always)]
        fn values_of_v<R: ::hodograph::Real>(v: R) -> OfV<R> {
            let t6 = v - R::of(1.5);
            let t7 = t6 * t6;
            let q1 = R::of(-0.9).mul_add(t7, R::of(1.725));
            let q2 = (R::of(0.3333333333333333) * t6)
                .mul_add(t6, R::of(-1.0833333333333333))
                .mul_add(t6, R::of(1.0));
            let t26 = t7 * t7;
            let t33 = t26 * t26;
            let q3 = R::of(87882602500.0)
                .mul_add(
                    t26,
                    R::of(2457496683950.0).mul_add(t7, R::of(14276993167587.75)),
                )
                .mul_add(
                    t33,
                    R::of(-27846488557837.75)
                        .mul_add(t7, R::of(202133752627425.5))
                        .mul_add(
                            t26,
                            R::of(-210457750326324.8)
                                .mul_add(t7, R::of(461890215129203.5)),
                        ),
                );
            let q4 = R::of(1688875650000.0)
                .mul_add(t6, R::of(1519988085000.0))
                .mul_add(
                    t33,
                    R::of(-5955711300000.0)
                        .mul_add(t6, R::of(-13128968160000.0))
                        .mul_add(
                            t7,
                            R::of(-2771959893750.0).mul_add(t6, R::of(15190473088125.0)),
                        )
                        .mul_add(
                            t26,
                            R::of(26767996087500.0)
                                .mul_add(t6, R::of(58948758230625.0))
                                .mul_add(
                                    t7,
                                    R::of(-21619790709960.938)
                                        .mul_add(t6, R::of(-99018641451621.1)),
                                ),
                        ),
                ) * t7;
            let t55 = q4 * q1;
            let q5 = R::of(342399750000.0)
                .mul_add(t6, R::of(308159775000.0))
                .mul_add(
                    t7,
                    R::of(-8978393077500.0).mul_add(t6, R::of(-9655592619750.0)),
                )
                .mul_add(
                    t33,
                    R::of(36791676123750.0)
                        .mul_add(t6, R::of(72444318105375.0))
                        .mul_add(
                            t7,
                            R::of(-77155242649687.5)
                                .mul_add(t6, R::of(-189516666561468.75)),
                        )
                        .mul_add(
                            t26,
                            R::of(110218925373867.19)
                                .mul_add(t6, R::of(304014963804105.5))
                                .mul_add(
                                    t7,
                                    R::of(-68202348644091.8)
                                        .mul_add(t6, R::of(-312366756789940.44)),
                                ),
                        ),
                ) * t6;
            let t80 = q5 * q1;
            let q6 = R::of(-1.266).mul_add(t7, R::of(-2.6835));
            let t84 = q6 * q5;
            let t86 = R::of(2.0) * t80;
            let q7 = R::of(21970650625.0)
                .mul_add(t6, R::of(19773585562.5))
                .mul_add(
                    t7,
                    R::of(-1574209642293.75).mul_add(t6, R::of(-1517853670939.375)),
                )
                .mul_add(
                    t26,
                    R::of(23287486703162.563)
                        .mul_add(t6, R::of(28073771146303.805))
                        .mul_add(
                            t7,
                            R::of(-88453235816830.61)
                                .mul_add(t6, R::of(-177836559677873.47)),
                        ),
                )
                .mul_add(
                    t33,
                    R::of(202660466096805.66)
                        .mul_add(t6, R::of(466493494941138.5))
                        .mul_add(
                            t7,
                            R::of(-247796278912417.28)
                                .mul_add(t6, R::of(-800130950748964.9)),
                        )
                        .mul_add(
                            t26,
                            R::of(229187229960937.53)
                                .mul_add(t6, R::of(624738515302226.8))
                                .mul_add(
                                    t7,
                                    R::of(-144340692227876.1)
                                        .mul_add(t6, R::of(-661080370403672.5)),
                                ),
                        ),
                );
            let q8 = R::of(-43941301250.0)
                .mul_add(t6, R::of(-39547171125.0))
                .mul_add(t7, R::of(5286535857487.5).mul_add(t6, R::of(4960012257488.75)))
                .mul_add(
                    t26,
                    R::of(-49582806105350.125)
                        .mul_add(t6, R::of(-68689927957070.11))
                        .mul_add(
                            t7,
                            R::of(157415019134623.72)
                                .mul_add(t6, R::of(339672672227953.2)),
                        ),
                )
                .mul_add(
                    t33,
                    R::of(-378871203521714.44)
                        .mul_add(t6, R::of(-817594227430322.4))
                        .mul_add(
                            t7,
                            R::of(540053820286830.3)
                                .mul_add(t6, R::of(1633093294132059.8)),
                        )
                        .mul_add(
                            t26,
                            R::of(-516391168292055.25)
                                .mul_add(t6, R::of(-1515193554939878.5))
                                .mul_add(
                                    t7,
                                    R::of(288681384455752.2)
                                        .mul_add(t6, R::of(1322160740807345.0)),
                                ),
                        ),
                );
            let q3_inverse = R::of(1.0) / q3;
            let t152 = t55 * q3_inverse;
            let t154 = t84 * q3_inverse;
            let t158 = t80 * q3_inverse;
            let q8_over_q3 = q8 * q3_inverse;
            let q7_over_q3 = q7 * q3_inverse;
            let t163 = t86 * q3_inverse;
            let q9 = t6.mul_add(t6, R::of(-1.0833333333333333));
            let t254 = t33 * t33;
            let q10 = (R::of(-4.5060046779825e17) * t6)
                .mul_add(
                    t254,
                    R::of(-3.39534713190519e19)
                        .mul_add(t6, R::of(-3.1240901259471864e19))
                        .mul_add(
                            t7,
                            R::of(1.7677585617292755e20)
                                .mul_add(t6, R::of(2.1633917477947087e20)),
                        )
                        .mul_add(
                            t26,
                            R::of(-6.976803334455582e20)
                                .mul_add(t6, R::of(-7.292009496225882e20))
                                .mul_add(
                                    t7,
                                    R::of(2.129822777483541e21)
                                        .mul_add(t6, R::of(3.5843545578517037e21)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-1.7971259220451147e21)
                                .mul_add(t6, R::of(-8.638552927296561e21))
                                .mul_add(
                                    t7,
                                    R::of(-3.892126387134757e21)
                                        .mul_add(t6, R::of(7.855037991434916e20)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(6.87015646852112e21)
                                        .mul_add(t6, R::of(1.4730067374115178e22))
                                        .mul_add(
                                            t7,
                                            R::of(-2.4045356513867213e21)
                                                .mul_add(t6, R::of(-7.341848855567455e21)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q11 = R::of(-2.5700915570715e17)
                .mul_add(t6, R::of(-1.156541200682175e17))
                .mul_add(
                    t7,
                    R::of(-1.0780276128516626e19)
                        .mul_add(t6, R::of(-1.1463857677578381e19)),
                )
                .mul_add(
                    t254,
                    R::of(2.077750561020257e20)
                        .mul_add(t6, R::of(2.1743205258122933e20))
                        .mul_add(
                            t7,
                            R::of(-7.248144711073585e20)
                                .mul_add(t6, R::of(-8.398456648772581e20)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.234957700969781e21)
                                .mul_add(t6, R::of(3.859958595186202e21))
                                .mul_add(
                                    t7,
                                    R::of(-4.874688316886113e21)
                                        .mul_add(t6, R::of(-1.3813169414535861e22)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(2.0877063535834825e21)
                                .mul_add(t6, R::of(1.2221480845514224e22))
                                .mul_add(
                                    t7,
                                    R::of(4.153667105066276e21)
                                        .mul_add(t6, R::of(-1.3087962569970375e22)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.6211583052631058e22)
                                        .mul_add(t6, R::of(-1.4790474440452522e22))
                                        .mul_add(
                                            t7,
                                            R::of(7.866839808624097e21)
                                                .mul_add(t6, R::of(1.8015063161749182e22)),
                                        ),
                                ),
                        ),
                );
            let q12 = R::of(-1.827079305975e17)
                .mul_add(t6, R::of(-8.2218568768875e16))
                .mul_add(
                    t7,
                    R::of(-7.663703408898075e18)
                        .mul_add(t6, R::of(-8.481523535726299e18)),
                )
                .mul_add(
                    t254,
                    R::of(1.876674887242252e20)
                        .mul_add(t6, R::of(1.9968726072187565e20))
                        .mul_add(
                            t7,
                            R::of(-9.928552007474703e20)
                                .mul_add(t6, R::of(-1.1708814884320524e21)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.077230895742566e21)
                                .mul_add(t6, R::of(4.20525075622119e21))
                                .mul_add(
                                    t7,
                                    R::of(-1.1718802603451187e22)
                                        .mul_add(t6, R::of(-1.485583671546411e22)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(2.13043963345462e22)
                                .mul_add(t6, R::of(3.246298930762312e22))
                                .mul_add(
                                    t7,
                                    R::of(-2.7027879772421947e22)
                                        .mul_add(t6, R::of(-4.495383550910629e22)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(2.046933656457365e22)
                                        .mul_add(t6, R::of(4.40233167968312e22))
                                        .mul_add(
                                            t7,
                                            R::of(-5.056940067030582e21)
                                                .mul_add(t6, R::of(-1.1580392753500034e22)),
                                        ),
                                ),
                        ),
                );
            let q13 = R::of(-3.90791962666875e16)
                .mul_add(
                    t26,
                    R::of(-2.34475177600125e16)
                        .mul_add(t6, R::of(2.9227499402745875e17))
                        .mul_add(
                            t7,
                            R::of(-9.835086041419196e17)
                                .mul_add(t6, R::of(1.2662562190070083e20)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(1.2489712854482554e20)
                        .mul_add(t6, R::of(-1.0036651390880371e21))
                        .mul_add(
                            t7,
                            R::of(-1.1783898768284507e21)
                                .mul_add(t6, R::of(4.3904555097085e21)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.751387384538222e21)
                                .mul_add(t6, R::of(-1.5125821821026405e22))
                                .mul_add(
                                    t7,
                                    R::of(-1.8510496882434576e22)
                                        .mul_add(t6, R::of(3.0675509394052695e22)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(4.382320403074665e22)
                                .mul_add(t6, R::of(-4.988166198176536e22))
                                .mul_add(
                                    t7,
                                    R::of(-7.245032479924447e22)
                                        .mul_add(t6, R::of(4.7128957421113366e22)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(8.171222247433544e22)
                                        .mul_add(t6, R::of(-2.905387791032898e22))
                                        .mul_add(
                                            t7,
                                            R::of(-3.923332728505116e22)
                                                .mul_add(t6, R::of(6.204233872483802e21)),
                                        ),
                                ),
                        ),
                );
            let q14 = R::of(1.953959813334375e16)
                .mul_add(
                    t26,
                    R::of(1.172375888000625e16)
                        .mul_add(t6, R::of(1.7078483200437312e17))
                        .mul_add(
                            t7,
                            R::of(4.917543020709598e17)
                                .mul_add(t6, R::of(-4.07114074506445e19)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-4.277836544369995e19)
                        .mul_add(t6, R::of(4.446896904990881e20))
                        .mul_add(
                            t7,
                            R::of(5.0900729439090554e20)
                                .mul_add(t6, R::of(-1.9049945614372695e21)),
                        )
                        .mul_add(
                            t26,
                            R::of(-2.0459467353121127e21)
                                .mul_add(t6, R::of(7.34501446652707e21))
                                .mul_add(
                                    t7,
                                    R::of(7.546931787946696e21)
                                        .mul_add(t6, R::of(-1.7616110153778451e22)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-2.3730404973340277e22)
                                .mul_add(t6, R::of(2.7422731210020004e22))
                                .mul_add(
                                    t7,
                                    R::of(4.696918424403825e22)
                                        .mul_add(t6, R::of(-2.1317648858715034e22)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-4.074593127853781e22)
                                        .mul_add(t6, R::of(1.2656628398498905e22))
                                        .mul_add(
                                            t7,
                                            R::of(1.3905982076173326e22)
                                                .mul_add(t6, R::of(-3.102116936241901e21)),
                                        ),
                                ),
                        ),
                );
            let q15 = ::hodograph::horner(Self::Q15.map(R::of), t7);
            let t425 = q15 * q3;
            let t426 = R::of(1.0) / t425;
            let t427 = q10 * t426;
            let t428 = q11 * t426;
            let t429 = q12 * t426;
            let t430 = q13 * t426;
            let t431 = q14 * t426;
            let t432 = R::of(2.0) * q12 * t426;
            let q17 = R::of(-237118141260000.0)
                .mul_add(t6, R::of(-180574584498000.0))
                .mul_add(
                    t7,
                    R::of(910079573287500.0).mul_add(t6, R::of(1299424571156250.0)),
                )
                .mul_add(
                    t33,
                    R::of(-560076342345000.0)
                        .mul_add(t6, R::of(-2033858167897500.0))
                        .mul_add(
                            t7,
                            R::of(-1212658746409687.5)
                                .mul_add(t6, R::of(-805509489916406.3)),
                        )
                        .mul_add(
                            t26,
                            R::of(1312652097798047.0)
                                .mul_add(t6, R::of(2289640623051445.5))
                                .mul_add(
                                    t7,
                                    R::of(-223764833848095.7)
                                        .mul_add(t6, R::of(-341614313008092.75)),
                                ),
                        ),
                );
            let q18 = ::hodograph::horner(Self::Q18.map(R::of), t7) * t6;
            let q19 = ::hodograph::horner(Self::Q19.map(R::of), t7);
            let t476 = R::of(2.0) * (q18 * q15);
            let q21 = R::of(-78893011197000.0)
                .mul_add(
                    t26,
                    R::of(-60860322923400.0)
                        .mul_add(t6, R::of(1379111699722680.0))
                        .mul_add(
                            t7,
                            R::of(1253673685043010.0)
                                .mul_add(t6, R::of(-2023626973427662.5)),
                        ),
                )
                .mul_add(
                    t33,
                    R::of(-4737868122694005.0)
                        .mul_add(t6, R::of(-58907838280410.0))
                        .mul_add(
                            t7,
                            R::of(1911998433703916.3)
                                .mul_add(t6, R::of(2025268023813616.5)),
                        )
                        .mul_add(
                            t26,
                            R::of(2473700610834077.5)
                                .mul_add(t6, R::of(-2513139754288228.5))
                                .mul_add(
                                    t7,
                                    R::of(-2522207047633514.5)
                                        .mul_add(t6, R::of(366042005172840.7)),
                                ),
                        ),
                );
            let q23 = R::of(-56085079050000.0)
                .mul_add(
                    t26,
                    R::of(-43265632410000.0)
                        .mul_add(t6, R::of(1144597520682000.0))
                        .mul_add(
                            t7,
                            R::of(1014376986661500.0)
                                .mul_add(t6, R::of(-4374021291305625.0)),
                        ),
                )
                .mul_add(
                    t33,
                    R::of(-5893616416601250.0)
                        .mul_add(t6, R::of(7442700143098500.0))
                        .mul_add(
                            t7,
                            R::of(1.2412320842757938e16)
                                .mul_add(t6, R::of(-6968694792215742.0)),
                        )
                        .mul_add(
                            t26,
                            R::of(-1.201059434484457e16)
                                .mul_add(t6, R::of(3018117120595242.0))
                                .mul_add(
                                    t7,
                                    R::of(4833335362038170.0)
                                        .mul_add(t6, R::of(-235298102822116.7)),
                                ),
                        ),
                );
            let q25 = R::of(-9227673262500.0)
                .mul_add(t6, R::of(-7197585144750.0))
                .mul_add(
                    t26,
                    R::of(824699593768050.0)
                        .mul_add(t6, R::of(654721617988515.0))
                        .mul_add(
                            t7,
                            R::of(-5454108671588514.0)
                                .mul_add(t6, R::of(-6182093516136310.0)),
                        ),
                )
                .mul_add(
                    t33,
                    R::of(1.1333881377692908e16)
                        .mul_add(t6, R::of(1.9021669644765376e16))
                        .mul_add(
                            t7,
                            R::of(-1.5912590547912008e16)
                                .mul_add(t6, R::of(-2.452782682290967e16)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.0801076405736606e16)
                                .mul_add(t6, R::of(1.9597119529584716e16))
                                .mul_add(
                                    t7,
                                    R::of(-3098347009752331.5)
                                        .mul_add(t6, R::of(-3030387109879757.0)),
                                ),
                        ),
                );
            let q27 = R::of(4613836631250.0)
                .mul_add(t6, R::of(3598792572375.0))
                .mul_add(
                    t26,
                    R::of(-245576704197825.0)
                        .mul_add(t6, R::of(-200356684563997.5))
                        .mul_add(
                            t7,
                            R::of(2561623537347882.0)
                                .mul_add(t6, R::of(2526639403167342.5)),
                        ),
                )
                .mul_add(
                    t33,
                    R::of(-6368632978811804.0)
                        .mul_add(t6, R::of(-9958847341960914.0))
                        .mul_add(
                            t7,
                            R::of(8511739576065838.0)
                                .mul_add(t6, R::of(1.3994804848234156e16)),
                        )
                        .mul_add(
                            t26,
                            R::of(-4955925578248346.0)
                                .mul_add(t6, R::of(-9601571408987578.0))
                                .mul_add(
                                    t7,
                                    R::of(1375123379765625.3)
                                        .mul_add(t6, R::of(1249477030604453.5)),
                                ),
                        ),
                );
            let q28 = R::of(-3.412665533411748e25)
                .mul_add(
                    t33,
                    R::of(-1.4426694937309452e25)
                        .mul_add(t6, R::of(-4.9942914615032504e26))
                        .mul_add(
                            t7,
                            R::of(-4.011578577790825e26)
                                .mul_add(t6, R::of(1.185864833462694e28)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.07556744334403e27)
                                .mul_add(t6, R::of(-4.762229844648761e28))
                                .mul_add(
                                    t7,
                                    R::of(-8.842892403045214e28)
                                        .mul_add(t6, R::of(1.0212456524687917e29)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(8.493710295948224e29)
                        .mul_add(t6, R::of(2.037619096321178e29))
                        .mul_add(
                            t7,
                            R::of(-3.9386018344645334e30)
                                .mul_add(t6, R::of(-3.947125643946764e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.0841340651386275e31)
                                .mul_add(t6, R::of(1.29054486302653e31))
                                .mul_add(
                                    t7,
                                    R::of(-1.923682418099095e31)
                                        .mul_add(t6, R::of(-3.6760405840373066e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(2.2730588070561374e31)
                                .mul_add(t6, R::of(5.380375493365837e31))
                                .mul_add(
                                    t7,
                                    R::of(-1.9553872263787941e31)
                                        .mul_add(t6, R::of(-8.307782921098177e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.0894174811204134e31)
                                        .mul_add(t6, R::of(5.831708989324709e31))
                                        .mul_add(t7, R::of(-5.120221699970446e31)),
                                ),
                        ),
                );
            let q29 = R::of(9.988517512337272e25)
                .mul_add(
                    t33,
                    R::of(2.8853389874618903e25)
                        .mul_add(t6, R::of(1.247208319711653e27))
                        .mul_add(
                            t7,
                            R::of(-1.9258616093372595e26)
                                .mul_add(t6, R::of(-3.6474327556641734e28)),
                        )
                        .mul_add(
                            t26,
                            R::of(-3.1112496402455254e28)
                                .mul_add(t6, R::of(4.07981499417428e29))
                                .mul_add(
                                    t7,
                                    R::of(5.439360069118425e29)
                                        .mul_add(t6, R::of(-1.855985460443523e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-4.1017372246814953e30)
                        .mul_add(t6, R::of(5.566663456976165e30))
                        .mul_add(
                            t7,
                            R::of(1.812153839313342e31)
                                .mul_add(t6, R::of(-5.272448587024607e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(-5.01647715830188e31)
                                .mul_add(t6, R::of(-7.73648182447304e30))
                                .mul_add(
                                    t7,
                                    R::of(9.09448881092767e31)
                                        .mul_add(t6, R::of(5.985135585322711e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-1.0788119561447022e32)
                                .mul_add(t6, R::of(-1.1635071895935421e32))
                                .mul_add(
                                    t7,
                                    R::of(6.750207699554053e31)
                                        .mul_add(t6, R::of(1.791065556791925e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.702422625815375e30)
                                        .mul_add(t6, R::of(-1.2430467727961662e32))
                                        .mul_add(
                                            t7,
                                            R::of(-1.8934597023182765e31)
                                                .mul_add(t6, R::of(1.0240443399940891e32)),
                                        ),
                                ),
                        ),
                );
            let q30 = R::of(1.6029661041454945e25)
                .mul_add(t6, R::of(2.8853389874618903e25))
                .mul_add(
                    t7,
                    R::of(-1.352706434348901e27)
                        .mul_add(t6, R::of(-1.1874880374256169e27)),
                )
                .mul_add(
                    t26,
                    R::of(-4.849948196401881e28)
                        .mul_add(t6, R::of(-4.274013736620698e28))
                        .mul_add(
                            t7,
                            R::of(6.512569364025975e29)
                                .mul_add(t6, R::of(7.873181390133786e29)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-4.2139251146793274e30)
                        .mul_add(t6, R::of(-6.219465131223273e30))
                        .mul_add(
                            t7,
                            R::of(1.5623333375346923e31)
                                .mul_add(t6, R::of(2.910288820075701e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(-3.536577988522987e31)
                                .mul_add(t6, R::of(-8.18965578217549e31))
                                .mul_add(
                                    t7,
                                    R::of(5.153281622126517e31)
                                        .mul_add(t6, R::of(1.4428466681517763e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-4.446878759128492e31)
                                .mul_add(t6, R::of(-1.6248701608707108e32))
                                .mul_add(
                                    t7,
                                    R::of(9.080515819013406e30)
                                        .mul_add(t6, R::of(8.833516849937475e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.8052675277708688e31)
                                        .mul_add(t6, R::of(2.519319487403902e31))
                                        .mul_add(
                                            t7,
                                            R::of(-1.033547872444474e31)
                                                .mul_add(t6, R::of(-3.786919404636553e31)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q31 = R::of(3.5766530957552935e25)
                .mul_add(
                    t33,
                    R::of(-2.8853389874618903e25)
                        .mul_add(t6, R::of(1.3474600516057428e27))
                        .mul_add(
                            t7,
                            R::of(1.9258616093372595e26)
                                .mul_add(t6, R::of(3.2767304185213663e28)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.1112496402455254e28)
                                .mul_add(t6, R::of(-4.467350707022398e29))
                                .mul_add(
                                    t7,
                                    R::of(-5.439360069118425e29)
                                        .mul_add(t6, R::of(3.3329724314536975e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(4.1017372246814953e30)
                        .mul_add(t6, R::of(-1.3089598672867161e31))
                        .mul_add(
                            t7,
                            R::of(-1.812153839313342e31)
                                .mul_add(t6, R::of(3.7867871919106613e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(5.01647715830188e31)
                                .mul_add(t6, R::of(-7.476244880058322e31))
                                .mul_add(
                                    t7,
                                    R::of(-9.09448881092767e31)
                                        .mul_add(t6, R::of(1.2585241203533983e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(1.0788119561447022e32)
                                .mul_add(t6, R::of(-1.4618527049786678e32))
                                .mul_add(
                                    t7,
                                    R::of(-6.750207699554053e31)
                                        .mul_add(t6, R::of(1.730482664338993e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.702422625815375e30)
                                        .mul_add(t6, R::of(-1.1603629430006082e32))
                                        .mul_add(
                                            t7,
                                            R::of(1.8934597023182765e31)
                                                .mul_add(t6, R::of(1.0240443399940891e32)),
                                        ),
                                ),
                        ),
                );
            let q32 = R::of(-1.3962327790247358e25)
                .mul_add(
                    t33,
                    R::of(-1.4426694937309452e25)
                        .mul_add(t6, R::of(-7.53025556304486e26))
                        .mul_add(
                            t7,
                            R::of(-4.011578577790825e26)
                                .mul_add(t6, R::of(-3.709521392363099e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.07556744334403e27)
                                .mul_add(t6, R::of(-8.276164448639656e28))
                                .mul_add(
                                    t7,
                                    R::of(-8.842892403045214e28)
                                        .mul_add(t6, R::of(8.489871423628362e29)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(8.493710295948224e29)
                        .mul_add(t6, R::of(-3.8115563677268117e30))
                        .mul_add(
                            t7,
                            R::of(-3.9386018344645334e30)
                                .mul_add(t6, R::of(1.2699286997807765e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.0841340651386275e31)
                                .mul_add(t6, R::of(-2.765835517458191e31))
                                .mul_add(
                                    t7,
                                    R::of(-1.923682418099095e31)
                                        .mul_add(t6, R::of(5.552531087874097e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(2.2730588070561374e31)
                                .mul_add(t6, R::of(-7.290686467845657e31))
                                .mul_add(
                                    t7,
                                    R::of(-1.9553872263787941e31)
                                        .mul_add(t6, R::of(9.507221524339722e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.0894174811204134e31)
                                        .mul_add(t6, R::of(-6.038418563813604e31))
                                        .mul_add(t7, R::of(5.120221699970446e31)),
                                ),
                        ),
                );
            let q33 = R::of(-7.999988241985384e24)
                .mul_add(
                    t33,
                    R::of(-2.0571398336533848e24)
                        .mul_add(t6, R::of(-8.509271695649044e24))
                        .mul_add(
                            t7,
                            R::of(-1.0514268614696623e25)
                                .mul_add(t6, R::of(4.5941862243520556e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.7491806111762683e27)
                                .mul_add(t6, R::of(-1.77469983372874e28))
                                .mul_add(
                                    t7,
                                    R::of(-2.3863729902827857e28)
                                        .mul_add(t6, R::of(8.690446704586836e28)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(3.353934916834862e29)
                        .mul_add(t6, R::of(4.231143533706836e28))
                        .mul_add(
                            t7,
                            R::of(-1.9375279684724312e30)
                                .mul_add(t6, R::of(-1.6103890679991094e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(6.565441058685069e30)
                                .mul_add(t6, R::of(8.065079056541229e30))
                                .mul_add(
                                    t7,
                                    R::of(-1.4327688628277166e31)
                                        .mul_add(t6, R::of(-2.3116386598761403e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(2.123379191196315e31)
                                .mul_add(t6, R::of(4.413870848318802e31))
                                .mul_add(
                                    t7,
                                    R::of(-2.094947026811073e31)
                                        .mul_add(t6, R::of(-6.061123251806349e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.0587818563936948e31)
                                        .mul_add(t6, R::of(5.158379340014736e31))
                                        .mul_add(
                                            t7,
                                            R::of(-3.6519383631371416e30)
                                                .mul_add(t6, R::of(-3.0406074496942592e31)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q34 = R::of(-1.1331059852561562e25)
                .mul_add(
                    t33,
                    R::of(8.744726442330221e25)
                        .mul_add(
                            t7,
                            R::of(1.4231840875818518e26)
                                .mul_add(t6, R::of(8.652432543254242e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(2.854510907388942e27)
                                .mul_add(t6, R::of(-3.6919705359805536e28))
                                .mul_add(
                                    t7,
                                    R::of(-8.292843434909597e28)
                                        .mul_add(t6, R::of(2.7718048639015655e29)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(6.822973539888122e29)
                        .mul_add(t6, R::of(-2.385473699324403e29))
                        .mul_add(
                            t7,
                            R::of(-2.5285074611769135e30)
                                .mul_add(t6, R::of(-1.294514313554395e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.193136891556585e30)
                                .mul_add(t6, R::of(8.656432742412293e30))
                                .mul_add(
                                    t7,
                                    R::of(6.46748071256381e30)
                                        .mul_add(t6, R::of(-1.2869132959664274e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-2.6667636548435333e31)
                                .mul_add(t6, R::of(1.562263523800883e31))
                                .mul_add(
                                    t7,
                                    R::of(3.078315479025245e31)
                                        .mul_add(t6, R::of(4.4028528184026026e30)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-7.691979737762929e30)
                                        .mul_add(t6, R::of(2.7972527707339794e30))
                                        .mul_add(
                                            t7,
                                            R::of(-6.002169030202786e30)
                                                .mul_add(t6, R::of(2.3476161902677816e31)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q35 = R::of(-2.2857109262815386e24)
                .mul_add(t6, R::of(-2.0571398336533848e24))
                .mul_add(
                    t33,
                    R::of(2.796661792374092e26)
                        .mul_add(t6, R::of(1.1154413417979195e26))
                        .mul_add(
                            t7,
                            R::of(6.111494126177445e27)
                                .mul_add(t6, R::of(2.477742321968956e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(-1.4139268028326471e29)
                                .mul_add(t6, R::of(-1.260240796195629e29))
                                .mul_add(
                                    t7,
                                    R::of(8.694507384327327e29)
                                        .mul_add(t6, R::of(1.497553758726004e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-3.628699859991705e30)
                        .mul_add(t6, R::of(-8.999687102339693e30))
                        .mul_add(
                            t7,
                            R::of(7.189586981985115e30)
                                .mul_add(t6, R::of(3.3171181830213597e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(-2.54104497114251e30)
                                .mul_add(t6, R::of(-7.315298985005398e31))
                                .mul_add(
                                    t7,
                                    R::of(-2.796564436577691e31)
                                        .mul_add(t6, R::of(1.0651207037889126e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(8.725853397394743e31)
                                .mul_add(t6, R::of(-8.331680093296849e31))
                                .mul_add(
                                    t7,
                                    R::of(-1.3781404483451828e32)
                                        .mul_add(t6, R::of(4.32156062843791e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.4375398966365642e32)
                                        .mul_add(t6, R::of(1.2392164107988158e31))
                                        .mul_add(
                                            t7,
                                            R::of(-8.853982915844497e31)
                                                .mul_add(t6, R::of(-2.3230385698844593e31)),
                                        ),
                                ),
                        ),
                );
            let q36 = (R::of(-2.2857109262815386e24) * t6)
                .mul_add(
                    t33,
                    R::of(-4.7913963393666375e26)
                        .mul_add(t6, R::of(-4.443113672421577e26))
                        .mul_add(
                            t7,
                            R::of(-6.38724424346828e27)
                                .mul_add(t6, R::of(-4.664416466029903e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(2.3873207966775334e29)
                                .mul_add(t6, R::of(2.554239767745961e29))
                                .mul_add(
                                    t7,
                                    R::of(-1.8476983378606838e30)
                                        .mul_add(t6, R::of(-2.566058680514366e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(8.808425835027705e30)
                        .mul_add(t6, R::of(1.460263888757361e31))
                        .mul_add(
                            t7,
                            R::of(-2.3879913218810558e31)
                                .mul_add(t6, R::of(-5.103685274678942e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.5877924960398565e31)
                                .mul_add(t6, R::of(1.097456442921918e32))
                                .mul_add(
                                    t7,
                                    R::of(-5.596754927313619e31)
                                        .mul_add(t6, R::of(-1.745479689660755e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(3.5079751049928595e31)
                                .mul_add(t6, R::of(1.481411007212252e32))
                                .mul_add(
                                    t7,
                                    R::of(8.799140176269914e29)
                                        .mul_add(t6, R::of(-6.79449221446666e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-3.020130326877043e31)
                                        .mul_add(t6, R::of(-4.142549224227911e31))
                                        .mul_add(
                                            t7,
                                            R::of(1.5216409846404757e31)
                                                .mul_add(t6, R::of(4.646077139768919e31)),
                                        ),
                                ),
                        ),
                );
            let q37 = R::of(-1.1331059852561562e25)
                .mul_add(
                    t33,
                    R::of(-2.2881586615044264e26)
                        .mul_add(
                            t7,
                            R::of(-1.4231840875818518e26)
                                .mul_add(t6, R::of(6.926189705685642e26)),
                        )
                        .mul_add(
                            t26,
                            R::of(-2.854510907388942e27)
                                .mul_add(t6, R::of(1.0466164271023755e29))
                                .mul_add(
                                    t7,
                                    R::of(8.292843434909597e28)
                                        .mul_add(t6, R::of(-5.6877793155358515e29)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-6.822973539888122e29)
                        .mul_add(t6, R::of(1.8943930351763773e30))
                        .mul_add(
                            t7,
                            R::of(2.5285074611769135e30)
                                .mul_add(t6, R::of(-1.8461349988960313e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(-3.193136891556585e30)
                                .mul_add(t6, R::of(-3.548423907177358e29))
                                .mul_add(
                                    t7,
                                    R::of(-6.46748071256381e30)
                                        .mul_add(t6, R::of(7.035783419347701e30)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(2.6667636548435333e31)
                                .mul_add(t6, R::of(-2.4375885282414896e29))
                                .mul_add(
                                    t7,
                                    R::of(-3.078315479025245e31)
                                        .mul_add(t6, R::of(6.077008686333917e30)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(7.691979737762929e30)
                                        .mul_add(t6, R::of(5.418287281739563e30))
                                        .mul_add(
                                            t7,
                                            R::of(6.002169030202786e30)
                                                .mul_add(t6, R::of(2.3476161902677816e31)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q38 = R::of(2.2857109262815386e24)
                .mul_add(t6, R::of(2.0571398336533848e24))
                .mul_add(
                    t33,
                    R::of(5.515537052874946e25)
                        .mul_add(t6, R::of(-1.1154413417979195e26))
                        .mul_add(
                            t7,
                            R::of(-5.128933053175655e26)
                                .mul_add(t6, R::of(-2.477742321968956e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.0340498304866781e29)
                                .mul_add(t6, R::of(1.260240796195629e29))
                                .mul_add(
                                    t7,
                                    R::of(-1.2513282548179353e30)
                                        .mul_add(t6, R::of(-1.497553758726004e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(7.039965545713097e30)
                        .mul_add(t6, R::of(8.999687102339693e30))
                        .mul_add(
                            t7,
                            R::of(-2.365871520536648e31)
                                .mul_add(t6, R::of(-3.3171181830213597e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(5.593384864336201e31)
                                .mul_add(t6, R::of(7.315298985005398e31))
                                .mul_add(
                                    t7,
                                    R::of(-9.589658818786478e31)
                                        .mul_add(t6, R::of(-1.0651207037889126e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(1.3615756112029418e32)
                                .mul_add(t6, R::of(8.331680093296849e31))
                                .mul_add(
                                    t7,
                                    R::of(-1.5423213871045648e32)
                                        .mul_add(t6, R::of(-4.32156062843791e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.3182187861390678e32)
                                        .mul_add(t6, R::of(-1.2392164107988158e31))
                                        .mul_add(
                                            t7,
                                            R::of(-7.839555592750847e31)
                                                .mul_add(t6, R::of(2.3230385698844593e31)),
                                        ),
                                ),
                        ),
                );
            let q39 = R::of(1.1428554631407693e24)
                .mul_add(
                    t33,
                    R::of(-2.0571398336533848e24)
                        .mul_add(t6, R::of(-2.3681151695487776e25))
                        .mul_add(
                            t7,
                            R::of(-1.0514268614696623e25)
                                .mul_add(t6, R::of(3.4352328911258236e26)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.7491806111762683e27)
                                .mul_add(t6, R::of(-1.9653753586391353e28))
                                .mul_add(
                                    t7,
                                    R::of(-2.3863729902827857e28)
                                        .mul_add(t6, R::of(3.264244159220077e29)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(3.353934916834862e29)
                        .mul_add(t6, R::of(-1.8776312282278506e30))
                        .mul_add(
                            t7,
                            R::of(-1.9375279684724312e30)
                                .mul_add(t6, R::of(6.985375488048898e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(6.565441058685069e30)
                                .mul_add(t6, R::of(-1.8994253758887233e31))
                                .mul_add(
                                    t7,
                                    R::of(-1.4327688628277166e31)
                                        .mul_add(t6, R::of(3.914459749976055e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(2.123379191196315e31)
                                .mul_add(t6, R::of(-6.365201881995281e31))
                                .mul_add(
                                    t7,
                                    R::of(-2.094947026811073e31)
                                        .mul_add(t6, R::of(7.718596254183399e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.0587818563936948e31)
                                        .mul_add(t6, R::of(-6.781427660169468e31))
                                        .mul_add(
                                            t7,
                                            R::of(-3.6519383631371416e30)
                                                .mul_add(t6, R::of(3.5478211112410847e31)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q40 = R::of(8.109519413281657e23)
                .mul_add(
                    t7,
                    R::of(2.0853049919867116e23)
                        .mul_add(t6, R::of(-2.863516115641472e25)),
                )
                .mul_add(
                    t33,
                    R::of(1.5156695886739023e24)
                        .mul_add(t6, R::of(-1.0418885925233883e27))
                        .mul_add(
                            t7,
                            R::of(-5.133310157685385e25)
                                .mul_add(t6, R::of(3.078378351524489e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.2816213079470916e27)
                                .mul_add(t6, R::of(1.4799200418436802e28))
                                .mul_add(
                                    t7,
                                    R::of(-5.135275850072651e28)
                                        .mul_add(t6, R::of(-3.3190695058549565e28)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(3.087716943026679e29)
                        .mul_add(t6, R::of(7.964233808339631e29))
                        .mul_add(
                            t7,
                            R::of(-4.548479853167656e29)
                                .mul_add(t6, R::of(-2.2547080816287203e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(-6.709088187724641e29)
                                .mul_add(t6, R::of(7.267754699855943e30))
                                .mul_add(
                                    t7,
                                    R::of(4.965743366155965e30)
                                        .mul_add(t6, R::of(-1.1591348888681007e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-7.910027976439656e30)
                                .mul_add(t6, R::of(2.223605021935227e31))
                                .mul_add(
                                    t7,
                                    R::of(9.156302243715093e30)
                                        .mul_add(t6, R::of(-2.744661292095672e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-6.406897797107299e30)
                                        .mul_add(t6, R::of(2.810037131813215e31))
                                        .mul_add(
                                            t7,
                                            R::of(5.760249412466751e30)
                                                .mul_add(t6, R::of(-1.7867440307188534e31)),
                                        ),
                                ),
                        ),
                );
            let q41 = R::of(6.951016639955705e23)
                .mul_add(
                    t7,
                    R::of(4.170609983973423e23).mul_add(t6, R::of(4.985938599887477e25)),
                )
                .mul_add(
                    t33,
                    R::of(4.361844093431173e25)
                        .mul_add(t6, R::of(-2.4372582000595872e26))
                        .mul_add(
                            t7,
                            R::of(-3.735707362004822e26)
                                .mul_add(t6, R::of(-3.4708440766062365e28)),
                        )
                        .mul_add(
                            t26,
                            R::of(-3.148976943197054e28)
                                .mul_add(t6, R::of(3.0969116779890524e29))
                                .mul_add(
                                    t7,
                                    R::of(4.3411081917923696e29)
                                        .mul_add(t6, R::of(-1.3178997767708693e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-2.2556195001584548e30)
                        .mul_add(t6, R::of(2.3311756677119646e30))
                        .mul_add(
                            t7,
                            R::of(6.529879209661924e30)
                                .mul_add(t6, R::of(1.0801714702203126e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(-1.3702162239191372e30)
                                .mul_add(t6, R::of(-5.195950224020521e30))
                                .mul_add(
                                    t7,
                                    R::of(-2.0270751853100598e31)
                                        .mul_add(t6, R::of(8.372036518748336e30)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(4.5860630073408185e31)
                                .mul_add(t6, R::of(1.184475144209274e31))
                                .mul_add(
                                    t7,
                                    R::of(-5.2690756891255435e31)
                                        .mul_add(t6, R::of(-3.541036350415281e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.5462173052983036e31)
                                        .mul_add(t6, R::of(3.4530664515983983e31))
                                        .mul_add(
                                            t7,
                                            R::of(4.0976145846215215e31)
                                                .mul_add(t6, R::of(-8.000346406203821e30)),
                                        ),
                                ),
                        ),
                );
            let q42 = R::of(-1.158502773325951e23)
                .mul_add(
                    t7,
                    R::of(2.0853049919867116e23)
                        .mul_add(t6, R::of(3.3397767425329574e25)),
                )
                .mul_add(
                    t33,
                    R::of(1.5156695886739023e24)
                        .mul_add(t6, R::of(8.686731572829396e26))
                        .mul_add(
                            t7,
                            R::of(-5.133310157685385e25)
                                .mul_add(t6, R::of(6.788795698345145e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.2816213079470916e27)
                                .mul_add(t6, R::of(-7.364937308543177e28))
                                .mul_add(
                                    t7,
                                    R::of(-5.135275850072651e28)
                                        .mul_add(t6, R::of(3.0893995697920764e29)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(3.087716943026679e29)
                        .mul_add(t6, R::of(-5.8456776283444286e29))
                        .mul_add(
                            t7,
                            R::of(-4.548479853167656e29)
                                .mul_add(t6, R::of(2.1794652644879242e29)),
                        )
                        .mul_add(
                            t26,
                            R::of(-6.709088187724641e29)
                                .mul_add(t6, R::of(1.2277381672661933e30))
                                .mul_add(
                                    t7,
                                    R::of(4.965743366155965e30)
                                        .mul_add(t6, R::of(-3.4254729939722594e30)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-7.910027976439656e30)
                                .mul_add(t6, R::of(5.389817404430264e30))
                                .mul_add(
                                    t7,
                                    R::of(9.156302243715093e30)
                                        .mul_add(t6, R::of(-3.25145516587888e30)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-6.406897797107299e30)
                                        .mul_add(t6, R::of(-1.0707805939570284e27))
                                        .mul_add(
                                            t7,
                                            R::of(5.760249412466751e30)
                                                .mul_add(t6, R::of(9.867093900984713e30)),
                                        ),
                                ),
                        ),
                );
            let q43 = R::of(-8.190397280188195e26)
                .mul_add(
                    t7,
                    R::of(-3.3181398355811735e26)
                        .mul_add(t6, R::of(-1.0987441215307152e28)),
                )
                .mul_add(
                    t26,
                    R::of(-8.424315013360731e27)
                        .mul_add(t6, R::of(2.3717296669253878e29))
                        .mul_add(
                            t7,
                            R::of(7.743578142353656e28)
                                .mul_add(t6, R::of(-8.572013720367769e29)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-1.5032917085176864e30)
                        .mul_add(t6, R::of(1.6339930439500667e30))
                        .mul_add(
                            t7,
                            R::of(1.2740565443922335e31)
                                .mul_add(t6, R::of(2.852666734849649e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(-5.120182384803894e31)
                                .mul_add(t6, R::of(-4.736550772736117e31))
                                .mul_add(
                                    t7,
                                    R::of(1.1925474716524902e32)
                                        .mul_add(t6, R::of(1.29054486302653e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-1.7313141762891853e32)
                                .mul_add(t6, R::of(-2.9408324672298453e32))
                                .mul_add(
                                    t7,
                                    R::of(1.5911411649392961e32)
                                        .mul_add(t6, R::of(3.2282252960195023e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-9.77693613189397e31)
                                        .mul_add(t6, R::of(-3.323113168439271e32))
                                        .mul_add(
                                            t7,
                                            R::of(3.26825244336124e31)
                                                .mul_add(t6, R::of(1.1663417978649418e32)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q44 = R::of(2.3972442029609453e27)
                .mul_add(t6, R::of(6.636279671162347e26))
                .mul_add(
                    t7,
                    R::of(2.7438583033656365e28)
                        .mul_add(t6, R::of(-4.044309379608245e27)),
                )
                .mul_add(
                    t26,
                    R::of(-7.294865511328347e29)
                        .mul_add(t6, R::of(-5.9113743164664984e29))
                        .mul_add(
                            t7,
                            R::of(7.343666989513704e30)
                                .mul_add(t6, R::of(9.246912117501323e30)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-2.9695767367096367e31)
                        .mul_add(t6, R::of(-6.1526058370222425e31))
                        .mul_add(
                            t7,
                            R::of(7.793328839766631e31)
                                .mul_add(t6, R::of(2.3557999911073448e32)),
                        )
                        .mul_add(
                            t26,
                            R::of(-6.326938304429529e31)
                                .mul_add(t6, R::of(-5.5181248741320675e32))
                                .mul_add(
                                    t7,
                                    R::of(-7.736481824473039e31)
                                        .mul_add(t6, R::of(8.185039929834903e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(4.788108468258169e32)
                                .mul_add(t6, R::of(-7.551683693012915e32))
                                .mul_add(
                                    t7,
                                    R::of(-6.981043137561253e32)
                                        .mul_add(t6, R::of(3.375103849777026e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(7.1642622271677e32)
                                        .mul_add(t6, R::of(5.107267877446126e30))
                                        .mul_add(
                                            t7,
                                            R::of(-2.4860935455923324e32)
                                                .mul_add(t6, R::of(-1.8934597023182765e31)),
                                        ),
                                ),
                        ),
                );
            let q45 = R::of(3.847118649949187e26)
                .mul_add(t6, R::of(6.636279671162347e26))
                .mul_add(
                    t7,
                    R::of(-2.975954155567582e28)
                        .mul_add(t6, R::of(-2.4937248785937954e28)),
                )
                .mul_add(
                    t26,
                    R::of(-9.699896392803761e29)
                        .mul_add(t6, R::of(-8.120626099579325e29))
                        .mul_add(
                            t7,
                            R::of(1.1722624855246755e31)
                                .mul_add(t6, R::of(1.3384408363227436e31)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-6.742280183486924e31)
                        .mul_add(t6, R::of(-9.32919769683491e31))
                        .mul_add(
                            t7,
                            R::of(2.1872666725485692e32)
                                .mul_add(t6, R::of(3.783375466098412e32)),
                        )
                        .mul_add(
                            t26,
                            R::of(-4.243893586227584e32)
                                .mul_add(t6, R::of(-9.008621360393039e32))
                                .mul_add(
                                    t7,
                                    R::of(5.153281622126517e32)
                                        .mul_add(t6, R::of(1.298562001336599e33)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-3.557503007302793e32)
                                .mul_add(t6, R::of(-1.1374091126094976e33))
                                .mul_add(
                                    t7,
                                    R::of(5.448309491408044e31)
                                        .mul_add(t6, R::of(4.416758424968737e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(7.221070111083475e31)
                                        .mul_add(t6, R::of(7.557958462211706e31))
                                        .mul_add(
                                            t7,
                                            R::of(-2.067095744888948e31)
                                                .mul_add(t6, R::of(-3.786919404636553e31)),
                                        ),
                                ),
                        ),
                );
            let q46 = R::of(8.583967429812705e26)
                .mul_add(t6, R::of(-6.636279671162347e26))
                .mul_add(
                    t7,
                    R::of(2.9644121135326344e28).mul_add(t6, R::of(4.044309379608245e27)),
                )
                .mul_add(
                    t26,
                    R::of(6.553460837042732e29)
                        .mul_add(t6, R::of(5.9113743164664984e29))
                        .mul_add(
                            t7,
                            R::of(-8.041231272640316e30)
                                .mul_add(t6, R::of(-9.246912117501323e30)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(5.332755890325916e31)
                        .mul_add(t6, R::of(6.1526058370222425e31))
                        .mul_add(
                            t7,
                            R::of(-1.8325438142014025e32)
                                .mul_add(t6, R::of(-2.3557999911073448e32)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.5441446302927934e32)
                                .mul_add(t6, R::of(5.5181248741320675e32))
                                .mul_add(
                                    t7,
                                    R::of(-7.476244880058322e32)
                                        .mul_add(t6, R::of(-8.185039929834903e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(1.0068192962827186e33)
                                .mul_add(t6, R::of(7.551683693012915e32))
                                .mul_add(
                                    t7,
                                    R::of(-8.771116229872007e32)
                                        .mul_add(t6, R::of(-3.375103849777026e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(6.921930657355972e32)
                                        .mul_add(t6, R::of(-5.107267877446126e30))
                                        .mul_add(
                                            t7,
                                            R::of(-2.3207258860012165e32)
                                                .mul_add(t6, R::of(1.8934597023182765e31)),
                                        ),
                                ),
                        ),
                );
            let q47 = R::of(-3.350958669659366e26)
                .mul_add(
                    t7,
                    R::of(-3.3181398355811735e26)
                        .mul_add(t6, R::of(-1.656656223869869e28)),
                )
                .mul_add(
                    t26,
                    R::of(-8.424315013360731e27)
                        .mul_add(t6, R::of(-7.4190427847261975e28))
                        .mul_add(
                            t7,
                            R::of(7.743578142353656e28)
                                .mul_add(t6, R::of(-1.489709600755138e30)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-1.5032917085176864e30)
                        .mul_add(t6, R::of(1.358379427780538e31))
                        .mul_add(
                            t7,
                            R::of(1.2740565443922335e31)
                                .mul_add(t6, R::of(-5.336178914817537e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(-5.120182384803894e31)
                                .mul_add(t6, R::of(1.5239144397369317e32))
                                .mul_add(
                                    t7,
                                    R::of(1.1925474716524902e32)
                                        .mul_add(t6, R::of(-2.765835517458191e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-1.7313141762891853e32)
                                .mul_add(t6, R::of(4.442024870299278e32))
                                .mul_add(
                                    t7,
                                    R::of(1.5911411649392961e32)
                                        .mul_add(t6, R::of(-4.374411880707394e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-9.77693613189397e31)
                                        .mul_add(t6, R::of(3.802888609735889e32))
                                        .mul_add(
                                            t7,
                                            R::of(3.26825244336124e31)
                                                .mul_add(t6, R::of(-1.2076837127627208e32)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q48 = R::of(-1.9999970604963462e26)
                .mul_add(
                    t33,
                    R::of(-4.937135600768123e25)
                        .mul_add(t6, R::of(-1.95713248999928e26))
                        .mul_add(
                            t7,
                            R::of(-2.313139095233257e26)
                                .mul_add(t6, R::of(9.647791071139317e28)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.4983612223525364e28)
                                .mul_add(t6, R::of(-3.371929684084606e29))
                                .mul_add(
                                    t7,
                                    R::of(-4.295471382509014e29)
                                        .mul_add(t6, R::of(1.477375939779762e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(5.366295866935779e30)
                        .mul_add(t6, R::of(6.346715300560255e29))
                        .mul_add(
                            t7,
                            R::of(-2.7125391558614037e31)
                                .mul_add(t6, R::of(-2.093505788398842e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(7.878529270422083e31)
                                .mul_add(t6, R::of(8.871586962195352e31))
                                .mul_add(
                                    t7,
                                    R::of(-1.4327688628277167e32)
                                        .mul_add(t6, R::of(-2.0804747938885263e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(1.698703352957052e32)
                                .mul_add(t6, R::of(3.0897095938231613e32))
                                .mul_add(
                                    t7,
                                    R::of(-1.2569682160866438e32)
                                        .mul_add(t6, R::of(-3.0305616259031744e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(4.235127425574779e31)
                                        .mul_add(t6, R::of(1.5475138020044209e32))
                                        .mul_add(
                                            t7,
                                            R::of(-7.303876726274283e30)
                                                .mul_add(t6, R::of(-3.0406074496942592e31)),
                                        ),
                                ),
                        ),
                );
            let q49 = R::of(-2.83276496314039e26)
                .mul_add(
                    t33,
                    R::of(2.0112870817359508e27)
                        .mul_add(
                            t7,
                            R::of(3.1310049926800737e27)
                                .mul_add(t6, R::of(1.8170108340833908e29)),
                        )
                        .mul_add(
                            t26,
                            R::of(5.7090218147778845e28)
                                .mul_add(t6, R::of(-7.014744018363051e29))
                                .mul_add(
                                    t7,
                                    R::of(-1.4927118182837274e30)
                                        .mul_add(t6, R::of(4.7120682686326615e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(1.0916757663820995e31)
                        .mul_add(t6, R::of(-3.5782105489866046e30))
                        .mul_add(
                            t7,
                            R::of(-3.5399104456476786e31)
                                .mul_add(t6, R::of(-1.6828686076207135e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.8317642698679022e31)
                                .mul_add(t6, R::of(9.522076016653522e31))
                                .mul_add(
                                    t7,
                                    R::of(6.467480712563811e31)
                                        .mul_add(t6, R::of(-1.1582219663697846e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-2.1334109238748266e32)
                                .mul_add(t6, R::of(1.093584466660618e32))
                                .mul_add(
                                    t7,
                                    R::of(1.846989287415147e32)
                                        .mul_add(t6, R::of(2.201426409201301e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-3.0767918951051716e31)
                                        .mul_add(t6, R::of(8.391758312201938e30))
                                        .mul_add(
                                            t7,
                                            R::of(-1.2004338060405573e31)
                                                .mul_add(t6, R::of(2.3476161902677816e31)),
                                        ),
                                ),
                        ),
                );
            let q50 = R::of(-5.714277315703847e25)
                .mul_add(
                    t33,
                    R::of(-4.937135600768123e25)
                        .mul_add(t6, R::of(6.432322122460412e27))
                        .mul_add(
                            t7,
                            R::of(2.453970951955423e27)
                                .mul_add(t6, R::of(1.2834137664972635e29)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.955484643937912e28)
                                .mul_add(t6, R::of(-2.6864609253820295e30))
                                .mul_add(
                                    t7,
                                    R::of(-2.2684334331521325e30)
                                        .mul_add(t6, R::of(1.4780662553356457e31)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(2.396086013961606e31)
                        .mul_add(t6, R::of(-5.443049789987556e31))
                        .mul_add(
                            t7,
                            R::of(-1.259956194327557e32)
                                .mul_add(t6, R::of(9.346463076580649e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.9805418196256314e32)
                                .mul_add(t6, R::of(-2.795149468256761e31))
                                .mul_add(
                                    t7,
                                    R::of(-7.315298985005398e32)
                                        .mul_add(t6, R::of(-2.516907992919922e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(8.520965630311301e32)
                                .mul_add(t6, R::of(6.1080973781763205e32))
                                .mul_add(
                                    t7,
                                    R::of(-4.99900805597811e32)
                                        .mul_add(t6, R::of(-6.890702241725914e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.728624251375164e32)
                                        .mul_add(t6, R::of(4.312619689909692e32))
                                        .mul_add(
                                            t7,
                                            R::of(2.4784328215976316e31)
                                                .mul_add(t6, R::of(-8.853982915844497e31)),
                                        ),
                                ),
                        ),
                );
            let q51 = R::of(-5.714277315703847e25)
                .mul_add(
                    t33,
                    R::of(-1.1020211580543266e28)
                        .mul_add(
                            t7,
                            R::of(-9.774850079327469e27)
                                .mul_add(t6, R::of(-1.3413212911283388e29)),
                        )
                        .mul_add(
                            t26,
                            R::of(-9.328832932059806e28)
                                .mul_add(t6, R::of(4.535909513687314e30))
                                .mul_add(
                                    t7,
                                    R::of(4.5976315819427297e30)
                                        .mul_add(t6, R::of(-3.1410871743631627e31)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-4.105693888822985e31)
                        .mul_add(t6, R::of(1.3212638752541556e32))
                        .mul_add(
                            t7,
                            R::of(2.0443694442603052e32)
                                .mul_add(t6, R::of(-3.1043887184453724e32)),
                        )
                        .mul_add(
                            t26,
                            R::of(-6.1244223296147306e32)
                                .mul_add(t6, R::of(5.046571745643842e32))
                                .mul_add(
                                    t7,
                                    R::of(1.097456442921918e33)
                                        .mul_add(t6, R::of(-5.037079434582257e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-1.396383751728604e33)
                                .mul_add(t6, R::of(2.4555825734950016e32))
                                .mul_add(
                                    t7,
                                    R::of(8.888466043273511e32)
                                        .mul_add(t6, R::of(4.399570088134957e30)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-2.717796885786664e32)
                                        .mul_add(t6, R::of(-9.060390980631129e31))
                                        .mul_add(
                                            t7,
                                            R::of(-8.285098448455822e31)
                                                .mul_add(t6, R::of(1.5216409846404757e31)),
                                        ),
                                ),
                        ),
                );
            let q52 = R::of(-2.83276496314039e26)
                .mul_add(
                    t33,
                    R::of(-5.26276492146018e27)
                        .mul_add(
                            t7,
                            R::of(-3.1310049926800737e27)
                                .mul_add(t6, R::of(1.454499838193985e28)),
                        )
                        .mul_add(
                            t26,
                            R::of(-5.7090218147778845e28)
                                .mul_add(t6, R::of(1.9885712114945135e30))
                                .mul_add(
                                    t7,
                                    R::of(1.4927118182837274e30)
                                        .mul_add(t6, R::of(-9.669224836410947e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-1.0916757663820995e31)
                        .mul_add(t6, R::of(2.841589552764566e31))
                        .mul_add(
                            t7,
                            R::of(3.5399104456476786e31)
                                .mul_add(t6, R::of(-2.3999754985648407e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(-3.8317642698679022e31)
                                .mul_add(t6, R::of(-3.9032662978950936e30))
                                .mul_add(
                                    t7,
                                    R::of(-6.467480712563811e31)
                                        .mul_add(t6, R::of(6.332205077412931e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(2.1334109238748266e32)
                                .mul_add(t6, R::of(-1.7063119697690428e30))
                                .mul_add(
                                    t7,
                                    R::of(-1.846989287415147e32)
                                        .mul_add(t6, R::of(3.0385043431669587e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(3.0767918951051716e31)
                                        .mul_add(t6, R::of(1.6254861845218688e31))
                                        .mul_add(
                                            t7,
                                            R::of(1.2004338060405573e31)
                                                .mul_add(t6, R::of(2.3476161902677816e31)),
                                        ),
                                ),
                        ),
                );
            let q53 = R::of(5.714277315703847e25)
                .mul_add(
                    t33,
                    R::of(4.937135600768123e25)
                        .mul_add(t6, R::of(1.2685735221612376e27))
                        .mul_add(
                            t7,
                            R::of(-2.453970951955423e27)
                                .mul_add(t6, R::of(-1.0770759411668876e28)),
                        )
                        .mul_add(
                            t26,
                            R::of(-4.955484643937912e28)
                                .mul_add(t6, R::of(1.9646946779246887e30))
                                .mul_add(
                                    t7,
                                    R::of(2.2684334331521325e30)
                                        .mul_add(t6, R::of(-2.12725803319049e31)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-2.396086013961606e31)
                        .mul_add(t6, R::of(1.0559948318569646e32))
                        .mul_add(
                            t7,
                            R::of(1.259956194327557e32)
                                .mul_add(t6, R::of(-3.0756329766976426e32)),
                        )
                        .mul_add(
                            t26,
                            R::of(-3.9805418196256314e32)
                                .mul_add(t6, R::of(6.1527233507698215e32))
                                .mul_add(
                                    t7,
                                    R::of(7.315298985005398e32)
                                        .mul_add(t6, R::of(-8.630692936907831e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-8.520965630311301e32)
                                .mul_add(t6, R::of(9.531029278420593e32))
                                .mul_add(
                                    t7,
                                    R::of(4.99900805597811e32)
                                        .mul_add(t6, R::of(-7.711606935522825e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.728624251375164e32)
                                        .mul_add(t6, R::of(3.954656358417203e32))
                                        .mul_add(
                                            t7,
                                            R::of(-2.4784328215976316e31)
                                                .mul_add(t6, R::of(-7.839555592750847e31)),
                                        ),
                                ),
                        ),
                );
            let q54 = R::of(2.8571386578519233e25)
                .mul_add(
                    t33,
                    R::of(-4.937135600768123e25)
                        .mul_add(t6, R::of(-5.446664889962188e26))
                        .mul_add(
                            t7,
                            R::of(-2.313139095233257e26)
                                .mul_add(t6, R::of(7.213989071364229e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.4983612223525364e28)
                                .mul_add(t6, R::of(-3.734213181414357e29))
                                .mul_add(
                                    t7,
                                    R::of(-4.295471382509014e29)
                                        .mul_add(t6, R::of(5.54921507067413e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(5.366295866935779e30)
                        .mul_add(t6, R::of(-2.816446842341776e31))
                        .mul_add(
                            t7,
                            R::of(-2.7125391558614037e31)
                                .mul_add(t6, R::of(9.080988134463566e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(7.878529270422083e31)
                                .mul_add(t6, R::of(-2.0893679134775955e32))
                                .mul_add(
                                    t7,
                                    R::of(-1.4327688628277167e32)
                                        .mul_add(t6, R::of(3.5230137749784495e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(1.698703352957052e32)
                                .mul_add(t6, R::of(-4.4556413173966966e32))
                                .mul_add(
                                    t7,
                                    R::of(-1.2569682160866438e32)
                                        .mul_add(t6, R::of(3.8592981270917e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(4.235127425574779e31)
                                        .mul_add(t6, R::of(-2.03442829805084e32))
                                        .mul_add(
                                            t7,
                                            R::of(-7.303876726274283e30)
                                                .mul_add(t6, R::of(3.5478211112410847e31)),
                                        ),
                                ),
                        ),
                );
            let q55 = R::of(2.1084750474532306e25)
                .mul_add(t6, R::of(5.213262479966779e24))
                .mul_add(
                    t33,
                    R::of(-6.872438677539533e26)
                        .mul_add(t6, R::of(3.4860400539499755e25))
                        .mul_add(
                            t7,
                            R::of(-2.2921549035514545e28)
                                .mul_add(t6, R::of(-1.0779951331139309e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(6.156756703048978e28)
                                .mul_add(t6, R::of(8.135080485099473e28))
                                .mul_add(
                                    t7,
                                    R::of(2.6638560753186242e29)
                                        .mul_add(t6, R::of(-8.729968945123506e29)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-5.3105112093679305e29)
                        .mul_add(t6, R::of(4.6315754145400184e30))
                        .mul_add(
                            t7,
                            R::of(1.1149927331675482e31)
                                .mul_add(t6, R::of(-5.913023809117952e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(-2.7056496979544642e31)
                                .mul_add(t6, R::of(-7.379997006497105e30))
                                .mul_add(
                                    t7,
                                    R::of(7.267754699855942e31)
                                        .mul_add(t6, R::of(4.469169029540368e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-9.273079110944806e31)
                                .mul_add(t6, R::of(-5.537019583507759e31))
                                .mul_add(
                                    t7,
                                    R::of(1.3341630131611362e32)
                                        .mul_add(t6, R::of(4.578151121857547e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.0978645168382687e32)
                                        .mul_add(t6, R::of(-1.9220693391321893e31))
                                        .mul_add(
                                            t7,
                                            R::of(5.62007426362643e31)
                                                .mul_add(t6, R::of(5.760249412466751e30)),
                                        ),
                                ),
                        ),
                );
            let q56 = R::of(1.8072643263884836e25)
                .mul_add(t6, R::of(1.0426524959933558e25))
                .mul_add(
                    t33,
                    R::of(1.1966252639729945e27)
                        .mul_add(t6, R::of(1.0032241414891697e27))
                        .mul_add(
                            t7,
                            R::of(-5.361968040131092e27)
                                .mul_add(t6, R::of(-7.844985460210126e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(-6.941688153212473e29)
                                .mul_add(t6, R::of(-5.9830561920744026e29))
                                .mul_add(
                                    t7,
                                    R::of(5.574441020380294e30)
                                        .mul_add(t6, R::of(7.379883926047029e30)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-2.108639642833391e31)
                        .mul_add(t6, R::of(-3.3834292502376825e31))
                        .mul_add(
                            t7,
                            R::of(3.2636459347967503e31)
                                .mul_add(t6, R::of(8.4888429725605e31)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.296205764264375e31)
                                .mul_add(t6, R::of(-1.5072378463110509e31))
                                .mul_add(
                                    t7,
                                    R::of(-5.195950224020521e31)
                                        .mul_add(t6, R::of(-1.8243676667790538e32)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(6.697629214998669e31)
                                .mul_add(t6, R::of(3.2102441051385727e32))
                                .mul_add(
                                    t7,
                                    R::of(7.106850865255644e31)
                                        .mul_add(t6, R::of(-2.634537844562772e32)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.4164145401661124e32)
                                        .mul_add(t6, R::of(-4.638651915894911e31))
                                        .mul_add(
                                            t7,
                                            R::of(6.906132903196797e31)
                                                .mul_add(t6, R::of(4.0976145846215215e31)),
                                        ),
                                ),
                        ),
                );
            let q57 = R::of(-3.0121072106474724e24)
                .mul_add(t6, R::of(5.213262479966779e24))
                .mul_add(
                    t33,
                    R::of(8.015464182079098e26)
                        .mul_add(t6, R::of(3.4860400539499755e25))
                        .mul_add(
                            t7,
                            R::of(1.911080946022467e28)
                                .mul_add(t6, R::of(-1.0779951331139309e27)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.357759139669029e29)
                                .mul_add(t6, R::of(8.135080485099473e28))
                                .mul_add(
                                    t7,
                                    R::of(-1.3256887155377718e30)
                                        .mul_add(t6, R::of(-8.729968945123506e29)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(4.943039311667322e30)
                        .mul_add(t6, R::of(4.6315754145400184e30))
                        .mul_add(
                            t7,
                            R::of(-8.1839486796822e30)
                                .mul_add(t6, R::of(-5.913023809117952e30)),
                        )
                        .mul_add(
                            t26,
                            R::of(2.615358317385509e30)
                                .mul_add(t6, R::of(-7.379997006497105e30))
                                .mul_add(
                                    t7,
                                    R::of(1.2277381672661933e31)
                                        .mul_add(t6, R::of(4.469169029540368e31)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-2.7403783951778076e31)
                                .mul_add(t6, R::of(-5.537019583507759e31))
                                .mul_add(
                                    t7,
                                    R::of(3.2338904426581584e31)
                                        .mul_add(t6, R::of(4.578151121857547e31)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.300582066351552e31)
                                        .mul_add(t6, R::of(-1.9220693391321893e31))
                                        .mul_add(
                                            t7,
                                            R::of(-2.1415611879140568e27)
                                                .mul_add(t6, R::of(5.760249412466751e30)),
                                        ),
                                ),
                        ),
                );
            let q58 = ::hodograph::horner(Self::Q58.map(R::of), t6);
            OfV {
                t3: R::of(4.0) * v,
                q1,
                q2,
                q3,
                t55,
                t80,
                t84,
                t86,
                q7,
                q8,
                t152,
                t154,
                t158,
                q8_over_q3,
                q7_over_q3,
                t163,
                t167: R::of(60.0) * q3,
                t171: R::of(240.0) * v * q3,
                t172: R::of(60.0) * t55,
                t174: R::of(60.0) * q1 * q3,
                t175: R::of(60.0) * t80,
                t176: R::of(60.0) * t84,
                t178: R::of(120.0) * t80,
                t180: R::of(60.0) * q2 * q3,
                t181: R::of(60.0) * q7,
                t182: R::of(60.0) * q8,
                t219: R::of(-1.8).mul_add(v, R::of(2.7)),
                q9,
                t427,
                t428,
                t429,
                t430,
                t431,
                t432,
                t434: R::of(2.0).mul_add(v, R::of(-3.0)),
                t481: (-t152).mul_add(q19, (-t427).mul_add(t476, q17)) * q3_inverse,
                t511: (-t154).mul_add(q19, (-t428).mul_add(t476, q21)) * q3_inverse,
                t541: (-t158).mul_add(q19, (-t429).mul_add(t476, q23)) * q3_inverse,
                t573: (-q8_over_q3).mul_add(q19, (-t430).mul_add(t476, q25))
                    * q3_inverse,
                t605: (-q7_over_q3).mul_add(q19, (-t431).mul_add(t476, q27))
                    * q3_inverse,
                t611: (-t163).mul_add(q19, (-t432).mul_add(t476, R::of(2.0) * q23))
                    * q3_inverse,
                q28,
                q29,
                q30,
                q31,
                q32,
                q33,
                q34,
                q35,
                q36,
                q37,
                q38,
                q39,
                q40,
                q41,
                q42,
                t1374: R::of(2.0) * q30,
                t1376: R::of(3.0) * q31,
                t1377: R::of(4.0) * q32,
                t1378: R::of(2.0) * q36,
                t1379: R::of(3.0) * q37,
                t1380: R::of(3.0) * q38,
                t1381: R::of(4.0) * q39,
                t1382: R::of(2.0) * q41,
                t1383: R::of(4.0) * q42,
                q43,
                q44,
                q45,
                q46,
                q47,
                q48,
                q49,
                q50,
                q51,
                q52,
                q53,
                q54,
                q55,
                q56,
                q57,
                t2110: q58 / (q15 * t425),
            }
        }
    }
    /// What points need of u alone.
    struct OfU<R> {
        u: R,
        p4: R,
        p1: R,
        z_numerator: R,
        z_numerator_over_p1: R,
        t153: R,
        t207: R,
        t208: R,
        t214: R,
        t215: R,
        t216: R,
        t643: R,
        t644: R,
    }
    /// What points need of v alone.
    struct OfV<R> {
        t3: R,
        q1: R,
        q2: R,
        q3: R,
        t55: R,
        t80: R,
        t84: R,
        t86: R,
        q7: R,
        q8: R,
        t152: R,
        t154: R,
        t158: R,
        q8_over_q3: R,
        q7_over_q3: R,
        t163: R,
        t167: R,
        t171: R,
        t172: R,
        t174: R,
        t175: R,
        t176: R,
        t178: R,
        t180: R,
        t181: R,
        t182: R,
        t219: R,
        q9: R,
        t427: R,
        t428: R,
        t429: R,
        t430: R,
        t431: R,
        t432: R,
        t434: R,
        t481: R,
        t511: R,
        t541: R,
        t573: R,
        t605: R,
        t611: R,
        q28: R,
        q29: R,
        q30: R,
        q31: R,
        q32: R,
        q33: R,
        q34: R,
        q35: R,
        q36: R,
        q37: R,
        q38: R,
        q39: R,
        q40: R,
        q41: R,
        q42: R,
        t1374: R,
        t1376: R,
        t1377: R,
        t1378: R,
        t1379: R,
        t1380: R,
        t1381: R,
        t1382: R,
        t1383: R,
        q43: R,
        q44: R,
        q45: R,
        q46: R,
        q47: R,
        q48: R,
        q49: R,
        q50: R,
        q51: R,
        q52: R,
        q53: R,
        q54: R,
        q55: R,
        q56: R,
        q57: R,
        t2110: R,
    }
    impl ::hodograph::Stages<::hodograph::Homogeneous> for FramesGutter2 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 3];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 10];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 3] {
            let values = Self::values_of_u(u);
            [values.u, values.p1, values.z_numerator]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 10] {
            let values = Self::values_of_v(v);
            [
                values.t167,
                values.t171,
                values.t172,
                values.t174,
                values.t175,
                values.t176,
                values.t178,
                values.t180,
                values.t181,
                values.t182,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 3], of_v: [R; 10]) -> [R; 4] {
            let [u, p1, z_numerator] = of_u;
            let [t167, t171, t172, t174, t175, t176, t178, t180, t181, t182] = of_v;
            let t185 = -z_numerator;
            [
                p1 * t167,
                t185.mul_add(t172, u.mul_add(t176, p1 * t171)),
                t185.mul_add(t175, u.mul_add(t182, p1 * t174)),
                t185.mul_add(t181, u.mul_add(t178, p1 * t180)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Point> for FramesGutter2 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 3];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 10];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 3] {
            let values = Self::values_of_u(u);
            [values.u, values.p1, values.z_numerator]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 10] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.q3,
                values.t55,
                values.t80,
                values.t84,
                values.t86,
                values.q7,
                values.q8,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 3], of_v: [R; 10]) -> [R; 3] {
            let [u, p1, z_numerator] = of_u;
            let [t3, q1, q2, q3, t55, t80, t84, t86, q7, q8] = of_v;
            let weight_inverse = R::of(1.0) / (p1 * q3);
            let t196 = u * weight_inverse;
            let t198 = -(z_numerator * weight_inverse);
            [
                t198.mul_add(t55, t196.mul_add(t84, t3)),
                t198.mul_add(t80, t196.mul_add(q8, q1)),
                t198.mul_add(q7, t196.mul_add(t86, q2)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Separated> for FramesGutter2 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 2];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 9];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 2] {
            let values = Self::values_of_u(u);
            [values.z_numerator_over_p1, values.t153]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 9] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t152,
                values.t154,
                values.t158,
                values.q8_over_q3,
                values.q7_over_q3,
                values.t163,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 2], of_v: [R; 9]) -> [R; 3] {
            let [z_numerator_over_p1, t153] = of_u;
            let [t3, q1, q2, t152, t154, t158, q8_over_q3, q7_over_q3, t163] = of_v;
            let t156 = -z_numerator_over_p1;
            [
                t156.mul_add(t152, t153.mul_add(t154, t3)),
                t156.mul_add(t158, t153.mul_add(q8_over_q3, q1)),
                t156.mul_add(q7_over_q3, t153.mul_add(t163, q2)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::First> for FramesGutter2 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 4];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 17];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 4] {
            let values = Self::values_of_u(u);
            [values.z_numerator_over_p1, values.t153, values.t207, values.t208]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 17] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t152,
                values.t154,
                values.t158,
                values.q8_over_q3,
                values.q7_over_q3,
                values.t163,
                values.t219,
                values.q9,
                values.t427,
                values.t428,
                values.t429,
                values.t430,
                values.t431,
                values.t432,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 4], of_v: [R; 17]) -> [R; 9] {
            let [z_numerator_over_p1, t153, t207, t208] = of_u;
            let [t3, q1, q2, t152, t154, t158, q8_over_q3, q7_over_q3, t163, t219, q9,
            t427, t428, t429, t430, t431, t432] = of_v;
            let t156 = -z_numerator_over_p1;
            let t613 = -t208;
            [
                t156.mul_add(t152, t153.mul_add(t154, t3)),
                t156.mul_add(t158, t153.mul_add(q8_over_q3, q1)),
                t156.mul_add(q7_over_q3, t153.mul_add(t163, q2)),
                t613.mul_add(t154, t207 * t152),
                t613.mul_add(q8_over_q3, t207 * t158),
                t613.mul_add(t163, t207 * q7_over_q3),
                t156.mul_add(t427, t153.mul_add(t428, R::of(4.0))),
                t156.mul_add(t429, t153.mul_add(t430, t219)),
                t156.mul_add(t431, t153.mul_add(t432, q9)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Second> for FramesGutter2 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 6];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 24];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 6] {
            let values = Self::values_of_u(u);
            [
                values.z_numerator_over_p1,
                values.t153,
                values.t207,
                values.t208,
                values.t215,
                values.t216,
            ]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 24] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t152,
                values.t154,
                values.t158,
                values.q8_over_q3,
                values.q7_over_q3,
                values.t163,
                values.t219,
                values.q9,
                values.t427,
                values.t428,
                values.t429,
                values.t430,
                values.t431,
                values.t432,
                values.t434,
                values.t481,
                values.t511,
                values.t541,
                values.t573,
                values.t605,
                values.t611,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 6], of_v: [R; 24]) -> [R; 18] {
            let [z_numerator_over_p1, t153, t207, t208, t215, t216] = of_u;
            let [t3, q1, q2, t152, t154, t158, q8_over_q3, q7_over_q3, t163, t219, q9,
            t427, t428, t429, t430, t431, t432, t434, t481, t511, t541, t573, t605, t611,
            ] = of_v;
            let t156 = -z_numerator_over_p1;
            let t613 = -t208;
            [
                t156.mul_add(t152, t153.mul_add(t154, t3)),
                t156.mul_add(t158, t153.mul_add(q8_over_q3, q1)),
                t156.mul_add(q7_over_q3, t153.mul_add(t163, q2)),
                t613.mul_add(t154, t207 * t152),
                t613.mul_add(q8_over_q3, t207 * t158),
                t613.mul_add(t163, t207 * q7_over_q3),
                t156.mul_add(t427, t153.mul_add(t428, R::of(4.0))),
                t156.mul_add(t429, t153.mul_add(t430, t219)),
                t156.mul_add(t431, t153.mul_add(t432, q9)),
                t216.mul_add(t154, t215 * t152),
                t216.mul_add(q8_over_q3, t215 * t158),
                t216.mul_add(t163, t215 * q7_over_q3),
                t613.mul_add(t428, t207 * t427),
                t613.mul_add(t430, t207 * t429),
                t613.mul_add(t432, t207 * t431),
                t156.mul_add(t481, t153 * t511),
                t156.mul_add(t541, t153.mul_add(t573, R::of(-1.8))),
                t156.mul_add(t605, t153.mul_add(t611, t434)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Normal> for FramesGutter2 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 4];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 15];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 4] {
            let values = Self::values_of_u(u);
            [values.u, values.p4, values.t643, values.t644]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 15] {
            let values = Self::values_of_v(v);
            [
                values.q28,
                values.q29,
                values.q30,
                values.q31,
                values.q32,
                values.q33,
                values.q34,
                values.q35,
                values.q36,
                values.q37,
                values.q38,
                values.q39,
                values.q40,
                values.q41,
                values.q42,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 4], of_v: [R; 15]) -> [R; 3] {
            let [u, p4, t643, t644] = of_u;
            let [q28, q29, q30, q31, q32, q33, q34, q35, q36, q37, q38, q39, q40, q41,
            q42] = of_v;
            let t1353 = t644
                .mul_add(q42, t643.mul_add(q37, p4.mul_add(q41, u.mul_add(q34, q40))));
            let t1357 = t644
                .mul_add(q39, t643.mul_add(q31, p4.mul_add(q36, u.mul_add(q29, q33))));
            let t1361 = t644
                .mul_add(q32, t643.mul_add(q38, p4.mul_add(q30, u.mul_add(q35, q28))));
            let t1362 = R::scale(t1353, t1357, t1361);
            let t1363 = t1353 * t1362;
            let t1364 = t1357 * t1362;
            let t1365 = t1361 * t1362;
            let t1370 = R::of(1.0)
                / t1365.mul_add(t1365, t1364.mul_add(t1364, t1363 * t1363)).sqrt();
            [t1363 * t1370, t1364 * t1370, t1365 * t1370]
        }
    }
    impl ::hodograph::Stages<::hodograph::Local> for FramesGutter2 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 11];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 64];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 11] {
            let values = Self::values_of_u(u);
            [
                values.u,
                values.p4,
                values.z_numerator_over_p1,
                values.t153,
                values.t207,
                values.t208,
                values.t214,
                values.t215,
                values.t216,
                values.t643,
                values.t644,
            ]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 64] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t152,
                values.t154,
                values.t158,
                values.q8_over_q3,
                values.q7_over_q3,
                values.t163,
                values.t219,
                values.q9,
                values.t427,
                values.t428,
                values.t429,
                values.t430,
                values.t431,
                values.t432,
                values.t434,
                values.t481,
                values.t511,
                values.t541,
                values.t573,
                values.t605,
                values.t611,
                values.q28,
                values.q29,
                values.q30,
                values.q31,
                values.q32,
                values.q33,
                values.q34,
                values.q35,
                values.q36,
                values.q37,
                values.q38,
                values.q39,
                values.q40,
                values.q41,
                values.q42,
                values.t1374,
                values.t1376,
                values.t1377,
                values.t1378,
                values.t1379,
                values.t1380,
                values.t1381,
                values.t1382,
                values.t1383,
                values.q43,
                values.q44,
                values.q45,
                values.q46,
                values.q47,
                values.q48,
                values.q49,
                values.q50,
                values.q51,
                values.q52,
                values.q53,
                values.q54,
                values.q55,
                values.q56,
                values.q57,
                values.t2110,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 11], of_v: [R; 64]) -> [R; 39] {
            let [u, p4, z_numerator_over_p1, t153, t207, t208, t214, t215, t216, t643,
            t644] = of_u;
            let [t3, q1, q2, t152, t154, t158, q8_over_q3, q7_over_q3, t163, t219, q9,
            t427, t428, t429, t430, t431, t432, t434, t481, t511, t541, t573, t605, t611,
            q28, q29, q30, q31, q32, q33, q34, q35, q36, q37, q38, q39, q40, q41, q42,
            t1374, t1376, t1377, t1378, t1379, t1380, t1381, t1382, t1383, q43, q44, q45,
            q46, q47, q48, q49, q50, q51, q52, q53, q54, q55, q56, q57, t2110] = of_v;
            let t156 = -z_numerator_over_p1;
            let t613 = -t208;
            let t614 = t613.mul_add(t154, t207 * t152);
            let t616 = t613.mul_add(q8_over_q3, t207 * t158);
            let t618 = t613.mul_add(t163, t207 * q7_over_q3);
            let t620 = t156.mul_add(t427, t153.mul_add(t428, R::of(4.0)));
            let t622 = t156.mul_add(t429, t153.mul_add(t430, t219));
            let t624 = t156.mul_add(t431, t153.mul_add(t432, q9));
            let t1353 = t644
                .mul_add(q42, t643.mul_add(q37, p4.mul_add(q41, u.mul_add(q34, q40))));
            let t1357 = t644
                .mul_add(q39, t643.mul_add(q31, p4.mul_add(q36, u.mul_add(q29, q33))));
            let t1361 = t644
                .mul_add(q32, t643.mul_add(q38, p4.mul_add(q30, u.mul_add(q35, q28))));
            let t1362 = R::scale(t1353, t1357, t1361);
            let t1363 = t1353 * t1362;
            let t1364 = t1357 * t1362;
            let t1365 = t1361 * t1362;
            let t1369 = t1365.mul_add(t1365, t1364.mul_add(t1364, t1363 * t1363)).sqrt();
            let t1370 = R::of(1.0) / t1369;
            let t1371 = t1363 * t1370;
            let t1372 = t1364 * t1370;
            let t1373 = t1365 * t1370;
            let t1386 = t643.mul_add(t1383, p4.mul_add(t1379, u.mul_add(t1382, q34)));
            let t1389 = t643.mul_add(t1381, p4.mul_add(t1376, u.mul_add(t1378, q29)));
            let t1392 = t643.mul_add(t1377, p4.mul_add(t1380, u.mul_add(t1374, q35)));
            let t2067 = t644
                .mul_add(q57, t643.mul_add(q52, p4.mul_add(q56, u.mul_add(q49, q55))));
            let t2071 = t644
                .mul_add(q54, t643.mul_add(q46, p4.mul_add(q51, u.mul_add(q44, q48))));
            let t2075 = t644
                .mul_add(q47, t643.mul_add(q53, p4.mul_add(q45, u.mul_add(q50, q43))));
            let t2076 = t1362 * t1370;
            let t2080 = t618.mul_add(t618, t616.mul_add(t616, t614 * t614));
            let t2083 = t618.mul_add(t624, t616.mul_add(t622, t614 * t620));
            let t2086 = t624.mul_add(t624, t622.mul_add(t622, t620 * t620));
            let t2091 = -(t1392.mul_add(t618, t1389.mul_add(t616, t1386 * t614))
                * t2076);
            let t2101 = -(t2075.mul_add(t618, t2071.mul_add(t616, t2067 * t614))
                * t2076);
            let area = t214 * t2110;
            let t2114 = (-t1373).mul_add(t616, t1372 * t618);
            let t2117 = (-t1371).mul_add(t618, t1373 * t614);
            let t2120 = (-t1372).mul_add(t614, t1371 * t616);
            let t2125 = t2075.mul_add(t2120, t2071.mul_add(t2117, t2067 * t2114))
                * t2076;
            let t2127 = R::of(1.0) / t2080;
            let t2133 = t2091 * t2127;
            let t2134 = -(t1392.mul_add(t2120, t1389.mul_add(t2117, t1386 * t2114))
                * t2076) * t2127;
            let t2137 = -t2083.mul_add(t2134, t2125) / (area * (t1369 / t1362));
            let t2138 = -t2125 * t2127;
            let t2139 = t2101 * t2127;
            let t2161 = t2091.mul_add(t2127, t2137);
            let t2168 = R::of(0.5) * t2091.mul_add(t2127, -t2137);
            let t2171 = t2134.mul_add(t2134, t2168 * t2168).sqrt();
            [
                t156.mul_add(t152, t153.mul_add(t154, t3)),
                t156.mul_add(t158, t153.mul_add(q8_over_q3, q1)),
                t156.mul_add(q7_over_q3, t153.mul_add(t163, q2)),
                t614,
                t616,
                t618,
                t620,
                t622,
                t624,
                t216.mul_add(t154, t215 * t152),
                t216.mul_add(q8_over_q3, t215 * t158),
                t216.mul_add(t163, t215 * q7_over_q3),
                t613.mul_add(t428, t207 * t427),
                t613.mul_add(t430, t207 * t429),
                t613.mul_add(t432, t207 * t431),
                t156.mul_add(t481, t153 * t511),
                t156.mul_add(t541, t153.mul_add(t573, R::of(-1.8))),
                t156.mul_add(t605, t153.mul_add(t611, t434)),
                t1371,
                t1372,
                t1373,
                t2080,
                t2083,
                t2086,
                t2091,
                t2101,
                -(t2075.mul_add(t624, t2071.mul_add(t622, t2067 * t620)) * t2076),
                (-t2134).mul_add(t2134, t2133 * t2137),
                R::of(0.5) * t2161,
                R::of(0.5).mul_add(t2161, t2171),
                R::of(0.5).mul_add(t2161, -t2171),
                t2080.sqrt(),
                t2086.sqrt(),
                -t2134.mul_add(t2114, t2133 * t614),
                -t2134.mul_add(t2117, t2133 * t616),
                -t2134.mul_add(t2120, t2133 * t618),
                -t2138.mul_add(t2114, t2139 * t614),
                -t2138.mul_add(t2117, t2139 * t616),
                -t2138.mul_add(t2120, t2139 * t618),
            ]
        }
    }
    impl ::hodograph::Sweep for FramesGutter2 {}
    impl ::hodograph::Patch for FramesGutter2 {
        fn name(&self) -> &str {
            Self::NAME
        }
        fn degree(&self) -> (u32, u32) {
            Self::DEGREE
        }
        fn domain(&self) -> ::hodograph::Domain {
            Self::DOMAIN
        }
        fn control_net(&self) -> &[[f64; 4]] {
            &Self::CONTROL_NET
        }
        fn bounds(&self) -> ::core::option::Option<&::hodograph::Bounds> {
            ::core::option::Option::Some(&Self::BOUNDS)
        }
    }
}
/// A gutter: half a circle that goes downhill through four frames, turns to both sides and is wider in the middle.
///
/// Position, orientation and size are C2 cubic splines through the frames; that of the orientation is in the 4-space that Euler's map M folds
/// onto the sphere of unit quaternions, with rational points for the rational frames.
///
/// ```text
/// profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));
/// frames F(v) = frames_file("gutter.json");
/// surface R = F.sweep(c);
/// domain u in -1..1;
/// ```
///
/// Source: `JW (1)`.
///
/// - Degree (2, 15): W (2, 12), X (2, 15), Y (2, 15), Z (2, 15).
/// - Domain: u from -1.0 to 1.0, v from 2.0 to 3.0.
/// - W ≠ 0 on the domain: certified.
/// - R_u × R_v ≠ 0 on the domain: certified.
///
/// | operations | at one place | on a grid for each v | for each u | for each point |
/// | --- | --- | --- | --- | --- |
/// | homogeneous coordinates | 189: 84 +, 105 × | 76 +, 94 × | 2 +, 1 × | 6 +, 10 × |
/// | point | 178: 84 +, 93 ×, 1 ÷ | 76 +, 83 × | 2 +, 1 × | 6 +, 9 ×, 1 ÷ |
/// | point, separated | 184: 84 +, 98 ×, 2 ÷ | 76 +, 89 ×, 1 ÷ | 2 +, 3 ×, 1 ÷ | 6 +, 6 × |
/// | point and first derivatives | 439: 203 +, 233 ×, 3 ÷ | 186 +, 208 ×, 2 ÷ | 2 +, 7 ×, 1 ÷ | 15 +, 18 × |
/// | point, first and second derivatives | 672: 310 +, 359 ×, 3 ÷ | 280 +, 310 ×, 2 ÷ | 4 +, 13 ×, 1 ÷ | 26 +, 36 × |
/// | unit normal | 819: 405 +, 412 ×, 1 ÷, 1 √ | 391 +, 388 × | 3 × | 14 +, 21 ×, 1 ÷, 1 √ |
/// | everything: derivatives, normal, fundamental forms, curvatures | 2383: 1142 +, 1229 ×, 8 ÷, 4 √ | 1045 +, 1076 ×, 3 ÷ | 4 +, 15 ×, 1 ÷ | 93 +, 138 ×, 4 ÷, 4 √ |
///
/// | error at most | `f64` plain | fused | `f32` plain | fused | size from | to | each, `f64` plain | relative |
/// | --- | --- | --- | --- | --- | --- | --- | --- | --- |
/// | homogeneous | 7.17e2 | 6.19e2 | 3.86e11 | 3.33e11 | 5.9e17 | 6.76e17 | 4.04e1, 7.17e2, 7.59e1, 3.45e1 | 9.98e-16, 1.54e-15, –, – |
/// | point | 3.29e-15 | 2.94e-15 | 1.81e-6 | 1.61e-6 | 1.24e1 | 1.26e1 | 3.11e-15, 3.29e-15, 3.03e-15 | 3.71e-16, –, – |
/// | separated point | 3.19e-15 | 2.86e-15 | 1.75e-6 | 1.57e-6 | 1.24e1 | 1.26e1 | 3.01e-15, 3.19e-15, 3.07e-15 | 3.67e-16, –, – |
/// | partial u | 6.35e-15 | 5.62e-15 | 3.45e-6 | 3.06e-6 | 2.57e0 | 2.85e0 | 3.24e-15, 6.35e-15, 5.08e-15 | –, –, – |
/// | partial v | 3.11e-15 | 2.71e-15 | 1.68e-6 | 1.46e-6 | 4.83e0 | 4.92e0 | 3.11e-15, 2.38e-15, 2.3e-15 | 8.85e-16, 6.26e-15, – |
/// | partial uu | 1.62e-14 | 1.53e-14 | 8.8e-6 | 8.33e-6 | 5.54e0 | 6.27e0 | 5.79e-15, 1.28e-14, 1.62e-14 | –, –, – |
/// | partial uv | 5.47e-15 | 4.66e-15 | 2.95e-6 | 2.51e-6 | 1.67e0 | 1.9e0 | 5.47e-15, 4.29e-15, 4.5e-15 | –, –, – |
/// | partial vv | 2.05e-14 | 1.85e-14 | 1.15e-5 | 1.03e-5 | 4.27e0 | 4.46e0 | 1.33e-14, 1.73e-14, 2.05e-14 | –, –, – |
/// | unit normal | 6.42e-15 | 5.34e-15 | 3.48e-6 | 2.89e-6 | 9.48e-1 | 1e0 | 2.22e-15, 6.42e-15, 3.69e-15 | –, –, – |
/// | first form | 5.2e-14 | 4.56e-14 | 2.85e-5 | 2.5e-5 | 2.71e1 | 2.8e1 | 5.2e-14, 3.49e-14, 4.72e-14 | 7.85e-15, –, 2.53e-15 |
/// | second form | 5.01e-14 | 4.55e-14 | 2.74e-5 | 2.5e-5 | 5.73e0 | 7.99e0 | 5.01e-14, 4.68e-14, 4.65e-14 | 1.73e-14, –, – |
/// | gaussian | 1.54e-13 | 1.38e-13 | 8.37e-5 | 7.5e-5 | 5.7e-2 | 2.49e0 | 1.54e-13 | – |
/// | mean | 3.4e-14 | 3.05e-14 | 1.86e-5 | 1.66e-5 | 3.94e-1 | 1.33e0 | 3.4e-14 | – |
/// | principal | 8.31e-14 | 7.45e-14 | 4.52e-5 | 4.06e-5 | 7.69e-1 | 2.92e0 | 8.3e-14, 8.31e-14 | –, – |
/// | speeds | 8.52e-15 | 7.69e-15 | 4.67e-6 | 4.24e-6 | 5.19e0 | 5.29e0 | 8.52e-15, 5.21e-15 | 3.44e-15, 1.34e-15 |
/// | normal u | 1.04e-13 | 9.49e-14 | 5.63e-5 | 5.2e-5 | 1.7e0 | 4.57e0 | 1.04e-13, 9.55e-14, 6.45e-14 | –, –, – |
/// | normal v | 1.56e-13 | 1.39e-13 | 8.46e-5 | 7.55e-5 | 5.23e-1 | 3.78e0 | 1.56e-13, 1.16e-13, 7.77e-14 | –, –, – |
#[allow(
    clippy::approx_constant,
    clippy::doc_markdown,
    clippy::excessive_precision,
    clippy::float_cmp,
    clippy::many_single_char_names,
    clippy::missing_const_for_fn,
    clippy::possible_missing_comma,
    clippy::similar_names,
    clippy::suboptimal_flops,
    clippy::trivially_copy_pass_by_ref,
    clippy::unreadable_literal,
    clippy::unused_self
)]
pub mod frames_gutter_3 {
    /// The surface `frames_gutter_3` as a value.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct FramesGutter3;
    impl FramesGutter3 {
        /// The name of the sweep.
        pub const NAME: &'static str = "frames_gutter_3";
        /// The formula that it was generated from.
        pub const FORMULA: &'static str = "profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));\nframes F(v) = frames_file(\"gutter.json\");\nsurface R = F.sweep(c);\ndomain u in -1..1;";
        /// Where the formula is from.
        pub const SOURCE: ::core::option::Option<&'static str> = ::core::option::Option::Some(
            "JW (1)",
        );
        /// The patch degree in u and v.
        pub const DEGREE: (u32, u32) = (2, 15);
        /// The parameters over which the surface is stated.
        pub const DOMAIN: ::hodograph::Domain = ::hodograph::Domain {
            u: [-1.0, 1.0],
            v: [2.0, 3.0],
        };
        /// Homogeneous Bézier control points (W, X, Y, Z) over the domain, rounded; the index of u is the outer one.
        pub const CONTROL_NET: [[f64; 4]; 48] = [
            [
                2.529193359375e16,
                1.90204453125e17,
                4100625000000000.0,
                2.4776982421875e16,
            ],
            [
                2.483724853125e16,
                1.9200164990625e17,
                3497671125000000.0,
                2.362784428125e16,
            ],
            [
                2.4424460969464284e16,
                1.9402704924444643e17,
                2800435929267857.0,
                2.2261895382535716e16,
            ],
            [
                2.4112500755180836e16,
                1.9676869979510086e17,
                1980355391029780.3,
                2.0743615935022452e16,
            ],
            [
                2.3962965705336588e16,
                2.0080587804456787e17,
                1013859477386363.8,
                1.914481959703659e16,
            ],
            [
                2.403716391073489e16,
                2.0679216920334442e17,
                -124700242726492.81,
                1.7529372679066748e16,
            ],
            [
                2.4395349414044016e16,
                2.1544983618781997e17,
                -1472044704617648.3,
                1.5941559869384466e16,
            ],
            [
                2.5098597384130136e16,
                2.2758626410006915e17,
                -3085076053736955.5,
                1.4400428427543258e16,
            ],
            [
                2.621302049849653e16,
                2.441384436797369e17,
                -5049160379905423.0,
                1.2900424185706362e16,
            ],
            [
                2.7815179977364076e16,
                2.662416956134821e17,
                -7486220221863518.0,
                1.1416355103424962e16,
            ],
            [
                2.9997003723981384e16,
                2.953075312217588e17,
                -1.0563841641078354e16,
                9909574859981622.0,
            ],
            [
                3.2868457939416444e16,
                3.330875653079556e17,
                -1.4504809565096934e16,
                8332439979331114.0,
            ],
            [
                3.65566123842339e16,
                3.816985185431766e17,
                -1.959403762107992e16,
                6629188768747828.0,
            ],
            [
                4.120045638501716e16,
                4.4358814678027245e17,
                -2.6178630706397056e16,
                4732868046310714.0,
            ],
            [
                4.69416650830875e16,
                5.21432059049478e17,
                -3.465747327701025e16,
                2559299078587500.0,
            ],
            [5.39122856484375e16, 6.1796418301665e17, -4.54588392587625e16, 0.0],
            [0.0, -2050312500000000.0, -1.2131015625e16, -3.5887587890625e16],
            [0.0, -2423287125000000.0, -1.26143274375e16, -3.480366740625e16],
            [0.0, -2749072712142857.0, -1.2685312788428572e16, -3.3757741456875e16],
            [0.0, -3000679993379670.5, -1.240380342862022e16, -3.287587047114076e16],
            [0.0, -3158537173699450.5, -1.1849555775896704e16, -3.2260766575811584e16],
            [0.0, -3211266492234935.0, -1.110523933668501e16, -3.1984973601392976e16],
            [0.0, -3156029970702545.5, -1.0241025177203324e16, -3.2092675826576748e16],
            [0.0, -2998296208446042.0, -9305089411360146.0, -3.2608717812987776e16],
            [0.0, -2750657159237538.5, -8321989018665634.0, -3.355072153620457e16],
            [0.0, -2430651024481900.0, -7297583778877515.0, -3.4939089916544336e16],
            [0.0, -2058107617929380.5, -6226969128480324.0, -3.680086518412873e16],
            [0.0, -1652655223987714.3, -5102008364032457.0, -3.916641873817252e16],
            [0.0, -1231812468963692.3, -3916521096474461.5, -4.206104220048569e16],
            [0.0, -809804356071428.6, -2668700774571428.5, -4.549524929109823e16],
            [0.0, -397030750200000.0, -1361248286400000.0, -4.945757174668125e16],
            [0.0, 0.0, 0.0, -5.39122856484375e16],
            [2.529193359375e16, 2.14466484375e17, 7.177517578125e16, 514951171875000.0],
            [
                2.483724853125e16,
                2.1888335784375e17,
                6.79790424375e16,
                -1600810593750000.0,
            ],
            [
                2.4424460969464284e16,
                2.2322274869555357e17,
                6.408622592823214e16,
                -3108730194321428.5,
            ],
            [
                2.4112500755180836e16,
                2.280168350555947e17,
                6.034500955010888e16,
                -4063990922217989.0,
            ],
            [
                2.3962965705336588e16,
                2.3390640099869904e17,
                5.696252949739677e16,
                -4554291954756816.0,
            ],
            [
                2.403716391073489e16,
                2.4162013422514618e17,
                5.408559846764029e16,
                -4681105994303273.0,
            ],
            [
                2.4395349414044016e16,
                2.5196353269437232e17,
                5.179513004568398e16,
                -4540490485022181.0,
            ],
            [
                2.5098597384130136e16,
                2.6582741842201843e17,
                5.011344841369917e16,
                -4209750395177032.5,
            ],
            [
                2.621302049849653e16,
                2.8422253899324323e17,
                4.90176993531207e16,
                -3743553851624905.5,
            ],
            [
                2.7815179977364076e16,
                3.083388388269758e17,
                4.844891446326069e16,
                -3178812454330068.5,
            ],
            [
                2.9997003723981384e16,
                3.396175033890767e17,
                4.830829386650436e16,
                -2544363396979026.0,
            ],
            [
                3.2868457939416444e16,
                3.7981448220508666e17,
                4.843982156979319e16,
                -1871576748733800.5,
            ],
            [
                3.65566123842339e16,
                4.3103010870342304e17,
                4.860647598590426e16,
                -1203853424201095.0,
            ],
            [
                4.120045638501716e16,
                4.956827919383965e17,
                4.847163724118134e16,
                -604533502832142.9,
            ],
            [
                4.69416650830875e16,
                5.76414683932122e17,
                4.759642183263525e16,
                -163197494212500.0,
            ],
            [5.39122856484375e16, 6.7593067254585e17, 4.54588392587625e16, 0.0],
        ];
        /// Proved bounds of the errors of the evaluators over the domain.
        pub const BOUNDS: ::hodograph::Bounds = ::hodograph::Bounds {
            homogeneous: ::hodograph::Bound {
                errors: [717.0, 619.0, 386000000000.0, 333000000000.0],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 5.9e17,
                most: 6.76e17,
            },
            point: ::hodograph::Bound {
                errors: [3.29e-15, 2.94e-15, 1.81e-6, 1.61e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 12.4,
                most: 12.6,
            },
            coordinates: [
                [3.11e-15, 2.94e-15, 1.7e-6, 1.61e-6],
                [3.29e-15, 2.86e-15, 1.81e-6, 1.57e-6],
                [3.03e-15, 2.6e-15, 1.67e-6, 1.43e-6],
            ],
            separated_point: ::hodograph::Bound {
                errors: [3.19e-15, 2.86e-15, 1.75e-6, 1.57e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 12.4,
                most: 12.6,
            },
            partial_u: ::hodograph::Bound {
                errors: [6.35e-15, 5.62e-15, 3.45e-6, 3.06e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 2.57,
                most: 2.85,
            },
            partial_v: ::hodograph::Bound {
                errors: [3.11e-15, 2.71e-15, 1.68e-6, 1.46e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.83,
                most: 4.92,
            },
            partial_uu: ::hodograph::Bound {
                errors: [1.62e-14, 1.53e-14, 8.8e-6, 8.33e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 5.54,
                most: 6.27,
            },
            partial_uv: ::hodograph::Bound {
                errors: [5.47e-15, 4.66e-15, 2.95e-6, 2.51e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 1.67,
                most: 1.9,
            },
            partial_vv: ::hodograph::Bound {
                errors: [2.05e-14, 1.85e-14, 1.15e-5, 1.03e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.27,
                most: 4.46,
            },
            unit_normal: ::hodograph::Bound {
                errors: [6.42e-15, 5.34e-15, 3.48e-6, 2.89e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.948,
                most: 1.0,
            },
            first_form: ::hodograph::Bound {
                errors: [5.2e-14, 4.56e-14, 2.85e-5, 2.5e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 27.1,
                most: 28.0,
            },
            second_form: ::hodograph::Bound {
                errors: [5.01e-14, 4.55e-14, 2.74e-5, 2.5e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 5.73,
                most: 7.99,
            },
            gaussian: ::hodograph::Bound {
                errors: [1.54e-13, 1.38e-13, 8.37e-5, 7.5e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.057,
                most: 2.49,
            },
            mean: ::hodograph::Bound {
                errors: [3.4e-14, 3.05e-14, 1.86e-5, 1.66e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.394,
                most: 1.33,
            },
            principal: ::hodograph::Bound {
                errors: [8.31e-14, 7.45e-14, 4.52e-5, 4.06e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.769,
                most: 2.92,
            },
            speeds: ::hodograph::Bound {
                errors: [8.52e-15, 7.69e-15, 4.67e-6, 4.24e-6],
                relative_errors: [3.44e-15, 3.13e-15, 1.89e-6, 1.72e-6],
                size: 5.19,
                most: 5.29,
            },
            normal_u: ::hodograph::Bound {
                errors: [1.04e-13, 9.49e-14, 5.63e-5, 5.2e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 1.7,
                most: 4.57,
            },
            normal_v: ::hodograph::Bound {
                errors: [1.56e-13, 1.39e-13, 8.46e-5, 7.55e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.523,
                most: 3.78,
            },
        };
        /// `q1 = 3/10*v^3 - 27/10*v^2 + 63/10*v - 27/10`
        const Q1: [f64; 4] = [0.8625, -1.575, -0.45, 0.3];
        /// `q2 = -1/6*v^3 + 3/2*v^2 - 29/6*v + 11/2`
        const Q2: [f64; 4] = [0.1875, -0.4583333333333333, 0.25, -0.16666666666666666];
        /// `q7 = 211/500*v^3 - 1899/500*v^2 + 4431/500*v - 2227/250`
        const Q7: [f64; 4] = [-3.89675, -2.2155, -0.633, 0.422];
        /// `q9 = 9/10*v^2 - 27/5*v + 63/10`
        const Q9: [f64; 3] = [-1.575, -0.9, 0.9];
        /// `q10 = -1/2*v^2 + 3*v - 29/6`
        const Q10: [f64; 3] = [-0.4583333333333333, 0.5, -0.5];
        /// `q19 = 8153484*v^5 - 122302260*v^4 + 675577288*v^3 - 1703896452*v^2 + 1976447804*v - 851539932`
        const Q19: [f64; 6] = [
            14928518.625,
            72625787.75,
            50580333.0,
            -37852562.0,
            -20383710.0,
            8153484.0,
        ];
        /// `q59 = 1/75*v^3 - 3/25*v^2 + 47/150*v - 23/150`
        const Q59: [f64; 4] = [
            0.08833333333333333,
            -0.03666666666666667,
            -0.02,
            0.013333333333333334,
        ];
        /// What points need of u alone.
        #[inline(always)]
        fn values_of_u<R: ::hodograph::Real>(u: R) -> OfU<R> {
            let p4 = u * u;
            let p1 = u.mul_add(u, R::of(1.0));
            let z_numerator = u.mul_add(u, R::of(-1.0));
            let p1_inverse = R::of(1.0) / p1;
            let z_numerator_over_p1 = z_numerator * p1_inverse;
            let t234 = p1_inverse * p1_inverse;
            let p2 = R::of(12.0).mul_add(p4, R::of(-4.0));
            let p3 = R::of(2.0).mul_add(p4, R::of(-6.0)) * u;
            let t242 = t234 * p1_inverse;
            let t717 = u * p4;
            OfU {
                u,
                p4,
                p1,
                z_numerator,
                z_numerator_over_p1,
                t181: u * p1_inverse,
                t235: R::of(-4.0) * u * t234,
                t236: z_numerator * t234,
                t242,
                t243: p2 * t242,
                t244: p3 * t242,
                t717,
                t718: u * t717,
            }
        }
        /// What points need of v alone.
        #[inline(always)]
        fn values_of_v<R: ::hodograph::Real>(v: R) -> OfV<R> {
            let t10 = v - R::of(2.5);
            let q1 = ::hodograph::horner(Self::Q1.map(R::of), t10);
            let q2 = ::hodograph::horner(Self::Q2.map(R::of), t10);
            let t31 = t10 * t10;
            let t40 = t31 * t31;
            let t51 = t40 * t40;
            let q3 = R::of(461661814849.0)
                .mul_add(
                    t40,
                    R::of(-2769970889094.0)
                        .mul_add(t10, R::of(-2274840721067.5))
                        .mul_add(
                            t31,
                            R::of(30745111603852.5)
                                .mul_add(t10, R::of(12693645645129.938)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(-143650662940788.75)
                        .mul_add(t10, R::of(-102644609387763.06))
                        .mul_add(
                            t31,
                            R::of(149875108126217.8)
                                .mul_add(t10, R::of(256784226803051.56)),
                        )
                        .mul_add(
                            t40,
                            R::of(625101617313225.9)
                                .mul_add(t10, R::of(818265326920246.1))
                                .mul_add(
                                    t31,
                                    R::of(313490417557873.56)
                                        .mul_add(t10, R::of(440976160728430.4)),
                                ),
                        ),
                );
            let q4 = R::of(112591710000.0)
                .mul_add(
                    t40,
                    R::of(-675550260000.0)
                        .mul_add(t10, R::of(764746290000.0))
                        .mul_add(
                            t31,
                            R::of(2208854340000.0).mul_add(t10, R::of(-5505421978125.0)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(-2773120072500.0)
                        .mul_add(t10, R::of(12179368980000.0))
                        .mul_add(
                            t31,
                            R::of(11105006220000.0)
                                .mul_add(t10, R::of(-45706792989023.44)),
                        )
                        .mul_add(
                            t40,
                            R::of(-959216026640.625)
                                .mul_add(t10, R::of(66466628328867.19))
                                .mul_add(
                                    t31,
                                    R::of(-32780807251171.875)
                                        .mul_add(t10, R::of(-52891758791872.56)),
                                ),
                        ),
                );
            let t78 = q4 * q1;
            let q5 = R::of(-245429184000.0)
                .mul_add(
                    t40,
                    R::of(1472575104000.0)
                        .mul_add(t10, R::of(183834852000.0))
                        .mul_add(
                            t31,
                            R::of(-13906597908000.0)
                                .mul_add(t10, R::of(15506543151000.0)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(42668002296000.0)
                        .mul_add(t10, R::of(-92167226029500.0))
                        .mul_add(
                            t31,
                            R::of(-21715515976500.0)
                                .mul_add(t10, R::of(156932595706125.0)),
                        )
                        .mul_add(
                            t40,
                            R::of(-101482569055500.0)
                                .mul_add(t10, R::of(-7594286507296.875))
                                .mul_add(
                                    t31,
                                    R::of(-28159140437015.625)
                                        .mul_add(t10, R::of(-168455956989269.53)),
                                ),
                        ),
                );
            let t104 = q5 * q1;
            let q6 = R::of(-44307462969.8)
                .mul_add(t10, R::of(332305972273.5))
                .mul_add(
                    t31,
                    R::of(384179350652.25).mul_add(t10, R::of(-6281398043267.375)),
                )
                .mul_add(
                    t40,
                    R::of(-687835160157.8125)
                        .mul_add(t10, R::of(54743121372355.05))
                        .mul_add(
                            t31,
                            R::of(-15865084757779.61)
                                .mul_add(t10, R::of(-220315934489584.72)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(93156537730452.31)
                        .mul_add(t10, R::of(344968175952687.1))
                        .mul_add(
                            t31,
                            R::of(-133401431428044.08)
                                .mul_add(t10, R::of(43941531292505.4)),
                        )
                        .mul_add(
                            t40,
                            R::of(-191638404114288.03)
                                .mul_add(t10, R::of(-766244815426547.1))
                                .mul_add(
                                    t31,
                                    R::of(-245557456094203.75)
                                        .mul_add(t10, R::of(-564098886788861.1)),
                                ),
                        ),
                );
            let q7 = ::hodograph::horner(Self::Q7.map(R::of), t10);
            let t143 = q7 * q5;
            let q8 = R::of(41101224319.6)
                .mul_add(t10, R::of(-308259182397.0))
                .mul_add(
                    t31,
                    R::of(-1269258016759.5).mul_add(t10, R::of(11056804101537.25)),
                )
                .mul_add(
                    t40,
                    R::of(4159008122144.375)
                        .mul_add(t10, R::of(-103927176290440.72))
                        .mul_add(
                            t31,
                            R::of(21245181556965.78)
                                .mul_add(t10, R::of(416057996304787.06)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(-143818103549601.13)
                        .mul_add(t10, R::of(-646400865350958.6))
                        .mul_add(
                            t31,
                            R::of(180156795077046.25)
                                .mul_add(t10, R::of(-212209274879842.72)),
                        )
                        .mul_add(
                            t40,
                            R::of(528365869459547.9)
                                .mul_add(t10, R::of(1685387103013380.8))
                                .mul_add(
                                    t31,
                                    R::of(246194609929009.8)
                                        .mul_add(t10, R::of(922091812505492.8)),
                                ),
                        ),
                );
            let t176 = R::of(2.0) * t104;
            let q3_inverse = R::of(1.0) / q3;
            let t180 = t78 * q3_inverse;
            let t182 = t143 * q3_inverse;
            let t186 = t104 * q3_inverse;
            let q8_over_q3 = q8 * q3_inverse;
            let q6_over_q3 = q6 * q3_inverse;
            let t191 = t176 * q3_inverse;
            let q9 = ::hodograph::horner(Self::Q9.map(R::of), t10);
            let q10 = ::hodograph::horner(Self::Q10.map(R::of), t10);
            let t293 = t51 * t51;
            let q11 = R::of(6.8851102951323e16)
                .mul_add(
                    t40,
                    R::of(-6.8851102951323e17)
                        .mul_add(t10, R::of(1.188735903809685e18))
                        .mul_add(
                            t31,
                            R::of(7.5771192844116e18)
                                .mul_add(t10, R::of(-2.178319364603603e19)),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.907838106598884e19)
                        .mul_add(t10, R::of(1.523480462463956e20))
                        .mul_add(
                            t31,
                            R::of(3.236991942722787e19)
                                .mul_add(t10, R::of(-3.420043596332063e20)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.8093560631752065e19)
                                .mul_add(t10, R::of(-2.986149010402494e20))
                                .mul_add(
                                    t31,
                                    R::of(1.6257349690411359e21)
                                        .mul_add(t10, R::of(1.7669928967044016e21)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-6.198243838026406e21)
                                .mul_add(t10, R::of(-3.133495777386102e21))
                                .mul_add(
                                    t31,
                                    R::of(1.1804855977002714e22)
                                        .mul_add(t10, R::of(7.89605053542045e21)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-1.6186016525447292e22)
                                        .mul_add(t10, R::of(-7.407484307515563e21))
                                        .mul_add(
                                            t31,
                                            R::of(8.478067457840507e21)
                                                .mul_add(t10, R::of(1.8366475249272787e21)),
                                        ),
                                ),
                        ),
                );
            let q12 = R::of(-2.111163585745294e17)
                .mul_add(
                    t40,
                    R::of(2.111163585745294e18)
                        .mul_add(t10, R::of(-3.1142970144294164e18))
                        .mul_add(
                            t31,
                            R::of(-2.8009763791175266e19)
                                .mul_add(t10, R::of(6.66032615582358e19)),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.9878416093608323e20)
                        .mul_add(t10, R::of(-4.6990489848777356e20))
                        .mul_add(
                            t31,
                            R::of(-7.82316006269537e20)
                                .mul_add(t10, R::of(1.1428387905221801e21)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.1746075368194616e21)
                                .mul_add(t10, R::of(2.1261731083674137e21))
                                .mul_add(
                                    t31,
                                    R::of(1.5340789994509073e21)
                                        .mul_add(t10, R::of(-1.6900918530526356e22)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-5.719799671457197e21)
                                .mul_add(t10, R::of(3.63396701974972e22))
                                .mul_add(
                                    t31,
                                    R::of(2.894412659346456e22)
                                        .mul_add(t10, R::of(-1.0930619862734197e22)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-3.3116676863956045e22)
                                        .mul_add(t10, R::of(-3.689083978008709e22))
                                        .mul_add(
                                            t31,
                                            R::of(-4.293712610857278e22)
                                                .mul_add(t10, R::of(3.419965608762044e20)),
                                        ),
                                ),
                        ),
                );
            let q13 = R::of(-1.500827193657792e17)
                .mul_add(
                    t40,
                    R::of(1.500827193657792e18)
                        .mul_add(t10, R::of(-2.2139552235280212e18))
                        .mul_add(
                            t31,
                            R::of(-1.9912154353916064e19)
                                .mul_add(t10, R::of(4.734829020727664e19)),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.4637825626355995e20)
                        .mul_add(t10, R::of(-3.5210963844540144e20))
                        .mul_add(
                            t31,
                            R::of(-7.22563251202464e20)
                                .mul_add(t10, R::of(1.3903982068056462e21)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.0776558450850844e21)
                                .mul_add(t10, R::of(-2.4707092450910195e21))
                                .mul_add(
                                    t31,
                                    R::of(-3.082265807581885e21)
                                        .mul_add(t10, R::of(-2.490130671480205e21)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(5.405678304228403e21)
                                .mul_add(t10, R::of(1.917068528303934e22))
                                .mul_add(
                                    t31,
                                    R::of(-1.1722680393530494e22)
                                        .mul_add(t10, R::of(-1.5780938301611834e22)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.7414186871583487e21)
                                        .mul_add(t10, R::of(-1.292588999821006e22))
                                        .mul_add(
                                            t31,
                                            R::of(1.35242334609106e22)
                                                .mul_add(t10, R::of(7.23052471620922e21)),
                                        ),
                                ),
                        ),
                );
            let q14 = R::of(8.377954371756738e16)
                .mul_add(
                    t40,
                    R::of(-8.377954371756737e17)
                        .mul_add(t10, R::of(2.896667556292906e17))
                        .mul_add(
                            t31,
                            R::of(1.9631326478143648e19)
                                .mul_add(t10, R::of(-3.0454049435045306e19)),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.0339373909566695e20)
                        .mul_add(t10, R::of(2.3484382965833777e20))
                        .mul_add(
                            t31,
                            R::of(1.482489992494725e21)
                                .mul_add(t10, R::of(-4.128182024978098e20)),
                        )
                        .mul_add(
                            t40,
                            R::of(-5.963015231032376e21)
                                .mul_add(t10, R::of(-3.109507322739915e21))
                                .mul_add(
                                    t31,
                                    R::of(5.162731168681991e21)
                                        .mul_add(t10, R::of(1.1545831334687162e22)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.160818485698923e22)
                                .mul_add(t10, R::of(4.5520642503089445e21))
                                .mul_add(
                                    t31,
                                    R::of(-4.592712972309425e22)
                                        .mul_add(t10, R::of(-2.372703032091776e22)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-5.055615405546473e22)
                                        .mul_add(t10, R::of(-2.676361898783641e22))
                                        .mul_add(
                                            t31,
                                            R::of(1.9790403726350153e21)
                                                .mul_add(t10, R::of(-8.59551773080772e21)),
                                        ),
                                ),
                        ),
                );
            let q15 = R::of(-9.031504760121419e16)
                .mul_add(
                    t40,
                    R::of(9.03150476012142e17)
                        .mul_add(t10, R::of(-9.809109634941238e17))
                        .mul_add(
                            t31,
                            R::of(-1.5144903802441316e19)
                                .mul_add(t10, R::of(3.054787091523466e19)),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.2460051279791802e20)
                        .mul_add(t10, R::of(-1.970261251754996e20))
                        .mul_add(
                            t31,
                            R::of(-7.63736294615947e20)
                                .mul_add(t10, R::of(2.5496422840466398e20)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.096652196286206e21)
                                .mul_add(t10, R::of(1.8431832026669428e21))
                                .mul_add(
                                    t31,
                                    R::of(-2.882483275407816e21)
                                        .mul_add(t10, R::of(-7.975505742331462e21)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.6580436915082079e22)
                                .mul_add(t10, R::of(5.636833997229442e21))
                                .mul_add(
                                    t31,
                                    R::of(2.3665443278836954e22)
                                        .mul_add(t10, R::of(-3.6649065311714945e21)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.9082843614638865e22)
                                        .mul_add(t10, R::of(2.9834769171819795e22))
                                        .mul_add(
                                            t31,
                                            R::of(1.0619618157910657e22)
                                                .mul_add(t10, R::of(3.2645935405051806e21)),
                                        ),
                                ),
                        ),
                );
            let q16 = R::of(679457.0)
                .mul_add(t31, R::of(-2038371.0).mul_add(t10, R::of(-4731570.25)))
                .mul_add(
                    t40,
                    R::of(8430055.5)
                        .mul_add(t10, R::of(18156446.9375))
                        .mul_add(
                            t31,
                            R::of(7464259.3125).mul_add(t10, R::of(20999432.390625)),
                        ),
                );
            let t473 = q16 * q3;
            let t474 = R::of(1.0) / t473;
            let t475 = q11 * t474;
            let t476 = q12 * t474;
            let t477 = q13 * t474;
            let t478 = q14 * t474;
            let t479 = q15 * t474;
            let t480 = R::of(2.0) * q13 * t474;
            let q18 = R::of(7093277730000.0)
                .mul_add(t10, R::of(-46106305245000.0))
                .mul_add(
                    t40,
                    R::of(55549971477000.0)
                        .mul_add(t10, R::of(195310167475500.0))
                        .mul_add(
                            t31,
                            R::of(-487602340768125.0)
                                .mul_add(t10, R::of(-105646323777187.5)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(1114408167150375.0)
                        .mul_add(t10, R::of(-141678684948937.5))
                        .mul_add(
                            t31,
                            R::of(-1691911741873007.8)
                                .mul_add(t10, R::of(398838389574550.75)),
                        )
                        .mul_add(
                            t40,
                            R::of(2038758050662207.0)
                                .mul_add(t10, R::of(-931866823612986.4))
                                .mul_add(
                                    t31,
                                    R::of(-639770566892866.8)
                                        .mul_add(t10, R::of(265517059621172.6)),
                                ),
                        ),
                );
            let q19 = ::hodograph::horner(Self::Q19.map(R::of), t10);
            let q20 = R::of(60939359560068.0)
                .mul_add(
                    t31,
                    R::of(-304696797800340.0).mul_add(t10, R::of(-204735664896075.0)),
                )
                .mul_add(
                    t51,
                    R::of(2213648035477380.0)
                        .mul_add(t10, R::of(710844156127276.5))
                        .mul_add(
                            t31,
                            R::of(-6033327843513128.0)
                                .mul_add(t10, R::of(-3079338281632892.0)),
                        )
                        .mul_add(
                            t40,
                            R::of(2997502162524356.0)
                                .mul_add(t10, R::of(3081410721636618.5))
                                .mul_add(
                                    t31,
                                    R::of(3750609703879355.0)
                                        .mul_add(t10, R::of(1636530653840492.3)),
                                ),
                        ),
                );
            let t546 = R::of(2.0) * (q19 * q16);
            let q22 = R::of(-21749934286080.0)
                .mul_add(t10, R::of(141374572859520.0))
                .mul_add(
                    t40,
                    R::of(-48486886677216.0)
                        .mul_add(t10, R::of(-1094420678822064.0))
                        .mul_add(
                            t31,
                            R::of(1012120398780480.0)
                                .mul_add(t10, R::of(3445556792397480.0)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(-3316869056941812.0)
                        .mul_add(t10, R::of(-5923577787447978.0))
                        .mul_add(
                            t31,
                            R::of(4951859989546197.0)
                                .mul_add(t10, R::of(7952981593589752.0)),
                        )
                        .mul_add(
                            t40,
                            R::of(-4040611031988827.0)
                                .mul_add(t10, R::of(-4725221213768208.0))
                                .mul_add(
                                    t31,
                                    R::of(2154081988626570.0)
                                        .mul_add(t10, R::of(397224464719449.6)),
                                ),
                        ),
                );
            let q24 = R::of(-15462038592000.0)
                .mul_add(t10, R::of(100503250848000.0))
                .mul_add(
                    t40,
                    R::of(-34469350718400.0)
                        .mul_add(t10, R::of(-895711544085600.0))
                        .mul_add(
                            t31,
                            R::of(1307953695312000.0)
                                .mul_add(t10, R::of(2509551498222000.0)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(-5995297080037800.0)
                        .mul_add(t10, R::of(-1056558340775700.0))
                        .mul_add(
                            t31,
                            R::of(1.003028434287705e16)
                                .mul_add(t10, R::of(-4390702007155875.0)),
                        )
                        .mul_add(
                            t40,
                            R::of(-4450192012881844.0)
                                .mul_add(t10, R::of(3481909162273490.5))
                                .mul_add(
                                    t31,
                                    R::of(-680597330769000.0)
                                        .mul_add(t10, R::of(227211509441854.7)),
                                ),
                        ),
                );
            let q26 = R::of(8631257107116.0)
                .mul_add(t10, R::of(-56103171196254.0))
                .mul_add(
                    t40,
                    R::of(-198004250614482.0)
                        .mul_add(t10, R::of(1459498141402917.0))
                        .mul_add(
                            t31,
                            R::of(457490893435881.25)
                                .mul_add(t10, R::of(-9353445866139664.0)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(1529653072101536.3)
                        .mul_add(t10, R::of(2.3299247793068076e16))
                        .mul_add(
                            t31,
                            R::of(-6040360349083247.0)
                                .mul_add(t10, R::of(-1.939202596052876e16)),
                        )
                        .mul_add(
                            t40,
                            R::of(3603135901540925.0)
                                .mul_add(t10, R::of(-2546511298558112.5))
                                .mul_add(
                                    t31,
                                    R::of(3170195216757287.5)
                                        .mul_add(t10, R::of(3370774206026761.5)),
                                ),
                        ),
                );
            let q28 = R::of(-9304567223658.0)
                .mul_add(t10, R::of(60479686953777.0))
                .mul_add(
                    t40,
                    R::of(59931978701751.0)
                        .mul_add(t10, R::of(-829144541711293.5))
                        .mul_add(
                            t31,
                            R::of(-75661867617359.38)
                                .mul_add(t10, R::of(4926880923511954.0)),
                        ),
                )
                .mul_add(
                    t51,
                    R::of(-1142286102560132.0)
                        .mul_add(t10, R::of(-1.2337692331416744e16))
                        .mul_add(
                            t31,
                            R::of(3912574584678997.5)
                                .mul_add(t10, R::of(1.0349045278580612e16)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2668028628560881.5)
                                .mul_add(t10, R::of(527298375510064.8))
                                .mul_add(
                                    t31,
                                    R::of(-1149830424685728.3)
                                        .mul_add(t10, R::of(-1532489630853094.3)),
                                ),
                        ),
                );
            let q29 = R::of(1.0280238875884368e24)
                .mul_add(
                    t31,
                    R::of(-1.336431053864968e25)
                        .mul_add(t10, R::of(7.286078968260562e25)),
                )
                .mul_add(
                    t51,
                    R::of(-1.7815784838522277e26)
                        .mul_add(t10, R::of(-5.830554417879231e26))
                        .mul_add(
                            t31,
                            R::of(5.694136747698285e27)
                                .mul_add(t10, R::of(-4.2488072243656876e27)),
                        )
                        .mul_add(
                            t40,
                            R::of(-6.069714772752073e28)
                                .mul_add(t10, R::of(7.553051653476407e28))
                                .mul_add(
                                    t31,
                                    R::of(3.927011476174924e29)
                                        .mul_add(t10, R::of(-3.2695618176543216e29)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.6673514053318154e30)
                        .mul_add(t10, R::of(-1.2630245727803387e29))
                        .mul_add(
                            t31,
                            R::of(3.4603599057031634e30)
                                .mul_add(t10, R::of(4.862958097165211e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.6761983427132184e30)
                                .mul_add(t10, R::of(-7.54972539703483e30))
                                .mul_add(
                                    t31,
                                    R::of(-1.9343097257780682e31)
                                        .mul_add(t10, R::of(-1.8009026469321343e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-8.082285162862505e30)
                                .mul_add(t10, R::of(9.178837299473447e30))
                                .mul_add(
                                    t31,
                                    R::of(2.3622848680696223e31)
                                        .mul_add(t10, R::of(2.5079034880760037e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.315086133025678e31)
                                        .mul_add(t10, R::of(5.0601005429457704e30))
                                        .mul_add(
                                            t31,
                                            R::of(5.390904603683335e30)
                                                .mul_add(t10, R::of(-1.6390964577825077e30)),
                                        ),
                                ),
                        ),
                );
            let q30 = R::of(-3.944723410319286e24)
                .mul_add(
                    t31,
                    R::of(5.128140433415071e25)
                        .mul_add(t10, R::of(-1.7715876354245898e26)),
                )
                .mul_add(
                    t51,
                    R::of(-3.2456764272030226e26)
                        .mul_add(t10, R::of(2.816613534576995e27))
                        .mul_add(
                            t31,
                            R::of(-1.7738100290738655e27)
                                .mul_add(t10, R::of(-1.3112709990109066e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.3237878525311117e28)
                                .mul_add(t10, R::of(-2.38510077709851e28))
                                .mul_add(
                                    t31,
                                    R::of(-4.157225833058893e28)
                                        .mul_add(t10, R::of(4.8873194686476586e29)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.458715272360155e29)
                        .mul_add(t10, R::of(-1.976405847956373e30))
                        .mul_add(
                            t31,
                            R::of(2.1061770701694307e30)
                                .mul_add(t10, R::of(2.7516095287449083e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(-5.150343954611741e30)
                                .mul_add(t10, R::of(5.963893934353779e29))
                                .mul_add(
                                    t31,
                                    R::of(2.4983554831459754e30)
                                        .mul_add(t10, R::of(-4.0467036874637343e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(1.9763891741371535e31)
                                .mul_add(t10, R::of(2.55563389286469e31))
                                .mul_add(
                                    t31,
                                    R::of(1.5593136433872816e31)
                                        .mul_add(t10, R::of(2.4163397397401956e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.63462973524094e30)
                                        .mul_add(t10, R::of(-5.0075787845845315e30))
                                        .mul_add(
                                            t31,
                                            R::of(-1.294791104628292e30)
                                                .mul_add(t10, R::of(-5.743671466276141e30)),
                                        ),
                                ),
                        ),
                );
            let q31 = R::of(-1.8240600563395036e24)
                .mul_add(
                    t31,
                    R::of(2.3712780732413546e25)
                        .mul_add(t10, R::of(-6.3387517848983655e25)),
                )
                .mul_add(
                    t51,
                    R::of(-3.5642591630738934e26)
                        .mul_add(t10, R::of(1.9018741177964964e27))
                        .mul_add(
                            t31,
                            R::of(2.763951564100936e26)
                                .mul_add(t10, R::of(-1.5295181036785769e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.642860464617302e28)
                                .mul_add(t10, R::of(2.677325620513751e28))
                                .mul_add(
                                    t31,
                                    R::of(-2.8041783683167554e29)
                                        .mul_add(t10, R::of(3.1408136046415157e29)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.6310398950257426e30)
                        .mul_add(t10, R::of(-1.7092952234858687e30))
                        .mul_add(
                            t31,
                            R::of(-5.57090466667303e30)
                                .mul_add(t10, R::of(-5.445959850769162e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(4.1865032255816784e30)
                                .mul_add(t10, R::of(1.705604178483242e31))
                                .mul_add(
                                    t31,
                                    R::of(3.6687290749260934e31)
                                        .mul_add(t10, R::of(9.432540783142251e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-4.353722459121338e31)
                                .mul_add(t10, R::of(-9.842239640192075e31))
                                .mul_add(
                                    t31,
                                    R::of(-1.7013596715146886e32)
                                        .mul_add(t10, R::of(-1.749593858213722e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-1.4113462732933347e32)
                                        .mul_add(t10, R::of(-1.0772995019512665e32))
                                        .mul_add(
                                            t31,
                                            R::of(-3.5898894656273145e31)
                                                .mul_add(t10, R::of(-2.1928565795837403e31)),
                                        ),
                                ),
                        ),
                );
            let q32 = R::of(-1.062160492942375e25)
                .mul_add(
                    t31,
                    R::of(1.3808086408250875e26)
                        .mul_add(t10, R::of(-3.4562188147294284e26)),
                )
                .mul_add(
                    t51,
                    R::of(-2.4158314170414907e27)
                        .mul_add(t10, R::of(1.0960941463095259e28))
                        .mul_add(
                            t31,
                            R::of(1.8202655257272759e28)
                                .mul_add(t10, R::of(-1.2557878424826354e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-8.899032219184312e28)
                                .mul_add(t10, R::of(7.939295356777388e29))
                                .mul_add(
                                    t31,
                                    R::of(4.804220854455055e29)
                                        .mul_add(t10, R::of(-2.921461924145856e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.5705921754032925e30)
                        .mul_add(t10, R::of(4.529374681588937e30))
                        .mul_add(
                            t31,
                            R::of(7.752838949599327e30)
                                .mul_add(t10, R::of(7.519951832857998e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.408328941368172e30)
                                .mul_add(t10, R::of(-3.190368025642071e31))
                                .mul_add(
                                    t31,
                                    R::of(-3.6276980155580235e31)
                                        .mul_add(t10, R::of(-1.8219989260666188e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(2.587732872796196e30)
                                .mul_add(t10, R::of(8.166890273689276e31))
                                .mul_add(
                                    t31,
                                    R::of(1.451791751619994e32)
                                        .mul_add(t10, R::of(1.3740647338019036e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.2336725621017027e32)
                                        .mul_add(t10, R::of(8.238804005814196e31))
                                        .mul_add(
                                            t31,
                                            R::of(3.9141204768032693e31)
                                                .mul_add(t10, R::of(1.4481074990925365e31)),
                                        ),
                                ),
                        ),
                );
            let q33 = R::of(-2.3390681928998537e24)
                .mul_add(
                    t31,
                    R::of(3.0407886507698098e25)
                        .mul_add(t10, R::of(-1.0563976882595588e26)),
                )
                .mul_add(
                    t51,
                    R::of(-2.019022894140131e26)
                        .mul_add(t10, R::of(1.2750321501130067e27))
                        .mul_add(
                            t31,
                            R::of(3.8636314876825633e27)
                                .mul_add(t10, R::of(-1.2701178290209804e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-8.551368209534022e28)
                                .mul_add(t10, R::of(2.0198082936871114e29))
                                .mul_add(
                                    t31,
                                    R::of(8.186441844764749e29)
                                        .mul_add(t10, R::of(-1.753988543780705e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-4.327071028876196e30)
                        .mul_add(t10, R::of(6.804672563417362e30))
                        .mul_add(
                            t31,
                            R::of(1.2591082710847262e31)
                                .mul_add(t10, R::of(-5.195426012842988e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(-6.185948789217124e30)
                                .mul_add(t10, R::of(-3.001510164424394e31))
                                .mul_add(
                                    t31,
                                    R::of(-8.0295855801158345e31)
                                        .mul_add(t10, R::of(-1.286525878381848e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(1.132978145327186e32)
                                .mul_add(t10, R::of(1.8327694040647925e32))
                                .mul_add(
                                    t31,
                                    R::of(3.0954948111234144e32)
                                        .mul_add(t10, R::of(3.146880866518772e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.3254692427886753e32)
                                        .mul_add(t10, R::of(1.9275753290874657e32))
                                        .mul_add(
                                            t31,
                                            R::of(7.377132543245685e31)
                                                .mul_add(t10, R::of(4.221680428284635e31)),
                                        ),
                                ),
                        ),
                );
            let q34 = R::of(-4.2103227472197365e24)
                .mul_add(
                    t31,
                    R::of(5.473419571385657e25)
                        .mul_add(t10, R::of(-2.4322449171920517e26)),
                )
                .mul_add(
                    t51,
                    R::of(2.354529264226776e26)
                        .mul_add(t10, R::of(2.1260227997813095e27))
                        .mul_add(
                            t31,
                            R::of(-1.1699970177829758e28)
                                .mul_add(t10, R::of(1.458726165807696e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(9.811930930831207e28)
                                .mul_add(t10, R::of(-3.041902425293653e29))
                                .mul_add(
                                    t31,
                                    R::of(-3.3124429752963965e29)
                                        .mul_add(t10, R::of(1.8029166616465949e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.0695703134157283e29)
                        .mul_add(t10, R::of(-4.2890445352845994e30))
                        .mul_add(
                            t31,
                            R::of(2.6893747934256285e30)
                                .mul_add(t10, R::of(-6.2282956453138984e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-8.728245176513891e30)
                                .mul_add(t10, R::of(2.1574964840214257e31))
                                .mul_add(
                                    t31,
                                    R::of(6.632275187262161e30)
                                        .mul_add(t10, R::of(-3.9175880236098884e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(9.340269708150106e30)
                                .mul_add(t10, R::of(2.787956099057862e31))
                                .mul_add(
                                    t31,
                                    R::of(2.327369530173894e31)
                                        .mul_add(t10, R::of(8.220722713289114e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(5.26658405926026e31)
                                        .mul_add(t10, R::of(2.3202724768386815e31))
                                        .mul_add(
                                            t31,
                                            R::of(2.382850849769471e31)
                                                .mul_add(t10, R::of(-1.6115989795100546e31)),
                                        ),
                                ),
                        ),
                );
            let q35 = R::of(-5.698565171620728e24)
                .mul_add(
                    t31,
                    R::of(7.408134723106947e25)
                        .mul_add(t10, R::of(-2.1821513532262706e26)),
                )
                .mul_add(
                    t51,
                    R::of(-9.633225413590283e26)
                        .mul_add(t10, R::of(5.356342676035158e27))
                        .mul_add(
                            t31,
                            R::of(5.264547256007984e27)
                                .mul_add(t10, R::of(-5.387514627753701e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.723187611768296e28)
                                .mul_add(t10, R::of(3.454667163764339e29))
                                .mul_add(
                                    t31,
                                    R::of(1.856172577075683e29)
                                        .mul_add(t10, R::of(-1.3682090321537945e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.0230791502685336e30)
                        .mul_add(t10, R::of(2.3330190087200132e30))
                        .mul_add(
                            t31,
                            R::of(2.643734892713593e30)
                                .mul_add(t10, R::of(2.1112817297463184e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.928221248185365e30)
                                .mul_add(t10, R::of(-3.258917624860455e30))
                                .mul_add(
                                    t31,
                                    R::of(-2.3173173963700143e31)
                                        .mul_add(t10, R::of(-4.23017298093697e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-3.19164954672462e30)
                                .mul_add(t10, R::of(6.448493001721636e31))
                                .mul_add(
                                    t31,
                                    R::of(6.996039428946478e31)
                                        .mul_add(t10, R::of(4.5763970792101e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.658071556432863e31)
                                        .mul_add(t10, R::of(-1.069335697385315e31))
                                        .mul_add(
                                            t31,
                                            R::of(-8.236107262152591e30)
                                                .mul_add(t10, R::of(9.475492823591583e30)),
                                        ),
                                ),
                        ),
                );
            let q36 = R::of(-4.303334629439221e24)
                .mul_add(
                    t31,
                    R::of(5.594335018270987e25).mul_add(t10, R::of(-1.57798263067056e26)),
                )
                .mul_add(
                    t51,
                    R::of(-7.365082602149072e26)
                        .mul_add(t10, R::of(3.30632592542682e27))
                        .mul_add(
                            t31,
                            R::of(8.387221670276672e27)
                                .mul_add(t10, R::of(-4.207903919258486e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-6.242846493879287e28)
                                .mul_add(t10, R::of(3.243772963525308e29))
                                .mul_add(
                                    t31,
                                    R::of(2.3199263472920345e29)
                                        .mul_add(t10, R::of(-1.2258943852086795e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.424657178658532e29)
                        .mul_add(t10, R::of(6.364213474587562e29))
                        .mul_add(
                            t31,
                            R::of(-1.2671631612918044e30)
                                .mul_add(t10, R::of(1.1147784349812326e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(5.790632835806607e30)
                                .mul_add(t10, R::of(-3.767453848707608e31))
                                .mul_add(
                                    t31,
                                    R::of(-1.4510288713190137e31)
                                        .mul_add(t10, R::of(4.154245203269736e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.830902629502432e31)
                                .mul_add(t10, R::of(4.143223153847248e31))
                                .mul_add(
                                    t31,
                                    R::of(9.747629003930196e30)
                                        .mul_add(t10, R::of(-7.086625065037457e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-8.231119879292786e31)
                                        .mul_add(t10, R::of(-4.041041082689997e31))
                                        .mul_add(
                                            t31,
                                            R::of(-4.196339121432118e31)
                                                .mul_add(t10, R::of(1.8794287351252756e30)),
                                        ),
                                ),
                        ),
                );
            let q37 = R::of(2.806881831479824e24)
                .mul_add(
                    t31,
                    R::of(-3.6489463809237716e25)
                        .mul_add(t10, R::of(9.586929215712319e25)),
                )
                .mul_add(
                    t51,
                    R::of(6.31181075988465e26)
                        .mul_add(t10, R::of(-3.378943360517829e27))
                        .mul_add(
                            t31,
                            R::of(-2.152393034043626e27)
                                .mul_add(t10, R::of(3.774808184252819e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.4432062428892984e28)
                                .mul_add(t10, R::of(-1.7160568956008583e29))
                                .mul_add(
                                    t31,
                                    R::of(3.587413234628587e29)
                                        .mul_add(t10, R::of(4.5668404571547295e28)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.0735339942899898e30)
                        .mul_add(t10, R::of(2.4259908924357974e30))
                        .mul_add(
                            t31,
                            R::of(-1.1609292425007573e30)
                                .mul_add(t10, R::of(-8.459652546964034e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.463605553933955e31)
                                .mul_add(t10, R::of(9.69273647995247e30))
                                .mul_add(
                                    t31,
                                    R::of(-3.4013856577420624e31)
                                        .mul_add(t10, R::of(1.034036558010482e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.4156258571110597e31)
                                .mul_add(t10, R::of(-2.2699196625401996e30))
                                .mul_add(
                                    t31,
                                    R::of(-2.870928589290261e30)
                                        .mul_add(t10, R::of(1.9488247805080534e30)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-3.204369407527737e31)
                                        .mul_add(t10, R::of(-9.61128821146787e30))
                                        .mul_add(
                                            t31,
                                            R::of(1.0171391138261726e31)
                                                .mul_add(t10, R::of(-4.2442128297121065e30)),
                                        ),
                                ),
                        ),
                );
            let q38 = R::of(-1.062160492942375e25)
                .mul_add(
                    t31,
                    R::of(1.3808086408250875e26)
                        .mul_add(t10, R::of(-3.6145113560762855e26)),
                )
                .mul_add(
                    t51,
                    R::of(-2.1898394036202956e27)
                        .mul_add(t10, R::of(9.872485186771092e27))
                        .mul_add(
                            t31,
                            R::of(1.9273018814676051e28)
                                .mul_add(t10, R::of(-1.1769633493725934e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.1592430068651971e29)
                                .mul_add(t10, R::of(8.054226891963193e29))
                                .mul_add(
                                    t31,
                                    R::of(5.865510813719222e29)
                                        .mul_add(t10, R::of(-3.1511955649285805e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.6283240010463287e30)
                        .mul_add(t10, R::of(5.371469188202094e30))
                        .mul_add(
                            t31,
                            R::of(7.193034730420703e30)
                                .mul_add(t10, R::of(5.216911681455307e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(5.798376616141368e29)
                                .mul_add(t10, R::of(-2.677781898357178e31))
                                .mul_add(
                                    t31,
                                    R::of(-4.719133299633797e31)
                                        .mul_add(t10, R::of(-2.324819816825078e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(2.351266089598541e31)
                                .mul_add(t10, R::of(8.080857422431783e31))
                                .mul_add(
                                    t31,
                                    R::of(1.216725855799923e32)
                                        .mul_add(t10, R::of(1.4216522990407648e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.3729364590573085e32)
                                        .mul_add(t10, R::of(8.086157175813483e31))
                                        .mul_add(
                                            t31,
                                            R::of(4.085253882439775e31)
                                                .mul_add(t10, R::of(1.8342048714292112e31)),
                                        ),
                                ),
                        ),
                );
            let q39 = R::of(-2.3390681928998537e24)
                .mul_add(
                    t31,
                    R::of(3.0407886507698098e25)
                        .mul_add(t10, R::of(-7.113491118053481e25)),
                )
                .mul_add(
                    t51,
                    R::of(-6.265461512973671e26)
                        .mul_add(t10, R::of(2.605720270704974e27))
                        .mul_add(
                            t31,
                            R::of(7.417326798710725e27)
                                .mul_add(t10, R::of(-3.999901392309797e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-5.987313750401637e28)
                                .mul_add(t10, R::of(3.3660676333706724e29))
                                .mul_add(
                                    t31,
                                    R::of(4.4875997851351785e29)
                                        .mul_add(t10, R::of(-1.6062340331888688e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.1144412906547047e30)
                        .mul_add(t10, R::of(3.391095443485872e30))
                        .mul_add(
                            t31,
                            R::of(1.3750355888393135e31)
                                .mul_add(t10, R::of(6.127617975873886e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.2576304753935193e31)
                                .mul_add(t10, R::of(-4.290561544229368e31))
                                .mul_add(
                                    t31,
                                    R::of(-4.229046898234573e31)
                                        .mul_add(t10, R::of(-3.6890578729675856e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(7.973756002792649e31)
                                .mul_add(t10, R::of(1.9091838440211873e32))
                                .mul_add(
                                    t31,
                                    R::of(3.0416370138312663e32)
                                        .mul_add(t10, R::of(3.07987511153234e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.6867455249904357e32)
                                        .mul_add(t10, R::of(2.0310612973901924e32))
                                        .mul_add(
                                            t31,
                                            R::of(6.594716941013804e31)
                                                .mul_add(t10, R::of(4.8732954155281835e31)),
                                        ),
                                ),
                        ),
                );
            let q40 = R::of(-4.2103227472197365e24)
                .mul_add(
                    t31,
                    R::of(5.473419571385657e25)
                        .mul_add(t10, R::of(-2.2246055651141946e26)),
                )
                .mul_add(
                    t51,
                    R::of(4.322737092413474e25)
                        .mul_add(t10, R::of(1.9563531145722994e27))
                        .mul_add(
                            t31,
                            R::of(-5.388494266069099e27)
                                .mul_add(t10, R::of(3.859068150425634e27)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.3425890918994864e28)
                                .mul_add(t10, R::of(-1.3021509876414248e29))
                                .mul_add(
                                    t31,
                                    R::of(-9.322281874957626e28)
                                        .mul_add(t10, R::of(9.393598683019478e29)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(2.2155503970680792e29)
                        .mul_add(t10, R::of(-4.1456510870130797e30))
                        .mul_add(
                            t31,
                            R::of(-5.135650197187299e29)
                                .mul_add(t10, R::of(1.1883881450083786e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.1362607109248322e30)
                                .mul_add(t10, R::of(-2.0016311148027432e31))
                                .mul_add(
                                    t31,
                                    R::of(-1.1539227833260825e31)
                                        .mul_add(t10, R::of(4.787760466127585e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.5589793261659756e31)
                                .mul_add(t10, R::of(5.85884449334351e31))
                                .mul_add(
                                    t31,
                                    R::of(5.388228368720267e31)
                                        .mul_add(t10, R::of(5.292330319232996e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-5.261481114328813e30)
                                        .mul_add(t10, R::of(-1.4166590334459458e31))
                                        .mul_add(
                                            t31,
                                            R::of(-1.28681072247036e31)
                                                .mul_add(t10, R::of(-9.964100501296526e30)),
                                        ),
                                ),
                        ),
                );
            let q41 = R::of(-6.726589059209165e24)
                .mul_add(
                    t31,
                    R::of(8.744565776971915e25)
                        .mul_add(t10, R::of(-2.6680750846128652e26)),
                )
                .mul_add(
                    t51,
                    R::of(-1.0483218396462335e27)
                        .mul_add(t10, R::of(6.466961513172489e27))
                        .mul_add(
                            t31,
                            R::of(2.944958353136001e27)
                                .mul_add(t10, R::of(-6.264874707276233e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.431929689129304e28)
                                .mul_add(t10, R::of(3.449172677819013e29))
                                .mul_add(
                                    t31,
                                    R::of(-2.232836163349994e29)
                                        .mul_add(t10, R::of(-1.1352953109644357e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(6.669975401871801e29)
                        .mul_add(t10, R::of(1.8993959845172073e30))
                        .mul_add(
                            t31,
                            R::of(-5.3701972764474174e29)
                                .mul_add(t10, R::of(5.680245976829272e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.2637179039227255e29)
                                .mul_add(t10, R::of(-8.065375503684886e30))
                                .mul_add(
                                    t31,
                                    R::of(-4.137337511521833e30)
                                        .mul_add(t10, R::of(3.8689637431702023e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(4.975276418745438e30)
                                .mul_add(t10, R::of(1.82016151158177e31))
                                .mul_add(
                                    t31,
                                    R::of(2.672554214020645e31)
                                        .mul_add(t10, R::of(2.384276730147886e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.602647798930326e31)
                                        .mul_add(t10, R::of(1.8527914307252932e31))
                                        .mul_add(
                                            t31,
                                            R::of(6.841500645678237e30)
                                                .mul_add(t10, R::of(7.150132781610924e30)),
                                        ),
                                ),
                        ),
                );
            let q42 = R::of(-3.5861121911993506e23)
                .mul_add(
                    t31,
                    R::of(4.661945848559156e24).mul_add(t10, R::of(9.729807342346188e24)),
                )
                .mul_add(
                    t51,
                    R::of(-3.518477359867544e26)
                        .mul_add(t10, R::of(1.1165566727446926e27))
                        .mul_add(
                            t31,
                            R::of(3.9753464794450836e27)
                                .mul_add(t10, R::of(-2.138097857535956e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.8302181917000969e28)
                                .mul_add(t10, R::of(1.785487108467151e29))
                                .mul_add(
                                    t31,
                                    R::of(3.7192986675572557e28)
                                        .mul_add(t10, R::of(-8.507414907851405e29)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.4831510299605145e28)
                        .mul_add(t10, R::of(2.3704348211603386e30))
                        .mul_add(
                            t31,
                            R::of(-1.5322848283336734e28)
                                .mul_add(t10, R::of(-3.3903283772458505e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.551605508010699e29)
                                .mul_add(t10, R::of(1.1197360404622858e30))
                                .mul_add(
                                    t31,
                                    R::of(3.2078100060637476e30)
                                        .mul_add(t10, R::of(8.208442493178866e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.1349052217529778e31)
                                .mul_add(t10, R::of(-2.7236519402178487e31))
                                .mul_add(
                                    t31,
                                    R::of(-3.0805825140420387e31)
                                        .mul_add(t10, R::of(-4.650704350333401e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-2.7755315199706364e31)
                                        .mul_add(t10, R::of(-1.440522174469774e31))
                                        .mul_add(
                                            t31,
                                            R::of(-9.795039459455806e30)
                                                .mul_add(t10, R::of(2.857680133608242e30)),
                                        ),
                                ),
                        ),
                );
            let q43 = R::of(4.630941887819328e24)
                .mul_add(
                    t31,
                    R::of(-6.020224454165126e25)
                        .mul_add(t10, R::of(1.9376166765152792e26)),
                )
                .mul_add(
                    t51,
                    R::of(5.454728209186492e26)
                        .mul_add(t10, R::of(-3.7489907985430716e27))
                        .mul_add(
                            t31,
                            R::of(3.319941612801495e26)
                                .mul_add(t10, R::of(2.646432706039895e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.1855348512150306e28)
                                .mul_add(t10, R::of(-7.185311647788375e28))
                                .mul_add(
                                    t31,
                                    R::of(2.6282344239012313e29)
                                        .mul_add(t10, R::of(-8.756458447086042e28)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.4736416376632247e30)
                        .mul_add(t10, R::of(5.7126816227864326e29))
                        .mul_add(
                            t31,
                            R::of(5.607619243900244e30)
                                .mul_add(t10, R::of(3.8196625376214595e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(-6.207134486209378e30)
                                .mul_add(t10, R::of(-2.1138413976514152e31))
                                .mul_add(
                                    t31,
                                    R::of(-3.189256985656789e31)
                                        .mul_add(t10, R::of(-9.127233182216072e30)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(4.211660763713882e31)
                                .mul_add(t10, R::of(1.0164092732278806e32))
                                .mul_add(
                                    t31,
                                    R::of(1.6538662398241108e32)
                                        .mul_add(t10, R::of(1.7196288871678168e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.417084413762888e32)
                                        .mul_add(t10, R::of(1.0760892527495818e32))
                                        .mul_add(
                                            t31,
                                            R::of(4.051573794062805e31)
                                                .mul_add(t10, R::of(2.5220062977448027e31)),
                                        ),
                                ),
                        ),
                );
            let q44 = R::of(2.672862107729936e25)
                .mul_add(t10, R::of(-3.34107763466242e26))
                .mul_add(
                    t51,
                    R::of(1.748658952382535e27)
                        .mul_add(t10, R::of(-4.097630512860124e27))
                        .mul_add(
                            t31,
                            R::of(-1.2827219719334307e28)
                                .mul_add(t10, R::of(1.1957687170166397e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-8.497614448731376e28)
                                .mul_add(t10, R::of(-1.1532458068228938e30))
                                .mul_add(
                                    t31,
                                    R::of(1.3595492976257533e30)
                                        .mul_add(t10, R::of(6.675919509497372e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-5.231298908246915e30)
                        .mul_add(t10, R::of(-2.501027107997723e31))
                        .mul_add(
                            t31,
                            R::of(-1.768234401892474e30)
                                .mul_add(t10, R::of(4.498467877414113e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(5.835549716598253e31)
                                .mul_add(t10, R::of(2.94381817698454e31))
                                .mul_add(
                                    t31,
                                    R::of(-7.54972539703483e31)
                                        .mul_add(t10, R::of(-1.7408787532002614e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.4407221175457074e32)
                                .mul_add(t10, R::of(-5.657599614003753e31))
                                .mul_add(
                                    t31,
                                    R::of(5.507302379684068e31)
                                        .mul_add(t10, R::of(1.181142434034811e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.0031613952304015e32)
                                        .mul_add(t10, R::of(6.945258399077034e31))
                                        .mul_add(
                                            t31,
                                            R::of(1.0120201085891541e31)
                                                .mul_add(t10, R::of(5.390904603683335e30)),
                                        ),
                                ),
                        ),
                );
            let q45 = R::of(-1.0256280866830142e26)
                .mul_add(t10, R::of(1.2820351083537678e27))
                .mul_add(
                    t51,
                    R::of(-4.2518103250190154e27)
                        .mul_add(t10, R::of(-7.465055782566952e27))
                        .mul_add(
                            t31,
                            R::of(6.19654977606939e28)
                                .mul_add(t10, R::of(-3.7250010610551173e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.6225419980218133e29)
                                .mul_add(t10, R::of(4.4151969198091125e29))
                                .mul_add(
                                    t31,
                                    R::of(-4.2931813987773185e29)
                                        .mul_add(t10, R::of(-7.067283916200119e29)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(7.819711149836254e30)
                        .mul_add(t10, R::of(-5.188072908540232e30))
                        .mul_add(
                            t31,
                            R::of(-2.766968187138922e31)
                                .mul_add(t10, R::of(2.7380301912202597e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.30193143449389e31)
                                .mul_add(t10, R::of(-5.665378350072915e31))
                                .mul_add(
                                    t31,
                                    R::of(5.963893934353779e30)
                                        .mul_add(t10, R::of(2.2485199348313777e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-3.2373629499709874e31)
                                .mul_add(t10, R::of(1.3834724218960074e32))
                                .mul_add(
                                    t31,
                                    R::of(1.533380335718814e32)
                                        .mul_add(t10, R::of(7.7965682169364075e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(9.665358958960782e31)
                                        .mul_add(t10, R::of(7.903889205722821e30))
                                        .mul_add(
                                            t31,
                                            R::of(-1.0015157569169063e31)
                                                .mul_add(t10, R::of(-1.294791104628292e30)),
                                        ),
                                ),
                        ),
                );
            let q46 = R::of(-4.742556146482709e25)
                .mul_add(t10, R::of(5.928195183103386e26))
                .mul_add(
                    t51,
                    R::of(-1.5213004283756076e27)
                        .mul_add(t10, R::of(-8.197796075069955e27))
                        .mul_add(
                            t31,
                            R::of(4.1841230591522925e28)
                                .mul_add(t10, R::of(5.804298284611966e27)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.059036207357154e29)
                                .mul_add(t10, R::of(5.021434882772874e29))
                                .mul_add(
                                    t31,
                                    R::of(4.8191861169247515e29)
                                        .mul_add(t10, R::of(-4.767103226138484e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(5.025301767426425e30)
                        .mul_add(t10, R::of(2.446559842538614e31))
                        .mul_add(
                            t31,
                            R::of(-2.393013312880216e31)
                                .mul_add(t10, R::of(-7.242176066674939e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(-6.535151820922994e30)
                                .mul_add(t10, R::of(4.605153548139846e31))
                                .mul_add(
                                    t31,
                                    R::of(1.7056041784832418e32)
                                        .mul_add(t10, R::of(3.3018561674334844e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(7.546032626513801e31)
                                .mul_add(t10, R::of(-3.0476057213849362e32))
                                .mul_add(
                                    t31,
                                    R::of(-5.9053437841152454e32)
                                        .mul_add(t10, R::of(-8.506798357573442e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-6.998375432854888e32)
                                        .mul_add(t10, R::of(-4.234038819880004e32))
                                        .mul_add(
                                            t31,
                                            R::of(-2.154599003902533e32)
                                                .mul_add(t10, R::of(-3.5898894656273145e31)),
                                        ),
                                ),
                        ),
                );
            let t1747 = R::of(-2.761617281650175e26)
                .mul_add(t10, R::of(3.4520216020627184e27));
            let q47 = t1747
                .mul_add(
                    t51,
                    R::of(-8.294925155350628e27)
                        .mul_add(t10, R::of(-5.556412259195429e28))
                        .mul_add(
                            t31,
                            R::of(2.4114071218809566e29)
                                .mul_add(t10, R::of(3.8225576040272796e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.5115756849652707e30)
                                .mul_add(t10, R::of(-1.690816121645019e30))
                                .mul_add(
                                    t31,
                                    R::of(1.4290731642199298e31)
                                        .mul_add(t10, R::of(8.167175452573594e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-4.67433907863337e31)
                        .mul_add(t10, R::of(-3.855888263104939e31))
                        .mul_add(
                            t31,
                            R::of(6.341124554224512e31)
                                .mul_add(t10, R::of(1.0078690634479125e32)),
                        )
                        .mul_add(
                            t40,
                            R::of(9.023942199429598e31)
                                .mul_add(t10, R::of(-2.649161835504989e31))
                                .mul_add(
                                    t31,
                                    R::of(-3.1903680256420708e32)
                                        .mul_add(t10, R::of(-3.264928214002221e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.457599140853295e32)
                                .mul_add(t10, R::of(1.811413010957337e31))
                                .mul_add(
                                    t31,
                                    R::of(4.900134164213565e32)
                                        .mul_add(t10, R::of(7.25895875809997e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(5.4962589352076144e32)
                                        .mul_add(t10, R::of(3.701017686305108e32))
                                        .mul_add(
                                            t31,
                                            R::of(1.647760801162839e32)
                                                .mul_add(t10, R::of(3.9141204768032693e31)),
                                        ),
                                ),
                        ),
                );
            let t1797 = R::of(-6.0815773015396195e25)
                .mul_add(t10, R::of(7.601971626924525e26));
            let q48 = t1797
                .mul_add(
                    t51,
                    R::of(-2.5353544518229414e27)
                        .mul_add(t10, R::of(-4.643752656522301e27))
                        .mul_add(
                            t31,
                            R::of(2.805070730248615e28)
                                .mul_add(t10, R::of(8.113626124133383e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.5402356580419606e29)
                                .mul_add(t10, R::of(-1.6247599598114642e30))
                                .mul_add(
                                    t31,
                                    R::of(3.6356549286368004e30)
                                        .mul_add(t10, R::of(1.3916951136100074e31)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.806381670049128e31)
                        .mul_add(t10, R::of(-6.4906065433142935e31))
                        .mul_add(
                            t31,
                            R::of(9.526541588784307e31)
                                .mul_add(t10, R::of(1.636840752410144e32)),
                        )
                        .mul_add(
                            t40,
                            R::of(-6.234511215411586e31)
                                .mul_add(t10, R::of(-6.804543668138836e31))
                                .mul_add(
                                    t31,
                                    R::of(-3.001510164424394e32)
                                        .mul_add(t10, R::of(-7.226627022104252e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.0292207027054784e31)
                                .mul_add(t10, R::of(7.930847017290302e32))
                                .mul_add(
                                    t31,
                                    R::of(1.0996616424388754e33)
                                        .mul_add(t10, R::of(1.547747405561707e33)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.2587523466075087e33)
                                        .mul_add(t10, R::of(6.976407728366026e32))
                                        .mul_add(
                                            t31,
                                            R::of(3.855150658174931e32)
                                                .mul_add(t10, R::of(7.377132543245685e31)),
                                        ),
                                ),
                        ),
                );
            let t1847 = R::of(-1.0946839142771314e26)
                .mul_add(t10, R::of(1.3683548928464143e27));
            let q49 = t1847
                .mul_add(
                    t51,
                    R::of(-5.837387801260925e27)
                        .mul_add(t10, R::of(5.415417307721585e27))
                        .mul_add(
                            t31,
                            R::of(4.677250159518881e28)
                                .mul_add(t10, R::of(-2.4569937373442494e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.917452331615392e29)
                                .mul_add(t10, R::of(1.8642668768579295e30))
                                .mul_add(
                                    t31,
                                    R::of(-5.475424365528575e30)
                                        .mul_add(t10, R::of(-5.631153058003873e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(2.8846666586345518e31)
                        .mul_add(t10, R::of(1.6043554701235924e30))
                        .mul_add(
                            t31,
                            R::of(-6.004662349398439e31)
                                .mul_add(t10, R::of(3.4961872314533167e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(-7.473954774376678e30)
                                .mul_add(t10, R::of(-9.60106969416528e31))
                                .mul_add(
                                    t31,
                                    R::of(2.1574964840214254e32)
                                        .mul_add(t10, R::of(5.969047668535944e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-3.1340704188879107e32)
                                .mul_add(t10, R::of(6.538188795705074e31))
                                .mul_add(
                                    t31,
                                    R::of(1.672773659434717e32)
                                        .mul_add(t10, R::of(1.163684765086947e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.288289085315646e32)
                                        .mul_add(t10, R::of(1.5799752177780782e32))
                                        .mul_add(
                                            t31,
                                            R::of(4.640544953677363e31)
                                                .mul_add(t10, R::of(2.382850849769471e31)),
                                        ),
                                ),
                        ),
                );
            let q50 = R::of(-1.4816269446213895e26)
                .mul_add(t10, R::of(1.8520336807767367e27))
                .mul_add(
                    t51,
                    R::of(-5.237163247743049e27)
                        .mul_add(t10, R::of(-2.2156418451257653e28))
                        .mul_add(
                            t31,
                            R::of(1.1783953887277348e29)
                                .mul_add(t10, R::of(1.1055549237616767e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.0775029255507402e30)
                                .mul_add(t10, R::of(-5.1740564623597625e29))
                                .mul_add(
                                    t31,
                                    R::of(6.21840089477581e30)
                                        .mul_add(t10, R::of(3.155493381028661e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.189134451446071e31)
                        .mul_add(t10, R::of(-1.5346187254028003e31))
                        .mul_add(
                            t31,
                            R::of(3.2662266122080185e31)
                                .mul_add(t10, R::of(3.436855360527671e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.533538075695582e31)
                                .mul_add(t10, R::of(3.221043373003901e31))
                                .mul_add(
                                    t31,
                                    R::of(-3.258917624860455e31)
                                        .mul_add(t10, R::of(-2.0855856567330127e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-3.384138384749576e32)
                                .mul_add(t10, R::of(-2.2341546827072338e31))
                                .mul_add(
                                    t31,
                                    R::of(3.8690958010329815e32)
                                        .mul_add(t10, R::of(3.498019714473239e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.83055883168404e32)
                                        .mul_add(t10, R::of(1.0974214669298588e32))
                                        .mul_add(
                                            t31,
                                            R::of(-2.13867139477063e31)
                                                .mul_add(t10, R::of(-8.236107262152591e30)),
                                        ),
                                ),
                        ),
                );
            let q51 = R::of(-1.1188670036541974e26)
                .mul_add(t10, R::of(1.3985837545677466e27))
                .mul_add(
                    t51,
                    R::of(-3.7871583136093444e27)
                        .mul_add(t10, R::of(-1.6939689984942867e28))
                        .mul_add(
                            t31,
                            R::of(7.273917035939004e28)
                                .mul_add(t10, R::of(1.761316550758101e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-8.415807838516972e29)
                                .mul_add(t10, R::of(-1.1861408338370646e30))
                                .mul_add(
                                    t31,
                                    R::of(5.838791334345554e30)
                                        .mul_add(t10, R::of(3.943874790396459e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.9614310163338871e31)
                        .mul_add(t10, R::of(-3.636985767987798e30))
                        .mul_add(
                            t31,
                            R::of(8.909898864422587e30)
                                .mul_add(t10, R::of(-1.6473121096793457e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.3377341219774792e32)
                                .mul_add(t10, R::of(6.369696119387267e31))
                                .mul_add(
                                    t31,
                                    R::of(-3.767453848707608e32)
                                        .mul_add(t10, R::of(-1.3059259841871125e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.323396162615789e32)
                                .mul_add(t10, R::of(2.6816318406517024e32))
                                .mul_add(
                                    t31,
                                    R::of(2.485933892308349e32)
                                        .mul_add(t10, R::of(4.873814501965098e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-2.8346500260149827e32)
                                        .mul_add(t10, R::of(-2.4693359637878355e32))
                                        .mul_add(
                                            t31,
                                            R::of(-8.082082165379994e31)
                                                .mul_add(t10, R::of(-4.196339121432118e31)),
                                        ),
                                ),
                        ),
                );
            let q52 = R::of(7.297892761847543e25)
                .mul_add(t10, R::of(-9.122365952309429e26))
                .mul_add(
                    t51,
                    R::of(2.3008630117709564e27)
                        .mul_add(t10, R::of(1.4517164747734693e28))
                        .mul_add(
                            t31,
                            R::of(-7.433675393139225e28)
                                .mul_add(t10, R::of(-4.520025371491615e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(7.549616368505638e29)
                                .mul_add(t10, R::of(-6.542091861489668e29))
                                .mul_add(
                                    t31,
                                    R::of(-3.0889024120815454e30)
                                        .mul_add(t10, R::of(6.098602498868598e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(7.306944731447567e29)
                        .mul_add(t10, R::of(-1.6103009914349847e31))
                        .mul_add(
                            t31,
                            R::of(3.396387249410116e31)
                                .mul_add(t10, R::of(-1.5092080152509846e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.015158305635684e32)
                                .mul_add(t10, R::of(1.6099661093273506e32))
                                .mul_add(
                                    t31,
                                    R::of(9.69273647995247e31)
                                        .mul_add(t10, R::of(-3.061247091967856e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(8.272292464083856e30)
                                .mul_add(t10, R::of(2.3909380999777416e32))
                                .mul_add(
                                    t31,
                                    R::of(-1.3619517975241197e31)
                                        .mul_add(t10, R::of(-1.4354642946451306e31)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(7.795299122032213e30)
                                        .mul_add(t10, R::of(-9.613108222583212e31))
                                        .mul_add(
                                            t31,
                                            R::of(-1.922257642293574e31)
                                                .mul_add(t10, R::of(1.0171391138261726e31)),
                                        ),
                                ),
                        ),
                );
            let q53 = t1747
                .mul_add(
                    t51,
                    R::of(-8.674827254583084e27)
                        .mul_add(t10, R::of(-5.03663062832668e28))
                        .mul_add(
                            t31,
                            R::of(2.1719467410896403e29)
                                .mul_add(t10, R::of(4.047333951081971e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.353926698745187e30)
                                .mul_add(t10, R::of(-2.2025617130438746e30))
                                .mul_add(
                                    t31,
                                    R::of(1.4497608405533747e31)
                                        .mul_add(t10, R::of(9.971368383322677e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-5.041912903885729e31)
                        .mul_add(t10, R::of(-3.942486001569493e31))
                        .mul_add(
                            t31,
                            R::of(7.520056863482931e31)
                                .mul_add(t10, R::of(9.350945149546914e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(6.260294017746369e31)
                                .mul_add(t10, R::of(6.378214277755505e30))
                                .mul_add(
                                    t31,
                                    R::of(-2.677781898357178e32)
                                        .mul_add(t10, R::of(-4.247219969670417e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.8598558534600624e32)
                                .mul_add(t10, R::of(1.6458862627189787e32))
                                .mul_add(
                                    t31,
                                    R::of(4.8485144534590696e32)
                                        .mul_add(t10, R::of(6.083629278999615e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(5.686609196163059e32)
                                        .mul_add(t10, R::of(4.118809377171926e32))
                                        .mul_add(
                                            t31,
                                            R::of(1.6172314351626966e32)
                                                .mul_add(t10, R::of(4.085253882439775e31)),
                                        ),
                                ),
                        ),
                );
            let q54 = t1797
                .mul_add(
                    t51,
                    R::of(-1.7072378683328353e27)
                        .mul_add(t10, R::of(-1.4410561479839443e28))
                        .mul_add(
                            t31,
                            R::of(5.732584595550942e28)
                                .mul_add(t10, R::of(1.5576386277292522e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-7.999802784619593e29)
                                .mul_add(t10, R::of(-1.1375896125763112e30))
                                .mul_add(
                                    t31,
                                    R::of(6.05892174006721e30)
                                        .mul_add(t10, R::of(7.628919634729803e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.56997445310219e31)
                        .mul_add(t10, R::of(-4.671661935982057e31))
                        .mul_add(
                            t31,
                            R::of(4.747533620880221e31)
                                .mul_add(t10, R::of(1.7875462654911075e32)),
                        )
                        .mul_add(
                            t40,
                            R::of(7.353141571048663e31)
                                .mul_add(t10, R::of(-2.483393522932871e32))
                                .mul_add(
                                    t31,
                                    R::of(-4.290561544229368e32)
                                        .mul_add(t10, R::of(-3.8061422084111155e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-2.9512462983740685e31)
                                .mul_add(t10, R::of(5.581629201954854e32))
                                .mul_add(
                                    t31,
                                    R::of(1.1455103064127125e33)
                                        .mul_add(t10, R::of(1.5208185069156332e33)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.231950044612936e33)
                                        .mul_add(t10, R::of(8.060236574971307e32))
                                        .mul_add(
                                            t31,
                                            R::of(4.062122594780385e32)
                                                .mul_add(t10, R::of(6.594716941013804e31)),
                                        ),
                                ),
                        ),
                );
            let q55 = t1847
                .mul_add(
                    t51,
                    R::of(-5.339053356274067e27)
                        .mul_add(t10, R::of(9.942295312550989e26))
                        .mul_add(
                            t31,
                            R::of(4.303976852059059e28)
                                .mul_add(t10, R::of(-1.1315837958745107e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(7.7181363008512685e28)
                                .mul_add(t10, R::of(6.350919274609024e29))
                                .mul_add(
                                    t31,
                                    R::of(-2.3438717777545648e30)
                                        .mul_add(t10, R::of(-1.5847879187427962e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.5029757892831165e31)
                        .mul_add(t10, R::of(3.3233255956021184e30))
                        .mul_add(
                            t31,
                            R::of(-5.8039115218183115e31)
                                .mul_add(t10, R::of(-6.676345256343488e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.4260657740100543e32)
                                .mul_add(t10, R::of(1.2498867820173153e31))
                                .mul_add(
                                    t31,
                                    R::of(-2.0016311148027433e32)
                                        .mul_add(t10, R::of(-1.0385305049934742e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.830208372902068e31)
                                .mul_add(t10, R::of(2.491285528316183e32))
                                .mul_add(
                                    t31,
                                    R::of(3.515306696006106e32)
                                        .mul_add(t10, R::of(2.6941141843601335e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.1169321276931984e32)
                                        .mul_add(t10, R::of(-1.5784443342986438e31))
                                        .mul_add(
                                            t31,
                                            R::of(-2.8333180668918916e31)
                                                .mul_add(t10, R::of(-1.28681072247036e31)),
                                        ),
                                ),
                        ),
                );
            let q56 = R::of(-1.748913155394383e26)
                .mul_add(t10, R::of(2.1861414442429787e27))
                .mul_add(
                    t51,
                    R::of(-6.403380203070876e27)
                        .mul_add(t10, R::of(-2.411140231186337e28))
                        .mul_add(
                            t31,
                            R::of(1.4227315328979477e29)
                                .mul_add(t10, R::of(6.184412541585602e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.2529749414552466e30)
                                .mul_add(t10, R::of(4.620666409345678e29))
                                .mul_add(
                                    t31,
                                    R::of(6.208510820074223e30)
                                        .mul_add(t10, R::of(-3.79582147769499e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.816472497543097e31)
                        .mul_add(t10, R::of(1.0004963102807702e31))
                        .mul_add(
                            t31,
                            R::of(2.6591543783240904e31)
                                .mul_add(t10, R::of(-6.981256459381643e30)),
                        )
                        .mul_add(
                            t40,
                            R::of(6.816295172195126e30)
                                .mul_add(t10, R::of(-2.490089694314998e30))
                                .mul_add(
                                    t31,
                                    R::of(-8.065375503684886e31)
                                        .mul_add(t10, R::of(-3.7236037603696496e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.095170994536162e31)
                                .mul_add(t10, R::of(3.482693493121806e31))
                                .mul_add(
                                    t31,
                                    R::of(1.092096906949062e32)
                                        .mul_add(t10, R::of(1.3362771070103225e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(9.537106920591543e31)
                                        .mul_add(t10, R::of(7.807943396790978e31))
                                        .mul_add(
                                            t31,
                                            R::of(3.7055828614505865e31)
                                                .mul_add(t10, R::of(6.841500645678237e30)),
                                        ),
                                ),
                        ),
                );
            let q57 = R::of(-9.323891697118312e24)
                .mul_add(t10, R::of(1.165486462139789e26))
                .mul_add(
                    t51,
                    R::of(2.335153762163085e26)
                        .mul_add(t10, R::of(-8.092497927695351e27))
                        .mul_add(
                            t31,
                            R::of(2.456424680038324e28)
                                .mul_add(t10, R::of(8.348227606834676e28)),
                        )
                        .mul_add(
                            t40,
                            R::of(-4.2761957150719124e29)
                                .mul_add(t10, R::of(-3.477414564230184e29))
                                .mul_add(
                                    t31,
                                    R::of(3.213876795240872e30)
                                        .mul_add(t10, R::of(6.322807734847335e29)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.3611863852562248e31)
                        .mul_add(t10, R::of(-5.224726544940772e29))
                        .mul_add(
                            t31,
                            R::of(3.3186087496244737e31)
                                .mul_add(t10, R::of(-1.9919702768337756e29)),
                        )
                        .mul_add(
                            t40,
                            R::of(-4.068394052695021e31)
                                .mul_add(t10, R::of(2.806766058811769e30))
                                .mul_add(
                                    t31,
                                    R::of(1.1197360404622857e31)
                                        .mul_add(t10, R::of(2.887029005457373e31)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(6.566753994543093e31)
                                .mul_add(t10, R::of(-7.9443365522708445e31))
                                .mul_add(
                                    t31,
                                    R::of(-1.6341911641307092e32)
                                        .mul_add(t10, R::of(-1.5402912570210195e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-1.8602817401333604e32)
                                        .mul_add(t10, R::of(-8.32659455991191e31))
                                        .mul_add(
                                            t31,
                                            R::of(-2.881044348939548e31)
                                                .mul_add(t10, R::of(-9.795039459455806e30)),
                                        ),
                                ),
                        ),
                );
            let q58 = R::of(1.2040448908330252e26)
                .mul_add(t10, R::of(-1.5050561135412815e27))
                .mul_add(
                    t51,
                    R::of(4.65028002363667e27)
                        .mul_add(t10, R::of(1.254587488112893e28))
                        .mul_add(
                            t31,
                            R::of(-8.247779756794758e28)
                                .mul_add(t10, R::of(6.971877386883138e27)),
                        )
                        .mul_add(
                            t40,
                            R::of(5.29286541207979e29)
                                .mul_add(t10, R::of(-6.0525162173085575e29))
                                .mul_add(
                                    t31,
                                    R::of(-1.2933560966019075e30)
                                        .mul_add(t10, R::of(4.4679985206320933e30)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.4010333515337668e30)
                        .mul_add(t10, R::of(-2.210462456494837e31))
                        .mul_add(
                            t31,
                            R::of(7.997754271901006e30)
                                .mul_add(t10, R::of(7.289905017070318e31)),
                        )
                        .mul_add(
                            t40,
                            R::of(4.583595045145751e31)
                                .mul_add(t10, R::of(-6.827847934830316e31))
                                .mul_add(
                                    t31,
                                    R::of(-2.113841397651415e32)
                                        .mul_add(t10, R::of(-2.8703312870911105e32)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-7.301786545772858e31)
                                .mul_add(t10, R::of(2.9481625345997174e32))
                                .mul_add(
                                    t31,
                                    R::of(6.098455639367284e32)
                                        .mul_add(t10, R::of(8.269331199120554e32)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(6.878515548671267e32)
                                        .mul_add(t10, R::of(4.251253241288664e32))
                                        .mul_add(
                                            t31,
                                            R::of(2.1521785054991635e32)
                                                .mul_add(t10, R::of(4.051573794062805e31)),
                                        ),
                                ),
                        ),
                );
            let q59 = ::hodograph::horner(Self::Q59.map(R::of), t10);
            OfV {
                t3: R::of(4.0) * v,
                q1,
                q2,
                q3,
                t78,
                t104,
                q6,
                t143,
                q8,
                t176,
                t180,
                t182,
                t186,
                q8_over_q3,
                q6_over_q3,
                t191,
                t195: R::of(30.0) * q3,
                t199: R::of(120.0) * v * q3,
                t201: R::of(30.0) * q1 * q3,
                t203: R::of(30.0) * q2 * q3,
                t204: R::of(30.0) * t78,
                t205: R::of(30.0) * t104,
                t206: R::of(30.0) * q6,
                t207: R::of(30.0) * t143,
                t208: R::of(30.0) * q8,
                t210: R::of(60.0) * t104,
                q9,
                q10,
                t475,
                t476,
                t477,
                t478,
                t479,
                t480,
                t483: R::of(1.8).mul_add(v, R::of(-5.4)),
                t485: R::of(3.0) - v,
                t551: (-t180).mul_add(q20, (-t475).mul_add(t546, q18)) * q3_inverse,
                t583: (-t182).mul_add(q20, (-t476).mul_add(t546, q22)) * q3_inverse,
                t615: (-t186).mul_add(q20, (-t477).mul_add(t546, q24)) * q3_inverse,
                t647: (-q8_over_q3).mul_add(q20, (-t478).mul_add(t546, q26))
                    * q3_inverse,
                t679: (-q6_over_q3).mul_add(q20, (-t479).mul_add(t546, q28))
                    * q3_inverse,
                t685: (-t191).mul_add(q20, (-t480).mul_add(t546, R::of(2.0) * q24))
                    * q3_inverse,
                q29,
                q30,
                q31,
                q32,
                q33,
                q34,
                q35,
                q36,
                q37,
                q38,
                q39,
                q40,
                q41,
                q42,
                q43,
                t1532: R::of(2.0) * q35,
                t1533: R::of(2.0) * q36,
                t1534: R::of(2.0) * q37,
                t1535: R::of(3.0) * q38,
                t1536: R::of(3.0) * q39,
                t1537: R::of(3.0) * q40,
                t1538: R::of(4.0) * q41,
                t1539: R::of(4.0) * q42,
                t1540: R::of(4.0) * q43,
                q44,
                q45,
                q46,
                q47,
                q48,
                q49,
                q50,
                q51,
                q52,
                q53,
                q54,
                q55,
                q56,
                q57,
                q58,
                t2337: q59 / (q16 * t473),
            }
        }
    }
    /// What points need of u alone.
    struct OfU<R> {
        u: R,
        p4: R,
        p1: R,
        z_numerator: R,
        z_numerator_over_p1: R,
        t181: R,
        t235: R,
        t236: R,
        t242: R,
        t243: R,
        t244: R,
        t717: R,
        t718: R,
    }
    /// What points need of v alone.
    struct OfV<R> {
        t3: R,
        q1: R,
        q2: R,
        q3: R,
        t78: R,
        t104: R,
        q6: R,
        t143: R,
        q8: R,
        t176: R,
        t180: R,
        t182: R,
        t186: R,
        q8_over_q3: R,
        q6_over_q3: R,
        t191: R,
        t195: R,
        t199: R,
        t201: R,
        t203: R,
        t204: R,
        t205: R,
        t206: R,
        t207: R,
        t208: R,
        t210: R,
        q9: R,
        q10: R,
        t475: R,
        t476: R,
        t477: R,
        t478: R,
        t479: R,
        t480: R,
        t483: R,
        t485: R,
        t551: R,
        t583: R,
        t615: R,
        t647: R,
        t679: R,
        t685: R,
        q29: R,
        q30: R,
        q31: R,
        q32: R,
        q33: R,
        q34: R,
        q35: R,
        q36: R,
        q37: R,
        q38: R,
        q39: R,
        q40: R,
        q41: R,
        q42: R,
        q43: R,
        t1532: R,
        t1533: R,
        t1534: R,
        t1535: R,
        t1536: R,
        t1537: R,
        t1538: R,
        t1539: R,
        t1540: R,
        q44: R,
        q45: R,
        q46: R,
        q47: R,
        q48: R,
        q49: R,
        q50: R,
        q51: R,
        q52: R,
        q53: R,
        q54: R,
        q55: R,
        q56: R,
        q57: R,
        q58: R,
        t2337: R,
    }
    impl ::hodograph::Stages<::hodograph::Homogeneous> for FramesGutter3 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 3];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 10];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 3] {
            let values = Self::values_of_u(u);
            [values.u, values.p1, values.z_numerator]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 10] {
            let values = Self::values_of_v(v);
            [
                values.t195,
                values.t199,
                values.t201,
                values.t203,
                values.t204,
                values.t205,
                values.t206,
                values.t207,
                values.t208,
                values.t210,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 3], of_v: [R; 10]) -> [R; 4] {
            let [u, p1, z_numerator] = of_u;
            let [t195, t199, t201, t203, t204, t205, t206, t207, t208, t210] = of_v;
            let t213 = -z_numerator;
            [
                p1 * t195,
                t213.mul_add(t204, u.mul_add(t207, p1 * t199)),
                t213.mul_add(t205, u.mul_add(t208, p1 * t201)),
                t213.mul_add(t206, u.mul_add(t210, p1 * t203)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Point> for FramesGutter3 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 3];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 10];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 3] {
            let values = Self::values_of_u(u);
            [values.u, values.p1, values.z_numerator]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 10] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.q3,
                values.t78,
                values.t104,
                values.q6,
                values.t143,
                values.q8,
                values.t176,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 3], of_v: [R; 10]) -> [R; 3] {
            let [u, p1, z_numerator] = of_u;
            let [t3, q1, q2, q3, t78, t104, q6, t143, q8, t176] = of_v;
            let weight_inverse = R::of(1.0) / (p1 * q3);
            let t224 = u * weight_inverse;
            let t226 = -(z_numerator * weight_inverse);
            [
                t226.mul_add(t78, t224.mul_add(t143, t3)),
                t226.mul_add(t104, t224.mul_add(q8, q1)),
                t226.mul_add(q6, t224.mul_add(t176, q2)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Separated> for FramesGutter3 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 2];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 9];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 2] {
            let values = Self::values_of_u(u);
            [values.z_numerator_over_p1, values.t181]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 9] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t180,
                values.t182,
                values.t186,
                values.q8_over_q3,
                values.q6_over_q3,
                values.t191,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 2], of_v: [R; 9]) -> [R; 3] {
            let [z_numerator_over_p1, t181] = of_u;
            let [t3, q1, q2, t180, t182, t186, q8_over_q3, q6_over_q3, t191] = of_v;
            let t184 = -z_numerator_over_p1;
            [
                t184.mul_add(t180, t181.mul_add(t182, t3)),
                t184.mul_add(t186, t181.mul_add(q8_over_q3, q1)),
                t184.mul_add(q6_over_q3, t181.mul_add(t191, q2)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::First> for FramesGutter3 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 4];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 17];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 4] {
            let values = Self::values_of_u(u);
            [values.z_numerator_over_p1, values.t181, values.t235, values.t236]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 17] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t180,
                values.t182,
                values.t186,
                values.q8_over_q3,
                values.q6_over_q3,
                values.t191,
                values.q9,
                values.q10,
                values.t475,
                values.t476,
                values.t477,
                values.t478,
                values.t479,
                values.t480,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 4], of_v: [R; 17]) -> [R; 9] {
            let [z_numerator_over_p1, t181, t235, t236] = of_u;
            let [t3, q1, q2, t180, t182, t186, q8_over_q3, q6_over_q3, t191, q9, q10,
            t475, t476, t477, t478, t479, t480] = of_v;
            let t184 = -z_numerator_over_p1;
            let t687 = -t236;
            [
                t184.mul_add(t180, t181.mul_add(t182, t3)),
                t184.mul_add(t186, t181.mul_add(q8_over_q3, q1)),
                t184.mul_add(q6_over_q3, t181.mul_add(t191, q2)),
                t687.mul_add(t182, t235 * t180),
                t687.mul_add(q8_over_q3, t235 * t186),
                t687.mul_add(t191, t235 * q6_over_q3),
                t184.mul_add(t475, t181.mul_add(t476, R::of(4.0))),
                t184.mul_add(t477, t181.mul_add(t478, q9)),
                t184.mul_add(t479, t181.mul_add(t480, q10)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Second> for FramesGutter3 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 6];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 25];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 6] {
            let values = Self::values_of_u(u);
            [
                values.z_numerator_over_p1,
                values.t181,
                values.t235,
                values.t236,
                values.t243,
                values.t244,
            ]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 25] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t180,
                values.t182,
                values.t186,
                values.q8_over_q3,
                values.q6_over_q3,
                values.t191,
                values.q9,
                values.q10,
                values.t475,
                values.t476,
                values.t477,
                values.t478,
                values.t479,
                values.t480,
                values.t483,
                values.t485,
                values.t551,
                values.t583,
                values.t615,
                values.t647,
                values.t679,
                values.t685,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 6], of_v: [R; 25]) -> [R; 18] {
            let [z_numerator_over_p1, t181, t235, t236, t243, t244] = of_u;
            let [t3, q1, q2, t180, t182, t186, q8_over_q3, q6_over_q3, t191, q9, q10,
            t475, t476, t477, t478, t479, t480, t483, t485, t551, t583, t615, t647, t679,
            t685] = of_v;
            let t184 = -z_numerator_over_p1;
            let t687 = -t236;
            [
                t184.mul_add(t180, t181.mul_add(t182, t3)),
                t184.mul_add(t186, t181.mul_add(q8_over_q3, q1)),
                t184.mul_add(q6_over_q3, t181.mul_add(t191, q2)),
                t687.mul_add(t182, t235 * t180),
                t687.mul_add(q8_over_q3, t235 * t186),
                t687.mul_add(t191, t235 * q6_over_q3),
                t184.mul_add(t475, t181.mul_add(t476, R::of(4.0))),
                t184.mul_add(t477, t181.mul_add(t478, q9)),
                t184.mul_add(t479, t181.mul_add(t480, q10)),
                t244.mul_add(t182, t243 * t180),
                t244.mul_add(q8_over_q3, t243 * t186),
                t244.mul_add(t191, t243 * q6_over_q3),
                t687.mul_add(t476, t235 * t475),
                t687.mul_add(t478, t235 * t477),
                t687.mul_add(t480, t235 * t479),
                t184.mul_add(t551, t181 * t583),
                t184.mul_add(t615, t181.mul_add(t647, t483)),
                t184.mul_add(t679, t181.mul_add(t685, t485)),
            ]
        }
    }
    impl ::hodograph::Stages<::hodograph::Normal> for FramesGutter3 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 4];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 15];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 4] {
            let values = Self::values_of_u(u);
            [values.u, values.p4, values.t717, values.t718]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 15] {
            let values = Self::values_of_v(v);
            [
                values.q29,
                values.q30,
                values.q31,
                values.q32,
                values.q33,
                values.q34,
                values.q35,
                values.q36,
                values.q37,
                values.q38,
                values.q39,
                values.q40,
                values.q41,
                values.q42,
                values.q43,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 4], of_v: [R; 15]) -> [R; 3] {
            let [u, p4, t717, t718] = of_u;
            let [q29, q30, q31, q32, q33, q34, q35, q36, q37, q38, q39, q40, q41, q42,
            q43] = of_v;
            let t1511 = t718
                .mul_add(q41, t717.mul_add(q38, p4.mul_add(q35, u.mul_add(q32, q29))));
            let t1515 = t718
                .mul_add(q42, t717.mul_add(q39, p4.mul_add(q36, u.mul_add(q33, q30))));
            let t1519 = t718
                .mul_add(q43, t717.mul_add(q40, p4.mul_add(q37, u.mul_add(q34, q31))));
            let t1520 = R::scale(t1511, t1515, t1519);
            let t1521 = t1511 * t1520;
            let t1522 = t1515 * t1520;
            let t1523 = t1519 * t1520;
            let t1528 = R::of(1.0)
                / t1523.mul_add(t1523, t1522.mul_add(t1522, t1521 * t1521)).sqrt();
            [t1521 * t1528, t1522 * t1528, t1523 * t1528]
        }
    }
    impl ::hodograph::Stages<::hodograph::Local> for FramesGutter3 {
        type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; 11];
        type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; 65];
        #[inline(always)]
        fn of_u<R: ::hodograph::Real>(&self, u: R) -> [R; 11] {
            let values = Self::values_of_u(u);
            [
                values.u,
                values.p4,
                values.z_numerator_over_p1,
                values.t181,
                values.t235,
                values.t236,
                values.t242,
                values.t243,
                values.t244,
                values.t717,
                values.t718,
            ]
        }
        #[inline(always)]
        fn of_v<R: ::hodograph::Real>(&self, v: R) -> [R; 65] {
            let values = Self::values_of_v(v);
            [
                values.t3,
                values.q1,
                values.q2,
                values.t180,
                values.t182,
                values.t186,
                values.q8_over_q3,
                values.q6_over_q3,
                values.t191,
                values.q9,
                values.q10,
                values.t475,
                values.t476,
                values.t477,
                values.t478,
                values.t479,
                values.t480,
                values.t483,
                values.t485,
                values.t551,
                values.t583,
                values.t615,
                values.t647,
                values.t679,
                values.t685,
                values.q29,
                values.q30,
                values.q31,
                values.q32,
                values.q33,
                values.q34,
                values.q35,
                values.q36,
                values.q37,
                values.q38,
                values.q39,
                values.q40,
                values.q41,
                values.q42,
                values.q43,
                values.t1532,
                values.t1533,
                values.t1534,
                values.t1535,
                values.t1536,
                values.t1537,
                values.t1538,
                values.t1539,
                values.t1540,
                values.q44,
                values.q45,
                values.q46,
                values.q47,
                values.q48,
                values.q49,
                values.q50,
                values.q51,
                values.q52,
                values.q53,
                values.q54,
                values.q55,
                values.q56,
                values.q57,
                values.q58,
                values.t2337,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 11], of_v: [R; 65]) -> [R; 39] {
            let [u, p4, z_numerator_over_p1, t181, t235, t236, t242, t243, t244, t717,
            t718] = of_u;
            let [t3, q1, q2, t180, t182, t186, q8_over_q3, q6_over_q3, t191, q9, q10,
            t475, t476, t477, t478, t479, t480, t483, t485, t551, t583, t615, t647, t679,
            t685, q29, q30, q31, q32, q33, q34, q35, q36, q37, q38, q39, q40, q41, q42,
            q43, t1532, t1533, t1534, t1535, t1536, t1537, t1538, t1539, t1540, q44, q45,
            q46, q47, q48, q49, q50, q51, q52, q53, q54, q55, q56, q57, q58, t2337] = of_v;
            let t184 = -z_numerator_over_p1;
            let t687 = -t236;
            let t688 = t687.mul_add(t182, t235 * t180);
            let t690 = t687.mul_add(q8_over_q3, t235 * t186);
            let t692 = t687.mul_add(t191, t235 * q6_over_q3);
            let t694 = t184.mul_add(t475, t181.mul_add(t476, R::of(4.0)));
            let t696 = t184.mul_add(t477, t181.mul_add(t478, q9));
            let t698 = t184.mul_add(t479, t181.mul_add(t480, q10));
            let t1511 = t718
                .mul_add(q41, t717.mul_add(q38, p4.mul_add(q35, u.mul_add(q32, q29))));
            let t1515 = t718
                .mul_add(q42, t717.mul_add(q39, p4.mul_add(q36, u.mul_add(q33, q30))));
            let t1519 = t718
                .mul_add(q43, t717.mul_add(q40, p4.mul_add(q37, u.mul_add(q34, q31))));
            let t1520 = R::scale(t1511, t1515, t1519);
            let t1521 = t1511 * t1520;
            let t1522 = t1515 * t1520;
            let t1523 = t1519 * t1520;
            let t1527 = t1523.mul_add(t1523, t1522.mul_add(t1522, t1521 * t1521)).sqrt();
            let t1528 = R::of(1.0) / t1527;
            let t1529 = t1521 * t1528;
            let t1530 = t1522 * t1528;
            let t1531 = t1523 * t1528;
            let t1543 = t717.mul_add(t1538, p4.mul_add(t1535, u.mul_add(t1532, q32)));
            let t1546 = t717.mul_add(t1539, p4.mul_add(t1536, u.mul_add(t1533, q33)));
            let t1549 = t717.mul_add(t1540, p4.mul_add(t1537, u.mul_add(t1534, q34)));
            let t2294 = t718
                .mul_add(q56, t717.mul_add(q53, p4.mul_add(q50, u.mul_add(q47, q44))));
            let t2298 = t718
                .mul_add(q57, t717.mul_add(q54, p4.mul_add(q51, u.mul_add(q48, q45))));
            let t2302 = t718
                .mul_add(q58, t717.mul_add(q55, p4.mul_add(q52, u.mul_add(q49, q46))));
            let t2303 = t1520 * t1528;
            let t2307 = t692.mul_add(t692, t690.mul_add(t690, t688 * t688));
            let t2310 = t692.mul_add(t698, t690.mul_add(t696, t688 * t694));
            let t2313 = t698.mul_add(t698, t696.mul_add(t696, t694 * t694));
            let t2318 = -(t1549.mul_add(t692, t1546.mul_add(t690, t1543 * t688))
                * t2303);
            let t2328 = -(t2302.mul_add(t692, t2298.mul_add(t690, t2294 * t688))
                * t2303);
            let area = t242 * t2337;
            let t2341 = (-t1531).mul_add(t690, t1530 * t692);
            let t2344 = (-t1529).mul_add(t692, t1531 * t688);
            let t2347 = (-t1530).mul_add(t688, t1529 * t690);
            let t2352 = t2302.mul_add(t2347, t2298.mul_add(t2344, t2294 * t2341))
                * t2303;
            let t2354 = R::of(1.0) / t2307;
            let t2360 = t2318 * t2354;
            let t2361 = -(t1549.mul_add(t2347, t1546.mul_add(t2344, t1543 * t2341))
                * t2303) * t2354;
            let t2364 = -t2310.mul_add(t2361, t2352) / (area * (t1527 / t1520));
            let t2365 = -t2352 * t2354;
            let t2366 = t2328 * t2354;
            let t2387 = t2318.mul_add(t2354, t2364);
            let t2394 = R::of(0.5) * t2318.mul_add(t2354, -t2364);
            let t2397 = t2361.mul_add(t2361, t2394 * t2394).sqrt();
            [
                t184.mul_add(t180, t181.mul_add(t182, t3)),
                t184.mul_add(t186, t181.mul_add(q8_over_q3, q1)),
                t184.mul_add(q6_over_q3, t181.mul_add(t191, q2)),
                t688,
                t690,
                t692,
                t694,
                t696,
                t698,
                t244.mul_add(t182, t243 * t180),
                t244.mul_add(q8_over_q3, t243 * t186),
                t244.mul_add(t191, t243 * q6_over_q3),
                t687.mul_add(t476, t235 * t475),
                t687.mul_add(t478, t235 * t477),
                t687.mul_add(t480, t235 * t479),
                t184.mul_add(t551, t181 * t583),
                t184.mul_add(t615, t181.mul_add(t647, t483)),
                t184.mul_add(t679, t181.mul_add(t685, t485)),
                t1529,
                t1530,
                t1531,
                t2307,
                t2310,
                t2313,
                t2318,
                t2328,
                -(t2302.mul_add(t698, t2298.mul_add(t696, t2294 * t694)) * t2303),
                (-t2361).mul_add(t2361, t2360 * t2364),
                R::of(0.5) * t2387,
                R::of(0.5).mul_add(t2387, t2397),
                R::of(0.5).mul_add(t2387, -t2397),
                t2307.sqrt(),
                t2313.sqrt(),
                -t2361.mul_add(t2341, t2360 * t688),
                -t2361.mul_add(t2344, t2360 * t690),
                -t2361.mul_add(t2347, t2360 * t692),
                -t2365.mul_add(t2341, t2366 * t688),
                -t2365.mul_add(t2344, t2366 * t690),
                -t2365.mul_add(t2347, t2366 * t692),
            ]
        }
    }
    impl ::hodograph::Sweep for FramesGutter3 {}
    impl ::hodograph::Patch for FramesGutter3 {
        fn name(&self) -> &str {
            Self::NAME
        }
        fn degree(&self) -> (u32, u32) {
            Self::DEGREE
        }
        fn domain(&self) -> ::hodograph::Domain {
            Self::DOMAIN
        }
        fn control_net(&self) -> &[[f64; 4]] {
            &Self::CONTROL_NET
        }
        fn bounds(&self) -> ::core::option::Option<&::hodograph::Bounds> {
            ::core::option::Option::Some(&Self::BOUNDS)
        }
    }
}
/// A gutter: half a circle that goes downhill through four frames, turns to both sides and is wider in the middle.
///
/// Position, orientation and size are C2 cubic splines through the frames; that of the orientation is in the 4-space that Euler's map M folds
/// onto the sphere of unit quaternions, with rational points for the rational frames.
///
/// ```text
/// profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));
/// frames F(v) = frames_file("gutter.json");
/// surface R = F.sweep(c);
/// domain u in -1..1;
/// ```
///
/// Source: `JW (1)`.
///
/// It consists of 3 pieces:
///
/// | piece | v | degree |
/// | --- | --- | --- |
/// | [`frames_gutter_1`](super::frames_gutter_1) | from 0.0 to 1.0 | (2, 15) |
/// | [`frames_gutter_2`](super::frames_gutter_2) | from 1.0 to 2.0 | (2, 15) |
/// | [`frames_gutter_3`](super::frames_gutter_3) | from 2.0 to 3.0 | (2, 15) |
///
/// They meet exactly. The points that two neighbors compute at a joint differ by 6.990000000000001e-15 at most in `f64` plain, 5.720000000000001e-15 fused, 3.9300000000000005e-6 in `f32` plain, 3.2500000000000006e-6 fused.
///
/// | error at most | `f64` plain | fused | `f32` plain | fused | size from | to | each, `f64` plain | relative |
/// | --- | --- | --- | --- | --- | --- | --- | --- | --- |
/// | homogeneous | 7.17e2 | 6.19e2 | 3.86e11 | 3.33e11 | 5.9e17 | 6.76e17 | 8.88e1, 7.17e2, 1.62e2, 2.54e2 | 1.02e-15, –, –, – |
/// | point | 3.94e-15 | 2.97e-15 | 2.36e-6 | 1.84e-6 | 1.24e1 | 1.26e1 | 3.11e-15, 3.29e-15, 3.94e-15 | –, –, – |
/// | separated point | 4.06e-15 | 3.03e-15 | 2.42e-6 | 1.87e-6 | 1.24e1 | 1.26e1 | 3.01e-15, 3.19e-15, 4.06e-15 | –, –, – |
/// | partial u | 6.35e-15 | 5.62e-15 | 3.57e-6 | 3.06e-6 | 2.83e0 | 3.14e0 | 3.24e-15, 6.35e-15, 6.02e-15 | –, –, – |
/// | partial v | 3.66e-15 | 3.11e-15 | 1.96e-6 | 1.67e-6 | 4.92e0 | 5e0 | 3.66e-15, 2.96e-15, 2.7e-15 | 9.25e-16, –, – |
/// | partial uu | 1.88e-14 | 1.55e-14 | 1.11e-5 | 9.28e-6 | 5.81e0 | 6.58e0 | 5.79e-15, 1.28e-14, 1.88e-14 | –, –, – |
/// | partial uv | 5.51e-15 | 5.13e-15 | 2.95e-6 | 2.74e-6 | 2.14e0 | 2.61e0 | 5.47e-15, 4.78e-15, 5.51e-15 | –, –, – |
/// | partial vv | 2.05e-14 | 1.85e-14 | 1.15e-5 | 1.03e-5 | 4.27e0 | 4.57e0 | 1.33e-14, 1.73e-14, 2.05e-14 | –, –, – |
/// | unit normal | 6.42e-15 | 5.34e-15 | 3.48e-6 | 2.89e-6 | 9.62e-1 | 1e0 | 2.42e-15, 6.42e-15, 4.07e-15 | –, –, – |
/// | first form | 5.2e-14 | 4.56e-14 | 2.85e-5 | 2.5e-5 | 2.92e1 | 3e1 | 5.2e-14, 3.49e-14, 5.07e-14 | 1.07e-14, –, 2.53e-15 |
/// | second form | 5.04e-14 | 4.55e-14 | 2.74e-5 | 2.5e-5 | 5.75e0 | 7.99e0 | 5.01e-14, 4.68e-14, 5.04e-14 | 1.73e-14, –, – |
/// | gaussian | 1.55e-13 | 1.39e-13 | 8.41e-5 | 7.56e-5 | 9.1e-2 | 2.49e0 | 1.55e-13 | – |
/// | mean | 3.4e-14 | 3.05e-14 | 1.86e-5 | 1.66e-5 | 4.43e-1 | 1.33e0 | 3.4e-14 | – |
/// | principal | 8.31e-14 | 7.45e-14 | 4.52e-5 | 4.06e-5 | 8.28e-1 | 2.92e0 | 8.3e-14, 8.31e-14 | –, – |
/// | speeds | 8.52e-15 | 7.69e-15 | 4.67e-6 | 4.24e-6 | 5.39e0 | 5.48e0 | 8.52e-15, 5.6e-15 | 4.53e-15, 1.34e-15 |
/// | normal u | 1.37e-13 | 1.24e-13 | 7.41e-5 | 6.73e-5 | 1.8e0 | 5.02e0 | 1.37e-13, 1.18e-13, 7.75e-14 | –, –, – |
/// | normal v | 1.58e-13 | 1.41e-13 | 8.52e-5 | 7.58e-5 | 5.89e-1 | 3.78e0 | 1.58e-13, 1.16e-13, 7.77e-14 | –, –, – |
#[allow(
    clippy::approx_constant,
    clippy::doc_markdown,
    clippy::excessive_precision,
    clippy::float_cmp,
    clippy::many_single_char_names,
    clippy::missing_const_for_fn,
    clippy::possible_missing_comma,
    clippy::similar_names,
    clippy::suboptimal_flops,
    clippy::trivially_copy_pass_by_ref,
    clippy::unreadable_literal,
    clippy::unused_self
)]
pub mod frames_gutter {
    /// The pieces of the surface `frames_gutter`.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct FramesGutterPieces;
    /// The surface `frames_gutter`.
    pub type FramesGutter = ::hodograph::Piecewise<FramesGutterPieces>;
    /// The surface `frames_gutter` as a value.
    #[allow(non_upper_case_globals)]
    pub const FramesGutter: FramesGutter = ::hodograph::Piecewise::NEW;
    impl ::hodograph::Pieces for FramesGutterPieces {
        const NAME: &'static str = "frames_gutter";
        const DEGREE: (u32, u32) = (2, 15);
        const DOMAIN: ::hodograph::Domain = ::hodograph::Domain {
            u: [-1.0, 1.0],
            v: [0.0, 3.0],
        };
        const JOINTS: &'static [f64] = &[1.0, 2.0];
        const BOUNDS: ::core::option::Option<&'static ::hodograph::Bounds> = ::core::option::Option::Some(
            &::hodograph::Bounds {
                homogeneous: ::hodograph::Bound {
                    errors: [717.0, 619.0, 386000000000.0, 333000000000.0],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 5.9e17,
                    most: 6.76e17,
                },
                point: ::hodograph::Bound {
                    errors: [3.94e-15, 2.97e-15, 2.36e-6, 1.84e-6],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 12.4,
                    most: 12.6,
                },
                coordinates: [
                    [3.11e-15, 2.94e-15, 1.7e-6, 1.61e-6],
                    [3.29e-15, 2.86e-15, 1.81e-6, 1.57e-6],
                    [3.94e-15, 2.97e-15, 2.36e-6, 1.84e-6],
                ],
                separated_point: ::hodograph::Bound {
                    errors: [4.06e-15, 3.03e-15, 2.42e-6, 1.87e-6],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 12.4,
                    most: 12.6,
                },
                partial_u: ::hodograph::Bound {
                    errors: [6.35e-15, 5.62e-15, 3.57e-6, 3.06e-6],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 2.83,
                    most: 3.14,
                },
                partial_v: ::hodograph::Bound {
                    errors: [3.66e-15, 3.11e-15, 1.96e-6, 1.67e-6],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 4.92,
                    most: 5.0,
                },
                partial_uu: ::hodograph::Bound {
                    errors: [1.88e-14, 1.55e-14, 1.11e-5, 9.28e-6],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 5.81,
                    most: 6.58,
                },
                partial_uv: ::hodograph::Bound {
                    errors: [5.51e-15, 5.13e-15, 2.95e-6, 2.74e-6],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 2.14,
                    most: 2.61,
                },
                partial_vv: ::hodograph::Bound {
                    errors: [2.05e-14, 1.85e-14, 1.15e-5, 1.03e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 4.27,
                    most: 4.57,
                },
                unit_normal: ::hodograph::Bound {
                    errors: [6.42e-15, 5.34e-15, 3.48e-6, 2.89e-6],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 0.962,
                    most: 1.0,
                },
                first_form: ::hodograph::Bound {
                    errors: [5.2e-14, 4.56e-14, 2.85e-5, 2.5e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 29.2,
                    most: 30.0,
                },
                second_form: ::hodograph::Bound {
                    errors: [5.04e-14, 4.55e-14, 2.74e-5, 2.5e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 5.75,
                    most: 7.99,
                },
                gaussian: ::hodograph::Bound {
                    errors: [1.55e-13, 1.39e-13, 8.41e-5, 7.56e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 0.091,
                    most: 2.49,
                },
                mean: ::hodograph::Bound {
                    errors: [3.4e-14, 3.05e-14, 1.86e-5, 1.66e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 0.443,
                    most: 1.33,
                },
                principal: ::hodograph::Bound {
                    errors: [8.31e-14, 7.45e-14, 4.52e-5, 4.06e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 0.828,
                    most: 2.92,
                },
                speeds: ::hodograph::Bound {
                    errors: [8.52e-15, 7.69e-15, 4.67e-6, 4.24e-6],
                    relative_errors: [4.53e-15, 3.66e-15, 2.65e-6, 2.18e-6],
                    size: 5.39,
                    most: 5.48,
                },
                normal_u: ::hodograph::Bound {
                    errors: [1.37e-13, 1.24e-13, 7.41e-5, 6.73e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 1.8,
                    most: 5.02,
                },
                normal_v: ::hodograph::Bound {
                    errors: [1.58e-13, 1.41e-13, 8.52e-5, 7.58e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 0.589,
                    most: 3.78,
                },
            },
        );
        const JUMPS: [f64; 4] = [
            6.990000000000001e-15,
            5.720000000000001e-15,
            3.9300000000000005e-6,
            3.2500000000000006e-6,
        ];
        fn visit<V: ::hodograph::Visitor>(piece: usize, visitor: V) -> V::Output {
            match piece {
                0 => visitor.visit(super::frames_gutter_1::FramesGutter1),
                1 => visitor.visit(super::frames_gutter_2::FramesGutter2),
                _ => visitor.visit(super::frames_gutter_3::FramesGutter3),
            }
        }
    }
}
