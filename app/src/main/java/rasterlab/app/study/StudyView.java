package rasterlab.app.study;

import java.util.Locale;

/** The state that the tab of speed and accuracy shows. */
public enum StudyView {
    CHART,
    HAZARDS;

    /** Lower-case name, the key of its texts. */
    String code() {
        return name().toLowerCase(Locale.ROOT);
    }
}
