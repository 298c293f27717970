package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CubePainterTest {
    private static final double HIGH = 17;
    private static final double CORNER = 6;

    @ParameterizedTest
    @DisplayName("a long name beside its corner covers it")
    @ValueSource(doubles = {20, 90, 200})
    void namesLeaveTheirCornersFree(double wide) {
        for (int degrees = 0; degrees < 360; degrees++) {
            double dx = 100 * Math.cos(Math.toRadians(degrees));
            double dy = 100 * Math.sin(Math.toRadians(degrees));
            Point2D away = CubePainter.away(dx, dy, wide, HIGH);
            var plate =
                    new Rectangle2D.Double(
                            away.getX() - wide / 2 - 4, away.getY() - HIGH / 2, wide + 8, HIGH);
            var corner = new Rectangle2D.Double(-CORNER, -CORNER, 2 * CORNER, 2 * CORNER);
            assertFalse(plate.intersects(corner), degrees + "°");
            assertTrue(away.getX() * dx + away.getY() * dy > 0, degrees + "° inwards");
        }
    }

    @ParameterizedTest
    @DisplayName("the corner in the middle has no direction outwards")
    @ValueSource(doubles = {0, 0.5})
    void aCornerInTheMiddleHasItsNameBelow(double dx) {
        Point2D away = CubePainter.away(dx, 0, 60, HIGH);
        assertTrue(away.getX() == 0 && away.getY() > HIGH / 2, away.toString());
    }
}
