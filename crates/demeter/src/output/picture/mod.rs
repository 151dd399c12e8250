//! A picture of the packing, drawn without a graphics card: spheres coloured by what they feel, walls as thin lines.
//!
//! The same frame gives the same picture on every machine and with any number of threads.

mod camera;
mod chains;
mod colouring;
mod cut;
mod edges;
mod faces;
mod image;
mod shading;
mod spheres;
mod together;
mod viridis;

pub use camera::View;
pub use colouring::ColourBy;
pub use cut::Cut;
pub(crate) use image::Font;
pub use image::Image;

use super::frame::Frame;
use super::ticks::Ticks;
use camera::{Area, Bounds, Camera};
use colouring::{Colouring, Legend};
use cut::Planes;
use glam::DVec3;
use image::to_linear;
use shading::{Lighting, Rgb};
use spheres::{Sight, Sphere};
use together::Drawn;

/// Every pixel is the mean of a square of this many pixels on a side.
const SCALE: usize = 2;
const PAPER: [u8; 3] = [255, 255, 255];
const INK: [u8; 3] = [38, 44, 52];
const FAINT: [u8; 3] = [104, 112, 122];
const LINE: [u8; 3] = [70, 78, 88];
const FACE: [u8; 3] = [96, 125, 160];

/// How a picture is made.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureOptions {
    /// Text over the picture.
    pub title: String,
    /// What the colours tell.
    pub colour: ColourBy,
    /// Width [pixels], 400 to 8000.
    pub width: usize,
    /// Height [pixels], 300 to 6000.
    pub height: usize,
    /// Where one looks from.
    pub view: View,
    /// Lower and upper corner of what is shown [m]; all grains and the walls near them when absent.
    pub region: Option<(DVec3, DVec3)>,
    /// Value at the start of the colour bar, in SI; when absent 0, or of diameters about the least. Force chains begin at 0.
    pub colour_start: Option<f64>,
    /// Value at the end of the colour bar, in SI; where most values end when absent.
    pub colour_end: Option<f64>,
    /// How walls are drawn.
    pub walls: WallLook,
    /// Whether the contacts are drawn as cylinders between the centres, thick and bright where the force is large, and the
    /// grains faintly behind them.
    pub chains: bool,
    /// What is cut away.
    pub cuts: Vec<Cut>,
}

/// How walls are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WallLook {
    /// Where surfaces end, bend, or turn away.
    #[default]
    Lines,
    /// These lines, and the surfaces between them translucent.
    Faces,
    /// Not at all.
    Hidden,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self {
            title: String::new(),
            colour: ColourBy::Automatic,
            width: 1200,
            height: 900,
            view: View::default(),
            region: None,
            colour_start: None,
            colour_end: None,
            walls: WallLook::Lines,
            chains: false,
            cuts: Vec::new(),
        }
    }
}

/// Draws the grains and walls of a frame.
pub fn render_packing(frame: &Frame, options: &PictureOptions) -> Image {
    let width = options.width.clamp(400, 8000);
    let height = options.height.clamp(300, 6000);
    let colouring = Colouring::new(frame, options.colour, ends(options));
    let bar = options.chains.then(|| chains::Chains::new(frame, options.colour_end));
    let mut image = scene(frame, &colouring, bar.as_ref(), (width, height), options);
    write_titles(&mut image, frame, options);
    if let Some(chains) = &bar {
        draw_bar(&mut image, &chains.label, &chains.bar);
    } else if !frame.grains.is_empty() {
        match &colouring.legend {
            Legend::Bar(bar) => draw_bar(&mut image, &colouring.label, bar),
            Legend::Names(names) => draw_names(&mut image, &colouring.label, names),
        }
    }
    image
}

/// The place of the scene in a picture, without title and legend.
fn scene_area(width: usize, height: usize) -> Area {
    let (width, height) = (width as f64, height as f64);
    Area {
        left: 50.0,
        top: 100.0,
        width: width - 50.0 - 190.0,
        height: height - 100.0 - 40.0,
    }
}

fn scene(
    frame: &Frame,
    colouring: &Colouring,
    chains: Option<&chains::Chains>,
    (width, height): (usize, usize),
    options: &PictureOptions,
) -> Image {
    let scale = SCALE as f64;
    let area = scene_area(width, height);
    let area = Area {
        left: scale * area.left,
        top: scale * area.top,
        width: scale * area.width,
        height: scale * area.height,
    };
    let (columns, rows) = (SCALE * width, SCALE * height);
    let region = options
        .region
        .map_or_else(|| bounds(frame, options), |(lower, upper)| thick(lower, upper));
    let camera = Camera::showing(&region, &area, options.view);
    let planes = Planes::new(&options.cuts, &camera);
    let sight = Sight {
        camera: &camera,
        planes: &planes,
    };
    let albedo: Vec<Rgb> = colouring.colours.iter().map(|colour| colour.map(to_linear)).collect();
    let grains = drawn(own_grains(frame), albedo, sight, (columns, rows));
    let grains = grains.together(frame.part.together, frame.own().start as u32, sight);
    let mut layer = Layer::new(grains, sight, columns);
    if let Some(chains) = chains {
        let front = drawn(
            chains.beads.iter().copied(),
            chains.albedo.clone(),
            sight,
            (columns, rows),
        );
        layer.fade_behind(Layer::new(front, sight, columns));
    }
    if options.walls != WallLook::Hidden {
        // A wall that goes on far beyond the grains must not run through the title and the legend.
        let first_row = (area.top - 20.0 * scale) as usize;
        let last_column = (area.left + area.width + 20.0 * scale) as usize;
        layer.draw_walls(frame, sight, columns, options.walls, (first_row, last_column));
    }
    Image::reduce(&layer.colours, columns, SCALE)
}

/// Centres and radii of the own grains [m].
fn own_grains(frame: &Frame) -> impl Iterator<Item = (DVec3, f64)> {
    let rows = &frame.grains.position.rows()[frame.own()];
    rows.iter().map(|row| (row.vector, row.scalar))
}

/// Which of some spheres every pixel sees.
fn drawn(
    spheres: impl Iterator<Item = (DVec3, f64)>,
    albedo: Vec<Rgb>,
    sight: Sight,
    (columns, rows): (usize, usize),
) -> Drawn {
    let sphere = |(p, radius)| Sphere {
        centre: sight.camera.local(p),
        radius,
    };
    let spheres: Vec<Sphere> = spheres.map(sphere).collect();
    Drawn {
        seen: spheres::draw(&spheres, sight, columns, rows),
        spheres,
        albedo,
    }
}

/// Lit spheres: what every pixel sees, and its colour.
struct Layer {
    seen: Vec<spheres::Seen>,
    colours: Vec<Rgb>,
}

impl Layer {
    /// How much of the colour of grains is left behind force chains.
    const FADED: f32 = 0.22;

    fn new(drawn: Drawn, sight: Sight, columns: usize) -> Self {
        let paper = PAPER.map(to_linear);
        let colours = Lighting::new(&drawn, sight).shade(&drawn.seen, columns, &drawn.albedo, paper);
        let seen = drawn.seen;
        Self { seen, colours }
    }

    /// Fades this layer and lays another over it.
    fn fade_behind(&mut self, front: Self) {
        let paper = PAPER.map(to_linear);
        for (k, colour) in self.colours.iter_mut().enumerate() {
            if !front.seen[k].is_covered() {
                (0..3).for_each(|c| colour[c] = paper[c] + Self::FADED * (colour[c] - paper[c]));
            } else {
                *colour = front.colours[k];
                self.seen[k] = front.seen[k];
            }
        }
    }

    fn draw_walls(
        &mut self,
        frame: &Frame,
        sight: Sight,
        columns: usize,
        look: WallLook,
        (first_row, last_column): (usize, usize),
    ) {
        let own = |t: &[DVec3; 3]| t.map(|p| sight.camera.local(p));
        let surfaces: Vec<Vec<[DVec3; 3]>> = frame
            .walls
            .iter()
            .map(|wall| wall.triangles.iter().map(own).collect())
            .collect();
        let free = |k: usize| k / columns >= first_row && k % columns <= last_column;
        if look == WallLook::Faces {
            let cover = faces::draw(&surfaces, sight, &self.seen, columns);
            lay_over(&mut self.colours, &cover, FACE.map(to_linear), free);
        }
        let lines: Vec<edges::Line> = surfaces
            .iter()
            .flat_map(|surface| edges::feature_lines(surface))
            .collect();
        let cover = edges::draw(&lines, sight, &self.seen, columns, 0.7 * SCALE as f64);
        lay_over(&mut self.colours, &cover, LINE.map(to_linear), free);
    }
}

/// Lays a colour over pixels, as much as covers them.
fn lay_over(colours: &mut [Rgb], cover: &[f32], ink: Rgb, free: impl Fn(usize) -> bool) {
    let pixels = colours.iter_mut().zip(cover).enumerate();
    for (_, (colour, share)) in pixels.filter(|(k, _)| free(*k)) {
        (0..3).for_each(|c| colour[c] += share * (ink[c] - colour[c]));
    }
}

/// The ends of the colour bar that are told.
fn ends(options: &PictureOptions) -> colouring::Ends {
    (options.colour_start, options.colour_end)
}

/// The start and end of the colour bar of a frame, in SI, so that other frames can have the same; nothing for names.
pub fn colour_range(frame: &Frame, options: &PictureOptions) -> Option<(f64, f64)> {
    match options.chains {
        true => Some((0.0, chains::Chains::new(frame, options.colour_end).end)),
        false => Colouring::new(frame, options.colour, ends(options)).range(),
    }
}

/// What a picture of a frame shows: lower and upper corner [m].
pub fn shown_region(frame: &Frame, options: &PictureOptions) -> (DVec3, DVec3) {
    let bounds = bounds(frame, options);
    (bounds.lower, bounds.upper)
}

/// What the picture shows: all grains, and the walls as far as they are near them; of both what is not cut away.
fn bounds(frame: &Frame, options: &PictureOptions) -> Bounds {
    let mut lower = DVec3::INFINITY;
    let mut upper = DVec3::NEG_INFINITY;
    for (p, r) in own_grains(frame) {
        if p.is_finite() && r.is_finite() && options.cuts.iter().all(|cut| cut.keeps_some(p, r)) {
            lower = lower.min(p - r);
            upper = upper.max(p + r);
        }
    }
    let all = |own: f64| frame.part.together.largest(own);
    (lower, upper) = (-(-lower).map(all), upper.map(all));
    let shown = if options.walls == WallLook::Hidden {
        &[]
    } else {
        frame.walls
    };
    let corners = || {
        shown
            .iter()
            .flat_map(|w| w.triangles.iter().flatten())
            .filter(|p| p.is_finite())
    };
    let (near, far) = if lower.x <= upper.x {
        let margin = 0.8 * (upper - lower).max_element();
        (lower - margin, upper + margin)
    } else {
        (DVec3::NEG_INFINITY, DVec3::INFINITY)
    };
    for &corner in corners() {
        lower = lower.min(corner.clamp(near, far));
        upper = upper.max(corner.clamp(near, far));
    }
    let bounds = (options.cuts.iter()).fold(Bounds { lower, upper }, |bounds, cut| cut.of_box(bounds));
    if !bounds.lower.cmple(bounds.upper).all() {
        return thick(DVec3::ZERO, DVec3::ONE);
    }
    thick(bounds.lower, bounds.upper)
}

/// A box with some extent in every direction: a single plane has no thickness, and the camera needs some.
fn thick(lower: DVec3, upper: DVec3) -> Bounds {
    let thickness = (1e-3 * (upper - lower).max_element()).max(f64::MIN_POSITIVE);
    Bounds {
        lower: lower - thickness,
        upper: upper + thickness,
    }
}

fn write_titles(image: &mut Image, frame: &Frame, options: &PictureOptions) {
    let left = 40;
    let title = fitted(&options.title, Font::TITLE, image.width() - 2 * left);
    image.text(left, 28, &title, Font::TITLE, INK);
    let grains = frame.grains.len();
    let noun = if grains == 1 { "grain" } else { "grains" };
    let details = format!("{} {noun}, t = {} s", grouped(grains), short(frame.time));
    image.text(left, 28 + Font::TITLE.height() + 8, &details, Font::TEXT, FAINT);
}

/// The colour bar at the right side, with the quantity above it.
fn draw_bar(image: &mut Image, label: &str, bar: &colouring::Bar) {
    let (width, height) = (image.width(), image.height());
    let (bar_width, bar_height) = (26, height * 55 / 100);
    let (left, top) = (width - 150, height * 26 / 100);
    write_label(image, label, top - 46);
    for row in 0..bar_height {
        let share = 1.0 - (row as f64 + 0.5) / bar_height as f64;
        image.fill(left, top + row, bar_width, 1, colouring::map(share));
    }
    if bar.saturated {
        // A tip over the bar: some grains are above its end.
        for row in 0..14 {
            let inset = bar_width * (14 - row) / 28;
            image.fill(
                left + inset,
                top - 14 + row,
                bar_width - 2 * inset,
                1,
                colouring::map(1.0),
            );
        }
    }
    let ticks = Ticks::inside(bar.low, bar.high, 5.0);
    for (value, text) in ticks.values.iter().zip(&ticks.labels) {
        let share = (value - bar.low) / (bar.high - bar.low);
        let y = top + ((1.0 - share) * bar_height as f64 + 0.5) as usize;
        image.fill(left + bar_width, y.min(top + bar_height - 1), 7, 1, INK);
        image.text(
            left + bar_width + 13,
            y - Font::TEXT.height() / 2,
            text,
            Font::TEXT,
            INK,
        );
    }
}

/// The names of the materials at the right side, each with its colour.
fn draw_names(image: &mut Image, label: &str, names: &[(String, [u8; 3])]) {
    let (left, top) = (image.width() - 180, image.height() * 26 / 100);
    write_label(image, label, top - 46);
    let rows = (image.height() - top) / 32;
    for (k, (name, colour)) in names.iter().take(rows).enumerate() {
        image.fill(left, top + 32 * k, 20, 20, *colour);
        let name = fitted(name, Font::TEXT, 140);
        image.text(left + 30, top + 32 * k, &name, Font::TEXT, INK);
    }
}

fn write_label(image: &mut Image, label: &str, y: usize) {
    let x = image.width().saturating_sub(Font::TEXT.width(label) + 24);
    image.text(x, y, label, Font::TEXT, INK);
}

/// A text, shortened to a width.
fn fitted(text: &str, font: Font, width: usize) -> String {
    let most = width / font.width("M").max(1);
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let kept: String = text.chars().take(most.saturating_sub(3)).collect();
    kept + "..."
}

/// A number with its thousands apart.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A number with four digits.
fn short(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e5).contains(&value.abs()) {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests;
