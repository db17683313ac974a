"""Checks every encoding of every peer on problems so small that all labels can be tried.

The number of packings is found by trying, with nothing but `check` of the problem, which is the
definition. `table.py --check` runs this; it takes about a minute.
"""

from itertools import product

from problem import TINY


def tried(problem):
    """The number of packings among all labels."""
    fixed = problem.fixed()
    choices = [[fixed[v]] if v in fixed else range(problem.colors) for v in range(problem.labels())]
    return sum(map(problem.check, product(*choices)))


def check(peers, answer):
    """Compares `answer(name, peer, encoding)`, a number or why there is none; whether all agree."""
    good = True
    print("\n| tiny problem | packings, tried | peers that differ |\n|---|---|---|")
    for name, problem in TINY.items():
        expected = tried(problem)
        asked = {f"{peer} {how}": answer(name, peer, how) for peer, (_, hows) in peers.items() for how in hows}
        wrong = [f"{who}: {found}" for who, found in asked.items() if found != expected]
        good = good and not wrong
        print(f"| {name} | {expected} | {'; '.join(wrong) or f'none of {len(asked)}'} |", flush=True)
    return good
