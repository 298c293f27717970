package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.SphericalView;

class WireTest {
    private static final int WHITE = 0xFFFFFFFF;
    private static final int BLACK = 0xFF000000;
    private static final int DIM = 0xFF7F7F7F;
    private static final int SIZE = 200;

    /** The cube [−1, 1]³; vertex numbers have bits for x, y and z. */
    private static final Mesh CUBE =
            new Mesh(
                    new double[] {
                        -1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1,
                        1, 1, 1
                    },
                    new int[][] {
                        {0, 2, 3, 1},
                        {4, 5, 7, 6},
                        {0, 1, 5, 4},
                        {2, 6, 7, 3},
                        {0, 4, 6, 2},
                        {1, 3, 7, 5}
                    });

    private static final SphericalView CORNER = new SphericalView(0.7, 1, 8);

    private final Renderer renderer = new Renderer();

    private Raster wire(
            Mesh mesh, String method, String projection, HiddenLines hidden, double crease) {
        int[] colours = new int[mesh.faceCount()];
        var scene = Scene.dull("cube", mesh, colours, 0, CORNER, 200);
        var plain = new RenderRequest(scene, method, "wire", projection, CORNER, SIZE, SIZE);
        return renderer.render(
                plain.with(plain.look().withWire(new WireStyle(hidden, crease))), () -> false);
    }

    static Stream<Arguments> methods() {
        return Renderer.visibilities().stream()
                .filter(name -> !name.equals("painter-textbook"))
                .flatMap(
                        name ->
                                Stream.of("perspective", "isometric", "cavalier")
                                        .map(p -> argumentSet(name + ", " + p, name, p)));
    }

    @ParameterizedTest(
            name = "hidden line is left, or a seen one is interrupted: {argumentSetName}")
    @MethodSource("methods")
    void removesTheThreeHiddenEdgesOfACube(String method, String projection) {
        Raster all = wire(CUBE, method, projection, HiddenLines.SHOWN, 0);
        Raster seen = wire(CUBE, method, projection, HiddenLines.REMOVED, 0);
        Raster dashed = wire(CUBE, method, projection, HiddenLines.DASHED, 0);
        int removed = 0;
        int dashes = 0;
        for (int i = 0; i < all.argb().length; i++) {
            if (seen.argb()[i] == WHITE) assertEquals(WHITE, all.argb()[i]);
            if (dashed.argb()[i] == DIM) dashes++;
            else assertEquals(seen.argb()[i], dashed.argb()[i]);
            if (seen.argb()[i] != all.argb()[i]) removed++;
        }
        int drawn = count(all, WHITE);
        assertEquals(0.25 * drawn, removed, 0.08 * drawn, "three edges of twelve are hidden");
        assertEquals(0.5, (double) dashes / removed, 0.12, "half of what is hidden is dashes");
        assertClosed(seen);
    }

    private static int count(Raster picture, int argb) {
        int count = 0;
        for (int pixel : picture.argb()) if (pixel == argb) count++;
        return count;
    }

    /** Each pixel of a closed net has two neighbours at least. */
    private static void assertClosed(Raster picture) {
        for (int y = 1; y < SIZE - 1; y++)
            for (int x = 1; x < SIZE - 1; x++) {
                if (picture.argb(x, y) != WHITE) continue;
                int neighbours = -1;
                for (int dy = -1; dy <= 1; dy++)
                    for (int dx = -1; dx <= 1; dx++)
                        if (picture.argb(x + dx, y + dy) == WHITE) neighbours++;
                assertTrue(neighbours >= 2, "a line ends at (%d, %d)".formatted(x, y));
            }
    }

    @Test
    @DisplayName("edge between two triangles of a plane is drawn though it is no crease")
    void leavesOutWhatIsNoCrease() {
        Mesh cut = CUBE.fans().mesh();
        Raster diagonals = wire(cut, "zfloat", "perspective", HiddenLines.REMOVED, 0);
        Raster creases = wire(cut, "zfloat", "perspective", HiddenLines.REMOVED, 1);
        Raster whole = wire(CUBE, "zfloat", "perspective", HiddenLines.REMOVED, 0);
        assertEquals(count(whole, WHITE), count(creases, WHITE));
        assertTrue(count(diagonals, WHITE) > count(whole, WHITE) + 100);
        Raster none = wire(CUBE, "zfloat", "perspective", HiddenLines.REMOVED, 120);
        assertEquals(6, count(none, WHITE) * 6 / count(whole, WHITE), 3, "its outline stays");
    }

    @Test
    @DisplayName("lines cannot be told from a bright background")
    void inkContrastsWithTheBackground() {
        for (int background : new int[] {0xFFFFFF, 0xFFFF00, 0x2B3A4A, 0x000000, 0x777777}) {
            var scene = Scene.dull("cube", CUBE, new int[6], background, CORNER, 200);
            var request =
                    new RenderRequest(scene, "zfloat", "wire", "perspective", CORNER, SIZE, SIZE);
            Raster picture = renderer.render(request, () -> false);
            int ink = background == 0x2B3A4A || background == 0 ? WHITE : BLACK;
            assertTrue(count(picture, ink) > 300, Integer.toHexString(background));
        }
    }

    @Test
    @DisplayName("edge through the eye's plane is drawn mirrored, or fails")
    void edgesBehindTheEyeAreCut() {
        var inside = new SphericalView(0.7, 1, 0.5);
        var scene = Scene.dull("cube", CUBE, new int[6], 0, inside, 200);
        var request = new RenderRequest(scene, "zfloat", "wire", "perspective", inside, SIZE, SIZE);
        Raster picture = renderer.render(request, () -> false);
        Raster exact = renderer.render(request.withVisibility("raycast"), () -> false);
        assertTrue(count(picture, WHITE) > 50, count(picture, WHITE) + " pixels");
        assertEquals(count(exact, WHITE), count(picture, WHITE), 6);
    }
}
