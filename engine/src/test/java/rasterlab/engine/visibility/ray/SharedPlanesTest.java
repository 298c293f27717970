package rasterlab.engine.visibility.ray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.hidden.TestScenes;

class SharedPlanesTest {
    private static final SphericalView CAMERA = new SphericalView(0.7, 1.1, 500);

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void facesOverEachOtherInOnePlaneAreFound(double[] second, boolean found) {
        double[] first = {0, 0, 10, 30, 0, 11, 30, 30, 13, 0, 30, 12};
        double[] xyz = new double[24];
        System.arraycopy(first, 0, xyz, 0, 12);
        System.arraycopy(second, 0, xyz, 12, 12);
        var mesh = new Mesh(xyz, new int[][] {{0, 1, 2, 3}, {4, 5, 6, 7}});
        var view = TestScenes.seen(mesh, CAMERA, Projection.PERSPECTIVE, 80, 60);
        assertEquals(found, SharedPlanes.anyOverlap(view));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("shifted face is not found", square(10, 10, 0, false), true),
                argumentSet("face turned round is not found", square(10, 10, 0, true), true),
                argumentSet("face in the midst is not found", square(0, 0, 0, false), true),
                argumentSet("neighbour counts", square(30, 0, 0, false), false),
                argumentSet("neighbour at a corner counts", square(30, 30, 0, false), false),
                argumentSet("plane beside it counts", square(10, 10, 1e-6, false), false));
    }

    /** A square of the plane z = 10 + x/30 + y/15, or that far above it. */
    private static double[] square(double x, double y, double above, boolean turned) {
        double[] xyz = new double[12];
        for (int k = 0; k < 4; k++) {
            int corner = turned ? 3 - k : k;
            double atX = x + (corner == 1 || corner == 2 ? 30 : 0);
            double atY = y + (corner >= 2 ? 30 : 0);
            xyz[3 * k] = atX;
            xyz[3 * k + 1] = atY;
            xyz[3 * k + 2] = 10 + atX / 30 + atY / 15 + above;
        }
        return xyz;
    }
}
