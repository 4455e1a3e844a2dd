fn main() {}

hodograph::sweep!(file = "no_such.sweep");
