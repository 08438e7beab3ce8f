# SPDX-License-Identifier: GPL-3.0-or-later
# Written by tools/test_order.py.
