package rasterlab.app.shell.settings;

import java.awt.Rectangle;
import java.util.Optional;
import rasterlab.app.canvas.file.LastChosen;
import rasterlab.app.language.Language;

/**
 * The settings that the window keeps between runs.
 *
 * @param tab name of the tab that was shown
 * @param bounds where the window was on the screen, in view units; empty before the first run
 * @param maximised whether it filled the screen
 * @param controls whether the labs showed the column of controls beside their picture
 * @param chosen with which dialogs for files begin
 */
public record LabSettings(
        LabLook look,
        String tab,
        Optional<Rectangle> bounds,
        boolean maximised,
        boolean controls,
        LastChosen chosen) {
    /** A first run opens on the lab that is understood soonest. */
    private static final String FIRST_TAB = "line";

    public LabSettings {
        bounds = bounds.map(Rectangle::new);
    }

    /** The settings of a first run. */
    public static LabSettings first(Language language) {
        return new LabSettings(
                LabLook.first(language), FIRST_TAB, Optional.empty(), false, true, LastChosen.NONE);
    }

    public LabSettings with(LabLook other) {
        return new LabSettings(other, tab, bounds, maximised, controls, chosen);
    }

    public LabSettings at(String shownTab, Rectangle place, boolean filled) {
        return new LabSettings(look, shownTab, Optional.of(place), filled, controls, chosen);
    }

    public LabSettings with(LastChosen other) {
        return new LabSettings(look, tab, bounds, maximised, controls, other);
    }

    public LabSettings withControls(boolean shown) {
        return new LabSettings(look, tab, bounds, maximised, shown, chosen);
    }
}
