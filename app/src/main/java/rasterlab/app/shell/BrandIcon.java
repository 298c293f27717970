package rasterlab.app.shell;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.Component;
import java.awt.Graphics2D;
import rasterlab.app.canvas.MethodColours;

/** The product's sign: a segment of four pixels on a 4×4 grid. */
final class BrandIcon extends FlatAbstractIcon {
    private static final int[] ROWS = {3, 2, 2, 1};

    BrandIcon() {
        super(18, 18, null);
    }

    @Override
    protected void paintIcon(Component c, Graphics2D g) {
        for (int x = 0; x < 4; x++) {
            for (int y = 0; y < 4; y++) {
                boolean lit = ROWS[x] == y;
                g.setColor(lit ? MethodColours.BLUE : MethodColours.SKY_BLUE);
                int size = lit ? 4 : 1;
                int inset = (4 - size) / 2;
                g.fillRect(1 + x * 4 + inset, 1 + y * 4 + inset, size, size);
            }
        }
    }
}
