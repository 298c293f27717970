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
 * @param message why points were lost
 * @param rule how an answer is compared, and what makes it right; nothing where that is not told
 * @param scene the case as a scene file; "" where it is hidden
 */
public record CaseResult(
        String name,
        String verdict,
        int points,
        int of,
        LocalizedText message,
        LocalizedText rule,
        List<ResultPicture> pictures,
        String scene) {
    public CaseResult {
        pictures = List.copyOf(pictures);
    }

    /** A case of which it is not told what makes an answer right. */
    public CaseResult(
            String name,
            String verdict,
            int points,
            int of,
            LocalizedText said,
            List<ResultPicture> pictures,
            String scene) {
        this(name, verdict, points, of, said, LocalizedText.NOTHING, pictures, scene);
    }

    static CaseResult of(CaseReport report) {
        return new CaseResult(
                report.name(),
                report.verdict().code(),
                report.points(),
                report.of(),
                LocalizedText.of(report::message),
                report.pictures().stream().map(ResultPicture::of).toList(),
                report.scene());
    }

    /** A case of that exercise, with what makes an answer right. */
    public static CaseResult of(Exercise exercise, CaseReport report) {
        CaseResult judged = of(report);
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

    public CaseResult under(LocalizedText next) {
        return new CaseResult(name, verdict, points, of, message, next, pictures, scene);
    }

    /** The open cases of an exercise, none of them tried. */
    public static List<CaseResult> untried(Exercise exercise) {
        return exercise.cases().stream()
                .filter(one -> one.visibility() == Disclosure.OPEN)
                .map(CaseResult::untried)
                .toList();
    }

    private static CaseResult untried(Exercise.Case one) {
        return new CaseResult(
                one.name(), "", 0, one.points(), LocalizedText.NOTHING, List.of(), "");
    }

    /**
     * The cases, of which those whose own names are kept from the student get numbers, by which
     * they are chosen.
     */
    public static List<CaseResult> numbered(List<CaseResult> cases) {
        var toldApart = new ArrayList<CaseResult>();
        int hidden = 0;
        for (CaseResult one : cases)
            toldApart.add(
                    CaseReport.isHidden(one.name) ? one.called(CaseReport.hidden(++hidden)) : one);
        return List.copyOf(toldApart);
    }

    private CaseResult called(String next) {
        return new CaseResult(next, verdict, points, of, message, rule, pictures, scene);
    }

    public CaseResult withoutVerdict() {
        return new CaseResult(name, "", 0, of, LocalizedText.NOTHING, rule, List.of(), scene);
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
