//! Colours over a drawing that tell what has happened to its elements. What never has is broken as well, for who sees no
//! colours.

use crate::picture::{Group, Picture};
use std::collections::BTreeMap;

/// What has happened to an element.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Colour {
    /// Nothing.
    Never,
    /// Something, but not all that could.
    Partly,
    /// All.
    Wholly,
}

/// The colours of the elements of a chart; what has none is left as it is.
#[derive(Clone, Debug, Default)]
pub struct Colours {
    /// Of steps and macro-steps, by their labels.
    pub steps: BTreeMap<String, Colour>,
    /// Of transitions, in order of declaration.
    pub transitions: Vec<Colour>,
    /// Of links before transitions, by the label that they lead from and the designation, or `#n`, that they lead to.
    pub before: BTreeMap<(String, String), Colour>,
    /// Of links after transitions, the other way around. A step and a transition may be called alike.
    pub after: BTreeMap<(String, String), Colour>,
    /// Of actions, in the order of the text.
    pub actions: Vec<Colour>,
    /// Of forcing orders, in order of declaration.
    pub orders: Vec<Colour>,
}

const LOOK: &str = "\
.grafc .wholly>.box{fill:#cdeccd}.grafc .partly>.box{fill:#fdeeb5}.grafc .never>.box{fill:#fbd5d0;stroke-dasharray:4 3}\
.grafc .wholly>.bar{fill:#1d7a1d}.grafc .partly>.bar{fill:#b98900}.grafc .never>.bar{fill:#c9281a}\
.grafc .link.wholly>path{stroke:#1d7a1d}.grafc .link.never>path{stroke:#c9281a;stroke-dasharray:4 3}\
@media (prefers-color-scheme:dark){\
.grafc .wholly>.box{fill:#1f4a24}.grafc .partly>.box{fill:#574712}.grafc .never>.box{fill:#5f2420}\
.grafc .wholly>.bar{fill:#5fce64}.grafc .partly>.bar{fill:#e6b93a}.grafc .never>.bar{fill:#ff7b6b}\
.grafc .link.wholly>path{stroke:#5fce64}.grafc .link.never>path{stroke:#ff7b6b}}";

/// Gives a picture of a chart its colours.
pub fn coloured(picture: &mut Picture, colours: &Colours) {
    picture.look = LOOK;
    picture.description.push_str(". Green has happened, yellow in part, red and broken never");
    // Groups are few levels deep whatever the chart.
    picture.groups.iter_mut().for_each(|group| colour(group, colours));
}

fn colour(group: &mut Group, colours: &Colours) {
    let data = |name: &str| group.data.iter().find(|(known, _)| *known == name).map(|(_, value)| value.as_str());
    let place = |name: &str| data(name).and_then(|value| value.parse::<usize>().ok());
    let found = match (data("data-step"), data("data-from"), data("data-to")) {
        (Some(label), _, _) => colours.steps.get(label),
        (None, Some(from), Some(to)) => {
            let is_before = group.class.split(' ').any(|class| class == "before");
            let links = if is_before { &colours.before } else { &colours.after };
            links.get(&(from.to_string(), to.to_string()))
        }
        (None, _, _) => {
            let transition = place("data-number").and_then(|number| colours.transitions.get(number.checked_sub(1)?));
            let action = || place("data-action").and_then(|number| colours.actions.get(number));
            transition.or_else(action).or_else(|| place("data-order").and_then(|number| colours.orders.get(number)))
        }
    };
    let class = found.map(|colour| match colour {
        Colour::Never => " never",
        Colour::Partly => " partly",
        Colour::Wholly => " wholly",
    });
    group.class.push_str(class.unwrap_or_default());
    group.groups.iter_mut().for_each(|inner| colour(inner, colours));
}
