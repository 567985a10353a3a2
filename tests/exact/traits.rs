//! The traits that every public type must implement. If one is missing, this file does not compile.

use core::error::Error as StdError;
use core::fmt::{Debug, Display};
use core::hash::Hash;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian};
use fixel::canvas::{Add, Multiply, Opacity, Replace};
use fixel::canvas::{
    Biased, ColorIndex, Contrast, ErrorDiffusion, FloatDepth, Label, NoDepth, NoTest,
};
use fixel::canvas::{TestAndWrite, TestBehind, TestNearer, TestOnly, WideFloatDepth, WriteOnly};
use fixel::math::Direction;
use fixel::mesh::{Bounds, Buffers, Counts, Keyframes, Missing, Part, Positions, Shape};
use fixel::mode::{Affine, Compact, Exact, Fast, Newton};
use fixel::prelude::*;
use fixel::shade::{Colored, ExponentialFog, Illumination, InFog, Shiny, SurfacePoint, TwoSided};
use fixel::shade::{Converted, FaceLit, Lit, Map, PartColors, PerFace, Texels, Tinted};
use fixel::shade::{Gradient, Masked, Mipmapped, Tolerance, Translucent, Within};
use fixel::textbook::Segment;
use fixel::texture::{Argb1555, Argb4444, Indexed, Mipmap, OrHole, Raw, Trilinear};
use fixel::texture::{Bilinear, CutOut, Nearest};
use fixel::view::{Aspect, Parallel, Perspective};
use fixel::{DepthView, Hit, Index, Matrix4, NormalView, Prepared, Primitive, ScreenPoint, Window};

const fn any<T: Debug + Send + Sync + Unpin>() {}
const fn shared<T: Clone + Debug + Send + Sync>() {}
const fn value<T: Copy + Debug + Eq + Hash + Send + Sync + 'static>() {}
const fn local<T: Copy + Debug>() {}
const fn default<T: Default>() {}
const fn shown<T: Display>() {}
const fn error<T: StdError + Display>() {}

macro_rules! all {
    ($check:ident: $($Type:ty)+) => { const _: () = { $($check::<$Type>();)+ }; };
}

all!(value: Error Scalar TexCoord fixel::num::Fraction Index Angle Rate);
all!(value: Vec2 Vec3 Direction Matrix4 Transform);
all!(value: Aspect Camera Mvp Mvp<Parallel> Parallel Perspective Projection Projection<Parallel>);
all!(value: Segment Viewport Window);
all!(value: Add Multiply Opacity Replace Translucent<Rgb565> fixel::shade::Precise<Rgb565> Gradient<Rgb565>);
all!(value: Argb1555 Argb4444 Masked<u8, u8> OrHole<u8> Raw<'static, Rgb565> Indexed<'static, u8, Rgb565>);
all!(value: Bounds Counts LineStyle LineStyle<true> Missing PointStyle Shape);
all!(value: Affine Compact Exact Fast Newton Cull DrawOptions DrawOptions<Fast, Biased> Drawn ScreenPoint);
all!(value: Hit Ray);
all!(value: Flat<Rgb565> Gouraud<Rgb565> DepthView<Rgb565> NormalView<Rgb565> Fragment Light);
all!(value: Converted<Flat<Rgb565>, Rgb565> FaceLit<Flat<Rgb565>> Lit<Flat<Rgb565>> Tinted<Flat<Rgb565>>);
all!(value: Colored<Light> Illumination PointLight Shiny<Light> SpotLight SurfacePoint TwoSided<Light> Viewer);
all!(value: Fog<Rgb565> Fog<Rgb565, ExponentialFog> InFog<Flat<Rgb565>, Rgb565>);
all!(value: Textured<Texture<'static, Rgb565>> FaceColors<'static, Rgb565>);
all!(value: Mipmap<'static, Rgb565> Mipmapped Trilinear);
all!(value: Part<'static> PartColors<'static>);
all!(value: PerFace<u8> Texels Tolerance Within<1, Texels>);
all!(value: Biased FloatDepth LinearDepth Native NoDepth NoTest TestAndWrite TestBehind TestNearer TestOnly WideFloatDepth WriteOnly);
all!(value: ColorIndex Contrast);
all!(value: Bilinear CutOut<u8, Rgb565> Nearest);
all!(value: Keyframes<'static> Mesh<'static> Outline<'static> Positions<'static> Sprites<'static>);
all!(shared: Map<Flat<Rgb565>, fn(&Fragment, Rgb565) -> Option<Rgb565>> Prepared<'static> Prepared<'static, u8>);
all!(shared: Object<u8> DrawList<1, 1>);
all!(local: Corner<'static> Primitive<'static>);
all!(any: Label<'static, Canvas<'static, Rgb565>>);
all!(any: Canvas<'static, Rgb565, BigEndian> Canvas<'static, Rgb565, LittleEndian, LinearDepth>);
all!(any: Buffers<'static> ErrorDiffusion<'static> Canvas<'static, Rgb565> Canvas<'static, Rgb565, Native, LinearDepth>);

all!(default: Affine Compact Exact Newton TestAndWrite TestBehind TestNearer TestOnly WriteOnly NoTest LineStyle PointStyle);
all!(default: Biased Biased<NoTest> Add Multiply Replace Parallel Perspective PerFace<u8> Texels Within<1, Texels>);
all!(default: Bilinear ColorIndex Contrast Nearest Trilinear);
all!(default: Angle Rate Vec2 Vec3 Direction Matrix4 Transform Camera Counts Cull DrawOptions);
all!(default: Drawn Missing Gouraud<Rgb565> DepthView<Rgb565> NormalView<Rgb565> DrawList<1, 1>);
all!(shown: Error Scalar Angle Vec2 Vec3);
all!(error: Error);
