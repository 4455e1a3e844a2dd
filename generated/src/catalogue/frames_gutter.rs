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
            let q30 = R::of(2.4382163910707614e-9)
                .mul_add(
                    t28,
                    R::of(3.16968130839199e-8).mul_add(t21, R::of(1.1078719998229073e-7)),
                )
                .mul_add(
                    t48,
                    R::of(-2.3353183554739368e-7)
                        .mul_add(t21, R::of(-2.1804541823227222e-6))
                        .mul_add(
                            t28,
                            R::of(-1.5851867432288827e-6)
                                .mul_add(t21, R::of(1.70360219050936e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(3.2845808559954784e-5)
                                .mul_add(t21, R::of(-7.677642167875443e-5))
                                .mul_add(
                                    t28,
                                    R::of(-0.00023493615550845482)
                                        .mul_add(t21, R::of(0.000249772217112708)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.0009123825233262918)
                        .mul_add(t21, R::of(-0.0008084141714485072))
                        .mul_add(
                            t28,
                            R::of(-0.0015151346029842984)
                                .mul_add(t21, R::of(0.0020943877973501803)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.0015262198535388853)
                                .mul_add(t21, R::of(0.0002644416059439978))
                                .mul_add(
                                    t28,
                                    R::of(0.005446211926063916)
                                        .mul_add(t21, R::of(-0.010109720049775629)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.009063633318013273)
                                .mul_add(t21, R::of(-0.007023863460383614))
                                .mul_add(
                                    t28,
                                    R::of(0.007119140643179605)
                                        .mul_add(t21, R::of(-0.005854502104167529)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.004353511917940761)
                                        .mul_add(t21, R::of(-0.008594102509188935))
                                        .mul_add(
                                            t28,
                                            R::of(0.001087738179035714)
                                                .mul_add(t21, R::of(-0.0043371783457931525)),
                                        ),
                                ),
                        ),
                );
            let q31 = R::of(1.7957162217703681e-9)
                .mul_add(
                    t28,
                    R::of(2.3344310883014784e-8)
                        .mul_add(t21, R::of(8.914567112926581e-8)),
                )
                .mul_add(
                    t48,
                    R::of(-4.219664039795696e-8)
                        .mul_add(t21, R::of(-1.0047637662855335e-6))
                        .mul_add(
                            t28,
                            R::of(-2.1958141869583735e-6)
                                .mul_add(t21, R::of(-8.056564996785511e-7)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.651457239856387e-5)
                                .mul_add(t21, R::of(6.827569831274586e-5))
                                .mul_add(
                                    t28,
                                    R::of(-2.720431243672462e-5)
                                        .mul_add(t21, R::of(-0.0004782029920662271)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.00012418432408460906)
                        .mul_add(t21, R::of(0.0015439083192758728))
                        .mul_add(
                            t28,
                            R::of(0.0006561601993573765)
                                .mul_add(t21, R::of(-0.002154785190426935)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.0014131581805786734)
                                .mul_add(t21, R::of(0.0005913482588232))
                                .mul_add(
                                    t28,
                                    R::of(-0.0010960223457542706)
                                        .mul_add(t21, R::of(0.002994869277462675)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.012794130983452098)
                                .mul_add(t21, R::of(-0.020872821171016416))
                                .mul_add(
                                    t28,
                                    R::of(0.02123055061653203)
                                        .mul_add(t21, R::of(-0.029257508185764197)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.014035975344674712)
                                        .mul_add(t21, R::of(-0.0063285270330790365))
                                        .mul_add(
                                            t28,
                                            R::of(0.004108988911042967)
                                                .mul_add(t21, R::of(0.0029446854350733726)),
                                        ),
                                ),
                        ),
                );
            let q32 = R::of(-2.2160834185864894e-9)
                .mul_add(
                    t28,
                    R::of(-2.880908444162436e-8)
                        .mul_add(t21, R::of(-8.581995713090685e-8)),
                )
                .mul_add(
                    t48,
                    R::of(3.3730298889591064e-7)
                        .mul_add(t21, R::of(2.022660193934985e-6))
                        .mul_add(
                            t28,
                            R::of(-9.129219699252539e-8)
                                .mul_add(t21, R::of(-1.5248702284951559e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-2.1220054941065152e-5)
                                .mul_add(t21, R::of(3.551433405499385e-5))
                                .mul_add(
                                    t28,
                                    R::of(0.00020201252192804546)
                                        .mul_add(t21, R::of(0.00015846298938575773)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.0011453831497939854)
                        .mul_add(t21, R::of(-0.0008092643041334988))
                        .mul_add(
                            t28,
                            R::of(0.004181818801977192)
                                .mul_add(t21, R::of(-0.002121503885009933)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.004149764618451807)
                                .mul_add(t21, R::of(0.015651057605536676))
                                .mul_add(
                                    t28,
                                    R::of(-0.02541666751819266)
                                        .mul_add(t21, R::of(0.006802402407634469)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.03178820796154798)
                                .mul_add(t21, R::of(-0.0775430782880876))
                                .mul_add(
                                    t28,
                                    R::of(0.12880470161429836)
                                        .mul_add(t21, R::of(-0.13328493369640287)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.11020759925294127)
                                        .mul_add(t21, R::of(-0.08389067456535365))
                                        .mul_add(
                                            t28,
                                            R::of(0.030876278183930777)
                                                .mul_add(t21, R::of(-0.019141725690089723)),
                                        ),
                                ),
                        ),
                );
            let q33 = R::of(8.182586796411309e-9)
                .mul_add(
                    t28,
                    R::of(1.0637362835334702e-7)
                        .mul_add(t21, R::of(2.7083031756597464e-7)),
                )
                .mul_add(
                    t48,
                    R::of(-1.795802108792626e-6)
                        .mul_add(t21, R::of(-8.140990835571719e-6))
                        .mul_add(
                            t28,
                            R::of(1.4142140240014833e-5)
                                .mul_add(t21, R::of(9.330684566961782e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-7.898343450481537e-5)
                                .mul_add(t21, R::of(-0.0006126850558256952))
                                .mul_add(
                                    t28,
                                    R::of(0.0004237009424171437)
                                        .mul_add(t21, R::of(0.0023541109206326716)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.0020194900763663946)
                        .mul_add(t21, R::of(-0.0039044936492219685))
                        .mul_add(
                            t28,
                            R::of(0.005658515262934784)
                                .mul_add(t21, R::of(-0.004753159608307306)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.00037628397214983463)
                                .mul_add(t21, R::of(0.02208090606383937))
                                .mul_add(
                                    t28,
                                    R::of(-0.03393436321385234)
                                        .mul_add(t21, R::of(0.016455345916228232)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.014136376823975097)
                                .mul_add(t21, R::of(-0.061349351886324226))
                                .mul_add(
                                    t28,
                                    R::of(0.0972143800323695)
                                        .mul_add(t21, R::of(-0.11000458258544032)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.10499820689502155)
                                        .mul_add(t21, R::of(-0.06296945714031002))
                                        .mul_add(
                                            t28,
                                            R::of(0.031611660064203656)
                                                .mul_add(t21, R::of(-0.013884673200906443)),
                                        ),
                                ),
                        ),
                );
            let q34 = R::of(-1.801952589867827e-9)
                .mul_add(
                    t28,
                    R::of(-2.342538366828175e-8)
                        .mul_add(t21, R::of(-7.141382685510117e-8)),
                )
                .mul_add(
                    t48,
                    R::of(2.782150154043227e-7)
                        .mul_add(t21, R::of(1.341750626934598e-6))
                        .mul_add(
                            t28,
                            R::of(-4.3678937321261375e-6)
                                .mul_add(t21, R::of(-1.932865910329764e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(5.867114235849918e-5)
                                .mul_add(t21, R::of(0.00021676795409609104))
                                .mul_add(
                                    t28,
                                    R::of(-0.0004735563687909107)
                                        .mul_add(t21, R::of(-0.0013475652647552464)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.0026875825334362904)
                        .mul_add(t21, R::of(0.0037941447671009836))
                        .mul_add(
                            t28,
                            R::of(-0.009946562484480713)
                                .mul_add(t21, R::of(0.0017309135544429166)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.01327774115516946)
                                .mul_add(t21, R::of(-0.030125778147312102))
                                .mul_add(
                                    t28,
                                    R::of(0.03931090907979446)
                                        .mul_add(t21, R::of(-0.004394372763214388)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.06392045280939976)
                                .mul_add(t21, R::of(0.14576984054920863))
                                .mul_add(
                                    t28,
                                    R::of(-0.23842273737906072)
                                        .mul_add(t21, R::of(0.24138141934320043)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.2044116056142426)
                                        .mul_add(t21, R::of(0.15609578266443191))
                                        .mul_add(
                                            t28,
                                            R::of(-0.05172136500890292)
                                                .mul_add(t21, R::of(0.037128127099301224)),
                                        ),
                                ),
                        ),
                );
            let q35 = R::of(3.2435146617620884e-9)
                .mul_add(
                    t28,
                    R::of(4.216569060290715e-8).mul_add(t21, R::of(1.813748500371544e-7)),
                )
                .mul_add(
                    t48,
                    R::of(1.2585439358474865e-7)
                        .mul_add(t21, R::of(-1.5738163931922103e-6))
                        .mul_add(
                            t28,
                            R::of(-7.016189091270546e-6)
                                .mul_add(t21, R::of(-7.948205538303868e-6)),
                        )
                        .mul_add(
                            t37,
                            R::of(5.216321837848332e-5)
                                .mul_add(t21, R::of(0.00016763674230290237))
                                .mul_add(
                                    t28,
                                    R::of(-0.0001564965857773468)
                                        .mul_add(t21, R::of(-0.0009561683887554473)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.00012369000467357514)
                        .mul_add(t21, R::of(0.0026700513775270176))
                        .mul_add(
                            t28,
                            R::of(0.0007987207001246597)
                                .mul_add(t21, R::of(-0.004400887974248357)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.004145539774388662)
                                .mul_add(t21, R::of(0.007911333733038763))
                                .mul_add(
                                    t28,
                                    R::of(-0.0005588703187640208)
                                        .mul_add(t21, R::of(-0.006617154459858617)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.03067346354149118)
                                .mul_add(t21, R::of(-0.041170305593509655))
                                .mul_add(
                                    t28,
                                    R::of(0.0298312455087662)
                                        .mul_add(t21, R::of(-0.034408546847132834)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.007220183963499014)
                                        .mul_add(t21, R::of(0.010155566629866313))
                                        .mul_add(
                                            t28,
                                            R::of(-0.007183133560770631)
                                                .mul_add(t21, R::of(0.008067274916517465)),
                                        ),
                                ),
                        ),
                );
            let q36 = R::of(-1.0975037304066549e-9)
                .mul_add(
                    t28,
                    R::of(-1.4267548495286514e-8)
                        .mul_add(t21, R::of(-4.4770465669652663e-8)),
                )
                .mul_add(
                    t48,
                    R::of(1.5260406093845677e-7)
                        .mul_add(t21, R::of(9.33567673492707e-7))
                        .mul_add(
                            t28,
                            R::of(-8.644796094863894e-7)
                                .mul_add(t21, R::of(-1.0032294462845281e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(1.3206319489473587e-6)
                                .mul_add(t21, R::of(6.517988208167725e-5))
                                .mul_add(
                                    t28,
                                    R::of(1.9154413463666662e-5)
                                        .mul_add(t21, R::of(-0.00020079055232584438)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-4.5833790406170785e-5)
                        .mul_add(t21, R::of(6.609670875483287e-5))
                        .mul_add(
                            t28,
                            R::of(-0.00021021555353063643)
                                .mul_add(t21, R::of(0.0011773790210639035)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.0004256036458925242)
                                .mul_add(t21, R::of(-0.0022363651170705756))
                                .mul_add(
                                    t28,
                                    R::of(-0.0029574816198740506)
                                        .mul_add(t21, R::of(0.005307245607733777)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.017748599785232733)
                                .mul_add(t21, R::of(-0.03181953357118409))
                                .mul_add(
                                    t28,
                                    R::of(0.020027943127464993)
                                        .mul_add(t21, R::of(-0.0007546751806212659)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.010982545320905306)
                                        .mul_add(t21, R::of(0.016912413148882616))
                                        .mul_add(
                                            t28,
                                            R::of(-0.011596111265820904)
                                                .mul_add(t21, R::of(-0.00445327132862999)),
                                        ),
                                ),
                        ),
                );
            let q37 = R::of(8.287921023555545e-10)
                .mul_add(
                    t28,
                    R::of(1.0774297330622208e-8)
                        .mul_add(t21, R::of(3.2462820257202646e-8)),
                )
                .mul_add(
                    t48,
                    R::of(-1.1698256819297698e-7)
                        .mul_add(t21, R::of(-5.930365785462319e-7))
                        .mul_add(
                            t28,
                            R::of(1.109420254667225e-6)
                                .mul_add(t21, R::of(6.9325560269092465e-6)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.0303923863277177e-6)
                                .mul_add(t21, R::of(-2.2045545895386193e-5))
                                .mul_add(
                                    t28,
                                    R::of(-1.3774036358557363e-5)
                                        .mul_add(t21, R::of(-0.00012304521306498952)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-1.4386688930120904e-5)
                        .mul_add(t21, R::of(0.0008595875743401906))
                        .mul_add(
                            t28,
                            R::of(-0.00024265262559659503)
                                .mul_add(t21, R::of(0.000474080029658397)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.0034492914594999795)
                                .mul_add(t21, R::of(-0.016136496764787615))
                                .mul_add(
                                    t28,
                                    R::of(-0.0030823844350111535)
                                        .mul_add(t21, R::of(0.03470193278117663)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.027317663790230345)
                                .mul_add(t21, R::of(0.01772429203588228))
                                .mul_add(
                                    t28,
                                    R::of(0.012120646458735803)
                                        .mul_add(t21, R::of(-0.04769058902898284)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.051627332214250365)
                                        .mul_add(t21, R::of(-0.02174557675402708))
                                        .mul_add(
                                            t28,
                                            R::of(0.02091287238661096)
                                                .mul_add(t21, R::of(0.002328191271095514)),
                                        ),
                                ),
                        ),
                );
            let q38 = R::of(5.40585776960348e-10)
                .mul_add(
                    t28,
                    R::of(7.027615100484525e-9)
                        .mul_add(t21, R::of(1.9815218493662064e-8)),
                )
                .mul_add(
                    t48,
                    R::of(-1.0534348014886355e-7)
                        .mul_add(t21, R::of(-6.528071348991633e-7))
                        .mul_add(
                            t28,
                            R::of(-4.486429417738771e-7)
                                .mul_add(t21, R::of(3.126445277501142e-6)),
                        )
                        .mul_add(
                            t37,
                            R::of(6.644313152823827e-6)
                                .mul_add(t21, R::of(1.1381984277266474e-5))
                                .mul_add(
                                    t28,
                                    R::of(1.2923376491706236e-5)
                                        .mul_add(t21, R::of(-9.66539475756628e-5)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.000257817065502873)
                        .mul_add(t21, R::of(-0.00015542622421389112))
                        .mul_add(
                            t28,
                            R::of(0.00013160209513290305)
                                .mul_add(t21, R::of(0.001956237579490311)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.004233629132279542)
                                .mul_add(t21, R::of(-0.0023849749071052414))
                                .mul_add(
                                    t28,
                                    R::of(-0.014150625091454977)
                                        .mul_add(t21, R::of(-0.005229539731712703)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.01930058240937236)
                                .mul_add(t21, R::of(0.0017084342796481128))
                                .mul_add(
                                    t28,
                                    R::of(-0.006616043607253971)
                                        .mul_add(t21, R::of(0.004274896481569647)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.01836188523536569)
                                        .mul_add(t21, R::of(0.005326943625102024))
                                        .mul_add(
                                            t28,
                                            R::of(0.005486143950862598)
                                                .mul_add(t21, R::of(0.0028854087005833248)),
                                        ),
                                ),
                        ),
                );
            let q39 = R::of(8.182586796411309e-9)
                .mul_add(
                    t28,
                    R::of(1.0637362835334702e-7)
                        .mul_add(t21, R::of(2.7387892101950533e-7)),
                )
                .mul_add(
                    t48,
                    R::of(-1.7522776302086017e-6)
                        .mul_add(t21, R::of(-7.908497256097344e-6))
                        .mul_add(
                            t28,
                            R::of(1.4728068912490186e-5)
                                .mul_add(t21, R::of(9.410548903589108e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-7.88770487928873e-5)
                                .mul_add(t21, R::of(-0.0006194110807772234))
                                .mul_add(
                                    t28,
                                    R::of(0.0003982652863154009)
                                        .mul_add(t21, R::of(0.0023240942394536727)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.0019856092606670133)
                        .mul_add(t21, R::of(-0.0037228390241913693))
                        .mul_add(
                            t28,
                            R::of(0.0058553670032170674)
                                .mul_add(t21, R::of(-0.005058963127608389)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.0010323344713418592)
                                .mul_add(t21, R::of(0.02312567656329597))
                                .mul_add(
                                    t28,
                                    R::of(-0.030367286268855744)
                                        .mul_add(t21, R::of(0.015490583647297178)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.0059706351438627075)
                                .mul_add(t21, R::of(-0.06381874338090886))
                                .mul_add(
                                    t28,
                                    R::of(0.10836073865781452)
                                        .mul_add(t21, R::of(-0.1053696233979648)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.09580764779138011)
                                        .mul_add(t21, R::of(-0.06279346918231389))
                                        .mul_add(
                                            t28,
                                            R::of(0.030013278395114897)
                                                .mul_add(t21, R::of(-0.011401341523975499)),
                                        ),
                                ),
                        ),
                );
            let q40 = R::of(-1.801952589867827e-9)
                .mul_add(
                    t28,
                    R::of(-2.342538366828175e-8)
                        .mul_add(t21, R::of(-6.476843299848765e-8)),
                )
                .mul_add(
                    t48,
                    R::of(3.5999844833446163e-7)
                        .mul_add(t21, R::of(1.6478722906680437e-6))
                        .mul_add(
                            t28,
                            R::of(-4.3226404139331236e-6)
                                .mul_add(t21, R::of(-2.1270092200131347e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(5.33307893957512e-5)
                                .mul_add(t21, R::of(0.00019814483489090696))
                                .mul_add(
                                    t28,
                                    R::of(-0.0005028162828664764)
                                        .mul_add(t21, R::of(-0.0012410560475614517)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.0030451500296481407)
                        .mul_add(t21, R::of(0.004060389197107138))
                        .mul_add(
                            t28,
                            R::of(-0.010346143666125227)
                                .mul_add(t21, R::of(-0.001012778988235587)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.008879892991556507)
                                .mul_add(t21, R::of(-0.026050298893948994))
                                .mul_add(
                                    t28,
                                    R::of(0.05512616038937739)
                                        .mul_add(t21, R::of(0.0005613224682022089)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.08478859046754122)
                                .mul_add(t21, R::of(0.14249975189022607))
                                .mul_add(
                                    t28,
                                    R::of(-0.23436470079422342)
                                        .mul_add(t21, R::of(0.23831041243763423)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.18171537474438562)
                                        .mul_add(t21, R::of(0.14886649005082375))
                                        .mul_add(
                                            t28,
                                            R::of(-0.055913848191923916)
                                                .mul_add(t21, R::of(0.03293701818500948)),
                                        ),
                                ),
                        ),
                );
            let q41 = R::of(3.2435146617620884e-9)
                .mul_add(
                    t28,
                    R::of(4.216569060290715e-8).mul_add(t21, R::of(1.773758615791553e-7)),
                )
                .mul_add(
                    t48,
                    R::of(8.883309824363722e-8)
                        .mul_add(t21, R::of(-1.5711316138873245e-6))
                        .mul_add(
                            t28,
                            R::of(-6.148285059170007e-6)
                                .mul_add(t21, R::of(-6.262330038591338e-6)),
                        )
                        .mul_add(
                            t37,
                            R::of(4.91755176847907e-5)
                                .mul_add(t21, R::of(0.0001670169596166671))
                                .mul_add(
                                    t28,
                                    R::of(-0.00017050098608258944)
                                        .mul_add(t21, R::of(-0.0011564046051718404)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.00012938648921632232)
                        .mul_add(t21, R::of(0.0038278017707829948))
                        .mul_add(
                            t28,
                            R::of(0.0008774621784643527)
                                .mul_add(t21, R::of(-0.0042743108384251235)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.001703112313451616)
                                .mul_add(t21, R::of(-0.009112076860523696))
                                .mul_add(
                                    t28,
                                    R::of(-0.003221308495883582)
                                        .mul_add(t21, R::of(0.03310879829832359)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.003939397929213185)
                                .mul_add(t21, R::of(-0.02544222314269471))
                                .mul_add(
                                    t28,
                                    R::of(0.02960755862055982)
                                        .mul_add(t21, R::of(-0.06969222705457548)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.04373917412898077)
                                        .mul_add(t21, R::of(-0.017116751384990036))
                                        .mul_add(
                                            t28,
                                            R::of(0.01562671956643205)
                                                .mul_add(t21, R::of(0.012024095825144175)),
                                        ),
                                ),
                        ),
                );
            let q42 = R::of(-3.5357201214774165e-9)
                .mul_add(
                    t28,
                    R::of(-4.5964361579206416e-8)
                        .mul_add(t21, R::of(-1.5088373863945854e-7)),
                )
                .mul_add(
                    t48,
                    R::of(4.368181193714437e-7)
                        .mul_add(t21, R::of(3.2506813224756686e-6))
                        .mul_add(
                            t28,
                            R::of(5.327032537910891e-7)
                                .mul_add(t21, R::of(-2.7953655256682584e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-3.264847802273022e-5)
                                .mul_add(t21, R::of(0.00013075158266046843))
                                .mul_add(
                                    t28,
                                    R::of(0.0002396012453645081)
                                        .mul_add(t21, R::of(-0.0003729495965449974)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.0008859344906032287)
                        .mul_add(t21, R::of(0.0007521271434923005))
                        .mul_add(
                            t28,
                            R::of(0.0015643346509950618)
                                .mul_add(t21, R::of(-0.0012143086169717362)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.0007098388404738785)
                                .mul_add(t21, R::of(-0.00013280078654552807))
                                .mul_add(
                                    t28,
                                    R::of(-0.006267879282927272)
                                        .mul_add(t21, R::of(0.006744470539523704)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.0009955462222663639)
                                .mul_add(t21, R::of(-7.296826916350447e-5))
                                .mul_add(
                                    t28,
                                    R::of(0.004728912546409537)
                                        .mul_add(t21, R::of(-0.006806888004252624)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.002138217425046201)
                                        .mul_add(t21, R::of(0.0017811238164549626))
                                        .mul_add(
                                            t28,
                                            R::of(-2.9760362759320297e-5)
                                                .mul_add(t21, R::of(0.0024337975662995113)),
                                        ),
                                ),
                        ),
                );
            let q43 = R::of(-9.669241194148135e-10)
                .mul_add(
                    t28,
                    R::of(-1.2570013552392576e-8)
                        .mul_add(t21, R::of(-5.482804684304731e-8)),
                )
                .mul_add(
                    t48,
                    R::of(-6.321245980097167e-8)
                        .mul_add(t21, R::of(3.0491240065999666e-7))
                        .mul_add(
                            t28,
                            R::of(2.2331748829317928e-6)
                                .mul_add(t21, R::of(5.563985922949535e-6)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.5486726120437948e-5)
                                .mul_add(t21, R::of(-8.764737321580595e-5))
                                .mul_add(
                                    t28,
                                    R::of(3.347422513702083e-5)
                                        .mul_add(t21, R::of(0.0005536898092462784)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.00011543218892360922)
                        .mul_add(t21, R::of(-0.0018047759239769763))
                        .mul_add(
                            t28,
                            R::of(-0.000978183888627929)
                                .mul_add(t21, R::of(0.0025767916614589208)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.0027510910160191858)
                                .mul_add(t21, R::of(0.00018817666730168835))
                                .mul_add(
                                    t28,
                                    R::of(-0.0005494784618069515)
                                        .mul_add(t21, R::of(-0.006446151923394304)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.011174409187943898)
                                .mul_add(t21, R::of(0.019797317512635488))
                                .mul_add(
                                    t28,
                                    R::of(-0.014513909177229571)
                                        .mul_add(t21, R::of(0.025185019139746145)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.009375586638722977)
                                        .mul_add(t21, R::of(0.0009111537603377359))
                                        .mul_add(
                                            t28,
                                            R::of(-0.0024393642254732922)
                                                .mul_add(t21, R::of(-0.003681554808294784)),
                                        ),
                                ),
                        ),
                );
            let q44 = R::of(2.7566691955468375e-9)
                .mul_add(
                    t28,
                    R::of(3.583669954210889e-8)
                        .mul_add(t21, R::of(1.1228056948118245e-7)),
                )
                .mul_add(
                    t48,
                    R::of(-3.5749452503555443e-7)
                        .mul_add(t21, R::of(-2.3306077876912735e-6))
                        .mul_add(
                            t28,
                            R::of(-1.3412411233547433e-7)
                                .mul_add(t21, R::of(1.6921652557948158e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(2.368026932488601e-5)
                                .mul_add(t21, R::of(-4.046465972761652e-5))
                                .mul_add(
                                    t28,
                                    R::of(-0.00021648533674415034)
                                        .mul_add(t21, R::of(-0.00015095379157106084)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.0012463765028427113)
                        .mul_add(t21, R::of(0.0009476178217533062))
                        .mul_add(
                            t28,
                            R::of(-0.0044298027713915175)
                                .mul_add(t21, R::of(0.0012405985845548684)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.003857202621648523)
                                .mul_add(t21, R::of(-0.013772880818603702))
                                .mul_add(
                                    t28,
                                    R::of(0.027415335330874663)
                                        .mul_add(t21, R::of(-0.00749552736874242)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.03419710417449361)
                                .mul_add(t21, R::of(0.07658010008593402))
                                .mul_add(
                                    t28,
                                    R::of(-0.12967250049895548)
                                        .mul_add(t21, R::of(0.13397426506678115)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.10768677498007242)
                                        .mul_add(t21, R::of(0.0820003608180505))
                                        .mul_add(
                                            t28,
                                            R::of(-0.027991413459157614)
                                                .mul_add(t21, R::of(0.017180256706417492)),
                                        ),
                                ),
                        ),
                );
            let q45 = R::of(6.33936261678398e-8)
                .mul_add(t21, R::of(7.924203270979975e-7))
                .mul_add(
                    t48,
                    R::of(2.6588927995749777e-6)
                        .mul_add(t21, R::of(-5.371232217590055e-6))
                        .mul_add(
                            t28,
                            R::of(-4.7969992011099894e-5)
                                .mul_add(t21, R::of(-3.328892160780653e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.00034072043810187203)
                                .mul_add(t21, R::of(0.0006240703626391409))
                                .mul_add(
                                    t28,
                                    R::of(-0.0013819755902175796)
                                        .mul_add(t21, R::of(-0.0039939146436437315)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.003996355473803328)
                        .mul_add(t21, R::of(0.013685737849894377))
                        .mul_add(
                            t28,
                            R::of(-0.0113177984002791)
                                .mul_add(t21, R::of(-0.01969674983879588)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.025132653568202164)
                                .mul_add(t21, R::of(-0.01678841838892774))
                                .mul_add(
                                    t28,
                                    R::of(0.0026444160594399782)
                                        .mul_add(t21, R::of(0.04901590733457525)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.08087776039820503)
                                .mul_add(t21, R::of(0.06344543322609292))
                                .mul_add(
                                    t28,
                                    R::of(-0.04214318076230168)
                                        .mul_add(t21, R::of(0.03559570321589803)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.023418008416670116)
                                        .mul_add(t21, R::of(0.013060535753822282))
                                        .mul_add(
                                            t28,
                                            R::of(-0.01718820501837787)
                                                .mul_add(t21, R::of(0.001087738179035714)),
                                        ),
                                ),
                        ),
                );
            let q46 = R::of(4.668862176602957e-8)
                .mul_add(t21, R::of(5.836077720753696e-7))
                .mul_add(
                    t48,
                    R::of(2.1394961071023796e-6)
                        .mul_add(t21, R::of(-9.7052272915301e-7))
                        .mul_add(
                            t28,
                            R::of(-2.210480285828174e-5)
                                .mul_add(t21, R::of(-4.611209792612584e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-1.6113129993571022e-5)
                                .mul_add(t21, R::of(0.0003137768755727135))
                                .mul_add(
                                    t28,
                                    R::of(0.0012289625696294256)
                                        .mul_add(t21, R::of(-0.0004624733114243185)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.007651247873059633)
                        .mul_add(t21, R::of(-0.001862764861269136))
                        .mul_add(
                            t28,
                            R::of(0.02161471646986222)
                                .mul_add(t21, R::of(0.008530082591645895)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.025857422285123215)
                                .mul_add(t21, R::of(-0.015544739986365408))
                                .mul_add(
                                    t28,
                                    R::of(0.005913482588232)
                                        .mul_add(t21, R::of(-0.009864201111788436)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.0239589542197014)
                                .mul_add(t21, R::of(0.08955891688416469))
                                .mul_add(
                                    t28,
                                    R::of(-0.1252369270260985)
                                        .mul_add(t21, R::of(0.10615275308266015)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.11703003274305679)
                                        .mul_add(t21, R::of(0.042107926034024135))
                                        .mul_add(
                                            t28,
                                            R::of(-0.012657054066158073)
                                                .mul_add(t21, R::of(0.004108988911042967)),
                                        ),
                                ),
                        ),
                );
            let q47 = R::of(-5.761816888324872e-8)
                .mul_add(t21, R::of(-7.202271110406091e-7))
                .mul_add(
                    t48,
                    R::of(-2.0596789711417645e-6)
                        .mul_add(t21, R::of(7.757968744605944e-6))
                        .mul_add(
                            t28,
                            R::of(4.449852426656968e-5)
                                .mul_add(t21, R::of(-1.9171361368430333e-6)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.00030497404569903116)
                                .mul_add(t21, R::of(-0.0004031810438802379))
                                .mul_add(
                                    t28,
                                    R::of(0.0006392580129898893)
                                        .mul_add(t21, R::of(0.003434212872776773)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.0025354078301721237)
                        .mul_add(t21, R::of(-0.01718074724690978))
                        .mul_add(
                            t28,
                            R::of(-0.011329700257868983)
                                .mul_add(t21, R::of(0.05436364442570349)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.025458046620119197)
                                .mul_add(t21, R::of(-0.045647410802969884))
                                .mul_add(
                                    t28,
                                    R::of(0.15651057605536675)
                                        .mul_add(t21, R::of(-0.22875000766373393)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.05441921926107575)
                                .mul_add(t21, R::of(0.22251745573083584))
                                .mul_add(
                                    t28,
                                    R::of(-0.4652584697285255)
                                        .mul_add(t21, R::of(0.6440235080714918)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.5331397347856115)
                                        .mul_add(t21, R::of(0.3306227977588238))
                                        .mul_add(
                                            t28,
                                            R::of(-0.1677813491307073)
                                                .mul_add(t21, R::of(0.030876278183930777)),
                                        ),
                                ),
                        ),
                );
            let t1729 = R::of(2.1274725670669404e-7)
                .mul_add(t21, R::of(2.659340708833675e-6));
            let q48 = t1729
                .mul_add(
                    t48,
                    R::of(6.499927621583392e-6)
                        .mul_add(t21, R::of(-4.13034485022304e-5))
                        .mul_add(
                            t28,
                            R::of(-0.0001791017983825778)
                                .mul_add(t21, R::of(0.0002969849450403115)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.0018661369133923563)
                                .mul_add(t21, R::of(-0.0015006852555914923))
                                .mul_add(
                                    t28,
                                    R::of(-0.011028331004862514)
                                        .mul_add(t21, R::of(0.007202916021091444)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.037665774730122746)
                        .mul_add(t21, R::of(-0.030292351145495923))
                        .mul_add(
                            t28,
                            R::of(-0.05466291108910756)
                                .mul_add(t21, R::of(0.07356069841815219)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.05703791529968767)
                                .mul_add(t21, R::of(-0.004139123693648181))
                                .mul_add(
                                    t28,
                                    R::of(0.2208090606383937)
                                        .mul_add(t21, R::of(-0.3054092689246711)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.13164276732982585)
                                .mul_add(t21, R::of(0.09895463776782568))
                                .mul_add(
                                    t28,
                                    R::of(-0.36809611131794534)
                                        .mul_add(t21, R::of(0.4860719001618475)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.4400183303417613)
                                        .mul_add(t21, R::of(0.3149946206850647))
                                        .mul_add(
                                            t28,
                                            R::of(-0.12593891428062004)
                                                .mul_add(t21, R::of(0.031611660064203656)),
                                        ),
                                ),
                        ),
                );
            let t1779 = R::of(-4.68507673365635e-8)
                .mul_add(t21, R::of(-5.856345917070438e-7));
            let q49 = t1779
                .mul_add(
                    t48,
                    R::of(-1.7139318445224282e-6)
                        .mul_add(t21, R::of(6.398945354299422e-6))
                        .mul_add(
                            t28,
                            R::of(2.9518513792561154e-5)
                                .mul_add(t21, R::of(-9.17257683746489e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.0003865731820659528)
                                .mul_add(t21, R::of(0.0011147517048114845))
                                .mul_add(
                                    t28,
                                    R::of(0.0039018231737296388)
                                        .mul_add(t21, R::of(-0.008050458269445483)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.021561044236083942)
                        .mul_add(t21, R::of(0.04031373800154435))
                        .mul_add(
                            t28,
                            R::of(0.053118026739413765)
                                .mul_add(t21, R::of(-0.12930531229824926)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.020770962653315)
                                .mul_add(t21, R::of(0.14605515270686406))
                                .mul_add(
                                    t28,
                                    R::of(-0.30125778147312104)
                                        .mul_add(t21, R::of(0.35379818171815014)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.035154982105715105)
                                .mul_add(t21, R::of(-0.4474431696657983))
                                .mul_add(
                                    t28,
                                    R::of(0.8746190432952519)
                                        .mul_add(t21, R::of(-1.1921136868953035)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.9655256773728017)
                                        .mul_add(t21, R::of(-0.6132348168427277))
                                        .mul_add(
                                            t28,
                                            R::of(0.31219156532886383)
                                                .mul_add(t21, R::of(-0.05172136500890292)),
                                        ),
                                ),
                        ),
                );
            let t1829 = R::of(8.43313812058143e-8)
                .mul_add(t21, R::of(1.0541422650726787e-6));
            let q50 = t1829
                .mul_add(
                    t48,
                    R::of(4.352996400891705e-6)
                        .mul_add(t21, R::of(2.8946510524492187e-6))
                        .mul_add(
                            t28,
                            R::of(-3.4623960650228626e-5)
                                .mul_add(t21, R::of(-0.00014733997091668146)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.00015896411076607735)
                                .mul_add(t21, R::of(0.0009911011491911832))
                                .mul_add(
                                    t28,
                                    R::of(0.0030174613614522426)
                                        .mul_add(t21, R::of(-0.002660441958214896)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.015298694220087157)
                        .mul_add(t21, R::of(0.001855350070103627))
                        .mul_add(
                            t28,
                            R::of(0.03738071928537825)
                                .mul_add(t21, R::of(0.010383369101620576)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.05281065569098029)
                                .mul_add(t21, R::of(-0.04560093751827528))
                                .mul_add(
                                    t28,
                                    R::of(0.07911333733038764)
                                        .mul_add(t21, R::of(-0.005029832868876187)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.05293723567886894)
                                .mul_add(t21, R::of(0.21471424479043827))
                                .mul_add(
                                    t28,
                                    R::of(-0.24702183356105795)
                                        .mul_add(t21, R::of(0.149156227543831)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.13763418738853134)
                                        .mul_add(t21, R::of(-0.02166055189049704))
                                        .mul_add(
                                            t28,
                                            R::of(0.020311133259732626)
                                                .mul_add(t21, R::of(-0.007183133560770631)),
                                        ),
                                ),
                        ),
                );
            let q51 = R::of(-2.8535096990573028e-8)
                .mul_add(t21, R::of(-3.5668871238216283e-7))
                .mul_add(
                    t48,
                    R::of(-1.0744911760716639e-6)
                        .mul_add(t21, R::of(3.509893401584506e-6))
                        .mul_add(
                            t28,
                            R::of(2.0538488816839554e-5)
                                .mul_add(t21, R::of(-1.8154071799214177e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.0002006458892569056)
                                .mul_add(t21, R::of(2.5092007029999815e-5))
                                .mul_add(
                                    t28,
                                    R::of(0.0011732378774701906)
                                        .mul_add(t21, R::of(0.0003256250288823333)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.00321264883721351)
                        .mul_add(t21, R::of(-0.0006875068560925617))
                        .mul_add(
                            t28,
                            R::of(0.0009253539225676602)
                                .mul_add(t21, R::of(-0.0027328021958982736)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.014128548252766843)
                                .mul_add(t21, R::of(0.004681640104817766))
                                .mul_add(
                                    t28,
                                    R::of(-0.022363651170705757)
                                        .mul_add(t21, R::of(-0.026617334578866458)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.042457964861870215)
                                .mul_add(t21, R::of(0.12424019849662914))
                                .mul_add(
                                    t28,
                                    R::of(-0.19091720142710453)
                                        .mul_add(t21, R::of(0.10013971563732497)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.0030187007224850636)
                                        .mul_add(t21, R::of(-0.03294763596271592))
                                        .mul_add(
                                            t28,
                                            R::of(0.03382482629776523)
                                                .mul_add(t21, R::of(-0.011596111265820904)),
                                        ),
                                ),
                        ),
                );
            let q52 = R::of(2.1548594661244416e-8)
                .mul_add(t21, R::of(2.693574332655552e-7))
                .mul_add(
                    t48,
                    R::of(7.791076861728635e-7)
                        .mul_add(t21, R::of(-2.6905990684384705e-6))
                        .mul_add(
                            t28,
                            R::of(-1.30468047280171e-5)
                                .mul_add(t21, R::of(2.3297825348011724e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.00013865112053818493)
                                .mul_add(t21, R::of(-1.9577455340226637e-5))
                                .mul_add(
                                    t28,
                                    R::of(-0.0003968198261169515)
                                        .mul_add(t21, R::of(-0.00023415861809547518)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.0019687234090398323)
                        .mul_add(t21, R::of(-0.00021580033395181356))
                        .mul_add(
                            t28,
                            R::of(0.01203422604076267)
                                .mul_add(t21, R::of(-0.003154484132755735)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.0056889603559007644)
                                .mul_add(t21, R::of(0.03794220605449978))
                                .mul_add(
                                    t28,
                                    R::of(-0.16136496764787617)
                                        .mul_add(t21, R::of(-0.027741459915100384)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.277615462249413)
                                .mul_add(t21, R::of(-0.19122364653161242))
                                .mul_add(
                                    t28,
                                    R::of(0.10634575221529366)
                                        .mul_add(t21, R::of(0.06060323229367902)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.19076235611593137)
                                        .mul_add(t21, R::of(0.1548819966427511))
                                        .mul_add(
                                            t28,
                                            R::of(-0.04349115350805416)
                                                .mul_add(t21, R::of(0.02091287238661096)),
                                        ),
                                ),
                        ),
                );
            let q53 = R::of(1.405523020096905e-8)
                .mul_add(t21, R::of(1.7569037751211313e-7))
                .mul_add(
                    t48,
                    R::of(4.7556524384788953e-7)
                        .mul_add(t21, R::of(-2.4229000434238616e-6))
                        .mul_add(
                            t28,
                            R::of(-1.4361756967781592e-5)
                                .mul_add(t21, R::of(-9.42150177725142e-6)),
                        )
                        .mul_add(
                            t37,
                            R::of(6.252890555002285e-5)
                                .mul_add(t21, R::of(0.00012624194990365272))
                                .mul_add(
                                    t28,
                                    R::of(0.00020487571699079652)
                                        .mul_add(t21, R::of(0.00021969740035900602)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.0015464631612106049)
                        .mul_add(t21, R::of(-0.003867255982543095))
                        .mul_add(
                            t28,
                            R::of(-0.0021759671389944757)
                                .mul_add(t21, R::of(0.0017108272367277397)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.023474850953883734)
                                .mul_add(t21, R::of(0.04656992045507497))
                                .mul_add(
                                    t28,
                                    R::of(-0.02384974907105241)
                                        .mul_add(t21, R::of(-0.1273556258230948)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.04183631785370162)
                                .mul_add(t21, R::of(0.13510407686560652))
                                .mul_add(
                                    t28,
                                    R::of(0.010250605677888677)
                                        .mul_add(t21, R::of(-0.03308021803626986)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.01709958592627859)
                                        .mul_add(t21, R::of(-0.05508565570609707))
                                        .mul_add(
                                            t28,
                                            R::of(0.010653887250204047)
                                                .mul_add(t21, R::of(0.005486143950862598)),
                                        ),
                                ),
                        ),
                );
            let q54 = t1729
                .mul_add(
                    t48,
                    R::of(6.573094104468128e-6)
                        .mul_add(t21, R::of(-4.030238549479784e-5))
                        .mul_add(
                            t28,
                            R::of(-0.00017398693963414157)
                                .mul_add(t21, R::of(0.00030928944716229393)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.0018821097807178216)
                                .mul_add(t21, R::of(-0.0014986639270648588))
                                .mul_add(
                                    t28,
                                    R::of(-0.011149399453990022)
                                        .mul_add(t21, R::of(0.006770509867361815)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.03718550783125876)
                        .mul_add(t21, R::of(-0.029784138910005198))
                        .mul_add(
                            t28,
                            R::of(-0.05211974633867917)
                                .mul_add(t21, R::of(0.07611977104182187)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.060707557531300665)
                                .mul_add(t21, R::of(-0.01135567918476045))
                                .mul_add(
                                    t28,
                                    R::of(0.23125676563295972)
                                        .mul_add(t21, R::of(-0.2733055764197017)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.12392466917837743)
                                .mul_add(t21, R::of(0.04179444600703895))
                                .mul_add(
                                    t28,
                                    R::of(-0.38291246028545317)
                                        .mul_add(t21, R::of(0.5418036932890726)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.4214784935918592)
                                        .mul_add(t21, R::of(0.28742294337414037))
                                        .mul_add(
                                            t28,
                                            R::of(-0.12558693836462778)
                                                .mul_add(t21, R::of(0.030013278395114897)),
                                        ),
                                ),
                        ),
                );
            let q55 = t1779
                .mul_add(
                    t48,
                    R::of(-1.5544423919637035e-6)
                        .mul_add(t21, R::of(8.279964311692617e-6))
                        .mul_add(
                            t28,
                            R::of(3.6253190394696963e-5)
                                .mul_add(t21, R::of(-9.07754486925956e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.00042540184400262696)
                                .mul_add(t21, R::of(0.0010132849985192728))
                                .mul_add(
                                    t28,
                                    R::of(0.003566607028036325)
                                        .mul_add(t21, R::of(-0.0085478768087301)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.019856896760983227)
                        .mul_add(t21, R::of(0.04567725044472211))
                        .mul_add(
                            t28,
                            R::of(0.05684544875949994)
                                .mul_add(t21, R::of(-0.13449986765962793)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.012153347858827044)
                                .mul_add(t21, R::of(0.09767882290712158))
                                .mul_add(
                                    t28,
                                    R::of(-0.26050298893949)
                                        .mul_add(t21, R::of(0.49613544350439653)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.0044905797456176715)
                                .mul_add(t21, R::of(-0.5935201332727885))
                                .mul_add(
                                    t28,
                                    R::of(0.8549985113413564)
                                        .mul_add(t21, R::of(-1.1718235039711171)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.9532416497505369)
                                        .mul_add(t21, R::of(-0.5451461242331569))
                                        .mul_add(
                                            t28,
                                            R::of(0.2977329801016475)
                                                .mul_add(t21, R::of(-0.055913848191923916)),
                                        ),
                                ),
                        ),
                );
            let q56 = t1829
                .mul_add(
                    t48,
                    R::of(4.257020677899727e-6)
                        .mul_add(t21, R::of(2.043161259603656e-6))
                        .mul_add(
                            t28,
                            R::of(-3.456489550552114e-5)
                                .mul_add(t21, R::of(-0.00012911398624257015)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.00012524660077182676)
                                .mul_add(t21, R::of(0.0009343348360110233))
                                .mul_add(
                                    t28,
                                    R::of(0.003006305273100008)
                                        .mul_add(t21, R::of(-0.0028985167634040204)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.018502473682749446)
                        .mul_add(t21, R::of(0.0019407973382448347))
                        .mul_add(
                            t28,
                            R::of(0.053589224790961926)
                                .mul_add(t21, R::of(0.011407008320036586)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.051291730061101486)
                                .mul_add(t21, R::of(-0.018734235447967776))
                                .mul_add(
                                    t28,
                                    R::of(-0.09112076860523695)
                                        .mul_add(t21, R::of(-0.028991776462952236)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.2648703863865887)
                                .mul_add(t21, R::of(0.027575785504492297))
                                .mul_add(
                                    t28,
                                    R::of(-0.15265333885616825)
                                        .mul_add(t21, R::of(0.1480377931027991)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.2787689082183019)
                                        .mul_add(t21, R::of(0.13121752238694231))
                                        .mul_add(
                                            t28,
                                            R::of(-0.03423350276998007)
                                                .mul_add(t21, R::of(0.01562671956643205)),
                                        ),
                                ),
                        ),
                );
            let q57 = R::of(-9.192872315841283e-8)
                .mul_add(t21, R::of(-1.1491090394801603e-6))
                .mul_add(
                    t48,
                    R::of(-3.6212097273470052e-6)
                        .mul_add(t21, R::of(1.0046816745543205e-5))
                        .mul_add(
                            t28,
                            R::of(7.151498909446472e-5)
                                .mul_add(t21, R::of(1.1186768329612872e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.0005590731051336517)
                                .mul_add(t21, R::of(-0.0006203210824318742))
                                .mul_add(
                                    t28,
                                    R::of(0.0023535284878884316)
                                        .mul_add(t21, R::of(0.004073221171196638)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.005967193544719958)
                        .mul_add(t21, R::of(-0.013289017359048432))
                        .mul_add(
                            t28,
                            R::of(0.010529780008892207)
                                .mul_add(t21, R::of(0.020336350462935804)),
                        )
                        .mul_add(
                            t37,
                            R::of(-0.014571703403660832)
                                .mul_add(t21, R::of(0.0078082272452126645))
                                .mul_add(
                                    t28,
                                    R::of(-0.0013280078654552808)
                                        .mul_add(t21, R::of(-0.056410913546345455)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(0.05395576431618963)
                                .mul_add(t21, R::of(-0.006968823555864548))
                                .mul_add(
                                    t28,
                                    R::of(-0.0004378096149810268)
                                        .mul_add(t21, R::of(0.023644562732047684)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(-0.027227552017010496)
                                        .mul_add(t21, R::of(0.006414652275138603))
                                        .mul_add(
                                            t28,
                                            R::of(0.003562247632909925)
                                                .mul_add(t21, R::of(-2.9760362759320297e-5)),
                                        ),
                                ),
                        ),
                );
            let q58 = R::of(-2.5140027104785153e-8)
                .mul_add(t21, R::of(-3.1425033880981443e-7))
                .mul_add(
                    t48,
                    R::of(-1.3158731242331353e-6)
                        .mul_add(t21, R::of(-1.4538865754223485e-6))
                        .mul_add(
                            t28,
                            R::of(6.708072814519927e-6)
                                .mul_add(t21, R::of(4.689667254156764e-5)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.0001112797184589907)
                                .mul_add(t21, R::of(-0.00029424779628832096))
                                .mul_add(
                                    t28,
                                    R::of(-0.0015776527178845072)
                                        .mul_add(t21, R::of(0.000569061827329354)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(0.008859036947940454)
                        .mul_add(t21, R::of(0.0017314828338541384))
                        .mul_add(
                            t28,
                            R::of(-0.02526686293567767)
                                .mul_add(t21, R::of(-0.012716390552163077)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.03092149993750705)
                                .mul_add(t21, R::of(0.030262001176211042))
                                .mul_add(
                                    t28,
                                    R::of(0.0018817666730168835)
                                        .mul_add(t21, R::of(-0.004945306156262564)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.051569215387154435)
                                .mul_add(t21, R::of(-0.07822086431560729))
                                .mul_add(
                                    t28,
                                    R::of(0.11878390507581292)
                                        .mul_add(t21, R::of(-0.07256954588614786)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.10074007655898458)
                                        .mul_add(t21, R::of(-0.028126759916168934))
                                        .mul_add(
                                            t28,
                                            R::of(0.0018223075206754717)
                                                .mul_add(t21, R::of(-0.0024393642254732922)),
                                        ),
                                ),
                        ),
                );
            let q59 = R::of(7.167339908421777e-8)
                .mul_add(t21, R::of(8.959174885527222e-7))
                .mul_add(
                    t48,
                    R::of(2.694733667548379e-6)
                        .mul_add(t21, R::of(-8.222374075817751e-6))
                        .mul_add(
                            t28,
                            R::of(-5.127337132920802e-5)
                                .mul_add(t21, R::of(-2.8166063590449607e-6)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.00033843305115896315)
                                .mul_add(t21, R::of(0.00044992511717283415))
                                .mul_add(
                                    t28,
                                    R::of(-0.0007283638750970974)
                                        .mul_add(t21, R::of(-0.003680250724650556)),
                                ),
                        ),
                )
                .mul_add(
                    t323,
                    R::of(-0.0024152606651369735)
                        .mul_add(t21, R::of(0.018695647542640668))
                        .mul_add(
                            t28,
                            R::of(0.013266649504546287)
                                .mul_add(t21, R::of(-0.05758743602808973)),
                        )
                        .mul_add(
                            t37,
                            R::of(0.01488718301465842)
                                .mul_add(t21, R::of(0.04242922883813375))
                                .mul_add(
                                    t28,
                                    R::of(-0.137728808186037)
                                        .mul_add(t21, R::of(0.24673801797787198)),
                                ),
                        )
                        .mul_add(
                            t48,
                            R::of(-0.05996421894993936)
                                .mul_add(t21, R::of(-0.23937972922145528))
                                .mul_add(
                                    t28,
                                    R::of(0.45948060051560413)
                                        .mul_add(t21, R::of(-0.6483625024947774)),
                                )
                                .mul_add(
                                    t37,
                                    R::of(0.5358970602671246)
                                        .mul_add(t21, R::of(-0.32306032494021725))
                                        .mul_add(
                                            t28,
                                            R::of(0.164000721636101)
                                                .mul_add(t21, R::of(-0.027991413459157614)),
                                        ),
                                ),
                        ),
                );
            let q60 = (R::of(4.3269140487790233e30) * v)
                .mul_add(v, R::of(1.7307656195116093e31))
                .mul_add(v, R::of(8.653828097558046e31));
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
        /// The polynomial `q58` of v.
        const Q58: [f64; 4] = [
            3.170762614945268e34,
            6.923062478046436e33,
            -4.9846049841934343e33,
            -5.538449982437149e33,
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
            let q15 = ::hodograph::horner(::hodograph::constants(Self::Q15), t7);
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
            let q18 = ::hodograph::horner(::hodograph::constants(Self::Q18), t7) * t6;
            let q19 = ::hodograph::horner(::hodograph::constants(Self::Q19), t7);
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
            let q28 = R::of(-5.134808391387441e-11)
                .mul_add(
                    t33,
                    R::of(-2.1706877951800007e-11)
                        .mul_add(t6, R::of(-7.514574591177033e-10))
                        .mul_add(
                            t7,
                            R::of(-6.035952583773211e-10)
                                .mul_add(t6, R::of(1.784291088094988e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(6.13223232773906e-9)
                                .mul_add(t6, R::of(-7.165407078018455e-8))
                                .mul_add(
                                    t7,
                                    R::of(-1.3305305682827483e-7)
                                        .mul_add(t6, R::of(1.5365996739569737e-7)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(1.2779914842122543e-6)
                        .mul_add(t6, R::of(3.065868463172044e-7))
                        .mul_add(
                            t7,
                            R::of(-5.926149384385737e-6)
                                .mul_add(t6, R::of(-5.938974587449862e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.631223640453707e-5)
                                .mul_add(t6, R::of(1.9417960908421233e-5))
                                .mul_add(
                                    t7,
                                    R::of(-2.8944356035221043e-5)
                                        .mul_add(t6, R::of(-5.531091123109525e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(3.420118767080112e-5)
                                .mul_add(t6, R::of(8.0954892771254e-5))
                                .mul_add(
                                    t7,
                                    R::of(-2.9421396969962675e-5)
                                        .mul_add(t6, R::of(-0.0001250016242125925)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.6391732412724378e-5)
                                        .mul_add(t6, R::of(8.774580444916156e-5))
                                        .mul_add(t7, R::of(-7.704053354589374e-5)),
                                ),
                        ),
                );
            let q29 = R::of(1.5029050763317697e-10)
                .mul_add(
                    t33,
                    R::of(4.3413755903600015e-11)
                        .mul_add(t6, R::of(1.876590507673095e-9))
                        .mul_add(
                            t7,
                            R::of(-2.897714486069079e-10)
                                .mul_add(t6, R::of(-5.488046847087878e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(-4.6812881614163065e-8)
                                .mul_add(t6, R::of(6.13862333190647e-7))
                                .mul_add(
                                    t7,
                                    R::of(8.184239402671406e-7)
                                        .mul_add(t6, R::of(-2.792576542668369e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-6.1716082382983495e-6)
                        .mul_add(t6, R::of(8.375784251653565e-6))
                        .mul_add(
                            t7,
                            R::of(2.7266260491952037e-5)
                                .mul_add(t6, R::of(-7.933098917181924e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(-7.547955917584514e-5)
                                .mul_add(t6, R::of(-1.1640564070281424e-5))
                                .mul_add(
                                    t7,
                                    R::of(0.00013683865882703334)
                                        .mul_add(t6, R::of(9.005431128898934e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-0.00016232158208609777)
                                .mul_add(t6, R::of(-0.0001750651044490656))
                                .mul_add(
                                    t7,
                                    R::of(0.0001015658370265971)
                                        .mul_add(t6, R::of(0.0002694895928270442)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(2.5615208695782636e-6)
                                        .mul_add(t6, R::of(-0.00018703289078141042))
                                        .mul_add(
                                            t7,
                                            R::of(-2.8489615149885238e-5)
                                                .mul_add(t6, R::of(0.00015408106709178748)),
                                        ),
                                ),
                        ),
                );
            let q30 = R::of(2.4118753279777784e-11)
                .mul_add(t6, R::of(4.3413755903600015e-11))
                .mul_add(
                    t7,
                    R::of(-2.0353264280295584e-9)
                        .mul_add(t6, R::of(-1.786733413968458e-9)),
                )
                .mul_add(
                    t26,
                    R::of(-7.297390984513476e-8)
                        .mul_add(t6, R::of(-6.430821123500142e-8))
                        .mul_add(
                            t7,
                            R::of(9.799025275841064e-7)
                                .mul_add(t6, R::of(1.184624671628983e-6)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-6.340409813879948e-6)
                        .mul_add(t6, R::of(-9.358011042418118e-6))
                        .mul_add(
                            t7,
                            R::of(2.350737935837902e-5)
                                .mul_add(t6, R::of(4.378915926093117e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(-5.321251131841562e-5)
                                .mul_add(t6, R::of(-0.00012322424457121754))
                                .mul_add(
                                    t7,
                                    R::of(7.753796396807725e-5)
                                        .mul_add(t6, R::of(0.00021709543776194211)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-6.690919500988372e-5)
                                .mul_add(t6, R::of(-0.0002444832889501724))
                                .mul_add(
                                    t7,
                                    R::of(1.3662841661187425e-5)
                                        .mul_add(t6, R::of(0.00013291198918393587)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(2.716264679190494e-5)
                                        .mul_add(t6, R::of(3.7906506564605285e-5))
                                        .mul_add(
                                            t7,
                                            R::of(-1.555109997264478e-5)
                                                .mul_add(t6, R::of(-5.6979230299770476e-5)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q31 = R::of(5.381549451406584e-11)
                .mul_add(
                    t33,
                    R::of(-4.3413755903600015e-11)
                        .mul_add(t6, R::of(2.027432548635211e-9))
                        .mul_add(
                            t7,
                            R::of(2.897714486069079e-10)
                                .mul_add(t6, R::of(4.9302759630584524e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.6812881614163065e-8)
                                .mul_add(t6, R::of(-6.72172226463588e-7))
                                .mul_add(
                                    t7,
                                    R::of(-8.184239402671406e-7)
                                        .mul_add(t6, R::of(5.014899538713914e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(6.1716082382983495e-6)
                        .mul_add(t6, R::of(-1.9695039096942413e-5))
                        .mul_add(
                            t7,
                            R::of(-2.7266260491952037e-5)
                                .mul_add(t6, R::of(5.697724098377185e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(7.547955917584514e-5)
                                .mul_add(t6, R::of(-0.00011249003035996938))
                                .mul_add(
                                    t7,
                                    R::of(-0.00013683865882703334)
                                        .mul_add(t6, R::of(0.00018936166321267307)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.00016232158208609777)
                                .mul_add(t6, R::of(-0.00021995514834389812))
                                .mul_add(
                                    t7,
                                    R::of(-0.0001015658370265971)
                                        .mul_add(t6, R::of(0.00026037409230417755)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-2.5615208695782636e-6)
                                        .mul_add(t6, R::of(-0.0001745920108032946))
                                        .mul_add(
                                            t7,
                                            R::of(2.8489615149885238e-5)
                                                .mul_add(t6, R::of(0.00015408106709178748)),
                                        ),
                                ),
                        ),
                );
            let q32 = R::of(-2.1008175925458946e-11)
                .mul_add(
                    t33,
                    R::of(-2.1706877951800007e-11)
                        .mul_add(t6, R::of(-1.1330269279497391e-9))
                        .mul_add(
                            t7,
                            R::of(-6.035952583773211e-10)
                                .mul_add(t6, R::of(-5.5814674444508785e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(6.13223232773906e-9)
                                .mul_add(t6, R::of(-1.2452588231490775e-7))
                                .mul_add(
                                    t7,
                                    R::of(-1.3305305682827483e-7)
                                        .mul_add(t6, R::of(1.277413874903387e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(1.2779914842122543e-6)
                        .mul_add(t6, R::of(-5.734992611972588e-6))
                        .mul_add(
                            t7,
                            R::of(-5.926149384385737e-6)
                                .mul_add(t6, R::of(1.9107763360504262e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.631223640453707e-5)
                                .mul_add(t6, R::of(-4.16156675337695e-5))
                                .mul_add(
                                    t7,
                                    R::of(-2.8944356035221043e-5)
                                        .mul_add(t6, R::of(8.354520225998249e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(3.420118767080112e-5)
                                .mul_add(t6, R::of(-0.00010969805768408405))
                                .mul_add(
                                    t7,
                                    R::of(-2.9421396969962675e-5)
                                        .mul_add(t6, R::of(0.00014304877048163073)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.6391732412724378e-5)
                                        .mul_add(t6, R::of(-9.085602444369052e-5))
                                        .mul_add(t7, R::of(7.704053354589374e-5)),
                                ),
                        ),
                );
            let q33 = R::of(-1.2037044460926135e-11)
                .mul_add(
                    t33,
                    R::of(-3.095240004238149e-12)
                        .mul_add(t6, R::of(-1.2803329034044721e-11))
                        .mul_add(
                            t7,
                            R::of(-1.5820113100293068e-11)
                                .mul_add(t6, R::of(6.912563140289812e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(2.631874466567142e-9)
                                .mul_add(t6, R::of(-2.6702715250603352e-8))
                                .mul_add(
                                    t7,
                                    R::of(-3.5906150003613494e-8)
                                        .mul_add(t6, R::of(1.3075930889425908e-7)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(5.046440381139199e-7)
                        .mul_add(t6, R::of(6.366317211380015e-8))
                        .mul_add(
                            t7,
                            R::of(-2.9152680723193933e-6)
                                .mul_add(t6, R::of(-2.42304416263542e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(9.878577760180477e-6)
                                .mul_add(t6, R::of(1.213498223347118e-5))
                                .mul_add(
                                    t7,
                                    R::of(-2.155790981488709e-5)
                                        .mul_add(t6, R::of(-3.478167277858312e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(3.194905912198229e-5)
                                .mul_add(t6, R::of(6.64125471674615e-5))
                                .mul_add(
                                    t7,
                                    R::of(-3.1521259459691056e-5)
                                        .mul_add(t6, R::of(-9.11976466193405e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.593077876408221e-5)
                                        .mul_add(t6, R::of(7.761466590189724e-5))
                                        .mul_add(
                                            t7,
                                            R::of(-5.494826131736194e-6)
                                                .mul_add(t6, R::of(-4.5749976066352185e-5)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q34 = R::of(-1.7049083962259632e-11)
                .mul_add(
                    t33,
                    R::of(1.3157601961530182e-10)
                        .mul_add(
                            t7,
                            R::of(2.1413694145697772e-10)
                                .mul_add(t6, R::of(1.3018733536596838e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.294990650875268e-9)
                                .mul_add(t6, R::of(-5.555059850812766e-8))
                                .mul_add(
                                    t7,
                                    R::of(-1.2477683980787105e-7)
                                        .mul_add(t6, R::of(4.170548427645478e-7)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(1.0266069570493994e-6)
                        .mul_add(t6, R::of(-3.589261897716454e-7))
                        .mul_add(
                            t7,
                            R::of(-3.8044751828805968e-6)
                                .mul_add(t6, R::of(-1.947768656181482e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(4.804498403106567e-6)
                                .mul_add(t6, R::of(1.3024752367332778e-5))
                                .mul_add(
                                    t7,
                                    R::of(9.731183413338703e-6)
                                        .mul_add(t6, R::of(-1.936331916040481e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-4.0124999823958655e-5)
                                .mul_add(t6, R::of(2.3506328918062825e-5))
                                .mul_add(
                                    t7,
                                    R::of(4.6317343432230134e-5)
                                        .mul_add(t6, R::of(6.624676627883835e-6)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.1573604772326174e-5)
                                        .mul_add(t6, R::of(4.208838182169324e-6))
                                        .mul_add(
                                            t7,
                                            R::of(-9.031060208235345e-6)
                                                .mul_add(t6, R::of(3.532300249035159e-5)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q35 = R::of(-3.43915556026461e-12)
                .mul_add(t6, R::of(-3.095240004238149e-12))
                .mul_add(
                    t33,
                    R::of(4.2079489767632363e-10)
                        .mul_add(t6, R::of(1.678329594825071e-10))
                        .mul_add(
                            t7,
                            R::of(9.195554330118629e-9)
                                .mul_add(t6, R::of(3.728092290902791e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(-2.1274406005836737e-7)
                                .mul_add(t6, R::of(-1.896199598852792e-7))
                                .mul_add(
                                    t7,
                                    R::of(1.308204072122808e-6)
                                        .mul_add(t6, R::of(2.2532684587969286e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-5.459860718399839e-6)
                        .mul_add(t6, R::of(-1.3541224125399695e-5))
                        .mul_add(
                            t7,
                            R::of(1.0817688169048271e-5)
                                .mul_add(t6, R::of(4.991044716993919e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(-3.823339531217156e-6)
                                .mul_add(t6, R::of(-0.0001100683856825582))
                                .mul_add(
                                    t7,
                                    R::of(-4.207802492041714e-5)
                                        .mul_add(t6, R::of(0.0001602615513917089)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.00013129204959668462)
                                .mul_add(t6, R::of(-0.00012536118889637063))
                                .mul_add(
                                    t7,
                                    R::of(-0.0002073595278936905)
                                        .mul_add(t6, R::of(6.502361734994916e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(0.00021629696352997585)
                                        .mul_add(t6, R::of(1.8645656196355573e-5))
                                        .mul_add(
                                            t7,
                                            R::of(-0.0001332199283181088)
                                                .mul_add(t6, R::of(-3.4953199560210786e-5)),
                                        ),
                                ),
                        ),
                );
            let q36 = (R::of(-3.43915556026461e-12) * t6)
                .mul_add(
                    t33,
                    R::of(-7.20929194172937e-10)
                        .mul_add(t6, R::of(-6.685254428150824e-10))
                        .mul_add(
                            t7,
                            R::of(-9.610456992664498e-9)
                                .mul_add(t6, R::of(-7.01823386329678e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.5920411009216043e-7)
                                .mul_add(t6, R::of(3.843192854567691e-7))
                                .mul_add(
                                    t7,
                                    R::of(-2.780107466469074e-6)
                                        .mul_add(t6, R::of(-3.860975978013607e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(1.3253446155151562e-5)
                        .mul_add(t6, R::of(2.197160898488401e-5))
                        .mul_add(
                            t7,
                            R::of(-3.5930499951153e-5)
                                .mul_add(t6, R::of(-7.679172107212789e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(6.902942927154858e-5)
                                .mul_add(t6, R::of(0.0001651268926628143))
                                .mul_add(
                                    t7,
                                    R::of(-8.42106086399227e-5)
                                        .mul_add(t6, R::of(-0.0002626305938779209)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(5.278214295992739e-5)
                                .mul_add(t6, R::of(0.00022289795458866653))
                                .mul_add(
                                    t7,
                                    R::of(1.323947464870235e-6)
                                        .mul_add(t6, R::of(-0.00010223215634958814)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-4.544187056628522e-5)
                                        .mul_add(t6, R::of(-6.233015310186443e-5))
                                        .mul_add(
                                            t7,
                                            R::of(2.289510888223414e-5)
                                                .mul_add(t6, R::of(6.990639912042157e-5)),
                                        ),
                                ),
                        ),
                );
            let q37 = R::of(-1.7049083962259632e-11)
                .mul_add(
                    t33,
                    R::of(-3.442838502890931e-10)
                        .mul_add(
                            t7,
                            R::of(-2.1413694145697772e-10)
                                .mul_add(t6, R::of(1.0421371995848902e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(-4.294990650875268e-9)
                                .mul_add(t6, R::of(1.5747733728469106e-7))
                                .mul_add(
                                    t7,
                                    R::of(1.2477683980787105e-7)
                                        .mul_add(t6, R::of(-8.558019141294401e-7)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-1.0266069570493994e-6)
                        .mul_add(t6, R::of(2.8503658381912556e-6))
                        .mul_add(
                            t7,
                            R::of(3.8044751828805968e-6)
                                .mul_add(t6, R::of(-2.7777552154337213e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(-4.804498403106567e-6)
                                .mul_add(t6, R::of(-5.339074889228459e-7))
                                .mul_add(
                                    t7,
                                    R::of(-9.731183413338703e-6)
                                        .mul_add(t6, R::of(1.0586270288706996e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(4.0124999823958655e-5)
                                .mul_add(t6, R::of(-3.667675577058669e-7))
                                .mul_add(
                                    t7,
                                    R::of(-4.6317343432230134e-5)
                                        .mul_add(t6, R::of(9.143666407274866e-6)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.1573604772326174e-5)
                                        .mul_add(t6, R::of(8.152532596245893e-6))
                                        .mul_add(
                                            t7,
                                            R::of(9.031060208235345e-6)
                                                .mul_add(t6, R::of(3.532300249035159e-5)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q38 = R::of(3.43915556026461e-12)
                .mul_add(t6, R::of(3.095240004238149e-12))
                .mul_add(
                    t33,
                    R::of(8.298857788679049e-11)
                        .mul_add(t6, R::of(-1.678329594825071e-10))
                        .mul_add(
                            t7,
                            R::of(-7.717160742084723e-10)
                                .mul_add(t6, R::of(-3.728092290902791e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.5558652597834677e-7)
                                .mul_add(t6, R::of(1.896199598852792e-7))
                                .mul_add(
                                    t7,
                                    R::of(-1.8827894970403773e-6)
                                        .mul_add(t6, R::of(-2.2532684587969286e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(1.0592562853080688e-5)
                        .mul_add(t6, R::of(1.3541224125399695e-5))
                        .mul_add(
                            t7,
                            R::of(-3.5597678171675716e-5)
                                .mul_add(t6, R::of(-4.991044716993919e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(8.415990156802677e-5)
                                .mul_add(t6, R::of(0.0001100683856825582))
                                .mul_add(
                                    t7,
                                    R::of(-0.00014428914902779694)
                                        .mul_add(t6, R::of(-0.0001602615513917089)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.00020486712821586706)
                                .mul_add(t6, R::of(0.00012536118889637063))
                                .mul_add(
                                    t7,
                                    R::of(-0.00023206272994480772)
                                        .mul_add(t6, R::of(-6.502361734994916e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(0.00019834351824054878)
                                        .mul_add(t6, R::of(-1.8645656196355573e-5))
                                        .mul_add(
                                            t7,
                                            R::of(-0.00011795652239661939)
                                                .mul_add(t6, R::of(3.4953199560210786e-5)),
                                        ),
                                ),
                        ),
                );
            let q39 = R::of(1.719577780132305e-12)
                .mul_add(
                    t33,
                    R::of(-3.095240004238149e-12)
                        .mul_add(t6, R::of(-3.563143684993474e-11))
                        .mul_add(
                            t7,
                            R::of(-1.5820113100293068e-11)
                                .mul_add(t6, R::of(5.168763977314969e-10)),
                        )
                        .mul_add(
                            t26,
                            R::of(2.631874466567142e-9)
                                .mul_add(t6, R::of(-2.9571681680968074e-8))
                                .mul_add(
                                    t7,
                                    R::of(-3.5906150003613494e-8)
                                        .mul_add(t6, R::of(4.911488728150845e-7)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(5.046440381139199e-7)
                        .mul_add(t6, R::of(-2.82514547418797e-6))
                        .mul_add(
                            t7,
                            R::of(-2.9152680723193933e-6)
                                .mul_add(t6, R::of(1.0510424863454667e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(9.878577760180477e-6)
                                .mul_add(t6, R::of(-2.8579376629320886e-5))
                                .mul_add(
                                    t7,
                                    R::of(-2.155790981488709e-5)
                                        .mul_add(t6, R::of(5.889824412951138e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(3.194905912198229e-5)
                                .mul_add(t6, R::of(-9.577291333284923e-5))
                                .mul_add(
                                    t7,
                                    R::of(-3.1521259459691056e-5)
                                        .mul_add(t6, R::of(0.00011613652855130438)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(1.593077876408221e-5)
                                        .mul_add(t6, R::of(-0.00010203558278450193))
                                        .mul_add(
                                            t7,
                                            R::of(-5.494826131736194e-6)
                                                .mul_add(t6, R::of(5.33816790270969e-5)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q40 = R::of(1.2201848650491212e-12)
                .mul_add(
                    t7,
                    R::of(3.1376182244120256e-13)
                        .mul_add(t6, R::of(-4.308540182304167e-11)),
                )
                .mul_add(
                    t33,
                    R::of(2.2805261301751198e-12)
                        .mul_add(t6, R::of(-1.5676597180127068e-9))
                        .mul_add(
                            t7,
                            R::of(-7.72374667696363e-11)
                                .mul_add(t6, R::of(4.631828943245648e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(6.442267724610739e-9)
                                .mul_add(t6, R::of(2.2267361905355897e-8))
                                .mul_add(
                                    t7,
                                    R::of(-7.726704322143388e-8)
                                        .mul_add(t6, R::of(-4.993980741272349e-8)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(4.645880094036639e-7)
                        .mul_add(t6, R::of(1.198324716842382e-6))
                        .mul_add(
                            t7,
                            R::of(-6.843791836451286e-7)
                                .mul_add(t6, R::of(-3.3925076642661348e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(-1.0094713937713733e-6)
                                .mul_add(t6, R::of(1.0935301878838771e-5))
                                .mul_add(
                                    t7,
                                    R::of(7.471620191423471e-6)
                                        .mul_add(t6, R::of(-1.7440723375430047e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-1.1901687297473364e-5)
                                .mul_add(t6, R::of(3.345708981433508e-5))
                                .mul_add(
                                    t7,
                                    R::of(1.3776872399242915e-5)
                                        .mul_add(t6, R::of(-4.1297073200372e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-9.640028373498096e-6)
                                        .mul_add(t6, R::of(4.228073950780542e-5))
                                        .mul_add(
                                            t7,
                                            R::of(8.667060023913046e-6)
                                                .mul_add(t6, R::of(-2.6883936185285835e-5)),
                                        ),
                                ),
                        ),
                );
            let q41 = R::of(1.0458727414706752e-12)
                .mul_add(
                    t7,
                    R::of(6.275236448824051e-13)
                        .mul_add(t6, R::of(7.502006601874579e-11)),
                )
                .mul_add(
                    t33,
                    R::of(6.562973556474759e-11)
                        .mul_add(t6, R::of(-3.667178554451637e-10))
                        .mul_add(
                            t7,
                            R::of(-5.62086771246323e-10)
                                .mul_add(t6, R::of(-5.2223457339336064e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(-4.738053897725149e-8)
                                .mul_add(t6, R::of(4.659714793563779e-7))
                                .mul_add(
                                    t7,
                                    R::of(6.531773639373166e-7)
                                        .mul_add(t6, R::of(-1.9829551904564616e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-3.393879014452295e-6)
                        .mul_add(t6, R::of(3.5075633000573293e-6))
                        .mul_add(
                            t7,
                            R::of(9.825070236812153e-6)
                                .mul_add(t6, R::of(1.6252613902891292e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(-2.0616722311961502e-6)
                                .mul_add(t6, R::of(-7.8179969734271e-6))
                                .mul_add(
                                    t7,
                                    R::of(-3.0500037491507416e-5)
                                        .mul_add(t6, R::of(1.2596840489813196e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(6.90034068178458e-5)
                                .mul_add(t6, R::of(1.7822001161054925e-5))
                                .mul_add(
                                    t7,
                                    R::of(-7.928023944476324e-5)
                                        .mul_add(t6, R::of(-5.327959329241002e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-2.3264892256279247e-5)
                                        .mul_add(t6, R::of(5.195596936790885e-5))
                                        .mul_add(
                                            t7,
                                            R::of(6.165405178969104e-5)
                                                .mul_add(t6, R::of(-1.2037583366545896e-5)),
                                        ),
                                ),
                        ),
                );
            let q42 = R::of(-1.7431212357844587e-13)
                .mul_add(
                    t7,
                    R::of(3.1376182244120256e-13)
                        .mul_add(t6, R::of(5.0251375281345956e-11)),
                )
                .mul_add(
                    t33,
                    R::of(2.2805261301751198e-12)
                        .mul_add(t6, R::of(1.3070340980442316e-9))
                        .mul_add(
                            t7,
                            R::of(-7.72374667696363e-11)
                                .mul_add(t6, R::of(1.0214644470132947e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(6.442267724610739e-9)
                                .mul_add(t6, R::of(-1.1081526016451593e-7))
                                .mul_add(
                                    t7,
                                    R::of(-7.726704322143388e-8)
                                        .mul_add(t6, R::of(4.6484118294059406e-7)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(4.645880094036639e-7)
                        .mul_add(t6, R::of(-8.795598116924292e-7))
                        .mul_add(
                            t7,
                            R::of(-6.843791836451286e-7)
                                .mul_add(t6, R::of(3.279294855960266e-7)),
                        )
                        .mul_add(
                            t26,
                            R::of(-1.0094713937713733e-6)
                                .mul_add(t6, R::of(1.8472950782852083e-6))
                                .mul_add(
                                    t7,
                                    R::of(7.471620191423471e-6)
                                        .mul_add(t6, R::of(-5.154078916235134e-6)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-1.1901687297473364e-5)
                                .mul_add(t6, R::of(8.109695885915418e-6))
                                .mul_add(
                                    t7,
                                    R::of(1.3776872399242915e-5)
                                        .mul_add(t6, R::of(-4.892245989686486e-6)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-9.640028373498096e-6)
                                        .mul_add(t6, R::of(-1.6111315701332743e-9))
                                        .mul_add(
                                            t7,
                                            R::of(8.667060023913046e-6)
                                                .mul_add(t6, R::of(1.4846352818739939e-5)),
                                        ),
                                ),
                        ),
                );
            let q43 = R::of(-1.2323540139329858e-9)
                .mul_add(
                    t7,
                    R::of(-4.992581928914001e-10)
                        .mul_add(t6, R::of(-1.6532064100589473e-8)),
                )
                .mul_add(
                    t26,
                    R::of(-1.2675500425923741e-8)
                        .mul_add(t6, R::of(3.568582176189976e-7))
                        .mul_add(
                            t7,
                            R::of(1.1651241422704212e-7)
                                .mul_add(t6, R::of(-1.2897732740433219e-6)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-2.2619019660806723e-6)
                        .mul_add(t6, R::of(2.458559478331158e-6))
                        .mul_add(
                            t7,
                            R::of(1.9169872263183814e-5)
                                .mul_add(t6, R::of(4.292215848440861e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(-7.703994199701459e-5)
                                .mul_add(t6, R::of(-7.126769504939835e-5))
                                .mul_add(
                                    t7,
                                    R::of(0.00017943460044990775)
                                        .mul_add(t6, R::of(0.00019417960908421232)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-0.00026049920431698935)
                                .mul_add(t6, R::of(-0.000442487289848762))
                                .mul_add(
                                    t7,
                                    R::of(0.00023940831369560783)
                                        .mul_add(t6, R::of(0.00048572935662752407)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-0.00014710698484981337)
                                        .mul_add(t6, R::of(-0.00050000649685037))
                                        .mul_add(
                                            t7,
                                            R::of(4.917519723817313e-5)
                                                .mul_add(t6, R::of(0.00017549160889832312)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q44 = R::of(3.6069721831962476e-9)
                .mul_add(t6, R::of(9.985163857828002e-10))
                .mul_add(
                    t7,
                    R::of(4.128499116880809e-8).mul_add(t6, R::of(-6.085200420745065e-9)),
                )
                .mul_add(
                    t26,
                    R::of(-1.0976093694175757e-6)
                        .mul_add(t6, R::of(-8.894447506690982e-7))
                        .mul_add(
                            t7,
                            R::of(1.1049521997431647e-5)
                                .mul_add(t6, R::of(1.3913206984541391e-5)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-4.4681224682693906e-5)
                        .mul_add(t6, R::of(-9.257412357447524e-5))
                        .mul_add(
                            t7,
                            R::of(0.00011726097952314991)
                                .mul_add(t6, R::of(0.0003544613863953765)),
                        )
                        .mul_add(
                            t26,
                            R::of(-9.519718700618308e-5)
                                .mul_add(t6, R::of(-0.0008302751509342965))
                                .mul_add(
                                    t7,
                                    R::of(-0.00011640564070281423)
                                        .mul_add(t6, R::of(0.0012315479294433)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.0007204344903119147)
                                .mul_add(t6, R::of(-0.0011362510746026843))
                                .mul_add(
                                    t7,
                                    R::of(-0.0010503906266943936)
                                        .mul_add(t6, R::of(0.0005078291851329854)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(0.0010779583713081769)
                                        .mul_add(t6, R::of(7.684562608734792e-6))
                                        .mul_add(
                                            t7,
                                            R::of(-0.00037406578156282084)
                                                .mul_add(t6, R::of(-2.8489615149885238e-5)),
                                        ),
                                ),
                        ),
                );
            let q45 = R::of(5.788500787146669e-10)
                .mul_add(t6, R::of(9.985163857828002e-10))
                .mul_add(
                    t7,
                    R::of(-4.4777181416650285e-8)
                        .mul_add(t6, R::of(-3.7521401693337616e-8)),
                )
                .mul_add(
                    t26,
                    R::of(-1.4594781969026951e-6)
                        .mul_add(t6, R::of(-1.221856013465027e-6))
                        .mul_add(
                            t7,
                            R::of(1.7638245496513915e-5)
                                .mul_add(t6, R::of(2.013861941769271e-5)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-0.00010144655702207917)
                        .mul_add(t6, R::of(-0.00014037016563627177))
                        .mul_add(
                            t7,
                            R::of(0.0003291033110173063)
                                .mul_add(t6, R::of(0.0005692590703921053)),
                        )
                        .mul_add(
                            t26,
                            R::of(-0.0006385501358209874)
                                .mul_add(t6, R::of(-0.001355466690283393))
                                .mul_add(
                                    t7,
                                    R::of(0.0007753796396807724)
                                        .mul_add(t6, R::of(0.0019538589398574793)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-0.0005352735600790698)
                                .mul_add(t6, R::of(-0.001711383022651207))
                                .mul_add(
                                    t7,
                                    R::of(8.197704996712456e-5)
                                        .mul_add(t6, R::of(0.0006645599459196793)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(0.00010865058716761975)
                                        .mul_add(t6, R::of(0.00011371951969381585))
                                        .mul_add(
                                            t7,
                                            R::of(-3.110219994528956e-5)
                                                .mul_add(t6, R::of(-5.6979230299770476e-5)),
                                        ),
                                ),
                        ),
                );
            let q46 = R::of(1.2915718683375801e-9)
                .mul_add(t6, R::of(-9.985163857828002e-10))
                .mul_add(
                    t7,
                    R::of(4.460351606997465e-8).mul_add(t6, R::of(6.085200420745065e-9)),
                )
                .mul_add(
                    t26,
                    R::of(9.860551926116904e-7)
                        .mul_add(t6, R::of(8.894447506690982e-7))
                        .mul_add(
                            t7,
                            R::of(-1.2099100076344583e-5)
                                .mul_add(t6, R::of(-1.3913206984541391e-5)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(8.023839261942262e-5)
                        .mul_add(t6, R::of(9.257412357447524e-5))
                        .mul_add(
                            t7,
                            R::of(-0.00027573054735719377)
                                .mul_add(t6, R::of(-0.0003544613863953765)),
                        )
                        .mul_add(
                            t26,
                            R::of(0.0006837268918052622)
                                .mul_add(t6, R::of(0.0008302751509342965))
                                .mul_add(
                                    t7,
                                    R::of(-0.0011249003035996939)
                                        .mul_add(t6, R::of(-0.0012315479294433)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.0015148933057013846)
                                .mul_add(t6, R::of(0.0011362510746026843))
                                .mul_add(
                                    t7,
                                    R::of(-0.0013197308900633887)
                                        .mul_add(t6, R::of(-0.0005078291851329854)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(0.0010414963692167102)
                                        .mul_add(t6, R::of(-7.684562608734792e-6))
                                        .mul_add(
                                            t7,
                                            R::of(-0.0003491840216065892)
                                                .mul_add(t6, R::of(2.8489615149885238e-5)),
                                        ),
                                ),
                        ),
                );
            let q47 = R::of(-5.041962222110147e-10)
                .mul_add(
                    t7,
                    R::of(-4.992581928914001e-10)
                        .mul_add(t6, R::of(-2.492659241489426e-8)),
                )
                .mul_add(
                    t26,
                    R::of(-1.2675500425923741e-8)
                        .mul_add(t6, R::of(-1.1162934888901757e-7))
                        .mul_add(
                            t7,
                            R::of(1.1651241422704212e-7)
                                .mul_add(t6, R::of(-2.2414658816683393e-6)),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-2.2619019660806723e-6)
                        .mul_add(t6, R::of(2.0438621998454193e-5))
                        .mul_add(
                            t7,
                            R::of(1.9169872263183814e-5)
                                .mul_add(t6, R::of(-8.028989656761624e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(-7.703994199701459e-5)
                                .mul_add(t6, R::of(0.00022929316032605114))
                                .mul_add(
                                    t7,
                                    R::of(0.00017943460044990775)
                                        .mul_add(t6, R::of(-0.00041615667533769494)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-0.00026049920431698935)
                                .mul_add(t6, R::of(0.0006683616180798599))
                                .mul_add(
                                    t7,
                                    R::of(0.00023940831369560783)
                                        .mul_add(t6, R::of(-0.0006581883461045043)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-0.00014710698484981337)
                                        .mul_add(t6, R::of(0.0005721950819265229))
                                        .mul_add(
                                            t7,
                                            R::of(4.917519723817313e-5)
                                                .mul_add(t6, R::of(-0.00018171204888738104)),
                                        ),
                                ),
                        ),
                ) * t6;
            let q48 = R::of(-3.009261115231534e-10)
                .mul_add(
                    t33,
                    R::of(-7.428576010171557e-11)
                        .mul_add(t6, R::of(-2.944765677830286e-10))
                        .mul_add(
                            t7,
                            R::of(-3.480424882064475e-10)
                                .mul_add(t6, R::of(1.4516382594608605e-7)),
                        )
                        .mul_add(
                            t26,
                            R::of(5.2637489331342835e-8)
                                .mul_add(t6, R::of(-5.073515897614637e-7))
                                .mul_add(
                                    t7,
                                    R::of(-6.463107000650428e-7)
                                        .mul_add(t6, R::of(2.2229082512024043e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(8.074304609822718e-6)
                        .mul_add(t6, R::of(9.549475817070024e-7))
                        .mul_add(
                            t7,
                            R::of(-4.081375301247151e-5)
                                .mul_add(t6, R::of(-3.1499574114260457e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(0.00011854293312216572)
                                .mul_add(t6, R::of(0.00013348480456818298))
                                .mul_add(
                                    t7,
                                    R::of(-0.0002155790981488709)
                                        .mul_add(t6, R::of(-0.0003130350550072481)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.0002555924729758583)
                                .mul_add(t6, R::of(0.0004648878301722305))
                                .mul_add(
                                    t7,
                                    R::of(-0.00018912755675814632)
                                        .mul_add(t6, R::of(-0.0004559882330967025)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(6.372311505632884e-5)
                                        .mul_add(t6, R::of(0.00023284399770569174))
                                        .mul_add(
                                            t7,
                                            R::of(-1.0989652263472388e-5)
                                                .mul_add(t6, R::of(-4.5749976066352185e-5)),
                                        ),
                                ),
                        ),
                );
            let q49 = R::of(-4.2622709905649075e-10)
                .mul_add(
                    t33,
                    R::of(3.026248451151942e-9)
                        .mul_add(
                            t7,
                            R::of(4.7110127120535095e-9)
                                .mul_add(t6, R::of(2.733934042685336e-7)),
                        )
                        .mul_add(
                            t26,
                            R::of(8.589981301750537e-8)
                                .mul_add(t6, R::of(-1.0554613716544255e-6))
                                .mul_add(
                                    t7,
                                    R::of(-2.2459831165416788e-6)
                                        .mul_add(t6, R::of(7.089932326997313e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(1.642571131279039e-5)
                        .mul_add(t6, R::of(-5.383892846574681e-6))
                        .mul_add(
                            t7,
                            R::of(-5.326265256032835e-5)
                                .mul_add(t6, R::of(-2.5320992530359263e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(5.76539808372788e-5)
                                .mul_add(t6, R::of(0.00014327227604066055))
                                .mul_add(
                                    t7,
                                    R::of(9.731183413338704e-5)
                                        .mul_add(t6, R::of(-0.0001742698724436433)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-0.00032099999859166924)
                                .mul_add(t6, R::of(0.00016454430242643977))
                                .mul_add(
                                    t7,
                                    R::of(0.00027790406059338083)
                                        .mul_add(t6, R::of(3.312338313941917e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-4.62944190893047e-5)
                                        .mul_add(t6, R::of(1.262651454650797e-5))
                                        .mul_add(
                                            t7,
                                            R::of(-1.806212041647069e-5)
                                                .mul_add(t6, R::of(3.532300249035159e-5)),
                                        ),
                                ),
                        ),
                );
            let q50 = R::of(-8.597888900661526e-11)
                .mul_add(
                    t33,
                    R::of(-7.428576010171557e-11)
                        .mul_add(t6, R::of(9.678282646555444e-9))
                        .mul_add(
                            t7,
                            R::of(3.6923251086151563e-9)
                                .mul_add(t6, R::of(1.9310664093249121e-7)),
                        )
                        .mul_add(
                            t26,
                            R::of(7.456184581805581e-8)
                                .mul_add(t6, R::of(-4.04213714110898e-6))
                                .mul_add(
                                    t7,
                                    R::of(-3.413159277935026e-6)
                                        .mul_add(t6, R::of(2.2239469226087735e-5)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(3.605229534075086e-5)
                        .mul_add(t6, R::of(-8.189791077599758e-5))
                        .mul_add(
                            t7,
                            R::of(-0.0001895771377555957)
                                .mul_add(t6, R::of(0.00014062994619762752)),
                        )
                        .mul_add(
                            t26,
                            R::of(0.0005989253660392702)
                                .mul_add(t6, R::of(-4.205673484338871e-5))
                                .mul_add(
                                    t7,
                                    R::of(-0.001100683856825582)
                                        .mul_add(t6, R::of(-0.0003787022242837543)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.0012820924111336712)
                                .mul_add(t6, R::of(0.0009190443471767924))
                                .mul_add(
                                    t7,
                                    R::of(-0.0007521671333782238)
                                        .mul_add(t6, R::of(-0.0010367976394684525)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(0.00026009446939979664)
                                        .mul_add(t6, R::of(0.0006488908905899275))
                                        .mul_add(
                                            t7,
                                            R::of(3.7291312392711145e-5)
                                                .mul_add(t6, R::of(-0.0001332199283181088)),
                                        ),
                                ),
                        ),
                );
            let q51 = R::of(-8.597888900661526e-11)
                .mul_add(
                    t33,
                    R::of(-1.658137146597755e-8)
                        .mul_add(
                            t7,
                            R::of(-1.4707559741931812e-8)
                                .mul_add(t6, R::of(-2.0181959684595444e-7)),
                        )
                        .mul_add(
                            t26,
                            R::of(-1.403646772659356e-7)
                                .mul_add(t6, R::of(6.824878091751049e-6))
                                .mul_add(
                                    t7,
                                    R::of(6.917747138221844e-6)
                                        .mul_add(t6, R::of(-4.7261826929974264e-5)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-6.17756156482177e-5)
                        .mul_add(t6, R::of(0.00019880169232727341))
                        .mul_add(
                            t7,
                            R::of(0.0003076025257883761)
                                .mul_add(t6, R::of(-0.00046709649936498894)),
                        )
                        .mul_add(
                            t26,
                            R::of(-0.0009215006528655346)
                                .mul_add(t6, R::of(0.0007593237219870344))
                                .mul_add(
                                    t7,
                                    R::of(0.0016512689266281431)
                                        .mul_add(t6, R::of(-0.0007578954777593043)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-0.002101044751023367)
                                .mul_add(t6, R::of(0.0003694750007194917))
                                .mul_add(
                                    t7,
                                    R::of(0.001337387727531999)
                                        .mul_add(t6, R::of(6.619737324351175e-6)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-0.00040892862539835254)
                                        .mul_add(t6, R::of(-0.00013632561169885565))
                                        .mul_add(
                                            t7,
                                            R::of(-0.00012466030620372887)
                                                .mul_add(t6, R::of(2.289510888223414e-5)),
                                        ),
                                ),
                        ),
                );
            let q52 = R::of(-4.2622709905649075e-10)
                .mul_add(
                    t33,
                    R::of(-7.918528556649142e-9)
                        .mul_add(
                            t7,
                            R::of(-4.7110127120535095e-9)
                                .mul_add(t6, R::of(2.1884881191282697e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(-8.589981301750537e-8)
                                .mul_add(t6, R::of(2.99206940840913e-6))
                                .mul_add(
                                    t7,
                                    R::of(2.2459831165416788e-6)
                                        .mul_add(t6, R::of(-1.454863254020048e-5)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-1.642571131279039e-5)
                        .mul_add(t6, R::of(4.275548757286884e-5))
                        .mul_add(
                            t7,
                            R::of(5.326265256032835e-5)
                                .mul_add(t6, R::of(-3.611081780063838e-5)),
                        )
                        .mul_add(
                            t26,
                            R::of(-5.76539808372788e-5)
                                .mul_add(t6, R::of(-5.872982378151304e-6))
                                .mul_add(
                                    t7,
                                    R::of(-9.731183413338704e-5)
                                        .mul_add(t6, R::of(9.527643259836296e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.00032099999859166924)
                                .mul_add(t6, R::of(-2.5673729039410683e-6))
                                .mul_add(
                                    t7,
                                    R::of(-0.00027790406059338083)
                                        .mul_add(t6, R::of(4.571833203637434e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(4.62944190893047e-5)
                                        .mul_add(t6, R::of(2.445759778873768e-5))
                                        .mul_add(
                                            t7,
                                            R::of(1.806212041647069e-5)
                                                .mul_add(t6, R::of(3.532300249035159e-5)),
                                        ),
                                ),
                        ),
                );
            let q53 = R::of(8.597888900661526e-11)
                .mul_add(
                    t33,
                    R::of(7.428576010171557e-11)
                        .mul_add(t6, R::of(1.9087372913961815e-9))
                        .mul_add(
                            t7,
                            R::of(-3.6923251086151563e-9)
                                .mul_add(t6, R::of(-1.6206037558377918e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(-7.456184581805581e-8)
                                .mul_add(t6, R::of(2.956143993588589e-6))
                                .mul_add(
                                    t7,
                                    R::of(3.413159277935026e-6)
                                        .mul_add(t6, R::of(-3.2007421449686416e-5)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-3.605229534075086e-5)
                        .mul_add(t6, R::of(0.00015888844279621033))
                        .mul_add(
                            t7,
                            R::of(0.0001895771377555957)
                                .mul_add(t6, R::of(-0.00046276981623178434)),
                        )
                        .mul_add(
                            t26,
                            R::of(-0.0005989253660392702)
                                .mul_add(t6, R::of(0.0009257589172482945))
                                .mul_add(
                                    t7,
                                    R::of(0.001100683856825582)
                                        .mul_add(t6, R::of(-0.0012986023412501725)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-0.0012820924111336712)
                                .mul_add(t6, R::of(0.0014340698975110694))
                                .mul_add(
                                    t7,
                                    R::of(0.0007521671333782238)
                                        .mul_add(t6, R::of(-0.0011603136497240387)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-0.00026009446939979664)
                                        .mul_add(t6, R::of(0.0005950305547216463))
                                        .mul_add(
                                            t7,
                                            R::of(-3.7291312392711145e-5)
                                                .mul_add(t6, R::of(-0.00011795652239661939)),
                                        ),
                                ),
                        ),
                );
            let q54 = R::of(4.298944450330763e-11)
                .mul_add(
                    t33,
                    R::of(-7.428576010171557e-11)
                        .mul_add(t6, R::of(-8.19523047548499e-10))
                        .mul_add(
                            t7,
                            R::of(-3.480424882064475e-10)
                                .mul_add(t6, R::of(1.0854404352361435e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(5.2637489331342835e-8)
                                .mul_add(t6, R::of(-5.618619519383934e-7))
                                .mul_add(
                                    t7,
                                    R::of(-6.463107000650428e-7)
                                        .mul_add(t6, R::of(8.349530837856437e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(8.074304609822718e-6)
                        .mul_add(t6, R::of(-4.237718211281955e-5))
                        .mul_add(
                            t7,
                            R::of(-4.081375301247151e-5)
                                .mul_add(t6, R::of(0.00013663552322491066)),
                        )
                        .mul_add(
                            t26,
                            R::of(0.00011854293312216572)
                                .mul_add(t6, R::of(-0.0003143731429225297))
                                .mul_add(
                                    t7,
                                    R::of(-0.0002155790981488709)
                                        .mul_add(t6, R::of(0.0005300841971656024)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.0002555924729758583)
                                .mul_add(t6, R::of(-0.0006704103933299445))
                                .mul_add(
                                    t7,
                                    R::of(-0.00018912755675814632)
                                        .mul_add(t6, R::of(0.000580682642756522)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(6.372311505632884e-5)
                                        .mul_add(t6, R::of(-0.00030610674835350574))
                                        .mul_add(
                                            t7,
                                            R::of(-1.0989652263472388e-5)
                                                .mul_add(t6, R::of(5.33816790270969e-5)),
                                        ),
                                ),
                        ),
                );
            let q55 = R::of(3.172480649127715e-11)
                .mul_add(t6, R::of(7.844045561030064e-12))
                .mul_add(
                    t33,
                    R::of(-1.0340496437530001e-9)
                        .mul_add(t6, R::of(5.245210099402776e-11))
                        .mul_add(
                            t7,
                            R::of(-3.448851379627955e-8)
                                .mul_add(t6, R::of(-1.6219868021623623e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(9.263657886491297e-8)
                                .mul_add(t6, R::of(1.2240308676760403e-7))
                                .mul_add(
                                    t7,
                                    R::of(4.008125142964061e-7)
                                        .mul_add(t6, R::of(-1.3135397347643758e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-7.990369186035759e-7)
                        .mul_add(t6, R::of(6.968820141054958e-6))
                        .mul_add(
                            t7,
                            R::of(1.6776546035793346e-5)
                                .mul_add(t6, R::of(-8.896929387386672e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(-4.0710091971193615e-5)
                                .mul_add(t6, R::of(-1.1104185331485107e-5))
                                .mul_add(
                                    t7,
                                    R::of(0.00010935301878838771)
                                        .mul_add(t6, R::of(6.724458172281123e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-0.00013952578700344038)
                                .mul_add(t6, R::of(-8.331181108231355e-5))
                                .mul_add(
                                    t7,
                                    R::of(0.00020074253888601048)
                                        .mul_add(t6, R::of(6.888436199621458e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-0.000165188292801488)
                                        .mul_add(t6, R::of(-2.8920085120494286e-5))
                                        .mul_add(
                                            t7,
                                            R::of(8.456147901561083e-5)
                                                .mul_add(t6, R::of(8.667060023913046e-6)),
                                        ),
                                ),
                        ),
                );
            let q56 = R::of(2.7192691278237558e-11)
                .mul_add(t6, R::of(1.5688091122060128e-11))
                .mul_add(
                    t33,
                    R::of(1.800481584449899e-9)
                        .mul_add(t6, R::of(1.5094839179891946e-9))
                        .mul_add(
                            t7,
                            R::of(-8.067792819793602e-9)
                                .mul_add(t6, R::of(-1.1803822196172783e-8)),
                        )
                        .mul_add(
                            t26,
                            R::of(-1.0444691467867212e-6)
                                .mul_add(t6, R::of(-9.002302405677782e-7))
                                .mul_add(
                                    t7,
                                    R::of(8.387486628414801e-6)
                                        .mul_add(t6, R::of(1.1104015186934383e-5)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(-3.1727283047303385e-5)
                        .mul_add(t6, R::of(-5.090818521678443e-5))
                        .mul_add(
                            t7,
                            R::of(4.9105886200802606e-5)
                                .mul_add(t6, R::of(0.000127725913078558)),
                        )
                        .mul_add(
                            t26,
                            R::of(1.950313668346955e-5)
                                .mul_add(t6, R::of(-2.267839454315765e-5))
                                .mul_add(
                                    t7,
                                    R::of(-7.8179969734271e-5)
                                        .mul_add(t6, R::of(-0.00027450033742356674)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(0.00010077472391850557)
                                .mul_add(t6, R::of(0.00048302384772492055))
                                .mul_add(
                                    t7,
                                    R::of(0.00010693200696632954)
                                        .mul_add(t6, R::of(-0.0003964011972238162)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-0.0002131183731696401)
                                        .mul_add(t6, R::of(-6.979467676883774e-5))
                                        .mul_add(
                                            t7,
                                            R::of(0.0001039119387358177)
                                                .mul_add(t6, R::of(6.165405178969104e-5)),
                                        ),
                                ),
                        ),
                );
            let q57 = R::of(-4.532115213039593e-12)
                .mul_add(t6, R::of(7.844045561030064e-12))
                .mul_add(
                    t33,
                    R::of(1.206033006752303e-9)
                        .mul_add(t6, R::of(5.245210099402776e-11))
                        .mul_add(
                            t7,
                            R::of(2.8754750156973094e-8)
                                .mul_add(t6, R::of(-1.6219868021623623e-9)),
                        )
                        .mul_add(
                            t26,
                            R::of(2.0429288940265893e-7)
                                .mul_add(t6, R::of(1.2240308676760403e-7))
                                .mul_add(
                                    t7,
                                    R::of(-1.9946746829612867e-6)
                                        .mul_add(t6, R::of(-1.3135397347643758e-6)),
                                ),
                        ),
                )
                .mul_add(
                    t254,
                    R::of(7.437458927049505e-6)
                        .mul_add(t6, R::of(6.968820141054958e-6))
                        .mul_add(
                            t7,
                            R::of(-1.231383736369401e-5)
                                .mul_add(t6, R::of(-8.896929387386672e-6)),
                        )
                        .mul_add(
                            t26,
                            R::of(3.935153827152319e-6)
                                .mul_add(t6, R::of(-1.1104185331485107e-5))
                                .mul_add(
                                    t7,
                                    R::of(1.8472950782852083e-5)
                                        .mul_add(t6, R::of(6.724458172281123e-5)),
                                ),
                        )
                        .mul_add(
                            t33,
                            R::of(-4.1232631329881075e-5)
                                .mul_add(t6, R::of(-8.331181108231355e-5))
                                .mul_add(
                                    t7,
                                    R::of(4.8658175315492505e-5)
                                        .mul_add(t6, R::of(6.888436199621458e-5)),
                                )
                                .mul_add(
                                    t26,
                                    R::of(-1.9568983958745943e-5)
                                        .mul_add(t6, R::of(-2.8920085120494286e-5))
                                        .mul_add(
                                            t7,
                                            R::of(-3.2222631402665485e-9)
                                                .mul_add(t6, R::of(8.667060023913046e-6)),
                                        ),
                                ),
                        ),
                );
            let q58 = ::hodograph::horner(::hodograph::constants(Self::Q58), t6);
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
/// | homogeneous coordinates | 193: 84 +, 109 × | 76 +, 94 × | 2 +, 1 × | 6 +, 14 × |
/// | point | 178: 84 +, 93 ×, 1 ÷ | 76 +, 83 × | 2 +, 1 × | 6 +, 9 ×, 1 ÷ |
/// | point, separated | 184: 84 +, 98 ×, 2 ÷ | 76 +, 89 ×, 1 ÷ | 2 +, 3 ×, 1 ÷ | 6 +, 6 × |
/// | point and first derivatives | 439: 203 +, 233 ×, 3 ÷ | 186 +, 208 ×, 2 ÷ | 2 +, 7 ×, 1 ÷ | 15 +, 18 × |
/// | point, first and second derivatives | 672: 310 +, 359 ×, 3 ÷ | 280 +, 310 ×, 2 ÷ | 4 +, 13 ×, 1 ÷ | 26 +, 36 × |
/// | unit normal | 819: 405 +, 412 ×, 1 ÷, 1 √ | 391 +, 388 × | 3 × | 14 +, 21 ×, 1 ÷, 1 √ |
/// | everything: derivatives, normal, fundamental forms, curvatures | 2383: 1142 +, 1229 ×, 8 ÷, 4 √ | 1045 +, 1076 ×, 3 ÷ | 4 +, 15 ×, 1 ÷ | 93 +, 138 ×, 4 ÷, 4 √ |
///
/// | error at most | `f64` plain | fused | `f32` plain | fused | size from | to | each, `f64` plain | relative |
/// | --- | --- | --- | --- | --- | --- | --- | --- | --- |
/// | homogeneous | 7.81e2 | 6.83e2 | 4.21e11 | 3.68e11 | 5.9e17 | 6.76e17 | 4.44e1, 7.81e2, 8.06e1, 3.65e1 | 1.13e-15, 1.65e-15, –, – |
/// | point | 3.29e-15 | 2.94e-15 | 1.81e-6 | 1.61e-6 | 1.24e1 | 1.26e1 | 3.11e-15, 3.29e-15, 3.03e-15 | 3.71e-16, –, – |
/// | separated point | 3.19e-15 | 2.86e-15 | 1.75e-6 | 1.57e-6 | 1.24e1 | 1.26e1 | 3.01e-15, 3.19e-15, 3.07e-15 | 3.67e-16, –, – |
/// | partial u | 6.35e-15 | 5.62e-15 | 3.45e-6 | 3.06e-6 | 2.57e0 | 2.85e0 | 3.24e-15, 6.35e-15, 5.08e-15 | –, –, – |
/// | partial v | 3.14e-15 | 2.71e-15 | 1.69e-6 | 1.46e-6 | 4.78e0 | 4.92e0 | 3.14e-15, 2.38e-15, 2.3e-15 | 8.85e-16, 6.26e-15, – |
/// | partial uu | 1.62e-14 | 1.53e-14 | 8.8e-6 | 8.33e-6 | 5.54e0 | 6.27e0 | 5.79e-15, 1.28e-14, 1.62e-14 | –, –, – |
/// | partial uv | 5.47e-15 | 4.66e-15 | 2.95e-6 | 2.51e-6 | 1.67e0 | 1.9e0 | 5.47e-15, 4.29e-15, 4.5e-15 | –, –, – |
/// | partial vv | 2.05e-14 | 1.85e-14 | 1.15e-5 | 1.03e-5 | 4.18e0 | 4.46e0 | 1.33e-14, 1.74e-14, 2.05e-14 | –, –, – |
/// | unit normal | 6.42e-15 | 5.34e-15 | 3.48e-6 | 2.89e-6 | 9.48e-1 | 1e0 | 2.22e-15, 6.42e-15, 3.69e-15 | –, –, – |
/// | first form | 5.2e-14 | 4.56e-14 | 2.85e-5 | 2.5e-5 | 2.64e1 | 2.82e1 | 5.2e-14, 3.49e-14, 4.73e-14 | 7.85e-15, –, 2.53e-15 |
/// | second form | 5.01e-14 | 4.55e-14 | 2.74e-5 | 2.5e-5 | 5.73e0 | 7.99e0 | 5.01e-14, 4.68e-14, 4.65e-14 | 1.73e-14, –, – |
/// | gaussian | 1.55e-13 | 1.39e-13 | 8.42e-5 | 7.53e-5 | 5.7e-2 | 2.68e0 | 1.55e-13 | – |
/// | mean | 3.4e-14 | 3.05e-14 | 1.86e-5 | 1.66e-5 | 3.94e-1 | 1.33e0 | 3.4e-14 | – |
/// | principal | 8.31e-14 | 7.45e-14 | 4.52e-5 | 4.06e-5 | 7.69e-1 | 2.97e0 | 8.3e-14, 8.31e-14 | –, – |
/// | speeds | 8.52e-15 | 7.69e-15 | 4.67e-6 | 4.24e-6 | 5.12e0 | 5.31e0 | 8.52e-15, 5.21e-15 | 3.44e-15, 1.34e-15 |
/// | normal u | 1.04e-13 | 9.49e-14 | 5.63e-5 | 5.2e-5 | 1.7e0 | 4.57e0 | 1.04e-13, 9.55e-14, 6.45e-14 | –, –, – |
/// | normal v | 1.56e-13 | 1.39e-13 | 8.46e-5 | 7.55e-5 | 4.82e-1 | 3.78e0 | 1.56e-13, 1.16e-13, 7.77e-14 | –, –, – |
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
                errors: [781.0, 683.0, 421000000000.0, 368000000000.0],
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
                errors: [3.14e-15, 2.71e-15, 1.69e-6, 1.46e-6],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 4.78,
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
                size: 4.18,
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
                size: 26.4,
                most: 28.2,
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
                errors: [1.55e-13, 1.39e-13, 8.42e-5, 7.53e-5],
                relative_errors: [
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                    f64::INFINITY,
                ],
                size: 0.057,
                most: 2.68,
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
                most: 2.97,
            },
            speeds: ::hodograph::Bound {
                errors: [8.52e-15, 7.69e-15, 4.67e-6, 4.24e-6],
                relative_errors: [3.44e-15, 3.13e-15, 1.89e-6, 1.72e-6],
                size: 5.12,
                most: 5.31,
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
                size: 0.482,
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
        /// The polynomial `q59` of v.
        const Q59: [f64; 4] = [
            6.0116551489365795e37,
            -2.495404024086882e37,
            -1.361129467683754e37,
            9.074196451225026e36,
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
            let t722 = u * p4;
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
                t722,
                t723: u * t722,
            }
        }
        /// What points need of v alone.
        #[inline(always)]
        fn values_of_v<R: ::hodograph::Real>(v: R) -> OfV<R> {
            let t10 = v - R::of(2.5);
            let q1 = ::hodograph::horner(::hodograph::constants(Self::Q1), t10);
            let q2 = ::hodograph::horner(::hodograph::constants(Self::Q2), t10);
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
            let q7 = ::hodograph::horner(::hodograph::constants(Self::Q7), t10);
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
            let q9 = ::hodograph::horner(::hodograph::constants(Self::Q9), t10);
            let q10 = ::hodograph::horner(::hodograph::constants(Self::Q10), t10);
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
            let q19 = ::hodograph::horner(::hodograph::constants(Self::Q19), t10);
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
            let q29 = R::of(1.5105453404632173e-15)
                .mul_add(
                    t31,
                    R::of(-1.9637089426021826e-14)
                        .mul_add(t10, R::of(1.0705930833544215e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-2.617794304143537e-13)
                        .mul_add(t10, R::of(-8.567229725473709e-13))
                        .mul_add(
                            t31,
                            R::of(8.366781974661158e-12)
                                .mul_add(t10, R::of(-6.2430611124684865e-12)),
                        )
                        .mul_add(
                            t40,
                            R::of(-8.918644283090807e-11)
                                .mul_add(t10, R::of(1.1098211937663068e-10))
                                .mul_add(
                                    t31,
                                    R::of(5.770224757322394e-10)
                                        .mul_add(t10, R::of(-4.804189307896131e-10)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.449952697253939e-9)
                        .mul_add(t10, R::of(-1.8558478128162766e-10))
                        .mul_add(
                            t31,
                            R::of(5.084541901207515e-9)
                                .mul_add(t10, R::of(7.1454747143790075e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.9323200419241955e-9)
                                .mul_add(t10, R::of(-1.1093324443092493e-8))
                                .mul_add(
                                    t31,
                                    R::of(-2.842212694240909e-8)
                                        .mul_add(t10, R::of(-2.6461886098120355e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.1875850688349583e-8)
                                .mul_add(t10, R::of(1.3487089240809922e-8))
                                .mul_add(
                                    t31,
                                    R::of(3.471065646811017e-8)
                                        .mul_add(t10, R::of(3.6850329783010655e-8)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.401713338798374e-8)
                                        .mul_add(t10, R::of(7.435149503531929e-9))
                                        .mul_add(
                                            t31,
                                            R::of(7.921222384314528e-9)
                                                .mul_add(t10, R::of(-2.4084357832202e-9)),
                                        ),
                                ),
                        ),
                );
            let q30 = R::of(-5.796250105483436e-15)
                .mul_add(
                    t31,
                    R::of(7.535125137128467e-14)
                        .mul_add(t10, R::of(-2.6031140717852744e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-4.769092880967773e-13)
                        .mul_add(t10, R::of(4.138641622931067e-12))
                        .mul_add(
                            t31,
                            R::of(-2.606379585760308e-12)
                                .mul_add(t10, R::of(-1.9267395646680226e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.414499366449721e-11)
                                .mul_add(t10, R::of(-3.504590612026433e-11))
                                .mul_add(
                                    t31,
                                    R::of(-6.108494352316509e-11)
                                        .mul_add(t10, R::of(7.181270532573883e-10)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-5.082125329702665e-10)
                        .mul_add(t10, R::of(-2.9040673865060615e-9))
                        .mul_add(
                            t31,
                            R::of(3.094749059769503e-9)
                                .mul_add(t10, R::of(4.043126820885521e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(-7.567750279297277e-9)
                                .mul_add(t10, R::of(8.763154535920217e-10))
                                .mul_add(
                                    t31,
                                    R::of(3.671003445979976e-9)
                                        .mul_add(t10, R::of(-5.946096655081674e-9)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(2.9040428865306877e-8)
                                .mul_add(t10, R::of(3.755166504790518e-8))
                                .mul_add(
                                    t31,
                                    R::of(2.2912054737023356e-8)
                                        .mul_add(t10, R::of(3.5504921421649954e-8)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.87124046285518e-9)
                                        .mul_add(t10, R::of(-7.357975715720817e-9))
                                        .mul_add(
                                            t31,
                                            R::of(-1.9025245362318835e-9)
                                                .mul_add(t10, R::of(-8.43956670198346e-9)),
                                        ),
                                ),
                        ),
                );
            let q31 = R::of(-2.6802153647345874e-15)
                .mul_add(
                    t31,
                    R::of(3.4842799741549636e-14)
                        .mul_add(t10, R::of(-9.3139586430159e-14)),
                )
                .mul_add(
                    t51,
                    R::of(-5.23720813882492e-13)
                        .mul_add(t10, R::of(2.794552851806129e-12))
                        .mul_add(
                            t31,
                            R::of(4.061261811933845e-13)
                                .mul_add(t10, R::of(-2.2474248629432312e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.8833344327115056e-11)
                                .mul_add(t10, R::of(3.933976427782112e-11))
                                .mul_add(
                                    t31,
                                    R::of(-4.1203697883180073e-10)
                                        .mul_add(t10, R::of(4.615010811552359e-10)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(2.3965977282106716e-9)
                        .mul_add(t10, R::of(-2.5115835988689476e-9))
                        .mul_add(
                            t31,
                            R::of(-8.185708705804582e-9)
                                .mul_add(t10, R::of(-8.002118799230173e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(6.151513614213185e-9)
                                .mul_add(t10, R::of(2.5061600956824244e-8))
                                .mul_add(
                                    t31,
                                    R::of(5.3907128778413745e-8)
                                        .mul_add(t10, R::of(1.385987300560569e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-6.397220194681563e-8)
                                .mul_add(t10, R::of(-1.446187137060621e-7))
                                .mul_add(
                                    t31,
                                    R::of(-2.499923353227974e-7)
                                        .mul_add(t10, R::of(-2.5707971207045004e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-2.073786964138004e-7)
                                        .mul_add(t10, R::of(-1.582949348359222e-7))
                                        .mul_add(
                                            t31,
                                            R::of(-5.274868483651686e-8)
                                                .mul_add(t10, R::of(-3.2221131518302134e-8)),
                                        ),
                                ),
                        ),
                );
            let q32 = R::of(-1.5607045739004724e-14)
                .mul_add(
                    t31,
                    R::of(2.0289159460706142e-13)
                        .mul_add(t10, R::of(-5.078457114900182e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-3.5497452290890926e-12)
                        .mul_add(t10, R::of(1.610565596195282e-11))
                        .mul_add(
                            t31,
                            R::of(2.6746398031112175e-11)
                                .mul_add(t10, R::of(-1.8452143933370581e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.3075952626795854e-10)
                                .mul_add(t10, R::of(1.1665746051751797e-9))
                                .mul_add(
                                    t31,
                                    R::of(7.059168093143176e-10)
                                        .mul_add(t10, R::of(-4.29270248496983e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.7771457255681815e-9)
                        .mul_add(t10, R::of(6.655317938706616e-9))
                        .mul_add(
                            t31,
                            R::of(1.1391772985111258e-8)
                                .mul_add(t10, R::of(1.1049576122475354e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.5387213318751327e-9)
                                .mul_add(t10, R::of(-4.6878244889828866e-8))
                                .mul_add(
                                    t31,
                                    R::of(-5.330423154722099e-8)
                                        .mul_add(t10, R::of(-2.6771868059944814e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.802331716761322e-9)
                                .mul_add(t10, R::of(1.2000166725634036e-7))
                                .mul_add(
                                    t31,
                                    R::of(2.1332162532496207e-7)
                                        .mul_add(t10, R::of(2.019006665310335e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.8127189093937614e-7)
                                        .mul_add(t10, R::of(1.2105834457958275e-7))
                                        .mul_add(
                                            t31,
                                            R::of(5.751283136150102e-8)
                                                .mul_add(t10, R::of(2.1278027307083344e-8)),
                                        ),
                                ),
                        ),
                );
            let q33 = R::of(-3.4369518086773434e-15)
                .mul_add(
                    t31,
                    R::of(4.4680373512805463e-14)
                        .mul_add(t10, R::of(-1.5522368934635442e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-2.9666875078032366e-13)
                        .mul_add(t10, R::of(1.873491361968293e-12))
                        .mul_add(
                            t31,
                            R::of(5.677096234287455e-12)
                                .mul_add(t10, R::of(-1.866270416116038e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.2565106277635678e-10)
                                .mul_add(t10, R::of(2.967841548716504e-10))
                                .mul_add(
                                    t31,
                                    R::of(1.2028895177320185e-9)
                                        .mul_add(t10, R::of(-2.5772545307765366e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-6.358059437563439e-9)
                        .mul_add(t10, R::of(9.998567696865654e-9))
                        .mul_add(
                            t31,
                            R::of(1.8500933246671413e-8)
                                .mul_add(t10, R::of(-7.633992410265118e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(-9.089434820250873e-9)
                                .mul_add(t10, R::of(-4.410322802770688e-8))
                                .mul_add(
                                    t31,
                                    R::of(-1.179841561108783e-7)
                                        .mul_add(t10, R::of(-1.8903798777806795e-9)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(1.6647617617965248e-7)
                                .mul_add(t10, R::of(2.6930126010476175e-7))
                                .mul_add(
                                    t31,
                                    R::of(4.548420829344097e-7)
                                        .mul_add(t10, R::of(4.6239258516294516e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.416969947386338e-7)
                                        .mul_add(t10, R::of(2.8323173876584096e-7))
                                        .mul_add(
                                            t31,
                                            R::of(1.0839722037315697e-7)
                                                .mul_add(t10, R::of(6.203201868032005e-8)),
                                        ),
                                ),
                        ),
                );
            let q34 = R::of(-6.186513255619218e-15)
                .mul_add(
                    t31,
                    R::of(8.042467232304983e-14)
                        .mul_add(t10, R::of(-3.573862699969349e-13)),
                )
                .mul_add(
                    t51,
                    R::of(3.4596698111804153e-13)
                        .mul_add(t10, R::of(3.1239097385778907e-12))
                        .mul_add(
                            t31,
                            R::of(-1.7191561061035144e-11)
                                .mul_add(t10, R::of(2.1434054591295028e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.4417336724813192e-10)
                                .mul_add(t10, R::of(-4.4696738958566307e-10))
                                .mul_add(
                                    t31,
                                    R::of(-4.867197506102355e-10)
                                        .mul_add(t10, R::of(2.6491479384611872e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.5715923265342652e-10)
                        .mul_add(t10, R::of(-6.3021845270653125e-9))
                        .mul_add(
                            t31,
                            R::of(3.9516810961446035e-9)
                                .mul_add(t10, R::of(-9.151657932896927e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.2825003621979948e-8)
                                .mul_add(t10, R::of(3.170156161107667e-8))
                                .mul_add(
                                    t31,
                                    R::of(9.745252519656874e-9)
                                        .mul_add(t10, R::of(-5.756378238253093e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(1.3724292846358732e-8)
                                .mul_add(t10, R::of(4.096533305978823e-8))
                                .mul_add(
                                    t31,
                                    R::of(3.419762168744167e-8)
                                        .mul_add(t10, R::of(1.2079266386434777e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(7.738549762238934e-8)
                                        .mul_add(t10, R::of(3.409333986115384e-8))
                                        .mul_add(
                                            t31,
                                            R::of(3.5012846409451254e-8)
                                                .mul_add(t10, R::of(-2.3680318702562908e-8)),
                                        ),
                                ),
                        ),
                );
            let q35 = R::of(-8.373288958791007e-15)
                .mul_add(
                    t31,
                    R::of(1.088527564642831e-13)
                        .mul_add(t10, R::of(-3.206383235445864e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-1.415475256734134e-12)
                        .mul_add(t10, R::of(7.870438195934577e-12))
                        .mul_add(
                            t31,
                            R::of(7.73555694884295e-12)
                                .mul_add(t10, R::of(-7.916241262371143e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-4.001364567328586e-11)
                                .mul_add(t10, R::of(5.076177168720294e-10))
                                .mul_add(
                                    t31,
                                    R::of(2.7274004731296406e-10)
                                        .mul_add(t10, R::of(-2.0104024850510187e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.5032797019809093e-9)
                        .mul_add(t10, R::of(3.4280633313892358e-9))
                        .mul_add(
                            t31,
                            R::of(3.884619289320743e-9)
                                .mul_add(t10, R::of(3.102249682888881e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(4.302634418999605e-9)
                                .mul_add(t10, R::of(-4.788549072273315e-9))
                                .mul_add(
                                    t31,
                                    R::of(-3.404991885618954e-8)
                                        .mul_add(t10, R::of(-6.215680552615605e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-4.689707514974132e-9)
                                .mul_add(t10, R::of(9.475208868551049e-8))
                                .mul_add(
                                    t31,
                                    R::of(1.0279756033570709e-7)
                                        .mul_add(t10, R::of(6.724411142163861e-8)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(5.375053061863154e-8)
                                        .mul_add(t10, R::of(-1.571247589261311e-8))
                                        .mul_add(
                                            t31,
                                            R::of(-1.2101871949283484e-8)
                                                .mul_add(t10, R::of(1.392298535673629e-8)),
                                        ),
                                ),
                        ),
                );
            let q36 = R::of(-6.323181933254658e-15)
                .mul_add(
                    t31,
                    R::of(8.220136513231055e-14)
                        .mul_add(t10, R::of(-2.3186370850611695e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-1.0822016240207184e-12)
                        .mul_add(t10, R::of(4.858209309145623e-12))
                        .mul_add(
                            t31,
                            R::of(1.2323914615630623e-11)
                                .mul_add(t10, R::of(-6.182959107364142e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-9.173038483257283e-11)
                                .mul_add(t10, R::of(4.766295992467587e-10))
                                .mul_add(
                                    t31,
                                    R::of(3.4088253944569635e-10)
                                        .mul_add(t10, R::of(-1.8012899056469549e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.5627135202422627e-10)
                        .mul_add(t10, R::of(9.35137123350595e-10))
                        .mul_add(
                            t31,
                            R::of(-1.861928922085784e-9)
                                .mul_add(t10, R::of(1.638019690923687e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(8.508570232720887e-9)
                                .mul_add(t10, R::of(-5.535775895174348e-8))
                                .mul_add(
                                    t31,
                                    R::of(-2.1320953013944258e-8)
                                        .mul_add(t10, R::of(6.104114710467701e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(5.6290054994129444e-8)
                                .mul_add(t10, R::of(6.087919264429427e-8))
                                .mul_add(
                                    t31,
                                    R::of(1.4322853535039283e-8)
                                        .mul_add(t10, R::of(-1.0412859662933945e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-1.2094543648812123e-7)
                                        .mul_add(t10, R::of(-5.93777620517859e-8))
                                        .mul_add(
                                            t31,
                                            R::of(-6.16596616422252e-8)
                                                .mul_add(t10, R::of(2.7615723261410484e-9)),
                                        ),
                                ),
                        ),
                );
            let q37 = R::of(4.1243421704128116e-15)
                .mul_add(
                    t31,
                    R::of(-5.3616448215366555e-14)
                        .mul_add(t10, R::of(1.4086726418503718e-13)),
                )
                .mul_add(
                    t51,
                    R::of(9.274372364629669e-13)
                        .mul_add(t10, R::of(-4.96491104004648e-12))
                        .mul_add(
                            t31,
                            R::of(-3.1626573153344073e-12)
                                .mul_add(t10, R::of(5.546582120033657e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-5.0593368590405043e-11)
                                .mul_add(t10, R::of(-2.521518983085551e-10))
                                .mul_add(
                                    t31,
                                    R::of(5.271229989213767e-10)
                                        .mul_add(t10, R::of(6.710368948115072e-11)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-1.577416432129461e-9)
                        .mul_add(t10, R::of(3.5646732365057494e-9))
                        .mul_add(
                            t31,
                            R::of(-1.7058322078300472e-9)
                                .mul_add(t10, R::of(-1.2430342223594498e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.1505750756018612e-8)
                                .mul_add(t10, R::of(1.424219622024154e-8))
                                .mul_add(
                                    t31,
                                    R::of(-4.997887032054681e-8)
                                        .mul_add(t10, R::of(1.5193801656063052e-9)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(5.0188111244457307e-8)
                                .mul_add(t10, R::of(-3.3353471751705473e-9))
                                .mul_add(
                                    t31,
                                    R::of(-4.2184504229061265e-9)
                                        .mul_add(t10, R::of(2.8635406502871264e-9)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-4.708397670620769e-8)
                                        .mul_add(t10, R::of(-1.4122518745881661e-8))
                                        .mul_add(
                                            t31,
                                            R::of(1.494551602878817e-8)
                                                .mul_add(t10, R::of(-6.236310256267571e-9)),
                                        ),
                                ),
                        ),
                );
            let q38 = R::of(-1.5607045739004724e-14)
                .mul_add(
                    t31,
                    R::of(2.0289159460706142e-13)
                        .mul_add(t10, R::of(-5.311047100063349e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-3.2176798102046307e-12)
                        .mul_add(t10, R::of(1.4506313207032668e-11))
                        .mul_add(
                            t31,
                            R::of(2.8319155924929197e-11)
                                .mul_add(t10, R::of(-1.7293922103904523e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.7033545072503518e-10)
                                .mul_add(t10, R::of(1.1834622764679605e-9))
                                .mul_add(
                                    t31,
                                    R::of(8.61859353276748e-10)
                                        .mul_add(t10, R::of(-4.630265731137242e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.861975019200739e-9)
                        .mul_add(t10, R::of(7.892664607934425e-9))
                        .mul_add(
                            t31,
                            R::of(1.0569214613597565e-8)
                                .mul_add(t10, R::of(7.665562762861894e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(8.519948695267787e-10)
                                .mul_add(t10, R::of(-3.934646867816304e-8))
                                .mul_add(
                                    t31,
                                    R::of(-6.934143168121087e-8)
                                        .mul_add(t10, R::of(-3.4160157016969805e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(3.454875007003869e-8)
                                .mul_add(t10, R::of(1.187375281233614e-7))
                                .mul_add(
                                    t31,
                                    R::of(1.7878179624902784e-7)
                                        .mul_add(t10, R::of(2.0889303079449204e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.0173488145747762e-7)
                                        .mul_add(t10, R::of(1.1881540100037315e-7))
                                        .mul_add(
                                            t31,
                                            R::of(6.002741075603467e-8)
                                                .mul_add(t10, R::of(2.6951218307696975e-8)),
                                        ),
                                ),
                        ),
                );
            let q39 = R::of(-3.4369518086773434e-15)
                .mul_add(
                    t31,
                    R::of(4.4680373512805463e-14)
                        .mul_add(t10, R::of(-1.045233577987048e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-9.206268267243766e-13)
                        .mul_add(t10, R::of(3.828761822546023e-12))
                        .mul_add(
                            t31,
                            R::of(1.0898782187609024e-11)
                                .mul_add(t10, R::of(-5.877326863132961e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-8.79756686274716e-11)
                                .mul_add(t10, R::of(4.945991859391215e-10))
                                .mul_add(
                                    t31,
                                    R::of(6.593935245222142e-10)
                                        .mul_add(t10, R::of(-2.3601487901400174e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-4.576260178915349e-9)
                        .mul_add(t10, R::of(4.982766921146053e-9))
                        .mul_add(
                            t31,
                            R::of(2.0204332085752633e-8)
                                .mul_add(t10, R::of(9.003725393296066e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.3172898375866466e-8)
                                .mul_add(t10, R::of(-6.304413571371215e-8))
                                .mul_add(
                                    t31,
                                    R::of(-6.214025922796572e-8)
                                        .mul_add(t10, R::of(-5.420583361912351e-9)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(1.1716381420147579e-7)
                                .mul_add(t10, R::of(2.805293529160106e-7))
                                .mul_add(
                                    t31,
                                    R::of(4.469283908763282e-7)
                                        .mul_add(t10, R::of(4.5254697435555356e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.947817733404148e-7)
                                        .mul_add(t10, R::of(2.9843763515699466e-7))
                                        .mul_add(
                                            t31,
                                            R::of(9.690065636792205e-8)
                                                .mul_add(t10, R::of(7.160664038551915e-8)),
                                        ),
                                ),
                        ),
                );
            let q40 = R::of(-6.186513255619218e-15)
                .mul_add(
                    t31,
                    R::of(8.042467232304983e-14)
                        .mul_add(t10, R::of(-3.268764093249448e-13)),
                )
                .mul_add(
                    t51,
                    R::of(6.351691290277499e-14)
                        .mul_add(t10, R::of(2.8746025429916567e-12))
                        .mul_add(
                            t31,
                            R::of(-7.917680711503143e-12)
                                .mul_add(t10, R::of(5.670391012829433e-12)),
                        )
                        .mul_add(
                            t40,
                            R::of(4.911493243310058e-11)
                                .mul_add(t10, R::of(-1.9133389123626964e-10))
                                .mul_add(
                                    t31,
                                    R::of(-1.3697862100982114e-10)
                                        .mul_add(t10, R::of(1.3802652732226345e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(3.255458719644504e-10)
                        .mul_add(t10, R::of(-6.091486791580188e-9))
                        .mul_add(
                            t31,
                            R::of(-7.546159743241296e-10)
                                .mul_add(t10, R::of(1.746179438801908e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.6695850584418206e-9)
                                .mul_add(t10, R::of(-2.9411325848509278e-8))
                                .mul_add(
                                    t31,
                                    R::of(-1.6955371413561756e-8)
                                        .mul_add(t10, R::of(7.034981726279073e-9)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(5.22945011575177e-8)
                                .mul_add(t10, R::of(8.608798255339453e-8))
                                .mul_add(
                                    t31,
                                    R::of(7.917290010463829e-8)
                                        .mul_add(t10, R::of(7.776380491179875e-8)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-7.731051658564592e-9)
                                        .mul_add(t10, R::of(-2.0815933635713392e-8))
                                        .mul_add(
                                            t31,
                                            R::of(-1.8907984185518183e-8)
                                                .mul_add(t10, R::of(-1.4640929812874487e-8)),
                                        ),
                                ),
                        ),
                );
            let q41 = R::of(-9.883834299254224e-15)
                .mul_add(
                    t31,
                    R::of(1.2848984589030492e-13)
                        .mul_add(t10, R::of(-3.92038398691515e-13)),
                )
                .mul_add(
                    t51,
                    R::of(-1.5403705004347193e-12)
                        .mul_add(t10, R::of(9.502345907149267e-12))
                        .mul_add(
                            t31,
                            R::of(4.327227384397845e-12)
                                .mul_add(t10, R::of(-9.205406033765805e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.573399513960623e-11)
                                .mul_add(t10, R::of(5.068103747233539e-10))
                                .mul_add(
                                    t31,
                                    R::of(-3.2808578704120355e-10)
                                        .mul_add(t10, R::of(-1.668166530692158e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(9.800648006279898e-10)
                        .mul_add(t10, R::of(2.790911562218143e-9))
                        .mul_add(
                            t31,
                            R::of(-7.890795701581467e-10)
                                .mul_add(t10, R::of(8.346371321304794e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.326234509895542e-10)
                                .mul_add(t10, R::of(-1.1851004177302557e-8))
                                .mul_add(
                                    t31,
                                    R::of(-6.07927109029882e-9)
                                        .mul_add(t10, R::of(5.684931279541031e-9)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(7.310511655018255e-9)
                                .mul_add(t10, R::of(2.6744869680606577e-8))
                                .mul_add(
                                    t31,
                                    R::of(3.926965476059459e-8)
                                        .mul_add(t10, R::of(3.5033797838573443e-8)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.824247231028324e-8)
                                        .mul_add(t10, R::of(2.7224323250869073e-8))
                                        .mul_add(
                                            t31,
                                            R::of(1.005268170017725e-8)
                                                .mul_add(t10, R::of(1.0506175865516112e-8)),
                                        ),
                                ),
                        ),
                );
            let q42 = R::of(-5.269318277712215e-16)
                .mul_add(
                    t31,
                    R::of(6.8501137610258794e-15)
                        .mul_add(t10, R::of(1.4296666956896448e-14)),
                )
                .mul_add(
                    t51,
                    R::of(-5.169937825025518e-13)
                        .mul_add(t10, R::of(1.6406325764803947e-12))
                        .mul_add(
                            t31,
                            R::of(5.841246661436206e-12)
                                .mul_add(t10, R::of(-3.1416524412984406e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-2.689263931394558e-11)
                                .mul_add(t10, R::of(2.623537511836446e-10))
                                .mul_add(
                                    t31,
                                    R::of(5.465018215918019e-11)
                                        .mul_add(t10, R::of(-1.2500522705350798e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-5.1180304484742714e-11)
                        .mul_add(t10, R::of(3.4830409265830217e-9))
                        .mul_add(
                            t31,
                            R::of(-2.2514901994461645e-11)
                                .mul_add(t10, R::of(-4.981639818606238e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.749247325242012e-10)
                                .mul_add(t10, R::of(1.6453042374694167e-9))
                                .mul_add(
                                    t31,
                                    R::of(4.713453175798929e-9)
                                        .mul_add(t10, R::of(1.2061222224726712e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.667593346111676e-8)
                                .mul_add(t10, R::of(-4.002046836665305e-8))
                                .mul_add(
                                    t31,
                                    R::of(-4.526509178122921e-8)
                                        .mul_add(t10, R::of(-6.833595863951937e-8)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-4.07827702781835e-8)
                                        .mul_add(t10, R::of(-2.1166570979043213e-8))
                                        .mul_add(
                                            t31,
                                            R::of(-1.4392516938339616e-8)
                                                .mul_add(t10, R::of(4.19898356689196e-9)),
                                        ),
                                ),
                        ),
                );
            let q43 = R::of(6.804557535147399e-15)
                .mul_add(
                    t31,
                    R::of(-8.845924795691618e-14)
                        .mul_add(t10, R::of(2.847071821628458e-13)),
                )
                .mul_add(
                    t51,
                    R::of(8.015002743962118e-13)
                        .mul_add(t10, R::of(-5.5086468812151465e-12))
                        .mul_add(
                            t31,
                            R::of(4.878215763634989e-13)
                                .mul_add(t10, R::of(3.888583369726545e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-4.680722777438481e-11)
                                .mul_add(t10, R::of(-1.0557866563591022e-10))
                                .mul_add(
                                    t31,
                                    R::of(3.8618433974157084e-10)
                                        .mul_add(t10, R::of(-1.286645929719968e-10)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.1653217752620312e-9)
                        .mul_add(t10, R::of(8.394031219539687e-10))
                        .mul_add(
                            t31,
                            R::of(8.239655928458855e-9)
                                .mul_add(t10, R::of(5.612489668776936e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(-9.120564404166657e-9)
                                .mul_add(t10, R::of(-3.106010776841909e-8))
                                .mul_add(
                                    t31,
                                    R::of(-4.686191962450091e-8)
                                        .mul_add(t10, R::of(-1.3411263805415904e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(6.188479294156937e-8)
                                .mul_add(t10, R::of(1.4934791985034508e-7))
                                .mul_add(
                                    t31,
                                    R::of(2.430138027411176e-7)
                                        .mul_add(t10, R::of(2.526767552970732e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.082218403770735e-7)
                                        .mul_add(t10, R::of(1.5811710469846376e-7))
                                        .mul_add(
                                            t31,
                                            R::of(5.953252633575562e-8)
                                                .mul_add(t10, R::of(3.7057551946715595e-8)),
                                        ),
                                ),
                        ),
                );
            let q44 = R::of(3.927417885204365e-14)
                .mul_add(t10, R::of(-4.909272356505457e-13))
                .mul_add(
                    t51,
                    R::of(2.5694234000506116e-12)
                        .mul_add(t10, R::of(-6.020926899530136e-12))
                        .mul_add(
                            t31,
                            R::of(-1.8847905396042158e-11)
                                .mul_add(t10, R::of(1.7570242146788432e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.2486122224936974e-10)
                                .mul_add(t10, R::of(-1.6945424137872535e-9))
                                .mul_add(
                                    t31,
                                    R::of(1.9976781487793522e-9)
                                        .mul_add(t10, R::of(9.809382087448072e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-7.68670289263381e-9)
                        .mul_add(t10, R::of(-3.674929045880908e-8))
                        .mul_add(
                            t31,
                            R::of(-2.598186937942787e-9)
                                .mul_add(t10, R::of(6.60990447156977e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(8.57456965725481e-8)
                                .mul_add(t10, R::of(4.325552046116615e-8))
                                .mul_add(
                                    t31,
                                    R::of(-1.1093324443092493e-7)
                                        .mul_add(t10, R::of(-2.557991424816818e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-2.1169508878496284e-7)
                                .mul_add(t10, R::of(-8.313095481844708e-8))
                                .mul_add(
                                    t31,
                                    R::of(8.092253544485953e-8)
                                        .mul_add(t10, R::of(1.7355328234055085e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.4740131913204262e-7)
                                        .mul_add(t10, R::of(1.0205140016395122e-7))
                                        .mul_add(
                                            t31,
                                            R::of(1.4870299007063857e-8)
                                                .mul_add(t10, R::of(7.921222384314528e-9)),
                                        ),
                                ),
                        ),
                );
            let q45 = R::of(-1.5070250274256933e-13)
                .mul_add(t10, R::of(1.8837812842821166e-12))
                .mul_add(
                    t51,
                    R::of(-6.2474737722846585e-12)
                        .mul_add(t10, R::of(-1.0968913626225878e-11))
                        .mul_add(
                            t31,
                            R::of(9.105011570448348e-11)
                                .mul_add(t10, R::of(-5.4733971300966466e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.8534791293360454e-10)
                                .mul_add(t10, R::of(6.48754879625447e-10))
                                .mul_add(
                                    t31,
                                    R::of(-6.30826310164758e-10)
                                        .mul_add(t10, R::of(-1.0384440398938065e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.1490032852118213e-8)
                        .mul_add(t10, R::of(-7.623187994553997e-9))
                        .mul_add(
                            t31,
                            R::of(-4.065694341108486e-8)
                                .mul_add(t10, R::of(4.023173777700354e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(4.851752185062625e-8)
                                .mul_add(t10, R::of(-8.324525307227005e-8))
                                .mul_add(
                                    t31,
                                    R::of(8.763154535920217e-9)
                                        .mul_add(t10, R::of(3.303903101381978e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-4.7568773240653394e-8)
                                .mul_add(t10, R::of(2.0328300205714814e-7))
                                .mul_add(
                                    t31,
                                    R::of(2.2530999028743106e-7)
                                        .mul_add(t10, R::of(1.1456027368511678e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.4201968568659982e-7)
                                        .mul_add(t10, R::of(1.1613721388565541e-8))
                                        .mul_add(
                                            t31,
                                            R::of(-1.4715951431441633e-8)
                                                .mul_add(t10, R::of(-1.9025245362318835e-9)),
                                        ),
                                ),
                        ),
                );
            let q46 = R::of(-6.968559948309927e-14)
                .mul_add(t10, R::of(8.710699935387408e-13))
                .mul_add(
                    t51,
                    R::of(-2.235350074323816e-12)
                        .mul_add(t10, R::of(-1.2045578719297316e-11))
                        .mul_add(
                            t31,
                            R::of(6.148016273973485e-11)
                                .mul_add(t10, R::of(8.528649805061075e-12)),
                        )
                        .mul_add(
                            t40,
                            R::of(-4.4948497258864626e-10)
                                .mul_add(t10, R::of(7.378335422151861e-10))
                                .mul_add(
                                    t31,
                                    R::of(7.081157570007802e-10)
                                        .mul_add(t10, R::of(-7.004628640140612e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(7.3840172984837745e-9)
                        .mul_add(t10, R::of(3.594896592316008e-8))
                        .mul_add(
                            t31,
                            R::of(-3.5162170384165264e-8)
                                .mul_add(t10, R::of(-1.0641421317545956e-7)),
                        )
                        .mul_add(
                            t40,
                            R::of(-9.602542559076207e-9)
                                .mul_add(t10, R::of(6.766664975634502e-8))
                                .mul_add(
                                    t31,
                                    R::of(2.506160095682424e-7)
                                        .mul_add(t10, R::of(4.851641590057238e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(1.1087898404484552e-7)
                                .mul_add(t10, R::of(-4.4780541362770935e-7))
                                .mul_add(
                                    t31,
                                    R::of(-8.677122822363726e-7)
                                        .mul_add(t10, R::of(-1.2499616766139869e-6)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-1.0283188482818002e-6)
                                        .mul_add(t10, R::of(-6.221360892414012e-7))
                                        .mul_add(
                                            t31,
                                            R::of(-3.165898696718444e-7)
                                                .mul_add(t10, R::of(-5.274868483651686e-8)),
                                        ),
                                ),
                        ),
                );
            let t1752 = R::of(-4.0578318921412284e-13)
                .mul_add(t10, R::of(5.072289865176535e-12));
            let q47 = t1752
                .mul_add(
                    t51,
                    R::of(-1.2188297075760436e-11)
                        .mul_add(t10, R::of(-8.164414026904913e-11))
                        .mul_add(
                            t31,
                            R::of(3.54324431162962e-10)
                                .mul_add(t10, R::of(5.616743586533557e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.6904287866741163e-9)
                                .mul_add(t10, R::of(-2.484430999091212e-9))
                                .mul_add(
                                    t31,
                                    R::of(2.0998342893153233e-8)
                                        .mul_add(t10, R::of(1.2000585758343399e-8)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-6.868323975951728e-8)
                        .mul_add(t10, R::of(-5.665718588352273e-8))
                        .mul_add(
                            t31,
                            R::of(9.317445114189262e-8)
                                .mul_add(t10, R::of(1.4809304880644635e-7)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.3259491346970426e-7)
                                .mul_add(t10, R::of(-3.892593465062646e-8))
                                .mul_add(
                                    t31,
                                    R::of(-4.6878244889828864e-7)
                                        .mul_add(t10, R::of(-4.797380839249889e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-2.141749444795585e-7)
                                .mul_add(t10, R::of(2.661632201732925e-8))
                                .mul_add(
                                    t31,
                                    R::of(7.200100035380422e-7)
                                        .mul_add(t10, R::of(1.0666081266248104e-6)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(8.07602666124134e-7)
                                        .mul_add(t10, R::of(5.438156728181285e-7))
                                        .mul_add(
                                            t31,
                                            R::of(2.421166891591655e-7)
                                                .mul_add(t10, R::of(5.751283136150102e-8)),
                                        ),
                                ),
                        ),
                );
            let t1802 = R::of(-8.936074702561093e-14)
                .mul_add(t10, R::of(1.1170093378201366e-12));
            let q48 = t1802
                .mul_add(
                    t51,
                    R::of(-3.725368544312506e-12)
                        .mul_add(t10, R::of(-6.823381267947444e-12))
                        .mul_add(
                            t31,
                            R::of(4.1216809963302443e-11)
                                .mul_add(t10, R::of(1.1921902092003655e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.732540832232076e-10)
                                .mul_add(t10, R::of(-2.387370192750779e-9))
                                .mul_add(
                                    t31,
                                    R::of(5.342114787689707e-9)
                                        .mul_add(t10, R::of(2.0449121801444316e-8)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-4.1236072492424585e-8)
                        .mul_add(t10, R::of(-9.537089156345159e-8))
                        .mul_add(
                            t31,
                            R::of(1.3997994775611916e-7)
                                .mul_add(t10, R::of(2.405121322067284e-7)),
                        )
                        .mul_add(
                            t40,
                            R::of(-9.160790892318141e-8)
                                .mul_add(t10, R::of(-9.99837830227596e-8))
                                .mul_add(
                                    t31,
                                    R::of(-4.410322802770688e-7)
                                        .mul_add(t10, R::of(-1.0618574049979048e-6)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.5123039022245436e-8)
                                .mul_add(t10, R::of(1.1653332332575673e-6))
                                .mul_add(
                                    t31,
                                    R::of(1.6158075606285704e-6)
                                        .mul_add(t10, R::of(2.2742104146720483e-6)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.8495703406517807e-6)
                                        .mul_add(t10, R::of(1.0250909842159013e-6))
                                        .mul_add(
                                            t31,
                                            R::of(5.664634775316819e-7)
                                                .mul_add(t10, R::of(1.0839722037315697e-7)),
                                        ),
                                ),
                        ),
                );
            let t1852 = R::of(-1.6084934464609966e-13)
                .mul_add(t10, R::of(2.0106168080762457e-12));
            let q49 = t1852
                .mul_add(
                    t51,
                    R::of(-8.577270479926439e-12)
                        .mul_add(t10, R::of(7.957240565714956e-12))
                        .mul_add(
                            t31,
                            R::of(6.87260142487136e-11)
                                .mul_add(t10, R::of(-3.6102278228173805e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(4.2868109182590055e-10)
                                .mul_add(t10, R::of(2.7392939777145065e-9))
                                .mul_add(
                                    t31,
                                    R::of(-8.045413012541935e-9)
                                        .mul_add(t10, R::of(-8.274235760374003e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(4.2386367015378996e-8)
                        .mul_add(t10, R::of(2.3573884898013976e-9))
                        .mul_add(
                            t31,
                            R::of(-8.823058337891437e-8)
                                .mul_add(t10, R::of(5.137185424987984e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.0981989519476312e-8)
                                .mul_add(t10, R::of(-1.4107503984177943e-7))
                                .mul_add(
                                    t31,
                                    R::of(3.1701561611076665e-7)
                                        .mul_add(t10, R::of(8.770727267691186e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-4.605102590602474e-7)
                                .mul_add(t10, R::of(9.607004992451112e-8))
                                .mul_add(
                                    t31,
                                    R::of(2.457919983587294e-7)
                                        .mul_add(t10, R::of(1.7098810843720835e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(4.831706554573911e-7)
                                        .mul_add(t10, R::of(2.3215649286716805e-7))
                                        .mul_add(
                                            t31,
                                            R::of(6.818667972230768e-8)
                                                .mul_add(t10, R::of(3.5012846409451254e-8)),
                                        ),
                                ),
                        ),
                );
            let q50 = R::of(-2.177055129285662e-13)
                .mul_add(t10, R::of(2.7213189116070772e-12))
                .mul_add(
                    t51,
                    R::of(-7.695319765070073e-12)
                        .mul_add(t10, R::of(-3.2555930904885085e-11))
                        .mul_add(
                            t31,
                            R::of(1.731496403105607e-10)
                                .mul_add(t10, R::of(1.6244669592570196e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.5832482524742287e-9)
                                .mul_add(t10, R::of(-7.602592677924313e-10))
                                .mul_add(
                                    t31,
                                    R::of(9.137118903696529e-9)
                                        .mul_add(t10, R::of(4.636580804320389e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.21664397608163e-8)
                        .mul_add(t10, R::of(-2.2549195529713638e-8))
                        .mul_add(
                            t31,
                            R::of(4.79928866394493e-8)
                                .mul_add(t10, R::of(5.0500050761169666e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(3.722699619466657e-8)
                                .mul_add(t10, R::of(4.732897860899565e-8))
                                .mul_add(
                                    t31,
                                    R::of(-4.7885490722733144e-8)
                                        .mul_add(t10, R::of(-3.0644926970570586e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-4.972544442092484e-7)
                                .mul_add(t10, R::of(-3.282795260481892e-8))
                                .mul_add(
                                    t31,
                                    R::of(5.685125321130629e-7)
                                        .mul_add(t10, R::of(5.139878016785354e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(2.6897644568655444e-7)
                                        .mul_add(t10, R::of(1.612515918558946e-7))
                                        .mul_add(
                                            t31,
                                            R::of(-3.142495178522622e-8)
                                                .mul_add(t10, R::of(-1.2101871949283484e-8)),
                                        ),
                                ),
                        ),
                );
            let q51 = R::of(-1.644027302646211e-13)
                .mul_add(t10, R::of(2.0550341283077635e-12))
                .mul_add(
                    t51,
                    R::of(-5.564729004146807e-12)
                        .mul_add(t10, R::of(-2.4890637352476526e-11))
                        .mul_add(
                            t31,
                            R::of(1.0688060480120371e-10)
                                .mul_add(t10, R::of(2.588022069282431e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.2365918214728284e-9)
                                .mul_add(t10, R::of(-1.7428773118188838e-9))
                                .mul_add(
                                    t31,
                                    R::of(8.579332786441657e-9)
                                        .mul_add(t10, R::of(5.795003170576838e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.8820638490351278e-8)
                        .mul_add(t10, R::of(-5.344070280363394e-9))
                        .mul_add(
                            t31,
                            R::of(1.3091919726908332e-8)
                                .mul_add(t10, R::of(-2.420507598711519e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.9656236291084245e-7)
                                .mul_add(t10, R::of(9.359427255992974e-8))
                                .mul_add(
                                    t31,
                                    R::of(-5.535775895174347e-7)
                                        .mul_add(t10, R::of(-1.9188857712549834e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(4.883291768374161e-7)
                                .mul_add(t10, R::of(3.940303849589061e-7))
                                .mul_add(
                                    t31,
                                    R::of(3.652751558657656e-7)
                                        .mul_add(t10, R::of(7.161426767519642e-8)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-4.165143865173578e-7)
                                        .mul_add(t10, R::of(-3.628363094643637e-7))
                                        .mul_add(
                                            t31,
                                            R::of(-1.187555241035718e-7)
                                                .mul_add(t10, R::of(-6.16596616422252e-8)),
                                        ),
                                ),
                        ),
                );
            let q52 = R::of(1.0723289643073311e-13)
                .mul_add(t10, R::of(-1.3404112053841639e-12))
                .mul_add(
                    t51,
                    R::of(3.380814340440892e-12)
                        .mul_add(t10, R::of(2.1331056438648238e-11))
                        .mul_add(
                            t31,
                            R::of(-1.0922804288102258e-10)
                                .mul_add(t10, R::of(-6.641580362202256e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.1093164240067314e-9)
                                .mul_add(t10, R::of(-9.61274003217696e-10))
                                .mul_add(
                                    t31,
                                    R::of(-4.538734169553993e-9)
                                        .mul_add(t10, R::of(8.961090981663403e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(1.0736590316984115e-9)
                        .mul_add(t10, R::of(-2.3661246481941916e-8))
                        .mul_add(
                            t31,
                            R::of(4.990542531108049e-8)
                                .mul_add(t10, R::of(-2.2175818701790614e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.4916410668313396e-7)
                                .mul_add(t10, R::of(2.3656325831620474e-7))
                                .mul_add(
                                    t31,
                                    R::of(1.424219622024154e-7)
                                        .mul_add(t10, R::of(-4.498098328849213e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(1.2155041324850441e-8)
                                .mul_add(t10, R::of(3.513167787112011e-7))
                                .mul_add(
                                    t31,
                                    R::of(-2.0012083051023284e-8)
                                        .mul_add(t10, R::of(-2.1092252114530632e-8)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.1454162601148506e-8)
                                        .mul_add(t10, R::of(-1.4125193011862308e-7))
                                        .mul_add(
                                            t31,
                                            R::of(-2.8245037491763322e-8)
                                                .mul_add(t10, R::of(1.494551602878817e-8)),
                                        ),
                                ),
                        ),
                );
            let q53 = t1752
                .mul_add(
                    t51,
                    R::of(-1.2746513040152036e-11)
                        .mul_add(t10, R::of(-7.40066356347065e-11))
                        .mul_add(
                            t31,
                            R::of(3.191388905547187e-10)
                                .mul_add(t10, R::of(5.947022744235131e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-3.458784420780905e-9)
                                .mul_add(t10, R::of(-3.2363735637756686e-9))
                                .mul_add(
                                    t31,
                                    R::of(2.130232097642329e-8)
                                        .mul_add(t10, R::of(1.4651609005704716e-8)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-7.408425169819587e-8)
                        .mul_add(t10, R::of(-5.792962528801109e-8))
                        .mul_add(
                            t31,
                            R::of(1.1049730451108195e-7)
                                .mul_add(t10, R::of(1.3739978997676835e-7)),
                        )
                        .mul_add(
                            t40,
                            R::of(9.198675315434272e-8)
                                .mul_add(t10, R::of(9.371943564794566e-9))
                                .mul_add(
                                    t31,
                                    R::of(-3.9346468678163045e-7)
                                        .mul_add(t10, R::of(-6.240728851308978e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-2.7328125613575844e-7)
                                .mul_add(t10, R::of(2.4184125049027086e-7))
                                .mul_add(
                                    t31,
                                    R::of(7.124251687401684e-7)
                                        .mul_add(t10, R::of(8.939089812451392e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(8.355721231779682e-7)
                                        .mul_add(t10, R::of(6.052046443724329e-7))
                                        .mul_add(
                                            t31,
                                            R::of(2.376308020007463e-7)
                                                .mul_add(t10, R::of(6.002741075603467e-8)),
                                        ),
                                ),
                        ),
                );
            let q54 = t1802
                .mul_add(
                    t51,
                    R::of(-2.5085605871689152e-12)
                        .mul_add(t10, R::of(-2.1174417014660662e-11))
                        .mul_add(
                            t31,
                            R::of(8.42327600960125e-11)
                                .mul_add(t10, R::of(2.2887442593978951e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.175465372626592e-9)
                                .mul_add(t10, R::of(-1.6715377039219605e-9))
                                .mul_add(
                                    t31,
                                    R::of(8.902785346904188e-9)
                                        .mul_add(t10, R::of(1.120968991687764e-8)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-3.776238064224028e-8)
                        .mul_add(t10, R::of(-6.864390268373024e-8))
                        .mul_add(
                            t31,
                            R::of(6.975873689604474e-8)
                                .mul_add(t10, R::of(2.626563171147842e-7)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.0804470471955279e-7)
                                .mul_add(t10, R::of(-3.649018821345311e-7))
                                .mul_add(
                                    t31,
                                    R::of(-6.304413571371215e-7)
                                        .mul_add(t10, R::of(-5.592623330516915e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-4.336466689529881e-8)
                                .mul_add(t10, R::of(8.201466994103305e-7))
                                .mul_add(
                                    t31,
                                    R::of(1.683176117496064e-6)
                                        .mul_add(t10, R::of(2.234641954381641e-6)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.8101878974222142e-6)
                                        .mul_add(t10, R::of(1.1843453200212443e-6))
                                        .mul_add(
                                            t31,
                                            R::of(5.968752703139893e-7)
                                                .mul_add(t10, R::of(9.690065636792205e-8)),
                                        ),
                                ),
                        ),
                );
            let q55 = t1852
                .mul_add(
                    t51,
                    R::of(-7.845033823798674e-12)
                        .mul_add(t10, R::of(1.4608889967638246e-12))
                        .mul_add(
                            t31,
                            R::of(6.324125594581645e-11)
                                .mul_add(t10, R::of(-1.6627129494156599e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.1340782025658867e-10)
                                .mul_add(t10, R::of(9.33183716228911e-10))
                                .mul_add(
                                    t31,
                                    R::of(-3.444010042252854e-9)
                                        .mul_add(t10, R::of(-2.3286365571669593e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(2.2084244371562152e-8)
                        .mul_add(t10, R::of(4.883188079466755e-9))
                        .mul_add(
                            t31,
                            R::of(-8.528081508212264e-8)
                                .mul_add(t10, R::of(-9.810007666213684e-9)),
                        )
                        .mul_add(
                            t40,
                            R::of(2.0954153265622896e-7)
                                .mul_add(t10, R::of(1.8365435642860025e-8))
                                .mul_add(
                                    t31,
                                    R::of(-2.941132584850928e-7)
                                        .mul_add(t10, R::of(-1.525983427220558e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(5.627985381023258e-8)
                                .mul_add(t10, R::of(3.6606150810262387e-7))
                                .mul_add(
                                    t31,
                                    R::of(5.165278953203673e-7)
                                        .mul_add(t10, R::of(3.9586450052319146e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(3.11055219647195e-7)
                                        .mul_add(t10, R::of(-2.3193154975693775e-8))
                                        .mul_add(
                                            t31,
                                            R::of(-4.1631867271426784e-8)
                                                .mul_add(t10, R::of(-1.8907984185518183e-8)),
                                        ),
                                ),
                        ),
                );
            let q56 = R::of(-2.5697969178060984e-13)
                .mul_add(t10, R::of(3.212246147257623e-12))
                .mul_add(
                    t51,
                    R::of(-9.408921568596359e-12)
                        .mul_add(t10, R::of(-3.542852150999854e-11))
                        .mul_add(
                            t31,
                            R::of(2.0905160995728388e-10)
                                .mul_add(t10, R::of(9.087177507235476e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(-1.841081206753161e-9)
                                .mul_add(t10, R::of(6.789459076525185e-10))
                                .mul_add(
                                    t31,
                                    R::of(9.122586745020371e-9)
                                        .mul_add(t10, R::of(-5.577458379700461e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.6690664491074527e-8)
                        .mul_add(t10, R::of(1.4700972009419848e-8))
                        .mul_add(
                            t31,
                            R::of(3.9072761871054e-8)
                                .mul_add(t10, R::of(-1.0258034412055907e-8)),
                        )
                        .mul_add(
                            t40,
                            R::of(1.0015645585565753e-8)
                                .mul_add(t10, R::of(-3.658857960885096e-9))
                                .mul_add(
                                    t31,
                                    R::of(-1.1851004177302557e-7)
                                        .mul_add(t10, R::of(-5.4713439812689374e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(4.5479450236328245e-8)
                                .mul_add(t10, R::of(5.117358158512778e-8))
                                .mul_add(
                                    t31,
                                    R::of(1.6046921808363948e-7)
                                        .mul_add(t10, R::of(1.9634827380297293e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.4013519135429377e-7)
                                        .mul_add(t10, R::of(1.1472741693084971e-7))
                                        .mul_add(
                                            t31,
                                            R::of(5.4448646501738146e-8)
                                                .mul_add(t10, R::of(1.005268170017725e-8)),
                                        ),
                                ),
                        ),
                );
            let q57 = R::of(-1.3700227522051759e-14)
                .mul_add(t10, R::of(1.7125284402564699e-13))
                .mul_add(
                    t51,
                    R::of(3.431200069655147e-13)
                        .mul_add(t10, R::of(-1.1890856997558692e-11))
                        .mul_add(
                            t31,
                            R::of(3.6093916682568685e-11)
                                .mul_add(t10, R::of(1.2266617989016033e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-6.283304882596881e-10)
                                .mul_add(t10, R::of(-5.10960146964966e-10))
                                .mul_add(
                                    t31,
                                    R::of(4.722367521305603e-9)
                                        .mul_add(t10, R::of(9.290530967060633e-10)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.0000836328561277e-8)
                        .mul_add(t10, R::of(-7.677045672711407e-10))
                        .mul_add(
                            t31,
                            R::of(4.87625729721623e-8)
                                .mul_add(t10, R::of(-2.926937259280014e-10)),
                        )
                        .mul_add(
                            t40,
                            R::of(-5.977967782327487e-8)
                                .mul_add(t10, R::of(4.124172057766213e-9))
                                .mul_add(
                                    t31,
                                    R::of(1.6453042374694165e-8)
                                        .mul_add(t10, R::of(4.242107858219036e-8)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(9.64897777978137e-8)
                                .mul_add(t10, R::of(-1.1673153422781733e-7))
                                .mul_add(
                                    t31,
                                    R::of(-2.401228101999183e-7)
                                        .mul_add(t10, R::of(-2.2632545890614606e-7)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(-2.7334383455807747e-7)
                                        .mul_add(t10, R::of(-1.223483108345505e-7))
                                        .mul_add(
                                            t31,
                                            R::of(-4.2333141958086426e-8)
                                                .mul_add(t10, R::of(-1.4392516938339616e-8)),
                                        ),
                                ),
                        ),
                );
            let q58 = R::of(1.7691849591383237e-13)
                .mul_add(t10, R::of(-2.2114811989229047e-12))
                .mul_add(
                    t51,
                    R::of(6.832972371908299e-12)
                        .mul_add(t10, R::of(1.843450631111287e-11))
                        .mul_add(
                            t31,
                            R::of(-1.2119023138673323e-10)
                                .mul_add(t10, R::of(1.0244253103633476e-11)),
                        )
                        .mul_add(
                            t40,
                            R::of(7.77716673945309e-10)
                                .mul_add(t10, R::of(-8.893373277133113e-10))
                                .mul_add(
                                    t31,
                                    R::of(-1.900415981446384e-9)
                                        .mul_add(t10, R::of(6.565133775606704e-9)),
                                ),
                        ),
                )
                .mul_add(
                    t293,
                    R::of(-2.0586334875519486e-9)
                        .mul_add(t10, R::of(-3.247982662893047e-8))
                        .mul_add(
                            t31,
                            R::of(1.1751643707355562e-8)
                                .mul_add(t10, R::of(1.0711552706996513e-7)),
                        )
                        .mul_add(
                            t40,
                            R::of(6.734987602532323e-8)
                                .mul_add(t10, R::of(-1.0032620844583323e-7))
                                .mul_add(
                                    t31,
                                    R::of(-3.106010776841909e-7)
                                        .mul_add(t10, R::of(-4.2175727662050823e-7)),
                                ),
                        )
                        .mul_add(
                            t51,
                            R::of(-1.0729011044332723e-7)
                                .mul_add(t10, R::of(4.3319355059098557e-7))
                                .mul_add(
                                    t31,
                                    R::of(8.960875191020705e-7)
                                        .mul_add(t10, R::of(1.215069013705588e-6)),
                                )
                                .mul_add(
                                    t40,
                                    R::of(1.0107070211882927e-6)
                                        .mul_add(t10, R::of(6.246655211312204e-7))
                                        .mul_add(
                                            t31,
                                            R::of(3.162342093969275e-7)
                                                .mul_add(t10, R::of(5.953252633575562e-8)),
                                        ),
                                ),
                        ),
                );
            let q59 = ::hodograph::horner(::hodograph::constants(Self::Q59), t10);
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
                t195: R::of(1.0164395367051604e-19) * q3,
                t199: R::of(4.0657581468206416e-19) * v * q3,
                t201: R::of(1.0164395367051604e-19) * q1 * q3,
                t203: R::of(1.0164395367051604e-19) * q2 * q3,
                t204: R::of(1.0164395367051604e-19) * t78,
                t205: R::of(1.0164395367051604e-19) * t104,
                t206: R::of(1.0164395367051604e-19) * q6,
                t207: R::of(1.0164395367051604e-19) * t143,
                t208: R::of(1.0164395367051604e-19) * q8,
                t210: R::of(2.0328790734103208e-19) * t104,
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
                t1537: R::of(2.0) * q35,
                t1538: R::of(2.0) * q36,
                t1539: R::of(2.0) * q37,
                t1540: R::of(3.0) * q38,
                t1541: R::of(3.0) * q39,
                t1542: R::of(3.0) * q40,
                t1543: R::of(4.0) * q41,
                t1544: R::of(4.0) * q42,
                t1545: R::of(4.0) * q43,
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
                t2342: q59 / (q16 * t473),
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
        t722: R,
        t723: R,
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
        t1537: R,
        t1538: R,
        t1539: R,
        t1540: R,
        t1541: R,
        t1542: R,
        t1543: R,
        t1544: R,
        t1545: R,
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
        t2342: R,
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
                R::of(2.9514790517935283e20) * (p1 * t195),
                R::of(2.9514790517935283e20)
                    * t213.mul_add(t204, u.mul_add(t207, p1 * t199)),
                R::of(2.9514790517935283e20)
                    * t213.mul_add(t205, u.mul_add(t208, p1 * t201)),
                R::of(2.9514790517935283e20)
                    * t213.mul_add(t206, u.mul_add(t210, p1 * t203)),
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
            [values.u, values.p4, values.t722, values.t723]
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
            let [u, p4, t722, t723] = of_u;
            let [q29, q30, q31, q32, q33, q34, q35, q36, q37, q38, q39, q40, q41, q42,
            q43] = of_v;
            let t1516 = t723
                .mul_add(q41, t722.mul_add(q38, p4.mul_add(q35, u.mul_add(q32, q29))));
            let t1520 = t723
                .mul_add(q42, t722.mul_add(q39, p4.mul_add(q36, u.mul_add(q33, q30))));
            let t1524 = t723
                .mul_add(q43, t722.mul_add(q40, p4.mul_add(q37, u.mul_add(q34, q31))));
            let t1525 = R::scale(t1516, t1520, t1524);
            let t1526 = t1516 * t1525;
            let t1527 = t1520 * t1525;
            let t1528 = t1524 * t1525;
            let t1533 = R::of(1.0)
                / t1528.mul_add(t1528, t1527.mul_add(t1527, t1526 * t1526)).sqrt();
            [t1526 * t1533, t1527 * t1533, t1528 * t1533]
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
                values.t722,
                values.t723,
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
                values.t1537,
                values.t1538,
                values.t1539,
                values.t1540,
                values.t1541,
                values.t1542,
                values.t1543,
                values.t1544,
                values.t1545,
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
                values.t2342,
            ]
        }
        #[inline(always)]
        fn join<R: ::hodograph::Real>(&self, of_u: [R; 11], of_v: [R; 65]) -> [R; 39] {
            let [u, p4, z_numerator_over_p1, t181, t235, t236, t242, t243, t244, t722,
            t723] = of_u;
            let [t3, q1, q2, t180, t182, t186, q8_over_q3, q6_over_q3, t191, q9, q10,
            t475, t476, t477, t478, t479, t480, t483, t485, t551, t583, t615, t647, t679,
            t685, q29, q30, q31, q32, q33, q34, q35, q36, q37, q38, q39, q40, q41, q42,
            q43, t1537, t1538, t1539, t1540, t1541, t1542, t1543, t1544, t1545, q44, q45,
            q46, q47, q48, q49, q50, q51, q52, q53, q54, q55, q56, q57, q58, t2342] = of_v;
            let t184 = -z_numerator_over_p1;
            let t687 = -t236;
            let t688 = t687.mul_add(t182, t235 * t180);
            let t690 = t687.mul_add(q8_over_q3, t235 * t186);
            let t692 = t687.mul_add(t191, t235 * q6_over_q3);
            let t694 = t184.mul_add(t475, t181.mul_add(t476, R::of(4.0)));
            let t696 = t184.mul_add(t477, t181.mul_add(t478, q9));
            let t698 = t184.mul_add(t479, t181.mul_add(t480, q10));
            let t1516 = t723
                .mul_add(q41, t722.mul_add(q38, p4.mul_add(q35, u.mul_add(q32, q29))));
            let t1520 = t723
                .mul_add(q42, t722.mul_add(q39, p4.mul_add(q36, u.mul_add(q33, q30))));
            let t1524 = t723
                .mul_add(q43, t722.mul_add(q40, p4.mul_add(q37, u.mul_add(q34, q31))));
            let t1525 = R::scale(t1516, t1520, t1524);
            let t1526 = t1516 * t1525;
            let t1527 = t1520 * t1525;
            let t1528 = t1524 * t1525;
            let t1532 = t1528.mul_add(t1528, t1527.mul_add(t1527, t1526 * t1526)).sqrt();
            let t1533 = R::of(1.0) / t1532;
            let t1534 = t1526 * t1533;
            let t1535 = t1527 * t1533;
            let t1536 = t1528 * t1533;
            let t1548 = t722.mul_add(t1543, p4.mul_add(t1540, u.mul_add(t1537, q32)));
            let t1551 = t722.mul_add(t1544, p4.mul_add(t1541, u.mul_add(t1538, q33)));
            let t1554 = t722.mul_add(t1545, p4.mul_add(t1542, u.mul_add(t1539, q34)));
            let t2299 = t723
                .mul_add(q56, t722.mul_add(q53, p4.mul_add(q50, u.mul_add(q47, q44))));
            let t2303 = t723
                .mul_add(q57, t722.mul_add(q54, p4.mul_add(q51, u.mul_add(q48, q45))));
            let t2307 = t723
                .mul_add(q58, t722.mul_add(q55, p4.mul_add(q52, u.mul_add(q49, q46))));
            let t2308 = t1525 * t1533;
            let t2312 = t692.mul_add(t692, t690.mul_add(t690, t688 * t688));
            let t2315 = t692.mul_add(t698, t690.mul_add(t696, t688 * t694));
            let t2318 = t698.mul_add(t698, t696.mul_add(t696, t694 * t694));
            let t2323 = -(t1554.mul_add(t692, t1551.mul_add(t690, t1548 * t688))
                * t2308);
            let t2333 = -(t2307.mul_add(t692, t2303.mul_add(t690, t2299 * t688))
                * t2308);
            let area = t242 * t2342;
            let t2346 = (-t1536).mul_add(t690, t1535 * t692);
            let t2349 = (-t1534).mul_add(t692, t1536 * t688);
            let t2352 = (-t1535).mul_add(t688, t1534 * t690);
            let t2357 = t2307.mul_add(t2352, t2303.mul_add(t2349, t2299 * t2346))
                * t2308;
            let t2359 = R::of(1.0) / t2312;
            let t2365 = t2323 * t2359;
            let t2366 = -(t1554.mul_add(t2352, t1551.mul_add(t2349, t1548 * t2346))
                * t2308) * t2359;
            let t2369 = -t2315.mul_add(t2366, t2357) / (area * (t1532 / t1525));
            let t2370 = -t2357 * t2359;
            let t2371 = t2333 * t2359;
            let t2392 = t2323.mul_add(t2359, t2369);
            let t2399 = R::of(0.5) * t2323.mul_add(t2359, -t2369);
            let t2402 = t2366.mul_add(t2366, t2399 * t2399).sqrt();
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
                t1534,
                t1535,
                t1536,
                t2312,
                t2315,
                t2318,
                t2323,
                t2333,
                -(t2307.mul_add(t698, t2303.mul_add(t696, t2299 * t694)) * t2308),
                (-t2366).mul_add(t2366, t2365 * t2369),
                R::of(0.5) * t2392,
                R::of(0.5).mul_add(t2392, t2402),
                R::of(0.5).mul_add(t2392, -t2402),
                t2312.sqrt(),
                t2318.sqrt(),
                -t2366.mul_add(t2346, t2365 * t688),
                -t2366.mul_add(t2349, t2365 * t690),
                -t2366.mul_add(t2352, t2365 * t692),
                -t2370.mul_add(t2346, t2371 * t688),
                -t2370.mul_add(t2349, t2371 * t690),
                -t2370.mul_add(t2352, t2371 * t692),
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
/// | [`frames_gutter_1`] | from 0.0 to 1.0 | (2, 15) |
/// | [`frames_gutter_2`] | from 1.0 to 2.0 | (2, 15) |
/// | [`frames_gutter_3`] | from 2.0 to 3.0 | (2, 15) |
///
/// They meet exactly. The points that two neighbors compute at a joint differ by 7e-15 at most in `f64` plain, 5.73e-15 fused, 3.94e-6 in `f32` plain, 3.26e-6 fused.
///
/// | error at most | `f64` plain | fused | `f32` plain | fused | size from | to | each, `f64` plain | relative |
/// | --- | --- | --- | --- | --- | --- | --- | --- | --- |
/// | homogeneous | 7.81e2 | 6.83e2 | 4.21e11 | 3.68e11 | 5.9e17 | 6.76e17 | 8.88e1, 7.81e2, 1.62e2, 2.54e2 | 1.13e-15, –, –, – |
/// | point | 3.94e-15 | 2.97e-15 | 2.36e-6 | 1.84e-6 | 1.24e1 | 1.26e1 | 3.11e-15, 3.29e-15, 3.94e-15 | –, –, – |
/// | separated point | 4.06e-15 | 3.03e-15 | 2.42e-6 | 1.87e-6 | 1.24e1 | 1.26e1 | 3.01e-15, 3.19e-15, 4.06e-15 | –, –, – |
/// | partial u | 6.35e-15 | 5.62e-15 | 3.57e-6 | 3.06e-6 | 2.83e0 | 3.14e0 | 3.24e-15, 6.35e-15, 6.02e-15 | –, –, – |
/// | partial v | 3.66e-15 | 3.11e-15 | 1.96e-6 | 1.67e-6 | 4.92e0 | 5e0 | 3.66e-15, 2.96e-15, 2.7e-15 | 9.25e-16, –, – |
/// | partial uu | 1.88e-14 | 1.55e-14 | 1.11e-5 | 9.28e-6 | 5.81e0 | 6.58e0 | 5.79e-15, 1.28e-14, 1.88e-14 | –, –, – |
/// | partial uv | 5.51e-15 | 5.13e-15 | 2.95e-6 | 2.74e-6 | 2.14e0 | 2.61e0 | 5.47e-15, 4.78e-15, 5.51e-15 | –, –, – |
/// | partial vv | 2.05e-14 | 1.85e-14 | 1.15e-5 | 1.03e-5 | 4.27e0 | 4.57e0 | 1.33e-14, 1.74e-14, 2.05e-14 | –, –, – |
/// | unit normal | 6.42e-15 | 5.34e-15 | 3.48e-6 | 2.89e-6 | 9.62e-1 | 1e0 | 2.42e-15, 6.42e-15, 4.07e-15 | –, –, – |
/// | first form | 5.2e-14 | 4.56e-14 | 2.85e-5 | 2.5e-5 | 2.92e1 | 3e1 | 5.2e-14, 3.49e-14, 5.07e-14 | 1.07e-14, –, 2.53e-15 |
/// | second form | 5.04e-14 | 4.55e-14 | 2.74e-5 | 2.5e-5 | 5.75e0 | 7.99e0 | 5.01e-14, 4.68e-14, 5.04e-14 | 1.73e-14, –, – |
/// | gaussian | 1.55e-13 | 1.39e-13 | 8.42e-5 | 7.56e-5 | 9.1e-2 | 2.68e0 | 1.55e-13 | – |
/// | mean | 3.4e-14 | 3.05e-14 | 1.86e-5 | 1.66e-5 | 4.43e-1 | 1.33e0 | 3.4e-14 | – |
/// | principal | 8.31e-14 | 7.45e-14 | 4.52e-5 | 4.06e-5 | 8.28e-1 | 2.97e0 | 8.3e-14, 8.31e-14 | –, – |
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
                    errors: [781.0, 683.0, 421000000000.0, 368000000000.0],
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
                    errors: [1.55e-13, 1.39e-13, 8.42e-5, 7.56e-5],
                    relative_errors: [
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                        f64::INFINITY,
                    ],
                    size: 0.091,
                    most: 2.68,
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
                    most: 2.97,
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
        const JUMPS: [f64; 4] = [7e-15, 5.73e-15, 3.94e-6, 3.26e-6];
        fn visit<V: ::hodograph::Visitor>(piece: usize, visitor: V) -> V::Output {
            match piece {
                0 => visitor.visit(super::frames_gutter_1::FramesGutter1),
                1 => visitor.visit(super::frames_gutter_2::FramesGutter2),
                _ => visitor.visit(super::frames_gutter_3::FramesGutter3),
            }
        }
    }
}
