// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing: precompiled headers need a target, and a target a source.
