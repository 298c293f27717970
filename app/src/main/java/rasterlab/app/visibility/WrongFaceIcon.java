package rasterlab.app.visibility;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.PixelMark;

/** The sign of a pixel that shows a wrong face: in the colour and edge of marked areas. */
final class WrongFaceIcon extends FlatAbstractIcon {
    /** The size, as large as the other kinds' marks. */
    private static final int SIZE = 16;

    private static final Color EDGE = new Color(PictureDifference.EDGE);

    WrongFaceIcon() {
        super(SIZE, SIZE, null);
    }

    /** Draws the sign into the middle of the square with its upper left corner at (x, y). */
    static void paint(Graphics2D g, int x, int y, int size) {
        int inset = size / 5;
        int edge = Math.max(1, size / 10);
        g.setColor(EDGE);
        g.fillRect(x + inset, y + inset, size - 2 * inset, size - 2 * inset);
        int within = inset + edge;
        g.setColor(PixelMark.COLOR);
        g.fillRect(x + within, y + within, size - 2 * within, size - 2 * within);
    }

    @Override
    protected void paintIcon(Component c, Graphics2D g) {
        paint(g, 0, 0, SIZE);
    }
}
