package rasterlab.engine.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.hidden.SideView;

class ScreenPolygonTest {
    /** Pixel (3, 2) is the origin; corners are given as pixels from there, y up. */
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void ownsPixels(String picture, double[] yz) {
        double[] xyz = new double[yz.length / 2 * 3];
        int[] face = new int[yz.length / 2];
        for (int k = 0; k < face.length; k++) {
            xyz[3 * k + 1] = yz[2 * k];
            xyz[3 * k + 2] = yz[2 * k + 1];
            face[k] = k;
        }
        assertEquals(picture, text(counts(new Mesh(xyz, new int[][] {face}), 7, 5), 7));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "right and bottom edges are owned too",
                        "....... .###... .###... ....... .......",
                        new double[] {-2, -1, 1, -1, 1, 1, -2, 1}),
                argumentSet(
                        "rounding moves edges off pixel centres",
                        "....... .###... .###... ....... .......",
                        new double[] {
                            -2 + 1e-9, -1 + 1e-9, 1 + 1e-9, -1 + 1e-9, 1 + 1e-9, 1 - 1e-9,
                            -2 + 1e-9, 1 - 1e-9
                        }),
                argumentSet(
                        "pixels are tested at their corners",
                        "....... ..##... ..##... ....... .......",
                        new double[] {-1.4, -0.4, 0.6, -0.4, 0.6, 1.4, -1.4, 1.4}),
                argumentSet(
                        "a slanted left edge is not owned",
                        "....... ...#... ..##... .###... .......",
                        new double[] {-2, -1.5, 1, -1.5, 0.5, 1, 0, 1, -2, -1}),
                argumentSet(
                        "a face outside writes into the picture's edge",
                        "....... ....... ....... ....... .......",
                        new double[] {-9, -9, -5, -9, -5, 9, -9, 9}),
                argumentSet(
                        "a face larger than the picture is not cut",
                        "####### ####### ####### ####### #######",
                        new double[] {-90, -90, 90, -90, 90, 90, -90, 90}),
                argumentSet(
                        "a face between pixel centres lights one",
                        "....... ....... ....... ....... .......",
                        new double[] {0.1, 0.1, 0.9, 0.1, 0.9, 0.9, 0.1, 0.9}));
    }

    /** Shared edges are covered twice, or leave gaps: a fan of random triangles fills a square. */
    @ParameterizedTest(name = "shared edges leave gaps or are owned twice, seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void fanCoversEachPixelOnce(long seed) {
        var random = new Random(seed);
        int spokes = 3 + random.nextInt(30);
        double[] xyz = new double[3 * (spokes + 1)];
        int[][] faces = new int[spokes][];
        boolean whole = seed % 2 == 0;
        for (int k = 0; k < spokes; k++) {
            double angle = 2 * Math.PI * k / spokes;
            xyz[3 * k + 1] = 200 * Math.cos(angle);
            xyz[3 * k + 2] = 200 * Math.sin(angle);
            faces[k] = new int[] {spokes, k, (k + 1) % spokes};
        }
        xyz[3 * spokes + 1] = whole ? random.nextInt(9) - 4 : random.nextDouble() * 9 - 4;
        xyz[3 * spokes + 2] = whole ? random.nextInt(9) - 4 : random.nextDouble() * 9 - 4;
        int[] counts = counts(new Mesh(xyz, faces), 61, 61);
        for (int i = 0; i < counts.length; i++)
            assertEquals(1, counts[i], "writes of pixel (%d, %d)".formatted(i % 61, i / 61));
    }

    /** The eye stands inside a box: clipped faces must still fit together. */
    @ParameterizedTest(name = "clipped faces leave gaps or overlap, eye at {0}")
    @ValueSource(doubles = {0.1, 0.8, 1.9, 2.7, 4})
    void boxAroundTheEyeCoversEachPixelOnce(double theta) {
        double[] xyz = new double[24];
        for (int i = 0; i < 24; i++) xyz[i] = (i / 3 >> i % 3 & 1) == 0 ? -50 : 50;
        int[][] faces = {
            {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}
        };
        var view =
                new ViewedMesh(
                        new Mesh(xyz, faces),
                        new ViewTransform(
                                new SphericalView(theta, 1.1, 20), Projection.PERSPECTIVE),
                        new PictureFit(80, 60, 1));
        int[] counts = counts(view);
        for (int i = 0; i < counts.length; i++)
            assertEquals(1, counts[i], "writes of pixel (%d, %d)".formatted(i % 80, i / 80));
    }

    private static int[] counts(Mesh mesh, int width, int height) {
        return counts(SideView.parallel(mesh, width, height));
    }

    private static int[] counts(ViewedMesh view) {
        int width = view.fit().width();
        int height = view.fit().height();
        int[] counts = new int[width * height];
        var polygon = new ScreenPolygon(view);
        for (int f = 0; f < view.mesh().faceCount(); f++) {
            polygon.load(view, f);
            polygon.fill(
                    width,
                    height,
                    (y, from, to) -> {
                        for (int x = from; x < to; x++) counts[y * width + x]++;
                    });
        }
        return counts;
    }

    private static String text(int[] counts, int width) {
        var text = new StringBuilder();
        for (int i = 0; i < counts.length; i++) {
            if (i > 0 && i % width == 0) text.append(' ');
            text.append(counts[i] == 0 ? '.' : counts[i] == 1 ? '#' : (char) ('0' + counts[i]));
        }
        return text.toString();
    }
}
