fn main() {}

hodograph::sweep! {
    sweep family {
        symbol c;
        surface R = u*i + v*j + c*u*v*k;
        domain u in 0..1, v in 0..1;
    }
}
