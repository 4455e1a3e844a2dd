//! Trial.
use hodograph_codegen::{language, meaning};
use std::time::Instant;
fn main() {
    for path in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&path).unwrap();
        let (file, source) = match language::parse_text(&path, &text) { Ok(x)=>x, Err(r)=>{println!("{r}"); continue} };
        let t = Instant::now();
        let (models, diags) = meaning::models(&file);
        println!("models {:?}", t.elapsed());
        if !diags.is_empty() { println!("{}", language::Report::new(source.clone(), diags)); }
        for m in &models {
            println!("== {} {:?}", m.name, m.formula);
            if let Some(s) = &m.surface {
                let t = Instant::now();
                let h = s.homogeneous();
                println!("degrees {:?} {} raw {} common {} in {:?}", h.degrees().map(|d|d.to_string()), h.degree(), h.raw_degree(), h.common_factor(), t.elapsed());
                let t = Instant::now();
                match s.derive() { Err(e)=>println!("{e}"), Ok(d)=>{
                println!("derive {:?}", t.elapsed());
                println!("field {:?}", (0..d.field.generators().len()).map(|i| d.field.relation(i).to_string()).collect::<Vec<_>>());
                println!("W {}", d.homogeneous.coordinates()[0]);
                println!("N {:?}", d.normal.numerator());
                println!("N2 {} split {:?}", d.normal.norm_squared(), d.normal.split());
                println!("factor {}", d.normal.factor());
                println!("speeds {} ; {}", d.speeds[0], d.speeds[1]);
                println!("singular {:?}", d.singular_zeros);
                match &d.offset { hodograph_algebra::Offset::Rational(o) => println!("offset degree {:?}", o.degrees().map(|d|d.to_string())), o=>println!("{o:?}")}
                println!("net {:?} {:?}", d.control_net.degree, d.control_net.points[0][0]);
                }}
            }
            for c in &m.claims {
                let t = Instant::now();
                match m.check(c, 2_000_000_000) { Ok(j) => println!("{:?} {} [{}] expected {} | {} | scope {} | {:?} ({:?})", j.id, j.verdict, j.statement, j.expected, j.derived, j.scope, j.witness, t.elapsed()), Err(d) => {
                    let mut ds=language::Diagnostics::new(); ds.push(*d); println!("{}", language::Report::new(source.clone(), ds)); } }
            }
        }
    }
}
