package rasterlab.engine.visibility.hidden;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.FlatPaint;

/** A narrow triangle that is listed twice: the first is seen, as of all faces at one place. */
class NarrowFacesTest {
    private static final int FIRST = 0xFF0000FF;
    private static final int SECOND = 0xFFFFFFFF;

    @ParameterizedTest(name = "{0}, {1} long and {2} wide: rounding parts the planes")
    @CsvSource({"newell, 1000, 1e-4", "bsp, 1000, 1e-4", "newell, 90, 2e-5", "bsp, 90, 2e-5"})
    void ofTwoEqualFacesTheFirstIsSeen(String method, double length, double width) {
        double[] xyz = {-length, 0, 0, 0, 0, 0, 0, 0, -width};
        var view =
                SurfaceView.of(
                        new Mesh(xyz, new int[][] {{0, 1, 2}, {0, 1, 2}}),
                        new SphericalView(1, 1, 1),
                        Projection.PARALLEL,
                        new PictureFit(1, 1, 1));
        var out = new Raster(1, 1);
        new Visibilities()
                .named(method)
                .implementation()
                .draw(
                        view.view(),
                        new FlatPaint(new int[] {FIRST, SECOND}, new int[0]),
                        out,
                        () -> false);
        assertEquals(Integer.toHexString(FIRST), Integer.toHexString(out.argb(0, 0)));
    }
}
