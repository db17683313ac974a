//! What is to be done with an answer: kept with a checkpoint, so that the search can be taken up
//! again without the options of the command that began it.

use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Where the answer goes, and in which form.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Request {
    /// The file of the result.
    pub output: Option<PathBuf>,
    /// One JSON object on standard output.
    pub json: bool,
    /// The file that cells given beforehand came from, for the record.
    pub pins: Option<String>,
    /// The automorphism as it was asked for, for the record.
    pub automorphism: Option<String>,
    /// Why the program chose to search, if it was its choice.
    #[serde(default)]
    pub why: Option<String>,
}

impl Request {
    /// The words that are kept with a checkpoint. A file is found again from any folder.
    pub fn text(&self) -> String {
        let absolute = |file: &Path| std::path::absolute(file).unwrap_or_else(|_| file.into());
        let output = self.output.as_deref().map(absolute);
        let request = Self { output, ..self.clone() };
        serde_json::to_string(&request).unwrap_or_default()
    }

    /// Reads these words; what is not understood is left out, for it changes no answer.
    pub fn read(text: &str) -> Self {
        serde_json::from_str(text).unwrap_or_default()
    }
}
