//! A count of dappled tilings in words, for checkpoints: what is counted, and nothing else.

use crate::dappled::{Condition, Direction, Edges, FREE, Field, Limit, Rule};
use anyhow::{Context, anyhow};
use serde_json::{Value, json};

/// What is counted.
#[derive(Debug, Clone)]
pub(super) struct Job {
    /// What tilings keep.
    pub(super) rule: Rule,
    /// Cells given.
    pub(super) given: Option<Field>,
    /// The tile by whose number they are counted.
    pub(super) by: Option<u8>,
}

/// The edges in a word.
pub(super) fn edges_name(edges: Edges) -> &'static str {
    match edges {
        Edges::Free => "free",
        Edges::Cylinder => "cylinder",
        Edges::Torus => "torus",
    }
}

impl Job {
    /// The job as JSON; the same job always in the same bytes.
    pub(super) fn text(&self) -> String {
        let limit = |limit: &Limit| match limit {
            Limit::None => Value::Null,
            Limit::Same(limit) => json!(limit),
            Limit::Map(map) => json!(map),
        };
        let condition = |condition: &Condition| {
            let down = condition.direction == Direction::Vertical;
            json!([condition.set, down, limit(&condition.limit)])
        };
        let rule = &self.rule;
        json!({
            "job": "count of dappled tilings",
            "version": 1,
            "width": rule.width(),
            "height": rule.height(),
            "tiles": rule.tiles(),
            "edges": edges_name(rule.edges()),
            "conditions": rule.conditions().iter().map(condition).collect::<Vec<_>>(),
            "given": self.given.as_ref().map(Field::cells),
            "by": self.by,
        })
        .to_string()
    }

    /// Reads what [`Job::text`] wrote.
    ///
    /// # Errors
    /// Any other text.
    pub(super) fn read(text: &str) -> anyhow::Result<Self> {
        let job: Value = serde_json::from_str(text).context("no job")?;
        let wrong = || anyhow!("not a job that this program goes on with");
        let number = |value: &Value| value.as_u64().map(|number| number as usize).ok_or_else(wrong);
        if job["version"] != 1 {
            return Err(wrong());
        }
        let size = (number(&job["width"])?, number(&job["height"])?);
        let edges = [Edges::Free, Edges::Cylinder, Edges::Torus];
        let edges = edges.into_iter().find(|&edges| job["edges"] == edges_name(edges));
        let limit = |value: &Value| -> anyhow::Result<Limit> {
            Ok(match value {
                Value::Null => Limit::None,
                Value::Array(map) => {
                    let map = map.iter().map(|limit| Ok(number(limit)? as u32));
                    Limit::Map(map.collect::<anyhow::Result<_>>()?)
                }
                limit => Limit::Same(number(limit)? as u32),
            })
        };
        let condition = |value: &Value| -> anyhow::Result<Condition> {
            let down = value[1].as_bool().ok_or_else(wrong)?;
            Ok(Condition {
                set: value[0].as_u64().ok_or_else(wrong)?,
                direction: if down { Direction::Vertical } else { Direction::Horizontal },
                limit: limit(&value[2])?,
            })
        };
        let conditions = job["conditions"].as_array().ok_or_else(wrong)?;
        let conditions = conditions.iter().map(condition).collect::<anyhow::Result<_>>()?;
        let tiles = number(&job["tiles"])?;
        let rule = Rule::new(size, tiles, edges.ok_or_else(wrong)?, conditions)?;
        let cell = |value: &Value| match number(value)? {
            tile if tile < tiles || tile == usize::from(FREE) => Ok(tile as u8),
            _ => Err(wrong()),
        };
        let given = match &job["given"] {
            Value::Array(cells) => {
                let cells = cells.iter().map(cell).collect::<anyhow::Result<_>>()?;
                Some(Field::new(size.0, size.1, cells)?)
            }
            _ => None,
        };
        let by = job["by"].as_u64().map(|tile| tile as u8);
        Ok(Self { rule, given, by })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_is_read_as_it_was_written() {
        let map = Limit::Map(vec![1, 2, 3, u32::MAX]);
        let conditions = vec![
            Condition { set: 3, direction: Direction::Vertical, limit: map },
            Condition { set: 1 << 63, direction: Direction::Horizontal, limit: Limit::Same(2) },
        ];
        let rule = Rule::new((2, 2), 64, Edges::Cylinder, conditions).unwrap();
        let given = Some(Field::new(2, 2, vec![FREE, 1, 63, 0]).unwrap());
        let job = Job { rule, given, by: Some(5) };
        let read = Job::read(&job.text()).unwrap();
        assert_eq!((&read.rule, &read.given, read.by), (&job.rule, &job.given, job.by));
        assert_eq!(read.text(), job.text());
        for text in ["", "{}", "[]", "{\"version\":1}"] {
            assert!(Job::read(text).is_err());
        }
    }
}
