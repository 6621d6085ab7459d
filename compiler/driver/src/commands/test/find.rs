//! Which charts there are in places, and which tests belong to them.
//!
//! `NAME.test.csv`, `NAME.*.test.csv` and `NAME.scenarios` belong to `NAME.gct` beside them. Of `a.b.test.csv` that is
//! `a.b.gct`, if there is one, else `a.gct`.

use crate::report::Failure;
use grafc::files::Refusal;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use walkdir::WalkDir;

const CHART: &str = ".gct";
const TABLE: &str = ".test.csv";
const SCENARIOS: &str = ".scenarios";

/// A chart, and its tests.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Tested {
    /// Tests as tables.
    pub tables: BTreeSet<PathBuf>,
    /// The file of its scenarios beside it, if there is one.
    pub scenarios: Option<PathBuf>,
    /// Whether the scenarios within the chart count.
    pub with_own: bool,
}

/// What was found.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Found {
    /// By the paths of charts, in order.
    pub charts: BTreeMap<PathBuf, Tested>,
    /// Tests without a chart.
    pub alone: BTreeSet<PathBuf>,
}

/// Looks at places: charts, tests, and folders with all that is below them.
pub fn find(places: &[PathBuf]) -> Result<Found, Failure> {
    let mut found = Found::default();
    for place in places {
        let place = &plain(place);
        if place.is_dir() {
            for file in below(place)? {
                found.add(&plain(&file), true);
            }
        } else if ends_with(place, CHART) {
            // That it is not there, reading it says.
            found.add(place, true);
            let folder = place.parent().filter(|folder| !folder.as_os_str().is_empty());
            for file in beside(folder.unwrap_or(Path::new(".")))? {
                let file = folder.map_or_else(|| PathBuf::from(&file), |folder| folder.join(&file));
                if owner(&file).as_ref() == Some(place) {
                    found.add(&file, false);
                }
            }
        } else if ends_with(place, TABLE) || ends_with(place, SCENARIOS) {
            found.add(place, false);
        } else {
            // What is not there is told in the words of the system.
            std::fs::metadata(place).map_err(|error| Refusal::to_read(place.display().to_string(), error))?;
            return Err(Failure::WrongUse(
                format!("`{}` is no chart, no test and no folder", place.display()),
                format!("name `*{CHART}`, `*{TABLE}`, `*{SCENARIOS}`, or a folder with such files"),
            ));
        }
    }
    Ok(found)
}

impl Found {
    /// All files that are read.
    pub fn files(&self) -> impl Iterator<Item = &PathBuf> {
        let of_charts = self.charts.iter();
        of_charts.flat_map(|(chart, tested)| [chart].into_iter().chain(&tested.tables).chain(&tested.scenarios))
    }

    /// Adds a file; of a chart that was named or found in a folder, its own scenarios count.
    fn add(&mut self, file: &Path, with_own: bool) {
        if ends_with(file, CHART) {
            self.charts.entry(file.to_path_buf()).or_default().with_own |= with_own;
            return;
        }
        let is_table = ends_with(file, TABLE);
        if !is_table && !ends_with(file, SCENARIOS) {
            return;
        }
        match owner(file) {
            None => _ = self.alone.insert(file.to_path_buf()),
            Some(chart) => {
                let tested = self.charts.entry(chart).or_default();
                if is_table {
                    tested.tables.insert(file.to_path_buf());
                } else {
                    tested.scenarios = Some(file.to_path_buf());
                }
            }
        }
    }
}

/// What a chart is called in the names of its tests.
pub fn called(chart: &Path) -> String {
    let name = shown(chart);
    name.strip_suffix(CHART).unwrap_or(&name).to_string()
}

/// What a table is called in its name: what stands behind the name of its chart.
pub fn table_called(chart: &Path, table: &Path) -> String {
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let (chart, table) = (name(chart), name(table));
    let stem = chart.strip_suffix(CHART).unwrap_or(&chart);
    let rest = table.strip_prefix(stem).unwrap_or(&table);
    rest.strip_prefix('.').unwrap_or(rest).to_string()
}

/// A path as messages have it.
pub fn shown(path: &Path) -> String {
    path.display().to_string()
}

/// A path without what says that it begins here.
fn plain(path: &Path) -> PathBuf {
    match path.strip_prefix(".") {
        Ok(rest) if !rest.as_os_str().is_empty() => rest.to_path_buf(),
        Ok(_) | Err(_) => path.to_path_buf(),
    }
}

/// The chart of a test, if it is there.
fn owner(test: &Path) -> Option<PathBuf> {
    let name = test.file_name()?.to_str()?;
    let mut stem = match name.strip_suffix(SCENARIOS) {
        Some(stem) => return Some(test.with_file_name(format!("{stem}{CHART}"))).filter(|chart| chart.is_file()),
        None => name.strip_suffix(TABLE)?,
    };
    loop {
        let chart = test.with_file_name(format!("{stem}{CHART}"));
        if chart.is_file() {
            return Some(chart);
        }
        stem = stem.rsplit_once('.')?.0;
    }
}

fn ends_with(path: &Path, ending: &str) -> bool {
    let name = path.file_name().and_then(|name| name.to_str());
    name.is_some_and(|name| name.len() > ending.len() && name.ends_with(ending))
}

/// The names of the tests in a folder.
fn beside(folder: &Path) -> Result<BTreeSet<String>, Failure> {
    let refused = |error| Failure::from(Refusal::to_read(folder.display().to_string(), error));
    let mut names = BTreeSet::new();
    for entry in std::fs::read_dir(folder).map_err(refused)? {
        let name = entry.map_err(refused)?.file_name();
        let name = name.to_string_lossy();
        if name.ends_with(TABLE) || name.ends_with(SCENARIOS) {
            names.insert(name.into_owned());
        }
    }
    Ok(names)
}

/// All files below a folder but hidden ones, in order. A link that leads around in a circle is not followed.
fn below(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let is_hidden = |name: &std::ffi::OsStr| name.to_string_lossy().starts_with('.');
    let walk = WalkDir::new(folder).follow_links(true).sort_by_file_name().into_iter();
    let mut files = Vec::new();
    for entry in walk.filter_entry(|entry| entry.depth() == 0 || !is_hidden(entry.file_name())) {
        match entry {
            Ok(entry) if entry.file_type().is_file() => files.push(entry.into_path()),
            Ok(_) => {}
            // A link that leads back, or nowhere.
            Err(error) if error.loop_ancestor().is_some() => {}
            Err(error) if error.path().is_some_and(Path::is_symlink) => {}
            Err(error) => {
                let path = error.path().unwrap_or(folder).display().to_string();
                let error = error.into_io_error().unwrap_or_else(|| std::io::ErrorKind::Other.into());
                return Err(Refusal::to_read(path, error).into());
            }
        }
    }
    Ok(files)
}
