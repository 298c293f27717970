package rasterlab.engine.light.normals;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class OrdinarySurfaceTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void tellsWhatIsPromised(boolean promised, double[] xyz, int[] triangles) {
        assertEquals(promised, new NormalsTopic().isPromised(new TriangleSurface(xyz, triangles)));
    }

    static Stream<Arguments> mistakes() {
        int[] one = {0, 1, 2};
        double[] flat = {0, 0, 0, 4, 0, 0, 0, 3, 0};
        double[] huge = {0, 0, 0, 4e74, 0, 0, 0, 3e74, 0};
        double[] narrow = {0, 0, 0, 4, 0, 0, 0, 0.03, 0};
        double[] apart = {0, 0, 0, 4, 0, 0, 0, 0.05, 0};
        double[] far = {900, 0, 0, 904, 0, 0, 900, 3, 0};
        double[] folded = {0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 3, 0.1};
        return Stream.of(
                argumentSet("nothing is promised", true, flat, one),
                argumentSet("squares of large coordinates overflow", true, huge, one),
                argumentSet("a narrow face is promised", false, narrow, one),
                argumentSet("a face wider than a hundredth is not", true, apart, one),
                argumentSet("sides that rounding moves are promised", false, far, one),
                argumentSet(
                        "faces that cancel are promised",
                        false,
                        folded,
                        new int[] {0, 1, 2, 1, 0, 3}));
    }
}
