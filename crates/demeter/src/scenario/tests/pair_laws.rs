use super::*;
use demeter_physics::contact::LawChoice;
use demeter_physics::parameters::Value as ParameterValue;

#[test]
fn contact_laws_of_a_stage_are_those_of_all_where_it_tells_them() {
    let scenario = read_good("every_stop.toml");
    let told = |stage: usize, a: usize, b: usize| {
        let choice = scenario.contact_in(stage).choice(a, b);
        let number = |law: &LawChoice, key: &str| match law.parameters.get(key) {
            Some(ParameterValue::Number(value)) => Some(*value),
            _ => None,
        };
        let restitution = number(&choice.normal, "restitution").unwrap();
        let friction = choice.tangential.as_ref().and_then(|law| number(law, "friction"));
        (choice.normal.law, restitution, friction)
    };
    let hertz = |restitution, friction| ("hertz-tsuji".to_string(), restitution, Some(friction));
    let linear = |restitution| ("linear".to_string(), restitution, None);
    let (gel, steel) = (0, 1);
    for stage in [0, 1] {
        assert_eq!(told(stage, gel, gel), hertz(0.5, 0.1));
        assert_eq!(told(stage, gel, steel), hertz(0.5, 0.02));
        assert_eq!(told(stage, steel, steel), linear(0.9));
    }
    for stage in [2, 3, scenario.stages.len()] {
        assert_eq!(told(stage, gel, gel), hertz(0.3, 0.3));
        assert_eq!(told(stage, steel, gel), hertz(0.3, 0.0));
        assert_eq!(told(stage, steel, steel), linear(0.6));
    }
    assert_eq!(scenario.contacts().len(), 2);
}

#[test]
fn another_restitution_keeps_its_impact_speed_and_another_way_does_not() {
    let scenario = |pair: &str| {
        let laws = "contact.normal={ law = \"viscoelastic\", restitution = 0.8, impact_speed = \"1 m/s\" }";
        let pair = format!("contact.pair=[{{ between = [\"glass\", \"glass\"], normal = {pair} }}]");
        let normal = parse(settle(), &[laws, &pair])
            .unwrap()
            .contact
            .choice(0, 0)
            .normal
            .parameters;
        normal
            .into_iter()
            .map(|(name, value)| (name, format!("{value:?}")))
            .collect::<Vec<_>>()
    };
    let pairs = |told: &[(&str, f64)]| {
        let value = |value: f64| format!("{:?}", ParameterValue::Number(value));
        told.iter()
            .map(|(name, told)| ((*name).to_string(), value(*told)))
            .collect::<Vec<_>>()
    };
    assert_eq!(
        scenario("{ restitution = 0.5 }"),
        pairs(&[("impact_speed", 1.0), ("restitution", 0.5)])
    );
    let other = "{ restitution = 0.5, impact_speed = \"2 m/s\" }";
    assert_eq!(scenario(other), pairs(&[("impact_speed", 2.0), ("restitution", 0.5)]));
    assert_eq!(
        scenario("{ dissipation_time = \"1e-7 s\" }"),
        pairs(&[("dissipation_time", 1e-7)])
    );
}
