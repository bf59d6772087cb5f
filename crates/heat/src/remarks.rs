//! Remarks on a balance of heat: its errors, and what it takes for granted.

use radiosity_audit::{Checked, HeatFault};
use radiosity_scene::Scene;
use radiosity_solve::Outcome;
use radiosity_work::digits::significant;
use radiosity_work::wording::{Wording, option, set, words};

/// Words for luminaires and openings of a scene, whose light has no part in its heat; none where there are none.
pub fn light_without_heat(scene: &Scene) -> Option<String> {
    let luminaires = scene.luminaires.iter().map(|luminaire| &luminaire.name);
    let openings = scene.surfaces.iter().filter(|surface| surface.is_opening()).map(|surface| &surface.name);
    let names: Vec<&String> = luminaires.chain(openings).collect();
    let [first, others @ ..] = &names[..] else { return None };
    let more = if others.is_empty() { String::new() } else { format!(" and {} more", others.len()) };
    Some(format!(
        "the light of '{first}'{more} is left out of the heat: what surfaces take up of it is a heat_flux of theirs"
    ))
}

/// Words for surfaces whose level nothing sets, by what they are called; none where there are none.
pub fn without_level(called: &[String]) -> Option<String> {
    let [first, others @ ..] = called else { return None };
    let who = match others {
        [] => first.clone(),
        [second] => format!("{first} and {second}"),
        _ => format!("{first} and {} more", others.len()),
    };
    Some(format!(
        "nothing sets the temperature of {who}: all are adiabatic and, as far as the transfers tell, exchange heat with \
         one another alone; none is told, and no flow depends on it"
    ))
}

/// Words for surfaces of one side whose backs heat reaches, and are adiabatic for want of another condition; none
/// where there are none.
pub fn adiabatic_backs(names: &[&str]) -> Option<String> {
    let [first, others @ ..] = names else { return None };
    let who = match others {
        [] => format!("the back of '{first}', which is"),
        [second] => format!("the backs of '{first}' and '{second}', which are"),
        _ => format!("the backs of '{first}' and {} more, which are", others.len()),
    };
    Some(format!("heat reaches {who} adiabatic: back = \"front\" or a temperature says otherwise"))
}

/// Words for the part that errors of heat leave out where elements of an `outcome` were not cut once more.
pub fn no_error_of_cut(outcome: &Outcome) -> Wording {
    let allow = words(
        "the errors are those of the transfers alone: there is no memory or no time to cut elements once more, which tells what \
         even fluxes miss; allow more with ",
    ) + option("memory");
    match outcome.sampling {
        Some(_) => allow + ", or take more " + option("rays"),
        None => allow + ", or take a lower " + option("order"),
    }
}

/// Words for an order that was asked for and does nothing, as rays carried the transfers of an `outcome`; none
/// elsewhere.
pub fn idle_order(outcome: &Outcome, asked: Option<usize>) -> Option<Wording> {
    let order = asked.filter(|order| *order > 0 && outcome.sampling.is_some())?;
    Some(
        set("order", order)
            + " does nothing: rays carry the pairs, between elements of even flux; take "
            + set("transport", "exact")
            + ", or leave it out",
    )
}

/// Words for rays that carried the transfers of a balance, why they did, and what they leave; none where rules carried
/// them.
pub fn carried_by_rays(outcome: &Outcome) -> Option<String> {
    let sampling = outcome.sampling.as_ref()?;
    let left = match sampling.error {
        Some(error) => format!("{} % of the irradiance", significant(100.0 * error, 2)),
        None => "an error that too few rays do not tell".to_owned(),
    };
    Some(format!(
        "carried by {} rays ({}) between elements of even flux, {} pairs by rules: they leave {left}",
        sampling.rays, outcome.choice.why, sampling.exact_pairs
    ))
}

/// Words for heat of an `outcome` that a referee finds to be off by more than its errors tell.
pub fn heat_underestimated(checked: &Checked, outcome: &Outcome) -> Option<Wording> {
    let cure = || match outcome.sampling {
        Some(_) => words("take more ") + option("rays") + ", or " + set("transport", "exact"),
        None => words("take a higher ") + option("order") + ", or more elements by " + option("subdivide"),
    };
    let own = significant(100.0 * checked.own_error, 2);
    let told = |finding: &str| {
        words(format!(
            "the balance by itself tells an error of {own} %, and path tracing finds more: {finding}; "
        )) + cure()
    };
    checked.finding().map(told)
}

/// Words for heat that a referee cannot read.
pub fn heat_unchecked(fault: &HeatFault) -> String {
    format!("not checked by path tracing: {fault}")
}

/// Words for the correction of transfers of a closed scene whose row sums missed 1 by `moved` at the most.
pub fn corrected(moved: f64) -> String {
    format!(
        "row sums of view factors were within {moved:.1e} of 1, and transfers were corrected to make them 1"
    )
}
