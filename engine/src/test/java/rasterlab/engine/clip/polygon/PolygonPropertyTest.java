package rasterlab.engine.clip.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** Checks properties of both methods on every convex window and every simple subject. */
class PolygonPropertyTest {
    private static final int TRIES = 500;
    private static final List<String> METHODS = List.of("sutherland-hodgman", "weiler-atherton");
    private static final double ROUNDING = 1e-12;

    @Provide
    Arbitrary<double[]> subjects() {
        return Arbitraries.integers()
                .between(-3, 9)
                .array(Integer[].class)
                .ofMinSize(6)
                .ofMaxSize(14)
                .map(
                        xy ->
                                Arrays.stream(xy)
                                        .limit(xy.length / 2 * 2)
                                        .mapToDouble(Integer::doubleValue)
                                        .toArray());
    }

    private static double[] window(int turned) {
        double[] corners = {0, 1, 5, 0, 6, 6, 1, 5};
        double[] window = new double[8];
        for (int i = 0; i < 8; i++) window[i] = corners[(i + 2 * turned) % 8];
        return window;
    }

    @Property(tries = TRIES, maxDiscardRatio = 50)
    void piecesLieInTheWindow(@ForAll("subjects") double[] subject) {
        Assume.that(PolygonCases.proper(window(0), subject));
        Ring window = ConvexWindow.of(window(0));
        for (String method : METHODS)
            for (double[] piece : PolygonCases.clip(method, window(0), subject))
                for (int side = 0; side < 4; side++)
                    for (int i = 0; i < piece.length; i += 2)
                        assertTrue(
                                outside(window, side, piece[i], piece[i + 1]) <= ROUNDING, method);
    }

    private static double outside(Ring window, int side, double x, double y) {
        double wayX = window.x(side + 1) - window.x(side);
        double wayY = window.y(side + 1) - window.y(side);
        return wayY * (x - window.x(side)) - wayX * (y - window.y(side));
    }

    @Property(tries = TRIES, maxDiscardRatio = 50)
    void theOrderOfTheSidesIsIrrelevant(
            @ForAll("subjects") double[] subject, @ForAll @IntRange(min = 1, max = 3) int turned) {
        Assume.that(PolygonCases.proper(window(0), subject));
        for (String method : METHODS)
            assertSame(
                    PolygonCases.clip(method, window(0), subject),
                    PolygonCases.clip(method, window(turned), subject));
    }

    @Property(tries = TRIES, maxDiscardRatio = 50)
    void theSubjectsDirectionIsIrrelevant(@ForAll("subjects") double[] subject) {
        Assume.that(PolygonCases.proper(window(0), subject));
        double[] back = subject.clone();
        for (int i = 0; i < back.length; i += 2) {
            back[i] = subject[back.length - 2 - i];
            back[i + 1] = subject[back.length - 1 - i];
        }
        for (String method : METHODS)
            assertSame(
                    PolygonCases.clip(method, window(0), subject),
                    PolygonCases.clip(method, window(0), back));
    }

    /** Where a piece touches itself or is not simple by rounding, it is no subject. */
    @Property(tries = TRIES, maxDiscardRatio = 50)
    void clippingAgainChangesNothing(@ForAll("subjects") double[] subject) {
        for (double[] window : List.of(PolygonInWindow.rectangle(0, 0, 6, 6), window(0))) {
            Assume.that(PolygonCases.proper(window, subject));
            for (String method : METHODS)
                for (double[] piece : PolygonCases.clip(method, window, subject))
                    if (PolygonCases.proper(window, piece))
                        assertSame(List.of(piece), PolygonCases.clip(method, window, piece));
        }
    }

    /** Nothing is lost and nothing is twice where two windows meet. */
    @Property(tries = TRIES, maxDiscardRatio = 50)
    void aHalfOnEachSideOfALineIsTheWhole(
            @ForAll("subjects") double[] subject, @ForAll @IntRange(min = -2, max = 8) int line) {
        double[] left = PolygonInWindow.rectangle(-5, -5, line, 12);
        double[] right = PolygonInWindow.rectangle(line, -5, 12, 12);
        Assume.that(PolygonCases.proper(left, subject));
        double whole = Math.abs(PolygonArea.of(subject));
        for (String method : METHODS)
            assertEquals(
                    whole,
                    area(PolygonCases.clip(method, left, subject))
                            + area(PolygonCases.clip(method, right, subject)),
                    1e-10);
    }

    private static double area(List<double[]> pieces) {
        return pieces.stream().mapToDouble(PolygonArea::of).sum();
    }

    private static void assertSame(List<double[]> pieces, List<double[]> others) {
        assertEquals(pieces.size(), others.size());
        assertTrue(AreaBetween.of(pieces, others) <= ROUNDING);
    }
}
