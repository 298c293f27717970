package rasterlab.app.canvas.method;

import java.awt.Color;
import javax.swing.UIManager;

/** The colour of words that stand back behind others but are to be read. */
public final class SecondaryText {
    private SecondaryText() {}

    /**
     * A colour as pale as the present theme's switched-off words, with a contrast of at least 4.5.
     */
    public static Color on(Color ground) {
        return MethodColors.textOn(ground, UIManager.getColor("Label.disabledForeground"));
    }
}
