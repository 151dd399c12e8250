use super::*;

type Triple = (f64, f64, f64);

fn kernels(width: f64) -> [Kernel; 2] {
    let gaussian = KernelShape::Gaussian { cut: 5.0 };
    [(gaussian, 0.5 * width), (KernelShape::Lucy, width)].map(|(shape, width)| Kernel { shape, width })
}

/// Grains that fly along straight lines: places and velocities.
fn flight(time: f64) -> Spread {
    let starts = [(0.3, 0.5, -0.4), (-0.2, 0.1, 0.7), (0.6, -0.3, 0.2), (-0.5, -0.4, -0.1)];
    let speeds = [(0.1, -0.7, 0.3), (0.4, 0.2, -0.5), (-0.6, 0.3, 0.1), (0.2, 0.5, 0.8)];
    let point = |(k, (start, speed)): (usize, (&Triple, &Triple))| {
        let velocity = DVec3::from(*speed);
        Point {
            place: DVec3::from(*start) + velocity * time,
            load: Load::Grain {
                mass: 1.0 + k as f64,
                solid: 0.1,
                contacts: 2.0,
                velocity,
            },
        }
    };
    Spread {
        points: starts.iter().zip(&speeds).enumerate().map(point).collect(),
        ..Spread::default()
    }
}

fn fields(spread: &Spread, kernel: Kernel, cells: [usize; 3]) -> (Grid, Vec<CellValues>) {
    let grid = Grid {
        lower: DVec3::splat(-2.0),
        upper: DVec3::splat(2.0),
        cells,
    };
    let mut sums = vec![[0.0; SUMS]; grid.len()];
    grid.spread(spread, &kernel.in_dimensions(grid.dimensions()), &mut sums);
    (grid, sums.iter().map(CellValues::of).collect())
}

fn total(grid: &Grid, cells: &[CellValues], value: impl Fn(&CellValues) -> f64) -> f64 {
    let size = grid.cell_size();
    cells.iter().map(value).sum::<f64>() * size.x * size.y * size.z
}

#[test]
fn the_integral_of_density_and_momentum_is_all_mass_and_momentum() {
    let spread = flight(0.0);
    let momentum: DVec3 = (spread.points.iter())
        .map(|p| match p.load {
            Load::Grain { mass, velocity, .. } => velocity * mass,
            Load::Force(_) => DVec3::ZERO,
        })
        .sum();
    for kernel in kernels(0.5) {
        for (cells, allowed) in [
            ([1, 1, 1], 1e-14),
            ([200, 1, 1], 1e-5),
            ([1, 40, 40], 1e-3),
            ([40, 40, 40], 1e-3),
        ] {
            let (grid, cells) = fields(&spread, kernel, cells);
            let mass = total(&grid, &cells, |c| c.density);
            assert!((mass - 10.0).abs() < 10.0 * allowed, "{kernel:?} {mass}");
            let count = total(&grid, &cells, |c| c.number_density);
            assert!((count - 4.0).abs() < 4.0 * allowed);
            let along = total(&grid, &cells, |c| c.momentum.z);
            assert!((along - momentum.z).abs() < 10.0 * allowed, "{along}");
        }
    }
}

#[test]
fn density_changes_as_momentum_flows() {
    for kernel in kernels(0.6) {
        // midpoints in time and across a cell: both errors fall with the square of the step
        let (time, cells) = (1e-4, 400);
        let density = |time: f64| fields(&flight(time), kernel, [1, cells, 1]).1;
        let (before, now, after) = (density(-time), density(0.0), density(time));
        let step = 4.0 / cells as f64;
        let largest = now.iter().map(|c| c.momentum.y.abs()).fold(0.0, f64::max);
        for k in 1..cells - 1 {
            let change = (after[k].density - before[k].density) / (2.0 * time);
            let flow = (now[k + 1].momentum.y - now[k - 1].momentum.y) / (2.0 * step);
            assert!(
                (change + flow).abs() < 2e-3 * largest / kernel.width,
                "{kernel:?} {k}: {change} {flow}"
            );
        }
    }
}

#[test]
fn the_integral_of_stress_is_the_sum_of_force_times_branch() {
    let branches = [
        ((0.1, 0.2, 0.3), (0.3, -0.2, 0.25), (2.0, 1.0, -3.0)),
        ((-0.6, 0.3, 0.2), (0.0, 0.0, 0.5), (0.3, 4.0, 1.0)),
        ((0.4, -0.5, -0.6), (-0.4, 0.1, 0.0), (-1.0, 0.5, 2.0)),
    ];
    let branch = |(from, branch, force): &(Triple, Triple, Triple)| Branch {
        from: DVec3::from(*from),
        branch: DVec3::from(*branch),
        force: DVec3::from(*force),
    };
    let spread = Spread {
        branches: branches.iter().map(branch).collect(),
        ..Spread::default()
    };
    let sum = |row: usize, column: usize| {
        spread
            .branches
            .iter()
            .map(|b| b.force[row] * b.branch[column])
            .sum::<f64>()
    };
    for kernel in kernels(0.5) {
        // a profile of Lucy's polynomial on fine cells is summed to 1e-10: its third derivative jumps, no lower one does
        for (cells, allowed) in [
            ([1, 1, 1], 1e-14),
            (
                [1, 1, 4000],
                if kernel.shape == KernelShape::Lucy { 1e-10 } else { 1e-6 },
            ),
            (
                [4000, 1, 1],
                if kernel.shape == KernelShape::Lucy { 1e-10 } else { 1e-6 },
            ),
            ([40, 40, 40], 1e-3),
        ] {
            let (grid, told) = fields(&spread, kernel, cells);
            for row in 0..3 {
                for column in 0..3 {
                    let whole = total(&grid, &told, |c| c.contact_stress[3 * row + column]);
                    let off = (whole - sum(row, column)).abs();
                    assert!(off < 10.0 * allowed, "{kernel:?} {cells:?} {row}{column}: {off:e}");
                }
            }
        }
    }
}

#[test]
fn stress_pushes_where_the_branch_ends() {
    // div stress = sum F (W at the grain's end - W at the other): the force density of the contact
    let force = DVec3::new(1.0, -2.0, 0.5);
    let (from, branch) = (DVec3::new(0.1, -0.2, -0.3), DVec3::new(0.2, 0.1, 0.6));
    let spread = Spread {
        branches: vec![Branch { from, branch, force }],
        ..Spread::default()
    };
    for kernel in kernels(0.5) {
        let cells = 2000;
        let (grid, told) = fields(&spread, kernel, [1, 1, cells]);
        let line = kernel.in_dimensions(1);
        let step = grid.cell_size().z;
        for k in 1..cells - 1 {
            let z = -2.0 + (k as f64 + 0.5) * step;
            let change = (told[k + 1].contact_stress[2] - told[k - 1].contact_stress[2]) / (2.0 * step);
            let at = |place: f64| line.at((z - place) * (z - place));
            let expected = -force.x * (at(from.z + branch.z) - at(from.z)) / 16.0;
            assert!((change - expected).abs() < 2e-3, "{k}: {change} {expected}");
        }
    }
}

#[test]
fn images_are_seen_across_periodic_sides_and_oblique_ones_slide() {
    let kernel = Kernel {
        shape: KernelShape::Lucy,
        width: 0.5,
    };
    let mut spread = flight(0.0);
    let size = DVec3::splat(4.0);
    let periods = |oblique: f64| Periods {
        edges: [0, 1, 2].map(|k| Some(DVec3::AXES[k] * size[k] + DVec3::X * if k == 2 { oblique } else { 0.0 })),
        velocities: [DVec3::ZERO, DVec3::ZERO, DVec3::X * 3.0],
    };
    spread.periods = periods(0.0);
    let (_, inside) = fields(&spread, kernel, [40, 40, 1]);
    for point in &mut spread.points {
        point.place += DVec3::new(1.9, -1.9, 0.0);
    }
    let (_, moved) = fields(&spread, kernel, [40, 40, 1]);
    // the same field, 19 cells farther
    for (k, cell) in inside.iter().enumerate() {
        let to = (k / 40 + 40 - 19) % 40 * 40 + (k % 40 + 19) % 40;
        assert!((cell.density - moved[to].density).abs() < 1e-12);
    }
    // a grain at the upper side, whose image below is 1 m to the left of it and 3 m/s slower
    spread.points.truncate(1);
    spread.points[0].place = DVec3::new(0.05, 0.05, 1.95);
    spread.periods = periods(1.0);
    let (_, slid) = fields(&spread, kernel, [40, 40, 40]);
    let at = |x: usize, y: usize, z: usize| slid[(z * 40 + y) * 40 + x];
    assert!(at(20, 20, 39).density > 0.0 && at(10, 20, 0).density > 0.0 && at(20, 20, 0).density == 0.0);
    assert!((at(20, 20, 39).velocity.x - at(10, 20, 0).velocity.x - 3.0).abs() < 1e-12);
}

#[test]
fn averaged_directions_take_what_lies_between_their_sides() {
    let spread = Spread {
        points: vec![Point {
            place: DVec3::new(0.0, 0.0, 1.0),
            load: Load::Grain {
                mass: 2.0,
                solid: 1.0,
                contacts: 0.0,
                velocity: DVec3::X,
            },
        }],
        branches: vec![Branch {
            from: DVec3::new(0.0, 0.0, 0.5),
            branch: DVec3::Z,
            force: DVec3::Z,
        }],
        ..Spread::default()
    };
    let kernel = kernels(0.3)[1];
    let mut below = 0.0;
    for (lower, upper, mass, share) in [(-2.0, 1.0, 0.0, 0.5), (1.0, 2.0, 2.0, 0.5), (0.75, 1.25, 2.0, 0.5)] {
        let grid = Grid {
            lower: DVec3::new(-2.0, -2.0, lower),
            upper: DVec3::new(2.0, 2.0, upper),
            cells: [400, 1, 1],
        };
        let mut sums = vec![[0.0; SUMS]; grid.len()];
        grid.spread(&spread, &kernel.in_dimensions(1), &mut sums);
        let cells: Vec<CellValues> = sums.iter().map(CellValues::of).collect();
        assert!((total(&grid, &cells, |c| c.density) - mass).abs() < 1e-6);
        let stress = total(&grid, &cells, |c| c.contact_stress[8]);
        assert!((stress - share).abs() < 1e-6, "{stress}");
        below += stress;
    }
    assert!((below - 1.5).abs() < 1e-6);
}

#[test]
fn a_grid_that_ends_at_walls_has_what_they_do() {
    let traction_at = |x: f64| {
        let grid = Grid {
            lower: DVec3::splat(-2.0),
            upper: DVec3::splat(2.0),
            cells: [1, 1, 1],
        };
        let mut sampling = Sampling {
            grid,
            kernel: kernels(0.5)[1].in_dimensions(grid.dimensions()),
            spread: Spread::default(),
            cells: vec![[0.0; SUMS]],
        };
        let branch = Branch {
            from: DVec3::X * x,
            branch: DVec3::X * (-0.25 * x),
            force: DVec3::X * (-1.5 * x),
        };
        sampling.add_branch(ToldBranch { branch, is_half: true });
        sampling.deposit();
        sampling.cells[0][deposit::TRACTION]
    };
    assert!(traction_at(-2.0) > 0.0 && traction_at(-2.0) == -traction_at(2.0));
}
