package rasterlab.app.study.chart;

import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.Optional;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.measuring.Machine;

/** The words that tell when and where a study was measured, in one language. */
public final class ConditionsWords {
    private final Language language;
    private final Texts texts;

    public ConditionsWords(Language language) {
        this.language = language;
        texts = Texts.of("study", language);
    }

    /**
     * When and where a study was measured, and the load that its machine had; empty where nobody
     * knows.
     */
    public Optional<String> measuredOn(Study study) {
        return study.circumstances().map(this::measuredOn);
    }

    /** Says that a result is none of this machine, but came with the program, and its machine. */
    public String shipped(Study study) {
        return texts.text(
                "measured.shipped",
                measuredOn(study).orElse(""),
                study.circumstances().map(how -> how.machine().java()).orElse(""));
    }

    private String measuredOn(StudyConditions how) {
        String when =
                DateTimeFormatter.ofLocalizedDateTime(FormatStyle.MEDIUM, FormatStyle.SHORT)
                        .withLocale(language.locale())
                        .withZone(ZoneId.systemDefault())
                        .format(how.begun());
        Machine where = how.machine();
        String date =
                texts.text(
                        how.whole() ? "measured.on" : "measured.part",
                        when,
                        where.processor(),
                        where.cores());
        boolean told = how.loadBefore() >= 0 && how.loadAfter() >= 0;
        return told
                ? texts.text("measured.load", date, load(how.loadBefore()), load(how.loadAfter()))
                : date + ".";
    }

    private String load(double processes) {
        return String.format(language.locale(), "%.1f", processes);
    }
}
