//! The head of the `.vtp` files that `output::vtp` writes: which arrays there are, and where.

use crate::output::vtk_file::ENCODING;
use crate::output::vtp::{Array, Values};
use roxmltree::{Document, Node, ParsingOptions};

/// Most elements of a head.
const MAX_ELEMENTS: u32 = 10_000;

/// What the head of a file tells.
#[derive(Debug, PartialEq)]
pub(super) struct Head {
    pub step: u64,
    pub time: f64,
    pub texts: Vec<(String, Vec<String>)>,
    pub fields: Vec<Array>,
    pub points: usize,
    pub cells: usize,
    pub element: String,
    pub arrays: Vec<ArrayPlace>,
}

/// Where an array is, and what it holds.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ArrayPlace {
    pub section: String,
    pub name: String,
    pub kind: String,
    pub components: usize,
    pub tuples: usize,
    pub offset: u64,
}

impl Head {
    /// Reads a head.
    pub fn parse(text: &str) -> Result<Self, String> {
        let first = text.lines().next().unwrap_or_default();
        if !first.starts_with("<VTKFile type=\"PolyData\"") || !first.contains(ENCODING) {
            return Err("it does not begin as the files that Demeter writes".to_string());
        }
        let whole = format!("{}</AppendedData></VTKFile>", text.trim_end_matches('_'));
        let options = ParsingOptions {
            nodes_limit: MAX_ELEMENTS,
            ..ParsingOptions::default()
        };
        let document = Document::parse_with_options(&whole, options).map_err(|e| format!("its head is no XML: {e}"))?;
        let piece = child(child(document.root_element(), "PolyData")?, "Piece")?;
        let fields = child(child(document.root_element(), "PolyData")?, "FieldData")?;
        let count = |name: &str| number::<usize>(piece, name).ok_or_else(|| format!("its piece tells no `{name}`"));
        let counts = [
            count("NumberOfVerts")?,
            count("NumberOfLines")?,
            count("NumberOfPolys")?,
        ];
        let mut head = Self {
            step: field(fields, "step")?,
            time: field(fields, "TimeValue")?,
            texts: Vec::new(),
            fields: elements(fields).filter_map(whole_array).collect(),
            points: count("NumberOfPoints")?,
            cells: counts.iter().copied().max().unwrap_or(0),
            element: String::new(),
            arrays: Vec::new(),
        };
        let texts = elements(fields).filter(|node| node.attribute("type") == Some("String"));
        for node in texts {
            let name = node.attribute("Name").unwrap_or_default().to_string();
            head.texts.push((name, texts_of(node.text().unwrap_or_default())?));
        }
        for section in elements(piece) {
            if ["Verts", "Lines", "Polys"].contains(&section.tag_name().name()) {
                head.element = section.tag_name().name().to_string();
            }
            for node in elements(section) {
                let place = head.place(section.tag_name().name(), node);
                head.arrays
                    .push(place.ok_or("an array does not tell its name, type, components and place")?);
            }
        }
        Ok(head)
    }

    fn place(&self, section: &str, node: Node<'_, '_>) -> Option<ArrayPlace> {
        let name = node.attribute("Name")?;
        Some(ArrayPlace {
            section: section.to_string(),
            name: name.to_string(),
            kind: node.attribute("type")?.to_string(),
            components: number(node, "NumberOfComponents")?,
            tuples: match (section, name) {
                ("PointData" | "Points", _) | (_, "connectivity") => self.points,
                _ => self.cells,
            },
            offset: number(node, "offset")?,
        })
    }
}

fn elements<'a, 'i: 'a>(node: Node<'a, 'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(Node::is_element)
}

fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Result<Node<'a, 'i>, String> {
    let found = elements(node).find(|child| child.has_tag_name(name));
    found.ok_or_else(|| format!("its head has no `{name}`"))
}

fn number<T: std::str::FromStr>(node: Node<'_, '_>, name: &str) -> Option<T> {
    node.attribute(name)?.parse().ok()
}

/// A number that belongs to the file as a whole.
fn field<T: std::str::FromStr>(fields: Node<'_, '_>, name: &str) -> Result<T, String> {
    let found = elements(fields).find(|node| node.attribute("Name") == Some(name));
    let value = found.and_then(|node| node.text()?.trim().parse().ok());
    value.ok_or_else(|| format!("it tells no `{name}`"))
}

/// An array that belongs to the file as a whole: those of rows of numbers.
fn whole_array(node: Node<'_, '_>) -> Option<Array> {
    let components = number(node, "NumberOfComponents").filter(|components| *components > 0)?;
    let words = node.text().unwrap_or_default().split_ascii_whitespace();
    let values = match node.attribute("type")? {
        "Float64" => Values::Float64(words.map(|word| word.parse().ok()).collect::<Option<_>>()?),
        "Int32" => Values::Int32(words.map(|word| word.parse().ok()).collect::<Option<_>>()?),
        _ => return None,
    };
    let name = node.attribute("Name")?.to_string();
    Some(Array::new(name, components, values))
}

/// Texts from the codes of their bytes, each closed by a zero.
fn texts_of(codes: &str) -> Result<Vec<String>, String> {
    let bytes: Option<Vec<u8>> = codes.split_ascii_whitespace().map(|code| code.parse().ok()).collect();
    let bytes = bytes.ok_or("a text in its head is not told by the codes of its bytes")?;
    let Some(inner) = bytes.strip_suffix(&[0]) else {
        return Ok(Vec::new());
    };
    Ok(inner
        .split(|byte| *byte == 0)
        .map(|text| String::from_utf8_lossy(text).into_owned())
        .collect())
}
