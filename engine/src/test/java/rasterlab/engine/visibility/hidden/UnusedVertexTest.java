package rasterlab.engine.visibility.hidden;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.FlatPaint;

/**
 * A triangle whose corner lies a hair above the pixel, and a vertex far off of which no face is.
 */
class UnusedVertexTest {
    private static final int FACE = 0xFF0000FF;

    @ParameterizedTest(name = "{0}: the far vertex widens the triangle")
    @ValueSource(strings = {"raycast", "scanline", "warnock", "newell", "bsp", "z32", "zfloat"})
    void vertexOfNoFaceChangesNothing(String method) {
        double[] xyz = {0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 7e238, 0};
        var view =
                SurfaceView.of(
                        new Mesh(xyz, new int[][] {{0, 1, 2}}),
                        new SphericalView(0, Math.toRadians(1), 1),
                        Projection.PERSPECTIVE,
                        new PictureFit(1, 1, 1));
        var out = new Raster(1, 1);
        new Visibilities()
                .named(method)
                .implementation()
                .draw(view.view(), new FlatPaint(new int[] {FACE}, new int[0]), out, () -> false);
        assertEquals("0", Integer.toHexString(out.argb(0, 0)));
    }
}
