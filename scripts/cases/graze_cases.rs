// Runs an intersect function of yours on hard cases with exact answers:
//
//     mod graze_cases;
//     fn main() { std::process::exit(graze_cases::run(my_intersect)) }
//
//     ./program cases.json [--junit FILE] [--report FILE] [--ulps N]
//
// `npm run cases` writes cases.json. The function gets the shape, and origin and direction; it
// returns every t of the whole line, ascending, a tangent once. For a kind that it does not know
// it returns None: the case is skipped. A case fails if the number of roots is wrong, or a root is
// off by more than N units in the last place, counted from the double that is nearest to the exact
// root. The exit code is 1 where a case failed, 2 where the file cannot be read.
#![allow(dead_code)]
use std::collections::HashMap;
use std::fmt::Write;

pub type Vec3 = [f64; 3];

#[derive(Default)]
pub struct Shape {
    pub kind: String,
    /// center, vertex, normal, point, corner
    pub vectors: HashMap<String, Vec3>,
    /// radius, slope, flare, width, side
    pub numbers: HashMap<String, f64>,
    /// axis
    pub words: HashMap<String, String>,
}

pub type Intersect = fn(&Shape, Vec3, Vec3) -> Option<Vec<f64>>;

/// As much JSON as the file has.
enum Json {
    Text(String),
    Number(f64),
    List(Vec<Json>),
    Object(Vec<(String, Json)>),
}

impl Json {
    fn at(&self, key: &str) -> Result<&Json, String> {
        match self {
            Json::Object(fields) => fields.iter().find(|(name, _)| name == key).map(|(_, x)| x),
            _ => None,
        }
        .ok_or(format!("no {key}"))
    }
    fn text(&self) -> &str {
        if let Json::Text(words) = self { words } else { "" }
    }
    fn number(&self) -> f64 {
        if let Json::Number(x) = self { *x } else { f64::NAN }
    }
    fn items(&self) -> &[Json] {
        if let Json::List(items) = self { items } else { &[] }
    }
    fn vector(&self) -> Result<Vec3, String> {
        match self.items() {
            [x, y, z] => Ok([x.number(), y.number(), z.number()]),
            _ => Err("a vector has three numbers".into()),
        }
    }
}

struct Reader<'a> {
    source: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    fn peek(&mut self) -> u8 {
        while self.source.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        self.source.get(self.at).copied().unwrap_or(0)
    }
    fn expect(&mut self, wanted: u8) -> Result<(), String> {
        if self.peek() != wanted {
            return Err(format!("expected {}", wanted as char));
        }
        self.at += 1;
        Ok(())
    }
    /// After an item, or at the beginning: whether another one follows.
    fn more(&mut self, end: u8, is_first: bool) -> Result<bool, String> {
        if self.peek() == end {
            self.at += 1;
            return Ok(false);
        }
        if !is_first {
            self.expect(b',')?;
        }
        Ok(true)
    }
    fn string(&mut self) -> Result<String, String> {
        self.expect(b'"')?;
        let from = self.at;
        while self.source.get(self.at).is_some_and(|c| *c != b'"') {
            self.at += 1;
        }
        let words = String::from_utf8_lossy(&self.source[from..self.at]).into_owned();
        self.expect(b'"')?;
        Ok(words)
    }
    fn read(&mut self) -> Result<Json, String> {
        match self.peek() {
            b'{' => {
                self.at += 1;
                let mut fields = Vec::new();
                while self.more(b'}', fields.is_empty())? {
                    self.peek();
                    let key = self.string()?;
                    self.expect(b':')?;
                    fields.push((key, self.read()?));
                }
                Ok(Json::Object(fields))
            }
            b'[' => {
                self.at += 1;
                let mut items = Vec::new();
                while self.more(b']', items.is_empty())? {
                    items.push(self.read()?);
                }
                Ok(Json::List(items))
            }
            b'"' => Ok(Json::Text(self.string()?)),
            _ => {
                let from = self.at;
                while self.source.get(self.at).is_some_and(|c| b"+-.eE0123456789".contains(c)) {
                    self.at += 1;
                }
                let words = String::from_utf8_lossy(&self.source[from..self.at]).into_owned();
                words.parse().map(Json::Number).map_err(|_| format!("no number: '{words}'"))
            }
        }
    }
}

struct Judged {
    id: String,
    family: String,
    state: &'static str,
    words: String,
    ulps: f64,
}

fn shape(json: &Json) -> Result<Shape, String> {
    let mut found = Shape::default();
    if let Json::Object(fields) = json {
        for (key, value) in fields {
            match value {
                Json::List(_) => drop(found.vectors.insert(key.clone(), value.vector()?)),
                Json::Number(x) => drop(found.numbers.insert(key.clone(), *x)),
                Json::Text(words) if key == "kind" => found.kind = words.clone(),
                other => drop(found.words.insert(key.clone(), other.text().into())),
            }
        }
    }
    Ok(found)
}

fn ulps_off(t: f64, exact: f64) -> f64 {
    if !t.is_finite() || !exact.is_finite() {
        return f64::INFINITY;
    }
    let size = exact.abs();
    let next = f64::from_bits(size.to_bits() + 1);
    let place = if next.is_finite() { next - size } else { size - f64::from_bits(size.to_bits() - 1) };
    (t - exact).abs() / place
}

fn judge(one: &Json, intersect: Intersect, most: f64) -> Result<Judged, String> {
    let ray = one.at("ray")?;
    let class = one.at("class")?.text();
    let hits = one.at("hits")?.items();
    let mut judged = Judged {
        id: one.at("id")?.text().into(),
        family: one.at("family")?.text().into(),
        state: "failed",
        words: String::new(),
        ulps: 0.0,
    };
    let (origin, direction) = (ray.at("origin")?.vector()?, ray.at("direction")?.vector()?);
    let Some(found) = intersect(&shape(one.at("shape")?)?, origin, direction) else {
        judged.state = "skipped";
        return Ok(judged);
    };
    if found.len() != hits.len() {
        judged.words = format!("{} roots, exactly {} ({class})", found.len(), hits.len());
        return Ok(judged);
    }
    for (t, hit) in found.iter().zip(hits) {
        let exact = hit.at("t")?.text().parse().map_err(|_| "t is no number".to_string())?;
        let off = ulps_off(*t, exact);
        judged.ulps = judged.ulps.max(off);
    }
    if judged.ulps <= most {
        judged.state = "passed";
    } else {
        judged.words = format!("off by {:.3e} ulps", judged.ulps);
    }
    Ok(judged)
}

fn count<'a>(results: impl IntoIterator<Item = &'a Judged>, state: &str) -> usize {
    results.into_iter().filter(|one| one.state == state).count()
}

fn junit(results: &[Judged]) -> String {
    let escaped = |words: &str| {
        words.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
    };
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let (failed, skipped) = (count(results, "failed"), count(results, "skipped"));
    let all = results.len();
    let _ = writeln!(
        out,
        "<testsuite name=\"graze\" tests=\"{all}\" failures=\"{failed}\" skipped=\"{skipped}\">"
    );
    for one in results {
        let _ = write!(out, "  <testcase classname=\"{}\" name=\"{}\"", one.family, one.id);
        let _ = match one.state {
            "passed" => writeln!(out, "/>"),
            "skipped" => writeln!(out, "><skipped/></testcase>"),
            _ => writeln!(out, "><failure message=\"{}\"/></testcase>", escaped(&one.words)),
        };
    }
    out + "</testsuite>\n"
}

fn report(results: &[Judged]) -> String {
    let mut out = String::from(
        "| family | cases | wrong | skipped | ulps: worst of the right ones | first that is wrong |\n\
         | --- | ---: | ---: | ---: | ---: | --- |\n",
    );
    let mut families: Vec<&str> = Vec::new();
    for one in results {
        if !families.contains(&one.family.as_str()) {
            families.push(&one.family);
        }
    }
    for family in families {
        let own: Vec<&Judged> = results.iter().filter(|one| one.family == family).collect();
        let passed = own.iter().filter(|one| one.state == "passed");
        let worst = passed.fold(0.0, |worst: f64, one| worst.max(one.ulps));
        let first = own.iter().find(|one| one.state == "failed");
        let first = first.map_or(String::new(), |one| format!("{}: {}", one.id, one.words));
        let (wrong, skipped) =
            (count(own.iter().copied(), "failed"), count(own.iter().copied(), "skipped"));
        let cases = own.len();
        let _ = writeln!(out, "| {family} | {cases} | {wrong} | {skipped} | {worst} | {first} |");
    }
    out
}

fn judged(file: &str, intersect: Intersect, most: f64) -> Result<Vec<Judged>, String> {
    let source = std::fs::read(file).map_err(|error| error.to_string())?;
    let given = Reader { source: &source, at: 0 }.read()?;
    if given.at("graze")?.text() != "hard-cases" || given.at("version")?.number() != 1.0 {
        return Err("has no hard cases of version 1".into());
    }
    given.at("cases")?.items().iter().map(|one| judge(one, intersect, most)).collect()
}

/// The exit code.
pub fn run(intersect: Intersect) -> i32 {
    let mut options: HashMap<String, String> = HashMap::new();
    let mut file = String::new();
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        if word.starts_with("--") {
            options.insert(word, words.next().unwrap_or_default());
        } else {
            file = word;
        }
    }
    let most = options.get("--ulps").and_then(|x| x.parse().ok()).unwrap_or(4503599627370496.0);
    let written = judged(&file, intersect, most).and_then(|results| {
        for (option, text) in [("--junit", junit(&results)), ("--report", report(&results))] {
            if let Some(path) = options.get(option) {
                std::fs::write(path, text).map_err(|error| error.to_string())?;
            }
        }
        Ok(results)
    });
    match written {
        Ok(results) => {
            let failed = count(&results, "failed");
            let (passed, skipped) = (count(&results, "passed"), count(&results, "skipped"));
            println!("{passed} passed, {failed} failed, {skipped} skipped");
            i32::from(failed > 0)
        }
        Err(words) => {
            eprintln!("{file}: {words}");
            2
        }
    }
}
