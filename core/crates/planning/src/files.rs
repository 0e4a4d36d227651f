//! A plan as files: the session to fill in, and a rig to rehearse it with.

use toml_edit::{DocumentMut, Item, Table, value};

use super::design::session_of;
use super::predict::{Let, swings};
use super::result::Plan;
use gyradius_base::error::{Error, Result};
use gyradius_recording::write_session;
use gyradius_simulator::RIG_FORMAT;

const TO_FILL_IN: &str = "# Planned, not measured: replace every length and angle by what you read, with your own\n\
                          # uncertainty, and put the recordings beside this file. A swing with `same_as` hangs as that\n\
                          # swing does, but for what stands beside it: what you read anew there, put beside it.\n";
const TO_REHEARSE: &str = "# A rehearsal of the plan: `gyradius simulate` makes the session that the assumed hull would give.\n";

/// The `session.toml` that the plan's swings will fill.
pub fn session_toml(plan: &Plan) -> String {
    TO_FILL_IN.to_owned()
        + &write_session(
            &session_of(&plan.title, &plan.hull, &plan.means, &plan.steps).with_same_hangings(),
        )
}

/// A rig file (`gyradius-rig/1`): the planned session, with the hull as it is assumed for the
/// truth.
///
/// # Errors
/// None that a plan made by [`super::plan`] can cause.
pub fn rig_toml(plan: &Plan) -> Result<String> {
    let text = write_session(
        &session_of(&plan.title, &plan.hull, &plan.means, &plan.steps).with_same_hangings(),
    );
    let mut rig: DocumentMut = text
        .parse()
        .map_err(|e: toml_edit::TomlError| Error::no_result("rig", e.to_string()))?;
    rig["format"] = value(RIG_FORMAT);
    rig.insert("truth", Item::Table(truth(plan)));
    if let Some(tables) = rig.get_mut("swing").and_then(Item::as_array_of_tables_mut) {
        for (table, swing) in tables.iter_mut().zip(swings(&plan.steps)) {
            let start = Let::of(swing, &plan.hull);
            let told = [
                ("yaw_deg", start.yaw_deg),
                ("sway_m", start.sway_m),
                ("surge_m", start.surge_m),
                ("pitch_deg", start.pitch_deg),
                ("roll_deg", start.roll_deg),
                ("duration_s", swing.duration_s),
            ];
            let told: Vec<(&str, f64)> = told.into_iter().filter(|(_, v)| *v != 0.0).collect();
            table.insert("truth", Item::Table(numbers(&told)));
        }
    }
    Ok(TO_REHEARSE.to_owned() + &rig.to_string() + &effects(plan))
}

fn numbers(told: &[(&str, f64)]) -> Table {
    let mut table = Table::new();
    told.iter().for_each(|(name, number)| {
        table.insert(name, value(*number));
    });
    table
}

fn truth(plan: &Plan) -> Table {
    let hull = &plan.hull;
    numbers(&[
        ("k_yaw_m", hull.k_yaw_m.value),
        ("k_pitch_m", hull.k_pitch_m.value),
        ("k_roll_m", hull.k_roll_m.value),
        ("cm_depth_m", hull.cm_depth_m.value),
        ("psi_deg", hull.psi_deg.value),
        ("rate_hz", plan.means.rate_hz),
    ])
}

/// Damping of every motion with the decay time assumed, and the phone's noise.
fn effects(plan: &Plan) -> String {
    let (hull, means) = (&plan.hull, &plan.means);
    let rate = 2.0 * hull.mass_kg / means.decay_s;
    let turn = |k: f64| rate * k * k;
    format!(
        "\n[[effect]]\nid = \"linear_damping\"\nsurge_n_s_m = {rate:?}\nsway_n_s_m = {rate:?}\nroll_n_m_s = {:?}\n\
         pitch_n_m_s = {:?}\nyaw_n_m_s = {:?}\n\n[[effect]]\nid = \"white_noise\"\ngyro_rad_s = {:?}\nacc_m_s2 = {:?}\n",
        turn(hull.k_roll_m.value),
        turn(hull.k_pitch_m.value),
        turn(hull.k_yaw_m.value),
        means.gyro_noise_rad_s,
        means.acc_noise_m_s2,
    )
}
