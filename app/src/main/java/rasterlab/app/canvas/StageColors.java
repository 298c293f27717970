package rasterlab.app.canvas;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import javax.swing.UIManager;

/**
 * The colours of a stage around what the methods draw.
 *
 * @param ground behind everything
 * @param grid lines between pixels
 * @param axis lines through pixel (0, 0)
 * @param ink the exact line, handles and read-outs
 * @param margin behind the rulers
 * @param focus around what has the keyboard
 */
public record StageColors(
        Color ground, Color grid, Color axis, Color ink, Color margin, Color focus) {
    /** Key of {@code UIManager} that says whether the theme is one of high contrast. */
    public static final String HIGH_CONTRAST = "Rasterlab.highContrast";

    public static final StageColors LIGHT =
            new StageColors(
                    Color.WHITE,
                    new Color(0xE3E6EA),
                    new Color(0x9AA3AD),
                    new Color(0x1B1F24),
                    new Color(0xF3F5F7),
                    new Color(0x0A63C9));

    public static final StageColors DARK =
            new StageColors(
                    new Color(0x1B1D20),
                    new Color(0x33373C),
                    new Color(0x767E87),
                    new Color(0xF0F2F4),
                    new Color(0x25282C),
                    new Color(0x6CB2FF));

    /** The colours for a projector, whose weak greys are lost on the wall. */
    public static final StageColors PROJECTOR =
            new StageColors(
                    Color.WHITE,
                    new Color(0xB4BAC2),
                    new Color(0x4A5159),
                    Color.BLACK,
                    Color.WHITE,
                    new Color(0x0050B3));

    /** The colours for the theme that is installed. */
    public static StageColors now() {
        if (UIManager.getBoolean(HIGH_CONTRAST)) return PROJECTOR;
        return FlatLaf.isLafDark() ? DARK : LIGHT;
    }
}
