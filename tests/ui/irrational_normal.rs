fn main() {}

hodograph::sweep! {
    sweep tube {
        path s(v) = (v, v^2);
        surface R = s + u*s.normal;
        domain u in 0..1, v in 0..1;
    }
}
