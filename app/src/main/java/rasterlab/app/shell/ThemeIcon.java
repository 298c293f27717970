package rasterlab.app.shell;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import rasterlab.app.shell.settings.LabTheme;

/** A sun, a moon or a projector's screen: the theme that is worn. */
final class ThemeIcon extends FlatAbstractIcon {
    private final LabTheme theme;

    ThemeIcon(LabTheme theme) {
        super(16, 16, null);
        this.theme = theme;
    }

    @Override
    protected void paintIcon(Component c, Graphics2D g) {
        g.setColor(c.getForeground());
        if (theme == LabTheme.DARK) {
            var moon = new Area(new Ellipse2D.Double(2, 2, 12, 12));
            moon.subtract(new Area(new Ellipse2D.Double(6, 0.5, 11, 11)));
            g.fill(moon);
            return;
        }
        if (theme == LabTheme.PROJECTOR) {
            g.fill(new Rectangle2D.Double(1, 2, 14, 1.6));
            g.setStroke(new BasicStroke(1.3f));
            g.draw(new Rectangle2D.Double(2.5, 3, 11, 7.5));
            g.draw(new Line2D.Double(8, 10.5, 5, 14.5));
            g.draw(new Line2D.Double(8, 10.5, 11, 14.5));
            return;
        }
        g.fill(new Ellipse2D.Double(5, 5, 6, 6));
        g.setStroke(new BasicStroke(1.3f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        for (int ray = 0; ray < 8; ray++) {
            double dx = Math.cos(ray * Math.PI / 4);
            double dy = Math.sin(ray * Math.PI / 4);
            g.draw(new Line2D.Double(8 + 5 * dx, 8 + 5 * dy, 8 + 7 * dx, 8 + 7 * dy));
        }
    }
}
