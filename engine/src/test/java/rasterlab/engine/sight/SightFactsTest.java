package rasterlab.engine.sight;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

class SightFactsTest {
    @ParameterizedTest(name = "backs of {0} are left out, or kept in vain")
    @CsvSource({
        "cube, true",
        "sphere, true",
        "torus, true",
        "vase, false",
        "revolution, false",
        "transparency, false",
        "textured-quad, false"
    })
    void closedBodiesHideTheirBacks(String name, boolean closed) {
        assertEquals(closed, new SightFacts(Scenes.named(name)).closed());
    }

    @Test
    void bodyWithoutOneFaceIsOpen() {
        Scene sphere = Scenes.named("sphere");
        int[] rest = IntStream.range(1, sphere.mesh().faceCount()).toArray();
        assertFalse(new SightFacts(sphere.only(rest)).closed());
    }

    @Test
    void bodyWhoseEdgesAreWalkedTwiceTheSameWayIsOpen() {
        Scene cube = Scenes.named("cube");
        int[] twice = IntStream.range(0, 2 * cube.mesh().faceCount()).map(f -> f / 2).toArray();
        assertTrue(ClosedMesh.is(cube.mesh()));
        assertFalse(ClosedMesh.is(cube.only(twice).mesh()));
    }

    @Test
    void bodiesThatTouchAtACornerAreClosed() {
        // Two tetrahedra, one above and one below vertex 0.
        double[] xyz = {0, 0, 0, 9, 0, 9, -9, 9, 9, -9, -9, 9, 9, 0, -9, -9, 9, -9, -9, -9, -9};
        int[][] faces = {
            {0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}
        };
        assertTrue(ClosedMesh.is(new Mesh(xyz, faces)));
    }

    @Test
    void bodyTurnedInsideOutIsRefused() {
        Mesh cube = Scenes.named("cube").mesh();
        int[][] turned = new int[cube.faceCount()][];
        for (int f = 0; f < turned.length; f++) {
            turned[f] = new int[cube.cornerCount(f)];
            for (int k = 0; k < turned[f].length; k++)
                turned[f][k] = cube.corner(f, turned[f].length - 1 - k);
        }
        double[] xyz = new double[3 * cube.vertexCount()];
        for (int v = 0; v < cube.vertexCount(); v++) {
            xyz[3 * v] = cube.x(v);
            xyz[3 * v + 1] = cube.y(v);
            xyz[3 * v + 2] = cube.z(v);
        }
        assertTrue(ClosedMesh.is(new Mesh(xyz, turned)));
        assertTrue(ClosedMesh.volume(new Mesh(xyz, turned)) < 0);
    }

    @ParameterizedTest(name = "squares at z = {0} and {1} on one side have no order")
    @CsvSource({"0, 10, true", "10, 0, true", "0, 0, true"})
    void parallelSquaresHaveAnOrder(double first, double second, boolean proved) {
        assertEquals(proved, PaintOrder.proved(seen(squares(first, first, second, second))));
    }

    @Test
    void meanDepthThatErrsIsNotProved() {
        // The second square is nearer where both are seen, but its mean is farther.
        assertFalse(PaintOrder.proved(seen(squares(0, 0, -200, 40))));
        // Turned the other way it is farther everywhere.
        assertTrue(PaintOrder.proved(seen(squares(0, 0, -200, -1))));
    }

    @Test
    void facesThatPassThroughEachOtherHaveNoOrder() {
        Scene scene = Scenes.named("cyclic-overlap");
        assertFalse(PaintOrder.proved(seen(scene.mesh())));
    }

    /** Two squares over each other, seen from above; left and right height of each. */
    private static Mesh squares(double left, double right, double left2, double right2) {
        double[] xyz = {
            -10, -10, left, 10, -10, right, 10, 10, right, -10, 10, left,
            -12, -9, left2, 9, -9, right2, 9, 9, right2, -12, 9, left2
        };
        return new Mesh(xyz, new int[][] {{0, 1, 2, 3}, {4, 5, 6, 7}});
    }

    private static ViewedMesh seen(Mesh mesh) {
        var fit = PictureFit.of(80, 60, 1);
        var above = new SphericalView(0, 0.001, 500);
        return new ViewedMesh(mesh, new ViewTransform(above, Projection.PERSPECTIVE), fit);
    }
}
