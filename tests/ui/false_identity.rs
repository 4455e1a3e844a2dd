fn main() {}

hodograph::sweep! {
    sweep cylinder {
        path s(v) = ((1 - v^2)/(1 + v^2), 2*v/(1 + v^2));
        surface R = s + u*k;
        domain u in 0..1, v in 0..1;
        claim "unit circle": norm2(R) == 1;
    }
}
