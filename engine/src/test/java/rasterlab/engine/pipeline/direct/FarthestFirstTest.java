package rasterlab.engine.pipeline.direct;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Comparator;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.scene.FaceMiddle;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/** The order of transparent faces beside one found by comparing their depths. */
class FarthestFirstTest {
    @ParameterizedTest(name = "{1} different depths: {2}")
    @CsvSource({
        "3000, 3000, the nearest face comes first",
        "3000, 7, faces of one depth change places",
        "1, 1, a single face is lost",
        "0, 1, no face is too few"
    })
    void isTheOrderThatComparingGives(int faces, int depths, String mistake) {
        ViewedMesh view = viewed(faces, depths);
        int[] expected =
                IntStream.range(0, faces)
                        .boxed()
                        .sorted(
                                Comparator.comparingDouble(
                                        f -> -FaceMiddle.of(view.mesh(), f, view::eyeZ)))
                        .mapToInt(Integer::intValue)
                        .toArray();
        assertArrayEquals(
                expected, FarthestFirst.sorted(view, IntStream.range(0, faces).toArray()));
    }

    /** Triangles before and behind a parallel picture plane. */
    private static ViewedMesh viewed(int faces, int depths) {
        var random = new Random(1976);
        double[] xyz = new double[9 * faces];
        int[][] corners = new int[faces][];
        for (int f = 0; f < faces; f++) {
            double height = random.nextInt(depths) - depths / 2;
            for (int k = 0; k < 3; k++) {
                xyz[9 * f + 3 * k] = k == 1 ? 1 : 0;
                xyz[9 * f + 3 * k + 1] = k == 2 ? 1 : 0;
                xyz[9 * f + 3 * k + 2] = height;
            }
            corners[f] = new int[] {3 * f, 3 * f + 1, 3 * f + 2};
        }
        var fromAbove = new SphericalView(0.3, 0.1, 1);
        return new ViewedMesh(
                new Mesh(xyz, corners),
                new ViewTransform(fromAbove, Projection.PARALLEL),
                PictureFit.of(40, 30, 1));
    }
}
