package rasterlab.engine.clip.volume;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import org.joml.Vector4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.transform.ProjectionMatrices;

/** M_p is written down twice: as the named matrix CANONICAL and inside the clipping. */
class CanonicalVolumeTest {
    @Test
    @DisplayName("clipping and the named matrix mean two different boxes")
    void clippingUsesTheNamedMatrix() {
        for (double zMin : new double[] {0.125, 0.5})
            for (double z : new double[] {-1, 0, 0.25, 1, 2}) {
                var image = new Vector4d(3, -4, z, 1).mul(ProjectionMatrices.canonical(zMin));
                assertArrayEquals(
                        new double[] {image.x, image.y, image.z, image.w},
                        HomogeneousClip.canonical(zMin, 3, -4, z),
                        1e-15);
            }
    }
}
