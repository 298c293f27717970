package rasterlab.tests.bench.pipeline;

import static org.lwjgl.opengl.GL20C.*;

import java.util.Locale;
import org.joml.Matrix4d;

/** The light of {@link TorusScene} as shaders, for each vertex or pixel, and a texture. */
final class GlProgram implements AutoCloseable {
    private final int program = glCreateProgram();

    private GlProgram(String vertex, String fragment) {
        attach(GL_VERTEX_SHADER, vertex);
        attach(GL_FRAGMENT_SHADER, fragment);
        glBindAttribLocation(program, 0, "position");
        glBindAttribLocation(program, 1, "normal");
        glBindAttribLocation(program, 2, "texture");
        glLinkProgram(program);
        if (glGetProgrami(program, GL_LINK_STATUS) == 0)
            throw new AssertionError(glGetProgramInfoLog(program));
    }

    static GlProgram smooth() {
        return lit("pixel = vec4(color, 1)");
    }

    static GlProgram glass() {
        return lit("pixel = vec4(color, 0.5)");
    }

    /** The texture is the one that is bound. */
    static GlProgram textured() {
        return lit("pixel = vec4(color, 1) * texture(picture, st)");
    }

    private static GlProgram lit(String fragment) {
        return new GlProgram(
                vertexHead()
                        + "out vec3 color; out vec2 st;\n"
                        + light()
                        + "void main() { vec4 p = vec4(position, 1) * toEye; st = texture;"
                        + " color = light(p.xyz, normal * mat3(toEye));"
                        + " gl_Position = vec4(position, 1) * toClip; }",
                "#version 330\nin vec3 color; in vec2 st; uniform sampler2D picture;"
                        + "out vec4 pixel; void main() { "
                        + fragment
                        + "; }");
    }

    static GlProgram phong() {
        return new GlProgram(
                vertexHead()
                        + "out vec3 n; out vec3 p;\n"
                        + "void main() { p = (vec4(position, 1) * toEye).xyz;"
                        + " n = normal * mat3(toEye);"
                        + " gl_Position = vec4(position, 1) * toClip; }",
                "#version 330\nin vec3 n; in vec3 p; out vec4 pixel;\n"
                        + light()
                        + "void main() { pixel = vec4(light(p, n), 1); }");
    }

    /** The colour at the vertices is given, as for triangles of pixels. */
    static GlProgram colored() {
        return new GlProgram(
                vertexHead()
                        + "out vec3 color;\n"
                        + "void main() { color = normal;"
                        + " gl_Position = vec4(position, 1) * toClip; }",
                "#version 330\nin vec3 color; out vec4 pixel;"
                        + "void main() { pixel = vec4(color, 1); }");
    }

    private static String vertexHead() {
        return "#version 330\nin vec3 position; in vec3 normal; in vec2 texture;\n"
                + "uniform mat4 toEye; uniform mat4 toClip;\n";
    }

    private static String light() {
        double[] l = TorusScene.toLight();
        return String.format(
                Locale.ROOT,
                "vec3 light(vec3 p, vec3 normal) { vec3 n = normalize(normal);"
                        + " vec3 l = vec3(%s, %s, %s); vec3 h = normalize(l - normalize(p));"
                        + " float d = max(0.0, dot(n, l));"
                        + " float s = d > 0.0 ? pow(max(0.0, dot(n, h)), %d.0) : 0.0;"
                        + " return min(vec3(1), vec3(%s, %s, %s) * (%s + %s * d) + %s * s); }\n",
                l[0],
                l[1],
                l[2],
                TorusLook.SHININESS,
                TorusLook.base(16),
                TorusLook.base(8),
                TorusLook.base(0),
                TorusScene.AMBIENT,
                1 - TorusScene.AMBIENT,
                TorusLook.SPECULAR);
    }

    private void attach(int kind, String source) {
        int shader = glCreateShader(kind);
        glShaderSource(shader, source);
        glCompileShader(shader);
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == 0)
            throw new AssertionError(glGetShaderInfoLog(shader) + source);
        glAttachShader(program, shader);
    }

    /** Row points times these matrices. */
    void use(Matrix4d toEye, Matrix4d toClip) {
        glUseProgram(program);
        // The shader multiplies from the left, so it needs the transpose of JOML's columns.
        glUniformMatrix4fv(glGetUniformLocation(program, "toEye"), true, toEye.get(new float[16]));
        var whole = new Matrix4d(toClip).mul(toEye);
        glUniformMatrix4fv(glGetUniformLocation(program, "toClip"), true, whole.get(new float[16]));
    }

    @Override
    public void close() {
        glDeleteProgram(program);
    }
}
