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
        let mut found = vec![Vec::new(); 20];
        for (a, b) in self.0.chunks(L::COUNT).zip(self.1.chunks(L::COUNT)) {
            let (a, b) = (L::load(a), L::load(b));
            let as_number = |mask: L::Mask| L::select(mask, L::splat(1.0), L::splat(2.0));
            let v = L::Vector::new(a, b, a + 1.0);
            let w = L::Vector::new(b, a * 2.0, b - 0.3);
            let of_rows = {
                let rows = [a, b, a - b, a * 3.0];
                let back = L::rows(rows);
                L::columns(back.as_flattened(), &std::array::from_fn(|lane| 4 * lane))
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
        assert_eq!(
            run(instructions, Everything(&a, &b)),
            portable,
            "{}",
            instructions.name()
        );
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
