# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes expected.json: mixed models of replicates by statsmodels, PyMARE and a dense likelihood of its own.

python3 -m venv /tmp/venv && /tmp/venv/bin/pip install statsmodels==0.15.0 pymare==0.0.13 && /tmp/venv/bin/python origin.py
"""
import json, pathlib
import numpy as np
import pandas as pd
import statsmodels.formula.api as smf
from pymare.estimators import VarianceBasedLikelihoodEstimator
from scipy.optimize import minimize

rng = np.random.default_rng(20260721)


def rows(surfaces, lenses, spots, repeats, errors):
    """Unbalanced: some spots and repeats are missing."""
    out = []
    for s in range(surfaces):
        for l in range(lenses[s]):
            lens = rng.normal(0, 3.0)
            for p in range(spots - (l % 2)):
                spot = rng.normal(0, 2.0)
                for r in range(repeats + (p % 2) - (s % 2)):
                    error = errors() if errors else float("nan")
                    value = 40.0 + 9.0 * s + lens + spot + rng.normal(0, 1.5) + (rng.normal(0, error) if errors else 0.0)
                    out.append((f"S{s}", f"L{l}", f"P{p}", round(value, 4), round(error, 4)))
    return pd.DataFrame(out, columns=["surface", "lens", "spot", "value", "standard_error"])


def dense(table, levels, start):
    """REML over ln of the variances with dense matrices; known variances on the diagonal."""
    X = np.stack([(table.surface == s).to_numpy(float) for s in table.surface.unique()], axis=1)
    y, known = table.value.to_numpy(), np.nan_to_num(table.standard_error.to_numpy()) ** 2
    same = [np.ones((len(y), len(y)), bool)]
    for name in ["surface", "lens", "spot"]:
        labels = table[name].to_numpy()
        same.append(same[-1] & (labels[:, None] == labels[None, :]))
    blocks = [m.astype(float) for m in same[2:]] + [np.eye(len(y))]
    blocks = [blocks[k] for k in levels]

    def parts(theta):
        V = np.diag(known) + sum(t * b for t, b in zip(theta, blocks))
        inverse = np.linalg.inv(V)
        information = X.T @ inverse @ X
        beta = np.linalg.solve(information, X.T @ inverse @ y)
        rest = y - X @ beta
        value = -0.5 * (np.linalg.slogdet(V)[1] + np.linalg.slogdet(information)[1] + rest @ inverse @ rest)
        return value, beta, np.sqrt(np.diag(np.linalg.inv(information)))

    best = min((minimize(lambda x: -parts(np.exp(x))[0], np.log(s), method="Nelder-Mead",
                         options=dict(xatol=1e-11, fatol=1e-13, maxiter=40000, maxfev=40000)) for s in start), key=lambda r: r.fun)
    value, beta, error = parts(np.exp(best.x))
    return dict(variances=np.exp(best.x).tolist(), means=beta.tolist(), standard_errors=error.tolist(), log_likelihood=value)


def as_rows(table):
    return [[r.surface, r.lens, r.spot, r.value, None if np.isnan(r.standard_error) else r.standard_error] for r in table.itertuples()]


cases = {}

plain = rows(2, [5, 6], 4, 2, None)
model = smf.mixedlm("value ~ 0 + C(surface)", plain.assign(lens=plain.surface + plain.lens), groups="lens", re_formula="1",
                    vc_formula={"spot": "0 + C(spot)"}).fit(reml=True, method=["bfgs", "nm", "bfgs"], maxiter=5000)
cases["statsmodels"] = dict(rows=as_rows(plain), variances=[float(model.cov_re.iloc[0, 0]), float(model.vcomp[0]), float(model.scale)],
                            means=model.fe_params.tolist(), standard_errors=model.bse_fe.tolist())

uneven = rows(2, [4, 5], 4, 3, lambda: rng.uniform(0.3, 3.0))
cases["dense"] = dict(rows=as_rows(uneven)) | dense(uneven, [0, 1, 2], [[9, 4, 2], [1, 1, 1], [0.1, 5, 5]])

simple = rows(1, [1], 1, 12, lambda: rng.uniform(0.5, 4.0))
pymare = VarianceBasedLikelihoodEstimator(method="REML").fit(y=simple.value.to_numpy()[:, None], v=simple.standard_error.to_numpy()[:, None] ** 2,
                                                            X=np.ones((len(simple), 1))).summary()
cases["pymare"] = dict(rows=as_rows(simple), variances=[float(np.ravel(pymare.tau2)[0])], means=np.ravel(pymare.get_fe_stats()["est"]).tolist())
cases["pymare"]["dense_variance"] = dense(simple, [2], [[1.0], [10.0]])["variances"][0]

pathlib.Path(__file__).with_name("expected.json").write_text(json.dumps(cases, indent=1))
for name, case in cases.items():
    print(name, {k: v for k, v in case.items() if k != "rows"}, len(case["rows"]))
