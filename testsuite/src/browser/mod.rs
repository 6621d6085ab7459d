//! A browser that tests drive: Chromium, by playwright-core in node.
//!
//! The scripts beside this file do what a user does on pages, and check what they see. They share one browser.
//!
//! `CHROMIUM` names a browser, otherwise it is `chromium`, `chromium-browser` or `google-chrome` on PATH;
//! `PLAYWRIGHT_CORE` the folder of the package, otherwise it is `target/browser/node_modules/playwright-core`.

use crate::binary::root;
use crate::programs::call;
use crate::tools::{Tool, or_skip};
use serde_json::Value as Json;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Node, the browser and what drives it, found.
pub struct Tools {
    browser: PathBuf,
    driver: PathBuf,
}

impl Tools {
    /// All of them, or what is missing.
    pub fn find() -> Result<Tools, String> {
        let node = Command::new("node").arg("--version").output();
        node.map_err(|fault| format!("node: {fault}"))?;
        let named = std::env::var_os("CHROMIUM").map(PathBuf::from);
        let path = std::env::var_os("PATH").unwrap_or_default();
        let names = ["chromium", "chromium-browser", "google-chrome"];
        let known = names.iter().flat_map(|name| std::env::split_paths(&path).map(move |folder| folder.join(name)));
        let browser = named.into_iter().chain(known).find(|path| path.is_file());
        let browser = browser.ok_or("no chromium on PATH; CHROMIUM names one")?;
        let driver = std::env::var_os("PLAYWRIGHT_CORE")
            .map_or_else(|| root().join("target/browser/node_modules/playwright-core"), PathBuf::from);
        if !driver.join("index.mjs").is_file() {
            return Err(format!("no playwright-core in {}; PLAYWRIGHT_CORE names its folder", driver.display()));
        }
        Ok(Tools { browser, driver })
    }

    /// All of them, or nothing and a line that says why the test that wants them does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Browser, Tools::find())
    }

    /// Does the jobs, each an object with the name of a script in `do`, in a folder with the pages; what was printed.
    ///
    /// # Errors
    /// What was not as it should be.
    pub fn play(&self, folder: &Path, jobs: &[Json]) -> Result<String, String> {
        let file = folder.join("jobs.json");
        fs::write(&file, Json::from(jobs).to_string()).map_err(|e| e.to_string())?;
        let script = root().join("testsuite/src/browser/main.mjs");
        let mut node = Command::new("node");
        node.arg(script).arg(&file).env("CHROMIUM", &self.browser).env("PLAYWRIGHT_CORE", &self.driver);
        call(&mut node)
    }
}
