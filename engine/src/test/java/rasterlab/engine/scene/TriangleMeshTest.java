package rasterlab.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class TriangleMeshTest {
    private static final float[] THREE = {0, 1, 2};

    private static TriangleMesh mesh(float[] x, int... triangles) {
        return TriangleMesh.of(x, THREE, THREE, triangles);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(Executable mistake, String message) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, mistake).getMessage());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "a vertex beyond the last is let in",
                        (Executable) () -> mesh(THREE, 0, 1, 2, 0, 1, 3),
                        "triangle 1: corner must be a vertex from 0 to 2, got 3"),
                argumentSet(
                        "a negative vertex is let in",
                        (Executable) () -> mesh(THREE, 0, -1, 2),
                        "triangle 0: corner must be a vertex from 0 to 2, got -1"),
                argumentSet(
                        "two corners are let in",
                        (Executable) () -> mesh(THREE, 0, 1),
                        "triangles must have 3 vertices each, got 2 in all"),
                argumentSet(
                        "NaN is let in",
                        (Executable) () -> mesh(new float[] {0, Float.NaN, 2}, 0, 1, 2),
                        "vertex 1: x must be finite, got NaN"),
                argumentSet(
                        "fewer y than x are let in",
                        (Executable) () -> mesh(new float[4]),
                        "y needs one number for each of 4 vertices, got 3"),
                argumentSet(
                        "a short normal is let in",
                        (Executable)
                                () -> mesh(THREE).withNormals(new float[3], THREE, new float[3]),
                        "vertex 0: the normal must have length 1, got (0.0, 0.0, 0.0)"),
                argumentSet(
                        "a colour above 1 is let in",
                        (Executable) () -> mesh(THREE).withColors(THREE, THREE, THREE, THREE),
                        "vertex 2: a colour must be from 0 to 1, got 2.0"),
                argumentSet(
                        "colours are invented",
                        (Executable) () -> mesh(THREE).values(VertexQuantity.RED),
                        "the mesh has no red of vertices"));
    }

    @Test
    void writingToTheGivenArraysChangesNothing() {
        float[] x = THREE.clone();
        int[] triangles = {0, 1, 2};
        var mesh = mesh(x, triangles);
        x[0] = 9;
        triangles[0] = 9;
        assertEquals(0, mesh.values(VertexQuantity.X)[0]);
        assertEquals(0, mesh.triangles()[0]);
    }
}
