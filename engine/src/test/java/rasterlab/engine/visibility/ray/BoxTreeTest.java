package rasterlab.engine.visibility.ray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.hidden.TestScenes;

class BoxTreeTest {
    private static final long SEED = 1980;
    private static final ViewTransform FRONT =
            new ViewTransform(new SphericalView(0, 1, 400), Projection.FRONT);

    @Test
    @DisplayName("a box is missed that holds a face which the ray meets")
    void raysMeetWhatTheyMeetWithoutBoxes() {
        var random = new Random(SEED);
        for (int count : new int[] {1, 4, 5, 33, 200}) {
            Mesh mesh = TestScenes.crossing(count, 60, SEED + count);
            var paint = TestScenes.numbers(mesh);
            var targets = new RayTargets(mesh);
            var boxes = new BoxTree(mesh);
            var view = new ViewedMesh(mesh, FRONT, PictureFit.of(8, 8, 1), -1e3, 1e3);
            var one = new RayHits(targets, paint, new RaySpan(view), new Tally());
            var all = new RayHits(targets, paint, new RaySpan(view), new Tally());
            for (int k = 0; k < 2000; k++) {
                double[] ray = random.doubles(6, -150, 150).toArray();
                if (k % 3 == 0) ray[3 + k / 3 % 3] = 0;
                one.start(ray);
                boxes.cast(one);
                all.start(ray);
                for (int f = 0; f < count; f++) all.tryFace(f);
                assertArrayEquals(all.faces(), one.faces(), "seed " + SEED + ", ray " + k);
            }
        }
    }
}
