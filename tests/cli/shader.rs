//! `export --to` a language of shaders: what is written where, and what is refused. Whether compilers
//! take it is for `tests/shaders`.

use crate::{CORNER_2, Place, names};

#[test]
fn shaders_are_written() {
    let place = Place::new();
    place.run("find --kind corner --colors 3 --method construct -o p.json").exits(0);
    for (language, sign) in [
        ("glsl-330", "textureGrad(atlas, "),
        ("glsl-es-300", "precision highp int;"),
        ("hlsl", "atlas.SampleGrad(atlas_sampler, "),
        ("wgsl", "fn ground_sample(tile: vec2i, "),
    ] {
        let args = format!("export p.json --to {language} --name ground");
        let text = place.run(&args).exits(0).stdout;
        assert!(text.contains(sign) && text.contains("ground_texture("), "{text}");
        assert!(text.contains("// table: 16x6 texels"), "{text}");
        assert!(!text.contains("NAME") && !text.contains("CELL"), "{text}");
        let object = place.run(&format!("{args} --json -o out")).exits(0).json();
        assert_eq!(names(&object), ["file", "format", "result"]);
        assert_eq!((&object["format"], place.read("out")), (&language.into(), text));
    }
    let formula = place.run("export p.json --to wgsl --lookup formula").exits(0).stdout;
    assert!(!formula.contains("table"), "{formula}");
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let place = Place::new();
    place.write("p.txt", CORNER_2);
    place.run("find --kind corner --colors 3 --set compact -o compact.json").exits(0);
    place.run("find --kind corner --colors 3 --seed 5 --method construct -o seeded.json").exits(0);
    place.run("find --kind domino --colors 3 -o ring.json").exits(0);
    for (args, expected) in [
        ("compact.json --to wgsl", "this coloring needs the complete set"),
        (
            "compact.json --to wgsl --coloring map:compact.json --lookup formula",
            "only those of complete",
        ),
        ("compact.json --to wgsl --coloring map:p.txt", "colors 2"),
        ("seeded.json --to hlsl --lookup formula", "not the constructed one"),
        ("ring.json --to hlsl", "a ring of dominoes has no square tiles"),
        ("p.txt --to hlsl --name 3d", "name '3d': expected a letter"),
        ("p.txt --to hlsl --coloring halton:40000x40000", "2^30 points"),
        ("p.txt --to hlsl --json", "needs -o FILE"),
        ("p.txt --to hlsl -o no/where", "no/where"),
        ("p.txt --to metal", "glsl-330"),
    ] {
        let refused = place.run(&format!("export {args}")).exits(2);
        assert_eq!(refused.stdout, "", "{args}");
        assert!(refused.stderr.contains(expected), "{args}: {}", refused.stderr);
    }
}
