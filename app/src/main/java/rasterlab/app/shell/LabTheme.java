package rasterlab.app.shell;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import javax.swing.UIManager;

/** The window's light and dark look. */
public enum LabTheme {
    LIGHT,
    DARK;

    /** Makes the theme the look of every component created from now on. */
    public void install() {
        if (this == DARK) FlatDarkLaf.setup();
        else FlatLightLaf.setup();
        UIManager.put("ScrollBar.showButtons", false);
        UIManager.put("TabbedPane.showTabSeparators", true);
        UIManager.put("ToolTip.maximumWidth", 420);
    }

    /** Makes the theme the look of every open window. */
    public void installEverywhere() {
        install();
        FlatLaf.updateUI();
    }

    public LabTheme other() {
        return this == LIGHT ? DARK : LIGHT;
    }
}
