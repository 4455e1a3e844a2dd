fn main() {}

hodograph::sweep! {
    sweep paraboloid {
        surface R = u*i + v*j + (u^2 + v^2)*k;
        domain u in 0..1, v in 0..1;
        claim "degree": degree(Z) == (2, 1);
    }
}
