//! Which chart becomes what, and where that goes. All of it is found before a chart is read, so that a call that makes no
//! sense writes nothing.

use super::job::Job;
use super::{Arguments, Stage};
use crate::choices;
use crate::commands::refuse_second_standard_input;
use crate::report::Failure;
use crate::stream::Stream;
use clap::ValueEnum;
use grafc::Product;
use grafc::files::{FileIdentity, identity};
use grafc_backends::{About, Target};
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

/// What all charts are made into.
enum Asked<'a> {
    Target(&'static About),
    Stage(Stage),
    Pass(&'a str),
}

/// A job for each chart, in the order of the command line.
pub fn jobs(args: &Arguments) -> Result<Vec<Job<'_>>, Failure> {
    refuse_second_standard_input(&args.charts)?;
    refuse_one_place(args)?;
    let asked = asked(args)?;
    refuse_unmapped(args, &asked)?;
    if args.watch && args.output.as_ref().is_none_or(|output| *output == Stream::Standard) {
        let what = "`--watch` has no file to write to".to_string();
        return Err(Failure::WrongUse(what, "add `-o FILE` or `-o DIR/`".to_string()));
    }
    let mut jobs = Vec::new();
    for chart in &args.charts {
        let mut product = product(args, &asked)?;
        let mut folders = Vec::new();
        let mut place = |stream: Option<&Stream>, ending: &str| match stream {
            Some(Stream::File(path)) if Stream::is_folder(path) => {
                folders.push(path.clone());
                in_folder(path, chart, ending).map(Some)
            }
            other => Ok(other.cloned()),
        };
        let output = place(args.output.as_ref(), &asked.ending(&product))?.unwrap_or(Stream::Standard);
        let map = place(args.map.as_ref(), "map.json")?;
        let beside = beside(&product, &output);
        if let (Product::Code(target) | Product::Mapped(target), Some(beside)) = (&mut product, &beside) {
            target.set_beside(&beside.file_name());
        }
        jobs.push(Job { chart, product, output, beside, map, folders });
    }
    refuse_collisions(&jobs)?;
    Ok(jobs)
}

/// The file beside the output, if the target writes two and the output is a file.
fn beside(product: &Product, output: &Stream) -> Option<Stream> {
    let (Product::Code(target) | Product::Mapped(target), Stream::File(path)) = (product, output) else { return None };
    let ending = target.ending_beside(&path.extension().unwrap_or_default().to_string_lossy())?;
    Some(Stream::File(path.with_extension(ending)))
}

/// Several charts, and one file for what is made of them.
fn refuse_one_place(args: &Arguments) -> Result<(), Failure> {
    let is_folder = |stream: &Stream| matches!(stream, Stream::File(path) if Stream::is_folder(path));
    let [first, second, ..] = args.charts.as_slice() else { return Ok(()) };
    let refuse = |option: &str, to: &str| {
        let (first, second) = (first.input_name(), second.input_name());
        let what = format!("{} charts, `{first}`, `{second}`…, and {to}", args.charts.len());
        let what = if args.charts.len() == 2 { what.replace("`…, and", "`, and") } else { what };
        Err(Failure::WrongUse(what, format!("name a folder with `{option} DIR/`, or compile them one by one")))
    };
    match &args.output {
        None => refuse("-o", "no folder for what is made of them"),
        Some(output) if !is_folder(output) => refuse("-o", &format!("one place, `{}`", output.output_name())),
        Some(_) => match &args.map {
            Some(map) if !is_folder(map) => refuse("--map", &format!("one map, `{}`", map.output_name())),
            Some(_) | None => Ok(()),
        },
    }
}

/// A file in a folder, named after its chart.
fn in_folder(folder: &Path, chart: &Stream, ending: &str) -> Result<Stream, Failure> {
    match chart {
        Stream::File(path) => {
            let mut name = path.file_stem().unwrap_or(path.as_os_str()).to_os_string();
            name.push(".");
            name.push(ending);
            Ok(Stream::File(folder.join(name)))
        }
        Stream::Standard => Err(Failure::WrongUse(
            format!("standard input has no name for a file in `{}`", folder.display()),
            "name a file".to_string(),
        )),
    }
}

/// What is asked for, by an option or by the ending of the output.
fn asked(args: &Arguments) -> Result<Asked<'_>, Failure> {
    if let Some(pass) = &args.dump_after {
        return Ok(Asked::Pass(pass));
    }
    if let Some(stage) = args.emit {
        return Ok(Asked::Stage(stage));
    }
    let given = args.target.as_ref().and_then(|name| Target::ALL.iter().find(|about| about.name == *name));
    match given {
        Some(about) => Ok(Asked::Target(about)),
        None => by_ending(args).map(Asked::Target),
    }
}

fn by_ending(args: &Arguments) -> Result<&'static About, Failure> {
    let output = args.output.as_ref();
    let ending = match output {
        Some(Stream::File(path)) if !Stream::is_folder(path) => path.extension().map(|e| e.to_string_lossy()),
        Some(Stream::File(_) | Stream::Standard) | None => None,
    };
    let Some(ending) = ending else {
        let chart = args.charts.first().map_or(String::new(), Stream::input_name);
        let what = format!("nothing says what to make of `{chart}`");
        let help = "add `--target st` or another target, see `grafc --help`; `-o FILE.st` says it, too; \
                    to look for faults alone there is `grafc check`";
        return Err(Failure::WrongUse(what, help.to_string()));
    };
    let mut writers = Target::ALL.iter().filter(|about| about.has_ending(&ending));
    match (writers.next(), writers.next()) {
        (Some(about), None) => Ok(about),
        (Some(first), Some(second)) => {
            let all = [first, second].into_iter().chain(writers);
            let what =
                format!("files that end with `.{ending}` are written by {}", choices::sentence(all, "--target "));
            Err(Failure::WrongUse(what, "say which of them is meant".to_string()))
        }
        (None, _) => {
            let what = format!("no target is known by the ending `.{ending}`");
            Err(Failure::WrongUse(what, format!("add `--target`, or take one of {}", choices::endings())))
        }
    }
}

impl Asked<'_> {
    /// What the name of a file with it ends with, without the dot.
    fn ending(&self, product: &Product) -> String {
        match self {
            Asked::Target(about) => match product {
                Product::Code(target) | Product::Mapped(target) => target.extension().to_string(),
                Product::Tree
                | Product::Chart
                | Product::NetAfter(_)
                | Product::Net
                | Product::Equations
                | Product::Program => about.extension.to_string(),
            },
            Asked::Stage(stage) => {
                stage.to_possible_value().map_or(String::new(), |value| value.get_name().to_string())
            }
            Asked::Pass(_) => "net".to_string(),
        }
    }
}

fn product(args: &Arguments, asked: &Asked) -> Result<Product, Failure> {
    Ok(match asked {
        Asked::Pass(pass) => Product::NetAfter((*pass).to_string()),
        Asked::Stage(Stage::Ast) => Product::Tree,
        Asked::Stage(Stage::Model) => Product::Chart,
        Asked::Stage(Stage::Net) => Product::Net,
        Asked::Stage(Stage::Logic) => Product::Equations,
        Asked::Stage(Stage::Scan) => Product::Program,
        Asked::Target(about) => {
            let target = args.choices.target(about)?;
            if args.map.is_some() { Product::Mapped(target) } else { Product::Code(target) }
        }
    })
}

/// A map that nobody can write.
fn refuse_unmapped(args: &Arguments, asked: &Asked) -> Result<(), Failure> {
    match asked {
        Asked::Target(about) if args.map.is_some() && !about.mapped => {
            let mapped = Target::ALL.iter().filter(|about| about.mapped);
            let what = format!("`--map` is an option of {}", choices::sentence(mapped, "--target "));
            Err(Failure::WrongUse(what, "leave it out".to_string()))
        }
        Asked::Target(_) | Asked::Stage(_) | Asked::Pass(_) => Ok(()),
    }
}

/// What would take the place of something else: of a chart, or of what another chart is made into.
fn refuse_collisions(jobs: &[Job]) -> Result<(), Failure> {
    let file = |stream: &Stream| match stream {
        Stream::File(path) => identity(path),
        Stream::Standard => None,
    };
    let charts: HashSet<FileIdentity> = jobs.iter().filter_map(|job| file(job.chart)).collect();
    let mut taken: HashMap<PathBuf, &Job> = HashMap::new();
    for job in jobs {
        if job.beside.as_ref().is_some_and(|beside| beside.is_same_stream(&job.output)) {
            let what =
                format!("the code and the file beside it would both be written to `{}`", job.output.output_name());
            return Err(Failure::WrongUse(what, "name the file of the code with `-o`".to_string()));
        }
        if let Some(map) = &job.map
            && (map.is_same_stream(&job.output) || job.beside.as_ref().is_some_and(|beside| map.is_same_stream(beside)))
        {
            let what = "the map and the code would be written to one place".to_string();
            return Err(Failure::WrongUse(what, "choose another file with `--map` or `-o`".to_string()));
        }
        let places = [
            (Some(&job.output), "output", "-o"),
            (job.beside.as_ref(), "file beside the output", "-o"),
            (job.map.as_ref(), "map", "--map"),
        ];
        for (stream, what, option) in places {
            let Some(Stream::File(path)) = stream else { continue };
            if identity(path).is_some_and(|identity| charts.contains(&identity)) {
                let what = format!("the {what} would overwrite `{}`", path.display());
                return Err(Failure::WrongUse(what, format!("choose another file with `{option}`")));
            }
            // Where names that differ by case are one, one run must not be another than elsewhere.
            let name = PathBuf::from(path.to_string_lossy().to_lowercase());
            if let Some(other) = taken.insert(name, job)
                && !std::ptr::eq(other, job)
            {
                let (one, two) = (other.chart.input_name(), job.chart.input_name());
                let what = format!("`{one}` and `{two}` would both be written to `{}`", path.display());
                return Err(Failure::WrongUse(what, "compile them into different folders".to_string()));
            }
        }
    }
    Ok(())
}
