package rasterlab.app.canvas;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.Component;
import java.awt.Graphics2D;
import rasterlab.engine.raster.PixelMark;

/** The mark of a wrong pixel beside its count in an inspector. */
public final class PixelMarkIcon extends FlatAbstractIcon {
    private static final int SIZE = 16;

    private final PixelMark mark;

    public PixelMarkIcon(PixelMark mark) {
        super(SIZE, SIZE, null);
        this.mark = mark;
    }

    @Override
    protected void paintIcon(Component c, Graphics2D g) {
        mark.paint(g, 0, 0, SIZE);
    }
}
