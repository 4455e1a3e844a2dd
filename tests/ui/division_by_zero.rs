fn main() {}

hodograph::sweep! {
    sweep plane {
        let zero = 2 - sqrt(4);
        surface R = u*i + v/zero*j;
        domain u in 0..1, v in 0..1;
    }
}
