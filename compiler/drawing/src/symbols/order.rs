//! Forcing orders \[33\] to \[37\]: `G12{8, 9, 11}` in a doubled rectangle.

use super::action::Block;
use crate::font::shown;
use crate::picture::Group;
use crate::rich::Token;
use grafc_model::chart::{Order, Situation, Tables};

pub(crate) fn order(chart: &Tables, order: &Order, number: usize) -> Block {
    let grafcet = shown(&chart.grafcets[order.grafcet].name);
    let mut tokens = vec![Token::plain(format!("{grafcet}{{"))];
    match &order.situation {
        Situation::Steps(steps) => {
            for (place, step) in steps.iter().enumerate() {
                let comma = if place + 1 < steps.len() { ", " } else { "" };
                let label = shown(&chart.steps[*step].label);
                tokens.push(Token { may_break: place > 0, ..Token::plain(format!("{label}{comma}")) });
            }
        }
        Situation::Current => tokens.push(Token::plain("*")),
        Situation::Initial => tokens.push(Token::plain("INIT")),
    }
    tokens.push(Token::plain("}"));
    let owner = chart.steps[order.step].label.to_string();
    let group = Group::new("order").of("data-owner", owner);
    let group = group.of("data-forces", chart.grafcets[order.grafcet].name.to_string());
    Block::order(tokens, group.of("data-order", number.to_string()))
}
