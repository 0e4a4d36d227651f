//! Names of the parameters of causes.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use gyradius_base::error::{Error, Result};

use super::unit::UnitName;
use gyradius_base::{named, ordered_as_text, written_as_text};

named! {
    /// What a parameter of a cause is, its unit included.
    ParameterName: "parameter of a cause" {
        /// Error of the gyroscope about the axis of the swing: of its scale, or of its bias.
        AboutTheAxis = "about_the_axis",
        /// Largest reading of the accelerometer that was kept.
        AccMS2 = "acc_m_s2",
        /// Change of the accelerometer's bias along x as it warms up.
        AccWarmXMS2 = "acc_warm_x_m_s2",
        /// The same along y.
        AccWarmYMS2 = "acc_warm_y_m_s2",
        /// The same along z.
        AccWarmZMS2 = "acc_warm_z_m_s2",
        /// Place across the hull at the start.
        AcrossM = "across_m",
        /// Speed across the hull at the start.
        AcrossMS = "across_m_s",
        /// A place along the suspension, or along the hull.
        AlongM = "along_m",
        /// Speed along the hull at the start.
        AlongMS = "along_m_s",
        /// Drag along the hull over that across.
        AlongOverAcross = "along_over_across",
        /// When it happened, in the recording.
        AtS = "at_s",
        /// Turn of the mount's axis in one direction.
        AxisTurn1Rad = "axis_turn_1_rad",
        /// The same in the direction across.
        AxisTurn2Rad = "axis_turn_2_rad",
        /// Centre of pressure along the hull.
        CentreXM = "centre_x_m",
        /// Centre of pressure in height.
        CentreZM = "centre_z_m",
        /// How much a line lengthens in ten times the time.
        CreepMPerDecade = "creep_m_per_decade",
        /// Share of critical damping.
        DampingRatio = "damping_ratio",
        /// By how much one line is longer than the other.
        DifferenceM = "difference_m",
        /// Direction against the hull: of the wind, or of what moves inside.
        DirectionRad = "direction_rad",
        /// How a wind brakes.
        DragNSM = "drag_n_s_m",
        /// Relative error of the clock.
        Error = "error",
        /// By how much a length is larger than stated.
        ExcessM = "excess_m",
        /// By how much gravity is larger than stated.
        ExcessMS2 = "excess_m_s2",
        /// By how much more than in proportion to the velocity a damping grows: 1 of a quadratic
        /// drag.
        Exponent = "exponent",
        /// Force over strain of a line.
        ForcePerStrainN = "force_per_strain_n",
        /// How far forward the centre of mass lies.
        ForwardM = "forward_m",
        /// Natural frequency.
        FrequencyHz = "frequency_hz",
        /// How much the support gives.
        GiveMPerN = "give_m_per_n",
        /// Angle over which a bearing gives.
        GiveRad = "give_rad",
        /// Its share in phase.
        GustCos = "gust_cos",
        /// Frequency of a tone in the wind.
        GustHz = "gust_hz",
        /// Its share out of phase.
        GustSin = "gust_sin",
        /// Largest reading of the gyroscope that was kept.
        GyroRadS = "gyro_rad_s",
        /// Change of the gyroscope's bias about x as it warms up.
        GyroWarmXRadS = "gyro_warm_x_rad_s",
        /// The same about y.
        GyroWarmYRadS = "gyro_warm_y_rad_s",
        /// The same about z.
        GyroWarmZRadS = "gyro_warm_z_rad_s",
        /// κ: how much softer (harder below 0) the restoring force is at wide angles; 1 makes a spring a
        /// pendulum.
        Hardness = "hardness",
        /// Impulse along x.
        ImpulseXNS = "impulse_x_n_s",
        /// Impulse along y.
        ImpulseYNS = "impulse_y_n_s",
        /// Share of the inertia that comes along, for each radian of amplitude.
        InertiaSharePerRad = "inertia_share_per_rad",
        /// Lever of a mount as a first look sees it, in one direction.
        Lever1 = "lever_1",
        /// Lever that drives the mount, in one direction across its axis.
        Lever1PerM = "lever_1_per_m",
        /// The same in the other direction.
        Lever2 = "lever_2",
        /// The same in the other direction.
        Lever2PerM = "lever_2_per_m",
        /// How long the lines bore the weight before.
        LoadedBeforeS = "loaded_before_s",
        /// Mass of what moves inside.
        MassKg = "mass_kg",
        /// What the line on the negative side of the axis gave.
        NegativeM = "negative_m",
        /// How long it took.
        OverS = "over_s",
        /// Inertia that comes along, for each radian of amplitude in pitch.
        PitchKgM2Rad = "pitch_kg_m2_rad",
        /// Dry friction in pitch.
        PitchNM = "pitch_n_m",
        /// Damping in pitch.
        PitchNMS = "pitch_n_m_s",
        /// Torque of a quadratic drag in pitch.
        PitchTorqueCoefficient = "pitch_torque_coefficient",
        /// Place along the hull of what moves inside.
        PlaceXM = "place_x_m",
        /// The same across.
        PlaceYM = "place_y_m",
        /// The same in height.
        PlaceZM = "place_z_m",
        /// What the line on the positive side of the axis gave.
        PositiveM = "positive_m",
        /// Damping at the fastest rate of the swing.
        RateAtFastestPerS = "rate_at_fastest_per_s",
        /// Torsional rigidity of both lines.
        RigidityNM2 = "rigidity_n_m2",
        /// Dry friction in roll.
        RollNM = "roll_n_m",
        /// Damping in roll.
        RollNMS = "roll_n_m_s",
        /// Torque of a quadratic drag in roll.
        RollTorqueCoefficient = "roll_torque_coefficient",
        /// Relative error of the gyroscope's scale.
        ScaleError = "scale_error",
        /// Shift of the phone along its x.
        ShiftXM = "shift_x_m",
        /// The same along y.
        ShiftYM = "shift_y_m",
        /// The same along z.
        ShiftZM = "shift_z_m",
        /// Speed of the wind.
        SpeedMS = "speed_m_s",
        /// Where it is at the start, times its mass.
        StartKgM = "start_kg_m",
        /// How fast it is at the start, times its mass.
        StartKgMS = "start_kg_m_s",
        /// The same across it.
        StiffnessAcrossNM = "stiffness_across_n_m",
        /// Stiffness of the support along the suspension.
        StiffnessAlongNM = "stiffness_along_n_m",
        /// Stiffness in yaw.
        StiffnessNMRad = "stiffness_n_m_rad",
        /// How much the weight stretches a line.
        StretchUnderLoadM = "stretch_under_load_m",
        /// Force of a quadratic drag along the hull.
        SurgeForceCoefficient = "surge_force_coefficient",
        /// Mass that comes along, for each metre of amplitude along the hull.
        SurgeKgM = "surge_kg_m",
        /// Dry friction along the hull.
        SurgeN = "surge_n",
        /// Damping along the hull.
        SurgeNSM = "surge_n_s_m",
        /// Force of a quadratic drag across the hull.
        SwayForceCoefficient = "sway_force_coefficient",
        /// Mass that comes along in sway.
        SwayKg = "sway_kg",
        /// The same across the hull.
        SwayKgM = "sway_kg_m",
        /// Dry friction across the hull.
        SwayN = "sway_n",
        /// Damping across the hull.
        SwayNSM = "sway_n_s_m",
        /// How far to port the centre of mass lies.
        ToPortM = "to_port_m",
        /// Torque over the square of the rate, and over the inertia.
        TorqueCoefficientPerInertia = "torque_coefficient_per_inertia",
        /// Torque over the inertia.
        TorquePerInertia = "torque_per_inertia",
        /// Angular impulse about x.
        TurnXNMS = "turn_x_n_m_s",
        /// Turn of the phone about its x.
        TurnXRad = "turn_x_rad",
        /// Angular impulse about y.
        TurnYNMS = "turn_y_n_m_s",
        /// The same about y.
        TurnYRad = "turn_y_rad",
        /// Angular impulse about z.
        TurnZNMS = "turn_z_n_m_s",
        /// The same about z.
        TurnZRad = "turn_z_rad",
        /// How much a mount turns, as a first look sees it.
        Turning = "turning",
        /// The rate times the time.
        Vt = "vt",
        /// The square of the rate.
        Vv = "vv",
        /// The third power of the rate.
        Vvv = "vvv",
        /// Time in which the sensors warm up.
        WarmUpS = "warm_up_s",
        /// The position times the time.
        Xt = "xt",
        /// The position times the rate.
        Xv = "xv",
        /// The position times the square of the rate.
        Xvv = "xvv",
        /// Of a learned force: the square of the position.
        Xx = "xx",
        /// The square of the position times the rate.
        Xxv = "xxv",
        /// The third power of the position.
        Xxx = "xxx",
        /// The same in yaw.
        YawKgM2Rad = "yaw_kg_m2_rad",
        /// Dry friction in yaw.
        YawNM = "yaw_n_m",
        /// Damping in yaw.
        YawNMS = "yaw_n_m_s",
        /// Torque of a quadratic drag in yaw.
        YawTorqueCoefficient = "yaw_torque_coefficient",
    }
}

impl ParameterName {
    /// Less the unit that it ends in: `yaw_n_m_s` in `N m s` is `yaw`.
    pub fn without(self, unit: UnitName) -> &'static str {
        let name = self.name();
        let ending = unit.in_names();
        let bare = name.strip_suffix(&ending);
        bare.and_then(|bare| bare.strip_suffix('_')).unwrap_or(name)
    }
}

/// A parameter in a result: of the whole session, or of one of its swings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ParameterId {
    /// What it is.
    pub name: ParameterName,
    /// Which swing's it is, counted from 1, where each has its own.
    pub swing: Option<usize>,
}

impl ParameterId {
    /// That of a place among the swings, or of the session.
    pub(super) fn of(name: ParameterName, place: Option<usize>) -> Self {
        let swing = place.map(|place| place + 1);
        Self { name, swing }
    }
}

impl From<ParameterName> for ParameterId {
    fn from(name: ParameterName) -> Self {
        Self { name, swing: None }
    }
}

impl fmt::Display for ParameterId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.swing {
            None => write!(f, "{}", self.name),
            Some(swing) => write!(f, "{}_{swing}", self.name),
        }
    }
}

impl FromStr for ParameterId {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let whole = text.parse::<ParameterName>();
        let of_swing = || {
            let (name, number) = text.rsplit_once('_')?;
            let swing: usize = number.parse().ok()?;
            let name = name.parse().ok()?;
            let id = Self {
                name,
                swing: Some(swing),
            };
            (swing > 0 && id.to_string() == text).then_some(id)
        };
        match whole {
            Ok(name) => Ok(name.into()),
            Err(error) => of_swing().ok_or(error),
        }
    }
}

ordered_as_text!(ParameterId);
written_as_text!(ParameterId);

impl schemars::JsonSchema for ParameterId {
    fn schema_name() -> Cow<'static, str> {
        "ParameterId".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let names: Vec<&str> = ParameterName::ALL.iter().map(|name| name.name()).collect();
        schemars::json_schema!({
            "type": "string",
            "pattern": format!("^({})(_[1-9][0-9]*)?$", names.join("|")),
        })
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    fn id(text: &str) -> ParameterId {
        text.parse().unwrap()
    }

    #[test]
    fn a_text_is_read_as_it_is_written() {
        for name in ParameterName::ALL {
            assert_eq!(id(name.name()), ParameterId::from(*name));
            let of_swing = ParameterId::of(*name, Some(11));
            assert_eq!(id(&of_swing.to_string()), of_swing);
        }
        assert_eq!(
            id("lever_1_2"),
            ParameterId::of(ParameterName::Lever1, Some(1))
        );
        for unknown in [
            "",
            "x",
            "exponent_",
            "exponent_0",
            "exponent_01",
            "exponent_+1",
        ] {
            let error = unknown.parse::<ParameterId>().unwrap_err().to_string();
            assert!(error.contains("exponent"), "{error}");
        }
    }

    #[test]
    fn results_list_them_as_their_texts() {
        let texts = [
            "exponent_10",
            "exponent_2",
            "start_kg_m_1",
            "start_kg_m_s_1",
        ];
        let map: BTreeMap<ParameterId, u8> = texts.iter().rev().map(|text| (id(text), 0)).collect();
        let json = serde_json::to_string(&map).unwrap();
        assert_eq!(
            json,
            r#"{"exponent_10":0,"exponent_2":0,"start_kg_m_1":0,"start_kg_m_s_1":0}"#
        );
        assert_eq!(
            serde_json::from_str::<BTreeMap<ParameterId, u8>>(&json).unwrap(),
            map
        );
    }

    #[test]
    fn a_unit_is_not_said_twice() {
        let bare = |text: &str, unit| id(text).name.without(unit);
        assert_eq!(bare("yaw_n_m_s", UnitName::NewtonMetreSecond), "yaw");
        assert_eq!(
            bare("excess_m_s2", UnitName::MetrePerSecondSquared),
            "excess"
        );
        assert_eq!(bare("exponent", UnitName::One), "exponent");
    }
}
