package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class EndLabelTest {
    private static final Point2D END = new Point2D.Double(160, 130);

    private static Rectangle place(List<Point2D> lamps) {
        return EndLabel.place(END, 16, 18, lamps, new Rectangle());
    }

    @Test
    void standsBelowTheEnd() {
        assertEquals(new Rectangle(152, 140, 16, 18), place(List.of()));
    }

    @Test
    void nameOfAPictureLeavesTheLampInItsCorner() {
        var picture = new Dimension(300, 380);
        var corner = new Rectangle(7, 7, 80, 18);
        assertEquals(corner, EndLabel.corner(picture, 80, 18, List.of(END)));
        Rectangle other = EndLabel.corner(picture, 80, 18, List.of(new Point2D.Double(40, 12)));
        assertFalse(other.intersects(28, 0, 24, 24), other + " lies over the lamp");
        assertTrue(new Rectangle(picture).contains(other), other + " is cut");
    }

    @Test
    void leavesEachLampInSight() {
        var lamps = new ArrayList<Point2D>();
        for (Point2D lamp :
                List.of(
                        new Point2D.Double(155, 160),
                        new Point2D.Double(165, 100),
                        new Point2D.Double(125, 130))) {
            lamps.add(lamp);
            Rectangle place = place(lamps);
            for (Point2D each : lamps)
                assertFalse(
                        place.intersects(each.getX() - 12, each.getY() - 12, 24, 24),
                        place + " lies over a lamp at " + each);
        }
    }
}
