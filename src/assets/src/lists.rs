//! Converts a model into the lists of a mesh in flash: fixed-point numbers, and indices of 16 bits.

use std::collections::HashSet;

use super::order::order;
use super::vector::{Vector, along, largest, sub};
use super::{Alpha, Corner, Model, Triangle};

/// The numbers of fraction bits: 16 in positions and normals, 20 in texture coordinates.
const SCALAR: u32 = 16;
const TEX_COORD: u32 = 20;

/// The largest number of positions that have indices of 16 bits.
const MOST: usize = 1 << 16;

/// The index that stands for a missing attribute of a corner.
const NO_VALUE: u16 = u16::MAX;

/// Options for the conversion of a model to the lists of a mesh.
#[derive(Clone, Debug)]
pub struct Options {
    /// Whether the middle of the [box](Model::bounds) around all faces of the model is moved to the origin, before
    /// anything else. Faces that `part` and `object` leave out count, so that parts of one model still fit together.
    pub center: bool,
    /// The factor by which all positions are multiplied. The factor must not be 0.
    pub scale: f64,
    /// Whether z points up in the file. If so, the model is turned so that y points up.
    pub z_up: bool,
    /// If given, only faces of the material with this name are kept.
    pub part: Option<String>,
    /// If given, only faces of the object with this name are kept.
    pub object: Option<String>,
    /// What a user can do about too many values.
    pub remedy: &'static str,
    /// Whether faces and values keep the file's order. If not, they are put into an order in which a draw call projects
    /// fewer vertices, if there is one: faces among those of the same material, except those that are not opaque.
    pub file_order: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            center: false,
            scale: 1.0,
            z_up: false,
            part: None,
            object: None,
            remedy: "include the parts of its materials one by one",
            file_order: false,
        }
    }
}

/// The lists of a mesh. If `uv_faces`, `normal_faces` or `color_faces` is empty although the mesh has such values,
/// `faces` gives their indices, too.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lists {
    /// Positions, in units of 2^-16.
    pub positions: Vec<[i32; 3]>,
    /// For each face, the indices of its corners' positions.
    pub faces: Vec<[u16; 3]>,
    /// The sides of the file's polygons: pairs of indices of positions.
    pub edges: Vec<[u16; 2]>,
    /// Texture coordinates, in units of 2^-20.
    pub uvs: Vec<[i32; 2]>,
    /// For each face, the indices of its corners' texture coordinates; empty, or as long as `faces`.
    pub uv_faces: Vec<[u16; 3]>,
    /// Normals, in units of 2^-16.
    pub normals: Vec<[i32; 3]>,
    /// For each face, the indices of its corners' normals; empty, or as long as `faces`.
    pub normal_faces: Vec<[u16; 3]>,
    /// Colors: red, green and blue.
    pub colors: Vec<[u8; 3]>,
    /// For each face, the indices of its corners' colors; empty, or as long as `faces`.
    pub color_faces: Vec<[u16; 3]>,
    /// As [`Model::far`], for the faces that the options select.
    pub far: Option<String>,
}

/// A run of faces with one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// The index of the first face, and the index after the last face.
    pub faces: [usize; 2],
    /// Index of the material; `None` for faces without a material.
    pub material: Option<u32>,
}

/// Converts a number to units of 2^-`fraction`, rounded to nearest, halves away from zero; `None` if the result does
/// not fit 32 bits.
fn fixed(x: f64, fraction: u32) -> Option<i32> {
    let units = (x * f64::from(1_u32 << fraction)).round();
    #[allow(clippy::cast_possible_truncation)] // checked
    let bits = units as i32;
    (f64::from(bits).total_cmp(&(units + 0.0)).is_eq()).then_some(bits)
}

/// For each face, the indices of an attribute's values. The list is empty if there are no values, or the attribute can
/// use the indices of the positions.
fn own_faces(
    model: &Model,
    values: usize,
    index: impl Fn(&Corner) -> Option<u32>,
) -> Vec<[u16; 3]> {
    let triangles = model.triangles.iter();
    let mut corners = triangles.clone().flat_map(|triangle| &triangle.corners);
    let is_own = values != model.positions.len()
        || corners.any(|corner| index(corner) != Some(corner.position));
    let own = |corner| index(&corner).map_or(NO_VALUE, narrow);
    let faces = triangles.map(|triangle| triangle.corners.map(own));
    faces.filter(|_| values > 0 && is_own).collect()
}

/// Converts an index that [`Model::lists`] has checked.
#[allow(clippy::cast_possible_truncation)]
const fn narrow(index: u32) -> u16 {
    index as u16
}

/// Keeps only the values that corners or `others` use, in their order or in the order of their first use, and renumbers
/// the corners. Returns the new index of each old value.
fn compact<T: Clone>(
    values: &mut Vec<T>,
    triangles: &mut [Triangle],
    others: &[[u32; 2]],
    by_use: bool,
    index: impl Fn(&mut Corner) -> Option<&mut u32>,
) -> Vec<Option<u32>> {
    let mut places = vec![None; values.len()];
    let mut used = Vec::new();
    let mut note = |at: u32| {
        if places[at as usize].replace(0).is_none() {
            used.push(at);
        }
    };
    let mut each = |change: &mut dyn FnMut(&mut u32)| {
        let corners = triangles
            .iter_mut()
            .flat_map(|triangle| &mut triangle.corners);
        corners.filter_map(&index).for_each(change);
    };
    each(&mut |at| note(*at));
    others.as_flattened().iter().for_each(|&at| note(at));
    if !by_use {
        used.sort_unstable();
    }
    for (new, &at) in (0..).zip(&used) {
        places[at as usize] = Some(new);
    }
    *values = used.iter().map(|&at| values[at as usize].clone()).collect();
    each(&mut |at| *at = places[*at as usize].unwrap_or(*at));
    places
}

/// Returns the index of the wanted name in a list; `None` if no name is wanted.
fn find<'a>(
    wanted: Option<&str>,
    what: &str,
    mut names: impl Iterator<Item = &'a str> + Clone,
) -> Result<Option<u32>, String> {
    let Some(wanted) = wanted else {
        return Ok(None);
    };
    let all: Vec<&str> = names.clone().collect();
    match names.position(|name| name == wanted) {
        Some(at) => Ok(u32::try_from(at).ok()),
        None => Err(format!(
            "there is no {what} '{wanted}': the names are '{}'",
            all.join("', '")
        )),
    }
}

impl Model {
    /// The model with only the faces that the options name, and only the values that these faces use.
    fn selected(&self, options: &Options) -> Result<Self, String> {
        let materials = self.materials.iter().map(|material| material.name.as_str());
        let material = find(options.part.as_deref(), "material", materials)?;
        let objects = self.objects.iter().map(String::as_str);
        let object = find(options.object.as_deref(), "object", objects)?;
        let is_wanted = |triangle: &&Triangle| {
            (material.is_none() || triangle.material == material)
                && (object.is_none() || triangle.object == object)
        };
        let triangles: Vec<Triangle> = self.triangles.iter().filter(is_wanted).copied().collect();
        if triangles.is_empty() {
            return Err(
                "the options select no face: a face must have the material and the object that they name"
                    .into(),
            );
        }
        let is_blended = |triangle: &Triangle| {
            let material = triangle.material.map(|at| &self.materials[at as usize]);
            material.is_some_and(|it| it.opacity < 1.0 || it.alpha == Alpha::Blended)
        };
        let mut model = Self {
            positions: self.positions.clone(),
            uvs: self.uvs.clone(),
            normals: self.normals.clone(),
            colors: self.colors.clone(),
            edges: self.edges.clone(),
            objects: self.objects.clone(),
            triangles,
            ..Self::default()
        };
        // Lines that belong to no face are kept only if all faces are kept.
        model.compact(model.triangles.len() == self.triangles.len(), false);
        if !options.file_order && order(&mut model.triangles, is_blended) {
            model.compact(true, true);
        }
        Ok(model)
    }

    /// Keeps only the values that faces use and, if wanted, lines, in their order or in the order of their first use.
    fn compact(&mut self, with_lines: bool, by_use: bool) {
        let triangles = &mut self.triangles;
        let edges = std::mem::take(&mut self.edges);
        let lines = if with_lines { &edges[..] } else { &[] };
        let places = compact(&mut self.positions, triangles, lines, by_use, |corner| {
            Some(&mut corner.position)
        });
        compact(&mut self.uvs, triangles, &[], by_use, |corner| {
            corner.uv.as_mut()
        });
        compact(&mut self.normals, triangles, &[], by_use, |corner| {
            corner.normal.as_mut()
        });
        compact(&mut self.colors, triangles, &[], by_use, |corner| {
            corner.color.as_mut()
        });
        for [from, to] in edges {
            if let (Some(from), Some(to)) = (places[from as usize], places[to as usize]) {
                self.edge(from, to);
            }
        }
        self.edges.sort_unstable();
    }

    /// The lists of a mesh.
    ///
    /// Positions are rounded to the nearest 2^-16, texture coordinates to the nearest 2^-20, halves away from zero.
    ///
    /// # Errors
    ///
    /// There are more than 65,536 values of a kind, a position leaves the range from −32,768 to 32,768, or the options
    /// select no face, or only faces that cannot be seen.
    pub fn lists(&self, options: &Options) -> Result<Lists, String> {
        let model = self.selected(options)?;
        let kinds = [
            (model.positions.len(), "positions"),
            (model.uvs.len(), "texture coordinates"),
            (model.normals.len(), "normals"),
            (model.colors.len(), "colors"),
        ];
        for (count, kind) in kinds {
            if count > MOST {
                let remedy = options.remedy;
                return Err(format!(
                    "it has {count} {kind}: a mesh can have at most {MOST}; {remedy}"
                ));
            }
        }
        let turned = |[x, y, z]: Vector| if options.z_up { [x, z, -y] } else { [x, y, z] };
        let origin = if options.center {
            self.middle()
        } else {
            [0.0; 3]
        };
        let placed = |position: &Vector| turned(sub(*position, origin));
        let sizes = model.positions.iter().map(|at| largest(placed(at)));
        let most = sizes.fold(0.0, f64::max);
        let position = |position: &Vector| -> Result<[i32; 3], String> {
            let [x, y, z] = placed(position).map(|x| fixed(x * options.scale, SCALAR));
            x.zip(y).zip(z).map(|((x, y), z)| [x, y, z]).ok_or_else(|| {
                let fits = (f64::from(32_767_u16) / most).log2().floor().exp2();
                format!(
                    "a coordinate is {}: it must lie between -32768 and 32767.99999; with scale = {fits} it does",
                    most * options.scale
                )
            })
        };
        let positions = model.positions.iter().map(position);
        let uv = |&[u, v]: &[f64; 2]| {
            // In OBJ files, v points up. The file's v is rounded before it is reversed, so that halves are rounded away
            // from zero in the file's own direction.
            let up = fixed(1.0 - v, TEX_COORD).map(|v| (1 << TEX_COORD) - v);
            [fixed(u, TEX_COORD).unwrap_or(0), up.unwrap_or(0)]
        };
        let normal = |normal: &Vector| {
            let turned = turned(*normal);
            let size = largest(turned);
            // Only a normal's direction matters. A very short normal is scaled so that rounding does not lose its
            // direction, a very long normal so that it fits.
            let scale = if (0.01..16_384.0).contains(&size) {
                1.0
            } else {
                1.0 / size
            };
            turned.map(|x| fixed(x * scale, SCALAR).unwrap_or(0))
        };
        let far = match options.part.as_ref().or(options.object.as_ref()) {
            None => self.far.clone(),
            Some(_) => model.check_sight()?,
        };
        let faces = model.triangles.iter().map(|triangle| triangle.corners);
        let faces = faces.map(|corners| corners.map(|corner| narrow(corner.position)));
        Ok(Lists {
            faces: faces.collect(),
            edges: model.edges.iter().map(|edge| edge.map(narrow)).collect(),
            uvs: model.uvs.iter().map(uv).collect(),
            uv_faces: own_faces(&model, model.uvs.len(), |corner| corner.uv),
            normals: model.normals.iter().map(normal).collect(),
            normal_faces: own_faces(&model, model.normals.len(), |corner| corner.normal),
            color_faces: own_faces(&model, model.colors.len(), |corner| corner.color),
            colors: model.colors.clone(),
            positions: positions.collect::<Result<_, _>>()?,
            far,
        })
    }

    /// The least and the greatest coordinates of the positions that faces use, in the file's units. A model that was
    /// read has faces; without faces, the least are greater than the greatest.
    #[must_use]
    pub fn bounds(&self) -> [Vector; 2] {
        let corners = self.triangles.iter().flat_map(|triangle| triangle.corners);
        let (mut low, mut high) = ([f64::MAX; 3], [f64::MIN; 3]);
        for position in corners.map(|corner| self.positions[corner.position as usize]) {
            for axis in 0..3 {
                low[axis] = low[axis].min(position[axis]);
                high[axis] = high[axis].max(position[axis]);
            }
        }
        [low, high]
    }

    /// The middle of the box between the [bounds](Self::bounds).
    #[must_use]
    pub fn middle(&self) -> Vector {
        let [low, high] = self.bounds();
        along(low, sub(high, low), 0.5)
    }

    /// Returns a warning if more than a hundredth of the positions become equal when they are multiplied by `scale` and
    /// rounded; otherwise `None`. The warning names the options that keep these positions apart. Positions that differ
    /// by less than 1/65,536 of the model's size count as one position.
    #[must_use]
    pub fn merging(&self, scale: f64) -> Option<String> {
        let corners = self.triangles.iter().flat_map(|triangle| triangle.corners);
        let used: HashSet<u32> = corners.map(|corner| corner.position).collect();
        let points: Vec<Vector> = used.iter().map(|&at| self.positions[at as usize]).collect();
        let [low, high] = self.bounds();
        let fine = 1.0 / largest(sub(high, low));
        let distinct = |scale: f64| {
            let steps = scale * f64::from(1_u32 << SCALAR);
            #[allow(clippy::cast_possible_truncation)] // saturates
            let rounded = |point: &Vector| point.map(|x| (x * steps).round() as i64);
            points.iter().map(rounded).collect::<HashSet<_>>().len()
        };
        if fine <= scale.abs() {
            return None;
        }
        let (apart, kept) = (distinct(fine), distinct(scale));
        let are_kept = |kept: usize| kept * 100 >= apart * 99;
        if are_kept(kept) {
            return None;
        }
        let mut enough = 2.0 * scale;
        while enough.abs() < fine && !are_kept(distinct(enough)) {
            enough *= 2.0;
        }
        let farthest = largest(low).max(largest(high));
        // With the middle of the model at the origin, all positions fit at every scale up to `fine`.
        let center = if farthest * enough.abs() < 32_767.0 {
            ""
        } else {
            "center, "
        };
        let merged = apart.saturating_sub(kept);
        Some(format!(
            "{merged} of {apart} positions become equal to others when rounded to 1/65536: {center}scale = {enough} keeps them apart"
        ))
    }

    /// The runs of faces with one material, in the order of the faces.
    #[must_use]
    pub fn runs(&self) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for (at, triangle) in self.triangles.iter().enumerate() {
            match runs.last_mut() {
                Some(run) if run.material == triangle.material => run.faces[1] = at + 1,
                _ => runs.push(Run {
                    faces: [at, at + 1],
                    material: triangle.material,
                }),
            }
        }
        runs
    }
}

impl Lists {
    /// The positions with 16-bit components, rounded to nearest, and the number of their fraction bits. There are as
    /// many fraction bits as the largest component permits, at most 16.
    #[must_use]
    pub fn quantized_positions(&self) -> (Vec<[i16; 3]>, u32) {
        let units = |bits: i32, fraction: u32| {
            let down = SCALAR - fraction;
            (i64::from(bits) * 2 + (1 << down)) >> (down + 1)
        };
        let fits = |fraction: &u32| {
            let mut all = self.positions.iter().flatten();
            all.all(|&bits| i16::try_from(units(bits, *fraction)).is_ok())
        };
        let fraction = (0..=SCALAR).rev().find(fits).unwrap_or(0);
        let short = |bits| i16::try_from(units(bits, fraction)).unwrap_or(i16::MAX);
        let positions = self.positions.iter().map(|position| position.map(short));
        (positions.collect(), fraction)
    }
}
