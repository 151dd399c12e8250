//! Walls that get other motions, come or go between two steps.

use super::Simulation;
use crate::walls::{Motions, Pose, Wall, WallError, link};
use glam::DVec3;
use std::collections::BTreeMap;

/// A wall that cannot come because a grain is in its way.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "wall `{wall}` cannot come: grain {grain} at {position} is in its way, by {share:.3} of its radius; move the grains away \
     first, or let the wall come elsewhere"
)]
pub struct WallInTheWay {
    /// Name of the wall.
    pub wall: String,
    /// Id of the grain; the lowest where several are.
    pub grain: u32,
    /// Its place [m].
    pub position: DVec3,
    /// Overlap, or what is missing of the reach of an attraction, as a share of the radius.
    pub share: f64,
}

impl Simulation {
    /// Tells a wall other motions, from where it stands. What its drive does at that moment, as when it catches a freely
    /// moving wall, is booked, and that it moves otherwise in the half step in which the latest load still acts.
    pub fn set_wall_motion(&mut self, wall: usize, motions: Motions) -> Result<(), WallError> {
        self.check_wall(wall)?;
        if let Some(leader) = motions.leader() {
            self.check_wall(leader)?;
            let mut leaders: Vec<Option<usize>> = self.walls.iter().map(Wall::leader).collect();
            leaders[wall] = Some(leader);
            if let Some(between) = link(&leaders, wall) {
                let [follower, leader] = between.map(|w| self.walls[w].name.clone());
                return Err(WallError::Link { follower, leader });
            }
        }
        self.begin_wall_motion(wall, motions)
    }

    /// The same for one of several walls that are told motions together, which fit each other when all are told.
    pub(crate) fn begin_wall_motion(&mut self, wall: usize, motions: Motions) -> Result<(), WallError> {
        let leader = (motions.leader()).and_then(|leader| self.walls.get(leader));
        let leader = leader.map_or(Pose::START, |leader| leader.pose());
        let former = &self.walls[wall];
        let energy_before = former.energy();
        // no drive does what grains do on a wall that moves freely
        let power_before = if former.is_free() { 0.0 } else { former.power() };
        self.walls[wall].set_motion_behind(motions, leader)?;
        self.forget_driver(wall);
        if self.is_started() {
            let now = &self.walls[wall];
            let ahead = 0.5 * self.dt * (now.power() - power_before);
            self.books.drive_walls(now.energy() - energy_before + ahead);
        }
        Ok(())
    }

    pub(super) fn check_wall(&self, index: usize) -> Result<(), WallError> {
        let count = self.walls.len();
        if index < count {
            Ok(())
        } else {
            Err(WallError::NoSuchWall { index, count })
        }
    }

    /// Takes away the walls that are told by `absent`, and puts back the others. What was stored in the contacts of those
    /// that go is booked; one that comes must touch no grain. Either all of that happens or nothing.
    pub fn set_absent(&mut self, absent: impl Fn(usize) -> bool) -> Result<(), WallInTheWay> {
        let comes = |w: usize| !absent(w) && !self.walls[w].is_present();
        let goes = |w: usize| absent(w) && self.walls[w].is_present();
        let coming: Vec<usize> = (0..self.walls.len()).filter(|&w| comes(w)).collect();
        let going: Vec<usize> = (0..self.walls.len()).filter(|&w| goes(w)).collect();
        if coming.is_empty() && going.is_empty() {
            return Ok(());
        }
        self.hear_corrected_places();
        for &wall in &coming {
            self.check_way(wall)?;
        }
        if self.is_started() {
            let stored = self.stored_at_walls(&going);
            self.books.take_wall_away(stored);
        }
        for (walls, is_present) in [(coming, true), (going, false)] {
            for wall in walls {
                self.walls[wall].set_present(is_present);
            }
        }
        if self.is_started() {
            self.find_candidates();
            self.foresee_bulges();
        }
        Ok(())
    }

    /// Looks for a grain that a wall which comes would touch, or attract.
    fn check_way(&mut self, wall: usize) -> Result<(), WallInTheWay> {
        self.walls[wall].set_present(true);
        let in_the_way = self.in_the_way_of(&self.walls[wall]);
        self.walls[wall].set_present(false);
        let found = self.of_all_segments(in_the_way.into_iter().collect());
        match found.into_iter().min_by_key(|(grain, ..)| *grain) {
            None => Ok(()),
            Some((grain, position, share)) => Err(WallInTheWay {
                wall: self.walls[wall].name.clone(),
                grain,
                position,
                share,
            }),
        }
    }

    /// Walls that have moved and stand in fixed grains, by index: the lowest id of these grains, and how many they are, in all processes.
    pub(crate) fn walls_in_fixed_grains(&self) -> BTreeMap<usize, (u32, u64)> {
        let grains = &self.grains;
        let mut mine = Vec::new();
        for (w, wall) in self
            .walls
            .iter()
            .enumerate()
            .filter(|(_, wall)| wall.pose() != Pose::START)
        {
            let meets = |&g: &usize| {
                grains.is_fixed(g) && wall.is_present() && wall.nearest(grains.position[g], grains.radius(g)).is_some()
            };
            mine.extend(self.own_grains().filter(meets).map(|g| (w, grains.id[g])));
        }
        let mut found = BTreeMap::new();
        for (wall, id) in self.of_all_segments(mine) {
            let (first, count) = found.entry(wall).or_insert((id, 0));
            (*first, *count) = (id.min(*first), *count + 1);
        }
        found
    }

    /// The own grain with the lowest id that a wall would touch, its place, and how far it is in the way as a share of its radius.
    fn in_the_way_of(&self, shape: &Wall) -> Option<(u32, DVec3, f64)> {
        let grains = &self.grains;
        let mut first: Option<(u32, DVec3, f64)> = None;
        for g in self.own_grains().filter(|&g| !grains.is_fixed(g)) {
            let (id, place, radius) = (grains.id[g], grains.position[g], grains.radius(g));
            let reach = radius * (1.0 - 1e-9) + self.max_reach;
            if first.is_some_and(|(first, ..)| first < id) {
                continue;
            }
            if let Some(nearest) = shape.nearest(place, reach) {
                first = Some((id, place, (reach - nearest) / radius));
            }
        }
        first
    }
}
