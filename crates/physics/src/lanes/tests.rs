use super::*;

/// Numbers on which operations of different registers might differ.
const AWKWARD: [f64; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.5,
    f64::MIN_POSITIVE,
    3e-310,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    0.1,
    std::f64::consts::PI,
];

/// Bits of everything that lanes can do with two numbers each.
struct Everything<'a>(&'a [f64], &'a [f64]);

impl Kernel for Everything<'_> {
    type Output = Vec<Vec<u64>>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Vec<Vec<u64>> {
        let mut found = vec![Vec::new(); 41];
        for (a, b) in self.0.chunks(L::COUNT).zip(self.1.chunks(L::COUNT)) {
            let (a, b) = (L::load(a), L::load(b));
            let as_number = |mask: L::Mask| L::select(mask, L::splat(1.0), L::splat(2.0));
            let v = L::Vector::new(a, b, a + 1.0);
            let w = L::Vector::new(b, a * 2.0, b - 0.3);
            let of_rows = {
                let rows = [a, b, a - b, a * 3.0];
                let back = L::rows(rows);
                L::columns(back.as_ref().as_flattened(), &std::array::from_fn(|lane| 4 * lane))
            };
            let anywhere = {
                let back = L::rows([b, a, a + b, a * 5.0]);
                let last = L::COUNT - 1;
                L::of_rows(&std::array::from_fn(|lane| &back.as_ref()[lane.min(last)]))
            };
            let fetched = {
                let back = L::rows([a, b, b - a, a + 2.0]);
                let index: Index = std::array::from_fn(|lane| (lane % L::COUNT) as u32);
                let [first, [x, y, z, w]] = L::fetch([back.as_ref(), back.as_ref()], &index);
                let mut put = vec![0.0; 7 * L::COUNT];
                L::put_strided([w, z, y, x], &mut put, 1, 6);
                (first, L::strided(&put, 1, 6))
            };
            let quads = {
                let mut quads = [[0.0; MOST_LANES]; 6];
                for lane in 0..L::COUNT {
                    let (a, b) = (a.as_slice()[lane], b.as_slice()[lane]);
                    let one = L::Quad::load(&[a, b, a, 1.0]);
                    let other = L::Quad::load(&[b, a, -a, -2.0]);
                    let within = one.lies_within(other, L::Quad::all(b));
                    let computed = (one * L::Quad::all(a) + other - one).store();
                    let each = [computed[0], computed[1], one.larger(other).store()[0], computed[2]];
                    for (quad, value) in quads.iter_mut().zip(each) {
                        quad[lane] = value;
                    }
                    quads[4][lane] = f64::from(u8::from(within));
                    quads[5][lane] = one.larger(other).store()[3];
                }
                quads
            };
            let singles = {
                let (mut stored, mut lanes) = ([0.0; MOST_LANES], [[0.0; MOST_LANES]; 2]);
                a.store_singles(&mut stored);
                let loaded = L::load_singles(&stored);
                for (lane, stored) in stored.into_iter().enumerate().take(L::COUNT) {
                    let (a, b) = (a.as_slice()[lane], b.as_slice()[lane]);
                    let [one, other] = [[a, b, -a, 5.0], [b, -b, a, 6.0]].map(|numbers| L::Quad::load(&numbers));
                    let mut put = [0.0; 6];
                    L::Quad::put_singles(one, other, &mut put);
                    let rounded = one.rounded().store();
                    let [one, other] = L::Quad::of_singles(&put).map(L::Quad::store);
                    assert!((0..3).all(|k| rounded[k].total_cmp(&one[k]).is_eq() || rounded[k].is_nan()));
                    assert_eq!(rounded[3], 5.0);
                    assert_eq!([one[3], other[3]], [0.0; 2]);
                    let all = [one[0], one[1], one[2], other[0], other[1], other[2]];
                    let expected = [a, b, -a, b, -b, a].map(|x| f64::from(x as f32));
                    assert!(
                        all.iter()
                            .zip(expected)
                            .all(|(x, y)| x.total_cmp(&y).is_eq() || x.is_nan() && y.is_nan())
                    );
                    assert!(loaded.as_slice()[lane].total_cmp(&f64::from(stored)).is_eq() || stored.is_nan());
                    lanes[0][lane] = f64::from(stored);
                    lanes[1][lane] = one[1] + other[2];
                }
                lanes.map(|all| L::load(&all))
            };
            let results = [
                a + b,
                a - b,
                a * b,
                a / b,
                -a,
                a.sqrt(),
                a.abs(),
                a.max(b),
                a.min(b),
                as_number(a.gt(b)),
                as_number(a.ge(b)),
                as_number(a.lt(b) | !a.gt(b) & b.ge(a)),
                v.inner(w),
                v.outer(w).components()[1],
                v.or(a.gt(b), w).components()[2],
                a.keep(a.gt(b)),
                of_rows[0],
                of_rows[1],
                of_rows[2],
                of_rows[3],
                anywhere[0],
                anywhere[1],
                anywhere[2],
                anywhere[3],
                as_number(L::Mask::of_bits(a.gt(b).bits())),
                fetched.0[0],
                fetched.0[1],
                fetched.0[2],
                fetched.0[3],
                fetched.1[0],
                fetched.1[1],
                fetched.1[2],
                fetched.1[3],
                L::load(&quads[0]),
                L::load(&quads[1]),
                L::load(&quads[2]),
                L::load(&quads[3]),
                L::load(&quads[4]),
                L::load(&quads[5]),
                singles[0],
                singles[1],
            ];
            for (found, result) in found.iter_mut().zip(results) {
                // which of the quiet numbers that are none comes out is not told by IEEE 754
                let bits = |x: f64| if x.is_nan() { u64::MAX } else { x.to_bits() };
                found.extend(result.to_array()[..L::COUNT].iter().map(|&x| bits(x)));
            }
        }
        found
    }
}

#[test]
fn all_instructions_give_the_same_bits() {
    let pairs = || AWKWARD.iter().flat_map(|&a| AWKWARD.iter().map(move |&b| (a, b)));
    let (a, b): (Vec<f64>, Vec<f64>) = pairs().unzip();
    assert_eq!(a.len() % MOST_LANES, 0);
    let portable = run(Instructions::Portable, Everything(&a, &b));
    assert!(portable.iter().all(|results| results.len() == a.len()));
    for instructions in Instructions::available() {
        let name = instructions.name();
        assert_eq!(run(instructions, Everything(&a, &b)), portable, "{name}");
        assert_eq!(run_on_two(instructions, Everything(&a, &b)), portable, "two of {name}");
    }
}

#[test]
fn one_lane_is_plain_arithmetic() {
    for (a, b) in AWKWARD.iter().flat_map(|&a| AWKWARD.iter().map(move |&b| (a, b))) {
        let found = run(Instructions::Portable, Everything(&[a], &[b]));
        let same = |k: usize, expected: f64| {
            let bits = if expected.is_nan() {
                u64::MAX
            } else {
                expected.to_bits()
            };
            assert_eq!(found[k], [bits], "operation {k} on {a} and {b}");
        };
        same(0, a + b);
        same(3, a / b);
        same(5, a.sqrt());
        same(7, if a > b { a } else { b });
        same(8, if a < b { a } else { b });
        same(12, a * b + b * (a * 2.0) + (a + 1.0) * (b - 0.3));
    }
}

/// Two vectors per lane side by side, added to rows and taken away from others.
struct SideBySide<'a>(&'a [f64], &'a [f64]);

impl Kernel for SideBySide<'_> {
    type Output = Vec<[f64; 8]>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Vec<[f64; 8]> {
        let mut found = Vec::new();
        for (a, b) in self.0.chunks(L::COUNT).zip(self.1.chunks(L::COUNT)) {
            let (a, b) = (L::load(a), L::load(b));
            let rows = L::side_by_side(L::Vector::new(a, b, a + b), L::Vector::new(a * b, a - b, b));
            for row in rows.as_ref() {
                let [mut sum, mut difference] = [[0.25; 8]; 2];
                (L::Eight::load(&sum) + *row).store(&mut sum);
                (L::Eight::load(&difference) - *row).store(&mut difference);
                found.extend([sum, difference]);
            }
        }
        found
    }
}

#[test]
fn vectors_lie_side_by_side_with_all_instructions() {
    let a: Vec<f64> = (0..2 * MOST_LANES).map(|k| 0.3 * k as f64 - 1.0).collect();
    let b: Vec<f64> = a.iter().map(|x| 2.0 - x * x).collect();
    let expected: Vec<[f64; 8]> = (a.iter().zip(&b))
        .flat_map(|(a, b)| {
            let row = [*a, *b, a + b, 0.0, a * b, a - b, *b, 0.0];
            [row.map(|x| 0.25 + x), row.map(|x| 0.25 - x)]
        })
        .collect();
    for instructions in Instructions::available() {
        let name = instructions.name();
        assert_eq!(run(instructions, SideBySide(&a, &b)), expected, "{name}");
        assert_eq!(run_on_two(instructions, SideBySide(&a, &b)), expected, "two of {name}");
    }
}

/// Fetches rows of which one is not there.
struct Beyond(Index);

impl Kernel for Beyond {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self) -> f64 {
        let [[x, ..], _] = L::fetch([&[[0.0; 4]; 9], &[[0.0; 4]; 8]], &self.0);
        x.to_array()[0]
    }
}

/// Takes rows of four out of some numbers, and single numbers out of others, of which one is not there.
struct BeyondPlaces<'a>(Places, &'a [f64], &'a [f64]);

impl Kernel for BeyondPlaces<'_> {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self) -> f64 {
        let [x, ..] = L::columns(self.1, &self.0);
        (x + L::gather(self.2, &self.0)).to_array()[0]
    }
}

/// Takes rows of four at a distance, or puts them, where there are so many numbers.
struct BeyondRows {
    numbers: usize,
    puts: bool,
}

impl BeyondRows {
    const START: usize = 2;
    const STRIDE: usize = 5;

    /// Numbers that are enough for so many lanes.
    fn enough(lanes: usize) -> usize {
        Self::START + Self::STRIDE * (lanes - 1) + 4
    }
}

impl Kernel for BeyondRows {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let mut numbers = vec![0.0; self.numbers];
        if self.puts {
            L::put_strided([L::splat(1.0); 4], &mut numbers, Self::START, Self::STRIDE);
        } else {
            let _ = L::strided(&numbers, Self::START, Self::STRIDE);
        }
    }
}

/// How many lanes there are.
struct Count;

impl Kernel for Count {
    type Output = usize;

    #[inline(always)]
    fn run<L: Lanes>(self) -> usize {
        assert_eq!(L::REGISTERS * L::Register::COUNT, L::COUNT);
        L::COUNT
    }
}

#[test]
fn rows_that_are_not_there_are_never_read() {
    for instructions in Instructions::available() {
        let name = instructions.name();
        assert_eq!(run(instructions, Beyond([7; MOST_LANES])), 0.0);
        assert_eq!(run_on_two(instructions, Beyond([7; MOST_LANES])), 0.0);
        let enough = BeyondPlaces([9; MOST_LANES], &[0.0; 13], &[0.0; 10]);
        assert_eq!(run_on_two(instructions, enough), 0.0);
        for lane in 0..run_on_two(instructions, Count) {
            let (mut index, mut places) = ([0; MOST_LANES], [0; MOST_LANES]);
            index[lane] = 8;
            places[lane] = 9;
            if lane < run(instructions, Count) {
                let read = std::panic::catch_unwind(|| run(instructions, Beyond(index)));
                assert!(read.is_err(), "{name} lane {lane}");
            }
            let read = std::panic::catch_unwind(|| run_on_two(instructions, Beyond(index)));
            assert!(read.is_err(), "two of {name}, lane {lane}");
            for (rows, numbers) in [(12, 10), (13, 9)] {
                let numbers = (vec![0.0; rows], vec![0.0; numbers]);
                let read =
                    std::panic::catch_unwind(|| run_on_two(instructions, BeyondPlaces(places, &numbers.0, &numbers.1)));
                assert!(read.is_err(), "two of {name}, lane {lane}");
            }
        }
    }
}

#[test]
fn rows_at_a_distance_that_are_not_there_are_neither_read_nor_put() {
    for instructions in Instructions::available() {
        let one = BeyondRows::enough(run(instructions, Count));
        let two = BeyondRows::enough(run_on_two(instructions, Count));
        for puts in [false, true] {
            let ends = |missing: usize| {
                let of = |enough: usize| BeyondRows {
                    numbers: enough - missing,
                    puts,
                };
                [
                    std::panic::catch_unwind(|| run(instructions, of(one))).is_err(),
                    std::panic::catch_unwind(|| run_on_two(instructions, of(two))).is_err(),
                ]
            };
            assert_eq!(ends(0), [false; 2], "{} {puts}", instructions.name());
            assert_eq!(ends(1), [true; 2], "{} {puts}", instructions.name());
        }
    }
}

/// Puts every register by itself.
struct ByRegister<'a>(&'a [f64]);

impl Kernel for ByRegister<'_> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Vec<f64> {
        let mut put = vec![0.0; self.0.len()];
        for (from, to) in self.0.chunks(L::COUNT).zip(put.chunks_mut(L::COUNT)) {
            for which in 0..L::REGISTERS {
                let register = L::load(from).register(which);
                register.store(&mut to[which * L::Register::COUNT..]);
            }
        }
        put
    }
}

#[test]
fn registers_lie_one_behind_the_other() {
    let numbers: Vec<f64> = (0..2 * MOST_LANES).map(|k| k as f64).collect();
    for instructions in Instructions::available() {
        assert_eq!(run(instructions, ByRegister(&numbers)), numbers);
        assert_eq!(run_on_two(instructions, ByRegister(&numbers)), numbers);
    }
}

#[test]
fn instructions_that_are_not_there_run_portably() {
    let all = [
        Instructions::Avx512,
        Instructions::Avx2,
        Instructions::Neon,
        Instructions::Portable,
    ];
    let portable = run(Instructions::Portable, Everything(&AWKWARD[..8], &AWKWARD[4..]));
    for instructions in all {
        assert_eq!(run(instructions, Everything(&AWKWARD[..8], &AWKWARD[4..])), portable);
    }
}
