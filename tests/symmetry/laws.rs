//! What must hold between a group of symmetries and the packings it acts on.

use crate::oracle::Problem;
use num_bigint::BigUint;
use std::collections::{BTreeMap, BTreeSet, HashSet};
use tilepack::symmetry::{
    Anchor, Canonizer, ColorMap, Group, Isometry, PointSymmetry, Symmetry, burnside,
    by_canonical_form, expand,
};
use tilepack::tiles::Kind;

/// Checks everything that must hold between a group and a closed list; gives the number of
/// orbits.
pub(crate) fn check_laws(problem: &Problem, group: &Group, packings: &[Vec<u8>]) -> usize {
    let known: HashSet<&[u8]> = packings.iter().map(Vec::as_slice).collect();
    let mut orbits = 0;
    let mut seen = HashSet::new();
    let mut forms = BTreeMap::new();
    for packing in packings {
        if seen.contains(packing) {
            continue;
        }
        let orbit = expand(group, packing);
        assert!(orbit.iter().all(|image| known.contains(image.as_slice())), "{problem:?}");
        assert!(orbit.contains(packing));
        forms.insert(orbit[0].clone(), orbit.len() as u64);
        seen.extend(orbit);
        orbits += 1;
    }
    assert_eq!(seen.len(), packings.len(), "the orbits are disjoint and cover the list");
    assert_eq!(burnside(group, packings), Some(BigUint::from(orbits)), "{problem:?}");

    let by_form = |anchor, pinned: &[&Vec<u8>]| {
        by_canonical_form(group, anchor, pinned.iter().map(|labels| labels.as_slice()))
    };
    let all: Vec<_> = packings.iter().collect();
    assert_eq!(by_form(Anchor::Everywhere, &all), forms, "{problem:?}");
    for anchor in problem.anchors() {
        let is_pinned = |labels: &&Vec<u8>| problem.has_anchor(labels, anchor);
        let pinned: Vec<_> = packings.iter().filter(is_pinned).collect();
        let reduced = by_form(anchor, &pinned);
        assert_eq!(reduced.len() as u64, orbits, "{anchor:?} {problem:?}");
        assert_eq!(reduced.values().sum::<u64>(), packings.len() as u64, "{anchor:?}");
        let mut canonizer = Canonizer::new(group, anchor);
        let mut representatives = BTreeMap::new();
        for labels in &pinned {
            let form = canonizer.canonical(labels);
            let size = canonizer.classify(labels);
            assert_eq!(size.is_some(), form == **labels, "{anchor:?} {problem:?}");
            representatives.extend(size.map(|size| (form, size)));
        }
        assert_eq!(representatives, reduced);
        for (form, &size) in &reduced {
            let orbit = expand(group, form);
            assert_eq!(orbit.len() as u64, size);
            assert_eq!(orbit.iter().find(is_pinned), Some(form));
        }
        if let Some(other) = packings.iter().find(|labels| !is_pinned(labels)) {
            assert!(canonizer.classify(other).is_none(), "not anchored: {anchor:?}");
        }
    }
    orbits as usize
}

/// The axioms of a group, on the elements and on what they do.
pub(crate) fn check_axioms(problem: &Problem, group: &Group, labels: &[u8]) {
    let (lattice, colors) = (problem.lattice(), problem.set.colors());
    let points: Vec<_> = group.points().collect();
    let known: HashSet<_> = points.iter().cloned().collect();
    assert_eq!(known.len(), points.len(), "each once");
    assert_eq!(group.point_count(), points.len());
    assert_eq!(group.elements().count(), points.len() * problem.shape.cells());
    assert_eq!(group.order(), BigUint::from(group.elements().count()));
    assert!(known.contains(&PointSymmetry::identity(colors)));
    let image = |point: &PointSymmetry, labels: &[u8]| {
        Symmetry { point: point.clone(), rows: 0, columns: 0 }.image(lattice, labels)
    };
    for a in &points {
        assert!(known.contains(&a.inverse()));
        assert_eq!(a.then(&a.inverse()), PointSymmetry::identity(colors));
        assert_eq!(image(&a.inverse(), &image(a, labels)), labels);
        for b in points.iter().step_by(1 + points.len() / 50) {
            assert!(known.contains(&a.then(b)), "{a:?} then {b:?}");
            assert_eq!(image(&a.then(b), labels), image(b, &image(a, labels)));
        }
    }
    // Whole elements: an image of an image is an image, and labels and tiles move alike.
    let images: BTreeSet<_> = group.images(labels).collect();
    let direct: BTreeSet<_> = group.elements().map(|g| g.image(lattice, labels)).collect();
    assert_eq!(images, direct);
    for (i, element) in group.elements().enumerate() {
        let moved = element.image(lattice, labels);
        let (shape, kind) = (problem.shape, problem.set.kind());
        let (before, after) = (problem.tiles(labels), problem.tiles(&moved));
        for cell in 0..shape.cells() as u32 {
            let turned = element.point.isometry.cell(lattice, tilepack::torus::Cell(cell));
            let there = shape.step(turned, element.rows as i64, element.columns as i64);
            let tile = element.point.tile(kind, colors, before[cell as usize]);
            assert_eq!(Some(after[there.index()]), tile, "{element:?}");
        }
        if i % (1 + direct.len() / 20) == 0 {
            assert_eq!(group.images(&moved).collect::<BTreeSet<_>>(), images);
        }
    }
}

fn permutations(count: usize) -> Vec<Vec<u8>> {
    let mut all = vec![vec![]];
    for _ in 0..count {
        let longer = |p: Vec<u8>| {
            let rest: Vec<u8> = (0..count as u8).filter(|c| !p.contains(c)).collect();
            rest.into_iter().map(move |c| [p.clone(), vec![c]].concat())
        };
        all = all.into_iter().flat_map(longer).collect();
    }
    all
}

/// All recolorings and isometries that fit the torus.
pub(crate) fn all_points(problem: &Problem) -> Vec<PointSymmetry> {
    let (kind, colors) = (problem.set.kind(), problem.set.colors());
    let square = problem.shape.width() == problem.shape.height();
    let mut points = Vec::new();
    for isometry in Isometry::ALL {
        let turns = square && (kind == Kind::Corner || colors.single().is_some());
        let reverses = isometry == Isometry::IDENTITY || isometry == Isometry::HALF_TURN;
        let fits = if kind == Kind::Domino { reverses } else { turns || !isometry.transposes() };
        if !fits {
            continue;
        }
        for v in permutations(colors.vertical()) {
            let both = if kind == Kind::Wang {
                permutations(colors.horizontal())
            } else {
                vec![v.clone()]
            };
            for h in both {
                let map = ColorMap::new(colors, h, v.clone()).unwrap();
                points.push(PointSymmetry { isometry, map });
            }
        }
    }
    points
}

/// Whether recoloring and moving maps the tiles to the tiles.
pub(crate) fn keeps_set(problem: &Problem, point: &PointSymmetry) -> bool {
    let (kind, colors) = (problem.set.kind(), problem.set.colors());
    problem.set.allowed().all(|tile| problem.set.allows(point.tile(kind, colors, tile).unwrap()))
}

/// What a point does to the colors that occur, for comparing groups that differ in what they do
/// to the others.
pub(crate) fn on_used(problem: &Problem, point: &PointSymmetry) -> (Isometry, Vec<Option<u8>>) {
    let (kind, colors) = (problem.set.kind(), problem.set.colors());
    let tiles: Vec<_> = problem.set.allowed().map(|tile| kind.unpack(tile, colors)).collect();
    let shown = |palette: usize, color: u8| {
        tiles.iter().any(|sides| {
            let count = kind.sides().len();
            (0..count).any(|i| (kind != Kind::Wang || i % 2 == palette) && sides[i] == color)
        })
    };
    let maps = [point.map.horizontal(), point.map.vertical()];
    let images = maps.iter().enumerate().flat_map(|(palette, images)| {
        let images: Vec<_> = (0u8..)
            .zip(images.iter())
            .map(|(color, &image)| shown(palette, color).then_some(image))
            .collect();
        images
    });
    (point.isometry, images.collect())
}

/// The group has every recoloring joined with an isometry that keeps the set, and no other.
pub(crate) fn check_complete(problem: &Problem) {
    let expected: BTreeSet<_> = all_points(problem)
        .iter()
        .filter(|point| keeps_set(problem, point))
        .map(|point| on_used(problem, point))
        .collect();
    let group = problem.group();
    let points: BTreeSet<_> = group.points().map(|point| on_used(problem, &point)).collect();
    assert_eq!(points, expected, "{problem:?}");
    assert_eq!(points.len(), group.point_count(), "each once");
}

/// All that can be said about a problem without an automorphism; gives packings and orbits.
pub(crate) fn check(problem: &Problem) -> (usize, usize) {
    let packings = problem.packings();
    let group = problem.group();
    if !problem.set.is_compact() {
        check_complete(problem);
    }
    if let Some(first) = packings.first() {
        check_axioms(problem, &group, first);
    }
    let orbits = check_laws(problem, &group, &packings);
    let translations = Group::translations(&problem.set, problem.shape);
    check_laws(problem, &translations, &packings);
    check_laws(problem, &group.restricted(|p| p.isometry == Isometry::IDENTITY), &packings);
    check_laws(problem, &group.restricted(|p| p.map.is_identity()), &packings);
    check_laws(
        problem,
        &group.restricted(|p| {
            p.map.vertical()[0] == 0 && p.map.horizontal()[0] == 0 && !p.isometry.transposes()
        }),
        &packings,
    );
    (packings.len(), orbits)
}

/// The packings with an automorphism, their number and that of their orbits; the group is the
/// largest that maps them to each other for algebraic reasons.
pub(crate) fn check_automorphism(
    problem: &Problem,
    packings: &[Vec<u8>],
    text: &str,
) -> (usize, usize) {
    let automorphism = problem.automorphism(text);
    let lattice = problem.lattice();
    let kept: Vec<_> =
        packings.iter().filter(|labels| problem.has(labels, &automorphism)).cloned().collect();
    let group = Group::of(&problem.set, problem.shape, Some(&automorphism)).unwrap();
    let points: HashSet<_> = group.points().collect();

    // g A g^-1 is a power of A: seen on labels as different as the palettes allow.
    let radices = problem.radices();
    let probes: Vec<Vec<u8>> = (1..12usize)
        .map(|k| (0..).zip(&radices).map(|(i, &r)| (i * i * k / 3 + i / 5 * k) as u8 % r).collect())
        .collect();
    let apply = |labels: &[u8], times: usize| {
        let point = PointSymmetry { isometry: Isometry::IDENTITY, map: automorphism.map.clone() };
        let (rows, columns) = (automorphism.dy as usize, automorphism.dx as usize);
        let step = Symmetry { point, rows, columns };
        (0..times).fold(labels.to_vec(), |labels, _| step.image(lattice, &labels))
    };
    let order = automorphism.order(problem.shape);
    for point in problem.group().points() {
        let symmetry =
            Symmetry { point: point.clone(), rows: 1 % problem.shape.height(), columns: 0 };
        let conjugate = |times| {
            probes.iter().all(|probe| {
                symmetry.image(lattice, &apply(probe, 1))
                    == apply(&symmetry.image(lattice, probe), times)
            })
        };
        assert_eq!((0..order).any(conjugate), points.contains(&point), "{text} {point:?}");
    }
    if let Some(first) = kept.first() {
        check_axioms(problem, &group, first);
    }
    (kept.len(), check_laws(problem, &group, &kept))
}
