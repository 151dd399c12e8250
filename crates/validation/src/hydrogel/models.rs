//! The five models, and what the paper tells of them.

use super::ValidationError;

/// A row of Table I of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Published {
    /// Force on the plate at full compression over the measured one.
    pub rtop: f64,
    /// Root mean square error of the force on the plate [N].
    pub errf: f64,
    /// Root mean square error of the contacts per grain.
    pub errz: f64,
    /// `-log <B>` of the force distributions.
    pub bhat: f64,
    /// Threshold that makes `errz` least [N].
    pub tau: f64,
}

/// A contact model of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    /// Name on the command line and of the folder.
    pub name: &'static str,
    /// Name in the paper.
    pub title: &'static str,
    /// Multi-contact law in the scenario.
    law: &'static str,
    /// Whether its prefactor is the fitted one.
    pub fitted: bool,
    /// What the paper tells of it.
    pub published: Published,
}

const fn published(rtop: f64, errf: f64, errz: f64, bhat: f64, tau: f64) -> Published {
    Published {
        rtop,
        errf,
        errz,
        bhat,
        tau,
    }
}

/// The models in the order of Table I.
pub const MODELS: [Model; 5] = [
    Model {
        name: "independent",
        title: "Independent contacts",
        law: "independent",
        fitted: false,
        published: published(0.43, 3.39, 0.51, 7.21e-2, 2.89e-3),
    },
    Model {
        name: "point-on-sphere",
        title: "Point force on sphere",
        law: "point-on-sphere",
        fitted: false,
        published: published(0.44, 3.23, 0.53, 6.51e-2, 2.93e-3),
    },
    Model {
        name: "sphere-to-sphere",
        title: "Sphere to sphere",
        law: "sphere-to-sphere",
        fitted: false,
        published: published(0.70, 1.82, 0.34, 2.57e-2, 3.35e-3),
    },
    Model {
        name: "half-space",
        title: "Elastic half-space",
        law: "half-space",
        fitted: false,
        published: published(0.80, 1.26, 0.40, 1.90e-2, 3.45e-3),
    },
    Model {
        name: "mc-dem",
        title: "MC-DEM",
        law: "half-space",
        fitted: true,
        published: published(1.00, 0.41, 0.26, 0.98e-2, 4.00e-3),
    },
];

impl Model {
    /// The law as the scenario tells it; `prefactor` is the fitted one.
    pub fn law(&self, prefactor: f64) -> String {
        let law = self.law;
        if self.fitted {
            format!("{{ law = \"{law}\", prefactor = {prefactor:?} }}")
        } else {
            format!("{{ law = \"{law}\" }}")
        }
    }

    /// Name of the folder of its run.
    pub fn folder(&self, prefactor: f64) -> String {
        if self.fitted {
            format!("{}-{prefactor}", self.name)
        } else {
            self.name.to_string()
        }
    }

    /// Its name with the fitted prefactor.
    pub fn label(&self, prefactor: f64) -> String {
        if self.fitted {
            format!("{}, γ = {prefactor}", self.title)
        } else {
            self.title.to_string()
        }
    }

    /// Its place in Table I.
    pub fn place(&self) -> usize {
        MODELS.iter().position(|model| model == self).unwrap_or(0)
    }
}

/// Models by name, in the order of Table I; all when no name is told.
pub fn find_models(names: &[String]) -> Result<Vec<Model>, ValidationError> {
    if let Some(unknown) = names.iter().find(|name| !MODELS.iter().any(|m| m.name == **name)) {
        let shown: String = unknown.chars().take(60).collect();
        return Err(ValidationError::UnknownModel { name: shown });
    }
    let wanted = |model: &&Model| names.is_empty() || names.iter().any(|name| name == model.name);
    Ok(MODELS.iter().filter(wanted).copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn models_are_found_by_name_in_the_order_of_the_paper() {
        let names = |told: &[&str]| {
            let told: Vec<String> = told.iter().map(ToString::to_string).collect();
            find_models(&told).map(|models| models.iter().map(|m| m.name).collect::<Vec<_>>())
        };
        assert_eq!(names(&[]).unwrap().len(), MODELS.len());
        assert_eq!(names(&["mc-dem", "independent"]).unwrap(), ["independent", "mc-dem"]);
        let error = names(&["mcdem"]).unwrap_err().to_string();
        assert!(error.contains("`mcdem`") && error.contains("`mc-dem`"), "{error}");
    }

    #[test]
    fn only_the_fitted_model_has_the_prefactor() {
        assert_eq!(MODELS[3].law(1.2), "{ law = \"half-space\" }");
        assert_eq!(MODELS[4].law(1.2), "{ law = \"half-space\", prefactor = 1.2 }");
        assert_eq!(MODELS[4].law(1.0), "{ law = \"half-space\", prefactor = 1.0 }");
        assert_eq!(
            (MODELS[0].folder(1.2), MODELS[4].folder(1.2)),
            ("independent".to_string(), "mc-dem-1.2".to_string())
        );
    }
}
