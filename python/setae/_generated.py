# SPDX-License-Identifier: GPL-3.0-or-later
# Written by tools/python_keywords.py from the library's description of options: change that.
"""Keywords of requests, for type checkers and editors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypedDict

from ._options import Text


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
    realisations: int
    """number of patches of each kind."""
    seed: int
    """seed of the first patch; further patches use the next numbers."""
    loops: bool
    """whole loops as well, which take minutes instead of seconds."""


class RadiusRequest(TypedDict, total=False):
    pixel_size: Text
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
    min_radius: float
    """smallest radius of a contact, in pixels."""
    min_confidence: float
    """smallest confidence of a reported contact, from 0 to 1."""
    exclude: Sequence[float]
    """numbers of frames that are left out, such as "12,17"."""
    reason: Text
    """reason why frames are left out, such as "glare"."""
