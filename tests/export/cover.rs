//! All exact covers with colors and multiplicities, of a problem in Knuth's format: the item with
//! the fewest options left, one of them taken, then not taken.

use std::collections::HashMap;

/// An item of an option, with its color.
type Entry = (usize, Option<char>);

#[derive(Clone)]
enum Item {
    /// To be taken so often.
    Primary(u32, u32),
    /// Open, or with a color, or taken.
    Secondary(Option<Option<char>>),
}

/// The number of solutions.
pub(crate) fn covers(text: &str) -> u64 {
    let mut lines = text.lines().filter(|line| !line.starts_with('|'));
    let (primary, secondary) = lines.next().unwrap().split_once(" | ").unwrap_or_default();
    let mut items = Vec::new();
    let mut names = HashMap::new();
    for item in primary.split(' ') {
        let (bounds, name) = item.rsplit_once('|').unwrap_or(("1", item));
        let (low, high) = bounds.split_once(':').unwrap_or((bounds, bounds));
        assert!(names.insert(name, items.len()).is_none() && name.len() <= 8, "{name}");
        items.push(Item::Primary(low.parse().unwrap(), high.parse().unwrap()));
    }
    for name in secondary.split(' ') {
        assert!(names.insert(name, items.len()).is_none() && name.len() <= 8, "{name}");
        items.push(Item::Secondary(None));
    }
    let entry = |word: &str| match word.split_once(':') {
        Some((name, color)) => (names[name], Some(color.parse().unwrap())),
        None => (names[word], None),
    };
    let options: Vec<Vec<Entry>> = lines.map(|line| line.split(' ').map(entry).collect()).collect();
    solve(&items, &options.iter().collect::<Vec<_>>())
}

fn fits(items: &[Item], option: &[Entry]) -> bool {
    option.iter().all(|&(item, color)| match &items[item] {
        Item::Primary(_, high) => *high > 0,
        Item::Secondary(shown) => shown.is_none_or(|shown| shown.is_some() && shown == color),
    })
}

fn solve(items: &[Item], options: &[&Vec<Entry>]) -> u64 {
    let mut left = vec![0u32; items.len()];
    options.iter().flat_map(|option| option.iter()).for_each(|entry| left[entry.0] += 1);
    let needs = |&item: &usize| matches!(items[item], Item::Primary(low, _) if low > 0);
    let Some(item) = (0..items.len()).filter(needs).min_by_key(|&item| left[item]) else {
        return 1;
    };
    let Item::Primary(low, _) = items[item] else { return 0 };
    if left[item] < low {
        return 0;
    }
    let of_item = |option: &&Vec<Entry>| option.iter().any(|entry| entry.0 == item);
    let Some(first) = options.iter().position(of_item) else { return 0 };
    let taken = options[first];
    let mut rest = options.to_vec();
    rest.remove(first);
    let mut after = items.to_vec();
    for &(item, color) in taken {
        match &mut after[item] {
            Item::Primary(low, high) => (*low, *high) = (low.saturating_sub(1), *high - 1),
            Item::Secondary(shown) => *shown = Some(color),
        }
    }
    let fitting: Vec<_> = rest.iter().copied().filter(|option| fits(&after, option)).collect();
    solve(&after, &fitting) + solve(items, &rest)
}
