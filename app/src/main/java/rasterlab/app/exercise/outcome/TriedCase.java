package rasterlab.app.exercise.outcome;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.topic.CaseRules;
import rasterlab.exercises.topic.CaseRules.CaseRule;

/**
 * One case of a result.
 *
 * @param verdict a code, as in the HTTP API; "" for a case that was not tried yet, or whose verdict
 *     may still change
 * @param said why points were lost
 * @param rule how an answer is compared, and what makes it right; nothing where that is not told
 * @param scene the case as a scene file; "" where it is hidden
 */
public record TriedCase(
        String name,
        String verdict,
        int points,
        int of,
        LocalizedText said,
        LocalizedText rule,
        List<TriedPicture> pictures,
        String scene) {
    public TriedCase {
        pictures = List.copyOf(pictures);
    }

    /** A case of which it is not told what makes an answer right. */
    public TriedCase(
            String name,
            String verdict,
            int points,
            int of,
            LocalizedText said,
            List<TriedPicture> pictures,
            String scene) {
        this(name, verdict, points, of, said, LocalizedText.NOTHING, pictures, scene);
    }

    static TriedCase of(CaseReport report) {
        return new TriedCase(
                report.name(),
                report.verdict().code(),
                report.points(),
                report.of(),
                LocalizedText.of(report::message),
                report.pictures().stream().map(TriedPicture::of).toList(),
                report.scene());
    }

    /** A case of that exercise, with what makes an answer right. */
    public static TriedCase of(Exercise exercise, CaseReport report) {
        TriedCase judged = of(report);
        return CaseRules.of(exercise, report.name())
                .map(
                        right ->
                                new LocalizedText(
                                        rule(Language.ENGLISH, right),
                                        rule(Language.RUSSIAN, right)))
                .map(judged::under)
                .orElse(judged);
    }

    private static String rule(Language language, CaseRule right) {
        String code = language.locale().getLanguage();
        return rule(language, right.tolerance().in(code), right.rule().in(code));
    }

    /** How an answer is compared, and where there is one the rule, as a sentence each. */
    public static String rule(Language language, String tolerance, String rule) {
        Texts texts = Texts.of("exercise", language);
        if (tolerance.isEmpty()) return "";
        String compared = texts.text("compared", tolerance);
        return rule.isEmpty() ? compared : compared + " " + texts.text("rule", rule);
    }

    public TriedCase under(LocalizedText next) {
        return new TriedCase(name, verdict, points, of, said, next, pictures, scene);
    }

    /** The open cases of an exercise, none of them tried. */
    public static List<TriedCase> untried(Exercise exercise) {
        return exercise.cases().stream()
                .filter(one -> one.visibility() == Disclosure.OPEN)
                .map(TriedCase::untried)
                .toList();
    }

    private static TriedCase untried(Exercise.Case one) {
        return new TriedCase(one.name(), "", 0, one.points(), LocalizedText.NOTHING, List.of(), "");
    }

    /**
     * The cases, of which those whose own names are kept from the student get numbers, by which
     * they are chosen.
     */
    public static List<TriedCase> toldApart(List<TriedCase> cases) {
        var toldApart = new ArrayList<TriedCase>();
        int hidden = 0;
        for (TriedCase one : cases)
            toldApart.add(
                    CaseReport.isHidden(one.name) ? one.called(CaseReport.hidden(++hidden)) : one);
        return List.copyOf(toldApart);
    }

    private TriedCase called(String next) {
        return new TriedCase(next, verdict, points, of, said, rule, pictures, scene);
    }

    public TriedCase withoutVerdict() {
        return new TriedCase(name, "", 0, of, LocalizedText.NOTHING, rule, List.of(), scene);
    }

    /** Pixels that its pictures show; 0 where it has none. */
    public int pixels() {
        return pictures.stream()
                .map(one -> CaseDrawing.pixels(one.rows()))
                .mapToInt(size -> size.width * size.height)
                .max()
                .orElse(0);
    }

    public boolean right() {
        return verdict.equals(GradingVerdict.OK.code());
    }
}
