# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact experiments: lenses, cameras, recordings, micrographs, force curves, means over replicates."""

from __future__ import annotations

import base64
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Union

from . import _setae
from ._columns import Columns, Named, edge_of
from ._errors import InvalidArgument
from ._given import Given, Source, as_file, saved
from ._loops import Loop, bodies_of, checked_bodies, curve_file, files_of, loop_files
from ._names import renamed
from ._options import Path, Text, filled, named, path, text
from ._quantities import Alert, Quantity, quantity_from
from ._results import Answer, alerts_html, rows_html
from ._scan import Scan

if TYPE_CHECKING:
    from ._columns import Array
    from ._fits import Fitted
    from typing_extensions import Unpack

    from ._generated import RadiusRequest

#: One file or several.
Paths = Union[Path, Sequence[Path]]
#: One file or several, or one table in memory or several.
Sources = Any


def paths(files: Paths) -> list[str]:
    return [path(file) for file in files] if isinstance(files, (list, tuple)) else [path(files)]  # type: ignore[arg-type]


def sources(files: Sources, name: str) -> list[str | Given]:
    """Paths, and tables in memory as files that exist as long as the list."""
    several = isinstance(files, (list, tuple))
    return [as_file(file, f"{name} {number}" if several else name) for number, file in enumerate(files if several else [files], 1)]


class Lens(Answer):
    """Radius and shape of a lens, as printed by ``setae jkr lens --json``."""

    @property
    def radius(self) -> Quantity:
        """Radius of curvature [m] of the circle through its points."""
        found: Quantity = self["radius_of_curvature"]
        return found


@renamed("pixel")
def lens(file: Source, *, x: str | None = None, z: str | None = None, start: Text | None = None, stop: Text | None = None,
         pixel_size: Text | None = None) -> Lens:
    """Radius and asphericity of a lens from a table of two lengths, a profilometer trace, or a picture of its side.

    The table may be in memory: a DataFrame, or a dictionary of arrays, with units as for :func:`loop`; or a line of :func:`scan`.

    Parameters
    ----------
    file : str or path or table
        path of a file, or a table in memory
    x : str, optional
        column of positions along the lens; default: the first column of lengths
    z : str, optional
        column of heights; default: the second column of lengths
    start : str or Quantity, optional
        start of the range along the lens; points before are left out, such as "-0.2 mm"
    stop : str or Quantity, optional
        end of the range along the lens; points beyond are left out, such as "0.2 mm"
    pixel_size : str or Quantity, optional
        size of a pixel in pictures that do not state it, such as "2.05 um"

    Returns
    -------
    Lens
        radius of curvature and asphericity

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import numpy, setae
    >>> x = numpy.linspace(-0.2e-3, 0.2e-3, 81)
    >>> lens = setae.lens({"x [m]": x, "z [m]": numpy.sqrt(1e-3**2 - x**2)})
    >>> round(float(lens.radius), 9)
    0.001
    """
    profile = as_file(line_of(file) if isinstance(file, Scan) else file, "lens")
    return Lens(_setae.lens(path(profile), filled(_setae.LensRequest(), x=x, z=z, start=start, stop=stop, pixel_size=pixel_size)))


def line_of(scan: Scan) -> dict[str, Any]:
    """Positions and heights of a line."""
    if scan.heights.ndim != 1:
        raise InvalidArgument("a map; expected a line, such as scan.heights[:, 0] with size or x")
    coordinate = scan.to_xarray()
    return {"x [m]": coordinate.x.data, "z [m]": coordinate.data}


class Camera(Answer):
    """Scale of a camera, as printed by ``setae jkr camera --json``."""

    @property
    def pixel_size(self) -> Quantity:
        """Pixel size [m] at the centre of the picture."""
        found: Quantity = self["pixel_size"]
        return found


def camera(pictures: Paths, pitch: Text) -> Camera:
    """Pixel size and distortion from pictures of a ruling.

    Parameters
    ----------
    pictures : str or path or Sequence[str or path]
        pictures of a ruling
    pitch : str or Quantity
        distance of the lines of the ruling, such as '10 um' or '10 ± 0.02 um'

    Returns
    -------
    Camera
        pixel size and distortion

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import setae
    >>> f"{float(setae.camera('ruling_upright.png', pitch='10 um').pixel_size):.4g} m"
    '1.25e-06 m'
    """
    return Camera(_setae.camera_scale(paths(pictures), text(pitch, "pitch")))


@dataclass(frozen=True, eq=False, repr=False)
class Recording(Columns):
    """Results of a recording, one row per frame."""

    handle: Any = field(default=None, repr=False)  #: object that writes the table: of the library, or its content in another process

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "handle": saved(self.handle.save, "recording.csv")}

    @property
    def alerts(self) -> tuple[Alert, ...]:
        """Always empty; notes on the recording are in ``data["notes"]``."""
        return ()

    def save(self, file: Path) -> None:
        """Writes the results as a table."""
        self.handle.save(path(file))


class ContactRadii(Recording):
    """Contact radii of a recording, one row per frame; ``save("radius.csv")`` writes a table for ``loop(…, camera=…)``."""

    @property
    def n(self) -> int:
        """Number of frames with a contact radius."""
        return int(self._data["summary"]["measured"])

    def __repr__(self) -> str:
        return f"ContactRadii({len(self['time'])} frames, {self.n} measured)"

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the contact radius against time on axes of matplotlib."""
        from ._plot import plot_columns

        return plot_columns(self, "time", ["contact_radius"], ax, **style)


@renamed("pixel", "smallest_radius")
def contact_radii(
    frames: Paths,
    *,
    pixel_size: Text | None = None,
    frame_rate: float | None = None,
    first: int | None = None,
    last: int | None = None,
    region: str | None = None,
    polarity: str = "automatic",
    fringes: bool = False,
    min_radius: float | None = None,
    min_confidence: float | None = None,
    exclude: Sequence[int] = (),
    reason: str | None = None,
    ignore_stated_pixel_size: bool = False,
) -> ContactRadii:
    """Contact radius in every frame of a recording: a TIFF stack, an AVI, a folder of pictures, or pictures.

    Parameters
    ----------
    frames : str or path or Sequence[str or path]
        TIFF stack, AVI, folder of pictures, or pictures
    pixel_size : str or Quantity, optional
        size of a pixel in the camera's pictures, such as "1.82 um"
    frame_rate : float, optional
        frames per second of the camera
    first : int, optional
        number of the first frame that is analysed
    last : int, optional
        number of the last frame that is analysed
    region : str, optional
        part of the frames that is analysed: x,y,width,height in pixels, such as "100,80,320,240"
    polarity : str, default 'automatic'
        grey level of the contact relative to the surroundings; one of automatic, dark, bright
    fringes : bool, default False
        pictures show Newton's rings around the contact; the innermost ring is the edge
    min_radius : float, optional
        smallest radius of a contact, in pixels
    min_confidence : float, optional
        smallest confidence of a reported contact, from 0 to 1
    exclude : Sequence[int], default ()
        numbers of frames that are left out, such as "12,17"
    reason : str, optional
        reason why frames are left out, such as "glare"
    ignore_stated_pixel_size : bool, default False
        the given size of a pixel counts, even where a file states another

    Returns
    -------
    ContactRadii
        one row per frame, with the contact radius and its error

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import setae
    >>> radii = setae.contact_radii("frames", pixel_size="2 um", frame_rate=10)
    >>> radii, radii.units["contact_radius"]
    (ContactRadii(5 frames, 4 measured), 'm')
    """
    request = filled(
        _setae.RadiusRequest(),
        pixel_size=pixel_size,
        frame_rate=frame_rate,
        first=first,
        last=last,
        region=region,
        polarity=polarity,
        fringes=fringes,
        min_radius=min_radius,
        min_confidence=min_confidence,
        exclude=list(exclude),
        reason=reason,
        ignore_stated_pixel_size=ignore_stated_pixel_size,
    )
    found = _setae.contact_radii(paths(frames), request)
    return ContactRadii(found.columns, found.units, found.json, found)


@dataclass(frozen=True, eq=False, repr=False)
class ContactLine(Recording):
    """The edge of a contact, as printed by ``setae jkr line --json``, one row per frame; ``edge``: "time", "frame", "radius_1" … at every angle [m].

    ``save("edge.csv")`` writes a table for :func:`contact_line`.
    """

    edge: Named = field(default_factory=lambda: edge_of({}), repr=False)

    @property
    def n(self) -> int:
        """Number of frames."""
        return len(self["time"])

    @property
    def roughness_exponent(self) -> Quantity | None:
        """ζ of ⟨|r_n|²⟩ ∝ n^−(1 + 2ζ); None for too few frames or places."""
        roughness = self._data["roughness"]
        return None if roughness is None else quantity_from(roughness["exponent"], self._shared)

    def __repr__(self) -> str:
        return f"ContactLine({self.n} frames, {self.data['angles']} places each)"

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Plots the mean radius of the edge against time on axes of matplotlib."""
        from ._plot import plot_columns

        return plot_columns(self, "time", ["mean_radius"], ax, **style)


def recorded_edge(frames: Sources) -> Sources:
    """The recorded edge of a result, with its header as far as it is known; other frames as they are."""
    if getattr(frames, "handle", None) is not None and hasattr(frames, "edge"):
        return saved(getattr(frames, "save_edge", None) or frames.save, "edge.csv")
    return getattr(frames, "edge", frames)


@renamed("pixel", "smallest_radius", "smallest_void", "smallest_mode", "largest_mode")
def contact_line(
    frames: Sources,
    *,
    angles: int | None = None,
    min_void_area: float = 16.0,
    ring_width: Text | None = None,
    threshold: float = 3.0,
    min_mode: int = 3,
    max_mode: int = 0,
    radius: Text | None = None,
    contact_modulus: Text | None = None,
    displacement: Source | None = None,
    **recording: Unpack[RadiusRequest],
) -> ContactLine:
    """Roughness and motion of the edge of a contact: roughness exponent, speeds, jumps, arrests, voids inside.

    Frames are a recording as for :func:`contact_radii`, whose keywords are accepted too, or a table, of ``save()`` or a simulation, with columns
    "time", "radius_1" … "radius_N"; or in memory the result of :func:`contact_line` or :func:`contact_front`, or such a table. With radius and
    contact_modulus the result has "release_rate", the energy release rate of the edge.

    Parameters
    ----------
    frames : str or path or table or a list of them
        recording as for `contact_radii`, a table of the edge, or a result with an edge
    angles : int, optional
        number of places along the edge; default: one every 2 px of the largest contact
    min_void_area : float, default 16.0
        smallest area of a reported void, in px^2
    ring_width : str or Quantity, optional
        width of the rings whose cells have a speed each, such as "5 um"; default: the step of the edge from frame to frame
    threshold : float, default 3.0
        factor by which a jump is faster, and an arrest slower, than the mean speed
    min_mode : int, default 3
        smallest mode of the edge's roughness; mode 1 is the centre, mode 2 an ellipse
    max_mode : int, default 0
        largest mode of the edge's roughness; default: a quarter of the places
    radius : str or Quantity, optional
        radius of the sphere, for the energy release rate, such as "1 mm"
    contact_modulus : str or Quantity, optional
        contact modulus E* of both bodies, for the energy release rate, such as "1 MPa"
    displacement : str or path or table, optional
        table of time and displacement of the sphere, for the energy release rate; default: the displacement in the table of the edge
    pixel_size : str or Quantity, optional
        size of a pixel in the camera's pictures, such as "1.82 um"
    frame_rate : float, optional
        frames per second of the camera
    fringes : bool, default False
        pictures show Newton's rings around the contact; the innermost ring is the edge
    um_per_px : float, optional
        size of a pixel in micrometres, such as "1.82"
    ignore_stated_pixel_size : bool, default False
        the given size of a pixel counts, even where a file states another
    first : int, optional
        number of the first frame that is analysed
    last : int, optional
        number of the last frame that is analysed
    region : str or Quantity, optional
        part of the frames that is analysed: x,y,width,height in pixels, such as "100,80,320,240"
    polarity : str or Quantity, default 'automatic'
        grey level of the contact relative to the surroundings; one of automatic, dark, bright
    min_radius : float, default 5.0
        smallest radius of a contact, in pixels
    min_confidence : float, default 0.5
        smallest confidence of a reported contact, from 0 to 1
    exclude : Sequence[float], optional
        numbers of frames that are left out, such as "12,17"
    reason : str or Quantity, optional
        reason why frames are left out, such as "glare"

    Returns
    -------
    ContactLine
        one row per frame, with roughness and motion of the edge

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import setae
    >>> setae.contact_line("frames", pixel_size="2 um", frame_rate=10, angles=64)
    ContactLine(2 frames, 64 places each)
    """
    recorded = sources(recorded_edge(frames), "edge.csv")
    moved = None if displacement is None else as_file(displacement, "displacement")
    request = filled(
        _setae.LineRequest(),
        radius=radius,
        contact_modulus=contact_modulus,
        displacement=None if moved is None else path(moved),
        angles=angles,
        min_void_area=min_void_area,
        ring_width=ring_width,
        threshold=threshold,
        min_mode=min_mode,
        max_mode=max_mode,
        **recording,
    )
    found: Any = _setae.contact_line(list(map(path, recorded)), request)
    return ContactLine(found.columns, found.units, found.json, found, edge_of(found.edge))


@dataclass(frozen=True, repr=False)
class Contour(Answer):
    """The contour in a micrograph, as printed by ``setae contour --json``; ``profiles`` are texts of profile files, the longest first."""

    tables = ("segments",)

    profiles: tuple[str, ...] = field(default=(), compare=False)
    overlay: bytes = field(default=b"", compare=False)  #: the picture with the edge drawn in, PNG

    def save(self, file: Path, segment: int = 0) -> None:
        """Writes a profile as a file for :func:`read`."""
        with open(file, "w", encoding="utf-8") as written:
            written.write(self.profiles[segment])

    def _repr_png_(self) -> bytes:
        return self.overlay

    def _repr_html_(self) -> str:
        picture = base64.b64encode(self.overlay).decode()
        return f"<img src='data:image/png;base64,{picture}'>{rows_html(self._data['segments'])}{alerts_html(self.alerts)}"


#: Points (x, y) in pixels, one file of them, or an earlier trace.
Anchors = Union[Path, Contour, Sequence[Sequence[float]]]


def anchors_file(anchors: Anchors | None) -> str | Given:
    """A file of anchors for the library; empty without anchors."""
    if anchors is None:
        return ""
    if isinstance(anchors, Contour):
        return Given("trace.json", anchors.json().encode())
    if isinstance(anchors, (str, os.PathLike)):
        return os.fspath(anchors)
    points = [list(map(float, point)) for point in anchors]
    return Given("anchors.json", json.dumps({"anchors": points}).encode())


@renamed("pixel", "least_length")
def contour(
    picture: Path,
    *,
    pixel_size: Text | None = None,
    scale_bar: Text | None = None,
    calibration: Path | None = None,
    vacuum: str = "automatic",
    shape: str = "envelope",
    foil_thickness: Text | None = None,
    hidden: Sequence[str] = (),
    whole_picture: bool = False,
    smoothing: float | None = None,
    denoise: float = 0.0,
    min_length: float | None = None,
    image: int | str | None = None,
    ignore_stated_pixel_size: bool = False,
    anchors: Anchors | None = None,
) -> Contour:
    """The profile of a sample in a picture of its side: DM3, DM4, TIFF, PNG, JPEG, SER, EMD or MRC.

    The scale is that of the file, or one of pixel_size, scale_bar and calibration is given.

    Parameters
    ----------
    picture : str or path
        picture of the side of a sample: DM3, DM4, TIFF, PNG, JPEG, SER, EMD or MRC
    pixel_size : str or Quantity, optional
        size of a pixel, or width and height as '1 nm x 0.2 nm', such as '0.055 nm'; default: that of the file
    scale_bar : str or Quantity, optional
        length that the scale bar in the picture stands for, such as '500 nm'
    calibration : str or path, optional
        file of a calibration that was saved from another picture
    vacuum : str, default 'automatic'
        side of the picture that is vacuum, by grey level; one of automatic, bright, dark
    shape : str, default 'envelope'
        profile where the contour turns back: the highest point over each x, a cut, or the curve itself; one of envelope, cut,
        parametric
    foil_thickness : str or Quantity, optional
        thickness of the sample along the beam, such as '20 nm'
    hidden : Sequence[str], default ()
        parts of the picture without sample, as 'x,y,width,height' in pixels
    whole_picture : bool, default False
        scale bars and text that are found are not hidden
    smoothing : float, optional
        length of the smoothing spline in pixels; default: that of the smallest expected error
    denoise : float, default 0.0
        standard deviation in pixels of a Gaussian that smooths the picture first
    min_length : float, optional
        shortest length in pixels of a segment that is kept; default: 50, of masks 0
    image : int or str, optional
        number, counted from 0, or title of an image in a file of several; default: the first that is no spectrum and no Fourier
        transform
    ignore_stated_pixel_size : bool, default False
        pixel size or scale bar given hold even where the file contradicts them
    anchors : sequence of (x, y), Contour or path, optional
        points (x, y) in pixels that the trace passes, or a file of them; or an earlier trace, or its JSON file, which is repeated with
        its own options

    Returns
    -------
    Contour
        profiles with standard errors, the longest first, and the picture with the edge drawn in

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import setae
    >>> traced = setae.contour("wave.png", pixel_size="0.1 nm")
    >>> setae.power_spectrum(traced, instrument="tem").units["C1D"]
    'm3'
    """
    points = anchors_file(anchors)
    request = filled(
        _setae.ContourRequest(),
        pixel_size=pixel_size,
        scale_bar=scale_bar,
        calibration=None if calibration is None else path(calibration),
        vacuum=vacuum,
        shape=shape,
        foil_thickness=foil_thickness,
        hidden=list(hidden),
        whole_picture=whole_picture,
        smoothing=smoothing,
        denoise=denoise,
        min_length=min_length,
        image=named(image),
        ignore_stated_pixel_size=ignore_stated_pixel_size,
    )
    traced = _setae.contour(path(picture), request, path(points) if points else "")
    return Contour(traced.json(), tuple(traced.profile(i) for i in range(traced.segments)), traced.overlay())


@dataclass(frozen=True, repr=False)
class ForceCurves(Answer):
    """Fits of a force curve ("segments", "summary"), or of every curve of a file ("curves"), as printed by ``setae jkr fit --json``."""

    tables = ("curves", "segments")

    samples: Mapping[str, Mapping[str, Any]] = field(default_factory=dict, compare=False)  #: columns of each fitted segment of one curve

    def points(self, segment: str | None = None) -> Fitted:
        """The fitted samples of a segment, "approach" or "retract", with the model; default: the segment whose fit is the result."""
        from ._fits import curve_of_segment

        if not self.samples:
            raise InvalidArgument("no points of a single curve; expected the fit of one curve, such as force_curves(…, curve_number=0)")
        chosen = segment or self._data["summary"]["fitted_segment"]
        if chosen not in self.samples:
            raise InvalidArgument(f"segment: '{chosen}'; expected one of {', '.join(self.samples)}")
        return curve_of_segment(self.samples[chosen])

    @property
    def best_fit(self) -> Array:
        """Force of the model [N] at the fitted samples of the segment whose fit is the result."""
        return self.points().best_fit

    @property
    def residuals(self) -> Array:
        """Measured minus fitted force [N]."""
        return self.points().residuals

    def plot(self, ax: Any = None, *, segment: str | None = None, **style: Any) -> Any:
        """Plots a segment and its fit on axes of matplotlib, with a panel of residuals; ``style``: keywords of matplotlib for the points."""
        return self.points(segment).plot(ax, **style)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """Results of one curve; none for a file of many."""
        return self._entry("summary").quantities if "summary" in self._data else ()


@renamed("nu", "counter_E", "counter_nu")
def force_curves(
    file: Source | Loop,
    *,
    units: Mapping[str, str] | None = None,
    radius: Text | None = None,
    tip: str = "paraboloid",
    half_angle: float = 0.0,
    model: str = "hertz",
    fit_range: str | None = None,
    contact_point: Text = "fit",
    keep_baseline_slope: bool = False,
    poisson_ratio: float | None = None,
    counter_youngs_modulus: Text | None = None,
    counter_poisson_ratio: float | None = None,
    mapping: str | None = None,
    spring_constant: Text | None = None,
    sensitivity: Text | None = None,
    curve_number: int | None = None,
) -> ForceCurves:
    """Fits of force curves (force and displacement). The contact begins where the force leaves the baseline.

    A curve may be a table in memory with columns of force and displacement, as for :func:`loop`.

    Parameters
    ----------
    file : str or path or table or Loop
        path of a file, or a table in memory
    units : Mapping[str, str], optional
        units of columns of a table in memory, where neither names nor attributes state them, such as {'force': 'mN'}
    radius : str or Quantity, optional
        radius of the sphere; fits of loops include a given ±, such as "7.5 um"; default: as the file states
    tip : str, default 'paraboloid'
        shape of the tip of a force curve; one of paraboloid, cone, three_sided_pyramid
    half_angle : float, default 0.0
        half angle of a conical tip, or inclination of a pyramid's faces, in degrees
    model : str, default 'hertz'
        contact model of a force curve: hertz, dmt, jkr, maugis_dugdale or large_strain
    fit_range : str, optional
        range of a force curve that is fitted, FROM:TO in indentation, force or shares of the largest indentation, such as "0 nm:500
        nm"; default: -1:1
    contact_point : str or Quantity, default 'fit'
        contact point of a force curve: fit, found (where the force leaves the baseline), or a length
    keep_baseline_slope : bool, default False
        only the mean of free flight is removed from a force curve, not the slope
    poisson_ratio : float, optional
        Poisson ratio of the soft body, from 0 to 0.5; default: 0.5
    counter_youngs_modulus : str or Quantity, optional
        Young's modulus of the counter-body, such as "70 GPa"; default: rigid
    counter_poisson_ratio : float, optional
        Poisson ratio of the counter-body, from 0 to 0.5; default: 0
    mapping : str, optional
        mapping (TOML) that names the columns of a foreign table: a file or a known name, such as "eoh"
    spring_constant : str or Quantity, optional
        spring constant of the cantilever of a force curve, such as "0.05 N/m"
    sensitivity : str or Quantity, optional
        deflection sensitivity of the cantilever of a force curve, such as "55 nm/V"
    curve_number : int, optional
        number of one force curve in a file of many, as the file counts them, from 0; default: `setae jkr fit` fits every curve

    Returns
    -------
    ForceCurves
        fits of one curve, or of every curve of a file

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import numpy, setae
    >>> depth = numpy.linspace(-1e-6, 0.5e-6, 300)
    >>> force = setae.models.hertz(depth, radius=5e-6, contact_modulus=10e3, zero_outside=True)
    >>> fit = setae.force_curves({"force [N]": force, "displacement [m]": depth}, radius="5 um", poisson_ratio=0.5)
    >>> round(float(fit["summary"]["contact_modulus"]) / 10e3, 2)
    1.0
    """
    files = files_of(mapping=mapping, spring_constant=spring_constant, sensitivity=sensitivity, curve_number=curve_number)
    bodies = bodies_of(radius=radius, poisson_ratio=poisson_ratio, counter_youngs_modulus=counter_youngs_modulus,
                       counter_poisson_ratio=counter_poisson_ratio)
    request = filled(
        _setae.CurveRequest(),
        tip=tip,
        half_angle=half_angle,
        model=model,
        fit_range=fit_range,
        contact_point=contact_point,
        keep_baseline_slope=keep_baseline_slope,
    )
    curve = curve_file(file, "curve", units)
    fitted = _setae.fit_force_curves(path(curve), loop_files(files), checked_bodies(bodies), request)
    return ForceCurves(fitted.json, fitted.segments)


class Replicates(Answer):
    """Means over surfaces, lenses, spots and repeats, as printed by ``setae jkr summary --json``."""

    tables = ("surfaces",)


def replicates(
    files: Sources,
    *,
    quantity: str = "W",
    group_by: Sequence[str] = (),
    crossed: Sequence[str] = (),
    value: str | None = None,
    error: str | None = None,
    unit: str | None = None,
    method: str | None = None,
    branch: str | None = None,
    elastomer: str | None = None,
    exclude: Sequence[str] = (),
    exclusions: Path | None = None,
    each_surface: bool = False,
) -> Replicates:
    """Means of tables with one row per fit: y = mean of the surface + b(lens) + b(spot) + b(repeat) + error of the fit.

    Tables are files, or in memory, such as DataFrames. Quantities are "W", "E*", "E_loss", "F_po" or a column. Exclusions
    are texts such as "file=a.csv;reason=dust on the lens".

    Parameters
    ----------
    files : str or path or table or a list of them
        tables with one row per fit
    quantity : str, default 'W'
        quantity that is summarised: W, E*, E_loss, F_po, or the name of a column
    group_by : Sequence[str], default ()
        columns of the groups, outermost first, such as "surface,lens"; default: surface, lens and spot, as far as the tables have them
    crossed : Sequence[str], default ()
        group columns whose labels name the same item on every surface, such as a lens pressed on all surfaces
    value : str, optional
        column of the values, where the name of the quantity does not determine it
    error : str, optional
        column of the standard errors, where the name of the quantity does not determine it
    unit : str, optional
        unit of values whose column states none, such as "mJ/m2"
    method : str, optional
        fit method that is summarised, where tables have several; default: the primary fit, where tables name it
    branch : str, optional
        branch that is summarised, where tables have several, such as "loading"
    elastomer : str, optional
        elastomer that is summarised, where tables have several and no groups of elastomers
    exclude : Sequence[str], default ()
        rows that are left out, as COLUMN=LABEL with a reason, such as "file=a.csv;reason=dust on the lens"; may be repeated
    exclusions : str or path, optional
        file of exclusions: TOML with [[exclude]], or CSV with a column `reason`
    each_surface : bool, default False
        separate variances for each surface, not pooled

    Returns
    -------
    Replicates
        means of the groups and their variances

    Raises
    ------
    FileError
        for a path that cannot be read
    FormatError
        for content of an unknown format, or damaged content
    InvalidArgument
        for a value outside its domain, with another dimension or without its unit

    Examples
    --------
    >>> import setae
    >>> fits = {"surface": ["A", "A", "B", "B"], "lens": ["1", "2", "1", "2"], "W [mJ/m2]": [40.0, 42.0, 30.0, 33.0],
    ...         "W standard_error [mJ/m2]": [1.0, 1.0, 1.0, 1.0]}
    >>> found = setae.replicates(fits, group_by=["surface", "lens"])
    >>> [entry["surface"] for entry in found["surfaces"]]
    ['A', 'B']
    """
    tables = sources(files, "fits")
    request = filled(
        _setae.ReplicateRequest(),
        files=list(map(path, tables)),
        quantity=quantity,
        value=value,
        error=error,
        unit=unit,
        method=method,
        branch=branch,
        elastomer=elastomer,
        group_by=",".join(group_by),
        crossed=",".join(crossed),
        exclude=list(exclude),
        exclusions=None if exclusions is None else path(exclusions),
        each_surface=each_surface,
    )
    return Replicates(_setae.replicates(request))
