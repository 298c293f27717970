package rasterlab.app.exercise.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.Icon;

/** An icon made as small as a line of text. */
record SmallIcon(Icon icon) implements Icon {
    private static final int SIDE = 13;

    @Override
    public void paintIcon(Component shown, Graphics graphics, int x, int y) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.translate(x, y);
        double scale = (double) getIconWidth() / icon.getIconWidth();
        g.scale(scale, scale);
        icon.paintIcon(shown, g, 0, 0);
        g.dispose();
    }

    @Override
    public int getIconWidth() {
        return UIScale.scale(SIDE);
    }

    @Override
    public int getIconHeight() {
        return UIScale.scale(SIDE);
    }
}
