fn main() {}

hodograph::sweep!(file = "included.sweep");
