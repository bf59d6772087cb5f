//! A plain list of polygons → the tree of a scene without materials.
//!
//! JSON: `[[[0,0,0],[1,0,0],[0,1,0]], …]`, a list of vertices per polygon. CSV: a row `name,x,y,z` per
//! vertex, with or without that header; successive rows of one name make a polygon. Lines that start with `#`
//! are left out.

use radiosity_scene::{
    Fault,
    error::Located,
    place::{At, Span},
    tree::{Node, Value},
};

use crate::{
    csv_rows::{Row, rows},
    fields::not_a_number,
};

const COLUMNS: [&str; 4] = ["name", "x", "y", "z"];

/// The tree of a scene with one surface for each item of a list; none of what is no list.
pub(super) fn from_list(polygons: &Node) -> Option<Node> {
    let surfaces = polygons.items()?.iter().map(|vertices| surface(None, vertices.clone())).collect();
    Some(scene(surfaces, &polygons.span))
}

/// The tree of a scene with the polygons of a CSV text.
pub(super) fn from_csv(text: &str) -> Result<Node, Located> {
    let mut polygons: Vec<(At<String>, Vec<Node>)> = Vec::new();
    for (index, row) in rows(text).enumerate() {
        if index == 0 && is_header(&row) {
            continue;
        }
        let fields = fields(text, &row)?;
        let vertex = vertex(&fields)?;
        match polygons.last_mut().filter(|(name, _)| name.value == fields[0].value) {
            Some((_, vertices)) => vertices.push(vertex),
            None => polygons.push((fields[0].clone(), vec![vertex])),
        }
    }
    let surfaces = polygons.into_iter().map(|(name, vertices)| {
        let span = name.span.start..vertices[vertices.len() - 1].span.end;
        surface(Some(name), At::new(Value::List(vertices), &span))
    });
    Ok(scene(surfaces.collect(), &(0..text.len())))
}

/// Whether the first row of a text is one of a list of polygons: the header, or a name and three numbers.
pub(super) fn starts_csv(text: &str) -> bool {
    let is_vertex = |row: &Row| {
        row.fields.len() == COLUMNS.len() && row.fields[1..].iter().all(|field| field.parse::<f64>().is_ok())
    };
    rows(text).next().is_some_and(|row| is_header(&row) || is_vertex(&row))
}

fn is_header(row: &Row) -> bool {
    row.fields.len() == COLUMNS.len()
        && row.fields.iter().zip(COLUMNS).all(|(field, name)| field.eq_ignore_ascii_case(name))
}

/// The four fields of a row, each with its place in the text.
fn fields(text: &str, row: &Row) -> Result<Vec<At<String>>, Located> {
    let start = row.start;
    let line = start..start + text[start..].find('\n').unwrap_or(text.len() - start);
    let mut next = start;
    // Text with quotes in it stands differently in the file: then the whole line is meant.
    let place = |field: &String| {
        let Some(at) = text[next..].find(field.as_str()).map(|at| next + at).filter(|at| *at <= line.end)
        else {
            return At::new(field.clone(), &line);
        };
        next = at + field.len();
        At::new(field.clone(), &(at..next))
    };
    let fields: Vec<At<String>> = row.fields.iter().map(place).collect();
    if fields.len() != COLUMNS.len() {
        let expected = "four fields parted by commas, name,x,y,z";
        let fault = Fault::wrong_count("a row", expected, fields.len());
        return Err(Located::at(&line, fault));
    }
    Ok(fields)
}

fn vertex(fields: &[At<String>]) -> Result<Node, Located> {
    let number = |field: &At<String>| match field.value.parse() {
        Ok(number) => Ok(At::new(Value::Number(number), &field.span)),
        Err(_) => Err(Located::at(&field.span, not_a_number("a text"))),
    };
    let point: Vec<Node> = fields[1..].iter().map(number).collect::<Result<_, _>>()?;
    let span = fields[1].span.start..fields[3].span.end;
    Ok(At::new(Value::List(point), &span))
}

fn surface(name: Option<At<String>>, vertices: Node) -> Node {
    let span = name.as_ref().map_or(&vertices.span, |name| &name.span).clone();
    let polygon = At::new(Value::Table(vec![(key("vertices", &span), vertices)]), &span);
    let name = name.map(|name| (key("name", &span), At::new(Value::Text(name.value), &name.span)));
    let entries = name.into_iter().chain([(key("polygon", &span), polygon)]).collect();
    At::new(Value::Table(entries), &span)
}

fn scene(surfaces: Vec<Node>, span: &Span) -> Node {
    At::new(Value::Table(vec![(key("surfaces", span), At::new(Value::List(surfaces), span))]), span)
}

fn key(name: &str, span: &Span) -> At<String> {
    At::new(name.to_owned(), span)
}

#[cfg(test)]
mod tests {
    use radiosity_scene::{FaultKind, Source};

    const TRIANGLES: &str = "# two of them\nname,x,y,z\na,0,0,0\na, 1,0,0\na,0,1,0\n\"b, too\",0,0,1\n\"b, too\",0,1,1\n\"b, too\",1,0,1\n";

    #[test]
    fn rows_of_one_name_make_a_polygon() {
        for text in [TRIANGLES, &TRIANGLES.replace("name,x,y,z\n", "")] {
            let scene = crate::read(&Source::new("two.csv", text)).unwrap();
            let names: Vec<&str> = scene.surfaces.iter().map(|surface| surface.name.as_str()).collect();
            assert_eq!(names, ["a", "b, too"]);
            assert!(scene.surfaces.iter().all(|surface| (surface.shape.area() - 0.5).abs() < 1e-15));
        }
    }

    #[test]
    fn a_json_list_is_a_list_of_polygons() {
        let scene = crate::read(&Source::new("one.json", "[[[0,0,0],[1,0,0],[0,1,0]]]")).unwrap();
        assert_eq!(scene.surfaces[0].name, "surface-1");
        let error = crate::read(&Source::new("one.json", "[[[0,0,0],[1,0,0],\n [0,1]]]")).unwrap_err();
        assert!(error.to_string().starts_with("one.json:2:2: surface \"surface-1\": "), "{error}");
    }

    #[test]
    fn faults_of_rows_are_placed() {
        let error = |old, new| crate::read(&Source::new("t.csv", &TRIANGLES.replace(old, new))).unwrap_err();
        assert!(error("a, 1,0,0", "a, 1,O,0").to_string().starts_with("t.csv:4:6: expected a number"));
        assert!(error("a, 1,0,0", "a, 1,0").to_string().starts_with("t.csv:4:1: a row takes four fields"));
        let spaced = "a,0,0,0\n\n# three\n\na, 1,O,0";
        assert!(error("a,0,0,0\na, 1,0,0", spaced).to_string().starts_with("t.csv:7:6: expected a number"));
        assert_eq!(error("a, 1,0,0", "a, NaN,0,0").fault.kind, FaultKind::NotFinite);
        let empty = crate::read(&Source::new("t.csv", "name,x,y,z\n")).unwrap_err();
        assert_eq!(empty.to_string(), "t.csv: the scene has no surface");
    }
}
