package rasterlab.app.shell;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import rasterlab.app.canvas.method.MethodColors;

/** The product's sign: a segment of four pixels on a 4×4 grid. */
final class BrandIcon extends FlatAbstractIcon {
    private static final int[] ROWS = {3, 2, 2, 1};

    BrandIcon() {
        super(18, 18, null);
    }

    @Override
    protected void paintIcon(Component c, Graphics2D g) {
        boolean dark = FlatLaf.isLafDark();
        Color line = dark ? MethodColors.SKY_BLUE : MethodColors.BLUE;
        Color grid = dark ? Color.LIGHT_GRAY : MethodColors.SKY_BLUE;
        for (int x = 0; x < 4; x++) {
            for (int y = 0; y < 4; y++) {
                boolean lit = ROWS[x] == y;
                g.setColor(lit ? line : grid);
                int size = lit ? 4 : 1;
                int inset = (4 - size) / 2;
                g.fillRect(1 + x * 4 + inset, 1 + y * 4 + inset, size, size);
            }
        }
    }
}
