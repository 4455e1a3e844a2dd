fn main() {}

hodograph::sweep! {
    sweep plane {
        surfase R = u*i + v*j;
        domain u in 0..1, v in 0 1;
        claim "degree": degree(W) = (0, 0);
    }
}
