package rasterlab.app.cli;

import java.util.Locale;
import java.util.ResourceBundle;

/** The languages a report is printed in. */
enum ReportLanguage {
    EN,
    RU;

    /** "en" or "ru". */
    String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    ResourceBundle texts() {
        return ResourceBundle.getBundle(
                "rasterlab.app.cli.report",
                Locale.forLanguageTag(code()),
                ResourceBundle.Control.getNoFallbackControl(
                        ResourceBundle.Control.FORMAT_PROPERTIES));
    }
}
