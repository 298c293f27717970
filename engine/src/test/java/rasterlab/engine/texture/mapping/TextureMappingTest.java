package rasterlab.engine.texture.mapping;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.study.Deviation;

class TextureMappingTest {
    private static final MappingTopic TOPIC = new MappingTopic();

    @Property(tries = 300)
    void perspectiveIsExact(@ForAll long seed) {
        var random = new Random(seed);
        double[] s = random.doubles(4, -1000, 1000).toArray();
        double near = Math.pow(10, random.nextDouble(-6, 6));
        double far = Math.pow(10, random.nextDouble(-6, 6));
        var span = new TexturedSpan(s[0], s[1], near, s[2], s[3], far, 1 + random.nextInt(40));
        Deviation deviation =
                TOPIC.compare(
                        span,
                        TOPIC.exact(span, 99),
                        TOPIC.record(TOPIC.method("perspective").implementation(), span, 99));
        assertTrue(TOPIC.correct(deviation), () -> span + " " + deviation);
    }

    @Test
    void affineMappingPutsHalfTheFloorInTheMiddle() {
        var span = new TexturedSpan(0, 0, 1, 1, 1, 3, 3);
        assertArrayEquals(
                new double[] {0, 0, 0.5, 0.5, 1, 1},
                TOPIC.method("affine").implementation().coordinates(span));
        assertArrayEquals(
                new double[] {0, 0, 0.25, 0.25, 1, 1},
                TOPIC.method("perspective").implementation().coordinates(span));
    }

    @Test
    void piecesSaveDivisions() {
        var row = new TexturedSpan(0, 0, 1, 1, 1, 3, 320);
        assertEquals(7, divisions("affine", row));
        assertEquals(20 * 7, divisions("affine-16", row));
        assertEquals(2 * 320 + 9, divisions("stepped-float", row));
        assertEquals(3 * 320, divisions("perspective", row));
    }

    private static long divisions(String method, TexturedSpan row) {
        return TOPIC.operations(TOPIC.method(method).implementation(), row).get("divisions");
    }

    @Test
    void piecesAreRightWhereTheyMeet() {
        var span = new TexturedSpan(0, 0, 1, 1, 1, 50, 100);
        double[] right = TOPIC.method("perspective").implementation().coordinates(span);
        double[] pieces = TOPIC.method("affine-16").implementation().coordinates(span);
        for (int i = 0; i < 100; i += 16) assertEquals(right[2 * i], pieces[2 * i], 1e-15);
        assertEquals(right[198], pieces[198], 1e-15);
    }

    @Test
    void refusesADepthBehindTheEye() {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new TexturedSpan(0, 0, -1, 1, 1, 1, 2));
        assertEquals("from[2] must be from 1.0E-6 to 1000000.0, got -1.0", refusal.getMessage());
    }
}
