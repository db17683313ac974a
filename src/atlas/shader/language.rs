//! The languages of shaders, and the way from our templates to them.
//!
//! The templates are WGSL. On what they use of it, whole numbers of 32 bits and vectors, GLSL and
//! HLSL differ in words only: types stand before names, and have other names. So a translation is a
//! few rules for declarations and a list of words. Textures are handled differently, so the
//! templates have words of their own for them.

/// A language of shaders.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// OpenGL 3.3 and later.
    Glsl330,
    /// WebGL 2, OpenGL ES 3.0.
    GlslEs300,
    /// Direct3D 11 (shader model 5) and later.
    Hlsl,
    /// WebGPU.
    Wgsl,
}

/// Words of WGSL, GLSL and HLSL.
const WORDS: &[[&str; 3]] = &[
    ["u32", "uint", "uint"],
    ["i32", "int", "int"],
    ["f32", "float", "float"],
    ["vec2i", "ivec2", "int2"],
    ["vec2u", "uvec2", "uint2"],
    ["vec4u", "uvec4", "uint4"],
    ["vec2f", "vec2", "float2"],
    ["vec4f", "vec4", "float4"],
    ["dpdx", "dFdx", "ddx"],
    ["dpdy", "dFdy", "ddy"],
];

impl Language {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Glsl330, Self::GlslEs300, Self::Hlsl, Self::Wgsl];

    /// As the command line has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Glsl330 => "glsl-330",
            Self::GlslEs300 => "glsl-es-300",
            Self::Hlsl => "hlsl",
            Self::Wgsl => "wgsl",
        }
    }

    /// As people have it.
    pub fn title(self) -> &'static str {
        match self {
            Self::Glsl330 => "GLSL 3.30",
            Self::GlslEs300 => "GLSL ES 3.00",
            Self::Hlsl => "HLSL, shader model 5",
            Self::Wgsl => "WGSL",
        }
    }

    /// A template in this language.
    pub(super) fn translate(self, template: &str) -> String {
        if self == Self::Wgsl {
            return template.to_owned();
        }
        template.lines().map(|line| self.line(line) + "\n").collect()
    }

    /// A constant of 32 bits.
    pub(super) fn constant(self, name: &str, value: u64) -> String {
        match self {
            Self::Wgsl => format!("const {name}: u32 = {value}u;\n"),
            Self::Hlsl => format!("static const uint {name} = {value}u;\n"),
            _ => format!("const uint {name} = {value}u;\n"),
        }
    }

    fn line(self, line: &str) -> String {
        let code = line.trim_start();
        if code.starts_with("//") {
            return line.to_owned();
        }
        if let Some((head, result)) = line.split_once(") -> ")
            && let Some((name, parameters)) =
                head.strip_prefix("fn ").and_then(|head| head.split_once('('))
        {
            let parameters: Vec<String> = parameters.split(", ").map(turned).collect();
            let result = result.trim_end_matches(" {");
            return self.words(&format!("{result} {name}({}) {{", parameters.join(", ")));
        }
        for keyword in ["let ", "var "] {
            if let Some((before, declared)) = line.split_once(keyword)
                && let Some((declared, value)) = declared.split_once(" = ")
            {
                return self.words(&format!("{before}{} = {value}", turned(declared)));
            }
        }
        self.words(line)
    }

    /// Replaces words.
    fn words(self, line: &str) -> String {
        let column = if self == Self::Hlsl { 2 } else { 1 };
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let mut text = String::with_capacity(line.len());
        let mut rest = line;
        while let Some(first) = rest.chars().next() {
            let end = match is_word(first) {
                true => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
                false => first.len_utf8(),
            };
            let (word, after) = rest.split_at(end);
            let known = WORDS.iter().find(|words| words[0] == word);
            text.push_str(known.map_or(word, |words| words[column]));
            rest = after;
        }
        text
    }
}

/// `name: type` as `type name`; anything else as it is.
fn turned(declared: &str) -> String {
    match declared.split_once(": ") {
        Some((name, of_type)) => format!("{of_type} {name}"),
        None => declared.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_and_words_are_translated() {
        let template = "// let x: u32\nfn f(x: i32, TEXTURE) -> vec2f {\n    \
                        for (var i: u32 = 0u; i < 8u; i = i + 1u) {\n    let a: vec4u = g(i32(x));";
        assert_eq!(
            Language::Hlsl.translate(template),
            "// let x: u32\nfloat2 f(int x, TEXTURE) {\n    \
             for (uint i = 0u; i < 8u; i = i + 1u) {\n    uint4 a = g(int(x));\n"
        );
        assert_eq!(Language::Wgsl.translate(template), template);
    }
}
