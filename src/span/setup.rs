//! The set-up of a primitive: the planes of 1/w, and of the varyings divided by w.

use super::interpolant::{Basis, Interpolant, WideBasis, magnitude};
use super::newton::FRACTION;
use super::plan::Plan;
use super::scale::{ONE, Scale, WHOLE, weigh};
use crate::num::wide::product;
use crate::raster::{Barycentric, DepthShift, Patch, ScreenVertex};
use crate::shade::Lanes;

/// The most pixels of a span; every span computes its interpolants afresh.
///
/// A step is rounded by up to half a unit of 2⁻³⁰, so the steps of a span add at most 32 units of error. All modes use
/// the same length, so depths are the same in all modes but `Compact`. (`Compact` has wide planes only.)
pub(super) const SPAN: i32 = 64;

/// If 1/w is greater than this at all corners, the triangle is shallow: 1/w changes less than fourfold, because the
/// nearest corner's 1/w lies between 2^30 and 2^31. (The value is 2^29 plus the rounding error at a pixel.)
pub(super) const SHALLOW: u32 = (1 << 29) + 64;

/// A number that a shader interpolates over a primitive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Varying {
    /// The varying's values at the corners of the mesh's triangle.
    pub(super) corners: [i32; 3],
    /// The greatest error that the varying may have if the triangle is drawn affinely: in a small triangle, and in other
    /// triangles.
    pub(super) tolerance: [u32; 2],
    /// The varying over w, or the varying itself.
    pub(super) interpolant: Interpolant,
    pub(super) scale: Scale,
}

impl Varying {
    /// All bits 0: a varying before the first triangle.
    pub(super) const UNSET: Self = Self {
        corners: [0; 3],
        tolerance: [0; 2],
        interpolant: Interpolant::NONE,
        scale: Scale::UNSET,
    };

    /// The varying's values at the vertices of a patch.
    #[inline]
    fn at(&self, patch: &Patch<'_>) -> [i32; 3] {
        match patch.barycentric {
            None => self.corners,
            Some(places) => self.mixed(places),
        }
    }

    #[cold]
    #[inline(never)]
    fn mixed(&self, [a, b, c]: &[Barycentric; 3]) -> [i32; 3] {
        let at_a = a.mix(&self.corners);
        // Vertices of a line or of a point are the same.
        let after = |at: i32, before: &Barycentric, place: &Barycentric| {
            if !cfg!(for_size) && place.0 == before.0 {
                at
            } else {
                place.mix(&self.corners)
            }
        };
        let at_b = after(at_a, a, b);
        [at_a, at_b, after(at_b, b, c)]
    }

    /// The range of the varying's values; `None` if they are too large for [`Scale::AFFINE`].
    #[inline]
    fn affine_range(&self) -> Option<u32> {
        let [a, b, c] = self.corners;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let fits = low >= -Scale::MOST_AFFINE && high <= Scale::MOST_AFFINE;
        fits.then(|| (high - low).cast_unsigned())
    }

    /// Whether the varying may be interpolated without regard to 1/w. `range` is the varying's range, `least` is the
    /// least 1/w, and `change` is the range of 1/w. `is_small` chooses the tolerance.
    ///
    /// Let q be 1/w and f the varying, both at the corners, and λ the barycentric weights of a pixel; their sum is 1.
    /// The affine value is Σλf, the exact value is Σλqf / Σλq. Their difference is the covariance of q and f, weighted
    /// by λ, divided by the mean Σλq. The covariance is at most a quarter of the product of the ranges of q and f, and
    /// the mean is at least `least`. So the error is at most `change` · range of f / (4 · `least`), which must be below
    /// the tolerance.
    #[inline]
    fn is_affine(&self, range: u32, [least, change]: [u32; 2], is_small: bool) -> bool {
        let [small, large] = self.tolerance;
        let tolerance = if is_small { small } else { large };
        product(range.cast_signed(), change.cast_signed())
            < product((4 * tolerance).cast_signed(), least.cast_signed())
    }
}

/// The plan for varyings that are linear.
const fn straight(is_small: bool) -> Plan {
    if is_small {
        Plan::Small
    } else {
        Plan::Straight
    }
}

/// A varying of at most this magnitude has the scale [`Scale::AFFINE`]. All bits are 1, so a magnitude is tested by its
/// upper bits.
const MOST_OVER_W: i32 = (1 << (FRACTION - 2)) - 1;
const _: () = assert!(MOST_OVER_W < Scale::MOST_AFFINE);

/// Written without `map`, because `map` returns a copy of the array.
const fn signed([a, b, c]: [u32; 3]) -> [i32; 3] {
    [a.cast_signed(), b.cast_signed(), c.cast_signed()]
}

/// The right shift that turns a level, of 5 bits and 16 fraction bits, into half of a pair.
const PAIR_DOWN: u32 = 5;

/// The three varyings at a pixel, from `pair` (the first and the third varying) and `second` (the second varying,
/// [shifted left](Scale::AFFINE_UP)).
///
/// The first varying is the lower half of the pair, because its five bits of whole steps are then the bits in which
/// RGB565 has red.
///
/// The first and the third varying are levels raised by half a step: from ½ to 31½ steps. The unit of a half is 2^-11
/// step. A coarse plane has an error of [67½ units](super::interpolant), and the bits that are cut add one unit.
/// Together, this is a thirtieth of a step, so a half stays between 0 and 2^16.
#[inline]
pub(super) const fn unpaired(pair: i32, second: i32) -> [i32; 3] {
    let upper = (pair.cast_unsigned() >> 16).cast_signed();
    [
        (pair & 0xffff) << PAIR_DOWN,
        second >> Scale::AFFINE_UP,
        upper << PAIR_DOWN,
    ]
}

/// The interpolants of a primitive.
pub(crate) struct Planes<L: Lanes> {
    pub(super) setup: Setup,
    pub(super) varyings: L::Of<Varying>,
}

/// The values that all varyings of a primitive share, and the interpolant of 1/w (or depth).
#[derive(Debug)]
pub(crate) struct Setup {
    /// Whether varyings are interpolated directly, as fractions in units of 2⁻³⁰; otherwise, varyings over w are
    /// interpolated.
    pub(super) is_linear: bool,
    /// Whether there are three varyings, and the first and the third are [paired](unpaired) in triangles that are not
    /// large.
    pub(super) is_paired: bool,
    /// The least number of bits of a [`Scale`] in triangles where 1/w changes less than fourfold. With b bits, an
    /// interpolant's unit is 2^(b − 30) units of the varying. If a scale has more bits than its varying needs, accuracy
    /// is lost, but interpolants need no scaling later.
    pub(super) least_bits: u32,
    /// Set when a draw call begins.
    pub(super) shift: DepthShift,
    /// 1/w (or depth).
    pub(super) q: Interpolant,
    /// The least 1/w of the corners. The greatest 1/w has bit 30 set.
    pub(super) least: u32,
    /// Right shift that turns an interpolant of 1/w into a depth: 15 to 47.
    pub(super) down: u32,
}

impl Setup {
    /// The set-up for a draw call, before the first patch.
    #[inline]
    pub(super) const fn new([is_linear, is_paired]: [bool; 2], least_bits: u32) -> Self {
        Self {
            is_linear,
            is_paired,
            least_bits,
            shift: DepthShift(15),
            q: Interpolant::NONE,
            least: 0,
            down: 0,
        }
    }

    /// Sets up all interpolants through the vertices of a patch, and returns their plan: [`Plan::BySpan`] if varyings
    /// must be divided.
    ///
    /// One copy of this code serves any number of varyings, because a copy for each number would be most of a small
    /// program.
    #[inline(never)]
    pub(super) fn set_up(&mut self, varyings: &mut [Varying], patch: &Patch<'_>) -> Plan {
        let (q, exponent) = ScreenVertex::weights(patch.vertices);
        self.down = self.shift.right_shift(exponent);
        let [first, second, third] = q;
        self.least = first.min(second).min(third);
        let change = first.max(second).max(third) - self.least;
        let basis = match Basis::new(patch, self.is_paired) {
            Some(basis) => basis,
            None if cfg!(for_size) => Basis::NONE,
            // Apart, so that a small triangle does not begin with the numbers of a basis without small planes.
            None => return self.set_up_large(varyings, (q, change), patch),
        };
        let mut wide = None;
        basis.set_up(signed(q), (patch, &mut wide), &mut self.q);
        let affine = if self.is_linear && !self.is_paired {
            None
        } else {
            self.affine_range(varyings, change, true)
        };
        let affine = affine.map(|range| range << Scale::AFFINE_UP);
        match (affine, &mut *varyings) {
            (Some(range), [first, second, third])
                if self.is_paired
                    && basis.is_coarse(range)
                    && patch.barycentric.is_none()
                    && patch.size[0] <= SPAN << 8 =>
            {
                let cut = |[a, b, c]: [i32; 3]| [a >> PAIR_DOWN, b >> PAIR_DOWN, c >> PAIR_DOWN];
                let plane = basis.small(second.corners, Scale::AFFINE_UP);
                second.interpolant.set(plane);
                let (lower, upper) = (cut(first.corners), cut(third.corners));
                let plane = basis.small(lower, 0).paired(basis.small(upper, 0));
                first.interpolant.set(plane);
                Plan::Small
            }
            (Some(range), varyings)
                if basis.is_small(range)
                    && (patch.barycentric.is_none() || varyings.is_empty()) =>
            {
                for varying in varyings {
                    varying.scale = Scale::AFFINE;
                    let plane = basis.small(varying.corners, Scale::AFFINE_UP);
                    varying.interpolant.set(plane);
                }
                straight(self.q.is_small)
            }
            (affine, varyings) => {
                // `affine` holds within the tolerance of a small triangle. This triangle gets the narrower one.
                let affine = affine.and_then(|_| self.affine_range(varyings, change, false));
                if !cfg!(for_size)
                    && affine.is_none()
                    && self.is_small_over_w()
                    && patch.barycentric.is_none()
                    && Self::set_up_small_over_w(varyings, &basis, q)
                {
                    return Plan::SmallOverW;
                }
                let is_affine = affine.is_some() && !self.is_linear;
                self.set_up_varyings(varyings, (basis, wide), (q, is_affine), patch)
            }
        }
    }

    /// Sets up all interpolants of a triangle that has no small plane.
    #[inline(never)]
    fn set_up_large(
        &mut self,
        varyings: &mut [Varying],
        (q, change): ([u32; 3], u32),
        patch: &Patch<'_>,
    ) -> Plan {
        let wide = WideBasis::new(patch);
        wide.set_up(signed(q), &mut self.q);
        let is_affine = !self.is_linear && self.affine_range(varyings, change, false).is_some();
        self.set_up_varyings(varyings, (Basis::NONE, Some(wide)), (q, is_affine), patch)
    }

    /// Whether a triangle's rows may have the plan [`Plan::SmallOverW`], if the planes of its varyings are small and have
    /// the right scale.
    #[inline]
    const fn is_small_over_w(&self) -> bool {
        self.least_bits == FRACTION && self.q.is_small && self.least > SHALLOW
    }

    /// Sets up small planes through the varyings over w. Returns false if the values of a varying are too large, or too far
    /// apart, for a small plane.
    #[inline]
    fn set_up_small_over_w(
        varyings: &mut [Varying],
        basis: &Basis,
        [q_a, q_b, q_c]: [u32; 3],
    ) -> bool {
        for varying in varyings {
            let [a, b, c] = varying.corners;
            if magnitude(a) | magnitude(b) | magnitude(c) > MOST_OVER_W {
                return false;
            }
            // `weigh` would return the same products and the same scale.
            let over_w = |value: i32, q: u32| {
                let filled = value << (32 - FRACTION);
                ((product(filled, q.cast_signed()) + (1 << 31)) >> 32) as i32
            };
            let values = [over_w(a, q_a), over_w(b, q_b), over_w(c, q_c)];
            if !basis.has_small(values) {
                return false;
            }
            varying.scale = Scale::AFFINE;
            varying.interpolant.set(basis.small(values, 0));
        }
        true
    }

    /// Sets up 1/w at a point.
    pub(super) fn set_up_point(&mut self, patch: &Patch<'_>) {
        let [at, ..] = patch.vertices;
        self.down = self.shift.right_shift(at.exponent);
        self.least = at.q;
        self.q.set_level(at.q.cast_signed());
    }

    /// The widest range of the varyings, if all may be interpolated without regard to 1/w. `is_small` chooses the
    /// tolerance.
    #[inline]
    fn affine_range(&self, varyings: &[Varying], change: u32, is_small: bool) -> Option<u32> {
        let mut widest = 0;
        for varying in varyings {
            let range = varying.affine_range()?;
            if !self.is_linear && !varying.is_affine(range, [self.least, change], is_small) {
                return None;
            }
            widest = range.max(widest);
        }
        Some(widest)
    }

    /// Sets up any varyings through the vertices of a patch.
    #[inline(never)]
    fn set_up_varyings(
        &mut self,
        varyings: &mut [Varying],
        (basis, mut wide): (Basis, Option<WideBasis>),
        (q, is_affine): ([u32; 3], bool),
        patch: &Patch<'_>,
    ) -> Plan {
        let (weights, least_bits) = if self.is_linear {
            ([ONE; 3], self.least_bits)
        } else if self.least > SHALLOW {
            (q, self.least_bits)
        } else {
            (q, 1)
        };
        // With `is_paired`, `Plan::Small` is only for varyings that are paired.
        let mut is_small = self.q.is_small;
        for varying in &mut *varyings {
            let mut values = varying.at(patch);
            varying.scale = if is_affine {
                let [a, b, c] = values;
                let up = Scale::AFFINE_UP;
                values = [a << up, b << up, c << up];
                Scale::AFFINE
            } else {
                weigh(&mut values, &weights, least_bits)
            };
            basis.set_up(values, (patch, &mut wide), &mut varying.interpolant);
            is_small &= varying.interpolant.is_small;
        }
        let is_whole = |varying: &Varying| varying.scale.bits() == WHOLE;
        if is_affine || self.is_linear && varyings.iter().all(is_whole) {
            straight(is_small && !self.is_paired)
        } else if self.is_linear {
            Plan::Scaled
        } else if cfg!(for_size)
            && is_small
            && patch.barycentric.is_none()
            && self.is_small_over_w()
            && varyings
                .iter()
                .all(|varying| varying.scale == Scale::AFFINE)
        {
            Plan::SmallOverW
        } else {
            Plan::BySpan
        }
    }

    /// Sets up wide planes through 1/w and all varyings: for a mode that uses only wide planes, or for
    /// [`precise_q`](Self::precise_q) and `WidePlane::precise`.
    #[cold]
    #[inline(never)]
    pub(super) fn set_up_wide(&mut self, varyings: &mut [Varying], patch: &Patch<'_>) {
        let (q, exponent) = ScreenVertex::weights(patch.vertices);
        self.down = self.shift.right_shift(exponent);
        let basis = WideBasis::new(patch);
        basis.set_up(signed(q), &mut self.q);
        let weights = if self.is_linear { [ONE; 3] } else { q };
        for varying in varyings {
            let mut values = varying.at(patch);
            varying.scale = weigh(&mut values, &weights, 1);
            basis.set_up(values, &mut varying.interpolant);
        }
    }

    /// 1/w at a pixel, shifted left to 31 bits, and by how many bits it was shifted.
    pub(super) fn precise_q(&self, at: [i32; 2]) -> (u32, u32) {
        let coarse = self.q.wide.precise(at, 0).cast_unsigned();
        // Rounding up may add a bit.
        let up = (coarse | 1).leading_zeros().saturating_sub(2);
        (self.q.wide.precise(at, up).cast_unsigned(), up)
    }

    /// The greatest change of 1/w from a pixel to the next, across or down.
    pub(super) fn steepness(&self) -> u32 {
        self.q.step.unsigned_abs().max(self.q.row().unsigned_abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::vertex;
    use crate::random::cases;
    use crate::raster::{MOST_WEIGHT, area};
    use rand::Rng;

    /// The number of bits of a varying's scale in a triangle with corners of these 1/w.
    fn bits(q: [u32; 3]) -> u32 {
        let screens = [[0, 0], [9000, 500], [300, 9900]];
        let [mut a, mut b, mut c] = screens.map(vertex);
        [a.q, b.q, c.q] = q;
        let patch = Patch {
            vertices: [&a, &b, &c],
            barycentric: None,
            size: [9000, 9900],
            area: area(&screens),
        };
        let mut varyings = [Varying {
            corners: [0, 100, 200],
            ..Varying::UNSET
        }];
        let mut setup = Setup::new([false; 2], 28);
        assert_eq!(setup.set_up(&mut varyings, &patch), Plan::BySpan);
        varyings[0].scale.bits()
    }

    /// A scale has the bits that a mode asks for if 1/w changes less than fourfold. Otherwise, it has the 9 bits that
    /// the value 200 takes.
    #[test]
    fn scales_have_the_bits_that_a_mode_asks_for() {
        assert_eq!(bits([1 << 30, 1 << 30, SHALLOW + 1]), 28);
        assert_eq!(bits([1 << 30, 1 << 30, SHALLOW]), 9);
    }

    /// The two ways to set up a small triangle with varyings over w: `set_up_small_over_w` and, in a build for size,
    /// `set_up_varyings`.
    #[test]
    fn a_build_for_size_has_the_same_small_planes() {
        let mut compared = 0;
        cases(4096, |random| {
            let screens = [(); 3].map(|()| [(); 2].map(|()| random.random_range(0..21 << 8)));
            let mut vertices = screens.map(vertex);
            for vertex in &mut vertices {
                vertex.q = random.random_range(SHALLOW + 1..MOST_WEIGHT);
            }
            let [a, b, c] = &vertices;
            let size = [0, 1].map(|axis| {
                let [a, b, c] = screens.map(|screen| screen[axis]);
                a.max(b).max(c) - a.min(b).min(c)
            });
            let patch = Patch {
                vertices: [a, b, c],
                barycentric: None,
                size,
                area: area(&screens),
            };
            let most = Scale::MOST_AFFINE >> random.random_range(0..20);
            let mut one = [(); 2].map(|()| Varying {
                corners: [(); 3].map(|()| random.random_range(-most..=most)),
                ..Varying::UNSET
            });
            let mut other = one;
            let mut setup = Setup::new([false; 2], FRACTION);
            if setup.set_up(&mut one, &patch) != Plan::SmallOverW {
                return;
            }
            compared += 1;
            let (q, _) = ScreenVertex::weights(patch.vertices);
            let basis = Basis::new(&patch, false).unwrap();
            setup.set_up_varyings(&mut other, (basis, None), (q, false), &patch);
            assert_eq!(std::format!("{one:?}"), std::format!("{other:?}"));
        });
        assert!(compared > 1000, "{compared}");
    }

    /// The plan of a sliver that is ten pixels long, with these varyings. A small or coarse plane in it has a range below
    /// 2^23.
    fn plan_of_sliver(is_paired: bool, q: [u32; 3], varyings: &mut [Varying]) -> Plan {
        let screens = [[0, 127], [2560, 127], [0, 135]];
        let mut vertices = screens.map(vertex);
        for (vertex, q) in vertices.iter_mut().zip(q) {
            vertex.q = q;
        }
        let patch = Patch {
            vertices: vertices.each_ref(),
            barycentric: None,
            size: [2560, 8],
            area: area(&screens),
        };
        Setup::new([false, is_paired], FRACTION).set_up(varyings, &patch)
    }

    /// Levels are shifted left by two bits, so 63 steps of green have a range of 24 bits.
    #[test]
    fn a_sliver_has_no_coarse_planes_of_a_wide_range() {
        let plan = |steps: i32| {
            let mut varyings = [Varying {
                corners: [0, steps << 16, 0],
                tolerance: [1 << 13; 2],
                ..Varying::UNSET
            }; 3];
            plan_of_sliver(true, [1 << 30; 3], &mut varyings)
        };
        assert_eq!(plan(31), Plan::Small);
        assert_ne!(plan(63), Plan::Small);
    }

    /// A sliver without small planes has the narrow tolerance of 16 units, like a large triangle. The errors are
    /// 2^23 · 2^12 / 2^32 = 8 units, 32 units, and again 32 units.
    #[test]
    fn a_sliver_without_small_planes_has_the_narrow_tolerance() {
        let plan = |texels: i32, change: u32| {
            let mut varying = [Varying {
                corners: [0, texels << 16, 0],
                tolerance: [1 << 11, 1 << 4],
                ..Varying::UNSET
            }];
            plan_of_sliver(false, [1 << 30, (1 << 30) + change, 1 << 30], &mut varying)
        };
        assert_eq!(plan(128, 1 << 12), Plan::Straight);
        assert_eq!(plan(128, 1 << 14), Plan::BySpan);
        // The same error is allowed in a small plane.
        assert_eq!(plan(2, 1 << 20), Plan::Small);
    }

    /// The error is at most `change` · range / (4 · `least`), and must be below the tolerance.
    #[test]
    fn a_varying_is_affine_below_its_tolerance() {
        let with = |tolerance, range, change| {
            let is_affine = |tolerance, is_small| {
                let varying = Varying {
                    tolerance,
                    ..Varying::UNSET
                };
                varying.is_affine(range, [1 << 30, change], is_small)
            };
            let small = is_affine([tolerance, 0], true);
            assert_eq!(small, is_affine([0, tolerance], false));
            small
        };
        // 2^20 · 2^16 / (4 · 2^30) is 16.
        assert!(with(16, (1 << 16) - 1, 1 << 20) && with(17, 1 << 16, 1 << 20));
        assert!(!with(16, 1 << 16, 1 << 20) && !with(0, 0, 0));
        assert!(with(1, 1 << 27, 0) && !with(1, 1 << 27, 1 << 30));

        let range = |corners| {
            let varying = Varying {
                corners,
                ..Varying::UNSET
            };
            varying.affine_range()
        };
        let most = Scale::MOST_AFFINE;
        assert_eq!(range([-most, 0, most]), Some(2 * most.cast_unsigned()));
        for at in 0..3 {
            for far in [most + 1, -most - 1] {
                let mut corners = [0; 3];
                corners[at] = far;
                assert_eq!(range(corners), None, "{corners:?}");
            }
        }
    }
}
