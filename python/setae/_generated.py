# SPDX-License-Identifier: GPL-3.0-or-later
# Written by tools/python_keywords.py from the library's description of options: change that.
"""Keywords of requests, for type checkers and editors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypedDict

from ._options import Text


class BlindTipRequest(TypedDict, total=False):
    points: int
    """extent of the estimated tip in pixels, an odd number."""
    threshold: Text
    """height by which the map must demand a sharper tip, about twice the noise, such as "0.2 nm"; default: 0."""
    rounds: int
    """largest number of passes over the map."""


class ComparisonRequest(TypedDict, total=False):
    pixels: Text
    """points of each surface, 512 or 1024x512; at least four per shortest wavelength."""
    cell: Text
    """extent of each surface, such as "2 um"; default: twice the longest wavelength."""
    surfaces: int
    """number of surfaces."""
    seed: int
    """seed of the first surface; the others have the next ones."""
    tolerance: float
    """largest relative duality gap of each contact."""


class ContainerRequest(TypedDict, total=False):
    name: Text
    """name of the surface that measured files become; default: that of the output."""
    description: Text
    """description of the surface that measured files become."""
    taken_over: Sequence[str] | str
    """containers and studies (.toml) whose surfaces are taken over."""
    size: Sequence[str] | str
    """extent where files do not state it, of all files or of one as "FILE=1 mm x 1 mm", such as "1 mm x 1 mm"."""
    unit: Sequence[str] | str
    """unit of lengths where files do not state it, of all files or of one as FILE=um, such as "um"."""
    channel: Sequence[str] | str
    """channel by its number, counted from 0, or by its name, of all files or of one as FILE=1; default: the preferred channel."""
    detrend: Sequence[str] | str
    """trend to be removed: mean, tilt or parabola, of all files or of one as FILE=tilt; default: mean."""
    layout: Text
    """layout of a text file: a narrow map (matrix), points x y z (columns), or the table of a spectrum (spectrum); default: from numbers
    and header; one of matrix, columns, spectrum."""
    keep_values: bool
    """values that mark missing heights (NO_DATA), such as -9999, stay heights; without it they become undefined."""


class CurveRequest(TypedDict, total=False):
    curve: bool
    """tables are force curves: force and displacement without visible adhesion; AFM files always are."""
    tip: Text
    """shape of the tip of a force curve; one of paraboloid, cone, three_sided_pyramid."""
    half_angle: float
    """half angle of a conical tip, or inclination of a pyramid's faces, in degrees."""
    model: Text
    """contact model of a force curve: hertz, dmt, jkr, maugis_dugdale or large_strain."""
    fit_range: Text
    """range of a force curve that is fitted, FROM:TO in indentation, force or shares of the largest indentation, such as "0 nm:500 nm";
    default: -1:1."""
    contact_point: Text
    """contact point of a force curve: fit, found (where the force leaves the baseline), or a length."""
    keep_baseline_slope: bool
    """only the mean of free flight is removed from a force curve, not the slope."""


class FrontRequest(TypedDict, total=False):
    radius: Text
    """radius of the sphere, such as "1.25 mm"."""
    contact_modulus: Text
    """contact modulus E* of sphere and surface together, such as "1 MPa"."""
    W_int: Text
    """energy gained per unit area of full contact, such as "50 mJ/m2"."""
    to_force: Text
    """force of a smooth sphere where the loop turns, such as "0.1 mN"."""
    to_displacement: Text
    """displacement of a smooth sphere where the loop turns, such as "1 um"."""
    stage_stiffness: Text
    """stiffness of the stage that is moved, such as "100 N/m"; default: the displacement of the sphere is prescribed."""
    dead_load: bool
    """the force is prescribed; the loop ends at pull-off."""
    shortest_wavelength: Text
    """shortest wavelength that counts, such as "1 um"; default: four pixels."""
    steps: int
    """steps on approach; halved where the edge jumps."""
    duration: Text
    """duration of the approach: times of the edge that is saved, such as "100 s"."""
    model: Text
    """dependence of the energy on the position of the edge; one of constant_toughness, variational, energy_release_rate, stress_intensity,
    mean_circle."""
    method: Text
    """solver for the equilibria; one of trust_region, rosso_krauth."""


class HardWallRequest(TypedDict, total=False):
    contact_modulus: Text
    """contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"."""
    layer: Text
    """thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space."""
    bonded: bool
    """the layer sticks to its base."""
    frictionless: bool
    """the layer slides on its base."""
    nu: float
    """Poisson ratio of the layer, from 0 to 0.5."""
    pressure: Text
    """mean pressure over the map, such as "10 MPa"."""
    displacement: Text
    """approach from first touch, such as "5 nm"."""
    stage_stiffness: Text
    """stiffness of the stage that is displaced, with adhesion only, such as "10 N/m"."""
    mean_gap: Text
    """mean gap over the map, such as "2 nm"."""
    free: bool
    """nothing touches beyond the map; without it the map repeats itself."""
    hardness: Text
    """pressure at which the body flows, such as "1 GPa"; default: the body stays elastic."""
    tolerance: float
    """largest relative duality gap of a converged contact."""


class InteractionRequest(TypedDict, total=False):
    W_int: Text
    """work of adhesion per unit area in contact, such as "50 mJ/m2"."""
    range: Text
    """range of the attraction: its greatest tension is the work of adhesion over the range, such as "0.3 nm"."""
    law: Text
    """decay of the attraction with the gap; one of exponential, cubic, dugdale, lennard_jones."""


class LensRequest(TypedDict, total=False):
    x: Text
    """column of positions along the lens; default: the first column of lengths."""
    z: Text
    """column of heights; default: the second column of lengths."""
    pixel: Text
    """size of a pixel in pictures that do not state it, such as "2.05 um"."""
    start: Text
    """start of the range along the lens; points before are left out, such as "-0.2 mm"."""
    stop: Text
    """end of the range along the lens; points beyond are left out, such as "0.2 mm"."""


class LineRequest(TypedDict, total=False):
    pixel: Text
    """size of a pixel in the camera's pictures, such as "1.82 um"."""
    frame_rate: float
    """frames per second of the camera."""
    fringes: bool
    """pictures show Newton's rings around the contact; the innermost ring is the edge."""
    um_per_px: float
    """size of a pixel in micrometres, such as "1.82"."""
    ignore_stated_pixel_size: bool
    """the given size of a pixel counts, even where a file states another."""
    first: int
    """number of the first frame that is analysed."""
    last: int
    """number of the last frame that is analysed."""
    region: Text
    """part of the frames that is analysed: x,y,width,height in pixels, such as "100,80,320,240"."""
    polarity: Text
    """grey level of the contact relative to the surroundings; one of automatic, dark, bright."""
    smallest_radius: float
    """smallest radius of a contact, in pixels."""
    min_confidence: float
    """smallest confidence of a reported contact, from 0 to 1."""
    exclude: Sequence[float]
    """numbers of frames that are left out, such as "12,17"."""
    reason: Text
    """reason why frames are left out, such as "glare"."""
    angles: int
    """number of places along the edge; default: one every 2 px of the largest contact."""
    smallest_void: float
    """smallest area of a reported void, in px^2."""
    ring_width: Text
    """width of the rings whose cells have a speed each, such as "5 um"; default: the step of the edge from frame to frame."""
    threshold: float
    """factor by which a jump is faster, and an arrest slower, than the mean speed."""
    smallest_mode: int
    """smallest mode of the edge's roughness; mode 1 is the centre, mode 2 an ellipse."""
    largest_mode: int
    """largest mode of the edge's roughness; default: a quarter of the places."""
    radius: Text
    """radius of the sphere, for the energy release rate, such as "1 mm"."""
    contact_modulus: Text
    """contact modulus E* of both bodies, for the energy release rate, such as "1 MPa"."""
    displacement: Text
    """table of time and displacement of the sphere, for the energy release rate; default: the displacement in the table of the edge."""


class LoopBodies(TypedDict, total=False):
    radius: Text
    """radius of the sphere; fits of loops include a given ±, such as "7.5 um"; default: as the file states."""
    nu: float
    """Poisson ratio of the soft body, from 0 to 0.5; default: 0.5."""
    counter_E: Text
    """Young's modulus of the counter-body, such as "70 GPa"; default: rigid."""
    counter_nu: float
    """Poisson ratio of the counter-body, from 0 to 0.5; default: 0."""
    lens_height: Text
    """height of the soft sphere above the mount; fits are corrected for the finite height, such as "3 ± 0.1 mm"."""
    layer_thickness: Text
    """thickness of a soft layer on a rigid base; fits are corrected for the finite thickness, such as "0.5 mm"."""


class LoopFiles(TypedDict, total=False):
    mapping: Text
    """mapping (TOML) that names the columns of a foreign table: a file or a known name, such as "eoh"."""
    columns: Sequence[str] | str
    """column of a role as ROLE=COLUMN, by name or number from 1, or ROLE=EXPRESSION; roles are force, displacement, contact_radius, time,
    such as "force=-1 * load"; default: guessed from names and units."""
    camera: Text
    """camera record with a separate clock: a table of time and contact_radius, a TIFF stack, an AVI or a folder of pictures."""
    camera_mapping: Text
    """mapping (TOML) of the camera's table."""
    clock_offset: Text
    """time that is added to the camera's times, such as "0.12 s"; default: found from the records."""
    spring_constant: Text
    """spring constant of the cantilever of a force curve, such as "0.05 N/m"."""
    sensitivity: Text
    """deflection sensitivity of the cantilever of a force curve, such as "55 nm/V"."""
    curve_number: int
    """number of one force curve in a file of many, as the file counts them, from 0; default: `setae jkr fit` fits every curve."""
    pixel: Text
    """size of a pixel in the camera's pictures, such as "1.82 um"."""
    frame_rate: float
    """frames per second of the camera."""
    fringes: bool
    """pictures show Newton's rings around the contact; the innermost ring is the edge."""


class LoopModels(TypedDict, total=False):
    models: Sequence[str] | str
    """additional model: hertz, dmt, jkr, maugis_dugdale, transition, layer, large_strain; all compares every model."""
    branch: Text
    """branch of additional models, profile likelihood and common fits; one of loading, unloading."""
    errors: Text
    """treatment of measurement errors in additional models and common fits; one of effective_variance, orthogonal_distance, force_only."""
    model_contact_point: Text
    """contact point that is held fixed in additional models, such as "1.2 um"; default: fitted."""
    cohesive_stress: Text
    """cohesive stress that is held fixed in the model maugis_dugdale, such as "5 MPa"; default: fitted."""
    profile: bool
    """intervals of E* and W by profile likelihood."""
    crack_speed: bool
    """fit of G(v) = G0 (1 + (v/v0)^n) to the edge during retraction."""
    exponent: float
    """exponent n that is held fixed in the fit of G(v); default: fitted."""
    share: Sequence[str] | str
    """quantity that all loops have in common in one fit; modulus, work or both; one of modulus, work."""


class LoopSettings(TypedDict, total=False):
    machine_stiffness: Text
    """stiffness of the testing machine, where the displacement is that of the stage, such as "30 ± 1 N/m"."""
    rigid_contact: Text
    """file of a loop on a rigid body that gives the stiffness of the testing machine."""
    contact_point: Text
    """contact point of force-displacement fits: auto, fit, a method such as jump_in, or a displacement."""
    segments: Sequence[str] | str
    """range of samples or times that replaces a segment found; also cut=400 for cycles, "ignore=30:35 (slip)" for excluded data, such as
    "loading=120:900"."""
    baseline_share: float
    """share of the record, from the start, that is free flight; default: found from the record."""
    drift: Text
    """drift of the force zero in time: auto, none, linear, quadratic, cubic, or extrapolate (only the free flight before contact)."""
    force_zero: Text
    """zero of force for a record without free flight; no drift is removed, such as "0 N"."""
    displacement_drift: Text
    """drift rate of the displacement, where known, such as "0.1 nm/s"."""
    area_ratio: float
    """ratio of true to apparent area of the hard surface, for losses per true area."""
    samples_dropped: int
    """number of samples left out after the jump into contact."""
    relaxation: Sequence[str] | str
    """term SHARE:TIME of the bulk's relaxation E(t)/E∞ = 1 + Σ g e^(−t/τ), which is removed from the force first, such as "0.1:20s"."""
    unweighted: bool
    """ordinary least squares in radius or depth, without errors of force."""
    no_drift: bool
    """constant zero of force, from the free flight before contact: drift none."""
    whole_retraction: bool
    """fit of the retraction from the largest force on, pinned stretch included."""
    retraction_modulus_free: bool
    """E* as a free parameter of the retraction fit (Eq. S2)."""


class MadeSurfaceRequest(TypedDict, total=False):
    pixels: Text
    """points of a surface made from a spectrum, 512 or 1024x512."""
    cell: Text
    """extent of a surface made from a spectrum, such as "2 um"; default: twice the longest wavelength."""
    surface: Text
    """name of the surface in a study from whose spectrum one is made."""
    seed: int
    """seed of the phases of a surface made from a spectrum."""


class PatchSurveyRequest(TypedDict, total=False):
    energy_shares: Sequence[float]
    """ratio U_el/(A W) of stored to gained energy of the patches."""
    points: Sequence[float]
    """number of points along each side of a patch."""
    points_per_wave: Sequence[float]
    """number of points per shortest wavelength."""
    waves_per_side: float
    """number of longest wavelengths along each side of a patch."""
    hurst_exponent: float
    """Hurst exponent of patches, where no study gives the spectrum."""
    squared_ratios: Sequence[float]
    """ratio w dx/(E* ρ²) of the grid, at most 1, which sets the range of the attraction."""
    law: Text
    """decay of the attraction with the gap; one of exponential, cubic, dugdale, lennard_jones."""
    seeds: int
    """number of patches of each kind."""
    seed: int
    """seed of the first patch; further patches use the next numbers."""
    loops: bool
    """whole loops as well, which take minutes instead of seconds."""


class PerssonRequest(TypedDict, total=False):
    contact_modulus: Text
    """contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"."""
    layer: Text
    """thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space."""
    bonded: bool
    """the layer sticks to its base."""
    frictionless: bool
    """the layer slides on its base."""
    nu: float
    """Poisson ratio of the layer, from 0 to 0.5."""
    pressure: Text
    """mean pressure: one, several as 1MPa,10MPa, or ten per decade as 1MPa:100MPa; below 0 with adhesion."""
    energy_factor: float
    """factor of the stored energy of partial contact, in (0, 1]."""
    W_int: Text
    """work of adhesion per unit projected area, such as "50 mJ/m2"; default: none."""


class RadiusRequest(TypedDict, total=False):
    pixel: Text
    """size of a pixel in the camera's pictures, such as "1.82 um"."""
    frame_rate: float
    """frames per second of the camera."""
    fringes: bool
    """pictures show Newton's rings around the contact; the innermost ring is the edge."""
    um_per_px: float
    """size of a pixel in micrometres, such as "1.82"."""
    ignore_stated_pixel_size: bool
    """the given size of a pixel counts, even where a file states another."""
    first: int
    """number of the first frame that is analysed."""
    last: int
    """number of the last frame that is analysed."""
    region: Text
    """part of the frames that is analysed: x,y,width,height in pixels, such as "100,80,320,240"."""
    polarity: Text
    """grey level of the contact relative to the surroundings; one of automatic, dark, bright."""
    smallest_radius: float
    """smallest radius of a contact, in pixels."""
    min_confidence: float
    """smallest confidence of a reported contact, from 0 to 1."""
    exclude: Sequence[float]
    """numbers of frames that are left out, such as "12,17"."""
    reason: Text
    """reason why frames are left out, such as "glare"."""


class ReplicateRequest(TypedDict, total=False):
    quantity: Text
    """quantity that is summarised: W, E*, E_loss, F_po, or the name of a column."""
    group_by: Text
    """columns of the groups, outermost first, such as "surface,lens"; default: surface, lens and spot, as far as the tables have them."""
    crossed: Text
    """group columns whose labels name the same item on every surface, such as a lens pressed on all surfaces."""
    value: Text
    """column of the values, where the name of the quantity does not determine it."""
    error: Text
    """column of the standard errors, where the name of the quantity does not determine it."""
    unit: Text
    """unit of values whose column states none, such as "mJ/m2"."""
    method: Text
    """fit method that is summarised, where tables have several; default: the primary fit, where tables name it."""
    branch: Text
    """branch that is summarised, where tables have several, such as "loading"."""
    elastomer: Text
    """elastomer that is summarised, where tables have several and no groups of elastomers."""
    exclude: Sequence[str] | str
    """rows that are left out, as COLUMN=LABEL with a reason, such as "file=a.csv;reason=dust on the lens"; may be repeated."""
    exclusions: Text
    """file of exclusions: TOML with [[exclude]], or CSV with a column `reason`."""
    each_surface: bool
    """separate variances for each surface, not pooled."""


class ScaleRequest(TypedDict, total=False):
    all: bool
    """unreliable distances, too: those that sampling, tip or resolution distort."""
    binned: bool
    """one measurement is shown in the bins of combined measurements, too."""
    bins_per_decade: int
    """bins per decade of combined functions."""
    weighting: Text
    """weights of measurements that are combined; one of equal, per_instrument, by_count."""
    distance: Text
    """length of the stencil, or several lengths separated by commas, such as "10nm,100nm"; default: ten per decade."""
    order: int
    """order of the derivative: 1 slope, 2 curvature, 3 third derivative."""
    statistic: Text
    """statistic of the derivative; one of rms, variance, mean, skewness, kurtosis, minimum, maximum."""
    along: Text
    """direction of the differences; one of x, y, both."""
    area: bool
    """maps as areas, over all directions or by planes, instead of along scan lines."""
    longest: Text
    """longest distance over an area, needed for maps that are read in bands, such as "5 um"."""
    slope: bool
    """rms slope between points, sqrt(2A)/d, instead of A."""


class Solids(TypedDict, total=False):
    E: Text
    """Young's modulus of the soft solid, such as "0.7 ± 0.02 MPa"."""
    nu: float
    """Poisson ratio of the soft solid, from 0 to 0.5."""
    W_int: Text
    """intrinsic work of adhesion, such as "37 ± 3.7 mJ/m2"."""
    gamma: Text
    """surface energy of the soft solid, such as "25 mJ/m2"."""
    rough_E: Text
    """Young's modulus of the rough solid, such as "70 GPa"; default: a rigid solid."""
    rough_nu: float
    """Poisson ratio of the rough solid, from 0 to 0.5."""
    radius: Text
    """radius of a soft sphere that is pressed on and pulled off, given with the preload, such as "1.25 mm"."""
    preload: Text
    """largest force on the soft sphere, given with the radius, such as "1 mN"."""


class SweepRequest(TypedDict, total=False):
    contact_modulus: Text
    """contact modulus E* = E/(1 - nu^2) of the soft body, such as "1 GPa"."""
    layer: Text
    """thickness of an elastic layer on a rigid base, such as "1 um"; default: a half-space."""
    bonded: bool
    """the layer sticks to its base."""
    frictionless: bool
    """the layer slides on its base."""
    nu: float
    """Poisson ratio of the layer, from 0 to 0.5."""
    W_int: Text
    """work of adhesion per unit area in contact, such as "50 mJ/m2"."""
    range: Text
    """range of the attraction: its greatest tension is the work of adhesion over the range, such as "0.3 nm"."""
    law: Text
    """decay of the attraction with the gap; one of exponential, cubic, dugdale, lennard_jones."""
    stage_stiffness: Text
    """stiffness of the stage that is moved, such as "10 N/m"; default: the mean gap is prescribed."""
    to_gap: Text
    """mean gap, or position of the stage, where the sweep turns, such as "2 nm"; default: 0, full contact."""
    to_pressure: Text
    """mean pressure where the sweep turns, such as "10 kPa"."""
    largest_move: float
    """largest change of any gap per step, in ranges: 2 takes two thirds of the time, works change by up to 1 %."""
    restart: Text
    """file written every 20 steps; where it exists the sweep continues from it, to the same bytes; removed at the end."""


class SynthesisRequest(TypedDict, total=False):
    hurst: float
    """Hurst exponent H of a self-affine spectrum, 0 < H <= 1."""
    rolloff: Text
    """roll-off wavelength, above which the spectrum is flat, such as "2 um"."""
    short_cutoff: Text
    """shortest wavelength of a self-affine spectrum, such as "20 nm"."""
    long_cutoff: Text
    """longest wavelength of a self-affine spectrum, such as "20 um"; default: no limit."""
    rms_height: Text
    """rms height of the spectrum, such as "20 nm"."""
    rms_slope: Text
    """rms slope of the spectrum, such as "0.3"."""
    plateau: Text
    """C_iso at wavelengths longer than the roll-off, such as "5e-27 m4"."""
    spectrum: Text
    """table of q and C_iso [m4] or C1D [m3] instead of a self-affine spectrum."""
    unit: Text
    """units of the columns of a spectrum's table whose header has none, such as "frequency 1/um, one-sided nm3"."""
    pixels: Text
    """points along x and y, 1024x512, or one number for both."""
    size: Text
    """extent of the surface along x and y, or one length for both, such as "5 um x 2 um"."""
    window_of: Text
    """extent of the periodic surface from which a window of the size given is cut, which is not periodic, such as "20 um"."""
    seed: int
    """seed of the random numbers; equal seeds give equal surfaces."""
    line: bool
    """a line on a surface with the spectrum, instead of a map."""
    exact_rms: bool
    """heights are scaled to the rms height of the spectrum, or to the rms height given."""
    amplitudes: Text
    """amplitudes of the modes: random, or exactly those of the spectrum; one of gaussian, exact."""
    stretch: float
    """factor by which features are longer along one direction."""
    angle: float
    """angle between the long direction of stretched features and x in degrees."""
    skewness: float
    """skewness of the heights of a surface, which keeps the spectrum; default: 0."""
    kurtosis: float
    """kurtosis of the heights of a surface, which keeps the spectrum; default: 3, Gaussian."""


class TextureRequest(TypedDict, total=False):
    standard: Text
    """standard of the parameters: of maps (iso25178), or of lines (iso21920; of a map the mean over scan lines); one of iso25178,
    iso21920."""
    only: Text
    """symbols or names of the parameters of a standard that are wanted, such as "Sq, Sdr"; default: all."""
    s_filter: Text
    """nesting index of the Gaussian S-filter (λs), such as "2.5um"."""
    l_filter: Text
    """Gaussian L-filter: "default" for both filters of iso21920 by Ra (ISO 4288), or a nesting index (λc), such as "0.8mm"."""
    section_length: Text
    """length of a section by iso21920, such as "0.8mm"; default: the nesting index of the L-filter, else all."""
    profile: Text
    """profile whose parameters iso21920 gives; default: roughness; one of primary, waviness, roughness."""
    averages: Text
    """averages of iso21920: over the evaluation length (2021), or over sections (ISO 4287:1997); default: evaluation_length; one of
    evaluation_length, sections."""
    mean_line: Text
    """zero of heights in iso21920: the mean, or zero for profiles that an instrument filtered; default: mean; one of mean, zero."""
    between: Text
    """heights between points in the material ratio: linear (triangles), or nothing; default: linear; one of linear, nothing."""
    material_height: Text
    """height c above the mean in Smr(c) and Rmr(c), such as "0.2um"; default: 0."""
    material_ratio: float
    """material ratio p in Smc(p) and Rmc(p), from 0 to 1; default: 0.5, the median."""
