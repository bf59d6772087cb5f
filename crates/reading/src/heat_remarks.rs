//! Remarks on what a balance of heat takes for granted.

use radiosity_scene::Scene;

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
