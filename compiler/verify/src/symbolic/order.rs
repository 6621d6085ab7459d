//! An order of variables in which what stands in one formula stands near (the heuristic FORCE): each variable goes, again and
//! again, to the middle of the formulas that it stands in.

/// So often.
const ROUNDS: usize = 60;

/// For each variable its place, from groups of variables that should be near.
pub(crate) fn places(count: usize, groups: &[Vec<usize>]) -> Vec<usize> {
    let mut of: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (group, variables) in groups.iter().enumerate() {
        for v in variables {
            of[*v].push(group);
        }
    }
    let mut places: Vec<usize> = (0..count).collect();
    let mut best = (span(groups, &places), places.clone());
    for _ in 0..ROUNDS {
        let middle: Vec<f64> = groups.iter().map(|group| mean(group.iter().map(|v| places[*v] as f64))).collect();
        let wanted: Vec<f64> = (0..count)
            .map(|v| if of[v].is_empty() { places[v] as f64 } else { mean(of[v].iter().map(|group| middle[*group])) })
            .collect();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|a, b| wanted[*a].total_cmp(&wanted[*b]).then(places[*a].cmp(&places[*b])));
        for (place, v) in order.into_iter().enumerate() {
            places[v] = place;
        }
        let now = span(groups, &places);
        if now < best.0 {
            best = (now, places.clone());
        }
    }
    best.1
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0_u32), |(sum, count), value| (sum + value, count + 1));
    sum / f64::from(count.max(1))
}

/// How far apart the variables of the groups are, in all.
fn span(groups: &[Vec<usize>], places: &[usize]) -> usize {
    let of_group = |group: &Vec<usize>| {
        let least = group.iter().map(|v| places[*v]).min().unwrap_or(0);
        group.iter().map(|v| places[*v]).max().unwrap_or(0) - least
    };
    groups.iter().map(of_group).sum()
}

#[cfg(test)]
mod tests {
    use super::places;

    #[test]
    fn what_belongs_together_comes_together() {
        // Two rings, whose variables were declared in turn.
        let groups = [vec![0, 2], vec![2, 4], vec![4, 0], vec![1, 3], vec![3, 5], vec![5, 1]];
        let found = places(6, &groups);
        let span = |ring: [usize; 3]| {
            ring.map(|v| found[v]).iter().max().unwrap() - ring.map(|v| found[v]).iter().min().unwrap()
        };
        assert_eq!((span([0, 2, 4]), span([1, 3, 5])), (2, 2), "{found:?}");
    }
}
