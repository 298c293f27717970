package rasterlab.app.shell.settings;

import java.util.List;
import rasterlab.app.language.Language;

/**
 * How the window looks and speaks.
 *
 * @param textPercent size of the type, one of {@link #SIZES}; 100 is the system's
 */
public record LabLook(LabTheme theme, Language language, int textPercent) {
    /** The sizes of type that can be chosen, ascending, in percent of the system's. */
    public static final List<Integer> SIZES = List.of(75, 90, 100, 110, 125, 150, 175, 200);

    private static final int USUAL = 100;

    public LabLook {
        if (!SIZES.contains(textPercent))
            throw new IllegalArgumentException(
                    "text size must be one of " + SIZES + " %, got " + textPercent);
    }

    /** Light and in type of usual size. */
    public static LabLook first(Language language) {
        return new LabLook(LabTheme.LIGHT, language, USUAL);
    }

    public LabLook with(LabTheme other) {
        return new LabLook(other, language, textPercent);
    }

    public LabLook with(Language other) {
        return new LabLook(theme, other, textPercent);
    }

    /** The look in the next larger type, the same at the end of the list. */
    public LabLook larger() {
        return resized(1);
    }

    /** The look in the next smaller type, the same at the end of the list. */
    public LabLook smaller() {
        return resized(-1);
    }

    public LabLook usualSize() {
        return new LabLook(theme, language, USUAL);
    }

    private LabLook resized(int by) {
        int next = SIZES.indexOf(textPercent) + by;
        int size = SIZES.get(Math.max(0, Math.min(SIZES.size() - 1, next)));
        return new LabLook(theme, language, size);
    }
}
