package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.ray.FaceCrossings;

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
        int[] colors = new int[mesh.faceCount()];
        var scene = Scene.dull("cube", mesh, colors, 0, CORNER, 200);
        var plain = new RenderRequest(scene, method, "wire", projection, CORNER, SIZE, SIZE);
        return renderer.render(
                plain.with(plain.look().withWire(new WireStyle(hidden, crease))), () -> false);
    }

    static Stream<Arguments> methods() {
        return Renderer.visibilities().stream()
                .filter(name -> !Set.of("painter-textbook", "none").contains(name))
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

    @ParameterizedTest(name = "outline before another face is dotted: {argumentSetName}")
    @MethodSource("walls")
    void outlineIsWholeBeforeAWall(String method, String projection) {
        var xyz = new double[36];
        for (int v = 0; v < 8; v++) {
            xyz[3 * v] = CUBE.x(v);
            xyz[3 * v + 1] = CUBE.y(v);
            xyz[3 * v + 2] = CUBE.z(v);
        }
        var wall = new double[12];
        double[] far = {-3, -3, -3};
        double[][] across = {{1, -1, 0}, {1, 1, -2}};
        for (int k = 0; k < 4; k++)
            for (int axis = 0; axis < 3; axis++)
                wall[3 * k + axis] =
                        far[axis]
                                + 40 * (k == 0 || k == 3 ? -1 : 1) * across[0][axis]
                                + 40 * (k < 2 ? -1 : 1) * across[1][axis];
        System.arraycopy(wall, 0, xyz, 24, 12);
        int[][] faces = new int[7][];
        for (int f = 0; f < 6; f++)
            faces[f] =
                    new int[] {
                        CUBE.corner(f, 0), CUBE.corner(f, 1), CUBE.corner(f, 2), CUBE.corner(f, 3)
                    };
        faces[6] = new int[] {8, 9, 10, 11};
        Raster alone = wire(CUBE, method, projection, HiddenLines.REMOVED, 0);
        Raster before = wire(new Mesh(xyz, faces), method, projection, HiddenLines.REMOVED, 0);
        int wallPixels = 0;
        int missing = 0;
        for (int i = 0; i < alone.argb().length; i++) {
            if (alone.argb()[i] == WHITE && before.argb()[i] != WHITE) missing++;
            if (before.argb()[i] == WHITE && alone.argb()[i] != WHITE) wallPixels++;
        }
        assertTrue(missing <= 1, missing + " pixels of the cube's edges are missing");
        assertTrue(wallPixels < 100, wallPixels + " pixels of the wall's edges are in the picture");
    }

    static Stream<Arguments> walls() {
        return Stream.of("painter", "zfloat", "raycast")
                .flatMap(
                        name ->
                                Stream.of("perspective", "parallel")
                                        .map(p -> argumentSet(name + ", " + p, name, p)));
    }

    private static int count(Raster picture, int argb) {
        int count = 0;
        for (int pixel : picture.argb()) if (pixel == argb) count++;
        return count;
    }

    /** Each pixel of a closed net has two neighbours at least. */
    private static void assertClosed(Raster picture) {
        for (int y = 1; y < picture.height() - 1; y++)
            for (int x = 1; x < picture.width() - 1; x++) {
                if (picture.argb(x, y) != WHITE) continue;
                int neighbours = -1;
                for (int dy = -1; dy <= 1; dy++)
                    for (int dx = -1; dx <= 1; dx++)
                        if (picture.argb(x + dx, y + dy) == WHITE) neighbours++;
                assertTrue(neighbours >= 2, "a line ends at (%d, %d)".formatted(x, y));
            }
    }

    /** Each quadrilateral as two triangles. */
    private static Mesh halved(Mesh quads) {
        double[] xyz =
                IntStream.range(0, quads.vertexCount())
                        .boxed()
                        .flatMapToDouble(v -> DoubleStream.of(quads.x(v), quads.y(v), quads.z(v)))
                        .toArray();
        int[][] triangles = new int[2 * quads.faceCount()][];
        for (int t = 0; t < triangles.length; t++) {
            int face = t / 2;
            int second = 1 + t % 2;
            triangles[t] =
                    new int[] {
                        quads.corner(face, 0),
                        quads.corner(face, second),
                        quads.corner(face, second + 1)
                    };
        }
        return new Mesh(xyz, triangles);
    }

    @Test
    @DisplayName("edge between two triangles of a plane is drawn though it is no crease")
    void leavesOutWhatIsNoCrease() {
        Mesh cut = halved(CUBE);
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
        var inside = new SphericalView(0.5, 1.2, 0.5);
        int[] colors = {0xFFFFFF, 0xFFFFFF, 0xFFFFFF, 0xFFFFFF, 0xFFFFFF, 0xFFFFFF};
        var scene = Scene.dull("cube", CUBE, colors, 0, inside, 200);
        var request = new RenderRequest(scene, "zfloat", "wire", "perspective", inside, SIZE, SIZE);
        Raster wire = renderer.render(request, () -> false);
        Raster faces = renderer.render(request.withShading(ShadingMethod.TONE), () -> false);
        int edges = 0;
        for (int y = 2; y < SIZE - 2; y++)
            for (int x = 2; x < SIZE - 2; x++) {
                boolean meet = differs(faces, x, y, faces.argb(x, y));
                if (meet) edges++;
                String at = "at (%d, %d)".formatted(x, y);
                if (wire.argb(x, y) == WHITE) assertTrue(meet, "no faces meet " + at);
                else if (meet) assertTrue(differs(wire, x, y, BLACK), "no edge " + at);
            }
        assertTrue(edges > 200, edges + " pixels on edges");
    }

    @Test
    @DisplayName("line in which faces pass through each other is not drawn")
    void drawsWhereFacesCross() {
        double[] xyz = {
            -1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1
        };
        var crossed = new Mesh(xyz, new int[][] {{0, 1, 2, 3}, {4, 5, 6, 7}});
        for (String method : List.of("zfloat", "raycast", "newell")) {
            Raster picture = wire(crossed, method, "perspective", HiddenLines.REMOVED, 0);
            for (int y = SIZE / 2 - 30; y <= SIZE / 2 + 30; y++)
                assertEquals(WHITE, picture.argb(SIZE / 2, y), method + ", row " + y);
        }
    }

    @Test
    @DisplayName("faces that touch are taken for such as cross")
    void neighboursDoNotCross() {
        for (Mesh mesh : List.of(CUBE, halved(CUBE), Scenes.named("torus").mesh()))
            for (Projection projection : List.of(Projection.PERSPECTIVE, Projection.CAVALIER)) {
                var transform = new ViewTransform(CORNER, projection);
                var view = new ViewedMesh(mesh, transform, PictureFit.of(SIZE, SIZE, 1));
                assertEquals(List.of(), FaceCrossings.of(view, () -> false));
            }
    }

    @ParameterizedTest(name = "lines of {0} are dotted, or a pixel of a hidden one strays")
    @ValueSource(strings = {"interpenetrating", "sphere", "globe", "cyclic-overlap", "house"})
    void linesGoOn(String name) {
        Scene scene = Scenes.named(name);
        var request =
                new RenderRequest(
                        scene, "zfloat", "wire", "perspective", scene.defaultCamera(), 800, 600);
        var style = new WireStyle(HiddenLines.REMOVED, 30);
        assertClosed(renderer.render(request.with(request.look().withWire(style)), () -> false));
    }

    /** Whether a pixel or one around it has another colour. */
    private static boolean differs(Raster picture, int x, int y, int argb) {
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) if (picture.argb(x + dx, y + dy) != argb) return true;
        return false;
    }
}
