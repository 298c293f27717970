package rasterlab.app.shell;

import javax.swing.UIManager;
import rasterlab.app.shell.settings.LabTheme;

/** Themes in the type of a desktop, which is larger than that of a machine without a display. */
public final class DesktopType {
    /** The pixels of 10 points on a screen of 100 dots per inch. */
    private static final double PIXELS = 14;

    private DesktopType() {}

    /** Installs a theme, on the event thread. */
    public static void install(LabTheme theme, int textPercent) {
        LabTheme.LIGHT.install();
        double usual = UIManager.getFont("defaultFont").getSize2D();
        theme.install((int) Math.round(textPercent * PIXELS / usual));
    }
}
