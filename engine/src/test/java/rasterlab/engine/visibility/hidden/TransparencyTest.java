package rasterlab.engine.visibility.hidden;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ViewedMesh;

/** Each pixel holds the numbers of what is seen in it, back to front, as one number. */
class TransparencyTest {
    private static final long SEED = 91;
    private static final SphericalView CAMERA = new SphericalView(0.4, 1, 500);

    /** Every third face is transparent: the digit of a face is put behind those it is seen over. */
    private static final FacePaint LAYERS =
            new FacePaint() {
                @Override
                public void span(int face, int y, int from, int to, Raster out) {
                    for (int x = from; x < to; x++) {
                        int at = y * out.width() + x;
                        int under = opaque(face) ? 0 : out.argb()[at];
                        out.argb()[at] = 31 * under + face + 1;
                    }
                }

                @Override
                public boolean opaque(int face) {
                    return face % 3 != 0;
                }
            };

    @ParameterizedTest(name = "{0} loses or misplaces a layer")
    @ValueSource(strings = {"newell", "bsp", "scanline", "warnock", "raycast"})
    void layersAreBlendedBackToFront(String method) {
        assertLayers(method, TestScenes.crossing(60, 60, SEED), 2e-4);
    }

    @ParameterizedTest(name = "{0} lets a transparent face hide")
    @ValueSource(strings = {"painter", "z16", "z24", "z32", "zfloat", "reversed-z"})
    void layersThatDoNotCrossAreBlendedBackToFront(String method) {
        assertLayers(method, panes(), 2e-4);
    }

    /** Squares across x, one behind the other, in no order. */
    private static Mesh panes() {
        double[] depths = {10, -70, 40, -20, 90, -110, 60, -50};
        double[] xyz = new double[12 * depths.length];
        int[][] faces = new int[depths.length][];
        for (int k = 0; k < depths.length; k++) {
            for (int c = 0; c < 4; c++) {
                xyz[12 * k + 3 * c] = depths[k];
                xyz[12 * k + 3 * c + 1] = (c == 1 || c == 2 ? 55.3 : -60.1) + 9.7 * k;
                xyz[12 * k + 3 * c + 2] = (c >= 2 ? 57.2 : -49.9) - 7.3 * k;
            }
            faces[k] = new int[] {4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3};
        }
        return new Mesh(xyz, faces);
    }

    private static void assertLayers(String method, Mesh mesh, double allowed) {
        ViewedMesh view = TestScenes.seen(mesh, CAMERA, Projection.PERSPECTIVE, 400, 300);
        Raster exact = TestScenes.exact(view, LAYERS);
        var difference = PictureDifference.of(exact, TestScenes.picture(method, view, LAYERS));
        assertEquals(0, difference.share(), allowed, method + ", seed " + SEED);
    }

    @Test
    @DisplayName("raycast shows only the nearest face")
    void rayCastBlendsWhatLiesBehind() {
        double[] xyz = new double[24];
        int[][] faces = {{0, 1, 2, 3}, {4, 5, 6, 7}};
        for (int v = 0; v < 8; v++) {
            xyz[3 * v] = v < 4 ? 10 : -10;
            xyz[3 * v + 1] = v % 4 == 1 || v % 4 == 2 ? 20 : -20;
            xyz[3 * v + 2] = v % 4 >= 2 ? 20 : -20;
        }
        Raster picture =
                TestScenes.picture(
                        "raycast", SideView.parallel(new Mesh(xyz, faces), 9, 9), LAYERS);
        assertEquals(31 * 2 + 1, picture.argb(4, 4));
    }
}
