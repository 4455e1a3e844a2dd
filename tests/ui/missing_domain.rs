fn main() {}

hodograph::sweep! {
    sweep plane {
        surface R = u*i + v*j;
        domain u in 0..1;
    }
}
