package rasterlab.app.canvas.lab;

import java.util.Locale;
import rasterlab.app.language.Texts;

/** Why no tab shows inputs of a topic. */
public enum NotShown {
    /** No tab is about the topic. */
    NO_TAB,
    /** Cases whose fields no tab reads. */
    NO_READER,
    /** No tab has the user's own program among its methods. */
    NO_OWN;

    /** The reason in the language of the texts, those of {@code canvas}. */
    public String in(Texts texts, String topic) {
        return texts.text("unshown." + code(), topic);
    }

    /** Lower-case name with hyphens. */
    String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
