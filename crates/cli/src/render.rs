//! `demeter render`: pictures of the frames of a run.

use crate::answer::{answer, answer_json, note};
use crate::arguments::RenderArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::suggestion::did_you_mean;
use demeter::output::picture::{ColourBy, PictureOptions, View, WallLook};
use demeter::render::{Cut, LoadedFrame};
use demeter::results::{Moment, Run};
use demeter::scenario::units;
use demeter_physics::dimension::Dimension;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Views that have a name: degrees about z from the x axis, and above the horizon.
const VIEWS: [(&str, f64, f64); 7] = [
    ("corner", -62.0, 17.0),
    ("front", -90.0, 0.0),
    ("back", 90.0, 0.0),
    ("right", 0.0, 0.0),
    ("left", 180.0, 0.0),
    ("top", -90.0, 90.0),
    ("bottom", -90.0, -90.0),
];

/// Draws frames of a run.
pub fn render(arguments: &RenderArguments) -> Result<Exit, Failure> {
    let run = Run::open(&arguments.run)?;
    let moments = run.moments()?;
    let Some(last) = moments.last().copied() else {
        let place = arguments.run.display();
        return Err(Failure::wrong(match run.missing_frames()? {
            Some(problem) => format!("`{place}`: {problem}"),
            None => format!("the run in `{place}` has no frames; tell `output.frames` in its scenario"),
        }));
    };
    if let Some(problem) = run.missing_frames()? {
        note(&format!("warning: `{}`: {problem}", arguments.run.display()));
    }
    let mut options = options(arguments, &run)?;
    if arguments.frame == "all" {
        let files = movie(arguments, &run, &moments, &mut options)?;
        return tell(arguments, &files, Some(&files[0]));
    }
    let moment = one(&arguments.frame, &moments, last)?;
    let file = arguments
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{}-{}.png", name_of(&arguments.run), moment.step)));
    if !file
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("png"))
    {
        return Err(Failure::wrong(format!(
            "--out: `{}` does not end with .png",
            file.display()
        )));
    }
    let frame = LoadedFrame::read(&run, moment.step)?;
    if !frame.shows_grains(&options) {
        note("warning: the picture shows no grain: all of them are cut away (`--clip`)");
    }
    draw(&frame, &options, &file)?;
    tell(arguments, &[file], None)
}

fn tell(arguments: &RenderArguments, files: &[PathBuf], movie: Option<&PathBuf>) -> Result<Exit, Failure> {
    if arguments.json {
        let files: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
        answer_json(&json!({ "files": files }))?;
        return Ok(Exit::Finished);
    }
    match (files, movie.and_then(|first| first.parent())) {
        ([only], None) => answer(&format!("wrote {}\n", only.display()))?,
        (_, folder) => {
            let folder = folder.unwrap_or(Path::new("."));
            let shown = folder.display();
            answer(&format!("wrote {} pictures into {shown}\n", files.len()))?;
            note(&format!(
                "a film of them: ffmpeg -framerate 25 -i {shown}/%05d.png -c:v libx264 -pix_fmt yuv420p {shown}.mp4"
            ));
        }
    }
    Ok(Exit::Finished)
}

/// All frames, seen from one place and with one colour bar, into a folder.
fn movie(
    arguments: &RenderArguments,
    run: &Run,
    moments: &[Moment],
    options: &mut PictureOptions,
) -> Result<Vec<PathBuf>, Failure> {
    let folder = arguments
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{}-frames", name_of(&arguments.run))));
    if folder.extension().is_some_and(|ending| ending == "png") {
        return Err(Failure::wrong("--out: name a folder for the pictures of `--frame all`"));
    }
    std::fs::create_dir_all(&folder)
        .map_err(|error| Failure::io(format!("cannot make the folder `{}`: {error}", folder.display())))?;
    // The first, the middle and the last frame tell what all show.
    let mut looked = vec![0, moments.len() / 2, moments.len() - 1];
    looked.dedup();
    let mut region = None;
    for k in looked {
        let frame = LoadedFrame::read(run, moments[k].step)?;
        let (low, high) = frame.region(options);
        let union = |(a, b): (demeter_physics::DVec3, demeter_physics::DVec3)| (a.min(low), b.max(high));
        region = Some(region.map_or((low, high), union));
        if k + 1 == moments.len()
            && let Some((start, end)) = frame.colour_range(options)
        {
            options.colour_start = Some(start);
            options.colour_end = Some(end);
        }
    }
    options.region = region;
    remove_numbered(&folder, moments.len())?;
    let mut files = Vec::with_capacity(moments.len());
    for (k, moment) in moments.iter().enumerate() {
        let file = folder.join(picture_name(k));
        draw(&LoadedFrame::read(run, moment.step)?, options, &file)?;
        files.push(file);
    }
    Ok(files)
}

/// Removes the pictures of an earlier, longer film, which would follow those that are drawn now.
fn remove_numbered(folder: &Path, from: usize) -> Result<(), Failure> {
    let failed =
        |error: std::io::Error| Failure::io(format!("cannot clear the folder `{}`: {error}", folder.display()));
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let number = path.file_stem().and_then(|stem| stem.to_str()?.parse::<usize>().ok());
        if number.is_some_and(|k| k >= from && path.file_name() == picture_name(k).file_name()) {
            std::fs::remove_file(&path).map_err(failed)?;
        }
    }
    Ok(())
}

/// Name of a picture of a film.
fn picture_name(k: usize) -> PathBuf {
    PathBuf::from(format!("{k:05}.png"))
}

fn draw(frame: &LoadedFrame, options: &PictureOptions, file: &Path) -> Result<(), Failure> {
    frame
        .picture(options)
        .write_png(file)
        .map_err(|error| Failure::io(error.to_string()))
}

fn name_of(run: &Path) -> String {
    let real = run.canonicalize().unwrap_or_else(|_| run.to_owned());
    real.file_name()
        .map_or_else(|| "run".to_owned(), |name| name.to_string_lossy().into_owned())
}

/// The moment that is asked for: `last`, a number from 0, or the one nearest to a time.
fn one(told: &str, moments: &[Moment], last: Moment) -> Result<Moment, Failure> {
    if told == "last" {
        return Ok(last);
    }
    if let Ok(number) = told.parse::<usize>() {
        return moments.get(number).copied().ok_or_else(|| {
            let there = moments.len();
            Failure::wrong(format!(
                "--frame: there is no frame number {number}; there are {there}, from 0"
            ))
        });
    }
    match units::parse(told) {
        Ok(time) if time.dimension == Dimension::TIME => {
            let away = |moment: &&Moment| (moment.time - time.value).abs();
            let nearest = moments.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
            let (nearest, first) = (
                nearest.copied().unwrap_or(last),
                moments.first().map_or(last.time, |m| m.time),
            );
            if time.value < first || time.value > last.time {
                note(&format!(
                    "warning: --frame: there is no frame at {told}; they are from {first} s to {} s, and that at {} s is drawn",
                    last.time, nearest.time
                ));
            }
            Ok(nearest)
        }
        _ => Err(Failure::wrong(format!(
            "--frame: `{told}` is no frame; tell `last`, `all`, a number from 0, or a time, as \"0.5 s\""
        ))),
    }
}

fn options(arguments: &RenderArguments, run: &Run) -> Result<PictureOptions, Failure> {
    let (width, height) = size(&arguments.size)?;
    let names = || ColourBy::NAMED.iter().map(|(name, _)| *name);
    let colour = ColourBy::NAMED
        .iter()
        .find(|(name, _)| *name == arguments.colour)
        .ok_or_else(|| {
            let known = names().collect::<Vec<_>>().join(", ");
            let meant = did_you_mean(&arguments.colour, names());
            Failure::wrong(format!(
                "--colour: `{}` is no quantity of grains; there are {known}.{meant}",
                arguments.colour
            ))
        })?;
    let title = match &arguments.title {
        Some(title) => title.clone(),
        None => {
            let summary = run.summary().ok().flatten();
            let title = summary.as_ref().and_then(|summary| summary["title"].as_str());
            title.map_or_else(|| name_of(&arguments.run), str::to_owned)
        }
    };
    let value = |name: &str, told: &Option<String>| {
        let told = told.as_deref();
        told.map(|text| colour_value(name, text, colour.1)).transpose()
    };
    let start = value("--colour-start", &arguments.colour_start)?;
    let end = value("--colour-end", &arguments.colour_end)?;
    if let (Some(end), Some(text)) = (end, &arguments.colour_end)
        && end <= start.unwrap_or(0.0)
    {
        return Err(Failure::wrong(match &arguments.colour_start {
            Some(start) => format!("--colour-end: `{text}` is not above `--colour-start`, which is `{start}`"),
            None => format!("--colour-end: `{text}` is no value above 0, as \"2 m/s\" or \"5 mN\""),
        }));
    }
    Ok(PictureOptions {
        title,
        colour: colour.1,
        width,
        height,
        view: view(&arguments.view)?,
        colour_start: start,
        colour_end: end,
        walls: match arguments.walls.as_str() {
            "faces" => WallLook::Faces,
            "none" => WallLook::Hidden,
            _ => WallLook::Lines,
        },
        chains: arguments.chains,
        cuts: cuts(arguments)?,
        ..PictureOptions::default()
    })
}

/// A value with a unit of what the colours tell, or a number in SI.
fn colour_value(name: &str, text: &str, by: ColourBy) -> Result<f64, Failure> {
    let wrong = |message: String| Err(Failure::wrong(format!("{name}: `{text}` {message}")));
    let Ok(quantity) = units::parse(text) else {
        return wrong("is no value, as \"2 m/s\" or \"5 mN\"".to_string());
    };
    if by == ColourBy::Material {
        return wrong("is the end of a bar, and materials have none".to_string());
    }
    if quantity.dimension == Dimension::NONE {
        return Ok(quantity.value);
    }
    // the colours of themselves tell forces, or diameters where there are none
    let meant = by.unit().map_or(vec!["N", "m"], |unit| vec![unit]);
    let is_meant =
        |unit: &&str| units::parse(&format!("1 {unit}")).is_ok_and(|one| one.dimension == quantity.dimension);
    if meant.iter().any(is_meant) {
        return Ok(quantity.value);
    }
    let allowed = meant.join(" or ");
    wrong(match allowed.is_empty() {
        true => "has a unit; what the colours tell has none".to_string(),
        false => format!("has another unit than what the colours tell, which is in {allowed}"),
    })
}

/// `WIDTHxHEIGHT`, both made even, as films need them.
fn size(text: &str) -> Result<(usize, usize), Failure> {
    let read = || -> Option<(usize, usize)> {
        let (width, height) = text.split_once('x')?;
        let (width, height) = (width.parse().ok()?, height.parse().ok()?);
        ((400..=8000).contains(&width) && (300..=6000).contains(&height)).then_some((width, height))
    };
    let (width, height) = read().ok_or_else(|| {
        Failure::wrong(format!(
            "--size: `{text}` is no size; tell width and height, as `1200x900`, from 400x300 to 8000x6000"
        ))
    })?;
    Ok((width & !1, height & !1))
}

fn view(text: &str) -> Result<View, Failure> {
    if let Some((_, azimuth, elevation)) = VIEWS.iter().find(|(name, ..)| *name == text) {
        return Ok(View {
            azimuth: *azimuth,
            elevation: *elevation,
        });
    }
    let read = || -> Option<View> {
        let (azimuth, elevation) = text.split_once(',')?;
        let (azimuth, elevation): (f64, f64) = (azimuth.trim().parse().ok()?, elevation.trim().parse().ok()?);
        ((-720.0..=720.0).contains(&azimuth) && (-90.0..=90.0).contains(&elevation))
            .then_some(View { azimuth, elevation })
    };
    read().ok_or_else(|| {
        let names = VIEWS.map(|(name, ..)| name).join(", ");
        Failure::wrong(format!(
            "--view: `{text}` is no view; tell one of {names}, or degrees about z and above the horizon, as `-62,17`"
        ))
    })
}

fn cuts(arguments: &RenderArguments) -> Result<Vec<Cut>, Failure> {
    let read = |text: &String| {
        text.parse::<Cut>()
            .map_err(|error| Failure::wrong(format!("--clip: {error}")))
    };
    arguments.clip.iter().map(read).collect()
}
