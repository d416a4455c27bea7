//! Variants under the design that they came from.

use std::collections::HashMap;
use std::ffi::OsStr;
use std::path::Path;

/// A file in tree order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Branch {
    /// The place in the list that was given
    pub index: usize,
    /// 0 for those without a parent in the list
    pub depth: usize,
}

/// Brings files, given as (path, parent), in tree order: each followed by its children, otherwise in the order given.
/// A parent is looked for in the folder of its variant first. One whose parent is not there stands at the top, and so does
/// the first one of a circle. Each comes exactly once.
pub fn tree(files: &[(&Path, Option<&str>)]) -> Vec<Branch> {
    let mut near: HashMap<(Option<&Path>, &OsStr), usize> = HashMap::new();
    let mut anywhere: HashMap<&OsStr, usize> = HashMap::new();
    for (index, (path, _)) in files.iter().enumerate() {
        let stem = path.file_stem().unwrap_or_default();
        near.entry((path.parent(), stem)).or_insert(index);
        // of two with the same name in other folders the first one is the parent
        anywhere.entry(stem).or_insert(index);
    }
    let parent = |index: usize| {
        let (path, parent) = files[index];
        let parent = OsStr::new(parent?);
        let found = near.get(&(path.parent(), parent)).or_else(|| anywhere.get(parent));
        found.copied().filter(|found| *found != index)
    };
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); files.len()];
    let mut tops = Vec::new();
    for index in 0..files.len() {
        match parent(index) {
            Some(parent) => children[parent].push(index),
            None => tops.push(index),
        }
    }
    let mut order = Vec::with_capacity(files.len());
    let mut seen = vec![false; files.len()];
    // whatever no top leads to is in a circle, or hangs on one
    for top in tops.into_iter().chain(0..files.len()) {
        let mut open = vec![Branch { index: top, depth: 0 }];
        while let Some(branch) = open.pop() {
            if std::mem::replace(&mut seen[branch.index], true) {
                continue;
            }
            order.push(branch);
            let below = children[branch.index].iter().rev();
            open.extend(below.map(|index| Branch { index: *index, depth: branch.depth + 1 }));
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(files: &[(&str, Option<&str>)]) -> String {
        let line = |branch: Branch| format!("{}{}", "-".repeat(branch.depth), files[branch.index].0);
        let paths: Vec<(&Path, Option<&str>)> = files.iter().map(|(path, parent)| (Path::new(path), *parent)).collect();
        tree(&paths).into_iter().map(line).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn children_follow_their_parent() {
        let files = [("a", Some("c")), ("b", None), ("c", None), ("d", Some("a")), ("e", Some("c")), ("f", Some("b"))];
        assert_eq!(shown(&files), "b -f c -a --d -e");
    }

    #[test]
    fn orphans_stand_at_the_top_and_circles_come_once() {
        assert_eq!(shown(&[("a", Some("gone")), ("b", Some("b"))]), "a b");
        let circle = [("x", Some("a")), ("a", Some("c")), ("b", Some("a")), ("c", Some("b")), ("d", None)];
        assert_eq!(shown(&circle), "d x a -b --c");
        assert_eq!(shown(&[("same", None), ("same", None), ("child", Some("same"))]), "same -child same");
    }

    #[test]
    fn a_parent_in_the_same_folder_comes_before_one_of_the_same_name_elsewhere() {
        let files =
            [("a/base.toml", None), ("a/one.toml", Some("base")), ("b/base.toml", None), ("b/two.toml", Some("base"))];
        assert_eq!(shown(&files), "a/base.toml -a/one.toml b/base.toml -b/two.toml");
        assert_eq!(shown(&[("a/base.toml", None), ("b/two.toml", Some("base"))]), "a/base.toml -b/two.toml");
        assert_eq!(shown(&[("a/v1.2.toml", None), ("a/x.toml", Some("v1.2"))]), "a/v1.2.toml -a/x.toml");
    }

    #[test]
    fn a_long_line_of_descent_is_no_matter() {
        let stems: Vec<String> = (0..100_000).map(|i| i.to_string()).collect();
        let parent = |i: usize| i.checked_sub(1).map(|i| stems[i].as_str());
        let files: Vec<(&Path, Option<&str>)> =
            stems.iter().enumerate().map(|(i, stem)| (Path::new(stem), parent(i))).collect();
        assert_eq!(tree(&files).len(), files.len());
    }
}
