package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.transform.GlMatrices;

/** A triangle that leans far back: what only points somewhere, and what is more than that. */
class DirectionsTest {
    private static final int SIDE = 16;
    private static final Set<VertexQuantity> PLACE =
            EnumSet.of(VertexQuantity.X, VertexQuantity.Y, VertexQuantity.Z);

    /** Keeps what the pixels get. */
    private static final class Seen implements PixelColors {
        private final Set<VertexQuantity> wants;
        private final Set<VertexQuantity> directions;
        private final Map<VertexQuantity, float[]> values = new EnumMap<>(VertexQuantity.class);

        Seen(Set<VertexQuantity> wants, Set<VertexQuantity> directions) {
            this.wants = wants;
            this.directions = directions;
        }

        @Override
        public Set<VertexQuantity> wants() {
            return wants;
        }

        @Override
        public Set<VertexQuantity> directions() {
            return directions;
        }

        @Override
        public void color(PixelBatch batch) {
            for (VertexQuantity each : wants)
                values.put(each, Arrays.copyOf(batch.values(each), batch.count));
        }

        double of(VertexQuantity quantity, int pixel) {
            return values.get(quantity)[pixel];
        }

        double length(int pixel) {
            return Math.sqrt(PLACE.stream().mapToDouble(q -> of(q, pixel) * of(q, pixel)).sum());
        }
    }

    private static Seen draw(Seen colors) {
        var mesh =
                TriangleMesh.of(
                                new float[] {-1, 1, 0},
                                new float[] {-1, -1, 1},
                                new float[] {-2, -2, -8},
                                new int[] {0, 1, 2})
                        .withColors(
                                new float[] {0, 0.5f, 1},
                                new float[3],
                                new float[3],
                                new float[] {1, 1, 1});
        var view =
                new TriangleView(
                        new Matrix4d(),
                        GlMatrices.perspective(60, 1, 1, 10),
                        List.of(),
                        Culling.NONE);
        try (var pipeline = new TrianglePipeline(1)) {
            var surface = new Surface.PerPixel(colors);
            pipeline.drawOn(0, mesh, view, surface, new DepthRaster(SIDE, SIDE), () -> false);
        }
        return colors;
    }

    @Test
    void pointTheSameWayWithoutTheDivisionByW() {
        var exact = draw(new Seen(PLACE, Set.of()));
        var pointing = draw(new Seen(PLACE, PLACE));
        int pixels = exact.values.get(VertexQuantity.X).length;
        for (int i = 0; i < pixels; i++)
            for (VertexQuantity each : PLACE)
                assertEquals(
                        exact.of(each, i) / exact.length(i),
                        pointing.of(each, i) / pointing.length(i),
                        1e-6,
                        "pixel " + i + ", " + each);
        assertNotEquals(exact.length(0), pointing.length(0), 0.1, "the division was made");
    }

    @Test
    void leaveOtherValuesDivided() {
        var both = EnumSet.of(VertexQuantity.RED);
        both.addAll(PLACE);
        var exact = draw(new Seen(both, Set.of()));
        var pointing = draw(new Seen(both, PLACE));
        int pixels = exact.values.get(VertexQuantity.RED).length;
        for (int i = 0; i < pixels; i++)
            assertEquals(
                    exact.of(VertexQuantity.RED, i),
                    pointing.of(VertexQuantity.RED, i),
                    1e-6,
                    "pixel " + i);
    }
}
