//! Barycentric weights and attributes at a point.

use super::*;
use attributes::*;

const T: Corners = [[0., 0.], [4., 0.], [0., 4.]];

#[test]
fn weights_are_areas() {
    let w = weights(&T, [1., 2.]).unwrap();
    close(w.value, [0.25, 0.25, 0.5]);
    close(w.dx, [-0.25, 0.25, 0.]);
    close(w.dy, [-0.25, 0., 0.25]);
    // The other winding gives the same weights.
    let w = weights(&[T[0], T[2], T[1]], [1., 2.]).unwrap();
    close(w.value, [0.25, 0.5, 0.25]);
    assert_eq!(weights(&[T[0], T[1], T[1]], [1., 2.]), None);
}

#[test]
fn half_way_between_depths_1_and_4() {
    // 1/z is linear on the screen. In the middle of the edge from corner 0 to corner 1, z is 1/(1/2 + 1/8) = 1.6, which
    // is (1.6 − 1)/3 = 0.2 of the way in space.
    let w = weights(&T, [2., 0.]).unwrap();
    let value = interpolate(&w, [1., 4., 9.], &[[0.], [1.], [7.]]);
    close([value.w, value.attributes[0]], [1.6, 0.2]);
    // On this edge, 1/w = 1 − 3x/16 and a/w = x/16, so a = x/(16 − 3x) and ∂a/∂x = 16/(16 − 3x)² = 0.16.
    close(value.dx, [0.16]);
    close([value.inverse_w_gradient[0]], [-3. / 16.]);
    // Along y, 1/w changes by (1/9 − 1)/4 = −2/9, and a/w by 7/36, so ∂a/∂y = (7/36 + 0.2·2/9)·1.6.
    close(value.dy, [(7. / 36. + 0.2 * 2. / 9.) * 1.6]);
}

#[test]
fn equal_w_is_affine() {
    let value = at_pixel(&T, [3.; 3], &[[1., 0.], [5., 0.], [1., 8.]], [1, 0]).unwrap();
    close(value.attributes, [2.5, 1.]);
    close(value.dx, [1., 0.]);
    close(value.dy, [0., 2.]);
    close([value.w], [3.]);
}

#[test]
fn snapped_and_unsnapped_corners_give_the_same_values() {
    let snapped = [[-130, 77], [2000, 640], [333, 3001]];
    let (w, a) = ([1., 2.5, 0.7], [[0.1, 3.], [0.9, -2.], [0.4, 0.]]);
    for pixel in Bounds::new(12, 12).pixels() {
        let one = at_pixel_snapped(snapped, w, &a, pixel).unwrap();
        let other = at_pixel(&snapped.map(view::unsnap), w, &a, pixel).unwrap();
        close(one.attributes, other.attributes);
        close(one.dx, other.dx);
        close(one.dy, other.dy);
        close([one.w], [other.w]);
    }
}
