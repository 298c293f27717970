package rasterlab.engine.scene.obj;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;

/** One model in every unit that doubles have is one picture. */
class UnitsTest {
    private static final String FACES =
            "f 1 2 5\nf 2 3 5\nf 3 4 5\ns 1\nf 4 1 5\nf 1 4 6 3 2\nl 1 5\np 5\n";

    /** A pyramid whose bottom is a pentagon with a corner that turns inwards. */
    private static final int[] CORNERS = {
        -8, -8, 0, 8, -8, 0, 8, 8, 0, -8, 8, 0, 0, 0, 16, 0, 0, 0
    };

    private static final String CUT =
            "a.obj:12: a face that is not flat or not convex was cut into triangles";

    static IntStream exponents() {
        return IntStream.of(55, 0, -60, -150, -199, -204, -250, -400, -700, -1021, -1065);
    }

    @ParameterizedTest(name = "a unit of 2^{0} is refused, or changes the model")
    @MethodSource("exponents")
    void fitsWhateverTheUnit(int exponent) throws Exception {
        ObjModel model = pyramid(exponent);
        assertEquals(List.of(CUT), model.notes());
        Mesh usual = scene(pyramid(0)).mesh();
        Mesh mesh = scene(model).mesh();
        assertEquals(usual.faceCount(), mesh.faceCount());
        assertEquals(usual.vertexCount(), mesh.vertexCount());
        for (int v = 0; v < mesh.vertexCount(); v++) {
            assertEquals(usual.x(v), mesh.x(v), 1e-9, "x of vertex " + v);
            assertEquals(usual.y(v), mesh.y(v), 1e-9, "y of vertex " + v);
            assertEquals(usual.z(v), mesh.z(v), 1e-9, "z of vertex " + v);
        }
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int axis = 0; axis < 3; axis++)
                assertEquals(
                        usual.cornerNormal(f, 0, axis),
                        mesh.cornerNormal(f, 0, axis),
                        1e-12,
                        "normal of face " + f);
    }

    private static ObjModel pyramid(int exponent) throws Exception {
        var text = new StringBuilder();
        for (int v = 0; v < CORNERS.length; v += 3)
            text.append(
                    "v %s %s %s\n"
                            .formatted(at(v, exponent), at(v + 1, exponent), at(v + 2, exponent)));
        return Texts.read(text + FACES);
    }

    private static double at(int number, int exponent) {
        return Math.scalb((double) CORNERS[number], exponent);
    }

    private static Scene scene(ObjModel model) {
        return ObjScene.of(
                "a",
                model,
                UpAxis.Z,
                map -> Optional.empty(),
                note -> {
                    throw new AssertionError(note);
                });
    }

    /** A tiny face far away from the origin, where its coordinates differ by their last bits. */
    @ParameterizedTest(name = "a tiny face at x = {0} is without area")
    @MethodSource("places")
    void tinyFacesFarFromTheOriginHaveAnArea(double x, double unit) throws Exception {
        ObjModel model =
                Texts.read(
                        "v %s 0 0\nv %s %s 0\nv %s 0 %s\nf 1 2 3".formatted(x, x, unit, x, unit));
        assertEquals(1, model.normals()[3 * model.normal(0, 0)], 1e-15);
        assertEquals(List.of(), model.notes());
    }

    static List<Arguments> places() {
        return List.of(
                Arguments.of(1e18, 1e-300), Arguments.of(-1e18, 4e-322), Arguments.of(5, 1e-160));
    }
}
