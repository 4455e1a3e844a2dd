fn main() {}

hodograph::sweep! {
    sweep curve {
        surface R = u*i + u^2*j;
        domain u in 0..1, v in 0..1;
    }
}
