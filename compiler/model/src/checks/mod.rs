//! The rules, one a file, named after the fault.
//!
//! A rule looks at the resolved chart and reports; it changes nothing, and knows of no other rule. What another rule has
//! reported already it leaves alone: a label given twice, a grafcet made up for stray steps.

mod action_on_macro_step;
mod activation_link_outside_enclosure;
mod always_true_cycle;
mod arc_crosses_frame;
mod arcs;
mod assigned_and_allocated;
mod assumption_beyond_inputs;
mod bound_under_scan;
mod chart_without_steps;
mod child_never_started;
mod children;
mod commander_not_the_parent;
mod constant_out_of_range;
mod cyclic_continuous_actions;
mod cyclic_hierarchy;
#[cfg(feature = "names")]
mod deceptive_name;
mod each_scan_under_stable;
mod edge_in_continuous_action;
mod edge_in_delay;
mod edge_inside_edge;
mod edge_or_delay_in_claim;
mod edges;
mod enclosing_step_without_enclosure;
mod enclosure_may_be_empty;
mod enclosure_of_two_steps;
mod enclosure_without_activation_link;
mod forced_macro_step;
mod forced_step_outside_grafcet;
mod forces_its_own_grafcet;
mod grafcet_never_activated;
mod initial_enclosure_without_initial_step;
mod initial_step_in_inactive_enclosure;
mod level_event;
mod likeness;
mod macro_step_expansion;
mod negated_edge;
mod negated_off_delay;
mod never_read;
mod never_set;
mod not_an_enclosing_step;
mod nothing_to_retain;
mod off_delay_of_active_step;
mod output_read;
mod restart_of_commander;
mod same_transition_twice;
mod self_loop_with_events;
mod source_transition_on_level;
mod step_named_twice;
mod steps_outside_grafcets;
#[cfg(test)]
pub mod testing;
mod transient_step_with_continuous_action;
mod transition_without_steps;
pub mod truth;

use crate::resolve::Resolved;
use grafc_diagnostics::Diagnostics;

pub use cyclic_hierarchy::set_levels;

/// A rule.
pub type Rule = fn(&Resolved, &mut Diagnostics);

/// The rules that a chart must not break, in order of their codes. Unknown names and steps (E02.., E0301, E0302) are
/// reported where they are resolved, cyclic hierarchies (E0313) by [`set_levels`].
pub const ERRORS: &[Rule] = &[
    nothing_to_retain::check,
    bound_under_scan::check,
    constant_out_of_range::check,
    step_named_twice::check,
    transition_without_steps::check,
    arc_crosses_frame::check,
    macro_step_expansion::check,
    action_on_macro_step::check,
    initial_step_in_inactive_enclosure::check,
    initial_enclosure_without_initial_step::check,
    enclosure_without_activation_link::check,
    enclosure_of_two_steps::check,
    grafcet_never_activated::check,
    forces_its_own_grafcet::check,
    forced_step_outside_grafcet::check,
    forced_macro_step::check,
    steps_outside_grafcets::check,
    not_an_enclosing_step::check,
    activation_link_outside_enclosure::check,
    enclosing_step_without_enclosure::check,
    chart_without_steps::check,
    commander_not_the_parent::check,
    cyclic_continuous_actions::check,
    assigned_and_allocated::check,
    edge_inside_edge::check,
    edge_in_continuous_action::check,
    edge_in_delay::check,
    edge_or_delay_in_claim::check,
    assumption_beyond_inputs::check,
    each_scan_under_stable::check,
];

/// The rules that an author may break knowingly. They expect a chart that breaks none of the others.
pub const WARNINGS: &[Rule] = &[
    output_read::check,
    level_event::check,
    negated_edge::check,
    enclosure_may_be_empty::check,
    self_loop_with_events::check,
    source_transition_on_level::check,
    always_true_cycle::check,
    transient_step_with_continuous_action::check,
    never_read::check,
    never_set::check,
    same_transition_twice::check,
    off_delay_of_active_step::check,
    negated_off_delay::check,
    #[cfg(feature = "names")]
    deceptive_name::check,
    child_never_started::check,
    restart_of_commander::check,
];
