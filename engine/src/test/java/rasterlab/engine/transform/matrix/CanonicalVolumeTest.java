package rasterlab.engine.transform.matrix;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Random;
import org.joml.Vector4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.Topics;

/** M_p is written down twice: as the named matrix CANONICAL and inside the homogeneous clipping. */
class CanonicalVolumeTest {
    /**
     * The segments go from the middle of the volume outwards, so that exactly the second end is
     * cut.
     */
    @Test
    @DisplayName("clipping and the named matrix mean two different boxes")
    void whatClippingCutsEndsOnTheBoxOfTheNamedMatrix() {
        var clipper =
                (VolumeClipper) Topics.named("clip-volume").method("homogeneous").implementation();
        long seed = 5;
        var random = new Random(seed);
        for (int i = 0; i < 1_000; i++) {
            double zMin = random.nextDouble(0.05, 0.9);
            var ends = new ArrayList<Vector4d>();
            double[] out = random.doubles(3, -1, 1).map(v -> Math.copySign(9, v) + v).toArray();
            clipper.clip(
                    zMin,
                    0,
                    0,
                    (zMin + 1) / 2,
                    out[0],
                    out[1],
                    out[2],
                    (x0, y0, z0, x1, y1, z1) -> ends.add(new Vector4d(x1, y1, z1, 1)));
            assertEquals(1, ends.size(), "seed " + seed);
            Vector4d box = ends.get(0).mul(WorkedMatricesTest.joml("CANONICAL", zMin));
            box.div(box.w);
            double side = Math.max(Math.abs(box.x), Math.abs(box.y));
            double face = Math.max(side, Math.abs(2 * box.z - 1));
            assertTrue(Math.abs(face - 1) < 1e-9, "seed " + seed + " " + box);
        }
    }
}
