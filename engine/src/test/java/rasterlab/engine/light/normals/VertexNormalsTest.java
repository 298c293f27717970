package rasterlab.engine.light.normals;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.transform.Images;

class VertexNormalsTest {
    private static final NormalsTopic TOPIC = new NormalsTopic();

    /** Bottom, top, and four sides of a cube about the origin, counter-clockwise from outside. */
    private static final int[][] SIDES = {
        {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}
    };

    private static final double[] CUBE = {
        -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, //
        -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1
    };

    @Property(tries = 64)
    void anglesDoNotCareHowACubeIsCut(@ForAll @IntRange(max = 63) int cuts) {
        double[] normals = method("angle").normals(CUBE, cube(cuts));
        for (int i = 0; i < normals.length; i++)
            assertEquals(CUBE[i] / Math.sqrt(3), normals[i], 1e-15);
    }

    @ParameterizedTest(name = "{0} does not depend on the cut, as the course says it does")
    @ValueSource(strings = {"plain", "area"})
    void otherWeightsDependOnTheCut(String name) {
        double[] one = method(name).normals(CUBE, cube(0));
        double[] other = method(name).normals(CUBE, cube(63));
        double worst = 0;
        for (int i = 0; i < one.length; i++) worst = Math.max(worst, Math.abs(one[i] - other[i]));
        assertTrue(worst > 0.2, name + " differs by " + worst);
    }

    /** Each side is cut from its first or second corner, by a bit of {@code cuts}. */
    private static int[] cube(int cuts) {
        var triangles = new int[36];
        for (int side = 0, at = 0; side < 6; side++) {
            int from = cuts >> side & 1;
            for (int half = 1; half <= 2; half++) {
                triangles[at++] = SIDES[side][from];
                triangles[at++] = SIDES[side][(from + half) % 4];
                triangles[at++] = SIDES[side][(from + half + 1) % 4];
            }
        }
        return triangles;
    }

    @ParameterizedTest(name = "{0} points into the sphere or beside its radius")
    @ValueSource(strings = {"plain", "area", "angle"})
    void normalsOfASphereAreItsRadii(String name) {
        TriangleSurface sphere = NormalsWorkloads.sphere(48, 24);
        double[] normals = method(name).normals(sphere.vertices(), sphere.triangles());
        assertArrayEquals(sphere.vertices(), normals, 0.05, name);
    }

    @Test
    void coursesMeanIsTooShortWhereTheSurfaceIsCurved() {
        double[] normals = method("plain-textbook").normals(CUBE, cube(0));
        double length = Math.hypot(Math.hypot(normals[3], normals[4]), normals[5]);
        assertTrue(length < 0.75, "length " + length);
    }

    @ParameterizedTest(name = "{0} crashes on nothing")
    @ValueSource(strings = {"plain-textbook", "plain", "area", "angle"})
    void nothingHasNoNormals(String name) {
        assertEquals(0, method(name).normals(new double[0], new int[0]).length);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(double[] vertices, int[] triangles, String message) {
        for (var method : TOPIC.methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> method.implementation().normals(vertices, triangles));
            assertEquals(message, refusal.getMessage(), method.name());
        }
    }

    static Stream<Arguments> mistakes() {
        double[] one = {0, 0, 0};
        return Stream.of(
                argumentSet(
                        "half a vertex is read",
                        new double[4],
                        new int[0],
                        "vertices must have 3 numbers each, got 4 in all"),
                argumentSet(
                        "half a face is read",
                        one,
                        new int[] {0, 0},
                        "triangles must have 3 vertices each, got 2 in all"),
                argumentSet(
                        "a face has a vertex that does not exist",
                        one,
                        new int[] {0, 0, 1},
                        "triangles[0][2] must be a vertex from 0 to 0, got 1"),
                argumentSet(
                        "a face has a vertex before the first",
                        one,
                        new int[] {0, -1, 0},
                        "triangles[0][1] must be a vertex from 0 to 0, got -1"),
                argumentSet(
                        "NaN spreads over its neighbours",
                        new double[] {0, Double.NaN, 0},
                        new int[0],
                        "vertices[0].y must be from -1E75 to 1E75, got NaN"),
                argumentSet(
                        "products overflow",
                        new double[] {0, 0, 0, 1e80, 0, 0},
                        new int[0],
                        "vertices[1].x must be from -1E75 to 1E75, got 1.0E80"));
    }

    private static VertexNormals method(String name) {
        return TOPIC.method(name).implementation();
    }

    @Test
    @DisplayName("what is wrong is told of a vertex that is only rounded")
    void firstDifferenceIsOneThatCounts() {
        var surface = new TriangleSurface(new double[] {0, 0, 0, 1, 0, 0}, new int[0]);
        var exact = new Images(new double[] {0, 0.5, 0, 0, 0, 1}, 3);
        var rounded = new Images(new double[] {0, Math.nextUp(0.5), 0, 0, 1, 0}, 3);
        String said = TOPIC.compare(surface, exact, rounded).first();
        assertTrue(said.startsWith("normal of vertex 1 is"), said);
    }
}
