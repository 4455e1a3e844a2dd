fn main() {}

hodograph::sweep! {
    sweep translation {
        profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
        path s(v) = ph([1, 2 + I, 3]);
        surface R = s + p.x*s.norml + q.z*k;
        domain u in 0..1, v in 0..1;
    }
}
