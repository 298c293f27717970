package rasterlab.app.shell.settings;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Font;
import java.util.Map;
import javax.swing.UIManager;
import javax.swing.plaf.InsetsUIResource;
import rasterlab.app.canvas.StageColors;

/** The window's colours; the projector's are also shown in larger type. */
public enum LabTheme {
    LIGHT(1, Map.of()),
    DARK(1, Map.of()),
    /** Black on white, so that the last row reads it in a room that is not dark. */
    PROJECTOR(
            1.35,
            Map.of(
                    "@background", "#ffffff",
                    "@foreground", "#000000",
                    "@disabledForeground", "#5a5a5a",
                    "@accentColor", "#0050b3",
                    "Component.borderColor", "#3c3c3c",
                    "Separator.foreground", "#3c3c3c",
                    "Component.focusWidth", "2",
                    "Label.disabledForeground", "#5a5a5a"));

    private final double type;
    private final Map<String, String> colors;

    LabTheme(double type, Map<String, String> colors) {
        this.type = type;
        this.colors = colors;
    }

    /** Makes the theme the look of every component created from now on, in type of usual size. */
    public void install() {
        install(100);
    }

    /**
     * Makes the theme the look of every component created from now on.
     *
     * @param textPercent size of the type, 100 for the system's
     */
    public void install(int textPercent) {
        FlatLaf.setGlobalExtraDefaults(colors);
        // This comes before any other use of UIManager, which would set up Java's own look.
        if (this == DARK) FlatDarkLaf.setup();
        else FlatLightLaf.setup();
        UIManager.put(StageColors.HIGH_CONTRAST, this == PROJECTOR);
        Font usual = UIManager.getLookAndFeelDefaults().getFont("defaultFont");
        double size = usual.getSize2D() * type * textPercent / 100;
        UIManager.put("defaultFont", usual.deriveFont((float) size));
        UIManager.put("ScrollBar.showButtons", false);
        UIManager.put("TabbedPane.showTabSeparators", true);
        // Ten Russian titles fit beside each other in a window 1280 pixels wide.
        UIManager.put("TabbedPane.tabInsets", new InsetsUIResource(4, 7, 4, 7));
        UIManager.put("ToolTip.maximumWidth", 420);
    }
}
