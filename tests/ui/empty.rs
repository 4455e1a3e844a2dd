fn main() {}

hodograph::sweep! {}
