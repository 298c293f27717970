package rasterlab.engine.visibility.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ViewedMesh;

/** The reference against quotients of whole numbers, and where doubles alone would be wrong. */
@Tag("slow")
class ExactVisibilityTest {
    private static final int SCENES = Boolean.getBoolean("rasterlab.full") ? 400 : 30;
    private static final long SEED = 281;

    /** All faces at each pixel, the nearest first. */
    private static List<List<Integer>> layers(ViewedMesh view, boolean seenThrough) {
        int width = view.fit().width();
        List<List<Integer>> layers = new ArrayList<>();
        for (int i = 0; i < width * view.fit().height(); i++) layers.add(new ArrayList<>());
        var paint =
                new FacePaint() {
                    @Override
                    public void span(int face, int y, int from, int to, Raster out) {
                        for (int x = from; x < to; x++) layers.get(y * width + x).add(0, face);
                    }

                    @Override
                    public boolean opaque(int face) {
                        return !seenThrough;
                    }
                };
        new ExactVisibility()
                .draw(view, paint, new Raster(width, view.fit().height()), () -> false);
        return layers;
    }

    @ParameterizedTest
    @EnumSource
    void agreesWithQuotientsOfWholeNumbers(RandomScenes.Kind kind) {
        for (int k = 0; k < SCENES; k++) {
            long seed = SEED + k;
            ViewedMesh view = RandomScenes.of(kind, seed);
            var expected = new RationalSurfaces(view);
            List<List<Integer>> all = layers(view, true);
            List<List<Integer>> nearest = layers(view, false);
            for (int i = 0; i < all.size(); i++) {
                int x = i % view.fit().width();
                int y = i / view.fit().width();
                String place = "seed %d, pixel (%d, %d)".formatted(seed, x, y);
                List<Integer> seen = expected.seen(x, y);
                assertEquals(seen, all.get(i), place);
                assertEquals(seen.stream().limit(1).toList(), nearest.get(i), place);
            }
        }
    }

    /**
     * The nearest face at the middle pixel, seen from the front at one pixel per unit, at x = 2⁻²⁰.
     */
    private static int middle(double[] xyz, int[]... faces) {
        var transform = new ViewTransform(new SphericalView(0, 1, 500), Projection.FRONT);
        var view = new ViewedMesh(new Mesh(xyz, faces), transform, new PictureFit(9, 9, 1));
        return layers(view, false).get(4 * 9 + 4).get(0);
    }

    /**
     * Two sheets that lean to each other and meet in the middle; the first one is moved away.
     *
     * @param away in world units, along y
     */
    private static double[] leaning(double away) {
        double hair = 0x1p-20;
        double left = hair - 4;
        double right = hair + 4;
        return new double[] {
            left, away - 2, -3, right, away + 2, -3, right, away + 2, 3, left, away - 2, 3, left, 2,
            -3, right, -2, -3, right, -2, 3, left, 2, 3
        };
    }

    private static final int[] FIRST = {0, 1, 2, 3};
    private static final int[] SECOND = {4, 5, 6, 7};

    @Test
    @DisplayName("depths that doubles cannot tell are taken for equal")
    void nearerByLessThanDoublesTellIsSeen() {
        double ulp = 0x1p-51; // Of the corners at 2, and a hundredth of what a depth of 500 has.
        assertEquals(1, middle(leaning(ulp), FIRST, SECOND));
        assertEquals(0, middle(leaning(-ulp), FIRST, SECOND));
    }

    @Test
    @DisplayName("of equal depths the later is seen")
    void ofEqualDepthsTheEarlierIsSeen() {
        assertEquals(0, middle(leaning(0), FIRST, SECOND));
        assertEquals(0, middle(leaning(0), SECOND, FIRST));
    }

    @Test
    @DisplayName("a centre on an edge is owned by both faces or by none")
    void edgeThroughTheLineOfSightIsOwnedByTheFaceOnItsRight() {
        double hair = 0x1p-20;
        double[] xyz = {-4, 0, -4, hair, 0, -4, hair, 0, 4, -4, 0, 4, 4, 0, -4, 4, 0, 4};
        int[] left = {0, 1, 2, 3};
        int[] right = {1, 4, 5, 2};
        assertEquals(1, middle(xyz, left, right));
        assertEquals(0, middle(xyz, right, left));
    }
}
