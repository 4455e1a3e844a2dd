fn main() {}

hodograph::sweep! {
    sweep power {
        surface R = u*i + v*j + (1 + u + v)^(10^9)*k;
        domain u in 0..1, v in 0..1;
    }
}
