// WebGL 2: programs, textures, and what is wrong with them in words.

function makeProgram(gl, fragment) {
    const vertex = `void main() {
        vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
        gl_Position = vec4(at, 0.0, 1.0);
    }`;
    const compile = (kind, text) => {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, "#version 300 es\n" + text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
            throw new Error("A shader does not compile: " + gl.getShaderInfoLog(shader));
        }
        return shader;
    };
    const program = gl.createProgram();
    gl.attachShader(program, compile(gl.VERTEX_SHADER, vertex));
    gl.attachShader(program, compile(gl.FRAGMENT_SHADER, fragment));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
        throw new Error("A shader does not link: " + gl.getProgramInfoLog(program));
    }
    const places = {};
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
    for (let at = 0; at < count; at++) {
        const { name } = gl.getActiveUniform(program, at);
        places[name] = gl.getUniformLocation(program, name);
    }
    return { program, places };
}

// Textures by their units.
const UNITS = { table: 0, map: 1, ranks: 2, atlas: 3, window: 4 };

function numbersTexture(gl, unit, { internal, format, type }, width, height, data) {
    const texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, data);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
}

function atlasPicture(level) {
    const picture = new Image();
    const done = new Promise((resolve, reject) => {
        picture.onload = () => resolve(picture);
        picture.onerror = () => reject(new Error(`Mip level ${level} of the atlas is not a picture.`));
    });
    const element = document.getElementById("level-" + level);
    picture.src = "data:image/png;base64," + element.textContent.trim();
    element.remove();
    return done;
}

// All mip levels as they are; nothing is resampled. The number of levels that a texture can have.
async function atlasTexture(gl, scene) {
    const block = scene.side + 2 * scene.gutter;
    const width = scene.width * block, height = scene.height * block;
    const largest = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    if (Math.max(width, height) > largest) {
        throw new Error(`The atlas has ${width} x ${height} texels, but this graphics card takes ` +
            `textures of at most ${largest} x ${largest}. Make it with smaller tiles (--tile-size).`);
    }
    const pictures = await Promise.all(Array.from({ length: scene.levels }, (_, at) => atlasPicture(at)));
    let levels = 0;
    while (levels < pictures.length) {
        const { naturalWidth, naturalHeight } = pictures[levels];
        const fits = naturalWidth === width >> levels && naturalHeight === height >> levels;
        if (!fits || scene.side >> levels << levels !== scene.side) break;
        levels++;
    }
    if (levels === 0) throw new Error("The atlas does not have the size of its packing.");
    gl.activeTexture(gl.TEXTURE0 + UNITS.atlas);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    // Graphics cards decode sRGB before they filter.
    const internal = scene.srgb ? gl.SRGB8_ALPHA8 : gl.RGBA8;
    gl.texStorage2D(gl.TEXTURE_2D, levels, internal, width, height);
    for (let level = 0; level < levels; level++) {
        gl.texSubImage2D(gl.TEXTURE_2D, level, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE, pictures[level]);
    }
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    const anisotropic = gl.getExtension("EXT_texture_filter_anisotropic");
    if (anisotropic) {
        const most = gl.getParameter(anisotropic.MAX_TEXTURE_MAX_ANISOTROPY_EXT);
        gl.texParameterf(gl.TEXTURE_2D, anisotropic.TEXTURE_MAX_ANISOTROPY_EXT, Math.min(16, most));
    }
    return levels;
}
