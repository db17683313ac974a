//! Every shader is accepted by a compiler of its language: WGSL by naga, the others by glslang,
//! whose SPIR-V is checked too.

use crate::{Case, tools};
use naga::front::wgsl;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use std::fs;
use std::path::Path;
use std::process::Command;
use tilepack::atlas::shader::{Language, MapTexture, Shader};
use tilepack::tiles::Kind;
use tilepack::tiling::Coloring;

/// The text of a shader with a function around it that calls it as its head says.
fn whole(case: &Case, language: Language) -> String {
    let text = Shader::new(language, &case.tiling, &case.cells, "my").unwrap().text();
    let call = text.lines().find_map(|line| line.strip_prefix("// color = ")).unwrap();
    assert!(call.starts_with("my_texture(position, "), "{call}");
    let two = MapTexture::of(&case.tiling).is_some_and(|map| map.channels == 2);
    match language {
        Language::Glsl330 | Language::GlslEs300 => {
            let version = if language == Language::Glsl330 { "330 core" } else { "300 es" };
            format!(
                "#version {version}\n{text}\nuniform sampler2D atlas;\nuniform usampler2D table;\n\
                 uniform usampler2D map;\nin vec2 position;\nout vec4 color;\n\
                 void main() {{\n    color = {call};\n}}\n"
            )
        }
        Language::Hlsl => {
            let texel = if two { "uint2" } else { "uint" };
            format!(
                "{text}\nTexture2D<float4> atlas : register(t0);\n\
                 Texture2D<uint> table : register(t1);\nTexture2D<{texel}> map : register(t2);\n\
                 SamplerState atlas_sampler : register(s0);\n\
                 float4 main(float2 position : TEXCOORD0) : SV_Target0 {{\n    return {call};\n}}\n"
            )
        }
        Language::Wgsl => format!(
            "{text}\n@group(0) @binding(0) var atlas: texture_2d<f32>;\n\
             @group(0) @binding(1) var atlas_sampler: sampler;\n\
             @group(0) @binding(2) var table: texture_2d<u32>;\n\
             @group(0) @binding(3) var map: texture_2d<u32>;\n\
             @fragment fn main(@location(0) position: vec2f) -> @location(0) vec4f {{\n    \
             return {call};\n}}\n"
        ),
    }
}

#[test]
fn naga_accepts_wgsl() {
    for case in Case::all() {
        let text = whole(&case, Language::Wgsl);
        let module = wgsl::parse_str(&text)
            .unwrap_or_else(|error| panic!("{}: {}", case.name, error.emit_to_string(&text)));
        let validated =
            Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
        assert!(validated.is_ok(), "{}: {validated:?}\n{text}", case.name);
    }
}

#[test]
fn glslang_accepts_glsl_es() {
    let Some(glslang) = tools::find("glslangValidator") else { return };
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(glslang);
    for (at, case) in Case::all().iter().enumerate() {
        let file = folder.path().join(format!("{at}.frag"));
        fs::write(&file, whole(case, Language::GlslEs300)).unwrap();
        command.arg(file);
    }
    tools::run(&mut command, "GLSL ES 3.00");
}

#[test]
fn glslang_accepts_glsl_and_its_code_is_valid() {
    // As OpenGL has it, with places found for what has none.
    compiled(Language::Glsl330, &["-G", "--aml", "--amb"], "opengl4.5");
}

#[test]
fn glslang_accepts_hlsl_and_its_code_is_valid() {
    compiled(Language::Hlsl, &["-D", "-V", "-e", "main"], "vulkan1.0");
}

fn compiled(language: Language, options: &[&str], environment: &str) {
    let Some(glslang) = tools::find("glslangValidator") else { return };
    let spirv_val = tools::find("spirv-val");
    let folder = tempfile::tempdir().unwrap();
    let code = folder.path().join("code.spv");
    for case in Case::all() {
        let file = folder.path().join("shader.frag");
        fs::write(&file, whole(&case, language)).unwrap();
        let mut command = Command::new(&glslang);
        command.args(options).args(["-S", "frag", "-o"]).arg(&code).arg(&file);
        tools::run(&mut command, &case.name);
        if let Some(spirv_val) = &spirv_val {
            valid(spirv_val, &code, environment, &case.name);
        }
    }
}

fn valid(spirv_val: &Path, code: &Path, environment: &str, about: &str) {
    tools::run(Command::new(spirv_val).args(["--target-env", environment]).arg(code), about);
}

#[test]
fn what_no_shader_can_do_is_refused() {
    let case = Case::new(Kind::Corner, "3", "hash", "table");
    for name in ["", "3d", "a b", "gl_my", "my__own", "my_", "größe"] {
        let refused = Shader::new(Language::Wgsl, &case.tiling, &case.cells, name);
        let message = refused.unwrap_err().to_string();
        assert!(message.starts_with(&format!("name '{name}': expected")), "{message}");
    }
    // Whole blocks at every pixel.
    let colors = tilepack::tiles::Colors::one(5).unwrap();
    let compact = tilepack::tiling::Compact::of(5, 1).unwrap();
    let blocks = Case::of(Kind::Corner, "5", "blocks", Coloring::Compact(compact));
    assert_eq!(blocks.tiling.colors(), colors);
    let refused = Shader::new(Language::GlslEs300, &blocks.tiling, &blocks.cells, "my");
    assert!(refused.unwrap_err().to_string().contains("16x16 tiles, too much work"));
    // More points than 32 bits hold.
    let grid = tilepack::torus::Shape::new(30000, 30000).unwrap();
    let halton = tilepack::tiling::Halton::of_tiles(Kind::Corner, grid).unwrap();
    let tiling =
        tilepack::tiling::Tiling::new(Kind::Corner, case.tiling.colors(), Coloring::Halton(halton));
    let refused = Shader::new(Language::Hlsl, &tiling.unwrap(), &case.cells, "my").unwrap_err();
    assert!(refused.to_string().contains("2^30"), "{refused}");
}
