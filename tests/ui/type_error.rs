fn main() {}

hodograph::sweep! {
    sweep plane {
        path s(v) = (v, v^2);
        surface R = u + s;
        domain u in 0..1, v in 0..1;
    }
}
