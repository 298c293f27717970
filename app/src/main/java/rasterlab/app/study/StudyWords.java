package rasterlab.app.study;

import java.util.List;
import java.util.stream.Collectors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

/** What a chart or a table says about a study, in one language. */
public final class StudyWords {
    private final Texts texts;

    public StudyWords(Language language) {
        texts = Texts.of("study", language);
    }

    /** What is counted, in the singular; in English where it has no translation. */
    public String item(Study study) {
        return texts.textOr("item." + study.item(), study.item());
    }

    /** Unit of the error; in English where it has no translation. */
    public String errorUnit(Study study) {
        return texts.textOr("unit." + study.errorUnit(), study.errorUnit());
    }

    String title(Study study) {
        return texts.text("chart.title", study.topic());
    }

    String costAxis(Study study) {
        return texts.text("chart.cost", item(study));
    }

    String errorAxis(Study study) {
        return texts.text("chart.error", errorUnit(study));
    }

    /** What stands for an error of zero. */
    String exact() {
        return texts.text("chart.exact");
    }

    String notTimed() {
        return texts.text("chart.notTimed");
    }

    /**
     * @param kind refused, endless or crashed
     * @param sizes at which a method ended so
     */
    String reason(Verdict.Kind kind, List<Integer> sizes) {
        String listed = sizes.stream().map(String::valueOf).collect(Collectors.joining(", "));
        return texts.text("chart." + kind.code(), listed);
    }
}
