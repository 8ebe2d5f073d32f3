//! Reads cases of Graze as CSV, lets your intersect answer them, and writes a file of results.
//!
//!     rustc -O graze_results.rs && ./graze_results cases.csv results.csv
//!
//! `npm run grade -- --cases cases.csv` writes the cases, as does the page Check. Fill in
//! intersect.

use std::collections::HashMap;

/// A shape's numbers by their symbols: of a sphere Cx, Cy, Cz and r; an axis is in `words`.
#[allow(dead_code)]
struct Shape {
    kind: String,
    numbers: HashMap<String, f64>,
    words: HashMap<String, String>,
}

/// All t at which the line origin + t direction meets the shape: ascending, a tangent once; an
/// error for what is no shape or no ray.
#[allow(unused_variables)]
fn intersect(shape: &Shape, origin: [f64; 3], direction: [f64; 3]) -> Result<Vec<f64>, String> {
    Ok(vec![])
}

fn answer(head: &[&str], row: &[&str]) -> String {
    let mut shape = Shape {
        kind: row.get(1).unwrap_or(&"").to_string(),
        numbers: HashMap::new(),
        words: HashMap::new(),
    };
    for (name, cell) in head.iter().zip(row).skip(2).filter(|(_, cell)| !cell.is_empty()) {
        match cell.parse::<f64>() {
            Ok(x) => drop(shape.numbers.insert(name.to_string(), x)),
            Err(_) => drop(shape.words.insert(name.to_string(), cell.to_string())),
        }
    }
    let at = |name: &str| shape.numbers.get(name).copied().unwrap_or(f64::NAN);
    let origin = [at("Ex"), at("Ey"), at("Ez")];
    let direction = [at("dx"), at("dy"), at("dz")];
    match intersect(&shape, origin, direction) {
        Ok(t) => {
            let cells: Vec<String> = t.iter().map(|x| format!(",{x:e}")).collect();
            format!("{}{}\n", row[0], cells.concat())
        }
        Err(words) => format!("{},error,{}\n", row[0], words.replace(',', " ")),
    }
}

fn main() {
    let files: Vec<String> = std::env::args().collect();
    let text = std::fs::read_to_string(&files[1]).expect("cases");
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<&str>>());
    let head = lines.next().expect("a head");
    let rows: Vec<String> = lines.map(|row| answer(&head, &row)).collect();
    std::fs::write(&files[2], format!("id,t1,t2\n{}", rows.concat())).expect("results");
}
