//! The pixel centers that a triangle covers, found with half-spaces and the top-left rule.
//!
//! A center is covered if it is inside all three edges. A center exactly on an edge is covered if the edge is a top
//! edge (horizontal, with the triangle below it) or a left edge (with the triangle to its right). Every center is
//! tested on its own, so no error can accumulate.

/// Corners on the screen in 24.8 (1/256 pixel), x right and y down.
pub type Snapped = [[i32; 2]; 3];

/// Corners on the screen in pixels, x right and y down.
pub type Corners = [[f64; 2]; 3];

/// A rectangle of pixels; `right` and `bottom` are exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// First column.
    pub left: i32,
    /// First row.
    pub top: i32,
    /// The column after the last one.
    pub right: i32,
    /// The row after the last one.
    pub bottom: i32,
}

impl Bounds {
    /// The bounds of a picture of `width` x `height` pixels at the origin.
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            left: 0,
            top: 0,
            right: width as i32,
            bottom: height as i32,
        }
    }

    /// The intersection of two rectangles; empty (right ≤ left or bottom ≤ top) if they do not overlap.
    pub fn intersect(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        }
    }

    /// The part of these bounds that contains every center within `margin` pixels of the corners' bounding box.
    pub fn around(self, corners: &Corners, margin: f64) -> Self {
        let range = |axis: usize| {
            let low = corners.iter().map(|c| c[axis]).fold(f64::MAX, f64::min);
            let high = corners.iter().map(|c| c[axis]).fold(f64::MIN, f64::max);
            // `as` saturates. One more pixel on each side includes centers exactly at the limit.
            let low = (low - margin).floor() as i32;
            let high = (high + margin).ceil() as i32;
            (low.saturating_sub(1), high.saturating_add(1))
        };
        let ((left, right), (top, bottom)) = (range(0), range(1));
        self.intersect(Self {
            left,
            top,
            right,
            bottom,
        })
    }

    /// Every pixel, in row order.
    pub fn pixels(self) -> impl Iterator<Item = [i32; 2]> {
        (self.top..self.bottom).flat_map(move |y| (self.left..self.right).map(move |x| [x, y]))
    }
}

/// A pixel's center in 24.8.
pub fn center_snapped([x, y]: [i32; 2]) -> [i64; 2] {
    [i64::from(x) * 256 + 128, i64::from(y) * 256 + 128]
}

/// A pixel's center in pixels.
pub fn center([x, y]: [i32; 2]) -> [f64; 2] {
    [f64::from(x) + 0.5, f64::from(y) + 0.5]
}

/// (b − a) × (p − a), exact for any input. The result is twice the area of the triangle a, b, p in 1/256² pixel²,
/// positive if the triangle runs clockwise on the screen (y down).
pub fn edge(a: [i32; 2], b: [i32; 2], p: [i64; 2]) -> i128 {
    let from_a = |to: i64, axis: usize| i128::from(to) - i128::from(a[axis]);
    from_a(b[0].into(), 0) * from_a(p[1], 1) - from_a(b[1].into(), 1) * from_a(p[0], 0)
}

/// Twice the signed area in 1/256² pixel². The area is positive for corners that run clockwise on the screen (y down),
/// and negative for a front face, because its corners run counter-clockwise.
pub fn area2(t: Snapped) -> i128 {
    edge(t[0], t[1], t[2].map(i64::from))
}

/// Twice the signed area in pixel², with the sign of [`area2`].
pub fn area2_f64(t: &Corners) -> f64 {
    let [a, b, c] = *t;
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether an edge owns the centers on it, in a triangle that runs clockwise on the screen. A top edge runs to the
/// right, and a left edge runs up.
fn is_top_left<T: PartialOrd>(a: &[T; 2], b: &[T; 2]) -> bool {
    b[1] < a[1] || (b[1] == a[1] && b[0] > a[0])
}

/// The edges of a triangle of either winding, in clockwise order on the screen; `None` for a triangle without area.
fn edges(t: Snapped) -> Option<[[[i32; 2]; 2]; 3]> {
    let [a, b, c] = t;
    match area2(t) {
        0 => None,
        1.. => Some([[a, b], [b, c], [c, a]]),
        _ => Some([[a, c], [c, b], [b, a]]),
    }
}

/// Whether the center of `pixel` is on the inner side of each edge, or on an edge that owns it.
fn is_inside(edges: &[[[i32; 2]; 2]; 3], pixel: [i32; 2]) -> bool {
    let p = center_snapped(pixel);
    edges.iter().all(|[from, to]| match edge(*from, *to, p) {
        0 => is_top_left(from, to),
        e => e > 0,
    })
}

/// Whether a triangle of either winding covers the center of `pixel`. A triangle without area covers no center.
pub fn covers(t: Snapped, pixel: [i32; 2]) -> bool {
    edges(t).is_some_and(|edges| is_inside(&edges, pixel))
}

/// Whether a triangle of either winding, with corners that were not snapped, covers a point.
///
/// The ends of an edge are sorted first, so both triangles beside the edge compute the same value for it. So the
/// triangles leave no gap and do not overlap, even in rounded arithmetic.
pub fn covers_f64(t: &Corners, p: [f64; 2]) -> bool {
    let [a, b, c] = *t;
    let [a, b, c] = match area2_f64(t) {
        area if area > 0. => [a, b, c],
        area if area < 0. => [a, c, b],
        _ => return false,
    };
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let swap = from > to;
        let (low, high) = if swap { (to, from) } else { (from, to) };
        let e = area2_f64(&[low, high, p]);
        let e = if swap { -e } else { e };
        e > 0. || (e == 0. && is_top_left(&from, &to))
    })
}

/// Every pixel of `bounds` that a triangle covers, in row order.
pub fn covered_in(t: Snapped, bounds: Bounds) -> impl Iterator<Item = [i32; 2]> {
    let edges = edges(t);
    bounds
        .around(&t.map(super::view::unsnap), 0.)
        .pixels()
        .filter(move |&pixel| edges.is_some_and(|edges| is_inside(&edges, pixel)))
}

/// Every pixel of a width x height picture that a triangle covers, in row order.
pub fn covered(t: Snapped, width: u32, height: u32) -> impl Iterator<Item = [i32; 2]> {
    covered_in(t, Bounds::new(width, height))
}

/// How many of the triangles cover each pixel, in row order. If triangles tile an area without overlap, the count is 1
/// everywhere inside the area.
pub fn counts(triangles: &[Snapped], width: u32, height: u32) -> Vec<u32> {
    let mut counts = vec![0; width as usize * height as usize];
    for &triangle in triangles {
        for [x, y] in covered(triangle, width, height) {
            counts[y as usize * width as usize + x as usize] += 1;
        }
    }
    counts
}

/// The area of the part of a pixel on one side of the line through a and b: the side of the points p for which the area
/// of a b p is positive.
pub fn share_beside([a, b]: [[f64; 2]; 2], [x, y]: [i32; 2]) -> f64 {
    let [left, top] = [x, y].map(f64::from);
    let corners = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]].map(|[x, y]| [left + x, top + y]);
    let height = |p: [f64; 2]| area2_f64(&[a, b, p]);
    // The square without the corners on the other side, and with the points where the line crosses its sides.
    let mut part = Vec::new();
    for (i, &from) in corners.iter().enumerate() {
        let to = corners[(i + 1) % 4];
        let (before, after) = (height(from), height(to));
        if before >= 0. {
            part.push(from);
        }
        if before * after < 0. {
            let t = before / (before - after);
            part.push([0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis])));
        }
    }
    let fan = part
        .windows(2)
        .map(|side| area2_f64(&[part[0], side[0], side[1]]));
    fan.sum::<f64>() / 2.
}

/// Counts as text, one line per row: `.` for 0, then `1` to `9`, `+` for more.
pub fn picture(counts: &[u32], width: u32) -> Vec<String> {
    let character = |&count: &u32| match count {
        0 => '.',
        1..=9 => char::from_digit(count, 10).unwrap_or('+'),
        _ => '+',
    };
    counts
        .chunks(width as usize)
        .map(|row| row.iter().map(character).collect())
        .collect()
}
